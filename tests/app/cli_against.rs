//! `light --against`: which of two lights is better for what.

use serde_json::Value;
use spectral_explorer::cli::{self, Outcome};

/// Exit code, what is printed and what is said beside it.
fn tell(args: &[&str]) -> (u8, String, String) {
    let words = [cli::PROGRAM, "light"];
    let words = words.iter().chain(args).map(Into::into);
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let Outcome::Done(code) = cli::run(words, None, &mut out, &mut err) else {
        panic!("a window");
    };
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    (code, text(out), text(err))
}

#[test]
fn two_lights_are_compared_beside_their_figures() {
    let (code, out, err) = tell(&["FL2", "--against", "LED-B1", "--json"]);
    assert_eq!((code, err.as_str()), (0, ""));
    let found: Value = serde_json::from_str(&out).expect("JSON");
    let better = found["better"].as_array().expect("a list");
    let colours = &better[0];
    let keys: Vec<&String> = colours.as_object().expect("an object").keys().collect();
    let mut sorted = keys.clone();
    sorted.sort();
    assert_eq!(sorted, ["a", "b", "for", "which", "words"]);
    assert_eq!(colours["for"], "colours");
    assert_eq!(colours["which"], "b");
    assert_eq!(colours["a"], found["a"]["rf"]);
    assert_eq!(colours["b"], found["b"]["rf"]);
    // The figures are those of either light alone.
    for (side, name) in [("a", "FL2"), ("b", "LED-B1")] {
        let alone: Value = serde_json::from_str(&tell(&[name, "--json"]).1).expect("JSON");
        assert_eq!(found[side], alone, "{name}");
    }
    // People read the same sentences.
    let (_, text, _) = tell(&["FL2", "--against", "LED-B1"]);
    for better in better {
        assert!(text.contains(better["words"].as_str().expect("words")));
    }
    assert!(text.contains(found["summary"].as_str().expect("words")));
}

#[test]
fn counts_are_compared_only_where_they_are_said_to_be_a_light() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("lamp.csv");
    let rows: String = (380..=780)
        .map(|nm| format!("{nm},{}.5\n", 1000 + nm % 7))
        .collect();
    std::fs::write(&file, format!("nm,counts\n{rows}")).expect("a table");
    let file = file.to_str().expect("UTF-8");
    let (code, out, err) = tell(&["FL2", "--against", file]);
    assert_eq!((code, out.as_str()), (1, ""));
    assert!(err.contains("found counts, expected one light"), "{err}");
    let (code, out, err) = tell(&["FL2", "--against", file, "--as-light", "--json"]);
    assert_eq!(code, 0, "{err}");
    let found: Value = serde_json::from_str(&out).expect("JSON");
    assert_eq!(found["b"]["counts"]["is"], true);
    assert!(found["b"]["cct"].is_number(), "{}", found["b"]);
}

#[test]
fn tables_of_one_lamp_are_told_apart() {
    let (_, text, _) = tell(&[
        "cie_fluorescent_1nm/FL2",
        "--against",
        "cie_fluorescent_5nm/FL2",
    ]);
    let first = text.lines().next();
    let names = "cie_fluorescent_1nm/FL2 against cie_fluorescent_5nm/FL2";
    assert_eq!(first, Some(names));
}

#[test]
fn what_is_not_one_light_is_refused_in_one_line() {
    for (code, args, words) in [
        (
            2,
            &["FL2", "FL11", "--against", "CIE A"][..],
            "found 2 INPUTs",
        ),
        (1, &["FL2", "--against", "no such lamp"], "--against: "),
        (
            1,
            &["FL2", "--against", "colorchecker_ohta/red"],
            "--against: ",
        ),
        (1, &["no such lamp", "--against", "FL2"], "INPUT: "),
        (1, &["FL2", "--against", "lessons"], "a folder"),
    ] {
        let (found, out, err) = tell(args);
        assert_eq!((found, out.as_str()), (code, ""), "{err}");
        assert_eq!(err.trim_end().lines().count(), 1, "{err}");
        assert!(err.contains(words), "{args:?}: {err}");
    }
}

#[test]
fn options_of_the_model_are_not_used_without_json() {
    let order = ["FL2", "--against", "CIE A", "--order", "9"];
    assert!(tell(&order).2.contains("--order is not used"));
    let with_json = [&order[..], &["--json"]].concat();
    assert_eq!(tell(&with_json).2, "");
}
