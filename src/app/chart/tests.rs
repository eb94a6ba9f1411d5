//! Whole charts, read back as XML.

use super::{svg::hex, *};

const RED: Rgb = [200, 30, 20];

/// Parses a chart and checks what must hold for every one of them.
fn checked(chart: &Chart) -> String {
    let svg = chart.to_svg(640, 400, Theme::Light);
    let document = roxmltree::Document::parse(&svg).unwrap();
    for node in document.descendants() {
        for attribute in node.attributes() {
            let value = attribute.value();
            assert!(!value.contains("NaN") && !value.contains("inf"), "{value}");
            if attribute.name() != "d" {
                continue;
            }
            let numbers = value.split(|c: char| c.is_ascii_alphabetic() || c == ' ');
            for number in numbers.filter(|number| !number.is_empty()) {
                let number: f64 = number.parse().unwrap();
                // The form of a point on the edge reaches a little beyond it.
                assert!((-2.0..=2000.0).contains(&number), "{number} in {value}");
            }
        }
    }
    assert_eq!(document.root_element().tag_name().name(), "svg");
    svg
}

fn texts(svg: &str) -> Vec<String> {
    let document = roxmltree::Document::parse(svg).unwrap();
    let texts = document.descendants().filter(|n| n.has_tag_name("text"));
    texts.filter_map(|n| n.text().map(str::to_owned)).collect()
}

fn of(series: Series) -> Chart {
    Chart {
        series: vec![series],
        ..Chart::default()
    }
}

fn line(points: &[[f64; 2]]) -> Chart {
    of(Series::line("data", RED, points.to_vec()))
}

fn assert_written(svg: &str, expected: &[&str]) {
    let texts = texts(svg);
    for expected in expected {
        assert!(texts.iter().any(|text| text == expected), "{expected}");
    }
}

/// Path data of the first thing drawn in the chart's colour, after the legend's sample.
fn drawn(svg: &str) -> String {
    let document = roxmltree::Document::parse(svg).unwrap();
    let group = document
        .descendants()
        .find(|n| n.has_tag_name("g") && n.children().any(|c| c.has_tag_name("title")));
    let path = group.and_then(|g| g.children().find(|n| n.has_tag_name("path")));
    let data = path.and_then(|n| n.attribute("d").map(str::to_owned));
    data.unwrap_or_default()
}

#[test]
fn names_labels_and_notes_are_in_the_file() {
    let chart = Chart {
        title: "Fluorescent lamp".into(),
        x_label: "Wavelength (nm)".into(),
        y_label: "Power".into(),
        x_range: [380.0, 780.0],
        series: vec![Series::line(
            "measured",
            RED,
            vec![[380.0, 0.0], [780.0, 1.0]],
        )],
        colours: [[0, 0, 255], [0, 255, 0], [255, 0, 0]]
            .map(Ink::Own)
            .to_vec(),
        strip: true,
        residual: Some(Panel {
            y_label: "Residual".into(),
            series: vec![Series::line(
                "difference",
                RED,
                vec![[400.0, -0.1], [700.0, 0.1]],
            )],
            ..Panel::default()
        }),
        notes: vec!["Source: a table".into()],
        ..Chart::default()
    };
    let expected = [
        "Fluorescent lamp",
        "Wavelength (nm)",
        "Power",
        "measured",
        "difference",
        "Residual",
        "Source: a table",
        "400",
        "750",
        "0.0",
        "1.0",
    ];
    assert_written(&checked(&chart), &expected);
}

#[test]
fn text_with_markup_comes_back_as_it_was() {
    let odd = "a <b> & \"c\" 'd'";
    let mut chart = line(&[[0.0, 0.0], [1.0, 1.0]]);
    chart.title = odd.into();
    chart.notes = vec!["null \u{0} and bell \u{7}".into()];
    chart.series[0].name = odd.into();
    let svg = checked(&chart);
    assert_eq!(texts(&svg).iter().filter(|text| *text == odd).count(), 2);
    let document = roxmltree::Document::parse(&svg).unwrap();
    let title = document.descendants().find(|n| n.has_tag_name("title"));
    assert_eq!(title.unwrap().text(), Some(odd));
}

#[test]
fn charts_without_data_are_still_charts() {
    checked(&Chart::default());
    checked(&line(&[]));
    checked(&line(&[[0.5, 0.5]]));
    checked(&Chart {
        strip: true,
        residual: Some(Panel::default()),
        y_scale: Scale::Log10,
        ..Chart::default()
    });
}

#[test]
fn flat_data_get_a_range_around_them() {
    for level in [0.0, 5.0, -3e-9, 1e12, 1e300] {
        let chart = line(&[[0.0, level], [1.0, level]]);
        let svg = checked(&chart);
        assert!(!drawn(&svg).is_empty(), "level {level}");
        let log = Chart {
            y_scale: Scale::Log10,
            y_range: Some([level, level]),
            ..chart
        };
        checked(&log);
    }
}

#[test]
fn huge_tiny_and_broken_numbers_stay_inside() {
    let numbers = [
        0.0,
        1.0,
        -1.0,
        1e-300,
        5e-324,
        1e300,
        -1e308,
        1e308,
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
    ];
    let mut points = Vec::new();
    for x in numbers {
        for y in numbers {
            points.push([x, y]);
        }
    }
    let base: Vec<f64> = numbers.into_iter().cycle().take(points.len()).collect();
    let all = [
        Marks::Line {
            points: points.clone(),
            width: f64::NAN,
            dash: Dash::Dashed,
        },
        Marks::Stems {
            points: points.clone(),
            base: base.clone(),
            labels: vec!["Hg".into(); 50],
        },
        Marks::Area {
            points: points.clone(),
            base,
            is_coloured: false,
        },
        Marks::Bars {
            points: points.clone(),
            width: 0.1,
        },
        Marks::Points {
            points,
            radius: f64::INFINITY,
            shape: Shape::Triangle,
        },
    ];
    for marks in all {
        for y_scale in [Scale::Linear, Scale::Log10] {
            for low in numbers {
                for high in numbers {
                    for y_range in [None, Some([low, high])] {
                        checked(&Chart {
                            x_range: [low, high],
                            y_range,
                            y_scale,
                            ..of(Series::new("data", RED, marks.clone()))
                        });
                    }
                }
            }
        }
    }
}

#[test]
fn a_broken_point_breaks_the_line() {
    let svg = checked(&line(&[
        [0.0, 0.0],
        [0.2, 1.0],
        [0.4, f64::NAN],
        [0.6, 1.0],
        [1.0, 0.0],
    ]));
    assert_eq!(drawn(&svg).matches('M').count(), 2);
}

#[test]
fn labels_of_close_stems_do_not_cover_each_other() {
    let points: Vec<[f64; 2]> = (0..30).map(|i| [f64::from(i) / 300.0, 0.5]).collect();
    let labels = (0..30).map(|i| format!("line {i}")).collect();
    let stems = Series::stems("data", RED, points, vec![]);
    let svg = checked(&of(stems.labelled(labels)));
    let written = texts(&svg).iter().filter(|t| t.starts_with("line")).count();
    assert!((1..30).contains(&written), "{written} labels");
    // All thirty are there as tooltips.
    assert_eq!(svg.matches("<title>line").count(), 30);
}

#[test]
fn the_picture_grows_rather_than_lose_its_panels() {
    let chart = Chart {
        notes: vec!["note".into(); 40],
        ..line(&[[0.0, 0.0], [1.0, 1.0]])
    };
    let svg = checked(&chart);
    let document = roxmltree::Document::parse(&svg).unwrap();
    let height: f64 = document
        .root_element()
        .attribute("height")
        .unwrap()
        .parse()
        .unwrap();
    assert!(height > 500.0, "{height}");
}

fn map() -> Cells {
    Cells {
        x_edges: vec![0.0, 1.0, 2.0, 4.0],
        y_edges: vec![0.0, 0.5, 1.0],
        values: vec![
            Some(1.0),
            Some(2.0),
            None,
            Some(4.0),
            Some(f64::NAN),
            Some(8.0),
        ],
        label: "Error".into(),
        ..Cells::default()
    }
}

fn heat_map() -> Chart {
    Chart {
        title: "Trade-off".into(),
        x_label: "Order".into(),
        y_label: "Spikes".into(),
        x_range: [0.0, 4.0],
        series: vec![Series::cells("error", map())],
        notes: vec!["Source: a table".into()],
        ..Chart::default()
    }
}

fn named(names: &[&str], series: Vec<Series>) -> Chart {
    let names = names.iter().enumerate();
    Chart {
        x_range: [-0.5, names.len() as f64 - 0.5],
        x_names: names.map(|(i, n)| (i as f64, (*n).to_owned())).collect(),
        series,
        ..Chart::default()
    }
}

#[test]
fn a_heat_map_fills_its_panel_and_has_a_bar_that_tells_its_colours() {
    let svg = checked(&heat_map());
    let [darkest, lightest] = [ramp_colour(0.0), ramp_colour(1.0)].map(hex);
    assert!(svg.contains(&darkest) && svg.contains(&lightest));
    assert_written(&svg, &["Error", "2", "8"]);
    assert!(svg.contains("Coloured by Error from 1 to 8."));
    // Two boxes have no value that could be shown: a stroke each.
    assert_eq!(drawn(&svg).matches('M').count(), 2);
    assert_eq!(heat_map().y_limits(), [0.0, 1.0]);
}

#[test]
fn heat_maps_of_odd_numbers_stay_inside() {
    let numbers = [0.0, -1.0, 1e-300, 1e300, f64::NAN, f64::INFINITY];
    for scale in [Scale::Linear, Scale::Log10] {
        for low in numbers {
            for high in numbers {
                let cells = Cells {
                    x_edges: vec![low, 1.0, high],
                    y_edges: vec![low, high],
                    values: vec![Some(low), Some(high)],
                    range: Some([high, low]),
                    scale,
                    ..Cells::default()
                };
                checked(&Chart {
                    x_scale: scale,
                    y_scale: scale,
                    ..of(Series::cells("data", cells))
                });
            }
        }
    }
}

#[test]
fn places_with_names_have_them_instead_of_numbers() {
    let bars = |shift: f64| {
        let points = (0..3).map(|i| [f64::from(i) + shift, 1.0]).collect();
        Series::bars(format!("at {shift}"), RED, 0.4, points)
    };
    let short = named(&["a", "b", "c"], vec![bars(-0.2), bars(0.2)]);
    let svg = checked(&short);
    assert_written(&svg, &["a", "b", "c"]);
    assert!(!svg.contains("rotate(-35)"));
    let longest = "a representation with a very long name";
    let svg = checked(&named(&[longest; 9], vec![bars(0.0)]));
    assert_eq!(
        svg.matches("rotate(-35)").count(),
        9,
        "names that do not fit are slanted"
    );
    assert!(texts(&svg).iter().any(|t| t.ends_with('…')));
}

#[test]
fn a_logarithmic_horizontal_axis_places_decades_evenly() {
    let points = vec![[1.0, 0.0], [10.0, 0.5], [100.0, 1.0]];
    let chart = Chart {
        x_range: [1.0, 100.0],
        x_scale: Scale::Log10,
        ..line(&points)
    };
    let svg = checked(&chart);
    assert_written(&svg, &["10"]);
    // Even steps up and even steps across: a straight line through the middle.
    let corners: Vec<f64> = drawn(&svg)
        .split(|c: char| !(c.is_ascii_digit() || c == '.'))
        .filter_map(|number| number.parse().ok())
        .collect();
    assert!((corners[2] - (corners[0] + corners[4]) / 2.0).abs() < 0.02);
}

#[test]
fn forms_and_dashes_tell_series_apart_without_colour() {
    let point = vec![[0.5, 0.5]];
    let mut seen = std::collections::BTreeSet::new();
    for shape in Shape::ALL {
        let points = Series::points("data", RED, shape, point.clone());
        seen.insert(checked(&of(points)));
    }
    for dash in [Dash::Solid, Dash::Dashed, Dash::Dotted] {
        let points = vec![[0.0, 0.0], [1.0, 1.0]];
        let line = Series::line("data", RED, points).dashed(dash);
        seen.insert(checked(&of(line)));
    }
    assert_eq!(seen.len(), 9);
}

/// The table without its comment lines.
fn rows(chart: &Chart) -> Vec<String> {
    let csv = chart.to_csv();
    let rows = csv.lines().filter(|line| !line.starts_with('#'));
    rows.map(str::to_owned).collect()
}

#[test]
fn series_that_share_their_places_are_columns_of_one_table() {
    let chart = Chart {
        title: "A lamp\nof two lines".into(),
        x_label: "Wavelength (nm)".into(),
        series: vec![
            Series::line("measured", RED, vec![[380.0, 0.1], [381.0, f64::NAN]]),
            Series::line("a, \"b\"", RED, vec![[380.0, 1e-30], [381.0, 2.0]]),
        ],
        residual: Some(Panel {
            series: vec![Series::line("", RED, vec![[380.0, -1.0], [381.0, 0.3]])],
            ..Panel::default()
        }),
        notes: vec!["Source: a table".into()],
        ..Chart::default()
    };
    let csv = chart.to_csv();
    assert!(
        csv.starts_with("# title: A lamp of two lines\n# Source: a table\n"),
        "{csv}"
    );
    assert_eq!(
        rows(&chart),
        [
            r#"Wavelength (nm),measured,"a, ""b""",series 3"#,
            "380,0.1,1e-30,-1",
            "381,,2,0.3",
        ]
    );
}

#[test]
fn series_with_places_of_their_own_stand_below_one_another() {
    let chart = Chart {
        x_label: "N".into(),
        y_label: "=error".into(),
        series: vec![
            Series::line("a", RED, vec![[1.0, 2.0]]),
            Series::stems("b", RED, vec![[1.5, 3.0]], vec![0.5]),
        ],
        ..Chart::default()
    };
    assert_eq!(
        rows(&chart),
        ["series,N,'=error", "a,1,2", "b (base),1.5,0.5", "b,1.5,3"]
    );
}

#[test]
fn bars_side_by_side_are_one_table_by_name() {
    let bars = |name: &str, shift: f64| {
        let points = (0..2).map(|i| [f64::from(i) + shift, shift]).collect();
        Series::bars(name, RED, 0.3, points)
    };
    let chart = named(&["x, y", "z"], vec![bars("a", -0.25), bars("b", 0.25)]);
    assert_eq!(
        rows(&chart),
        ["x,a,b", r#""x, y",-0.25,0.25"#, "z,-0.25,0.25"]
    );
    let lone = Series::points("c", RED, Shape::Dot, vec![[0.0, 1.0]]);
    let chart = named(&["p", "q"], vec![bars("a", 0.0), lone]);
    assert_eq!(
        rows(&chart),
        ["series,x,name,y", "a,0,p,0", "a,1,q,0", "c,0,p,1"]
    );
}

#[test]
fn a_heat_map_has_one_line_a_box() {
    let rows = rows(&heat_map());
    assert_eq!(rows.len(), 7);
    assert_eq!(
        rows[..4],
        ["Order,Spikes,Error", "0.5,0.25,1", "1.5,0.25,2", "3,0.25,"]
    );
    assert_eq!(rows[5], "1.5,0.75,");
    let mut chart = heat_map();
    chart
        .series
        .push(Series::line("path", RED, vec![[1.0, 0.5]]));
    let both = self::rows(&chart);
    assert_eq!(both[0], "series,Order,Spikes,Error");
    assert_eq!(both.last().map(String::as_str), Some("path,1,0.5,"));
}

#[test]
fn a_bare_chart_has_no_axes_and_stands_in_the_middle() {
    let chart = Chart {
        even: true,
        is_bare: true,
        x_label: "x".to_owned(),
        y_label: "y".to_owned(),
        ..line(&[[0.0, 0.0], [1.0, 1.0]])
    };
    let drawing = Drawing::new(&chart, [640.0, 400.0], Looks::of_file(Theme::Light));
    let main = drawing.main;
    assert!(
        (main.width - main.height).abs() < 1e-9,
        "as long on both axes"
    );
    assert!((main.left + main.right() - 640.0).abs() < 1e-9);
    // The name of the series is all that is written.
    assert_eq!(texts(&checked(&chart)), ["data"]);
}

#[test]
fn pieces_of_a_ground_stay_in_the_panel_and_those_beside_it_are_left_out() {
    let piece = |left: f64| Piece {
        corners: [
            [left, 0.0],
            [left + 1.0, 0.0],
            [left + 1.0, 1.0],
            [left, 1.0],
        ],
        colours: [RED; 4],
    };
    let pieces = vec![piece(-0.5), piece(0.25), piece(3.0)];
    let chart = of(Series::new("", RED, Marks::Ground { pieces }));
    let svg = checked(&chart);
    let colour = hex(RED);
    assert_eq!(svg.matches(&format!("stroke=\"{colour}\"")).count(), 2);
    assert_eq!(chart.to_csv().lines().count(), 1, "a ground is no data");
}
