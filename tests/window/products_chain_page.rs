//! The parts "Chain" and "Absorption" of the page Products, driven without a display.

use std::sync::Arc;

use crate::driver::{Shown, Ui, about, app, copied, harness, no_files, with};
use crate::plain::plain;
use eframe::egui;
use egui::{Pos2, Role, Vec2, pos2};
use egui_kittest::kittest::Queryable as _;
use spectral_explorer::{
    app::{
        App, Command, Settings,
        chart::Marks,
        charts::products::absorption::{AbsorptionSheet, dip_rows},
        open::resolve,
        pages::Page,
        products::{Link, Products},
        workspace::Preferences,
    },
    spectrum::{Band, Kind, NamedSpectrum, Sampled, Sampling},
    ui::{
        Window,
        pages::products_view::{absorption, chain},
    },
};

const GLASS: &str = "filters_glass_cc0/isuzu IVG550 (Green filter) 2 mm";

fn chained(mut app: App, keys: &[&str]) -> App {
    let chain = keys
        .iter()
        .map(|key| Link::once(Arc::new(resolve(key, None, None).unwrap())))
        .collect();
    app.apply(Command::Products(Products {
        chain,
        ..app.document().products.clone()
    }));
    app
}

fn own(app: &mut App, name: &str, kind: Kind, values: impl Fn(f64) -> f64) {
    let values = Band::VISIBLE.grid().map(values).collect();
    app.apply(Command::Adopt(vec![NamedSpectrum {
        name: name.to_owned(),
        kind,
        unit: String::new(),
        scale: 1.0,
        samples: Sampled::even(380.0, 1.0, values).unwrap(),
        notes: Vec::new(),
        source: String::new(),
    }]));
}

fn all_sorts() -> Vec<(&'static str, App)> {
    let mut dark = plain();
    own(&mut dark, "dark", Kind::Light, |_| 0.0);
    let mut infrared = about("CIE A");
    infrared = with(infrared, |s| s.band = Band::new(800.0, 1000.0).unwrap());
    vec![
        ("spiky", about("FL11")),
        ("smooth", about("CIE D65")),
        ("reflectance", about("colorchecker_ohta/red")),
        ("empty", chained(about("FL2"), &[])),
        ("long", chained(about("FL2"), &[GLASS; 16])),
        ("dark", dark),
        ("infrared", infrared),
        (
            "sun",
            with(
                about("solar_astm_g173/ASTM G173-03 global tilt AM1.5G"),
                |s| {
                    s.dips = true;
                    s.threshold_percent = 0.1;
                    s.max_width_nm = 4.5;
                },
            ),
        ),
    ]
}

fn open(app: App, page: Page, size: [f32; 2]) -> Ui {
    let preferences = Preferences {
        page,
        ..Preferences::default()
    };
    let window = Window::new(app, preferences, no_files(), None);
    let mut ui = harness(Shown(window), size, 0.05, 40);
    ui.run();
    ui
}

fn unfold(ui: &mut Ui, fold: &str) {
    ui.get_by_label(fold).click();
    // It opens in a moment.
    for _ in 0..8 {
        ui.run();
    }
}

/// Brings what an open fold shows below the edge into view.
fn scroll_to(ui: &mut Ui, role: Role, name: &str) {
    ui.get_by_role_and_label(role, name).scroll_to_me();
    for _ in 0..40 {
        ui.step();
    }
}

fn order(ui: &Ui) -> Vec<String> {
    let chain = &app(ui).document().products.chain;
    chain
        .iter()
        .map(|link| link.entry.name().to_owned())
        .collect()
}

fn card(ui: &Ui, start: &str) -> egui::Rect {
    ui.get_by(|node| {
        node.role() == Role::Button && node.label().is_some_and(|label| label.starts_with(start))
    })
    .rect()
}

fn drag(ui: &mut Ui, from: Pos2, to: Pos2) {
    ui.hover_at(from);
    ui.run();
    ui.drag_at(from);
    ui.run();
    for share in [0.3, 0.7, 1.0] {
        ui.hover_at(from + share * (to - from));
        ui.run();
    }
    ui.drop_at(to);
    ui.run();
}

#[test]
fn both_parts_open_on_whatever_there_is_in_small_and_large_windows() {
    for (_, app) in all_sorts() {
        for page in [Page::Chain, Page::Absorption] {
            for size in [[1280.0, 800.0], [1920.0, 1080.0], [900.0, 500.0]] {
                open(app.clone(), page, size);
            }
        }
    }
}

#[test]
fn a_card_is_dragged_behind_another_and_undo_brings_it_back() {
    let keys = [GLASS, "colorchecker_ohta/red", "colorchecker_ohta/cyan"];
    let mut ui = open(chained(about("FL2"), &keys), Page::Chain, [1280.0, 900.0]);
    let before = order(&ui);
    let (first, last) = (card(&ui, "Stage 1:"), card(&ui, "Stage 3:"));
    let from = pos2(first.left() + 12.0, first.top() + 14.0);
    drag(&mut ui, from, pos2(last.right() - 4.0, from.y));
    assert_eq!(
        order(&ui),
        [&before[1], &before[2], &before[0]].map(Clone::clone)
    );
    ui.state_mut().0.app.apply(Command::Undo);
    ui.run();
    assert_eq!(order(&ui), before);
    // Let go where it was, it stays.
    drag(&mut ui, from, from + Vec2::new(20.0, 0.0));
    assert_eq!(order(&ui), before);
}

#[test]
fn arrows_move_a_stage_and_the_drawn_spectrum_goes_with_it() {
    let keys = [GLASS, "colorchecker_ohta/red"];
    let mut ui = open(chained(about("FL2"), &keys), Page::Chain, [1280.0, 800.0]);
    let place = card(&ui, "Stage 1:");
    let click = pos2(place.left() + 30.0, place.top() + 14.0);
    ui.hover_at(click);
    ui.drag_at(click);
    ui.drop_at(click);
    ui.run();
    let memory = |ui: &Ui| ui.state().0.app.document().pages.chain;
    assert_eq!(memory(&ui).stage, Some(0));
    ui.get_by_label("Move down stage 1").click();
    ui.run();
    assert_eq!(order(&ui)[1], "isuzu IVG550 (Green filter) 2 mm");
    assert_eq!(memory(&ui).stage, Some(1));
    ui.get_by_label("Remove stage 1").click();
    ui.run();
    assert_eq!(order(&ui).len(), 1);
}

#[test]
fn a_glass_of_2_mm_is_typed_in_mm_and_bounces_in_times() {
    let mut ui = open(
        chained(about("FL2"), &[GLASS]),
        Page::Chain,
        [1280.0, 800.0],
    );
    for (name, typed) in [("Thickness of stage 1", "5"), ("Bounces of stage 1", "3")] {
        ui.get_by_role_and_label(Role::SpinButton, name).click();
        ui.run();
        ui.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::A);
        ui.event(egui::Event::Text(typed.into()));
        ui.run();
        ui.key_press(egui::Key::Enter);
        ui.run();
    }
    let link = &app(&ui).document().products.chain[0];
    assert_eq!((link.thickness, link.bounces), (2.5, 3));
}

#[test]
fn the_ways_of_forming_are_those_of_the_settings() {
    let mut ui = open(about("FL2"), Page::Chain, [1280.0, 1400.0]);
    unfold(&mut ui, chain::names::MODEL);
    scroll_to(&mut ui, Role::ComboBox, chain::names::WAY);
    ui.get_by_role_and_label(Role::ComboBox, chain::names::WAY)
        .click();
    ui.run();
    ui.get_by_role_and_label(Role::Button, "paper's points")
        .click();
    ui.run();
    assert_eq!(app(&ui).document().settings.sampling, Sampling::Paper);
}

#[test]
fn stages_and_spikes_are_copied_as_tables() {
    let mut ui = open(about("FL2"), Page::Chain, [1280.0, 1400.0]);
    unfold(&mut ui, chain::names::MODEL);
    scroll_to(&mut ui, Role::Button, chain::names::COPY_STAGES);
    let stages = copied(&mut ui, chain::names::COPY_STAGES).expect("a table");
    let rows: Vec<&str> = stages.lines().filter(|l| !l.starts_with('#')).collect();
    assert_eq!(rows.len(), 1 + 1 + 2, "{stages}");
    let cells = rows[0].split(',').count();
    assert!(
        rows.iter().all(|row| row.split(',').count() == cells),
        "{stages}"
    );
    scroll_to(&mut ui, Role::Button, chain::names::COPY_SPIKES);
    let spikes = copied(&mut ui, chain::names::COPY_SPIKES).expect("a table");
    assert!(spikes.contains("Hg 435.8"), "{spikes}");
    assert!(spikes.contains("# behind: light skin"), "{spikes}");
}

#[test]
fn what_goes_wrong_at_a_stage_is_told_on_its_card() {
    // Fifteen numbers of a glass that is black at 404.9 nm ring below zero there.
    let app = with(chained(about("FL2"), &[GLASS]), |s| {
        *s = Settings {
            sampling: Sampling::Double,
            ..Settings::plain()
        }
    });
    let ui = open(app, Page::Chain, [1280.0, 800.0]);
    ui.get_by_label_contains("turns the line there negative");
}

#[test]
fn an_example_of_the_sun_is_one_click_and_its_lines_have_their_names() {
    let mut ui = open(about("FL11"), Page::Absorption, [1280.0, 800.0]);
    // What is not searched itself shows the first example, and the light stays.
    ui.get_by_label_contains("An example. In FL11:");
    ui.get_by_label_contains("named");
    assert_eq!(app(&ui).document().light.name(), "FL11");
    ui.get_by_label("Sun on the ground").click();
    ui.run();
    assert!(app(&ui).document().settings.dips);
    let rows = dip_rows(app(&ui));
    let sheet = AbsorptionSheet::of(app(&ui));
    let known = sheet.known.iter().map(|line| line.name);
    let dips = rows.iter().filter_map(|d| d.name.as_deref());
    let named: Vec<&str> = dips.chain(known).collect();
    for name in [
        "G band 430.8",
        "Mg b 517-518",
        "H-alpha 656.3",
        "O2 A 759-762",
    ] {
        assert!(named.contains(&name), "{name}: {named:?}");
    }
    for row in &rows {
        let depth = row.depth.expect("a depth");
        assert!((0.0..=1.0).contains(&depth) && row.spike.weight < 0.0);
    }
    unfold(&mut ui, absorption::names::ALL);
    scroll_to(&mut ui, Role::Button, absorption::names::COPY);
    let table = copied(&mut ui, absorption::names::COPY).expect("a table");
    assert!(
        table.contains("place nm,weight,depth,name,below zero"),
        "{table}"
    );
    assert!(table.contains("Mg b 517-518"), "{table}");
}

#[test]
fn known_lines_of_the_sun_are_named_at_their_places_and_no_other_dip_is() {
    // Fraunhofer's lines in air, nm: NIST Atomic Spectra Database.
    let places = [
        ("Ca K 393.4", 393.37),
        ("H-beta 486.1", 486.13),
        ("Na D 589.3", 589.3),
        ("H-alpha 656.3", 656.28),
    ];
    for example in ["Sun on the ground", "Sun in space"] {
        let mut ui = open(about("FL11"), Page::Absorption, [1280.0, 800.0]);
        ui.get_by_label(example).click();
        ui.run();
        unfold(&mut ui, absorption::names::ALL);
        let sheet = AbsorptionSheet::of(app(&ui));
        let dips = sheet.dips.iter();
        let dips = dips.filter_map(|dip| Some((dip.name.clone()?, dip.spike.at_nm)));
        let known = sheet
            .known
            .iter()
            .map(|line| (line.name.to_owned(), line.at_nm()));
        let named: Vec<(String, f64)> = dips.chain(known).collect();
        for (name, nm) in places {
            let found = named.iter().find(|(one, _)| one == name);
            let at = found
                .unwrap_or_else(|| panic!("{example}: {name} in {named:?}"))
                .1;
            // The tables have steps of half a nanometre.
            assert!((at - nm).abs() <= 1.0, "{example}: {name} at {at}");
            ui.get_by_label_contains(&format!(", {name}"));
        }
        let labels = |series: &str| -> Vec<String> {
            let found = sheet.chart.series.iter().find(|one| one.name == series);
            match found.map(|one| &one.marks) {
                Some(Marks::Stems { labels, .. }) => labels.clone(),
                _ => panic!("{example}: {series}"),
            }
        };
        for (label, dip) in labels("dark lines").iter().zip(&sheet.dips) {
            assert_eq!(*label, dip.name.clone().unwrap_or_default(), "{example}");
        }
        // Iron's line at 407.2 is none of hydrogen.
        let beside = sheet
            .dips
            .iter()
            .find(|d| (d.spike.at_nm - 407.5).abs() < 0.6);
        assert!(beside.is_none_or(|dip| dip.name.is_none()), "{beside:?}");
    }
}

#[test]
fn every_example_is_there_and_shows_dips_that_have_names() {
    let titles = [
        "Sun on the ground",
        "Sun in space",
        "Holmium oxide",
        "Neodymium lamp",
    ];
    for title in titles {
        let mut ui = open(about("FL11"), Page::Absorption, [1280.0, 800.0]);
        ui.get_by_label(title).click();
        ui.run();
        let rows = dip_rows(app(&ui));
        let named = rows.iter().filter(|d| d.name.is_some()).count();
        println!(
            "{title}: {:?}",
            rows.iter()
                .map(|d| (d.spike.at_nm.round(), d.name.as_deref().unwrap_or("-")))
                .collect::<Vec<_>>()
        );
        assert!(named > 0, "{title}: {rows:?}");
        let chart = AbsorptionSheet::of(app(&ui)).chart;
        assert!(
            !chart
                .to_svg(800, 400, spectral_explorer::app::chart::Theme::Dark)
                .contains("NaN")
        );
    }
}

#[test]
fn a_line_on_a_dip_is_told_in_a_sentence_and_a_dip_below_zero_is_warned_of() {
    let mut app = with(about("FL2"), |s| {
        s.dips = true;
        s.sampling = Sampling::Double;
    });
    own(&mut app, "notch", Kind::Transmittance, |nm| {
        0.9 - 0.8 * (-((nm - 578.0) / 3.0).powi(2)).exp()
    });
    let notch = app.document().own.last().unwrap().clone();
    app.apply(Command::Products(Products {
        chain: vec![Link::once(notch)],
        ..app.document().products.clone()
    }));
    let ui = open(app.clone(), Page::Absorption, [1280.0, 800.0]);
    ui.get_by_label_contains("FL2 in notch: the line at 57");
    // The mean alone is far below the hill that the dip is cut into.
    own(&mut app, "gap", Kind::Light, |nm| {
        let hill = 0.1 + (-((nm - 545.0) / 35.0).powi(2)).exp();
        hill * (1.0 - 0.9 * (-((nm - 545.0) / 2.4).powi(2)).exp())
    });
    let app = with(app, |s| s.order = 0);
    let rows = dip_rows(&app);
    assert!(rows.iter().any(|row| row.below_zero), "{rows:?}");
    let ui = open(app, Page::Absorption, [1280.0, 800.0]);
    ui.get_by_label_contains("goes below zero at");
}
