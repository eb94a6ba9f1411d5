//! The parts "Resampling", "Bounces" and "Narrow filters" of the page "Products".

use std::{sync::Arc, time::Duration};

use crate::driver::{Shown, Ui, about, copied, harness, no_files, with};
use eframe::egui;
use egui::Role;
use egui_kittest::kittest::Queryable as _;
use spectral_explorer::{
    app::{
        App, Command, Entry,
        chart::{Chart, Series},
        charts::products::{
            bounces::Bounced,
            narrow::{Behind, Filter, WAYS, of},
            resampling::Bench,
        },
        open::resolve,
        pages::{NarrowMemory, Page},
        products::Products,
        studies::TimingAsk,
        workspace::Preferences,
    },
    spectrum::{Band, Basis, Kind, NamedSpectrum, Sampled, Sampling},
    ui::{
        Window,
        pages::products_view::{bounces, narrow, resampling},
        picture::window_image,
    },
};

/// Everything that the parts may be opened on.
fn all_sorts() -> Vec<(&'static str, App)> {
    let band = |min, max| Band::new(min, max).unwrap();
    let mut reflectance = about("FL11");
    let orange = resolve("colorchecker_ohta:orange", None, None)
        .or_else(|_| resolve("orange", None, None))
        .unwrap();
    reflectance.apply(Command::Show(Arc::new(orange)));
    let mut nothing = about("FL11");
    nothing.apply(Command::Products(Products::default()));
    vec![
        ("spiky", about("FL11")),
        ("smooth", about("CIE D65")),
        ("cosine", with(about("FL2"), |s| s.basis = Basis::Cosine)),
        ("order 0", with(about("FL2"), |s| s.order = 0)),
        ("order 40", with(about("FL2"), |s| s.order = 40)),
        ("short", with(about("FL2"), |s| s.band = band(540.0, 560.0))),
        (
            "dark",
            with(about("FL11"), |s| s.band = band(2000.0, 2400.0)),
        ),
        (
            "infrared",
            with(about("CIE A"), |s| s.band = band(800.0, 1000.0)),
        ),
        ("reflectance", reflectance),
        ("nothing chosen", nothing),
    ]
}

fn surface(app: &App) -> Arc<spectral_explorer::app::Entry> {
    let chosen = app.document().products.surface.clone();
    chosen.unwrap_or_else(|| Products::first().surface.expect("shipped"))
}

fn assert_sound(what: &str, chart: &Chart) {
    let svg = chart.to_svg(640, 300, spectral_explorer::app::chart::Theme::Dark);
    assert!(!svg.contains("NaN"), "{what}: {}", chart.title);
    let csv = chart.to_csv();
    assert!(!csv.contains("NaN"), "{what}: {}", chart.title);
}

#[test]
fn charts_and_tables_hold_no_number_that_is_none() {
    for (what, app) in all_sorts() {
        let surface = surface(&app);
        let bench = Bench::of(&app, &surface);
        assert_sound(what, &bench.chart(&app, &[]));
        assert_sound(what, &bench.chart(&app, &Sampling::ALL));
        let bounced = Bounced::of(&app, &surface);
        for (added, log) in [(false, true), (true, true), (true, false)] {
            assert_sound(what, &bounced.chart(&app, added, log));
            assert!(!bounced.sentence(added).contains("NaN"));
        }
        let behind = Behind::of(&app);
        let rows = behind.table(&app);
        assert!(rows.len() > 20, "the shipped glasses");
        let filters = [
            Filter::Gaussian {
                centre_nm: 546.0,
                width_nm: 10.0,
            },
            Filter::Real(rows[0].entry.clone()),
        ];
        let curve = behind.curve(10.0);
        for filter in filters {
            assert_sound(what, &behind.light_chart(&app, &filter));
            behind.swatches(&behind.figures(&filter));
        }
        for luminance in [false, true] {
            let marked = Some(500.0);
            let chart = behind.error_chart(&app, &curve, luminance, 10.0, marked);
            assert_sound(what, &chart);
        }
        for csv in [
            bench.table(&app, None).csv(),
            bench.spikes_table(&app).csv(),
            bounced.table(&app).csv(),
            behind.filters_table(&app, &rows).csv(),
        ] {
            for word in ["NaN", "inf"] {
                let table = csv.lines().filter(|l| !l.starts_with('#'));
                assert!(!table.clone().any(|l| l.contains(word)), "{what}: {csv}");
            }
        }
    }
}

#[test]
fn a_dip_of_the_surface_gives_no_line_of_the_light_another_width() {
    let band = Band::VISIBLE;
    let nm: Vec<f64> = band.grid().collect();
    let dip = |nm: &f64| 0.8 - 0.6 * (-0.5 * ((nm - 420.0) / 3.0).powi(2)).exp();
    let leaf = NamedSpectrum {
        name: "a dip".to_owned(),
        kind: Kind::Reflectance,
        samples: Sampled::new(nm.clone(), nm.iter().map(dip).collect()).unwrap(),
        ..surface(&about("FL11")).spectrum.clone()
    };
    let app = with(about("FL11"), |s| s.dips = true);
    let bench = Bench::of(&app, &Entry::own(1, leaf));
    let spikes = &bench.resampled.ways[0].step.spikes;
    let chart = bench.chart(&app, &[]);
    let named = |series: &&Series| series.name == "spikes × factor";
    let stems = chart.series.iter().find(named).expect("stems");
    assert!(
        spikes.len() > app.derived().model.lines().len(),
        "a dip is one more"
    );
    for (spike, tip) in spikes.iter().zip(stems.marks.points()) {
        let width_nm = app.derived().stem_width_at(spike.at_nm);
        let base = band.interpolate(&bench.resampled.series_product, spike.at_nm);
        let height = spike.stem_height(width_nm);
        assert!(
            (tip[1] - base - height).abs() < 1e-9 * height.abs(),
            "{spike:?}"
        );
    }
}

#[test]
fn only_enough_points_add_nothing_to_a_product() {
    let app = about("FL11");
    let bench = Bench::of(&app, &surface(&app));
    let added = |sampling| {
        let way = bench.resampled.ways.iter().find(|w| w.sampling == sampling);
        way.and_then(|way| way.step.added).expect("a colour")
    };
    assert!(added(Sampling::Paper) > 0.1);
    assert!(added(Sampling::ThreeN) < 0.1 * added(Sampling::Paper));
    // Sums of some dozen products.
    assert!(added(Sampling::FourN) < 1e-9);
    assert!(added(Sampling::Double) < 1e-9);
}

#[test]
fn behind_narrow_filters_spikes_are_worth_more_than_orders_to_a_lamp_of_lines() {
    for key in ["FL11", "FL2"] {
        let app = with(about(key), |s| s.order = 10);
        let behind = Behind::of(&app);
        let mean = |way: usize| {
            let errors: Vec<f64> = behind
                .curve(10.0)
                .iter()
                .filter(|point| (420.0..=670.0).contains(&point.centre_nm))
                .filter_map(|point| of(point, way).delta_e_2000)
                .collect();
            errors.iter().sum::<f64>() / errors.len() as f64
        };
        let [composite, series, samples] = [0, 1, 2].map(mean);
        println!("{key}: {composite:.2} {series:.2} {samples:.2}");
        // Samples that happen to stand near the lines may do as well as either.
        assert!(composite < series && samples > 0.0, "{key}");
    }
}

fn preferences(page: Page) -> Preferences {
    Preferences {
        page,
        ..Preferences::default()
    }
}

fn window(app: App, page: Page, size: [f32; 2], quiet: bool) -> Ui {
    let mut window = Window::new(app, preferences(page), no_files(), None);
    window.quiet = quiet;
    harness(Shown(window), size, 0.05, 60)
}

fn open(app: App, page: Page, size: [f32; 2]) -> Ui {
    let mut ui = window(app, page, size, true);
    settled(&mut ui);
    ui
}

/// Runs until nothing is being computed any more.
fn settled(ui: &mut Ui) {
    for _ in 0..1000 {
        ui.step();
        if !ui.state_mut().0.studies.is_running() {
            break;
        }
        std::thread::sleep(Duration::from_millis(10));
    }
    ui.run();
}

const LARGE: [f32; 2] = [1920.0, 1080.0];

#[test]
fn a_click_on_a_way_forms_all_products_so_and_undo_takes_it_back() {
    for page in [Page::Resampling, Page::Bounces] {
        let mut ui = open(about("FL11"), page, LARGE);
        let row = |label: &str| label.starts_with("3N+1 points: ");
        ui.get_by_role_and_label(Role::Button, &label_of(&ui, row))
            .click();
        settled(&mut ui);
        let sampling = |ui: &Ui| ui.state().0.app.document().settings.sampling;
        assert_eq!(sampling(&ui), Sampling::ThreeN);
        ui.state_mut().0.app.apply(Command::Undo);
        settled(&mut ui);
        assert_eq!(sampling(&ui), Sampling::Exact);
    }
}

/// The first label of a button that answers to a description.
fn label_of(ui: &Ui, wanted: impl Fn(&str) -> bool) -> String {
    use egui_kittest::kittest::NodeT as _;
    let buttons = ui.get_all_by_role(Role::Button);
    let mut labels = buttons.filter_map(|node| node.accesskit_node().label());
    labels.find(|label| wanted(label)).expect("such a button")
}

#[test]
fn a_way_that_is_not_wanted_leaves_the_chart_and_comes_back() {
    let mut ui = open(about("FL11"), Page::Resampling, LARGE);
    let hidden = |ui: &Ui| {
        let pages = &ui.state().0.app.document().pages;
        pages.resampling.hidden.clone()
    };
    for expected in [vec![Sampling::Convolution], vec![]] {
        ui.get_by_role_and_label(Role::CheckBox, "cut convolution")
            .click();
        ui.run();
        assert_eq!(hidden(&ui), expected);
    }
}

#[test]
fn times_are_measured_in_the_window_and_again_when_asked_and_never_for_a_picture() {
    let mut ui = window(about("FL11"), Page::Resampling, LARGE, false);
    settled(&mut ui);
    let turn = |ui: &mut Ui| {
        let (ask, times) = ui
            .state_mut()
            .0
            .studies
            .of::<TimingAsk>()
            .answer()
            .expect("measured");
        assert_eq!(times.len(), Sampling::ALL.len());
        ask.turn
    };
    let first = turn(&mut ui);
    ui.get_by_label(resampling::names::AGAIN).click();
    ui.run_steps(2);
    settled(&mut ui);
    assert_eq!(turn(&mut ui), first + 1);
    let mut ui = open(about("FL11"), Page::Resampling, LARGE);
    assert!(
        ui.state_mut()
            .0
            .studies
            .of::<TimingAsk>()
            .answer()
            .is_none()
    );
    let picture = || window_image(&about("FL11"), &preferences(Page::Resampling), [1280, 800]);
    assert!(picture() == picture());
}

#[test]
fn every_table_is_copied() {
    for (page, button, head) in [
        (Page::Resampling, resampling::names::COPY, "way,points,"),
        (
            Page::Resampling,
            resampling::names::COPY_SPIKES,
            "at_nm,weight,",
        ),
        (Page::Bounces, bounces::names::COPY, "way,bounces,"),
        (Page::Narrow, narrow::names::COPY, "filter,luminance_share,"),
    ] {
        let mut ui = open(about("FL11"), page, LARGE);
        let text = copied(&mut ui, button).expect("a table");
        assert!(text.lines().any(|line| line.starts_with(head)), "{text}");
    }
}

#[test]
fn bounces_are_told_in_total_and_as_added() {
    let mut ui = open(about("CIE D65"), Page::Bounces, LARGE);
    ui.get_by_label(bounces::names::ADDED).click();
    ui.run();
    let memory = ui.state().0.app.document().pages.bounces;
    assert!(memory.added && memory.log);
    let bounced = Bounced::of(&ui.state().0.app, &surface(&ui.state().0.app));
    // At 1 nm nothing is added, so that way stays below 1 through all bounces.
    let exact = bounced
        .ways
        .iter()
        .position(|w| w.sampling == Sampling::Exact);
    let stays = bounced.stays(true)[exact.expect("every way")];
    assert_eq!(stays, (16, 16));
    assert!(bounced.sentence(true).contains("through all 16 bounces"));
}

fn narrow_memory(ui: &Ui) -> NarrowMemory {
    ui.state().0.app.document().pages.narrow.clone()
}

#[test]
fn the_band_pass_moves_by_its_slider_and_by_hand() {
    let mut ui = open(about("FL11"), Page::Narrow, LARGE);
    ui.get_by_role_and_label(Role::Slider, narrow::names::CENTRE)
        .set_value_accesskit(600.0);
    ui.run();
    assert_eq!(narrow_memory(&ui).centre_nm, 600.0);
    let rect = ui
        .get_by_role_and_label(Role::Image, "The light and the filter over it")
        .rect();
    // The frame ends at the right of the image; 380 nm stands somewhere right of its left.
    let from = egui::pos2(rect.center().x, rect.center().y);
    ui.hover_at(from);
    ui.run();
    ui.drag_at(from);
    ui.run();
    ui.hover_at(from + egui::vec2(60.0, 0.0));
    ui.run();
    ui.drop_at(from + egui::vec2(60.0, 0.0));
    ui.run();
    let moved = narrow_memory(&ui);
    assert_ne!(moved.centre_nm, 600.0);
    assert_eq!(moved.width_nm, 10.0);
    // The middle of the panel is near the middle of the band; 60 points right are some 30 nm.
    assert!((590.0..650.0).contains(&moved.centre_nm), "{moved:?}");
}

#[test]
fn an_edge_of_the_band_pass_makes_it_wider() {
    let mut app = about("FL11");
    app.pages_follow(|pages| (pages.narrow.centre_nm, pages.narrow.width_nm) = (580.0, 100.0));
    let mut window = Window::new(app, preferences(Page::Narrow), no_files(), None);
    window.quiet = true;
    let mut ui = harness(Shown(window), LARGE, 0.05, 60);
    ui.run();
    let name = "The light and the filter over it";
    let rect = ui.get_by_role_and_label(Role::Image, name).rect();
    // Looking for the right edge by its hand: 630 nm is at 62 % of the frame.
    let mut x = rect.left() + 0.55 * rect.width();
    let y = rect.center().y;
    while x < rect.right() {
        ui.hover_at(egui::pos2(x, y));
        ui.run();
        if ui.output().platform_output.cursor_icon == egui::CursorIcon::ResizeHorizontal {
            break;
        }
        x += 3.0;
    }
    assert!(x < rect.right(), "the edge can be found");
    ui.drag_at(egui::pos2(x, y));
    ui.run();
    for step in 1..=4 {
        ui.hover_at(egui::pos2(x - 10.0 * step as f32, y));
        ui.run();
    }
    ui.drop_at(egui::pos2(x - 40.0, y));
    ui.run();
    let memory = narrow_memory(&ui);
    assert_eq!(memory.centre_nm, 580.0);
    assert!((30.0..95.0).contains(&memory.width_nm), "{memory:?}");
}

#[test]
fn a_measured_filter_takes_the_place_of_the_gaussian_until_it_is_moved() {
    let mut ui = open(about("FL11"), Page::Narrow, LARGE);
    let label = label_of(&ui, |label| {
        label.starts_with("Filter ") && label.contains("IVG550")
    });
    ui.get_by_role_and_label(Role::Button, &label)
        .scroll_to_me();
    ui.run();
    ui.get_by_role_and_label(Role::Button, &label).click();
    ui.run();
    let filter = narrow_memory(&ui).filter.expect("the glass");
    assert!(filter.contains("IVG550"), "{filter}");
    ui.get_by_label(narrow::names::GAUSSIAN).click();
    ui.run();
    assert_eq!(narrow_memory(&ui).filter, None);
    // A filter that left the library is no filter.
    let mut nowhere = about("FL11");
    nowhere.pages_follow(|pages| pages.narrow.filter = Some("own/77".to_owned()));
    window_image(&nowhere, &preferences(Page::Narrow), [1280, 800]);
}

#[test]
fn all_three_have_equally_many_numbers() {
    let behind = Behind::of(&about("FL11"));
    assert_eq!(WAYS.len(), 3);
    // Order 7 and eight spikes, two numbers each.
    let app = about("FL11");
    assert_eq!(behind.numbers(), app.derived().model.numbers());
}
