//! A second light: chosen, read in a sentence, known to every page, let go of.

use crate::driver::{
    Ui, app, assert_written, at_rest, click, is_written, no_files, wait_until, words,
};
use crate::sizes;
use eframe::egui;
use egui::{Key, Role};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use spectral_explorer::{
    app::{
        App, Command, Document,
        chart::Marks,
        charts::spectrum::spectrum_chart,
        pages::{Beside, Page, PageStates},
        workspace::{Preferences, from_json, to_json},
    },
    ui::Window,
};

const SECOND: &str = "cie_led_1nm/LED-B1";

fn on(page: Page, app: App) -> Ui {
    let preferences = Preferences {
        page,
        greeted: true,
        ..Preferences::default()
    };
    at_rest(Window::new(app, preferences, no_files(), None))
}

/// FL2 beside an LED.
fn compared() -> App {
    let mut app = App::new();
    let second = app.entry(SECOND).expect("shipped");
    app.apply(Command::Compare(Some(second)));
    app
}

fn summary(app: &App) -> String {
    app.compared().expect("two lights").summary.clone()
}

fn press(ui: &mut Ui, key: Key) {
    ui.key_press(key);
    ui.run();
}

#[test]
fn three_acts_choose_a_second_light_and_the_answer_stands_in_a_sentence() {
    for page in [Page::Spectrum, Page::Quality] {
        let mut ui = on(page, App::new());
        // One: the button. Two: a name. Three: the row that it finds.
        click(&mut ui, "+ Compare");
        let search = ui.get_by_role_and_label(Role::TextInput, "Search the library");
        search.click();
        ui.run();
        ui.event(egui::Event::Text("LED-B1".to_owned()));
        ui.run();
        press(&mut ui, Key::Enter);
        let second = app(&ui).document().second.as_ref().expect("chosen");
        assert_eq!(second.key, SECOND);
        assert_eq!(
            app(&ui).document().light.name(),
            "FL2",
            "the first light stays"
        );
        assert!(!ui.state().drawer.open, "what was chosen is to be seen");
        let said = summary(app(&ui));
        assert!(said.contains("shows colours better (Rf "), "{said}");
        assert_written(&ui, &said);
        ui.get_by_role_and_label(Role::Button, "Compared with LED-B1");
    }
}

#[test]
fn the_cross_lets_go_of_it_and_undo_brings_it_back() {
    let mut ui = on(Page::Quality, compared());
    let said = summary(app(&ui));
    assert_written(&ui, &said);
    click(&mut ui, "Compare no more");
    assert!(app(&ui).document().second.is_none() && app(&ui).compared().is_none());
    assert!(!is_written(&ui, &said));
    ui.get_by_role_and_label(Role::Button, "+ Compare");
    click(&mut ui, "Undo");
    assert_eq!(summary(app(&ui)), said);
    assert_written(&ui, &said);
    click(&mut ui, "Redo");
    assert!(app(&ui).document().second.is_none());
}

#[test]
fn escape_closes_the_library_and_leaves_the_second_light_as_it_was() {
    let mut ui = on(Page::Spectrum, compared());
    click(&mut ui, "Compared with LED-B1");
    assert!(ui.state().drawer.open && ui.state().drawer.compares);
    press(&mut ui, Key::Escape);
    assert!(!ui.state().drawer.open);
    let second = app(&ui).document().second.as_ref().expect("kept");
    assert_eq!(second.key, SECOND);
    // The library opened by its own key shows lights again.
    click(&mut ui, "Library: FL2");
    assert!(ui.state().drawer.open && !ui.state().drawer.compares);
}

#[test]
fn the_plot_draws_it_over_the_light_with_an_edge_and_the_surfaces_are_split() {
    let app = compared();
    let chart = spectrum_chart(&app);
    let at = |name: &str| chart.series.iter().position(|series| series.name == name);
    let (first, second) = (at("measured").expect("drawn"), at("LED-B1").expect("drawn"));
    assert!(second > first, "over it");
    let [edge, line] = [second - 1, second].map(|i| match &chart.series[i].marks {
        Marks::Line { points, width, .. } => (points.clone(), *width),
        _ => panic!("a line"),
    });
    assert_eq!(edge.0, line.0);
    assert!(edge.1 > line.1, "the edge is wider");
    let lit = app.surfaces_beside().expect("two lights");
    assert_eq!(lit.len(), 24);
    let ui = on(Page::Spectrum, app);
    assert_written(&ui, "FL2 | LED-B1");
    assert!(!is_written(&ui, "measured | model"));
}

#[test]
fn every_page_about_a_light_names_the_second_one_beside_it() {
    for page in [
        Page::Spectrum,
        Page::Chain,
        Page::Narrow,
        Page::TwoLights,
        Page::Metamers,
        Page::Quality,
        Page::Chromaticity,
        Page::Rendition,
        Page::Mix,
        Page::Solve,
        Page::FromColour,
        Page::Prism,
        Page::Rainbow,
    ] {
        // Chosen in the window: the prism and the rainbow follow the choice.
        let mut ui = on(page, App::new());
        let second = app(&ui).entry(SECOND).expect("shipped");
        ui.state_mut().0.app.apply(Command::Compare(Some(second)));
        ui.run();
        // The chip in the bar is there on every page. What takes longer is waited for.
        wait_until(&mut ui, page.title(), |ui| {
            sizes::words(ui, egui::vec2(1280.0, 800.0))
                .iter()
                .any(|words| words.text.contains("LED-B1") && words.text != "vs LED-B1")
        });
    }
}

#[test]
fn on_the_desk_the_second_light_is_a_colour_to_aim_at() {
    let mut ui = on(Page::Mix, compared());
    let aim = "The colour that is aimed at";
    ui.get_by_role_and_label(Role::ComboBox, aim).click();
    ui.run();
    click(&mut ui, "the colour of LED-B1");
    let wish = &app(&ui).document().pages.solve;
    assert_eq!(wish.light.as_deref(), Some(SECOND));
}

#[test]
fn lights_that_were_found_are_compared_in_a_table_that_sorts_by_what_is_clicked() {
    let mut ui = on(Page::Spectrum, App::new());
    click(&mut ui, "Library: FL2");
    let search = ui.get_by_role_and_label(Role::TextInput, "Search the library");
    search.click();
    ui.run();
    ui.event(egui::Event::Text("fluorescent Ra 90".to_owned()));
    ui.run();
    ui.get_by(|node| {
        let label = node.label();
        label.is_some_and(|label| label.starts_with("Compare the quality of "))
    })
    .click();
    ui.run();
    ui.state_mut().studies.finish();
    ui.run();
    assert_written(&ui, "lights reach 80.");
    let first = |ui: &Ui| {
        let rows = words(ui);
        let rows = rows
            .into_iter()
            .filter(|words| words.matches(", ").count() >= 5);
        rows.map(|row| row.split(", ").map(str::to_owned).collect::<Vec<_>>())
            .next()
            .expect("a row")
    };
    let by_rf = first(&ui);
    click(&mut ui, "Sort by lm/W");
    ui.run();
    let by_light = first(&ui);
    assert_ne!(by_rf[0], by_light[0]);
    let efficacy = |row: &[String]| row.last().and_then(|cell| cell.parse::<f64>().ok());
    assert!(
        efficacy(&by_light) > efficacy(&by_rf),
        "{by_light:?} {by_rf:?}"
    );
}

#[test]
fn a_workspace_keeps_it() {
    let app = compared();
    let text = to_json(app.document(), None).expect("text");
    let read = from_json(&text).expect("a workspace");
    assert!(read.losses.is_empty(), "{:?}", read.losses);
    assert_eq!(&read.document, app.document());
    let again = App::with_document(read.document);
    assert_eq!(summary(&again), summary(&app));
    // One that this version does not have is said to be missing, and nothing else is lost.
    let missing = text.replace(SECOND, "cie_led_1nm/no such lamp");
    let read = from_json(&missing).expect("a workspace");
    assert_eq!(read.losses.len(), 1, "{:?}", read.losses);
    let without = Document {
        second: None,
        ..app.document().clone()
    };
    assert_eq!(read.document, without);
}

#[test]
fn a_surface_is_no_second_light_and_what_is_removed_is_none_any_more() {
    let mut app = App::new();
    let red = app.entry("colorchecker_ohta/red").expect("shipped");
    app.apply(Command::Compare(Some(red)));
    assert!(app.document().second.is_none() && app.undo_words().is_none());
    let led = app.entry(SECOND).expect("shipped").spectrum.clone();
    app.apply(Command::Adopt(vec![led]));
    let own = app.document().own[0].clone();
    let tube = app.entry("cie_fluorescent_1nm/FL2").expect("shipped");
    app.apply(Command::Show(tube));
    app.apply(Command::Compare(Some(own.clone())));
    assert_eq!(app.document().second.as_ref(), Some(&own));
    app.apply(Command::Rename {
        key: own.key.clone(),
        name: "lamp in the hall".to_owned(),
    });
    assert!(summary(&app).contains("lamp in the hall"));
    app.apply(Command::Remove {
        key: own.key.clone(),
    });
    assert!(app.document().second.is_none() && app.compared().is_none());
}

#[test]
fn prism_and_rainbow_send_it_through_as_well() {
    for page in [Page::Prism, Page::Rainbow] {
        let mut ui = on(page, App::new());
        let second = app(&ui).entry(SECOND).expect("shipped");
        ui.state_mut().app.apply(Command::Compare(Some(second)));
        ui.run();
        let pages = &ui.state().app.document().pages;
        let beside = [pages.prism.beside, pages.rainbow.beside];
        assert_eq!(beside, [Beside::Overlaid; 2]);
        click(&mut ui, "Compare no more");
        assert_eq!(ui.state().app.document().pages, PageStates::default());
    }
}

#[test]
fn a_hue_that_is_pointed_at_lights_its_surfaces_up() {
    let mut ui = on(Page::Rendition, App::new());
    let lit = |ui: &Ui| {
        let all = ui.root().children_recursive();
        let fields = all.filter(|node| {
            let node = node.accesskit_node();
            let is_field = node
                .label()
                .is_some_and(|label| label.contains("from its reference"));
            is_field && node.toggled() == Some(egui::accesskit::Toggled::True)
        });
        fields.count()
    };
    assert_eq!(lit(&ui), 0);
    let chart = ui
        .query_all_by_role(Role::Image)
        .find(|node| {
            let label = node.accesskit_node().label();
            label.is_some_and(|label| label.starts_with("Colour vectors"))
        })
        .expect("the large chart")
        .rect();
    // A little to the right of the middle and above it: a warm hue.
    let reach = 0.3 * chart.height();
    ui.hover_at(chart.center() + egui::vec2(0.98 * reach, -0.2 * reach));
    ui.run();
    assert!(lit(&ui) >= 1);
    ui.remove_cursor();
    ui.run();
    assert_eq!(lit(&ui), 0);
}
