//! One spectrum of another program's JSON, on its way to a reading.

use serde_json::Value;

use crate::spectrum::Kind;

use crate::io::error::{kept, quoted};
use crate::io::interpret::factor_scale::KnownScale;
use crate::io::interpret::interpret;
use crate::io::interpret::raw::RawSpectrum;
use crate::io::reading::decision::Decision;
use crate::io::{Input, ReadError, Reading};

/// What is known of a spectrum before its numbers are put in order.
pub(super) struct JsonSpectrum<'a> {
    pub name: String,
    /// What it is, where the file says.
    pub kind: Option<Kind>,
    pub unit: &'a str,
    /// Whether a factor is per cent, where the file says.
    pub percent: Option<bool>,
    pub source: &'a str,
}

/// Adds a spectrum to a reading.
pub(super) fn add(
    input: &Input,
    found: JsonSpectrum,
    nm: &[f64],
    values: Vec<f64>,
    reading: &mut Reading,
) -> Result<(), ReadError> {
    let unstated = || Decision::guessed(Kind::Light, false, "nothing states it");
    let kind = found.kind.map_or_else(unstated, Decision::of_format);
    let is_factor = kind.value.is_factor();
    let mut raw = RawSpectrum::known(found.name, nm, values, kind, found.unit);
    raw.known.scale = match found.percent {
        // What is no share of a whole has no per cent.
        Some(true) if is_factor => KnownScale::Stated(0.01),
        Some(false) => KnownScale::Stated(1.0),
        Some(true) | None => KnownScale::Open,
    };
    raw.source = Some(found.source.to_owned());
    interpret(raw, input, reading)?;
    reading.keep_scale_to_notes();
    Ok(())
}

/// A word at a place in the JSON, unless it is empty.
pub(crate) fn word<'a>(value: &'a Value, pointer: &str) -> Option<&'a str> {
    let text = value.pointer(pointer)?.as_str()?.trim();
    (!text.is_empty()).then(|| kept(text))
}

/// A list of numbers; `null` stands for a missing one.
pub(crate) fn numbers(input: &Input, list: &Value, what: &str) -> Result<Vec<f64>, ReadError> {
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
