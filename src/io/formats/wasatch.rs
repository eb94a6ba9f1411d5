//! Wasatch ENLIGHTEN JSON: one measurement with its spectrometer's wavelengths.
//!
//! ```text
//! {"metadata": {"ENLIGHTEN Version", "Technique": "Scope", "Label", "Laser Wavelength", ...},
//!  "spectrometerSettings": {"wavelengths": [nm, ...], "eeprom": {"wavelength_coeffs": [..]}},
//!  "spectrum": {"Processed": [..], "Raw": [..], "Dark": [..], "Reference": [..]}}
//! ```
//!
//! The processed values are the spectrum; raw and dark readings are left out with a note. Their
//! unit is given by the technique: counts, or per cent in reflectance and transmission.

use serde_json::Value;

use super::{Confidence, Format};
use crate::io::decode::json::{any_json, numbers, word};
use crate::io::interpret::{KnownScale, RawSpectrum, alone};
use crate::io::{Decision, Input, ReadError, Reading};
use crate::spectrum::Kind;

pub(crate) const FORMAT: Format = Format::new("Wasatch ENLIGHTEN JSON", &["json"], sniff, read);

fn sniff(input: &Input) -> Confidence {
    let head = input.head();
    let mut keys = [
        "ENLIGHTEN Version",
        "spectrometerSettings",
        "Measurement ID",
    ]
    .iter();
    let mut is_marked = || keys.any(|key| head.contains(&format!("\"{key}\"")));
    Confidence::certain_if(head.starts_with('{') && is_marked())
}

/// Wavelengths of pixels by the spectrometer's polynomial.
fn by_polynomial(value: &Value, pixels: usize) -> Option<Vec<f64>> {
    let list = value.pointer("/spectrometerSettings/eeprom/wavelength_coeffs")?;
    let coefficients: Vec<f64> = list.as_array()?.iter().filter_map(Value::as_f64).collect();
    if !(2..=8).contains(&coefficients.len()) {
        return None;
    }
    let of = |x: f64| coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c);
    Some((0..pixels).map(|pixel| of(pixel as f64)).collect())
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let value = any_json(input, text)?;
    let list = |key: &'static str| {
        let list = value.get("spectrum")?.as_object()?.get(key)?;
        list.is_array().then_some((key, list))
    };
    let mut keys = ["Processed", "processed", "Raw", "raw"].into_iter();
    let (which, list) = keys.find_map(list).ok_or_else(|| {
        let expected = said!("\"spectrum\": {\"Processed\": [...]}");
        input.error(
            said!("ENLIGHTEN JSON without a processed spectrum"),
            expected,
        )
    })?;
    let values = numbers(input, list, which)?;
    let mut notes = Vec::new();
    let nm = match value.pointer("/spectrometerSettings/wavelengths") {
        Some(list) if list.is_array() => numbers(input, list, "wavelengths")?,
        _ => {
            let note = said!("wavelengths computed from the spectrometer's coefficients");
            notes.push(note.to_owned());
            by_polynomial(&value, values.len()).ok_or_else(|| {
                let expected = said!("\"spectrometerSettings\": {\"wavelengths\": [...]}");
                input.error(said!("ENLIGHTEN JSON without wavelengths"), expected)
            })?
        }
    };
    // A region of interest may shorten the values, regardless of the start given in the file.
    let start = value
        .pointer("/metadata/ROI Pixel Start")
        .and_then(Value::as_u64);
    let start = start.and_then(|start| usize::try_from(start).ok());
    let left = nm.len().saturating_sub(values.len());
    let start = start.filter(|start| *start <= left && left > 0);
    let nm = &nm[start.unwrap_or(0)..];
    if nm.len() != values.len() {
        let found = tr!(
            "{wavelengths} wavelengths and {values} values",
            wavelengths = nm.len(),
            values = values.len()
        );
        return Err(input.error(found, said!("as many of each")));
    }
    let technique = word(&value, "/metadata/Technique").unwrap_or("");
    let lower = technique.to_lowercase();
    let kinds = [
        ("reflect", Kind::Reflectance, 0.01, ""),
        ("transmi", Kind::Transmittance, 0.01, ""),
        ("absorb", Kind::Absorbance, 1.0, ""),
        ("", Kind::Light, 1.0, "counts"),
    ];
    let known = kinds.iter().find(|(word, ..)| lower.contains(word));
    let (_, kind, scale, unit) = *known.unwrap_or(&kinds[3]);
    let name = word(&value, "/metadata/Label").unwrap_or(input.stem());
    if !technique.is_empty() {
        notes.push(tr!("technique: {technique}", technique));
    }
    if which.eq_ignore_ascii_case("processed") {
        notes.push(said!("raw and dark readings beside it were left out").to_owned());
    }
    let mut spectrum = RawSpectrum::known(name, nm, values, Decision::of_format(kind), unit);
    spectrum.known.scale = KnownScale::Stated(scale);
    spectrum.notes = notes;
    alone(spectrum, input)
}
