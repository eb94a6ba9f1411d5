//! The reflection check as a chart: what was expected and what was found, as they were compared.

use super::chain::strip;
use crate::{
    app::{
        chart::{Chart, Dash, Ink, Panel, Series},
        charts::spectrum::{before_provenance, on_grid, over},
        derived::less,
        products::{ModelledLight, same_surface::SameSurfaceSheet},
        state::App,
    },
    study::products::Compared,
};

/// The check as a sum is written: the light, times the surface, is the spectrum that was found,
/// with what was expected of it.
pub fn as_product(app: &App, sheet: &SameSurfaceSheet) -> [Chart; 3] {
    let band = sheet.band;
    let [light, surface, outgoing] = &sheet.names;
    let filled = |title: String, values: &[f64]| {
        let area = Series::area("", Ink::Measured, on_grid(band, values, 1.0), Vec::new());
        Chart {
            title,
            series: vec![area.coloured()],
            colours: strip(band),
            ..over(band)
        }
    };
    let document = app.document();
    let factor = document.products.surface.as_ref();
    let reflected = factor.map_or(Vec::new(), |entry| entry.on_band(band));
    let compared = sheet.measured.as_ref();
    let found = compared.map_or(&[][..], |compared| &compared.found);
    let mut last = filled(format!("The spectrum: {outgoing}"), found);
    if let Some(compared) = compared {
        let expected = on_grid(band, &compared.expected, 1.0);
        let line = Series::line("the product", Ink::Spikes, expected);
        last.series.push(line.dashed(Dash::Dashed));
    }
    last.y_label = "Relative power".to_owned();
    let lit = ModelledLight::of(app);
    [
        Chart {
            y_label: "Relative power".to_owned(),
            ..filled(format!("The light: {light}"), &lit.derived.measured)
        },
        Chart {
            y_label: "Reflectance".to_owned(),
            y_range: Some([0.0, 1.0]),
            ..filled(format!("The surface: {surface}"), &reflected)
        },
        last,
    ]
}

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
