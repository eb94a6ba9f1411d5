//! A measurement on whole nm, with the deviation and memory of its noise there.

use super::measurement::Measurement;
use crate::spectrum::Outside;

/// Lags of a memory that are worth keeping.
const LEAST_MEMORY: f64 = 0.01;

/// A light on whole nm with the deviation and memory of its noise.
#[derive(Clone, Debug)]
pub(super) struct OnWholeNm {
    pub first_nm: u32,
    pub values: Vec<f64>,
    /// Standard deviation of each value; all 0 where none is known.
    pub sigma: Vec<f64>,
    /// Correlation of the noise 1, 2, ... nm apart.
    pub memory: Vec<f64>,
    /// True where scans told sigma and memory.
    pub is_of_scans: bool,
}

impl OnWholeNm {
    /// The values from one wavelength to another, both included; 0 outside the table. Gaps of the
    /// mask are bridged by straight lines, ends that it takes are outside.
    pub(super) fn of(light: &Measurement, first_nm: u32, last_nm: u32) -> Self {
        let light = &light.bridged();
        let samples = &light.samples;
        let step = samples.step_nm();
        let lags = |own: &dyn Fn(f64) -> f64| -> Vec<f64> {
            (1..=(last_nm - first_nm))
                .map(|k| own(f64::from(k)))
                .take_while(|rho| *rho > LEAST_MEMORY)
                .collect()
        };
        let rho = |samples_apart: f64| {
            let at = |k: usize| match k {
                0 => 1.0,
                k => light.memory.get(k - 1).copied().unwrap_or(0.0),
            };
            let (below, share) = (samples_apart as usize, samples_apart.fract());
            at(below) * (1.0 - share) + at(below + 1) * share
        };
        let in_a_nm = (1.0 / step).max(1.0);
        // The mean of all samples of a nm has less noise than one of them, and what noise of theirs
        // is alike stays; at steps of a nm and more a point is one sample or lies between two.
        let inside = in_a_nm.round() as usize;
        let pairs = (1..inside).map(|k| 2.0 * (inside - k) as f64 * rho(k as f64));
        let mean_of_nm = ((inside as f64 + pairs.sum::<f64>()).max(0.0)).sqrt() / inside as f64;
        let own = light.sigma.as_deref().unwrap_or_default();
        let nm = samples.nm();
        let sigma = (first_nm..=last_nm).map(|at| {
            let at = f64::from(at);
            if own.is_empty() || at < nm[0] || at > nm[nm.len() - 1] {
                return 0.0;
            }
            let right = nm.partition_point(|nm| *nm < at).clamp(1, nm.len() - 1);
            let share = (at - nm[right - 1]) / (nm[right] - nm[right - 1]);
            if inside > 1 {
                return mean_of_nm * (own[right - 1] * (1.0 - share) + own[right] * share);
            }
            light.sigma_at(right - 1, share)
        });
        Self {
            is_of_scans: light.scans.is_some_and(|n| n > 1),
            first_nm,
            values: samples.on_whole_nm(first_nm, last_nm, Outside::Zero),
            sigma: sigma.collect(),
            memory: if inside > 1 {
                lags(&|k| shared(&rho, inside, k as usize))
            } else if (step - 1.0).abs() < 1e-9 {
                light.memory.clone()
            } else {
                lags(&|k| rho(k / step))
            },
        }
    }

    /// Standard deviation of a sum of the values, one weight each from an index on.
    pub(super) fn doubt_of(&self, first: usize, weights: &[f64]) -> f64 {
        let parts: Vec<f64> = weights
            .iter()
            .zip(&self.sigma[first..])
            .map(|(w, s)| w * s)
            .collect();
        remembered_sum(&parts, &self.memory).sqrt()
    }
}

/// Variance of a sum of noises of these deviations and this memory.
pub(super) fn remembered_sum(parts: &[f64], memory: &[f64]) -> f64 {
    let at = |lag: usize| -> f64 {
        let later = &parts[lag.min(parts.len())..];
        parts.iter().zip(later).map(|(a, b)| a * b).sum()
    };
    let lags = (1..=memory.len()).map(|lag| 2.0 * memory[lag - 1] * at(lag));
    (at(0) + lags.sum::<f64>()).max(0.0)
}

/// Correlation of the means of all samples of two nm that lie so many nm apart.
fn shared(rho: &dyn Fn(f64) -> f64, inside: usize, apart: usize) -> f64 {
    let sum = |between: usize| -> f64 {
        let pairs = (0..inside).flat_map(|i| (0..inside).map(move |j| (i, j + between)));
        pairs.map(|(i, j)| rho(i.abs_diff(j) as f64)).sum()
    };
    sum(apart * inside) / sum(0)
}
