//! `light`: figures of lights and of their models, of presets, files and folders.

use std::{ffi::OsString, fs, path::Path};

use serde_json::Value;
use spectral_explorer::{
    app::{App, Command, Library, Settings, workspace},
    cli::{self, Outcome},
};
use tempfile::TempDir;

/// What the command did.
struct Told {
    code: u8,
    out: String,
    err: String,
}

fn tell(args: &[&str]) -> Told {
    let words = [cli::PROGRAM, "light"];
    let words = words.iter().chain(args).map(OsString::from);
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let outcome = cli::run(words, None, &mut out, &mut err);
    let Outcome::Done(code) = outcome else {
        panic!("{outcome:?}");
    };
    Told {
        code,
        out: String::from_utf8(out).expect("UTF-8"),
        err: String::from_utf8(err).expect("UTF-8"),
    }
}

/// What the command prints when it works.
#[track_caller]
fn said(args: &[&str]) -> String {
    let told = tell(args);
    assert_eq!(told.code, 0, "{}", told.err);
    told.out
}

#[track_caller]
fn json(args: &[&str]) -> Value {
    // JSON knows neither NaN nor infinity: text with either would not be read.
    serde_json::from_str(&said(&[args, &["--json"]].concat())).expect("JSON")
}

/// The one line with which the command is refused.
#[track_caller]
fn refusal(code: u8, args: &[&str]) -> String {
    let told = tell(args);
    assert_eq!((told.code, told.out.as_str()), (code, ""), "{}", told.err);
    assert_eq!(told.err.lines().count(), 1, "{}", told.err);
    assert!(told.err.contains("expected"), "{}", told.err);
    told.err
}

fn number(value: &Value) -> f64 {
    value
        .as_f64()
        .unwrap_or_else(|| panic!("no number: {value}"))
}

#[track_caller]
fn near(value: &Value, expected: f64, within: f64) {
    let found = number(value);
    assert!(
        (found - expected).abs() <= within,
        "{found}, not {expected}"
    );
}

/// A file in a folder, by its path in words.
fn put(folder: &TempDir, name: &str, content: impl AsRef<[u8]>) -> String {
    let path = folder.path().join(name);
    fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
    fs::write(&path, content).expect("a file");
    path.to_str().expect("UTF-8").to_owned()
}

fn folder() -> TempDir {
    tempfile::tempdir().expect("a folder")
}

fn words(path: &Path) -> &str {
    path.to_str().expect("UTF-8")
}

/// A table of 380-780 nm under a head line.
fn table(head: &str, row: impl Fn(f64) -> String) -> String {
    let nm = (0..=80).map(|i| 380.0 + 5.0 * f64::from(i));
    let rows = nm.map(|nm| format!("{nm},{}\n", row(nm)));
    format!("{head}\n{}", rows.collect::<String>())
}

/// A light in W m-2 nm-1.
fn lamp() -> String {
    table("nm,irradiance (W/m2/nm)", |nm| (nm / 500.0).to_string())
}

/// A filter that says so.
fn filter() -> String {
    table("nm,Transmittance [%]", |nm| (nm / 10.0).to_string())
}

#[test]
fn a_shipped_light_has_the_figures_that_other_programs_find() {
    let fl2 = json(&["cie_fluorescent_5nm/FL2"]);
    assert_eq!(fl2["name"], "FL2");
    // Two other libraries' values; the tolerances are those of the golden tests.
    near(&fl2["cct"], 4225.14, 0.1);
    near(&fl2["duv"], 0.001_862_6, 1e-6);
    near(&fl2["ra"], 64.232, 0.15);
    near(&fl2["rf"], 70.207_8, 0.05);
    near(&fl2["rg"], 86.438_3, 0.05);
    near(&fl2["ler"], 336.645, 0.002);
    near(&fl2["dominant_nm"], 577.075_2, 0.01);
    near(&fl2["purity"], 0.242_836, 1e-4);
    near(&fl2["sp_ratio"], 1.572_5, 0.002);
    near(&fl2["melanopic_der"], 0.569_904, 2e-4);
    near(&fl2["ppfd_per_100lx"], 1.308_405, 5e-5);
    near(&fl2["ssi"]["value"], 61.748_6, 0.1);
    assert_eq!(fl2["ssi"]["reference"], "D4225");
    assert_eq!(fl2["hue_bins"].as_array().map(Vec::len), Some(16));
    assert_eq!(fl2["r"].as_array().map(Vec::len), Some(15));
}

#[test]
fn the_model_is_that_of_the_options_and_comes_nearer_with_every_number() {
    let off = |order: &str, key: &str| {
        let light = json(&["FL2", "--order", order]);
        (number(&light[key]) - number(&light["model"][key])).abs()
    };
    for (key, within) in [("ra", 0.5), ("rf", 0.5), ("melanopic_der", 0.005)] {
        let (few, many) = (off("1", key), off("40", key));
        assert!(many < few && many < within, "{key}: {few}, {many}");
    }
    // Without a word it is the program's usual model, and other options make another one.
    let [usual, told, plain] = [
        &["FL2"][..],
        &["FL2", "--order", "7", "--threshold", "0.5"],
        &["FL2", "--no-spikes"],
    ]
    .map(|args| json(args)["model"].clone());
    assert_eq!(usual, told);
    assert_ne!(usual["ra"], plain["ra"]);
    let exact = json(&["FL2", "--colour-exact"]);
    // Colour-exact on 380-780 nm; beyond is less than 1e-4 of the luminance.
    near(&exact["model"]["cct"], number(&exact["cct"]), 1.0);
}

#[test]
fn words_tell_every_figure_beside_the_models_and_what_it_means() {
    let told = said(&["cie_led_5nm/LED-B3"]);
    for part in [
        "LED-B3 (light, 81 points, 380-780 nm",
        "Model: cosine order 7 on 380-780 nm",
        "measured",
        "CCT ",
        "4102 K",
        "neutral white; may be sold as 4000 K",
        "strong red looks wrong: R9 24, duller",
        "Melanopic DER",
        "PPFD of 100 lx",
        "TLCI is left out: the camera and sample tables of EBU Tech 3355 are not openly licensed",
    ] {
        assert!(told.contains(part), "{part}: {told}");
    }
    let ra = told
        .lines()
        .find(|line| line.starts_with("Ra "))
        .expect("Ra");
    assert_eq!(ra.split_whitespace().nth(1), Some("84.8"), "{ra}");
    let model = ra.split_whitespace().nth(2).expect("of the model");
    assert!(model.parse::<f64>().is_ok(), "{ra}");
}

#[test]
fn several_lights_are_a_table_or_a_list_in_the_order_given() {
    let list = json(&["FL2", "CIE D65", "fl11"]);
    let names: Vec<_> = list.as_array().expect("a list").iter().collect();
    let names = names
        .iter()
        .map(|light| light["name"].as_str().expect("a name"));
    assert!(names.eq(["FL2", "CIE D65", "fl11"]));
    assert_eq!(list[0], json(&["FL2"]));
    let table = said(&["FL2", "CIE D65"]);
    let lines: Vec<&str> = table.lines().collect();
    assert_eq!(lines.len(), 3);
    assert!(lines[0].starts_with("name,x,y,u_prime,v_prime,cct,duv,"));
    let column = |line: &str, key: &str| -> f64 {
        let place = lines[0].split(',').position(|k| k == key).expect(key);
        let cell = line.split(',').nth(place).expect("a cell");
        cell.parse().unwrap_or_else(|_| panic!("{key}: {cell}"))
    };
    for (line, light) in lines[1..].iter().zip(list.as_array().expect("a list")) {
        for key in ["cct", "ra", "rf", "melanopic_der"] {
            assert_eq!(column(line, key), number(&light[key]), "{key}");
            let of_model = column(line, &format!("model_{key}"));
            assert_eq!(of_model, number(&light["model"][key]), "{key}");
        }
    }
    // One light too, when it is asked for.
    let one = said(&["FL2", "--csv"]);
    assert_eq!(one.lines().collect::<Vec<_>>(), lines[..2]);
}

#[test]
fn a_file_means_all_its_lights_and_a_sign_one_of_them() {
    let folder = folder();
    let three = table("nm,warm,cool,warm", |nm| {
        format!("{},{},{}", nm * nm, 1e7 / nm, nm)
    });
    let file = put(&folder, "three.csv", three);
    let list = json(&[&file]);
    let name = |index: usize| list[index]["name"].as_str().expect("a name").to_owned();
    let names: Vec<String> = (0..3).map(name).collect();
    let expected = ["#1", "#cool", "#3"].map(|at| format!("{file}{at}"));
    // Readers may tell columns of one name apart themselves.
    assert_eq!(names[1], expected[1]);
    for (index, name) in names.iter().enumerate() {
        let again = json(&[name]);
        assert_eq!(again["cct"], list[index]["cct"], "{name}");
    }
    // What is no light beside lights is told, and refused where it is alone.
    let two = table(
        "nm,lamp (W/m2/nm),R1 Reflectance [%],R2 Reflectance [%]",
        |nm| format!("{nm},50,60"),
    );
    let mixed = tell(&[&put(&folder, "mixed.csv", two), "--json"]);
    assert_eq!(mixed.code, 0, "{}", mixed.err);
    assert!(
        mixed.err.contains("found 2 spectra that are no lights"),
        "{}",
        mixed.err
    );
    let second = json(&[&format!("{file}#2")]);
    assert_eq!(
        (&second["name"], &second["cct"]),
        (&"cool".into(), &list[1]["cct"])
    );
}

#[test]
fn a_folder_is_every_light_in_it_and_the_rest_is_told() {
    let folder = folder();
    put(&folder, "lamps/a.csv", lamp());
    put(
        &folder,
        "lamps/b/warm.csv",
        table("nm,W/m2/nm", |nm| (nm * nm).to_string()),
    );
    put(&folder, "lamps/c glass.csv", filter());
    put(&folder, "lamps/notes.txt", "bought in May\n");
    let lamps = folder.path().join("lamps");
    let lamps = words(&lamps);
    let told = tell(&[lamps, "--json"]);
    assert_eq!(told.code, 0, "{}", told.err);
    let list: Value = serde_json::from_str(&told.out).expect("JSON");
    let names: Vec<_> = list
        .as_array()
        .expect("a list")
        .iter()
        .map(|l| &l["name"])
        .collect();
    assert_eq!(names, ["lamps/a.csv", "lamps/b/warm.csv"]);
    for words in [
        "skipped: lamps/c glass.csv: found transmittance values, expected a light",
        "skipped: lamps/notes.txt, line 1: found no table",
        ": 2 lights in 4 files",
    ] {
        assert!(told.err.contains(words), "{words}: {}", told.err);
    }
    // Each is as it is alone, and a preset may stand beside the folder.
    let alone = json(&[words(&folder.path().join("lamps/a.csv"))]);
    assert_eq!(alone["model"]["rf"], list[0]["model"]["rf"]);
    let table = said(&[lamps, "CIE A"]);
    let firsts: Vec<&str> = table.lines().filter_map(|l| l.split(',').next()).collect();
    assert_eq!(firsts, ["name", "lamps/a.csv", "lamps/b/warm.csv", "CIE A"]);
    // A folder of one light is a list too.
    let one = json(&[words(&folder.path().join("lamps/b"))]);
    assert_eq!(one.as_array().map(Vec::len), Some(1));
}

#[test]
fn numbers_that_do_not_say_what_they_are_are_a_light_here() {
    let folder = folder();
    // Such numbers would be taken for a reflectance.
    let plain = table("nm,value", |nm| (nm / 1000.0).to_string());
    let file = put(&folder, "lamps/plain.csv", plain);
    let told = tell(&[&file, "--json"]);
    assert_eq!(told.code, 0, "{}", told.err);
    assert!(told.err.contains("taken as a light"), "{}", told.err);
    let alone: Value = serde_json::from_str(&told.out).expect("JSON");
    let among = tell(&[words(&folder.path().join("lamps")), "--json"]);
    let among_others: Value = serde_json::from_str(&among.out).expect("JSON");
    assert_eq!(among_others[0]["cct"], alone["cct"]);
    assert!(among.err.contains("taken as lights"), "{}", among.err);
}

#[test]
fn a_unit_of_power_or_photons_gives_lux_and_ppfd() {
    let folder = folder();
    let full = |file: &str| json(&[file, "--full"]);
    let watts = full(&put(&folder, "watts.csv", lamp()));
    let absolute = &watts["absolute"];
    assert_eq!(absolute["unit"], "lx");
    let per_100 = number(&watts["ppfd_per_100lx"]);
    // Sums of the same products in another order.
    let expected = number(&absolute["value"]) * per_100 / 100.0;
    near(&absolute["ppfd"], expected, 1e-9 * expected);
    assert_eq!(absolute["ppfd"], watts["absolute"]["ppfd"]);
    // The same light counted in photons.
    let photons = table("nm,PFD (µmol m-2 s-1 nm-1)", |nm| {
        (nm / 500.0 * nm / 119.626_565_8).to_string()
    });
    let photons = full(&put(&folder, "photons.csv", photons));
    // The constant is given to nine figures here.
    let lux = number(&absolute["value"]);
    near(&photons["absolute"]["value"], lux, 1e-8 * lux);
    let relative = full("FL2");
    assert_eq!(relative["absolute"], Value::Null);
    let reasons = relative["reasons"].as_array().expect("reasons");
    let lux = reasons
        .iter()
        .find(|reason| reason["key"] == "lux")
        .expect("lux");
    assert!(
        lux["why"].as_str().expect("words").contains("unit"),
        "{lux}"
    );
    assert_eq!(relative["rf_samples"].as_array().map(Vec::len), Some(99));
}

#[test]
fn melanopic_edi_and_photons_are_told_of_irradiance_alone() {
    let folder = folder();
    for (unit, quantity) in [
        ("radiance (W/sr/m2/nm)", "luminance"),
        ("radiant flux (W/nm)", "luminous flux"),
        ("irradiance (W/m2/nm)", "illuminance"),
    ] {
        let text = table(&format!("nm,{unit}"), |nm| (nm / 500.0).to_string());
        let absolute = json(&[&put(&folder, "a.csv", text), "--full"])["absolute"].clone();
        assert_eq!(absolute["quantity"], quantity);
        assert!(absolute["value"].is_number(), "{absolute}");
        for key in ["melanopic_edi", "ppfd", "eppfd"] {
            let is_told = absolute[key].is_number();
            assert_eq!(is_told, quantity == "illuminance", "{unit} {key}");
        }
    }
}

#[test]
fn a_light_without_figures_answers_in_words() {
    let folder = folder();
    let of = |name: &str, rows: &str| {
        let text = format!("nm,irradiance (W/m2/nm)\n{rows}");
        json(&[&put(&folder, name, text)])
    };
    let dark = of("dark.csv", "380,0\n500,0\n780,0\n");
    let infrared = of("infrared.csv", "900,1\n950,2\n1000,1\n");
    for (light, why) in [
        (&dark, "every value is zero"),
        (&infrared, "no light between"),
    ] {
        for key in ["cct", "ra", "rf", "ler", "melanopic_der", "xyz"] {
            assert_eq!(light[key], Value::Null, "{key}");
        }
        let notes = light["notes"].to_string();
        assert!(notes.contains(why) && notes.contains("ra, r: "), "{notes}");
    }
    let line = of("line.csv", "531,0\n532,1\n533,0\n");
    near(&line["dominant_nm"], 532.0, 0.5);
    assert_eq!((&line["cct"], &line["rf"]), (&Value::Null, &Value::Null));
    let words = said(&[words(&folder.path().join("dark.csv"))]);
    assert!(words.contains("every value is zero"), "{words}");
}

#[test]
fn a_project_is_its_light_under_its_own_settings() {
    let folder = folder();
    let mut app = App::new();
    app.apply(Command::Edit(Settings {
        order: 11,
        ..app.document().settings
    }));
    let name = app.document().light.name().to_owned();
    let text = workspace::to_json(app.document(), None).expect("JSON");
    let file = put(&folder, "lesson.json", text);
    let of_project = json(&[&file]);
    assert_eq!(of_project["name"], name.as_str());
    let same = json(&[&name, "--order", "11"]);
    assert_eq!(of_project["model"]["ra"], same["model"]["ra"]);
    let other = json(&[&file, "--order", "4"]);
    assert_ne!(of_project["model"]["ra"], other["model"]["ra"]);
}

#[test]
fn what_is_no_light_is_refused_in_one_line() {
    let folder = folder();
    let glass = put(&folder, "only/glass.csv", filter());
    let only = folder.path().join("only");
    let empty = folder.path().join("empty");
    fs::create_dir(&empty).expect("a folder");
    for (args, found) in [
        (
            &["colorchecker_ohta/red"][..],
            "found reflectance values, expected a light",
        ),
        (&[&*glass], "found transmittance values, expected a light"),
        (&["gone.csv"], "gone.csv: found no such file"),
        (&["gone.csv#2"], "gone.csv: found no such file"),
        (&[words(&empty)], "found no file in it"),
    ] {
        let line = refusal(1, args);
        assert!(line.contains("INPUT: ") && line.contains(found), "{line}");
    }
    let told = tell(&["FL99"]);
    assert_eq!((told.code, told.err.lines().count()), (1, 1));
    assert!(told.err.contains("close to it: FL9"), "{}", told.err);
    let told = tell(&[words(&only)]);
    assert_eq!((told.code, told.out.as_str()), (1, ""));
    let last = told.err.lines().last().expect("a line");
    assert!(
        last.contains("found no light in 1 file, expected at least one"),
        "{last}"
    );
    for (args, found) in [
        (&["FL2", "--csv", "--json"][..], "together with"),
        (&["FL2", "--full"], "found no --json"),
        (&[], "found no INPUT"),
        (&["FL2", "--order", "many"], "--order: found \"many\""),
    ] {
        let line = refusal(2, args);
        assert!(line.contains(found), "{line}");
    }
}

#[test]
fn what_is_refused_does_not_stop_the_others() {
    let told = tell(&["FL2", "gone.csv", "CIE A", "colorchecker_ohta/red"]);
    assert_eq!(told.code, 1);
    let firsts: Vec<&str> = told
        .out
        .lines()
        .filter_map(|l| l.split(',').next())
        .collect();
    assert_eq!(firsts, ["name", "FL2", "CIE A"]);
    assert_eq!(told.err.lines().count(), 2, "{}", told.err);
    assert!(
        told.err.contains("gone.csv: found no such file"),
        "{}",
        told.err
    );
    // What was left of two is a table as two would be.
    let told = tell(&["FL2", "gone.csv", "--json"]);
    let list: Value = serde_json::from_str(&told.out).expect("JSON");
    assert_eq!(list.as_array().map(Vec::len), Some(1));
}

#[test]
fn options_that_change_nothing_are_told() {
    let told = tell(&[
        "FL2",
        "--plain",
        "--observer",
        "1964",
        "--sampling",
        "3n",
        "--json",
    ]);
    assert_eq!(told.code, 0);
    for option in ["--observer is not used", "--sampling is not used"] {
        assert!(told.err.contains(option), "{}", told.err);
    }
    let exact = tell(&["FL2", "--observer", "1964", "--json"]);
    assert_eq!(exact.err, "");
}

#[test]
fn the_similarity_of_a_model_does_not_hang_on_the_scale_of_the_values() {
    let folder = TempDir::new().expect("a folder");
    let file = folder.path().join("lamp.csv");
    for name in ["HP1", "HP3"] {
        let lamp = Library::bundled().find(name).expect("it is shipped");
        let table = &lamp.spectrum().expect("a table").samples;
        let found = [1.0, 1e-6, 1e3, 1e12].map(|scale| {
            let pairs = table.nm().iter().zip(table.values());
            let rows: String = pairs
                .map(|(nm, v)| format!("{nm},{:e}\n", v * scale))
                .collect();
            // Whole numbers without a unit would be an instrument's counts.
            fs::write(&file, format!("nm,lamp (W/m2/nm)\n{rows}")).expect("a table");
            let said = said(&[file.to_str().expect("UTF-8"), "--json"]);
            let told: Value = serde_json::from_str(&said).expect("JSON");
            let [model, lamp] = [&told["model"]["ssi"]["value"], &told["ssi"]["value"]];
            [model, lamp].map(|v| v.as_f64().expect("a number"))
        });
        for other in &found[1..] {
            for (one, other) in found[0].iter().zip(other) {
                // A line on the border of two bands moves by rounding, and so does the figure.
                assert!((one - other).abs() < 1e-6, "{name}: {found:?}");
            }
        }
    }
}
