//! The page Combine: means of scans, differences, quotients, slits, and what changed, each with its
//! doubt.

use std::sync::Arc;

use eframe::egui;
use egui::{RichText, Ui, Vec2, vec2};

use crate::{
    app::{
        App, Command, Entry, MadeFor, cells,
        combining::{Slot, Verb},
        pages::{
            CombineState,
            combine::{CombineAsk, Combined},
        },
    },
    languages::{Language, said, spoken},
    measurements::{Kernel, Normalise, quantity_of},
    ui::{
        kit::{
            self, Choice, Chooser, Form, GROUP, Table, down, form, headline,
            knob::{drag, slider},
            main_button, pressed_if, pressed_small, sign_button, titled, warning, with_panel,
        },
        pages::{PageContext, progress},
    },
};

/// Part of the page's height for the chart, and its least height, points.
const CHART: (f32, f32) = (0.56, 200.0);

/// From this width on the first table stands beside the others, points, and its share of it.
const BESIDE: f32 = 620.0;
const FIRST: f32 = 0.32;

/// Width of the lists, points.
const LIST: f32 = 180.0;

/// What people and tests call the controls.
pub mod names {
    pub const VERB: &str = later!("Make");
    pub const SCANS: &str = later!("Scans");
    pub const OTHERS: &str = later!("Compared with");
    pub const SHAPE: &str = later!("Shape");
    pub const SCALE: &str = later!("Scale");
    pub const KEEP_ALL: &str = later!("Keep everything");
    pub const SURFACE: &str = later!("Off a surface");
    pub const TOLD: &str = later!("I know its width");
    pub const LIBRARY: &str = later!("To the library");
    pub const KEEP: &str = later!("Keep the instrument");
    pub const KNOWN: &str = later!("Known light");
}

/// The page.
#[derive(Default)]
pub struct CombineView;

impl CombineView {
    /// Draws the page.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let Some(ask) = CombineAsk::of(context.app, &context.pages.combine) else {
            return;
        };
        let job = context.put(&ask);
        let shown = job.result().cloned();
        let is_new = job.result_for(&ask).is_some();
        let says = shown.as_ref().map_or("", |shown| shown.says.as_str());
        headline(ui, context.theme, says);
        ui.add_space(GROUP);
        let scale = context.theme.scale;
        with_panel(
            ui,
            context,
            ("combine", scale),
            |ui, context, size| {
                if let Some(shown) = &shown {
                    result(ui, context, shown, size);
                }
            },
            |ui, context| {
                controls(ui, context, shown.as_deref());
                let job = context.studies.of::<CombineAsk>();
                progress(ui, job, said!("The result"));
                keep(ui, context, shown.as_deref().filter(|_| is_new));
                for note in shown.iter().flat_map(|shown| &shown.notes) {
                    warning(ui, context.theme, note.as_str());
                }
            },
        );
    }
}

/// The curve with its band, and below it the figures with their doubt.
fn result(ui: &mut Ui, context: &mut PageContext<'_>, shown: &Combined, size: Vec2) {
    let scale = context.theme.scale;
    let is_alone = shown.tables.is_empty();
    let high = if is_alone { size.y } else { CHART.0 * size.y };
    let size = vec2(size.x, high.max(CHART.1 * scale));
    context.chart(ui, &shown.chart, "combined", size);
    ui.add_space(GROUP);
    let (first, rest) = shown.tables.split_at(shown.tables.len().min(1));
    if size.x < BESIDE * scale || rest.is_empty() {
        tables(ui, context, &shown.tables);
        return;
    }
    let left = (FIRST * (size.x - 2.0 * GROUP)).floor();
    ui.horizontal_top(|ui| {
        ui.spacing_mut().item_spacing.x = 2.0 * GROUP;
        let right = size.x - 2.0 * GROUP - left;
        for (part, width) in [(first, left), (rest, right)] {
            down(ui, vec2(width, 0.0), |ui| {
                ui.set_width(width);
                tables(ui, context, part);
            });
        }
    });
}

/// A title within a sentence: English writes it small there.
fn in_sentence(title: &str) -> String {
    match spoken() {
        Language::English => title.to_lowercase(),
        _ => title.to_owned(),
    }
}

/// Tables below each other, each with its title and what copies it.
fn tables(ui: &mut Ui, context: &PageContext<'_>, all: &[(&'static str, cells::Table)]) {
    for (title, table) in all {
        let copy = tr!("Copy {table} as CSV", table = in_sentence(title));
        titled(ui, title, &copy, "", || table.csv());
        let shares: &[f32] = match table.heads().count() {
            4 => &[0.24, 0.26, 0.34, 0.16],
            _ => &[0.36, 0.64],
        };
        let columns = kit::columns(table, shares);
        let rows = kit::rows(table, |_, cells| [cells.join(", "), String::new()]);
        Table::dense(&columns, context.theme).show(ui, &rows, &mut |_, _, _| {});
        ui.add_space(GROUP);
    }
}

/// Keeps the result among the user's own, and an instrument among those on the page.
fn keep(ui: &mut Ui, context: &mut PageContext<'_>, shown: Option<&Combined>) {
    ui.add_space(GROUP);
    if context.pages.combine.verb == Verb::Learnt {
        let instrument = shown.and_then(|shown| shown.instrument.as_ref());
        let button = main_button(ui, said(names::KEEP));
        let meaning = said!("Readings are corrected by it from now on.");
        if pressed_if(ui, instrument.is_some(), button, meaning)
            && let Some(instrument) = instrument
        {
            let state = &mut context.pages.combine;
            state.instruments.push(instrument.clone());
            state.instrument = state.instruments.len() - 1;
        }
    } else {
        let is_made = shown.is_some_and(|shown| shown.is_made);
        let button = main_button(ui, said(names::LIBRARY));
        let meaning = said!("Keeps it among your own; it follows what it is made of.");
        if pressed_if(ui, is_made, button, meaning)
            && let Some(recipe) = context.pages.combine.recipe()
        {
            let place = MadeFor::Shown;
            context.commands.push(Command::Make { recipe, place });
        }
    }
    ui.add_space(GROUP);
}

/// The instruments that were learnt: a click chooses one.
fn instruments(ui: &mut Ui, state: &mut CombineState) {
    ui.add_space(GROUP);
    ui.label(RichText::new(said!("Instruments")).strong());
    let mut gone = None;
    for (place, kept) in state.instruments.iter().enumerate() {
        ui.horizontal(|ui| {
            ui.radio_value(&mut state.instrument, place, &kept.name)
                .on_hover_text(&kept.about);
            let name = tr!("Remove {instrument}", instrument = kept.name);
            if sign_button(ui, "\u{2715}", &name, said!("Takes it off the list.")) {
                gone = Some(place);
            }
        });
        ui.add(egui::Label::new(RichText::new(&kept.about).small()).wrap());
    }
    if let Some(place) = gone {
        state.instruments.remove(place);
    }
    if state.instruments.is_empty() {
        ui.weak(said!("An instrument that is learnt is listed here."));
    }
}

/// The verb, the spectra that it needs, and what else it asks.
fn controls(ui: &mut Ui, context: &mut PageContext<'_>, shown: Option<&Combined>) {
    let mut state = context.pages.combine.clone();
    let width = LIST * context.theme.scale;
    form(ui, "combine", |form| {
        let choice = Choice {
            name: said(names::VERB),
            meaning: state.verb.meaning(),
            width,
        };
        form.row((said(names::VERB), choice.meaning), |ui, _| {
            let words = |verb: Verb| (verb.title(), verb.meaning());
            choice.pick(ui, &mut state.verb, Verb::ALL, words);
        });
        for (index, slot) in state.verb.slots().iter().enumerate() {
            let chosen = slot_row(form, context, *slot, state.slots[index].as_deref(), width);
            if let Some(entry) = chosen {
                state.slots[index] = Some(entry.key.clone());
            }
        }
        of_verb(form, &mut state, width);
    });
    ui.add_space(6.0);
    ui.weak(state.verb.meaning());
    if let Some(light) = shown.and_then(|shown| shown.example_of.as_ref()) {
        ui.weak(tr!(
            "This is an example, drawn from {light}. Open your files, and choose them here.",
            light
        ));
    }
    if state.verb.slots().is_empty() {
        let left_out = shown.map_or(&[][..], |shown| &shown.left_out);
        marks(
            ui,
            context.app,
            said(names::SCANS),
            &mut state.scans,
            left_out,
        );
    }
    if state.verb == Verb::Changed {
        marks(ui, context.app, said(names::OTHERS), &mut state.others, &[]);
    }
    if matches!(state.verb, Verb::Corrected | Verb::Learnt) {
        instruments(ui, &mut state);
    }
    context.pages.combine = state;
}

fn slot_row(
    form: &mut Form<'_>,
    context: &PageContext<'_>,
    slot: Slot,
    key: Option<&str>,
    width: f32,
) -> Option<Arc<Entry>> {
    let entry = key.and_then(|key| context.app.entry(key));
    let says = entry
        .as_ref()
        .map_or(said!("choose a spectrum"), |entry| entry.name());
    let chooser = Chooser {
        name: said(slot.name),
        meaning: said(slot.meaning),
        says,
        offers: is_measurement,
        width,
    };
    form.row((said(slot.name), said(slot.meaning)), |ui, _| {
        chooser.show(ui, context.app)
    })
}

/// Whether a spectrum is a measurement, not a weighting, n or k.
pub(in crate::ui) fn is_measurement(entry: &Entry) -> bool {
    let of = &entry.spectrum;
    quantity_of(&of.name, of.kind, &of.unit).is_ok()
}

/// What only some verbs ask.
fn of_verb(form: &mut Form<'_>, state: &mut CombineState, width: f32) {
    let verb = state.verb;
    if verb == Verb::Unslit {
        form.rest(|ui| ui.checkbox(&mut state.is_told, said(names::TOLD)))
            .on_hover_text(said!("Else two of the light's own atomic lines tell it."));
    }
    if verb == Verb::Slit || verb == Verb::Unslit && state.is_told {
        let knob = CombineState::WIDTH;
        form.slider((knob.title(), knob.meaning()), slider(&knob, state));
    }
    if verb == Verb::Learnt {
        known_light(form, state, width);
    }
    if matches!(verb, Verb::Slit | Verb::Unslit) {
        let shapes = [Kernel::Gauss, Kernel::Triangle];
        let words = |shape| match shape {
            Kernel::Gauss => (said!("Gaussian"), ""),
            Kernel::Triangle => (said!("triangle"), ""),
        };
        let meaning = said!("How the slit weighs wavelengths.");
        picked(
            form,
            [said(names::SHAPE), meaning],
            width,
            &mut state.shape,
            shapes,
            words,
        );
    }
    if matches!(verb, Verb::Sum | Verb::Difference) {
        let scales = [
            None,
            Some(Normalise::Y),
            Some(Normalise::Area),
            Some(Normalise::Peak),
        ];
        let words = |by| match by {
            None => (said!("their own"), ""),
            Some(Normalise::Y) => (said!("equal Y"), ""),
            Some(Normalise::Area) => (said!("equal area"), ""),
            Some(_) => (said!("equal peak"), ""),
        };
        let meaning = said!("Lights without a common scale are brought to one first.");
        picked(
            form,
            [said(names::SCALE), meaning],
            width,
            &mut state.equal,
            scales,
            words,
        );
    }
    if matches!(verb, Verb::Quotient | Verb::QuotientLessDark) {
        form.rest(|ui| ui.checkbox(&mut state.of_surface, said(names::SURFACE)))
            .on_hover_text(said!(
                "The quotient is a reflectance; else a transmittance."
            ));
    }
    let keeps = match verb {
        Verb::Quotient | Verb::QuotientLessDark | Verb::Absorbance => {
            said!("Also where the reference is in the dark, where a quotient means little.")
        }
        Verb::Mean | Verb::Changed => said!("Also scans that do not belong to the others."),
        _ => return,
    };
    form.rest(|ui| ui.checkbox(&mut state.keep_all, said(names::KEEP_ALL)))
        .on_hover_text(keeps);
}

/// The light that an instrument is learnt from.
fn known_light(form: &mut Form<'_>, state: &mut CombineState, width: f32) {
    let words = |is_daylight| match is_daylight {
        true => (said!("daylight"), ""),
        false => (said!("black body"), said!("A bulb, or a furnace.")),
    };
    let meaning = said!("The light that was read.");
    picked(
        form,
        [said(names::KNOWN), meaning],
        width,
        &mut state.is_daylight,
        [false, true],
        words,
    );
    for knob in [CombineState::KELVIN, CombineState::DOUBT] {
        let field = drag(&knob, state);
        form.row((knob.title(), knob.meaning()), |ui, _| {
            kit::number(ui, field, knob.title())
        });
    }
}

/// A row of a few things to choose from.
fn picked<T: Copy + PartialEq>(
    form: &mut Form<'_>,
    [name, meaning]: [&'static str; 2],
    width: f32,
    now: &mut T,
    all: impl IntoIterator<Item = T>,
    words: impl Fn(T) -> (&'static str, &'static str),
) {
    let choice = Choice {
        name,
        meaning,
        width,
    };
    form.row((name, meaning), |ui, _| choice.pick(ui, now, all, words));
}

/// The user's own measurements, and others that were chosen, with a mark each; what does not belong
/// to the others is struck through, with why.
fn marks(
    ui: &mut Ui,
    app: &App,
    title: &str,
    keys: &mut Vec<String>,
    left_out: &[(String, String)],
) {
    ui.add_space(GROUP);
    let own = app
        .document()
        .own
        .iter()
        .filter(|e| is_measurement(e))
        .cloned();
    let mut all: Vec<Arc<Entry>> = own.collect();
    let own_keys: Vec<String> = all.iter().map(|entry| entry.key.clone()).collect();
    let others = keys.iter().filter(|key| !own_keys.contains(key));
    all.extend(others.filter_map(|key| app.entry(key)));
    ui.horizontal(|ui| {
        ui.label(RichText::new(title).strong());
        if !own_keys.is_empty() {
            if pressed_small(ui, said!("All"), said!("Marks all of your own.")) {
                *keys = own_keys;
            }
            if pressed_small(ui, said!("None"), said!("Marks none.")) {
                keys.clear();
            }
        }
    });
    if all.is_empty() {
        ui.weak(said!("Files that you open are listed here."));
    }
    for entry in all {
        let mut is_marked = keys.contains(&entry.key);
        let why = left_out.iter().find(|(key, _)| *key == entry.key);
        let name = RichText::new(entry.name());
        let name = if why.is_some() {
            name.strikethrough()
        } else {
            name
        };
        let mut mark = ui.checkbox(&mut is_marked, name);
        if let Some((_, why)) = why {
            mark = mark.on_hover_text(why);
        }
        if mark.changed() {
            match is_marked {
                true => keys.push(entry.key.clone()),
                false => keys.retain(|key| *key != entry.key),
            }
        }
    }
}
