//! The part "Same surface?": is a spectrum the light off a surface?

mod ranking;

use std::sync::Arc;

use eframe::egui;
use egui::{Button, RichText, TextStyle, Ui, vec2};

use super::change;
use crate::{
    app::{
        ByAddress, Command, Entry, MadeFor, Memo,
        chart::Chart,
        charts::products::same_surface::same_surface_chart,
        headlines,
        numbers::four_digits,
        products::same_surface::{RESIDUAL_MEANS, SameSurfaceSheet, example},
        studies::Ranked,
        ticks::short,
    },
    io::many::numbers,
    study::products::{Compared, SAME_RESIDUAL, Sameness},
    ui::{
        kit::{Chooser, factors, framed, headline, lights, scrolled, two_columns},
        pages::PageContext,
    },
};

/// From this width on words and ranking stand beside the charts, points.
const WIDE: f32 = 940.0;

/// Surfaces of the ranking that are seen at a time in a narrow window.
const ROWS: f32 = 8.0;

/// What buttons and lists are called.
pub mod names {
    pub const SURFACE: &str = "Surface S2";
    pub const OUTGOING: &str = "Outgoing spectrum S3";
    pub const EXAMPLE: &str = "Surface of the example";
    pub const TWICE: &str = "twice";
    pub const MAKE: &str = "Make an example";
    pub const AMONG: &str = "Best surface among";
    pub const COPY: &str = "Copy the ranking as CSV";
}

/// The part and what it keeps from frame to frame.
#[derive(Default)]
pub struct SameSurfaceView {
    sheet: Memo<u64, Option<SameSurfaceSheet>>,
    charts: Memo<u64, [Option<Chart>; 2]>,
    ranking: Memo<ByAddress<Vec<Ranked>>, ranking::Drawn>,
    /// The surface of the example; `None` for S2.
    example: Option<Arc<Entry>>,
}

impl SameSurfaceView {
    /// Draws the part.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let app = context.app;
        let revision = app.revision();
        let sheet = self.sheet.get(revision, |_| SameSurfaceSheet::of(app));
        let words = sheet.as_ref().map_or_else(
            || "Is a spectrum the light off a surface? Choose both, or make an example.".to_owned(),
            headlines::same_surface,
        );
        headline(ui, context.theme, words);
        choices(ui, context);
        example_row(ui, context, &mut self.example);
        ui.separator();
        let Some(sheet) = &*sheet else {
            explain(ui, context);
            return;
        };
        let drawn = revision;
        let charts = &*self.charts.get(drawn, |_| {
            let sides = [
                (&sheet.model, "In the model's numbers"),
                (&sheet.measured, "Measured curves"),
            ];
            let chart = |compared: &Compared, what| same_surface_chart(app, sheet, compared, what);
            sides.map(|(compared, what)| Some(chart(compared.as_ref()?, what)))
        });
        let everywhere = context.memory.products.same_surface.everywhere;
        if let Some(ask) = &sheet.ranking(app.document(), everywhere) {
            context.put(ask);
        }
        let rows = &mut self.ranking;
        let room = ui.available_size();
        let scale = context.theme.scale;
        scrolled(ui, "same surface", |ui| {
            if ui.available_width() >= WIDE * scale {
                let words = |ui: &mut Ui, context: &mut PageContext<'_>| {
                    verdicts(ui, context, sheet);
                    ui.add_space(6.0);
                    ranking::show(ui, context, sheet, rows, room.y - 270.0 * scale);
                };
                let height = (0.5 * room.y - 12.0).max(240.0 * scale);
                two_columns(ui, context, words, |ui, context| {
                    draw(ui, context, &charts[0], "model", height);
                    draw(ui, context, &charts[1], "measured", height);
                });
            } else {
                verdicts(ui, context, sheet);
                ui.add_space(4.0);
                let height = (0.40 * room.y).clamp(230.0 * scale, 320.0 * scale);
                let model = |ui: &mut Ui, context: &mut PageContext<'_>| {
                    draw(ui, context, &charts[0], "model", height);
                };
                two_columns(ui, context, model, |ui, context| {
                    draw(ui, context, &charts[1], "measured", height);
                });
                ui.add_space(6.0);
                let row = ui.text_style_height(&TextStyle::Body) + 8.0;
                ranking::show(ui, context, sheet, rows, ROWS * row);
            }
        });
    }
}

/// Makes an outgoing spectrum from the light and a surface.
fn example_row(ui: &mut Ui, context: &mut PageContext<'_>, of: &mut Option<Arc<Entry>>) {
    let products = &context.app.document().products;
    ui.horizontal_wrapped(|ui| {
        let surface = of.as_ref().or(products.surface.as_ref()).cloned();
        let can = surface.is_some();
        let make = ui
            .add_enabled(can, Button::new(names::MAKE))
            .on_hover_text(
                "Computes the present light off the surface, keeps it as a spectrum of your \
                 own and takes it as S3: something to check when there is no file at hand.",
            )
            .on_disabled_hover_text("Choose a surface first.");
        ui.label("of this light off");
        let says = match (&*of, &surface) {
            (Some(entry), _) => entry.name().to_owned(),
            (None, Some(entry)) => format!("S2 ({})", entry.name()),
            (None, None) => "choose a surface".to_owned(),
        };
        let chosen = Chooser {
            name: names::EXAMPLE,
            meaning: "The surface that the example's light really comes from.",
            says: &says,
            offers: factors,
            width: 150.0 * context.theme.scale,
        }
        .show(ui, context.app);
        if chosen.is_some() {
            *of = chosen;
        }
        let twice = &mut context.memory.products.same_surface.twice;
        ui.checkbox(twice, names::TWICE).on_hover_text(
            "The light meets the surface twice, as in a corner: a single reflection should \
             then not explain it.",
        );
        if make.clicked()
            && let Some(surface) = surface
        {
            let recipe = example(context.app, &surface, *twice);
            let place = MadeFor::Outgoing;
            context.commands.push(Command::Make { recipe, place });
        }
    });
}

/// Light, surface and outgoing spectrum.
fn choices(ui: &mut Ui, context: &mut PageContext<'_>) {
    let document = context.app.document();
    let products = &document.products;
    let width = 150.0 * context.theme.scale;
    ui.horizontal_wrapped(|ui| {
        ui.label("Is S3");
        let outgoing = Chooser {
            name: names::OUTGOING,
            meaning: "The spectrum that may have come from the surface; files that you open as \
                      lights are in the list.",
            says: name(&products.outgoing, "choose a spectrum"),
            offers: lights,
            width,
        }
        .show(ui, context.app);
        if outgoing.is_some() {
            change(context, |products| products.outgoing = outgoing);
        }
        ui.label("the light S1");
        ui.add(egui::Label::new(RichText::new(document.light.name()).strong()).truncate())
            .on_hover_text("The document's light: choose another in the library.");
        ui.label("off the surface S2");
        let surface = Chooser {
            name: names::SURFACE,
            meaning: "The reflectance that may have turned the light into the spectrum.",
            says: name(&products.surface, "choose a surface"),
            offers: factors,
            width,
        }
        .show(ui, context.app);
        if surface.is_some() {
            change(context, |products| products.surface = surface);
        }
        ui.label("?");
    });
}

/// What a spectrum is called, or what is said where there is none.
fn name<'a>(entry: &'a Option<Arc<Entry>>, otherwise: &'a str) -> &'a str {
    entry.as_ref().map_or(otherwise, |entry| entry.name())
}

/// What to do when something is missing.
fn explain(ui: &mut Ui, context: &PageContext<'_>) {
    let products = &context.app.document().products;
    ui.add_space(10.0);
    let mut say = |words: &str| {
        ui.add(egui::Label::new(words).wrap());
        ui.add_space(4.0);
    };
    if products.outgoing.is_none() {
        say(
            "There is no outgoing spectrum S3 yet. Open a file with the spectrum seen at a place \
             that another surface may light, and choose it in the first list above; or press \
             \"Make an example\".",
        );
    }
    if products.surface.is_none() {
        say("There is no surface S2 yet: choose one in the last list above.");
    }
    say(&format!(
        "The check is the paper's S3 = S1 S2: the light times the reflectance, both in the \
         model's numbers, against the spectrum found, up to a factor and behind a 10 nm blur. It \
         holds up to a residual of {} of the spectrum found.",
        short(SAME_RESIDUAL)
    ));
}

/// Both verdicts, with sign and words.
fn verdicts(ui: &mut Ui, context: &PageContext<'_>, sheet: &SameSurfaceSheet) {
    let verdict = sheet.verdict();
    let colour = match verdict {
        Sameness::Holds => ui.visuals().strong_text_color(),
        Sameness::DoesNotHold | Sameness::Unknown => context.theme.warning,
    };
    framed(ui, |ui| {
        let words = format!("{} S3 = S1 S2 {}", verdict.sign(), verdict.words());
        ui.label(RichText::new(words).heading().color(colour));
        ui.add_space(2.0);
        egui::Grid::new("verdicts")
            .spacing([16.0, 3.0])
            .show(ui, |ui| {
                for (head, meaning) in [
                    ("", ""),
                    ("residual", RESIDUAL_MEANS),
                    ("factor", FACTOR_MEANS),
                    ("verdict", "Up to the threshold it holds; see below."),
                ] {
                    let label = ui.label(RichText::new(head).small());
                    if !meaning.is_empty() {
                        label.on_hover_text(meaning);
                    }
                }
                ui.end_row();
                let model = format!(
                    "in the model's {} and {}",
                    sheet.numbers[0],
                    numbers(sheet.numbers[1])
                );
                let rows = [
                    (model, &sheet.model, verdict),
                    (
                        "measured curves".to_owned(),
                        &sheet.measured,
                        sheet.measured_verdict(),
                    ),
                ];
                for (what, compared, verdict) in rows {
                    let found = compared.as_ref().map(|c| c.reflection);
                    ui.label(what);
                    ui.label(four_digits(found.map(|f| f.residual)));
                    ui.label(four_digits(found.map(|f| f.factor)));
                    ui.label(format!("{} {}", verdict.sign(), verdict.words()));
                    ui.end_row();
                }
            });
        ui.weak(format!(
            "It holds up to a residual of {}, and does not hold beyond that plus what the models \
                 leave out themselves. In tests with shipped lights off shipped surfaces 95 of 100 \
                 right surfaces stayed below it, and 2 of 100 wrong ones.",
            short(SAME_RESIDUAL)
        ));
    });
}

const FACTOR_MEANS: &str =
    "What light times surface is multiplied by to come closest: geometry, not colour.";

fn draw(ui: &mut Ui, context: &mut PageContext<'_>, chart: &Option<Chart>, id: &str, height: f32) {
    if let Some(chart) = chart {
        let size = vec2(ui.available_width(), height);
        context.chart(ui, chart, ("same surface", id), size);
    }
}
