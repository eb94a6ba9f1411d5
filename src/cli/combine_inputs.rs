//! The measurements that the inputs of `combine` mean.

use std::{ffi::OsStr, path::Path};

use super::{
    arguments::Combine,
    inputs::{Inputs, named_spectrum},
    refusal::Refusal,
};
use crate::{
    app::{
        measured::{is_sigma, measurement, own_measurement},
        open::{Loaded, Wanted},
    },
    io::{Choices, shown, stream::is_stream},
    measurements::{Measurement, Quantity, noise_of},
    spectrum::{Band, NamedSpectrum, Outside, SpikeSettings, detect},
};

/// What the options state of each input.
pub(super) fn stated(mut part: Measurement, options: &Combine) -> Measurement {
    part.level = options.level.unwrap_or(part.level);
    part.axis_nm = options.axis.unwrap_or(part.axis_nm);
    part
}

/// The measurements that a word means: one, or for scans all of a file.
pub(super) fn read(
    word: &OsStr,
    all: bool,
    inputs: &mut Inputs,
) -> Result<Vec<Measurement>, Refusal> {
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
        return Ok(vec![own]);
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
            .map(|s| measurement(s, sigma_of(s)).map_err(|why| named(&why)))
            .collect();
    }
    let one = match &beside[..] {
        // Its sigma stands beside the only one.
        [one, sigma] if pick.is_none() && is_sigma(&sigma.name) => one.clone(),
        _ => {
            let wanted = Wanted {
                choices: Choices {
                    keep_photons: true,
                    ..Choices::default()
                },
                ..Wanted::default()
            };
            inputs.find(word, &wanted).map_err(refused)?.entry.spectrum
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
    Ok(vec![measurement(&one, sigma).map_err(|why| named(&why))?])
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
