//! The pages "Prism" and "Rainbow": a bench and a sky that the light is sent through.

mod bench;
mod controls;
mod drop;
pub(super) mod model;
mod sky;
mod strips;
mod substance;

pub(super) use substance::substance;

use std::sync::LazyLock;

use bench::Moved;
use eframe::egui;
use egui::{Color32, RichText, Slider, Ui, Vec2, vec2};

use super::PageContext;
use crate::{
    app::{
        Memo,
        dispersion::{IMPACTS, PrismMemory, PrismShown, RainbowMemory, RainbowShown, STOPS, sky},
    },
    optics::Sky,
    ui::kit::{self, Choice, Column, Row, Table, copy_button, down, headline, scrolled},
};

/// What people and tests call the controls.
pub(super) mod names {
    pub(crate) const GLASS: &str = "Glass";
    pub(crate) const APEX: &str = "Apex angle";
    pub(crate) const MINIMUM: &str = "least deviation";
    pub(crate) const INCIDENCE: &str = "Light meets it at";
    pub(crate) const GREEN: &str = "for";
    pub(crate) const SLIT: &str = "Slit";
    pub(crate) const SCREEN: &str = "Screen";
    pub(crate) const IMPACT: &str = "Rays meet the drop at";
    pub(crate) const BOW: &str = "Drawn";
    pub(crate) const EXPOSURE: &str = "Exposure";
    pub(crate) const BESIDE: &str = "Beside it";
    pub(crate) const DISC: &str = "as wide as the sun";
    pub(crate) const COPY: &str = "Copy lines as CSV";
}

/// From this width on the table stands beside the drawing, points.
const WIDE: f32 = 1000.0;

/// Least height of a drawing, points.
const LEAST: f32 = 190.0;

/// The pages and what they keep from frame to frame.
#[derive(Default)]
pub(super) struct PrismView {
    prism: Memo<(u64, PrismMemory), PrismShown>,
    sky: Memo<(), Sky>,
    rainbow: Memo<(u64, RainbowMemory), RainbowShown>,
    picture: sky::Painted,
}

/// Begins a new row of a wrapped one where there is no room for a name and what is `wide` beside
/// it: they are not to be parted.
fn together(ui: &mut Ui, name: &str, wide: f32) {
    let font = egui::TextStyle::Body.resolve(ui.style());
    let words = ui
        .painter()
        .layout_no_wrap(name.to_owned(), font, Color32::WHITE);
    let wide = words.size().x + wide + 3.0 * ui.spacing().item_spacing.x;
    if ui.layout().main_wrap() && ui.available_size_before_wrap().x < wide {
        ui.end_row();
    }
}

/// A slider with its name before it.
pub(super) fn slider(ui: &mut Ui, (name, meaning): (&str, &str), slider: Slider<'_>) {
    together(ui, name, ui.spacing().slider_width + 80.0);
    let add = |ui: &mut Ui| {
        let label = ui.label(name).on_hover_text(meaning);
        ui.add(slider).labelled_by(label.id).on_hover_text(meaning);
    };
    if ui.layout().main_wrap() {
        add(ui);
    } else {
        ui.horizontal(add);
    }
}

/// A choice with its name before it, in a wrapped row.
fn named_choice(ui: &mut Ui, choice: Choice<'_>, chosen: &str, list: impl FnOnce(&mut Ui)) {
    together(ui, choice.name, choice.width + 40.0);
    ui.label(choice.name).on_hover_text(choice.meaning);
    choice.show(ui, chosen, list);
}

/// How bright the picture is.
pub(super) fn exposure(ui: &mut Ui, stops: &mut f64) {
    let of = Slider::new(stops, STOPS)
        .step_by(0.1)
        .fixed_decimals(1)
        .suffix(" stops");
    let meaning = "How bright the picture is shown; each stop doubles it. A double click in the \
                   number's box lets you type it.";
    slider(ui, (names::EXPOSURE, meaning), of);
}

/// What must be said beside a picture, in small type.
pub(super) fn notes<'a>(ui: &mut Ui, notes: impl Iterator<Item = &'a str>) {
    let words: Vec<&str> = notes.filter(|words| !words.is_empty()).collect();
    if !words.is_empty() {
        let text = RichText::new(words.join(" ")).small().weak();
        ui.add(egui::Label::new(text).wrap());
    }
}

/// A table of the lines with the button that copies it.
fn lines(
    ui: &mut Ui,
    context: &PageContext<'_>,
    (columns, rows, notes): (&[Column], &[Vec<String>], &[String]),
    copy: impl FnOnce() -> String,
) {
    if rows.is_empty() {
        return;
    }
    let notes = notes
        .iter()
        .cloned()
        .chain(std::iter::repeat(String::new()));
    let rows: Vec<Row> = rows
        .iter()
        .zip(notes)
        .map(|(cells, note)| Row {
            note,
            ..Row::of(cells.clone())
        })
        .collect();
    Table::dense(columns, context.theme).show(ui, &rows, &mut |_, _, _| {});
    ui.horizontal(|ui| {
        copy_button(ui, names::COPY, "The lines with every figure.", copy);
    });
}

impl PrismView {
    /// Draws the prism's page.
    pub(super) fn prism(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let memory = context.memory.dispersion.prism.clone();
        let key = (context.app.revision(), memory);
        let app = context.app;
        let shown = &*self
            .prism
            .get(key, |(_, memory)| PrismShown::of(app, memory));
        headline(ui, context.theme, &shown.sentence);
        ui.add_space(4.0);
        controls::prism(ui, context);
        ui.add_space(4.0);
        let room = ui.available_size();
        scrolled(ui, "prism", |ui| {
            let width = ui.available_width();
            // What the strips leave, and no less than a drawing needs.
            let tells = |x_mm: f64| told(shown, x_mm);
            let axis = axis_of(shown, &tells);
            let left = room.y - strips::height(&shown.strips, &axis, context.theme);
            let height = left.min(0.7 * width).max(LEAST);
            if width < WIDE * context.theme.scale {
                drawn(ui, context, shown, vec2(width, height));
                screen(ui, context, shown);
                lines(ui, context, table_of(shown), || shown.csv.clone());
                return;
            }
            ui.horizontal_top(|ui| {
                drawn(ui, context, shown, vec2(0.5 * width, height));
                let beside = vec2(ui.available_width(), height);
                down(ui, beside, |ui| {
                    scrolled(ui, "lines of the prism", |ui| {
                        lines(ui, context, table_of(shown), || shown.csv.clone());
                    });
                });
            });
            screen(ui, context, shown);
        });
    }

    /// Draws the rainbow's page.
    pub(super) fn rainbow(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let key = (context.app.revision(), context.memory.dispersion.rainbow);
        let app = context.app;
        let sky = &*self.sky.get((), |()| sky());
        let shown = &*self
            .rainbow
            .get(key, |(_, memory)| RainbowShown::of(app, memory, sky));
        headline(ui, context.theme, &shown.sentence);
        ui.add_space(4.0);
        ui.horizontal_wrapped(|ui| {
            let memory = &mut context.memory.dispersion.rainbow;
            ui.spacing_mut().slider_width = 90.0;
            ui.checkbox(&mut memory.disc, names::DISC).on_hover_text(
                "The sun is half a degree wide and blurs every bow by as much; without it each \
                 line is as sharp as a drop makes it.",
            );
            exposure(ui, &mut memory.stops);
            controls::beside(ui, &mut memory.beside);
            controls::drop(ui, memory);
            model::sent(ui, &mut memory.sent);
            let sent = memory.sent;
            model::knobs(ui, context, sent);
        });
        ui.add_space(4.0);
        let room = ui.available_size();
        let theme = context.theme;
        let picture = &mut self.picture;
        scrolled(ui, "rainbow", |ui| {
            let axis = strips::Axis {
                ends: shown.ends_deg,
                label: "\u{b0} from the point opposite the sun",
                nm: &[],
                tells: &|angle| format!("{angle:.2}\u{b0} from the point opposite the sun"),
            };
            let width = ui.available_width();
            let table = if shown.table.is_empty() {
                0.0
            } else {
                (shown.table.len() as f32 + 2.5) * 20.0 * theme.scale
            };
            let words = 20.0 * theme.scale;
            let left = room.y - table - words - strips::height(&shown.strips, &axis, theme);
            let high = left.min(0.45 * width).max(LEAST);
            ui.horizontal_top(|ui| {
                ui.spacing_mut().item_spacing.x = 6.0;
                if let Some(drawing) = &shown.drop {
                    let wide = high.max(240.0 * theme.scale).min(0.4 * width);
                    let moved = drop::show(ui, drawing, vec2(wide, high), theme);
                    let impact = &mut context.memory.dispersion.rainbow.impact;
                    *impact =
                        moved.map_or(*impact, |to| to.clamp(*IMPACTS.start(), *IMPACTS.end()));
                }
                if let Some(strip) = shown.strips.first() {
                    let size = vec2(ui.available_width(), high);
                    picture.show(ui, (&strip.colours.rgb, shown.ends_deg), size);
                }
            });
            notes(ui, shown.drop.iter().map(|drawing| drawing.words.as_str()));
            strips::show(ui, &shown.strips, &axis, theme);
            let said = shown.notes.iter().map(String::as_str);
            let always = "The sky from 35\u{b0} to 60\u{b0} from the point opposite the sun, by rays \
                          alone: no supernumerary bows, as in drops above 0.5 mm.";
            notes(ui, said.chain([always]));
            ui.add_space(4.0);
            let columns = kit::columns(&shown.table, &[2.2, 1.0, 1.0, 1.0, 1.0, 1.0]);
            let rows: Vec<Vec<String>> = shown.table.shown().collect();
            lines(ui, context, (&columns, &rows, &[]), || shown.table.csv());
        });
    }
}

/// The bench; a hand turns the prism and moves its handles.
fn drawn(ui: &mut Ui, context: &mut PageContext<'_>, shown: &PrismShown, size: Vec2) {
    let moved = bench::show(ui, shown.drawing.as_ref(), size, context.theme);
    let memory = &mut context.memory.dispersion.prism;
    match moved {
        None => {}
        Some(Moved::Turned(by)) => memory.turn(shown.incidence_deg, by),
        Some(Moved::Set(handle, to)) => memory.set(handle, to),
    }
}

/// What is told of a place on the screen.
fn told(shown: &PrismShown, x_mm: f64) -> String {
    shown
        .told(x_mm)
        .unwrap_or_else(|| format!("{x_mm:.2} mm: no light from 380 to 780 nm lands there."))
}

fn axis_of<'a>(shown: &'a PrismShown, tells: &'a dyn Fn(f64) -> String) -> strips::Axis<'a> {
    strips::Axis {
        ends: shown.ends_mm,
        label: "mm on the screen, bent more \u{2192}",
        nm: &shown.scale,
        tells,
    }
}

/// What lands on the screen, and what must be said of it.
fn screen(ui: &mut Ui, context: &PageContext<'_>, shown: &PrismShown) {
    let tells = |x_mm: f64| told(shown, x_mm);
    strips::show(ui, &shown.strips, &axis_of(shown, &tells), context.theme);
    let words = shown.strips.first().map(|strip| strip.colours.words());
    let words = words.filter(|words| !words.is_empty());
    let words = words.map(|words| format!("Strip: {words}."));
    let said = shown.notes.iter().map(String::as_str);
    notes(ui, said.chain(words.as_deref()));
    ui.add_space(4.0);
}

/// The table of the lines: its columns, its rows, and what is told of each.
fn table_of(shown: &PrismShown) -> (&'static [Column], &[Vec<String>], &[String]) {
    (&*PRISM_COLUMNS, &shown.rows, &shown.told)
}

static PRISM_COLUMNS: LazyLock<[Column; 8]> = LazyLock::new(|| {
    [
        Column::words(
            "line",
            "What it is named after, by all lines together.",
            1.7,
        ),
        Column::numbers("nm", "Wavelength in air.", 1.0),
        Column::numbers("n", "Index of refraction of the glass there.", 1.0),
        Column::numbers(
            "turned \u{b0}",
            "Deviation: how far the ray is turned.",
            1.0,
        ),
        Column::numbers("place mm", "Where it lands on the screen.", 1.0),
        Column::numbers("width mm", "How wide the image of the slit is.", 1.0),
        Column::numbers(
            "passed %",
            "Share of its light that both faces let through.",
            1.0,
        ),
        Column::numbers(
            "apart nm",
            "Two lines nearer than this run together, and what limits it: the slit, or the \
             length of the glass.",
            1.4,
        ),
    ]
});
