//! Whole charts, read back as XML.

use super::*;

const RED: Rgb = [200, 30, 20];

/// Parses a chart and checks what must hold for every one of them.
fn checked(chart: &Chart) -> String {
    let svg = chart.to_svg(640, 400);
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
                assert!((-1.0..=2000.0).contains(&number), "{number} in {value}");
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

fn one(marks: Marks) -> Chart {
    Chart {
        series: vec![Series::new("data", RED, marks)],
        ..Chart::default()
    }
}

fn line(points: &[[f64; 2]]) -> Chart {
    Chart {
        series: vec![Series::line("data", RED, points.to_vec())],
        ..Chart::default()
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
        strip: Some(vec![[0, 0, 255], [0, 255, 0], [255, 0, 0]]),
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
    let texts = texts(&checked(&chart));
    for expected in [
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
    ] {
        assert!(texts.iter().any(|text| text == expected), "{expected}");
    }
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
        strip: Some(Vec::new()),
        residual: Some(Panel::default()),
        y_scale: Scale::Log10,
        theme: Theme::Dark,
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
                            ..one(marks.clone())
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
    let svg = checked(&one(Marks::Stems {
        points,
        base: vec![],
        labels,
    }));
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
