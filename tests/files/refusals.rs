//! Any file: what decides its format, and what is none.

use std::path::Path;

use crate::told::{read, refusal};
use spectral_explorer::io::{MOST_BYTES_OF_A_FORMAT, ReadError, quoted, read_path, shown};

#[test]
fn the_content_decides_and_not_the_extension() {
    let reading = read("lamp.xlsx", "380\t0.5\n385\t0.6\n390\t0.7\n");
    assert_eq!(reading.format, "plain columns");
    assert_eq!(reading.spectra[0].samples.values(), [0.5, 0.6, 0.7]);
}

#[test]
fn nothing_and_a_folder_are_refused_in_words() {
    let empty = refusal("a.csv", "");
    assert_eq!(empty, "a.csv: found an empty file, expected a spectrum");
    let folder = tempfile::tempdir().unwrap();
    let why = |path: &Path| read_path(path).unwrap_err().to_string();
    let said = why(folder.path());
    assert!(said.contains("expected a file"), "{said}");
    let device = cfg!(unix).then(|| why(Path::new("/dev/zero")));
    assert!(device.is_none_or(|said| said == "zero: found a device, expected a file"));
    let place = folder.path().display();
    assert_eq!(
        why(&folder.path().join("none.csv")),
        format!("none.csv: found no such file in {place}, expected a file that exists")
    );
    assert_eq!(
        why(Path::new("/nope/x.csv")),
        "x.csv: found no folder /nope, expected a file that exists"
    );
}

#[test]
fn a_refusal_is_one_printable_line_with_file_line_found_and_expected() {
    let mut error = ReadError::new("lamp.csv", quoted("abc"), "a number in column 2");
    error.line = Some(12);
    assert_eq!(
        error.to_string(),
        "lamp.csv, line 12: found \"abc\", expected a number in column 2"
    );
    let garbage = "a\u{0}\n\u{202e}".to_owned() + &"x".repeat(500);
    let shown = ReadError::new("odd\nname.txt", quoted(&garbage), "text").to_string();
    assert!(!shown.contains(|c: char| c.is_control() || c == '\u{202e}'));
    assert!(shown.chars().count() < 120, "{shown}");
    assert!(shown.starts_with("odd·name.txt: found \"a···xxx"));
}

#[test]
fn a_file_is_named_by_its_path_where_two_may_have_one_name() {
    let error = ReadError::new("x.csv", "nothing", "something");
    let at = |path: &str| error.clone().at(Path::new(path)).to_string();
    assert!(at("a/x.csv").starts_with("a/x.csv: found"));
    // What is said of the other file of a pair is not said of this one.
    assert!(at("a/x.hdr").starts_with("x.csv: found"));
    let odd = shown(Path::new("a/\u{1b}[31m\nx.csv"));
    assert_eq!(odd, "a/\\u{1b}[31m\\nx.csv");
}

#[test]
fn a_text_larger_than_any_instrument_writes_is_refused_by_its_size() {
    let mut bytes = b"##TITLE= a\n##JCAMP-DX= 4.24\n".to_vec();
    bytes.resize(MOST_BYTES_OF_A_FORMAT + 1, b' ');
    assert_eq!(
        refusal("a.dx", &bytes),
        "a.dx: found more than 64 MiB, expected at most 64 MiB in an instrument's own format"
    );
}
