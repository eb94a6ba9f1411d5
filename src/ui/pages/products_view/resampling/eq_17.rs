//! The factor at each spike by Eq. 17, and what reading it so costs.

use eframe::egui::Ui;

use super::names;
use crate::{
    app::{
        App,
        charts::products::resampling::Bench,
        studies::paper::{delta_e, figure},
        ticks::short,
    },
    ui::{
        kit::{Column, Row, table, titled},
        pages::PageContext,
    },
};

/// Eq. 17 at the light's spikes, as a table.
pub(super) fn show(ui: &mut Ui, context: &PageContext<'_>, bench: &Bench) {
    ui.add_space(6.0);
    let app: &App = context.app;
    titled(
        ui,
        "The factor at each spike, and what reading it so costs",
        names::COPY_SPIKES,
        "Copies Eq. 17 at every spike as a table.",
        || bench.spikes_csv(app),
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
    let mut rows: Vec<Row> = costs
        .each
        .iter()
        .map(|(reading, [series, corrected, printed])| {
            let at = format!("{:.1}", reading.spike.at_nm);
            Row {
                name: format!("Spike at {at} nm"),
                note: format!(
                    "Weight of the spike: {}.\n{COST}",
                    short(reading.spike.weight)
                ),
                cells: vec![
                    at,
                    figure(reading.measured),
                    figure(reading.series),
                    delta_e(*series),
                    figure(reading.linear),
                    delta_e(*corrected),
                    figure(reading.printed),
                    delta_e(*printed),
                ],
                ..Row::default()
            }
        })
        .collect();
    let [series, corrected, printed] = costs.all;
    rows.push(Row {
        name: "All spikes".to_owned(),
        note: "All spikes read so at once.".to_owned(),
        cells: vec![
            "all".to_owned(),
            String::new(),
            String::new(),
            delta_e(series),
            String::new(),
            delta_e(corrected),
            String::new(),
            delta_e(printed),
        ],
        ..Row::default()
    });
    let last = rows.len() - 1;
    table(ui, &columns(), &rows, Some(last), false, context.theme);
}

const COST: &str =
    "CIEDE2000 against the same product with this spike weighed by the factor as measured there.";

fn columns() -> [Column; 8] {
    [
        Column::numbers("at nm", "The spike's wavelength, nm.", 0.9),
        Column::numbers("measured", "The factor as measured there.", 1.1),
        Column::numbers(
            "series",
            "The factor's series evaluated exactly at the spike: what this program does.",
            1.0,
        ),
        Column::numbers("ΔE₀₀", COST, 1.2),
        Column::numbers(
            "corrected",
            "Eq. 17 with its two weights exchanged: the straight line between two of the paper's \
             points.",
            1.3,
        ),
        Column::numbers("ΔE₀₀", COST, 1.2),
        Column::numbers("as printed", "Eq. 17 with its weights as printed.", 1.2),
        Column::numbers("ΔE₀₀", COST, 1.2),
    ]
}
