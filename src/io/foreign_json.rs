//! JSON of other programs: colorimetry-io 1.0, rawtoaces, tobes-ui.
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

use serde_json::{Map, Value};

use crate::spectrum::Kind;

use super::curve;
use super::error::quoted;
use super::meaning;
use super::reading::provenance as provenance_line;
use super::spectrum_json::json_error;
use super::{Confidence, Format, Guess, Guessed, Input, ReadError, Reading};
use crate::spectrum::NamedSpectrum;

/// JSON of other programs.
pub const FORMAT: Format = Format {
    name: "JSON of another program",
    extensions: &["json"],
    sniff,
    read,
};

/// What a refusal asks for.
const KNOWN: &str = "a spectrum or composite of this program, or one of colorimetry-io, rawtoaces or tobes-ui";

/// Most points that `range_nm` may ask for.
const MOST_POINTS: f64 = curve::MOST_SAMPLES as f64;

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
    let value: Value = serde_json::from_str(text).map_err(|e| json_error(input, &e))?;
    let mut reading = Reading::default();
    let Some(root) = value.as_object() else {
        return Err(input.error("JSON that is no object", KNOWN));
    };
    if let Some(main) = value.pointer("/spectral_data/data/main").and_then(Value::as_object) {
        read_rawtoaces(input, &value, main, &mut reading)?;
    } else if let Some(spd) = root.get("spd").and_then(Value::as_object) {
        read_tobes(input, root, spd, &mut reading)?;
    } else if let Some(spectra) = root.get("spectra").and_then(Value::as_array) {
        for spectrum in spectra {
            read_colorimetry(input, spectrum, &mut reading)?;
        }
    } else if let Some(spectrum) = root.get("spectrum").filter(|s| s.get("spectral_data").is_some()) {
        read_colorimetry(input, spectrum, &mut reading)?;
    } else if root.contains_key("wavelength_axis") && root.contains_key("spectral_data") {
        read_colorimetry(input, &value, &mut reading)?;
    } else {
        let keys: Vec<&str> = root.keys().take(3).map(String::as_str).collect();
        return Err(input.error(format!("JSON with the keys {}", quoted(&keys.join(", "))), KNOWN));
    }
    if reading.spectra.is_empty() {
        return Err(input.error("JSON with no spectrum in it", KNOWN));
    }
    reading.notes.insert(0, reading.spectra[0].notes[0].clone());
    Ok(reading)
}

/// What is known of a spectrum before its numbers are put in order.
struct Found {
    name: String,
    kind: Kind,
    kind_stated: bool,
    unit: String,
    percent: Option<bool>,
    source: String,
}

fn add(
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
    let mut guess = |what, chosen: &str, because: String| {
        notes.push(format!("taken as {chosen}: {because}"));
        reading.guesses.push(Guess {
            spectrum: index,
            what,
            chosen: chosen.to_owned(),
            because,
        });
    };
    if !found.kind_stated {
        guess(Guessed::Kind, found.kind.word(), "nothing states it".to_owned());
    }
    let mut scale = 1.0;
    if found.kind.is_factor() {
        let percent = found.percent.unwrap_or_else(|| {
            let guessed = meaning::percent("", &[], false, samples.values());
            let chosen = if guessed.percent { "percent" } else { "fraction" };
            guess(Guessed::Percent, chosen, guessed.because);
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
        unit: if found.kind.is_factor() { "fraction".to_owned() } else { found.unit },
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

fn word<'a>(value: &'a Value, pointer: &str) -> Option<&'a str> {
    let text = value.pointer(pointer)?.as_str()?.trim();
    (!text.is_empty()).then_some(text)
}

/// A list of numbers; `null` stands for a missing one.
fn numbers(input: &Input, list: &Value, what: &str) -> Result<Vec<f64>, ReadError> {
    let list = list
        .as_array()
        .ok_or_else(|| input.error(format!("{what} that is no list"), "a list of numbers"))?;
    list.iter()
        .map(|item| match item {
            Value::Null => Ok(f64::NAN),
            Value::Number(number) => Ok(number.as_f64().unwrap_or(f64::NAN)),
            other => Err(input.error(format!("{} in {what}", quoted(&other.to_string())), "a number")),
        })
        .collect()
}

fn read_colorimetry(input: &Input, value: &Value, reading: &mut Reading) -> Result<(), ReadError> {
    let axis = value
        .get("wavelength_axis")
        .ok_or_else(|| input.error("no \"wavelength_axis\"", "one with \"values_nm\" or \"range_nm\""))?;
    let values = value
        .pointer("/spectral_data/values")
        .ok_or_else(|| input.error("no \"spectral_data\"", "one with \"values\""))?;
    let values = numbers(input, values, "\"values\"")?;
    let nm = if let Some(list) = axis.get("values_nm").filter(|l| !l.is_null()) {
        numbers(input, list, "\"values_nm\"")?
    } else {
        range(input, axis)?
    };
    if nm.len() != values.len() {
        return Err(input.error(
            format!("{} wavelengths and {} values", nm.len(), values.len()),
            "one value for each wavelength",
        ));
    }
    let stated = word(value, "/metadata/measurement_type").unwrap_or("");
    let kind = match stated.to_lowercase().as_str() {
        "sensitivity" => Some(Kind::Weighting),
        "emission" => Some(Kind::Light),
        other => meaning::kind_of_words(other),
    };
    let percent = word(value, "/spectral_data/scale").map(|s| s.to_lowercase().starts_with("percent"));
    let name = word(value, "/metadata/title").or_else(|| word(value, "/id")).unwrap_or(input.stem());
    let found = Found {
        name: name.to_owned(),
        kind: kind.unwrap_or(Kind::Light),
        kind_stated: kind.is_some(),
        unit: word(value, "/spectral_data/unit").unwrap_or("").to_owned(),
        percent,
        source: word(value, "/metadata/description").unwrap_or(&input.name).to_owned(),
    };
    add(input, found, &nm, &values, reading)
}

fn range(input: &Input, axis: &Value) -> Result<Vec<f64>, ReadError> {
    let expected = "\"range_nm\" with numbers \"start\", \"end\" and \"interval\"";
    let number = |key: &str| {
        axis.pointer(&format!("/range_nm/{key}"))
            .and_then(Value::as_f64)
            .ok_or_else(|| input.error(format!("no \"{key}\" in \"range_nm\""), expected))
    };
    let (start, end, interval) = (number("start")?, number("end")?, number("interval")?);
    let steps = ((end - start) / interval).round();
    // The negated test also refuses a step of zero, which makes the count infinite or no number.
    if !(1.0..MOST_POINTS).contains(&steps) {
        return Err(input.error(
            format!("a range of {start} to {end} nm in steps of {interval}"),
            "at least one step and at most 10,000,000",
        ));
    }
    Ok((0..=steps as usize).map(|i| start + i as f64 * interval).collect())
}

fn wavelengths(input: &Input, table: &Map<String, Value>) -> Result<Vec<(f64, usize)>, ReadError> {
    // Keys are in the order of the parser, which need not be that of the numbers.
    let mut order = table
        .keys()
        .enumerate()
        .map(|(index, key)| {
            let nm = super::number::number(key.trim(), false).filter(|v| v.is_finite());
            nm.map(|nm| (nm, index))
                .ok_or_else(|| input.error(quoted(key), "a wavelength in nm as key"))
        })
        .collect::<Result<Vec<_>, _>>()?;
    order.sort_by(|a, b| a.0.total_cmp(&b.0));
    Ok(order)
}

fn read_rawtoaces(
    input: &Input,
    value: &Value,
    main: &Map<String, Value>,
    reading: &mut Reading,
) -> Result<(), ReadError> {
    let order = wavelengths(input, main)?;
    let rows = main
        .values()
        .map(|row| numbers(input, row, "\"main\""))
        .collect::<Result<Vec<_>, _>>()?;
    let width = rows.iter().map(Vec::len).max().unwrap_or(0);
    let names: Vec<&str> = value
        .pointer("/spectral_data/index/main")
        .and_then(Value::as_array)
        .map(|list| list.iter().filter_map(Value::as_str).collect())
        .unwrap_or_default();
    let title = word(value, "/header/description").unwrap_or(input.stem());
    let unit = word(value, "/spectral_data/units").unwrap_or("");
    let nm: Vec<f64> = order.iter().map(|(nm, _)| *nm).collect();
    for column in 0..width {
        let values: Vec<f64> = order
            .iter()
            .map(|(_, row)| rows[*row].get(column).copied().unwrap_or(f64::NAN))
            .collect();
        let channel = names.get(column).copied().unwrap_or("");
        let kind = meaning::kind_of_title(channel)
            .filter(|_| width == 1)
            .or(if width == 3 { Some(Kind::Weighting) } else { None })
            .or_else(|| meaning::kind_of_words(title));
        let found = Found {
            name: if width == 1 { title.to_owned() } else { format!("{title} {channel}") },
            kind: kind.unwrap_or(Kind::Light),
            kind_stated: kind.is_some(),
            unit: unit.to_owned(),
            percent: unit.to_lowercase().contains("percent").then_some(true),
            source: word(value, "/header/laboratory").unwrap_or(&input.name).to_owned(),
        };
        add(input, found, &nm, &values, reading)?;
    }
    Ok(())
}

fn read_tobes(
    input: &Input,
    root: &Map<String, Value>,
    spd: &Map<String, Value>,
    reading: &mut Reading,
) -> Result<(), ReadError> {
    let order = wavelengths(input, spd)?;
    let list = Value::Array(spd.values().cloned().collect());
    let unordered = numbers(input, &list, "\"spd\"")?;
    let values: Vec<f64> = order.iter().map(|(_, row)| unordered[*row]).collect();
    let nm: Vec<f64> = order.iter().map(|(nm, _)| *nm).collect();
    let name = root.get("name").and_then(Value::as_str).filter(|n| !n.trim().is_empty());
    let unit = root.get("y_axis").or_else(|| root.get("units")).and_then(Value::as_str);
    let found = Found {
        name: name.unwrap_or(input.stem()).to_owned(),
        kind: Kind::Light,
        kind_stated: true,
        unit: unit.unwrap_or("").to_owned(),
        percent: None,
        source: input.name.clone(),
    };
    add(input, found, &nm, &values, reading)
}

#[cfg(test)]
mod tests {
    use crate::io::read_bytes;
    use crate::spectrum::Kind;

    #[test]
    fn colorimetry_io_gives_a_range_or_a_list_of_wavelengths() {
        let text = r#"{"schema_version":"1.0.0","spectra":[
            {"id":"a","metadata":{"title":"Tile","measurement_type":"reflectance"},
             "wavelength_axis":{"range_nm":{"start":400,"end":420,"interval":10}},
             "spectral_data":{"scale":"percent","values":[10,20,30]}},
            {"id":"b","metadata":{"measurement_type":"irradiance"},
             "wavelength_axis":{"values_nm":[400,405.5]},"spectral_data":{"values":[1,2]}}]}"#;
        let spectra = read_bytes("a.json", text.as_bytes()).unwrap().spectra;
        assert_eq!((spectra[0].name.as_str(), spectra[0].kind), ("Tile", Kind::Reflectance));
        assert_eq!((spectra[0].scale, spectra[0].samples.last_nm()), (0.01, 420.0));
        assert_eq!((spectra[1].name.as_str(), spectra[1].kind), ("b", Kind::Light));
        assert_eq!(spectra[1].samples.values(), [1.0, 2.0]);
    }

    #[test]
    fn rawtoaces_and_tobes_use_wavelengths_as_keys_in_any_order() {
        let text = r#"{"header":{"description":"Tungsten"},"spectral_data":{"units":"relative",
            "index":{"main":["power"]},"data":{"main":{"1000":[3.0],"380":[1.0],"400":[2.0]}}}}"#;
        let spectra = read_bytes("a.json", text.as_bytes()).unwrap().spectra;
        assert_eq!(spectra[0].samples.values(), [1.0, 2.0, 3.0]);
        assert_eq!((spectra[0].name.as_str(), spectra[0].kind), ("Tungsten", Kind::Light));
        let text = br#"{"status":"normal","spd":{"340":0.0,"1000":0.5}}"#;
        let spectra = read_bytes("b.json", text).unwrap().spectra;
        assert_eq!(spectra[0].samples.nm(), [340.0, 1000.0]);
    }

    #[test]
    fn other_json_is_refused_with_its_keys() {
        for (text, words) in [
            (r#"{"metadata":1,"x":2}"#, "found JSON with the keys \"metadata, x\""),
            ("[1,2]", "no object"),
            ("{\"spd\":{\"abc\":1}}", "found \"abc\", expected a wavelength in nm as key"),
            ("{", "line 1: found JSON with EOF"),
            (r#"{"wavelength_axis":{"range_nm":{"start":1,"end":9,"interval":0}},"spectral_data":{"values":[1]}}"#, "steps of 0"),
        ] {
            let refusal = read_bytes("a.json", text.as_bytes()).unwrap_err().to_string();
            assert!(refusal.contains(words), "{refusal}");
        }
    }
}
