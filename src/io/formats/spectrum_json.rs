//! The program's own spectrum as JSON.
//!
//! ```text
//! {"format": "spectral-explorer-spectrum", "version": 1, "name", "kind", "unit",
//!  "wavelengths_nm": [..], "values": [..], "source", "notes": [..],
//!  "scale_in_force", "settings", "written_by"}
//! ```
//!
//! Values are in `unit`, kinds are the words of [`Kind::word`](crate::spectrum::Kind::word); the
//! last three are for people.

use super::{Confidence, Format};
use crate::io::decode::json::json_error;
use crate::io::interpret::{RawSpectrum, alone};
use crate::io::reading::remark::Remark;
use crate::io::write::json::{FORMAT_WORD, SpectrumFile, VERSION};
use crate::io::{Decision, Input, ReadError, Reading, quoted};

pub(crate) const FORMAT: Format = Format::new("spectrum JSON", &["json"], sniff, read);

fn sniff(input: &Input) -> Confidence {
    super::own_json(input, FORMAT_WORD)
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_long_text()?.text;
    let file: SpectrumFile = serde_json::from_str(text).map_err(|e| json_error(input, &e))?;
    let SpectrumFile {
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
        let found = format!("\"format\": {}", quoted(&format));
        return Err(input.error(found, format!("\"{FORMAT_WORD}\"")));
    }
    if version != VERSION {
        return Err(input.error(format!("version {version}"), format!("version {VERSION}")));
    }
    let (wavelengths, numbers) = (wavelengths_nm.len(), values.len());
    if wavelengths != numbers {
        let found = format!("{wavelengths} wavelengths and {numbers} values");
        return Err(input.error(found, "one value for each wavelength"));
    }
    let name = match name.is_empty() {
        true => input.stem().to_owned(),
        false => name,
    };
    let kind = Decision::of_format(kind);
    let mut raw = RawSpectrum::known(name, &wavelengths_nm, values, kind, &unit);
    raw.notes = notes;
    raw.source = Some(source);
    let mut reading = alone(raw, input)?;
    if let (Some(spectrum), Some(facts)) = (reading.spectra.last_mut(), reading.facts.last_mut()) {
        spectrum.unit = unit;
        // Its notes begin with the line of the file before.
        facts.remarks.retain(|remark| *remark != Remark::Line);
    }
    Ok(reading)
}
