//! What the command line says of a light in words: its family, its names, and what a search finds.

use std::ffi::OsString;

use serde_json::Value;
use spectral_explorer::cli::{self, Outcome};

fn tell(args: &[&str]) -> (Outcome, String, String) {
    let program = OsString::from(cli::PROGRAM);
    let args = std::iter::once(program).chain(args.iter().map(OsString::from));
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let outcome = cli::run(args, None, &mut out, &mut err);
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    (outcome, text(out), text(err))
}

fn said(args: &[&str]) -> String {
    let (outcome, out, err) = tell(args);
    assert_eq!(outcome, Outcome::Done(0), "{args:?}: {err}");
    out
}

fn json(args: &[&str]) -> Value {
    serde_json::from_str(&said(args)).expect("JSON")
}

#[test]
fn a_search_lists_the_best_first_with_what_it_is() {
    let first = |words: &str| -> Value { json(&["list", "--search", words, "--json"])[0].clone() };
    for (words, id) in [
        ("street lamp", "cie_hp_5nm/HP1"),
        ("tungsten", "cie_illuminants/CIE A"),
        ("neon", "line_tubes/Neon tube"),
        ("energy saver", "cie_fluorescent_1nm/FL12"),
        ("skin", "everyday_surfaces/Skin, light"),
    ] {
        assert_eq!(first(words)["id"], id, "{words}");
    }
    let fl2 = first("office");
    assert_eq!(fl2["id"], "cie_fluorescent_1nm/FL2");
    assert_eq!(fl2["twins"], serde_json::json!(["cie_fluorescent_5nm/FL2"]));
    assert_eq!(
        (&fl2["family"], &fl2["made"]),
        (&"tube".into(), &false.into())
    );
    let about = fl2["about"].as_str().unwrap();
    assert!(
        about.starts_with("FL2: cool white fluorescent tube, "),
        "{about}"
    );
    // In words one line an item, and of a kind only that kind.
    let text = said(&["list", "--search", "sodium", "--kind", "light"]);
    assert!(
        text.lines()
            .next()
            .unwrap()
            .starts_with("lamps_nist_traditional/LPS "),
        "{text}"
    );
    assert!(
        text.lines().all(|line| line.contains("  light   ")),
        "{text}"
    );
    let (outcome, out, err) = tell(&["list", "--search", "qqqqqqqq"]);
    assert_eq!((outcome, out.as_str()), (Outcome::Done(0), ""));
    let line = "no spectrum in the library is called \"qqqqqqqq\"\n";
    assert!(err.ends_with(line), "{err}");
    let (_, _, err) = tell(&["list", "--kind", "absorbance"]);
    assert!(
        err.ends_with("no absorbance spectrum is in the library\n"),
        "{err}"
    );
    assert_eq!(
        json(&["list", "--search", "qqqqqqqq", "--json"]),
        serde_json::json!([])
    );
}

#[test]
fn a_report_tells_family_sentence_and_elements() {
    let report = json(&["report", "FL11", "--json"]);
    assert_eq!(report["family"], "three-band");
    assert!(
        report["about"]
            .as_str()
            .unwrap()
            .starts_with("FL11: three-band tube")
    );
    assert_eq!(report["elements"], serde_json::json!(["Hg", "Tb", "Eu"]));
    let spikes = report["model"]["spikes"].as_array().unwrap();
    let green = spikes
        .iter()
        .find(|s| s["line"] == "terbium band 545, with Hg 546.1 in it");
    assert_eq!(
        green.expect("the green band")["label"],
        "Tb band + Hg 546.1"
    );
    let text = said(&["report", "HP1"]);
    assert!(
        text.contains("Family    High-pressure sodium lamps"),
        "{text}"
    );
    assert!(
        text.contains("Na D 589.3, self-reversed") && !text.contains("near "),
        "{text}"
    );
    let plain = json(&["report", "CIE A", "--json"]);
    assert_eq!(plain["elements"], serde_json::json!([]));
    assert_eq!(plain["dark_lines"], serde_json::json!([]));
}

#[test]
fn known_dark_lines_are_told_at_their_places_and_bands_are_called_bands() {
    let sun = "ASTM G173-03 global tilt AM1.5G";
    let report = json(&["report", sun, "--json"]);
    let family = &report["dark_lines"][0];
    assert_eq!(
        (&family["family"], &family["bands"]),
        (&"sunlight".into(), &false.into())
    );
    let lines = family["lines"].as_array().unwrap();
    let seen = |name: &str| lines.iter().any(|l| l["name"] == name && l["seen"] == true);
    assert!(seen("Na D 589.3") && seen("H-beta 486.1"), "{family}");
    let text = said(&["report", sun]);
    assert!(text.contains("Dark      sunlight: "), "{text}");
    let holmium = "usgs_splib07/Holmium oxide powder (USGS splib07a Record 18789)";
    let text = said(&["report", holmium, "--range", "380:700", "--dips"]);
    assert!(
        text.contains("bands, not lines") && text.contains("Ho band "),
        "{text}"
    );
}

#[test]
fn the_lines_of_a_file_tell_its_family_as_far_as_they_can() {
    let folder = tempfile::tempdir().expect("a folder");
    // A lamp of the tests' own: mercury's lines with nothing under them, 1 nm.
    let lines = [
        (404.7, 4.0),
        (435.8, 10.0),
        (546.1, 8.0),
        (577.0, 1.5),
        (579.1, 1.6),
    ];
    let rows: Vec<String> = (380..=780)
        .map(|nm| {
            let of = |(at, power): (f64, f64)| {
                power * (-0.5 * ((f64::from(nm) - at) / 0.8).powi(2)).exp()
            };
            let value: f64 = lines.into_iter().map(of).sum();
            format!("{nm},{}", 0.01 + value)
        })
        .collect();
    let path = folder.path().join("lamp.csv");
    std::fs::write(&path, rows.join("\n")).expect("written");
    let path = path.to_str().unwrap();
    let report = json(&["report", path, "--kind", "light", "--json"]);
    assert_eq!(report["family"], "mercury");
    assert_eq!(report["elements"], serde_json::json!(["Hg"]));
    let flat = folder.path().join("flat.csv");
    let rows: Vec<String> = (380..=780).map(|nm| format!("{nm},1")).collect();
    std::fs::write(&flat, rows.join("\n")).expect("written");
    let report = json(&[
        "report",
        flat.to_str().unwrap(),
        "--kind",
        "light",
        "--json",
    ]);
    assert!(report["family"].is_null());
}

#[test]
fn ideal_filters_and_black_bodies_are_made_when_they_are_asked_for() {
    let report = json(&["report", "long-pass 546.1", "--json"]);
    assert_eq!(report["input"]["name"], "Ideal long-pass 546.1 nm");
    assert_eq!(report["input"]["kind"], "transmittance");
    let product = said(&["product", "FL2", "band-pass 546/10"]);
    assert!(
        product.contains("Ideal band-pass 546 nm, 10 nm wide"),
        "{product}"
    );
    let candle = json(&["report", "black body 2000 K", "--json"]);
    let cct = candle["colour"]["full"]["cct"].as_f64().unwrap();
    assert!((cct - 2000.0).abs() < 2.0, "{cct}");
    let (outcome, _, err) = tell(&["report", "long-pass 12"]);
    assert_eq!(outcome, Outcome::Done(1));
    assert!(err.contains("no shipped spectrum"), "{err}");
}

#[test]
fn line_tubes_are_named_and_everyday_surfaces_are_a_set() {
    let report = json(&["report", "Helium tube", "--json"]);
    assert_eq!(report["elements"], serde_json::json!(["He"]));
    let set = said(&["product", "CIE A", "--set", "everyday_surfaces"]);
    assert!(set.contains("24"), "{set}");
}
