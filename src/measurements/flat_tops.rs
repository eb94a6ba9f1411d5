//! Flat tops: where an instrument was at the end of its scale.
//!
//! A run of equal samples at the largest value is no sign by itself: tables drawn finer than they
//! were measured, rounded ones and lights whose top is wide have them. The run must be longer than
//! the table's own step, and the flanks beside it so steep that a top without clipping would rise
//! well above it.

use super::measurement::Measurement;

/// Samples within this share of the largest value are at it.
const AT_THE_TOP: f64 = 1e-4;
/// Fewest neighbours of a flat top.
const LEAST_RUN: usize = 3;
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
    let least_run = match ENDS_OF_SCALES.contains(&top) && are_whole(values) {
        true => LEAST_RUN,
        false => LEAST_RUN.max(2 * own_step(n, &bend) + 1),
    };
    let rounding = rounding(values);
    let is_end = ENDS_OF_SCALES.contains(&top) && are_whole(values);
    let least_height = match is_end {
        true => LEAST_STEPS * rounding,
        false => (LEAST_HEIGHT * top).max(LEAST_STEPS * rounding),
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
        let run = last - first + 1;
        let is_inside = first >= 1 && last + 1 < n;
        if is_inside && run >= least_run && 2 * run < n {
            let drops = [
                values[first] - values[first - 1],
                values[last] - values[last + 1],
            ];
            let missing = 0.5 * (drops[0] + drops[1]) * run as f64 / 4.0;
            if drops[0].min(drops[1]) >= least_height
                && missing >= least_height
                && !(is_straight(first, -1, n, &bend) && is_straight(last, 1, n, &bend))
            {
                found.push(FlatTop {
                    from_nm: nm[first],
                    to_nm: nm[last],
                    is_sure: top != ENDS_OF_SCALES[0] || !is_end,
                });
            }
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
