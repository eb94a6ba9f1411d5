//! The spectrum of a pixel or a region of an image, with its spread and its model.

use crate::app::{
    chart::Inks,
    chart::{Chart, Dash, Marks, Series, Theme},
    derived::Derived,
    picture::{RegionSpectrum, Spread},
};

/// The chart of a chosen spectrum, as measured, in the image's unit.
pub fn region_chart(region: &RegionSpectrum, spread: Spread, theme: Theme) -> Chart {
    let inks = Inks::of(theme);
    let spectrum = &region.spectrum;
    let mean: Vec<[f64; 2]> = points(&region.nm, spectrum.samples.values());
    let is_region = region.rect.pixels() > 1;
    let mut series = Vec::new();
    if is_region {
        let (name, bounds) = bounds(region, spread);
        let area = Marks::Area {
            points: points(&region.nm, &bounds.iter().map(|b| b[1]).collect::<Vec<_>>()),
            base: bounds.iter().map(|b| b[0]).collect(),
        };
        series.push(Series::new(name, inks.smooth, area));
    }
    let name = if is_region { "mean" } else { "pixel" };
    series.push(Series::line(name, inks.measured, mean));
    if let Some(derived) = &region.derived {
        let line = Series::line("model", inks.spikes, model(derived, region));
        series.push(line.dashed(Dash::Dashed));
    }
    let mut notes = Vec::new();
    if !spectrum.source.is_empty() {
        notes.push(format!("Source: {}", spectrum.source));
    }
    notes.extend(spectrum.notes.last().cloned());
    notes.push(format!(
        "As measured. Spectral Explorer {}.",
        env!("CARGO_PKG_VERSION")
    ));
    Chart {
        title: spectrum.name.clone(),
        x_label: "Wavelength (nm)".to_owned(),
        y_label: if spectrum.unit.is_empty() {
            spectrum.kind.word().to_owned()
        } else {
            spectrum.unit.clone()
        },
        x_range: [spectrum.samples.first_nm(), spectrum.samples.last_nm()],
        series,
        notes,
        theme,
        ..Chart::default()
    }
}

/// The model where the image has bands: beyond them it is a guess.
fn model(derived: &Derived, region: &RegionSpectrum) -> Vec<[f64; 2]> {
    let samples = &region.spectrum.samples;
    let shown = samples.first_nm()..=samples.last_nm();
    let values = derived.model_values();
    let all = derived.band.grid().zip(values);
    all.filter(|(nm, _)| shown.contains(nm))
        .map(|(nm, value)| [nm, value])
        .collect()
}

fn bounds(region: &RegionSpectrum, spread: Spread) -> (&'static str, Vec<[f64; 2]>) {
    match spread {
        Spread::Deviation => {
            let means = region.spectrum.samples.values().iter();
            let both = means.zip(&region.deviation);
            let bounds = both.map(|(mean, s)| [mean - s, mean + s]).collect();
            ("± 1 standard deviation", bounds)
        }
        Spread::Extremes => ("smallest to largest", region.extremes.clone()),
    }
}

fn points(nm: &[f64], values: &[f64]) -> Vec<[f64; 2]> {
    nm.iter().zip(values).map(|(nm, v)| [*nm, *v]).collect()
}
