//! A window with little room, as a large zoom on a small screen leaves it: nothing lies over
//! anything else, and everything can be reached.

use crate::{
    driver::{Shown, Ui, display, no_files},
    soft_renderer::SoftRenderer,
};
use eframe::egui;
use egui::{Rect, Role, Vec2, pos2, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use spectral_explorer::{
    app::{App, pages::Place, workspace::Preferences},
    ui::{Window, look_view::names as knobs, model_view::names, verdict_view::Side},
};

/// 1280 x 800 pixels at 250 %, in points.
const SMALL: [f32; 2] = [512.0, 320.0];

/// The window over preferences, at rest, its computations still going on.
pub(crate) fn over(preferences: Preferences, size: [f32; 2]) -> Ui {
    let pixels = Vec2::from(size) * preferences.zoom;
    let mut window = Window::new(App::new(), preferences, no_files(), None);
    window.quiet = true;
    let mut ui: Ui = display(size, 0.02, 40)
        .renderer(SoftRenderer::default())
        .build_eframe(|_| Shown(window));
    give(&mut ui, pixels);
    rest(&mut ui);
    ui
}

/// Gives the window pixels, as a system does: they are points of the zoom that is seen.
pub(crate) fn give(ui: &mut Ui, pixels: Vec2) {
    for _ in 0..4 {
        ui.set_size(pixels / ui.ctx.zoom_factor());
        ui.step();
    }
}

fn zoomed() -> Preferences {
    Preferences {
        zoom: 2.5,
        ..Preferences::default()
    }
}

/// Lets a few frames pass; computations on other threads are not waited for.
pub(crate) fn rest(ui: &mut Ui) {
    for _ in 0..6 {
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
    ui.query_all_by_role_and_label(role, name)
        .next()
        .map(|node| node.rect())
}

/// The top bar's controls.
const BAR: [(Role, &str); 9] = [
    (Role::Button, "Library: FL2"),
    (Role::Button, "+ Compare"),
    (Role::Button, "Undo"),
    (Role::Button, "Redo"),
    (Role::Button, "Open"),
    (Role::Button, "Save"),
    (Role::Button, "Surroundings"),
    (Role::Button, "Present"),
    (Role::Button, "Help"),
];

/// The two knobs.
const KNOBS: [(Role, &str); 4] = [
    (Role::Slider, knobs::ORDER),
    (Role::SpinButton, knobs::ORDER_TYPED),
    (Role::Slider, knobs::LINES),
    (Role::SpinButton, knobs::LINES_TYPED),
];

/// The rest of the first screen that is there at every width.
const LOOK: [(Role, &str); 10] = [
    (Role::Button, "Spectrum"),
    (Role::Button, "Dark lines"),
    (Role::CheckBox, "Show measured"),
    (Role::CheckBox, "Show model"),
    (Role::Button, "Layers"),
    (Role::Button, knobs::AUTOMATIC),
    (Role::SpinButton, knobs::BUDGET),
    (Role::Button, knobs::MORE),
    (Role::Button, knobs::RESET),
    (Role::ComboBox, "How surfaces are seen"),
];

/// Every knob, in the column.
const SETTINGS: [(Role, &str); 12] = [
    (Role::Button, "Fourier"),
    (Role::CheckBox, names::COLOUR_EXACT),
    (Role::Slider, names::ORDER),
    (Role::ComboBox, "How lines are found"),
    (Role::Slider, names::THRESHOLD),
    (Role::SpinButton, names::THRESHOLD),
    (Role::SpinButton, names::WIDTH),
    (Role::SpinButton, "Range from"),
    (Role::SpinButton, "Range to"),
    (Role::ComboBox, "Observer"),
    (Role::ComboBox, "Products by"),
    (Role::ComboBox, "Scale"),
];

/// What the column folds to.
const EDGE: &str = "Verdict, figures, settings";
/// The library's field.
const SEARCH: &str = "Search the library";

/// The entries of the rail.
fn places() -> [(Role, &'static str); 7] {
    Place::ALL.map(|place| (Role::Button, place.title()))
}

/// Widths of the window, points: 1000 pixels at 250 %, 1280 at 150 %, both sides of where the column
/// opens, and 2560 at 80 %.
const WIDTHS: [f32; 5] = [400.0, 853.0, 1149.0, 1151.0, 3200.0];

fn rects(ui: &Ui, controls: &[(Role, &'static str)]) -> Vec<(&'static str, Rect)> {
    let found = controls.iter().copied();
    found
        .filter_map(|(role, name)| Some((name, rect(ui, role, name)?)))
        .collect()
}

/// Whatever can be worked or looked at, and every word.
pub(crate) fn everything(ui: &Ui) -> Vec<(String, Rect)> {
    let nodes = ui.root().children_recursive();
    nodes
        .filter(|node| {
            matches!(
                node.accesskit_node().role(),
                Role::Button
                    | Role::Slider
                    | Role::SpinButton
                    | Role::TextInput
                    | Role::ComboBox
                    | Role::CheckBox
                    | Role::RadioButton
                    | Role::Image
                    | Role::Label
            )
        })
        .map(|node| {
            let shown = node.accesskit_node();
            let name = shown.label().or(shown.value()).unwrap_or_default();
            (format!("{:?} {name}", shown.role()), node.rect())
        })
        // A row of words without a word.
        .filter(|(name, _)| !name.ends_with(' '))
        .collect()
}

#[track_caller]
fn assert_apart<N: AsRef<str>>(controls: &[(N, Rect)], screen: Rect, case: &str) {
    for (i, (name, rect)) in controls.iter().enumerate() {
        let name = name.as_ref();
        assert!(
            rect.left() >= screen.left() - 0.5 && rect.right() <= screen.right() + 0.5,
            "{case}: {name} at {rect:?} is not within {screen:?}"
        );
        for (other, taken) in &controls[..i] {
            let other = other.as_ref();
            // Neighbours may touch.
            assert!(
                !rect.shrink(0.5).intersects(taken.shrink(0.5)),
                "{case}: {name} at {rect:?} lies over {other} at {taken:?}"
            );
        }
    }
}

#[track_caller]
fn assert_all(ui: &Ui, controls: &[(Role, &'static str)], case: &str) {
    for (role, name) in controls {
        assert!(rect(ui, *role, name).is_some(), "{case}: no {name}");
    }
}

/// Height of the plot.
fn plot(ui: &Ui) -> f32 {
    let transform = ui.state().0.look.spectrum.transform.expect("a plot");
    transform.frame().height()
}

#[test]
fn nothing_in_the_window_covers_anything_else_at_any_width() {
    let mut ui = over(zoomed(), SMALL);
    for width in WIDTHS {
        let size = vec2(width, 860.0);
        ui.set_size(size);
        rest(&mut ui);
        let case = format!("{width} points");
        for all in [&BAR[..], &places(), &KNOBS, &LOOK] {
            assert_all(&ui, all, &case);
        }
        let screen = Rect::from_min_size(pos2(0.0, 0.0), size);
        assert_apart(&everything(&ui), screen, &case);
        assert!(plot(&ui) >= 70.0, "{case}: the plot is {} high", plot(&ui));
        let column = rect(&ui, Role::Button, "All figures").is_some();
        assert_eq!(column, width >= 1150.0, "{case}: the column");
    }
}

#[test]
fn nothing_covers_anything_while_presenting() {
    let preferences = Preferences {
        present: true,
        ..zoomed()
    };
    let mut ui = over(preferences, SMALL);
    for width in WIDTHS {
        let size = vec2(width, 860.0);
        ui.set_size(size);
        rest(&mut ui);
        let case = format!("{width} points");
        assert_all(&ui, &KNOBS, &case);
        assert_all(&ui, &[(Role::Button, "Whole window")], &case);
        let screen = Rect::from_min_size(pos2(0.0, 0.0), size);
        assert_apart(&everything(&ui), screen, &case);
        assert!(plot(&ui) >= 70.0, "{case}: the plot is {} high", plot(&ui));
    }
}

#[test]
fn the_column_and_the_library_cover_nothing_at_any_width() {
    for side in [Side::Verdict, Side::Figures, Side::Settings] {
        let mut ui = over(zoomed(), SMALL);
        ui.state_mut().0.side = side;
        click(&mut ui, EDGE);
        for width in WIDTHS {
            let size = vec2(width, 860.0);
            ui.set_size(size);
            rest(&mut ui);
            let case = format!("{width} points, {side:?}");
            let inside = match side {
                Side::Verdict => &[(Role::Button, "All figures"), (Role::Button, "Settings")][..],
                Side::Figures => &[(Role::Button, "◀ Verdict")],
                Side::Settings => &SETTINGS,
            };
            assert_all(&ui, inside, &case);
            let mut controls = rects(&ui, inside);
            // The column has the window, or the page beside it is whole.
            if rect(&ui, Role::Button, knobs::AUTOMATIC).is_some() {
                for all in [&KNOBS[..], &LOOK] {
                    assert_all(&ui, all, &case);
                    // The order can be typed in both.
                    let once = all
                        .iter()
                        .filter(|c| side != Side::Settings || c.1 != "Waves (order N)");
                    controls.extend(rects(&ui, &once.copied().collect::<Vec<_>>()));
                }
            }
            for all in [&BAR[..], &places()] {
                assert_all(&ui, all, &case);
                controls.extend(rects(&ui, all));
            }
            let screen = Rect::from_min_size(pos2(0.0, 0.0), size);
            assert_apart(&controls, screen, &case);
        }
    }
    let mut ui = over(zoomed(), SMALL);
    ui.state_mut().0.drawer.open = true;
    for width in WIDTHS {
        let size = vec2(width, 860.0);
        ui.set_size(size);
        rest(&mut ui);
        let screen = Rect::from_min_size(pos2(0.0, 0.0), size);
        let library = [(Role::TextInput, SEARCH), (Role::Button, "Pin")];
        assert_all(&ui, &library, &format!("{width} points"));
        let mut controls = rects(&ui, &library);
        controls.extend(rects(&ui, &BAR));
        controls.extend(rects(&ui, &places()));
        // Beside the page it covers none of it; over it, it is on top.
        if width >= 1150.0 {
            controls.extend(rects(&ui, &KNOBS));
            controls.extend(rects(&ui, &LOOK));
        }
        assert_apart(&controls, screen, &format!("{width} points, library"));
    }
}

#[test]
fn at_250_percent_library_page_and_column_each_have_the_window_in_turn() {
    let mut ui = over(zoomed(), SMALL);
    let screen = Rect::from_min_size(pos2(0.0, 0.0), SMALL.into());
    let shown = |ui: &Ui| {
        [
            rect(ui, Role::TextInput, SEARCH).is_some(),
            rect(ui, Role::Slider, knobs::ORDER).is_some(),
            rect(ui, Role::Button, "All figures").is_some(),
        ]
    };
    assert_eq!(shown(&ui), [false, true, false]);
    click(&mut ui, EDGE);
    assert_eq!(shown(&ui), [false, false, true]);
    click(&mut ui, "Settings");
    assert_all(&ui, &SETTINGS, "the column");
    let settings = rects(&ui, &SETTINGS);
    assert_apart(&settings, screen, "the column");
    let bar = rects(&ui, &BAR);
    let bottom = bar.iter().map(|(_, r)| r.bottom()).fold(0.0, f32::max);
    // The first knobs stand in the window without scrolling.
    for (name, rect) in &settings[..5] {
        assert!(
            rect.top() > bottom && rect.bottom() < screen.bottom(),
            "{name} at {rect:?} is not to be seen below {bottom}"
        );
    }
    click(&mut ui, EDGE);
    assert_eq!(shown(&ui), [false, true, false]);
    // Over the page, until a light was chosen.
    click(&mut ui, "Library: FL2");
    assert_eq!(shown(&ui), [true, true, false]);
    let field = rect(&ui, Role::TextInput, SEARCH).expect("there");
    assert!(screen.contains_rect(field), "{field:?}");
    click(&mut ui, "CIE A");
    assert_eq!(shown(&ui), [false, true, false]);
    ui.set_size(vec2(1280.0, 800.0));
    rest(&mut ui);
    assert_eq!(shown(&ui), [false, true, true]);
}

#[test]
fn a_low_window_scrolls_its_page_instead_of_covering_the_plot() {
    for (size, present) in [
        (SMALL, false),
        ([640.0, 400.0], false),
        ([400.0, 280.0], false),
        ([1280.0, 400.0], false),
        (SMALL, true),
    ] {
        let preferences = Preferences {
            present,
            ..zoomed()
        };
        let ui = over(preferences, size);
        let below = rect(&ui, Role::Slider, knobs::ORDER).expect("the knobs");
        let images = ui.query_all_by_role(Role::Image);
        let lowest = images
            .map(|node| node.rect())
            .filter(|r| r.right() < size[0] - 320.0);
        let lowest = lowest.map(|rect| rect.bottom()).fold(0.0, f32::max);
        let frame = plot(&ui);
        assert!(
            lowest <= below.top(),
            "{size:?}: the plots reach to {lowest}, the knobs begin at {below:?}"
        );
        assert!(frame >= 70.0, "{size:?}: the plot is {frame} points high");
    }
}

#[test]
fn small_windows_over_the_window_keep_their_buttons_within_it() {
    let screen = Rect::from_min_size(pos2(0.0, 0.0), SMALL.into());
    let mut ui = over(zoomed(), SMALL);
    ui.key_press_modifiers(egui::Modifiers::SHIFT, egui::Key::F1);
    rest(&mut ui);
    let close = rect(&ui, Role::Button, "Close").expect("a way out");
    assert!(screen.contains_rect(close), "shortcuts: {close:?}");
    ui.key_press(egui::Key::Escape);
    rest(&mut ui);
    click(&mut ui, "Help");
    click(&mut ui, "About and licences");
    let close = rect(&ui, Role::Button, "Close").expect("a way out");
    assert!(screen.contains_rect(close), "about: {close:?}");
    ui.key_press(egui::Key::Escape);
    rest(&mut ui);
    click(&mut ui, "Help");
    click(&mut ui, "The ways to begin");
    let first = rect(&ui, Role::Button, "Show a class").expect("a tile");
    assert!(screen.contains_rect(first), "tiles: {first:?}");
    ui.key_press(egui::Key::Escape);
    rest(&mut ui);
    ui.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::K);
    rest(&mut ui);
    let field = rect(&ui, Role::TextInput, "Find anything").expect("a field");
    assert!(screen.contains_rect(field), "palette: {field:?}");
}

#[test]
fn the_page_looks_as_it_did_at_250_percent() {
    over(zoomed(), SMALL).snapshot("zoomed");
}

#[test]
fn the_column_looks_as_it_did_at_250_percent() {
    let mut ui = over(zoomed(), SMALL);
    click(&mut ui, EDGE);
    ui.snapshot("zoomed-model");
}
