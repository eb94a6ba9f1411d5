//! A measurement as a chart: its curve with the band that holds it 95 times of 100, and gaps where it
//! holds no value.

use crate::measurements::OF_95;
use crate::{
    app::{
        chart::{Chart, Dash, Ink, Panel, Series, Shape, stroke},
        combining::{Found, LineRow, Part, measurements},
    },
    languages::with_sign,
    measurements::{Measurement, Quantity, mean_of, rounded},
    spectrum::Band,
};

/// What a combination made, over the readings of its kind that it was made of.
pub fn combined_chart(found: &Found, title: String, parts: &[Part]) -> Chart {
    let of = found.result();
    let mut chart = Chart { title, ..over(of) };
    let is_light = of.quantity == Quantity::Light;
    let values = of.samples.values();
    let curves = || stretches(of, |i| values[i]);
    if is_light && let Ok(band) = Band::new(chart.x_range[0].ceil(), chart.x_range[1].floor()) {
        let area = |points| Series::area("", Ink::Measured, points, Vec::new()).coloured();
        chart.series.extend(curves().map(area));
        chart.colours = band.grid().map(Ink::Wavelength).collect();
    }
    for (index, part) in parts.iter().enumerate() {
        let is_kept = found.scans.get(index).is_none_or(|scan| scan.is_kept);
        let (name, dash) = match is_kept {
            true => (said!("as read"), Dash::Solid),
            false => (said!("left out"), Dash::Dotted),
        };
        if (part.of.quantity, &part.of.unit) == (of.quantity, &of.unit) {
            chart.series.extend(thin(&part.of, name, Ink::Smooth, dash));
        }
    }
    chart.series.extend(doubted(of, "95 %", 1.0));
    let curve = |points| Series::line(said!("result"), Ink::Measured, points);
    chart.series.extend(curves().map(curve));
    let at = |line: &LineRow| Some([line.at_nm, line.weight?]);
    let points: Vec<[f64; 2]> = found.lines.iter().filter_map(at).collect();
    if !is_light && !points.is_empty() {
        let ring = Series::points(said!("at shared lines"), Ink::Spikes, Shape::Ring, points);
        chart.series.push(ring);
    }
    chart
}

/// Two sets of readings, and what their means differ by where both are of one kind and grid.
pub fn readings_chart(sets: &[Vec<Part>; 2]) -> Chart {
    let Some(first) = sets.iter().flatten().next() else {
        return Chart::default();
    };
    let mut chart = over(&first.of);
    let inks = [Ink::Measured, Ink::Second];
    for part in sets.iter().flatten() {
        let nm = part.of.samples.nm();
        chart.x_range[0] = chart.x_range[0].min(nm[0]);
        chart.x_range[1] = chart.x_range[1].max(nm[nm.len() - 1]);
    }
    for ((set, ink), name) in sets
        .iter()
        .zip(inks)
        .zip([said!("first set"), said!("second set")])
    {
        let name = if sets[1].is_empty() {
            said!("as read")
        } else {
            name
        };
        let curves = set
            .iter()
            .flat_map(|part| thin(&part.of, name, ink, Dash::Solid));
        chart.series.extend(curves);
    }
    let means = sets.each_ref().map(|set| mean_of(&measurements(set)).ok());
    if let [Some(first), Some(second)] = means
        && first.samples.nm() == second.samples.nm()
        && first.unit == second.unit
    {
        let pairs = second.samples.values().iter().zip(first.samples.values());
        let rest = pairs.map(|(second, first)| second - first);
        let points = first.samples.nm().iter().copied().zip(rest);
        let points = points.map(|(nm, value)| [nm, value]).collect();
        chart.residual = Some(Panel {
            y_label: said!("second - first").to_owned(),
            series: vec![Series::line(said!("difference"), Ink::Residual, points)],
            ..Panel::default()
        });
    }
    chart
}

/// An empty chart over the wavelengths of a measurement.
fn over(of: &Measurement) -> Chart {
    let nm = of.samples.nm();
    let y_label = match (of.quantity, of.unit.as_str()) {
        (Quantity::Counts, _) => said!("Counts"),
        (Quantity::Light, "") => said!("Relative power"),
        (Quantity::Light, unit) => unit,
        (Quantity::Absorbance, _) => said!("Absorbance"),
        (Quantity::Reflectance, _) => said!("Reflectance"),
        (Quantity::Transmittance, _) => said!("Transmittance"),
        (Quantity::Factor | Quantity::Number, _) => said!("Factor"),
    };
    Chart {
        y_label: y_label.to_owned(),
        ..Chart::over_nm([nm[0], nm[nm.len() - 1]])
    }
}

/// The values of a measurement as thin lines.
fn thin(of: &Measurement, name: &str, ink: Ink, dash: Dash) -> Vec<Series> {
    let values = of.samples.values();
    let curves = stretches(of, |i| values[i]);
    let curve = |points| stroke(name, ink, points, 1.0, dash);
    curves.map(curve).collect()
}

/// The band about a measurement times a factor, and its level as a bracket at the right edge; none
/// where nothing is known of its noise.
pub fn doubted(of: &Measurement, name: &str, by: f64) -> Vec<Series> {
    let mut series = Vec::new();
    let values = of.samples.values();
    if let Some(sigma) = &of.sigma {
        let upper = stretches(of, |i| by * (values[i] + OF_95 * sigma[i]));
        let lower = stretches(of, |i| by * (values[i] - OF_95 * sigma[i]));
        series.extend(upper.zip(lower).map(|(upper, lower)| {
            let base = lower.iter().map(|point| point[1]).collect();
            Series::area(name, Ink::Measured, upper, base)
        }));
    }
    let last = (0..values.len()).rev().find(|i| of.is_kept(*i));
    if let Some(last) = last.filter(|_| of.level > 0.0) {
        let (nm, value) = (of.samples.nm()[last], by * values[last]);
        let ends = [1.0, -1.0].map(|sign| [nm, value * (1.0 + sign * OF_95 * of.level)]);
        let half = 100.0 * OF_95 * of.level;
        let half = with_sign(rounded(half, half).1);
        let name = tr!("level \u{b1} {half} %", half);
        series.push(Series::line(name, Ink::Faint, ends.to_vec()));
    }
    series
}

/// The stretches of a measurement that hold values, as points.
fn stretches(
    of: &Measurement,
    value: impl Fn(usize) -> f64,
) -> impl Iterator<Item = Vec<[f64; 2]>> {
    let nm = of.samples.nm();
    let mut all = vec![Vec::new()];
    for (i, nm) in nm.iter().enumerate() {
        match (of.is_kept(i), all.last_mut()) {
            (true, Some(points)) => points.push([*nm, value(i)]),
            (false, Some(points)) if !points.is_empty() => all.push(Vec::new()),
            _ => {}
        }
    }
    all.into_iter().filter(|points| !points.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spectrum::Sampled;

    #[test]
    fn a_mask_is_a_gap_and_the_band_holds_two_sigmas_about_the_curve() {
        let samples = Sampled::even(400.0, 1.0, vec![1.0, 0.0, 3.0, 4.0]).expect("finite");
        let mut of = Measurement::new("t", Quantity::Transmittance, "", samples);
        of.sigma = Some(vec![0.1, 0.0, 0.2, 0.1]);
        of.mask = vec![false, true, false, false];
        let parts: Vec<_> = stretches(&of, |i| of.samples.values()[i]).collect();
        assert_eq!(
            parts,
            [vec![[400.0, 1.0]], vec![[402.0, 3.0], [403.0, 4.0]]]
        );
        let band = doubted(&of, "95 %", 1.0);
        assert_eq!(band.len(), 2);
        let upper = band[1].marks.points()[0][1];
        assert!((upper - (3.0 + 0.2 * 1.96)).abs() < 1e-12, "{upper}");
        of.sigma = None;
        assert_eq!(doubted(&of, "95 %", 1.0), []);
    }
}
