//! The inputs of a combination: measurements with what they tell of themselves.

use std::sync::Arc;

use super::said;
use crate::{
    app::{
        Entry,
        readings::{Reading, measured},
    },
    measurements::{Measurement, Quantity, noise_of},
    spectrum::{Band, Composite, Outside, SpikeSettings, detect},
};

/// One input.
#[derive(Clone)]
pub struct Part {
    pub of: Measurement,
    /// What it tells of itself: counts, a cut top.
    pub reading: Reading,
    /// The composite that it is by its own source.
    pub composite: Option<Arc<Composite>>,
}

impl Part {
    /// A spectrum of the library or of a file, with what is known of it.
    ///
    /// # Errors
    /// A sentence for what is no measurement.
    pub fn of_entry(entry: &Entry, as_light: bool) -> Result<Self, String> {
        let (plain, mut reading) = measured(&entry.spectrum, None, as_light).map_err(said)?;
        let of = match entry.measured.as_deref() {
            Some(known) => Measurement {
                name: plain.name,
                quantity: plain.quantity,
                unit: plain.unit,
                ..known.clone()
            },
            None => plain,
        };
        if of.scans.is_some() {
            // A mean of scans is cut where they were; it has no scale of its own.
            reading.clipped.clear();
        }
        Ok(Self {
            of,
            reading,
            composite: entry.composite.clone(),
        })
    }
}

/// Where the doubt of a result is from.
pub(super) fn doubt_from(parts: &[Measurement]) -> &'static str {
    match parts.iter().all(|part| part.sigma.is_some()) {
        true if parts.iter().all(|part| part.scans.is_some()) => "repeats",
        true => "stated",
        false => "residuals",
    }
}

/// The measurements of some inputs.
pub fn measurements(parts: &[Part]) -> Vec<Measurement> {
    parts.iter().map(|part| part.of.clone()).collect()
}

/// Inputs with the noise that their own second differences tell, where none is stated.
pub(super) fn with_noise(mut parts: Vec<Measurement>) -> Vec<Measurement> {
    for part in &mut parts {
        part.sigma = part.sigma.take().or_else(|| noise_of(&part.samples));
    }
    parts
}

/// Whether the detector finds lines in a light.
pub(super) fn has_lines(part: &Measurement) -> bool {
    let samples = &part.samples;
    let is_light = matches!(part.quantity, Quantity::Light | Quantity::Counts);
    let band = Band::new(samples.first_nm().ceil(), samples.last_nm().floor());
    band.is_ok_and(|band| {
        let values = samples.on_band(band, Outside::Zero);
        is_light
            && !detect(band, &values, SpikeSettings::default())
                .spikes
                .is_empty()
    })
}
