//! Lines of their own width on the command line: who takes the width, and who a line's centre.

use std::fs;

use serde_json::Value;
use spectral_explorer::{
    app::Library,
    io::read_path,
    spectrum::{Band, Outside},
};

use crate::tell::{json, tell};

/// A command about FL11, with ideal lines and with wide ones.
fn both(args: &[&str]) -> [Value; 2] {
    let ideal = json(&[args, &["--json"]].concat());
    let wide = json(&[args, &["--wide-lines", "--json"]].concat());
    [ideal, wide]
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

#[test]
fn report_and_light_take_the_widths() {
    let [ideal, wide] = both(&["report", "FL11"]);
    assert_eq!(
        number(&wide["model"]["numbers"]),
        number(&ideal["model"]["numbers"]) + 1.0
    );
    let rms = |report: &Value| number(&report["error"]["relative_rms_10nm"]);
    assert!(rms(&wide) < rms(&ideal));
    let [ideal, wide] = both(&["light", "FL11", "--order", "10"]);
    assert_eq!(ideal["rf"], wide["rf"], "of the light as measured");
    let off = |light: &Value| (number(&light["model"]["rf"]) - number(&light["rf"])).abs();
    assert_ne!(ideal["model"]["rf"], wide["model"]["rf"]);
    println!("Rf off by {} ideal, {} wide", off(&ideal), off(&wide));
}

#[test]
fn chains_and_optics_take_the_centres_and_say_so() {
    let note = "--wide-lines: here each line stands at its centre";
    for args in [
        &["product", "FL11", "colorchecker_ohta/red"][..],
        &[
            "product",
            "FL11",
            "colorchecker_ohta/red",
            "--sampling",
            "double",
        ],
        &["prism", "FL11"],
        &["rainbow", "FL11"],
    ] {
        assert!(!tell(args).2.contains(note), "{args:?}");
        let (_, _, err) = tell(&[args, &["--wide-lines"]].concat());
        assert!(err.contains(note), "{args:?}: {err}");
    }
    // The same places and weights; only what is smooth differs.
    let [ideal, wide] = both(&["product", "FL11", "colorchecker_ohta/red"]);
    assert!(
        ideal["stages"][0]["spikes"]
            .as_array()
            .is_some_and(|s| s.len() > 3)
    );
    assert_eq!(ideal["stages"][0]["spikes"], wide["stages"][0]["spikes"]);
    let [ideal, wide] = both(&["prism", "FL11"]);
    assert!(ideal["at"].as_array().is_some_and(|at| at.len() > 3));
    assert_eq!(ideal["at"], wide["at"]);
    let [ideal, wide] = both(&["rainbow", "FL11"]);
    assert_eq!(ideal["at"], wide["at"]);
}

#[test]
fn a_written_composite_keeps_its_widths() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("fl11.json");
    let name = file.to_str().expect("UTF-8");
    let args = ["convert", "FL11", name, "--as", "composite", "--wide-lines"];
    assert_eq!(tell(&args).0, 0);
    let text = fs::read_to_string(&file).expect("a file");
    let written: Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(written["version"], 2);
    let spikes = written["spikes"].as_array().expect("spikes");
    assert!(
        spikes
            .iter()
            .any(|spike| spike["fwhm_nm"].as_f64() > Some(2.0))
    );
    // Read again, the lines are in the values where they were.
    let csv = folder.path().join("values.csv");
    let args = ["convert", name, csv.to_str().expect("UTF-8")];
    assert_eq!(tell(&args).0, 0);
    let reading = read_path(&csv).expect("a spectrum");
    let lamp = Library::bundled().find("FL11").expect("it is shipped");
    let lamp = &lamp.spectrum().expect("a table").samples;
    let [model, peak] = [&reading.spectra[0].samples, lamp]
        .map(|samples| samples.on_band(Band::VISIBLE, Outside::Zero)[545 - 380]);
    assert!((model - peak).abs() < 0.3 * peak, "{model} {peak}");
}

#[test]
fn a_composite_of_wide_lines_is_taken_as_it_is() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    for lamp in ["FL1", "FL11", "HP1", "F32T8/TL841 (Triphosphor)"] {
        for name in ["model.json", "model.txt"] {
            let file = path(name);
            let convert = ["convert", lamp, &file, "--as", "composite", "--wide-lines"];
            let (code, _, err) = tell(&[&convert[..], &["--force"]].concat());
            assert_eq!(code, 0, "{err}");
            let text = fs::read_to_string(path("model.json")).expect("written first");
            let written: Value = serde_json::from_str(&text).expect("JSON");
            let expected = written["spikes"].as_array().expect("lines");
            assert!(expected.iter().any(|line| line["fwhm_nm"].is_number()));
            let read = json(&["read", &file, "--json"]);
            let report = json(&["report", &file, "--json"]);
            let model = &report["model"];
            assert_eq!(model["as_given"], true, "{lamp} {name}");
            let told = &read[0]["composites"][0];
            assert_eq!(model["numbers"], told["numbers"], "{lamp} {name}");
            assert!(told["numbers"].is_u64());
            let lines = model["spikes"].as_array().expect("lines");
            assert_eq!(lines.len(), expected.len());
            for (line, expected) in lines.iter().zip(expected) {
                for key in ["at_nm", "weight", "fwhm_nm"] {
                    // An ideal line has no width in the file.
                    let [found, told] = [line, expected].map(|l| l[key].as_f64().unwrap_or(0.0));
                    assert_eq!(found, told, "{lamp} {name} {key}");
                }
            }
            // The table is the composite's own: a projection of a series on itself.
            let off = number(&report["error"]["relative_rms"]);
            assert!(off < 1e-9, "{lamp} {name}: {off}");
            // Every command takes the same light.
            let light = json(&["light", &file, "--json"]);
            let [whole, model] = [&light["ra"], &light["model"]["ra"]].map(number);
            println!("{lamp} {name}: Ra {whole} as a table, {model} as a composite");
            let (code, _, err) = tell(&["encode", &file, "--portable"]);
            assert_eq!(code, 0, "{err}");
        }
    }
}

#[test]
fn the_auction_sells_widths_and_says_so() {
    let args = [
        "auction",
        "FL11",
        "--goal",
        "spectrum",
        "--numbers",
        "31",
        "--basis",
        "cosine",
    ];
    let auction = json(&[&args[..], &["--json"]].concat());
    let steps = auction["steps"].as_array().expect("steps");
    assert!(steps.iter().any(|step| step["bought"] == "width"));
    let last = steps.last().expect("a step");
    assert_eq!(last["wide_lines_now"], true);
    let numbers = 2 * last["order_now"].as_u64().expect("an order") + 2;
    let lines = last["spikes_nm_now"].as_array().map_or(0, Vec::len) as u64;
    assert_eq!(last["numbers"].as_u64(), Some(numbers + 2 * lines));
    let printed = tell(&args).1;
    assert!(printed.contains(",wide_lines_now"));
    assert!(printed.lines().any(|line| line.contains(",width,")));
}
