//! Spectra that use wavelengths as keys: rawtoaces and tobes-ui.

use serde_json::{Map, Value};

use crate::spectrum::Kind;

use super::spectrum::{JsonSpectrum, add, numbers, word};
use crate::io::error::quoted;
use crate::io::interpret::kinds;
use crate::io::text::number;
use crate::io::{Input, ReadError, Reading};

/// Most channels of a rawtoaces file; a camera has three.
const MOST_CHANNELS: usize = 100;

/// Wavelengths of a table's keys in rising order, and their places in it.
fn wavelengths(
    input: &Input,
    table: &Map<String, Value>,
) -> Result<(Vec<f64>, Vec<usize>), ReadError> {
    // Keys are in the order of the parser, which need not be that of the numbers.
    let mut order = table
        .keys()
        .enumerate()
        .map(|(index, key)| {
            let nm = number::number(key.trim(), false).filter(|v| v.is_finite());
            nm.map(|nm| (nm, index))
                .ok_or_else(|| input.error(quoted(key), "a wavelength in nm as key"))
        })
        .collect::<Result<Vec<_>, _>>()?;
    order.sort_by(|a, b| a.0.total_cmp(&b.0));
    Ok(order.into_iter().unzip())
}

/// Adds the channels of a rawtoaces file to a reading.
///
/// # Errors
/// [`ReadError`] for keys that are no wavelengths or values that are no numbers.
pub(super) fn read_rawtoaces(
    input: &Input,
    value: &Value,
    main: &Map<String, Value>,
    reading: &mut Reading,
) -> Result<(), ReadError> {
    let (nm, places) = wavelengths(input, main)?;
    let rows = main
        .values()
        .map(|row| numbers(input, row, "\"main\""))
        .collect::<Result<Vec<_>, _>>()?;
    let width = rows.iter().map(Vec::len).max().unwrap_or(0);
    // Each is gone through with every wavelength, also where most rows are empty.
    if width > MOST_CHANNELS {
        let expected = format!("at most {MOST_CHANNELS} channels");
        return Err(input.error(format!("{width} channels"), expected));
    }
    let names: Vec<&str> = value
        .pointer("/spectral_data/index/main")
        .and_then(Value::as_array)
        .map(|list| list.iter().filter_map(Value::as_str).collect())
        .unwrap_or_default();
    let title = word(value, "/header/description").unwrap_or(input.stem());
    let unit = word(value, "/spectral_data/units").unwrap_or("");
    for column in 0..width {
        let cell = |row: &usize| rows[*row].get(column).copied().unwrap_or(f64::NAN);
        let values = places.iter().map(cell).collect();
        let channel = names.get(column).copied().unwrap_or("");
        let kind = kinds::kind_of_title(channel)
            .filter(|_| width == 1)
            .or((width == 3).then_some(Kind::Weighting))
            .or_else(|| kinds::kind_of_words(title));
        let found = JsonSpectrum {
            name: match width {
                1 => title.to_owned(),
                _ => format!("{title} {channel}"),
            },
            kind,
            unit,
            percent: unit.to_lowercase().contains("percent").then_some(true),
            source: word(value, "/header/laboratory").unwrap_or(&input.name),
        };
        add(input, found, &nm, values, reading)?;
    }
    Ok(())
}

/// Adds the spectrum of a tobes-ui file to a reading.
///
/// # Errors
/// [`ReadError`] for keys that are no wavelengths or values that are no numbers.
pub(super) fn read_tobes(
    input: &Input,
    root: &Map<String, Value>,
    spd: &Map<String, Value>,
    reading: &mut Reading,
) -> Result<(), ReadError> {
    let (nm, places) = wavelengths(input, spd)?;
    let list = Value::Array(spd.values().cloned().collect());
    let unordered = numbers(input, &list, "\"spd\"")?;
    let values = places.iter().map(|place| unordered[*place]).collect();
    let name = root
        .get("name")
        .and_then(Value::as_str)
        .filter(|n| !n.trim().is_empty());
    let unit = root
        .get("y_axis")
        .or_else(|| root.get("units"))
        .and_then(Value::as_str);
    let found = JsonSpectrum {
        name: name.unwrap_or(input.stem()).to_owned(),
        kind: Some(Kind::Light),
        unit: unit.unwrap_or(""),
        percent: None,
        source: &input.name,
    };
    add(input, found, &nm, values, reading)
}
