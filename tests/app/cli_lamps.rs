//! Encoding and decoding on the command line: what goes round, and what is refused.

use std::{fs, path::Path};

use serde_json::Value;
use spectral_explorer::{
    app::Library,
    io::read_path,
    spectrum::{Band, Outside},
};

use crate::tell::{json, refusal, tell};

fn word(path: &Path) -> &str {
    path.to_str().expect("UTF-8")
}

#[test]
fn a_light_goes_round_by_its_words_or_by_the_json() {
    let folder = tempfile::tempdir().expect("a folder");
    let encoded = json(&["encode", "FL11", "--numbers", "31", "--json"]);
    let words: Vec<&str> = encoded["words"]
        .as_array()
        .expect("words")
        .iter()
        .filter_map(Value::as_str)
        .collect();
    assert!(words.len() <= 31);
    let file = folder.path().join("fl11.json");
    fs::write(&file, encoded.to_string()).expect("a file");
    let by_file = folder.path().join("file.csv");
    let (code, out, err) = tell(&["decode", word(&file), "--out", word(&by_file)]);
    assert_eq!(code, 0, "{err}");
    assert!(
        out.starts_with("Wrote ") && out.contains(" number"),
        "{out}"
    );
    let by_words = folder.path().join("words.csv");
    let args = [&["decode"], &words[..], &["--out", word(&by_words)]].concat();
    assert_eq!(tell(&args).0, 0);
    let values = |path: &Path| {
        let reading = read_path(path).expect("a spectrum");
        reading.spectra[0]
            .samples
            .on_band(Band::VISIBLE, Outside::Zero)
    };
    assert_eq!(values(&by_file), values(&by_words));
    // As far from the lamp as the encoder said: behind a 10 nm blur, so the sums are near.
    let lamp = Library::bundled().find("FL11").expect("a lamp");
    let lamp = lamp
        .spectrum()
        .expect("a table")
        .samples
        .on_band(Band::VISIBLE, Outside::Zero);
    let sum = |values: &[f64]| values.iter().sum::<f64>();
    assert!((sum(&values(&by_file)) / sum(&lamp) - 1.0).abs() < 0.02);
}

#[test]
fn who_has_no_list_of_lamps_gets_none() {
    let (_, _, err) = tell(&["encode", "FL2"]);
    assert!(err.contains("the program's list of known lamps"), "{err}");
    let encoded = json(&["encode", "FL2", "--portable", "--json"]);
    assert_eq!(encoded["atoms"], Value::Array(Vec::new()));
    assert_eq!(tell(&["encode", "FL2", "--portable"]).2, "");
}

#[test]
fn the_strict_count_takes_no_more_words() {
    let words = |more: &[&str]| {
        let args = [&["encode", "FL2", "--numbers", "20", "--json"], more].concat();
        json(&args)["words"].as_array().expect("words").len()
    };
    assert!(words(&["--strict"]) <= words(&[]) && words(&[]) <= 20);
}

#[test]
fn what_cannot_be_encoded_is_refused_in_one_line() {
    for (args, code, part) in [
        (
            &["FL2", "--numbers", "65"][..],
            2,
            "--numbers: expected 3 to 64, found 65",
        ),
        (
            &["FL2", "--numbers", "2"],
            2,
            "--numbers: expected 3 to 64, found 2",
        ),
        (&["FL2", "--numbers", "x"], 2, "--numbers: found \"x\""),
        (
            &["FL2", "--range", "900:1000"],
            2,
            "expected a range that holds the visible",
        ),
        (
            &["colorchecker_ohta/red"],
            1,
            "expected a light (say --kind)",
        ),
        (&["no such lamp"], 1, "no shipped spectrum is called"),
    ] {
        let (err, found) = refusal(&[&["encode"], args].concat());
        assert_eq!(found, code, "{args:?}: {err}");
        assert!(err.contains(part), "{args:?}: {err}");
    }
}

#[test]
fn a_light_too_faint_for_words_is_refused_and_a_little_brighter_is_encoded() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("faint.csv");
    let encode = |scale: f64| {
        let value = |i: usize| scale * (1.0 + 0.01 * i as f64);
        let rows = (0..81).map(|i| format!("{},{:e}\n", 380 + 5 * i, value(i)));
        fs::write(&file, rows.collect::<String>()).expect("a file");
        tell(&["encode", word(&file), "--json"])
    };
    for scale in [1e-50, 1e-300] {
        let (code, out, err) = encode(scale);
        assert_eq!((code, out.as_str()), (1, ""), "{err}");
        assert!(err.contains("expected values that reach 1e-36"), "{err}");
    }
    let (code, out, err) = encode(1e-36);
    assert_eq!(code, 0, "{err}");
    let told: serde_json::Value = serde_json::from_str(&out).expect("JSON");
    let off = told["error"]["relative_rms_10nm"]
        .as_f64()
        .expect("an error");
    assert!(off < 0.01, "{off}");
}

#[test]
fn what_is_no_encoding_is_refused_in_one_line() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("a.csv");
    let there = folder.path().join("there.csv");
    fs::write(&there, "380,1\n").expect("a file");
    let words = tell(&["encode", "FL2"]).1;
    let words = words.lines().next().expect("words");
    for (args, code, part) in [
        (
            &["cheese", "--out", word(&out)][..],
            1,
            "eight hexadecimal digits",
        ),
        (&[words], 2, "found neither --out nor --json"),
        (&[words, "--out", "a.png"], 2, "--out: found \"a.png\""),
        (&[words, "--out", word(&there)], 1, "--force"),
        (&[word(&there), "--json"], 1, "there.csv"),
    ] {
        let (err, found) = refusal(&[&["decode"], args].concat());
        assert_eq!(found, code, "{args:?}: {err}");
        assert!(err.contains(part), "{args:?}: {err}");
    }
    assert_eq!(
        tell(&["decode", words, "--out", word(&there), "--force"]).0,
        0
    );
    assert!(!out.exists());
}
