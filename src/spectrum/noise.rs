//! How noisy values on a grid are, told from the values themselves.
//!
//! Noise has no memory and a spectrum has: the second difference of samples leaves almost nothing
//! of a smooth spectrum and the square root of 6 times the noise. Lines leave much, but stand at
//! few samples, so a low quantile of the differences is taken. The noise of a spectrometer differs
//! along the spectrum (its sensitivity is divided out), so each place asks its own surroundings.

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
pub(super) struct Noise {
    /// Second differences of samples that share no noise, without sign; 0 where there is nothing
    /// but rounding.
    differences: Vec<f64>,
    /// Those of neighbours, where they may share some; else empty.
    beside: Vec<f64>,
}

impl Noise {
    /// The noise of some values.
    pub(super) fn of(values: &[f64]) -> Self {
        let highest = values.iter().fold(0.0_f64, |top, v| top.max(v.abs()));
        let rounding = ROUNDING * highest;
        let neighbours = second_differences(values, 1, rounding);
        let samples = neighbours.iter().filter(|d| **d > 0.0).count();
        let step = neighbours.len() as f64 / samples as f64;
        let (differences, beside) = if samples < LEAST_SAMPLES {
            (Vec::new(), Vec::new())
        } else if step < COARSE_STEP {
            (second_differences(values, APART, rounding), neighbours)
        } else {
            (of_coarse(neighbours, step), Vec::new())
        };
        Self {
            differences,
            beside,
        }
    }

    /// Whether a height at a place (an index of the values) is at least `times` the standard
    /// deviation of the noise there. Where no noise can be told every height is.
    pub(super) fn is_below(&self, at: usize, height: f64, times: f64) -> bool {
        let all = self.differences.len();
        if all < LEAST_SAMPLES {
            return true;
        }
        let (from, to) = (
            at.saturating_sub(REACH).min(all - LEAST_SAMPLES),
            (at + REACH).min(all),
        );
        let height = height / times;
        self.is_at_most(from, to, height) && self.is_at_most(0, all, height / LEAST_SHARE)
    }

    fn is_at_most(&self, from: usize, to: usize, noise: f64) -> bool {
        is_noise_at_most(&self.differences[from..to], noise).unwrap_or(true)
            || self
                .beside
                .get(from..to)
                .and_then(|beside| is_noise_at_most(beside, LEAST_BESIDE * noise))
                .unwrap_or(false)
    }
}

/// Whether the noise by some second differences is no more than that: then more of them than the
/// quantile's share are as small as it would be. `None` where there are too few.
fn is_noise_at_most(differences: &[f64], noise: f64) -> Option<bool> {
    let limit = noise * NORMAL_AT_QUANTILE * SECOND_DIFFERENCE;
    let known = differences.iter().filter(|d| **d > 0.0).count();
    let small = differences.iter().filter(|d| **d <= limit).count();
    let small = small - (differences.len() - known);
    (known >= LEAST_SAMPLES).then_some(small > (QUANTILE * known as f64) as usize)
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
