//! The command line: what it prints, writes and refuses.

use std::{
    ffi::OsString,
    fs,
    io::Write,
    path::{Path, PathBuf},
    process::{Command, Output, Stdio},
};

use crate::plain::plain;
use serde_json::Value;
use spectral_explorer::{
    app::{
        self, App, Settings,
        chart::Theme,
        design::wish::MixWish,
        open,
        pages::PageStates,
        report,
        workspace::{self, Preferences},
    },
    cli::{self, Input, Outcome, Pictures},
    io::read_path,
    spectrum::Line,
};

/// Writes down what it was asked for instead of drawing it.
struct Sketch;

impl Pictures for Sketch {
    fn window(&self, app: &App, preferences: &Preferences, size: [u32; 2]) -> Vec<u8> {
        let entry = app.document().subject_entry();
        let order = app.document().settings.order;
        let (key, dark, lesson) = (&entry.key, preferences.dark, &preferences.lesson_asked);
        let step = lesson.as_ref().map(|lesson| (lesson.step, lesson.done));
        let step = step.map_or(String::new(), |step| format!(" {step:?}"));
        format!("window {key} {order} {dark} {size:?}{step}").into_bytes()
    }

    fn plot(&self, app: &App, theme: Theme, size: [u32; 2]) -> Vec<u8> {
        let entry = app.document().subject_entry();
        format!("plot {} {theme:?} {size:?}", entry.key).into_bytes()
    }
}

struct Told {
    outcome: Outcome,
    out: String,
    err: String,
}

fn tell<S: Into<OsString> + Clone>(args: &[S]) -> Told {
    let program = OsString::from(cli::PROGRAM);
    let args = std::iter::once(program).chain(args.iter().cloned().map(Into::into));
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let outcome = cli::run(args, Some(&Sketch), &mut out, &mut err);
    Told {
        outcome,
        out: String::from_utf8(out).expect("UTF-8"),
        err: String::from_utf8(err).expect("UTF-8"),
    }
}

/// What a command that works prints.
fn said<S: Into<OsString> + Clone>(args: &[S]) -> String {
    let told = tell(args);
    assert_eq!(told.outcome, Outcome::Done(0), "{}", told.err);
    told.out
}

fn json<S: Into<OsString> + Clone>(args: &[S]) -> Value {
    let text = said(args);
    // JSON knows neither NaN nor infinity: text with either would not be read.

    serde_json::from_str(&text).expect("JSON")
}

/// The one line with which a command is refused.
fn refusal<S: Into<OsString> + Clone>(code: u8, args: &[S]) -> String {
    let told = tell(args);
    assert_eq!(
        told.outcome,
        Outcome::Done(code),
        "{} {}",
        told.out,
        told.err
    );
    assert_eq!(told.out, "");
    the_one_line(&told.err)
}

fn the_one_line(err: &str) -> String {
    let line = err.strip_suffix('\n').expect("a whole line");
    assert!(!line.contains('\n'), "{line}");
    let start = format!("{}: ", cli::PROGRAM);
    line.strip_prefix(&start)
        .expect("the program's name first")
        .to_owned()
}

fn write(folder: &Path, name: &str, text: &str) -> String {
    let path = folder.join(name);
    fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

/// Keys that scripts stand on, with the places of the arrays' items left out. All keys are told in
/// docs/command_line.md, which `command_line.rs` holds to the program.
const KEYS: &[&str] = &[
    "input/name",
    "input/kind",
    "input/points",
    "input/notes",
    "settings",
    "model/range_nm",
    "model/basis",
    "model/order",
    "model/coefficients",
    "model/spikes",
    "model/numbers",
    "error/relative_rms",
    "error/relative_rms_10nm",
    "error/max_abs",
    "error/energy",
    "error/lowest",
    "colour/exact/xyz",
    "colour/exact/xy",
    "colour/exact/uv",
    "colour/exact/srgb_hex",
    "colour/exact/cct",
    "colour/exact/duv",
    "colour/model/xyz",
    "colour/model/xy",
    "colour/model/uv",
    "colour/model/srgb_hex",
    "colour/model/cct",
    "colour/model/duv",
    "colour/full/xyz",
    "colour/full/xy",
    "colour/full/uv",
    "colour/full/srgb_hex",
    "colour/full/cct",
    "colour/full/duv",
    "colour/delta_e_2000",
    "colour/delta_uv",
    "patches",
];

fn has_all_keys(report: &Value) {
    for key in KEYS {
        assert!(report.pointer(&format!("/{key}")).is_some(), "{key}");
    }
}

fn at<'a>(report: &'a Value, key: &str) -> &'a Value {
    report
        .pointer(&format!("/{key}"))
        .unwrap_or_else(|| panic!("no {key} in {report}"))
}

fn number(report: &Value, key: &str) -> f64 {
    at(report, key)
        .as_f64()
        .unwrap_or_else(|| panic!("{key} is no number"))
}

#[test]
fn a_report_on_a_preset_has_every_stable_key_and_the_defaults() {
    let report = json(&["report", "FL2", "--json"]);
    has_all_keys(&report);
    assert_eq!(at(&report, "input/name"), "FL2");
    assert_eq!(at(&report, "input/points"), 401, "the 1 nm table");
    assert_eq!(at(&report, "model/basis"), "cosine");
    assert_eq!(at(&report, "model/order"), 7);
    assert_eq!(
        at(&report, "model/range_nm"),
        &serde_json::json!([380.0, 780.0])
    );
    for (key, expected) in [
        ("threshold_percent", Value::from(0.5)),
        ("max_width_nm", Value::from(10.0)),
        ("colour_exact", Value::from(true)),
        ("dips", Value::from(false)),
        ("spikes", Value::from(true)),
        ("observer", Value::from("1931")),
        ("sampling", Value::from("exact")),
    ] {
        assert_eq!(at(&report, &format!("settings/{key}")), &expected, "{key}");
    }
    let count = |report, key| at(report, key).as_array().unwrap().len();
    assert_eq!(count(&report, "model/coefficients/c"), 15);
    let paper = json(&["report", "FL2", "--as-in-paper", "--json"]);
    assert_eq!(at(&paper, "model/basis"), "fourier");
    assert_eq!(at(&paper, "settings/colour_exact"), false);
    assert_eq!(count(&paper, "model/coefficients/a"), 8);
    assert_eq!(count(&paper, "model/coefficients/b"), 7);
    let spikes = at(&report, "model/spikes").as_array().unwrap();
    assert_eq!(
        number(&report, "model/numbers"),
        (15 + 2 * spikes.len()) as f64
    );
    for key in ["at_nm", "weight", "share_of_power", "line"] {
        assert!(spikes[0].get(key).is_some(), "{key}");
    }
    let patches = at(&report, "patches/items").as_array().unwrap();
    assert_eq!(patches.len(), 24);
    for key in ["name", "delta_e", "exact_hex", "model_hex"] {
        assert!(patches[0].get(key).is_some(), "{key}");
    }
    for key in ["set", "delta_e_mean", "delta_e_max"] {
        assert!(at(&report, "patches").get(key).is_some(), "{key}");
    }
    // FL2 is tabulated from 380 to 780 nm, so its colours over the range and over 360-830 nm differ
    // only by the weight of the two end points.
    for i in 0..3 {
        let (full, exact) = (
            format!("colour/full/xyz/{i}"),
            format!("colour/exact/xyz/{i}"),
        );
        assert!((number(&report, &full) - number(&report, &exact)).abs() < 0.01);
    }
    assert!(
        (number(&report, "colour/exact/cct") - 4225.0).abs() < 5.0,
        "4225 K in CIE 15"
    );
}

#[test]
fn every_option_of_the_model_arrives() {
    let report = json(&[
        "report",
        "FL11",
        "--json",
        "--order",
        "12",
        "--threshold",
        "2.5",
        "--max-width",
        "20",
        "--as-in-paper",
        "--basis",
        "cosine",
        "--colour-exact",
        "--dips",
        "--range",
        "400:700",
        "--observer",
        "1964",
        "--sampling",
        "double",
    ]);
    assert_eq!(at(&report, "model/basis"), "cosine");
    assert_eq!(
        at(&report, "model/coefficients/c")
            .as_array()
            .unwrap()
            .len(),
        25
    );
    assert_eq!(at(&report, "settings/threshold_percent"), 2.5);
    assert_eq!(at(&report, "settings/max_width_nm"), 20.0);
    assert_eq!(at(&report, "settings/colour_exact_reached"), true);
    assert_eq!(at(&report, "settings/dips"), true);
    assert_eq!(at(&report, "settings/observer"), "1964");
    assert_eq!(at(&report, "settings/sampling"), "double");
    assert_eq!(at(&report, "model/range_nm/0"), 400.0);
    assert!(
        number(&report, "colour/delta_e_2000") < 1e-6,
        "the colour is exact"
    );
    let plain = json(&["report", "FL11", "--json", "--no-spikes"]);
    assert_eq!(at(&plain, "model/spikes"), &Value::Array(Vec::new()));
    for observer in ["2015-2", "2015-10"] {
        let report = json(&["report", "FL11", "--json", "--observer", observer]);
        assert_eq!(at(&report, "settings/observer"), observer);
    }
    for sampling in ["paper", "3n", "4n"] {
        let report = json(&["report", "FL11", "--json", "--sampling", sampling]);
        assert_eq!(at(&report, "settings/sampling"), sampling);
    }
}

#[test]
fn options_may_stand_before_the_input_and_with_an_equals_sign() {
    let one = said(&["report", "--order=5", "--range=400:700", "FL2"]);
    assert_eq!(
        one,
        said(&["report", "FL2", "--order", "5", "--range", "400:700"])
    );
}

#[test]
fn the_report_for_people_is_words_without_nan() {
    let text = said(&["report", "FL2"]);
    assert!(
        text.starts_with("FL2 (light, 401 points, 380-780 nm"),
        "{text}"
    );
    assert!(
        text.contains("Hg 546.1") && text.contains("CIEDE2000"),
        "{text}"
    );
    assert!(!text.contains('\u{1b}'), "no colour codes");
}

/// A lamp of broad lines: at 1 nm its model is far off, to the eye it is not.
#[test]
fn the_report_begins_with_what_a_person_sees_and_ends_with_the_strict_figures() {
    let text = said(&["report", "FL11"]);
    let at = |part: &str| {
        let found = text.find(part);
        found.unwrap_or_else(|| panic!("no {part} in {text}"))
    };
    let order = [
        "Seen ",
        "Colour ",
        "Surfaces ",
        "Measured ",
        "\nModel ",
        "Series ",
        "  line ",
        "Error ",
        "behind a 10 nm blur",
        "energy ",
        "; at 1 nm ",
    ]
    .map(at);
    assert!(order.is_sorted(), "{order:?}: {text}");
    let last = text.lines().rfind(|line| !line.starts_with("Note "));
    assert!(
        last.is_some_and(|line| line.starts_with("Error ")),
        "{text}"
    );
}

/// The settings that JSON tells, but for what belongs to the input.
fn settings_of(report: &Value) -> Value {
    let mut settings = at(report, "settings").clone();
    for key in ["light", "hand_edits", "colour_exact_reached"] {
        settings.as_object_mut().unwrap().remove(key);
    }
    settings
}

/// One place says what is taken where nothing is said: no command has defaults of its own.
#[test]
fn every_command_takes_what_the_window_starts_with() {
    let fresh = App::new();
    let of_window = report::json(&fresh);
    let expected = settings_of(&of_window);
    let reported = json(&["report", "FL2", "--json"]);
    assert_eq!(settings_of(&reported), expected);
    assert_eq!(at(&reported, "model"), at(&of_window, "model"));
    assert_eq!(at(&reported, "patches"), at(&of_window, "patches"));
    let pages = PageStates::default();
    let prism = json(&["prism", "FL2", "--json"]);
    assert_eq!(number(&prism, "slit_mm"), pages.prism.slit_mm);
    assert_eq!(number(&prism, "apex"), pages.prism.apex_deg);
    let channels = ["450", "520", "560", "620"].map(|nm| format!("--channel=gauss:{nm},30"));
    let mixed = |more: &[&str]| {
        let channels = channels.iter().map(String::as_str);
        let args = ["mix", "--target", "4000K", "--json"].into_iter();
        let args = args.chain(channels).chain(more.iter().copied());
        said(&args.collect::<Vec<_>>())
    };
    let favour = MixWish::default().favour.word();
    assert_eq!(mixed(&[]), mixed(&["--favour", favour]));
    // The same product with nothing said and with each setting of the window named.
    let explicit = ["--basis", "cosine", "--colour-exact", "--sampling", "exact"];
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    for (args, out) in [
        (&["product", "FL2", "red", "--json"][..], None),
        (&["light", "FL2", "--json"], None),
        (&["plot", "FL2", "--out"], Some("plot.svg")),
        (&["convert", "FL2", "--as", "composite"], Some("model.json")),
    ] {
        let of = |more: &[&str], name: &str| match out {
            None => said(&[args, more].concat()),
            Some(kind) => {
                let path = place(&format!("{name}{kind}"));
                said(&[args, &[path.as_str()], more].concat());
                fs::read_to_string(path).unwrap()
            }
        };
        // Nothing is multiplied by those that do not take a sampling.
        let explicit = match args[0] {
            "product" => &explicit[..],
            _ => &explicit[..3],
        };
        assert_eq!(of(&[], "a"), of(explicit, "b"), "{args:?}");
        assert_ne!(of(&[], "c"), of(&["--as-in-paper"], "d"), "{args:?}");
    }
}

#[test]
fn a_file_is_reported_with_its_notes_and_one_of_several_is_picked() {
    let folder = tempfile::tempdir().unwrap();
    let rows: String = (0..81)
        .map(|i| format!("{};{},5;{},25\n", 380 + 5 * i, i, 100 - i))
        .collect();
    let file = write(folder.path(), "zwei.csv", &format!("nm;eins;zwei\n{rows}"));
    let first = json(&["report", &file, "--json", "--kind", "light"]);
    has_all_keys(&first);
    assert_eq!(at(&first, "input/name"), "eins");
    let notes = at(&first, "input/notes").to_string();
    assert!(notes.contains("Spectrum 1 of 2 in the file"), "{notes}");
    for pick in ["zwei", "2"] {
        let second = json(&[
            "report",
            &file,
            "--json",
            "--kind",
            "light",
            "--spectrum",
            pick,
        ]);
        assert_eq!(at(&second, "input/name"), "zwei");
    }
    let none = refusal(1, &["report", &file, "--spectrum", "drei"]);
    assert!(
        none.contains("expected a name or a number from 1 to 2 (eins, zwei)"),
        "{none}"
    );
}

#[test]
fn names_are_found_plain_or_with_their_group() {
    for (input, name) in [
        ("CIE D65", "CIE D65"),
        ("cie_fluorescent_1nm/FL2", "FL2"),
        ("cie_fluorescent_5nm/FL2", "FL2"),
        ("lamps_nist_traditional/Mercury", "Mercury"),
        ("paper/Mercury", "Mercury"),
    ] {
        let report = json(&["report", input, "--json"]);
        let found = at(&report, "input/name").as_str().unwrap();
        assert!(found == name || name.ends_with(found), "{input}: {found}");
    }
    let ambiguous = refusal(1, &["report", "Mercury"]);
    assert!(
        ambiguous.contains("lamps_nist_traditional/Mercury"),
        "{ambiguous}"
    );
    assert!(ambiguous.contains("paper/Mercury"), "{ambiguous}");
    let unknown = refusal(1, &["report", "FL22"]);
    assert!(
        unknown.contains("\"FL22\"") && unknown.contains("FL2"),
        "{unknown}"
    );
}

#[test]
fn the_papers_lamp_is_reported_as_sampled_and_keeps_its_lines() {
    let report = json(&["report", "paper/Mercury", "--json"]);
    let notes = at(&report, "input/notes").to_string();
    assert!(notes.contains("sampled at 1 nm"), "{notes}");
    let spikes = at(&report, "model/spikes").as_array().unwrap();
    let near = |nm: f64| spikes.iter().any(|s| (number(s, "at_nm") - nm).abs() < 1.0);
    assert!(near(435.8) && near(546.1), "{spikes:?}");
}

#[test]
fn a_reflectance_is_seen_under_d65_and_has_no_patches() {
    let chart = "colorchecker_ohta/dark skin";
    let report = json(&["report", chart, "--json"]);
    has_all_keys(&report);
    assert_eq!(at(&report, "input/kind"), "reflectance");
    assert_eq!(at(&report, "settings/light"), "CIE D65");
    assert!(at(&report, "patches").is_null());
    assert!(at(&report, "colour/exact/cct").is_null());
    let daylight = number(&report, "colour/exact/xy/0");
    let warm = json(&["report", chart, "--json", "--light", "CIE A"]);
    assert_eq!(at(&warm, "settings/light"), "CIE A");
    assert!(
        number(&warm, "colour/exact/xy/0") > daylight + 0.05,
        "redder under a filament"
    );
}

#[test]
fn a_light_from_a_file_shines_on_a_reflectance_and_a_reflectance_is_no_light() {
    let folder = tempfile::tempdir().unwrap();
    let equal: String = (380..=780).map(|nm| format!("{nm} 0.5\n")).collect();
    let file = write(folder.path(), "equal.txt", &equal);
    let report = json(&["report", "dark skin", "--json", "--light", &file]);
    assert_eq!(at(&report, "settings/light"), "equal");
    let wrong = refusal(
        1,
        &[
            "report",
            "dark skin",
            "--light",
            "colorchecker_ohta/dark skin",
        ],
    );
    assert!(
        wrong.contains("found reflectance values, expected a light"),
        "{wrong}"
    );
    let told = tell(&["report", "FL2", "--light", "CIE A"]);
    assert_eq!(told.outcome, Outcome::Done(0));
    assert!(
        the_one_line(&told.err).contains("--light is not used"),
        "{}",
        told.err
    );
}

#[test]
fn a_light_of_zeros_has_nulls_and_no_nan() {
    let folder = tempfile::tempdir().unwrap();
    let zeros: String = (380..=780).map(|nm| format!("{nm},0\n")).collect();
    let file = write(folder.path(), "dark.csv", &zeros);
    let report = json(&["report", &file, "--json", "--kind", "light"]);
    has_all_keys(&report);
    for key in [
        "error/relative_rms",
        "error/lowest",
        "colour/exact/xyz",
        "colour/model/srgb_hex",
        "colour/full/xy",
        "colour/delta_e_2000",
        "patches",
    ] {
        assert!(at(&report, key).is_null(), "{key}");
    }
    let text = said(&["report", &file, "--kind", "light"]);
    assert!(text.contains("zero") && !text.contains("NaN"), "{text}");
    // Nothing is seen in the dark, and that too is no error.
    let dark = json(&["report", "dark skin", "--json", "--light", &file]);
    assert!(at(&dark, "colour/exact/xyz").is_null());
}

#[test]
fn a_range_beyond_the_visible_says_that_the_colour_is_missing() {
    let list = json(&["list", "--json", "--kind", "light"]);
    let items = list.as_array().unwrap();
    let sun = items
        .iter()
        .find(|item| item["group"] == "solar_astm_g173")
        .unwrap();
    let sun = sun["id"].as_str().unwrap();
    let report = json(&["report", sun, "--json", "--range", "900:1100"]);
    has_all_keys(&report);
    assert!(number(&report, "error/relative_rms") > 0.0);
    assert!(at(&report, "colour/exact/xyz").is_null());
    assert!(at(&report, "colour/delta_e_2000").is_null());
    let text = said(&["report", sun, "--range", "900:1100"]);
    assert!(text.contains("there is no colour"), "{text}");
}

#[test]
fn what_is_outside_its_limits_is_refused_in_one_line() {
    for (option, value) in [
        ("--order", "101"),
        ("--order", "-1"),
        ("--order", "7.5"),
        ("--order", "many"),
        ("--order", "NaN"),
        ("--order", ""),
        ("--threshold", "0.009"),
        ("--threshold", "50.1"),
        ("--threshold", "NaN"),
        ("--threshold", "-1"),
        ("--threshold", "inf"),
        ("--threshold", "0,5"),
        ("--max-width", "0.99"),
        ("--max-width", "51"),
        ("--max-width", "nan"),
        ("--range", "380:399"),
        ("--range", "380.5:700"),
        ("--range", "700:380"),
        ("--range", "NaN:780"),
        ("--range", "380-780"),
        ("--range", "-10:780"),
        ("--range", "0:1e9"),
        ("--basis", "Legendre"),
        ("--observer", "1932"),
        ("--sampling", "none"),
        ("--kind", "weighting"),
    ] {
        let line = refusal(2, &["report", "FL2", option, value]);
        assert!(
            line.starts_with(&format!("{option}: found \"{value}\", expected ")),
            "{line}"
        );
    }
    // The ends themselves are allowed.
    for (option, value) in [
        ("--order", "0"),
        ("--order", "100"),
        ("--threshold", "0.01"),
        ("--threshold", "50"),
        ("--max-width", "1"),
        ("--max-width", "50"),
        ("--range", "380:400"),
    ] {
        has_all_keys(&json(&["report", "FL2", "--json", option, value]));
    }
}

#[test]
fn arguments_that_make_no_sense_are_refused_in_one_line() {
    for (args, expected) in [
        (&["report"][..], "found no INPUT"),
        (&["report", "FL2", "FL3"], "found no --repeats"),
        (&["report", "FL2", "--order"], "--order: found no value"),
        (
            &["report", "FL2", "--order", "3", "--order", "4"],
            "--order: found twice",
        ),
        (
            &["report", "FL2", "--ordr", "3"],
            "found \"--ordr\", expected --order",
        ),
        (
            &["report", "FL2", "--json=yes"],
            "--json: found \"yes\", expected no value",
        ),
        (&["plot", "FL2"], "found no --out FILE"),
        (
            &["plot", "FL2", "--out", "a.pdf"],
            "--out a.pdf: found .pdf",
        ),
        (
            &["plot", "FL2", "--sheet", "--out", "a.png"],
            "--out a.png: found .png",
        ),
        (&["render", "--out", "a.svg"], "--out: found \"a.svg\""),
        (
            &["render", "--out", "a.png", "--size", "9x9"],
            "--size: found \"9x9\"",
        ),
        (
            &["render", "--out", "a.png", "--size", "1280"],
            "--size: found \"1280\"",
        ),
        (
            &["render", "--out", "a.png", "--theme", "pink"],
            "--theme: found \"pink\"",
        ),
        (
            &["render", "--out", "a.png", "--kind", "light"],
            "--kind: found no INPUT",
        ),
        (&["list", "--kind", "lamp"], "--kind: found \"lamp\""),
        (&["convert", "FL2"], "found no OUT"),
        (&["convert", "FL2", "a.doc"], "OUT: found \"a.doc\""),
        (
            &["convert", "FL2", "a.spd", "--as", "composite"],
            "--as composite: found .spd",
        ),
        (
            &["convert", "FL2", "a.csv", "--order", "3"],
            "found options of a model",
        ),
        (&["--nonsense"], "found \"--nonsense\""),
    ] {
        let line = refusal(2, args);
        assert!(line.starts_with(expected), "{args:?}: {line}");
    }
}

#[test]
fn a_bad_file_is_refused_with_line_found_and_expected() {
    let folder = tempfile::tempdir().unwrap();
    let file = write(
        folder.path(),
        "bad.csv",
        "nm,value\n380,1\n385,2\n390,x\n395,4\n400,5\n",
    );
    let line = refusal(1, &["report", &file]);
    assert!(
        line.starts_with(&format!("{file}, line 4: found \"x\", expected ")),
        "{line}"
    );
    let missing = refusal(1, &["report", "no-such-file.csv"]);
    assert!(missing.contains("found no such file"), "{missing}");
    let name = "two\nlines\u{2028}here";
    refusal(1, &["report", name]);
    refusal(1, &[name]);
}

#[test]
fn every_listed_name_leads_to_its_spectrum() {
    let list = json(&["list", "--json"]);
    let items = list.as_array().unwrap();
    assert!(items.len() > 300, "{}", items.len());
    for item in items {
        let id = item["id"].as_str().unwrap();
        let told = tell(&[id]);
        let Outcome::Window { files, .. } = told.outcome else {
            panic!("{id}: {}", told.err);
        };
        let [Input::Preset(entry)] = &files[..] else {
            panic!("{id}");
        };
        assert_eq!(entry.key, id);
        assert_eq!(&open::resolve(id, None, None).unwrap(), &**entry);
        assert_eq!(entry.kind().word(), item["kind"].as_str().unwrap());
        assert_eq!(
            entry.spectrum.samples.len() as u64,
            item["points"].as_u64().unwrap()
        );
        assert!(entry.is_usable());
    }
    // And the report takes it: one of each group.
    let mut groups: Vec<&str> = Vec::new();
    for item in items {
        let group = item["group"].as_str().unwrap();
        if !groups.contains(&group) {
            groups.push(group);
            has_all_keys(&json(&["report", item["id"].as_str().unwrap(), "--json"]));
        }
    }
}

#[test]
fn a_list_can_be_of_one_kind_and_is_one_line_an_item() {
    let lights = said(&["list", "--kind", "light"]);
    assert!(
        lights
            .lines()
            .any(|l| l.starts_with("cie_fluorescent_1nm/FL2 ")),
        "{lights}"
    );
    assert!(lights.lines().all(|l| l.contains("  light   ")), "{lights}");
    for kind in ["reflectance", "transmittance", "weighting", "lines"] {
        let items = json(&["list", "--json", "--kind", kind]);
        assert!(!items.as_array().unwrap().is_empty(), "{kind}");
        assert!(
            items
                .as_array()
                .unwrap()
                .iter()
                .all(|item| item["kind"] == kind)
        );
    }
}

#[test]
fn a_spectrum_keeps_every_bit_through_all_formats() {
    let folder = tempfile::tempdir().unwrap();
    let values: [f64; 7] = [
        0.1 + 0.2,
        1.0 / 3.0,
        0.0,
        1e-300,
        12345.678901234567,
        5e-324,
        2.5,
    ];
    let nm: [f64; 7] = [
        380.0,
        385.25,
        1e3 / 3.0 + 60.0,
        404.656,
        500.0,
        656.281,
        780.5,
    ];
    let rows: String = nm
        .iter()
        .zip(values)
        .map(|(nm, v)| format!("{nm:?},{v:?}\n"))
        .collect();
    let csv = write(
        folder.path(),
        "a.csv",
        &format!("wavelength (nm),W m-2 nm-1\n{rows}"),
    );
    let mut last = csv.clone();
    for name in ["b.spd", "c.spdx", "d.json", "e.csv"] {
        let next = folder.path().join(name).to_str().unwrap().to_owned();
        let text = said(&["convert", &last, &next, "--kind", "light"]);
        assert!(text.starts_with("Wrote "), "{text}");
        last = next;
    }
    let bits = |path: &str| -> Vec<(u64, u64)> {
        let reading = read_path(Path::new(path)).unwrap();
        let samples = &reading.spectra[0].samples;
        let pairs = samples.nm().iter().zip(samples.values());
        pairs.map(|(nm, v)| (nm.to_bits(), v.to_bits())).collect()
    };
    let expected: Vec<_> = nm
        .iter()
        .zip(values)
        .map(|(n, v)| (n.to_bits(), v.to_bits()))
        .collect();
    assert_eq!(bits(&csv), expected);
    assert_eq!(bits(&last), expected);
}

fn composite(path: &Path) -> (Vec<u64>, Vec<[u64; 2]>) {
    let reading = read_path(path).unwrap();
    let composite = &reading.composites[0].composite;
    let spike = |s: &Line| [s.at_nm.to_bits(), s.weight.to_bits()];
    (
        composite
            .smooth()
            .coefficients
            .iter()
            .map(|c| c.to_bits())
            .collect(),
        composite.lines().iter().map(spike).collect(),
    )
}

#[test]
fn a_model_is_converted_as_it_is_reported_and_copied_bit_by_bit() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let word = |name: &str| path(name).to_str().unwrap().to_owned();
    let first = word("fl2.composite.json");
    said(&[
        "convert", "FL2", &first, "--order", "5", "--basis", "cosine",
    ]);
    let report = json(&[
        "report", "FL2", "--json", "--order", "5", "--basis", "cosine",
    ]);
    let (coefficients, spikes) = composite(&path("fl2.composite.json"));
    let reported = at(&report, "model/coefficients/c").as_array().unwrap();
    let reported: Vec<u64> = reported
        .iter()
        .map(|c| c.as_f64().unwrap().to_bits())
        .collect();
    assert_eq!(coefficients, reported);
    assert_eq!(
        spikes.len(),
        at(&report, "model/spikes").as_array().unwrap().len()
    );
    // A composite to .json is copied, to anything else sampled; with options it is fitted anew.
    said(&["convert", &first, &word("copy.json")]);
    assert_eq!(composite(&path("copy.json")), (coefficients, spikes));
    said(&["convert", &first, &word("sampled.csv")]);
    let sampled = read_path(&path("sampled.csv")).unwrap();
    assert_eq!(sampled.spectra[0].samples.len(), 401);
    said(&[
        "convert",
        &first,
        &word("anew.json"),
        "--as",
        "composite",
        "--order",
        "2",
    ]);
    assert_eq!(composite(&path("anew.json")).0.len(), 5);
    said(&["convert", &first, &word("table.json"), "--as", "spectrum"]);
    assert_eq!(
        read_path(&path("table.json")).unwrap().spectra[0]
            .samples
            .len(),
        401
    );
    // A plain spectrum to .json stays a spectrum.
    said(&["convert", "FL2", &word("fl2.json")]);
    assert_eq!(read_path(&path("fl2.json")).unwrap().spectra.len(), 1);
}

#[test]
fn a_model_keeps_name_and_kind_and_a_line_of_text_is_asked_about() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).display().to_string();
    let leaf = write(
        folder.path(),
        "leaf.csv",
        "nm,oak reflectance\n380,0.1\n500,0.3\n600,0.2\n780,0.5\n",
    );
    let (model, table) = (place("m.composite.json"), place("t.csv"));
    said(&["convert", &leaf, &model, "--order", "2"]);
    let text = said(&["convert", &model, &table, "--as", "spectrum"]);
    assert!(text.contains("leaf (reflectance, 401 points)"), "{text}");
    let line = place("m.txt");
    said(&["convert", &model, &line]);
    let reading = read_path(Path::new(&line)).unwrap();
    assert!(reading.is_doubtful(), "{:?}", reading.guesses);
    let text = said(&["convert", &line, &place("u.csv"), "--kind", "reflectance"]);
    assert!(text.contains("reflectance, 401 points"), "{text}");
}

#[test]
fn a_table_beside_the_range_is_not_modelled_as_zero() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("m.txt").display().to_string();
    let infrared = write(
        folder.path(),
        "ir.csv",
        "nm,irradiance\n1000,1\n1100,3\n1200,2\n1300,2\n",
    );
    let line = refusal(1, &["convert", &infrared, &out]);
    assert!(
        line.contains("found values of 1000-1300 nm, expected some in the model's range"),
        "{line}"
    );
    assert!(!Path::new(&out).exists());
    let text = said(&["report", &infrared]);
    assert!(
        text.contains("Nothing was measured in 380-780 nm: the table covers 1000-1300 nm."),
        "{text}"
    );
    assert!(!text.contains("is zero"), "{text}");
    let text = said(&["convert", &infrared, &out, "--range", "1000:1300"]);
    assert!(text.contains("Note      "), "{text}");
}

#[test]
fn a_kind_said_on_the_command_line_is_taken_as_in_the_window() {
    let folder = tempfile::tempdir().unwrap();
    let input = write(folder.path(), "hl.csv", "380,40\n500,60\n600,70\n780,80\n");
    let out = folder.path().join("o.json").display().to_string();
    said(&["convert", &input, &out, "--kind", "reflectance"]);
    let read = read_path(Path::new(&out)).unwrap();
    let hundredths = [40.0, 60.0, 70.0, 80.0].map(|percent| 0.01 * percent);
    assert_eq!(read.spectra[0].samples.values(), hundredths);
    let report = json(&["report", &input, "--json", "--kind", "reflectance"]);
    let y = at(&report, "colour/exact/xyz")[1].as_f64().unwrap();
    assert!((40.0..100.0).contains(&y), "{y}");
}

#[test]
fn photons_are_looked_at_as_power_and_converted_as_they_are() {
    let folder = tempfile::tempdir().unwrap();
    let rows = |value: fn(f64) -> f64| -> String {
        (0..=40)
            .map(|i| 380.0 + 10.0 * f64::from(i))
            .map(|nm| format!("{nm},{}\n", value(nm)))
            .collect()
    };
    // The same light twice: even power, and its photons.
    let title = "nm,irradiance (W m-2 nm-1)\n";
    let power = write(folder.path(), "p.csv", &format!("{title}{}", rows(|_| 1.0)));
    let title = "nm,photon irradiance (µmol m-2 s-1 nm-1)\n";
    let text = format!("{title}{}", rows(|nm| nm / 119.626_565_8));
    let photons = write(folder.path(), "q.csv", &text);
    let xy = |file: &str| {
        let report = json(&["report", file, "--json"]);
        let xy = at(&report, "colour/exact/xy").clone();
        [0, 1].map(|i| xy[i].as_f64().unwrap())
    };
    let (by_power, by_photons) = (xy(&power), xy(&photons));
    assert!(
        by_power
            .iter()
            .zip(by_photons)
            .all(|(a, b)| (a - b).abs() < 1e-8),
        "{by_power:?} {by_photons:?}"
    );
    let said_of = said(&["report", &photons]);
    assert!(said_of.contains("photons turned into power"), "{said_of}");
    let out = folder.path().join("o.csv");
    said(&["convert", &photons, out.to_str().unwrap()]);
    let sum = |path: &str| json(&["read", path, "--json"])[0]["spectra"][0]["sum"].clone();
    assert_eq!(sum(out.to_str().unwrap()), sum(&photons));
}

#[test]
fn what_has_no_colour_is_converted_all_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let input = write(
        folder.path(),
        "glass.csv",
        "nm,absorbance\n400,0.1\n500,0.5\n600,2.5\n",
    );
    for extension in ["csv", "json"] {
        let out = folder.path().join(format!("o.{extension}"));
        said(&["convert", &input, out.to_str().unwrap()]);
        let read = read_path(&out).unwrap();
        assert_eq!(
            read.spectra[0].samples.values(),
            [0.1, 0.5, 2.5],
            "{extension}"
        );
        assert_eq!(read.spectra[0].kind.word(), "absorbance", "{extension}");
    }
}

#[test]
fn the_papers_lamp_is_converted_with_its_own_printed_numbers() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mercury.json");
    let text = said(&["convert", "paper/Mercury", path.to_str().unwrap()]);
    assert!(text.contains("fourier series of order"), "{text}");
    let reading = read_path(&path).unwrap();
    assert!(reading.spectra.is_empty());
    assert!(!reading.composites[0].composite.lines().is_empty());
}

#[test]
fn a_place_that_cannot_be_written_to_is_refused_in_one_line() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["none/a.csv", "none/a.composite.json"] {
        let path = folder.path().join(name);
        let line = refusal(1, &["convert", "FL2", path.to_str().unwrap()]);
        assert!(line.contains("folder"), "{line}");
    }
    let path = folder.path().join("none/a.svg");
    refusal(1, &["plot", "FL2", "--out", path.to_str().unwrap()]);
}

#[test]
fn a_plot_is_svg_that_an_xml_reader_takes_or_a_png() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("fl11.svg");
    let out = path.to_str().unwrap();
    for theme in ["dark", "light"] {
        said(&[
            "plot", "FL11", "--order", "9", "--out", out, "--size", "900x600", "--theme", theme,
        ]);
        let text = fs::read_to_string(&path).unwrap();
        let svg = roxmltree::Document::parse(&text).unwrap();
        let root = svg.root_element();
        assert_eq!(root.tag_name().name(), "svg");
        assert_eq!(root.attribute("width"), Some("900"));
        assert!(text.contains("order 9"), "the options arrive");
    }
    let png = folder.path().join("fl11.PNG");
    said(&["plot", "FL11", "--out", png.to_str().unwrap()]);
    let sketch = fs::read_to_string(&png).unwrap();
    assert_eq!(sketch, "plot cie_fluorescent_1nm/FL11 Light [1280, 800]");
}

#[test]
fn a_sheet_is_one_page_and_of_lights_alone() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (svg, pdf) = (place("a.svg"), place("a.pdf"));
    said(&["plot", "FL2", "--sheet", "--out", &svg]);
    let text = fs::read_to_string(&svg).unwrap();
    let tree = roxmltree::Document::parse(&text).unwrap();
    assert_eq!(tree.root_element().attribute("width"), Some("794"));
    // The second time a page replaces a page.
    for _ in 0..2 {
        said(&["plot", "FL2", "--sheet", "--out", &pdf]);
    }
    assert!(fs::read(&pdf).unwrap().starts_with(b"%PDF-"));
    let line = refusal(1, &["plot", "red", "--sheet", "--out", &place("b.svg")]);
    assert!(line.contains("expected a light"), "{line}");
}

#[test]
fn a_lesson_is_rendered_without_what_it_does_not_use() {
    let folder = tempfile::tempdir().expect("a folder");
    let place = |name: &str| folder.path().join(name).to_str().expect("UTF-8").to_owned();
    let (alone, beside) = (place("alone.png"), place("beside.png"));
    said(&["render", "--lesson", "waves:2", "--out", &alone]);
    let more = [
        "CIE D65", "--page", "gem", "--order", "3", "--kind", "light",
    ];
    let told = tell(
        &[
            &["render", "--lesson", "waves:2", "--out", &beside],
            &more[..],
        ]
        .concat(),
    );
    assert_eq!(told.outcome, Outcome::Done(0), "{}", told.err);
    for option in ["INPUT", "--page", "--order", "--kind"] {
        let words = format!("{option} is not used: a lesson brings its own light and page");
        assert!(told.err.contains(&words), "{}", told.err);
    }
    assert_eq!(fs::read(&alone).unwrap(), fs::read(&beside).unwrap());
}

#[test]
fn an_author_sees_a_step_of_a_file_as_it_begins_and_as_it_ends() {
    let folder = tempfile::tempdir().expect("a folder");
    let place = |name: &str| folder.path().join(name).to_str().expect("UTF-8").to_owned();
    let mine = place("mine.json");
    fs::copy("lessons/waves.json", &mine).expect("a copy");
    let drawn = |lesson: &str, more: &[&str]| {
        let out = place("step.png");
        let words = ["render", "--lesson", lesson, "--out", &out, "--force"];
        said(&[&words[..], more].concat());
        fs::read(&out).unwrap()
    };
    let second = format!("{mine}:2");
    let begun = drawn(&second, &[]);
    assert_eq!(begun, drawn("waves:2", &[]));
    assert_ne!(begun, drawn(&mine, &[]));
    assert_ne!(begun, drawn(&second, &["--done"]));
    let out = place("none.png");
    for (lesson, words) in [
        ("waves:5", "found step 5 of waves, expected 1 to 4"),
        ("no such:1", "found no such lesson or file"),
    ] {
        let line = refusal(2, &["render", "--lesson", lesson, "--out", &out]);
        assert!(line.contains(words), "{line}");
    }
}

/// Draws every page alike.
struct Alike;

impl Pictures for Alike {
    fn window(&self, _: &App, _: &Preferences, _: [u32; 2]) -> Vec<u8> {
        b"a page".to_vec()
    }

    fn plot(&self, _: &App, _: Theme, _: [u32; 2]) -> Vec<u8> {
        b"a plot".to_vec()
    }
}

#[test]
fn options_of_the_model_are_told_on_a_page_that_does_not_show_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut count = 0;
    let mut told = |pictures: &dyn Pictures, more: &[&str]| {
        count += 1;
        let out = folder.path().join(format!("{count}.png"));
        let out = out.to_str().expect("UTF-8");
        let start = [
            "spectral-explorer",
            "render",
            "FL2",
            "--page",
            "glossary",
            "--out",
            out,
        ];
        let words = [&start[..], more].concat();
        let words: Vec<OsString> = words.into_iter().map(OsString::from).collect();
        let mut err = Vec::new();
        let outcome = cli::run(words, Some(pictures), &mut Vec::new(), &mut err);
        assert_eq!(outcome, Outcome::Done(0));
        String::from_utf8(err).expect("UTF-8")
    };
    let unused = "no option of the model is used: the page does not show it";
    assert!(told(&Alike, &["--order", "3"]).contains(unused));
    // A sketch tells the order.
    assert_eq!(told(&Sketch, &["--order", "3"]), "");
    assert_eq!(told(&Alike, &[]), "");
}

#[test]
fn the_window_is_rendered_with_an_input_or_as_it_starts() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    // A sketch is no picture that another might replace.
    let [first, second, third] = ["1.png", "2.png", "3.png"].map(place);
    said(&["render", "--out", &first]);
    let sketch = fs::read_to_string(&first).unwrap();
    assert_eq!(sketch, "window cie_fluorescent_1nm/FL2 7 true [1280, 800]");
    said(&[
        "render", "CIE D65", "--order", "3", "--out", &second, "--size", "800x600", "--theme",
        "light",
    ]);
    let sketch = fs::read_to_string(&second).unwrap();
    assert_eq!(sketch, "window cie_illuminants/CIE D65 3 false [800, 600]");
    let file = write(folder.path(), "own.txt", "400 1\n500 2\n600 3\n700 2\n");
    said(&["render", &file, "--kind", "light", "--out", &third]);
    let sketch = fs::read_to_string(&third).unwrap();
    assert!(sketch.starts_with("window own/1 7 "), "{sketch}");
}

#[test]
fn a_saved_project_is_taken_with_its_own_settings() {
    let folder = tempfile::tempdir().unwrap();
    let mut app = plain();
    let settings = app.document().settings;
    app.apply(app::Command::Edit(Settings {
        order: 11,
        ..settings
    }));
    let text = workspace::to_json(app.document(), None).unwrap();
    let file = write(folder.path(), "lesson.json", &text);
    let report = json(&["report", &file, "--json"]);
    assert_eq!(at(&report, "model/order"), 11);
    assert_eq!(at(&report, "input/name"), "FL11");
    let report = json(&["report", &file, "--json", "--order", "4"]);
    assert_eq!(at(&report, "model/order"), 4);
}

#[test]
fn without_a_command_files_and_presets_are_for_the_window() {
    let folder = tempfile::tempdir().unwrap();
    let file = write(folder.path(), "own.txt", "400 1\n500 2\n600 3\n700 2\n");
    let told = tell(&["FL2", &file, "--window"]);
    let Outcome::Window { files, insist, .. } = told.outcome else {
        panic!("{}", told.err);
    };
    assert!(insist);
    assert_eq!(files[1], Input::File(PathBuf::from(&file)));
    let (app, refused) = cli::app_with(&files);
    assert_eq!(app.document().light.name(), "FL2");
    assert_eq!(app.document().own.len(), 1);
    assert!(refused.is_empty());
    let none = tell::<&str>(&[]);
    assert_eq!(
        none.outcome,
        Outcome::Window {
            files: Vec::new(),
            follow: None,
            insist: false
        }
    );
    let neither = refusal(1, &["FL2", "reprot"]);
    assert!(
        neither.contains("\"reprot\": found no such file"),
        "{neither}"
    );
    // A file that is not there does not stop the others.
    let told = tell(&["gone.csv", "FL2"]);
    let Outcome::Window { files, .. } = told.outcome else {
        panic!("{}", told.err);
    };
    let (app, refused) = cli::app_with(&files);
    assert_eq!(app.document().light.name(), "FL2");
    assert!(
        refused.len() == 1 && refused[0].starts_with("gone.csv: found no such file"),
        "{refused:?}"
    );
    let alone = refusal(1, &["gone.csv"]);
    assert!(alone.contains("gone.csv"), "{alone}");
    let told = tell(&[folder.path().to_str().unwrap(), "FL2"]);
    let Outcome::Window { files, .. } = told.outcome else {
        panic!("{}", told.err);
    };
    let (app, refused) = cli::app_with(&files);
    assert_eq!(app.document().own.len(), 1);
    assert_eq!(app.document().light.key, "own/1");
    assert!(refused.is_empty());
}

#[test]
fn help_version_and_licences_are_everywhere() {
    for command in ["report", "list", "render", "plot", "convert"] {
        assert!(said(&[command, "--help"]).contains("Usage: spectral-explorer"));
        assert_eq!(said(&[command, "--version"]), said(&["--version"]));
    }
    assert!(said(&["--help"]).contains("convert"));
    assert_eq!(
        said(&["-V"]),
        format!("spectral-explorer {}\n", env!("CARGO_PKG_VERSION"))
    );
    let licences = said(&["--licences"]);
    assert!(licences.contains("Apache License") && licences.contains("Attribution-ShareAlike"));
}

/// A pipe whose reader went away, or a full disk.
struct Broken(std::io::ErrorKind);

impl Write for Broken {
    fn write(&mut self, _: &[u8]) -> std::io::Result<usize> {
        Err(self.0.into())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Err(self.0.into())
    }
}

#[test]
fn a_reader_that_goes_away_is_no_error_and_a_full_disk_is_one() {
    for args in [
        &["list"][..],
        &["report", "FL2"],
        &["--licences"],
        &["--help"],
    ] {
        let args = || [cli::PROGRAM].iter().chain(args).map(OsString::from);
        let mut err = Vec::new();
        let gone = &mut Broken(std::io::ErrorKind::BrokenPipe);
        assert_eq!(
            cli::run(args(), Some(&Sketch), gone, &mut err),
            Outcome::Done(0)
        );
        assert!(err.is_empty());
        let full = &mut Broken(std::io::ErrorKind::StorageFull);
        assert_eq!(
            cli::run(args(), Some(&Sketch), full, &mut err),
            Outcome::Done(1)
        );
        the_one_line(&String::from_utf8(err).unwrap());
    }
}

#[test]
fn a_missing_display_is_an_error_only_where_a_window_was_insisted_on() {
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let app = plain();
    assert_eq!(
        cli::without_display(&app, true, Some(&Sketch), &mut out, &mut err),
        3
    );
    assert!(out.is_empty());
    the_one_line(&String::from_utf8(err).unwrap());
}

fn program(args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_spectral-explorer"));
    command.args(args).stdin(Stdio::null());
    command
}

fn run(args: &[&str]) -> Output {
    program(args).output().unwrap()
}

#[test]
fn the_program_itself_reports_with_every_key() {
    let Output {
        status,
        stdout,
        stderr,
    } = run(&["report", "FL2", "--json"]);
    assert!(status.success() && stderr.is_empty());
    has_all_keys(&serde_json::from_slice(&stdout).unwrap());
}

#[test]
fn the_program_itself_refuses_in_one_line_with_its_exit_code() {
    for (args, code) in [
        (&["report", "no-such.csv"][..], 1),
        (&["report", "FL2", "--order", "x"], 2),
    ] {
        let Output {
            status,
            stdout,
            stderr,
        } = run(args);
        assert_eq!(status.code(), Some(code));
        assert!(stdout.is_empty());
        the_one_line(&String::from_utf8(stderr).unwrap());
    }
    let version = run(&["--version"]);
    assert!(version.status.success());
    let version = String::from_utf8(version.stdout).unwrap();
    assert_eq!(
        version.trim_end(),
        concat!("spectral-explorer ", env!("CARGO_PKG_VERSION"))
    );
}

#[test]
fn the_program_itself_ends_quietly_when_nobody_reads_on() {
    let mut child = program(&["--licences"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let Output { status, stderr, .. } = child.wait_with_output().unwrap();
    assert!(status.success(), "{status}");
    assert_eq!(String::from_utf8(stderr).unwrap(), "");
}

#[cfg(target_os = "linux")]
#[test]
fn the_program_itself_does_its_main_job_without_a_display() {
    let folder = tempfile::tempdir().unwrap();
    let without_display = |args: &[&str]| {
        let mut command = program(args);
        for name in ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"] {
            command.env_remove(name);
        }
        // A workspace of whoever runs the tests is left alone.
        command.env("XDG_DATA_HOME", folder.path().join("data"));
        command.current_dir(folder.path()).output().unwrap()
    };
    let done = without_display(&["FL2"]);
    assert_eq!(done.status.code(), Some(0));
    the_one_line(&String::from_utf8(done.stderr).unwrap());
    let words = String::from_utf8(done.stdout).unwrap();
    assert!(words.starts_with("FL2 (light"), "{words}");
    let picture = words.lines().last().unwrap().strip_prefix("Picture   ");
    if cfg!(feature = "window") {
        let picture = fs::read(folder.path().join(picture.expect("the picture is named")));
        assert!(picture.unwrap().starts_with(b"\x89PNG"));
    } else {
        assert_eq!(picture, None);
    }
    let insisted = without_display(&["FL2", "--window"]);
    assert_eq!(insisted.status.code(), Some(3));
    assert!(insisted.stdout.is_empty());
    the_one_line(&String::from_utf8(insisted.stderr).unwrap());
}

#[test]
fn read_prints_every_file_though_one_is_bad() {
    let folder = tempfile::tempdir().unwrap();
    let good = write(
        folder.path(),
        "a.csv",
        "nm,irradiance\n400,1\n500,3\n600,2\n",
    );
    let bad = write(folder.path(), "b.txt", "nothing to read\n");
    let also = write(
        folder.path(),
        "c.csv",
        "nm,reflectance %\n400,10\n500,30\n600,20\n",
    );
    let told = tell(&["read", &good, &bad, &also]);
    assert_eq!(told.outcome, Outcome::Done(1));
    assert!(told.out.contains("a.csv: plain columns") && told.out.contains("c.csv: plain columns"));
    assert!(the_one_line(&told.err).contains("b.txt"), "{}", told.err);
    // As JSON, every file in its place.
    let told = tell(&["read", "--json", &good, &bad, &also]);
    assert_eq!(told.outcome, Outcome::Done(1));
    let all: Value = serde_json::from_str(&told.out).unwrap();
    let all = all.as_array().unwrap();
    let errors: Vec<bool> = all.iter().map(|file| file["error"].is_null()).collect();
    assert_eq!(errors, [true, false, true]);
    for file in all {
        for key in [
            "file",
            "format",
            "spectra",
            "composites",
            "images",
            "makers_results",
            "notes",
            "error",
        ] {
            assert!(file.get(key).is_some(), "{key} is not in {file}");
        }
    }
    let spectrum = &all[2]["spectra"][0];
    for (key, value) in [
        ("kind", Value::from("reflectance")),
        ("points", 3.into()),
        ("first_nm", 400.0.into()),
        ("last_nm", 600.0.into()),
        ("first_value", 10.0.into()),
        ("last_value", 20.0.into()),
        ("sum", 60.0.into()),
        ("max", 30.0.into()),
        ("max_at_nm", 500.0.into()),
        ("scale", 0.01.into()),
        ("unit", "fraction".into()),
    ] {
        assert_eq!(spectrum[key], value, "{key}");
    }
}

#[test]
fn read_takes_a_folder_with_the_folders_below_it() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("more")).unwrap();
    for name in ["b.csv", "more/c.csv", "a.csv", ".hidden"] {
        write(folder.path(), name, "nm,irradiance\n400,1\n500,3\n600,2\n");
    }
    let all = json(&["read", folder.path().to_str().unwrap(), "--json"]);
    let names: Vec<&str> = all
        .as_array()
        .unwrap()
        .iter()
        .filter_map(|file| file["file"].as_str())
        .collect();
    assert_eq!(names.len(), 3, "{names:?}");
    for (name, end) in names.iter().zip(["a.csv", "b.csv", "more/c.csv"]) {
        assert!(name.ends_with(end), "{name}");
    }
    let empty = folder.path().join("empty");
    std::fs::create_dir(&empty).unwrap();
    let line = refusal(1, &["read", empty.to_str().unwrap()]);
    assert!(line.contains("expected a folder with files"), "{line}");
}

#[test]
fn read_lists_pixels_of_an_image_that_has_no_spectra_of_its_own() {
    let folder = tempfile::tempdir().unwrap();
    let header = "ENVI\nsamples = 10\nlines = 10\nbands = 2\nheader offset = 0\n\
        data type = 1\ninterleave = bip\nbyte order = 0\n\
        wavelength units = Nanometers\nwavelength = {500, 600}\n";
    let path = write(folder.path(), "cube.hdr", header);
    let numbers: Vec<u8> = (0..200).collect();
    std::fs::write(folder.path().join("cube.img"), numbers).unwrap();
    let all = json(&["read", &path, "--json"]);
    let file = &all[0];
    assert_eq!(file["images"][0]["width"], 10);
    let spectra = file["spectra"].as_array().unwrap();
    let told: Vec<(&str, f64)> = spectra
        .iter()
        .map(|s| {
            (
                s["name"].as_str().unwrap(),
                s["first_value"].as_f64().unwrap(),
            )
        })
        .collect();
    let places = ["row 0 column 0", "row 9 column 9", "row 5 column 5"];
    assert_eq!(told.len(), 3, "{told:?}");
    for ((name, value), (place, first)) in told.iter().zip(places.iter().zip([0.0, 198.0, 110.0])) {
        assert!(name.contains(place), "{name}");
        assert_eq!(*value, first, "{name}");
    }
    let text = said(&["read", &path]);
    assert!(
        text.contains("row 9 column 9: 2 points, lowest 0.7765, highest 0.7804"),
        "{text}"
    );
}

#[test]
fn all_spectra_of_a_file_go_into_one_table() {
    let folder = tempfile::tempdir().unwrap();
    let table = "nm,red reflectance,blue reflectance\n400,0.1,0.9\n500,0.2,0.5\n600,0.8,0.1\n";
    let input = write(folder.path(), "paints.csv", table);
    let out = folder.path().join("all.csv").display().to_string();
    let text = said(&["convert", &input, &out, "--all"]);
    assert!(
        text.contains("2 spectra (reflectance, 3 wavelengths)"),
        "{text}"
    );
    let read = json(&["read", &out, "--json"]);
    let spectra = read[0]["spectra"].as_array().unwrap();
    assert_eq!(spectra.len(), 2);
    assert_eq!(
        (&spectra[1]["first_value"], &spectra[1]["scale"]),
        (&0.9.into(), &1.0.into())
    );
    let sp = folder.path().join("all.sp").display().to_string();
    let line = refusal(2, &["convert", &input, &sp, "--all"]);
    assert!(
        line.contains("--all: found .sp, which holds one spectrum"),
        "{line}"
    );
}

#[test]
fn every_written_format_is_read_and_converted_on() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).display().to_string();
    let mut last = "FL2".to_owned();
    let extensions = ["sp", "csv", "spdx", "sp", "spd", "json", "sp", "csv"];
    for (number, extension) in extensions.iter().enumerate() {
        let next = place(&format!("x{number}.{extension}"));
        let text = said(&["convert", &last, &next]);
        assert!(text.starts_with("Wrote "), "{text}");
        last = next;
    }
    let [first, end] = [place("first.csv"), last].map(|path| {
        if !std::path::Path::new(&path).exists() {
            said(&["convert", "FL2", &path]);
        }
        json(&["read", &path, "--json"])[0]["spectra"][0]["sum"].clone()
    });
    assert_eq!(first, end);
    // A model in one line, there and back.
    let line = place("model.txt");
    said(&["convert", "FL2", &line, "--order", "5"]);
    let text = std::fs::read_to_string(&line).unwrap();
    assert!(
        text.starts_with("cs1;") && text.lines().count() == 1,
        "{text}"
    );
    let again = place("again.txt");
    said(&["convert", &line, &again]);
    assert_eq!(std::fs::read_to_string(&again).unwrap(), text);
    // What a format does not keep is said.
    let uneven = write(
        folder.path(),
        "uneven.csv",
        "nm,irradiance\n400,1\n403,3\n600,2\n",
    );
    let text = said(&["convert", &uneven, &place("uneven.sp")]);
    assert!(text.contains("resampled to 201 values"), "{text}");
}

#[test]
fn an_observer_of_ones_own_has_the_colours_of_its_table() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("ten degrees.csv");
    let table = spectral_explorer::color::Observer::CIE_1964.table();
    let mut text = String::from("nm,xbar,ybar,zbar\n");
    // From 300 nm on: more than any shipped table has.
    for nm in 300..=900 {
        let [x, y, z] = table.at(f64::from(nm));
        text += &format!("{nm},{x},{y},{z}\n");
    }
    fs::write(&path, text).expect("written");
    let of = |observer: &str| json(&["report", "FL2", "--observer", observer, "--json"]);
    let (own, shipped) = (of(path.to_str().expect("UTF-8")), of("1964"));
    assert_eq!(own["settings"]["observer"], "ten degrees");
    let numbers = |report: &Value| -> Vec<f64> {
        let xyz = report["colour"]["exact"]["xyz"]
            .as_array()
            .expect("three numbers");
        xyz.iter().map(|v| v.as_f64().expect("a number")).collect()
    };
    for (a, b) in numbers(&own).iter().zip(numbers(&shipped)) {
        // The same products summed in another order.
        assert!((a - b).abs() < 1e-9, "{a} {b}");
    }
    let why = refusal(2, &["report", "FL2", "--observer", "1932", "--json"]);
    assert!(
        why.contains("expected 1931, 1964, 2015-2, 2015-10 or a file"),
        "{why}"
    );
}
