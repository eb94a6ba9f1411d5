//! Spectra of colorimetry-io 1.0 files.

use serde_json::Value;

use crate::spectrum::Kind;

use super::spectrum::{JsonSpectrum, add, numbers, word};
use crate::io::interpret::curve::MOST_SAMPLES;
use crate::io::interpret::kinds;
use crate::io::provenance::shortest;
use crate::io::{Input, ReadError, Reading};

/// Adds one spectrum object to a reading.
///
/// # Errors
/// [`ReadError`] when axis or values are missing or do not fit each other.
pub(super) fn read_colorimetry(
    input: &Input,
    value: &Value,
    reading: &mut Reading,
) -> Result<(), ReadError> {
    let expected = "one with \"values_nm\" or \"range_nm\"";
    let axis = value
        .get("wavelength_axis")
        .ok_or_else(|| input.error("no \"wavelength_axis\"", expected))?;
    let values = value
        .pointer("/spectral_data/values")
        .ok_or_else(|| input.error("no \"spectral_data\"", "one with \"values\""))?;
    let values = numbers(input, values, "\"values\"")?;
    let nm = if let Some(list) = axis.get("values_nm").filter(|l| !l.is_null()) {
        numbers(input, list, "\"values_nm\"")?
    } else {
        range(input, axis, values.len())?
    };
    check_counts(input, nm.len(), values.len())?;
    let stated = word(value, "/metadata/measurement_type").unwrap_or("");
    let kind = match stated.to_lowercase().as_str() {
        "sensitivity" => Some(Kind::Weighting),
        "emission" => Some(Kind::Light),
        other => kinds::kind_of_words(other),
    };
    let percent =
        word(value, "/spectral_data/scale").map(|s| s.to_lowercase().starts_with("percent"));
    let name = word(value, "/metadata/title")
        .or_else(|| word(value, "/id"))
        .unwrap_or(input.stem());
    let found = JsonSpectrum {
        name: name.to_owned(),
        kind,
        unit: word(value, "/spectral_data/unit").unwrap_or(""),
        percent,
        source: word(value, "/metadata/description").unwrap_or(&input.name),
    };
    add(input, found, &nm, values, reading)
}

fn check_counts(input: &Input, wavelengths: usize, values: usize) -> Result<(), ReadError> {
    if wavelengths == values {
        return Ok(());
    }
    let found = format!("{wavelengths} wavelengths and {values} values");
    Err(input.error(found, "one value for each wavelength"))
}

/// The wavelengths of a range for some values: no more are made than there are values.
fn range(input: &Input, axis: &Value, values: usize) -> Result<Vec<f64>, ReadError> {
    let expected = "\"range_nm\" with numbers \"start\", \"end\" and \"interval\"";
    let number = |key: &str| {
        axis.pointer(&format!("/range_nm/{key}"))
            .and_then(Value::as_f64)
            .ok_or_else(|| input.error(format!("no \"{key}\" in \"range_nm\""), expected))
    };
    let (start, end, interval) = (number("start")?, number("end")?, number("interval")?);
    let steps = ((end - start) / interval).round();
    // The negated test also refuses a step of zero, which makes the count infinite or no number.
    if !(1.0..MOST_SAMPLES as f64).contains(&steps) {
        let [start, end, interval] = [start, end, interval].map(shortest);
        let found = format!("a range of {start} to {end} nm in steps of {interval}");
        return Err(input.error(found, "at least one step and at most 10,000,000"));
    }
    check_counts(input, steps as usize + 1, values)?;
    let at = |i: usize| start + i as f64 * interval;
    Ok((0..=steps as usize).map(at).collect())
}
