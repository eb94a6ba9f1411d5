//! The spikes behind a stage: what is left of each.

use eframe::egui::Ui;

use super::{names, percent};
use crate::{
    app::{
        charts::products::chain::{ChainSheet, Place},
        product_report::spikes_csv,
        products::KnownLines,
        ticks::short,
    },
    spectrum::Spike,
    ui::{
        kit::{self, Column, Row},
        pages::PageContext,
    },
};

/// The spikes behind the stage that is drawn.
pub(super) fn table(ui: &mut Ui, context: &PageContext<'_>, sheet: &ChainSheet, place: Place) {
    let (app, spikes) = (context.app, sheet.spikes(place));
    ui.horizontal(|ui| {
        let title = "Spikes, carried exactly (Eq. 14)";
        ui.strong(title).on_hover_text(
            "Each spike keeps its place; its weight is multiplied by the factor where it stands.",
        );
        if !spikes.is_empty()
            && ui
                .small_button(names::COPY_SPIKES)
                .on_hover_text("Copies places, weights and names as a table.")
                .clicked()
        {
            let stage = match place {
                Place::Light => "the light",
                Place::Stage(index) => &sheet.told.names[index],
            };
            ui.ctx()
                .copy_text(spikes_csv(app, stage, spikes, &sheet.told.known));
        }
    });
    if spikes.is_empty() {
        ui.weak(if app.document().settings.spikes {
            "No spikes: the light's lines are below the threshold, or there are none."
        } else {
            "Spikes are switched off."
        });
        return;
    }
    let document = app.document();
    let factor = document
        .scale
        .factor(&document.light.spectrum)
        .unwrap_or(1.0);
    let columns = [
        Column::numbers("nm", "Where the spike stands, nm.", 0.8),
        Column::numbers(
            "weight",
            "Power of the spike here, in the unit of the plot × nm.",
            1.1,
        ),
        Column::numbers(
            "of the light's",
            "Its weight here over that in the light, percent: what the factors so far let through \
             at its place. A dip of a factor has none in the light.",
            1.1,
        ),
        Column::words(
            "line",
            "Named only where it is safe; otherwise the nearest line.",
            1.4,
        ),
    ];
    let own = &sheet.light.derived.model.spikes;
    let rows: Vec<Row> = spikes
        .iter()
        .map(|spike| row(spike, own, factor, &sheet.told.known))
        .collect();
    kit::scrolled(ui, "spikes of the stage", |ui| {
        kit::table(ui, &columns, &rows, None, false, context.theme)
    });
}

fn row(spike: &Spike, own: &[Spike], factor: f64, known: &KnownLines) -> Row {
    let in_light = own.iter().find(|s| s.at_nm == spike.at_nm);
    let share = in_light.map(|s| spike.weight / s.weight);
    let name = known
        .at(spike.at_nm)
        .and_then(|name| name.safe.clone().or_else(|| name.near.clone()))
        .unwrap_or_else(|| "–".to_owned());
    let cells = vec![
        format!("{:.1}", spike.at_nm),
        short(spike.weight * factor),
        percent(share.filter(|s| s.is_finite()), false),
        name.clone(),
    ];
    Row {
        name: format!("Spike at {} nm, weight {}, {name}", cells[0], cells[1]),
        cells,
        ..Row::default()
    }
}
