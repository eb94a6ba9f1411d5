//! The reflection check as a chart: what was expected and what was found, as they were compared.

use crate::{
    app::{
        chart::{Chart, Dash, Ink, Panel, Series},
        charts::spectrum::{before_provenance, on_grid, over},
        derived::less,
        products::same_surface::SameSurfaceSheet,
        state::App,
    },
    study::products::Compared,
};

/// One of the two checks; `what` says whose numbers were compared.
pub fn same_surface_chart(
    app: &App,
    sheet: &SameSurfaceSheet,
    compared: &Compared,
    what: &str,
) -> Chart {
    let curve = |values: &[f64]| on_grid(sheet.band, values, 1.0);
    let Compared {
        reflection,
        expected,
        found,
    } = compared;
    let rest = less(found, expected);
    let [light, surface, outgoing] = &sheet.names;
    let told = format!(
        "S1 {light}, S2 {surface}, S3 {outgoing}. Expected is S1 S2 times {:.4}; residual {:.4}.",
        reflection.factor, reflection.residual
    );
    Chart {
        title: what.to_owned(),
        y_label: "share of the largest value, behind 10 nm".to_owned(),
        series: vec![
            Series::line("found: S3", Ink::Measured, curve(found)),
            Series::line("expected: S1 S2", Ink::Spikes, curve(expected)).dashed(Dash::Dashed),
        ],
        residual: Some(Panel {
            y_label: "found - expected".to_owned(),
            series: vec![Series::line("difference", Ink::Residual, curve(&rest))],
            ..Panel::default()
        }),
        notes: before_provenance(vec![told], app),
        ..over(sheet.band)
    }
}
