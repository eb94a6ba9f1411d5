//! The factor at each spike by Eq. 17, and what reading it so costs.

use eframe::egui::Ui;

use super::names;
use crate::{
    app::{
        charts::products::resampling::{Bench, EQ_17_COST},
        numbers::delta_e,
        ticks::short,
    },
    ui::{
        kit::{self, Row, titled},
        pages::PageContext,
    },
};

/// Eq. 17 at the light's spikes, as a table.
pub(super) fn show(ui: &mut Ui, context: &PageContext<'_>, bench: &Bench) {
    ui.add_space(6.0);
    let table = bench.spikes_table(context.app);
    titled(
        ui,
        "The factor at each spike, and what reading it so costs",
        names::COPY_SPIKES,
        "Copies Eq. 17 at every spike as a table.",
        || table.csv(),
    );
    let costs = &bench.spikes;
    if costs.each.is_empty() {
        ui.weak("This model has no spikes.");
        return;
    }
    ui.weak(
        "Costs are against the factor as measured: where the series is far off, a wrong reading \
         may come out nearer by chance. The page \"The paper checked\" compares with the series.",
    );
    let mut rows = kit::rows(&table, |i, cells| {
        let weight = short(costs.each[i].0.spike.weight);
        [
            format!("Spike at {} nm", cells[0]),
            format!("Weight of the spike: {weight}.\n{EQ_17_COST}"),
        ]
    });
    let [series, corrected, printed] = costs.all;
    rows.push(Row {
        name: "All spikes".to_owned(),
        note: "All spikes read so at once.".to_owned(),
        cells: vec![
            "all".to_owned(),
            String::new(),
            String::new(),
            String::new(),
            String::new(),
            delta_e(series),
            delta_e(corrected),
            delta_e(printed),
        ],
        ..Row::default()
    });
    let last = rows.len() - 1;
    let columns = kit::columns(&table, &[0.9, 1.1, 1.0, 1.2, 1.2, 1.2, 1.3, 1.3]);
    kit::table(ui, &columns, &rows, Some(last), false, context.theme);
}
