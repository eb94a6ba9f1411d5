//! The page "Truth" as charts: what a claim looks like on the spectrum at hand.

use super::coefficients::{CHANNEL_DASHES, FUNCTIONS, NEGLECTED_PERCENT, channel_inks};
use crate::{
    app::{
        chart::{Chart, Dash, Ink, Scale, Series, Shape, stroke},
        charts::spectrum::of_subject,
        state::App,
        studies::paper::{CHANNELS, Claims},
    },
    color::gaussian_cmf,
    io::many::numbers,
    languages::with_sign,
    study::{
        Measure,
        harmonics::Order,
        truth::{STATED_ORDER, SampledErrors},
    },
};

/// Orders that it shows.
const HIGHEST_SHOWN: usize = 20;

/// The nm in which colour-matching functions are worth drawing.
const VISIBLE_NM: [f64; 2] = [360.0, 830.0];

/// What is left out beyond each order, for X, Y and Z; `None` without colour.
pub fn neglected_chart(app: &App, claims: &Claims) -> Option<Chart> {
    let orders = &claims.harmonics.orders;
    let orders = &orders[..orders.len().min(HIGHEST_SHOWN + 1)];
    if orders.len() < 2 || orders[0].neglected.iter().any(Option::is_none) {
        return None;
    }
    let level = orders.iter().map(|o| [o.order as f64, 5.0]).collect();
    let mut series = vec![thin("5 %", Ink::Measured, level, Dash::Dashed)];
    let colours = channel_inks();
    for k in 0..3 {
        let point = |o: &Order| {
            let share = o.neglected[k].unwrap_or(f64::NAN);
            [
                o.order as f64,
                (100.0 * share.abs()).max(NEGLECTED_PERCENT[0]),
            ]
        };
        let points = orders.iter().map(point).collect();
        series.push(Series::line(CHANNELS[k], colours[k], points).dashed(CHANNEL_DASHES[k]));
    }
    let stated = STATED_ORDER.figure;
    let foot_to_top = NEGLECTED_PERCENT.map(|y| [stated, y]).to_vec();
    series.push(thin(
        said!("paper: N = 5"),
        Ink::Product,
        foot_to_top,
        Dash::Dotted,
    ));
    Some(Chart {
        title: said!("Left out beyond N").to_owned(),
        x_label: said!("Waves").to_owned(),
        y_label: said!("% of the exact total").to_owned(),
        x_range: [0.0, (orders.len() - 1) as f64],
        y_range: Some(NEGLECTED_PERCENT),
        y_scale: Scale::Log10,
        series,
        notes: of_subject(app),
        ..Chart::default()
    })
}

/// Errors of straight lines between samples against their number, and the composite's as level
/// lines; `None` for an all-zero spectrum.
pub fn samples_chart(app: &App, claims: &Claims) -> Option<Chart> {
    let found = claims.samples.as_ref()?;
    let first = found.tried.last()?.samples.max(2) as f64;
    let last = found.tried.first()?.samples as f64;
    // Marks a twentieth of their count apart, so that they do not cover the line.
    let apart = |points: &[[f64; 2]]| -> Vec<[f64; 2]> {
        let mut last = f64::INFINITY;
        let far = points.iter().filter(|p| {
            let is_far = p[0] <= 0.95 * last;
            if is_far {
                last = p[0];
            }
            is_far
        });
        far.copied().collect()
    };
    let (mut series, mut levels) = (Vec::new(), Vec::new());
    let mut pair = |measure: Measure, ink: Ink, shape: Shape| {
        let figure = measure.figure();
        let at = |s: &SampledErrors| Some([s.samples as f64, figure.drawn(s.errors[measure]?)]);
        let points: Vec<[f64; 2]> = found.tried.iter().filter_map(at).collect();
        let Some(own) = found.composite[measure].filter(|_| !points.is_empty()) else {
            return;
        };
        let own = figure.drawn(own);
        let level = vec![[first, own], [last, own]];
        series.push(thin("", ink, points.clone(), Dash::Solid));
        series.push(Series::points(
            figure.with_unit(),
            ink,
            shape,
            apart(&points),
        ));
        series.push(thin(said!("the composite"), ink, level, Dash::Dashed));
        levels.push(own);
    };
    pair(Measure::Own, Ink::Smooth, Shape::Dot);
    pair(Measure::RmsBlurred, Ink::Spikes, Shape::Triangle);
    // Samples at every nm lose nothing: that end leaves the picture at its foot.
    let lowest = levels.iter().copied().fold(f64::INFINITY, f64::min);
    let heights = series.iter().flat_map(|s: &Series| s.marks.points());
    let highest = heights.map(|p| p[1]).fold(0.0, f64::max);
    Some(Chart {
        y_range: (lowest < highest).then_some([lowest / 5.0, 2.0 * highest]),
        title: tr!(
            "Samples against {numbers}",
            numbers = numbers(found.numbers())
        ),
        x_label: said!("Samples, joined by straight lines").to_owned(),
        y_label: said!("ΔE₀₀, or %").to_owned(),
        x_range: [first, last.max(first + 1.0)],
        x_scale: Scale::Log10,
        y_scale: Scale::Log10,
        series,
        notes: of_subject(app),
        ..Chart::default()
    })
}

/// The colour-matching functions and Table 2's bells; `None` where the range has nothing of them.
pub fn table_2_chart(app: &App, claims: &Claims) -> Option<Chart> {
    let band = claims.band;
    let [low, high] = [
        band.min_nm().max(VISIBLE_NM[0]),
        band.max_nm().min(VISIBLE_NM[1]),
    ];
    if low >= high {
        return None;
    }
    let table = claims.observer.table();
    let colours = channel_inks();
    let grid = || band.grid().filter(|nm| (low..=high).contains(nm));
    let mut series = Vec::new();
    for k in 0..3 {
        let exact = grid().map(|nm| [nm, table.at(nm)[k]]).collect();
        series.push(Series::line(FUNCTIONS[k], colours[k], exact));
    }
    for k in 0..3 {
        let fit = grid()
            .map(|nm| [nm, gaussian_cmf::fitted_at(nm)[k]])
            .collect();
        series.push(thin(said!("fit"), Ink::Measured, fit, Dash::Dashed));
    }
    let worst = claims.table_2.worst.map(|d| [d.at_nm, d.fit]).to_vec();
    let words = claims
        .table_2
        .worst
        .map(|d| with_sign(format!("{:+.3}", d.off())));
    series.push(
        Series::points(said!("largest deviation"), Ink::Product, Shape::Ring, worst)
            .with_notes(words.to_vec()),
    );
    Some(Chart {
        title: said!("Colour-matching functions and Table 2").to_owned(),
        y_label: said!("value").to_owned(),
        series,
        notes: of_subject(app),
        ..Chart::over_nm([low, high])
    })
}

fn thin(name: &str, ink: Ink, points: Vec<[f64; 2]>, dash: Dash) -> Series {
    stroke(name, ink, points, 1.3, dash)
}
