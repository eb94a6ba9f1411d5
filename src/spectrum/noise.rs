//! How noisy values on a grid are, told from the values themselves.
//!
//! Noise has no memory and a spectrum has: the second difference of samples leaves almost nothing
//! of a smooth spectrum and the square root of 6 times the noise. Lines leave much, but stand at
//! few samples, so a low quantile of the differences is taken. The noise of a spectrometer differs
//! along the spectrum (its sensitivity is divided out), so each place asks its own surroundings.

use std::cell::OnceCell;

/// Share of the second differences that are smaller than the one looked at: more than half of
/// the samples may belong to lines before it notices.
const QUANTILE: f64 = 0.3;
/// That quantile of the absolute value of a standard normal number.
const NORMAL_AT_QUANTILE: f64 = 0.385_320_466_407_568;
/// Standard deviation of a second difference over that of a sample: 1 + 4 + 1 variances.
const SECOND_DIFFERENCE: f64 = 2.449_489_742_783_178;
/// What was averaged onto the grid from finer data, or smoothed by an instrument, shares its noise
/// with its neighbours, and differs less from them than from those so many samples away. Not less
/// than this, though: what does is a curve.
const APART: usize = 2;
const LEAST_BESIDE: f64 = 1.0 / 1.5;
/// How far the surroundings of a place reach, grid points to either side: so many samples tell
/// the noise to a seventh.
const REACH: usize = 60;
/// Nowhere is less noise taken for true than this share of what there is in all.
const LEAST_SHARE: f64 = 0.85;
/// Fewer samples than this tell nothing.
const LEAST_SAMPLES: usize = 20;
/// A second difference below this share of the largest value is rounding, or a point between two
/// samples of a table coarser than the grid, where straight lines have none.
const ROUNDING: f64 = 1e-9;
/// From this step on (nm) samples do not share their noise, and the grid holds straight lines
/// between them.
const COARSE_STEP: f64 = 1.3;
/// Where more than this share of a coarse table's second differences stand far above its noise,
/// they are its lines: of the 81 samples of a metal halide lamp in 5 nm steps most stand on one.
const LINES_SHARE: f64 = 0.1;
/// What stands far above the noise, in its standard deviations.
const FAR_ABOVE: f64 = 3.0;

/// The noise of values on an even grid.
#[derive(Clone, Debug)]
pub struct Noise {
    /// Second differences of samples that share no noise.
    differences: Differences,
    /// Those of neighbours, where they may share some.
    beside: Option<Differences>,
    /// The noise of the values as a whole.
    overall: OnceCell<f64>,
}

impl Noise {
    /// The noise of some values.
    pub fn of(values: &[f64]) -> Self {
        let highest = values.iter().fold(0.0_f64, |top, v| top.max(v.abs()));
        let rounding = ROUNDING * highest;
        let neighbours = second_differences(values, 1, rounding);
        let samples = neighbours.iter().filter(|d| **d > 0.0).count();
        let step = neighbours.len() as f64 / samples as f64;
        let (differences, beside) = if samples < LEAST_SAMPLES {
            (Vec::new(), None)
        } else if step < COARSE_STEP {
            (
                second_differences(values, APART, rounding),
                Some(neighbours),
            )
        } else {
            (of_coarse(neighbours, step), None)
        };
        Self {
            differences: Differences::new(differences),
            beside: beside.map(Differences::new),
            overall: OnceCell::new(),
        }
    }

    /// Whether a height at a place (an index of the values) is at least `times` the standard
    /// deviation of the noise there. Where no noise can be told every height is.
    pub fn is_below(&self, at: usize, height: f64, times: f64) -> bool {
        let all = self.differences.values.len();
        if all < LEAST_SAMPLES {
            return true;
        }
        let (from, to) = (
            at.saturating_sub(REACH).min(all - LEAST_SAMPLES),
            (at + REACH).min(all),
        );
        // A look at sums will do where lines tower over the noise.
        let most = self.differences.most(from, to);
        if height >= times * most.max(self.differences.most(0, all)) {
            return true;
        }
        let overall = *self.overall.get_or_init(|| self.between(0, all));
        height >= times * self.between(from, to).max(LEAST_SHARE * overall)
    }

    fn between(&self, from: usize, to: usize) -> f64 {
        let noise = noise_of(&self.differences.values[from..to]).unwrap_or(0.0);
        let beside = self.beside.as_ref();
        let beside = beside.and_then(|beside| noise_of(&beside.values[from..to]));
        beside.map_or(noise, |beside| noise.min(beside / LEAST_BESIDE))
    }
}

/// Second differences without sign; 0 where there is nothing but rounding.
#[derive(Clone, Debug)]
struct Differences {
    values: Vec<f64>,
    /// Sum of those before each and of all, and how many of them are known.
    before: Vec<(f64, u32)>,
}

impl Differences {
    fn new(values: Vec<f64>) -> Self {
        let mut before = Vec::with_capacity(values.len() + 1);
        let mut last = (0.0, 0);
        before.push(last);
        before.extend(values.iter().map(|d| {
            last = (last.0 + d, last.1 + u32::from(*d > 0.0));
            last
        }));
        Self { values, before }
    }

    /// More noise than this there is not: less than 1 - q of some numbers exceed their mean over
    /// 1 - q.
    fn most(&self, from: usize, to: usize) -> f64 {
        let (first, last) = (self.before[from], self.before[to]);
        let mean = (last.0 - first.0) / f64::from((last.1 - first.1).max(1));
        mean / ((1.0 - QUANTILE) * NORMAL_AT_QUANTILE * SECOND_DIFFERENCE)
    }
}

/// The differences of a table with `step` grid points from sample to sample; none where lines
/// make most of them.
fn of_coarse(mut differences: Vec<f64>, step: f64) -> Vec<f64> {
    // A kink of straight lines between samples is their second difference over the step.
    differences.iter_mut().for_each(|d| *d *= step);
    let far = FAR_ABOVE * SECOND_DIFFERENCE * noise_of(&differences).unwrap_or(0.0);
    let of_lines = differences.iter().filter(|d| **d > far).count();
    let samples = differences.iter().filter(|d| **d > 0.0).count();
    if of_lines as f64 > LINES_SHARE * samples as f64 {
        differences.clear();
    }
    differences
}

/// The second differences of values `apart` from each other, without sign; 0 where there is
/// nothing but rounding.
fn second_differences(values: &[f64], apart: usize, rounding: f64) -> Vec<f64> {
    let difference = |w: &[f64]| ((w[0] - w[apart]) - (w[apart] - w[2 * apart])).abs();
    values
        .windows(2 * apart + 1)
        .map(|w| Some(difference(w)).filter(|d| *d > rounding).unwrap_or(0.0))
        .collect()
}

/// The standard deviation of a sample by its second differences; `None` where there are too few.
fn noise_of(differences: &[f64]) -> Option<f64> {
    let mut known: Vec<f64> = differences.iter().copied().filter(|d| *d > 0.0).collect();
    if known.len() < LEAST_SAMPLES {
        return None;
    }
    let index = (QUANTILE * known.len() as f64) as usize;
    let (_, quantile, _) = known.select_nth_unstable_by(index, f64::total_cmp);
    Some(*quantile / (NORMAL_AT_QUANTILE * SECOND_DIFFERENCE))
}
