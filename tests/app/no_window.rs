//! A build without the window: what it does all the same, and how it refuses the rest.

use std::{ffi::OsString, fs};

use crate::plain::plain;
use spectral_explorer::cli::{self, Outcome};

/// What the command line makes of some words where nothing draws: result, output, errors.
fn tell(args: &[&str]) -> (Outcome, String, String) {
    let words = std::iter::once(&cli::PROGRAM).chain(args);
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let outcome = cli::run(words.map(OsString::from), None, &mut out, &mut err);
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    (outcome, text(out), text(err))
}

/// What [`cli::without_display`] says: exit code, output, errors.
fn instead(insist: bool) -> (u8, String, String) {
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let code = cli::without_display(&plain(), insist, None, &mut out, &mut err);
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    (code, text(out), text(err))
}

#[test]
fn pictures_of_the_window_are_refused_in_a_line_that_says_what_to_do() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.png");
    let path = path.to_str().unwrap();
    for command in ["render", "plot"] {
        let (outcome, out, err) = tell(&[command, "FL2", "--out", path]);
        assert_eq!(outcome, Outcome::Done(2), "{command}");
        assert!(out.is_empty() && err.lines().count() == 1, "{out}{err}");
        for part in ["without the window", "cargo build --release", ".svg"] {
            assert!(err.contains(part), "{command}: {err}");
        }
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn a_plot_as_svg_needs_no_window() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.svg");
    let (outcome, _, err) = tell(&["plot", "FL2", "--out", path.to_str().unwrap()]);
    assert_eq!((outcome, err.as_str()), (Outcome::Done(0), ""));
    assert!(fs::read_to_string(&path).unwrap().contains("<svg "));
}

#[test]
fn where_a_window_would_come_up_stands_the_report_and_a_word_about_it() {
    let (code, out, err) = instead(false);
    assert_eq!(code, 0);
    assert!(out.starts_with("FL11 (light"), "{out}");
    assert!(!out.contains("Picture"), "{out}");
    assert!(
        err.contains("no window") && err.lines().count() == 1,
        "{err}"
    );
}

#[test]
fn a_window_that_was_insisted_on_is_an_error() {
    let (code, out, err) = instead(true);
    assert_eq!((code, out.as_str()), (3, ""));
    assert!(err.contains("without the window"), "{err}");
    assert_eq!(err.lines().count(), 1);
}
