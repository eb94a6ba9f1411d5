//! A window with little room, as a large zoom on a small screen leaves it: nothing lies over
//! anything else, and everything can be reached.

use std::sync::Arc;

use crate::soft_renderer::SoftRenderer;
use eframe::egui;
use egui::{Rect, Role, pos2, vec2};
use egui_kittest::{Harness, kittest::Queryable as _};
use spectral_explorer::{
    app::{App, pages::Place, workspace::Preferences},
    ui::{Window, files::Picked, model_view::names, theme},
};

struct Shown(Window);

impl eframe::App for Shown {
    fn ui(&mut self, ui: &mut egui::Ui, _: &mut eframe::Frame) {
        self.0.show(ui);
    }
}

type Ui = Harness<'static, Shown>;

/// 1280 x 800 pixels at 250 %, in points.
const SMALL: [f32; 2] = [512.0, 320.0];

fn over(preferences: Preferences, size: [f32; 2]) -> Ui {
    let no_files = Arc::new(|_: &_| Picked::Cancelled);
    let mut window = Window::new(App::new(), preferences, no_files, None);
    window.quiet = true;
    let mut ui: Ui = Harness::builder()
        .with_size(size)
        .with_step_dt(0.02)
        .with_max_steps(40)
        .with_context_setup(theme::install_fonts)
        .renderer(SoftRenderer::default())
        .build_eframe(|_| Shown(window));
    rest(&mut ui);
    // The zoom has changed the size in points meanwhile.
    ui.set_size(size.into());
    rest(&mut ui);
    ui
}

fn zoomed() -> Preferences {
    Preferences {
        zoom: 2.5,
        ..Preferences::default()
    }
}

/// Lets a few frames pass; computations on other threads are not waited for.
fn rest(ui: &mut Ui) {
    for _ in 0..8 {
        ui.step();
    }
}

fn click(ui: &mut Ui, name: &str) {
    ui.get_by_role_and_label(Role::Button, name).click();
    rest(ui);
    ui.remove_cursor();
    rest(ui);
}

fn rect(ui: &Ui, role: Role, name: &str) -> Option<Rect> {
    ui.query_by_role_and_label(role, name)
        .map(|node| node.rect())
}

/// The top bar's controls; "Model" is there only where it has no room beside the page.
const BAR: [(Role, &str); 13] = [
    (Role::Button, "Library"),
    (Role::Button, "Model"),
    (Role::Button, "Open"),
    (Role::Button, "Save"),
    (Role::Button, "Undo"),
    (Role::Button, "Redo"),
    (Role::ComboBox, "Scale"),
    (Role::Button, "Help"),
    (Role::Button, "Light"),
    (Role::Button, "Projector"),
    (Role::Button, "Larger"),
    (Role::Button, "Zoom 100 %"),
    (Role::Button, "Smaller"),
];

/// Controls of the model's panel.
const MODEL: [(Role, &str); 12] = [
    (Role::Button, "Fourier"),
    (Role::CheckBox, names::COLOUR_EXACT),
    (Role::Slider, names::ORDER),
    (Role::SpinButton, names::ORDER),
    (Role::ComboBox, "Spike detector"),
    (Role::SpinButton, names::THRESHOLD),
    (Role::SpinButton, names::WIDTH),
    (Role::SpinButton, "Range from"),
    (Role::SpinButton, "Range to"),
    (Role::ComboBox, "Observer"),
    (Role::ComboBox, "Products by"),
    (Role::ComboBox, "What the curve shows"),
];

/// The tabs of the pages.
fn tabs() -> [(Role, &'static str); 5] {
    Place::ALL.map(|place| (Role::Button, place.title()))
}

fn rects(ui: &Ui, controls: &[(Role, &'static str)]) -> Vec<(&'static str, Rect)> {
    let found = controls.iter().copied();
    found
        .filter_map(|(role, name)| Some((name, rect(ui, role, name)?)))
        .collect()
}

#[track_caller]
fn assert_apart(controls: &[(&str, Rect)], screen: Rect, case: &str) {
    for (i, (name, rect)) in controls.iter().enumerate() {
        assert!(
            rect.left() >= screen.left() && rect.right() <= screen.right(),
            "{case}: {name} at {rect:?} is not within {screen:?}"
        );
        for (other, taken) in &controls[..i] {
            // Neighbours may touch.
            assert!(
                !rect.shrink(0.5).intersects(taken.shrink(0.5)),
                "{case}: {name} at {rect:?} lies over {other} at {taken:?}"
            );
        }
    }
}

#[test]
fn the_top_bars_controls_never_lie_over_one_another() {
    for present in [false, true] {
        let preferences = Preferences {
            present,
            ..zoomed()
        };
        let mut ui = over(preferences, SMALL);
        for width in (400..=1400).step_by(50).chain([512, 640, 853, 1100, 1280]) {
            let size = vec2(width as f32, 800.0);
            ui.set_size(size);
            rest(&mut ui);
            let bar = rects(&ui, &BAR);
            assert!(bar.len() >= BAR.len() - 1, "{width}: {bar:?}");
            let screen = Rect::from_min_size(pos2(0.0, 0.0), size);
            assert_apart(&bar, screen, &format!("{width} points, present {present}"));
        }
    }
}

#[test]
fn no_part_of_the_window_covers_another_at_any_width() {
    let mut ui = over(zoomed(), SMALL);
    for width in (400..=1400).step_by(50).chain([512, 640, 853, 1100, 1280]) {
        let size = vec2(width as f32, 800.0);
        ui.set_size(size);
        rest(&mut ui);
        let screen = Rect::from_min_size(pos2(0.0, 0.0), size);
        let (tabs, model) = (rects(&ui, &tabs()), rects(&ui, &MODEL));
        assert_eq!(tabs.len(), 8, "{width}: the page is there at first");
        let all: Vec<_> = tabs.into_iter().chain(model).collect();
        assert_apart(&all, screen, &format!("{width} points"));
        if let Some(search) = rect(&ui, Role::TextInput, "Library") {
            let left = all.iter().map(|(_, rect)| rect.left());
            let left = left.fold(f32::INFINITY, f32::min);
            assert!(
                search.right() <= left,
                "{width}: the library reaches to {search:?}"
            );
        }
    }
}

#[test]
fn at_250_percent_library_page_and_model_each_have_the_window_in_turn() {
    let mut ui = over(zoomed(), SMALL);
    let screen = Rect::from_min_size(pos2(0.0, 0.0), SMALL.into());
    let shown = |ui: &Ui| {
        [
            rect(ui, Role::TextInput, "Library").is_some(),
            rect(ui, Role::Button, "Coefficients").is_some(),
            rect(ui, Role::Slider, names::ORDER).is_some(),
        ]
    };
    assert_eq!(shown(&ui), [false, true, false]);
    click(&mut ui, "Model");
    assert_eq!(shown(&ui), [false, false, true]);
    let model = rects(&ui, &MODEL);
    assert_eq!(model.len(), MODEL.len(), "{model:?}");
    assert_apart(&model, screen, "model");
    let bar = rects(&ui, &BAR);
    let bottom = bar.iter().map(|(_, r)| r.bottom()).fold(0.0, f32::max);
    // The knobs stand in the window without scrolling; the curve and the numbers are below.
    for (name, rect) in &model[..MODEL.len() - 1] {
        assert!(
            rect.top() > bottom && rect.bottom() < screen.bottom(),
            "{name} at {rect:?} is not to be seen below {bottom}"
        );
    }
    click(&mut ui, "Library");
    assert_eq!(shown(&ui), [true, false, false]);
    click(&mut ui, "Library");
    assert_eq!(shown(&ui), [false, true, false]);
    assert!(
        !ui.state().0.drawer.open,
        "a larger window has its library still"
    );
    ui.set_size(vec2(1280.0, 800.0));
    rest(&mut ui);
    assert_eq!(shown(&ui), [true, true, true]);
}

#[test]
fn a_low_window_scrolls_its_page_instead_of_covering_the_plot() {
    for (size, scale) in [(SMALL, false), ([640.0, 400.0], false), (SMALL, true)] {
        let preferences = Preferences {
            present: scale,
            ..zoomed()
        };
        let ui = over(preferences, size);
        let below = rect(&ui, Role::Button, "Through reflectances").expect("the patches");
        let images = ui.query_all_by_role(Role::Image);
        let lowest = images.map(|node| node.rect().bottom()).fold(0.0, f32::max);
        let frame = ui
            .state()
            .0
            .look
            .spectrum
            .transform
            .expect("a plot")
            .frame()
            .height();
        assert!(
            lowest <= below.top(),
            "{size:?}: the plots reach to {lowest}, the patches begin at {below:?}"
        );
        assert!(frame >= 70.0, "{size:?}: the plot is {frame} points high");
    }
}

#[test]
fn small_windows_over_the_window_keep_their_buttons_within_it() {
    let screen = Rect::from_min_size(pos2(0.0, 0.0), SMALL.into());
    let mut ui = over(zoomed(), SMALL);
    ui.key_press(egui::Key::F1);
    rest(&mut ui);
    let close = rect(&ui, Role::Button, "Close").expect("a way out");
    assert!(screen.contains_rect(close), "shortcuts: {close:?}");
    ui.key_press(egui::Key::Escape);
    rest(&mut ui);
    click(&mut ui, "Help");
    click(&mut ui, "About and licences");
    let close = rect(&ui, Role::Button, "Close").expect("a way out");
    assert!(screen.contains_rect(close), "about: {close:?}");
}

#[test]
fn the_page_looks_as_it_did_at_250_percent() {
    over(zoomed(), SMALL).snapshot("zoomed");
}

#[test]
fn the_model_looks_as_it_did_at_250_percent() {
    let mut ui = over(zoomed(), SMALL);
    click(&mut ui, "Model");
    ui.snapshot("zoomed-model");
}
