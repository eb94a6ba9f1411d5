//! The pages about the paper: how X, Y, Z add up, and what becomes of its claims.

use std::sync::Arc;

use crate::driver::{Shown, Ui, about, copied, harness, no_files, with};
use eframe::egui;
use egui::Role;
use egui_kittest::kittest::Queryable as _;
use spectral_explorer::{
    app::{
        App, Command, Settings,
        charts::{
            coefficients::{CoefficientCharts, Sight},
            truth::{neglected_chart, samples_chart, table_2_chart},
        },
        open::resolve,
        pages::Page,
        studies::paper::{Claims, Verdict, copied_table, harmonics_of, truth_table},
        workspace::Preferences,
    },
    spectrum::{Band, Basis},
    ui::{
        Window,
        pages::{coefficients_view::names, truth_view::COPY},
    },
};

/// A program as the paper has it: a plain Fourier series.
fn plain(key: &str) -> App {
    with(about(key), |s| *s = Settings::plain())
}

/// Everything that the pages may be opened on.
fn all_sorts() -> Vec<(&'static str, App)> {
    let band = |min, max| Band::new(min, max).unwrap();
    let mut reflectance = plain("FL11");
    let orange = resolve("colorchecker_ohta:orange", None, None)
        .or_else(|_| resolve("orange", None, None))
        .unwrap();
    reflectance.apply(Command::Show(Arc::new(orange)));
    assert!(!reflectance.document().is_about_light());
    vec![
        ("as it starts", App::new()),
        ("spiky", plain("FL11")),
        ("smooth", plain("CIE D65")),
        ("cosine", with(about("FL2"), |s| s.basis = Basis::Cosine)),
        ("order 0", with(plain("FL2"), |s| s.order = 0)),
        ("order 100", with(plain("FL2"), |s| s.order = 100)),
        ("short", with(plain("FL2"), |s| s.band = band(540.0, 560.0))),
        (
            "dark",
            with(plain("FL11"), |s| s.band = band(2000.0, 2400.0)),
        ),
        (
            "infrared",
            with(plain("CIE A"), |s| s.band = band(800.0, 1000.0)),
        ),
        ("reflectance", reflectance),
    ]
}

#[test]
fn the_paper_misprints_eq_7_so_that_illuminant_c_leaves_its_place() {
    let claims = Claims::of(&with(plain("CIE C"), |s| {
        s.band = Band::PAPER;
        s.order = 20;
    }));
    let found = claims.eq_7.unwrap();
    // Known to three decimals; the series of order 20 has the colour to four.
    for (is, should) in [
        (found.printed.expect("a colour"), [0.289, 0.301]),
        (found.corrected, [0.310, 0.317]),
    ] {
        for k in 0..2 {
            assert!((is[k] - should[k]).abs() < 1.5e-3, "{is:?} {should:?}");
        }
    }
}

#[test]
fn every_claim_has_a_verdict_and_a_figure_on_whatever_is_open() {
    for (what, app) in all_sorts() {
        let claims = Claims::of(&app);
        let rows = truth_table(&claims);
        assert_eq!(rows.len(), 6, "{what}");
        for row in &rows {
            assert!(!row.verdict_words().is_empty() && !row.paper.is_empty());
            assert!(
                row.verdict == Verdict::Open || !row.measured.is_empty(),
                "{what}"
            );
            assert!(
                row.verdict != Verdict::Open || !row.condition.is_empty(),
                "{what}"
            );
        }
        let csv = copied_table(&app, &claims).csv();
        assert!(csv.contains("\nclaim,paper,measured,verdict\n"), "{what}");
        assert_eq!(
            csv.lines().filter(|l| !l.starts_with('#')).count(),
            1 + 6,
            "{what}"
        );
        for word in ["NaN", "inf,", " inf "] {
            assert!(!csv.contains(word), "{what}: {csv}");
        }
    }
}

#[test]
fn charts_of_both_pages_hold_no_number_that_is_none() {
    for (what, app) in all_sorts() {
        let harmonics = harmonics_of(&app);
        for channel in 0..3 {
            let sight = Sight {
                channel,
                partial_order: 4,
                pointed: Some(2),
            };
            let charts = CoefficientCharts::of(&app, &harmonics, sight);
            let CoefficientCharts {
                partial,
                light,
                weight,
                product,
                running,
                neglected,
            } = &charts;
            let bars = [light, weight, product, running, neglected];
            for chart in bars.into_iter().flatten().chain([partial]) {
                assert!(!chart.to_csv().contains("NaN"), "{what}: {}", chart.title);
                assert!(
                    !chart
                        .to_svg(640, 300, spectral_explorer::app::chart::Theme::Dark)
                        .contains("NaN"),
                    "{what}: {}",
                    chart.title
                );
            }
        }
        let claims = Claims::of(&app);
        for draw in [neglected_chart, samples_chart, table_2_chart] {
            if let Some(chart) = draw(&app, &claims) {
                assert!(
                    !chart
                        .to_svg(640, 300, spectral_explorer::app::chart::Theme::Dark)
                        .contains("NaN"),
                    "{what}: {}",
                    chart.title
                );
            }
        }
    }
}

#[test]
fn bars_come_with_eq_10_only_where_it_is_about_them() {
    let has_fit = |app: &App| {
        let sight = Sight {
            channel: 1,
            partial_order: 3,
            pointed: None,
        };
        let charts = CoefficientCharts::of(app, &harmonics_of(app), sight);
        let chart = charts.weight.unwrap();
        chart.series.iter().any(|s| s.name.contains("Eq. 10"))
    };
    let kinds: Vec<(&str, bool)> = all_sorts()
        .iter()
        .filter(|(what, _)| ["spiky", "cosine", "reflectance"].contains(what))
        .map(|(what, app)| (*what, has_fit(app)))
        .collect();
    let expected = [("spiky", true), ("cosine", false), ("reflectance", false)];
    assert_eq!(kinds, expected);
}

/// Time of the program between two frames, s.
const FRAME: f32 = 0.05;

fn open(app: App, page: Page, size: [f32; 2]) -> Ui {
    let preferences = Preferences {
        page,
        ..Preferences::default()
    };
    let window = Window::new(app, preferences, no_files(), None);
    let mut ui = harness(Shown(window), size, FRAME, 40);
    ui.run();
    ui
}

fn partial_order(ui: &Ui) -> usize {
    ui.state().0.app.document().pages.why.partial_order
}

#[test]
fn the_partial_sum_moves_by_keys_and_becomes_the_model_only_when_asked() {
    let mut ui = open(about("FL11"), Page::Coefficients, [1280.0, 800.0]);
    let before = ui.state().0.app.document().settings.order;
    ui.get_by_role_and_label(Role::Slider, names::PARTIAL)
        .focus();
    ui.run();
    ui.key_press(egui::Key::ArrowRight);
    ui.run();
    assert_eq!(partial_order(&ui), 4);
    assert_eq!(ui.state().0.app.document().settings.order, before);
    ui.get_by_label("Use N = 4").click();
    ui.run();
    assert_eq!(ui.state().0.app.document().settings.order, 4);
}

#[test]
fn playing_adds_two_orders_a_second_and_ends_at_the_model() {
    let mut ui = open(about("FL11"), Page::Coefficients, [1280.0, 800.0]);
    ui.get_by_label(names::PLAY).click();
    // A little over a second.
    ui.run_steps(24);
    assert_eq!(partial_order(&ui), 5);
    ui.get_by_label(names::STOP).click();
    ui.run_steps(30);
    assert_eq!(partial_order(&ui), 5);
    ui.get_by_label(names::PLAY).click();
    ui.run_steps(80);
    assert_eq!(partial_order(&ui), 7);
    ui.get_by_label(names::PLAY);
}

#[test]
fn pointing_at_a_bar_tells_its_order_and_a_click_takes_the_sum_there() {
    let mut ui = open(plain("FL11"), Page::Coefficients, [1920.0, 1600.0]);
    ui.get_by_label(names::ORDERS).click();
    // It opens in a moment.
    for _ in 0..8 {
        ui.run();
    }
    // Its bars are below the edge.
    ui.get_by_role_and_label(Role::Image, "Coefficients of the light")
        .scroll_to_me();
    for _ in 0..40 {
        ui.step();
    }
    let rect = ui
        .get_by_role_and_label(Role::Image, "Coefficients of the light")
        .rect();
    // Order 20 stands 0.6 of an order from the right, its bar somewhere around the middle.
    let x = rect.right() - 0.6 / 21.2 * rect.width();
    let mut y = rect.top() + 8.0;
    while partial_order(&ui) == 3 && y < rect.bottom() {
        ui.hover_at(egui::pos2(x, y));
        ui.run();
        ui.drag_at(egui::pos2(x, y));
        ui.drop_at(egui::pos2(x, y));
        ui.run();
        y += 8.0;
    }
    assert_eq!(partial_order(&ui), 20);
    // The release took the pointer away.
    ui.hover_at(egui::pos2(x, y - 9.0));
    ui.run_steps(3);
    // Its figures are told, and its curve is drawn with the sum.
    ui.get_by_label("Order 20, under the pointer");
}

#[test]
fn the_whole_page_is_copied_as_a_table() {
    let mut ui = open(about("FL2"), Page::Truth, [1280.0, 800.0]);
    // It stands below the claims.
    ui.get_by_role_and_label(Role::Button, COPY).scroll_to_me();
    for _ in 0..40 {
        ui.step();
    }
    let table = copied(&mut ui, COPY).expect("a table");
    assert!(table.contains("claim,paper,measured,verdict"));
}
