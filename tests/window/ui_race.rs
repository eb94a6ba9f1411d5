//! The page "Race" in the real window, driven without a display.

use crate::driver::{Shown, Ui, assert_written, click, harness, no_files, words};
use crate::plain::plain;
use egui_kittest::kittest::Queryable as _;
use spectral_explorer::{
    app::{
        pages::{FieldChoice, Page},
        studies::{RaceAsk, Stage},
        workspace::Preferences,
    },
    ui::Window,
};

fn race_of(field: FieldChoice) -> Ui {
    let preferences = Preferences {
        page: Page::Race,
        ..Preferences::default()
    };
    let mut app = plain();
    app.edit_pages(|pages| pages.race.field = field);
    let window = Window::new(app, preferences, no_files(), None);
    let mut ui = harness(Shown(window), [1920.0, 2600.0], 0.02, 40);
    ui.step();
    ui.state_mut().0.studies.finish();
    ui.run();
    ui
}

#[test]
fn the_light_at_hand_races_and_another_count_shows_at_once() {
    let mut ui = race_of(FieldChoice::ThisLight);
    let name = ui.state().0.app.document().light.name().to_owned();
    assert_written(&ui, &format!("{name}, 20 numbers each"));
    assert_written(&ui, "Principal components");
    assert!(!words(&ui).iter().any(|w| w.contains("composite wins")));
    click(&mut ui, "31 numbers");
    assert_eq!(ui.state().0.app.document().pages.race.numbers, 31);
    assert_eq!(
        ui.state_mut().0.studies.of::<RaceAsk>().stage(),
        Stage::Done
    );
    assert_written(&ui, &format!("{name}, 31 numbers each"));
}

#[test]
fn a_whole_set_shows_both_halves_and_a_click_on_a_light_shows_it() {
    let mut ui = race_of(FieldChoice::Fluorescent);
    for fold in [
        "Every figure at this count",
        "Errors against numbers, and who wins",
    ] {
        // The fold before it may have pushed it below the edge.
        ui.get_by_label(fold).scroll_to_me();
        for _ in 0..40 {
            ui.step();
        }
        ui.get_by_label(fold).click();
        // It opens in a moment.
        for _ in 0..8 {
            ui.run_steps(1);
        }
    }
    assert_written(&ui, "77 lights, 20 numbers each");
    assert_written(&ui, "Fluorescent: the composite wins");
    assert_written(
        &ui,
        "Fluorescent: the composite loses: principal components",
    );
    // The list of lights stands just above what is won and lost.
    ui.query_all_by_label_contains("Fluorescent: the composite wins")
        .next()
        .expect("a sentence")
        .scroll_to_me();
    for _ in 0..40 {
        ui.step();
    }
    click(&mut ui, "Show FL3 (3)");
    assert_eq!(ui.state().0.app.document().light.name(), "FL3");
    // The lights that race are the same: the result stands.
    assert_eq!(
        ui.state_mut().0.studies.of::<RaceAsk>().stage(),
        Stage::Done
    );
}

#[test]
fn without_lights_of_ones_own_the_page_says_so() {
    let ui = race_of(FieldChoice::Own);
    assert_written(&ui, "There are no lights of your own");
}
