//! The place "Design": lights that are mixed, solved for, and made from colours.

mod adding;
mod asked;
mod colour;
mod mix;
mod photo;
mod solve;
mod strips;
mod worth;

use crate::ui::kit::{drag_value, slide};
use std::{path::PathBuf, sync::Arc};

use eframe::egui;
use egui::{Ui, vec2};

use super::PageContext;
use crate::{
    app::{
        App, Document, Entry, Memo,
        chart::Chart,
        charts::design::{ground, on_diagram},
        design::{
            Beside, Desk, DeskSurfaces,
            colour::FromColour,
            mix::Mix,
            named_lines::{NamedLine, named_lines},
            wish::Answered,
        },
    },
    languages::said,
    ui::{
        chart_view::{ChartResponse, ChartView},
        kit::{drawing, named},
        swatch,
    },
};

/// The second light: its name, its key, and itself as a desk of one channel.
#[derive(Clone)]
struct Second {
    name: String,
    key: String,
    desk: Desk,
}

impl Second {
    fn of(document: &Document) -> Option<Self> {
        let entry = document.second.as_ref()?;
        Some(Self {
            name: entry.name().to_owned(),
            key: entry.key.clone(),
            desk: Desk::of_second(document)?,
        })
    }

    fn named(&self) -> (&str, &Desk) {
        (&self.name, &self.desk)
    }
}

/// What the pages keep from frame to frame.
#[derive(Default)]
pub(super) struct DesignView {
    desk: Memo<u64, Desk>,
    second: Memo<Option<Arc<Entry>>, Option<Second>>,
    lines: Memo<(), Vec<NamedLine>>,
    ground: Memo<(), Chart>,
    diagram: Memo<(u64, Option<[f64; 2]>), Chart>,
    spectrum: Memo<u64, Chart>,
    solved: Answered,
    /// The wish was moved: the faders follow what is solved for.
    follows: bool,
    beside: Memo<(u64, DeskSurfaces), Vec<Beside>>,
    colour: Memo<(u64, FromColour), Result<Arc<colour::Shown>, String>>,
    /// A hexadecimal colour while it is typed: of the first or the second light, and its text.
    typed: Option<(usize, String)>,
    /// The channel that is dragged in the spectrum.
    held: Option<usize>,
    /// What is dragged in the diagram.
    dragged: Option<mix::Held>,
    /// The channel whose switches are shown.
    chosen: usize,
    /// A picture whose pixels are taken as colours.
    pub(super) photo: Option<PathBuf>,
    drawn_photo: Option<photo::DrawnPhoto>,
}

impl DesignView {
    /// Brings what is kept up to the document.
    fn refresh(&mut self, app: &App) {
        let document = app.document();
        self.desk.get(app.changes(), |_| Desk::of(document));
        let second = document.second.clone();
        self.second.get(second, |_| Second::of(document));
        self.lines.get((), |_| named_lines(app.element_lines()));
    }

    /// The channels and the mixture among colours; drags are the page's.
    fn diagram(
        &mut self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
        target: Option<[f64; 2]>,
        size: egui::Vec2,
    ) -> ChartResponse {
        let ground = &*self.ground.get((), |()| ground());
        let key = (context.app.changes(), target);
        let second = self.second.held().and_then(Option::as_ref);
        let second = second.map(Second::named);
        let desk = self.desk.held();
        let make = |_: &_| {
            desk.map_or_else(Chart::default, |desk| {
                on_diagram(ground, desk, target, second)
            })
        };
        let chart = &*self.diagram.get(key, make);
        ChartView::held(ui, chart, "colours of channels", size, context.theme)
    }
}

/// By how much some English words are longer in the language spoken: 1 or more.
fn longer<const N: usize>(english: [&'static str; N]) -> f32 {
    let letters = |words: [&str; N]| words.iter().map(|word| word.chars().count()).sum::<usize>();
    (letters(english.map(said)) as f32 / letters(english) as f32).max(1.0)
}

/// Two colours side by side in one large field, with words below each.
fn large_swatch(
    ui: &mut Ui,
    context: &PageContext<'_>,
    [left, right]: [egui::Color32; 2],
    (name, meaning): (&str, &str),
    words: [&str; 2],
) {
    let scale = context.theme.scale;
    let size = vec2(ui.available_width(), 88.0 * scale);
    let (rect, response) = drawing(ui, size, egui::Sense::hover(), name);
    ui.painter()
        .rect_filled(rect, 4.0, context.theme.swatch_ground);
    let inner = rect.shrink(8.0);
    swatch::paint_split(ui, inner, left, right);
    response.on_hover_text(meaning);
    ui.horizontal(|ui| {
        let small = |words: &str| egui::RichText::new(words).small().weak();
        ui.label(small(words[0]));
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            ui.label(small(words[1]));
        });
    });
}

/// Changes the desk of the document.
fn change(context: &mut PageContext<'_>, change: impl FnOnce(&mut Mix)) {
    change(&mut context.pages.mix.desk);
}

/// Makes another desk the document's.
fn set(context: &mut PageContext<'_>, mix: Mix) {
    context.pages.mix.desk = mix;
}

/// A slider with its number behind it, both called the same.
struct Fader<'a> {
    name: &'a str,
    meaning: &'a str,
    range: std::ops::RangeInclusive<f64>,
    digits: usize,
    suffix: &'a str,
    logarithmic: bool,
}

impl Fader<'_> {
    /// Draws it over the room there is, but for `rest` points behind it.
    fn show(self, ui: &mut Ui, value: &mut f64, rest: f32, scale: f32) {
        let number = 64.0 * scale;
        ui.spacing_mut().slider_width = (ui.available_width() - rest - number - 8.0).max(10.0);
        let slider = slide(value, self.range.clone())
            .logarithmic(self.logarithmic)
            .show_value(false);
        let slider = ui.add(slider);
        named(&slider, egui::Role::Slider, self.name);
        slider.on_hover_text(self.meaning);
        let speed = (self.range.end() - self.range.start()) / 500.0;
        let drag = drag_value(value)
            .range(self.range)
            .speed(speed)
            .fixed_decimals(self.digits)
            .suffix(self.suffix);
        let drag = ui.add_sized([number, ui.spacing().interact_size.y], drag);
        named(&drag, egui::Role::SpinButton, self.name);
        drag.on_hover_text(self.meaning);
    }
}
