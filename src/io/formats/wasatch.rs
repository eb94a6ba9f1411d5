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

use crate::spectrum::Kind;

use super::foreign_json::spectrum::{numbers, word};
use super::{Confidence, Format};
use crate::io::decode::json::any_json;
use crate::io::interpret::factor_scale::KnownScale;
use crate::io::interpret::interpret;
use crate::io::interpret::raw::RawSpectrum;
use crate::io::reading::decision::Decision;
use crate::io::{Input, ReadError, Reading};

/// Wasatch ENLIGHTEN JSON.
pub(crate) const FORMAT: Format = Format {
    name: "Wasatch ENLIGHTEN JSON",
    extensions: &["json"],
    sniff,
    read,
};

fn sniff(input: &Input) -> Confidence {
    let head = input.head();
    let marks = [
        "\"ENLIGHTEN Version\"",
        "\"spectrometerSettings\"",
        "\"Measurement ID\"",
    ];
    if head.starts_with('{') && marks.iter().any(|mark| head.contains(mark)) {
        Confidence::Certain
    } else {
        Confidence::No
    }
}

/// Wavelengths of pixels by the spectrometer's polynomial.
fn by_polynomial(value: &Value, pixels: usize) -> Option<Vec<f64>> {
    let list = value.pointer("/spectrometerSettings/eeprom/wavelength_coeffs")?;
    let coefficients: Vec<f64> = list.as_array()?.iter().filter_map(Value::as_f64).collect();
    (coefficients.len() >= 2 && coefficients.len() <= 8).then(|| {
        (0..pixels)
            .map(|pixel| {
                coefficients
                    .iter()
                    .rev()
                    .fold(0.0, |sum, c| sum * pixel as f64 + c)
            })
            .collect()
    })
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
    let (nm, note) = match value.pointer("/spectrometerSettings/wavelengths") {
        Some(list) if list.is_array() => (numbers(input, list, "wavelengths")?, None),
        _ => match by_polynomial(&value, values.len()) {
            Some(nm) => (
                nm,
                Some("wavelengths computed from the spectrometer's coefficients"),
            ),
            None => {
                return Err(input.error(
                    "ENLIGHTEN JSON without wavelengths",
                    "\"spectrometerSettings\": {\"wavelengths\": [...]}",
                ));
            }
        },
    };
    // A region of interest may shorten the values.
    let start = value
        .pointer("/metadata/ROI Pixel Start")
        .and_then(Value::as_u64)
        .and_then(|start| usize::try_from(start).ok())
        .filter(|start| nm.len() > values.len() && start + values.len() <= nm.len())
        .unwrap_or(0);
    let nm = &nm[start..];
    if nm.len() != values.len() {
        return Err(input.error(
            format!("{} wavelengths and {} values", nm.len(), values.len()),
            "as many of each",
        ));
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
    let mut spectrum = RawSpectrum::light(name, nm, values, unit);
    spectrum.known.kind = Some(Decision::of_format(kind));
    spectrum.known.scale = KnownScale::Stated(scale);
    spectrum.notes.extend(note.map(str::to_owned));
    if !technique.is_empty() {
        spectrum.notes.push(format!("technique: {technique}"));
    }
    if which.eq_ignore_ascii_case("processed") {
        spectrum
            .notes
            .push("raw and dark readings beside it were left out".to_owned());
    }
    let mut reading = Reading::default();
    interpret(spectrum, input, &mut reading)?;
    Ok(reading)
}

#[cfg(test)]
mod tests {
    use crate::io::read_bytes;
    use crate::spectrum::Kind;

    #[test]
    fn processed_values_over_the_spectrometers_wavelengths_are_read() {
        let text = r#"{"metadata":{"ENLIGHTEN Version":"2","Label":"lamp","Technique":"Scope"},
            "spectrometerSettings":{"wavelengths":[400.5,401.0,401.5]},
            "spectrum":{"Dark":[1,1,1],"Processed":[2.5,null,-1],"Raw":[9,9,9]}}"#;
        let reading = read_bytes("a.json", text.as_bytes()).unwrap();
        let spectrum = &reading.spectra[0];
        assert_eq!(
            (reading.format, spectrum.name.as_str()),
            ("Wasatch ENLIGHTEN JSON", "lamp")
        );
        assert_eq!(spectrum.samples.values(), [2.5, -1.0]);
        assert_eq!(
            (spectrum.kind, spectrum.unit.as_str()),
            (Kind::Light, "counts")
        );
        let text = text
            .replace("Scope", "Transmission")
            .replace("[400.5,401.0,401.5]", "null");
        let with = text.replace(
            "\"wavelengths\"",
            "\"eeprom\":{\"wavelength_coeffs\":[400,2,0.5]},\"wavelengths\"",
        );
        let reading = read_bytes("a.json", with.as_bytes()).unwrap();
        assert_eq!(reading.spectra[0].samples.nm(), [400.0, 406.0]);
        assert_eq!(
            (reading.spectra[0].kind, reading.spectra[0].scale),
            (Kind::Transmittance, 0.01)
        );
        let why = read_bytes("a.json", text.as_bytes())
            .unwrap_err()
            .to_string();
        assert!(
            why.contains("found ENLIGHTEN JSON without wavelengths"),
            "{why}"
        );
    }
}
