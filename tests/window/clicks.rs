//! From a first start to an insight: each act of a person is counted.

use std::sync::Arc;

use crate::driver::{Ui, app, assert_written, at_rest, click, no_files, wait_until, words};
use crate::sizes;
use eframe::egui;
use egui::accesskit::Toggled;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use spectral_explorer::{
    app::{App, pages::Page, workspace::Preferences},
    study::Measure,
    ui::Window,
};

/// A person before a window that was never opened, and how often that person acted.
struct Person {
    ui: Ui,
    acts: usize,
}

impl Person {
    fn at_first_start() -> Self {
        let mut window = Window::new(App::new(), Preferences::default(), no_files(), None);
        window.greet();
        let ui = at_rest(window);
        assert_written(&ui, "What would you like to do?");
        Self { ui, acts: 0 }
    }

    /// Leaves the ways to begin.
    fn escapes(&mut self) {
        self.ui.key_press(egui::Key::Escape);
        self.ui.run();
        self.acts += 1;
    }

    fn presses(&mut self, key: egui::Key) {
        self.ui.key_press(key);
        self.ui.run();
        self.acts += 1;
    }

    /// Drags a slider to a value.
    fn slides(&mut self, name: &str, value: f64) {
        let slider = self.ui.get_by_role_and_label(egui::Role::Slider, name);
        slider.set_value_accesskit(value);
        self.ui.run();
        self.acts += 1;
    }

    fn clicks(&mut self, name: &str) {
        click(&mut self.ui, name);
        self.acts += 1;
        self.ui.step();
        self.ui.state_mut().studies.finish();
        self.ui.run();
    }
}

/// The figure behind a word in what is on screen.
#[track_caller]
fn figure_behind(ui: &Ui, word: &str) -> f64 {
    let all = words(ui).join("\n");
    let (_, rest) = all
        .split_once(word)
        .unwrap_or_else(|| panic!("no {word:?}: {all}"));
    let digits: String = rest
        .trim_start()
        .chars()
        .take_while(|c| c.is_ascii_digit() || *c == '.')
        .collect();
    let found = digits.trim_end_matches('.').parse();
    found.unwrap_or_else(|_| panic!("no figure behind {word:?}: {all}"))
}

#[test]
fn why_lines_matter_is_two_acts_away_on_the_first_screen() {
    let mut person = Person::at_first_start();
    person.escapes();
    person.slides("Lines", 20.0);
    assert_eq!(person.acts, 2);
    let ui = &person.ui;
    assert!(app(ui).derived().model.lines().is_empty());
    // The eye and the instrument disagree, on the same four steps.
    let chosen = |name: &str| {
        let node = ui.get_by_label(name);
        node.accesskit_node().toggled() == Some(Toggled::True)
    };
    assert!(chosen("To the eye: hard to tell"));
    assert!(chosen("To an instrument: large"));
    assert_written(ui, "Through a prism: measured above, model below");
    // The sentence reads back the figure of the report.
    let error = app(ui).derived().figures[Measure::RmsBlurred].expect("an error");
    let told = figure_behind(ui, "The eye hardly notices, but an instrument sees");
    assert!((told - 100.0 * error).abs() < 0.5, "{told} {error}");
}

#[test]
fn a_prism_is_before_the_class_in_three_acts() {
    for starts in [
        &["Picture", "Prism and rainbow"][..],
        &["Light through a prism"],
    ] {
        let mut person = Person::at_first_start();
        if starts.len() > 1 {
            // The ways to begin were left before.
            person.escapes();
            person.acts = 0;
        }
        for name in starts {
            person.clicks(name);
        }
        person.presses(egui::Key::F5);
        assert!(person.acts <= 3);
        let ui = &person.ui;
        assert_eq!(ui.state().preferences.page, Page::Prism);
        let drawn = ui.get_by_label("Drawing of the prism and the light").rect();
        assert!(drawn.area() > 0.4 * 1280.0 * 800.0, "{drawn:?}");
        for slider in ["Apex angle", "Slit"] {
            ui.get_by_role_and_label(egui::Role::Slider, slider);
        }
        let words = sizes::words(ui, egui::vec2(1280.0, 800.0));
        let largest = words.iter().map(|words| words.size).fold(0.0, f32::max);
        assert!(largest >= 28.0, "{largest}");
        person.presses(egui::Key::Escape);
        let preferences = &person.ui.state().preferences;
        assert!(!preferences.present && preferences.page == Page::Prism);
    }
}

#[test]
fn a_hundred_lamps_are_judged_in_five_acts_under_the_names_of_their_files() {
    let folder = tempfile::tempdir().expect("a folder");
    for k in 0..100 {
        let rows = (380..=780).step_by(5).map(|nm| {
            let from = f64::from(nm - 400 - 2 * k) / 60.0;
            format!("{nm},{:.5}\n", (-from * from).exp() + 0.05)
        });
        let text = format!("nm,rel\n{}", rows.collect::<String>());
        std::fs::write(folder.path().join(format!("lamp {k:03}.csv")), text).expect("a file");
    }
    let mut person = Person::at_first_start();
    let path = folder.path().to_owned();
    person
        .ui
        .state_mut()
        .open_files(vec![path], Arc::new(|| {}));
    wait_until(&mut person.ui, "the files", |ui| !ui.state().is_busy());
    person.acts += 1;
    let names: Vec<String> = app(&person.ui)
        .document()
        .own
        .iter()
        .map(|entry| entry.name().to_owned())
        .collect();
    assert_eq!((names.len(), names[7].as_str()), (100, "lamp 007"));
    person.clicks("How many numbers do they need?");
    assert!(person.acts <= 5);
    assert_eq!(person.ui.state().preferences.page, Page::Many);
    assert_written(&person.ui, "of 100 lights");
    assert_written(&person.ui, "lamp 007");
    // Opening was a step of its own.
    person.clicks("Undo");
    let said = app(&person.ui)
        .current_message()
        .expect("a word")
        .text
        .clone();
    assert!(said.starts_with("Undone: opened 100 files from"), "{said}");
    assert!(app(&person.ui).document().own.is_empty());
    person.clicks("Redo");
    person.clicks("Open");
    person.clicks("Files opened together…");
    person.clicks("Compare their quality");
    assert_written(&person.ui, "of 100 lights reach 80.");
}

#[test]
fn that_lines_matter_behind_a_filter_is_three_acts_away() {
    let mut person = Person::at_first_start();
    person.escapes();
    person.clicks("Through");
    person.clicks("One filter");
    assert_eq!(person.acts, 3);
    let ui = &person.ui;
    let composite = figure_behind(ui, "as a composite are off by ΔE₀₀");
    let series = figure_behind(ui, "as a series by");
    assert!(series > 1.0, "without spikes one sees it: {series}");
    assert!(
        10.0 * composite < series,
        "{composite} with spikes, {series} without"
    );
}

#[test]
fn whether_a_light_suits_skin_is_one_act_away() {
    let mut person = Person::at_first_start();
    person.clicks("Is this a good light?");
    assert_eq!(person.acts, 1);
    let painted = sizes::words(&person.ui, egui::vec2(1280.0, 800.0));
    let told = "light skin looks off, strong red looks wrong";
    let is_told = painted.iter().any(|words| words.text.contains(told));
    assert!(is_told, "{painted:?}");
    // FL2 is known for it: R9 below zero; skin has a row of its own.
    let behind = |title: &str| {
        let at = painted.iter().position(|words| words.text == title);
        let figure = at.and_then(|at| painted.get(at + 1));
        figure.and_then(|words| words.text.parse::<f64>().ok())
    };
    assert!(behind("R9").is_some_and(|r9| r9 < 0.0), "{painted:?}");
    assert!(behind("R13").is_some(), "{painted:?}");
}

#[test]
fn how_many_numbers_a_light_needs_is_one_act_away() {
    let mut person = Person::at_first_start();
    person.clicks("How many numbers?");
    assert_eq!(person.acts, 1);
    assert_written(
        &person.ui,
        "To stay under ΔE₀₀ 1 on the surfaces (mean), FL2 needs",
    );
    let needed = figure_behind(&person.ui, "FL2 needs");
    let measured = app(&person.ui).derived().band.points() as f64;
    assert!(
        (1.0..measured / 4.0).contains(&needed),
        "{needed} of {measured}"
    );
}
