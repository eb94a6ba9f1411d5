//! Prism, rainbow and gem on the command line: what they print, write and refuse.

use std::{fs, path::Path};

use crate::open_exr::lines_of_exr;
use serde_json::Value;

use crate::tell::{json, refusal, tell};

fn numbers(json: &Value, list: &str, key: &str) -> Vec<f64> {
    let rows = json[list].as_array().expect("a list").iter();
    rows.filter_map(|row| row[key].as_f64()).collect()
}

/// A small picture that takes a moment.
const SMALL: [&str; 4] = ["--size", "32", "--rays", "8"];

fn gem(more: &[&str]) -> Vec<String> {
    let words = [&["gem"], more, &SMALL].concat();
    words.into_iter().map(str::to_owned).collect()
}

fn told_of_gem(more: &[&str]) -> (u8, String, String) {
    let words = gem(more);
    tell(&words.iter().map(String::as_str).collect::<Vec<_>>())
}

fn word(path: &Path) -> &str {
    path.to_str().expect("UTF-8")
}

#[test]
fn the_spikes_that_land_are_those_of_the_model() {
    let model = json(&["report", "FL2", "--json"]);
    let spikes = model["model"]["spikes"].as_array().expect("spikes");
    let places: Vec<f64> = spikes.iter().filter_map(|s| s["at_nm"].as_f64()).collect();
    assert!(places.len() > 2);
    let prism = json(&["prism", "FL2", "--json"]);
    assert_eq!(numbers(&prism, "at", "nm"), places);
    assert_eq!(
        numbers(&json(&["rainbow", "FL2", "--json"]), "at", "nm"),
        places
    );
    let none = json(&["prism", "FL2", "--no-spikes", "--at", "500", "--json"]);
    assert_eq!(numbers(&none, "at", "nm"), [500.0]);
}

#[test]
fn a_longer_wavelength_is_bent_less_and_words_and_csv_tell_the_same() {
    let args = ["prism", "CIE D65", "--at", "450,550", "--at", "650"];
    let prism = json(&[&args[..], &["--json"]].concat());
    let turned = numbers(&prism, "at", "deviation");
    assert_eq!(turned.len(), 3);
    assert!(turned[0] > turned[1] && turned[1] > turned[2], "{turned:?}");
    let (_, csv, _) = tell(&[&args[..], &["--csv"]].concat());
    let (_, words, _) = tell(&args);
    for deviation in turned {
        assert!(csv.contains(&format!("{deviation:.8}")), "{csv}");
        assert!(words.contains(&format!("{deviation:.5}")), "{words}");
    }
}

#[test]
fn a_bow_needs_no_light_and_stands_where_it_is_known_to() {
    let bows = json(&["rainbow", "--at", "589.294", "--json"]);
    // Water at 589 nm: the bows of every textbook.
    assert!((numbers(&bows, "at", "primary")[0] - 42.1).abs() < 0.1);
    assert!((numbers(&bows, "at", "secondary")[0] - 50.9).abs() < 0.1);
    let (err, code) = refusal(&["rainbow"]);
    assert_eq!(code, 2);
    assert!(
        err.contains("found no INPUT and no --at, expected one of them"),
        "{err}"
    );
}

#[test]
fn a_wavelength_without_an_index_is_refused_by_the_number_that_was_typed() {
    for (args, part) in [
        (
            &["rainbow", "--at", "500,99999"][..],
            "170.0 to 3271 nm, found 99999 nm",
        ),
        (&["rainbow", "FL2", "--at", "-5"], "above 0 nm, found -5 nm"),
        (
            &["prism", "FL2", "--at", "1e9"],
            "262.1 to 12459 nm, found 1000000000 nm",
        ),
        (&["prism", "FL2", "--at", "-5", "--csv"], "found -5 nm"),
    ] {
        let (err, code) = refusal(args);
        assert_eq!(code, 2, "{args:?}");
        assert!(err.contains("--at: ") && err.contains(part), "{err}");
    }
    let (code, json, _) = tell(&["rainbow", "--at", "500,99999", "--json"]);
    let json: Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(
        (code, json["refused"][0]["nm"].as_f64()),
        (0, Some(99999.0))
    );
}

#[test]
fn a_light_without_lines_has_a_word_beside_its_empty_table() {
    let words = "has no lines, only a smooth band";
    for args in [
        &["prism", "CIE A"][..],
        &["prism", "CIE A", "--csv"],
        &["rainbow", "CIE A", "--json"],
        &["prism", "FL2", "--no-spikes"],
    ] {
        let (code, _, err) = tell(args);
        assert_eq!(code, 0, "{err}");
        assert!(err.contains(words), "{args:?}: {err}");
    }
    for args in [&["prism", "FL2"][..], &["rainbow", "CIE A", "--at", "500"]] {
        let (_, _, err) = tell(args);
        assert!(!err.contains(words), "{args:?}: {err}");
    }
}

#[test]
fn a_light_of_nothing_above_zero_is_refused_everywhere_in_the_same_words() {
    let folder = tempfile::tempdir().expect("a folder");
    for (value, found) in [("-0.5", "nothing above zero"), ("0", "nothing but zeros")] {
        let rows: String = (0..81)
            .map(|i| format!("{},{value}\n", 380 + 5 * i))
            .collect();
        let file = folder.path().join("dark.csv");
        fs::write(&file, rows).expect("a file");
        let dark = word(&file);
        let line = format!("dark: found {found} from 380 to 780 nm, expected values above zero\n");
        for args in [
            &["prism", dark][..],
            &["rainbow", dark],
            &["gem", "--light", dark],
            &["product", dark, "red"],
            &["sweep", dark],
            &["auction", dark, "--goal", "own", "--numbers", "5"],
            &["race", dark, "--numbers", "5"],
        ] {
            let (err, code) = refusal(args);
            assert_eq!(code, 1, "{args:?}");
            assert!(err.ends_with(&line), "{args:?}: {err}");
        }
        let (code, report, _) = tell(&["report", dark]);
        assert_eq!(code, 0);
        let said = report.contains("81 of 81 values in the range are below zero");
        assert_eq!(said, value != "0", "{report}");
    }
}

#[test]
fn a_material_is_a_word_two_numbers_or_a_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("glass.yml");
    let rows: String = (0..9)
        .map(|i| {
            format!(
                "        {} {}\n",
                0.3 + 0.1 * f64::from(i),
                1.6 - 0.005 * f64::from(i)
            )
        })
        .collect();
    let text = format!("REFERENCES: a table\nDATA:\n  - type: tabulated n\n    data: |\n{rows}");
    fs::write(&file, text).expect("a file");
    let index = |material: &str| {
        let args = [
            "prism",
            "CIE D65",
            "--at",
            "500",
            "--material",
            material,
            "--json",
        ];
        numbers(&json(&args), "at", "n")[0]
    };
    assert!((index("n-bk7") - 1.5214).abs() < 1e-4);
    assert!((index(word(&file)) - 1.59).abs() < 1e-9);
    let by_hand = index("1.5168,64.17");
    assert!((by_hand - 1.5214).abs() < 2e-3, "{by_hand}");
    let (err, code) = refusal(&["prism", "FL2", "--material", "cheese"]);
    assert_eq!(code, 2);
    assert!(
        err.contains("--material: found \"cheese\", expected diamond, zirconia"),
        "{err}"
    );
}

#[test]
fn a_bench_that_is_none_is_refused_in_its_own_words() {
    for (args, part) in [
        (["--apex", "180"], "apex"),
        (["--incidence", "90"], "incidence"),
        (["--screen", "0"], "screen"),
        (["--slit", "-1"], "slit"),
        (["--apex", "100"], "apex"),
        (["--slit", "NaN"], "--slit: found"),
        (["--thickness", "2"], "--filter"),
    ] {
        let (err, code) = refusal(&[&["prism", "FL2"][..], &args].concat());
        assert_eq!(code, 2, "{args:?}");
        assert!(err.contains(part), "{args:?}: {err}");
    }
    let (err, code) = refusal(&["prism", "colorchecker_ohta/red"]);
    assert_eq!(code, 1);
    assert!(err.contains("expected a light"), "{err}");
}

#[test]
fn a_filter_in_the_glass_takes_light_away() {
    let glass = "isuzu IVG550 (Green filter) 2 mm";
    let clear = ["prism", "CIE D65", "--at", "650", "--json"];
    let through = |args: &[&str]| numbers(&json(args), "at", "transmittance")[0];
    let green = [&clear[..], &["--filter", glass, "--thickness", "2"]].concat();
    assert!(through(&green) < 0.5 * through(&clear));
    let wrong = ["prism", "FL2", "--filter", "CIE A", "--thickness", "2"];
    let (err, code) = refusal(&wrong);
    assert_eq!(code, 1);
    assert!(err.contains("expected a transmittance"), "{err}");
}

#[test]
fn a_gem_says_its_noise_and_is_the_same_for_the_same_seed() {
    let (code, words, err) = told_of_gem(&["--light", "FL11"]);
    assert_eq!(code, 0, "{err}");
    assert!(words.contains("noise: relative MSE"), "{words}");
    assert!(err.contains("a film of "), "{err}");
    let told = |seed: &str| {
        let words = gem(&["--light", "FL11", "--json", "--seed", seed]);
        let json = json(&words.iter().map(String::as_str).collect::<Vec<_>>());
        assert!(json["noise"]["relative_mse"].as_f64().expect("noise") > 0.0);
        json["blocks"].clone()
    };
    assert_eq!(told("7"), told("7"));
    assert_ne!(told("7"), told("8"));
}

#[test]
fn a_picture_is_written_and_replaces_only_a_picture() {
    let folder = tempfile::tempdir().expect("a folder");
    let png = folder.path().join("gem.png");
    for _ in 0..2 {
        let (code, out, err) = told_of_gem(&["--out", word(&png)]);
        assert_eq!(code, 0, "{err}");
        assert!(out.contains("32 x 32 px."), "{out}");
    }
    assert!(
        fs::read(&png)
            .expect("a picture")
            .starts_with(b"\x89PNG\r\n\x1a\n")
    );
    fs::write(&png, "380,1\n").expect("a file");
    let words = gem(&["--out", word(&png)]);
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    assert!(refusal(&words).0.contains("is no picture"));
    assert_eq!(tell(&[&words[..], &["--force"]].concat()).0, 0);
}

#[test]
fn an_exr_holds_the_spikes_and_is_not_replaced_unasked() {
    let folder = tempfile::tempdir().expect("a folder");
    let exr = folder.path().join("gem.exr");
    let more = ["--light", "FL2", "--out", word(&exr), "--json"];
    let (code, out, err) = told_of_gem(&more);
    assert_eq!(code, 0, "{err}");
    assert!(err.contains("Wrote "), "{err}");
    let told: Value = serde_json::from_str(&out).expect("JSON alone");
    let lines = lines_of_exr(&fs::read(&exr).expect("an image"));
    let places = numbers(&told, "lines", "nm");
    assert_eq!(lines.len(), places.len());
    for ((nm, energy), place) in lines.iter().zip(places) {
        // Names of channels have six decimals.
        assert!((nm - place).abs() < 1e-6);
        assert_eq!(energy.len(), 32 * 32);
    }
    let (code, out, err) = told_of_gem(&more);
    assert_eq!((code, out.as_str()), (1, ""));
    assert!(err.contains("--force"), "{err}");
}

#[test]
fn what_is_no_gem_is_refused_in_one_line() {
    for (args, part) in [
        (&["--table", "1.5"][..], "table"),
        (&["--crown", "95"], "crown"),
        (&["--rays", "0"], "--rays: found"),
        (&["--size", "8"], "--size: found"),
        (&["--blocks", "64"], "--blocks: found 64"),
        (&["--from", "0,0,0"], "outside the gem"),
        (&["--from", "1,2"], "three numbers"),
        (&["--view", "B"], "--view: found"),
        (&["--seen", "me"], "eye or camera"),
        (&["--lamps", "sun"], "studio or jeweller"),
        (&["--absorption", "-1"], "--absorption: "),
        (&["--wavelength", "900"], "380 and 780 nm"),
        (&["--out", "gem.jpg"], ".png or .exr"),
        (
            &["--light", "FL2", "--wavelength", "500"],
            "expected one of them",
        ),
        (&["--view", "A", "--angle", "9"], "expected one of them"),
    ] {
        let words = gem(args);
        let mut words: Vec<&str> = words.iter().map(String::as_str).collect();
        if args[0] == "--rays" || args[0] == "--size" {
            words.truncate(3);
        }
        let (err, code) = refusal(&words);
        assert_eq!(code, 2, "{args:?}: {err}");
        assert!(err.contains(part), "{args:?}: {err}");
    }
}

#[test]
fn a_gem_under_a_bulb_is_white_to_the_eye_and_orange_to_a_camera() {
    let folder = tempfile::tempdir().expect("a folder");
    let corner = |seen: &[&str]| {
        let png = folder.path().join("gem.png");
        // As many rays as every wavelength needs.
        let small = ["gem", "--size", "16", "--rays", "64"];
        let more = ["--light", "CIE A", "--out", word(&png)];
        let (code, _, err) = tell(&[&small[..], &more, seen].concat());
        assert_eq!(code, 0, "{err}");
        let file = fs::read(&png).expect("a picture");
        let mut reader = png::Decoder::new(std::io::Cursor::new(file))
            .read_info()
            .expect("PNG");
        let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
        reader.next_frame(&mut pixels).expect("a frame");
        // The dome alone.
        [pixels[0], pixels[2]]
    };
    let [red, blue] = corner(&[]);
    assert!(red.abs_diff(blue) < 6, "{red} {blue}");
    assert_eq!(corner(&["--seen", "eye"]), [red, blue]);
    let [red, blue] = corner(&["--seen", "camera"]);
    assert!(red > blue + 40, "{red} {blue}");
}

#[test]
fn a_gem_of_a_colour_takes_light_away() {
    let bright = |more: &[&str]| {
        let words = gem(&[&["--wavelength", "650", "--json"], more].concat());
        let told = json(&words.iter().map(String::as_str).collect::<Vec<_>>());
        told["mean"].as_f64().expect("a radiance")
    };
    let clear = bright(&[]);
    let grey = bright(&["--absorption", "0.5"]);
    let green = "isuzu IVG550 (Green filter) 2 mm";
    let green = bright(&["--filter", green, "--thickness", "2"]);
    assert!(
        grey < 0.8 * clear && green < 0.8 * clear,
        "{clear} {grey} {green}"
    );
    assert_eq!(bright(&["--absorption", "0"]), clear);
}

#[test]
fn what_changes_nothing_is_said() {
    let (_, _, err) = told_of_gem(&["--wavelength", "589.3", "--order", "3", "--stops", "1"]);
    assert!(err.contains("--stops is not used"), "{err}");
    assert!(err.contains("--order is not used"), "{err}");
    let (_, _, err) = told_of_gem(&["--seen", "camera"]);
    assert!(err.contains("--seen is not used"), "{err}");
}

/// A file of refractiveindex.info with rows of um, n and k.
fn yaml(folder: &Path, name: &str, rows: &str) -> String {
    let path = folder.join(name);
    let text =
        format!("REFERENCES: \"A. Author\"\nDATA:\n  - type: tabulated nk\n    data: |\n{rows}");
    fs::write(&path, text).expect("a file");
    word(&path).to_owned()
}

#[test]
fn metals_are_refused_by_prism_rainbow_and_gem_with_n_and_k() {
    let folder = tempfile::tempdir().expect("a folder");
    let rows = "        0.3 1.5 5\n        0.5 1.6 5\n        0.9 1.7 5\n";
    let metal = yaml(folder.path(), "metal.yml", rows);
    // Gold by Johnson and Christy 1972: n is below 1 from 500 nm on.
    let rows = "        0.3757 1.46 1.933\n        0.4959 1.04 1.833\n        0.6168 0.21 2.897\n        \
        0.8211 0.16 4.902\n";
    let gold = yaml(folder.path(), "gold.yml", rows);
    for (material, part) in [
        (&metal, "k 5.0000 at 380 nm"),
        (&gold, "k 1.9294 at 380 nm"),
    ] {
        for command in [&["prism", "CIE D65"][..], &["rainbow", "CIE D65"], &["gem"]] {
            for more in [&[][..], &["--json"]] {
                let args = [command, &["--material", material], more].concat();
                let (err, code) = refusal(&args);
                assert_eq!(code, 1, "{err}");
                assert!(err.contains("expected a transparent material"), "{err}");
                assert!(err.contains(part), "{err}");
            }
        }
    }
    // At 589 nm gold's n of .5 is told, not where its table ends.
    let (err, _) = refusal(&["gem", "--wavelength", "700", "--material", &gold]);
    assert!(
        err.contains("found n 0.1") && err.contains("at 700 nm"),
        "{err}"
    );
    // A glass that is opaque in the violet alone takes a lamp that has none there.
    let rows = "        0.38 1.8 0.01\n        0.42 1.7 0\n        0.78 1.6 0\n";
    let glass = yaml(folder.path(), "glass.yml", rows);
    let args = ["gem", "--material", &glass, "--wavelength", "589"];
    assert_eq!(tell(&[&args[..], &SMALL].concat()).0, 0);
}

#[test]
fn a_light_is_sent_through_as_measured_unless_its_model_is_asked_for() {
    for command in [&["prism", "FL2"][..], &["rainbow", "FL2"]] {
        assert_eq!(
            json(&[command, &["--json"]].concat())["light_as"],
            "measured"
        );
        let modelled = json(&[command, &["--as-modelled", "--json"]].concat());
        assert_eq!(modelled["light_as"], "model");
    }
    let mean = |more: &[&str]| -> Vec<f64> {
        let args = [&["gem", "--light", "FL2", "--json"], &SMALL[..], more].concat();
        let told = json(&args);
        let mean = told["mean"].as_array().expect("three numbers").iter();
        mean.filter_map(Value::as_f64).collect()
    };
    // A model of order 0 is a flat line beside the spikes: bluer than a warm phosphor.
    let bluer = |mean: Vec<f64>| mean[2] / mean[1];
    assert!(
        bluer(mean(&["--order", "0", "--as-modelled"])) > 1.05 * bluer(mean(&["--order", "0"]))
    );
    assert_eq!(mean(&["--order", "0"]), mean(&["--order", "7"]));
}

#[test]
fn a_gem_looks_the_same_whatever_unit_its_light_is_told_in() {
    let folder = tempfile::tempdir().expect("a folder");
    let mean = |power: i32| -> Vec<f64> {
        let path = folder.path().join(format!("lamp{power}.csv"));
        let row = |nm: u32| format!("{nm},{}e{power}\n", 1.0 + f64::from(nm % 50) / 50.0);
        let rows: String = (380..=780).step_by(5).map(row).collect();
        fs::write(&path, format!("nm,light\n{rows}")).expect("a file");
        let args = [&["gem", "--light", word(&path), "--json"], &SMALL[..]].concat();
        let told = json(&args);
        let mean = told["mean"].as_array().expect("three numbers").iter();
        mean.filter_map(Value::as_f64).collect()
    };
    let usual = mean(0);
    assert!(usual[1] > 0.01, "{usual:?}");
    // From 1e30 on a number counts as missing.
    for power in [-300, -30, 25, 29] {
        // The same sums in single precision, in another order of magnitude.
        let found = mean(power);
        let off = usual.iter().zip(&found).map(|(a, b)| (a / b - 1.0).abs());
        assert!(
            off.fold(0.0, f64::max) < 1e-5,
            "{power}: {found:?} {usual:?}"
        );
    }
}

#[test]
fn a_gem_of_1024_pixels_is_opened_again_by_the_program_that_wrote_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("gem.exr");
    let (code, _, err) = tell(&["gem", "--size", "1024", "--rays", "1", "--out", word(&path)]);
    assert_eq!(code, 0, "{err}");
    let told = json(&["read", word(&path), "--json"]);
    let image = &told[0]["images"][0];
    assert_eq!(
        (&image["width"], &image["height"], &image["bands"]),
        (&1024.into(), &1024.into(), &40.into())
    );
}
