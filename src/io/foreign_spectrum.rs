//! One spectrum of another program's JSON, on its way to a reading.

use serde_json::Value;

use crate::spectrum::{Kind, NamedSpectrum};

use super::curve;
use super::error::{kept, quoted};
use super::meaning;
use super::reading::provenance as provenance_line;
use super::{Guess, Guessed, Input, ReadError, Reading};

/// What is known of a spectrum before its numbers are put in order.
pub struct Found {
    /// What to call it.
    pub name: String,
    /// What it is.
    pub kind: Kind,
    /// Whether the file says so.
    pub kind_stated: bool,
    /// Unit of its values.
    pub unit: String,
    /// Whether a factor is per cent, where the file says.
    pub percent: Option<bool>,
    /// Where it comes from.
    pub source: String,
}

/// Adds a spectrum to a reading.
///
/// # Errors
/// [`ReadError`] when the numbers are no spectrum.
pub fn add(
    input: &Input,
    found: Found,
    nm: &[f64],
    values: &[f64],
    reading: &mut Reading,
) -> Result<(), ReadError> {
    let cleaned = curve::clean(nm, values)
        .map_err(|trouble| input.error(trouble.to_string(), trouble.expected()))?;
    let (mut samples, mut notes) = (cleaned.samples, cleaned.notes);
    let index = reading.spectra.len();
    let mut guess = |what, chosen: &str, because: String, plain| {
        notes.push(format!("taken as {chosen}: {because}"));
        reading.guesses.push(Guess {
            spectrum: index,
            what,
            chosen: chosen.to_owned(),
            because,
            plain,
        });
    };
    if !found.kind_stated {
        guess(
            Guessed::Kind,
            found.kind.word(),
            "nothing states it".to_owned(),
            false,
        );
    }
    let mut scale = 1.0;
    if found.kind.is_factor() {
        let percent = found.percent.unwrap_or_else(|| {
            let guessed = meaning::percent("", &[], false, samples.values());
            let chosen = if guessed.percent {
                "percent"
            } else {
                "fraction"
            };
            guess(Guessed::Percent, chosen, guessed.because, guessed.plain);
            guessed.percent
        });
        if percent {
            scale = 0.01;
            samples = samples.scaled(scale);
        }
    }
    let mut spectrum = NamedSpectrum {
        name: found.name,
        kind: found.kind,
        unit: if found.kind.is_factor() {
            "fraction".to_owned()
        } else {
            found.unit
        },
        scale,
        samples,
        notes: Vec::new(),
        source: found.source,
    };
    spectrum.notes.push(provenance_line(&spectrum, &[]));
    spectrum.notes.extend(notes);
    reading.spectra.push(spectrum);
    Ok(())
}

/// A word at a place in the JSON, unless it is empty.
pub fn word<'a>(value: &'a Value, pointer: &str) -> Option<&'a str> {
    let text = value.pointer(pointer)?.as_str()?.trim();
    (!text.is_empty()).then(|| kept(text))
}

/// A list of numbers; `null` stands for a missing one.
///
/// # Errors
/// [`ReadError`] for anything else in the list.
pub fn numbers(input: &Input, list: &Value, what: &str) -> Result<Vec<f64>, ReadError> {
    let list = list
        .as_array()
        .ok_or_else(|| input.error(format!("{what} that is no list"), "a list of numbers"))?;
    list.iter()
        .map(|item| match item {
            Value::Null => Ok(f64::NAN),
            Value::Number(number) => Ok(number.as_f64().unwrap_or(f64::NAN)),
            other => Err(input.error(
                format!("{} in {what}", quoted(&other.to_string())),
                "a number",
            )),
        })
        .collect()
}
