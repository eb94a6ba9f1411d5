//! The measurements that the inputs of `combine` mean.

use std::{ffi::OsStr, path::Path, sync::Arc};

use super::{
    arguments::Stated,
    inputs::{Inputs, named_spectrum},
    refusal::Refusal,
};
use crate::{
    app::{
        measured::{is_sigma, own_measurement, spectrum},
        open::{Loaded, Wanted},
        readings::{Reading, measured},
    },
    io::{Choices, exposure_ms, shown, stream::is_stream},
    measurements::{Measurement, Quantity, noise_of},
    spectrum::{Band, Composite, NamedSpectrum, Outside, SpikeSettings, detect},
};

/// One input.
#[derive(Clone)]
pub(super) struct Part {
    pub of: Measurement,
    /// What it tells of itself: counts, a cut top.
    pub reading: Reading,
    /// The composite that it is by its own source.
    pub composite: Option<Arc<Composite>>,
}

impl Part {
    fn new(
        of: &NamedSpectrum,
        sigma: Option<&NamedSpectrum>,
        stated: Stated,
    ) -> Result<Self, String> {
        let found = measured(of, sigma, stated.as_light).map_err(|why| why.to_string())?;
        Ok(Self {
            of: stated.of(found.0),
            reading: found.1,
            composite: None,
        })
    }
}

/// The measurements that a word means: one, or for scans all of a file.
pub(super) fn read(
    word: &OsStr,
    all: bool,
    stated: Stated,
    inputs: &mut Inputs,
) -> Result<Vec<Part>, Refusal> {
    let path = Path::new(word);
    let refused = |why: String| Refusal::File(format!("INPUT: {why}"));
    let named = |why: &dyn std::fmt::Display| refused(format!("{}: {why}", shown(path)));
    let is_file = path.is_file() || is_stream(path);
    if is_file
        && let Some(own) = inputs
            .text(path)
            .ok()
            .and_then(|text| own_measurement(&text))
    {
        let mut of = own;
        let mut reading = Reading::of(&spectrum(&of, ""), stated.as_light);
        match (of.quantity, reading.has_no_figures()) {
            (Quantity::Light, true) => of.quantity = Quantity::Counts,
            (Quantity::Counts, false) if stated.as_light => of.quantity = Quantity::Light,
            _ => {}
        }
        if of.scans.is_some() {
            // A mean of scans is cut where they were; it has no scale of its own.
            reading.clipped.clear();
        }
        let of = stated.of(of);
        return Ok(vec![Part {
            of,
            reading,
            composite: None,
        }]);
    }
    let (file, pick) = named_spectrum(word);
    let beside = match is_file || Path::new(file).is_file() {
        true => spectra_of(Path::new(file), inputs)?,
        false => Vec::new(),
    };
    let is_value = |s: &&NamedSpectrum| !is_sigma(&s.name);
    let sigma_of = |spectrum: &NamedSpectrum| {
        let at = beside.iter().position(|s| s.name == spectrum.name)?;
        beside.get(at + 1).filter(|next| is_sigma(&next.name))
    };
    if all && pick.is_none() && beside.len() > 1 {
        let each = beside.iter().filter(is_value);
        return each
            .map(|s| Part::new(s, sigma_of(s), stated).map_err(|why| named(&why)))
            .collect();
    }
    let (one, composite) = match &beside[..] {
        // Its sigma stands beside the only one.
        [one, sigma] if pick.is_none() && is_sigma(&sigma.name) => (one.clone(), None),
        _ => {
            let wanted = Wanted {
                choices: Choices {
                    keep_photons: true,
                    ..Choices::default()
                },
                ..Wanted::default()
            };
            let entry = inputs.find(word, &wanted).map_err(refused)?.entry;
            (entry.spectrum, entry.composite)
        }
    };
    let sigma = sigma_of(&one);
    if let Some(sigma) = sigma {
        inputs.note(format!(
            "{}: {} is taken as the sigma of {}",
            shown(path),
            sigma.name,
            one.name
        ));
    }
    let mut part = Part::new(&one, sigma, stated).map_err(|why| named(&why))?;
    part.of.exposure_ms = exposure(Path::new(file), inputs);
    Ok(vec![Part { composite, ..part }])
}

/// The exposure that a file of text states.
fn exposure(path: &Path, inputs: &mut Inputs) -> Option<f64> {
    let is_file = path.is_file() || is_stream(path);
    exposure_ms(&is_file.then(|| inputs.text(path).ok()).flatten()?)
}

/// Every spectrum of a file.
fn spectra_of(path: &Path, inputs: &mut Inputs) -> Result<Vec<NamedSpectrum>, Refusal> {
    let choices = Choices {
        keep_photons: true,
        ..Choices::default()
    };
    match inputs.load(path, &choices) {
        Loaded::File(opened) => Ok(opened.into_spectra()),
        Loaded::Refused(why) => Err(Refusal::File(format!("INPUT: {why}"))),
        Loaded::Project { .. } => Ok(Vec::new()),
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
pub(super) fn measurements(parts: &[Part]) -> Vec<Measurement> {
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
