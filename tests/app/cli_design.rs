//! Recovering spectra and mixing lights on the command line: what comes out, and what is refused.

use std::fs;

use serde_json::Value;
use spectral_explorer::io::{png, read_path};

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
    assert!(err.contains("nearest by ΔE*ab"), "{err}");
    // It is the nearest by that, which no other sees: 20, 60, 5 has 4.184 (Wolfe's method apart
    // from the program) and .80 of CIEDE2000 elsewhere.
    let nearest = &json(&["recover", "--xyz", "20,60,5", "--json"])["nearest"];
    assert!((number(nearest, "delta_e_ab") - 4.184).abs() < 0.001);
    assert!(number(nearest, "delta_e") > 1.0);
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
    fs::write(
        &image,
        png([2, 2], pixels.as_flattened()).expect("a picture"),
    )
    .expect("a file");
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
    let folder = tempfile::tempdir().expect("a folder");
    let place = |name: &str| folder.path().join(name).to_str().expect("UTF-8").to_owned();
    let (table, cut, none) = (place("a.csv"), place("cut.png"), place("none.png"));
    fs::write(&table, "380,1\n390,2\n").expect("a file");
    fs::write(&cut, b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0").expect("a file");
    for (image, part) in [
        (
            &table,
            "found a file of another kind, expected a PNG picture",
        ),
        (
            &cut,
            "found a damaged picture, expected a whole PNG picture",
        ),
        (&none, "found no such file"),
    ] {
        let (err, code) = refusal(&["recover", "--image", image, "--out", &place("x.exr")]);
        assert_eq!(code, 1, "{err}");
        assert!(err.contains(part), "{err}");
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
fn a_mixture_says_what_was_met_of_what_was_asked() {
    let channels = ["line:450", "gauss:540,30", "gauss:620,20"];
    let mix = |more: &[&str]| {
        let channels = channels.iter().flat_map(|spec| ["--channel", spec]);
        let args: Vec<&str> = ["mix"].into_iter().chain(channels).collect();
        let (code, out, err) = tell(&[&args[..], more].concat());
        assert_eq!(code, 0, "{err}");
        (out.lines().last().expect("a line").to_owned(), err)
    };
    let target = ["--target", "4000K"];
    let floor = ["--floor", "ler=100"];
    assert_eq!(mix(&target).0, "the colour is met");
    assert_eq!(
        mix(&[target, floor].concat()).0,
        "colour and floors are met"
    );
    let (words, err) = mix(&floor);
    assert_eq!(words, "the channels as they stand: no colour was asked for");
    assert!(err.contains("--floor is not used"), "{err}");
    assert!(!err.contains("--favour"), "{err}");
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

#[test]
fn a_stricter_floor_never_finds_more_lumens_than_a_laxer_one() {
    let channels = [
        "gauss:450,20",
        "gauss:500,30",
        "gauss:530,35",
        "gauss:590,15",
        "gauss:630,20",
        "blackbody:2700",
    ];
    let ler = |target: &str, floor: &str| {
        let mut args = vec!["mix", "--json", "--favour", "ler", "--target", target];
        args.extend(channels.iter().flat_map(|channel| ["--channel", channel]));
        args.extend(["--floor", floor]);
        let mixed = json(&args);
        assert_eq!(mixed["reached"], true, "{floor}");
        number(&mixed, "ler")
    };
    let lax = ler("3000K", "ra=80");
    let strict = ler("3000K", "ra=90");
    // The trade is looked for to a thousandth.
    assert!(lax >= 0.999 * strict, "{lax} {strict}");
    // Weights of 367.5 lm/W and Ra 90.0 are known: what --floor ler=300 beside it once found.
    let found = ler("2700K", "ra=90");
    assert!(found > 0.995 * 367.5, "{found}");
}

#[test]
fn a_light_to_come_near_to_keeps_the_floors_that_were_asked_for() {
    let places = ["430", "460", "490", "520", "550", "580", "610", "640"];
    let lines = places.map(|nm| format!("line:{nm}"));
    let channels = lines.iter().flat_map(|line| ["--channel", line]);
    let base = ["mix", "--json", "--target", "FL2"];
    let args: Vec<&str> = base.into_iter().chain(channels).collect();
    let plain = number(&json(&args), "ra");
    assert!(plain < 80.0, "else the floor asks for nothing: {plain}");
    let kept = json(&[&args[..], &["--floor", "ra=80"]].concat());
    assert_eq!(kept["reached"], true, "{}", kept["why"]);
    assert!(number(&kept, "ra") >= 80.0 - 1e-3);
    let why = kept["why"].as_str().expect("words");
    assert!(why.contains("the nearest spectrum alone"), "{why}");
}

#[test]
fn a_mixture_says_what_its_composite_leaves_out() {
    let (code, _, err) = tell(&["mix", "--channel", "FL2", "--channel", "line:365"]);
    assert_eq!(code, 0);
    assert!(err.contains("lies outside 380-780 nm"), "{err}");
    let (_, _, err) = tell(&["mix", "--channel", "FL2"]);
    assert!(!err.contains("outside"), "{err}");
}

#[test]
fn one_colour_told_twice_under_one_light_is_one_colour() {
    let one = ["recover", "--colour", "#c08040", "--json"];
    let twice = ["--second-colour", "#c08040", "--second-light", "CIE D65"];
    let (once, twice) = (json(&one), json(&[&one[..], &twice].concat()));
    assert_eq!(once["values"], twice["values"]);
    let other = ["--second-colour", "#4080c0", "--second-light", "CIE D65"];
    let (err, code) = refusal(&[&one[..], &other].concat());
    assert_eq!(code, 2, "{err}");
    assert!(err.contains("expected two that differ"), "{err}");
}

#[test]
fn the_nearest_light_of_lines_is_shown_in_its_own_colour() {
    let args = [
        "recover", "--colour", "#ff00ff", "--method", "lines", "--json",
    ];
    let hex = json(&args)["nearest"]["srgb_hex"].clone();
    let hex = hex.as_str().expect("a colour").to_owned();
    // Magenta out of reach is answered by a purple, not by white.
    let part = |at: usize| u8::from_str_radix(&hex[at..at + 2], 16).expect("hex");
    assert!(part(3) < part(1) && part(3) < part(5), "{hex}");
}

#[test]
fn options_that_would_do_nothing_are_refused() {
    for args in [
        &["recover", "--colour", "#fff000", "--out", "x.exr"][..],
        &["mix", "--channel", "FL2", "--lines", "3"],
        &["gem", "--absorption", "1", "--thickness", "2"],
        &["picture", "cube.hdr", "--peers", "--force"],
    ] {
        let (err, code) = refusal(args);
        assert_eq!(code, 2, "{args:?}: {err}");
        assert!(err.contains("expected one of them"), "{err}");
    }
}
