//! A window under fingers: targets, a pinch and a drag in a plot, and what a first touch changes.

use crate::{
    driver::{Ui, click, words},
    narrow::{over, rest},
    sizes::walk,
};
use eframe::egui;
use egui::{Event, Pos2, Rect, Role, TouchDeviceId, TouchId, TouchPhase, Vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use spectral_explorer::{
    app::{pages::Page, workspace::Preferences},
    ui::{
        look_view::names as knobs,
        theme::{FINGER, NEAR_FINGER},
    },
};

/// A tablet, upright ones and phones aside.
const TABLET: [f32; 2] = [1024.0, 768.0];

fn on(page: Page, touch: Option<bool>) -> Ui {
    let preferences = Preferences {
        page,
        touch,
        greeted: true,
        ..Preferences::default()
    };
    over(preferences, TABLET)
}

/// A finger on the glass.
fn finger(ui: &mut Ui, id: u64, phase: TouchPhase, pos: Pos2) {
    ui.event(Event::Touch {
        device_id: TouchDeviceId(1),
        id: TouchId(id),
        phase,
        pos,
        force: None,
    });
}

fn touch_of(ui: &Ui) -> Option<bool> {
    ui.state().preferences.touch
}

#[test]
fn the_first_touch_makes_targets_large_unless_a_person_chose() {
    let at = Pos2::new(500.0, 300.0);
    let mut ui = on(Page::Spectrum, None);
    let before = ui.get_by_role_and_label(Role::Button, "Open").rect();
    assert!(before.height() < FINGER, "{before:?}");
    for phase in [TouchPhase::Start, TouchPhase::End] {
        finger(&mut ui, 1, phase, at);
    }
    rest(&mut ui);
    assert_eq!(touch_of(&ui), Some(true));
    let after = ui.get_by_role_and_label(Role::Button, "Open").rect();
    assert!(after.height() >= FINGER, "{after:?}");
    // Turned off by hand it stays off.
    click(&mut ui, "Help");
    click(&mut ui, "Targets for a pointer");
    assert_eq!(touch_of(&ui), Some(false));
    finger(&mut ui, 2, TouchPhase::Start, at);
    finger(&mut ui, 2, TouchPhase::End, at);
    rest(&mut ui);
    assert_eq!(touch_of(&ui), Some(false));
}

/// Controls in sight: their names and places.
fn targets(ui: &Ui) -> Vec<(Role, String, Rect)> {
    let screen = Rect::from_min_size(Pos2::ZERO, TABLET.into());
    let nodes = ui.root().children_recursive();
    let found = nodes.filter_map(|node| {
        let about = node.accesskit_node();
        let is_target = matches!(
            about.role(),
            Role::Button
                | Role::CheckBox
                | Role::ComboBox
                | Role::RadioButton
                | Role::Slider
                | Role::SpinButton
                | Role::Tab
                | Role::TextInput
        );
        let is_there = is_target && !about.is_disabled() && about.bounding_box().is_some();
        let rect = is_there.then(|| node.rect())?;
        let name = about.label().unwrap_or_default();
        (screen.contains_rect(rect)).then(|| (about.role(), name, rect))
    });
    found.collect()
}

#[test]
fn every_control_on_every_page_has_a_target_for_a_finger() {
    let mut wrong = Vec::new();
    for page in Page::all() {
        let ui = on(page, Some(true));
        let found = targets(&ui);
        assert!(found.len() > 10, "{}", page.title());
        for (role, name, rect) in found {
            let size = rect.size();
            // What is written small has a target around it.
            let target = size + Vec2::splat(2.0 * NEAR_FINGER);
            if target.min_elem() < FINGER {
                wrong.push(format!("{}: {role:?} {name:?} {size:?}", page.title()));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn rows_that_stand_on_one_another_are_as_high_as_a_finger() {
    let mut wrong = Vec::new();
    let mut seen = 0;
    for page in Page::all() {
        let found = targets(&on(page, Some(true)));
        let rows = || found.iter().filter(|(role, ..)| *role == Role::Button);
        for (_, name, row) in rows() {
            let is_below = |(_, _, other): &(Role, String, Rect)| {
                other.x_range() == row.x_range() && (other.top() - row.bottom()).abs() < 0.5
            };
            let stands = rows().any(is_below);
            seen += usize::from(stands);
            if stands && row.height() < FINGER - 0.01 {
                wrong.push(format!("{}: {name:?} {row:?}", page.title()));
            }
        }
    }
    assert!(seen > 5, "{seen}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_bar_that_is_always_there_has_buttons_as_large_as_a_finger() {
    let ui = on(Page::Spectrum, Some(true));
    for name in ["Open", "Save", "Help", "Present", "Surroundings"] {
        let size = ui.get_by_role_and_label(Role::Button, name).rect().size();
        assert!(size.min_elem() >= FINGER - 0.01, "{name}: {size:?}");
    }
}

#[test]
fn a_finger_beside_a_slider_moves_it_and_a_pointer_there_does_not() {
    for (touch, moves) in [(Some(true), true), (None, false)] {
        let mut ui = on(Page::Spectrum, touch);
        let slider = ui.get_by_role_and_label(Role::Slider, knobs::ORDER).rect();
        let before = ui.state().app.document().settings.order;
        let at = slider.left_top() + Vec2::new(2.0, -10.0);
        first_finger_of(&mut ui, touch.is_some(), TouchPhase::Start, at);
        first_finger_of(&mut ui, touch.is_some(), TouchPhase::End, at);
        rest(&mut ui);
        let after = ui.state().app.document().settings.order;
        assert_eq!(after != before, moves, "{touch:?}: {before} to {after}");
    }
}

#[test]
fn nothing_collides_or_is_cut_on_a_tablet() {
    let mut wrong = Vec::new();
    for page in Page::all() {
        let preferences = Preferences {
            page,
            touch: Some(true),
            greeted: true,
            ..Preferences::default()
        };
        walk(preferences, &[[1280.0, 800.0], [1000.0, 700.0]], &mut wrong);
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// First and last wavelength of the spectrum's plot.
fn seen(ui: &Ui) -> [f64; 2] {
    let transform = ui.state().look.spectrum.transform.expect("a plot");
    let bounds = transform.bounds();
    [bounds.min()[0], bounds.max()[0]]
}

/// A touch that also moves the pointer, as the system sends it for the first finger.
fn first_finger(ui: &mut Ui, phase: TouchPhase, pos: Pos2) {
    first_finger_of(ui, true, phase, pos);
}

/// The same, of a finger or of a mouse.
fn first_finger_of(ui: &mut Ui, is_finger: bool, phase: TouchPhase, pos: Pos2) {
    if is_finger {
        finger(ui, 1, phase, pos);
    }
    ui.event(Event::PointerMoved(pos));
    if matches!(phase, TouchPhase::Start | TouchPhase::End) {
        ui.event(Event::PointerButton {
            pos,
            button: egui::PointerButton::Primary,
            pressed: phase == TouchPhase::Start,
            modifiers: egui::Modifiers::NONE,
        });
    }
    if phase == TouchPhase::End {
        ui.event(Event::PointerGone);
    }
    ui.step();
}

#[test]
fn two_fingers_zoom_a_plot_and_one_moves_it() {
    let mut ui = on(Page::Spectrum, Some(true));
    let transform = ui.state().look.spectrum.transform.expect("a plot");
    let frame = *transform.frame();
    let middle = Pos2::new(
        transform.position_from_point_x(675.0),
        frame.top() + 0.4 * frame.height(),
    );
    let whole = seen(&ui);
    let apart = |by: f32| [middle - Vec2::new(by, 0.0), middle + Vec2::new(by, 0.0)];
    let [left, right] = apart(20.0);
    first_finger(&mut ui, TouchPhase::Start, left);
    finger(&mut ui, 2, TouchPhase::Start, right);
    ui.step();
    for by in [25.0, 30.0, 35.0, 40.0] {
        let [left, right] = apart(by);
        first_finger(&mut ui, TouchPhase::Move, left);
        finger(&mut ui, 2, TouchPhase::Move, right);
        ui.step();
    }
    finger(&mut ui, 2, TouchPhase::End, apart(40.0)[1]);
    first_finger(&mut ui, TouchPhase::End, apart(40.0)[0]);
    rest(&mut ui);
    let zoomed = seen(&ui);
    let share = (zoomed[1] - zoomed[0]) / (whole[1] - whole[0]);
    // Fingers that end twice as far apart show half as much; the first step of a pinch is not
    // counted, as nobody knows yet that it is one.
    assert!((0.4..0.7).contains(&share), "{share}: {whole:?} {zoomed:?}");

    first_finger(&mut ui, TouchPhase::Start, middle);
    for by in [10.0, 25.0, 40.0] {
        first_finger(&mut ui, TouchPhase::Move, middle + Vec2::new(by, 0.0));
    }
    first_finger(&mut ui, TouchPhase::End, middle + Vec2::new(40.0, 0.0));
    rest(&mut ui);
    let moved = seen(&ui);
    assert!(moved[0] < zoomed[0] - 1.0, "{zoomed:?} {moved:?}");
    let width = |[a, b]: [f64; 2]| b - a;
    assert!((width(moved) - width(zoomed)).abs() < 1e-6 * width(whole));
    assert_eq!(ui.state().app.undo_words(), None, "looking is no change");
}

#[test]
fn a_link_opens_page_and_light_and_one_that_is_wrong_says_so() {
    let mut ui = on(Page::Spectrum, None);
    ui.state_mut()
        .open_link("page=quality&light=FL11&page=nowhere");
    rest(&mut ui);
    assert_eq!(ui.state().preferences.page.word(), "quality");
    assert_eq!(ui.state().app.document().light.name(), "FL11");
    let said = words(&ui).join(" ");
    assert!(said.contains("found the page \"nowhere\""), "{said}");
    // On a page of a browser there is a link to copy.
    click(&mut ui, "Save");
    assert!(ui.query_by_label("Copy a link to this view").is_none());
    ui.key_press(egui::Key::Escape);
    rest(&mut ui);
    ui.state_mut().address = Some("https://example.org/".to_owned());
    rest(&mut ui);
    click(&mut ui, "Save");
    click(&mut ui, "Copy a link to this view");
    assert!(words(&ui).join(" ").contains("Copied: a link"));
}
