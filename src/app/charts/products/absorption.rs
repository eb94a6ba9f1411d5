//! Charts of the part "absorption" of the page "Products": absorption lines.

use crate::{
    app::{
        chart::Inks,
        chart::{Chart, Dash, Marks, Rgb, Series, Theme},
        charts::spectrum::provenance,
        state::App,
    },
    spectrum::{Spike, chain::below_zero},
    study::products::dips::depths,
};

use super::chain::strip;

/// A dip of the subject as it is told.
#[derive(Clone, Debug, PartialEq)]
pub struct DipRow {
    /// The dip: place in nm, weight in the subject's own unit x nm.
    pub spike: Spike,
    /// Share of the background that is missing at its deepest, 0-1.
    pub depth: Option<f64>,
    /// A name that is safe.
    pub name: Option<String>,
    /// The nearest line of its family, for hover.
    pub near: Option<String>,
    /// Whether the model's total is below zero there.
    pub below_zero: bool,
}

/// The subject's dips, by rising wavelength.
pub fn dip_rows(app: &App) -> Vec<DipRow> {
    let derived = app.derived();
    let spikes = &derived.model.spikes;
    let depths = depths(
        derived.band,
        &derived.measured,
        &derived.parts.smooth,
        spikes,
    );
    let width = app.document().settings.max_width_nm;
    let below = below_zero(derived.band, &derived.smooth, spikes, width);
    spikes
        .iter()
        .zip(depths)
        .zip(app.spike_names())
        .filter(|((spike, _), _)| spike.weight < 0.0)
        .map(|((spike, depth), name)| DipRow {
            spike: *spike,
            depth,
            name: name.safe.clone(),
            near: name.near.clone(),
            below_zero: below.contains(&spike.at_nm),
        })
        .collect()
}

/// Measured curve, what is left when dips are filled, the series, and the dips hanging from it.
pub fn absorption_chart(app: &App, dips: &[DipRow], theme: Theme) -> Chart {
    let (document, derived) = (app.document(), app.derived());
    let (inks, band, factor) = (Inks::of(theme), derived.band, app.scale_factor());
    let curve = |values: &[f64]| -> Vec<[f64; 2]> {
        let scaled = values.iter().map(|v| v * factor);
        band.grid().zip(scaled).map(|(nm, v)| [nm, v]).collect()
    };
    let mut series = vec![
        Series::new(
            "background",
            inks.residual,
            Marks::Line {
                points: curve(&derived.parts.smooth),
                width: 1.3,
                dash: Dash::Dashed,
            },
        ),
        Series::line("measured", inks.measured, curve(&derived.measured)),
        Series::line("smooth part", inks.smooth, curve(&derived.smooth)),
    ];
    let width = document.settings.max_width_nm;
    let stem = |spike: &Spike| {
        let base = factor * band.interpolate(&derived.smooth, spike.at_nm);
        (base, base + factor * spike.stem_height(width))
    };
    let mut stems = |name: &str, ink: Rgb, all: Vec<(Spike, String, String)>| {
        if all.is_empty() {
            return;
        }
        let ends: Vec<(f64, f64)> = all.iter().map(|(spike, ..)| stem(spike)).collect();
        let places = all.iter().zip(&ends);
        let marks = Marks::Stems {
            points: places.map(|((s, ..), (_, tip))| [s.at_nm, *tip]).collect(),
            base: ends.iter().map(|(base, _)| *base).collect(),
            labels: all.iter().map(|(_, label, _)| label.clone()).collect(),
        };
        let notes = all.into_iter().map(|(.., note)| note).collect();
        series.push(Series::new(name, ink, marks).with_notes(notes));
    };
    let lines = derived.model.spikes.iter().filter(|s| s.weight >= 0.0);
    stems(
        "spikes",
        inks.spikes,
        lines.map(|s| (*s, String::new(), String::new())).collect(),
    );
    let told = |dip: &DipRow| {
        let label = dip.name.clone();
        let label = label.unwrap_or_else(|| format!("{:.1}", dip.spike.at_nm));
        let note = match dip.depth {
            Some(depth) => format!("{label}: {:.1} % deep", 100.0 * depth),
            None => label.clone(),
        };
        (dip.spike, label, note)
    };
    stems("dips", inks.product, dips.iter().map(told).collect());
    let unit = app.unit();
    let mut notes = vec![format!("Spectrum: {}", document.subject_entry().name())];
    notes.extend(provenance(app));
    Chart {
        title: format!("Absorption: {}", document.subject_entry().name()),
        x_label: "Wavelength (nm)".to_owned(),
        y_label: if unit.is_empty() {
            "value".to_owned()
        } else {
            unit.to_owned()
        },
        x_range: [band.min_nm(), band.max_nm()],
        series,
        strip: strip(band, theme),
        notes,
        theme,
        ..Chart::default()
    }
}
