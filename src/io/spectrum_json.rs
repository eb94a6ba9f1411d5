//! The program's own spectrum as JSON.
//!
//! ```text
//! {"format": "spectral-explorer-spectrum", "version": 1, "name", "kind", "unit",
//!  "wavelengths_nm": [..], "values": [..], "source", "notes": [..],
//!  "scale_in_force", "settings", "written_by"}
//! ```
//!
//! Values are in `unit`, kinds are the words of [`Kind::word`]; the last three are for people.

use serde::{Deserialize, Serialize};

use crate::spectrum::{Kind, NamedSpectrum};

use super::error::quoted;
use super::interpret::decision::Decision;
use super::interpret::interpret;
use super::interpret::raw::RawSpectrum;
use super::interpret::remark::Remark;
use super::provenance::Provenance;
use super::{Confidence, Format, Input, ReadError, Reading, budget};

/// The word in `format`.
pub const FORMAT_WORD: &str = "spectral-explorer-spectrum";

/// The version written and read.
pub const VERSION: u32 = 1;

/// The program's own spectrum.
pub const FORMAT: Format = Format {
    name: "spectrum JSON",
    extensions: &["json"],
    sniff,
    read,
};

#[derive(Serialize, Deserialize)]
struct File {
    format: String,
    version: u32,
    #[serde(default)]
    name: String,
    kind: Kind,
    #[serde(default)]
    unit: String,
    wavelengths_nm: Vec<f64>,
    values: Vec<f64>,
    #[serde(default)]
    source: String,
    #[serde(default)]
    notes: Vec<String>,
    #[serde(default, skip_serializing_if = "String::is_empty")]
    scale_in_force: String,
    #[serde(default, skip_serializing_if = "String::is_empty")]
    settings: String,
    #[serde(default, skip_serializing_if = "String::is_empty")]
    written_by: String,
}

fn sniff(input: &Input) -> Confidence {
    if input.head().starts_with('{') && input.head().contains(FORMAT_WORD) {
        Confidence::Certain
    } else {
        Confidence::No
    }
}

/// Memory that the parser takes for a value in a list, and for one with a key, in bytes.
const VALUE_BYTES: usize = 40;
const KEYED_BYTES: usize = 130;

/// A whole text as JSON. The parsed form of short values is far larger than their text, so they
/// are counted first.
///
/// # Errors
/// [`ReadError`] for broken JSON, or more values than fit into the memory that the file may take.
pub fn any_json(input: &Input, text: &str) -> Result<serde_json::Value, ReadError> {
    let count = |marks: &[u8]| text.bytes().filter(|b| marks.contains(b)).count();
    let memory = count(b",[{") * VALUE_BYTES + count(b":") * KEYED_BYTES;
    if memory > budget::of(text.len()) / 2 {
        return Err(input.error(
            "JSON of far more values than its size allows",
            budget::WORDS,
        ));
    }
    serde_json::from_str(text).map_err(|error| json_error(input, &error))
}

/// An error of the JSON parser as one of the file.
pub fn json_error(input: &Input, error: &serde_json::Error) -> ReadError {
    // The parser's sentence ends in "at line L column C" and mostly holds "X, expected Y".
    let text = error.to_string();
    let text = text
        .rsplit_once(" at line ")
        .map_or(&*text, |(head, _)| head);
    let (found, expected) = text
        .split_once(", expected ")
        .or_else(|| text.split_once(" expected "))
        .unwrap_or((text, "valid JSON of this format"));
    let refusal = input.error(format!("JSON with {found}"), expected);
    if error.line() > 0 {
        refusal.at_line(error.line())
    } else {
        refusal
    }
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_long_text()?.text;
    let file: File = serde_json::from_str(text).map_err(|e| json_error(input, &e))?;
    let File {
        format,
        version,
        name,
        kind,
        unit,
        wavelengths_nm,
        values,
        source,
        notes,
        scale_in_force: _,
        settings: _,
        written_by: _,
    } = file;
    if format != FORMAT_WORD {
        return Err(input.error(
            format!("\"format\": {}", quoted(&format)),
            format!("\"{FORMAT_WORD}\""),
        ));
    }
    if version != VERSION {
        return Err(input.error(format!("version {version}"), format!("version {VERSION}")));
    }
    if wavelengths_nm.len() != values.len() {
        return Err(input.error(
            format!(
                "{} wavelengths and {} values",
                wavelengths_nm.len(),
                values.len()
            ),
            "one value for each wavelength",
        ));
    }
    let name = match name.is_empty() {
        true => input.stem().to_owned(),
        false => name,
    };
    let mut reading = Reading::default();
    let kind = Decision::of_format(kind);
    let mut raw = RawSpectrum::known(name, &wavelengths_nm, values, kind, &unit);
    raw.notes = notes;
    raw.source = Some(source);
    interpret(raw, input, &mut reading)?;
    if let (Some(spectrum), Some(facts)) = (reading.spectra.last_mut(), reading.facts.last_mut()) {
        spectrum.unit = unit;
        // Its notes begin with the line of the file before.
        facts.remarks.retain(|remark| *remark != Remark::Line);
    }
    Ok(reading)
}

/// A spectrum as JSON.
pub fn write(spectrum: &NamedSpectrum, provenance: &Provenance) -> String {
    let file = File {
        format: FORMAT_WORD.to_owned(),
        version: VERSION,
        name: spectrum.name.clone(),
        kind: spectrum.kind,
        unit: spectrum.unit.clone(),
        wavelengths_nm: spectrum.samples.nm().to_vec(),
        values: spectrum.samples.values().to_vec(),
        source: provenance.source_of(spectrum).to_owned(),
        notes: spectrum.notes.clone(),
        scale_in_force: provenance.scale_words.clone(),
        settings: provenance.settings.clone(),
        written_by: provenance.program.clone(),
    };
    // Numbers, words and lists only: there is nothing in it that JSON cannot hold.
    serde_json::to_string(&file).unwrap_or_default() + "\n"
}

#[cfg(test)]
mod tests {
    use crate::io::read_bytes;

    const HEAD: &str = r#"{"format":"spectral-explorer-spectrum","version":1,"kind":"light","#;

    #[test]
    fn faults_are_named_with_their_line() {
        for (body, words) in [
            (
                "\n\"wavelengths_nm\":[400,\"x\"],\"values\":[1,2]}",
                "line 2: found JSON with invalid type: string \"x\", expected f64",
            ),
            (
                "\"wavelengths_nm\":[400,500],\"values\":[1]}",
                "found 2 wavelengths and 1 values, expected one value for each wavelength",
            ),
            (
                "\"wavelengths_nm\":[400],\"values\":[1]}",
                "found 1 point with a wavelength and a value, expected at least 2",
            ),
            (
                "\"wavelengths_nm\":[400,500],\"values\":[1,1e999]}",
                "number out of range",
            ),
        ] {
            let refusal = read_bytes("a.json", (HEAD.to_owned() + body).as_bytes())
                .unwrap_err()
                .to_string();
            assert!(refusal.contains(words), "{refusal}");
        }
    }
}
