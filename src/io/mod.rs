//! Files to spectra and back, one format a file.
//!
//! [`read_path`] and [`read_bytes`] look at the content, not at the extension: every entry of
//! [`FORMATS`] says how sure it is that a file is its own, the surest reads it, and of equally
//! sure ones the earlier in the list. A further format is one more file and one more entry.
//!
//! ```text
//! bytes -> text (encoding) -> sniff -> the format's reader -> Reading
//!   columns: dialect (delimiter, decimals) -> table (blocks) -> titles, layout -> RawSpectrum
//!   an instrument's own: keyed_lines, cgats_tables, ... -> RawSpectrum; makers_results
//!   interpret: RawSpectrum -> axis, kind, scale decided -> curve -> Facts -> agree -> describe
//! ```
//!
//! A refusal ([`ReadError`]) is one line with file, line, what was found and what was expected.
//! Nothing here touches colour or the window.

pub mod alternating;
pub mod archive;
pub mod argyll_write;
pub mod atomic;
pub mod axis;
pub mod budget;
pub mod cgats;
pub mod cgats_tables;
pub mod choices;
pub mod colorimetry_json;
pub mod colour_png;
pub mod columns;
pub mod composite_json;
pub mod composite_line;
pub mod csv;
pub mod curve;
pub mod cxf;
pub mod dialect;
pub mod envi;
pub mod error;
pub mod foreign_json;
pub mod foreign_spectrum;
pub mod gdtf;
pub mod guarded;
pub mod heading;
pub mod input;
pub mod interpret;
pub mod jcamp;
pub mod keyed_json;
pub mod keyed_lines;
pub mod kinds;
pub mod layout;
pub mod licor_1800;
pub mod licor_li180;
pub mod macam;
pub mod makers_results;
pub mod many;
pub mod meaning;
pub mod no_table;
pub mod number;
pub mod perkin_elmer;
pub mod pick;
pub mod plain_json;
pub mod plain_row;
pub mod procspec;
pub mod provenance;
pub mod raman;
pub mod reading;
pub mod refractive_yaml;
pub mod roles;
pub mod row_order;
pub mod rows;
pub mod samples;
pub mod scan;
pub mod sekonic;
pub mod spd;
pub mod spdx;
pub mod spdx_write;
pub mod spectral_exr;
pub mod spectral_exr_write;
pub mod spectral_image;
pub mod spectrum_json;
pub mod spotread;
pub mod stream;
pub mod svc;
pub mod table;
pub mod text;
pub mod titles;
pub mod tuv;
pub mod units;
pub mod unopened;
pub mod unreadable;
pub mod uprtek;
pub mod usgs;
pub mod wasatch;
pub mod words;
pub mod write;
pub mod xlsx;
pub mod xml;

use std::io::Read;
use std::path::Path;

pub use choices::{Choices, Counted};
pub use dialect::Dialect;
pub use error::{ReadError, WriteError};
pub use input::Input;
pub use makers_results::{MakersResult, Quantity};
pub use provenance::Provenance;
pub use reading::{CompositeFile, Guess, Guessed, Reading};
pub use write::write_as;

/// How sure a format is that a file is its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Confidence {
    /// Not this format.
    No,
    /// Nothing speaks against it.
    Possible,
    /// The content looks like it.
    Likely,
    /// The content says so.
    Certain,
    /// This program wrote it: words in its names that other formats use do not matter.
    Own,
}

/// A file format that the program knows.
#[derive(Clone, Copy)]
pub struct Format {
    /// What messages call it.
    pub name: &'static str,
    /// Usual extensions, lower case, for file dialogues.
    pub extensions: &'static [&'static str],
    /// How sure it is that a file is its own.
    pub sniff: fn(&Input) -> Confidence,
    /// Reads a file of its own, or refuses it.
    pub read: fn(&Input) -> Result<Reading, ReadError>,
}

/// Every format, the special before the general.
pub const FORMATS: &[Format] = &[
    envi::FORMAT,
    spectral_exr::FORMAT,
    gdtf::FORMAT,
    xlsx::FORMAT,
    procspec::FORMAT,
    jcamp::FORMAT,
    cxf::FORMAT,
    refractive_yaml::FORMAT,
    unreadable::FORMAT,
    composite_json::FORMAT,
    composite_line::FORMAT,
    spectrum_json::FORMAT,
    foreign_json::FORMAT,
    spdx::FORMAT,
    spd::FORMAT,
    cgats::FORMAT,
    uprtek::FORMAT,
    licor_li180::FORMAT,
    sekonic::FORMAT,
    licor_1800::FORMAT,
    svc::FORMAT,
    usgs::FORMAT,
    perkin_elmer::FORMAT,
    tuv::FORMAT,
    macam::FORMAT,
    wasatch::FORMAT,
    spotread::FORMAT,
    raman::FORMAT,
    columns::FORMAT,
];

/// What is said of a file beyond [`text::MOST_BYTES`].
const TOO_LARGE: &str = "more than 512 MiB";
const AT_MOST: &str = "at most 512 MiB in one file";

/// Reads a file from disk.
///
/// # Errors
/// [`ReadError`] when it cannot be opened, is larger than [`text::MOST_BYTES`], or holds nothing
/// that the program reads.
pub fn read_path(path: &Path) -> Result<Reading, ReadError> {
    read_path_as(path, &Choices::default())
}

/// Reads a file from disk with decisions about it.
///
/// # Errors
/// As [`read_path`].
pub fn read_path_as(path: &Path, choices: &Choices) -> Result<Reading, ReadError> {
    let name = input::name_of(path);
    let trouble = |error: std::io::Error| {
        let (found, expected) = unopened::words(path, &error);
        ReadError::new(&name, found, expected)
    };
    let file = std::fs::File::open(path).map_err(trouble)?;
    let about = file.metadata().map_err(trouble)?;
    if about.is_dir() {
        return Err(ReadError::new(&name, "a folder", "a file"));
    }
    if is_device(&file, &about) {
        return Err(ReadError::new(&name, "a device", "a file"));
    }
    if about.len() > text::MOST_BYTES {
        return Err(ReadError::new(&name, TOO_LARGE, AT_MOST));
    }
    let mut bytes = Vec::with_capacity(about.len() as usize);
    file.take(text::MOST_BYTES + 1)
        .read_to_end(&mut bytes)
        .map_err(trouble)?;
    read(&Input::at(path, &bytes).deciding(choices))
}

/// Whether a file is a device, which may give bytes for ever; what is typed has an end.
#[cfg(unix)]
fn is_device(file: &std::fs::File, about: &std::fs::Metadata) -> bool {
    use std::io::IsTerminal;
    use std::os::unix::fs::FileTypeExt;
    let kind = about.file_type();
    kind.is_block_device() || kind.is_char_device() && !file.is_terminal()
}

#[cfg(not(unix))]
fn is_device(_: &std::fs::File, _: &std::fs::Metadata) -> bool {
    false
}

/// Reads a file that is in memory; `name` is what messages and spectra call it.
///
/// # Errors
/// [`ReadError`] when it is too large or holds nothing that the program reads.
pub fn read_bytes(name: &str, bytes: &[u8]) -> Result<Reading, ReadError> {
    read_bytes_as(name, bytes, &Choices::default())
}

/// Reads a file that is in memory with decisions about it.
///
/// # Errors
/// As [`read_bytes`].
pub fn read_bytes_as(name: &str, bytes: &[u8], choices: &Choices) -> Result<Reading, ReadError> {
    read(&Input::new(name, bytes).deciding(choices))
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    if input.bytes.len() as u64 > text::MOST_BYTES {
        return Err(input.error(TOO_LARGE, AT_MOST));
    }
    if input.bytes.is_empty() {
        return Err(input.error("an empty file", "a spectrum"));
    }
    let mut best = (Confidence::No, None);
    for format in FORMATS {
        let confidence = (format.sniff)(input);
        if confidence > best.0 {
            best = (confidence, Some(format));
        }
    }
    let Some(format) = best.1 else {
        return Err(input.error(
            "binary data of no kind known here",
            "a file with a spectrum",
        ));
    };
    let mut reading = (format.read)(input)?;
    interpret::describe::finish(&input.choices, &mut reading);
    reading.file.clone_from(&input.name);
    reading.format = format.name;
    reading.tell_holes();
    reading.tell_unused(&input.choices);
    reading.tidy();
    reading.name_apart();
    reading.notes.extend(input.text_notes());
    Ok(reading)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_content_decides_and_not_the_extension() {
        let reading = read_bytes("lamp.xlsx", b"380\t0.5\n385\t0.6\n390\t0.7\n").unwrap();
        assert_eq!(reading.format, columns::FORMAT.name);
        assert_eq!(reading.spectra[0].samples.values(), [0.5, 0.6, 0.7]);
    }

    #[test]
    fn nothing_and_a_folder_are_refused_in_words() {
        let empty = read_bytes("a.csv", b"").unwrap_err().to_string();
        assert_eq!(empty, "a.csv: found an empty file, expected a spectrum");
        let folder = tempfile::tempdir().unwrap();
        let refusal = read_path(folder.path()).unwrap_err().to_string();
        assert!(refusal.contains("expected a file"), "{refusal}");
        let device = cfg!(unix).then(|| read_path(Path::new("/dev/zero")).unwrap_err());
        let said = device.map(|refusal| refusal.to_string());
        assert!(said.is_none_or(|said| said == "zero: found a device, expected a file"));
        let missing = read_path(&folder.path().join("none.csv")).unwrap_err();
        assert_eq!(
            missing.to_string(),
            format!(
                "none.csv: found no such file in {}, expected a file that exists",
                folder.path().display()
            )
        );
        let nowhere = read_path(Path::new("/nope/x.csv")).unwrap_err();
        assert_eq!(
            nowhere.to_string(),
            "x.csv: found no folder /nope, expected a file that exists"
        );
    }
}
