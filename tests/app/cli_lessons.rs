//! `lessons`: the list, checks with file and step, sheets for a class, and the document that builds
//! one.

use std::{ffi::OsString, fs};

use serde_json::Value;
use spectral_explorer::{
    app::lessons::{figures, shelf},
    cli::{self, Outcome},
};

use crate::docs::{document, quoted, rows, section};

/// Exit code, what was printed, and what was said.
fn tell(args: &[&str]) -> (u8, String, String) {
    let words = [cli::PROGRAM, "lessons"];
    let words = words.iter().chain(args).map(OsString::from);
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let Outcome::Done(code) = cli::run(words, None, &mut out, &mut err) else {
        panic!("{args:?} opens a window");
    };
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    (code, text(out), text(err))
}

#[test]
fn another_act_is_answered_by_those_that_there_are() {
    for args in [&["foo"][..], &["foo", "waves"]] {
        let (code, out, err) = tell(args);
        assert_eq!((code, out.as_str()), (2, ""));
        let line = "ACT: found \"foo\", expected check or handout\n";
        assert!(err.ends_with(line), "{err}");
    }
}

#[test]
fn lessons_are_listed_with_minutes_audience_and_steps() {
    let (code, words, _) = tell(&[]);
    assert_eq!((code, words.lines().count()), (0, shelf::FILES.len()));
    let (_, json, _) = tell(&["--json"]);
    let list: Vec<Value> = serde_json::from_str(&json).expect("JSON");
    for (lesson, line) in list.iter().zip(words.lines()) {
        assert!(line.starts_with(lesson["name"].as_str().expect("a name")));
        assert!(
            lesson["minutes"]
                .as_u64()
                .is_some_and(|minutes| minutes > 0)
        );
        assert!(lesson["steps"].as_u64().is_some_and(|steps| steps > 1));
        assert!(
            lesson["audience"]
                .as_array()
                .is_some_and(|whom| !whom.is_empty())
        );
    }
}

#[test]
fn a_check_says_file_step_and_reason() {
    let (code, words, err) = tell(&["check", "samples"]);
    assert_eq!(code, 0, "{err}");
    assert!(
        words.contains("played through, also with 3 other lights"),
        "{words}"
    );
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("mine.json");
    let file = path.to_str().expect("UTF-8");
    let text = in_its_own_language("samples");
    for (from, to, reason) in [
        (
            "\"say\"",
            "\"sya\"",
            "step 1: found the field `sya`, expected one of `say`",
        ),
        (
            "\"light\": \"FL2\"",
            "\"light\": \"FL99\"",
            "step 1: found ",
        ),
        (
            "{numbers}",
            "{nombers}",
            "step 1: found the figure nombers, expected one of",
        ),
        (
            "544",
            "100",
            "step 1: found a task that is done before it begins",
        ),
        (
            "544",
            "547",
            "step 1: its own show does not meet its task: found where the narrow filter stands",
        ),
        (
            "spectral-explorer-lesson",
            "a-lesson",
            "found format \"a-lesson\", expected",
        ),
    ] {
        assert!(text.contains(from), "{from}");
        fs::write(&path, text.replacen(from, to, 1)).expect("a file");
        let (code, out, err) = tell(&["check", file]);
        assert_eq!(
            (code, out.as_str(), err.lines().count()),
            (1, "", 1),
            "{err}"
        );
        assert!(
            err.contains("mine") && err.contains(reason),
            "{reason}: {err}"
        );
    }
    for (args, code) in [
        (&["check", "no such"][..], 1),
        (&["check"], 2),
        (&["handout", "waves"], 2),
    ] {
        let (found, _, err) = tell(args);
        assert_eq!(found, code, "{args:?}");
        assert!(err.contains("expected"), "{err}");
    }
}

#[test]
fn a_sheet_is_written_with_its_pictures_and_replaces_nothing_unasked() {
    let folder = tempfile::tempdir().expect("a folder");
    let write = |name: &str, more: &[&str]| {
        let path = folder.path().join(name);
        let file = path.to_str().expect("UTF-8").to_owned();
        let args = [&["handout", "light", "--out", &file], more].concat();
        (tell(&args), path)
    };
    let ((code, _, err), html) = write("sheet.html", &[]);
    assert_eq!(code, 0, "{err}");
    let text = fs::read_to_string(html).expect("the sheet");
    assert!(text.contains("<svg") && text.contains(", right:"));
    let ((code, _, err), markdown) = write("sheet.md", &[]);
    assert_eq!(code, 0, "{err}");
    let text = fs::read_to_string(markdown).expect("the sheet");
    let picture = "sheet-1.svg";
    assert!(text.contains(&format!("]({picture})")) && folder.path().join(picture).is_file());
    assert_eq!(write("sheet.md", &[]).0.0, 1);
    assert_eq!(write("sheet.md", &["--force"]).0.0, 0);
}

/// A shipped lesson's file without its texts in other languages.
fn in_its_own_language(name: &str) -> String {
    let text = &shelf::named(name).expect("shipped").text;
    let (own, _) = text
        .split_once(",\n  \"texts\": {")
        .expect("texts at the end");
    format!("{own}\n}}\n")
}

#[test]
fn the_document_builds_a_lesson_that_ships_and_tells_every_figure() {
    let document = document("docs/lessons.md");
    let mut built = String::new();
    for piece in document.split("```json\n").skip(1) {
        let (piece, _) = piece.split_once("```").expect("an end");
        built += piece;
    }
    assert_eq!(built, in_its_own_language("samples"));
    let rows = rows(section(&document, "## Figures"));
    let told: Vec<&str> = rows.iter().flat_map(|row| quoted(row[0])).collect();
    let of_quality = |meaning: &str| meaning == "of light quality";
    let keys = figures::keys();
    let keys = keys.iter().filter(|(_, meaning)| !of_quality(meaning));
    let known: Vec<&str> = keys.map(|(key, _)| *key).collect();
    for key in &told {
        assert!(known.contains(key), "{key}");
    }
    for key in &known {
        assert!(told.contains(key), "{key}");
    }
}
