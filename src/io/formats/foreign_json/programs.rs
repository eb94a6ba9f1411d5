//! JSON of programs that describe their spectra: colorimetry-io 1.0, rawtoaces, tobes-ui.

use serde_json::{Map, Value};

use crate::io::decode::json::{number, numbers, word};
use crate::io::error::quoted;
use crate::io::interpret::curve::MOST_SAMPLES;
use crate::io::interpret::{KnownScale, RawSpectrum, interpret, kinds};
use crate::io::provenance::shortest;
use crate::io::text::number;
use crate::io::{Decision, Input, ReadError, Reading};
use crate::languages::with_sign;
use crate::spectrum::Kind;

/// Most channels of a rawtoaces file; a camera has three.
const MOST_CHANNELS: usize = 100;

/// A program's description of a spectrum.
struct Stated<'a> {
    name: String,
    kind: Option<Kind>,
    unit: &'a str,
    /// True if a factor is in per cent.
    percent: Option<bool>,
    source: Option<&'a str>,
}

/// Reads JSON of a known program; `false` for other JSON.
pub(super) fn read(input: &Input, value: &Value, reading: &mut Reading) -> Result<bool, ReadError> {
    let has = |value: &Value, key: &str| value.get(key).is_some();
    let is_colorimetry = |v: &Value| has(v, "wavelength_axis") || has(v, "spectral_data");
    let object = |pointer| value.pointer(pointer).and_then(Value::as_object);
    // tobes-ui's has numbers only.
    let is_nested = |value: &Value| value.is_array() || value.is_object();
    let spd = object("/spd").filter(|spd| !spd.values().any(is_nested));
    let spectra = value.get("spectra").and_then(Value::as_array);
    let spectra = spectra.filter(|list| list.iter().any(is_colorimetry));
    let spectrum = value.get("spectrum");
    let spectrum = spectrum.filter(|spectrum| has(spectrum, "spectral_data"));
    let is_itself = has(value, "wavelength_axis") && has(value, "spectral_data");
    if let Some(main) = object("/spectral_data/data/main") {
        read_rawtoaces(input, value, main, reading)?;
    } else if let Some(spd) = spd {
        read_tobes(input, value, spd, reading)?;
    } else if let Some(spectra) = spectra {
        for spectrum in spectra {
            read_colorimetry(input, spectrum, reading)?;
        }
    } else if let Some(spectrum) = spectrum.or(is_itself.then_some(value)) {
        read_colorimetry(input, spectrum, reading)?;
    } else {
        return Ok(false);
    }
    Ok(true)
}

/// Adds a spectrum to a reading.
fn add(
    input: &Input,
    stated: Stated,
    nm: &[f64],
    values: Vec<f64>,
    reading: &mut Reading,
) -> Result<(), ReadError> {
    let unstated = || Decision::guessed(Kind::Light, false, said!("nothing states it"));
    let kind = stated.kind.map_or_else(unstated, Decision::of_format);
    let is_factor = kind.value.is_factor();
    let mut raw = RawSpectrum::known(stated.name, nm, values, kind, stated.unit);
    raw.known.scale = match stated.percent {
        // What is no share of a whole has no per cent.
        Some(true) if is_factor => KnownScale::Stated(0.01),
        Some(false) => KnownScale::Stated(1.0),
        Some(true) | None => KnownScale::Open,
    };
    raw.source = Some(stated.source.unwrap_or(&input.name).to_owned());
    interpret(raw, input, reading)?;
    reading.keep_scale_to_notes();
    Ok(())
}

/// Adds a spectrum of colorimetry-io.
fn read_colorimetry(input: &Input, value: &Value, reading: &mut Reading) -> Result<(), ReadError> {
    let no_axis = || {
        let expected = said!("one with \"values_nm\" or \"range_nm\"");
        input.error(said!("no \"wavelength_axis\""), expected)
    };
    let axis = value.get("wavelength_axis").ok_or_else(no_axis)?;
    let no_values = || input.error(said!("no \"spectral_data\""), said!("one with \"values\""));
    let values = value.pointer("/spectral_data/values");
    let values = numbers(input, values.ok_or_else(no_values)?, "\"values\"")?;
    let nm = match axis.get("values_nm") {
        Some(list) if !list.is_null() => numbers(input, list, "\"values_nm\"")?,
        _ => range(input, axis, values.len())?,
    };
    check_counts(input, nm.len(), values.len())?;
    let stated = word(value, "/metadata/measurement_type").unwrap_or("");
    let scale = word(value, "/spectral_data/scale");
    let name = word(value, "/metadata/title").or_else(|| word(value, "/id"));
    let stated = Stated {
        name: name.unwrap_or(input.stem()).to_owned(),
        kind: match stated.to_lowercase().as_str() {
            "sensitivity" => Some(Kind::Weighting),
            "emission" => Some(Kind::Light),
            other => kinds::kind_of_words(other),
        },
        unit: word(value, "/spectral_data/unit").unwrap_or(""),
        percent: scale.map(|scale| scale.to_lowercase().starts_with("percent")),
        source: word(value, "/metadata/description"),
    };
    add(input, stated, &nm, values, reading)
}

fn check_counts(input: &Input, wavelengths: usize, values: usize) -> Result<(), ReadError> {
    if wavelengths == values {
        return Ok(());
    }
    let found = tr!(
        "{wavelengths} wavelengths and {values} values",
        wavelengths,
        values
    );
    Err(input.error(found, said!("one value for each wavelength")))
}

/// The wavelengths of a range for some values: no more are made than there are values.
fn range(input: &Input, axis: &Value, values: usize) -> Result<Vec<f64>, ReadError> {
    let expected = said!("\"range_nm\" with numbers \"start\", \"end\" and \"interval\"");
    let number = |key: &str| {
        let number = axis.pointer(&format!("/range_nm/{key}"));
        let missing = || input.error(tr!("no \"{key}\" in \"range_nm\"", key), expected);
        number.and_then(Value::as_f64).ok_or_else(missing)
    };
    let (start, end, interval) = (number("start")?, number("end")?, number("interval")?);
    let steps = ((end - start) / interval).round();
    // The negated test also refuses a step of zero, which makes the count infinite or no number.
    if !(1.0..MOST_SAMPLES as f64).contains(&steps) {
        let [start, end, interval] =
            [start, end, interval].map(|number| with_sign(shortest(number)));
        let found = tr!(
            "a range of {start} to {end} nm in steps of {interval}",
            start,
            end,
            interval
        );
        let expected = said!("at least one step and at most 10,000,000");
        return Err(input.error(found, expected));
    }
    check_counts(input, steps as usize + 1, values)?;
    let at = |i: usize| start + i as f64 * interval;
    Ok((0..=steps as usize).map(at).collect())
}

/// A table's keys as wavelengths in rising order, and the content under each.
fn keyed<T>(
    input: &Input,
    table: &Map<String, Value>,
    cells: impl Fn(&Value) -> Result<T, ReadError>,
) -> Result<(Vec<f64>, Vec<T>), ReadError> {
    let nm = |key: &String| {
        let nm = number::number(key.trim(), false).filter(|v| v.is_finite());
        nm.ok_or_else(|| input.error(quoted(key), said!("a wavelength in nm as key")))
    };
    let nm = table.keys().map(nm).collect::<Result<Vec<_>, _>>()?;
    let cells = table.values().map(cells).collect::<Result<Vec<_>, _>>()?;
    // Keys are in the order of the parser, which need not be that of the numbers.
    let mut rows: Vec<(f64, T)> = nm.into_iter().zip(cells).collect();
    rows.sort_by(|a, b| a.0.total_cmp(&b.0));
    Ok(rows.into_iter().unzip())
}

/// Adds the channels of a rawtoaces file.
fn read_rawtoaces(
    input: &Input,
    value: &Value,
    main: &Map<String, Value>,
    reading: &mut Reading,
) -> Result<(), ReadError> {
    let (nm, rows) = keyed(input, main, |row| numbers(input, row, "\"main\""))?;
    let width = rows.iter().map(Vec::len).max().unwrap_or(0);
    // Each is gone through with every wavelength, also where most rows are empty.
    if width > MOST_CHANNELS {
        let expected = tr!("at most {most} channels", most = MOST_CHANNELS);
        let found = tr!("{n} channels" | "{n} channels" % width);
        return Err(input.error(found, expected));
    }
    let names = value.pointer("/spectral_data/index/main");
    let names = names.and_then(Value::as_array).into_iter().flatten();
    let names: Vec<&str> = names.filter_map(Value::as_str).collect();
    let title = word(value, "/header/description").unwrap_or(input.stem());
    let unit = word(value, "/spectral_data/units").unwrap_or("");
    for column in 0..width {
        let cell = |row: &Vec<f64>| row.get(column).copied().unwrap_or(f64::NAN);
        let channel = names.get(column).copied().unwrap_or("");
        let stated = Stated {
            name: match width {
                1 => title.to_owned(),
                _ => format!("{title} {channel}"),
            },
            kind: kinds::kind_of_title(channel)
                .filter(|_| width == 1)
                .or((width == 3).then_some(Kind::Weighting))
                .or_else(|| kinds::kind_of_words(title)),
            unit,
            percent: unit.to_lowercase().contains("percent").then_some(true),
            source: word(value, "/header/laboratory"),
        };
        add(input, stated, &nm, rows.iter().map(cell).collect(), reading)?;
    }
    Ok(())
}

/// Adds the spectrum of a tobes-ui file.
fn read_tobes(
    input: &Input,
    value: &Value,
    spd: &Map<String, Value>,
    reading: &mut Reading,
) -> Result<(), ReadError> {
    let (nm, values) = keyed(input, spd, |item| number(input, item, "\"spd\""))?;
    let unit = word(value, "/y_axis").or_else(|| word(value, "/units"));
    let stated = Stated {
        name: word(value, "/name").unwrap_or(input.stem()).to_owned(),
        kind: Some(Kind::Light),
        unit: unit.unwrap_or(""),
        percent: None,
        source: None,
    };
    add(input, stated, &nm, values, reading)
}
