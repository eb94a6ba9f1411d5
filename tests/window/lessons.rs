//! Lessons in the window: begun by a click, taken with the keyboard alone, left without a trace.

use eframe::egui::Key;
use egui_kittest::kittest::Queryable as _;
use spectral_explorer::{
    app::{App, lessons::shelf, pages::Page, workspace::Preferences},
    ui::Window,
};

use crate::driver::{Ui, app, assert_written, at_rest, click, no_files};

fn at(page: Page) -> Ui {
    let mut preferences = Preferences::default();
    preferences.pages.page = page;
    at_rest(Window::new(App::new(), preferences, no_files(), None))
}

fn press(ui: &mut Ui, key: Key) {
    ui.key_press(key);
    ui.run();
}

/// The program shows a task at a pace that one can follow.
fn watch(ui: &mut Ui) {
    for _ in 0..400 {
        ui.step();
    }
}

#[test]
fn a_lesson_is_taken_with_the_keyboard_alone_and_leaves_everything_as_it_was() {
    let mut ui = at(Page::Lessons);
    let before = app(&ui).document().clone();
    click(&mut ui, "Lesson: Draw a lamp with waves");
    assert_written(&ui, "Step 1 of 4");
    assert_eq!(app(&ui).document().light.name(), "CIE D65");
    press(&mut ui, Key::Space);
    watch(&mut ui);
    assert_eq!(app(&ui).document().settings.order, 12);
    press(&mut ui, Key::ArrowRight);
    assert_written(&ui, "Step 2 of 4");
    press(&mut ui, Key::Num1);
    press(&mut ui, Key::Space);
    watch(&mut ui);
    assert_written(&ui, "A sum that stops somewhere swings around it.");
    press(&mut ui, Key::PageUp);
    assert_written(&ui, "Step 1 of 4");
    assert_eq!(app(&ui).document().settings.order, 1);
    click(&mut ui, "Leave the lesson");
    assert!(app(&ui).document().is_same_as(&before));
    assert_eq!(ui.state().preferences.pages.page, Page::Lessons);
    press(&mut ui, Key::ArrowRight);
    assert_eq!(
        app(&ui).document().settings.order,
        before.settings.order + 1
    );
}

#[test]
fn a_lesson_that_was_finished_has_a_tick() {
    let mut ui = at(Page::Lessons);
    click(&mut ui, "Lesson: What is in this light?");
    for _ in 0..3 {
        press(&mut ui, Key::PageDown);
    }
    press(&mut ui, Key::Space);
    assert_written(&ui, &shelf::shipped()[0].remember);
    click(&mut ui, "Finish");
    assert_eq!(ui.state().preferences.pages.lessons_finished, ["light"]);
    assert_written(&ui, "1 of 12 lessons finished");
}

#[test]
fn a_file_of_a_lesson_joins_the_list_and_one_with_a_fault_says_where() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = shelf::text_of("samples").expect("shipped");
    let put = |name: &str, text: String| {
        let path = folder.path().join(name);
        std::fs::write(&path, text).expect("a file");
        path
    };
    let mine = put(
        "mine.json",
        text.replace("Where samples", "Mine: where samples"),
    );
    let wrong = put("wrong.json", text.replacen("\"say\"", "\"sya\"", 1));
    let mut ui = at(Page::Spectrum);
    let wake: spectral_explorer::ui::theme::Wake = std::sync::Arc::new(|| {});
    ui.state_mut().open_files(vec![wrong, mine], wake);
    ui.run();
    assert_eq!(ui.state().preferences.pages.page, Page::Lessons);
    let said: Vec<String> = app(&ui).messages().iter().map(|m| m.text.clone()).collect();
    assert!(
        said.iter()
            .any(|words| words.contains("step 1: found the field `sya`")),
        "{said:?}"
    );
    assert!(
        ui.query_by_label("Lesson: Mine: where samples go wrong")
            .is_some()
    );
}
