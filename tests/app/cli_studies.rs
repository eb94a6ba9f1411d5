//! Sweep, auction and race on the command line: what they print and what they refuse.

use std::{collections::BTreeSet, ffi::OsString, fs};

use serde_json::Value;
use spectral_explorer::{
    app::{App, chart::Theme, pages::Page, workspace::Preferences},
    cli::{self, Outcome, Pictures},
};

/// Writes down what it was asked for instead of drawing it.
struct Sketch;

impl Pictures for Sketch {
    fn window(&self, _: &App, preferences: &Preferences, _: [u32; 2]) -> Vec<u8> {
        preferences.page.word().as_bytes().to_vec()
    }

    fn plot(&self, _: &App, _: Theme, _: [u32; 2]) -> Vec<u8> {
        Vec::new()
    }
}

struct Told {
    outcome: Outcome,
    out: String,
    err: String,
}

fn tell(args: &[&str]) -> Told {
    let program = OsString::from(cli::PROGRAM);
    let args = std::iter::once(program).chain(args.iter().map(OsString::from));
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let outcome = cli::run(args, Some(&Sketch), &mut out, &mut err);
    Told {
        outcome,
        out: String::from_utf8(out).expect("UTF-8"),
        err: String::from_utf8(err).expect("UTF-8"),
    }
}

fn json(args: &[&str]) -> Value {
    let told = tell(args);
    assert_eq!(told.outcome, Outcome::Done(0), "{args:?}: {}", told.err);
    serde_json::from_str(&told.out).expect("JSON")
}

/// One line on `err`, nothing on `out`, and the exit code.
fn refusal(args: &[&str]) -> (String, u8) {
    let told = tell(args);
    let Outcome::Done(code) = told.outcome else {
        panic!("{args:?}: opened a window");
    };
    assert_ne!(code, 0, "{args:?}: {}", told.out);
    assert_eq!(told.out, "", "{args:?}");
    assert_eq!(told.err.lines().count(), 1, "{args:?}: {}", told.err);
    assert!(told.err.contains("found"), "{}", told.err);
    assert!(told.err.contains("expected"), "{}", told.err);
    (told.err, code)
}

/// A table with its comments, its titles and its lines, each with as many cells as there are
/// titles.
fn table(args: &[&str]) -> (Vec<String>, Vec<String>, Vec<Vec<String>>) {
    let told = tell(args);
    assert_eq!(told.outcome, Outcome::Done(0), "{args:?}: {}", told.err);
    let is_comment = |line: &&str| line.starts_with('#');
    let comments = told.out.lines().filter(is_comment).map(str::to_owned);
    let comments: Vec<String> = comments.collect();
    let mut lines = told
        .out
        .lines()
        .filter(|line| !line.starts_with('#'))
        .map(cells);
    let titles = lines.next().expect("titles");
    let rows: Vec<Vec<String>> = lines.collect();
    for row in &rows {
        assert_eq!(row.len(), titles.len(), "{row:?}");
    }
    (comments, titles, rows)
}

fn cells(line: &str) -> Vec<String> {
    let (mut all, mut cell, mut quoted) = (Vec::new(), String::new(), false);
    for sign in line.chars() {
        match sign {
            '"' => quoted = !quoted,
            ',' if !quoted => all.push(std::mem::take(&mut cell)),
            other => cell.push(other),
        }
    }
    all.push(cell);
    all
}

fn keys(value: &Value) -> BTreeSet<&str> {
    let object = value.as_object().expect("an object");
    object.keys().map(String::as_str).collect()
}

fn has(value: &Value, wanted: &[&str]) {
    let keys = keys(value);
    for key in wanted {
        assert!(keys.contains(key), "{key} is not in {keys:?}");
    }
}

#[test]
fn a_sweep_has_every_order_of_every_way_and_marks_the_front() {
    let sweep = json(&["sweep", "FL2", "--json"]);
    has(
        &sweep,
        &["program", "input", "settings", "points", "threshold_map"],
    );
    let points = sweep["points"].as_array().expect("points");
    assert_eq!(points.len(), 8 * 41);
    has(
        &points[0],
        &[
            "way",
            "basis",
            "spikes",
            "spike_count",
            "colour_exact",
            "order",
            "numbers",
            "delta_e_own",
            "delta_e_patches_mean",
            "delta_e_patches_max",
            "delta_e_filters",
            "relative_rms",
            "relative_rms_10nm",
            "on_front",
        ],
    );
    let mut front: Vec<(u64, f64)> = points
        .iter()
        .filter(|p| p["on_front"] == true)
        .map(|p| {
            let error = p["delta_e_patches_mean"].as_f64();
            (
                p["numbers"].as_u64().expect("a count"),
                error.expect("an error"),
            )
        })
        .collect();
    front.sort_by_key(|p| p.0);
    assert!(front.len() > 4, "{front:?}");
    assert!(front.windows(2).all(|w| w[0].0 < w[1].0 && w[0].1 > w[1].1));
    let map = &sweep["threshold_map"];
    assert_eq!(map["thresholds_percent"].as_array().map(Vec::len), Some(25));
    assert_eq!(map["delta_e_own"][24].as_array().map(Vec::len), Some(41));
}

#[test]
fn a_sweeps_table_holds_the_same_numbers_as_its_json() {
    let (comments, titles, rows) = table(&["sweep", "FL2"]);
    assert!(
        comments.iter().any(|c| c.contains("name: FL2")),
        "{comments:?}"
    );
    assert!(
        comments.iter().any(|c| c.contains("source: ")),
        "{comments:?}"
    );
    let sweep = json(&["sweep", "FL2", "--json"]);
    let points = sweep["points"].as_array().expect("points");
    assert_eq!(rows.len(), points.len());
    for (row, point) in rows.iter().zip(points) {
        for (title, cell) in titles.iter().zip(row) {
            match &point[title] {
                Value::Null => assert_eq!(cell, ""),
                Value::Number(n) => assert_eq!(cell.parse::<f64>().ok(), n.as_f64(), "{title}"),
                Value::Bool(b) => assert_eq!(*cell, b.to_string(), "{title}"),
                Value::String(s) => assert_eq!(cell, s, "{title}"),
                other => panic!("{title}: {other}"),
            }
        }
    }
}

#[test]
fn behind_narrow_filters_fl2_buys_mercurys_lines_first() {
    let auction = json(&[
        "auction",
        "FL2",
        "--goal",
        "filters",
        "--numbers",
        "41",
        "--as-in-paper",
        "--json",
    ]);
    has(
        &auction,
        &[
            "goal",
            "basis",
            "colour_exact",
            "ended",
            "steps",
            "with",
            "without",
        ],
    );
    let steps = auction["steps"].as_array().expect("steps");
    assert_eq!(steps[0]["bought"], "order");
    assert_eq!(steps[0]["order"], 0);
    assert_eq!(steps[0]["numbers"], 1);
    for step in steps {
        has(
            step,
            &[
                "numbers",
                "error",
                "order_now",
                "spikes_nm_now",
                "gave_back",
                "delta_e_filters",
            ],
        );
        let is_spike = step["bought"] == "spike";
        assert_eq!(step["at_nm"].is_f64(), is_spike, "{step}");
        assert_eq!(step["order"].is_u64(), step["bought"] == "order", "{step}");
    }
    // A width in between is small change, one number.
    let first_nine: Vec<f64> = steps[1..]
        .iter()
        .filter(|step| step["bought"] != "width")
        .take(9)
        .filter_map(|s| s["at_nm"].as_f64())
        .collect();
    for line in [404.7, 435.8, 546.1, 578.0] {
        let near = first_nine.iter().any(|nm| (nm - line).abs() < 3.0);
        assert!(near, "{line} is not in {first_nine:?}");
    }
    let errors: Vec<f64> = steps.iter().filter_map(|s| s["error"].as_f64()).collect();
    assert!(errors.windows(2).all(|w| w[1] <= w[0]), "{errors:?}");
}

#[test]
fn for_its_own_colour_daylight_buys_no_line() {
    let auction = json(&[
        "auction",
        "CIE D65",
        "--goal",
        "own",
        "--numbers",
        "41",
        "--as-in-paper",
        "--json",
    ]);
    let steps = auction["steps"].as_array().expect("steps");
    assert!(steps.len() > 3);
    assert!(steps.iter().all(|s| s["bought"] == "order"), "{steps:?}");
}

#[test]
fn an_auctions_table_has_a_line_for_every_purchase_and_goals_mix() {
    let args = [
        "auction",
        "FL2",
        "--goal",
        "patches=2,filters=1",
        "--numbers",
        "21",
    ];
    let (comments, titles, rows) = table(&args);
    assert!(
        comments.iter().any(|c| c.contains("patches 2, filters 1")),
        "{comments:?}"
    );
    let at = |title: &str| titles.iter().position(|t| t == title).expect("a column");
    assert_eq!(rows[0][at("bought")], "order");
    assert_eq!(rows[0][at("error")], "1", "a mix counts its start as 1");
    let with_json: Vec<&str> = args.iter().copied().chain(["--json"]).collect();
    let steps = json(&with_json)["steps"].as_array().map(Vec::len);
    assert_eq!(steps, Some(rows.len()));
}

#[test]
fn a_race_has_one_row_a_representation_and_set() {
    let race = json(&["race", "--set", "discharge", "--numbers", "20,11", "--json"]);
    let rows = race["rows"].as_array().expect("rows");
    assert_eq!(rows.len(), 17 * 2, "one class is one set");
    for row in rows {
        has(
            row,
            &[
                "representation",
                "title",
                "numbers",
                "set",
                "lamps",
                "negative_lobes",
                "bytes",
                "ns_per_product",
                "ns_per_evaluation",
                "needs_table",
                "is_prefix",
                "wins",
            ],
        );
        for spread in [
            "delta_e_patches",
            "delta_e_own",
            "delta_e_check",
            "delta_e_filters",
            "relative_rms",
            "relative_rms_10nm",
        ] {
            assert_eq!(
                keys(&row[spread]),
                BTreeSet::from(["median", "p95", "worst"])
            );
            assert!(row[spread]["worst"].as_f64() >= row[spread]["median"].as_f64());
        }
        assert_eq!(row["set"], "discharge");
        assert_eq!(row["lamps"], 18);
    }
    assert_eq!(
        (&rows[0]["numbers"], &rows[17]["numbers"]),
        (&11.into(), &20.into())
    );
    let wins: u64 = rows[..17].iter().filter_map(|r| r["wins"].as_u64()).sum();
    assert_eq!(wins, 18, "every light has one winner");
}

#[test]
fn all_lights_race_class_by_class_and_together() {
    let (comments, titles, rows) = table(&["race", "--numbers", "11"]);
    assert!(
        comments.iter().any(|c| c.contains("all shipped lights")),
        "{comments:?}"
    );
    let at = |title: &str| titles.iter().position(|t| t == title).expect("a column");
    let sets: BTreeSet<&str> = rows.iter().map(|row| row[at("set")].as_str()).collect();
    let expected = ["LED", "all", "discharge", "fluorescent", "smooth"];
    assert_eq!(sets, BTreeSet::from(expected));
    assert_eq!(rows.len(), 17 * 5);
    let named = |row: &&Vec<String>| row[at("representation")] == "principal";
    assert!(
        rows.iter()
            .filter(named)
            .all(|row| row[at("needs_table")] == "true")
    );
    for row in &rows {
        let median: f64 = row[at("delta_e_patches_median")].parse().expect("a number");
        let worst: f64 = row[at("delta_e_patches_worst")].parse().expect("a number");
        assert!(0.0 < median && median <= worst);
    }
}

#[test]
fn a_race_tells_in_how_many_cells_known_lamps_and_wide_lines_are_ahead() {
    let race = json(&["race", "FL11", "--numbers", "2,20", "--strict", "--json"]);
    let judged = &race["judged"];
    assert_eq!(judged["count"], "strict");
    let rows = judged["rows"].as_array().expect("rows");
    for word in ["known-lamps", "wide-lines", "principal"] {
        let row = rows.iter().find(|row| row["representation"] == word);
        let row = row.expect("everybody has a row");
        assert_eq!(row["numbers"], 20, "2 numbers carry no colour");
        assert!(row["filters"]["median"].as_f64() > Some(0.0));
    }
    for word in ["known-lamps", "wide-lines"] {
        let row = |row: &&Value| row["representation"] == word && row["numbers"] == 20;
        let row = race["rows"]
            .as_array()
            .and_then(|rows| rows.iter().find(row));
        let row = row.expect("everybody has a row among the others");
        assert_eq!(row["needs_table"], word == "known-lamps");
        // What judges is the same there and here.
        let judged = rows.iter().find(|row| row["representation"] == word);
        let judged = judged.expect("a row");
        assert_eq!(row["delta_e_check"], judged["patches_check"]);
        assert_eq!(row["relative_rms_10nm"], judged["relative_rms_10nm"]);
    }
    for cell in judged["cells"].as_array().expect("cells") {
        // Three errors of one light at one count; its median, 95th percentile and worst are one figure.
        assert_eq!(cell["of"], 3);
        let behind = cell["behind"].as_array().map(Vec::len);
        let won = cell["won"].as_u64().expect("a count") as usize;
        assert_eq!(behind.map(|behind| behind + won), Some(3));
    }
    let (comments, ..) = table(&["race", "FL11", "--numbers", "20"]);
    let told = comments
        .iter()
        .find(|c| c.contains("cells won by known-lamps"));
    assert!(
        told.is_some_and(|c| c.contains(" of 3 against moments")),
        "{comments:?}"
    );
    let dark = json(&["race", "FL11", "--numbers", "2", "--json"]);
    assert!(dark["judged"].is_null());
}

#[test]
fn one_light_races_alone_and_counts_repeat() {
    let race = json(&[
        "race",
        "FL2",
        "--numbers",
        "11",
        "--numbers",
        "20,11",
        "--json",
    ]);
    let rows = race["rows"].as_array().expect("rows");
    assert_eq!(rows.len(), 17 * 2);
    assert!(rows.iter().all(|row| row["lamps"] == 1));
    assert_eq!(race["field"], "FL2");
}

#[test]
fn a_folder_of_lights_races_and_what_cannot_is_told_and_skipped() {
    let folder = tempfile::tempdir().expect("a folder");
    let write = |name: &str, text: String| fs::write(folder.path().join(name), text).expect(name);
    let light = |slope: f64| {
        let rows = (0..=80).map(|i| format!("{},{}\n", 380 + 5 * i, 40.0 + slope * f64::from(i)));
        format!("nm,irradiance (W/m2/nm)\n{}", rows.collect::<String>())
    };
    write("a.csv", light(1.0));
    write("b.csv", light(-0.3));
    write("c.csv", "no spectrum at all\n".to_owned());
    for (name, value) in [("dark.csv", 0), ("negative.csv", -1)] {
        let rows = (0..=80).map(|i| format!("{},{value}\n", 380 + 5 * i));
        write(
            name,
            format!("nm,irradiance (W/m2/nm)\n{}", rows.collect::<String>()),
        );
    }
    fs::create_dir(folder.path().join("below")).expect("a folder");
    write("below/d.csv", light(2.0));
    let path = folder.path().to_str().expect("Unicode");
    let told = tell(&["race", "--set", path, "--numbers", "11", "--json"]);
    assert_eq!(told.outcome, Outcome::Done(0), "{}", told.err);
    assert!(told.err.contains("c.csv"), "{}", told.err);
    assert!(!told.err.contains("/d.csv"), "{}", told.err);
    let skipped = told.err.matches("nothing above zero").count();
    assert_eq!(skipped, 2, "{}", told.err);
    let race: Value = serde_json::from_str(&told.out).expect("JSON");
    assert!(
        race["rows"]
            .as_array()
            .expect("rows")
            .iter()
            .all(|row| row["lamps"] == 2)
    );
    for name in ["a.csv", "b.csv", "dark.csv", "negative.csv"] {
        fs::remove_file(folder.path().join(name)).expect("it is there");
    }
    let told = tell(&["race", "--set", path, "--numbers", "11"]);
    assert_eq!(told.outcome, Outcome::Done(1));
    assert!(told.err.contains("found no light"), "{}", told.err);
}

#[test]
#[expect(clippy::too_many_lines, reason = "a table: one row a refusal")]
fn what_makes_no_sense_is_refused_in_one_line() {
    for (args, code, words) in [
        (&["race", "--numbers", "0"][..], 2, "1 to 101"),
        (&["race", "--numbers", "11,102"], 2, "1 to 101"),
        (&["race", "--numbers", "-3"], 2, "1 to 101"),
        (&["race", "FL2"], 2, "--numbers"),
        (
            &["race", "FL2", "--set", "led", "--numbers", "9"],
            2,
            "--set",
        ),
        (&["race", "--set", "nosuch", "--numbers", "9"], 1, "nosuch"),
        (
            &["race", "--set", "atomic_lines", "--numbers", "9"],
            1,
            "atomic_lines",
        ),
        (
            &["race", "--set", "cri_tcs", "--numbers", "9"],
            1,
            "cri_tcs",
        ),
        (&["race", "blue sky", "--numbers", "9"], 1, "a light"),
        (&["race", "--light", "FL2", "--numbers", "9"], 2, "--light"),
        (&["auction", "FL2", "--numbers", "9"], 2, "--goal"),
        (&["auction", "FL2", "--goal", "own"], 2, "--numbers"),
        (
            &["auction", "FL2", "--goal", "red", "--numbers", "9"],
            2,
            "filters",
        ),
        (
            &["auction", "FL2", "--goal", "own=-1", "--numbers", "9"],
            2,
            "own=-1",
        ),
        (
            &["auction", "FL2", "--goal", "own=0", "--numbers", "9"],
            2,
            "own=0",
        ),
        (
            &["auction", "FL2", "--goal", "own", "--numbers", "0"],
            2,
            "1 to 101",
        ),
        (
            &["auction", "blue sky", "--goal", "patches", "--numbers", "9"],
            2,
            "own or spectrum",
        ),
        (
            &[
                "auction",
                "blue sky",
                "--goal",
                "own=1,filters=1",
                "--numbers",
                "9",
            ],
            2,
            "filters",
        ),
        (
            &[
                "auction",
                "FL2",
                "--goal",
                "own",
                "--numbers",
                "9",
                "--range",
                "900:1000",
            ],
            1,
            "FL2",
        ),
        (&["sweep", "FL2", "--range", "900:1000"], 1, "zeros"),
        (&["sweep", "no such light"], 1, "no such light"),
        (
            &["render", "FL2", "--out", "x.png", "--page", "home"],
            2,
            "tradeoff",
        ),
    ] {
        let (told, found) = match args {
            ["sweep", "no such light"] => {
                let told = tell(args);
                (told.err, 1)
            }
            _ => refusal(args),
        };
        assert_eq!(found, code, "{args:?}: {told}");
        assert!(told.contains(words), "{args:?}: {told}");
    }
    for (args, words) in [
        (["product", "FL2", "no such thing"], "FACTOR: no shipped"),
        (
            ["product", "no such thing", "FL2"],
            "FACTOR: FL2: found a light",
        ),
        (
            ["product", "no such thing", "colorchecker_ohta/red"],
            "LIGHT: no shipped",
        ),
    ] {
        let told = tell(&args);
        assert_eq!(told.outcome, Outcome::Done(1), "{args:?}");
        assert_eq!((told.out.as_str(), told.err.lines().count()), ("", 1));
        assert!(told.err.contains(words), "{args:?}: {}", told.err);
    }
}

#[test]
fn a_reflectance_is_swept_and_auctioned_by_what_it_has() {
    let sweep = json(&["sweep", "blue sky", "--json"]);
    assert_eq!(sweep["front_of"], "delta_e_own");
    assert!(sweep["points"][3]["delta_e_patches_mean"].is_null());
    assert_eq!(sweep["input"]["light"], "CIE D65");
    let auction = json(&[
        "auction",
        "blue sky",
        "--goal",
        "own",
        "--numbers",
        "21",
        "--as-in-paper",
        "--json",
    ]);
    assert!(auction["steps"].as_array().is_some_and(|s| s.len() > 2));
}

#[test]
fn counts_beyond_what_a_short_range_holds_are_raced_all_the_same() {
    let args = [
        "race",
        "FL2",
        "--numbers",
        "1,2,3,101",
        "--range",
        "400:420",
        "--json",
    ];
    let race = json(&args);
    assert_eq!(race["rows"].as_array().map(Vec::len), Some(17 * 4));
}

#[test]
fn options_that_change_nothing_are_told() {
    let told = tell(&[
        "auction",
        "FL2",
        "--goal",
        "own",
        "--numbers",
        "5",
        "--order",
        "9",
    ]);
    assert_eq!(told.outcome, Outcome::Done(0));
    assert!(told.err.contains("--order is not used"), "{}", told.err);
}

#[test]
fn a_picture_can_be_of_any_page() {
    let folder = tempfile::tempdir().expect("a folder");
    for page in Page::all() {
        let path = folder.path().join(format!("{}.png", page.word()));
        let out = path.to_str().expect("Unicode");
        let told = tell(&["render", "FL2", "--out", out, "--page", page.word()]);
        assert_eq!(told.outcome, Outcome::Done(0), "{}", told.err);
        assert_eq!(fs::read_to_string(&path).expect("written"), page.word());
    }
}

const GLASS: &str = "isuzu IVG550 (Green filter) 2 mm";

/// Every stage has its keys and the light's four spikes by name.
fn has_stages(stages: &[Value]) {
    for stage in stages {
        has(
            stage,
            &[
                "name",
                "delta_e_2000",
                "luminance_error",
                "added",
                "folded_share",
                "multiplications",
                "transmission",
                "exact",
                "model",
                "spikes",
                "lines_on_dips",
                "below_zero_nm",
                "turned_negative_nm",
            ],
        );
        let spikes = stage["spikes"].as_array().expect("spikes");
        assert_eq!(spikes.len(), 4);
        has(&spikes[0], &["at_nm", "weight", "name"]);
        assert_eq!(spikes[1]["name"], "Hg 435.8");
    }
}

#[test]
fn a_product_has_its_total_and_every_stage_with_its_spikes() {
    let product = json(&[
        "product",
        "FL2",
        GLASS,
        "colorchecker_ohta/red",
        "colorchecker_ohta/red",
        "--sampling",
        "double",
        "--as-in-paper",
        "--json",
    ]);
    has(
        &product,
        &[
            "program",
            "light",
            "settings",
            "sampling",
            "factors",
            "delta_e_2000",
            "luminance_error",
            "added",
            "total",
            "folded_share",
            "multiplications",
            "transmission",
            "exact",
            "model",
            "stages",
            "notes",
        ],
    );
    assert_eq!(product["sampling"], "double");
    assert_eq!(product["light"]["name"], "FL2");
    assert_eq!(product["total"], product["delta_e_2000"]);
    for side in ["exact", "model"] {
        let xyz = product[side]["xyz"].as_array().expect("XYZ");
        assert_eq!(xyz.len(), 3);
        let hex = product[side]["srgb_hex"].as_str().expect("a colour");
        assert!(hex.starts_with('#') && hex.len() == 7, "{hex}");
    }
    let stages = product["stages"].as_array().expect("stages");
    assert_eq!(stages.len(), 3);
    has_stages(stages);
    assert_eq!(stages[0]["name"], GLASS);
    // Fifteen numbers of a glass that is black at 404.9 nm ring below zero there.
    let turned = stages[0]["turned_negative_nm"].as_array().expect("places");
    assert_eq!(turned.len(), 1);
    assert_eq!(stages[0]["below_zero_nm"], Value::Array(Vec::new()));
    let notes = product["notes"].to_string();
    assert!(notes.contains("turns the line there negative"), "{notes}");
    // The last stage is the total.
    for key in ["delta_e_2000", "luminance_error", "added", "exact", "model"] {
        assert_eq!(stages[2][key], product[key], "{key}");
    }
    // The same surface twice takes the same share of every line twice.
    let weight = |stage: usize, spike: usize| {
        stages[stage]["spikes"][spike]["weight"]
            .as_f64()
            .expect("a weight")
    };
    for spike in 0..4 {
        let (first, second) = (
            weight(1, spike) / weight(0, spike),
            weight(2, spike) / weight(1, spike),
        );
        // Two quotients of the same factor.
        assert!((first / second - 1.0).abs() < 1e-12);
    }
}

#[test]
fn every_way_of_forming_products_may_be_asked_for() {
    let mut added = BTreeSet::new();
    for way in ["paper", "3n", "4n", "double", "convolution", "exact"] {
        let args = ["product", "FL2", "colorchecker_ohta/red", "--json"];
        let product = json(&[&args[..], &["--sampling", way]].concat());
        assert_eq!(product["sampling"], way);
        added.insert(product["added"].to_string());
    }
    // Those that fold nothing differ by rounding alone, the others add something each.
    assert!(added.len() >= 4, "{added:?}");
    let exact = json(&["product", "FL2", "colorchecker_ohta/red", "--json"]);
    assert_eq!(exact["sampling"], "exact");
    assert_eq!(exact["added"], 0.0);
}

#[test]
fn a_light_over_a_set_of_factors_is_median_p95_and_worst() {
    let args = [
        "product",
        "CIE D65",
        "--set",
        "tm30_ces99_5nm",
        "--sampling",
        "paper",
    ];
    let set = json(&[&args[..], &["--json"]].concat());
    has(
        &set,
        &["set", "count", "added", "total", "items", "sampling"],
    );
    assert_eq!(set["set"], "tm30_ces99_5nm");
    assert_eq!(set["count"], 99);
    assert_eq!(set["items"].as_array().expect("items").len(), 99);
    for spread in ["added", "total"] {
        let figure = |key: &str| set[spread][key].as_f64().expect("a figure");
        assert!(0.0 < figure("median") && figure("median") < figure("p95"));
        assert!(figure("p95") < figure("worst"));
    }
    let told = tell(&args);
    assert_eq!(told.outcome, Outcome::Done(0));
    for word in ["Light", "Added", "Total", "tm30_ces99_5nm", "99"] {
        assert!(told.out.contains(word), "{word}: {}", told.out);
    }
}

#[test]
fn a_product_for_people_says_what_passes_and_what_it_costs() {
    let told = tell(&["product", "FL2", GLASS, "colorchecker_ohta/red"]);
    assert_eq!(told.outcome, Outcome::Done(0), "{}", told.err);
    for word in [
        "Light     FL2",
        "Stage 1",
        "Stage 2",
        "spike",
        "Total",
        "Exact",
        "Model",
    ] {
        assert!(told.out.contains(word), "{word}: {}", told.out);
    }
    assert!(!told.out.contains("NaN"));
}

#[test]
fn dips_of_a_factor_are_kept_when_they_are_asked_for_and_the_result_says_what_met() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("didymium.csv");
    let rows: String = (380..=780)
        .map(|nm| {
            let x = (f64::from(nm) - 578.0) / 3.0;
            format!("{nm},{}\n", 0.9 - 0.8 * (-x * x).exp())
        })
        .collect();
    fs::write(&path, rows).expect("a file");
    let path = path.to_str().expect("UTF-8");
    let args = ["product", "FL2", path, "--kind", "transmittance", "--json"];
    let plain = json(&[&args[..], &["--sampling", "double"]].concat());
    let kept = json(&[&args[..], &["--sampling", "double", "--dips"]].concat());
    let stage = |product: &Value| product["stages"][0].clone();
    let negative = |product: &Value| {
        let spikes = stage(product)["spikes"].as_array().expect("spikes").clone();
        let weights = spikes.iter().filter_map(|s| s["weight"].as_f64());
        weights.filter(|weight| *weight < 0.0).count()
    };
    assert_eq!(negative(&plain), 0);
    assert_eq!(stage(&plain)["lines_on_dips"], Value::Array(Vec::new()));
    assert_eq!(negative(&kept), 1);
    // Mercury's yellow pair stands in the middle of the dip.
    let met = stage(&kept)["lines_on_dips"]
        .as_array()
        .expect("a list")
        .clone();
    assert_eq!(met.len(), 1, "{met:?}");
    has(&met[0], &["at_nm", "dip_nm", "depth", "name", "dip_name"]);
    assert_eq!(met[0]["name"], "Hg 577/579");
    // One dip is no neodymium.
    assert!(met[0]["dip_name"].is_null());
    let notes = kept["notes"].to_string();
    assert!(notes.contains("stands on a dip"), "{notes}");
}

#[test]
fn thickness_times_and_the_spectrum_of_a_file_stand_behind_a_factors_name() {
    let passes = |args: &[&str]| {
        let product = json(&[&["product", "FL2"], args, &["--json"]].concat());
        product["transmission"]["exact"].as_f64().expect("a share")
    };
    let thick = passes(&[&format!("{GLASS}@4mm")]);
    for same in [format!("{GLASS}@x2"), format!("{GLASS}*2")] {
        // Two powers of the same shares.
        assert!((passes(&[&same]) / thick - 1.0).abs() < 1e-12, "{same}");
    }
    assert!((passes(&[GLASS, GLASS]) / thick - 1.0).abs() < 1e-12);
    let told = tell(&["product", "FL2", &format!("{GLASS}@3mm*2")]);
    assert!(
        told.out.contains("2 mm, 3 mm thick, 2 times"),
        "{}",
        told.out
    );

    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("two@x3.csv");
    let rows: String = (380..=780).map(|nm| format!("{nm},0.5,0.25\n")).collect();
    fs::write(&path, format!("wavelength_nm,half,quarter\n{rows}")).expect("a file");
    let path = path.to_str().expect("UTF-8");
    for (word, share) in [
        (path.to_owned(), 0.5),
        (format!("{path}#2"), 0.25),
        (format!("{path}#quarter"), 0.25),
        (format!("{path}#1@x2*2"), 0.0625),
    ] {
        let found = passes(&[&word, "--kind", "transmittance"]);
        assert!((found - share).abs() < 1e-9, "{word}: {found}");
    }
    // Of a file of lights too.
    let light = format!("{path}#quarter");
    let product = json(&["product", &light, "colorchecker_ohta/red", "--json"]);
    assert_eq!(product["light"]["name"], "quarter");

    for (word, code, words) in [
        ("colorchecker_ohta/red*17", 2, "1 to 16"),
        ("colorchecker_ohta/red@2", 2, "4mm"),
        ("colorchecker_ohta/red@x2", 2, "a thickness of a surface"),
        (&format!("{GLASS}@x21"), 2, "0 to 20"),
        ("colorchecker_ohta/red#2", 1, "found a preset"),
        (&format!("{path}#3"), 1, "found no spectrum"),
    ] {
        let (told, found) = refusal(&["product", "FL2", word]);
        assert_eq!(found, code, "{word}: {told}");
        assert!(told.contains(words), "{word}: {told}");
    }
}

#[test]
fn a_factor_met_several_times_is_that_many_factors_in_every_way() {
    for sampling in ["paper", "3n", "4n", "double", "convolution", "exact"] {
        let product = |factors: &[&str]| {
            json(
                &[
                    &["product", "FL2"],
                    factors,
                    &["--sampling", sampling, "--json"],
                ]
                .concat(),
            )
        };
        let red = "colorchecker_ohta/red";
        let (once, each) = (product(&[&format!("{red}*3")]), product(&[red, red, red]));
        assert_eq!(once["stages"].as_array().map(Vec::len), Some(1));
        for key in ["delta_e_2000", "added", "luminance_error", "folded_share"] {
            let [a, b] = [&once, &each].map(|v| v[key].as_f64().expect("a number"));
            // The same products in the same order.
            assert!(
                (a - b).abs() <= 1e-12 * (1.0 + b.abs()),
                "{sampling} {key}: {a} {b}"
            );
        }
        assert_eq!(
            once["multiplications"], each["multiplications"],
            "{sampling}"
        );
        assert_eq!(
            once["stages"][0]["spikes"], each["stages"][2]["spikes"],
            "{sampling}"
        );
    }
}

#[test]
fn a_light_that_is_zero_everywhere_is_refused_and_one_out_of_sight_says_so() {
    let folder = tempfile::tempdir().expect("a folder");
    let dark = folder.path().join("dark.csv");
    let rows: String = (380..=780).map(|nm| format!("{nm},0\n")).collect();
    fs::write(&dark, rows).expect("a file");
    let dark = dark.to_str().expect("UTF-8");
    for rest in [&["colorchecker_ohta/red"][..], &["--set", "cri_tcs"]] {
        let (told, code) = refusal(&[&["product", dark], rest].concat());
        assert_eq!(code, 1);
        assert!(told.contains("found nothing but zeros"), "{told}");
    }
    let told = tell(&[
        "product",
        "CIE A",
        "colorchecker_ohta/red",
        "--range",
        "800:830",
    ]);
    assert_eq!(told.outcome, Outcome::Done(0), "{}", told.err);
    assert!(!told.out.contains("NaN"));
}

#[test]
fn dips_of_holmium_and_of_the_sun_are_named() {
    let product = json(&[
        "product",
        "ASTM G173-03 global tilt AM1.5G",
        "usgs_splib07/Holmium oxide powder (USGS splib07a Record 18789)",
        "--range",
        "380:700",
        "--dips",
        "--threshold",
        "0.15",
        "--max-width",
        "25",
        "--sampling",
        "double",
        "--json",
    ]);
    let spikes = product["stages"][0]["spikes"].as_array().expect("spikes");
    let names: Vec<&str> = spikes.iter().filter_map(|s| s["name"].as_str()).collect();
    assert!(
        names.iter().any(|name| name.starts_with("Ho ")),
        "{names:?}"
    );
}

#[test]
fn products_that_make_no_sense_are_refused_in_one_line() {
    let folder = tempfile::tempdir().expect("a folder");
    let lamp = folder.path().join("lamp.csv");
    let rows: String = (380..=780).map(|nm| format!("{nm},0.5\n")).collect();
    fs::write(
        &lamp,
        format!("# unit: W/m2/nm\nwavelength_nm,irradiance (W/m2/nm)\n{rows}"),
    )
    .expect("a file");
    let lamp = lamp.to_str().expect("UTF-8");
    for (args, code, words) in [
        (&["product", "FL2"][..], 2, "FACTOR"),
        (&["product", "FL2", "CIE A"], 1, "found a light"),
        (&["product", "FL2", lamp], 1, "found a light"),
        (
            &["product", "colorchecker_ohta/red", "colorchecker_ohta/red"],
            1,
            "expected a light",
        ),
        (
            &["product", "FL2", "--set", "no_such_group"],
            1,
            "no_such_group",
        ),
        (
            &["product", "FL2", "--set", "cie_fluorescent_1nm"],
            1,
            "without",
        ),
        (
            &[
                "product",
                "FL2",
                "colorchecker_ohta/red",
                "--set",
                "tm30_ces99_5nm",
            ],
            2,
            "--set",
        ),
        (
            &[
                "product",
                "FL2",
                "--set",
                "tm30_ces99_5nm",
                "--kind",
                "reflectance",
            ],
            2,
            "--kind",
        ),
        (
            &[
                "product",
                "FL2",
                "colorchecker_ohta/red",
                "--sampling",
                "5n",
            ],
            2,
            "convolution",
        ),
        (&["product", "FL2", "CIE A", "--kind", "light"], 2, "--kind"),
    ] {
        let (told, found) = refusal(args);
        assert_eq!(found, code, "{args:?}: {told}");
        assert!(told.contains(words), "{args:?}: {told}");
    }
}
