//! Wasatch ENLIGHTEN JSON: one measurement with its spectrometer's wavelengths.
//!
//! ```text
//! {"metadata": {"ENLIGHTEN Version", "Technique": "Scope", "Label", "Laser Wavelength", ...},
//!  "spectrometerSettings": {"wavelengths": [nm, ...], "eeprom": {"wavelength_coeffs": [..]}},
//!  "spectrum": {"Processed": [..], "Raw": [..], "Dark": [..], "Reference": [..]}}
//! ```
//!
//! The processed values are the spectrum; raw and dark readings are left out and it is said. What
//! they count is told by the technique: counts, or per cent in reflectance and transmission.

use serde_json::Value;

use super::foreign_json::spectrum::{numbers, word};
use super::{Confidence, Format};
use crate::io::decode::json::any_json;
use crate::io::interpret::{KnownScale, RawSpectrum, alone};
use crate::io::{Decision, Input, ReadError, Reading};
use crate::spectrum::Kind;

pub(crate) const FORMAT: Format = Format::new("Wasatch ENLIGHTEN JSON", &["json"], sniff, read);

fn sniff(input: &Input) -> Confidence {
    let head = input.head();
    let marks = [
        "\"ENLIGHTEN Version\"",
        "\"spectrometerSettings\"",
        "\"Measurement ID\"",
    ];
    let is_marked = || marks.iter().any(|mark| head.contains(mark));
    Confidence::certain_if(head.starts_with('{') && is_marked())
}

/// Wavelengths of pixels by the spectrometer's polynomial.
fn by_polynomial(value: &Value, pixels: usize) -> Option<Vec<f64>> {
    let list = value.pointer("/spectrometerSettings/eeprom/wavelength_coeffs")?;
    let coefficients: Vec<f64> = list.as_array()?.iter().filter_map(Value::as_f64).collect();
    let nm = |pixel: usize| {
        let highest_first = coefficients.iter().rev();
        highest_first.fold(0.0, |sum, c| sum * pixel as f64 + c)
    };
    (2..=8)
        .contains(&coefficients.len())
        .then(|| (0..pixels).map(nm).collect())
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let value = any_json(input, text)?;
    let series = value.get("spectrum").and_then(Value::as_object);
    let Some((which, list)) = series.and_then(|all| {
        ["Processed", "processed", "Raw", "raw"]
            .into_iter()
            .find_map(|name| Some((name, all.get(name)?)).filter(|(_, l)| l.is_array()))
    }) else {
        return Err(input.error(
            "ENLIGHTEN JSON without a processed spectrum",
            "\"spectrum\": {\"Processed\": [...]}",
        ));
    };
    let values = numbers(input, list, which)?;
    let mut notes = Vec::new();
    let nm = match value.pointer("/spectrometerSettings/wavelengths") {
        Some(list) if list.is_array() => numbers(input, list, "wavelengths")?,
        _ => {
            let note = "wavelengths computed from the spectrometer's coefficients";
            notes.push(note.to_owned());
            by_polynomial(&value, values.len()).ok_or_else(|| {
                let expected = "\"spectrometerSettings\": {\"wavelengths\": [...]}";
                input.error("ENLIGHTEN JSON without wavelengths", expected)
            })?
        }
    };
    // A region of interest may shorten the values, wherever a file says that it begins.
    let ends_within = |start: &usize| {
        let end = start.checked_add(values.len());
        nm.len() > values.len() && end.is_some_and(|end| end <= nm.len())
    };
    let start = value
        .pointer("/metadata/ROI Pixel Start")
        .and_then(Value::as_u64)
        .and_then(|start| usize::try_from(start).ok())
        .filter(ends_within)
        .unwrap_or(0);
    let nm = &nm[start..];
    if nm.len() != values.len() {
        let found = format!("{} wavelengths and {} values", nm.len(), values.len());
        return Err(input.error(found, "as many of each"));
    }
    let technique = word(&value, "/metadata/Technique").unwrap_or("");
    let lower = technique.to_lowercase();
    let (kind, scale, unit) = if lower.contains("reflect") {
        (Kind::Reflectance, 0.01, "")
    } else if lower.contains("transmi") {
        (Kind::Transmittance, 0.01, "")
    } else if lower.contains("absorb") {
        (Kind::Absorbance, 1.0, "")
    } else {
        (Kind::Light, 1.0, "counts")
    };
    let name = word(&value, "/metadata/Label").unwrap_or(input.stem());
    if !technique.is_empty() {
        notes.push(format!("technique: {technique}"));
    }
    if which.eq_ignore_ascii_case("processed") {
        notes.push("raw and dark readings beside it were left out".to_owned());
    }
    let mut spectrum = RawSpectrum::known(name, nm, values, Decision::of_format(kind), unit);
    spectrum.known.scale = KnownScale::Stated(scale);
    spectrum.notes = notes;
    alone(spectrum, input)
}
