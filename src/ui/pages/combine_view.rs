//! The page Combine: means of scans, differences, quotients, slits, and what changed, each with its
//! doubt.

use std::sync::Arc;

use eframe::egui;
use egui::{RichText, Slider, Ui, vec2};

use crate::{
    app::{
        App, Command, Entry, MadeFor, Memo,
        chart::Chart,
        charts::combined::combined_chart,
        combining::{
            Found,
            desk::{Desk, Slot, Verb, Waits},
            words::{figure_words, headline as words_of, line_words},
        },
    },
    measurements::{Kernel, Normalise, quantity_of},
    ui::{
        kit::{
            Choice, Chooser, Column, Form, GROUP, Look, Row, Table, form, headline, main_button,
            pressed_if, pressed_small, warning, with_panel,
        },
        pages::PageContext,
    },
};

/// Part of the page's height for the curve, and its least height, points.
const CURVE: (f32, f32) = (0.56, 200.0);

/// Width of the lists, points.
const LIST: f32 = 190.0;

/// Most lines of a light that are listed.
const MOST_LINES: usize = 8;

/// What buttons and lists are called.
pub mod names {
    pub const VERB: &str = "Make";
    pub const SCANS: &str = "Scans";
    pub const OTHERS: &str = "Against";
    pub const WIDTH: &str = "Width, nm";
    pub const SHAPE: &str = "Shape of the slit";
    pub const SCALE: &str = "Bring lights to";
    pub const KEEP_ALL: &str = "Keep everything";
    pub const SURFACE: &str = "Off a surface";
    pub const TOLD: &str = "I know its width";
    pub const LIBRARY: &str = "To the library";
}

/// The page and what it keeps from frame to frame.
#[derive(Default)]
pub struct CombineView {
    shown: Memo<(u64, Desk), Arc<Result<Shown, Waits>>>,
}

/// What came of it.
struct Shown {
    found: Found,
    chart: Option<Chart>,
    figures: Vec<Row>,
}

impl Shown {
    fn of(app: &App, desk: &Desk) -> Result<Self, Waits> {
        let found = desk.found(app)?;
        Ok(Self {
            chart: combined_chart(&found),
            figures: rows(&found),
            found,
        })
    }
}

/// Figures, lines, parts that differ: a name and a value each.
fn rows(found: &Found) -> Vec<Row> {
    let row = |name: String, value: String| Row::of(vec![name, value]);
    let figures = found.figures().map(|(all, _)| all).unwrap_or_default();
    let mut rows: Vec<Row> = figures
        .iter()
        .map(|d| row(d.figure.words().to_owned(), figure_words(d)))
        .collect();
    let lines = found.lines.iter().take(MOST_LINES);
    rows.extend(lines.map(|line| row("Line".to_owned(), line_words(line))));
    rows.extend(found.scans.iter().map(|scan| {
        let told = format!(
            "level {:+.2} %, moved {:+.3} nm",
            100.0 * scan.level,
            scan.shift_nm
        );
        let told = match &scan.why {
            Some(why) if !scan.is_kept => format!("left out: {why}"),
            _ => told,
        };
        let look = match scan.is_kept {
            true => Look::Plain,
            false => Look::SmallWeak,
        };
        Row {
            looks: vec![look, look],
            ..row(scan.name.clone(), told)
        }
    }));
    rows
}

impl CombineView {
    /// Draws the page.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let app = context.app;
        let desk = context.memory.combine.clone();
        let key = (app.revision(), desk.clone());
        let shown = self
            .shown
            .get(key, |_| Arc::new(Shown::of(app, &desk)))
            .clone();
        let words = match &*shown {
            Ok(shown) => words_of(&shown.found),
            Err(Waits::ForSpectra) => waiting(desk.verb),
            Err(Waits::Refused(why)) => why.clone(),
        };
        headline(ui, context.theme, words);
        ui.add_space(GROUP);
        let scale = context.theme.scale;
        with_panel(
            ui,
            context,
            ("combine", scale),
            |ui, context, size| {
                if let Ok(shown) = &*shown {
                    result(ui, context, shown, size);
                }
            },
            |ui, context| {
                controls(ui, context);
                ui.add_space(GROUP);
                let recipe = desk.recipe().filter(|_| shown.is_ok());
                let button = main_button(ui, names::LIBRARY);
                let meaning = "Keeps it among your own; it follows what it is made of.";
                if pressed_if(ui, recipe.is_some(), button, meaning)
                    && let Some(recipe) = recipe
                {
                    let place = MadeFor::Shown;
                    context.commands.push(Command::Make { recipe, place });
                }
                if let Ok(shown) = &*shown {
                    let (own, rest) = shown.found.notes();
                    for note in own.iter().chain(&rest) {
                        warning(ui, context.theme, note.as_str());
                    }
                }
            },
        );
    }
}

/// What the page waits for.
fn waiting(verb: Verb) -> String {
    match verb.slots() {
        [] => "Mark the scans of one light below, or open their files.".to_owned(),
        slots => {
            let all: Vec<&str> = slots.iter().map(|slot| slot.name).collect();
            format!("{} Choose {}.", verb.meaning(), all.join(" and "))
        }
    }
}

/// The curve with its band, and the figures with their doubt.
fn result(ui: &mut Ui, context: &mut PageContext<'_>, shown: &Shown, size: egui::Vec2) {
    let scale = context.theme.scale;
    if let Some(chart) = &shown.chart {
        let high = (CURVE.0 * size.y).max(CURVE.1 * scale);
        context.chart(ui, chart, "combined", vec2(size.x, high));
        ui.add_space(GROUP);
    }
    let columns = [
        Column::words("Figure", "", 0.25),
        Column::words("Value", "\u{b1} is the half width of the 95 % interval.", 0.75),
    ];
    if !shown.figures.is_empty() {
        Table::dense(&columns, context.theme).plain(ui, &shown.figures);
    }
}

/// The verb, the spectra that it needs, and what else it asks.
fn controls(ui: &mut Ui, context: &mut PageContext<'_>) {
    let mut desk = context.memory.combine.clone();
    let width = LIST * context.theme.scale;
    form(ui, "combine", |form| {
        let choice = Choice {
            name: names::VERB,
            meaning: desk.verb.meaning(),
            width,
        };
        form.row((names::VERB, choice.meaning), |ui, _| {
            let words = |verb: Verb| (verb.title(), verb.meaning());
            choice.pick(ui, &mut desk.verb, Verb::ALL, words);
        });
        for (index, slot) in desk.verb.slots().iter().enumerate() {
            let chosen = slot_row(form, context, *slot, desk.slots[index].as_deref(), width);
            if let Some(entry) = chosen {
                desk.slots[index] = Some(entry.key.clone());
            }
        }
        of_verb(form, &mut desk, width);
    });
    if desk.verb.slots().is_empty() {
        marks(ui, context.app, names::SCANS, &mut desk.scans);
    }
    if desk.verb == Verb::Changed {
        marks(ui, context.app, names::OTHERS, &mut desk.others);
    }
    context.memory.combine = desk;
}

fn slot_row(
    form: &mut Form<'_>,
    context: &PageContext<'_>,
    slot: Slot,
    key: Option<&str>,
    width: f32,
) -> Option<Arc<Entry>> {
    let entry = key.and_then(|key| context.app.entry(key));
    let says = entry.as_ref().map_or("choose a spectrum", |entry| entry.name());
    let chooser = Chooser {
        name: slot.name,
        meaning: slot.meaning,
        says,
        offers: measurable,
        width,
    };
    form.row((slot.name, slot.meaning), |ui, _| {
        chooser.show(ui, context.app)
    })
}

fn measurable(entry: &Entry) -> bool {
    let of = &entry.spectrum;
    quantity_of(&of.name, of.kind, &of.unit).is_ok()
}

/// What only some verbs ask.
fn of_verb(form: &mut Form<'_>, desk: &mut Desk, width: f32) {
    let takes_width = match desk.verb {
        Verb::Slit => true,
        Verb::Unslit => {
            form.rest(|ui| ui.checkbox(&mut desk.is_told, names::TOLD))
                .on_hover_text("Else two of the light's own atomic lines tell it.");
            desk.is_told
        }
        _ => false,
    };
    if takes_width {
        let meaning = "Full width at half of the slit's top.";
        let slider = Slider::new(&mut desk.fwhm_nm, 0.5..=30.0).step_by(0.1);
        form.slider((names::WIDTH, meaning), slider);
    }
    if matches!(desk.verb, Verb::Slit | Verb::Unslit) {
        let meaning = "How the slit weighs wavelengths.";
        form.row((names::SHAPE, meaning), |ui, _| {
            let choice = Choice {
                name: names::SHAPE,
                meaning,
                width,
            };
            let all = [Kernel::Gauss, Kernel::Triangle];
            choice.pick(ui, &mut desk.shape, all, |shape| match shape {
                Kernel::Gauss => ("Gaussian", ""),
                Kernel::Triangle => ("triangle", ""),
            });
        });
    }
    if matches!(desk.verb, Verb::Sum | Verb::Difference) {
        let meaning = "Lights without a common scale can be added only once they are brought to one.";
        form.row((names::SCALE, meaning), |ui, _| {
            let choice = Choice {
                name: names::SCALE,
                meaning,
                width,
            };
            let all = [None, Some(Normalise::Y), Some(Normalise::Area), Some(Normalise::Peak)];
            choice.pick(ui, &mut desk.equal, all, |by| match by {
                None => ("their own scale", ""),
                Some(Normalise::Y) => ("equal Y", ""),
                Some(Normalise::Area) => ("equal area", ""),
                Some(_) => ("equal peak", ""),
            });
        });
    }
    if matches!(desk.verb, Verb::Quotient | Verb::QuotientLessDark) {
        form.rest(|ui| ui.checkbox(&mut desk.of_surface, names::SURFACE))
            .on_hover_text("The quotient is a reflectance; else a transmittance.");
    }
    let keeps = match desk.verb {
        Verb::Quotient | Verb::QuotientLessDark | Verb::Absorbance => {
            "Also where the reference is in the dark, where a quotient means little."
        }
        Verb::Mean | Verb::Changed => "Also scans that do not belong to the others.",
        _ => return,
    };
    form.rest(|ui| ui.checkbox(&mut desk.keep_all, names::KEEP_ALL))
        .on_hover_text(keeps);
}

/// The user's own lights and counts with a mark each.
fn marks(ui: &mut Ui, app: &App, title: &str, keys: &mut Vec<String>) {
    ui.add_space(GROUP);
    let own: Vec<&Arc<Entry>> = app.document().own.iter().filter(|e| measurable(e)).collect();
    ui.horizontal(|ui| {
        ui.label(RichText::new(title).strong());
        if pressed_small(ui, "all", "Marks all of your own.") {
            *keys = own.iter().map(|entry| entry.key.clone()).collect();
        }
        if pressed_small(ui, "none", "Marks none.") {
            keys.clear();
        }
    });
    if own.is_empty() {
        ui.weak("Files that you open are listed here.");
    }
    for entry in own {
        let mut is_marked = keys.contains(&entry.key);
        if ui.checkbox(&mut is_marked, entry.name()).changed() {
            match is_marked {
                true => keys.push(entry.key.clone()),
                false => keys.retain(|key| *key != entry.key),
            }
        }
    }
    // What left the library.
    keys.retain(|key| app.document().own.iter().any(|entry| entry.key == *key));
}
