//! An instrument's response: learnt from a known light, and taken off a reading.

use serde::{Deserialize, Serialize};

use super::{
    parts::{doubt_from, with_noise},
    result::Found,
    said,
};
use crate::{
    app::{instruments, today},
    languages::{fixed, signed},
    measurements::{
        Formula, Instrument, Kernel, Known, Measurement, Options, Quantity, axis_of, combine,
        learn, slit_of,
    },
};

/// An instrument that was learnt.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct KeptInstrument {
    pub name: String,
    /// The known light, the day, what its axis is off by, its slit.
    pub about: String,
    /// The text of its file.
    pub text: String,
}

impl KeptInstrument {
    pub fn of(instrument: &Instrument) -> Self {
        let axis = instrument.axis.as_ref();
        let axis = axis.map(|axis| {
            tr!(
                "axis {shift} nm at 550 nm",
                shift = signed(axis.at_550_nm, 1)
            )
        });
        let slit = instrument
            .slit
            .map(|slit| tr!("slit {width} nm", width = fixed(slit.fwhm_nm, 1)));
        let known = tr!("by {known}", known = instrument.known);
        let about = [Some(known), Some(instrument.date.clone()), axis, slit];
        let about: Vec<String> = about.into_iter().flatten().collect();
        Self {
            name: instrument.name.clone(),
            about: about.join(", "),
            text: instruments::text(instrument),
        }
    }
}

/// Coldest and hottest known light, K.
const KELVIN: std::ops::RangeInclusive<f64> = 1000.0..=25_000.0;

/// The known light that words are: `black body 2856 K`, `daylight 6500 K`; `None` for others.
pub fn known_of_words(words: &str) -> Option<Known> {
    let text = words.to_lowercase().replace("black body", "blackbody");
    let of = |name: &str| {
        let kelvin = text.strip_prefix(name)?.trim().trim_end_matches('k').trim();
        let kelvin = kelvin.parse::<f64>().ok()?;
        Some(kelvin).filter(|kelvin| KELVIN.contains(kelvin))
    };
    let black = of("blackbody").map(|kelvin| Known::BlackBody { kelvin });
    let daylight = of("daylight").filter(|kelvin| *kelvin >= 4000.0);
    black.or(daylight.map(|kelvin| Known::Daylight { kelvin }))
}

/// A reading without its dark, where one was taken.
fn without_dark(parts: &[Measurement]) -> Result<Measurement, String> {
    match parts {
        [reading] => Ok(reading.clone()),
        parts => {
            let formula = Formula::parse("A - B").map_err(said)?;
            let parts = with_noise(parts.to_vec());
            let made = combine(&formula, &parts, Options::default()).map_err(said)?;
            Ok(Measurement {
                name: parts[0].name.clone(),
                ..made.result
            })
        }
    }
}

/// Learns an instrument from a reading of a known light, which `words` call; `doubt` is the standard
/// uncertainty of its temperature, K.
///
/// # Errors
/// A sentence where the reading is too dark.
pub fn learnt(
    parts: &[Measurement],
    known: &Known,
    words: &str,
    doubt: f64,
    name: Option<String>,
) -> Result<Found, String> {
    let reading = without_dark(parts)?;
    let axis = axis_of(&reading);
    let mut instrument = learn(&reading, known, doubt, axis).map_err(said)?;
    instrument.name = name.unwrap_or_else(|| reading.name.clone());
    instrument.date = today();
    instrument.known = match doubt > 0.0 {
        true => format!("{words} \u{b1} {} K", doubt),
        false => words.to_owned(),
    };
    instrument.slit = slit_of(&reading, Kernel::Gauss)
        .ok()
        .map(|found| found.slit);
    let made_by = format!("response by {}", instrument.known);
    let mut found = Found::of(instrument.factor.clone(), made_by, doubt_from(parts));
    found.notes.extend(stretches(&instrument.factor));
    if let Some(axis) = &instrument.axis {
        found.notes.push(tr!(
            "The axis is read {shift} nm from its place at 550 nm, by {lines} lines; it is put \
             right.",
            shift = signed(axis.at_550_nm, 2),
            lines = axis.features.len()
        ));
    }
    if matches!(known, Known::Daylight { .. }) {
        let why = said!("A cloudy sky is daylight of one CCT to no better than some 14 %.");
        found.notes.push(why.to_owned());
    }
    found.instrument = Some(instrument);
    found.is_learnt = true;
    Ok(found)
}

/// A reading corrected by an instrument.
///
/// # Errors
/// A sentence where the response is not known in its range.
pub(super) fn used(instrument: Instrument, parts: &[Measurement]) -> Result<Found, String> {
    let from = doubt_from(parts);
    let reading = without_dark(parts)?;
    if !matches!(reading.quantity, Quantity::Counts | Quantity::Light) {
        return Err(tr!(
            "INPUT: found {quantity}, expected a reading in counts",
            quantity = reading.quantity
        ));
    }
    let light = instrument.corrected(&reading).map_err(said)?;
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
        tr!(
            "{why} from {from} to {to} nm: nothing is told there.",
            why = m.why,
            from = fixed(m.from_nm, 0),
            to = fixed(m.to_nm, 0)
        )
    })
    .collect()
}
