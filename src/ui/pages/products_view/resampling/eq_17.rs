//! The factor at each spike by Eq. 17, and what reading it so costs.

use eframe::egui::Ui;

use super::names;
use crate::{
    app::{
        charts::products::resampling::{Bench, EQ_17_COST},
        numbers::delta_e,
        ticks::short,
    },
    languages::said,
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
        said!("The surface at each line, and the cost of reading it so"),
        said(names::COPY_SPIKES),
        said!("Copies Eq. 17 at every line as a table."),
        || table.csv(),
    );
    let costs = &bench.spikes;
    if costs.each.is_empty() {
        ui.weak(said!("This model has no lines."));
        return;
    }
    ui.weak(said!(
        "Costs are against the surface as measured: where the series is far off, a wrong reading \
         may come out nearer by chance. The page \"The paper checked\" compares with the series."
    ));
    let mut rows = kit::rows(&table, |i, cells| {
        let weight = short(costs.each[i].0.spike.weight);
        [
            tr!("Line at {place} nm", place = cells[0]),
            tr!(
                "Weight of the line: {weight}.\n{meaning}",
                weight,
                meaning = said(EQ_17_COST)
            ),
        ]
    });
    let [series, corrected, printed] = costs.all;
    rows.push(Row {
        name: said!("All lines").to_owned(),
        note: said!("All lines read so at once.").to_owned(),
        cells: vec![
            said!("all").to_owned(),
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
