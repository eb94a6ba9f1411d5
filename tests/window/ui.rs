//! The real window, driven without a display: what a hand does, and what is on screen then.

use std::{
    fs,
    path::{Path, PathBuf},
    sync::{Arc, Mutex},
};

use crate::driver::{Shown, Ui, app, assert_written, at_rest, click, no_files, wait_until, words};
use crate::narrow::give;
use crate::plain::plain;
use crate::soft_renderer::SoftRenderer;
use eframe::egui;
use egui::{Key, Modifiers, Pos2, Role, Vec2, vec2};
use egui_kittest::{
    Harness, Node,
    kittest::{NodeT as _, Queryable as _},
};
use egui_plot::{PlotPoint, PlotTransform};
use spectral_explorer::{
    app::{
        App, Command, Entry, Height, Scale, Settings, Subject, Tone, View, chart, charts,
        derived::OF_CURVE,
        export::Export,
        measured,
        verdicts::Seen,
        workspace::{self, Preferences},
    },
    io::read_bytes,
    measurements::{Measurement, Quantity},
    spectrum::{Band, Kind, Line, NamedSpectrum, Sampled, Sampling},
    study::Measure,
    ui::{
        Window,
        files::{Ask, Picked, Picker},
        look_view::names as knobs,
        model_view::names,
        saver::Saver,
        theme,
        verdict_view::Side,
    },
};

/// Time of the program between two frames: short, so that two clicks make a double click.
const FRAME: f32 = 0.02;
/// Frames in which the window must come to rest; a tooltip comes after 0.35 s.
const MOST_FRAMES: u64 = 40;

fn window(app: App, picker: Picker) -> Window {
    Window::new(app, Preferences::default(), picker, None)
}

fn fresh() -> Ui {
    at_rest(window(plain(), no_files()))
}

fn settings(ui: &Ui) -> Settings {
    app(ui).document().settings
}

fn apply(ui: &mut Ui, command: Command) {
    let app = &mut ui.state_mut().app;
    app.apply(command);
    app.end_gesture();
    ui.run();
}

/// The control of that kind and name; the first from above where there are several.
#[track_caller]
fn control<'u>(ui: &'u Ui, role: Role, name: &'u str) -> Node<'u> {
    let mut found = ui.query_all_by_role_and_label(role, name);
    found
        .next()
        .unwrap_or_else(|| panic!("no {role:?} is called {name:?}"))
}

fn shortcut(ui: &mut Ui, modifiers: Modifiers, key: Key) {
    ui.key_press_modifiers(modifiers, key);
    ui.run();
}

fn press(ui: &mut Ui, key: Key) {
    ui.key_press(key);
    ui.run();
}

fn type_into(ui: &mut Ui, role: Role, name: &str, text: &str) {
    control(ui, role, name).click();
    ui.run();
    ui.event(egui::Event::Text(text.to_owned()));
    ui.run();
}

/// The window with another side of the column.
fn beside(side: Side) -> Ui {
    let mut ui = fresh();
    ui.state_mut().side = side;
    ui.run();
    ui
}

/// Chooses what is to be saved, in the menu or in its second level.
fn save_as(ui: &mut Ui, title: &str) {
    click(ui, "Save");
    if ui.query_by_role_and_label(Role::Button, title).is_none() {
        control(ui, Role::Button, "More formats").click();
        ui.run();
    }
    control(ui, Role::Button, title).click();
}

/// The window with the library open.
fn with_library() -> Ui {
    let mut ui = fresh();
    click(&mut ui, "Library: FL11");
    ui
}

/// What the verdict says about the numbers used.
fn numbers_words(app: &App) -> String {
    let derived = app.derived();
    let (smooth, spikes) = (
        derived.model.smooth().coefficients.len(),
        derived.model.lines().len(),
    );
    let lines = match spikes {
        0 => "no lines".to_owned(),
        1 => "2 for one line".to_owned(),
        n => format!("{} for {n} lines", 2 * n),
    };
    format!("{smooth} for the smooth part, {lines}")
}

/// Controls without a name: not even a hint inside counts, as the harness itself lets it.
fn nameless(ui: &Ui) -> Vec<String> {
    ui.root()
        .children_recursive()
        .map(|node| node.accesskit_node())
        .filter(|node| {
            let role = node.role();
            matches!(
                role,
                Role::Button
                    | Role::Slider
                    | Role::SpinButton
                    | Role::TextInput
                    | Role::ComboBox
                    | Role::CheckBox
                    | Role::RadioButton
                    | Role::Image
            )
        })
        .filter(|node| node.label().is_none_or(|label| label.trim().is_empty()))
        .map(|node| format!("{:?} at {:?}", node.role(), node.raw_bounds()))
        .collect()
}

#[track_caller]
fn assert_named(ui: &Ui, place: &str) {
    let nameless = nameless(ui);
    assert!(nameless.is_empty(), "{place}: without a name {nameless:?}");
}

/// Every control has a name, and every number is one.
#[track_caller]
fn assert_sound(ui: &Ui, place: &str) {
    assert_named(ui, place);
    for word in words(ui) {
        let is_no_number = word
            .split(|c: char| !c.is_alphanumeric())
            .any(|w| matches!(w, "NaN" | "inf" | "Infinity"));
        assert!(!is_no_number, "{place}: {word:?}");
    }
}

fn spectrum(name: &str, first_nm: f64, values: Vec<f64>) -> NamedSpectrum {
    NamedSpectrum {
        name: name.to_owned(),
        kind: Kind::Light,
        unit: "W m-2 nm-1".to_owned(),
        scale: 1.0,
        samples: Sampled::even(first_nm, 5.0, values).expect("finite values, rising grid"),
        notes: vec!["Made up for a test.".to_owned()],
        source: "a test".to_owned(),
    }
}

fn darkness() -> NamedSpectrum {
    spectrum("darkness", 380.0, vec![0.0; 81])
}

fn heater() -> NamedSpectrum {
    let values = (0..=64).map(|i| 1.0 + (f64::from(i) / 5.0).sin());
    spectrum("heater", 780.0, values.collect())
}

fn light(app: &App, key: &str) -> Command {
    Command::Show(app.entry(key).expect("shipped"))
}

// -------------------------------------------------------------------------------------- sliders

#[test]
fn the_first_window_shows_a_lamp_with_its_numbers() {
    let ui = fresh();
    assert_written(&ui, "FL11");
    assert_written(&ui, &numbers_words(app(&ui)));
    assert_written(&ui, "Spectrum of FL11");
    assert_sound(&ui, "first window");
}

#[test]
fn a_slider_moves_everything_in_the_same_frame() {
    for (side, order) in [Side::Verdict, Side::Figures]
        .into_iter()
        .flat_map(|side| [23.0, 3.0, 40.0, 0.0].map(|order| (side, order)))
    {
        let mut ui = beside(side);
        let before = numbers_words(app(&ui));
        control(&ui, Role::Slider, knobs::ORDER).set_value_accesskit(order);
        // One frame for the one event: what is on screen now was drawn in it.
        ui.step();
        assert_eq!(settings(&ui).order as f64, order);
        let now = numbers_words(app(&ui));
        assert_ne!(now, before);
        let patches = app(&ui).derived().patches.clone().expect("a light");
        for patch in &patches.items {
            let name = format!("{}: ΔE₀₀ {:.3}", patch.name, patch.delta_e_2000);
            control(&ui, Role::Button, &name);
        }
        let figure = |measure| app(&ui).derived().figures[measure].expect("not dark");
        if side == Side::Verdict {
            assert_written(&ui, &now);
            let worst = &patches.items[patches.worst];
            assert_written(&ui, &format!("at worst of 24 ({})", worst.name));
            // Two digits, without zeros at the end.
            let two: f64 = format!("{:.1e}", worst.delta_e_2000)
                .parse()
                .expect("a number");
            assert_written(&ui, &format!("ΔE₀₀ {two} at"));
            assert_written(&ui, &Seen::of(worst.delta_e_2000).verdict("light"));
        } else {
            let own = app(&ui).derived().colour.delta_e_2000.expect("a colour");
            assert_written(&ui, &format!("ΔE₀₀ {own:.3}"));
            for measure in [Measure::Rms, Measure::RmsBlurred] {
                assert_written(&ui, &format!("{:.2} %", 100.0 * figure(measure)));
            }
            let nm = figure(Measure::Displacement);
            assert_written(&ui, &format!("{nm:.2} nm"));
        }
        let numbers = app(&ui).derived().numbers();
        assert_written(&ui, &format!("Spectrum of FL11: {numbers} numbers"));
    }
}

#[test]
fn the_threshold_slider_drops_spikes() {
    let mut ui = fresh();
    let before = app(&ui).derived().model.lines().len();
    control(&ui, Role::Slider, knobs::LINES).set_value_accesskit(5.0);
    ui.step();
    // The slider is logarithmic: a value is reached by rounding.
    assert!((settings(&ui).threshold_percent - 5.0).abs() < 1e-9);
    let now = app(&ui).derived().model.lines().len();
    assert!(0 < now && now < before, "{now} of {before}");
    assert_written(&ui, &numbers_words(app(&ui)));
    let count = control(&ui, Role::SpinButton, knobs::LINES_TYPED);
    assert_eq!(count.accesskit_node().value(), Some(now.to_string()));
    // So many lines can be asked for as well.
    let fl2 = light(app(&ui), "cie_fluorescent_1nm/FL2");
    apply(&mut ui, fl2);
    for count in [3, 1, 4, 0, 2] {
        type_into(
            &mut ui,
            Role::SpinButton,
            knobs::LINES_TYPED,
            &count.to_string(),
        );
        press(&mut ui, Key::Enter);
        assert_eq!(app(&ui).derived().model.lines().len(), count);
    }
}

#[test]
fn automatic_reset_and_the_papers_settings_are_one_step_each() {
    let mut ui = fresh();
    let first = app(&ui).document().clone();
    for (open, button) in [
        (None, knobs::AUTOMATIC),
        (None, knobs::RESET),
        (Some(knobs::MORE), knobs::PAPER),
    ] {
        if let Some(menu) = open {
            click(&mut ui, menu);
        }
        control(&ui, Role::Button, button).click();
        let before = settings(&ui);
        wait_until(&mut ui, button, |ui| settings(ui) != before);
        let derived = app(&ui).derived();
        match button {
            knobs::AUTOMATIC => {
                assert!(derived.numbers() <= ui.state().app.document().pages.look.numbers);
                assert_written(&ui, "The best of all ways with at most 21 numbers: ");
            }
            knobs::RESET => assert_eq!(settings(&ui), Settings::default()),
            _ => {
                let now = settings(&ui);
                assert_eq!((now.band, now.sampling), (Band::PAPER, Sampling::Paper));
                assert!(!now.colour_exact);
            }
        }
        shortcut(&mut ui, Modifiers::COMMAND, Key::Z);
        assert_eq!(app(&ui).document(), &first, "{button}");
        assert!(app(&ui).undo_words().is_none(), "{button}");
    }
}

#[test]
fn automatic_stops_where_the_noise_of_a_light_begins() {
    // One wave in either basis, in noise of a hundredth.
    let value = |nm: i32| {
        let x = std::f64::consts::PI * f64::from(nm - 380) / 400.0;
        let noise = (f64::from(nm) * 12.9898).sin() * 43758.5453;
        1.0 + 0.3 * (2.0 * x).cos() + 0.03 * (noise - noise.floor() - 0.5)
    };
    let samples = Sampled::even(380.0, 1.0, (380..=780).map(value).collect());
    let mut of = Measurement::new("lamp", Quantity::Light, "", samples.expect("finite"));
    let entry = |of: &Measurement| Entry {
        measured: Some(Arc::new(of.clone())),
        ..Entry::own(1, measured::spectrum(of, ""))
    };
    let mut order = |tells: bool| {
        of.sigma = tells.then(|| vec![0.03 / 12.0_f64.sqrt(); 401]);
        let mut ui = fresh();
        apply(&mut ui, Command::Show(Arc::new(entry(&of))));
        let before = settings(&ui);
        control(&ui, Role::Button, knobs::AUTOMATIC).click();
        wait_until(&mut ui, "Automatic", |ui| settings(ui) != before);
        if tells {
            assert_written(&ui, "More waves would draw the noise.");
        }
        settings(&ui).order
    };
    assert_eq!(order(true), 1);
    assert!(order(false) > 1);
}

#[test]
fn a_number_can_be_typed_and_reach_further_than_the_slider() {
    let mut ui = fresh();
    for (typed, order) in [("21", 21), ("60", 60), ("5000", 100)] {
        type_into(&mut ui, Role::SpinButton, knobs::ORDER_TYPED, typed);
        press(&mut ui, Key::Enter);
        assert_eq!(settings(&ui).order, order, "typed {typed}");
    }
    type_into(&mut ui, Role::SpinButton, knobs::ORDER_TYPED, "many");
    press(&mut ui, Key::Enter);
    assert_eq!(settings(&ui).order, 100, "words are no number");
    click(&mut ui, "Settings");
    type_into(&mut ui, Role::SpinButton, names::THRESHOLD, "0.02");
    press(&mut ui, Key::Enter);
    assert_eq!(settings(&ui).threshold_percent, 0.02);
    type_into(&mut ui, Role::SpinButton, names::WIDTH, "33");
    press(&mut ui, Key::Enter);
    assert_eq!(settings(&ui).max_width_nm, 33.0);
}

#[test]
fn the_exported_plot_ends_where_the_table_does() {
    let mut app = plain();
    app.apply(light(&app, "cie_fluorescent_1nm/FL2"));
    let settings = app.document().settings;
    let chart_on = |app: &mut App, low, high| {
        app.apply(Command::Edit(Settings {
            band: Band::new(low, high).expect("a range"),
            ..settings
        }));
        charts::spectrum::spectrum_chart(app)
    };
    let wide = chart_on(&mut app, 300.0, 1400.0);
    let measured = wide.series.iter().find(|s| s.name == "measured");
    let points = app.measured_points().map(|(nm, _)| nm).collect::<Vec<_>>();
    assert!(measured.is_some());
    assert_eq!(points.first().zip(points.last()), Some((&380.0, &780.0)));
    let beside = chart_on(&mut app, 1000.0, 2000.0);
    assert!(beside.series.iter().all(|s| s.name != "measured"));
    assert!(beside.residual.is_none());
}

#[test]
fn the_models_numbers_stand_beside_the_points_that_the_table_has_in_the_range() {
    let mut ui = fresh();
    // 300 to 830 nm by 5 nm; the range in force holds 380 to 780 nm: 81 points.
    let table: String = (60..=166)
        .map(|i| format!("{},{}\n", 5 * i, 1.0 + 0.01 * f64::from(i)))
        .collect();
    drop_file(&mut ui, "coarse.csv", table.as_bytes());
    assert_written(&ui, "numbers instead of 81");
}

#[test]
fn a_range_in_which_nothing_was_measured_is_said_to_be_empty() {
    let mut app = plain();
    app.apply(light(&app, "cie_fluorescent_1nm/FL2"));
    let settings = app.document().settings;
    app.apply(Command::Edit(Settings {
        band: Band::new(1000.0, 2000.0).expect("a range"),
        ..settings
    }));
    let ui = at_rest(window(app, no_files()));
    assert_written(&ui, "Spectrum of FL2, nothing measured in this range");
}

#[test]
fn the_range_can_be_typed_and_brought_back() {
    let mut ui = beside(Side::Settings);
    type_into(&mut ui, Role::SpinButton, "Range from", "400");
    press(&mut ui, Key::Enter);
    type_into(&mut ui, Role::SpinButton, "Range to", "700");
    press(&mut ui, Key::Enter);
    assert_eq!(settings(&ui).band, Band::PAPER);
    assert_eq!(app(&ui).derived().measured.len(), 301);
    // Twenty nm are the least: what is shorter moves to that.
    type_into(&mut ui, Role::SpinButton, "Range to", "405");
    press(&mut ui, Key::Enter);
    assert_eq!(settings(&ui).band.max_nm(), 420.0);
    click(&mut ui, "380-780");
    assert_eq!(settings(&ui).band, Band::VISIBLE);
}

#[test]
fn plain_keys_change_the_order_when_no_control_has_the_keyboard() {
    let mut ui = fresh();
    press(&mut ui, Key::ArrowRight);
    press(&mut ui, Key::ArrowRight);
    press(&mut ui, Key::ArrowLeft);
    assert_eq!(settings(&ui).order, 8);
    press(&mut ui, Key::PageUp);
    assert_eq!(settings(&ui).threshold_percent, 0.5 * 1.25);
    press(&mut ui, Key::PageDown);
    assert_eq!(settings(&ui).threshold_percent, 0.5);
    for _ in 0..20 {
        press(&mut ui, Key::ArrowLeft);
    }
    assert_eq!(settings(&ui).order, 0, "there is nothing below");
    // A slider with the keyboard keeps the arrows to itself.
    click(&mut ui, "Settings");
    control(&ui, Role::Slider, names::WIDTH).focus();
    ui.run();
    press(&mut ui, Key::ArrowRight);
    assert_eq!(settings(&ui).order, 0);
    assert!(settings(&ui).max_width_nm > 10.0);
    control(&ui, Role::Slider, knobs::LINES).focus();
    ui.run();
    press(&mut ui, Key::ArrowLeft);
    assert_eq!(settings(&ui).order, 0);
    assert!(settings(&ui).threshold_percent > 0.5);
}

#[test]
fn switches_and_choices_do_what_they_say() {
    let mut ui = beside(Side::Settings);
    control(&ui, Role::CheckBox, names::COLOUR_EXACT).click();
    ui.run();
    assert!(settings(&ui).colour_exact);
    let delta = app(&ui).derived().colour.delta_e_2000.expect("a colour");
    // Exact but for rounding.
    assert!(delta < 1e-6, "{delta}");
    control(&ui, Role::CheckBox, names::SPIKES).click();
    ui.run();
    assert!(app(&ui).derived().model.lines().is_empty());
    click(&mut ui, "Cosine");
    assert_eq!(app(&ui).derived().model.smooth().basis.word(), "cosine");
    control(&ui, Role::CheckBox, "Show residual").click();
    ui.run();
    assert!(!app(&ui).document().view.residual);
    for (combo, choice) in [("Scale", "peak 1"), ("Products by", "twice the numbers")] {
        control(&ui, Role::ComboBox, combo).click();
        ui.run();
        control(&ui, Role::Button, choice).click();
        ui.run();
    }
    assert_eq!(app(&ui).document().scale, Scale::PeakOne);
    assert_eq!(settings(&ui).sampling, Sampling::Double);
    assert_written(&ui, "share of the peak");
}

#[test]
fn a_click_in_the_error_curve_goes_to_that_order() {
    let mut ui = fresh();
    let name = "Error against waves; click to go there";
    let rect = control(&ui, Role::Image, name).rect();
    let inside = rect.left_top() + vec2(0.7 * rect.width(), 0.4 * rect.height());
    ui.hover_at(inside);
    ui.run();
    ui.drag_at(inside);
    ui.drop_at(inside);
    ui.run();
    let order = settings(&ui).order;
    assert!(
        (15..=35).contains(&order),
        "order {order} of 40 at 0.7 of the width"
    );
    assert_written(&ui, &numbers_words(app(&ui)));
}

// -------------------------------------------------------------------------------------- library

fn search(ui: &mut Ui, text: &str) {
    control(ui, Role::TextInput, "Search the library").click();
    ui.run();
    shortcut(ui, Modifiers::COMMAND, Key::A);
    ui.event(egui::Event::Text(text.to_owned()));
    ui.run();
}

#[test]
fn a_search_finds_a_spectrum_and_a_click_shows_it() {
    let mut ui = with_library();
    search(&mut ui, "fluorescent fl2");
    assert!(ui.query_by_role_and_label(Role::Button, "CIE A").is_none());
    click(&mut ui, "FL2");
    assert_eq!(app(&ui).document().light.name(), "FL2");
    assert_written(&ui, "Spectrum of FL2:");
    search(&mut ui, "no such lamp");
    assert_written(&ui, "Nothing found. Try: LED, candle, 4000 K, sodium.");
    search(&mut ui, "ohta red");
    click(&mut ui, "moderate red");
    assert_eq!(app(&ui).document().subject, Subject::Factor);
    assert_written(&ui, "moderate red under six lights");
    // Back to the light by the switch over the knobs.
    click(&mut ui, "Settings");
    click(&mut ui, "FL2");
    assert!(app(&ui).document().is_about_light());
    // Escape gives up the search first, then the library.
    let text = |ui: &Ui| {
        let field = ui.query_by_role_and_label(Role::TextInput, "Search the library")?;
        Some(field.accesskit_node().value().unwrap_or_default())
    };
    assert_eq!(text(&ui).as_deref(), Some("ohta red"));
    press(&mut ui, Key::Escape);
    assert_eq!(text(&ui).as_deref(), Some(""));
    press(&mut ui, Key::Escape);
    assert_eq!(text(&ui), None);
}

#[test]
fn the_library_opens_by_key_and_by_the_lights_name_and_stays_when_pinned() {
    let mut ui = fresh();
    let is_open = |ui: &Ui| {
        let field = ui.query_by_role_and_label(Role::TextInput, "Search the library");
        field.is_some()
    };
    assert!(!is_open(&ui));
    for _ in 0..2 {
        shortcut(&mut ui, Modifiers::COMMAND, Key::L);
        assert!(is_open(&ui));
        click(&mut ui, "Library: FL11");
        assert!(!is_open(&ui));
    }
    shortcut(&mut ui, Modifiers::COMMAND, Key::F);
    // The field has the keyboard already.
    ui.event(egui::Event::Text("ohta red".to_owned()));
    ui.run();
    control(&ui, Role::Button, "moderate red");
    press(&mut ui, Key::Escape);
    click(&mut ui, "Pin");
    press(&mut ui, Key::Escape);
    assert!(is_open(&ui) && ui.state().preferences.pinned);
    click(&mut ui, "Pin");
    assert!(!is_open(&ui));
}

#[test]
fn a_click_with_ctrl_or_shift_lays_a_spectrum_over() {
    let mut ui = with_library();
    // The rows are to be on the screen.
    ui.set_size(vec2(1280.0, 3000.0));
    ui.run();
    for modifiers in [Modifiers::COMMAND, Modifiers::SHIFT] {
        let before = app(&ui).document().overlays.len();
        let name = if before == 0 { "CIE D65" } else { "CIE A" };
        control(&ui, Role::Button, name).click_modifiers(modifiers);
        ui.run();
        assert_eq!(app(&ui).document().light.name(), "FL11");
        assert_eq!(app(&ui).document().overlays.len(), before + 1);
    }
    // A plain click chooses the second light, when that is what the library was opened for.
    click(&mut ui, "+ Compare");
    click(&mut ui, "CIE A");
    assert_eq!(app(&ui).document().light.name(), "FL11");
    let second = app(&ui)
        .document()
        .second
        .as_ref()
        .map(|second| second.name());
    assert_eq!(second, Some("CIE A"));
    let overlays = &app(&ui).document().overlays;
    let names: Vec<&str> = overlays.iter().map(|o| o.name()).collect();
    assert_eq!(names, ["CIE D65", "CIE A"], "overlays stay overlays");
    click(&mut ui, "Layers");
    control(&ui, Role::CheckBox, "Show overlays");
    click(&mut ui, "Clear");
    assert!(app(&ui).document().overlays.is_empty());
}

/// The sum of a curve with the CIE 1931 y-bar at every whole nm of its range, straight between its
/// points.
fn luminance(points: &[[f64; 2]]) -> f64 {
    let table = spectral_explorer::color::Observer::CIE_1931.table();
    let at = |nm: f64| {
        let next = points.partition_point(|point| point[0] <= nm);
        let next = next.clamp(1, points.len() - 1);
        let [[x0, y0], [x1, y1]] = [points[next - 1], points[next]];
        y0 + (y1 - y0) * (nm - x0) / (x1 - x0)
    };
    (380..=780)
        .map(f64::from)
        .map(|nm| at(nm) * table.at(nm)[1])
        .sum()
}

/// The points of a curve of the spectrum plot.
fn drawn(ui: &Ui, name: &str) -> Option<Vec<[f64; 2]>> {
    let chart = charts::spectrum::spectrum_chart(app(ui));
    let found = chart
        .series
        .into_iter()
        .find(|series| series.name == name)?;
    match found.marks {
        chart::Marks::Line { points, .. } | chart::Marks::Area { points, .. } => Some(points),
        _ => None,
    }
}

#[test]
fn lights_of_relative_units_are_laid_over_equally_bright_and_a_surface_over_no_light() {
    // As measured their luminances are 1 to 7.4, 1 to 7.2, and 1 to some thousand.
    for (of, over) in [
        ("cie_fluorescent_1nm/FL2", "cie_illuminants/CIE A"),
        ("cie_fluorescent_1nm/FL8", "cie_illuminants/CIE D50"),
        ("cie_led_1nm/LED-B1", "cie_fluorescent_1nm/FL2"),
        ("cie_fluorescent_1nm/FL2", "lamps_nist_traditional/LPS"),
    ] {
        let mut ui = fresh();
        let command = light(app(&ui), of);
        apply(&mut ui, command);
        let entry = app(&ui).entry(over).expect("shipped");
        let name = entry.name().to_owned();
        if name == "CIE A" {
            click(&mut ui, "+ Compare");
            search(&mut ui, &name);
            click(&mut ui, &name);
        } else {
            apply(&mut ui, Command::ToggleOverlay(entry.clone()));
        }
        let laid: Vec<_> = app(&ui).document().laid_over().collect();
        assert_eq!(laid, [&entry], "{over}");
        let bright = |name: &str| luminance(&drawn(&ui, name).expect(name));
        let ratio = bright(&name) / bright("measured");
        // The eye has 4e-6 of its sensitivity outside 380 to 780 nm.
        assert!((ratio - 1.0).abs() < 1e-4, "{of}, {over}: {ratio}");
        assert_written(&ui, &format!("{name} at the same brightness"));
    }
    let mut ui = fresh();
    let surface = app(&ui).entry("colorchecker_ohta/red").expect("shipped");
    apply(&mut ui, Command::ToggleOverlay(surface));
    assert_eq!(drawn(&ui, "red"), None);
    assert_written(
        &ui,
        "red not drawn: power and reflectance have no common axis",
    );
    // A dark surface over a bright one stays dark.
    let white = app(&ui)
        .entry("colorchecker_ohta/white 9.5 (.05 D)")
        .expect("shipped");
    let black = app(&ui)
        .entry("colorchecker_ohta/black 2 (1.5 D)")
        .expect("shipped");
    apply(&mut ui, Command::Show(white));
    apply(&mut ui, Command::ToggleOverlay(black));
    let points = drawn(&ui, "black 2 (1.5 D)").expect("drawn");
    assert!(points.iter().all(|[_, share]| *share < 0.1), "{points:?}");
}

#[test]
fn an_own_spectrum_is_renamed_and_removed_in_the_library() {
    let mut ui = with_library();
    apply(&mut ui, Command::Adopt(vec![heater()]));
    control(&ui, Role::Button, "heater").click_secondary();
    ui.run();
    click(&mut ui, "Rename");
    shortcut(&mut ui, Modifiers::COMMAND, Key::A);
    ui.event(egui::Event::Text("my lamp".to_owned()));
    ui.run();
    press(&mut ui, Key::Enter);
    assert_eq!(app(&ui).document().own[0].name(), "my lamp");
    control(&ui, Role::Button, "my lamp").click_secondary();
    ui.run();
    click(&mut ui, "Remove");
    assert!(app(&ui).document().own.is_empty());
    assert_eq!(app(&ui).document().light.name(), "FL2", "the first light");
}

#[test]
fn a_click_on_a_patch_shows_its_product_and_a_second_hides_it() {
    let mut ui = fresh();
    let patch = app(&ui).derived().patches.as_ref().expect("a light").items[4].clone();
    let name = format!("{}: ΔE₀₀ {:.3}", patch.name, patch.delta_e_2000);
    click(&mut ui, &name);
    assert_eq!(app(&ui).document().patch, Some(4));
    assert_eq!(
        app(&ui).product().map(|p| p.name.clone()),
        Some(patch.name.clone())
    );
    assert_written(&ui, &format!("off {}", patch.name));
    click(&mut ui, &name);
    assert_eq!(app(&ui).product(), None);
}

// ----------------------------------------------------------------------------- spikes in the plot

fn height(is_log: bool) -> Height {
    if is_log { Height::Log } else { Height::Even }
}

fn transform(ui: &Ui) -> PlotTransform {
    ui.state()
        .look
        .spectrum
        .transform
        .expect("the plot was drawn")
}

/// The width of the line that a spike stands for.
fn stem_width(app: &App, spike: Line) -> f64 {
    let derived = app.derived();
    let mut spikes = derived.model.lines().iter();
    let index = spikes
        .position(|s| *s == spike)
        .expect("a spike of the model");
    derived.parts.stem_width_nm(index)
}

/// Where a spike's tip stands on screen.
fn tip(ui: &Ui, spike: Line) -> Pos2 {
    let (app, derived) = (app(ui), app(ui).derived());
    let base = derived.band.interpolate(&derived.smooth, spike.at_nm);
    let height = base + spike.stem_height(stem_width(app, spike));
    transform(ui).position_from_point(&PlotPoint::new(spike.at_nm, height * app.scale_factor()))
}

fn strongest(ui: &Ui) -> Line {
    let spikes = app(ui).derived().model.lines().iter().copied();
    spikes
        .max_by(|a, b| a.weight.total_cmp(&b.weight))
        .expect("FL11 has spikes")
}

fn hand_spike(ui: &Ui) -> Option<Line> {
    let spikes = &app(ui).derived().parts.spikes;
    spikes.iter().find(|s| s.hand.is_some()).map(|s| s.spike)
}

/// Presses, and moves in a few frames; the button stays down.
fn drag(ui: &mut Ui, from: Pos2, by: Vec2) {
    ui.hover_at(from);
    ui.run();
    ui.drag_at(from);
    ui.step();
    for step in 1..=5 {
        ui.hover_at(from + by * (step as f32 / 5.0));
        ui.step();
    }
    // One more frame: a plot tells where its points are in the frame after.
    ui.step();
}

#[test]
fn a_spike_is_dragged_in_place_and_weight_as_one_step_and_the_plot_stands_still() {
    let mut ui = fresh();
    let first = app(&ui).document().clone();
    let bounds = *transform(&ui).bounds();
    let spike = strongest(&ui);
    let from = tip(&ui, spike);
    let by = vec2(-40.0, 90.0);
    drag(&mut ui, from, by);
    let moved = hand_spike(&ui).expect("the spike is in hand");
    // The tip is under the pointer, to the pixel.
    let off = tip(&ui, moved).distance(from + by);
    assert!(off < 1.0, "the tip is {off} points from the pointer");
    assert!(
        moved.at_nm < spike.at_nm - 5.0 && moved.weight < 0.8 * spike.weight,
        "{moved:?}"
    );
    assert_eq!(
        transform(&ui).bounds().min(),
        bounds.min(),
        "the plot does not pan or zoom"
    );
    assert_eq!(transform(&ui).bounds().max(), bounds.max());
    ui.drop_at(from + by);
    ui.run();
    assert_eq!(hand_spike(&ui), Some(moved), "it stays where it was let go");
    let x = |b: &egui_plot::PlotBounds| [b.min()[0], b.max()[0]];
    assert_eq!(x(transform(&ui).bounds()), x(&bounds));
    // Moving on without the button moves nothing.
    ui.hover_at(from + by + vec2(60.0, 0.0));
    ui.run();
    assert_eq!(hand_spike(&ui), Some(moved));
    shortcut(&mut ui, Modifiers::COMMAND, Key::Z);
    assert_eq!(app(&ui).document(), &first);
    assert!(
        app(&ui).undo_words().is_none(),
        "the whole drag is one step"
    );
}

#[test]
fn a_spike_that_is_held_still_lets_the_window_rest() {
    let mut ui = fresh();
    let from = tip(&ui, strongest(&ui));
    drag(&mut ui, from, vec2(-40.0, 90.0));
    let (revision, held) = (app(&ui).revision(), hand_spike(&ui));
    // Panics when frame follows frame although nothing moves.
    ui.run();
    assert_eq!((app(&ui).revision(), hand_spike(&ui)), (revision, held));
}

#[test]
fn a_spike_is_dragged_past_another_without_changing_hands() {
    let mut ui = fresh();
    let spike = strongest(&ui);
    let from = tip(&ui, spike);
    // Far to the left, over every other line.
    let target = transform(&ui).position_from_point_x(400.0);
    let by = vec2(target - from.x, 20.0);
    drag(&mut ui, from, by);
    ui.drop_at(from + by);
    ui.run();
    assert_eq!(
        app(&ui).document().subject_edits().hand.len(),
        1,
        "one spike was moved"
    );
    let moved = hand_spike(&ui).expect("the one in hand");
    // Wider figures at the axis move the plot a little.
    let pointed = transform(&ui).value_from_position(from + by).x;
    assert!(
        (moved.at_nm - pointed).abs() < 0.6,
        "{moved:?} at {pointed}"
    );
    assert!((moved.at_nm - 400.0).abs() < 5.0, "{moved:?}");
    let off = tip(&ui, moved).distance(from + by);
    assert!(off < 1.0, "the tip is {off} points from the pointer");
}

#[test]
fn a_click_on_a_spike_alone_changes_nothing() {
    let mut ui = fresh();
    let from = tip(&ui, strongest(&ui));
    ui.hover_at(from);
    ui.run();
    ui.drag_at(from);
    ui.run();
    ui.hover_at(from + vec2(1.0, -1.0));
    ui.run();
    ui.drop_at(from + vec2(1.0, -1.0));
    ui.run();
    assert!(app(&ui).undo_words().is_none());
}

#[test]
fn a_spike_is_dragged_to_the_same_place_under_another_scale_and_a_log_axis() {
    for log_axis in [false, true] {
        let mut ui = fresh();
        let view = app(&ui).document().view;
        apply(&mut ui, Command::Scale(Scale::HundredLux));
        apply(
            &mut ui,
            Command::View(View {
                height: height(log_axis),
                ..view
            }),
        );
        let spike = strongest(&ui);
        let factor = app(&ui).scale_factor();
        let place = |ui: &Ui, spike: Line| {
            let derived = app(ui).derived();
            let base = derived.band.interpolate(&derived.smooth, spike.at_nm);
            let value = factor * (base + spike.stem_height(stem_width(app(ui), spike)));
            let height = if log_axis { value.log10() } else { value };
            transform(ui).position_from_point(&PlotPoint::new(spike.at_nm, height))
        };
        let from = place(&ui, spike);
        let by = vec2(-30.0, 25.0);
        drag(&mut ui, from, by);
        let moved = hand_spike(&ui).expect("the spike is in hand");
        let off = place(&ui, moved).distance(from + by);
        assert!(
            off < 1.0,
            "log {log_axis}: the tip is {off} points from the pointer"
        );
        ui.drop_at(from + by);
        ui.run();
    }
}

#[test]
fn shift_and_a_double_click_beside_the_lines_add_one() {
    let mut ui = fresh();
    let before = app(&ui).derived().model.lines().len();
    let frame = *transform(&ui).frame();
    let at = Pos2::new(
        transform(&ui).position_from_point_x(675.0),
        frame.center().y,
    );
    ui.hover_at(at);
    ui.run();
    let height = transform(&ui).value_from_position(at).y;
    for _ in 0..2 {
        for pressed in [true, false] {
            let event = egui::Event::PointerButton {
                pos: at,
                button: egui::PointerButton::Primary,
                pressed,
                modifiers: Modifiers::SHIFT,
            };
            ui.event_modifiers(event, Modifiers::SHIFT);
        }
        ui.step();
    }
    ui.run();
    assert_eq!(app(&ui).derived().model.lines().len(), before + 1);
    let added = hand_spike(&ui).expect("the added one");
    // A pixel is about half a nm.
    assert!((added.at_nm - 675.0).abs() < 0.6, "{added:?}");
    assert!(added.weight > 0.0 && added.stem_height(10.0) < height);
    click(&mut ui, "Undo");
    assert_eq!(app(&ui).derived().model.lines().len(), before);
    assert!(app(&ui).undo_words().is_none());
}

#[test]
fn a_drag_in_the_empty_plot_pans_it_and_home_brings_it_back() {
    let mut ui = fresh();
    let bounds = *transform(&ui).bounds();
    let frame = *transform(&ui).frame();
    let from = Pos2::new(
        transform(&ui).position_from_point_x(675.0),
        frame.top() + 0.4 * frame.height(),
    );
    drag(&mut ui, from, vec2(-80.0, 0.0));
    ui.drop_at(from + vec2(-80.0, 0.0));
    ui.run();
    assert!(transform(&ui).bounds().min()[0] > bounds.min()[0] + 1.0);
    assert!(app(&ui).undo_words().is_none(), "looking is no change");
    press(&mut ui, Key::Home);
    let now = *transform(&ui).bounds();
    assert_eq!(
        (now.min()[0], now.max()[0]),
        (bounds.min()[0], bounds.max()[0])
    );
}

#[test]
fn the_spike_table_edits_locks_and_deletes() {
    let mut ui = fresh();
    let count = app(&ui).derived().model.lines().len();
    click(&mut ui, "All figures");
    type_into(&mut ui, Role::SpinButton, "Line 1 place", "410");
    press(&mut ui, Key::Enter);
    assert_eq!(hand_spike(&ui).map(|s| s.at_nm), Some(410.0));
    type_into(&mut ui, Role::SpinButton, "Line 1 weight", "12.5");
    press(&mut ui, Key::Enter);
    assert_eq!(hand_spike(&ui).map(|s| s.weight), Some(12.5));
    click(&mut ui, "Forget hand edits");
    assert_eq!(hand_spike(&ui), None);
    click(&mut ui, "Delete line 1");
    assert_eq!(app(&ui).derived().model.lines().len(), count - 1);
    control(&ui, Role::CheckBox, "Lock line 1").click();
    ui.run();
    assert!(hand_spike(&ui).is_some());
}

#[test]
fn the_plot_in_a_file_shows_what_the_window_shows() {
    let mut ui = fresh();
    let view = app(&ui).document().view;
    for key in ["cie_fluorescent_1nm/FL2", "cie_illuminants/CIE A"] {
        let overlay = app(&ui).entry(key).expect("shipped");
        apply(&mut ui, Command::ToggleOverlay(overlay));
    }
    apply(&mut ui, Command::Patch(Some(4)));
    for log_axis in [false, true] {
        apply(
            &mut ui,
            Command::View(View {
                height: height(log_axis),
                ..view
            }),
        );
        ui.run();
        let chart = charts::spectrum::spectrum_chart(app(&ui));
        let log = |y: f64| if log_axis { y.log10() } else { y };
        let [[left, right], [low, high]] = [chart.x_limits(), chart.y_limits().map(log)];
        let bounds = *transform(&ui).bounds();
        assert_eq!((bounds.min(), bounds.max()), ([left, low], [right, high]));
        let names: Vec<&str> = chart.legend_series().iter().map(|s| &*s.name).collect();
        for name in [
            "FL2",
            "CIE A",
            "measured",
            "smooth part",
            "lines",
            "residual",
        ] {
            assert!(names.contains(&name), "{name} in {names:?}");
        }
        assert!(names.iter().any(|name| name.starts_with("off ")));
    }
}

// ---------------------------------------------------------------------------------------- undo

#[test]
fn undo_and_redo_by_keys_and_by_buttons() {
    let mut ui = fresh();
    let first = app(&ui).document().clone();
    control(&ui, Role::Slider, knobs::ORDER).set_value_accesskit(20.0);
    ui.run();
    let second = app(&ui).document().clone();
    shortcut(&mut ui, Modifiers::COMMAND, Key::Z);
    assert_eq!(app(&ui).document(), &first);
    shortcut(&mut ui, Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::Z);
    assert_eq!(app(&ui).document(), &second);
    click(&mut ui, "Undo");
    assert_eq!(app(&ui).document(), &first);
    click(&mut ui, "Redo");
    assert_eq!(app(&ui).document(), &second);
    shortcut(&mut ui, Modifiers::COMMAND, Key::Z);
    shortcut(&mut ui, Modifiers::COMMAND, Key::Y);
    assert_eq!(app(&ui).document(), &second);
}

#[test]
fn a_slider_dragged_by_the_mouse_is_one_step_of_undo() {
    let mut ui = fresh();
    let first = app(&ui).document().clone();
    let rail = control(&ui, Role::Slider, knobs::ORDER).rect();
    let from = Pos2::new(rail.left() + 20.0, rail.center().y);
    drag(&mut ui, from, vec2(60.0, 0.0));
    ui.drop_at(from + vec2(60.0, 0.0));
    ui.run();
    assert_ne!(settings(&ui).order, 7);
    shortcut(&mut ui, Modifiers::COMMAND, Key::Z);
    assert_eq!(app(&ui).document(), &first);
    assert!(app(&ui).undo_words().is_none());
}

// ---------------------------------------------------------------------------------------- files

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

fn drop_file(ui: &mut Ui, name: &str, bytes: &[u8]) {
    let file = FakeFile(name.into(), bytes.to_vec());
    ui.input_mut().dropped_files.push(Arc::new(file));
    ui.run();
}

/// What was asked of a picker that always gives the same answer.
fn picker(answer: Picked) -> (Picker, Arc<Mutex<Vec<Ask>>>) {
    let asked = Arc::new(Mutex::new(Vec::new()));
    let record = asked.clone();
    let picker: Picker = Arc::new(move |ask| {
        record
            .lock()
            .expect("no panic in a picker")
            .push(ask.clone());
        answer.clone()
    });
    (picker, asked)
}

const LAMP: &str = "400 1\n450 2\n500 4\n550 2\n600 1\n650 1\n700 1\n";

#[test]
fn a_dropped_file_is_shown() {
    let mut ui = fresh();
    drop_file(&mut ui, "lamp.csv", LAMP.as_bytes());
    assert_eq!(app(&ui).document().own.len(), 1);
    assert!(app(&ui).document().light.key.starts_with("own/"));
    let message = app(&ui).message().expect("how it was read");
    assert!(
        message.tone == Tone::Info && message.text.contains("lamp.csv"),
        "{message:?}"
    );
    assert_written(&ui, "lamp.csv");
    click(&mut ui, "Undo");
    assert_eq!(app(&ui).document().light.name(), "FL11");
}

#[test]
fn a_dropped_file_that_is_no_spectrum_leaves_everything_and_is_named() {
    let mut ui = fresh();
    let before = app(&ui).document().clone();
    for (name, bytes) in [
        (
            "poem.txt",
            &b"Tyger Tyger, burning bright\nIn the forests of the night"[..],
        ),
        ("noise.bin", &[0, 159, 146, 150, 0, 1, 2, 3]),
        ("empty.csv", b""),
        (
            "half.json",
            b"{\"format\": \"spectral-explorer-project\", \"version\": 1, ",
        ),
    ] {
        drop_file(&mut ui, name, bytes);
        assert_eq!(app(&ui).document(), &before);
        let message = app(&ui).message().expect("a refusal");
        assert_eq!(message.tone, Tone::Problem);
        assert!(
            message.text.starts_with(name) && !message.text.contains('\n'),
            "{message:?}"
        );
        assert_written(&ui, &message.text.clone());
    }
    assert!(app(&ui).undo_words().is_none());
}

#[test]
fn a_dropped_project_is_opened_and_can_be_undone() {
    let mut other = plain();
    other.apply(light(&other, "cie_illuminants/CIE A"));
    other.apply(Command::Scale(Scale::OneWatt));
    let text = workspace::to_json(other.document(), None).unwrap();
    let mut ui = fresh();
    let before = app(&ui).document().clone();
    drop_file(&mut ui, "project.json", text.as_bytes());
    assert_eq!(app(&ui).document(), other.document());
    shortcut(&mut ui, Modifiers::COMMAND, Key::Z);
    assert_eq!(app(&ui).document(), &before);
}

#[test]
fn the_open_button_asks_the_picker_and_shows_what_it_gave() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("my lamp.csv");
    fs::write(&path, LAMP).expect("written");
    let (picker, asked) = picker(Picked::Paths(vec![path.clone()]));
    let mut ui = at_rest(window(plain(), picker));
    click(&mut ui, "Open");
    control(&ui, Role::Button, "Open files…").click();
    wait_until(&mut ui, "the file", |ui| !app(ui).document().own.is_empty());
    assert_eq!(*asked.lock().expect("no panic"), [Ask::Open]);
    assert_eq!(ui.state().preferences.recent, [path]);
    assert!(!ui.state().is_busy());
    // It stands among the recent files now.
    ui.state_mut().app.apply(Command::Undo);
    click(&mut ui, "Open");
    control(&ui, Role::Button, "my lamp.csv").click();
    wait_until(&mut ui, "the same again", |ui| {
        app(ui).document().own.len() == 1
    });
}

#[test]
fn a_cancelled_dialog_changes_nothing() {
    let (picker, asked) = picker(Picked::Cancelled);
    let mut ui = at_rest(window(plain(), picker));
    let before = app(&ui).document().clone();
    shortcut(&mut ui, Modifiers::COMMAND, Key::O);
    wait_until(&mut ui, "an answer", |ui| !ui.state().is_busy());
    assert_eq!(asked.lock().expect("no panic").len(), 1);
    assert_eq!(app(&ui).document(), &before);
}

#[test]
fn without_a_dialog_the_path_is_typed() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("lamp.csv");
    fs::write(&path, LAMP).expect("written");
    let (picker, _) = picker(Picked::NoDialog);
    let mut ui = at_rest(window(plain(), picker));
    click(&mut ui, "Open");
    control(&ui, Role::Button, "Open files…").click();
    wait_until(&mut ui, "the path field", |ui| {
        ui.query_by_role_and_label(Role::TextInput, "Path of the file")
            .is_some()
    });
    assert_eq!(app(&ui).message().map(|m| m.tone), Some(Tone::Problem));
    assert_sound(&ui, "path field");
    // The field has the keyboard already.
    ui.event(egui::Event::Text(path.display().to_string()));
    ui.run();
    ui.key_press(Key::Enter);
    wait_until(&mut ui, "the file", |ui| !app(ui).document().own.is_empty());
    assert!(
        ui.query_by_label("Path of the file").is_none(),
        "the field is closed"
    );
}

#[test]
fn a_typed_path_that_leads_nowhere_is_told_and_escape_closes_the_field() {
    let mut ui = fresh();
    shortcut(&mut ui, Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::O);
    ui.event(egui::Event::Text("no such file.csv".to_owned()));
    ui.run();
    press(&mut ui, Key::Enter);
    assert_written(&ui, "No file or folder is called that.");
    let field = ui.query_by_role_and_label(Role::TextInput, "Path of the file");
    let typed = field.expect("still open").accesskit_node().value();
    assert_eq!(
        typed.as_deref(),
        Some("no such file.csv"),
        "nothing is lost"
    );
    press(&mut ui, Key::Escape);
    assert!(
        ui.query_by_role_and_label(Role::TextInput, "Path of the file")
            .is_none()
    );
}

#[test]
fn everything_in_the_save_menu_is_written_where_the_picker_says() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("saved");
    let (picker, asked) = picker(Picked::Paths(vec![path.clone()]));
    let mut ui = at_rest(window(plain(), picker));
    for export in Export::ALL {
        save_as(&mut ui, export.title());
        ui.step();
        wait_until(&mut ui, export.title(), |ui| {
            !ui.state().is_busy() && path.is_file() && app(ui).message().is_some()
        });
        wait_until(&mut ui, "the word that it is saved", |ui| {
            app(ui)
                .messages()
                .iter()
                .filter(|m| m.text.starts_with("Saved"))
                .count()
                == asked.lock().expect("no panic").len()
        });
        let ask = asked.lock().expect("no panic").last().cloned();
        let expected = Ask::Save {
            suggested: export.suggested_name(app(&ui)),
            extension: export.extension(),
        };
        assert_eq!(ask, Some(expected));
        let text = fs::read_to_string(&path).expect("text");
        let theme = spectral_explorer::app::chart::Theme::Dark;
        assert_eq!(text, export.text(app(&ui), theme).expect("a text"));
        fs::remove_file(&path).expect("there");
    }
}

#[test]
fn the_error_curve_is_saved_as_a_picture_of_pixels_too() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("curve.png");
    let (picker, asked) = picker(Picked::Paths(vec![path.clone()]));
    let mut ui = at_rest(window(plain(), picker));
    save_as(&mut ui, "Error against waves (PNG)");
    ui.step();
    wait_until(&mut ui, "the word that it is saved", |ui| {
        app(ui)
            .message()
            .is_some_and(|m| m.text.starts_with("Saved"))
    });
    let expected = Ask::Save {
        suggested: "FL11-error-against-order.png".to_owned(),
        extension: "png",
    };
    assert_eq!(asked.lock().expect("no panic").clone(), [expected]);
    let bytes = fs::read(&path).expect("saved");
    assert!(bytes.starts_with(b"\x89PNG"));
}

#[test]
fn a_saved_composite_can_be_opened_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("fl11.json");
    let (picker, _) = picker(Picked::NoDialog);
    let mut ui = at_rest(window(plain(), picker));
    save_as(&mut ui, Export::CompositeJson.title());
    wait_until(&mut ui, "the path field", |ui| {
        ui.query_by_role_and_label(Role::TextInput, "Path of the file")
            .is_some()
    });
    // A name is offered already; another one is typed over it.
    shortcut(&mut ui, Modifiers::COMMAND, Key::A);
    ui.event(egui::Event::Text(path.display().to_string()));
    ui.run();
    ui.key_press(Key::Enter);
    wait_until(&mut ui, "the file", |_| path.is_file());
    let reading = read_bytes("fl11.json", &fs::read(&path).expect("there")).expect("our own");
    assert_eq!(reading.composites[0].composite, app(&ui).derived().model);
}

#[test]
fn a_typed_path_replaces_a_file_only_by_the_button_that_says_so() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("kept.json");
    fs::write(&path, "kept").expect("written");
    let (picker, _) = picker(Picked::NoDialog);
    let mut ui = at_rest(window(plain(), picker));
    save_as(&mut ui, Export::CompositeJson.title());
    wait_until(&mut ui, "the path field", |ui| {
        ui.query_by_role_and_label(Role::TextInput, "Path of the file")
            .is_some()
    });
    shortcut(&mut ui, Modifiers::COMMAND, Key::A);
    ui.event(egui::Event::Text(path.display().to_string()));
    ui.run();
    press(&mut ui, Key::Enter);
    assert!(ui.query_by_label("Replace it").is_some(), "it asks");
    wait_until(&mut ui, "rest", |ui| !ui.state().is_busy());
    assert_eq!(fs::read_to_string(&path).expect("there"), "kept");
    click(&mut ui, "Replace it");
    wait_until(&mut ui, "the file", |_| {
        fs::read_to_string(&path).is_ok_and(|text| text != "kept")
    });
}

#[test]
fn a_place_that_cannot_be_written_is_told_in_one_line() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("no such folder").join("x.csv");
    let (picker, _) = picker(Picked::Paths(vec![path]));
    let mut ui = at_rest(window(plain(), picker));
    shortcut(&mut ui, Modifiers::COMMAND, Key::S);
    wait_until(&mut ui, "a refusal", |ui| {
        app(ui).message().is_some_and(|m| m.tone == Tone::Problem)
    });
    let message = &app(&ui).message().expect("a refusal").text;
    assert!(
        message.contains("x.csv") && !message.contains('\n'),
        "{message}"
    );
}

// ---------------------------------------------------------------------------------------- looks

#[test]
fn theme_presenting_and_zoom_change_by_button_and_by_key() {
    let mut ui = fresh();
    assert!(ui.ctx.global_style().visuals.dark_mode);
    click(&mut ui, "Surroundings");
    assert!(!ui.state().preferences.dark && !ui.ctx.global_style().visuals.dark_mode);
    shortcut(&mut ui, Modifiers::COMMAND, Key::D);
    assert!(ui.state().preferences.dark && ui.ctx.global_style().visuals.dark_mode);
    let size = |ui: &Ui| egui::TextStyle::Body.resolve(&ui.ctx.global_style()).size;
    let before = size(&ui);
    // By key, by button and by Escape, in and out.
    let plot = *transform(&ui).frame();
    for leaves in ["Escape", "F5", "Whole window"] {
        match leaves {
            "F5" => press(&mut ui, Key::F5),
            _ => click(&mut ui, "Present"),
        }
        assert!(ui.state().preferences.present && size(&ui) >= 28.0);
        // The plot is larger than before, not smaller.
        let now = *transform(&ui).frame();
        assert!(now.area() > plot.area(), "{now:?} from {plot:?}");
        match leaves {
            "Escape" => press(&mut ui, Key::Escape),
            "F5" => press(&mut ui, Key::F5),
            button => click(&mut ui, button),
        }
        assert!(!ui.state().preferences.present, "{leaves}");
        assert_eq!(size(&ui), before, "{leaves}");
    }
    click(&mut ui, "Help");
    click(&mut ui, "Larger (Ctrl++)");
    assert_eq!(
        (ui.state().preferences.zoom, ui.ctx.zoom_factor()),
        (1.1, 1.1)
    );
    for _ in 0..20 {
        shortcut(&mut ui, Modifiers::COMMAND, Key::Minus);
    }
    assert_eq!(ui.ctx.zoom_factor(), 0.8, "not smaller than that");
    shortcut(&mut ui, Modifiers::COMMAND, Key::Num0);
    assert_eq!(ui.ctx.zoom_factor(), 1.0);
    assert!(app(&ui).undo_words().is_none(), "looks are no part of undo");
}

#[test]
fn the_ways_to_begin_and_the_list_of_shortcuts_open_by_key_and_keeps_keys_to_itself() {
    let mut ui = fresh();
    press(&mut ui, Key::F1);
    control(&ui, Role::Button, "Show a class");
    press(&mut ui, Key::Escape);
    shortcut(&mut ui, Modifiers::SHIFT, Key::F1);
    assert_written(&ui, "One wave more");
    control(&ui, Role::Button, "Close");
    press(&mut ui, Key::ArrowRight);
    assert_eq!(settings(&ui).order, 7, "an open dialog has the keyboard");
    press(&mut ui, Key::Escape);
    assert!(ui.query_by_role_and_label(Role::Button, "Close").is_none());
}

/// Windows that show something out of the ordinary, by name.
fn subjects() -> Vec<(&'static str, App)> {
    let with = |spectrum: NamedSpectrum| {
        let mut app = plain();
        app.apply(Command::Adopt(vec![spectrum]));
        app
    };
    let mut reflectance = plain();
    reflectance.apply(light(&reflectance, "colorchecker_ohta/red"));
    let mut infrared = with(heater());
    let settings = infrared.document().settings;
    infrared.apply(Command::Edit(Settings {
        band: Band::new(780.0, 1100.0).expect("a range"),
        ..settings
    }));
    let mut far = infrared.clone();
    far.apply(Command::Edit(Settings {
        band: Band::new(850.0, 1100.0).expect("a range"),
        ..settings
    }));
    let mut overlaid = plain();
    for key in [
        "cie_illuminants/CIE A",
        "colorchecker_ohta/red",
        "observers/V(lambda) photopic",
    ] {
        overlaid.apply(Command::ToggleOverlay(
            overlaid.entry(key).expect("shipped"),
        ));
    }
    overlaid.apply(Command::Patch(Some(2)));
    let mut paper = plain();
    paper.apply(light(&paper, "paper/Mercury"));
    let mut line = plain();
    line.apply(light(&line, "lamps_nist_traditional/LPS"));
    vec![
        ("FL11", plain()),
        ("reflectance", reflectance),
        ("all zero", with(darkness())),
        ("infrared 780-1100", infrared),
        ("infrared 850-1100", far),
        ("overlays and a product", overlaid),
        ("one line, far out of sRGB", line),
        ("the paper's lamp", paper),
    ]
}

#[test]
fn every_view_of_every_kind_of_spectrum_is_drawn_with_names_and_without_nan() {
    for (name, app) in subjects() {
        let is_dark = !app.derived().has_errors();
        let mut ui = at_rest(window(app, no_files()));
        let mut look = 0;
        for (dark, present) in [(true, false), (true, true), (false, false), (false, true)] {
            for spikes_below in [false, true] {
                ui.state_mut().side = match spikes_below {
                    true => Side::Figures,
                    false => Side::Verdict,
                };
                let preferences = &mut ui.state_mut().preferences;
                preferences.dark = dark;
                preferences.present = present;
                preferences.curve = OF_CURVE[look % OF_CURVE.len()];
                look += 1;
                ui.run();
                assert_sound(&ui, name);
            }
        }
        for curve in OF_CURVE {
            ui.state_mut().preferences.curve = curve;
            ui.run();
            assert_sound(&ui, name);
        }
        for scale in Scale::ALL {
            let view = ui.state().app.document().view;
            apply(&mut ui, Command::Scale(scale));
            apply(
                &mut ui,
                Command::View(View {
                    height: if is_dark { Height::Even } else { Height::Log },
                    model: true,
                    ..view
                }),
            );
            assert_sound(&ui, name);
        }
        // Over the plot, for what hovering writes.
        let middle = transform(&ui).frame().center();
        for x in [-200.0, 0.0, 150.0] {
            ui.hover_at(middle + vec2(x, 0.0));
            ui.run();
            assert_sound(&ui, name);
        }
    }
}

#[test]
fn darkness_is_drawn_on_a_logarithmic_axis_too() {
    let mut ui = at_rest(window(plain(), no_files()));
    apply(&mut ui, Command::Adopt(vec![darkness()]));
    let view = app(&ui).document().view;
    for model in [false, true] {
        apply(
            &mut ui,
            Command::View(View {
                height: Height::Log,
                model,
                ..view
            }),
        );
        let bounds = *transform(&ui).bounds();
        let all = [bounds.min(), bounds.max()].concat();
        assert!(all.iter().all(|b| b.is_finite()), "{all:?}");
    }
    assert_sound(&ui, "darkness");
}

#[test]
fn a_spike_set_in_the_dark_is_listed_without_nan() {
    let mut dark = plain();
    dark.apply(Command::Adopt(vec![darkness()]));
    let mut ui = at_rest(window(dark, no_files()));
    ui.state_mut().side = Side::Figures;
    let act = spectral_explorer::app::SpikeAct::Add {
        at_nm: 500.0,
        weight: 1.0,
    };
    ui.state_mut().app.act_on_spikes(act);
    ui.run();
    assert_sound(&ui, "a spike in the dark");
}

#[test]
fn every_small_window_and_menu_is_drawn_with_names() {
    for (dark, present) in [(true, false), (false, false), (false, true)] {
        let mut ui = fresh();
        ui.state_mut().preferences.dark = dark;
        ui.state_mut().preferences.present = present;
        ui.run();
        shortcut(&mut ui, Modifiers::SHIFT, Key::F1);
        assert_written(&ui, "Undo");
        assert_sound(&ui, "shortcuts");
        press(&mut ui, Key::Escape);
        shortcut(&mut ui, Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::O);
        assert_sound(&ui, "path");
        press(&mut ui, Key::Escape);
        shortcut(&mut ui, Modifiers::COMMAND, Key::K);
        assert_sound(&ui, "palette");
        press(&mut ui, Key::Escape);
        shortcut(&mut ui, Modifiers::COMMAND, Key::L);
        assert_sound(&ui, "library");
        press(&mut ui, Key::Escape);
        assert_eq!(ui.state().preferences.present, present);
        if present {
            continue;
        }
        click(&mut ui, "Help");
        click(&mut ui, "The ways to begin");
        assert_sound(&ui, "three ways");
        control(&ui, Role::Button, "Show a class");
        press(&mut ui, Key::Escape);
        click(&mut ui, "Help");
        click(&mut ui, "About and licences");
        assert_named(&ui, "about");
        // Every licence is read to its last letter by the fonts.
        for licence in spectral_explorer::app::licences::all() {
            click(&mut ui, licence.id);
            assert_named(&ui, licence.id);
        }
        press(&mut ui, Key::Escape);
        for menu in ["Open", "Save", "Help", "Layers"] {
            click(&mut ui, menu);
            assert_sound(&ui, menu);
            press(&mut ui, Key::Escape);
        }
        for combo in [
            "Figure of the curve",
            "Set of surfaces",
            "How surfaces are seen",
            "Scale",
            "Observer",
            "How lines are found",
            "Products by",
        ] {
            if combo == "Scale" {
                click(&mut ui, knobs::MORE);
            }
            control(&ui, Role::ComboBox, combo).click();
            ui.run();
            assert_sound(&ui, combo);
            press(&mut ui, Key::Escape);
        }
    }
}

#[test]
fn every_name_in_the_library_can_be_written() {
    let mut ui = fresh();
    ui.state_mut().preferences.folded.clear();
    ui.state_mut().drawer.open = true;
    // Tall enough to show every shelf at once: a glyph that no font has would panic.
    let rows = ui.state().app.bundled().len() as f32;
    ui.set_size(vec2(1280.0, 42.0 * rows + 800.0));
    ui.run();
    let last = ui.state().app.bundled().last().map(|e| e.name().to_owned());
    control(&ui, Role::Button, &last.expect("a library"));
    assert_sound(&ui, "the whole library");
}

#[test]
fn small_and_large_windows_are_drawn() {
    let mut ui = fresh();
    for size in [
        [900.0, 560.0],
        [3840.0, 2160.0],
        [400.0, 300.0],
        [1280.0, 800.0],
    ] {
        give(&mut ui, size.into());
        ui.run();
        assert_sound(&ui, "a window of another size");
    }
    // Nothing is cut off at the usual size.
    let screen = egui::Rect::from_min_size(Pos2::ZERO, vec2(1280.0, 800.0));
    for (role, name) in [
        (Role::Slider, knobs::ORDER),
        (Role::SpinButton, knobs::ORDER_TYPED),
        (Role::Slider, knobs::LINES),
        (Role::SpinButton, knobs::LINES_TYPED),
        (Role::Button, knobs::AUTOMATIC),
        (Role::Button, knobs::RESET),
        (Role::ComboBox, "How surfaces are seen"),
        (Role::ComboBox, "Figure of the curve"),
        (Role::Button, "All figures"),
        (Role::Button, "Help"),
        (Role::Button, "Settings"),
        (Role::Slider, names::WIDTH),
        (Role::SpinButton, names::THRESHOLD),
        (Role::SpinButton, "Range to"),
        (Role::ComboBox, "Products by"),
    ] {
        if name == names::WIDTH {
            click(&mut ui, "Settings");
        }
        let rect = control(&ui, role, name).rect();
        assert!(screen.contains_rect(rect), "{name} is at {rect:?}");
    }
}

// ------------------------------------------------------------------------------------- workspace

#[test]
fn a_window_is_restored_as_it_was_left() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("workspace.json");
    let saver = Saver::new(path.clone());
    let first = Window::new(plain(), Preferences::default(), no_files(), Some(saver));
    let mut ui = at_rest(first);
    drop_file(&mut ui, "lamp.csv", LAMP.as_bytes());
    control(&ui, Role::Slider, knobs::ORDER).set_value_accesskit(11.0);
    ui.run();
    click(&mut ui, "Surroundings");
    ui.run();
    let left = (app(&ui).document().clone(), ui.state().preferences.clone());
    // The saver writes what it was given before it goes.
    drop(ui.into_state());
    let restored = workspace::load(&path).expect("readable").expect("kept");
    let (app_again, preferences, _) = Window::restored(restored);
    assert_eq!((app_again.document(), &preferences), (&left.0, &left.1));
    let again = Window::new(app_again, preferences, no_files(), None);
    let ui = at_rest(again);
    assert_eq!(settings(&ui).order, 11);
    assert_written(&ui, &numbers_words(app(&ui)));
    assert!(!ui.ctx.global_style().visuals.dark_mode);
}

/// The workspace of a file once its order is one; the longest wait is far beyond what a small file
/// takes.
fn kept_order(path: &Path, order: usize) -> bool {
    let until = std::time::Instant::now() + std::time::Duration::from_secs(20);
    while std::time::Instant::now() < until {
        let kept = workspace::load(path).ok().flatten();
        if kept.is_some_and(|kept| kept.document.settings.order == order) {
            return true;
        }
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    false
}

#[test]
fn a_change_is_kept_though_no_further_frame_is_drawn() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("workspace.json");
    let saver = Saver::new(path.clone());
    let first = Window::new(plain(), Preferences::default(), no_files(), Some(saver));
    let mut ui = at_rest(first);
    let moved = Settings {
        order: 23,
        ..settings(&ui)
    };
    ui.state_mut().app.apply(Command::Edit(moved));
    // The last frame before another window covers this one.
    ui.step();
    assert!(kept_order(&path, 23));
    // Covered from now on: the program goes on without a frame.
    let moved = Settings {
        order: 24,
        ..settings(&ui)
    };
    let context = ui.ctx.clone();
    let lamp = folder.path().join("covered.csv");
    fs::write(&lamp, LAMP).expect("a file");
    let window = ui.state_mut();
    window.open_files(vec![lamp], Arc::new(|| {}));
    while window.is_busy() {
        window.unseen(&context);
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    assert_eq!(window.app.document().light.name(), "covered");
    window.app.apply(Command::Edit(moved));
    window.unseen(&context);
    assert!(kept_order(&path, 24));
    let kept = workspace::load(&path).expect("readable").expect("kept");
    assert_eq!(kept.document.light.name(), "covered");
}

#[test]
fn what_could_not_be_restored_is_said_in_the_window() {
    let document = plain().document().clone();
    let text = workspace::to_json(&document, None)
        .unwrap()
        .replace("cie_fluorescent_1nm/FL11", "gone/FL11");
    let restored = workspace::from_json(&text).expect("sound");
    let (app_again, ..) = Window::restored(restored);
    let ui = at_rest(window(app_again, no_files()));
    assert_written(&ui, "gone/FL11");
    assert_eq!(app(&ui).message().map(|m| m.tone), Some(Tone::Problem));
}

// -------------------------------------------------------------------------------------- pictures

/// The window as it looks, without what changes from run to run.
fn picture(name: &str, app: App, preferences: Preferences, size: [f32; 2]) {
    pictured(name, app, preferences, size, Side::Verdict);
}

fn pictured(name: &str, app: App, preferences: Preferences, size: [f32; 2], side: Side) {
    let mut window = Window::new(app, preferences, no_files(), None);
    window.quiet = true;
    window.side = side;
    let mut ui: Ui = Harness::builder()
        .with_size(size)
        .with_step_dt(FRAME)
        .with_max_steps(MOST_FRAMES)
        .with_context_setup(theme::install_fonts)
        .renderer(SoftRenderer::default())
        .build_eframe(|_| Shown(window));
    ui.run();
    ui.run();
    ui.snapshot(name);
}

#[test]
fn the_window_looks_as_it_did_dark() {
    picture("dark", App::new(), Preferences::default(), [1280.0, 800.0]);
}

#[test]
fn the_window_looks_as_it_did_light() {
    let preferences = Preferences {
        dark: false,
        ..Preferences::default()
    };
    picture("light", App::new(), preferences, [1280.0, 800.0]);
}

#[test]
fn the_window_looks_as_it_did_on_a_large_screen() {
    picture("large", plain(), Preferences::default(), [1920.0, 1080.0]);
}

#[test]
fn the_window_looks_as_it_did_presenting() {
    let preferences = Preferences {
        present: true,
        ..Preferences::default()
    };
    picture("present", App::new(), preferences, [1280.0, 800.0]);
}

#[test]
fn the_window_looks_as_it_did_with_every_figure() {
    let size = [1280.0, 800.0];
    pictured(
        "spikes",
        plain(),
        Preferences::default(),
        size,
        Side::Figures,
    );
}

#[test]
fn the_window_looks_as_it_did_with_a_reflectance() {
    let mut app = plain();
    app.apply(light(&app, "cie_illuminants/CIE D65"));
    app.apply(light(&app, "colorchecker_ohta/red"));
    picture("reflectance", app, Preferences::default(), [1280.0, 800.0]);
}

#[test]
fn several_refused_files_are_counted_and_none_is_forgotten() {
    let mut ui = fresh();
    for name in ["first.csv", "second.csv"] {
        let file = FakeFile(PathBuf::from(name), b"no numbers here".to_vec());
        ui.input_mut().dropped_files.push(Arc::new(file));
    }
    ui.run();
    let message = app(&ui).message().expect("what came of them");
    assert_eq!(message.text, "0 of 2 files read; 2 refused.");
    for name in ["first.csv", "second.csv"] {
        assert_written(&ui, &format!("{name}: –, refused: line 1: found"));
    }
}
