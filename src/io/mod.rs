//! Files to spectra and back, one format a file.
//!
//! [`read_path`] and [`read_bytes`] look at the content, not at the extension: every entry of
//! [`FORMATS`] says how sure it is that a file is its own, the surest reads it, and of equally
//! sure ones the earlier in the list. A further format is one more file and one more entry, its seeds in
//! tests/hostile, its miniatures in tests/files and its row in docs/formats.md.
//!
//! ```text
//! bytes -> text (encoding) -> sniff -> the format's reader -> Reading
//!   formats: decode (archive, XML, JSON), table (dialect -> blocks -> titles, layout) -> RawSpectrum
//!   interpret: RawSpectrum -> axis, kind, scale decided -> curve -> Facts -> agree -> describe
//! ```
//!
//! A refusal ([`ReadError`]) is one line with file, line, what was found and what was expected.
//! Nothing here touches colour or the window.

mod choices;
mod decode;
mod error;
mod formats;
mod input;
mod interpret;
mod photo;
mod provenance;
mod reading;
mod table;
mod text;
mod unopened;
mod write;

pub(crate) mod budget;
pub(crate) mod disk;
pub mod many;
pub(crate) mod stream;

#[cfg(not(target_arch = "wasm32"))]
use std::io::Read;
use std::path::Path;

use crate::languages::said;

pub(crate) use choices::OfOne;
pub use choices::{Choices, Counted};
pub use decode::png::{ColourPixels, ColourPng};
pub(crate) use decode::{exr::ExrImage, exr::Layer as ExrLayer, png::chunks as png_chunks};
pub(crate) use error::part_of_message;
pub use error::{ReadError, WriteError, quoted, shown};
pub(crate) use formats::{
    Confidence, composite_json::in_words as composite_in_words, spectral_image::Meant,
};
pub use formats::{
    FORMATS, Format, composite_json::CompositeTextError, composite_json::write as composite_json,
    composite_line::parse as parse_composite_line, composite_line::write as composite_line, envi,
};
pub use input::Input;
pub(crate) use input::name_of;
pub(crate) use interpret::{describe::MOST_UNDERSTOOD, value_unit::counts_photons};
pub(crate) use photo::{Exif, Photo, photo_of, read_photo};
pub(crate) use provenance::one_line;
pub use provenance::{Column, Columns, Provenance, shortest};
pub use reading::{
    CompositeFile, Guessed, OpenQuestion, Reading, makers_results::MakersResult,
    makers_results::Quantity,
};
pub(crate) use reading::{
    TableFound, decision::AxisDecision, decision::Decision, decision::Decisions, decision::Origin,
};
#[cfg(test)]
pub(crate) use table::scan::MOST_CELLS;
pub(crate) use text::{MOST_BYTES, number::is_measured, units::names_wavelength};
pub use text::{
    MOST_BYTES_OF_A_FORMAT, decode as decode_text, dialect::Delimiter, dialect::Dialect,
    dialect::MOST_COLUMNS, dialect::used, exposure::exposure_ms, is_binary, lines as text_lines,
    number::ABSURD, units::WavelengthUnit,
};
pub(crate) use unopened::words as why_unopened;
pub use write::{
    WRITABLE, atomic::save_atomically, csv::write as csv, encode, exr::Precision, losses, png::png,
    spectral_exr::reflectance_exr, write_as,
};
pub(crate) use write::{
    atomic::UNFINISHED, atomic::save_by, atomic::save_together, csv::no_formula, csv::quoted_where,
    exr::BLOCK_ROWS as EXR_BLOCK_ROWS, exr::write_rows as write_exr_rows, png::PngFile,
    spectral_exr::light_exr,
};

/// The description of a file beyond [`text::MOST_BYTES`].
const TOO_LARGE: &str = later!("more than 512 MiB");
const AT_MOST: &str = later!("at most 512 MiB in one file");

/// Reads a file from disk.
///
/// # Errors
/// [`ReadError`] when it cannot be opened, is larger than `text::MOST_BYTES`, or holds nothing
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
    #[cfg(target_arch = "wasm32")]
    let bytes = disk::read(path).map_err(trouble)?;
    #[cfg(not(target_arch = "wasm32"))]
    let bytes = {
        let file = disk::open(path).map_err(trouble)?;
        let about = file.metadata().map_err(trouble)?;
        if about.is_dir() {
            return Err(ReadError::new(&name, said!("a folder"), said!("a file")));
        }
        if is_device(&file, &about) {
            return Err(ReadError::new(&name, said!("a device"), said!("a file")));
        }
        if about.len() > text::MOST_BYTES {
            return Err(ReadError::new(&name, said(TOO_LARGE), said(AT_MOST)));
        }
        let mut bytes = Vec::with_capacity(about.len() as usize);
        file.take(text::MOST_BYTES + 1)
            .read_to_end(&mut bytes)
            .map_err(trouble)?;
        bytes
    };
    read(&Input::at(path, &bytes).deciding(choices))
}

/// True if a file is a device, which may give bytes for ever; typed input has an end.
#[cfg(unix)]
fn is_device(file: &std::fs::File, about: &std::fs::Metadata) -> bool {
    use std::io::IsTerminal;
    use std::os::unix::fs::FileTypeExt;
    let kind = about.file_type();
    kind.is_block_device() || kind.is_char_device() && !file.is_terminal()
}

#[cfg(not(any(unix, target_arch = "wasm32")))]
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

pub(crate) fn read(input: &Input) -> Result<Reading, ReadError> {
    if input.bytes.len() as u64 > text::MOST_BYTES {
        return Err(input.error(said(TOO_LARGE), said(AT_MOST)));
    }
    if input.bytes.is_empty() {
        return Err(input.error(said!("an empty file"), said!("a spectrum")));
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
            said!("binary data of no kind known here"),
            said!("a file with a spectrum"),
        ));
    };
    let mut reading = (format.read)(input)?;
    interpret::agree::agree(&mut reading);
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
