//! Pictures in few numbers on the command line: kept, shown under another light, refused; and
//! tables of spectra fitted.

use std::{fs, path::Path};

use serde_json::Value;
use spectral_explorer::pictures::{Pixels, Scene};

use crate::tell::{json, refusal, tell};

/// A wall of paints of 31 bands as an ENVI cube; the path of its header.
pub fn wall(folder: &Path) -> String {
    let nm: Vec<f64> = (0..31).map(|j| 400.0 + 10.0 * f64::from(j)).collect();
    let scene = Scene::reflectance(48, 32, nm.clone()).expect("a scene");
    let mut values = vec![0.0_f32; 48 * 32 * 31];
    scene.rows(0, 32, &mut values).expect("rows");
    let bytes: Vec<u8> = values.iter().flat_map(|v| v.to_le_bytes()).collect();
    fs::write(folder.join("wall.img"), bytes).expect("data");
    let list: Vec<String> = nm.iter().map(f64::to_string).collect();
    let header = format!(
        "ENVI\nsamples = 48\nlines = 32\nbands = 31\nheader offset = 0\ndata type = 4\n\
         interleave = bsq\nbyte order = 0\nwavelength units = Nanometers\n\
         reflectance scale factor = 1\nwavelength = {{{}}}\n",
        list.join(", ")
    );
    let path = folder.join("wall.hdr");
    fs::write(&path, header).expect("a header");
    word(&path).to_owned()
}

fn word(path: &Path) -> &str {
    path.to_str().expect("UTF-8")
}

#[test]
fn more_numbers_are_off_by_less_and_take_more_bytes() {
    let folder = tempfile::tempdir().expect("a folder");
    let wall = wall(folder.path());
    let kept = |numbers: &str| json(&["picture", &wall, "--numbers", numbers, "--json"]);
    let (few, many) = (kept("5"), kept("15"));
    assert_eq!([&few["numbers"], &many["numbers"]], [5, 15]);
    let rms = |json: &Value| json["error"]["relative_rms"].as_f64().expect("a figure");
    assert!(rms(&many) < rms(&few));
    let full = |json: &Value| json["bytes"]["full"].as_u64().expect("bytes");
    assert!(full(&many) > full(&few));
}

#[test]
fn both_forms_are_written_and_seen_under_another_light() {
    let folder = tempfile::tempdir().expect("a folder");
    let wall = wall(folder.path());
    for name in ["wall.exr", "wall.cspx.png"] {
        let file = folder.path().join(name);
        let (code, out, err) = tell(&["picture", &wall, "--numbers", "9", "--out", word(&file)]);
        assert_eq!(code, 0, "{err}");
        assert!(out.contains("Wrote "), "{out}");
        let relit = folder.path().join(format!("{name}.relit.png"));
        let args = [
            "picture",
            word(&file),
            "--relight",
            "CIE A",
            "--out",
            word(&relit),
        ];
        let (code, out, err) = tell(&args);
        assert_eq!(code, 0, "{err}");
        assert!(out.contains("48 x 32 px, under CIE A"), "{out}");
        assert!(!err.is_empty(), "how far to trust it");
        assert!(fs::read(&relit).expect("a picture").starts_with(b"\x89PNG"));
        assert!(refusal(&args).0.contains("--force"));
    }
}

#[test]
fn a_bound_is_kept_or_it_is_said_that_it_is_not() {
    let folder = tempfile::tempdir().expect("a folder");
    let wall = wall(folder.path());
    let (code, _, err) = tell(&["picture", &wall, "--bound", "2", "--json"]);
    assert_eq!((code, err.as_str()), (0, ""));
}

#[test]
fn what_cannot_be_kept_is_refused_in_one_line() {
    let folder = tempfile::tempdir().expect("a folder");
    let wall = wall(folder.path());
    for (more, part) in [
        (&["--numbers", "2"][..], "--numbers: expected 3 to 30"),
        (&["--numbers", "31"], "--numbers: expected 3 to 30"),
        (
            &["--numbers", "9", "--lines", "900"],
            "--lines: expected a line between",
        ),
        (&["--numbers", "9", "--bound", "1"], "expected one of them"),
        (&["--lines", "auto"], "--numbers"),
        (&["--out", "a.jpg"], ".png or .exr"),
    ] {
        let (err, code) = refusal(&[&["picture", &wall], more].concat());
        assert_eq!(code, 2, "{more:?}: {err}");
        assert!(err.contains(part), "{more:?}: {err}");
    }
    let (err, code) = refusal(&["picture", "nothing.exr"]);
    assert_eq!(code, 1, "{err}");
    let out = folder.path().join("a.png");
    let (err, code) = refusal(&["picture", &wall, "--relight", "CIE A", "--out", word(&out)]);
    assert_eq!(code, 1, "{err}");
}

#[test]
fn a_table_becomes_a_row_of_numbers_for_each_spectrum() {
    let folder = tempfile::tempdir().expect("a folder");
    let table = folder.path().join("lamps.csv");
    let rows: String = (380..=780)
        .map(|nm| {
            let x = f64::from(nm) / 100.0;
            format!("{nm},{},{}\n", 1.0 + x.sin(), 2.0 + x.cos())
        })
        .collect();
    fs::write(&table, format!("nm,one,two\n{rows}")).expect("a table");
    for name in ["numbers.csv", "numbers.json"] {
        let out = folder.path().join(name);
        let args = ["fit", word(&table), "--numbers", "9", "--out", word(&out)];
        let (code, told, err) = tell(&args);
        assert_eq!(code, 0, "{err}");
        assert!(told.contains("2 spectra in 9 numbers each"), "{told}");
        let text = fs::read_to_string(&out).expect("numbers");
        assert!(text.contains("one") && text.contains("two"), "{text}");
        assert!(refusal(&args).0.contains("--force"));
    }
    let (err, code) = refusal(&["fit", word(&table)]);
    assert_eq!(code, 2);
    assert!(err.contains("found no --out"), "{err}");
}

#[test]
fn of_a_folder_every_spectrum_of_its_files_is_a_row() {
    let folder = tempfile::tempdir().expect("a folder");
    let lamps = folder.path().join("lamps");
    fs::create_dir(&lamps).expect("a folder");
    for (name, head) in [("a.csv", "nm,one,two"), ("b.csv", "nm,three,four")] {
        let rows: String = (380..=780)
            .map(|nm| {
                let x = f64::from(nm) / 100.0;
                format!("{nm},{},{}\n", 1.0 + x.sin(), 2.0 + x.cos())
            })
            .collect();
        fs::write(lamps.join(name), format!("{head}\n{rows}")).expect("a table");
    }
    fs::write(lamps.join("notes.md"), "no spectrum at all").expect("a file");
    let out = folder.path().join("numbers.csv");
    let args = ["fit", word(&lamps), "--numbers", "9", "--out", word(&out)];
    let (code, told, err) = tell(&args);
    assert_eq!(code, 0, "{err}");
    assert!(told.contains("4 spectra in 9 numbers each"), "{told}");
    assert!(err.contains("skipped") && err.contains("notes.md"), "{err}");
    let text = fs::read_to_string(&out).expect("numbers");
    for name in ["one", "two", "three", "four"] {
        assert!(text.contains(name), "{text}");
    }
}
