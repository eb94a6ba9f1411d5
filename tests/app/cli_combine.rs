//! `combine`: formulas, scans, ranges and slits on the command line.

use std::{ffi::OsString, fs, path::Path};

use serde_json::Value;
use spectral_explorer::{
    cli::{self, Outcome},
    preset,
};

/// What the command did: exit code, what it printed and what it said beside.
fn tell(args: &[&str]) -> (u8, String, String) {
    let words = [cli::PROGRAM, "combine"];
    let words = words.iter().chain(args).map(OsString::from);
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let outcome = cli::run(words, None, &mut out, &mut err);
    let Outcome::Done(code) = outcome else {
        panic!("{outcome:?}");
    };
    let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
    (code, text(out), text(err))
}

#[track_caller]
fn said(args: &[&str]) -> String {
    let (code, out, err) = tell(args);
    assert_eq!(code, 0, "{err}");
    out
}

#[track_caller]
fn json(args: &[&str]) -> Value {
    serde_json::from_str(&said(&[&["--json"], args].concat())).expect("JSON")
}

#[track_caller]
fn refused(code: u8, args: &[&str]) -> String {
    let (found, out, err) = tell(args);
    assert_eq!((found, out.as_str()), (code, ""), "{err}");
    err
}

fn numbers(value: &Value) -> Vec<f64> {
    let all = value.as_array().expect("a list").iter();
    all.map(|v| v.as_f64().unwrap_or(f64::NAN)).collect()
}

/// A file of a light, and its path in words.
fn put(folder: &Path, name: &str, unit: &str, rows: impl Iterator<Item = (f64, f64)>) -> String {
    let rows: String = rows.map(|(nm, value)| format!("{nm},{value}\n")).collect();
    let path = folder.join(name);
    fs::write(&path, format!("wavelength (nm),{unit}\n{rows}")).expect(name);
    path.to_str().expect("UTF-8").to_owned()
}

/// Normal numbers, as near as twelve even ones come to them, from a linear congruence.
fn noise(seed: u64) -> impl Iterator<Item = f64> {
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let mut even = move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    std::iter::from_fn(move || Some((0..12).map(|_| even()).sum::<f64>() - 6.0))
}

/// Files of scans of a lamp, whose ends are tilted by a share.
fn scans_of(folder: &Path, name: &str, count: usize, tilt: f64) -> Vec<String> {
    let lamp = preset::table("cie_led_1nm", "LED-B3").expect("a shipped lamp");
    let top = lamp.values().iter().fold(0.0_f64, |top, v| top.max(*v));
    let scan = |index: usize| {
        let seed = index as u64 + 1 + if tilt > 0.0 { 100 } else { 0 };
        let mut noise = noise(seed);
        let level = 1.0 + 0.01 * noise.next().expect("endless");
        let rows = lamp.nm().iter().zip(lamp.values()).zip(noise);
        let rows = rows.map(|((nm, v), e)| {
            let tilted = v * (1.0 + tilt * (nm - 580.0) / 200.0);
            (*nm, level * tilted + 1e-3 * top * e)
        });
        put(
            folder,
            &format!("{name}{index}.csv"),
            "irradiance (W m-2 nm-1)",
            rows,
        )
    };
    (0..count).map(scan).collect()
}

/// Files of scans of one lamp.
pub(crate) fn scans(folder: &Path, count: usize) -> Vec<String> {
    scans_of(folder, "scan", count, 0.0)
}

/// Files of scans of the lamp with its red up and its blue down by a tenth.
pub(crate) fn tilted(folder: &Path, count: usize) -> Vec<String> {
    scans_of(folder, "tilted", count, 0.1)
}

/// A light with mercury's lines as a slit of 5 nm shows them.
pub(crate) fn seen(folder: &Path) -> String {
    let line = |at: f64, nm: f64| 5.0 * (-4.0 * 2.0_f64.ln() * ((nm - at) / 5.0).powi(2)).exp();
    let mut noise = noise(11);
    let rows = (380..=780).map(|nm| {
        let nm = f64::from(nm);
        let lines: f64 = [404.656, 435.833, 546.074]
            .map(|at| line(at, nm))
            .iter()
            .sum();
        (
            nm,
            1.0 + 0.002 * (nm - 380.0) + lines + 2e-3 * noise.next().expect("endless"),
        )
    });
    put(
        folder,
        "seen.csv",
        "irradiance (W m-2 nm-1)",
        rows.collect::<Vec<_>>().into_iter(),
    )
}

/// Two ranges of FL2, the upper read 1.25 times as high.
pub(crate) fn ranges(folder: &Path) -> [String; 2] {
    let lamp = preset::table("cie_fluorescent_1nm", "FL2").expect("a shipped lamp");
    let part = |name: &str, from: f64, to: f64, by: f64| {
        let rows = lamp.nm().iter().zip(lamp.values());
        let inside = rows.filter(|(nm, _)| (from..=to).contains(*nm));
        put(
            folder,
            name,
            "irradiance (W m-2 nm-1)",
            inside.map(|(nm, v)| (*nm, by * v)),
        )
    };
    [
        part("lower.csv", 380.0, 580.0, 1.0),
        part("upper.csv", 530.0, 780.0, 1.25),
    ]
}

#[test]
fn words_of_a_formula_may_stand_apart_or_together() {
    let together = json(&["A - B", "FL2", "FL2"]);
    let apart = json(&["A", "-", "B", "FL2", "FL2"]);
    assert_eq!(together, apart);
    assert!(numbers(&together["values"]).iter().all(|v| *v == 0.0));
    assert_eq!(together["result"]["quantity"], "radiant");
    let absorbance = json(&["-log10(A / B)", "FL2", "CIE A"]);
    assert_eq!(absorbance["result"]["quantity"], "absorbance");
    assert_eq!(absorbance["figures"], Value::Null);
}

#[test]
fn a_quotient_times_its_divisor_is_what_was_divided() {
    let found = json(&["A / B * B", "--keep-all", "FL2", "CIE A"]);
    let plain = json(&["0.5*A + 0.5*A", "FL2"]);
    let (nm, values) = (numbers(&found["wavelengths"]), numbers(&found["values"]));
    let own = numbers(&plain["values"]);
    for (at, value) in numbers(&plain["wavelengths"]).iter().zip(&own) {
        let index = nm
            .iter()
            .position(|nm| nm == at)
            .expect("a point of the union");
        assert!(
            (values[index] - value).abs() <= 1e-12 * value.abs().max(1.0),
            "{at}"
        );
    }
    let coarse = json(&["A / B", "--grid", "5", "FL2", "CIE A"]);
    let nm = numbers(&coarse["wavelengths"]);
    assert!(nm.windows(2).all(|w| w[1] - w[0] == 5.0), "{nm:?}");
    let of_a = json(&["A / B", "--grid", "a", "FL2", "CIE A"]);
    assert_eq!(of_a["wavelengths"], plain["wavelengths"]);
}

#[test]
fn scans_tell_every_figure_with_its_doubt() {
    let folder = tempfile::tempdir().expect("a folder");
    let files = scans(folder.path(), 5);
    let words: Vec<&str> = ["mean"]
        .into_iter()
        .chain(files.iter().map(String::as_str))
        .collect();
    let found = json(&words);
    assert_eq!(found["result"]["scans"], 5);
    assert_eq!(found["scans"].as_array().map(Vec::len), Some(5));
    let cct = &found["figures"]["cct"];
    let (u, half) = (cct["u"].as_f64(), cct["half_width_95"].as_f64());
    let (u, half) = (u.expect("u"), half.expect("half width"));
    assert!(u > 0.0 && half > 1.9 * u && half < 3.0 * u, "{u} {half}");
    let told = said(&words);
    assert!(told.contains("\nCCT ") && told.contains(" ± "), "{told}");
    let one = json(&["mean", &files[0]]);
    assert!(
        one["notes"][0]
            .as_str()
            .is_some_and(|n| n.starts_with("One scan has no spread"))
    );
    let two = json(&["mean", &files[0], &files[1]]);
    let why = two["notes"][0].as_str().expect("a note");
    assert!(why.contains("Add one more"), "{why}");
}

#[test]
fn what_is_written_as_csv_is_read_back_bit_for_bit() {
    let folder = tempfile::tempdir().expect("a folder");
    let files = scans(folder.path(), 3);
    let out = folder.path().join("mean.csv");
    let out = out.to_str().expect("UTF-8");
    let words: Vec<&str> = ["mean"]
        .into_iter()
        .chain(files.iter().map(String::as_str))
        .collect();
    said(&[&words[..], &["--out", out]].concat());
    let text = fs::read_to_string(out).expect("written");
    assert!(
        text.contains("# scans: 3\n") && text.contains("# level: "),
        "{text}"
    );
    assert!(text.contains(",sigma of "), "{text}");
    let (mean, back) = (json(&words), json(&["mean", out]));
    for key in ["wavelengths", "values", "sigma"] {
        assert_eq!(mean[key], back[key], "{key}");
    }
    assert_eq!(mean["doubt"]["level"], back["doubt"]["level"]);
    assert_eq!(mean["figures"], back["figures"]);
    let again = refused(1, &[&words[..], &["--out", out]].concat());
    assert!(again.contains("--force"), "{again}");
    // A format without a place for it says so.
    let sp = folder.path().join("mean.sp");
    let (code, _, err) = tell(&[&words[..], &["--out", sp.to_str().expect("UTF-8")]].concat());
    assert_eq!(code, 0, "{err}");
    assert!(
        err.contains("keeps neither sigma nor what is masked"),
        "{err}"
    );
}

#[test]
fn json_and_convert_keep_sigma_and_what_is_masked_and_other_formats_say_that_they_do_not() {
    let folder = tempfile::tempdir().expect("a folder");
    let files = scans(folder.path(), 3);
    let path = |name: &str| folder.path().join(name).to_str().expect("UTF-8").to_owned();
    let out = path("mean.json");
    let words = ["mean", &files[0], &files[1], &files[2]];
    said(&[&words[..], &["--out", &out]].concat());
    let (mean, back) = (json(&words), json(&["mean", &out]));
    for key in ["wavelengths", "values", "sigma", "doubt", "figures"] {
        assert_eq!(mean[key], back[key], "{key}");
    }
    let convert = |to: &str| {
        let words = [cli::PROGRAM, "convert", &out, to].map(OsString::from);
        let (mut told, mut err) = (Vec::new(), Vec::new());
        let outcome = cli::run(words, None, &mut told, &mut err);
        assert_eq!(
            outcome,
            Outcome::Done(0),
            "{}",
            String::from_utf8_lossy(&err)
        );
        String::from_utf8(told).expect("UTF-8")
    };
    let csv = path("mean.csv");
    assert!(!convert(&csv).contains("keeps neither"));
    assert_eq!(json(&["mean", &csv])["sigma"], mean["sigma"]);
    let told = convert(&path("mean.spdx"));
    assert!(told.contains(".spdx keeps neither sigma nor"), "{told}");
}

#[test]
fn a_column_of_deviations_of_another_program_is_sigma_only_where_that_is_asked_for() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("foreign.csv");
    let rows: String = (380..=780)
        .map(|nm| format!("{nm},{},0.5\n", nm - 300))
        .collect();
    fs::write(
        &path,
        format!("wavelength (nm),irradiance (W m-2 nm-1),sd\n{rows}"),
    )
    .expect("a file");
    let path = path.to_str().expect("UTF-8");
    let (_, told, said) = tell(&["--json", "mean", path]);
    let plain: Value = serde_json::from_str(&told).expect("JSON");
    assert!(said.contains("--take-sigma takes it"), "{said}");
    assert_eq!(plain["doubt"]["from"], "residuals");
    let taken = json(&["mean", path, "--take-sigma"]);
    assert_eq!(taken["doubt"]["from"], "stated");
    assert!(numbers(&taken["sigma"]).iter().all(|s| *s == 0.5));
    assert_eq!(taken["values"], plain["values"]);
}

#[test]
fn values_and_figures_are_the_same_to_the_bit_with_a_sigma_and_without() {
    let folder = tempfile::tempdir().expect("a folder");
    let lamp = preset::table("cie_led_1nm", "LED-B3").expect("a shipped lamp");
    let row = |(nm, v): (&f64, &f64), end: &str| format!("{nm},{v}{end}\n");
    let rows = |end: &str| -> String {
        let pairs = lamp.nm().iter().zip(lamp.values());
        pairs.map(|pair| row(pair, end)).collect()
    };
    let put = |name: &str, text: String| {
        let path = folder.path().join(name);
        fs::write(&path, text).expect(name);
        path.to_str().expect("UTF-8").to_owned()
    };
    let head = "# Spectral Explorer\n# name: lamp\n# kind: light\n# unit: W/nm\nwavelength_nm,lamp";
    let plain = put("plain.csv", format!("{head}\n{}", rows("")));
    let doubted = put(
        "doubted.csv",
        format!("{head},sigma of lamp\n{}", rows(",0.01")),
    );
    for formula in ["1*A", "A + A", "A / A"] {
        let of = |file: &str| json(&[formula, "--keep-all", file]);
        let (a, b) = (of(&plain), of(&doubted));
        for key in ["wavelengths", "values"] {
            assert_eq!(a[key], b[key], "{formula} {key}");
        }
    }
    let light = |file: &str| -> Value {
        let words = [cli::PROGRAM, "light", "--json", file].map(OsString::from);
        let (mut out, mut err) = (Vec::new(), Vec::new());
        let outcome = cli::run(words, None, &mut out, &mut err);
        assert_eq!(outcome, Outcome::Done(0));
        let told: Value = serde_json::from_slice(&out).expect("JSON");
        let mut told = told.get(0).cloned().unwrap_or(told);
        // What a file is called, and what is said of how it was read.
        for key in ["name", "notes", "input"] {
            told.as_object_mut().expect("keys").remove(key);
            told["model"].as_object_mut().expect("keys").remove(key);
        }
        told
    };
    assert_eq!(light(&plain), light(&doubted));
}

#[test]
fn lights_without_a_common_scale_are_added_at_equal_y_and_quotients_of_surfaces_are_reflectances() {
    let folder = tempfile::tempdir().expect("a folder");
    let even = |by: f64| (380..=780).map(move |nm| (f64::from(nm), by * f64::from(nm)));
    let absolute = put(
        folder.path(),
        "watts.csv",
        "irradiance (W m-2 nm-1)",
        even(3.0),
    );
    let why = refused(1, &["A + B", "CIE A", &absolute]);
    assert!(why.contains("Bring both to equal Y or area first"), "{why}");
    let sum = json(&["A - B", &absolute, &absolute, "--equal", "area"]);
    assert!(numbers(&sum["values"]).iter().all(|v| *v == 0.0));
    let both = json(&["A + B", "CIE A", &absolute, "--equal", "y"]);
    assert_eq!(both["result"]["unit"], "relative");
    let y = both["figures"]["Y"]["value"].as_f64().expect("a sum");
    // Two lights of Y 100; that of a table cut at 380-780 nm is short of the whole by its ends.
    assert!((y - 200.0).abs() < 0.1, "{y}");
    let plain = json(&["A / B", "FL2", "CIE A"]);
    assert_eq!(plain["result"]["quantity"], "transmittance");
    let surface = json(&["A / B", "FL2", "CIE A", "--reflectance"]);
    assert_eq!(surface["result"]["quantity"], "reflectance");
    let tile = put(folder.path(), "white tile.csv", "counts", even(100.0));
    let sample = put(folder.path(), "sample.csv", "counts", even(50.0));
    let of_files = json(&["A / B", &sample, &tile]);
    assert_eq!(of_files["result"]["quantity"], "reflectance");
}

#[test]
fn what_changed_is_named_and_equal_sets_are_the_same() {
    let folder = tempfile::tempdir().expect("a folder");
    let (a, b) = (scans(folder.path(), 5), tilted(folder.path(), 5));
    let both = |first: &[String], second: &[String]| {
        let words: Vec<&str> = ["--json", "changed"]
            .into_iter()
            .chain(first.iter().map(String::as_str))
            .chain(["--"])
            .chain(second.iter().map(String::as_str))
            .collect();
        let found: Value = serde_json::from_str(&said(&words)).expect("JSON");
        found["changed"].clone()
    };
    let found = both(&a, &b);
    assert_eq!(found["verdict"], "different");
    let parts = found["parts"].as_array().expect("parts");
    assert!(parts.iter().any(|p| {
        p["what"]
            .as_str()
            .is_some_and(|w| w.ends_with("of the glow"))
    }));
    assert_eq!(both(&a, &a)["verdict"], "same");
    let few = both(&a[..1], &b[..1]);
    assert_eq!(few["verdict"], "cannot say");
    assert_eq!(few["least_seen_percent"], Value::Null);
    let few = said(&["changed", &a[0], "--", &b[0]]);
    assert!(few.contains("Cannot say: One scan has no spread"), "{few}");
}

#[test]
fn ranges_are_spliced_and_slits_add() {
    let folder = tempfile::tempdir().expect("a folder");
    let [lower, upper] = ranges(folder.path());
    let found = json(&["splice", &lower, &upper]);
    let factor = found["splice"]["factor"].as_f64().expect("a factor");
    assert!((factor - 0.8).abs() < 1e-6, "{factor}");
    assert_eq!(found["result"]["last_nm"], 780.0);
    let seen = json(&["slit", "10", "gauss", "FL2"]);
    assert_eq!(seen["slit"]["shape"], "gauss");
    let out = folder.path().join("seen.csv");
    let out = out.to_str().expect("UTF-8");
    said(&["slit", "10", "gauss", "FL2", "--out", out]);
    let why = refused(1, &["slit", "5", out]);
    assert!(
        why.contains("This light was seen through 10 nm: it cannot be shown as a 5 nm"),
        "{why}"
    );
}

#[test]
fn what_means_nothing_is_refused_with_what_does() {
    let folder = tempfile::tempdir().expect("a folder");
    let why = refused(1, &["-log10(A)", "FL2"]);
    assert!(
        why.contains("A light has no absorbance. Divide it by a reference first."),
        "{why}"
    );
    let why = refused(1, &["A - B", "FL2", "colorchecker_ohta/red"]);
    assert!(why.contains("A is a light and B a reflectance"), "{why}");
    let even = |from: i32, to: i32| (from..=to).map(|nm| (f64::from(nm), 1.0));
    let unit = "irradiance (W m-2 nm-1)";
    let low = put(folder.path(), "low.csv", unit, even(400, 700));
    let high = put(folder.path(), "high.csv", unit, even(720, 780));
    let why = refused(1, &["A + B", &low, &high]);
    assert!(
        why.contains("A ends at 700 nm and B begins at 720 nm: they share no wavelengths."),
        "{why}"
    );
    let why = refused(2, &["A +", "FL2"]);
    assert!(why.contains("FORMULA: found"), "{why}");
    let why = refused(2, &["A / C", "FL2", "CIE A"]);
    assert!(why.contains("INPUT: found 2 of them"), "{why}");
    let why = refused(2, &["A", "FL2", "--grid", "sideways"]);
    assert!(why.contains("--grid"), "{why}");
}

#[test]
fn repeats_of_light_and_report_have_the_keys_of_a_mean_besides_their_own() {
    let folder = tempfile::tempdir().expect("a folder");
    let files = scans(folder.path(), 5);
    let told = |command: &str| -> Value {
        let words = [cli::PROGRAM, command, "--repeats", "--json"];
        let words = words
            .iter()
            .copied()
            .chain(files.iter().map(String::as_str));
        let (mut out, mut err) = (Vec::new(), Vec::new());
        let outcome = cli::run(words.map(OsString::from), None, &mut out, &mut err);
        assert_eq!(
            outcome,
            Outcome::Done(0),
            "{}",
            String::from_utf8_lossy(&err)
        );
        serde_json::from_slice(&out).expect("JSON")
    };
    let words: Vec<&str> = ["mean"]
        .into_iter()
        .chain(files.iter().map(String::as_str))
        .collect();
    let mean = json(&words);
    for command in ["light", "report"] {
        let found = told(command);
        for key in [
            "figures", "lines", "scans", "drift", "doubt", "sigma", "clipped",
        ] {
            assert_eq!(found[key], mean[key], "{command} {key}");
        }
    }
    let light = told("light");
    let (plain, doubted) = (&light["cct"], &light["figures"]["cct"]["value"]);
    let off = plain.as_f64().expect("a CCT") - doubted.as_f64().expect("a CCT");
    assert!(off.abs() < 0.1, "{off}");
}

#[test]
fn an_instrument_learnt_from_a_bulb_makes_lights_of_counts_and_says_what_they_share() {
    let folder = tempfile::tempdir().expect("a folder");
    let response = |nm: f64| 0.2 + (-((nm - 560.0) / 120.0).powi(2)).exp();
    let counts = |lamp: &str, name: &str| {
        let table = match preset::table("cie_illuminants", lamp) {
            Some(table) => table,
            None => preset::table("cie_led_1nm", lamp).expect("a shipped lamp"),
        };
        let top = table.values().iter().fold(0.0_f64, |top, v| top.max(*v));
        let rows = table.nm().iter().zip(table.values());
        let rows = rows.filter(|(nm, _)| (380.0..=780.0).contains(*nm));
        let rows = rows.map(|(nm, v)| (*nm, 40_000.0 * v / top * response(*nm)));
        put(folder.path(), name, "counts", rows)
    };
    let (bulb, lamp) = (counts("CIE A", "bulb.csv"), counts("LED-B3", "lamp.csv"));
    let out = folder.path().join("meter.json");
    let out = out.to_str().expect("UTF-8");
    let learn = [
        "instrument",
        "learn",
        &bulb,
        "--known",
        "black body 2855.5 K",
        "--known-doubt",
        "50",
    ];
    let learnt = json(&[&learn[..], &["--out", out]].concat());
    assert_eq!(learnt["result"]["quantity"], "factor");
    assert_eq!(learnt["instrument"]["first_nm"], 380.0);
    let used = json(&["instrument", "use", out, &lamp]);
    assert_eq!(used["result"]["quantity"], "radiant");
    let plain = json(&["1*A", "LED-B3"]);
    let cct = |of: &Value| of["figures"]["cct"]["value"].as_f64().expect("a CCT");
    // The bulb's tables are of 5 nm, and A is 2848 K by another c2.
    assert!(
        (cct(&used) / cct(&plain) - 1.0).abs() < 0.01,
        "{} {}",
        cct(&used),
        cct(&plain)
    );
    // 50 K of the bulb are some 90 K of a light of 5000 K.
    let u = used["figures"]["cct"]["u"].as_f64().expect("a doubt");
    assert!((30.0..200.0).contains(&u), "{u}");
    let raw = json(&["1*A", &lamp]);
    assert_eq!(
        (&raw["figures"], &raw["counts"]["is"]),
        (&Value::Null, &Value::Bool(true))
    );
    let taken = json(&["1*A", &lamp, "--as-light"]);
    assert!(taken["figures"]["cct"]["value"].is_number(), "{taken}");
    let why = refused(1, &["instrument", "use", &lamp, &lamp]);
    assert!(why.contains("expected an instrument"), "{why}");
}

#[test]
fn composites_are_added_on_their_own_numbers() {
    let found = json(&["A - B", "paper/Mercury", "paper/Mercury"]);
    let lines = found["lines"].as_array().expect("lines");
    assert!(
        !lines.is_empty() && lines.iter().all(|line| line["weight"] == 0.0),
        "{lines:?}"
    );
    assert!(numbers(&found["values"]).iter().all(|v| *v == 0.0));
    // The mean of one is itself, of as many as there are.
    let line = |found: &Value| -> Vec<[f64; 2]> {
        let lines = found["lines"].as_array().expect("lines").iter();
        let number = |line: &Value, key: &str| line[key].as_f64().expect("a number");
        lines
            .map(|line| [number(line, "at_nm"), number(line, "weight")])
            .collect()
    };
    let one = json(&["A", "paper/Mercury"]);
    let mean = json(&[&["mean"][..], &["paper/Mercury"; 4]].concat());
    for (one, mean) in line(&one).iter().zip(line(&mean)) {
        assert!((one[0] - mean[0]).abs() < 1e-9 && (one[1] / mean[1] - 1.0).abs() < 1e-12);
    }
    assert_eq!(line(&one).len(), line(&mean).len());
}

#[test]
fn what_is_not_used_is_said_and_what_was_asked_for_stands_first() {
    let folder = tempfile::tempdir().expect("a folder");
    let files = scans(folder.path(), 4);
    let [a, b, c] = [0, 1, 2].map(|index| files[index].as_str());
    let two = said(&["A - B", a, b, c]);
    assert!(two.starts_with("A - B; A = scan0; B = scan1\n"), "{two}");
    let unused = "Note      Not used: scan2. The formula has no letter for it.";
    assert!(two.contains(unused), "{two}");
    let same = said(&["changed", a, b, c, "--", a, b, c]);
    assert!(
        same.starts_with("Same: no difference beyond the noise"),
        "{same}"
    );
    let few = said(&["changed", a, b, "--", a, b, c]);
    assert!(
        few.trim_end().ends_with("The first set has too few."),
        "{few}"
    );
    let (_, _, err) = tell(&["changed", a, b, c, "--", a, b, c, "--json"]);
    assert!(err.contains("options stand before --"), "{err}");
    let (_, _, err) = tell(&[a, b]);
    assert!(
        err.contains("or alone one of the words mean, splice"),
        "{err}"
    );
}

#[test]
fn repeats_of_counts_have_lines_and_no_figures() {
    let folder = tempfile::tempdir().expect("a folder");
    let line = |nm: f64| 200.0 + 9000.0 * (-((nm - 546.1) / 2.0).powi(2)).exp();
    let scan = |index: u64| {
        let rows = (380..=780).map(f64::from).zip(noise(index));
        let rows = rows.map(|(nm, e)| (nm, (line(nm) + 5.0 * e).round()));
        put(folder.path(), &format!("scan{index}.csv"), "counts", rows)
    };
    let files: Vec<String> = (1..5).map(scan).collect();
    for command in ["report", "light"] {
        let words = [cli::PROGRAM, command, "--repeats"].into_iter();
        let words = words.chain(files.iter().map(String::as_str));
        let (mut out, mut err) = (Vec::new(), Vec::new());
        let outcome = cli::run(words.map(OsString::from), None, &mut out, &mut err);
        assert_eq!(outcome, Outcome::Done(0));
        let text = String::from_utf8(out).expect("UTF-8");
        assert!(text.starts_with("scan1, mean of 4\n"), "{text}");
        assert!(
            text.contains("Line      546.") && text.contains("Counts, not light"),
            "{text}"
        );
        assert!(
            !text.contains("CIEDE2000") && !text.contains("xy "),
            "{text}"
        );
    }
}

#[test]
fn a_slit_is_told_by_the_lights_own_lines_and_taken_off() {
    let folder = tempfile::tempdir().expect("a folder");
    let seen = seen(folder.path());
    let found = json(&["unslit", "auto", &seen]);
    let fwhm = found["slit"]["fwhm_nm"].as_f64().expect("a width");
    assert!((fwhm - 5.0).abs() < 0.3, "{fwhm}");
    let lines = found["lines"].as_array().expect("lines");
    // The area of a Gaussian of height 5 and width 5: 26.6.
    for at in [404.656, 435.833, 546.074] {
        let near = |line: &&Value| (line["at_nm"].as_f64().expect("nm") - at).abs() < 0.3;
        let line = lines.iter().find(near).expect("the line");
        let weight = line["weight"].as_f64().expect("a weight");
        assert!((weight - 26.6).abs() < 1.5, "{at}: {weight}");
    }
    let why = refused(1, &["unslit", "auto", "CIE A"]);
    assert!(
        why.contains("No line without width was found: the slit cannot be told. Give its width."),
        "{why}"
    );
}
