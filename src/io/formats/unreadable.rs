//! Formats that are known by their content and not read: refused by their name.

use super::{Confidence, Format};
use crate::io::{Input, ReadError, Reading};

/// Recognises files of other kinds so that they are refused in plain words.
pub(crate) const FORMAT: Format = Format {
    name: "a format that is not read",
    extensions: &[],
    sniff,
    read,
};

/// What a person can do instead.
const AS_CSV: &str = "a format that is read; save it as CSV or text first";
const FROM_MAKER: &str =
    "a format that is read; export it as CSV, text or JCAMP-DX from the program that wrote it";
const WITH_HEADER: &str = "a header .hdr of the same name beside it";
const A_SPECTRUM: &str = "a file with a spectrum";

fn sniff(input: &Input) -> Confidence {
    if known(input).is_some() {
        Confidence::Certain
    } else {
        Confidence::No
    }
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let (found, expected) = known(input).unwrap_or(("binary data", A_SPECTRUM));
    Err(input.error(found, expected))
}

/// What the file is, and what was expected instead.
fn known(input: &Input) -> Option<(&'static str, &'static str)> {
    known_by_magic(input).or_else(|| match input.text() {
        Some(_) => known_text(input),
        None => Some(known_binary(input)),
    })
}

fn known_by_magic(input: &Input) -> Option<(&'static str, &'static str)> {
    let bytes = input.bytes;
    let starts = |magic: &[u8]| bytes.starts_with(magic);
    if starts(b"PK\x03\x04") || starts(b"PK\x05\x06") {
        return Some(zip(input));
    }
    let (found, expected) = if starts(b"\x89PNG\r\n\x1a\n") {
        ("a PNG image", A_SPECTRUM)
    } else if starts(b"\xff\xd8\xff") {
        ("a JPEG image", A_SPECTRUM)
    } else if starts(b"%PDF-") {
        ("a PDF document", AS_CSV)
    } else if starts(b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1") {
        ("an old Microsoft Office file (.xls, .doc)", AS_CSV)
    } else if starts(b"II*\0") || starts(b"MM\0*") {
        ("a TIFF image", A_SPECTRUM)
    } else if starts(b"GIF8") {
        ("a GIF image", A_SPECTRUM)
    } else if starts(b"\x89HDF\r\n\x1a\n") {
        ("an HDF5 file", AS_CSV)
    } else if is_asd(bytes) {
        ("an ASD binary spectrum (.asd)", FROM_MAKER)
    } else if starts(b"\n\n\xfe\xfe") {
        ("a Bruker OPUS binary spectrum", FROM_MAKER)
    } else if starts(b"AVS8") {
        (
            "an AvaSoft 8 binary spectrum (.RFL8, .IRR8, ...)",
            FROM_MAKER,
        )
    } else if starts(b"PEPE") {
        ("a PerkinElmer binary spectrum (.sp)", FROM_MAKER)
    } else if starts(b"\x1f\x8b") {
        ("a gzip archive", "the file inside it")
    } else if is_galactic(input) {
        ("a Galactic .spc spectrum", FROM_MAKER)
    } else {
        return None;
    };
    Some((found, expected))
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

/// A zip archive, told by the names of its first members.
fn zip(input: &Input) -> (&'static str, &'static str) {
    let head = &input.bytes[..input.bytes.len().min(1 << 16)];
    let tail = &input.bytes[input.bytes.len().saturating_sub(1 << 16)..];
    let holds = |name: &[u8]| {
        [head, tail]
            .iter()
            .any(|part| part.windows(name.len()).any(|w| w == name))
    };
    if holds(b"opendocument.spreadsheet") {
        ("an OpenDocument table (.ods)", AS_CSV)
    } else {
        ("a zip archive", "the file inside it")
    }
}

fn known_binary(input: &Input) -> (&'static str, &'static str) {
    let envi = ["sli", "esl", "bil", "bip", "bsq", "img"];
    if envi.iter().any(|e| input.has_extension(e)) {
        ("ENVI data without their header", WITH_HEADER)
    } else {
        ("binary data of no kind known here", A_SPECTRUM)
    }
}

fn known_text(input: &Input) -> Option<(&'static str, &'static str)> {
    let head = input.head();
    let first = head.lines().next().unwrap_or("").trim();
    let lower = head.get(..head.floor_char_boundary(512))?.to_lowercase();
    let (found, expected) = if head.contains("SPDXVersion")
        || head.contains("spdxVersion")
        || head.contains("spdx.org/rdf")
    {
        (
            "an SPDX software licence document",
            "an IES TM-27 .spdx spectrum",
        )
    } else if lower.starts_with("<!doctype html")
        || lower.starts_with("<html")
        || lower.starts_with("<br")
    {
        ("a web page (HTML)", A_SPECTRUM)
    } else if lower.starts_with("<svg") || lower.contains("<svg ") && lower.starts_with("<?xml") {
        ("an SVG drawing", A_SPECTRUM)
    } else if first.trim_start_matches('"').starts_with("TOA5") {
        ("a data logger's table over time (TOA5)", A_SPECTRUM)
    } else if first.starts_with("{\\rtf") {
        ("a rich text document (.rtf)", AS_CSV)
    } else {
        return None;
    };
    Some((found, expected))
}

#[cfg(test)]
mod tests {
    use crate::io::read_bytes;

    #[test]
    fn files_of_other_kinds_are_refused_by_name() {
        for (name, bytes, words) in [
            ("a.zip", b"PK\x03\x04....".as_slice(), "zip archive"),
            ("a.png", b"\x89PNG\r\n\x1a\n", "PNG"),
            ("a.jpg", b"\xff\xd8\xff\xe0", "JPEG"),
            ("a.pdf", b"%PDF-1.7", "PDF"),
            ("a.spc", b"\0\x4b\x01\x02\x03\x04\x05\x06\0", "Galactic"),
            ("a.sli", b"\0\x01\x02\x03\x04\x05\x06\0\0", "ENVI"),
            ("a.spdx", b"SPDXVersion: SPDX-2.3\n", "software licence"),
            ("a.dx", b"<br />\n<b>Warning</b>", "web page"),
            ("a.asd", b"as7\0\0\x01\0\0", "ASD binary"),
            ("a.0", b"\n\n\xfe\xfe\x01\0\0\0", "OPUS"),
            ("a.IRR8", b"AVS84\x01\0\0\0", "AvaSoft"),
            (
                "a.dat",
                b"\"TOA5\",\"CR6\"\n\"TS\",1\n\"x\",2\n",
                "data logger",
            ),
            ("a", b"\x01\x02\x03\x04\x05", "binary data"),
        ] {
            let refusal = read_bytes(name, bytes).unwrap_err().to_string();
            assert!(refusal.contains(words), "{refusal}");
            assert!(refusal.starts_with(&format!("{name}: found")), "{refusal}");
        }
    }
}
