//! The program's own spectrum as JSON.
//!
//! ```text
//! {"format": "spectral-explorer-spectrum", "version": 1, "name", "kind", "unit",
//!  "wavelengths_nm": [..], "values": [..], "source", "notes": [..],
//!  "scale_in_force", "settings", "written_by"}
//! ```
//!
//! Values are in `unit`, kinds are the words of [`Kind::word`](crate::spectrum::Kind::word); the
//! last three are for human readers.

use super::{Confidence, Format};
use crate::io::decode::json::json_error;
use crate::io::interpret::{RawSpectrum, alone};
use crate::io::reading::remark::Remark;
use crate::io::write::json::{FORMAT_WORD, SpectrumFile, VERSION};
use crate::io::{Decision, Input, ReadError, Reading, quoted};

pub(crate) const FORMAT: Format = Format::new(later!("spectrum JSON"), &["json"], sniff, read);

fn sniff(input: &Input) -> Confidence {
    super::own_json(input, FORMAT_WORD)
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_long_text()?.text;
    let file: SpectrumFile = serde_json::from_str(text).map_err(|e| json_error(input, &e))?;
    if file.format != FORMAT_WORD {
        let found = format!("\"format\": {}", quoted(&file.format));
        return Err(input.error(found, format!("\"{FORMAT_WORD}\"")));
    }
    if file.version != VERSION {
        let found = tr!("version {version}", version = file.version);
        return Err(input.error(found, tr!("version {version}", version = VERSION)));
    }
    let (wavelengths, numbers) = (file.wavelengths_nm.len(), file.values.len());
    if wavelengths != numbers {
        let found = tr!(
            "{wavelengths} wavelengths and {values} values",
            wavelengths,
            values = numbers
        );
        return Err(input.error(found, said!("one value for each wavelength")));
    }
    let kind = Decision::of_format(file.kind);
    let (name, nm) = (input.named(&file.name), &file.wavelengths_nm);
    let mut raw = RawSpectrum::known(name, nm, file.values, kind, &file.unit);
    raw.notes = file.notes;
    raw.source = Some(file.source);
    let mut reading = alone(raw, input)?;
    if let (Some(spectrum), Some(facts)) = (reading.spectra.last_mut(), reading.facts.last_mut()) {
        spectrum.unit = file.unit;
        // Its notes begin with the line of the file before.
        facts.remarks.retain(|remark| *remark != Remark::Line);
    }
    Ok(reading)
}
