//! The page "Race" in the real window, driven without a display.

use std::sync::Arc;

use eframe::egui;
use egui::Role;
use egui_kittest::{
    Harness,
    kittest::{NodeT as _, Queryable as _},
};
use spectral_explorer::{
    app::{
        App,
        pages::{FieldChoice, Page, PageMemory},
        studies::Stage,
        workspace::Preferences,
    },
    ui::{Window, files::Picked, theme},
};

struct Shown(Window);

impl eframe::App for Shown {
    fn ui(&mut self, ui: &mut egui::Ui, _: &mut eframe::Frame) {
        self.0.show(ui);
    }
}

type Ui = Harness<'static, Shown>;

fn race_of(field: FieldChoice) -> Ui {
    let preferences = Preferences {
        pages: PageMemory {
            page: Page::Race,
            field,
            ..PageMemory::default()
        },
        ..Preferences::default()
    };
    let window = Window::new(
        App::new(),
        preferences,
        Arc::new(|_| Picked::Cancelled),
        None,
    );
    let mut ui = Harness::builder()
        .with_size([1920.0, 2600.0])
        .with_step_dt(0.02)
        .with_max_steps(40)
        .with_context_setup(theme::install_fonts)
        .build_eframe(|_| Shown(window));
    ui.step();
    ui.state_mut().0.studies.finish();
    ui.run();
    ui
}

fn words(ui: &Ui) -> Vec<String> {
    let node = |node: egui_kittest::Node<'_>| {
        let node = node.accesskit_node();
        [node.label(), node.value()]
    };
    ui.root()
        .children_recursive()
        .flat_map(node)
        .flatten()
        .collect()
}

#[track_caller]
fn assert_written(ui: &Ui, text: &str) {
    let words = words(ui);
    let is_there = words.iter().any(|w| w.contains(text));
    assert!(is_there, "{text:?} is not on screen: {}", words.join(" | "));
}

#[track_caller]
fn click(ui: &mut Ui, name: &str) {
    let mut found = ui.query_all_by_role_and_label(Role::Button, name);
    found
        .next()
        .unwrap_or_else(|| panic!("no button {name:?}"))
        .click();
    drop(found);
    ui.run();
    ui.remove_cursor();
    ui.run();
}

#[test]
fn the_light_at_hand_races_and_another_count_shows_at_once() {
    let mut ui = race_of(FieldChoice::ThisLight);
    let name = ui.state().0.app.document().light.name().to_owned();
    assert_written(&ui, &format!("{name}, 20 numbers each"));
    assert_written(&ui, "Principal components");
    assert!(!words(&ui).iter().any(|w| w.contains("larger collection")));
    click(&mut ui, "31 numbers");
    assert_eq!(ui.state().0.preferences.pages.race_numbers, 31);
    assert_eq!(ui.state().0.studies.race.stage(), Stage::Done);
    assert_written(&ui, &format!("{name}, 31 numbers each"));
}

#[test]
fn a_whole_set_shows_both_halves_and_a_click_on_a_light_shows_it() {
    let mut ui = race_of(FieldChoice::Fluorescent);
    assert_written(&ui, "77 lights, 20 numbers each");
    assert_written(&ui, "Fluorescent: the composite wins");
    assert_written(
        &ui,
        "Fluorescent: the composite loses: principal components",
    );
    assert_written(&ui, "79 fluorescent");
    click(&mut ui, "Show FL3 (3)");
    assert_eq!(ui.state().0.app.document().light.name(), "FL3");
    // The lights that race are the same: the result stands.
    assert_eq!(ui.state().0.studies.race.stage(), Stage::Done);
}

#[test]
fn without_lights_of_ones_own_the_page_says_so() {
    let ui = race_of(FieldChoice::Own);
    assert_written(&ui, "There are no lights of your own");
}
