//! Formats that are known by their content and not read: refused by their name.

use super::{Confidence, Format};
use crate::io::decode::archive::names;
use crate::io::{Input, ReadError, Reading};
use crate::languages::said;

/// Recognises files of other kinds so that they are refused in plain words.
pub(crate) const FORMAT: Format =
    Format::new(later!("a format that is not read"), &[], sniff, read);

/// Expectations in refusals: ways to obtain a readable file.
const AS_CSV: &str = later!("a format that is read; save it as CSV or text first");
const FROM_MAKER: &str = later!(
    "a format that is read; export it as CSV, text or JCAMP-DX from the program that wrote it"
);
const WITH_HEADER: &str = later!("a header .hdr of the same name beside it");
const A_SPECTRUM: &str = later!("a file with a spectrum");

/// First bytes of known files, the type of file, and the input expected instead.
const MAGIC: [(&[u8], &str, &str); 12] = [
    (b"\x89PNG\r\n\x1a\n", later!("a PNG image"), A_SPECTRUM),
    (b"\xff\xd8\xff", later!("a JPEG image"), A_SPECTRUM),
    (b"%PDF-", later!("a PDF document"), AS_CSV),
    (
        b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1",
        later!("an old Microsoft Office file (.xls, .doc)"),
        AS_CSV,
    ),
    (b"II*\0", later!("a TIFF image"), A_SPECTRUM),
    (b"MM\0*", later!("a TIFF image"), A_SPECTRUM),
    (b"GIF8", later!("a GIF image"), A_SPECTRUM),
    (b"\x89HDF\r\n\x1a\n", later!("an HDF5 file"), AS_CSV),
    (
        b"\n\n\xfe\xfe",
        later!("a Bruker OPUS binary spectrum"),
        FROM_MAKER,
    ),
    (
        b"AVS8",
        later!("an AvaSoft 8 binary spectrum (.RFL8, .IRR8, ...)"),
        FROM_MAKER,
    ),
    (
        b"PEPE",
        later!("a PerkinElmer binary spectrum (.sp)"),
        FROM_MAKER,
    ),
    (
        b"\x1f\x8b",
        later!("a gzip archive"),
        later!("the file inside it"),
    ),
];

fn sniff(input: &Input) -> Confidence {
    Confidence::certain_if(known(input).is_some())
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let (found, expected) = known(input).unwrap_or((later!("binary data"), A_SPECTRUM));
    Err(input.error(said(found), said(expected)))
}

/// The type of the file, and the input expected instead.
fn known(input: &Input) -> Option<(&'static str, &'static str)> {
    known_by_magic(input).or_else(|| match input.text() {
        Some(_) => known_text(input),
        None => Some(known_binary(input)),
    })
}

fn known_by_magic(input: &Input) -> Option<(&'static str, &'static str)> {
    let bytes = input.bytes;
    if bytes.starts_with(b"PK\x03\x04") || bytes.starts_with(b"PK\x05\x06") {
        return Some(if names(bytes, "opendocument.spreadsheet") {
            (later!("an OpenDocument table (.ods)"), AS_CSV)
        } else if names(bytes, "word/document.xml") {
            (later!("a Word document"), AS_CSV)
        } else {
            (later!("a zip archive"), later!("the file inside it"))
        });
    }
    let magic = MAGIC.iter().find(|(magic, ..)| bytes.starts_with(magic));
    if let Some(&(_, found, expected)) = magic {
        return Some((found, expected));
    }
    if is_asd(bytes) {
        return Some((later!("an ASD binary spectrum (.asd)"), FROM_MAKER));
    }
    is_galactic(input).then_some((later!("a Galactic .spc spectrum"), FROM_MAKER))
}

/// ASD's files begin with the version of their layout, "ASD" at first, later "as2" to "as8", and
/// hold numbers after it.
fn is_asd(bytes: &[u8]) -> bool {
    let version = matches!(bytes, [b'a', b's', b'2'..=b'9', ..]) || bytes.starts_with(b"ASD");
    version && bytes[..bytes.len().min(512)].contains(&0)
}

/// Galactic files have no magic: the second byte is the version, 0x4B or 0x4D.
fn is_galactic(input: &Input) -> bool {
    input.has_extension("spc")
        && input.text().is_none()
        && matches!(input.bytes.get(1), Some(0x4b..=0x4d))
}

fn known_binary(input: &Input) -> (&'static str, &'static str) {
    let envi = ["sli", "esl", "bil", "bip", "bsq", "img"];
    if envi.iter().any(|e| input.has_extension(e)) {
        (later!("ENVI data without their header"), WITH_HEADER)
    } else {
        (later!("binary data of no kind known here"), A_SPECTRUM)
    }
}

fn known_text(input: &Input) -> Option<(&'static str, &'static str)> {
    let head = input.head();
    let first = input.first_line().trim();
    let lower = head.get(..head.floor_char_boundary(512))?.to_lowercase();
    let starts = |words: &[&str]| words.iter().any(|word| lower.starts_with(word));
    let spdx = ["SPDXVersion", "spdxVersion", "spdx.org/rdf"];
    if spdx.iter().any(|word| head.contains(word)) {
        let expected = later!("an IES TM-27 .spdx spectrum");
        Some((later!("an SPDX software licence document"), expected))
    } else if starts(&["<!doctype html", "<html", "<br"]) {
        Some((later!("a web page (HTML)"), A_SPECTRUM))
    } else if starts(&["<svg"]) || lower.contains("<svg ") && starts(&["<?xml"]) {
        Some((later!("an SVG drawing"), A_SPECTRUM))
    } else if first.trim_start_matches('"').starts_with("TOA5") {
        Some((later!("a data logger's table over time (TOA5)"), A_SPECTRUM))
    } else if first.starts_with("{\\rtf") {
        Some((later!("a rich text document (.rtf)"), AS_CSV))
    } else {
        None
    }
}
