//! White noise of one scan by its second differences, on any grid.
//!
//! The distance of a sample from the straight line between those beside it leaves almost nothing of
//! a smooth spectrum. Lines leave much but stand at few samples, so that a low quantile is taken;
//! found over true is 1.04 at a signal of 20 times the noise, 1.34 at 1000, where a lamp's own
//! structure begins to count: too large, which is the safe side. Memory cannot be seen this way.

use super::kernel::Slit;
use crate::spectrum::{Sampled, quantile};

/// Share of the differences that are smaller than the one looked at.
const QUANTILE: f64 = 0.3;
/// That quantile of the absolute value of a standard normal number.
const NORMAL_AT_QUANTILE: f64 = 0.385_320_466_407_568;
/// Reach of a sample's surroundings, samples to either side.
const REACH: usize = 60;
/// Distance between the compared samples of a fine table.
const APART: usize = 2;
/// Fewer differences than this tell nothing.
const LEAST: usize = 20;
/// Differences below this share of the largest value are rounding.
const ROUNDING: f64 = 1e-9;
/// From this step on, nm, a table may be made of lines alone.
const COARSE_NM: f64 = 1.3;
/// Largest share of a coarse table's differences that may lie far above its noise; beyond it they
/// are its lines and give no noise.
const LINES_SHARE: f64 = 0.1;
/// Least ratio of the noise told by samples two apart to that told by neighbours, for a memory.
const MEMORY: f64 = 1.5;
/// Threshold for far above the noise, in its standard deviations.
const FAR_ABOVE: f64 = 3.0;

/// Standard deviation of the noise of every sample; `None` where it cannot be told.
pub fn noise_of(samples: &Sampled) -> Option<Vec<f64>> {
    // What was averaged onto a fine grid shares its noise with its neighbours.
    let apart = if samples.step_nm() < COARSE_NM {
        APART
    } else {
        1
    };
    let nm = samples.nm();
    let differences = differences(samples, apart);
    let all = deviation(&differences)?;
    if samples.step_nm() >= COARSE_NM {
        let known = differences.iter().filter(|d| **d > 0.0).count();
        let far = differences.iter().filter(|d| **d > FAR_ABOVE * all).count();
        if far as f64 > LINES_SHARE * known as f64 {
            return None;
        }
    }
    let last = differences.len();
    let local = |i: usize| {
        let near = &differences[i.saturating_sub(REACH + apart).min(last)..(i + REACH).min(last)];
        deviation(near).unwrap_or(all)
    };
    Some((0..nm.len()).map(local).collect())
}

/// Weights of seven samples that leave nothing of a polynomial of order 5, and their root sum of
/// squares.
const SIXTH: [f64; 7] = [1.0, -6.0, 15.0, -20.0, 15.0, -6.0, 1.0];
const OF_SIXTH: f64 = 30.397_368_307_141_33;

/// Fewest samples of a slit's width for which what it lets through is smooth.
const SAMPLES_A_WIDTH: f64 = 3.0;

/// The same for a scan seen through a slit: a line is as wide as the slit then, and sixth differences
/// leave little of it where second ones take it for noise. Tables that are uneven or too coarse tell
/// it as any.
pub fn noise_behind(samples: &Sampled, slit: Slit) -> Option<Vec<f64>> {
    let plain = noise_of(samples)?;
    let step = samples.step_nm();
    let is_even = samples
        .nm()
        .windows(2)
        .all(|w| (w[1] - w[0] - step).abs() < 1e-6);
    if !is_even || slit.fwhm_nm < SAMPLES_A_WIDTH * step {
        return Some(plain);
    }
    let values = samples.values();
    let highest = values.iter().fold(0.0_f64, |top, v| top.max(v.abs()));
    let sixth = |w: &[f64]| {
        let sum: f64 = SIXTH.iter().zip(w).map(|(c, v)| c * v).sum();
        let away = sum.abs() / OF_SIXTH;
        if away > ROUNDING * highest { away } else { 0.0 }
    };
    let all: Vec<f64> = values.windows(SIXTH.len()).map(sixth).collect();
    let local = |i: usize| {
        let middle = i.saturating_sub(SIXTH.len() / 2);
        let near =
            &all[middle.saturating_sub(REACH).min(all.len())..(middle + REACH).min(all.len())];
        deviation(near).map_or(plain[i], |found| found.min(plain[i]))
    };
    Some((0..values.len()).map(local).collect())
}

/// True if neighbours of a table share their noise: what samples two apart tell of it exceeds what
/// neighbours tell by so much that white noise cannot. One scan does not tell how much is shared.
pub fn has_memory(samples: &Sampled) -> bool {
    let told = |apart: usize| deviation(&differences(samples, apart));
    match (told(1), told(2)) {
        (Some(one), Some(two)) => two > MEMORY * one,
        _ => false,
    }
}

/// Distances of the samples from the straight line between those so many samples away, each in units
/// of one sample's deviation; 0 for rounding.
fn differences(samples: &Sampled, apart: usize) -> Vec<f64> {
    let (nm, values) = (samples.nm(), samples.values());
    let highest = values.iter().fold(0.0_f64, |top, v| top.max(v.abs()));
    if nm.len() <= 2 * apart {
        return Vec::new();
    }
    (apart..nm.len() - apart)
        .map(|i| {
            let (left, right) = (i - apart, i + apart);
            let share = (nm[i] - nm[left]) / (nm[right] - nm[left]);
            let line = values[left] * (1.0 - share) + values[right] * share;
            let away = (values[i] - line).abs();
            let of_one = 1.0_f64.hypot(share).hypot(1.0 - share);
            if away > ROUNDING * highest {
                away / of_one
            } else {
                0.0
            }
        })
        .collect()
}

/// The deviation that some differences tell; `None` where they are too few.
fn deviation(differences: &[f64]) -> Option<f64> {
    let mut known: Vec<f64> = differences.iter().copied().filter(|d| *d > 0.0).collect();
    if known.len() < LEAST {
        return None;
    }
    Some(quantile(&mut known, QUANTILE)? / NORMAL_AT_QUANTILE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measurements::{Kernel, draws::normal};

    #[test]
    fn the_noise_of_a_smooth_light_is_told_to_a_tenth_on_even_and_uneven_grids() {
        for uneven in [0.0, 0.3] {
            let nm =
                (0..2000_i32).map(|i| 400.0 + 0.2 * (f64::from(i) + uneven * f64::from(i % 3)));
            let nm: Vec<f64> = nm.collect();
            let smooth = |nm: &f64| 100.0 * (-((nm - 600.0) / 120.0).powi(2)).exp();
            let values = nm
                .iter()
                .zip(normal(3))
                .map(|(nm, noise)| smooth(nm) + noise);
            let samples = Sampled::new(nm.clone(), values.collect()).expect("rising");
            let sigma = noise_of(&samples).expect("enough samples");
            let mean = sigma.iter().sum::<f64>() / sigma.len() as f64;
            assert!((mean - 1.0).abs() < 0.1, "{uneven}: {mean}");
        }
    }

    #[test]
    fn of_lines_behind_a_slit_sixth_differences_take_less_for_noise_than_second_ones() {
        let slit = Slit {
            shape: Kernel::Gauss,
            fwhm_nm: 5.0,
        };
        let values = (0..401).zip(normal(9)).map(|(i, noise)| {
            let lines = [25, 56, 100, 130, 166, 199, 240, 270, 310, 350];
            let lines = lines.map(|at| 20_000.0 * slit.height(f64::from(i - at)));
            lines.iter().sum::<f64>() + noise
        });
        let samples = Sampled::even(380.0, 1.0, values.collect()).expect("finite");
        let mean = |sigma: Vec<f64>| sigma.iter().sum::<f64>() / sigma.len() as f64;
        // Ten lines of 4000 noises stand on half of the table: too large is the safe side.
        let behind = mean(noise_behind(&samples, slit).expect("enough"));
        assert!((0.8..2.0).contains(&behind), "{behind}");
        let plain = mean(noise_of(&samples).expect("enough"));
        assert!(plain > 1.25 * behind, "{plain}, {behind}");
    }

    #[test]
    fn tables_of_lines_and_short_ones_tell_none() {
        let lines = (0..81).map(|i| {
            if i % 8 == 0 {
                1.0
            } else {
                0.01 * f64::from(i % 7)
            }
        });
        let lines = Sampled::even(380.0, 5.0, lines.collect()).expect("finite");
        assert_eq!(noise_of(&lines), None);
        let short = Sampled::even(380.0, 1.0, vec![1.0, 2.0, 1.0]).expect("finite");
        assert_eq!(noise_of(&short), None);
    }
}
