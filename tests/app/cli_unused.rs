//! Options that change nothing are told, and those that are not told change something.

use std::{fs, path::Path};

use crate::cli_pictures::wall;
use crate::tell::{refusal, tell};

/// What works: output and what was said.
fn told(args: &[&str]) -> [String; 2] {
    let (code, out, err) = tell(args);
    assert_eq!(code, 0, "{args:?}: {err}");
    [out, err]
}

fn is_told_unused(err: &str, option: &str) -> bool {
    err.contains(&format!(": {option} is not used: "))
}

/// A light with two lines and two dark lines.
fn notched(folder: &Path) -> String {
    let bell = |nm: f64, at: f64| (-((nm - at) / 2.0).powi(2)).exp();
    let value = |nm: f64| {
        100.0 - 60.0 * bell(nm, 589.0) - 40.0 * bell(nm, 486.0)
            + 80.0 * bell(nm, 546.0)
            + 20.0 * bell(nm, 405.0)
    };
    let rows = (380..=780).map(|nm| format!("{nm},{:.4}\n", value(f64::from(nm))));
    let text = format!("nm,irradiance (W/m2/nm)\n{}", rows.collect::<String>());
    let path = folder.join("notched.csv");
    fs::write(&path, text).expect("a file");
    path.to_str().expect("UTF-8").to_owned()
}

#[test]
fn each_option_of_the_model_changes_an_answer_or_is_told_to_change_none() {
    let folder = tempfile::tempdir().expect("a folder");
    let notched = notched(folder.path());
    let lights = [&notched[..], "FL2", "HP1", "paper/Mercury"];
    let options: [&[&str]; 12] = [
        &["--order", "3"],
        &["--threshold", "5"],
        &["--max-width", "3"],
        &["--basis", "fourier"],
        &["--plain"],
        &["--as-in-paper"],
        &["--no-spikes"],
        &["--wide-lines"],
        &["--dips"],
        &["--range", "500:700"],
        &["--observer", "1964"],
        &["--sampling", "paper"],
    ];
    for (command, more) in [
        ("report", &[][..]),
        ("prism", &[]),
        ("prism", &["--json"]),
        ("prism", &["--as-modelled", "--json"]),
        ("rainbow", &[]),
        ("product", &["red"]),
        ("product", &["red", "--check", "FL2"]),
        ("report", &["--no-spikes"]),
        ("prism", &["--no-spikes", "--at", "500", "--json"]),
    ] {
        for option in options.iter().filter(|option| !more.contains(&option[0])) {
            // Once told, an option changes nothing of any light.
            let mut changes = false;
            let mut is_told = false;
            for light in lights {
                let without = [&[command, light], more].concat();
                let [out, err] = told(&[&without, *option].concat());
                let is_same = told(&without)[0] == out;
                is_told = is_told_unused(&err, option[0]);
                assert!(is_same || !is_told, "{command} {light} {more:?} {option:?}");
                // A line's own width is told of where it is left out.
                changes |= !is_same || err.contains("--wide-lines: here");
                if changes {
                    break;
                }
            }
            assert!(changes || is_told, "{command} {more:?}: {option:?} ignored");
        }
    }
}

#[test]
fn what_a_command_goes_without_is_told_by_name() {
    let folder = tempfile::tempdir().expect("a folder");
    let sheet = folder.path().join("sheet.svg");
    let sheet = sheet.to_str().expect("UTF-8");
    let gem = ["gem", "--size", "16", "--rays", "1"];
    for (args, options) in [
        (
            &[
                "sweep", "FL2", "--basis", "cosine", "--plain", "--order", "3",
            ][..],
            &["--basis", "--plain", "--order 3"][..],
        ),
        (&["rainbow", "--at", "500", "--dips"], &["--dips"]),
        (&[&gem[..], &["--blocks", "8"]].concat(), &["--blocks"]),
        (
            &[&gem[..], &["--wavelength", "550", "--range", "400:700"]].concat(),
            &["--range"],
        ),
        (
            &[
                "plot", "FL2", "--out", sheet, "--sheet", "--size", "640x480", "--theme", "dark",
            ],
            &["--size", "--theme"],
        ),
        (
            &["mix", "--channel", "line:450", "--favour", "rf"],
            &["--favour"],
        ),
        (
            &["report", "FL2", "--column", "2", "--delimiter", "tab"],
            &["--column", "--delimiter"],
        ),
        (
            &["prism", "FL2", "--wavelength-unit", "um"],
            &["--wavelength-unit"],
        ),
    ] {
        let [_, err] = told(args);
        for option in options {
            assert!(is_told_unused(&err, option), "{args:?}: {option}: {err}");
        }
        let lines = err.lines().filter(|line| line.contains("is not used"));
        assert_eq!(lines.count(), options.len(), "{args:?}: {err}");
    }
}

#[test]
fn what_is_used_is_not_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let notched = notched(folder.path());
    for args in [
        &["report", &notched, "--column", "1", "--delimiter", "comma"][..],
        &["sweep", "FL2", "--basis", "cosine", "--json"],
        &["report", "FL2", "--plain", "--threshold", "2"],
        &[
            "mix",
            "--channel",
            "line:450",
            "--channel",
            "line:600",
            "--channel",
            "line:540",
            "--target",
            "4000K",
            "--favour",
            "rf",
        ],
    ] {
        let [_, err] = told(args);
        assert!(!err.contains("is not used"), "{args:?}: {err}");
    }
}

#[test]
fn a_raman_text_takes_a_delimiter_and_no_column() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("a.txt");
    let rows = "100.5\t10\n200.5\t20\n300.5\t30\n400.5\t40\n";
    let text = format!("Laser wavelength: 785 nm\nRaman shift (cm-1)\tIntensity\n{rows}");
    fs::write(&file, text).expect("a file");
    let file = file.to_str().expect("UTF-8");
    let [out, _] = told(&["read", file, "--delimiter", "tab", "--column", "1"]);
    assert!(!out.contains("the delimiter that was chosen"), "{out}");
    let unused = "the column that was chosen is not used: no plain table";
    assert!(out.contains(unused), "{out}");
}

#[test]
fn a_picture_of_surfaces_that_is_relit_needs_no_light_that_lit_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let wall = wall(folder.path());
    let place = |name: &str| folder.path().join(name).to_str().expect("UTF-8").to_owned();
    let (few, png) = (place("few.exr"), place("a.png"));
    told(&["picture", &wall, "--numbers", "9", "--out", &few]);
    let relit = ["picture", &few, "--relight", "CIE A", "--out", &png];
    let [_, err] = told(&[&relit[..], &["--light", "FL2"]].concat());
    assert!(is_told_unused(&err, "--light"), "{err}");
    for (input, code, part) in [
        (
            "wall",
            1,
            "wall: found the wall of paints, which has every wavelength",
        ),
        ("none.exr", 1, "none.exr: found no such file"),
    ] {
        let (err, found) = refusal(&[
            "picture",
            input,
            "--relight",
            "FL2",
            "--out",
            &place("b.png"),
        ]);
        assert_eq!(found, code);
        assert!(err.contains(part), "{err}");
    }
}
