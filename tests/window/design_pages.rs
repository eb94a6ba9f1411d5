//! The place Design in the window: colours taken from swatches and pictures, two lights, groups and
//! gels, each worked by hand.

use std::sync::Arc;

use crate::driver::{Ui, app, assert_written, at_rest, click, no_files, wait_until, words};
use eframe::egui;
use egui::Role;
use egui_kittest::kittest::Queryable as _;
use spectral_explorer::{
    app::{
        App, Given,
        design::{Desk, Telling},
        pages::{Page, PageStates},
        workspace::Preferences,
    },
    ui::Window,
};

fn on(page: Page) -> Ui {
    let preferences = Preferences {
        page,
        ..Preferences::default()
    };
    let mut window = Window::new(App::new(), preferences, no_files(), None);
    window.quiet = true;
    at_rest(window)
}

fn memory(ui: &Ui) -> &PageStates {
    &app(ui).document().pages
}

fn set(ui: &mut Ui, role: Role, name: &str, value: f64) {
    ui.get_by_role_and_label(role, name)
        .set_value_accesskit(value);
    ui.run();
}

#[test]
fn a_swatch_of_another_page_leads_to_the_spectra_of_its_colour() {
    let mut ui = on(Page::Spectrum);
    let name = words(&ui)
        .into_iter()
        .find(|name| name.starts_with("blue: "))
        .expect("a patch");
    ui.get_by_role_and_label(Role::Button, &name)
        .click_secondary();
    ui.run();
    // One button where both halves have one colour, else the left half's first.
    let offered = words(&ui).into_iter().find(|word| {
        let colour = word.strip_prefix("left: ").unwrap_or(word);
        colour.starts_with('#') && colour.len() == 7
    });
    let offered = offered.expect("the menu");
    click(&mut ui, &offered);
    assert_eq!(ui.state().preferences.page, Page::FromColour);
    let Given::Srgb([r, g, b]) = memory(&ui).from_colour.given else {
        panic!("a screen's colour");
    };
    assert!(
        offered.ends_with(&format!("#{r:02x}{g:02x}{b:02x}")),
        "{offered}"
    );
    assert!(b > r && b > g, "it is blue");
    let words = app(&ui).undo_words();
    assert_eq!(words.as_deref(), Some("From a colour: the colour"));
}

#[test]
fn a_colour_is_told_in_four_ways_and_under_two_lights() {
    let mut ui = on(Page::FromColour);
    assert_written(&ui, "#c08040");
    ui.get_by_role_and_label(Role::ComboBox, "How a colour is told")
        .click();
    ui.run();
    click(&mut ui, "xyY");
    assert_eq!(memory(&ui).from_colour.telling, Telling::Xyy);
    set(&mut ui, Role::SpinButton, "Y", 40.0);
    let Given::Xyy([x, _, whole]) = memory(&ui).from_colour.given else {
        panic!("x, y and Y: {:?}", memory(&ui).from_colour.given);
    };
    assert!(whole == 40.0 && x > 0.33, "{x} {whole}");
    assert_written(&ui, "Three coefficients");
    ui.get_by_role_and_label(Role::CheckBox, "and under a second light")
        .click();
    ui.run();
    assert_written(&ui, "Six coefficients");
    assert_written(&ui, "CIE D65 and CIE A");
    set(&mut ui, Role::SpinButton, "Y under the second light", 45.0);
    let second = memory(&ui).from_colour.second.clone().expect("two colours");
    assert!(matches!(second.0, Given::Xyy([_, _, 45.0])), "{second:?}");
    click(&mut ui, "Into the chain");
    let chain = &app(&ui).document().products.chain;
    assert_eq!(
        chain.last().map(|link| link.entry.key.as_str()),
        Some("own/1")
    );
    click(&mut ui, "Onto the patches");
    assert_eq!(app(&ui).document().own_patches, ["own/2"]);
}

#[test]
fn a_pixel_of_a_picture_is_a_colour() {
    let mut ui = on(Page::FromColour);
    let path = crate::root::root().join("tests/pictures/readme.png");
    ui.state_mut().open_files(vec![path], Arc::new(|| {}));
    wait_until(&mut ui, "the picture", |ui| {
        ui.query_by_role_and_label(Role::Image, "Picture readme.png")
            .is_some()
    });
    ui.get_by_role_and_label(Role::Image, "Picture readme.png")
        .click();
    ui.run();
    let Given::Srgb([r, g, b]) = memory(&ui).from_colour.given else {
        panic!("a screen's colour");
    };
    assert_ne!([r, g, b], [0xc0, 0x80, 0x40]);
    assert_written(&ui, &format!("#{r:02x}{g:02x}{b:02x}"));
    // Elsewhere a picture of colours is no spectrum.
    click(&mut ui, "Close the picture");
    assert!(
        ui.query_by_role_and_label(Role::Image, "Picture readme.png")
            .is_none()
    );
}

#[test]
fn a_group_has_a_fader_and_its_move_is_one_step_of_undo() {
    let mut ui = on(Page::Mix);
    assert!(
        ui.query_by_role_and_label(Role::Slider, "Fader of group 1")
            .is_none()
    );
    click(&mut ui, "Group of channel 1");
    click(&mut ui, "Channel 2: LED 530 nm");
    click(&mut ui, "Group of channel 2");
    let levels = |ui: &Ui| -> Vec<f64> {
        let mix = &app(ui).document().pages.mix.desk;
        mix.channels.iter().map(|channel| channel.level).collect()
    };
    let before = levels(&ui);
    set(&mut ui, Role::Slider, "Fader of group 1", 50.0);
    let after = levels(&ui);
    assert_eq!(after[1], 50.0);
    assert!((after[0] / before[0] - 50.0 / before[1]).abs() < 1e-9);
    assert_eq!(after[2..], before[2..]);
    click(&mut ui, "Undo");
    assert_eq!(levels(&ui), before);
}

#[test]
fn a_chromaticity_can_be_typed_and_the_faders_make_it() {
    let mut ui = on(Page::Solve);
    click(&mut ui, "x, y");
    set(&mut ui, Role::SpinButton, "x", 0.4);
    let [x, y] = memory(&ui).solve.xy.expect("a chromaticity");
    assert_eq!(x, 0.4);
    let figures = Desk::of(app(&ui).document()).figures.expect("it shines");
    let [a, b] = figures.xy.expect("a colour");
    assert!((a - x).hypot(b - y) < 1e-6, "{a} {b}");
    click(&mut ui, "a temperature");
    assert_eq!(memory(&ui).solve.xy, None);
}
