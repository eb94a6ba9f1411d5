//! ENVI spectral libraries and image cubes: a text header `.hdr` beside a file of bare numbers.
//!
//! The header starts with the line `ENVI` and continues with `key = value` lines; a value in braces
//! may run over several lines, a line that starts with `;` is a comment. The data file has the
//! same name without `.hdr`, with or without an extension of its own (`a.hdr` beside `a`, `a.sli`,
//! `a.img`, `a.bsq`, ...; `a.sli.hdr` beside `a.sli`). Either of the two may be opened.
//!
//! In a **library** (`file type = ENVI Spectral Library`) `samples` counts the channels and
//! `lines` the spectra; in a **cube** they are columns and rows, and `bands` the channels.
//! `interleave` is `bsq` (band by band), `bil` (row by row) or `bip` (pixel by pixel), `byte
//! order` 0 (least significant first) or 1, `data type` the kind of number, and `header
//! offset` the bytes before the first number. `wavelength units` may be unknown; `bbl = {1, 0}`
//! marks bad bands with 0; `reflectance scale factor = 10000` means that 10000 is a reflectance
//! of 1.
//!
//! Limits: 512 MiB of data; [`needs`] derives size and memory from the header alone.

mod header;
mod image;
mod library;
mod meaning;
mod pair;

use std::borrow::Cow;
use std::path::{Path, PathBuf};

use super::{Confidence, Format};
use crate::io::input::name_of;
use crate::io::{Input, ReadError, Reading};

pub use header::Header;
pub(crate) use meaning::{bandwidth_nm, left_over};
pub use meaning::{channels, values};
pub(crate) use pair::{header_at, place_of_data, read_header};

/// ENVI header or data.
pub(crate) const FORMAT: Format = Format {
    name: "ENVI",
    extensions: &[
        "hdr", "sli", "esl", "slb", "img", "bsq", "bil", "bip", "raw",
    ],
    sniff,
    read,
};

/// Extensions of data files that may be taken for text by their bytes.
const DATA_EXTENSIONS: [&str; 10] = [
    "sli", "esl", "slb", "img", "bsq", "bil", "bip", "raw", "dat", "bin",
];

fn sniff(input: &Input) -> Confidence {
    if is_header(input) {
        return Confidence::Certain;
    }
    let may_be_data = input.text().is_none()
        || !input.name.contains('.')
        || DATA_EXTENSIONS.iter().any(|e| input.has_extension(e));
    let has_header = || input.path.as_deref().and_then(pair::header_of).is_some();
    Confidence::certain_if(may_be_data && has_header())
}

fn is_header(input: &Input) -> bool {
    input.head().lines().next().map(str::trim) == Some("ENVI")
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let path = input.path.as_deref();
    let (header, name, data): (Header, String, Cow<[u8]>) = if is_header(input) {
        let header = header::parse(&input.name, &input.needs_text()?.text)?;
        let beside = said!("its data file beside it in the same folder");
        let path = path.ok_or_else(|| input.error(said!("an ENVI header by itself"), beside))?;
        let (name, bytes) = pair::data_of(path, &header)?;
        (header, name, bytes.into())
    } else {
        let header = path.and_then(pair::header_of).ok_or_else(|| {
            input.error(
                said!("ENVI data by itself"),
                said!("its header .hdr beside it"),
            )
        })?;
        let header = pair::read_header(&header)?;
        header.few_bytes()?;
        (header, input.name.clone(), input.bytes.into())
    };
    if header.is_library {
        let file_bytes = data.len() + input.bytes.len();
        library::read(&header, &data, &name, file_bytes, input)
    } else {
        image::read(&header, data.into_owned(), &name, &input.choices)
    }
}

/// The data file that would be read with the header at `path`; `None` when that is no header or
/// has no data beside it.
pub(crate) fn data_beside(path: &Path) -> Option<PathBuf> {
    if !pair::starts_as_header(path) {
        return None;
    }
    let header = pair::read_header(path).ok()?;
    // Data too large to be read whole are data all the same.
    pair::place_of_data(path, header.bytes()?)
}

/// The other file of a pair: a header's data, or the header of data.
pub(crate) fn pair_of(path: &Path) -> Option<PathBuf> {
    data_beside(path).or_else(|| pair::header_of(path))
}

/// The header of the library or cube whose header or data file is at `path`, for data small enough
/// to be read whole; the data are not read.
///
/// # Errors
/// [`ReadError`] when there is no header, or it is not right.
pub fn needs(path: &Path) -> Result<Header, ReadError> {
    let is_header = path
        .extension()
        .is_some_and(|e| e.eq_ignore_ascii_case("hdr"));
    let header_path = match is_header {
        true => Some(path.to_owned()),
        false => pair::header_of(path),
    };
    let header_path = header_path.ok_or_else(|| {
        let found = said!("no ENVI header beside it");
        let expected = said!("a header .hdr of the same name");
        ReadError::new(&name_of(path), found, expected)
    })?;
    let header = pair::read_header(&header_path)?;
    header.few_bytes()?;
    Ok(header)
}
