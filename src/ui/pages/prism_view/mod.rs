//! The pages "Prism" and "Rainbow": a bench and a sky that the light is sent through.

mod bench;
pub mod model;
mod sky;
mod strips;

use eframe::egui;
use egui::{Align, Color32, Layout, RichText, Slider, Ui, Vec2, vec2};

use super::PageContext;
use crate::{
    app::{
        dispersion::{
            APEXES_DEG, Beside, INCIDENCES_DEG, PrismMemory, PrismShown, RainbowMemory,
            RainbowShown, SLITS_MM, STOPS, sky, stuff_title,
        },
        memo::Memo,
    },
    optics::{Sky, Stuff},
    ui::kit::{Choice, Column, Row, Table, copy_button, headline, scrolled},
};

/// What people and tests call the controls.
pub mod names {
    pub const GLASS: &str = "Glass";
    pub const APEX: &str = "Apex angle";
    pub const MINIMUM: &str = "least deviation";
    pub const INCIDENCE: &str = "Light meets it at";
    pub const SLIT: &str = "Slit";
    pub const EXPOSURE: &str = "Exposure";
    pub const BESIDE: &str = "Beside it";
    pub const DISC: &str = "as wide as the sun";
    pub const COPY: &str = "Copy lines as CSV";
}

/// From this width on the table stands beside the drawing, points.
const WIDE: f32 = 1000.0;

/// Least height of a drawing, points.
const LEAST: f32 = 190.0;

/// The pages and what they keep from frame to frame.
#[derive(Default)]
pub struct PrismView {
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

/// The light of the second strip.
fn beside(ui: &mut Ui, chosen: &mut Beside) {
    let choice = Choice {
        name: names::BESIDE,
        meaning: "A second light in the same place: what is missing in this one is seen.",
        width: 150.0,
    };
    named_choice(ui, choice, chosen.title(), |ui| {
        for one in Beside::ALL {
            ui.selectable_value(chosen, one, one.title());
        }
    });
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
    (columns, rows): (&[Column], &[Vec<String>]),
    copy: impl FnOnce() -> String,
) {
    if rows.is_empty() {
        return;
    }
    let rows: Vec<Row> = rows
        .iter()
        .map(|cells| Row {
            name: cells.join(", "),
            cells: cells.clone(),
            ..Row::default()
        })
        .collect();
    let table = Table {
        enabled: false,
        dense: true,
        ..Table::new(columns, context.theme)
    };
    table.show(ui, &rows, &mut |_, _, _| {});
    ui.horizontal(|ui| {
        copy_button(ui, names::COPY, "The lines with every figure.", copy);
    });
}

impl PrismView {
    /// Draws the prism's page.
    pub fn prism(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let key = (context.app.revision(), context.memory.dispersion.prism);
        let app = context.app;
        let shown = &*self
            .prism
            .get(key, |(_, memory)| PrismShown::of(app, memory));
        headline(ui, context.theme, &shown.sentence);
        ui.add_space(4.0);
        prism_controls(ui, context);
        ui.add_space(4.0);
        let room = ui.available_size();
        scrolled(ui, "prism", |ui| {
            let width = ui.available_width();
            // What the strips leave, and no less than a drawing needs.
            let left = room.y - strips::height(&shown.strips, &axis_of(shown), context.theme);
            let height = left.min(0.7 * width).max(LEAST);
            if width < WIDE * context.theme.scale {
                drawn(ui, context, shown, vec2(width, height));
                screen(ui, context, shown);
                lines(ui, context, (&prism_columns(), &shown.rows), || {
                    shown.csv.clone()
                });
                return;
            }
            ui.horizontal_top(|ui| {
                drawn(ui, context, shown, vec2(0.5 * width, height));
                let beside = vec2(ui.available_width(), height);
                ui.allocate_ui_with_layout(beside, Layout::top_down(Align::Min), |ui| {
                    scrolled(ui, "lines of the prism", |ui| {
                        lines(ui, context, (&prism_columns(), &shown.rows), || {
                            shown.csv.clone()
                        });
                    });
                });
            });
            screen(ui, context, shown);
        });
    }

    /// Draws the rainbow's page.
    pub fn rainbow(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
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
            beside(ui, &mut memory.beside);
            model::knobs(ui, context);
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
            };
            let width = ui.available_width();
            let table = if shown.rows.is_empty() {
                0.0
            } else {
                (shown.rows.len() as f32 + 2.5) * 20.0 * theme.scale
            };
            let left = room.y - table - strips::height(&shown.strips, &axis, theme);
            if let Some(strip) = shown.strips.first() {
                let size = vec2(width, left.min(0.45 * width).max(LEAST));
                picture.show(ui, (&strip.colours.rgb, shown.ends_deg), size);
            }
            strips::show(ui, &shown.strips, &axis, theme);
            let said = shown.notes.iter().map(String::as_str);
            let always = "The sky from 35\u{b0} to 60\u{b0} from the point opposite the sun, by rays \
                          alone: no supernumerary bows, as in drops above 0.5 mm.";
            notes(ui, said.chain([always]));
            ui.add_space(4.0);
            let columns = [
                Column::words(
                    "line",
                    "What it is named after, by all lines together.",
                    2.2,
                ),
                Column::numbers("wavelength", "In air.", 1.0),
                Column::numbers("n", "Index of refraction of water there.", 1.0),
                Column::numbers("first bow \u{b0}", "After one reflection in the drop.", 1.0),
                Column::numbers(
                    "second bow \u{b0}",
                    "After two reflections in the drop.",
                    1.0,
                ),
                Column::numbers("polarised %", "Of the first bow's light.", 1.0),
            ];
            lines(ui, context, (&columns, &shown.rows), || shown.csv());
        });
    }
}

/// The bench; a hand turns the prism.
fn drawn(ui: &mut Ui, context: &mut PageContext<'_>, shown: &PrismShown, size: Vec2) {
    let turned = bench::show(ui, shown.drawing.as_ref(), size, context.theme);
    if turned != 0.0 {
        let memory = &mut context.memory.dispersion.prism;
        let from = shown.incidence_deg.unwrap_or(memory.incidence_deg);
        let [least, most] = [*INCIDENCES_DEG.start(), *INCIDENCES_DEG.end()];
        memory.incidence_deg = (from + turned).clamp(least, most);
        memory.at_minimum = false;
    }
}

fn axis_of(shown: &PrismShown) -> strips::Axis<'_> {
    strips::Axis {
        ends: shown.ends_mm,
        label: "mm on the screen, bent more \u{2192}",
        nm: &shown.scale,
    }
}

/// What lands on the screen, and what must be said of it.
fn screen(ui: &mut Ui, context: &PageContext<'_>, shown: &PrismShown) {
    strips::show(ui, &shown.strips, &axis_of(shown), context.theme);
    let words = shown.strips.first().map(|strip| strip.colours.words());
    let words = words.filter(|words| !words.is_empty());
    let words = words.map(|words| format!("Strip: {words}."));
    let said = shown.notes.iter().map(String::as_str);
    notes(ui, said.chain(words.as_deref()));
    ui.add_space(4.0);
}

fn prism_controls(ui: &mut Ui, context: &mut PageContext<'_>) {
    ui.horizontal_wrapped(|ui| {
        let memory = &mut context.memory.dispersion.prism;
        ui.spacing_mut().slider_width = 90.0;
        let choice = Choice {
            name: names::GLASS,
            meaning: "What the prism is made of: flint glass spreads colours twice as far as \
                      crown glass.",
            width: 150.0,
        };
        named_choice(ui, choice, stuff_title(memory.stuff), |ui| {
            for stuff in Stuff::ALL {
                ui.selectable_value(&mut memory.stuff, stuff, stuff_title(stuff));
            }
        });
        let of = Slider::new(&mut memory.apex_deg, APEXES_DEG)
            .step_by(0.5)
            .suffix("\u{b0}");
        let meaning = "The angle between the two faces that the light goes through.";
        slider(ui, (names::APEX, meaning), of);
        together(ui, names::MINIMUM, 30.0);
        ui.checkbox(&mut memory.at_minimum, names::MINIMUM)
            .on_hover_text(
                "The light meets the prism so that green (546.1 nm) is bent least, as one sets a \
                 spectroscope; else at an angle of your choice. Drag the drawing to turn it.",
            );
        if !memory.at_minimum {
            let of = Slider::new(&mut memory.incidence_deg, INCIDENCES_DEG)
                .fixed_decimals(1)
                .suffix("\u{b0}");
            let meaning = "Angle between the light and the normal of the first face.";
            slider(ui, (names::INCIDENCE, meaning), of);
        }
        let of = Slider::new(&mut memory.slit_mm, SLITS_MM)
            .logarithmic(true)
            .fixed_decimals(2)
            .suffix(" mm");
        let meaning = "Width of the beam. Wide, lines run together and the middle turns white.";
        slider(ui, (names::SLIT, meaning), of);
        exposure(ui, &mut memory.stops);
        beside(ui, &mut memory.beside);
        model::knobs(ui, context);
    });
}

fn prism_columns() -> [Column; 8] {
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
        Column::numbers(
            "place mm",
            "Where it lands on the screen, 500 mm away.",
            1.0,
        ),
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
}
