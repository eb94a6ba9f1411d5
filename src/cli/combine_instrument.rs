//! An instrument's response: learnt from a known light, and taken off a reading.

use std::{
    ffi::{OsStr, OsString},
    path::Path,
};

use super::{
    arguments::{Combine, Stated},
    combine_inputs::{doubt_from, read as read_light, with_noise},
    combine_result::Found,
    inputs::Inputs,
    refusal::Refusal,
};
use crate::{
    app::{instruments, today},
    io::shown,
    measurements::{
        Formula, Instrument, Kernel, Known, Measurement, Options, Quantity, axis_of, combine,
        learn, slit_of,
    },
};

/// Coldest and hottest known light, K.
const KELVIN: std::ops::RangeInclusive<f64> = 1000.0..=25_000.0;

/// The instrument in a file.
///
/// # Errors
/// [`Refusal`] for a file that is none.
pub(super) fn read(word: &OsString, inputs: &mut Inputs) -> Result<Instrument, Refusal> {
    let path = Path::new(word);
    let refused = |why: String| Refusal::File(format!("INSTRUMENT: {why}"));
    let text = inputs.text(path).map_err(refused)?;
    let named = |why: String| refused(format!("{}: {why}", shown(path)));
    instruments::read(&text).map_err(named)
}

/// A reading without its dark, where one was taken.
fn without_dark(parts: &[Measurement]) -> Result<Measurement, Refusal> {
    match parts {
        [reading] => Ok(reading.clone()),
        parts => {
            let formula = Formula::parse("A - B").map_err(Refusal::file)?;
            let parts = with_noise(parts.to_vec());
            let made = combine(&formula, &parts, Options::default()).map_err(Refusal::file)?;
            Ok(Measurement {
                name: parts[0].name.clone(),
                ..made.result
            })
        }
    }
}

/// The light that words mean: a black body, daylight, or a table.
fn known(words: &OsStr, stated: Stated, inputs: &mut Inputs) -> Result<Known, Refusal> {
    let text = words.to_string_lossy().to_lowercase();
    let of = |name: &str| {
        let rest = text.replace("black body", "blackbody");
        let kelvin = rest.strip_prefix(name)?.trim().trim_end_matches('k').trim();
        let kelvin = kelvin.parse::<f64>().ok()?;
        Some(kelvin).filter(|kelvin| KELVIN.contains(kelvin))
    };
    if let Some(kelvin) = of("blackbody") {
        return Ok(Known::BlackBody { kelvin });
    }
    if let Some(kelvin) = of("daylight").filter(|kelvin| *kelvin >= 4000.0) {
        return Ok(Known::Daylight { kelvin });
    }
    let mut found = read_light(words, false, stated, inputs)?;
    let light = found.remove(0).of;
    match light.quantity {
        Quantity::Light => Ok(Known::Table(Box::new(light))),
        quantity => Err(Refusal::File(format!(
            "--known: found {quantity}, expected a light, \"black body 2856 K\" or \"daylight 6500 K\""
        ))),
    }
}

/// Learns an instrument from a reading of a known light.
///
/// # Errors
/// [`Refusal`] where the reading is too dark or the light is not known.
pub(super) fn learnt(
    parts: &[Measurement],
    options: &Combine,
    inputs: &mut Inputs,
) -> Result<Found, Refusal> {
    let words = options.known.clone().unwrap_or_default();
    let known = known(&words, Stated::default(), inputs)?;
    let reading = without_dark(parts)?;
    let axis = axis_of(&reading);
    let doubt = options.known_doubt.unwrap_or(0.0);
    let mut instrument = learn(&reading, &known, doubt, axis).map_err(Refusal::file)?;
    instrument.name = match options.out.as_deref().and_then(Path::file_stem) {
        Some(stem) => stem.to_string_lossy().into_owned(),
        None => reading.name.clone(),
    };
    instrument.date = today();
    instrument.known = match doubt > 0.0 {
        true => format!("{} \u{b1} {doubt} K", words.to_string_lossy()),
        false => words.to_string_lossy().into_owned(),
    };
    instrument.slit = slit_of(&reading, Kernel::Gauss)
        .ok()
        .map(|found| found.slit);
    let made_by = format!("response by {}", instrument.known);
    let mut found = Found::of(instrument.factor.clone(), made_by, doubt_from(parts));
    found.notes.extend(stretches(&instrument.factor));
    if let Some(axis) = &instrument.axis {
        found.notes.push(format!(
            "The axis is read {:+.2} nm from its place at 550 nm, by {} lines; it is put right.",
            axis.at_550_nm,
            axis.features.len()
        ));
    }
    if matches!(known, Known::Daylight { .. }) {
        let why = "A cloudy sky is daylight of one CCT to no better than some 14 %.";
        found.notes.push(why.to_owned());
    }
    found.instrument = Some(instrument);
    found.is_learnt = true;
    Ok(found)
}

/// A reading corrected by an instrument.
///
/// # Errors
/// [`Refusal`] where the response is not known in its range.
pub(super) fn used(
    instrument: Option<Instrument>,
    parts: &[Measurement],
) -> Result<Found, Refusal> {
    let Some(instrument) = instrument else {
        return Err(Refusal::Usage("INSTRUMENT: expected a file".to_owned()));
    };
    let from = doubt_from(parts);
    let reading = without_dark(parts)?;
    if !matches!(reading.quantity, Quantity::Counts | Quantity::Light) {
        return Err(Refusal::File(format!(
            "INPUT: found {}, expected a reading in counts",
            reading.quantity
        )));
    }
    let light = instrument.corrected(&reading).map_err(Refusal::file)?;
    let made_by = format!("{} by the instrument {}", reading.name, instrument.name);
    let mut found = Found::of(light, made_by, from);
    found.notes.extend(stretches(found.result()));
    found.first_nm = vec![found.result().samples.nm().to_vec()];
    found.instrument = Some(instrument);
    found.tell_lines();
    Ok(found)
}

/// What is masked, a sentence each.
fn stretches(of: &Measurement) -> Vec<String> {
    let all = of.masked().into_iter().take(6);
    all.map(|m| {
        format!(
            "{} from {:.0} to {:.0} nm: nothing is told there.",
            m.why, m.from_nm, m.to_nm
        )
    })
    .collect()
}
