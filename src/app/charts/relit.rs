//! The charts of a picture in few numbers: error against numbers, and one pixel's spectrum.

use crate::{
    app::{
        chart::{Chart, Dash, Ink, Scale, Series, Shape},
        charts::units::kind_label,
        relit::{Fit, Looked, Turned},
    },
    languages::fixed,
    pictures::{Candidate, ReferenceKind},
};

/// The least error that is drawn.
const LEAST: f64 = 1e-3;

/// The error of every way that was tried against its numbers, `now` marked: of colours under six
/// lights, or of the spectra where nobody knows what lit the picture.
pub fn error_chart(looked: &Looked, now: usize) -> Chart {
    let choice = &looked.choice;
    let is_of_colour = looked.bands().is_factor() || looked.known.is_some();
    let of = |c: &Candidate| {
        if is_of_colour { c.p95 } else { 100.0 * c.rms }
    };
    let bound = if is_of_colour {
        choice.bound_p95
    } else {
        100.0 * choice.bound_rms
    };
    let [least, most] = looked.numbers();
    let mut series: Vec<Series> = vec![
        Series::line(
            "",
            Ink::Axis,
            vec![[least as f64, bound], [most as f64, bound]],
        )
        .dashed(Dash::Dashed),
    ];
    for (kind, has_lines, name, ink) in ways(looked) {
        let points: Vec<[f64; 2]> = (least..=most)
            .filter_map(|numbers| {
                let tried = choice.tried.iter().filter(|c| {
                    c.numbers == numbers && c.reference == kind && (c.lines > 0) == has_lines
                });
                let least = tried.map(of).min_by(f64::total_cmp)?;
                Some([numbers as f64, least.max(LEAST)])
            })
            .collect();
        if !points.is_empty() {
            series.push(Series::line(name, ink, points));
        }
    }
    let marked = choice.with_numbers(now);
    let marked = marked.map(|c| [c.numbers as f64, of(c).max(LEAST)]);
    let marked = marked.into_iter().collect();
    series.push(Series::points("", Ink::Spikes, Shape::Dot, marked).sized(5.0));
    Chart {
        title: if is_of_colour {
            said!("ΔE₀₀ of 95 % of the pixels, six lights").to_owned()
        } else {
            said!("Spectra: relative rms, %").to_owned()
        },
        x_label: said!("Numbers a pixel").to_owned(),
        x_range: [least as f64 - 1.0, most as f64 + 1.0],
        y_scale: Scale::Log10,
        series,
        ..Chart::default()
    }
}

/// The ways that were tried: what the series multiplies, whether there are lines beside it, its
/// name and colour.
fn ways(looked: &Looked) -> [(ReferenceKind, bool, String, Ink); 5] {
    let light = looked
        .known
        .as_ref()
        .map_or(said!("light"), |light| light.name());
    let by_light = tr!("series × {light}", light);
    let by_mean = said!("series × mean");
    [
        (ReferenceKind::One, false, said!("series"), Ink::Smooth),
        (
            ReferenceKind::One,
            true,
            said!("series, lines"),
            Ink::Residual,
        ),
        (ReferenceKind::Light, false, &by_light, Ink::Smooth),
        (ReferenceKind::Mean, false, by_mean, Ink::Product),
        (
            ReferenceKind::Mean,
            true,
            said!("series × mean, lines"),
            Ink::Spikes,
        ),
    ]
    .map(|(kind, has_lines, name, ink)| (kind, has_lines, name.to_owned(), ink))
}

/// Boxes of the histogram.
const BOXES: usize = 40;

/// How many of the drawn pixels are off by how much under the light.
pub fn difference_chart(turned: &Turned) -> Chart {
    let spread = turned.spread;
    let is_none = spread.max < LEAST;
    let most = if is_none { 1.0 } else { spread.max };
    let width = most / BOXES as f64;
    let mut counts = [0_usize; BOXES];
    let found = turned.off.iter().filter(|off| off.is_finite());
    found.for_each(|off| {
        let at = (f64::from(*off) / width) as usize;
        counts[at.min(BOXES - 1)] += 1;
    });
    let highest = counts.iter().copied().max().unwrap_or(0).max(1) as f64;
    let boxes = counts.iter().enumerate();
    // A box of none has no height on an axis of ratios.
    let boxes = boxes.filter(|(_, count)| **count > 0);
    let points = boxes.map(|(i, count)| [(i as f64 + 0.5) * width, *count as f64]);
    let mut series = Vec::new();
    if !is_none {
        let boxes = Series::bars("", Ink::Smooth, 0.9 * width, points.collect());
        series.push(boxes);
        for (name, at, ink, dash) in [
            (said!("mean"), spread.mean, Ink::Measured, Dash::Solid),
            ("95 %", spread.p95, Ink::Spikes, Dash::Dashed),
            (said!("most"), spread.max, Ink::Product, Dash::Dotted),
        ] {
            let line = vec![[at, 0.5], [at, 2.0 * highest]];
            series.push(Series::line(format!("{name} {}", fixed(at, 2)), ink, line).dashed(dash));
        }
    }
    Chart {
        title: tr!(
            "Pixels by their difference under {light}",
            light = turned.light
        ),
        x_label: "ΔE₀₀".to_owned(),
        x_range: [0.0, 1.04 * most],
        y_label: said!("Pixels").to_owned(),
        y_range: Some([0.5, 2.0 * highest]),
        y_scale: Scale::Log10,
        blank: if is_none {
            said!("no pixel is off by 0.001").to_owned()
        } else {
            String::new()
        },
        series,
        ..Chart::default()
    }
}

/// A drawn pixel by every band and by few numbers, with the lines that all pixels share.
pub fn pixel_chart(fit: &Fit, [x, y]: [usize; 2]) -> Chart {
    let bands = fit.operator.bands();
    let nm = bands.nm();
    let [exact, few] = fit.pixel(x, y);
    let points = |values: &[f64]| -> Vec<[f64; 2]> {
        let all = nm.iter().zip(values);
        all.filter(|(_, v)| v.is_finite())
            .map(|(nm, v)| [*nm, *v])
            .collect()
    };
    let step = fit.looked.0.step;
    let mut series = vec![
        Series::line(said!("every band"), Ink::Measured, points(&exact)),
        Series::line(said!("few numbers"), Ink::Spikes, points(&few)).dashed(Dash::Dashed),
    ];
    let stems = stems(fit, &exact, &few);
    if !stems.is_empty() {
        let (base, points) = stems.into_iter().unzip();
        series.push(Series::stems(said!("lines"), Ink::Spikes, points, base));
    }
    Chart {
        title: tr!(
            "Pixel in column {column}, row {row}",
            column = x * step,
            row = y * step
        ),
        y_label: kind_label(bands.kind(), ""),
        blank: if series[0].marks.points().is_empty() {
            said!("not measured").to_owned()
        } else {
            String::new()
        },
        series,
        ..Chart::over_nm([nm[0], nm[nm.len() - 1]])
    }
}

/// Foot and head of each line in a pixel: what it adds at its highest band.
fn stems(fit: &Fit, exact: &[f64], few: &[f64]) -> Vec<(f64, [f64; 2])> {
    let plan = fit.operator.plan();
    let numbers = fit.operator.numbers_of(exact);
    let lines = plan.lines.iter().zip(&numbers[plan.series..]);
    lines
        .filter_map(|(line, weight)| {
            let shape = line.shape.iter().enumerate();
            let (band, height) = shape.max_by(|a, b| a.1.total_cmp(b.1))?;
            let head = few[band];
            let foot = head - weight * height;
            (head.is_finite() && foot.is_finite()).then_some((foot, [line.at_nm, head]))
        })
        .collect()
}
