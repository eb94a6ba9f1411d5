//! Differences between two sets of scans: level, lines and glow, tested all together.
//!
//! Every part is a quotient of two linear sums of the light, so that its error by noise, memory
//! and axis is known without drawing; the parts but the level are tested by Holm's procedure.

use std::fmt;

use super::{
    error::MeasurementError,
    measurement::Measurement,
    repeats::{Repeats, RepeatsError, Scans, slope},
    statistics::{holm, quantile_of_p, two_sided_p},
};
use crate::spectrum::{Band, Outside, Sampled, SpikeSettings, detect};

/// Probability of calling the same light different.
const LEVEL_OF_TEST: f64 = 0.05;

/// Cosines of the glow that are compared.
const COSINES: usize = 7;

/// Degrees of freedom of the white noise for each of the scans'.
const TELLING: f64 = 40.0;

/// Verdict on two sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// No difference beyond the noise.
    Same,
    /// At least one part differs.
    Different,
}

impl Verdict {
    /// The word of JSON and of sentences.
    pub fn word(self) -> &'static str {
        match self {
            Self::Same => "same",
            Self::Different => "different",
        }
    }
}

/// Feature that is compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Feature {
    /// The whole power.
    Level,
    /// A line's share of the power, at its place, nm.
    Line(f64),
    /// The share of what is no line.
    Glow,
    /// A cosine of the glow, from 1: the first is its tilt.
    Shape(usize),
}

impl fmt::Display for Feature {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Level => f.write_str("level"),
            Self::Line(_) => f.write_str("line"),
            Self::Glow => f.write_str("glow"),
            Self::Shape(1) => f.write_str("tilt of the glow"),
            Self::Shape(_) => f.write_str("shape of the glow"),
        }
    }
}

/// One part and how it changed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    pub feature: Feature,
    /// From the first set to the second: a share of itself for level, lines and glow; a share of
    /// the glow for its shape.
    pub change: f64,
    /// Its standard uncertainty.
    pub u: f64,
    /// Probability of as much by chance.
    pub p: f64,
    /// True if it is a difference, all parts considered.
    pub is_different: bool,
}

/// Differences between two sets.
#[derive(Clone, Debug, PartialEq)]
pub struct Changed {
    /// Verdict on the two sets.
    pub verdict: Verdict,
    /// The parts that differ, the surest first, at most four.
    pub parts: Vec<Part>,
    /// Every part that was compared.
    pub compared: Vec<Part>,
    /// By how much a line, or the glow where there is none, would have to change to be seen, %.
    pub least_seen_percent: f64,
}

/// Most parts that are named.
const MOST_PARTS: usize = 4;

/// Why nothing can be said.
#[derive(Clone, Debug, PartialEq)]
pub enum ChangeError {
    /// A set of fewer than three scans.
    CannotSay(RepeatsError),
    /// The light has no power to compare.
    Dark,
}

impl fmt::Display for ChangeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::CannotSay(why) => write!(f, "Cannot say: {why}"),
            Self::Dark => f.write_str("Cannot say: found no power above 0 in both sets."),
        }
    }
}

impl std::error::Error for ChangeError {}

impl From<RepeatsError> for ChangeError {
    fn from(why: RepeatsError) -> Self {
        Self::CannotSay(why)
    }
}

impl From<MeasurementError> for ChangeError {
    fn from(why: MeasurementError) -> Self {
        Self::CannotSay(RepeatsError::Apart(why))
    }
}

/// A linear sum of samples, or a quotient of two.
struct Sum {
    feature: Feature,
    weights: Vec<f64>,
    over: Vec<f64>,
}

/// Tests two sets of scans for differences.
///
/// # Errors
/// [`ChangeError`] where a set has fewer than three scans or the sets cannot be compared.
pub fn changed(first: &[Measurement], second: &[Measurement]) -> Result<Changed, ChangeError> {
    // Both sets on one grid.
    let both: Vec<Measurement> = first.iter().chain(second).cloned().collect();
    let grid = Scans::of(&both)?;
    let on_grid = |values: &Vec<f64>| -> Result<Measurement, MeasurementError> {
        let samples = Sampled::new(grid.nm.clone(), values.clone())?;
        Ok(Measurement::new(
            "scan",
            both[0].quantity,
            &both[0].unit,
            samples,
        ))
    };
    let all: Vec<Measurement> = grid.values.iter().map(on_grid).collect::<Result<_, _>>()?;
    let (a, b) = all.split_at(first.len());
    let sets = [Repeats::of(a)?, Repeats::of(b)?];
    let means = sets.each_ref().map(|set| set.mean.samples.values());
    // Of equal level, so that a brighter set does not count for more.
    let totals = means.map(|m| dot(&widths(&grid.nm), m));
    if totals.iter().any(|total| total.is_nan() || *total <= 0.0) {
        return Err(ChangeError::Dark);
    }
    let middle: Vec<f64> = (0..grid.nm.len())
        .map(|i| 0.5 * (means[0][i] / totals[0] + means[1][i] / totals[1]))
        .collect();
    let sums = features(&grid.nm, &middle)?;
    let doubt = Pooled::new(&grid.nm, &sets, totals);
    let mut compared: Vec<Part> = sums
        .iter()
        .map(|sum| doubt.compared(sum, means, &middle))
        .collect();
    let others: Vec<f64> = compared[1..].iter().map(|part| part.p).collect();
    let found = holm(&others, LEVEL_OF_TEST);
    compared[0].is_different = compared[0].p < LEVEL_OF_TEST;
    compared[1..]
        .iter_mut()
        .zip(found)
        .for_each(|(part, is)| part.is_different = is);
    let mut parts: Vec<Part> = compared
        .iter()
        .copied()
        .filter(|part| part.is_different)
        .collect();
    parts.sort_by(|a, b| (b.change / b.u).abs().total_cmp(&(a.change / a.u).abs()));
    let is_different = compared[1..].iter().any(|part| part.is_different);
    parts.truncate(MOST_PARTS);
    let seen = compared[1..]
        .iter()
        .filter(|part| matches!(part.feature, Feature::Line(_)));
    let least = seen.map(|part| part.u).fold(f64::INFINITY, f64::min);
    let least = if least.is_finite() {
        least
    } else {
        compared[1].u
    };
    let t = quantile_of_p(LEVEL_OF_TEST / others.len() as f64, doubt.dof);
    Ok(Changed {
        verdict: if is_different {
            Verdict::Different
        } else {
            Verdict::Same
        },
        parts,
        compared,
        least_seen_percent: 100.0 * t * least,
    })
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The stretch that each sample stands for, nm.
fn widths(nm: &[f64]) -> Vec<f64> {
    let last = nm.len() - 1;
    (0..=last)
        .map(|i| 0.5 * (nm[(i + 1).min(last)] - nm[i.saturating_sub(1)]))
        .collect()
}

/// The windows of the lines of a light, with their places, none overlapping another.
fn lines(nm: &[f64], middle: &[f64]) -> Result<Vec<(f64, [f64; 2])>, MeasurementError> {
    let samples = Sampled::new(nm.to_vec(), middle.to_vec())?;
    let Ok(band) = Band::new(samples.first_nm().ceil(), samples.last_nm().floor()) else {
        return Ok(Vec::new());
    };
    let values = samples.on_band(band, Outside::Zero);
    let found = detect(band, &values, SpikeSettings::default());
    let mut all: Vec<(f64, [f64; 2], f64)> = found
        .spikes
        .iter()
        .map(|s| (s.spike.at_nm, s.window_nm, s.spike.weight))
        .collect();
    all.sort_by(|a, b| a.1[0].total_cmp(&b.1[0]));
    let mut apart: Vec<(f64, [f64; 2], f64)> = Vec::new();
    for line in all {
        match apart.last_mut() {
            Some(last) if line.1[0] < last.1[1] => {
                // One window, called by the heavier line.
                last.1[1] = last.1[1].max(line.1[1]);
                if line.2 > last.2 {
                    (last.0, last.2) = (line.0, line.2);
                }
            }
            _ => apart.push(line),
        }
    }
    Ok(apart
        .into_iter()
        .map(|(at, window, _)| (at, window))
        .collect())
}

/// All that is compared: level first.
fn features(nm: &[f64], middle: &[f64]) -> Result<Vec<Sum>, MeasurementError> {
    let total = widths(nm);
    let mut rest = total.clone();
    let mut found = vec![Sum {
        feature: Feature::Level,
        weights: total.clone(),
        over: Vec::new(),
    }];
    let mut of_lines = Vec::new();
    for (at, window) in lines(nm, middle)? {
        let from = nm.partition_point(|nm| *nm < window[0]);
        let to = nm.partition_point(|nm| *nm <= window[1]);
        if to < from + 3 {
            continue;
        }
        // What stands above the chord from one end of the window to the other.
        let last = to - 1;
        let mut weights = vec![0.0; nm.len()];
        for i in from + 1..last {
            let share = (nm[i] - nm[from]) / (nm[last] - nm[from]);
            weights[i] += total[i];
            weights[from] -= total[i] * (1.0 - share);
            weights[last] -= total[i] * share;
        }
        rest.iter_mut().zip(&weights).for_each(|(r, w)| *r -= w);
        of_lines.push((at, from, last, weights));
    }
    found.push(Sum {
        feature: Feature::Glow,
        weights: rest.clone(),
        over: total.clone(),
    });
    for k in 1..=COSINES {
        found.push(Sum {
            feature: Feature::Shape(k),
            weights: cosine(k, nm, &total, &of_lines),
            over: rest.clone(),
        });
    }
    found.extend(of_lines.into_iter().map(|(at, _, _, weights)| Sum {
        feature: Feature::Line(at),
        weights,
        over: total.clone(),
    }));
    if found.len() == 2 + COSINES {
        // Without lines all is glow, and its share says nothing.
        found.retain(|sum| sum.feature != Feature::Glow);
    }
    Ok(found)
}

/// A cosine of what is left once each line's window is replaced by its chord.
fn cosine(
    k: usize,
    nm: &[f64],
    total: &[f64],
    of_lines: &[(f64, usize, usize, Vec<f64>)],
) -> Vec<f64> {
    let length = nm[nm.len() - 1] - nm[0];
    let at = |i: usize| {
        let x = (nm[i] - nm[0]) / length;
        total[i] * (std::f64::consts::PI * k as f64 * x).cos()
    };
    let mut weights: Vec<f64> = (0..nm.len()).map(at).collect();
    for (_, from, last, _) in of_lines {
        for i in from + 1..*last {
            let share = (nm[i] - nm[*from]) / (nm[*last] - nm[*from]);
            let weight = at(i);
            weights[i] -= weight;
            weights[*from] += weight * (1.0 - share);
            weights[*last] += weight * share;
        }
    }
    weights
}

/// The doubt of the difference of two sets, pooled.
struct Pooled {
    /// White noise of the mean of either set at equal level, `[first, second]` together.
    variance: Vec<f64>,
    memory: Vec<f64>,
    level: f64,
    axis_nm: f64,
    slope: Vec<f64>,
    dof: f64,
}

impl Pooled {
    fn new(nm: &[f64], sets: &[Repeats; 2], totals: [f64; 2]) -> Self {
        let counts = sets.each_ref().map(|set| set.levels.len() as f64);
        let dof = counts[0] + counts[1] - 2.0;
        let pooled = |of: [f64; 2]| ((counts[0] - 1.0) * of[0] + (counts[1] - 1.0) * of[1]) / dof;
        let both = 1.0 / counts[0] + 1.0 / counts[1];
        let white =
            |i: usize| pooled([0, 1].map(|k| (sets[k].sigma[i] / totals[k]).powi(2))) * both;
        let memory = sets.each_ref().map(|set| &set.mean.memory);
        let lags = memory[0].len().max(memory[1].len());
        let rho = |lag: usize| pooled(memory.map(|m| m.get(lag).copied().unwrap_or(0.0)));
        let slopes = [0, 1].map(|k| slope(nm, sets[k].mean.samples.values()));
        let mean_slope = |i: usize| 0.5 * (slopes[0][i] / totals[0] + slopes[1][i] / totals[1]);
        Self {
            variance: (0..nm.len()).map(white).collect(),
            memory: (0..lags).map(rho).collect(),
            level: (pooled(sets.each_ref().map(|set| set.level_sd.powi(2))) * both).sqrt(),
            axis_nm: (pooled(sets.each_ref().map(|set| set.axis_sd_nm.powi(2))) * both).sqrt(),
            slope: (0..nm.len()).map(mean_slope).collect(),
            dof,
        }
    }

    /// Change of one part between the two means; `middle` is the mean of both at equal level.
    fn compared(&self, sum: &Sum, means: [&[f64]; 2], middle: &[f64]) -> Part {
        let Sum {
            feature,
            weights,
            over,
        } = sum;
        let is_level = over.is_empty();
        let of = |m: &[f64]| match is_level {
            true => dot(weights, m),
            false => dot(weights, m) / dot(over, m),
        };
        let at_middle = of(middle);
        // Shape is told as a share of the glow, all else as a share of itself.
        let unit = match feature {
            Feature::Shape(_) => 1.0,
            _ => at_middle,
        };
        let change = match is_level {
            true => (of(means[1]) / of(means[0])).ln(),
            false => (of(means[1]) - of(means[0])) / unit,
        };
        let below = if is_level { 1.0 } else { dot(over, middle) };
        let slope_at = |i: usize| match is_level {
            true => weights[i],
            false => (weights[i] - at_middle * over[i]) / below,
        };
        let slopes: Vec<f64> = (0..weights.len()).map(|i| slope_at(i) / unit).collect();
        let noisy: Vec<f64> = slopes
            .iter()
            .zip(&self.variance)
            .map(|(s, v)| s * v.sqrt())
            .collect();
        let mut white = dot(&noisy, &noisy);
        for (lag, rho) in (1..).zip(&self.memory) {
            white += 2.0 * rho * dot(&noisy, &noisy[lag.min(noisy.len())..]);
        }
        let axis = (self.axis_nm * dot(&slopes, &self.slope)).powi(2);
        let level = if is_level { self.level.powi(2) } else { 0.0 };
        let variance = white.max(0.0) + axis + level;
        let below = (level * level + axis * axis) / self.dof + white * white / (TELLING * self.dof);
        let dof = if below > 0.0 {
            (variance * variance / below).max(self.dof)
        } else {
            self.dof
        };
        let u = variance.sqrt();
        let p = match (u > 0.0, change == 0.0) {
            (true, _) => two_sided_p(change / u, dof),
            (false, true) => 1.0,
            (false, false) => 0.0,
        };
        Part {
            feature: *feature,
            change,
            u,
            p,
            is_different: false,
        }
    }
}
