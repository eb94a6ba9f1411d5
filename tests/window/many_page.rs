//! The page "Many lights" in the real window, driven without a display.

use crate::driver::{Shown, Ui, app, assert_written, click, harness, no_files, words};
use spectral_explorer::{
    app::{
        App,
        pages::{FieldChoice, Page},
        workspace::Preferences,
    },
    ui::Window,
};

fn page_of(field: FieldChoice) -> Ui {
    let preferences = Preferences {
        page: Page::Many,
        greeted: true,
        ..Preferences::default()
    };
    let mut app = App::new();
    app.edit_pages(|pages| pages.many.field = field);
    let window = Window::new(app, preferences, no_files(), None);
    let mut ui = harness(Shown(window), [1280.0, 800.0], 0.02, 40);
    ui.step();
    ui.state_mut().studies.finish();
    ui.run();
    ui
}

#[test]
fn the_order_that_is_enough_for_a_set_of_lights_is_told_and_taken() {
    let mut ui = page_of(FieldChoice::Smooth);
    assert_written(&ui, "enough for");
    let all = words(&ui).join("\n");
    let (before, _) = all.split_once(" waves (").expect("a count of waves");
    let digits = before.rsplit(|c: char| !c.is_ascii_digit()).next();
    let order: usize = digits
        .and_then(|digits| digits.parse().ok())
        .expect("a number");
    click(&mut ui, &format!("Take order {order}"));
    assert_eq!(app(&ui).document().settings.order, order);
    assert_written(&ui, &format!("at N = {order}"));
}

#[test]
fn without_lights_of_ones_own_it_says_how_to_bring_them() {
    let ui = page_of(FieldChoice::Own);
    assert_written(&ui, "There are no lights of your own");
}
