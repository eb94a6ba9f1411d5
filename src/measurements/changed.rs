//! Differences between two sets of scans: level, lines and glow, tested all together.
//!
//! Every part is a quotient of two linear sums of the light, so that its error by noise, memory
//! and axis is known without drawing; the parts but the level are tested by Holm's procedure.

use super::statistics::LEVEL_OF_TEST;
use std::fmt;

use super::{
    doubt::doubts,
    error::MeasurementError,
    features::{Feature, Sum, features, widths},
    figures::{Figure, dot},
    measurement::Measurement,
    repeats::{Repeats, RepeatsError, Scans, slope},
    statistics::{holm, quantile_of_p, two_sided_p},
};
use crate::spectrum::{Outside, Sampled};

/// Degrees of freedom of what is stated.
const STATED: f64 = 1e6;

/// Degrees of freedom of the white noise for each of the scans'.
const TELLING: f64 = 40.0;

/// Verdict on two sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// No difference beyond the noise.
    Same,
    /// At least one part differs.
    Different,
    /// Nothing tells the noise: fewer than three scans without sigma.
    CannotSay,
}

impl Verdict {
    /// The word of JSON and of sentences.
    pub fn word(self) -> &'static str {
        match self {
            Self::Same => "same",
            Self::Different => "different",
            Self::CannotSay => "cannot say",
        }
    }
}

/// One part and how it changed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    pub feature: Feature,
    /// From the first set to the second: a share of itself for level, lines and glow; a share of
    /// the glow for its shape; K for the CCT.
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

impl Changed {
    /// Nothing can be said: too little is known of the noise.
    pub fn unsaid() -> Self {
        Self {
            verdict: Verdict::CannotSay,
            parts: Vec::new(),
            compared: Vec::new(),
            least_seen_percent: f64::NAN,
        }
    }
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
            Self::CannotSay(why) => f.write_str(&tr!("Cannot say: {why}", why)),
            Self::Dark => f.write_str(said!("Cannot say: found no power above 0 in both sets.")),
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
    let mut all: Vec<Measurement> = grid.values.iter().map(on_grid).collect::<Result<_, _>>()?;
    all.iter_mut()
        .zip(&both)
        .for_each(|(on, own)| stated(on, own));
    let (a, b) = all.split_at(first.len());
    let sets = [set_of(a)?, set_of(b)?];
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
    if is_different && parts.len() < MOST_PARTS {
        parts.extend(change_of_cct(&sets));
    }
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

/// What a scan's own file states of its noise, on the common grid.
fn stated(on: &mut Measurement, own: &Measurement) {
    let sigma = own.sigma.clone();
    let sigma = sigma.and_then(|sigma| own.samples.sharing(sigma).ok());
    let at = |sigma: Sampled| -> Vec<f64> {
        let nm = on.samples.nm().iter();
        nm.map(|nm| sigma.at(*nm, Outside::Hold)).collect()
    };
    on.sigma = sigma.map(at);
    (on.level, on.axis_nm) = (own.level, own.axis_nm);
    if own.samples.nm() == on.samples.nm() {
        on.memory.clone_from(&own.memory);
    }
}

/// A set of scans, or one scan that states its noise.
fn set_of(scans: &[Measurement]) -> Result<Repeats, RepeatsError> {
    match scans {
        [one] if one.sigma.is_some() => Ok(Repeats::stated(one)),
        _ => Repeats::of(scans),
    }
}

/// Change of the CCT from one mean to the other, K; `None` where it is within its doubt.
fn change_of_cct(sets: &[Repeats; 2]) -> Option<Part> {
    let of = |set: &Repeats| {
        let all = doubts(&set.mean);
        all.iter().find(|d| d.figure == Figure::Cct)?.doubt
    };
    let (a, b) = (of(&sets[0])?, of(&sets[1])?);
    let (change, u) = (b.value - a.value, a.u.hypot(b.u));
    let p = match u > 0.0 {
        true => two_sided_p(change / u, a.dof.min(b.dof).min(1e6)),
        false => f64::from(u8::from(change == 0.0)),
    };
    (p < LEVEL_OF_TEST).then_some(Part {
        feature: Feature::Cct,
        change,
        u,
        p,
        is_different: true,
    })
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
        let are_repeats = counts.iter().all(|n| *n > 1.0);
        // One scan that states its noise is no sample of it: nothing is pooled then.
        let dof = match are_repeats {
            true => counts[0] + counts[1] - 2.0,
            false => counts
                .iter()
                .filter(|n| **n > 1.0)
                .map(|n| n - 1.0)
                .fold(STATED, f64::min),
        };
        let of_both = |of: [f64; 2]| match are_repeats {
            true => {
                let pooled = (counts[0] - 1.0) * of[0] + (counts[1] - 1.0) * of[1];
                pooled / dof * (1.0 / counts[0] + 1.0 / counts[1])
            }
            false => of[0] / counts[0] + of[1] / counts[1],
        };
        let white = |i: usize| of_both([0, 1].map(|k| (sets[k].sigma[i] / totals[k]).powi(2)));
        let memory = sets.each_ref().map(|set| &set.mean.memory);
        let lags = memory[0].len().max(memory[1].len());
        let rho = |lag: usize| {
            let own = memory.map(|m| m.get(lag).copied().unwrap_or(0.0));
            of_both(own) / of_both([1.0, 1.0])
        };
        let slopes = [0, 1].map(|k| slope(nm, sets[k].mean.samples.values()));
        let mean_slope = |i: usize| 0.5 * (slopes[0][i] / totals[0] + slopes[1][i] / totals[1]);
        Self {
            variance: (0..nm.len()).map(white).collect(),
            memory: (0..lags).map(rho).collect(),
            level: of_both(sets.each_ref().map(|set| set.level_sd.powi(2))).sqrt(),
            axis_nm: of_both(sets.each_ref().map(|set| set.axis_sd_nm.powi(2))).sqrt(),
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
