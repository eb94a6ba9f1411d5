//! The page "Photograph" in the real window, driven without a display.

use std::{
    fs,
    path::{Path, PathBuf},
    sync::{Arc, Mutex},
    time::{Duration, Instant},
};

use eframe::egui;
use egui::{Key, Pos2, Role, vec2};
use egui_kittest::kittest::Queryable as _;
use spectral_explorer::{
    app::{pages::Page, workspace::Preferences},
    ui::{
        Window,
        files::{Ask, Picked, Picker},
        pages::photograph_view::names,
        theme::waker,
    },
};

use crate::driver::{Shown, Ui, app, assert_written, harness, is_written, no_files, settle, words};
use crate::plain::plain;
use crate::root::root;

fn golden(name: &str) -> PathBuf {
    root().join("tests/golden/photographs/pictures").join(name)
}

fn page(files: Picker) -> Ui {
    let mut window = Window::new(plain(), Preferences::default(), files, None);
    window.preferences.page = Page::Photograph;
    let mut ui = harness(Shown(window), [1280.0, 800.0], 0.02, 60);
    settle(&mut ui);
    ui
}

fn open(ui: &mut Ui, paths: &[PathBuf]) {
    let wake = waker(&ui.ctx);
    ui.state_mut().0.open_files(paths.to_vec(), wake);
    settle(ui);
}

fn click(ui: &mut Ui, name: &str) {
    let found = ui.query_all_by_label(name).next();
    let said = || format!("nothing is called {name:?}: {}", words(ui).join(" | "));
    found.unwrap_or_else(|| panic!("{}", said())).click();
    settle(ui);
    ui.remove_cursor();
    settle(ui);
}

fn drag(ui: &mut Ui, from: Pos2, to: Pos2) {
    ui.hover_at(from);
    ui.run();
    ui.drag_at(from);
    ui.run();
    ui.hover_at(to);
    ui.run();
    ui.drop_at(to);
    settle(ui);
    ui.remove_cursor();
    settle(ui);
}

/// Where a tick of this wavelength stands in the profile: under its name.
fn tick(ui: &Ui, nm: &str) -> Pos2 {
    let plot = profile(ui);
    let shapes = ui.output().shapes.iter();
    let name = shapes.filter_map(|shape| match &shape.shape {
        egui::Shape::Text(text) if text.galley.text() == nm => Some(text.visual_bounding_rect()),
        _ => None,
    });
    let mut names = name.filter(|rect| plot.contains(rect.center()));
    let name = names
        .next()
        .unwrap_or_else(|| panic!("no tick is called {nm}"));
    Pos2::new(name.center().x, plot.center().y)
}

fn profile(ui: &Ui) -> egui::Rect {
    let name = "Profile of the strip, red, green and blue";
    ui.get_by_label(name).rect()
}

#[test]
fn without_a_photograph_the_page_says_what_to_drop_and_shows_an_example() {
    let ui = page(no_files());
    for word in [
        "Drop the picture here",
        "An example",
        "Looks like a fluorescent lamp. Right?",
    ] {
        assert_written(&ui, word);
    }
    // The example's set-up is nobody's.
    assert!(!is_written(&ui, names::INSTRUMENT));
}

#[test]
fn the_button_opens_a_photograph_which_goes_into_the_library() {
    let path = golden("16.jpg");
    let picker = Arc::new(move |ask: &Ask| {
        assert_eq!(*ask, Ask::Open);
        Picked::Paths(vec![path.clone()])
    });
    let mut ui = page(picker);
    click(&mut ui, names::OPEN);
    settle(&mut ui);
    assert_written(&ui, "Looks like a fluorescent lamp");
    assert!(!is_written(&ui, "An example"));
    click(&mut ui, names::LIBRARY);
    let own = &app(&ui).document().own;
    assert_eq!(own.len(), 1);
    assert_eq!(own[0].spectrum.unit, "relative");
    assert_eq!(own[0].name(), "16");
}

#[test]
fn no_takes_the_axis_away_and_undo_brings_it_back() {
    let mut ui = page(no_files());
    open(&mut ui, &[golden("16.jpg")]);
    click(&mut ui, names::NO);
    assert_written(&ui, "Cannot be said");
    assert!(!is_written(&ui, names::LIBRARY));
    click(&mut ui, names::UNDO);
    assert_written(&ui, "Looks like a fluorescent lamp");
}

#[test]
fn a_tick_is_dragged_and_moved_by_arrow_keys() {
    let mut ui = page(no_files());
    let before = tick(&ui, "435.8");
    // A few points off its peak: it goes back onto the peak, as a pin of the named lamp.
    drag(&mut ui, before, before + vec2(8.0, 0.0));
    assert_written(&ui, names::UNDO);
    let after = tick(&ui, "435.8");
    assert!((after.x - before.x).abs() < 2.0, "{before:?}, {after:?}");
    click(&mut ui, names::UNDO);
    // An arrow moves it by .1 px, which is exactly where it stays.
    let at = tick(&ui, "435.8");
    drag(&mut ui, at, at);
    let table = |ui: &Ui| words(ui).join("|");
    let plain = table(&ui);
    ui.hover_at(at);
    ui.run();
    ui.drag_at(at);
    ui.drop_at(at);
    settle(&mut ui);
    for _ in 0..5 {
        ui.key_press(Key::ArrowRight);
        settle(&mut ui);
    }
    assert_ne!(table(&ui), plain, "the axis follows");
    assert_written(&ui, "Looks like a fluorescent lamp");
}

#[test]
fn a_click_on_a_peak_asks_for_its_wavelength() {
    let mut ui = page(no_files());
    open(&mut ui, &[golden("inst0_bulb.jpg")]);
    assert_written(&ui, "Cannot be said");
    let plot = profile(&ui);
    for (share, laser) in [(0.3, "450"), (0.7, "650")] {
        let at = Pos2::new(plot.left() + share * plot.width(), plot.center().y);
        ui.hover_at(at);
        ui.run();
        ui.drag_at(at);
        ui.drop_at(at);
        settle(&mut ui);
        assert_written(&ui, "Column");
        click(&mut ui, laser);
    }
    assert_written(&ui, "The axis goes through 2 pins");
    assert_written(&ui, "laser diodes are off by up to 10 nm");
}

#[test]
fn an_instrument_is_kept_saved_opened_and_reads_many_pictures() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("bench.json");
    let asked = Arc::new(Mutex::new(None));
    let (told, saved) = (asked.clone(), file.clone());
    let picker: Picker = Arc::new(move |ask: &Ask| {
        *told.lock().expect("one asks") = Some(ask.clone());
        Picked::Paths(vec![saved.clone()])
    });
    let mut ui = page(picker);
    open(&mut ui, &[golden("inst0_cfl.jpg")]);
    click(&mut ui, names::INSTRUMENT);
    assert_written(&ui, "Instrument: inst0_cfl.jpg");
    click(&mut ui, names::SAVE_INSTRUMENT);
    wait_for(&mut ui, &file);
    let ask = asked.lock().expect("one asks").clone();
    assert!(
        matches!(
            ask,
            Some(Ask::Save {
                extension: "json",
                ..
            })
        ),
        "{ask:?}"
    );
    // The next picture is read with it: this one has moved, and waits for a word.
    open(&mut ui, &[golden("inst0_sky.jpg")]);
    assert_written(&ui, "has moved by");
    assert!(!is_written(&ui, names::LIBRARY));
    click(&mut ui, names::YES);
    assert_written(&ui, "moved by");
    assert_written(&ui, names::LIBRARY);

    // Another day: the file alone, and three pictures at once.
    let mut ui = page(no_files());
    open(&mut ui, &[file]);
    assert_written(&ui, "Instrument: inst0_cfl.jpg");
    let pictures = ["inst0_led.jpg", "17.jpg", "inst0_bulb.jpg"].map(golden);
    open(&mut ui, &pictures);
    assert_written(&ui, "2 of 3 pictures fit the instrument.");
    // The one of another size says so.
    assert_written(&ui, "this instrument was made with");
    click(&mut ui, "All to the library");
    assert_eq!(app(&ui).document().own.len(), 2);
}

/// Lets frames pass until a file is there.
fn wait_for(ui: &mut Ui, path: &Path) {
    let until = Instant::now() + Duration::from_secs(60);
    while !fs::metadata(path).is_ok_and(|about| about.len() > 0) {
        assert!(Instant::now() < until, "no file");
        settle(ui);
    }
}

#[test]
fn the_band_is_drawn_and_its_edge_moved_by_hand() {
    let mut ui = page(no_files());
    open(&mut ui, &[golden("16.jpg")]);
    let picture = ui
        .get_by_role_and_label(Role::Image, "Picture 16.jpg")
        .rect();
    let at = |x: f32, y: f32| picture.lerp_inside(vec2(x, y));
    // Where nothing is, a band shows nothing, and says so in words.
    drag(&mut ui, at(0.1, 0.02), at(0.9, 0.12));
    assert!(!is_written(&ui, "Looks like"), "{:?}", words(&ui));
    click(&mut ui, names::UNDO);
    assert_written(&ui, "Looks like a fluorescent lamp");
}

#[test]
fn what_is_no_photograph_of_a_spectrum_is_refused_in_words_and_another_can_be_opened() {
    let folder = tempfile::tempdir().expect("a folder");
    let cut = folder.path().join("cut.jpg");
    let whole = fs::read(golden("16.jpg")).expect("a picture");
    fs::write(&cut, &whole[..whole.len() / 2]).expect("half a picture");
    let mut ui = page(no_files());
    open(&mut ui, &[cut]);
    assert_written(&ui, "cut off");
    assert_written(&ui, names::OPEN);
    open(&mut ui, &[golden("none00.jpg")]);
    assert_written(&ui, "Cannot be said");
    let damaged = folder.path().join("bench.json");
    fs::write(
        &damaged,
        r#"{"format":"spectral-explorer-instrument","version":7}"#,
    )
    .expect("a file");
    open(&mut ui, &[damaged]);
    assert_written(&ui, "version 7");
}
