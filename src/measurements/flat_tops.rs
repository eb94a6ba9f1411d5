//! Flat tops: where an instrument was at the end of its scale.
//!
//! A run of equal samples at the largest value is no sign by itself: tables drawn finer than they
//! were measured, rounded ones and lights whose top is wide have them. The run must be longer than
//! the table's own step, and the flanks beside it so steep that a top without clipping would rise
//! well above it. Whole numbers whose largest is the end of a converter's scale say so themselves:
//! there two neighbours, or three at an end of the table, are enough.

use super::measurement::Measurement;

/// Samples within this share of the largest value are at it.
const AT_THE_TOP: f64 = 1e-4;
/// Fewest neighbours of a flat top.
const LEAST_RUN: usize = 3;
/// Fewest at the end of the scale of a converter of more than 8 bit: a line that is no wider has
/// them by chance once in tens of thousands of tables.
const LEAST_AT_THE_END: usize = 2;
/// Second differences below this share of the largest value are those of straight lines.
const STRAIGHT: f64 = 2e-4;
/// Least height that is missing, a share of the largest value.
const LEAST_HEIGHT: f64 = 0.002;
/// The same in steps of what the values are rounded to.
const LEAST_STEPS: f64 = 4.0;
/// Ends of the scales of converters, 8 to 16 bit.
const ENDS_OF_SCALES: [f64; 7] = [255.0, 1023.0, 4095.0, 8191.0, 16_383.0, 32_767.0, 65_535.0];

/// A stretch in which the top is cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlatTop {
    /// First wavelength at the top, nm.
    pub from_nm: f64,
    /// Last wavelength at the top, nm.
    pub to_nm: f64,
    /// False for 8 bit, where a light's own top may be as flat: "may be clipped".
    pub is_sure: bool,
}

/// The flat tops of a table.
pub fn flat_tops(of: &Measurement) -> Vec<FlatTop> {
    let (nm, values) = (of.samples.nm(), of.samples.values());
    let top = values.iter().copied().fold(0.0, f64::max);
    let n = values.len();
    if n < 8 || top <= 0.0 {
        return Vec::new();
    }
    let bend = |i: usize| (values[i - 1] - 2.0 * values[i] + values[i + 1]).abs() / top;
    let is_end = ENDS_OF_SCALES.contains(&top) && are_whole(values);
    let is_byte = is_end && top == ENDS_OF_SCALES[0];
    // More than 8 bit: a light's own top is not as flat at the very end of the scale.
    let is_sure_end = is_end && !is_byte;
    let least_run = match is_end {
        true => LEAST_RUN,
        false => LEAST_RUN.max(2 * own_step(n, &bend) + 1),
    };
    let rounding = rounding(values);
    let least_height = match is_end {
        true => LEAST_STEPS * rounding,
        false => (LEAST_HEIGHT * top).max(LEAST_STEPS * rounding),
    };
    let is_flat = |first: usize, last: usize| {
        let run = last - first + 1;
        let is_cut_off = first == 0 || last + 1 == n;
        let is_exact = is_sure_end && values[first..=last].iter().all(|v| *v == top);
        let before = (first > 0).then(|| values[first] - values[first - 1]);
        let behind = (last + 1 < n).then(|| values[last] - values[last + 1]);
        let (drop, flanks) = match (before, behind) {
            (Some(a), Some(b)) => (a.min(b), 0.5 * (a + b)),
            // At an end of the table half of the top is out of sight.
            (Some(one), None) | (None, Some(one)) if is_exact && run >= LEAST_RUN => (one, one),
            _ => return false,
        };
        let is_long = run >= least_run || is_exact && run >= LEAST_AT_THE_END;
        let missing = flanks * run as f64 / 4.0;
        is_long
            && 2 * run < n
            && drop >= least_height
            && missing >= least_height
            && (is_cut_off || !(is_straight(first, -1, n, &bend) && is_straight(last, 1, n, &bend)))
    };
    let mut found = Vec::new();
    let mut first = 0;
    while first < n {
        if values[first] < top * (1.0 - AT_THE_TOP) {
            first += 1;
            continue;
        }
        let mut last = first;
        while last + 1 < n && values[last + 1] >= top * (1.0 - AT_THE_TOP) {
            last += 1;
        }
        if is_flat(first, last) {
            found.push(FlatTop {
                from_nm: nm[first],
                to_nm: nm[last],
                is_sure: !is_byte,
            });
        }
        first = last + 1;
    }
    found
}

fn are_whole(values: &[f64]) -> bool {
    values.iter().all(|v| v.fract() == 0.0)
}

/// Smallest difference between values that differ: what they are rounded to.
fn rounding(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let steps = sorted.windows(2).map(|w| w[1] - w[0]);
    let least = steps.filter(|d| *d > 0.0).fold(f64::INFINITY, f64::min);
    if least.is_finite() { least } else { 0.0 }
}

/// Samples from one of the table's own points to the next: 1, or more where a coarser table was
/// drawn on this grid by straight lines.
fn own_step(points: usize, bend: &dyn Fn(usize) -> f64) -> usize {
    let kinks: Vec<usize> = (1..points - 1).filter(|i| bend(*i) > STRAIGHT).collect();
    // A point between two samples of the grid bends both.
    let mut groups: Vec<(usize, usize)> = Vec::new();
    for kink in kinks {
        match groups.last_mut() {
            Some(last) if last.1 + 1 == kink => last.1 = kink,
            _ => groups.push((kink, kink)),
        }
    }
    let in_runs: usize = groups
        .iter()
        .filter(|g| g.1 - g.0 >= 2)
        .map(|g| g.1 - g.0 + 1)
        .sum();
    let all: usize = groups.iter().map(|g| g.1 - g.0 + 1).sum();
    if groups.len() < 3 || 4 * in_runs > all {
        return 1;
    }
    let mut gaps: Vec<usize> = groups.windows(2).map(|w| w[1].0 - w[0].0).collect();
    gaps.sort_unstable();
    gaps[gaps.len() / 2]
}

/// True if the four samples beyond an end of a run stand on a straight line.
fn is_straight(end: usize, towards: isize, points: usize, bend: &dyn Fn(usize) -> f64) -> bool {
    (2..=3).all(|k| {
        let at = end as isize + towards * k;
        at < 1 || at as usize + 1 >= points || bend(at as usize) <= STRAIGHT
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{measurements::Quantity, spectrum::Sampled};

    /// A line 2 nm wide on a slope that rises to the end, in pixels of .35 nm, in whole numbers that
    /// end at `end`; both would reach so many ends.
    fn pixels(end: f64, line: f64, slope: f64) -> Measurement {
        let value = |i: i32| {
            let nm = 500.0 + 0.35 * f64::from(i);
            let x = f64::from(i) / 400.0;
            let line = line * (-((nm - 546.1) / 1.2).powi(2)).exp();
            (end * (0.1 + line + slope * x * x)).round().min(end)
        };
        let samples = Sampled::even(500.0, 0.35, (0..=400).map(value).collect());
        Measurement::new("a", Quantity::Counts, "counts", samples.expect("finite"))
    }

    #[test]
    fn a_line_of_two_pixels_at_the_end_of_a_scale_is_cut_and_below_it_is_none() {
        for end in [4095.0, 65_535.0] {
            let found = flat_tops(&pixels(end, 1.0, 0.0));
            assert_eq!(found.len(), 1, "{end}");
            let two = found[0].to_nm - found[0].from_nm;
            assert!(found[0].is_sure && two < 1.0, "{found:?}");
            assert_eq!(flat_tops(&pixels(end, 0.89, 0.0)), [], "{end}");
            // A scale that no converter has.
            assert_eq!(flat_tops(&pixels(end - 7.0, 1.0, 0.0)), [], "{end}");
        }
    }

    #[test]
    fn what_is_cut_at_the_end_of_the_table_is_told_and_a_rise_to_it_is_not() {
        let found = flat_tops(&pixels(65_535.0, 0.3, 1.2));
        assert_eq!(found.len(), 1);
        assert!((found[0].to_nm - 640.0).abs() < 1e-9, "{found:?}");
        assert_eq!(flat_tops(&pixels(65_535.0, 0.3, 0.9)), []);
        // In 8 bit a light's own top may be as flat.
        assert_eq!(flat_tops(&pixels(255.0, 0.3, 1.2)), []);
    }
}
