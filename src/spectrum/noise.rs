//! Noise of values on a grid, estimated from the values themselves.
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
/// Reach of a place's surroundings, in grid points to either side.
const REACH: usize = 60;
/// Relative standard error of the noise estimated from so many samples: that of the quantile,
/// `sqrt(q (1 - q) / n)` over its density and itself, is 1/6.8 for n = 2 [`REACH`].
const TOLD_TO: f64 = 1.0 / 7.0;
/// Spacing of the samples compared: values averaged onto the grid from finer data share noise with
/// their neighbours, and differ less from them than from samples this far away.
const APART: usize = 2;
/// The least that the noise told by neighbours is, over that told by samples [`APART`]; what differs
/// less from its neighbours is a curve. Area shared out to the grid makes noise of neighbours alike
/// by 1/4, which leaves 6 - 8/4 of the 6 variances of a second difference: .816 of the deviation.
/// Both are told to a seventh, so that their quotient may be smaller by a share of sqrt(2)/7: .679.
/// Two thirds is the simple fraction below.
const LEAST_BESIDE: f64 = 2.0 / 3.0;
/// Nowhere is less noise taken for true than this share of what there is in all: what is told to be
/// smaller by no more than a seventh may be the same.
const LEAST_SHARE: f64 = 1.0 - TOLD_TO;
/// Fewer samples than this tell nothing.
const LEAST_SAMPLES: usize = 20;
/// A second difference below this share of the largest value is rounding, or a point between two
/// samples of a table coarser than the grid, where straight lines have none.
const ROUNDING: f64 = 1e-9;
/// From this step on (nm) samples do not share their noise, and the grid holds straight lines
/// between them.
const COARSE_STEP: f64 = 1.3;
/// Largest share of a coarse table's second differences that may lie far above its noise: if more
/// do, they are its lines and no measure of noise. A share `c` of large ones moves the quantile of
/// the others from q to q / (1 - c): the estimate grows by 12 % for a tenth, just below its
/// standard error of a seventh. Noise alone lies so far above itself at one sample in a hundred
/// even where it is underestimated by a seventh, so that noise is not taken for lines.
const LINES_SHARE: f64 = 0.1;
/// Threshold for "far above the noise", in its standard deviations.
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

    /// True if a height at a place (an index of the values) is at least `times` the standard
    /// deviation of the noise there, or if the noise cannot be estimated.
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

/// True if the noise estimated from some second differences is at most `noise`: more of them than
/// the quantile's share are then as small as it implies. `None` where there are too few.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spectrum::{Band, Outside, Sampled};

    /// Normal numbers by Box and Muller from a linear congruence (Knuth's MMIX).
    fn normal(seed: u64) -> impl Iterator<Item = f64> {
        let mut state = seed;
        let mut even = move || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            ((state >> 11) as f64 + 0.5) / (1_u64 << 53) as f64
        };
        std::iter::from_fn(move || {
            let (a, b) = (even(), even());
            Some((-2.0 * a.ln()).sqrt() * (2.0 * std::f64::consts::PI * b).cos())
        })
    }

    fn root_mean_square(values: impl Iterator<Item = f64>) -> f64 {
        let (sum, count) = values.fold((0.0, 0.0), |(sum, n), v| (sum + v * v, n + 1.0));
        f64::sqrt(sum / count)
    }

    #[test]
    fn the_surroundings_of_a_place_tell_white_noise_to_a_seventh() {
        let off = (0..400).map(|seed| {
            let values: Vec<f64> = normal(seed).take(2 * REACH + 2 * APART).collect();
            noise_of(&second_differences(&values, APART, 0.0)).expect("enough") - 1.0
        });
        let off = root_mean_square(off);
        // 400 draws tell a deviation to 4 %; second differences share samples, which adds a little.
        assert!(off > 0.9 * TOLD_TO && off < 1.5 * TOLD_TO, "{off}");
    }

    #[test]
    fn area_shared_out_makes_neighbours_differ_by_0_816_of_what_others_do() {
        let band = Band::new(400.0, 20_000.0).expect("a range");
        let values = normal(5).take(10 * band.steps() + 1).collect();
        let fine = Sampled::even(400.0, 0.1, values).expect("rising");
        let values = fine.on_band(band, Outside::Zero);
        let told = |apart| noise_of(&second_differences(&values, apart, 0.0)).expect("enough");
        let share = told(1) / told(APART);
        // 20 000 samples tell a deviation to about 1 %.
        assert!((share - (4.0_f64 / 6.0).sqrt()).abs() < 0.02, "{share}");
        assert!(LEAST_BESIDE < share / (1.0 + 2.0_f64.sqrt() * TOLD_TO));
    }

    #[test]
    fn up_to_a_tenth_of_lines_moves_the_noise_by_less_than_a_seventh() {
        let mut values: Vec<f64> = normal(11).take(20_000).map(f64::abs).collect();
        let alone = noise_of(&values).expect("enough");
        let lines = (LINES_SHARE * values.len() as f64) as usize;
        values[..lines].fill(1e3);
        let beside = noise_of(&values).expect("enough");
        // The third of |normal| over its three tenths is 1.118; 20 000 values tell it to a hundredth.
        assert!((beside / alone - 1.118).abs() < 0.02, "{}", beside / alone);
        assert!(beside / alone < 1.0 + TOLD_TO);
    }
}
