//! The spectrum of a pixel or a region of an image, with its spread and its model.

use crate::app::{
    chart::{Chart, Dash, Ink, Series, curve},
    charts::{
        spectrum::{by_program, source_of},
        units::kind_label,
    },
    derived::Derived,
    pages::Spread,
    picture::RegionSpectrum,
};

/// The chart of a chosen spectrum, as measured, in the image's unit.
pub fn region_chart(region: &RegionSpectrum, spread: Spread) -> Chart {
    let spectrum = &region.spectrum;
    let nm = || region.nm.iter().copied();
    let mean = curve(nm(), spectrum.samples.values().iter().copied());
    let is_region = region.rect.pixels() > 1;
    let mut series = Vec::new();
    if is_region {
        let (name, bounds) = bounds(region, spread);
        let upper = curve(nm(), bounds.iter().map(|b| b[1]));
        let lower = bounds.iter().map(|b| b[0]).collect();
        series.push(Series::area(name, Ink::Smooth, upper, lower));
    }
    let name = match is_region {
        true => said!("mean"),
        false => said!("pixel"),
    };
    series.push(Series::line(name, Ink::Measured, mean));
    if let Some(derived) = &region.derived {
        let line = Series::line(said!("model"), Ink::Spikes, model(derived, region));
        series.push(line.dashed(Dash::Dashed));
    }
    let mut notes = source_of(spectrum);
    notes.extend(spectrum.notes.last().cloned());
    notes.push(by_program(said!("As measured.")));
    Chart {
        title: spectrum.name.clone(),
        y_label: kind_label(spectrum.kind, &spectrum.unit),
        series,
        notes,
        ..Chart::over_nm([spectrum.samples.first_nm(), spectrum.samples.last_nm()])
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
            (said!("± 1 standard deviation"), bounds)
        }
        Spread::Extremes => (said!("smallest to largest"), region.extremes.clone()),
    }
}
