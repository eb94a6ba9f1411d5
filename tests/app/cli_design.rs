//! Recovering spectra and mixing lights on the command line: what comes out, and what is refused.

use std::fs;

use serde_json::Value;
use spectral_explorer::{io::read_path, optics::png};

use crate::tell::{json, refusal, tell};

fn number(json: &Value, key: &str) -> f64 {
    json[key]
        .as_f64()
        .unwrap_or_else(|| panic!("{key}: {json}"))
}

#[test]
fn a_colour_comes_back_from_the_surface_that_was_made_of_it() {
    for light in ["CIE D65", "FL2", "CIE A"] {
        let args = ["recover", "--colour", "#c08040", "--light", light, "--json"];
        let recovered = json(&args);
        assert_eq!(recovered["method"], "smoothest");
        assert_eq!(recovered["light"], light);
        // The definition's bound for the round trip.
        assert!(number(&recovered, "round_trip_delta_e") < 0.01);
        assert_eq!(recovered["inside_0_1"], true);
        let under = recovered["under"].as_array().expect("lights");
        let own = under.iter().find(|seen| seen["light"] == light);
        assert_eq!(own.expect("the light itself")["srgb_hex"], "#c08040");
        assert!(recovered["nearest"].is_null());
    }
}

#[test]
fn xyz_lab_and_two_lights_are_taken_too() {
    // Middle grey, told in two ways.
    let lab = json(&["recover", "--lab", "50,0,0", "--json"]);
    let value = |json: &Value| {
        let values = json["values"].as_array().expect("values");
        let middle = values.iter().find(|row| row["nm"] == 580.0);
        number(middle.expect("580 nm"), "value")
    };
    assert!((value(&lab) - 0.1842).abs() < 1e-3, "{}", value(&lab));
    let second = ["--second-lab", "50,0,0", "--second-light", "CIE A"];
    let six = [
        "recover", "--lab", "50,0,0", "--method", "fourier6", "--json",
    ];
    let six = json(&[&six[..], &second].concat());
    assert!((value(&six) - value(&lab)).abs() < 1e-3);
    assert_eq!(six["second_light"], "CIE A");
    assert!(number(&six, "condition_number") > 1.0);
}

#[test]
fn a_colour_that_no_surface_has_gets_a_word_and_the_nearest() {
    let args = ["recover", "--xyz", "10,90,5", "--json"];
    let (code, _, err) = tell(&args);
    assert_eq!(code, 0);
    assert!(err.contains("no surface has this colour"), "{err}");
    assert!(number(&json(&args)["nearest"], "delta_e") > 1.0);
}

#[test]
fn a_light_of_lines_has_its_lines_where_they_were_asked_for() {
    let args = [
        "recover", "--colour", "#ffeedd", "--method", "lines", "--json",
    ];
    let light = json(&[&args[..], &["--lines", "436,546,611"]].concat());
    let places = light["lines"].as_array().expect("lines").iter();
    let places: Vec<f64> = places.map(|line| number(line, "at_nm")).collect();
    assert_eq!(places, [436.0, 546.0, 611.0]);
    assert!(number(&light, "round_trip_delta_e") < 0.01);
}

#[test]
fn a_picture_of_colours_becomes_a_spectral_one() {
    let folder = tempfile::tempdir().expect("a folder");
    let image = folder.path().join("photo.png");
    let pixels = [[200, 128, 64], [10, 20, 30], [255, 255, 255], [90, 90, 90]];
    fs::write(&image, png(2, &pixels).expect("a picture")).expect("a file");
    let out = folder.path().join("photo.exr");
    let (image, path) = (image.to_str().expect("UTF-8"), out.to_str().expect("UTF-8"));
    let args = ["recover", "--image", image, "--out", path];
    let (code, told, err) = tell(&args);
    assert_eq!(code, 0, "{err}");
    assert!(told.contains("2 x 2 px, 41 bands"), "{told}");
    let reading = read_path(&out).expect("a spectral picture");
    let grey = reading.images[0].pixel(1, 1).expect("a pixel");
    // A grey is flat: sRGB 90 is 10.2 % of the light at every wavelength.
    assert!(
        grey.samples
            .values()
            .iter()
            .all(|v| (v - 0.1022).abs() < 2e-3)
    );
    assert!(refusal(&args).0.contains("--force"));
    fs::write(image, "no picture").expect("a file");
    let (err, code) = refusal(&[&args[..], &["--force"]].concat());
    assert_eq!(code, 1);
    assert!(err.contains("expected a PNG picture"), "{err}");
}

#[test]
fn what_cannot_be_recovered_is_refused_in_one_line() {
    let colour = ["recover", "--colour", "#c08040"];
    for (more, code, part) in [
        (
            &["--method", "fourier6"][..],
            2,
            "expected two colours under two lights, found 1",
        ),
        (&["--second-light", "CIE A"], 2, "expected both or neither"),
        (&["--second-lab", "1,2,3"], 2, "expected both or neither"),
        (&["--method", "magic"], 2, "--method: found \"magic\""),
        (&["--xyz", "1,2,3"], 2, "expected one of them"),
        (&["--light", "colorchecker_ohta/red"], 1, "expected a light"),
        (
            &["--method", "lines", "--lines", "900"],
            2,
            "expected places in 380-780 nm",
        ),
    ] {
        let (err, found) = refusal(&[&colour, more].concat());
        assert_eq!(found, code, "{more:?}: {err}");
        assert!(err.contains(part), "{more:?}: {err}");
    }
    assert!(refusal(&["recover"]).0.contains("found no --colour"));
    assert!(
        refusal(&["recover", "--colour", "red"])
            .0
            .contains("#rrggbb")
    );
}

const DESK: [&str; 7] = [
    "mix",
    "--channel",
    "line:450",
    "--channel",
    "gauss:540,30",
    "--channel",
    "gauss:620,20",
];

#[test]
fn a_mixture_meets_its_colour() {
    for target in ["4000K", "0.33,0.34", "CIE A"] {
        let mix = json(&[&DESK[..], &["--target", target, "--json"]].concat());
        assert_eq!(mix["reached"], true, "{target}: {}", mix["why"]);
        // The definition's bound.
        assert!(number(&mix, "delta_uv_to_target") < 1e-6);
    }
    let warm = [
        &DESK[..],
        &["--target", "3000K", "--duv", "0.002", "--json"],
    ]
    .concat();
    let warm = json(&warm);
    assert!((number(&warm, "duv") - 0.002).abs() < 1e-5);
    let (_, words, _) = tell(&[&DESK[..], &["--target", "4000K"]].concat());
    assert!(
        words.contains("gauss:540,30") && words.contains("DMX"),
        "{words}"
    );
}

#[test]
fn an_impossible_target_is_answered_by_how_near_it_came_and_why() {
    let args = [
        "mix",
        "--channel",
        "line:450",
        "--channel",
        "line:470",
        "--json",
    ];
    let mix = json(&[&args[..], &["--target", "3000K"]].concat());
    assert_eq!(mix["reached"], false);
    assert!(number(&mix, "delta_uv_to_target") > 0.01);
    assert!(!mix["why"].as_str().expect("words").is_empty());
}

#[test]
fn fixed_weights_are_kept_and_lights_have_their_names() {
    let args = [
        "mix",
        "--channel",
        "FL2=2",
        "--channel",
        "CIE A=1",
        "--json",
    ];
    let mix = json(&args);
    let channels = mix["channels"].as_array().expect("channels");
    let weights: Vec<f64> = channels.iter().map(|c| number(c, "weight")).collect();
    assert_eq!(weights, [2.0, 1.0]);
    assert_eq!(channels[0]["spec"], "FL2");
}

#[test]
fn what_cannot_be_mixed_is_refused_in_one_line() {
    for (args, code, part) in [
        (&["mix"][..], 2, "--channel"),
        (
            &["mix", "--channel", "line:2000"],
            2,
            "expected a place in nm",
        ),
        (&["mix", "--channel", "no such lamp"], 1, "--channel"),
        (
            &["mix", "--channel", "FL2", "--target", "10K"],
            2,
            "--target",
        ),
        (
            &["mix", "--channel", "FL2", "--target", "0.9,0.9"],
            2,
            "--target",
        ),
        (
            &["mix", "--channel", "FL2", "--target", "CIE A", "--duv", "0"],
            2,
            "--duv",
        ),
        (
            &[
                "mix",
                "--channel",
                "FL2",
                "--target",
                "4000K",
                "--floor",
                "x=1",
            ],
            2,
            "--floor",
        ),
        (
            &["mix", "--front", "rf,ler", "--lines", "9"],
            2,
            "from 2 to 8",
        ),
        (
            &["mix", "--front", "rg,ler", "--lines", "3"],
            2,
            "rf,ler or ra,ler",
        ),
        (&["mix", "--front", "rf,ler"], 2, "--lines"),
    ] {
        let (err, found) = refusal(args);
        assert_eq!(found, code, "{args:?}: {err}");
        assert!(err.contains(part), "{args:?}: {err}");
    }
}
