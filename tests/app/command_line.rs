//! docs/command_line.md tells the truth: commands, options with their defaults, keys of JSON.

use std::{
    collections::{BTreeMap, BTreeSet},
    ffi::OsString,
    fs,
    path::Path,
};

use crate::cli_combine;
use crate::cli_photo::Drawn;
use crate::cli_pictures::wall;
use crate::docs::{document, quoted, rows, section};
use serde_json::Value;
use spectral_explorer::{
    app::pages::Page,
    cli::{self, Outcome},
    color::Observer,
    io::png,
    optics::BuiltinMaterial,
    spectrum::{Basis, Sampling},
};

const DOCUMENT: &str = "docs/command_line.md";

/// The options that several commands take, by their headings.
const SHARED: [&str; 3] = [
    "### Which spectrum",
    "### How files are read",
    "### The model",
];

/// What a command that works prints.
fn printed(args: &[&str]) -> String {
    let words = std::iter::once(&cli::PROGRAM).chain(args);
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let outcome = cli::run(words.map(OsString::from), None, &mut out, &mut err);
    let err = String::from_utf8_lossy(&err);
    assert_eq!(outcome, Outcome::Done(0), "{args:?}: {err}");
    String::from_utf8(out).expect("UTF-8")
}

/// The help of a command; of the program without one.
fn help(command: &str) -> String {
    match command {
        "" => printed(&["--help"]),
        command => printed(&[command, "--help"]),
    }
}

/// Every command of the program.
fn commands() -> BTreeSet<String> {
    help("")
        .lines()
        .skip_while(|line| *line != "Commands:")
        .skip(1)
        .take_while(|line| !line.is_empty())
        .filter_map(|line| line.strip_prefix("  "))
        // Lines that go on are further in.
        .filter(|line| !line.starts_with(' '))
        .filter_map(|line| line.split_whitespace().next())
        .filter(|command| *command != "help")
        .map(str::to_owned)
        .collect()
}

/// The options of a help, but for those that every command has.
fn options(help: &str) -> BTreeSet<String> {
    help.lines()
        .filter_map(|line| line.strip_prefix("      --"))
        .filter_map(|line| line.split_whitespace().next())
        .map(|option| format!("--{option}"))
        .collect()
}

/// The option that a row is about, without its value.
fn option(row: &[&str]) -> Option<String> {
    let words = quoted(row[0]);
    let option = words.first()?.split_whitespace().next()?;
    Some(option.to_owned())
}

#[test]
fn every_command_is_told_and_no_other() {
    let document = document(DOCUMENT);
    let told: BTreeSet<String> = rows(section(&document, "## Commands"))
        .iter()
        .filter_map(|row| option(row))
        .collect();
    let known = commands();
    assert!(known.len() > 5, "{known:?}");
    assert_eq!(told, known);
}

#[test]
fn the_points_that_3n_stands_for_are_told_as_they_are() {
    let points = [6, 7].map(|order| Sampling::ThreeN.points(2 * order + 1));
    assert_eq!(points, [Some(3 * 6 + 1), Some(3 * 7 + 2)]);
    for text in [help("product"), document(DOCUMENT)] {
        assert!(text.contains("3N+1") && text.contains("3N+2"), "{text}");
    }
}

#[test]
fn every_option_of_every_command_is_told_and_no_other() {
    let document = document(DOCUMENT);
    let mut told: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for heading in SHARED {
        let text = section(&document, heading);
        let takers = text.lines().find(|line| line.starts_with("Taken by "));
        for taker in quoted(takers.expect("who takes them")) {
            let options = told.entry(taker.to_owned()).or_default();
            options.extend(rows(text).iter().filter_map(|row| option(row)));
        }
    }
    for row in rows(section(&document, "### Of one command")) {
        let Some(option) = option(&row) else {
            continue;
        };
        let mut takers = quoted(row[1]);
        if takers.is_empty() {
            // The program without a command.
            takers.push("");
        }
        for taker in takers {
            let options = told.entry(taker.to_owned()).or_default();
            options.insert(option.clone());
        }
    }
    let known: BTreeMap<String, BTreeSet<String>> = commands()
        .into_iter()
        .chain([String::new()])
        .map(|command| {
            let options = options(&help(&command));
            (command, options)
        })
        .collect();
    for (command, options) in &known {
        // One without options has no row.
        let told = told.get(command).cloned().unwrap_or_default();
        assert_eq!(told, *options, "{command}");
    }
    for command in told.keys() {
        assert!(known.contains_key(command), "no command {command}");
    }
}

#[test]
fn the_defaults_are_those_of_the_help() {
    let document = document(DOCUMENT);
    let help = help("report");
    let words: Vec<&str> = help.split_whitespace().collect();
    let help = words.join(" ");
    let mut defaults = 0;
    for heading in SHARED {
        for row in rows(section(&document, heading)) {
            if option(&row).is_some() && !row[2].is_empty() {
                defaults += 1;
                let words = format!("[default: {}]", row[2]);
                assert!(help.contains(&words), "{}: not {words}", row[0]);
            }
        }
    }
    assert!(defaults > 5, "only {defaults} defaults were found");
}

#[test]
fn every_page_can_be_named() {
    let pages = document("docs/window.md");
    let help = help("render");
    let help: Vec<&str> = help.split_whitespace().collect();
    let (_, help) = help.split_at(help.iter().position(|w| *w == "--page").expect("--page"));
    for page in Page::all() {
        let (title, word) = (page.title(), page.word());
        let named = format!("- **{title}** (`{word}`): ");
        assert!(pages.contains(&named), "{named}");
        let told = help.iter().any(|w| w.trim_matches([',', ';']) == word);
        assert!(told, "the help does not tell {word}");
    }
}

#[test]
fn the_words_of_bases_observers_and_materials_are_told_in_the_document_and_the_help() {
    let document = document(DOCUMENT);
    let holds_all = |text: &str, words: &[&str]| {
        let found: Vec<&str> = text.split([' ', ',', '(', ')', ';', '\n']).collect();
        for word in words {
            assert!(found.contains(word), "{word}: {text}");
        }
    };
    let told = rows(section(&document, "### The model"));
    let told = |name: &str| {
        let row = told.iter().find(|row| option(row).as_deref() == Some(name));
        row.expect("a row")[1]
    };
    let helped = |command: &str, name: &str| {
        let help = help(command);
        let (_, from) = help.split_once(&format!("{name} <")).expect("the option");
        let (text, _) = from.split_once("--").unwrap_or((from, ""));
        text.to_owned()
    };
    let bases = Basis::ALL.map(Basis::word);
    holds_all(told("--basis"), &bases);
    holds_all(&helped("report", "--basis"), &bases);
    let observers = Observer::CIE.map(Observer::word);
    holds_all(told("--observer"), &observers);
    holds_all(&helped("report", "--observer"), &observers);
    let materials = BuiltinMaterial::ALL.map(BuiltinMaterial::word);
    let (_, told) = document
        .split_once("A MATERIAL is a word")
        .expect("it is told");
    holds_all(told.lines().next().expect("a line"), &materials);
    for command in ["prism", "gem"] {
        holds_all(&helped(command, "--material"), &materials);
    }
}

/// What stands for several keys, spelt out: `a.{b,c}` is `a.b` and `a.c`.
fn spelt_out(keys: &str) -> Vec<String> {
    let Some((before, rest)) = keys.split_once('{') else {
        return vec![keys.to_owned()];
    };
    let (choices, after) = rest.split_once('}').expect("a brace that is closed");
    choices
        .split(',')
        .flat_map(|choice| spelt_out(&format!("{before}{choice}{after}")))
        .collect()
}

/// The keys that the document tells of under a heading.
fn told_keys(heading: &str) -> BTreeSet<String> {
    let document = document(DOCUMENT);
    let rows = rows(section(&document, &format!("### `{heading}`")));
    let words = rows.iter().flat_map(|row| quoted(row[0]));
    words.flat_map(spelt_out).collect()
}

/// Adds every key of some JSON with what leads to it. A list of numbers or words, or of lists of
/// them, counts as one value.
fn add_keys(value: &Value, path: &str, found: &mut BTreeSet<String>) {
    match value {
        Value::Object(object) => {
            let dot = if path.is_empty() { "" } else { "." };
            for (key, value) in object {
                add_keys(value, &format!("{path}{dot}{key}"), found);
            }
        }
        Value::Array(items) if items.iter().any(Value::is_object) => {
            for item in items {
                add_keys(item, &format!("{path}[]"), found);
            }
        }
        _ => {
            found.insert(path.to_owned());
        }
    }
}

/// Every key that the examples print is told under the heading, and every key told is printed by
/// one of them.
fn holds(heading: &str, examples: &[&[&str]]) {
    let (told, of_report) = (told_keys(heading), told_keys("report --json"));
    let mut found = BTreeSet::new();
    for args in examples {
        let value: Value = serde_json::from_str(&printed(args)).expect("JSON");
        add_keys(&value, "", &mut found);
    }
    for key in &found {
        let is_it = |told: &String| match told.strip_suffix('*') {
            Some(start) => key.starts_with(start) && of_report.contains(key),
            // Of an empty list nobody sees the keys.
            None => told == key || told.starts_with(&format!("{key}[]")),
        };
        assert!(
            told.iter().any(is_it),
            "{heading} prints {key}, and {DOCUMENT} does not tell of it"
        );
    }
    for key in &told {
        let is_there = match key.strip_suffix('*') {
            Some(start) => found.iter().any(|found| found.starts_with(start)),
            None => found.contains(key),
        };
        assert!(
            is_there,
            "{DOCUMENT} tells of {key}, and {heading} does not print it"
        );
    }
}

/// A file of an example, and its path in words.
fn put(folder: &Path, name: &str, content: impl AsRef<[u8]>) -> String {
    let path = folder.join(name);
    fs::write(&path, content).expect(name);
    path.to_str().expect("UTF-8").to_owned()
}

/// What a lamp meter writes, with results of its own.
fn meter(folder: &Path) -> String {
    let text = "Model Name\tLI-180\nPPFD\t5.5\nIRR\t0.03\n380nm\t1\n390nm\t1.5\n400nm\t2\n\
                500nm\t3\n600nm\t4\n700nm\t2\nCCT\t5465.0\n";
    put(folder, "meter.txt", text)
}

/// A light whose top is cut.
fn cut_lamp(folder: &Path) -> String {
    let value = |nm: f64| (0.5 + 0.5 * (-((nm - 550.0) / 30.0).powi(2)).exp()).min(0.8);
    let rows: String = (380..=780)
        .map(|nm| format!("{nm},{}\n", value(f64::from(nm))))
        .collect();
    put(
        folder,
        "cut.csv",
        format!("nm,irradiance (W/m2/nm)\n{rows}"),
    )
}

#[test]
fn the_keys_of_a_report_are_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let meter = meter(folder.path());
    let cut = cut_lamp(folder.path());
    holds(
        "report --json",
        &[
            &["report", "FL2", "--json"],
            &["report", "FL2", "--as-in-paper", "--json"],
            &[
                "report",
                "solar_astm_g173/ASTM G173-03 extraterrestrial",
                "--json",
            ],
            &["report", &meter, "--json"],
            &["report", &cut, "--json"],
        ],
    );
}

#[test]
fn the_keys_of_a_light_are_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let cut = cut_lamp(folder.path());
    let told = [&["light", "FL2", "--json"][..], &["light", &cut, "--json"]];
    holds("light --json", &told);
    let rows: String = (380..=780).map(|nm| format!("{nm},0.5\n")).collect();
    let rows = format!("nm,irradiance (W/m2/nm)\n{rows}");
    let lamp = put(folder.path(), "lamp.csv", rows);
    let args = ["light", &lamp, "--json", "--full"];
    let of_cut = ["light", &cut, "--json", "--full"];
    holds("light --json --full", &[&args, &of_cut]);
    holds(
        "light --against --json",
        &[
            &["light", "FL2", "--against", "LED-B1", "--json"],
            &["light", &cut, "--against", &cut, "--json"],
        ],
    );
}

#[test]
fn the_csv_of_lights_has_the_keys_that_are_told() {
    let document = document(DOCUMENT);
    let told = section(&document, "### `light --json`");
    let csv = printed(&["light", "FL2", "FL11"]);
    let head = csv.lines().next().expect("a head");
    let keys: Vec<&str> = head.split(',').collect();
    let start = keys.iter().position(|key| key.starts_with("model_"));
    let (of_light, of_model) = keys[1..].split_at(start.expect("of the model") - 1);
    for (key, of_model) in of_light.iter().zip(of_model) {
        assert_eq!(format!("model_{key}"), *of_model);
        let is_special = key
            .strip_prefix('r')
            .is_some_and(|n| n.parse::<u8>().is_ok());
        let is_told = told.contains(&format!("`{key}`"))
            || ["{", ","].iter().any(|before| {
                [",", "}"]
                    .iter()
                    .any(|behind| told.contains(&format!("{before}{key}{behind}")))
            });
        assert!(is_special || is_told, "{key}");
    }
    assert_eq!(keys.last(), Some(&"notes"));
    assert_eq!(keys.len(), 2 + 2 * of_light.len());
}

#[test]
fn the_keys_of_a_frame_are_told() {
    let folder = tempfile::tempdir().expect("a folder");
    // Its top is at the end of 12 bit.
    let value = |nm: u32| (6000.0 * (-((f64::from(nm) - 550.0) / 40.0).powi(2)).exp()).min(4095.0);
    let nm: Vec<u32> = (380..=780).collect();
    let values: Vec<f64> = nm.iter().map(|nm| value(*nm).floor()).collect();
    let line = format!("{{\"wavelength_nm\":{nm:?},\"values\":{values:?}}}\n");
    let run = put(folder.path(), "run.jsonl", line);
    let args = ["follow", &run, "--replay", "step", "--json"];
    holds("follow --json", &[&args]);
}

#[test]
fn the_keys_of_a_sweep_are_told() {
    holds("sweep --json", &[&["sweep", "FL2", "--json"]]);
}

#[test]
fn the_keys_of_an_auction_are_told() {
    // With so many numbers an order and a line are given back on the way.
    let args = ["auction", "FL2", "--goal", "patches", "--numbers", "61"];
    let args: Vec<&str> = args
        .into_iter()
        .chain(["--as-in-paper", "--json"])
        .collect();
    holds("auction --json", &[&args]);
}

#[test]
fn the_keys_of_a_race_are_told() {
    holds(
        "race --json",
        &[&["race", "FL2", "--numbers", "11", "--json"]],
    );
}

#[test]
fn the_keys_of_a_product_are_told() {
    let folder = tempfile::tempdir().expect("a folder");
    // Mercury's yellow pair stands in the middle of the dip.
    let dip = |nm: u32| 0.9 - 0.8 * (-((f64::from(nm) - 578.0) / 3.0).powi(2)).exp();
    let rows: String = (380..=780)
        .map(|nm| format!("{nm},{}\n", dip(nm)))
        .collect();
    let glass = put(folder.path(), "didymium.csv", rows);
    let kind = ["--kind", "transmittance", "--dips", "--sampling", "double"];
    let through_glass: Vec<&str> = ["product", "FL2", &glass, "--json"]
        .into_iter()
        .chain(kind)
        .collect();
    let red = "colorchecker_ohta/red";
    holds(
        "product --json",
        &[&["product", "FL2", red, "--json"], &through_glass],
    );
    holds(
        "product --set --json",
        &[&["product", "FL2", "--set", "cri_tcs", "--json"]],
    );
    holds(
        "product --check --json",
        &[&["product", "FL2", red, "--check", "CIE A", "--json"]],
    );
}

#[test]
fn the_keys_of_a_combination_are_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let scans = cli_combine::scans(folder.path(), 3);
    let mean: Vec<&str> = ["combine", "mean"]
        .into_iter()
        .chain(scans.iter().map(String::as_str))
        .chain(["--json"])
        .collect();
    let mut changed = mean.clone();
    changed[1] = "changed";
    changed.push("--");
    let tilted = cli_combine::tilted(folder.path(), 3);
    changed.extend(tilted.iter().map(String::as_str));
    let quotient = ["combine", "A / B", "FL2", "CIE A", "--json"];
    let over_lines = [
        "combine", "A / B", "CIE A", "FL2", "--axis", "0.1", "--json",
    ];
    let slit = ["combine", "slit", "10", "FL2", "--json"];
    let [lower, upper] = cli_combine::ranges(folder.path());
    let splice = ["combine", "splice", &lower, &upper, "--json"];
    let all = ["combine", "A / B", "FL2", "CIE A", "--keep-all", "--json"];
    let unslit = ["combine", "unslit", "5", "FL2", "--json"];
    let seen = cli_combine::seen(folder.path());
    let auto = ["combine", "unslit", "auto", &seen, "--json"];
    let cut = cut_lamp(folder.path());
    let cut = ["combine", "1*A", &cut, "--json"];
    let learn = [
        "combine",
        "instrument",
        "learn",
        "CIE A",
        "--known",
        "black body 2856 K",
        "--json",
    ];
    let told = [
        &mean[..],
        &changed,
        &quotient,
        &over_lines,
        &slit,
        &splice,
        &all,
        &unslit,
        &auto,
        &cut,
        &learn,
    ];
    holds("combine --json", &told);
}

#[test]
fn the_keys_of_recovered_spectra_are_told() {
    let one = ["recover", "--colour", "#c08040", "--json"];
    let second = ["--second-colour", "#c08040", "--second-light", "CIE A"];
    let two = [&one[..], &second].concat();
    // No surface is so.
    let none = ["recover", "--xyz", "10,90,5", "--json"];
    let lines = [
        "recover", "--colour", "#ffeedd", "--method", "lines", "--json",
    ];
    holds("recover --json", &[&one, &two, &none, &lines]);
    let folder = tempfile::tempdir().expect("a folder");
    let pixels = [[200, 128, 64]; 4];
    let png = png([2, 2], pixels.as_flattened()).expect("a picture");
    let png = put(folder.path(), "photo.png", png);
    let out = folder.path().join("photo.exr");
    let out = out.to_str().expect("UTF-8");
    let image = ["recover", "--image", &png, "--out", out, "--json"];
    holds("recover --image --json", &[&image]);
}

#[test]
fn the_keys_of_a_mixture_are_told() {
    let target = ["--target", "4000K", "--json"];
    let channels = ["line:450", "gauss:540,30", "gauss:620,20"];
    let channels = channels.iter().flat_map(|spec| ["--channel", spec]);
    let args: Vec<&str> = ["mix"].into_iter().chain(channels).chain(target).collect();
    holds("mix --json", &[&args]);
    let front = ["mix", "--front", "ra,ler", "--lines", "3", "--json"];
    holds("mix --front --json", &[&front]);
}

#[test]
fn the_keys_of_a_picture_are_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let wall = wall(folder.path());
    let lined = [
        "picture",
        &wall,
        "--numbers",
        "9",
        "--lines",
        "550",
        "--json",
    ];
    let kept = folder.path().join("wall.exr");
    let kept = kept.to_str().expect("UTF-8");
    let written = ["picture", &wall, "--numbers", "9", "--out", kept, "--json"];
    holds("picture --json", &[&lined, &written]);
    let peers = ["picture", &wall, "--numbers", "9", "--peers", "--json"];
    holds("picture --peers --json", &[&peers]);
    let out = folder.path().join("relit.png");
    let out = out.to_str().expect("UTF-8");
    let relit = [
        "picture",
        kept,
        "--relight",
        "CIE A",
        "--out",
        out,
        "--json",
    ];
    holds("picture --relight --json", &[&relit]);
}

#[test]
fn the_keys_of_a_photograph_are_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let lamp = put(folder.path(), "lamp.png", Drawn::GLOWING.png());
    let bulb = put(folder.path(), "bulb.png", Drawn::BULB.png());
    let kept = folder.path().join("bench.json");
    let kept = kept.to_str().expect("UTF-8");
    // A lamp's own lines tell of the other keys, an instrument of its own.
    let known = ["--response-from", &bulb, "--as", "blackbody:2856"];
    let found = ["photo", &lamp, "--at", "200,95", "--json"];
    let saved = ["--save-instrument", kept];
    printed(&[&found[..], &known[..], &saved[..]].concat());
    let told = told_keys("photo --json");
    let mut seen = BTreeSet::new();
    let darker = put(
        folder.path(),
        "darker.png",
        Drawn::GLOWING.exposed(0.5, 1.0),
    );
    let exposures = [format!("{lamp}:1/30"), format!("{darker}:1/60")];
    for args in [
        [&found[..], &known[..]].concat(),
        [&found[..], &["--instrument", kept]].concat(),
        [&found[..], &["--exposures", &exposures[0], &exposures[1]]].concat(),
    ] {
        let value: Value = serde_json::from_str(&printed(&args)).expect("JSON");
        add_keys(&value, "", &mut seen);
    }
    // Where nothing is known of a whole object, its own key is null.
    let is_told = |key: &&String| {
        told.iter().any(|t| {
            t == *key || t.starts_with(&format!("{key}.")) || t.starts_with(&format!("{key}[]"))
        })
    };
    let untold: Vec<&String> = seen.iter().filter(|key| !is_told(key)).collect();
    assert!(untold.is_empty(), "{untold:?}");
    let unseen: Vec<&String> = told.iter().filter(|key| !seen.contains(*key)).collect();
    assert!(unseen.is_empty(), "{unseen:?}");
}

#[test]
fn the_keys_of_a_fit_are_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let rows: String = (380..=780)
        .map(|nm| format!("{nm},{}\n", 1 + nm % 7))
        .collect();
    let table = put(folder.path(), "lamps.csv", format!("nm,lamp\n{rows}"));
    let out = folder.path().join("numbers.json");
    let out = out.to_str().expect("UTF-8");
    holds("fit --json", &[&["fit", &table, "--out", out, "--json"]]);
}

#[test]
fn the_keys_of_an_encoding_are_told() {
    let encode = ["encode", "FL2", "--json"];
    let portable = ["encode", "FL2", "--portable", "--json"];
    holds("encode --json", &[&encode, &portable]);
    let folder = tempfile::tempdir().expect("a folder");
    let with_lamps = put(folder.path(), "lamps.json", printed(&encode));
    let portable = put(folder.path(), "portable.json", printed(&portable));
    holds(
        "decode --json",
        &[
            &["decode", &with_lamps, "--json"],
            &["decode", &portable, "--json"],
        ],
    );
}

#[test]
fn the_keys_of_prism_and_rainbow_are_told() {
    // Two of FL2's spikes are at shorter wavelengths than this glass has an index for.
    let folder = tempfile::tempdir().expect("a folder");
    let glass = folder.path().join("glass.yml");
    let rows = "        0.5 1.60\n        0.6 1.59\n        0.7 1.58\n        0.8 1.57\n";
    let text = format!("REFERENCES: a table\nDATA:\n  - type: tabulated n\n    data: |\n{rows}");
    fs::write(&glass, text).expect("a file");
    let of_glass = [
        "FL2",
        "--material",
        glass.to_str().expect("UTF-8"),
        "--json",
    ];
    let [prism, rainbow] = ["prism", "rainbow"].map(|name| [&[name][..], &of_glass].concat());
    // N-SF11 reflects the shortest under so flat an incidence.
    let far = ["--at", "300,900", "--json"];
    let flat: Vec<&str> = ["prism", "FL2", "--incidence", "54"]
        .into_iter()
        .chain(far)
        .collect();
    holds(
        "prism --json",
        &[&["prism", "FL2", "--json"], &flat, &prism],
    );
    holds("rainbow --json", &[&rainbow]);
}

#[test]
fn the_keys_of_a_gem_are_told() {
    let small = ["--size", "16", "--rays", "1", "--json"];
    let with = |more: &[&'static str]| [&["gem"], more, &small].concat();
    let (light, line) = (with(&["--light", "FL2"]), with(&["--wavelength", "589.3"]));
    let still = ["gem", "--size", "16", "--rays", "4", "--json"];
    holds("gem --json", &[&light, &line, &still]);
}

#[test]
fn the_keys_of_what_files_hold_are_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let meter = meter(folder);
    let header = "ENVI\nsamples = 10\nlines = 10\nbands = 2\nheader offset = 0\n\
        data type = 1\ninterleave = bip\nbyte order = 0\n\
        wavelength units = Nanometers\nwavelength = {500, 600}\n";
    let cube = put(folder, "cube.hdr", header);
    let numbers: Vec<u8> = (0..200).collect();
    put(folder, "cube.img", numbers);
    let model = folder.join("model.composite.json");
    let model = model.to_str().expect("UTF-8");
    printed(&["convert", "FL2", model]);
    let cut = cut_lamp(folder);
    holds(
        "read --json",
        &[&["read", &meter, &cube, model, &cut, "--json"]],
    );
}

#[test]
fn the_keys_of_a_list_are_told() {
    holds(
        "list --json",
        &[&["list", "--json"], &["list", "--search", "FL2", "--json"]],
    );
}

#[test]
fn the_keys_of_the_lessons_are_told() {
    holds("lessons --json", &[&["lessons", "--json"]]);
}
