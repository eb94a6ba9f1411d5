//! Charts in the window, driven without a display: what is pointed at, clicked, zoomed and saved.

use std::{
    collections::BTreeSet,
    fs,
    path::PathBuf,
    sync::{Arc, Mutex},
};

use crate::driver::{harness, no_files, wait_until, words};
use crate::plain::plain;
use eframe::egui;
use egui::{Modifiers, Pos2, Role, pos2, vec2};
use egui_kittest::{Harness, kittest::Queryable as _};
use spectral_explorer::{
    app::{
        chart::{Cells, Chart, Dash, Ink, Marks, Panel, Scale, Series, Shape, Theme, root},
        workspace::Preferences,
    },
    ui::{
        Window,
        chart_view::{ChartResponse, ChartView, Hit},
        files::{Ask, Picked, Picker},
        picture, theme,
    },
};

/// A chart above the program's window, as a page has it.
struct Page {
    window: Window,
    chart: Chart,
    pointed: Option<Hit>,
    clicked: Vec<Hit>,
    transform: Option<egui_plot::PlotTransform>,
}

impl eframe::App for Page {
    fn ui(&mut self, ui: &mut egui::Ui, _: &mut eframe::Frame) {
        let looks = theme::Theme::of(&self.window.preferences);
        egui::Panel::top("chart").exact_size(360.0).show(ui, |ui| {
            let ChartResponse {
                clicked,
                pointed,
                wish,
                transform,
                ..
            } = ChartView::show(ui, &self.chart, "page", ui.available_size(), looks);
            self.pointed = pointed;
            self.clicked.extend(clicked);
            self.transform = Some(transform);
            if let Some(wish) = wish {
                self.window.save_chart(wish, ui.ctx());
            }
        });
        self.window.show(ui);
    }
}

type Ui = Harness<'static, Page>;

fn over(chart: Chart, picker: Picker) -> Ui {
    let window = Window::new(plain(), Preferences::default(), picker, None);
    let page = Page {
        window,
        chart,
        pointed: None,
        clicked: Vec::new(),
        transform: None,
    };
    let mut ui = harness(page, [1280.0, 1100.0], 0.02, 40);
    ui.run();
    ui
}

fn fresh(chart: Chart) -> Ui {
    over(chart, no_files())
}

/// Where a place of the chart is on screen.
fn at(ui: &Ui, point: [f64; 2]) -> Pos2 {
    let transform = ui.state().transform.expect("the chart was drawn");
    transform.position_from_point(&point.into())
}

fn hover(ui: &mut Ui, at: Pos2) {
    ui.hover_at(at);
    ui.run();
}

fn click(ui: &mut Ui, at: Pos2) {
    hover(ui, at);
    ui.drag_at(at);
    ui.drop_at(at);
    ui.run();
}

#[track_caller]
fn assert_written(ui: &Ui, text: &str) {
    let words = words(ui);
    assert!(
        words.iter().any(|w| w == text),
        "{text:?} is not in {words:?}"
    );
}

fn curves() -> Chart {
    let points = |k: f64| (1..=20).map(|n| [f64::from(n), k / f64::from(n)]).collect();
    let notes = (1..=20).map(|n| format!("{} numbers", 2 * n + 1)).collect();
    Chart {
        title: "FL11: error (7 spikes)".into(),
        x_label: "Order N".into(),
        y_label: "CIEDE2000".into(),
        x_range: [0.0, 21.0],
        series: vec![
            Series::line("composite", [86, 180, 233], points(1.0)).with_notes(notes),
            Series::points("samples", [240, 165, 30], Shape::Square, points(5.0)),
        ],
        residual: Some(Panel {
            y_label: "difference".into(),
            y_range: None,
            series: vec![Series::line(
                "samples - composite",
                [64, 190, 150],
                points(4.0),
            )],
        }),
        notes: vec!["Source: a table".into()],
        ..Chart::default()
    }
}

fn map() -> Chart {
    let cells = Cells {
        x_edges: vec![1.0, 10.0, 100.0],
        y_edges: vec![0.0, 1.0, 2.0],
        values: vec![Some(0.5), None, Some(1.5), Some(2.5)],
        label: "Error".into(),
        ..Cells::default()
    };
    Chart {
        title: "Trade-off".into(),
        x_label: "Numbers".into(),
        y_label: "Spikes".into(),
        x_range: [1.0, 100.0],
        x_scale: Scale::Log10,
        series: vec![Series::cells("error", cells)],
        ..Chart::default()
    }
}

fn bars() -> Chart {
    let bars = |name: &str, shift: f64| {
        let points = (0..3).map(|i| [f64::from(i) + shift, 2.0 + f64::from(i)]);
        Series::bars(name, [86, 180, 233], 0.4, points.collect())
    };
    Chart {
        title: "Race".into(),
        x_range: [-0.5, 2.5],
        x_names: ["bins", "moments", "wavelets"]
            .iter()
            .enumerate()
            .map(|(i, name)| (i as f64, (*name).to_owned()))
            .collect(),
        series: vec![bars("lamps", -0.2), bars("daylight", 0.2)],
        ..Chart::default()
    }
}

#[test]
fn the_nearest_point_is_read_out_with_its_labels_and_its_note() {
    let mut ui = fresh(curves());
    let here = at(&ui, [4.0, 0.25]) + vec2(2.0, -1.0);
    hover(&mut ui, here);
    let hit = Hit {
        series: 0,
        point: 3,
        at: [4.0, 0.25],
    };
    assert_eq!(ui.state().pointed, Some(hit));
    for text in ["composite", "Order N: 4", "CIEDE2000: 0.25", "9 numbers"] {
        assert_written(&ui, text);
    }
    // Far from every point nothing is told.
    let nowhere = at(&ui, [18.0, 4.0]);
    hover(&mut ui, nowhere);
    assert_eq!(ui.state().pointed, None);
    assert!(!words(&ui).iter().any(|w| w.starts_with("Order N: ")));
}

#[test]
fn a_click_tells_the_point_and_a_click_beside_tells_nothing() {
    let mut ui = fresh(curves());
    let point = at(&ui, [2.0, 2.5]);
    click(&mut ui, point);
    let hit = Hit {
        series: 1,
        point: 1,
        at: [2.0, 2.5],
    };
    assert_eq!(ui.state().clicked, [hit]);
    let nowhere = at(&ui, [18.0, 4.0]);
    click(&mut ui, nowhere);
    assert_eq!(ui.state().clicked.len(), 1);
}

#[test]
fn the_lower_panel_counts_its_series_after_the_main_ones() {
    let mut ui = fresh(curves());
    let name = "FL11: error (7 spikes): difference";
    let rect = ui.get_by_role_and_label(Role::Image, name).rect();
    // The lowest point of the panel stands at its right end, near the bottom.
    let x = at(&ui, [20.0, 0.0]).x;
    let middle = rect.bottom() - 6.0;
    let mut found = None;
    for step in 0..30 {
        hover(&mut ui, pos2(x, middle - 2.0 * step as f32));
        found = found.or(ui.state().pointed);
    }
    let hit = found.expect("the last point of the lower panel");
    assert_eq!((hit.series, hit.point), (2, 19));
    assert_eq!(hit.at, [20.0, 0.2]);
}

#[test]
fn a_box_of_a_heat_map_tells_its_value_on_logarithmic_places_too() {
    let mut ui = fresh(map());
    let here = at(&ui, [1.5, 1.5]);
    hover(&mut ui, here);
    let hit = Hit {
        series: 0,
        point: 3,
        at: [55.0, 1.5],
    };
    assert_eq!(ui.state().pointed, Some(hit));
    assert_written(&ui, "Error: 2.5");
    click(&mut ui, here);
    assert_eq!(ui.state().clicked, [hit]);
    let empty = at(&ui, [1.5, 0.5]);
    hover(&mut ui, empty);
    assert_written(&ui, "Error: no value");
}

#[test]
fn a_bar_is_pointed_at_anywhere_inside_and_tells_the_name_of_its_place() {
    let mut ui = fresh(bars());
    let inside = at(&ui, [1.2, 0.8]);
    hover(&mut ui, inside);
    let hit = ui.state().pointed.expect("a bar");
    assert_eq!((hit.series, hit.point), (1, 1));
    for text in ["daylight", "x: moments", "y: 3"] {
        assert_written(&ui, text);
    }
}

#[test]
fn a_drag_pans_and_a_double_click_brings_everything_back() {
    let mut ui = fresh(curves());
    let bounds = |ui: &Ui| ui.state().transform.expect("drawn").bounds().min();
    let before = bounds(&ui);
    let from = at(&ui, [18.0, 4.0]);
    hover(&mut ui, from);
    ui.drag_at(from);
    for step in 1..=5 {
        ui.hover_at(from + vec2(-12.0 * step as f32, 0.0));
        ui.step();
    }
    ui.drop_at(from + vec2(-60.0, 0.0));
    ui.run();
    assert!(bounds(&ui)[0] > before[0] + 0.5, "{:?}", bounds(&ui));
    ui.remove_cursor();
    ui.run();
    let panned = bounds(&ui);
    assert!(panned[0] > before[0] + 0.5, "it stays where it was moved");
    // A beat, so that the clicks are none of the drag's.
    ui.run_steps(30);
    hover(&mut ui, from);
    for _ in 0..2 {
        for pressed in [true, false] {
            ui.event(egui::Event::PointerButton {
                pos: from,
                button: egui::PointerButton::Primary,
                pressed,
                modifiers: Modifiers::NONE,
            });
        }
        ui.step();
    }
    ui.run();
    assert_eq!(bounds(&ui), before);
}

fn recording(path: PathBuf) -> (Picker, Arc<Mutex<Vec<Ask>>>) {
    let asked = Arc::new(Mutex::new(Vec::new()));
    let record = asked.clone();
    let picker: Picker = Arc::new(move |ask| {
        record
            .lock()
            .expect("no panic in a picker")
            .push(ask.clone());
        Picked::Paths(vec![path.clone()])
    });
    (picker, asked)
}

fn choose(ui: &mut Ui, entry: &str) {
    let name = "Save chart: FL11: error (7 spikes)";
    ui.get_by_role_and_label(Role::Button, name).click();
    ui.run();
    ui.get_by_role_and_label(Role::Button, entry).click();
    ui.step();
}

#[test]
fn the_menu_saves_numbers_and_pictures_where_the_picker_says() {
    let folder = tempfile::tempdir().expect("a folder");
    for (entry, extension) in [
        ("Save CSV…", "csv"),
        ("Save SVG…", "svg"),
        ("Save PNG…", "png"),
    ] {
        let path = folder.path().join("saved").with_extension(extension);
        let (picker, asked) = recording(path.clone());
        let mut ui = over(curves(), picker);
        choose(&mut ui, entry);
        wait_until(&mut ui, entry, |ui| {
            let said = ui.state().window.app.message();
            said.is_some_and(|m| m.text.starts_with("Saved"))
        });
        let expected = Ask::Save {
            suggested: format!("FL11-error.{extension}"),
            extension,
        };
        assert_eq!(asked.lock().expect("no panic").clone(), [expected]);
        let bytes = fs::read(&path).expect("saved");
        let chart = curves();
        match extension {
            "csv" => assert_eq!(bytes, chart.to_csv().into_bytes()),
            "svg" => assert_eq!(
                bytes,
                chart
                    .to_svg(1200, 760, spectral_explorer::app::chart::Theme::Dark)
                    .into_bytes()
            ),
            _ => assert_eq!(bytes, picture::chart_png(&chart, [1200, 760], Theme::Dark)),
        }
    }
}

#[test]
fn the_menu_copies_the_numbers() {
    let mut ui = fresh(curves());
    choose(&mut ui, "Copy as CSV");
    let copied = ui
        .output()
        .platform_output
        .commands
        .iter()
        .find_map(|c| match c {
            egui::OutputCommand::CopyText(text) => Some(text.clone()),
            _ => None,
        });
    assert_eq!(copied.as_deref(), Some(curves().to_csv().trim_end()));
    let said = ui.state().window.app.message().map(|m| m.text.clone());
    assert_eq!(
        said.as_deref(),
        Some("Copied as CSV: FL11: error (7 spikes).")
    );
}

#[test]
fn without_a_dialog_a_chart_is_saved_to_a_typed_path() {
    let mut ui = over(curves(), Arc::new(|_| Picked::NoDialog));
    choose(&mut ui, "Save CSV…");
    wait_until(&mut ui, "the path field", |ui| {
        let field = ui.query_by_role_and_label(Role::TextInput, "Path of the file");
        field.is_some()
    });
    assert_written(&ui, "FL11-error.csv");
}

#[test]
fn every_kind_of_chart_is_drawn_with_a_name_whatever_its_numbers() {
    let odd = [0.0, -1.0, 1e-300, 1e300, f64::NAN, f64::INFINITY];
    let points: Vec<[f64; 2]> = odd.iter().flat_map(|x| odd.map(|y| [*x, y])).collect();
    let kinds = [
        Marks::Line {
            points: points.clone(),
            width: f64::NAN,
            dash: Dash::Dotted,
        },
        Marks::Stems {
            points: points.clone(),
            base: odd.to_vec(),
            labels: vec!["Hg".into(); 40],
        },
        Marks::Area {
            points: points.clone(),
            base: odd.to_vec(),
            is_coloured: false,
        },
        Marks::Bars {
            points: points.clone(),
            width: 0.3,
        },
        Marks::Points {
            points,
            radius: f64::NAN,
            shape: Shape::Cross,
        },
        Marks::Cells {
            cells: Cells {
                x_edges: odd.to_vec(),
                y_edges: odd.to_vec(),
                values: vec![Some(f64::NAN); 25],
                ..Cells::default()
            },
        },
    ];
    let empty = [Chart::default(), curves(), map(), bars()];
    let charts = kinds.into_iter().flat_map(|marks| {
        [Scale::Linear, Scale::Log10].map(|scale| Chart {
            x_scale: scale,
            y_scale: scale,
            y_range: Some([f64::NAN, 1e300]),
            colours: vec![Ink::Own([1, 2, 3])],
            strip: true,
            series: vec![Series::new("data", [200, 30, 20], marks.clone())],
            ..Chart::default()
        })
    });
    let mut ui = fresh(Chart::default());
    for chart in empty.into_iter().chain(charts) {
        let name = match chart.title.is_empty() {
            true => "Chart".to_owned(),
            false => chart.title.clone(),
        };
        ui.state_mut().chart = chart;
        ui.run();
        let rect = ui.get_by_role_and_label(Role::Image, &name).rect();
        hover(&mut ui, rect.center());
        let broken: Vec<String> = words(&ui)
            .into_iter()
            .filter(|w| w.contains("NaN"))
            .collect();
        assert!(broken.is_empty(), "{broken:?}");
        ui.remove_cursor();
        ui.run();
    }
}

/// The words of a window that shows nothing but a chart, and the range of its main panel.
fn written_in_the_window(chart: &Chart) -> (BTreeSet<String>, [[f64; 2]; 2]) {
    fn texts(shape: &egui::Shape, into: &mut BTreeSet<String>) {
        match shape {
            egui::Shape::Vec(shapes) => shapes.iter().for_each(|shape| texts(shape, into)),
            egui::Shape::Text(text) => drop(into.insert(text.galley.text().to_owned())),
            _ => {}
        }
    }
    let (mut words, mut shown) = (BTreeSet::new(), [[0.0; 2]; 2]);
    let mut context_ready = false;
    let ui = Harness::builder()
        .with_size([1300.0, 1000.0])
        .build_ui(|ui| {
            if !std::mem::replace(&mut context_ready, true) {
                theme::install_fonts(ui.ctx());
                return;
            }
            let looks = theme::Theme::of(&Preferences::default());
            let size = ui.available_size();
            let response = ChartView::show(ui, chart, "alone", size, looks);
            let bounds = response.transform.bounds();
            let [low, high] = [bounds.min(), bounds.max()];
            shown = [0, 1].map(|k| [low[k], high[k]]);
        });
    for clipped in &ui.output().shapes {
        texts(&clipped.shape, &mut words);
    }
    drop(ui);
    words.retain(|text| text != "⋯");
    (words, shown)
}

#[test]
fn the_window_and_the_file_show_the_same_series_ranges_ticks_and_labels() {
    let mut spikes = curves();
    spikes.series.push(Series::new(
        "spikes",
        [200, 30, 20],
        Marks::Stems {
            points: vec![[5.0, 3.0], [12.0, 2.0]],
            base: vec![0.0, 1.0],
            labels: vec!["Hg 435.8".into(), "Na".into()],
        },
    ));
    for chart in [curves(), spikes, map(), bars()] {
        // Higher than the window by its title, notes and margins, so that panels are of a size.
        let svg = chart.to_svg(1300, 1040, spectral_explorer::app::chart::Theme::Dark);
        let document = roxmltree::Document::parse(&svg).expect("an SVG document");
        let texts = document.descendants().filter(|n| n.has_tag_name("text"));
        let mut file: BTreeSet<String> =
            texts.filter_map(|n| n.text().map(str::to_owned)).collect();
        // The window has the notes where the title is pointed at.
        file.retain(|text| !chart.notes.contains(text));
        let (window, shown) = written_in_the_window(&chart);
        assert_eq!(window, file, "{}", chart.title);
        assert!(window.len() > 5, "{window:?}");
        let log = |range: [f64; 2], scale| match scale {
            Scale::Linear => range,
            Scale::Root => range.map(root),
            Scale::Log10 => range.map(f64::log10),
        };
        let own = [
            log(chart.x_limits(), chart.x_scale),
            log(chart.y_limits(), chart.y_scale),
        ];
        assert_eq!(shown, own, "{}", chart.title);
    }
}
