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

mod plain;
mod programs;

use std::borrow::Cow;

use super::{Confidence, Format};
use crate::io::decode::json::any_json;
use crate::io::decode::json_tree::{self, Tree};
use crate::io::error::quoted;
use crate::io::{Input, ReadError, Reading};
use serde::Deserialize;
use serde::de::IgnoredAny;

/// JSON of other programs.
pub(crate) const FORMAT: Format = Format {
    name: later!("JSON of another program"),
    extensions: &["json", "jsonl"],
    sniff,
    read,
};

/// The input expected, as given in a refusal.
const KNOWN: &str = later!(
    "a spectrum or composite of this program, one of colorimetry-io, rawtoaces or tobes-ui, or \
     lists of numbers beside one of wavelengths"
);

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
        has_known_keys(text) && programs::read(input, &any_json(input, text)?, &mut reading)?;
    let found = if is_known {
        said!("JSON with no spectrum in it").to_owned()
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

/// A description of JSON of no known program.
fn in_words(tree: &Tree) -> String {
    let Some(root) = tree.object() else {
        return said!("a JSON list with no wavelengths in it").to_owned();
    };
    let keys: Vec<&str> = root.iter().take(3).map(|(key, _)| key.as_str()).collect();
    tr!("JSON with the keys {keys}", keys = quoted(&keys.join(", ")))
}

/// The text with `null` for the numbers that JSON cannot write and many programs do: `NaN`,
/// `Infinity` and `-Infinity`, outside of words.
fn without_nan(text: &str) -> Cow<'_, str> {
    if !text.contains("NaN") && !text.contains("Infinity") {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len());
    // Quotes alternate between words and the rest; an escaped quote belongs to the word.
    let mut is_word = false;
    for piece in text.split_inclusive('"') {
        if is_word {
            out.push_str(piece);
            let word = piece.trim_end_matches('"');
            let strokes = word.len() - word.trim_end_matches('\\').len();
            is_word = strokes % 2 == 1;
        } else {
            let mut rest = piece;
            while let Some(at) = rest.find(['N', 'I', '-']) {
                let (before, from) = rest.split_at(at);
                out.push_str(before);
                let words = ["NaN", "-Infinity", "Infinity"];
                let word = words.into_iter().find(|word| from.starts_with(word));
                out.push_str(if word.is_some() { "null" } else { &from[..1] });
                rest = &from[word.map_or(1, str::len)..];
            }
            out.push_str(rest);
            is_word = true;
        }
    }
    Cow::Owned(out)
}

/// The keys by which known programs are recognised.
#[derive(Deserialize)]
struct Keys {
    spectral_data: Option<IgnoredAny>,
    spd: Option<IgnoredAny>,
    spectra: Option<IgnoredAny>,
    spectrum: Option<IgnoredAny>,
}

/// True if a text is one object with a key of a known program, checked without keeping any of it.
fn has_known_keys(text: &str) -> bool {
    serde_json::from_str::<Keys>(text).is_ok_and(|keys| {
        let known = [keys.spectral_data, keys.spd, keys.spectra, keys.spectrum];
        known.iter().any(Option::is_some)
    })
}
