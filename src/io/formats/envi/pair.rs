//! The two files of an ENVI pair: finding and reading the other one.

use std::io::Read;
use std::path::{Path, PathBuf};

use super::header::{self, Header};
use crate::io::input::name_of;
use crate::io::text::{self, MOST_BYTES};
use crate::io::{ReadError, budget, disk};

/// Endings of data files, in the order of the search.
const DATA_ENDINGS: [&str; 15] = [
    "", ".sli", ".esl", ".slb", ".img", ".dat", ".bsq", ".bil", ".bip", ".raw", ".bin", ".cube",
    ".hyspex", ".lib", ".spc",
];

/// Most bytes of a header.
const MOST_HEADER_BYTES: u64 = 64 << 20;

/// The ENVI header that belongs to a data file: `a.sli.hdr` or `a.hdr` beside `a.sli`.
pub(crate) fn header_of(data: &Path) -> Option<PathBuf> {
    [
        longer(data, ".hdr"),
        data.with_extension("hdr"),
        longer(data, ".HDR"),
        data.with_extension("HDR"),
    ]
    .into_iter()
    .find(|path| path != data && disk::is_file(path) && starts_as_header(path))
}

/// The ENVI header that a path is, or that belongs to it.
pub(crate) fn header_at(path: &Path) -> Option<PathBuf> {
    match starts_as_header(path) {
        true => Some(path.to_owned()),
        false => header_of(path),
    }
}

/// A path with more behind it.
fn longer(path: &Path, ending: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(ending);
    name.into()
}

/// True if a file begins like an ENVI header.
pub(crate) fn starts_as_header(path: &Path) -> bool {
    let start = disk::head(path, 8);
    let start = start.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&start);
    start.starts_with(b"ENVI")
}

/// Reads a header from disk.
///
/// # Errors
/// [`ReadError`] when it cannot be read or is not right.
pub(crate) fn read_header(path: &Path) -> Result<Header, ReadError> {
    let name = name_of(path);
    let bytes = read_file(path, MOST_HEADER_BYTES, said!("at most 64 MiB in a header"))?;
    header::parse(&name, &text::decode(&bytes).text)
}

/// The data that belong to a header, and their file's name.
///
/// # Errors
/// [`ReadError`] if the file is missing or cannot be read.
pub(super) fn data_of(path: &Path, header: &Header) -> Result<(String, Vec<u8>), ReadError> {
    let chosen = place_of_data(path, header.few_bytes()?).ok_or_else(|| {
        ReadError::new(
            &header.file,
            said!("an ENVI header by itself"),
            tr!(
                "its data beside it ({file} with an ending such as .sli, .img, .bsq, or none)",
                file = name_of(&path.with_extension(""))
            ),
        )
    })?;
    let bytes = read_file(&chosen, MOST_BYTES, said!("at most 512 MiB in one file"))?;
    Ok((name_of(&chosen), bytes))
}

/// The data file beside a header of which `need` bytes are announced. Of several files with
/// fitting names the first that is large enough is taken.
pub(crate) fn place_of_data(path: &Path, need: usize) -> Option<PathBuf> {
    let stem = path.with_extension("");
    let candidates = DATA_ENDINGS
        .iter()
        .flat_map(|ending| [longer(&stem, ending), longer(&stem, &ending.to_uppercase())]);
    let mut there = candidates.filter(|candidate| candidate != path && disk::is_file(candidate));
    let first = there.next()?;
    let large = |path: &PathBuf| disk::len(path).is_ok_and(|len| len >= need as u64);
    Some(if large(&first) {
        first
    } else {
        there.find(large).unwrap_or(first)
    })
}

fn read_file(path: &Path, most: u64, at_most: &str) -> Result<Vec<u8>, ReadError> {
    let name = name_of(path);
    let trouble = |error: std::io::Error| {
        ReadError::new(&name, error.to_string(), said!("a file that can be read"))
    };
    let size = disk::len(path).map_err(trouble)?;
    if size > most {
        let found = budget::in_words(usize::try_from(size).unwrap_or(usize::MAX));
        return Err(ReadError::new(&name, found, at_most));
    }
    let mut bytes = Vec::with_capacity(size as usize);
    disk::open(path)
        .map_err(trouble)?
        .take(most)
        .read_to_end(&mut bytes)
        .map_err(trouble)?;
    Ok(bytes)
}
