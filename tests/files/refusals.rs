//! Any file: what decides its format, and what is none.

use std::path::Path;

use crate::told::{read, refusal};
use spectral_explorer::io::read_path;

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
