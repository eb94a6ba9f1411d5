//! The model's side of a chain: how its products are formed, what they are off by, and its lines.

use crate::languages::{Language, in_language};
use eframe::egui;
use egui::{RichText, Ui};

use super::{super::take_way, names};
use crate::{
    app::{
        charts::products::chain::{ChainSheet, Place},
        numbers::hundredths,
        product_report::{scaled, spikes_table, stages_table},
        products::KnownLines,
        ticks::short,
    },
    languages::{fixed, said},
    spectrum::{Line, Sampling},
    study::products::Colours,
    ui::{
        kit::{Choice, Column, GROUP, Row, pressed, pressed_small, table},
        model_view::sampling_words,
        pages::PageContext,
    },
};

pub(super) fn show(ui: &mut Ui, context: &mut PageContext<'_>, sheet: &ChainSheet, place: Place) {
    ui.horizontal_wrapped(|ui| {
        way(ui, context);
        let meaning = said!("Copies the light and every step as a table.");
        if pressed(ui, said(names::COPY_STAGES), meaning) {
            let chain = &context.app.document().products.chain;
            let table = || stages_table(context.app, &sheet.told, chain).csv();
            ui.ctx().copy_text(in_language(Language::English, table));
        }
    });
    ui.add_space(4.0);
    steps(ui, context, sheet);
    totals(ui, sheet);
    ui.add_space(GROUP);
    spike_table(ui, context, sheet, place);
}

/// What exact light and model are behind each step.
fn steps(ui: &mut Ui, context: &PageContext<'_>, sheet: &ChainSheet) {
    let columns = [
        Column::words("", said!("The light and the steps behind it."), 2.0),
        Column::numbers(
            said!("Y exact"),
            said!("Luminance, the light's at 100."),
            1.0,
        ),
        Column::numbers(said!("Y model"), said!("The same by the model."), 1.0),
        Column::numbers(
            "ΔE₀₀",
            said!("CIEDE2000 between exact and model; the white is the exact light."),
            1.0,
        ),
        Column::numbers(
            said!("brightness, %"),
            said!("Luminance error: Y model over Y exact, minus 1."),
            1.0,
        ),
    ];
    let passage = &sheet.told.passage;
    let row = |name: &str, colours: &Colours| {
        let y = |xyz| scaled(passage, xyz).map(|(xyz, _)| xyz.y);
        Row::of(vec![
            name.to_owned(),
            hundredths(y(colours.exact)),
            hundredths(y(colours.model)),
            hundredths(colours.delta_e_2000),
            hundredths(colours.luminance_error.map(|share| 100.0 * share)),
        ])
    };
    let behind = sheet.told.names.iter().zip(&passage.steps);
    let rows: Vec<Row> = std::iter::once(row(context.app.document().light.name(), &passage.light))
        .chain(behind.map(|(name, step)| row(name, &step.colours)))
        .collect();
    table(ui, &columns, &rows, None, false, context.theme);
}

/// The chain as one product, a sentence.
fn totals(ui: &mut Ui, sheet: &ChainSheet) {
    let total = sheet.told.passage.total();
    let added = total.added.map_or(String::new(), |added| {
        tr!(
            "Forming the products adds ΔE₀₀ {difference}. ",
            difference = hundredths(added)
        )
    });
    let folded = match 100.0 * total.folded_share {
        0.0 => String::new(),
        share => tr!(
            "{share} % of the power is folded back. ",
            share = hundredths(share)
        ),
    };
    let multiplications =
        tr!("{n} multiplications." | "{n} multiplications." % total.multiplications);
    let words = format!("{added}{folded}{multiplications}");
    ui.add(egui::Label::new(RichText::new(words).weak()).wrap())
        .on_hover_text(said!(
            "Against the exact product of the same model and series; errors of colour do not \
             simply add up. Folded: power in waves that the points fold back (a convolution cuts \
             it off). One multiplication a point, or a pair of numbers, and one a line."
        ));
}

/// The ways of forming products.
fn way(ui: &mut Ui, context: &mut PageContext<'_>) {
    let before = context.app.document().settings.sampling;
    ui.label(said!("formed by")).on_hover_text(said!(
        "The model's way of forming the product of light and step; the exact side is always the \
         measured curves at every nm."
    ));
    let choice = Choice {
        name: said(names::WAY),
        meaning: sampling_words(before).1,
        width: 120.0 * context.theme.scale,
    };
    let mut sampling = before;
    choice.pick(ui, &mut sampling, Sampling::ALL, sampling_words);
    if sampling != before {
        take_way(context, sampling);
    }
}

/// The spikes behind the stage that is drawn.
fn spike_table(ui: &mut Ui, context: &PageContext<'_>, sheet: &ChainSheet, place: Place) {
    let (app, spikes) = (context.app, sheet.spikes(place));
    ui.horizontal(|ui| {
        let title = said!("Lines, carried exactly (Eq. 14)");
        ui.strong(title).on_hover_text(said!(
            "Each line keeps its place; its weight is multiplied by what the step lets through \
             there."
        ));
        let meaning = said!("Copies places, weights and names as a table.");
        if !spikes.is_empty() && pressed_small(ui, said(names::COPY_SPIKES), meaning) {
            let stage = match place {
                Place::Light => said!("the light"),
                Place::Stage(index) => &sheet.told.names[index],
            };
            let table = || spikes_table(app, stage, spikes, &sheet.told.known).csv();
            ui.ctx().copy_text(in_language(Language::English, table));
        }
    });
    if spikes.is_empty() {
        ui.weak(if app.document().settings.spikes {
            said!("No lines: those of the light are below the threshold, or there are none.")
        } else {
            said!("Lines are switched off.")
        });
        return;
    }
    let document = app.document();
    let factor = document
        .scale
        .factor(&document.light.spectrum)
        .unwrap_or(1.0);
    let columns = [
        Column::numbers("nm", said!("Place of the line, nm."), 0.8),
        Column::numbers(
            said!("weight"),
            said!("Power of the line here, in the unit of the plot × nm."),
            1.1,
        ),
        Column::numbers(
            said!("of the light's, %"),
            said!(
                "Its weight here over that in the light, percent: the share that the steps so far \
                 let through at its place. A dark line of a step has none in the light."
            ),
            1.1,
        ),
        Column::words(
            said!("line"),
            said!("Named only where it is safe; otherwise the nearest line."),
            1.4,
        ),
    ];
    let own = sheet.light.derived.model.lines();
    let rows: Vec<Row> = spikes
        .iter()
        .map(|spike| row(spike, own, factor, &sheet.told.known))
        .collect();
    table(ui, &columns, &rows, None, false, context.theme);
}

fn row(spike: &Line, own: &[Line], factor: f64, known: &KnownLines) -> Row {
    let in_light = own.iter().find(|s| s.at_nm == spike.at_nm);
    let share = in_light.map(|s| spike.weight / s.weight);
    let name = known
        .at(spike.at_nm)
        .and_then(|name| name.safe.clone())
        .unwrap_or_else(|| "–".to_owned());
    let cells = vec![
        fixed(spike.at_nm, 1),
        short(spike.weight * factor),
        hundredths(share.filter(|s| s.is_finite()).map(|s| 100.0 * s)),
        name.clone(),
    ];
    Row {
        name: tr!(
            "Line at {place} nm, weight {weight}, {name}",
            place = cells[0],
            weight = cells[1],
            name
        ),
        cells,
        ..Row::default()
    }
}
