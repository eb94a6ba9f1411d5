//! The error against the order, as a chart of all errors and of one.

use super::spectrum::{basis_words, provenance};
use crate::{
    app::{
        chart::{Chart, Dash, Ink, Marks, Scale, Series, Shape, stroke},
        derived::{OF_CURVE, OrderPoint},
        figures::SMALLEST,
        state::App,
        ticks::extent,
        verdicts::{HARD_TO_SEE, Seen},
    },
    study::Measure,
};

/// An error at every order: CIEDE2000, or percent.
fn errors(app: &App, measure: Measure) -> Vec<[f64; 2]> {
    let drawn = |error: f64| measure.figure().drawn(error);
    let point = |p: &OrderPoint| Some([p.order as f64, drawn(p.figures[measure]?)]);
    app.derived().curve.iter().filter_map(point).collect()
}

/// The errors against the order as a chart: colour differences, and relative errors in percent.
pub fn curve_chart(app: &App) -> Chart {
    let (document, derived) = (app.document(), app.derived());
    let of_series = [
        Ink::Measured,
        Ink::Smooth,
        Ink::Product,
        Ink::Spikes,
        Ink::Residual,
    ];
    let series = OF_CURVE.iter().zip(of_series).map(|(measure, ink)| {
        let name = measure.figure().with_unit();
        Series::line(name, ink, errors(app, *measure))
    });
    Chart {
        title: tr!(
            "{subject}: error against waves ({basis}, {n} line)"
                | "{subject}: error against waves ({basis}, {n} lines)"
                    % derived.model.lines().len(),
            subject = document.subject_entry().name(),
            basis = basis_words(derived.model.smooth().basis)
        ),
        x_label: said!("Waves").to_owned(),
        y_label: said!("Error (CIEDE2000, or percent)").to_owned(),
        x_range: [
            0.0,
            derived.curve.last().map_or(1.0, |p| p.order.max(1) as f64),
        ],
        y_scale: Scale::Log10,
        series: series.filter(|s| !s.marks.points().is_empty()).collect(),
        notes: provenance(app),
        ..Chart::default()
    }
}

/// One of the errors against the order with the order in force marked; `None` where there is none.
pub fn order_chart(app: &App, measure: Measure) -> Option<Chart> {
    let points = errors(app, measure);
    let [lowest, highest] = extent(points.iter().map(|p| p[1].log10()))?;
    let decades = [(lowest - 0.1).floor().max(SMALLEST.log10()), highest.ceil()];
    let air = 0.08 * (decades[1] - decades[0]);
    let y_range = [decades[0] - air, decades[1] + air].map(|log| 10_f64.powf(log));
    let last = points.last().map_or(1.0, |p| p[0].max(1.0));
    let x_range = [-0.02 * last, 1.02 * last];
    let order = app.derived().model.smooth().order() as f64;
    let faint = Ink::Axis;
    let thin = |ends: [[f64; 2]; 2]| stroke("", faint, ends.to_vec(), 1.1, Dash::Solid);
    let dots = |colour: Ink, radius: f64, points: Vec<[f64; 2]>| {
        Series::points("", colour, Shape::Dot, points).sized(radius)
    };
    let now = points.iter().copied().filter(|p| p[0] == order).collect();
    let mut series = vec![thin(y_range.map(|y| [order, y]))];
    if measure.is_colour() {
        let below = x_range.map(|x| [x, HARD_TO_SEE.min(y_range[1])]).to_vec();
        let floor = vec![y_range[0]; 2];
        series.push(Series::area(
            Seen::Hardly.seen(),
            Ink::Residual,
            below,
            floor,
        ));
        // A chart that begins above the limit has no room for its name. At the right end the curve
        // is farthest below.
        if y_range[0] < HARD_TO_SEE {
            let decades = (y_range[1] / y_range[0]).log10();
            let at = [0.82 * last, HARD_TO_SEE * 10_f64.powf(-0.09 * decades)];
            let words = vec![(at, Seen::Hardly.seen().to_owned())];
            series.push(Series::new("", Ink::Residual, Marks::Words { words }));
        }
        series.push(thin(x_range.map(|x| [x, HARD_TO_SEE])));
    }
    series.push(Series::line("", Ink::Smooth, points.clone()));
    series.push(dots(Ink::Smooth, 1.8, points));
    series.push(dots(Ink::Spikes, 4.5, now));
    Some(Chart {
        x_label: said!("Waves").to_owned(),
        x_range,
        y_range: Some(y_range),
        y_scale: Scale::Log10,
        y_unit: measure.figure().unit.tail.to_owned(),
        series,
        ..Chart::default()
    })
}
