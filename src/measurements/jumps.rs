//! Moments at which series over time jump: the five values behind a moment against the five before it.
//!
//! A lamp that warms up changes all the time and does not jump, so that both sides share one slope:
//! the jump is what the ten values leave beside it. How far that strays by noise alone, its memory
//! included, the moments before and behind tell, the noisier of both; where the ten values stray much
//! more about their own lines, as beside a flash, that counts. All moments of all series are tested together by Holm's procedure.

use super::statistics::LEVEL_OF_TEST;
use super::statistics::{holm, two_sided_p};

/// Values on either side.
const SIDE: usize = 5;
/// Weights of the values behind a moment, the nearest first, and of those before it with the other
/// sign: least squares of a step over a common slope.
const WEIGHTS: [f64; SIDE] = [0.7, 0.45, 0.2, -0.05, -0.3];
/// Sum of the squares of all ten.
const SQUARES: f64 = 1.65;
/// Degrees of freedom of ten values about a step and a slope.
const LOCAL_DOF: f64 = 7.0;
/// Ten values stray as much more than the noise around them in 1 of 5000 moments.
const FAR: f64 = 2.0;
/// Fewer values tell no noise.
const LEAST: usize = 30;
/// Of the sizes of all steps so large a share, the smallest, tells the noise: jumps are few.
const QUIET: f64 = 0.7;
/// Mean square of that share of normal numbers.
const OF_QUIET: f64 = 0.309_56;
/// Degrees of freedom that a value adds: neighbouring steps share most of their values.
const DOF: f64 = 0.3;
/// Moments on either side whose noise counts, at most and at least, and between two looks at it.
const REACH: usize = 150;
const LEAST_BESIDE: usize = 30;
const STRIDE: usize = 10;
/// A step below this share of the largest value is rounding.
const ROUNDING: f64 = 3e-5;

/// A series that jumps at a moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shift {
    /// Which of the series.
    pub series: usize,
    /// By how much it jumps, in its own unit.
    pub change: f64,
    /// Its standard uncertainty.
    pub u: f64,
    /// Probability of as much by chance.
    pub p: f64,
}

/// A moment at which one series or more jump.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// Place of the first value behind it.
    pub at: usize,
    /// What jumps, the surest first.
    pub shifts: Vec<Shift>,
}

/// The moments at which series of one length jump, in their order; a value that is not finite is
/// none.
pub fn jumps(series: &[Vec<f64>]) -> Vec<Moment> {
    let mut tested: Vec<(usize, Shift)> = Vec::new();
    for (index, values) in series.iter().enumerate() {
        let shift = |(at, change, u, dof): (usize, f64, f64, f64)| {
            // What is no jump by any number of degrees needs no probability.
            let p = match change.abs() > 1.9 * u {
                true => two_sided_p(change / u, dof),
                false => 1.0,
            };
            let series = index;
            (
                at,
                Shift {
                    series,
                    change,
                    u,
                    p,
                },
            )
        };
        tested.extend(steps(values).into_iter().map(shift));
    }
    let all: Vec<f64> = tested.iter().map(|(_, shift)| shift.p).collect();
    let is_jump = holm(&all, LEVEL_OF_TEST);
    let found = tested.into_iter().zip(is_jump).filter(|(_, is)| *is);
    let mut found: Vec<(usize, Shift)> = found.map(|(tested, _)| tested).collect();
    found.sort_by(|a, b| sureness(&b.1).total_cmp(&sureness(&a.1)));
    // A jump shows at the moments beside it too: the surest stands for those that it reaches.
    let mut moments: Vec<Moment> = Vec::new();
    for (at, shift) in found {
        let near = moments.iter_mut().find(|m| m.at.abs_diff(at) <= SIDE);
        match near {
            None => moments.push(Moment {
                at,
                shifts: vec![shift],
            }),
            Some(moment) if moment.shifts.iter().all(|s| s.series != shift.series) => {
                moment.shifts.push(shift);
            }
            Some(_) => {}
        }
    }
    moments.sort_by_key(|moment| moment.at);
    moments
}

fn sureness(shift: &Shift) -> f64 {
    (shift.change / shift.u).abs()
}

/// Every moment of a series with its step, that one's standard uncertainty and degrees of freedom.
fn steps(values: &[f64]) -> Vec<(usize, f64, f64, f64)> {
    let finite = || values.iter().filter(|v| v.is_finite());
    if finite().count() < LEAST {
        return Vec::new();
    }
    let all: Vec<(usize, f64, f64)> = (SIDE..=values.len() - SIDE)
        .filter_map(|at| {
            let (step, stray) = step_at(values, at);
            step.is_finite().then_some((at, step, stray))
        })
        .collect();
    let sizes: Vec<f64> = all.iter().map(|(_, step, _)| step.abs()).collect();
    let rounding = ROUNDING * finite().fold(0.0_f64, |most, v| most.max(v.abs()));
    let sides = noise_beside(&sizes);
    let told = |(index, (at, step, stray)): (usize, (usize, f64, f64))| {
        // None of the two takes in a moment of the other side.
        let (before, behind) = (sides[index / STRIDE].0, sides[index.div_ceil(STRIDE)].1);
        let (noise, count) = if before.0 > behind.0 { before } else { behind };
        let noise = noise.max(rounding);
        let dof = DOF * count as f64;
        match stray > FAR * noise {
            true => (at, step, stray, dof.min(LOCAL_DOF)),
            false => (at, step, noise, dof),
        }
    };
    all.into_iter().enumerate().map(told).collect()
}

/// Noise of the steps before and behind every so many of them, with how many tell it: a light that is
/// dimmed is noisier from then on.
fn noise_beside(sizes: &[f64]) -> Vec<((f64, usize), (f64, usize))> {
    let least = LEAST_BESIDE.min(sizes.len());
    let noise = |from: usize, to: usize| {
        let found = quiet(sizes[from..to].to_vec());
        (found.unwrap_or(0.0), to - from)
    };
    let beside = |at: usize| {
        let at = at.min(sizes.len());
        let (to, from) = (at.max(least), at.min(sizes.len() - least));
        let before = noise(to.saturating_sub(REACH), to);
        (before, noise(from, (from + REACH).min(sizes.len())))
    };
    let places = 0..=sizes.len().div_ceil(STRIDE);
    places.map(|place| beside(place * STRIDE)).collect()
}

/// The step at a moment, and its standard uncertainty by what the ten values leave.
fn step_at(values: &[f64], at: usize) -> (f64, f64) {
    let (before, behind) = (&values[at - SIDE..at], &values[at..at + SIDE]);
    let pairs = || behind.iter().zip(before.iter().rev()).zip(WEIGHTS);
    let step: f64 = pairs().map(|((b, a), weight)| weight * (b - a)).sum();
    // About the middle: half the step to each side, and the slope.
    let side = SIDE as f64;
    let mean = (before.iter().sum::<f64>() + behind.iter().sum::<f64>()) / (2.0 * side);
    let place = |k: usize| k as f64 + 0.5;
    let (moment, squares) = (0..SIDE).fold((0.0, 0.0), |(moment, squares), k| {
        let rest = behind[k] - before[SIDE - 1 - k] - step;
        (moment + place(k) * rest, squares + 2.0 * place(k).powi(2))
    });
    let slope = moment / squares;
    let left = |value: f64, sign: f64, k: usize| {
        (value - mean - sign * (0.5 * step + slope * place(k))).powi(2)
    };
    let rest: f64 = (0..SIDE)
        .map(|k| left(behind[k], 1.0, k) + left(before[SIDE - 1 - k], -1.0, k))
        .sum();
    (step, (SQUARES * rest / LOCAL_DOF).sqrt())
}

/// Standard deviation of numbers of these sizes, most of which are noise.
fn quiet(mut sizes: Vec<f64>) -> Option<f64> {
    let most = (QUIET * sizes.len() as f64).ceil() as usize;
    let last = most.checked_sub(1)?;
    sizes.select_nth_unstable_by(last, f64::total_cmp);
    let squares: f64 = sizes[..most].iter().map(|size| size * size).sum();
    Some((squares / (most as f64 * OF_QUIET)).sqrt())
}

/// Standard deviation of the values of a series by the differences of neighbours; `None` for too few.
pub fn scatter(values: &[f64]) -> Option<f64> {
    let sizes = values.windows(2).map(|pair| (pair[1] - pair[0]).abs());
    let sizes: Vec<f64> = sizes.filter(|size| size.is_finite()).collect();
    let is_told = sizes.len() + 1 >= LEAST;
    quiet(sizes).filter(|_| is_told).map(|of| of / 2_f64.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measurements::normal;

    /// Noise of deviation 1, each value the mean of so many, times their root.
    fn noise(seed: u64, count: usize, memory: usize) -> Vec<f64> {
        let white: Vec<f64> = normal(seed).take(count + memory).collect();
        let root = (memory as f64).sqrt();
        let mean = |values: &[f64]| values.iter().sum::<f64>() / root;
        white.windows(memory).take(count).map(mean).collect()
    }

    #[test]
    fn noise_of_any_memory_and_a_slope_jump_in_5_of_100_sets_at_most() {
        for (count, memory) in [(30, 1), (100, 1), (100, 4), (1000, 1), (1000, 16)] {
            let sets = if count > 500 { 60 } else { 300 };
            let mut false_sets = 0;
            for set in 0..sets {
                let one = |k: u64| {
                    let own = noise(1000 * set + k, count, memory).into_iter();
                    let slope = 0.3 * k as f64;
                    own.enumerate().map(|(i, v)| v + slope * i as f64).collect()
                };
                let series: Vec<Vec<f64>> = (0..12).map(one).collect();
                false_sets += i32::from(!jumps(&series).is_empty());
            }
            // 5 % and two standard deviations of so many sets.
            let most = 0.05 * f64::from(sets as u32);
            let most = most + 2.0 * most.sqrt();
            assert!(
                f64::from(false_sets) <= most,
                "{count} values, memory {memory}: {false_sets} of {sets}"
            );
        }
    }

    #[test]
    fn where_the_noise_doubles_nothing_jumps() {
        let mut false_sets = 0;
        for set in 0..200 {
            let one = |k: u64| {
                let values = noise(90_000 + 1000 * set + k, 200, 1)
                    .into_iter()
                    .enumerate();
                values
                    .map(|(i, v)| if i < 50 { v } else { 2.0 * v })
                    .collect()
            };
            let series: Vec<Vec<f64>> = (0..12).map(one).collect();
            false_sets += i32::from(!jumps(&series).is_empty());
        }
        // 5 % and two standard deviations of so many sets.
        assert!(false_sets <= 16, "{false_sets}");
    }

    #[test]
    fn a_jump_is_found_at_its_moment_in_the_series_that_has_it_and_a_flash_is_none() {
        let (mut found, mut alone) = (0, 0);
        for set in 0..50 {
            let one = |k: u64| noise(77_000 + 1000 * set + k, 200, 1);
            let mut series: Vec<Vec<f64>> = (0..12).map(one).collect();
            // Twelve of a value's deviations: nine of its own.
            series[3].iter_mut().skip(90).for_each(|v| *v += 12.0);
            let moments = jumps(&series);
            let is_there = |m: &Moment| {
                let shift = m.shifts[0];
                m.at == 90 && shift.series == 3 && (shift.change - 12.0).abs() < 5.0 * shift.u
            };
            found += i32::from(moments.iter().any(is_there));
            alone += i32::from(moments.len() == 1 && moments[0].shifts.len() == 1);
        }
        assert!(found >= 48 && alone >= 45, "{found} {alone}");
        let mut flash = noise(5, 200, 1);
        flash[100] += 50.0;
        assert_eq!(jumps(&[flash]), []);
    }

    #[test]
    fn a_step_of_a_still_light_is_told_and_gaps_and_short_series_are_none() {
        let still: Vec<f64> = (0..60).map(|i| if i < 30 { 1.0 } else { 1.01 }).collect();
        let moments = jumps(std::slice::from_ref(&still));
        assert_eq!(moments.len(), 1);
        assert_eq!(moments[0].at, 30);
        assert!((moments[0].shifts[0].change - 0.01).abs() < 1e-12);
        assert_eq!(jumps(&[vec![1.0; 200]]), []);
        assert_eq!(jumps(&[still[20..40].to_vec()]), []);
        let mut gap = still;
        gap[28..32].fill(f64::NAN);
        assert_eq!(jumps(&[gap]), []);
    }

    #[test]
    fn the_scatter_of_a_series_is_that_of_its_values_whatever_they_drift_by() {
        let values = noise(9, 2000, 1).into_iter().enumerate();
        let values: Vec<f64> = values.map(|(i, v)| 3.0 * v + 0.01 * i as f64).collect();
        let found = scatter(&values).expect("enough");
        // 2000 differences, of which the smaller 70 % are looked at: 3 %, three times.
        assert!((found / 3.0 - 1.0).abs() < 0.09, "{found}");
        assert_eq!(scatter(&values[..29]), None);
    }
}
