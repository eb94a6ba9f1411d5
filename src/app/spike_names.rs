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
    measurements::{LineWithDoubt, lines_of},
    spectrum::Band,
};

/// The lines of a light with their names, whatever the settings are. A reflectance emits nothing,
/// and where dark lines are what stands up between them is none either.
pub(super) fn identified(entry: &Entry, lines: &[ElementLine]) -> Identified {
    if entry.kind().is_factor() {
        return Identified::default();
    }
    let samples = &entry.spectrum.samples;
    let first_nm = samples.first_nm().max(Band::VISIBLE.min_nm());
    let last_nm = samples.last_nm().min(Band::VISIBLE.max_nm());
    if let Ok(band) = Band::new(first_nm.ceil(), last_nm.floor()) {
        let values = entry.on_band(band);
        if has_dark_lines(Curve::of(entry, band, &values)) {
            return Identified::default();
        }
    }
    Identified::of(samples, entry.kind().outside(), lines)
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
