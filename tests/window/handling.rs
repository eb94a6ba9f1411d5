//! What hands do to plots, the rail, the library and files, and what comes of it.

use std::{
    path::{Path, PathBuf},
    sync::{Arc, Mutex},
};

use crate::driver::{
    Ui, app, assert_written, at_rest, click, is_written, no_files, wait_until, words,
};
use eframe::egui;
use egui::{Key, Modifiers, Pos2, Role, Shape, vec2};
use egui_kittest::kittest::Queryable as _;
use spectral_explorer::{
    app::{App, pages::Page, workspace::Preferences},
    color::{MissingCones, Srgb},
    ui::{Window, look_view::ADD_LINE},
};

fn fresh() -> Ui {
    at_rest(Window::new(
        App::new(),
        Preferences::default(),
        no_files(),
        None,
    ))
}

fn at(page: Page) -> Ui {
    let preferences = Preferences {
        page,
        ..Preferences::default()
    };
    let mut ui = at_rest(Window::new(App::new(), preferences, no_files(), None));
    for _ in 0..4 {
        ui.state_mut().studies.finish();
        ui.run();
    }
    ui
}

fn press(ui: &mut Ui, key: Key) {
    ui.key_press(key);
    ui.run();
}

/// First and last value of both axes of the spectrum's plot.
fn seen(ui: &Ui) -> [[f64; 2]; 2] {
    let transform = ui.state().look.spectrum.transform.expect("a plot");
    let (min, max) = (transform.bounds().min(), transform.bounds().max());
    [[min[0], max[0]], [min[1], max[1]]]
}

/// A place of the plot with no line near it.
fn empty_place(ui: &Ui) -> Pos2 {
    let transform = ui.state().look.spectrum.transform.expect("a plot");
    let frame = *transform.frame();
    Pos2::new(
        transform.position_from_point_x(675.0),
        frame.top() + 0.4 * frame.height(),
    )
}

fn wheel(ui: &mut Ui, at: Pos2, notches: f32) {
    ui.hover_at(at);
    ui.run();
    ui.event(egui::Event::MouseWheel {
        unit: egui::MouseWheelUnit::Point,
        delta: vec2(0.0, 60.0 * notches),
        phase: egui::TouchPhase::Move,
        source: egui::MouseWheelSource::Wheel,
        modifiers: Modifiers::NONE,
    });
    for _ in 0..20 {
        ui.step();
    }
}

fn double_click(ui: &mut Ui, at: Pos2, modifiers: Modifiers) {
    ui.hover_at(at);
    ui.run();
    for _ in 0..2 {
        for pressed in [true, false] {
            ui.event_modifiers(
                egui::Event::PointerButton {
                    pos: at,
                    button: egui::PointerButton::Primary,
                    pressed,
                    modifiers,
                },
                modifiers,
            );
        }
        ui.step();
    }
    ui.run();
}

#[test]
fn the_wheel_zooms_the_wavelengths_around_the_pointer_and_three_ways_lead_back() {
    let mut ui = fresh();
    let whole = seen(&ui);
    let lines = app(&ui).derived().model.lines().len();
    for back in ["fit", "double click", "Home"] {
        let place = empty_place(&ui);
        let fit = |ui: &Ui| {
            words(ui)
                .iter()
                .any(|word| word.starts_with("Fit the view"))
        };
        assert!(!fit(&ui), "{back}: all is in view");
        wheel(&mut ui, place, 2.0);
        let [[first, last], heights] = seen(&ui);
        assert!(
            first > whole[0][0] + 10.0 && last < whole[0][1] - 1.0,
            "{first} {last}"
        );
        assert_eq!(heights, whole[1], "the base line stays");
        // What was under the pointer still is.
        let transform = ui.state().look.spectrum.transform.expect("a plot");
        let now = transform.value_from_position(place).x;
        assert!((now - 675.0).abs() < 0.5, "{now}");
        assert!(fit(&ui));
        match back {
            "fit" => {
                let name = words(&ui)
                    .into_iter()
                    .find(|word| word.starts_with("Fit the view"))
                    .expect("a way back");
                click(&mut ui, &name);
            }
            "Home" => press(&mut ui, Key::Home),
            _ => double_click(&mut ui, place, Modifiers::NONE),
        }
        ui.remove_cursor();
        ui.run();
        assert_eq!(seen(&ui), whole, "{back}");
    }
    assert_eq!(app(&ui).derived().model.lines().len(), lines);
    assert!(app(&ui).undo_words().is_none(), "looking is no change");
}

#[test]
fn a_line_is_added_by_its_button_and_a_click_or_by_shift_and_a_double_click() {
    for by_button in [true, false] {
        let mut ui = fresh();
        let before = app(&ui).derived().model.lines().len();
        let place = empty_place(&ui);
        if by_button {
            ui.get_by_role_and_label(Role::Button, ADD_LINE).click();
            ui.run();
            ui.hover_at(place);
            ui.run();
            ui.drag_at(place);
            ui.drop_at(place);
            ui.run();
        } else {
            double_click(&mut ui, place, Modifiers::SHIFT);
        }
        assert_eq!(
            app(&ui).derived().model.lines().len(),
            before + 1,
            "{by_button}"
        );
        click(&mut ui, "Undo");
        assert!(app(&ui).undo_words().is_none());
    }
}

#[test]
fn heights_hold_still_while_a_line_is_dragged_and_for_a_moment_after() {
    let mut ui = fresh();
    let before = seen(&ui)[1];
    let model = &app(&ui).derived().model;
    let largest = model
        .lines()
        .iter()
        .max_by(|a, b| a.weight.total_cmp(&b.weight));
    let nm = largest.expect("a line").at_nm;
    let transform = ui.state().look.spectrum.transform.expect("a plot");
    // Its stem, below its head.
    let from = Pos2::new(
        transform.position_from_point_x(nm),
        transform.frame().bottom() - 0.4 * transform.frame().height(),
    );
    ui.hover_at(from);
    ui.run();
    ui.drag_at(from);
    ui.run();
    for step in 1..=4 {
        ui.hover_at(from - vec2(0.0, 8.0 * step as f32));
        ui.run();
        assert_eq!(seen(&ui)[1], before, "step {step}");
    }
    ui.drop_at(from - vec2(0.0, 32.0));
    ui.run();
    assert!(app(&ui).undo_words().is_some(), "the line was moved");
    assert_eq!(seen(&ui)[1], before);
}

#[test]
fn a_place_opens_with_the_page_that_was_seen_there_last() {
    let mut ui = at(Page::Rainbow);
    click(&mut ui, "Look");
    assert_eq!(ui.state().preferences.page, Page::Spectrum);
    click(&mut ui, "Picture");
    assert_eq!(ui.state().preferences.page, Page::Rainbow);
}

#[test]
fn the_library_takes_the_keyboard_however_it_is_opened() {
    for by_key in [false, true] {
        let mut ui = fresh();
        match by_key {
            true => ui.key_press_modifiers(Modifiers::COMMAND, Key::L),
            false => ui.get_by_label("Library: FL2").click(),
        }
        ui.run();
        ui.event(egui::Event::Text("sodium".to_owned()));
        ui.run();
        assert_written(&ui, "sodium");
        let order = app(&ui).document().settings.order;
        press(&mut ui, Key::Enter);
        let light = app(&ui).document().light.name().to_lowercase();
        assert_ne!(light, "fl2", "by key {by_key}");
        assert_eq!(app(&ui).document().settings.order, order);
    }
}

#[derive(Debug)]
struct FakeFile(PathBuf, Vec<u8>);

impl egui::DroppedFile for FakeFile {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        Ok(self.1.clone())
    }
}

#[test]
fn a_refusal_is_told_where_the_file_was_dropped() {
    let mut ui = fresh();
    let place = Pos2::new(640.0, 300.0);
    ui.hover_at(place);
    ui.run();
    let file = FakeFile("people.csv".into(), b"name,age\nAda,36\n".to_vec());
    ui.input_mut().dropped_files.push(Arc::new(file));
    ui.run();
    assert_written(&ui, "Not opened");
    let note = ui.get_by_label("Not opened").rect();
    assert!(note.center().distance(place) < 220.0, "{note:?}");
    click(&mut ui, "Close the note");
    assert!(!is_written(&ui, "Not opened"));
}

#[test]
fn a_right_click_on_the_plot_saves_copies_or_prints_it() {
    let mut ui = fresh();
    let printed: Arc<Mutex<Vec<String>>> = Arc::default();
    let keep = printed.clone();
    ui.state_mut().printer = Arc::new(move |path: &Path| {
        let page = std::fs::read_to_string(path).expect("a page");
        keep.lock().expect("no panic before").push(page);
        Ok(())
    });
    let place = empty_place(&ui);
    ui.hover_at(place);
    ui.run();
    for pressed in [true, false] {
        ui.event(egui::Event::PointerButton {
            pos: place,
            button: egui::PointerButton::Secondary,
            pressed,
            modifiers: Modifiers::NONE,
        });
        ui.step();
    }
    ui.run();
    for words in ["Copy as CSV", "Save PNG…", "Save SVG…"] {
        ui.get_by_label(words);
    }
    click(&mut ui, "Print…");
    wait_until(&mut ui, "the page", |_| {
        !printed.lock().expect("no panic before").is_empty()
    });
    let pages = printed.lock().expect("no panic before");
    assert!(pages[0].contains("<svg") && pages[0].contains("FL2"));
}

#[test]
fn every_page_is_presented_as_itself_and_left_to_itself() {
    for page in Page::all() {
        let mut ui = at(page);
        press(&mut ui, Key::F5);
        ui.state_mut().studies.finish();
        ui.run();
        let preferences = &ui.state().preferences;
        assert!(preferences.present, "{page:?}");
        assert_eq!(preferences.page, page, "presented");
        assert!(ui.query_by_label("Whole window").is_some(), "{page:?}");
        press(&mut ui, Key::Escape);
        let preferences = &ui.state().preferences;
        assert!(!preferences.present, "{page:?}");
        assert_eq!(preferences.page, page, "left");
    }
}

/// Fills of the rectangles that are painted and have a hue.
fn coloured_fills(ui: &Ui) -> Vec<[u8; 3]> {
    fn gather(shape: &Shape, found: &mut Vec<[u8; 3]>) {
        match shape {
            Shape::Vec(shapes) => shapes.iter().for_each(|shape| gather(shape, found)),
            Shape::Rect(rect) if rect.fill.is_opaque() => {
                let [r, g, b, _] = rect.fill.to_array();
                if r != g || g != b {
                    found.push([r, g, b]);
                }
            }
            _ => {}
        }
    }
    let mut found = Vec::new();
    for clipped in &ui.output().shapes {
        gather(&clipped.shape, &mut found);
    }
    found
}

#[test]
fn the_window_is_seen_by_colour_blind_eyes_and_by_others_again() {
    let mut ui = fresh();
    let before = coloured_fills(&ui);
    assert!(before.len() > 24, "{}", before.len());
    for eyes in [Some(MissingCones::Long), Some(MissingCones::Middle), None] {
        ui.key_press_modifiers(Modifiers::COMMAND | Modifiers::SHIFT, Key::D);
        ui.run();
        assert_eq!(ui.state().preferences.without_cones, eyes);
        let now = coloured_fills(&ui);
        for rgb in &before {
            let Srgb(seen) = eyes.map_or(Srgb(*rgb), |eyes| eyes.seen(Srgb(*rgb)));
            let is_grey = seen[0] == seen[1] && seen[1] == seen[2];
            assert!(is_grey || now.contains(&seen), "{eyes:?} {rgb:?} {seen:?}");
        }
    }
}
