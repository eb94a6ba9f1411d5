//! A measurement as a chart: its curve with the band that holds it 95 times of 100, and gaps where it
//! holds no value.

use crate::{
    app::{
        chart::{Ink, Series},
        ticks::short,
    },
    measurements::Measurement,
};

/// Half width of 95 % in standard deviations.
const OF_95: f64 = 1.96;

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
        let name = format!("level \u{b1} {} %", short(100.0 * OF_95 * of.level));
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
    use crate::{measurements::Quantity, spectrum::Sampled};

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
