//! Scans of one light: their mean, and what each is off by.
//!
//! `scan = g m(nm - d) + e`: a common factor, a common shift and noise with a short memory. Every
//! scan less the mean is regressed on the mean and its slope; what is left is the noise, and what
//! noise alone makes of factor and shift is taken off their spread.

use std::fmt;

use super::{
    error::MeasurementError,
    measurement::Measurement,
    union::Union,
    units::{conversion, is_relative},
};
use crate::spectrum::Sampled;

/// Samples to either side over which the noise is averaged.
const REACH: usize = 20;

/// Longest memory, samples.
const MOST_MEMORY: usize = 8;

/// Fewest scans that tell a spread.
const LEAST_SCANS: usize = 3;

/// Results of repeated scans.
#[derive(Clone, Debug, PartialEq)]
pub struct Repeats {
    /// The mean with the doubt of the mean.
    pub mean: Measurement,
    /// Standard deviation of the level of one scan, a share of it.
    pub level_sd: f64,
    /// Standard deviation of the shift of one scan, nm.
    pub axis_sd_nm: f64,
    /// Standard deviation of the noise of one scan.
    pub sigma: Vec<f64>,
    /// Each scan's level less that of the mean, a share of it.
    pub levels: Vec<f64>,
    /// Each scan's shift against the mean, nm.
    pub shifts_nm: Vec<f64>,
    /// Root mean square of what is left of each scan.
    pub residuals: Vec<f64>,
}

/// Why scans tell no spread.
#[derive(Clone, Debug, PartialEq)]
pub enum RepeatsError {
    /// There are too few.
    TooFew { scans: usize },
    /// They cannot be taken together.
    Apart(MeasurementError),
    /// Their values are not all of one quantity and unit.
    Unlike { first: String, other: String },
}

impl fmt::Display for RepeatsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFew { scans: 2 } => f.write_str(said!(
                "Two scans tell no spread worth the name. Add one more, or state the \
                     instrument's noise."
            )),
            Self::TooFew { .. } => f.write_str(said!(
                "One scan has no spread. Add two more, or state the instrument's noise."
            )),
            Self::Apart(why) => why.fmt(f),
            Self::Unlike { first, other } => f.write_str(&tr!(
                "found {first} beside {other}, expected scans of one quantity and unit",
                first,
                other
            )),
        }
    }
}

impl std::error::Error for RepeatsError {}

impl From<MeasurementError> for RepeatsError {
    fn from(why: MeasurementError) -> Self {
        Self::Apart(why)
    }
}

/// Scans on one grid.
pub(super) struct Scans {
    pub nm: Vec<f64>,
    pub values: Vec<Vec<f64>>,
}

/// Values by a factor; to the bit as they were where it is one.
fn scaled(values: Vec<f64>, by: Option<f64>) -> Vec<f64> {
    match by {
        Some(by) if by != 1.0 => values.iter().map(|v| by * v).collect(),
        _ => values,
    }
}

impl Scans {
    /// The scans on their common grid: their own where they share it, else the union.
    pub(super) fn of(scans: &[Measurement]) -> Result<Self, RepeatsError> {
        let Some((first, others)) = scans.split_first() else {
            return Err(RepeatsError::TooFew { scans: 0 });
        };
        let words = |m: &Measurement| match m.unit.as_str() {
            "" => m.quantity.to_string(),
            unit => format!("{} ({unit})", m.quantity),
        };
        // What brings a scan to the unit of the first.
        let factor = |m: &Measurement| match (m.quantity == first.quantity, m.unit == first.unit) {
            (true, true) => Some(1.0),
            (true, false) if !is_relative(&m.unit) && !is_relative(&first.unit) => {
                conversion(&m.unit, &first.unit)
            }
            _ => None,
        };
        if let Some(other) = others.iter().find(|m| factor(m).is_none()) {
            return Err(RepeatsError::Unlike {
                first: words(first),
                other: words(other),
            });
        }
        if others.iter().all(|m| m.samples.nm() == first.samples.nm()) {
            return Ok(Self {
                nm: first.samples.nm().to_vec(),
                values: scans
                    .iter()
                    .map(|m| scaled(m.samples.values().to_vec(), factor(m)))
                    .collect(),
            });
        }
        let union = Union::of(&scans.iter().collect::<Vec<_>>(), false)?;
        let on = |m: &Measurement| {
            let own = m.samples.values();
            let places = union.places(m.samples.nm()).into_iter();
            let values =
                places.map(|(left, share)| own[left] * (1.0 - share) + own[left + 1] * share);
            scaled(values.collect(), factor(m))
        };
        Ok(Self {
            values: scans.iter().map(on).collect(),
            nm: union.nm,
        })
    }

    pub(super) fn mean(&self) -> Vec<f64> {
        let n = self.values.len() as f64;
        let at = |i: usize| self.values.iter().map(|v| v[i]).sum::<f64>() / n;
        // A mean of one is that one, to the bit.
        match &self.values[..] {
            [one] => one.clone(),
            _ => (0..self.nm.len()).map(at).collect(),
        }
    }
}

/// The plain mean of scans, with no more known of it than of them.
///
/// # Errors
/// [`RepeatsError`] where they cannot be taken together.
pub fn mean_of(scans: &[Measurement]) -> Result<Measurement, RepeatsError> {
    let on_grid = Scans::of(scans)?;
    let mean = on_grid.mean();
    if let [one] = scans {
        return Ok(one.clone());
    }
    let samples = Sampled::new(on_grid.nm, mean).map_err(MeasurementError::from)?;
    let first = &scans[0];
    let mut mean = Measurement::new(&first.name, first.quantity, &first.unit, samples);
    mean.scans = Some(scans.len());
    Ok(mean)
}

/// Slope of values over a grid, exact for parabolas inside and for lines at the ends.
pub(super) fn slope(nm: &[f64], values: &[f64]) -> Vec<f64> {
    let last = nm.len() - 1;
    let step = |i: usize| (values[i + 1] - values[i]) / (nm[i + 1] - nm[i]);
    let at = |i: usize| match i {
        0 => step(0),
        i if i == last => step(last - 1),
        i => {
            let (left, right) = (nm[i] - nm[i - 1], nm[i + 1] - nm[i]);
            (step(i - 1) * right + step(i) * left) / (left + right)
        }
    };
    (0..=last).map(at).collect()
}

/// The mean of values up to [`REACH`] samples away.
pub(super) fn running(values: &[f64]) -> Vec<f64> {
    let mut sums = vec![0.0];
    for v in values {
        sums.push(sums[sums.len() - 1] + v);
    }
    let mean = |i: usize| {
        let (from, to) = (i.saturating_sub(REACH), (i + REACH + 1).min(values.len()));
        ((sums[to] - sums[from]) / (to - from) as f64).max(0.0)
    };
    (0..values.len()).map(mean).collect()
}

/// Variance with one degree of freedom less.
pub(super) fn variance(values: &[f64]) -> f64 {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / (n - 1.0)
}

/// A regression on two columns with weights.
struct Regression {
    /// `[aa, ab, bb]`, and the determinant.
    normal: [f64; 3],
    determinant: f64,
}

impl Regression {
    fn new(a: &[f64], b: &[f64], weights: &[f64]) -> Self {
        let sum = |x: &[f64], y: &[f64]| -> f64 {
            x.iter()
                .zip(y)
                .zip(weights)
                .map(|((x, y), w)| w * x * y)
                .sum()
        };
        let normal = [sum(a, a), sum(a, b), sum(b, b)];
        Self {
            determinant: normal[0] * normal[2] - normal[1] * normal[1],
            normal,
        }
    }

    /// True if the columns are numerically independent.
    fn is_sound(&self) -> bool {
        let [aa, _, bb] = self.normal;
        self.determinant > 1e-12 * aa * bb
    }

    fn solved(&self, of_a: f64, of_b: f64) -> [f64; 2] {
        let [aa, ab, bb] = self.normal;
        if !self.is_sound() {
            // A flat light tells no shift.
            return [if aa > 0.0 { of_a / aa } else { 0.0 }, 0.0];
        }
        [
            (of_a * bb - ab * of_b) / self.determinant,
            (aa * of_b - ab * of_a) / self.determinant,
        ]
    }

    /// Variances of both by the noise alone, which the weights are the inverse variance of.
    fn by_noise(&self) -> [f64; 2] {
        let [aa, _, bb] = self.normal;
        match self.is_sound() {
            true => [bb / self.determinant, aa / self.determinant],
            false => [if aa > 0.0 { 1.0 / aa } else { 0.0 }, 0.0],
        }
    }
}

impl Repeats {
    /// One scan whose level, axis and noise are stated.
    pub(super) fn stated(one: &Measurement) -> Self {
        let sigma = one.sigma.clone();
        Self {
            mean: one.clone(),
            level_sd: one.level,
            axis_sd_nm: one.axis_nm,
            sigma: sigma.unwrap_or_else(|| vec![0.0; one.samples.len()]),
            levels: vec![0.0],
            shifts_nm: vec![0.0],
            residuals: vec![0.0],
        }
    }

    /// Estimates for the light and for the instrument from scans of one light.
    ///
    /// # Errors
    /// [`RepeatsError`] for fewer than three, or for scans of different things.
    pub fn of(scans: &[Measurement]) -> Result<Self, RepeatsError> {
        let n = scans.len();
        if n < LEAST_SCANS {
            return Err(RepeatsError::TooFew { scans: n });
        }
        let mut mean = mean_of(scans)?;
        let on_grid = Scans::of(scans)?;
        let m = mean.samples.values();
        let down: Vec<f64> = slope(&on_grid.nm, m).iter().map(|s| -s).collect();
        let mut sigma = vec![1.0; m.len()];
        let (mut levels, mut shifts_nm, mut left) = (Vec::new(), Vec::new(), Vec::new());
        for _ in 0..2 {
            let weights = weights_of(&sigma);
            let regression = Regression::new(m, &down, &weights);
            (levels, shifts_nm, left) = (Vec::new(), Vec::new(), Vec::new());
            for values in &on_grid.values {
                let off: Vec<f64> = values.iter().zip(m).map(|(v, m)| v - m).collect();
                let sum = |x: &[f64]| -> f64 {
                    x.iter()
                        .zip(&off)
                        .zip(&weights)
                        .map(|((x, y), w)| w * x * y)
                        .sum()
                };
                let [g, d] = regression.solved(sum(m), sum(&down));
                levels.push(g);
                shifts_nm.push(d);
                let rest = (0..m.len()).map(|i| off[i] - g * m[i] - d * down[i]);
                left.push(rest.collect::<Vec<f64>>());
            }
            sigma = spread(&left);
        }
        let [by_level, by_shift] = Regression::new(m, &down, &weights_of(&sigma)).by_noise();
        let level_sd = (variance(&levels) - by_level).max(0.0).sqrt();
        let axis_sd_nm = (variance(&shifts_nm) - by_shift).max(0.0).sqrt();
        let root = (n as f64).sqrt();
        mean.sigma = Some(sigma.iter().map(|s| s / root).collect());
        mean.level = level_sd / root;
        mean.axis_nm = axis_sd_nm / root;
        mean.memory = memory(&left, &sigma);
        let rms =
            |rest: &Vec<f64>| (rest.iter().map(|e| e * e).sum::<f64>() / rest.len() as f64).sqrt();
        Ok(Self {
            residuals: left.iter().map(rms).collect(),
            mean,
            level_sd,
            axis_sd_nm,
            sigma,
            levels,
            shifts_nm,
        })
    }
}

/// One over the variance; scans that are the same to the bit have none and count alike.
fn weights_of(sigma: &[f64]) -> Vec<f64> {
    let most = sigma.iter().copied().fold(0.0, f64::max);
    // No sample counts for more than a million others.
    let least = if most > 0.0 { 1e-3 * most } else { 1.0 };
    sigma.iter().map(|s| s.max(least).powi(-2)).collect()
}

/// The noise of one scan by what is left of all.
fn spread(left: &[Vec<f64>]) -> Vec<f64> {
    let n = left.len() as f64;
    let at = |i: usize| left.iter().map(|e| e[i] * e[i]).sum::<f64>() / (n - 1.0);
    let raw: Vec<f64> = (0..left[0].len()).map(at).collect();
    running(&raw).into_iter().map(f64::sqrt).collect()
}

/// Correlation of neighbours' noise, cut at the first that chance may have made.
fn memory(left: &[Vec<f64>], sigma: &[f64]) -> Vec<f64> {
    let (n, points) = (left.len() as f64, sigma.len());
    let least = 2.0 / (points as f64 * (n - 1.0)).sqrt();
    let at = |lag: usize| {
        let mut sum = 0.0;
        for e in left {
            for i in 0..points - lag {
                let scale = sigma[i] * sigma[i + lag];
                if scale > 0.0 {
                    sum += e[i] * e[i + lag] / scale;
                }
            }
        }
        // What is left has lost one of n degrees of freedom to the mean.
        sum / ((n - 1.0) * (points - lag) as f64)
    };
    let lags = 1..=MOST_MEMORY.min(points.saturating_sub(2));
    lags.map(at).take_while(|rho| *rho >= least).collect()
}
