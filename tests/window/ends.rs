//! No setting, file or workspace keeps the window from starting: every setting at its ends, drawn
//! by a driver whose largest texture is a small one.

use std::{
    fs,
    sync::{
        Arc,
        atomic::{AtomicUsize, Ordering},
    },
};

use crate::{
    driver::{about, display, no_files, with, words},
    full::{full_document, full_preferences, spectrum},
};
use eframe::egui;
use egui::{Key, Role};
use egui_kittest::{Harness, TestRenderer, kittest::Queryable as _};
use serde_json::{Value, json};
use spectral_explorer::{
    app::{
        App, Command, Detector, Document, Message, Scale, Subject,
        pages::{FieldChoice, Page, Show, Spread},
        products::{Link, Products},
        workspace::{self, Preferences, Restored},
    },
    color::Observer,
    spectrum::{Band, Basis, Kind, NamedSpectrum, Sampled, Sampling},
    study::Measure,
    ui::{Window, shell, verdict_view::Side},
};

/// The largest texture of the driver: less than most have.
const SIDE: usize = 2048;

/// A driver that looks at the sizes of textures and draws nothing.
#[derive(Clone, Default)]
struct Driver {
    largest: Arc<AtomicUsize>,
}

impl TestRenderer for Driver {
    fn handle_delta(&mut self, delta: &mut egui::TexturesDelta) {
        for change in delta.set.values().flatten() {
            for side in change.image.size() {
                self.largest.fetch_max(side, Ordering::SeqCst);
            }
        }
        delta.clear();
    }

    fn render(
        &mut self,
        _: &egui::Context,
        _: &egui::FullOutput,
    ) -> Result<image::RgbaImage, String> {
        Err("nobody looks".to_owned())
    }
}

struct Shown(Window, Driver);

impl eframe::App for Shown {
    fn ui(&mut self, ui: &mut egui::Ui, _: &mut eframe::Frame) {
        self.0.show(ui);
    }
}

type Ui = Harness<'static, Shown>;

fn over(app: App, preferences: Preferences) -> Ui {
    let window = Window::new(App::new(), Preferences::default(), no_files(), None);
    let driver = Driver::default();
    let mut ui: Ui = display([1280.0, 800.0], 0.02, 40)
        .renderer(driver.clone())
        .build_eframe(|_| Shown(window, driver));
    // A larger texture is a panic of its own.
    ui.input_mut().max_texture_side = Some(SIDE);
    ui.step();
    start(&mut ui, app, preferences);
    ui
}

/// Another program in the same window.
fn start(ui: &mut Ui, app: App, preferences: Preferences) {
    let window = &mut ui.state_mut().0;
    window.app = app;
    window.preferences = preferences;
    for _ in 0..3 {
        ui.step();
    }
}

#[track_caller]
fn assert_sound(ui: &Ui, case: &str) {
    let largest = ui.state().1.largest.load(Ordering::SeqCst);
    assert!(largest <= SIDE, "{case}: a texture of {largest} texels");
    let words = words(ui).join(" | ");
    assert!(!words.contains("broke down"), "{case}: {words}");
    let is_no_number = words
        .split(|c: char| !c.is_alphanumeric())
        .any(|word| matches!(word, "NaN" | "inf" | "Infinity"));
    assert!(!is_no_number, "{case}: {words}");
}

// ------------------------------------------------------------------------------ every setting

type Place = Vec<String>;

/// Every single value of a workspace beside the spectra's own numbers and names.
fn leaves(value: &Value, at: &Place, all: &mut Vec<Place>) {
    let pieces: Vec<(String, &Value)> = match value {
        Value::Object(fields) => fields.iter().map(|(k, v)| (k.clone(), v)).collect(),
        Value::Array(items) => {
            let numbered = items.iter().enumerate();
            numbered.map(|(i, v)| (i.to_string(), v)).collect()
        }
        _ => return all.push(at.clone()),
    };
    for (key, piece) in pieces {
        leaves(piece, &at.iter().cloned().chain([key]).collect(), all);
    }
}

fn at<'v>(value: &'v mut Value, place: &[String]) -> &'v mut Value {
    place.iter().fold(value, |value, step| match value {
        Value::Array(items) => &mut items[step.parse::<usize>().expect("a number")],
        other => &mut other[step.as_str()],
    })
}

/// The choices among words, all words of each.
fn choices() -> Vec<Vec<Value>> {
    fn words<T: serde::Serialize>(all: impl IntoIterator<Item = T>) -> Vec<Value> {
        let word = |value| serde_json::to_value(value).expect("a word");
        all.into_iter().map(word).collect()
    }
    vec![
        words(Page::all()),
        words(Sampling::ALL),
        words(Observer::CIE),
        words(Scale::ALL),
        words(FieldChoice::ALL),
        words(Show::ALL),
        words([Spread::Deviation, Spread::Extremes]),
        words([Basis::Fourier, Basis::Cosine]),
        words([Detector::Energy, Detector::Gradient]),
        words([Subject::Light, Subject::Factor]),
        words(Measure::COMPARED),
    ]
}

/// What a value of this form is tried as.
fn ends(value: &Value) -> Vec<Value> {
    match value {
        Value::Bool(is) => vec![json!(!is)],
        Value::Number(_) => vec![
            json!(0),
            json!(1),
            json!(0.5),
            json!(-1e300),
            json!(1e300),
            json!(u64::MAX),
        ],
        Value::String(_) => {
            let all = choices().into_iter().filter(|words| words.contains(value));
            all.flatten().chain([json!("no such word")]).collect()
        }
        _ => vec![json!(0), json!(u64::MAX), json!("no such key")],
    }
}

/// The page on which a setting is seen.
fn page_of(place: &Place) -> Page {
    let step = |index: usize| place.get(index).map_or("", String::as_str);
    if step(0) == "products" {
        return Page::Chain;
    }
    if (step(0), step(1)) != ("preferences", "pages") {
        return Page::Spectrum;
    }
    match step(2) {
        "partial_order" | "channel" => Page::Coefficients,
        "measure" | "ways" => Page::Tradeoff,
        "goal" | "auction_numbers" => Page::Auction,
        "field" | "race_numbers" | "race_measure" => Page::Race,
        "products" => {
            // What a page of products remembers stands under the word of an earlier version.
            Page::of_word(step(3)).unwrap_or(Page::Chain)
        }
        "image" => Page::Image,
        _ => Page::Spectrum,
    }
}

/// Workspaces to walk over: one in which everything is set, and a first start's.
fn grounds() -> [Value; 2] {
    let read = |document: &Document, preferences: &Preferences| {
        let text = workspace::to_json(document, Some(preferences)).expect("written");
        serde_json::from_str(&text).expect("our own JSON")
    };
    let mut full = full_document();
    full.subject = Subject::Light;
    [
        read(&full, &full_preferences()),
        read(App::new().document(), &Preferences::default()),
    ]
}

/// Draws a workspace with one setting changed, on the page where it is seen.
fn draw(ui: &mut Ui, restored: Restored, place: &Place, case: &str) {
    println!("{case}");
    let (app, mut preferences, _) = Window::restored(restored);
    let page = page_of(place);
    if place.last().is_none_or(|last| last != "page") {
        preferences.page = page;
    }
    start(ui, app, preferences);
    assert_sound(ui, case);
    if page != Page::Spectrum && page != Page::Race {
        ui.state_mut().0.studies.finish();
        ui.step();
        assert_sound(ui, case);
    }
}

#[test]
fn the_window_starts_with_every_setting_at_its_ends() {
    let mut ui = over(App::new(), Preferences::default());
    let [full, first] = grounds();
    let is_setting =
        |place: &Place| !["own", "format", "version", "program"].contains(&place[0].as_str());
    // What a first start shows differs in all that the model is made by.
    let is_of_model = |place: &Place| ["settings", "view", "scale"].contains(&place[0].as_str());
    let mut walked = 0;
    for (ground, is_walked) in [
        (full, &is_setting as &dyn Fn(&Place) -> bool),
        (first, &is_of_model),
    ] {
        let mut all = Vec::new();
        leaves(&ground, &Vec::new(), &mut all);
        all.retain(is_walked);
        assert!(all.len() > 20, "only {} settings", all.len());
        for place in all {
            // Many values come to the same.
            let mut seen = Vec::new();
            for end in ends(at(&mut ground.clone(), &place)) {
                let mut value = ground.clone();
                *at(&mut value, &place) = end.clone();
                let restored = workspace::from_json(&value.to_string()).expect("a workspace");
                let now = (restored.document.clone(), restored.preferences.clone());
                if !seen.contains(&now) {
                    seen.push(now);
                    walked += 1;
                    let case = format!("{} = {end}", place.join("."));
                    draw(&mut ui, restored, &place, &case);
                }
            }
        }
    }
    println!("{walked} starts");
    assert!(walked > 200, "only {walked} starts");
}

/// Documents on which pages have nothing to show, or much.
fn extremes() -> Vec<(&'static str, App)> {
    let ranged = |ends: [f64; 2]| {
        with(App::new(), |s| {
            s.band = Band::nearest(ends).expect("numbers");
        })
    };
    let mut nothing_chosen = App::new();
    nothing_chosen.apply(Command::Products(Products::default()));
    let mut darkness = App::new();
    darkness.apply(Command::Adopt(vec![spectrum(
        "dark",
        Kind::Light,
        380.0,
        5.0,
        vec![0.0; 81],
    )]));
    let mut long = App::new();
    let surface = Link::once(long.entry("colorchecker_ohta/red").expect("shipped"));
    long.apply(Command::Products(Products {
        chain: vec![surface; 16],
        ..long.document().products.clone()
    }));
    vec![
        ("the widest range", ranged([0.0, 1e9])),
        ("the shortest range", ranged([540.0, 560.0])),
        ("a dark range", ranged([2000.0, 2400.0])),
        ("an unseen range", ranged([800.0, 1000.0])),
        ("order 0", with(App::new(), |s| s.order = 0)),
        ("cosines", with(App::new(), |s| s.basis = Basis::Cosine)),
        ("a surface", about("colorchecker_ohta/red")),
        ("darkness", darkness),
        ("a chain of 16", long),
        (
            "the sun with its dark lines",
            with(
                about("solar_astm_g173/ASTM G173-03 global tilt AM1.5G"),
                |s| {
                    s.dips = true;
                    s.threshold_percent = 0.1;
                    s.max_width_nm = 4.5;
                },
            ),
        ),
        ("nothing chosen", nothing_chosen),
    ]
}

#[test]
fn every_page_is_drawn_on_whatever_there_is() {
    let mut ui = over(App::new(), Preferences::default());
    for (what, app) in extremes() {
        for page in Page::all() {
            let preferences = Preferences {
                page,
                ..Preferences::default()
            };
            start(&mut ui, app.clone(), preferences);
            assert_sound(&ui, &format!("{} on {what}", page.title()));
        }
    }
}

#[test]
fn a_workspace_with_any_range_at_all_starts() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("workspace.json");
    let mut ui = over(App::new(), Preferences::default());
    for (stored, taken, is_told) in [
        (json!([0.0, 20_000.0]), [0.0, 20_000.0], false),
        (json!([0.0, 1e300]), [0.0, 20_000.0], true),
        (json!([99_999.0, 99_999.0]), [99_980.0, 100_000.0], true),
        (json!([380.5, 780.0]), [381.0, 780.0], true),
        (json!([null, null]), [380.0, 780.0], true),
        (json!("inf"), [380.0, 780.0], true),
    ] {
        let [_, mut value] = grounds();
        value["settings"]["band"] = stored.clone();
        fs::write(&path, value.to_string()).expect("a file");
        let restart = shell::restore(Some(&path));
        let band = <[f64; 2]>::from(restart.app.document().settings.band);
        assert_eq!(band, taken, "{stored}");
        let words = |m: &Message| m.text.contains("range") || m.text.contains("settings.band");
        let told = restart.app.messages().iter().any(words);
        assert_eq!(told, is_told, "{stored}: {:?}", restart.app.messages());
        start(&mut ui, restart.app, restart.preferences);
        assert_sound(&ui, &stored.to_string());
    }
}

// -------------------------------------------------------------------------------- typed ranges

/// The window with every knob.
fn with_settings(app: App) -> Ui {
    let mut ui = over(app, Preferences::default());
    ui.state_mut().0.side = Side::Settings;
    ui.run();
    ui
}

#[test]
fn a_range_typed_behind_more_is_said_too() {
    let mut ui = over(App::new(), Preferences::default());
    ui.get_by_role_and_label(Role::Button, "More").click();
    ui.run();
    type_into(&mut ui, "Range to", "30000");
    assert_eq!(band(&ui), [380.0, 20_380.0]);
    assert!(said(&ui).contains("at most 20000 nm"), "{:?}", said(&ui));
}

fn type_into(ui: &mut Ui, name: &str, text: &str) {
    ui.get_by_role_and_label(Role::SpinButton, name).click();
    ui.run();
    ui.event(egui::Event::Text(text.to_owned()));
    ui.run();
    ui.key_press(Key::Enter);
    ui.run();
}

fn band(ui: &Ui) -> [f64; 2] {
    ui.state().0.app.document().settings.band.into()
}

fn said(ui: &Ui) -> &str {
    let message = ui.state().0.app.current_message();
    message.map_or("", |message| message.text.as_str())
}

#[test]
fn a_typed_range_that_is_none_becomes_one_and_is_said() {
    for (name, text, taken, word) in [
        ("Range to", "30000", [380.0, 20_380.0], "at most 20000 nm"),
        ("Range to", "1e9", [380.0, 20_380.0], "at most 20000 nm"),
        ("Range to", "1e300", [380.0, 20_380.0], "at most 20000 nm"),
        ("Range to", "-5", [380.0, 400.0], "found -5"),
        ("Range to", "inf", [380.0, 780.0], "found \"inf\""),
        ("Range to", "NaN", [380.0, 780.0], "found \"NaN\""),
        ("Range to", "far away", [380.0, 780.0], "found \"far away\""),
        ("Range to", "700.4", [380.0, 700.0], "found 700.4"),
        ("Range from", "-1e9", [0.0, 780.0], "found -1000000000"),
        ("Range from", "1e9", [760.0, 780.0], "20 nm above MIN"),
        ("Range from", "inf", [380.0, 780.0], "780 nm stays"),
    ] {
        let mut ui = with_settings(App::new());
        type_into(&mut ui, name, text);
        assert_eq!(band(&ui), taken, "{name} {text}");
        assert!(said(&ui).contains(word), "{name} {text}: {:?}", said(&ui));
        assert!(
            said(&ui).starts_with("The model's range: "),
            "{}",
            said(&ui)
        );
    }
    let mut ui = with_settings(App::new());
    for (name, text) in [
        ("Range to", "20380"),
        ("Range to", "700 nm"),
        ("Range from", "400"),
    ] {
        type_into(&mut ui, name, text);
        assert_eq!(said(&ui), "", "{text} is a range");
    }
    assert_eq!(band(&ui), [400.0, 700.0]);
}

#[test]
fn a_tables_range_that_is_too_wide_is_cut_and_said() {
    for (last_nm, taken, is_said) in [(18_000.0, 18_000.0, false), (90_000.0, 20_300.0, true)] {
        let step = (last_nm - 300.0) / 300.0;
        let values = (0..=300).map(|i| 1.0 + f64::from(i % 7)).collect();
        let far = NamedSpectrum {
            samples: Sampled::even(300.0, step, values).expect("a table"),
            ..spectrum("far", Kind::Light, 300.0, 1.0, vec![1.0; 2])
        };
        let mut app = App::new();
        app.apply(Command::Adopt(vec![far]));
        let mut ui = with_settings(app);
        ui.get_by_role_and_label(Role::Button, "table's").click();
        ui.run();
        assert_eq!(band(&ui), [300.0, taken]);
        let words = "at most 20000 nm below 100000 nm, found 300:90000; 300 to 20300 nm is taken";
        assert_eq!(said(&ui).contains(words), is_said, "{:?}", said(&ui));
        assert_sound(&ui, "a table's range");
    }
}
