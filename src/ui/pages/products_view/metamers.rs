//! The part "Metamers": surfaces that look alike under the light and differ under the second light,
//! found in the library or made for a surface.

mod table;

use eframe::egui;
use egui::{Button, Label, RichText, Ui, vec2};

use super::{among, second_light};
use crate::{
    app::{
        ByAddress, Command, MadeFor, Memo, Recipe,
        chart::Chart,
        charts::products::two_lights::{Found, MadeShown},
        headlines,
        pages::TwoLightsMemory,
        products::two_lights::{NoMetamer, TwoLightsSheet, pairs_table},
        studies::{Pairs, PairsAsk, Stage},
        ticks::short,
        verdicts::Seen,
    },
    color::{Adaptation, Swatch},
    languages::{fixed, said},
    study::products::MATCH_DELTA_E,
    ui::{
        kit::{Choice, Row, Table, bounded, copy_button, down, headline, knob, named, rolled},
        pages::{PageContext, progress},
        patches_view::set_choice,
        swatch,
        theme::of_seen,
    },
};

/// From this width on the list and the curves stand side by side, points.
const WIDE: f32 = 640.0;
/// Height of the pairs on top: usual and least, points.
const PAIR: [f32; 2] = [160.0, 72.0];
/// Least height of the curves, points.
const CURVES: f32 = 190.0;

/// What buttons and lists are called.
pub mod names {
    pub const AMONG: &str = later!("Pairs among");
    pub const COPY_PAIRS: &str = later!("Copy the pairs as CSV");
    pub const FOUND: &str = later!("Found in the library");
    pub const MADE: &str = later!("Made for a surface");
    pub const SET: &str = later!("Surface set");
    pub const SURFACE: &str = later!("Surface");
    pub const ROOM: &str = later!("Part of the room");
    pub const KEEP: &str = later!("Keep as my own spectrum");
}

/// The part and what it keeps from frame to frame.
#[derive(Default)]
pub struct MetamersView {
    sheet: Memo<u64, TwoLightsSheet>,
    made: Memo<(u64, usize, i32), Result<MadeShown, NoMetamer>>,
    found: Memo<(ByAddress<Pairs>, Adaptation, usize), Found>,
    rows: Memo<ByAddress<Pairs>, Vec<Row>>,
}

/// Two surfaces under both lights.
struct Pair<'a> {
    names: [String; 2],
    /// Both under each light.
    swatches: [[&'a Swatch; 2]; 2],
    /// Between the two under each light.
    delta_e_2000: [f64; 2],
    curves: &'a Chart,
}

impl MetamersView {
    /// Draws the part.
    pub fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let app = context.app;
        let (revision, adaptation) = (app.revision(), app.document().view.adaptation());
        let memory = context.pages.two_lights;
        let sheet = &*self.sheet.get(revision, |_| TwoLightsSheet::of(app));
        if memory.makes {
            let surface = memory.patch.min(sheet.names.len().saturating_sub(1));
            let key = (revision, surface, memory.room_percent);
            let made = &*self.made.get(key, |_| {
                MadeShown::of(app, sheet, (surface, memory.room_percent), adaptation)
            });
            let pair = made.as_ref().ok().map(|shown| made_pair(sheet, shown));
            page(ui, context, sheet, pair, |ui, context, pair| {
                made_controls(ui, context, sheet, (made, surface), pair.is_some());
            });
            return;
        }
        context.put(&pairs_ask(context));
        let found = context.studies.of::<PairsAsk>().answer();
        let found = found.map(|(ask, pairs)| {
            let chosen = memory
                .pair
                .min(pairs.metamers.pairs.len().saturating_sub(1));
            let of = ByAddress(pairs.clone());
            let key = (of.clone(), adaptation, chosen);
            let found = self
                .found
                .get(key, |_| Found::of(app, ask, pairs, chosen, adaptation));
            (
                &*found,
                self.rows.get(of, |_| table::rows(pairs)).as_slice(),
            )
        });
        let job = context.studies.of::<PairsAsk>();
        let found = found.filter(|_| job.stage() != Stage::Impossible);
        let pair = found.and_then(|(found, _)| found_pair(found));
        page(ui, context, sheet, pair, |ui, context, _| {
            list(ui, context, found);
        });
    }
}

/// The sentence, the pair on top, below it what chooses it and its curves.
fn page(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    sheet: &TwoLightsSheet,
    pair: Option<Pair<'_>>,
    chooses: impl FnOnce(&mut Ui, &mut PageContext<'_>, &Option<Pair<'_>>),
) {
    let theme = context.theme;
    let lights = sheet.lights.each_ref().map(String::as_str);
    let sentence = match &pair {
        Some(pair) => headlines::metamers(lights, &pair.names, pair.delta_e_2000),
        None => {
            said!("Surfaces that look alike under one light and differ under another.").to_owned()
        }
    };
    headline(ui, theme, sentence);
    second_light(ui, context);
    ui.add_space(4.0);
    let room = ui.available_size();
    let pair_height = bounded(0.3 * room.y, PAIR[1], PAIR[0] * theme.scale);
    if let Some(pair) = &pair {
        swatches(ui, context, pair, lights, pair_height);
        ui.add_space(8.0);
    }
    let curves = |ui: &mut Ui, context: &mut PageContext<'_>, height: f32| {
        if let Some(pair) = &pair {
            let size = vec2(ui.available_width(), height);
            context.chart(ui, pair.curves, "metamers", size);
        }
    };
    let room = ui.available_size();
    if room.x >= WIDE * theme.scale {
        let width = (0.5 * room.x - 8.0).floor();
        ui.horizontal_top(|ui| {
            down(ui, vec2(width, room.y), |ui| {
                ui.set_width(width);
                chooses(ui, context, &pair);
            });
            ui.add_space(8.0);
            down(ui, vec2(ui.available_width(), room.y), |ui| {
                curves(ui, context, room.y.max(CURVES));
            });
        });
    } else {
        rolled(ui, |ui| {
            curves(ui, context, CURVES * theme.scale);
            chooses(ui, context, &pair);
        });
    }
}

/// The pair under each light, large.
fn swatches(
    ui: &mut Ui,
    context: &PageContext<'_>,
    pair: &Pair<'_>,
    lights: [&str; 2],
    height: f32,
) {
    let theme = context.theme;
    let gap = 16.0;
    let width = ((ui.available_width() - gap) / 2.0).floor();
    ui.horizontal_top(|ui| {
        ui.spacing_mut().item_spacing.x = gap;
        for (i, light) in lights.into_iter().enumerate() {
            down(ui, vec2(width, height + 40.0), |ui| {
                ui.set_width(width);
                let [left, right] = pair.swatches[i];
                let [one, other] = &pair.names;
                let delta = pair.delta_e_2000[i];
                let name = tr!(
                    "Under {light}: left {one}, right {other}, ΔE₀₀ {difference}",
                    light,
                    one,
                    other,
                    difference = fixed(delta, 2)
                );
                let drawn = swatch::split(ui, vec2(width, height), left, right, &name);
                swatch::ticks(ui, drawn.rect, 8.0 * theme.scale);
                drawn.on_hover_text(&name);
                ui.horizontal(|ui| {
                    let seen = Seen::of(delta);
                    ui.colored_label(of_seen(seen, theme.dark), seen.word());
                    let words = tr!(
                        "under {light}, ΔE₀₀ {difference}",
                        light,
                        difference = fixed(delta, 1)
                    );
                    ui.add(Label::new(words).truncate());
                });
            });
        }
    });
}

/// The switch between what is found and what is made.
fn modes(ui: &mut Ui, context: &mut PageContext<'_>) {
    let makes = &mut context.pages.two_lights.makes;
    ui.horizontal_wrapped(|ui| {
        ui.selectable_value(makes, false, said(names::FOUND))
            .on_hover_text(said!(
                "All pairs among measured surfaces that match under the light."
            ));
        ui.selectable_value(makes, true, said(names::MADE))
            .on_hover_text(said!("A twin of any surface: it matches under the light."));
    });
}

fn made_pair<'a>(sheet: &'a TwoLightsSheet, shown: &'a MadeShown) -> Pair<'a> {
    let under = |i: usize| [&shown.swatches[0][i], &shown.swatches[1][i]];
    Pair {
        names: [
            sheet.names[shown.made.patch].clone(),
            said!("its twin").to_owned(),
        ],
        swatches: [under(0), under(1)],
        delta_e_2000: shown.made.delta_e_2000,
        curves: &shown.chart,
    }
}

fn found_pair(found: &Found) -> Option<Pair<'_>> {
    let pair = found.pairs.metamers.pairs.get(found.chosen)?;
    let surfaces = pair.pair;
    let under = |i: usize| surfaces.map(|surface| &found.swatches[surface][i]);
    Some(Pair {
        names: surfaces.map(|surface| found.pairs.surfaces[surface].words()),
        swatches: [under(0), under(1)],
        delta_e_2000: pair.delta_e_2000,
        curves: found.chart.as_ref()?,
    })
}

fn pairs_ask(context: &PageContext<'_>) -> PairsAsk {
    let document = context.app.document();
    let everywhere = context.pages.two_lights.everywhere;
    PairsAsk {
        lights: [document.light.clone(), document.light_beside()].map(ByAddress),
        band: document.settings.band,
        observer: document.settings.observer,
        group: (!everywhere).then(|| document.patch_set.clone()),
    }
}

/// The surface that a metamer is made for, and how far it goes.
fn made_controls(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    sheet: &TwoLightsSheet,
    (made, surface): (&Result<MadeShown, NoMetamer>, usize),
    is_made: bool,
) {
    modes(ui, context);
    ui.add_space(4.0);
    let [first, second] = &sheet.lights;
    ui.add(
        Label::new(RichText::new(tr!(
            "A curve that {first} shows as nothing is added to a surface: the sum looks the same \
             under {first} and different under {second}.",
            first,
            second
        )))
        .wrap(),
    );
    ui.add_space(4.0);
    let width = 150.0 * context.theme.scale;
    egui::Grid::new("a metamer made")
        .num_columns(2)
        .spacing([8.0, 8.0])
        .show(ui, |ui| {
            ui.label(said!("Among"));
            let choice = Choice {
                name: said(names::SET),
                meaning: said!("The surfaces that can be changed."),
                width,
            };
            set_choice(ui, choice, context.app, context.commands);
            ui.end_row();
            ui.label(said(names::SURFACE));
            let choice = Choice {
                name: said(names::SURFACE),
                meaning: said!("The surface that a twin is made for."),
                width,
            };
            let memory = &mut context.pages.two_lights;
            let chosen = sheet.names.get(surface).map_or("", String::as_str);
            choice.cut(ui, chosen, |ui| {
                for (i, name) in sheet.names.iter().enumerate() {
                    ui.selectable_value(&mut memory.patch, i, name);
                }
            });
            ui.end_row();
            ui.label(said!("How far"));
            let slider = knob::slider(&TwoLightsMemory::ROOM, memory);
            let slider = ui.add_enabled(is_made, slider);
            named(&slider, egui::Role::Slider, said(names::ROOM));
            slider.on_hover_text(said!(
                "100 % goes on until the twin would reflect less than nothing or more than all, \
                 -100 % the other way; 0 % is the surface itself."
            ));
            ui.end_row();
        });
    let kept = made
        .as_ref()
        .ok()
        .filter(|shown| shown.made.room_percent != 0);
    let button = ui
        .add_enabled(kept.is_some(), Button::new(said(names::KEEP)))
        .on_hover_text(said!(
            "Puts the made reflectance into the library and opens it."
        ))
        .on_disabled_hover_text(said!("There is nothing made to keep."));
    if let Some(shown) = kept.filter(|_| button.clicked()) {
        let document = context.app.document();
        let recipe = Recipe::Metamer {
            light: document.light.key.clone(),
            other: document.light_beside().key.clone(),
            patch_set: document.patch_set.clone(),
            patch: shown.made.patch,
            room_percent: shown.made.room_percent,
        };
        let place = MadeFor::Shown;
        context.commands.push(Command::Make { recipe, place });
    }
    if let Err(why) = made {
        ui.add(Label::new(why.words()).wrap());
    }
}

/// Pairs found in the library: a click on a row shows one.
fn list(ui: &mut Ui, context: &mut PageContext<'_>, found: Option<(&Found, &[Row])>) {
    modes(ui, context);
    ui.add_space(4.0);
    ui.horizontal_wrapped(|ui| {
        ui.label(said!("Among"));
        let meaning = said!("The surfaces that are compared, each with each.");
        let everywhere = context.pages.two_lights.everywhere;
        context.pages.two_lights.everywhere =
            among(ui, context, said(names::AMONG), meaning, everywhere);
        copy_button(ui, said(names::COPY_PAIRS), "", || {
            found.map_or_else(String::new, |(found, _)| {
                pairs_table(&found.lights, &found.pairs).csv()
            })
        });
        let job = context.studies.of::<PairsAsk>();
        if job.stage() != Stage::Done {
            progress(ui, job, said!("The pairs"));
        }
    });
    let Some((found, rows)) = found else {
        return;
    };
    let pairs = &found.pairs.metamers.pairs;
    let [first, second] = &found.lights;
    let surfaces = found.pairs.surfaces.len();
    let Some(index) = found.pairs.metamers.index else {
        let words = tr!(
            "No two of {surfaces} surfaces match under {first} (ΔE₀₀ below {limit}) without being \
             the same curve.",
            surfaces,
            first,
            limit = short(MATCH_DELTA_E)
        );
        ui.add(Label::new(words).wrap());
        return;
    };
    let words = tr!(
        "{n} pair of {surfaces} surfaces match under {first} (ΔE₀₀ below {limit}); metamerism \
         index under {second}: {index}."
            | "{n} pairs of {surfaces} surfaces match under {first} (ΔE₀₀ below {limit}); \
               metamerism index under {second}: {index}."
                % pairs.len(),
        surfaces,
        first,
        limit = short(MATCH_DELTA_E),
        second,
        index = fixed(index, 2)
    );
    ui.add(Label::new(words).wrap()).on_hover_text(said!(
        "Metamerism index: mean CIEDE2000 under the second light of all pairs that match under the \
         first. Two curves closer than 0.01 (root mean square) are one surface and no pair."
    ));
    let columns = table::columns(&found.lights);
    let table = Table {
        chosen: Some(found.chosen),
        ..Table::new(&columns, context.theme)
    };
    let least = 6.0 * table.row_height(ui);
    let height = (ui.available_height() - 1.5 * table.row_height(ui)).max(least);
    let mut paint = |ui: &Ui, [row, column]: [usize; 2], cell: egui::Rect| {
        if let 1 | 3 = column {
            let pair = pairs[row].pair;
            let light = column / 2;
            let [left, right] = pair.map(|i| swatch::colour(found.swatches[i][light].rgb8));
            swatch::paint_split(ui, cell.shrink2(vec2(0.0, 2.0)), left, right);
        }
    };
    if let Some(pair) = table.scrolled(ui, "pairs", height, rows, &mut paint) {
        context.pages.two_lights.pair = pair;
    }
}
