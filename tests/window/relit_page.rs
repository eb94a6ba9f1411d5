//! The page "In few numbers, relit" in the real window, driven without a display.

use std::sync::{Arc, Mutex};

use crate::driver::{Ui, app, at_rest, words};
use egui_kittest::kittest::Queryable as _;
use spectral_explorer::{
    app::{App, pages::Look, pages::Page, workspace::Preferences},
    pictures::{LineChoice, ReferenceKind},
    ui::{
        Window,
        files::{Ask, Picked},
        pages::relit_view::names,
    },
};

/// The page on the wall of paints in few numbers, saving into `path`.
fn page(path: Option<std::path::PathBuf>) -> Ui {
    let preferences = Preferences {
        page: Page::Relit,
        greeted: true,
        ..Preferences::default()
    };
    let mut app = App::new();
    app.pages_follow(|pages| pages.relit.numbers = Some(8));
    let path = Mutex::new(path);
    let picker = Arc::new(move |_: &Ask| {
        let path = path.lock().expect("one dialog at a time").take();
        path.map_or(Picked::Cancelled, |path| Picked::Paths(vec![path]))
    });
    let mut ui = at_rest(Window::new(app, preferences, picker, None));
    settle(&mut ui);
    ui
}

fn settle(ui: &mut Ui) {
    for _ in 0..5 {
        ui.step();
        ui.state_mut().0.studies.finish();
    }
    ui.step();
}

fn click(ui: &mut Ui, name: &str) {
    ui.get_by_label(name).click();
    settle(ui);
}

#[test]
fn the_wall_is_relit_mapped_compared_and_saved() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("wall.cspx.png");
    let mut ui = page(Some(path.clone()));
    let told = |ui: &Ui, part: &str| {
        let all = words(ui).join("\n");
        assert!(all.contains(part), "{part}: {all}");
    };
    told(
        &ui,
        "A wall of paints in 8 numbers a pixel instead of 81. Under FL2",
    );
    told(&ui, " compact, ");
    click(&mut ui, "Bulb");
    assert_eq!(app(&ui).document().light.name(), "CIE A");
    told(&ui, "Under CIE A its colours are off by ΔE₀₀");
    click(&mut ui, "Difference");
    assert_eq!(
        ui.state().0.app.document().pages.relit.look,
        Look::Difference
    );
    told(&ui, "Pixels by their difference under CIE A");
    click(&mut ui, "Other ways");
    told(&ui, "components of the picture");
    click(&mut ui, names::SAVE);
    let form = "As .cspx.png";
    let button = words(&ui)
        .into_iter()
        .find(|words| words.starts_with(form))
        .expect("a way to save");
    click(&mut ui, &button);
    for _ in 0..100 {
        std::thread::sleep(std::time::Duration::from_millis(50));
        ui.step();
        if path.exists() {
            break;
        }
    }
    ui.state_mut().0.finish_writing();
    assert!(path.metadata().expect("saved").len() > 10_000);
}

#[test]
fn what_stands_for_every_pixel_can_be_chosen_by_hand() {
    let mut ui = page(None);
    let wish = |ui: &Ui| ui.state().0.app.document().pages.relit.wish.clone();
    click(&mut ui, names::KEPT);
    click(&mut ui, "Nothing");
    assert_eq!(wish(&ui).reference, Some(ReferenceKind::One));
    click(&mut ui, names::HAND);
    let LineChoice::At(before) = wish(&ui).lines else {
        panic!("a list of lines: {:?}", wish(&ui).lines);
    };
    assert!(!before.contains(&546.1));
    click(&mut ui, names::ADD_LINE);
    let LineChoice::At(after) = wish(&ui).lines else {
        panic!("a list of lines");
    };
    assert_eq!(after.len(), before.len() + 1);
    assert!(after.contains(&546.1), "{after:?}");
    click(&mut ui, "546.1 nm ×");
    assert_eq!(wish(&ui).lines, LineChoice::At(before));
    let was = ui.state().0.app.document().pages.relit.between_series;
    click(&mut ui, names::BETWEEN);
    assert_ne!(ui.state().0.app.document().pages.relit.between_series, was);
    let words = app(&ui).undo_words().expect("a step");
    assert!(words.ends_with("what stands between bands"), "{words}");
}
