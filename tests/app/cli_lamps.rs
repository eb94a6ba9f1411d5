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
fn json_of_any_range_gives_the_light_back_on_it_and_another_range_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let (words, back) = (folder.path().join("e.json"), folder.path().join("e.csv"));
    for (range, [least, most]) in [("400:700", [400.0, 700.0]), ("360:830", [360.0, 830.0])] {
        let args = ["encode", "FL2", "--portable", "--range", range, "--json"];
        let encoded = json(&args);
        assert_eq!(encoded["range_nm"], serde_json::json!([least, most]));
        fs::write(&words, encoded.to_string()).expect("a file");
        let decode = ["decode", word(&words), "--out", word(&back), "--force"];
        let (code, _, err) = tell(&decode);
        assert_eq!(code, 0, "{err}");
        let reading = read_path(&back).expect("a spectrum");
        let table = &reading.spectra[0].samples;
        assert_eq!([table.first_nm(), table.last_nm()], [least, most]);
        // The lamp again, behind the blur of 10 nm as near as it said: sums over 50 nm are near.
        let lamp = Library::bundled().find("FL2").expect("a lamp");
        let lamp = &lamp.spectrum().expect("a table").samples;
        let band = Band::new(least, most).expect("a range");
        let [ours, theirs] = [table, lamp].map(|table| table.on_band(band, Outside::Zero));
        let whole: f64 = theirs.iter().sum();
        for (ours, theirs) in ours.chunks(50).zip(theirs.chunks(50)) {
            let [ours, theirs] = [ours, theirs].map(|part| part.iter().sum::<f64>());
            assert!((ours - theirs).abs() < 0.03 * whole, "{ours} {theirs}");
        }
        // The same range may be said, another may not.
        let same = [&decode[..], &["--range", range]].concat();
        assert_eq!(tell(&same).0, 0);
        let (err, code) = refusal(&[&decode[..], &["--range", "380:780"]].concat());
        assert_eq!(code, 2);
        assert!(
            err.contains(&format!("expected {least}-{most} nm")),
            "{err}"
        );
        // JSON of before says no range: it is 380-780 nm unless a person says another.
        let mut old = encoded.clone();
        old.as_object_mut().expect("an object").remove("range_nm");
        fs::write(&words, old.to_string()).expect("a file");
        assert_eq!(tell(&same).0, 0);
        let reading = read_path(&back).expect("a spectrum");
        assert_eq!(reading.spectra[0].samples.first_nm(), least);
        let read = json(&["decode", word(&words), "--json"]);
        assert_eq!(read["range_nm"], serde_json::json!([380.0, 780.0]));
        let mut odd = encoded;
        odd["range_nm"] = serde_json::json!([400, "red"]);
        fs::write(&words, odd.to_string()).expect("a file");
        let (err, code) = refusal(&decode);
        assert_eq!(code, 1);
        assert!(err.contains("\"range_nm\" with two whole nm"), "{err}");
    }
    let (_, _, err) = tell(&["encode", "FL2", "--portable", "--range", "400:700"]);
    assert!(
        err.contains("--range 400:700"),
        "words do not say it: {err}"
    );
}

#[test]
fn a_range_beyond_4000_nm_is_refused_for_words_and_race() {
    for command in [&["encode", "FL2"][..], &["race", "FL2", "--numbers", "11"]] {
        let (err, code) = refusal(&[command, &["--range", "0:4001"]].concat());
        assert_eq!(code, 2, "{err}");
        assert!(err.contains("at most 4000 nm"), "{err}");
    }
}

#[test]
fn a_known_lamp_itself_takes_six_numbers_however_many_it_may() {
    for lamp in ["FL2", "LED-B3"] {
        for numbers in ["11", "20", "41"] {
            let encoded = json(&["encode", lamp, "--numbers", numbers, "--json"]);
            // A label, the lamp and the four that make its colour exact.
            assert_eq!(encoded["numbers"], 6, "{encoded:#}");
            assert_eq!(encoded["strict_numbers"], 7);
            assert_eq!(encoded["lines"], Value::Array(Vec::new()));
            let off = |key: &str| encoded["error"][key].as_f64().expect("an error");
            // What counts as no error when an encoding is chosen.
            assert!(off("filters") < 2e-5 && off("relative_rms_10nm") < 1e-6);
            assert!(off("delta_e_own") < 1e-6);
        }
    }
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
fn the_strict_count_is_the_one_that_is_told() {
    let args = ["encode", "HP1", "--portable", "--strict", "--numbers", "20"];
    let told = json(&[&args[..], &["--json"]].concat());
    let count = |key: &str| told[key].as_array().expect("a list").len();
    let words = count("words");
    let lines = count("lines");
    assert!(lines > 0);
    // Each line's width is a number of its own.
    assert_eq!(told["strict_numbers"], words + lines);
    let (_, text, _) = tell(&args);
    let said = format!(
        "{} numbers, strictly counted ({words} words);",
        words + lines
    );
    assert!(text.contains(&said), "{text}");
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

#[cfg(unix)]
#[test]
fn a_fit_of_a_folder_is_not_written_onto_a_file_of_it_by_any_link() {
    let folder = tempfile::tempdir().expect("a folder");
    let (set, other) = (folder.path().join("set"), folder.path().join("other"));
    for path in [&set, &other] {
        fs::create_dir(path).expect("a folder");
    }
    let rows: String = (380..=480).map(|nm| format!("{nm},{nm}\n")).collect();
    for name in ["a.csv", "b.csv"] {
        fs::write(set.join(name), format!("nm,W\n{rows}")).expect("a table");
    }
    let (soft, hard) = (other.join("soft.csv"), other.join("hard.csv"));
    std::os::unix::fs::symlink(set.join("a.csv"), &soft).expect("a link");
    fs::hard_link(set.join("b.csv"), &hard).expect("a link");
    let around = set.join("../set/a.csv");
    let through = other.join("set");
    std::os::unix::fs::symlink(&set, &through).expect("a link");
    for input in [&set, &through] {
        for out in [
            &set.join("a.csv"),
            &through.join("b.csv"),
            &soft,
            &hard,
            &around,
        ] {
            let fit = ["fit", word(input), "--numbers", "5", "--out", word(out)];
            let (err, code) = refusal(&[&fit[..], &["--force"]].concat());
            assert_eq!(code, 1);
            assert!(err.contains("which is what is read"), "{err}");
        }
    }
    for name in ["a.csv", "b.csv"] {
        let text = fs::read_to_string(set.join(name)).expect("there");
        assert_eq!(text, format!("nm,W\n{rows}"));
    }
}

#[cfg(unix)]
#[test]
fn a_fit_of_40_001_points_takes_no_square_of_them() {
    let folder = tempfile::tempdir().expect("a folder");
    let table = folder.path().join("fine.csv");
    for (title, name) in [("W", "light.json"), ("reflectance", "surface.json")] {
        let value = |i: u32| 0.5 + 0.3 * (f64::from(i) / 5000.0).sin();
        let row = |i: u32| format!("{:.2},{}\n", 380.0 + 0.01 * f64::from(i), value(i));
        let rows: String = (0..=40_000).map(row).collect();
        fs::write(&table, format!("nm,{title}\n{rows}")).expect("a table");
        let out = folder.path().join(name);
        // A number for each pair of points would take 12.8 GB of the 2 that there are.
        let script = "ulimit -v 2000000; exec \"$0\" fit \"$1\" --out \"$2\"";
        let ran = std::process::Command::new("sh")
            .args(["-c", script, env!("CARGO_BIN_EXE_spectral-explorer")])
            .args([&table, &out])
            .output()
            .expect("a shell");
        let said = String::from_utf8_lossy(&ran.stderr);
        assert!(ran.status.success(), "{said}");
        let text = fs::read_to_string(&out).expect("numbers");
        let fitted: Value = serde_json::from_str(&text).expect("JSON");
        let off = fitted["spectra"][0]["relative_rms"].as_f64().expect("rms");
        assert!(off < 1e-3, "{off}");
    }
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
