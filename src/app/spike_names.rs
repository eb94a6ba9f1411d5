//! Names of the spikes of a spectrum: of what stands up after elements and phosphors, of what
//! hangs down after absorption lines.

use std::sync::Arc;

use super::{
    about::{About, family},
    absorption_names::{Curve, has_dark_lines, name_dips},
    derived::Derived,
    entry::Entry,
    families::Family,
    line_names::{ElementLine, Identified, LineName},
};
use crate::{
    app::measured::is_light,
    measurements::{LineWithDoubt, lines_of, lines_of_the_noise},
    spectrum::{Band, SpikeSettings},
};

/// Least share of a line that may be named where the noise is known.
const LEAST_SHARE: f64 = 1e-4;

/// The lines of a light with their names, whatever the settings are. A reflectance emits nothing,
/// where dark lines are what stands up between them is none either, and a line that its noise may
/// have made has no name.
pub(super) fn identified(entry: &Entry, lines: &[ElementLine]) -> Identified {
    if entry.kind().is_factor() {
        return Identified::default();
    }
    let samples = &entry.spectrum.samples;
    let mut of_noise = Vec::new();
    let first_nm = samples.first_nm().max(Band::VISIBLE.min_nm());
    let last_nm = samples.last_nm().min(Band::VISIBLE.max_nm());
    if let Ok(band) = Band::new(first_nm.ceil(), last_nm.floor()) {
        let values = entry.on_band(band);
        if has_dark_lines(Curve::of(entry, band, &values)) {
            return Identified::default();
        }
        if let Some(of) = entry.measured.as_deref() {
            let all = SpikeSettings {
                threshold: LEAST_SHARE,
                ..SpikeSettings::default()
            };
            let lines = lines_of_the_noise(of, band, all).into_iter();
            of_noise = lines.map(|(at_nm, _)| at_nm).collect();
        }
    }
    Identified::of(samples, entry.kind().outside(), lines).without(of_noise)
}

/// Names of a model's spikes, in their order.
pub(super) fn names_of(entry: &Entry, derived: &Derived, lines: &[ElementLine]) -> Vec<LineName> {
    names_in(&identified(entry, lines), entry, derived)
}

/// The same of a light whose lines are told already.
pub(super) fn names_in(light: &Identified, entry: &Entry, derived: &Derived) -> Vec<LineName> {
    let curve = Curve::of(entry, derived.band, &derived.measured);
    let spikes = derived.model.lines();
    let all: Vec<f64> = spikes.iter().map(|spike| spike.at_nm).collect();
    let mut names = light.names_at(&all);
    let dips = (0..spikes.len()).filter(|index| spikes[*index].weight < 0.0);
    let dips: Vec<usize> = dips.collect();
    let places: Vec<f64> = dips.iter().map(|index| spikes[*index].at_nm).collect();
    for (index, name) in dips.into_iter().zip(name_dips(&places, curve)) {
        names[index] = name;
    }
    names
}

/// What is told of a spectrum whatever its model is.
#[derive(Debug)]
pub struct Told {
    /// The spectrum.
    pub of: Arc<Entry>,
    /// Its lines with their names.
    pub light: Identified,
    /// Its title and a sentence.
    pub about: About,
    pub family: Option<&'static Family>,
    /// Its lines with their doubt, where its noise is known.
    pub doubted: Vec<LineWithDoubt>,
}

impl Told {
    /// Of a spectrum, beside all atomic lines.
    pub fn of(entry: &Arc<Entry>, lines: &[ElementLine]) -> Self {
        let light = identified(entry, lines);
        let measured = entry.measured.as_deref();
        let noisy = measured.filter(|of| is_light(of) && of.sigma.is_some());
        Self {
            doubted: noisy.map(lines_of).unwrap_or_default(),
            of: entry.clone(),
            about: About::of(entry),
            family: family(entry, &light),
            light,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        app::{library::Library, measured::spectrum},
        measurements::{Measurement, Quantity, Repeats, normal},
        preset,
        spectrum::{Outside, Sampled, detect},
    };

    /// Scans of FL2 whose noise is as wide as its lines.
    fn scans(seed: u64) -> Vec<Measurement> {
        let lamp = preset::table("cie_fluorescent_1nm", "FL2").expect("shipped");
        let white: Vec<f64> = normal(seed).take(5 * 405).collect();
        let scan = |noise: &[f64]| {
            let smoothed = noise.windows(5).map(|near| near.iter().sum::<f64>());
            let values = (380..=780).zip(smoothed);
            let values = values.map(|(nm, e)| lamp.at(f64::from(nm), Outside::Hold) + 2.0 * e);
            let samples = Sampled::even(380.0, 1.0, values.collect()).expect("finite");
            Measurement::new("scan", Quantity::Light, "", samples)
        };
        white.chunks(405).map(scan).collect()
    }

    #[test]
    fn a_line_that_the_noise_may_have_made_has_no_name() {
        const OWN_NM: [f64; 4] = [404.7, 435.8, 546.1, 578.0];
        let named = |of: &Measurement| {
            let entry = Entry {
                measured: Some(Arc::new(of.clone())),
                ..Entry::own(1, spectrum(of, ""))
            };
            let light = identified(&entry, Library::bundled().lines());
            let values = entry.on_band(Band::VISIBLE);
            let all = SpikeSettings {
                threshold: LEAST_SHARE,
                ..SpikeSettings::default()
            };
            let found = detect(Band::VISIBLE, &values, all).spikes;
            let places: Vec<f64> = found.iter().map(|line| line.spike.at_nm).collect();
            let names = light.names_at(&places).into_iter().zip(places);
            let named = names.filter(|(name, _)| name.label.is_some());
            named.map(|(_, at_nm)| at_nm).collect::<Vec<f64>>()
        };
        let is_own = |at: &f64| OWN_NM.iter().any(|own| (own - at).abs() <= 2.0);
        let (mut known, mut unknown) = ((0, 0), (0, 0));
        for seed in 0..16 {
            let mut mean = Repeats::of(&scans(seed)).expect("five").mean;
            for sum in [&mut known, &mut unknown] {
                let named = named(&mean);
                let own = named.iter().filter(|at| is_own(at)).count();
                *sum = (sum.0 + own, sum.1 + named.len() - own);
                mean.sigma = None;
            }
        }
        // Without sigma nobody can tell; with it a weak line of the lamp may lose its name, too.
        assert!(unknown.0 > 0 && unknown.1 > 0, "{unknown:?}");
        assert!(
            known.1 == 0 && 2 * known.0 > unknown.0,
            "{known:?} {unknown:?}"
        );
    }
}
