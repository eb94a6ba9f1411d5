//! From a first start to an insight: each act of a person is counted.

use crate::driver::{Ui, app, assert_written, at_rest, click, no_files, words};
use crate::sizes;
use eframe::egui;
use spectral_explorer::{
    app::{App, workspace::Preferences},
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
fn that_spikes_matter_is_three_acts_away() {
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
fn whether_a_light_suits_skin_is_two_acts_away() {
    let mut person = Person::at_first_start();
    person.escapes();
    person.clicks("Quality");
    assert_eq!(person.acts, 2);
    // FL2 is known for it: R9 below zero; skin has rows of its own.
    let painted = sizes::words(&person.ui, egui::vec2(1280.0, 800.0));
    let told = |words: &sizes::Words| words.text.contains("strong red looks wrong: R9 -");
    assert!(painted.iter().any(told), "{painted:?}");
}

#[test]
fn how_many_numbers_a_light_needs_is_one_act_away() {
    let mut person = Person::at_first_start();
    person.clicks("How many numbers?");
    assert_eq!(person.acts, 1);
    assert_written(
        &person.ui,
        "To stay under ΔE₀₀ 1 on the patches (mean), FL2 needs",
    );
    let needed = figure_behind(&person.ui, "FL2 needs");
    let measured = app(&person.ui).derived().band.points() as f64;
    assert!(
        (1.0..measured / 4.0).contains(&needed),
        "{needed} of {measured}"
    );
}
