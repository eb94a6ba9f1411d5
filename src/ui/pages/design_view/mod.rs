//! The place "Design": lights that are mixed, solved for, and made from colours.

mod asked;
mod colour;
mod mix;
mod photo;
mod solve;
mod strips;

use std::{path::PathBuf, sync::Arc};

use eframe::egui;
use egui::{DragValue, Slider, Ui, vec2};

use super::PageContext;
use crate::{
    app::{
        App, Memo,
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
    ui::{
        kit::{self, drawing, named},
        swatch,
    },
};

/// What the pages keep from frame to frame.
#[derive(Default)]
pub(super) struct DesignView {
    desk: Memo<u64, Desk>,
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
    /// A picture whose pixels are taken as colours.
    pub(super) photo: Option<PathBuf>,
    drawn_photo: Option<photo::DrawnPhoto>,
}

impl DesignView {
    /// Brings what is kept up to the document.
    fn refresh(&mut self, app: &App) {
        self.desk.get(app.changes(), |_| Desk::of(app.document()));
        self.lines.get((), |_| named_lines(app.element_lines()));
    }

    /// The channels and the mixture among colours.
    fn diagram(
        &mut self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
        target: Option<[f64; 2]>,
        size: egui::Vec2,
    ) {
        let ground = &*self.ground.get((), |()| ground());
        let Some(desk) = self.desk.held() else { return };
        let key = (context.app.changes(), target);
        let chart = &*self.diagram.get(key, |_| on_diagram(ground, desk, target));
        context.chart(ui, chart, "colours of channels", size);
    }
}

/// The colour of the mixture and the sentence about it.
fn headline(
    ui: &mut Ui,
    context: &PageContext<'_>,
    [left, right]: [egui::Color32; 2],
    meaning: &str,
    words: &str,
) {
    let scale = context.theme.scale;
    ui.horizontal(|ui| {
        let size = vec2(44.0, 24.0) * scale;
        let (rect, response) = drawing(ui, size, egui::Sense::hover(), "Colour of the mixture");
        swatch::paint_split(ui, rect, left, right);
        swatch::outline(ui, rect, ui.visuals().widgets.noninteractive.bg_stroke);
        response.on_hover_text(meaning);
        kit::headline(ui, context.theme, words);
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
        let slider = Slider::new(value, self.range.clone())
            .logarithmic(self.logarithmic)
            .show_value(false);
        let slider = ui.add(slider);
        named(&slider, egui::Role::Slider, self.name);
        slider.on_hover_text(self.meaning);
        let speed = (self.range.end() - self.range.start()) / 500.0;
        let drag = DragValue::new(value)
            .range(self.range)
            .speed(speed)
            .fixed_decimals(self.digits)
            .suffix(self.suffix);
        let drag = ui.add_sized([number, ui.spacing().interact_size.y], drag);
        named(&drag, egui::Role::SpinButton, self.name);
        drag.on_hover_text(self.meaning);
    }
}
