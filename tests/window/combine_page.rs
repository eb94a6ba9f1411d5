//! The page Combine in the real window, driven without a display: four files of one lamp and a dark
//! frame, as they come from an instrument.

use std::{
    fs,
    path::{Path, PathBuf},
};

use eframe::egui;
use egui::Role;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use spectral_explorer::{
    app::{
        Command,
        combining::Verb,
        open::{Loaded, load_path},
        pages::Page,
        workspace::Preferences,
    },
    ui::{Window, pages::combine_view::names, theme::waker},
};

use crate::driver::{Shown, Ui, app, assert_written, harness, is_written, no_files, settle};
use crate::plain::plain;

/// A small noise, another one for each seed, the same each time: sums of sines without a common
/// period, from -1 to 1.
fn noise(seed: usize, nm: i32) -> f64 {
    let at = f64::from(nm) * (1.0 + 0.137 * seed as f64);
    ((at * 12.9898).sin() * 43758.5453).fract()
}

/// A lamp: a broad glow and two lines of 3 nm.
fn lamp(nm: i32) -> f64 {
    let bell = |at: f64, width: f64| (-((f64::from(nm) - at) / width).powi(2)).exp();
    bell(580.0, 90.0) + 1.5 * bell(435.8, 2.0) + 2.0 * bell(546.1, 2.0)
}

/// What the instrument reads without light.
fn dark(nm: i32) -> f64 {
    0.05 + 0.02 * (f64::from(nm) / 70.0).sin()
}

fn write(folder: &Path, name: &str, value: impl Fn(i32) -> f64) -> PathBuf {
    let path = folder.join(format!("{name}.csv"));
    let rows: String = (380..=780)
        .map(|nm| format!("{nm},{:.6}\n", value(nm)))
        .collect();
    fs::write(&path, format!("nm,W/nm\n{rows}")).expect("a file");
    path
}

/// Four scans of the lamp, each of its own level, and a dark frame.
fn files(folder: &Path) -> Vec<PathBuf> {
    let mut all: Vec<PathBuf> = (1..=4)
        .map(|n| {
            let level = [1.0, 1.008, 0.993, 1.004][n - 1];
            let value = |nm| level * lamp(nm) + dark(nm) + 0.004 * noise(n, nm);
            write(folder, &format!("lamp{n}"), value)
        })
        .collect();
    all.push(write(folder, "dark", |nm| dark(nm) + 0.004 * noise(9, nm)));
    all
}

fn page() -> Ui {
    let mut window = Window::new(plain(), Preferences::default(), no_files(), None);
    window.preferences.page = Page::Combine;
    let mut ui = harness(Shown(window), [1280.0, 800.0], 0.02, 60);
    settle(&mut ui);
    ui
}

fn open(ui: &mut Ui, paths: Vec<PathBuf>) {
    let wake = waker(&ui.ctx);
    ui.state_mut().0.open_files(paths, wake);
    settle(ui);
    ui.state_mut().0.preferences.page = Page::Combine;
    settle(ui);
}

fn press(ui: &mut Ui, role: Role, name: &str) {
    let found = ui.query_all_by_role_and_label(role, name).next();
    let found = found.unwrap_or_else(|| panic!("no {role:?} is called {name:?}"));
    found.scroll_to_me();
    settle(ui);
    let found = ui.query_all_by_role_and_label(role, name).next();
    found.expect("still there").click();
    settle(ui);
    ui.remove_cursor();
    settle(ui);
}

fn pick(ui: &mut Ui, list: &str, one: &str) {
    press(ui, Role::ComboBox, list);
    press(ui, Role::Button, one);
}

/// The number of the user's own spectra and the last one's value at a place.
fn last(ui: &Ui, nm: f64) -> (usize, f64) {
    let own = &app(ui).document().own;
    let of = &own.last().expect("one's own").spectrum;
    (own.len(), of.samples.at(nm, of.kind.outside()))
}

#[test]
fn four_files_and_a_dark_frame_become_a_light_with_its_doubt_that_follows_them() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut ui = page();
    open(&mut ui, files(folder.path()));
    assert_written(&ui, "This is an example");
    for n in 1..=4 {
        press(&mut ui, Role::CheckBox, &format!("lamp{n}"));
    }
    assert_written(&ui, "The mean of 4 scans");
    assert!(!is_written(&ui, "This is an example"));
    press(&mut ui, Role::Button, names::LIBRARY);
    let own = app(&ui).document().own.last().expect("made").clone();
    assert_eq!(own.name(), "lamp1, mean of 4");
    assert_eq!(own.measured.as_ref().and_then(|of| of.scans), Some(4));
    pick(&mut ui, names::VERB, Verb::Difference.title());
    pick(&mut ui, "Light A", "lamp1, mean of 4");
    assert_written(&ui, "Choose Dark B.");
    pick(&mut ui, "Dark B", "dark");
    assert_written(&ui, "A light: CCT");
    press(&mut ui, Role::Button, names::LIBRARY);
    let (count, before) = last(&ui, 600.0);
    assert_eq!(count, 7);
    // The lamp alone: four levels and four noises of .4 % in the mean, and that of the dark.
    assert!((before - lamp(600)).abs() < 0.012, "{before}");
    // The dark frame is read again, brighter by .01 everywhere: the light is darker by as much.
    let path = write(folder.path(), "dark", |nm| {
        0.01 + dark(nm) + 0.004 * noise(9, nm)
    });
    let Loaded::File(opened) = load_path(&path) else {
        panic!("a dark frame")
    };
    let own = app(&ui).document().own.iter();
    let key = own
        .clone()
        .find(|e| e.name() == "dark")
        .expect("it")
        .key
        .clone();
    let app = &mut ui.state_mut().0.app;
    app.apply(Command::Reread { key, opened });
    settle(&mut ui);
    let (_, after) = last(&ui, 600.0);
    // Files hold six decimals.
    assert!((before - after - 0.01).abs() < 2e-6, "{before}, {after}");
}

#[test]
fn a_scan_that_does_not_belong_is_left_out_with_why_and_one_click_keeps_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut all = files(folder.path());
    all.pop();
    let other = |nm: i32| 1.4 * lamp(nm + 3) + 0.004 * noise(7, nm);
    all.push(write(folder.path(), "other", other));
    let mut ui = page();
    open(&mut ui, all);
    press(&mut ui, Role::Button, "All");
    assert_written(&ui, "The mean of 4 of 5 scans");
    assert_written(&ui, "left out: ");
    press(&mut ui, Role::CheckBox, names::KEEP_ALL);
    assert_written(&ui, "The mean of 5 scans");
}

#[test]
fn every_verb_shows_an_example_with_its_result_before_anything_is_chosen() {
    let mut ui = page();
    for verb in Verb::ALL {
        ui.state_mut()
            .0
            .app
            .edit_pages(|pages| pages.combine.verb = verb);
        settle(&mut ui);
        assert_written(&ui, "This is an example");
        assert_written(&ui, verb.meaning());
        for refused in ["Choose", "Mark"] {
            assert!(!is_written(&ui, refused), "{refused} of {}", verb.title());
        }
        // An example is nobody's own.
        let library = ui.get_by_role_and_label(Role::Button, names::LIBRARY);
        assert!(library.accesskit_node().is_disabled(), "{}", verb.title());
    }
}
