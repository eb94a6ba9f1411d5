//! JSON of other programs: colorimetry-io 1.0, rawtoaces, tobes-ui, and plain lists of numbers
//! ([`plain`]).
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

mod colorimetry;
mod keyed;
mod plain;
pub(super) mod spectrum;

use std::borrow::Cow;

use serde::Deserialize;
use serde::de::IgnoredAny;
use serde_json::{Map, Value};

use super::{Confidence, Format};
use crate::io::decode::json::any_json;
use crate::io::decode::json_tree::{self, Tree};
use crate::io::error::quoted;
use crate::io::{Input, ReadError, Reading};

/// JSON of other programs.
pub(crate) const FORMAT: Format = Format {
    name: "JSON of another program",
    extensions: &["json", "jsonl"],
    sniff,
    read,
};

/// What a refusal asks for.
const KNOWN: &str = "a spectrum or composite of this program, one of colorimetry-io, rawtoaces or tobes-ui, or \
     lists of numbers beside one of wavelengths";

fn sniff(input: &Input) -> Confidence {
    let head = input.head();
    let is_named = input.has_extension("json") || input.has_extension("jsonl");
    if head.starts_with('{') || head.starts_with('[') && is_named {
        Confidence::Likely
    } else {
        Confidence::No
    }
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*without_nan(&input.needs_long_text()?.text);
    let mut reading = Reading::default();
    let is_known =
        has_known_keys(text) && read_known(input, &any_json(input, text)?, &mut reading)?;
    let found = if is_known {
        "JSON with no spectrum in it".to_owned()
    } else {
        let tree = json_tree::of(input, text)?;
        plain::read(input, &tree, &mut reading)?;
        in_words(&tree)
    };
    match reading.spectra.is_empty() {
        true => Err(input.error(found, KNOWN)),
        false => Ok(reading),
    }
}

/// What JSON of no program in particular is.
fn in_words(tree: &Tree) -> String {
    let Some(root) = tree.object() else {
        return "a JSON list with no wavelengths in it".to_owned();
    };
    let keys: Vec<&str> = root.iter().take(3).map(|(key, _)| key.as_str()).collect();
    format!("JSON with the keys {}", quoted(&keys.join(", ")))
}

/// The text with `null` for the numbers that JSON cannot write and many programs do: `NaN`,
/// `Infinity` and `-Infinity`, outside of words.
fn without_nan(text: &str) -> Cow<'_, str> {
    if !text.contains("NaN") && !text.contains("Infinity") {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len());
    // Where quotes stand words and the rest take turns; a quote behind a stroke is a letter.
    let mut is_word = false;
    let mut kept = 0;
    let bytes = text.as_bytes();
    let mut at = 0;
    while at < bytes.len() {
        let number = ["NaN", "-Infinity", "Infinity"]
            .into_iter()
            .find(|number| !is_word && bytes[at..].starts_with(number.as_bytes()));
        match (bytes[at], number) {
            (_, Some(number)) => {
                out.push_str(&text[kept..at]);
                out.push_str("null");
                at += number.len();
                kept = at;
                continue;
            }
            (b'\\', None) if is_word => at += 1,
            (b'"', None) => is_word = !is_word,
            _ => {}
        }
        at += 1;
    }
    out.push_str(&text[kept..]);
    Cow::Owned(out)
}

/// The keys by which known programs are told.
#[derive(Deserialize)]
struct Keys {
    spectral_data: Option<IgnoredAny>,
    spd: Option<IgnoredAny>,
    spectra: Option<IgnoredAny>,
    spectrum: Option<IgnoredAny>,
}

/// Whether a text is one object with a key of a known program, told without keeping any of it.
fn has_known_keys(text: &str) -> bool {
    serde_json::from_str::<Keys>(text).is_ok_and(|keys| {
        let known = [keys.spectral_data, keys.spd, keys.spectra, keys.spectrum];
        known.iter().any(Option::is_some)
    })
}

/// Reads JSON of a program that is known; `false` where it is of none.
fn read_known(input: &Input, value: &Value, reading: &mut Reading) -> Result<bool, ReadError> {
    let is_colorimetry = |value: &Value| {
        value.get("wavelength_axis").is_some() || value.get("spectral_data").is_some()
    };
    let main = value.pointer("/spectral_data/data/main");
    let spd = value.get("spd").and_then(Value::as_object);
    let spectra = value.get("spectra").and_then(Value::as_array);
    let spectrum = value
        .get("spectrum")
        .filter(|s| s.get("spectral_data").is_some());
    let has = |key: &str| value.get(key).is_some();
    let itself = (has("wavelength_axis") && has("spectral_data")).then_some(value);
    if let Some(main) = main.and_then(Value::as_object) {
        keyed::read_rawtoaces(input, value, main, reading)?;
    } else if let (Some(spd), Some(root)) = (spd.filter(|spd| is_keyed(spd)), value.as_object()) {
        keyed::read_tobes(input, root, spd, reading)?;
    } else if let Some(spectra) = spectra.filter(|list| list.iter().any(is_colorimetry)) {
        for spectrum in spectra {
            colorimetry::read_colorimetry(input, spectrum, reading)?;
        }
    } else if let Some(spectrum) = spectrum.or(itself) {
        colorimetry::read_colorimetry(input, spectrum, reading)?;
    } else {
        return Ok(false);
    }
    Ok(true)
}

/// Whether an object has no lists or objects in it: tobes-ui's has numbers only.
fn is_keyed(object: &Map<String, Value>) -> bool {
    !object
        .values()
        .any(|value| value.is_array() || value.is_object())
}
