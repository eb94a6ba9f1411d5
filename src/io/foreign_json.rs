//! JSON of other programs: colorimetry-io 1.0, rawtoaces, tobes-ui, and plain lists of numbers
//! ([`plain_json`](super::plain_json)).
//!
//! ```text
//! colorimetry-io  {"spectrum": S} or {"spectra": [S, ...]} or S itself, with S =
//!                 {"metadata": {"title", "measurement_type"},
//!                  "wavelength_axis": {"values_nm": [..]} or {"range_nm": {start, end, interval}},
//!                  "spectral_data": {"values": [..], "scale"}}
//! rawtoaces       {"header": {"description"}, "spectral_data": {"units", "index": {"main": [names]},
//!                  "data": {"main": {"380": [v, ...], ...}}}}
//! tobes-ui        {"name", "spd": {"340": 0.0, ...}}
//! ```

use serde_json::Value;

use crate::spectrum::{Kind, NamedSpectrum};

use super::colorimetry_json;
use super::curve;
use super::error::{kept, quoted};
use super::keyed_json;
use super::meaning;
use super::plain_json;
use super::reading::provenance as provenance_line;
use super::spectrum_json::any_json;
use super::{Confidence, Format, Guess, Guessed, Input, ReadError, Reading};

/// JSON of other programs.
pub const FORMAT: Format = Format {
    name: "JSON of another program",
    extensions: &["json"],
    sniff,
    read,
};

/// What a refusal asks for.
const KNOWN: &str = "a spectrum or composite of this program, one of colorimetry-io, rawtoaces or tobes-ui, or \
     lists of numbers beside one of wavelengths";

fn sniff(input: &Input) -> Confidence {
    let head = input.head();
    if head.starts_with('{') || head.starts_with('[') && input.has_extension("json") {
        Confidence::Likely
    } else {
        Confidence::No
    }
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let value = any_json(input, text)?;
    let mut reading = Reading::default();
    let Some(root) = value.as_object() else {
        plain_json::read(input, &value, &mut reading)?;
        if reading.spectra.is_empty() {
            return Err(input.error("a JSON list with no wavelengths in it", KNOWN));
        }
        return Ok(reading);
    };
    if let Some(main) = value
        .pointer("/spectral_data/data/main")
        .and_then(Value::as_object)
    {
        keyed_json::read_rawtoaces(input, &value, main, &mut reading)?;
    } else if let Some(spd) = root.get("spd").and_then(Value::as_object) {
        keyed_json::read_tobes(input, root, spd, &mut reading)?;
    } else if let Some(spectra) = root.get("spectra").and_then(Value::as_array) {
        for spectrum in spectra {
            colorimetry_json::read_colorimetry(input, spectrum, &mut reading)?;
        }
    } else if let Some(spectrum) = root
        .get("spectrum")
        .filter(|s| s.get("spectral_data").is_some())
    {
        colorimetry_json::read_colorimetry(input, spectrum, &mut reading)?;
    } else if root.contains_key("wavelength_axis") && root.contains_key("spectral_data") {
        colorimetry_json::read_colorimetry(input, &value, &mut reading)?;
    } else {
        plain_json::read(input, &value, &mut reading)?;
        if reading.spectra.is_empty() {
            let keys: Vec<&str> = root.keys().take(3).map(String::as_str).collect();
            return Err(input.error(
                format!("JSON with the keys {}", quoted(&keys.join(", "))),
                KNOWN,
            ));
        }
        return Ok(reading);
    }
    if reading.spectra.is_empty() {
        return Err(input.error("JSON with no spectrum in it", KNOWN));
    }
    reading.notes.insert(0, reading.spectra[0].notes[0].clone());
    Ok(reading)
}

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

#[cfg(test)]
mod tests {
    use crate::io::read_bytes;

    #[test]
    fn other_json_is_refused_with_its_keys() {
        for (text, words) in [
            (
                r#"{"metadata":1,"x":2}"#,
                "found JSON with the keys \"metadata, x\"",
            ),
            ("[1,2]", "a JSON list with no wavelengths in it"),
            (
                "{\"spd\":{\"abc\":1}}",
                "found \"abc\", expected a wavelength in nm as key",
            ),
            ("{", "line 1: found JSON with EOF"),
            (
                r#"{"wavelength_axis":{"range_nm":{"start":1,"end":9,"interval":0}},"spectral_data":{"values":[1]}}"#,
                "steps of 0",
            ),
        ] {
            let refusal = read_bytes("a.json", text.as_bytes())
                .unwrap_err()
                .to_string();
            assert!(refusal.contains(words), "{refusal}");
        }
    }
}
