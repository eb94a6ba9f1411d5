//! What two sets of scans are compared by: level, lines, glow and its shape, linear sums of the light
//! or quotients of two.

use std::fmt;

use super::error::MeasurementError;
use crate::spectrum::{Band, Outside, Sampled, SpikeSettings, detect};

/// Cosines of the glow that are compared.
pub const COSINES: usize = 7;

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
    /// The correlated colour temperature, told beside what changed it.
    Cct,
}

impl fmt::Display for Feature {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Level => f.write_str(said!("level")),
            Self::Line(_) => f.write_str(said!("line")),
            Self::Glow => f.write_str(said!("glow")),
            Self::Shape(1) => f.write_str(said!("tilt of the glow")),
            Self::Shape(_) => f.write_str(said!("shape of the glow")),
            Self::Cct => f.write_str("CCT"),
        }
    }
}

/// A linear sum of samples, or a quotient of two.
pub(super) struct Sum {
    pub feature: Feature,
    pub weights: Vec<f64>,
    pub over: Vec<f64>,
}

/// The stretch that each sample stands for, nm.
pub(super) fn widths(nm: &[f64]) -> Vec<f64> {
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
pub(super) fn features(nm: &[f64], middle: &[f64]) -> Result<Vec<Sum>, MeasurementError> {
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
