//! The paper's detector, for comparison: a spike is where the curve is steep on both sides.
//!
//! The paper only says "by use of the gradient information" (Implementation); this is the plain
//! reading: a local maximum with a flank steeper than `g max|S|` per nm on both sides within three
//! of the widest line, standing on the straight line between the feet of its flanks. It misses
//! weak lines beside strong ones, whatever energy they carry, which is why it is not the default.

use super::{
    band::Band,
    line::{GAUSSIAN_AREA, Line},
    spikes::{Constraints, Decomposition, FoundSpike},
};

/// Steepest slope that still counts as smooth, as a share of the maximum per nm.
///
/// 2 % per nm: a Gaussian band of 40 nm full width stays just below it.
pub const DEFAULT_GRADIENT: f64 = 0.02;

/// Flanks are looked for within this many of the widest line.
const REACH_WIDTHS: f64 = 3.0;

/// Spikes by gradient on values on a band's grid.
///
/// `gradient` is the least slope as a share of the largest value per nm; `max_width_nm` bounds
/// the search and the full width at half maximum of what is accepted.
///
/// Lines at the places of `constraints.leave` stay in the smooth part.
pub fn detect(
    band: Band,
    values: &[f64],
    gradient: f64,
    max_width_nm: f64,
    constraints: Constraints<'_>,
) -> Decomposition {
    let mut parts = Decomposition::untouched(band, values);
    if let Some(power) = constraints.power {
        parts.power = power;
    }
    let top = values.iter().copied().fold(0.0_f64, |m, v| m.max(v.abs()));
    let steep = gradient * top;
    if !(steep > 0.0 && steep.is_finite()) {
        return parts;
    }
    let reach = (REACH_WIDTHS * max_width_nm).ceil() as usize;
    let last = values.len() - 1;
    let mut from = 0;
    for at in 1..last {
        let is_peak = values[at] >= values[at - 1] && values[at] > values[at + 1];
        if !is_peak || at < from {
            continue;
        }
        let left = foot(values, at, reach, steep, |i| i.checked_sub(1));
        let right = foot(values, at, reach, steep, |i| (i < last).then_some(i + 1));
        let (Some(left), Some(right)) = (left, right) else {
            continue;
        };
        let (left, right) = (left.max(from), right);
        let slope = (values[right] - values[left]) / (right - left) as f64;
        let residue: Vec<f64> = (left..=right)
            .map(|i| (values[i] - values[left] - slope * (i - left) as f64).max(0.0))
            .collect();
        let height = residue.iter().copied().fold(0.0, f64::max);
        let energy: f64 = residue.iter().sum();
        let width_nm = energy / (GAUSSIAN_AREA * height);
        let is_line = height > 0.0 && width_nm <= max_width_nm;
        if !is_line {
            continue;
        }
        let moment: f64 = residue
            .iter()
            .enumerate()
            .map(|(i, r)| r * band.nm(left + i))
            .sum();
        let found = FoundSpike {
            spike: Line::ideal(moment / energy, energy),
            width_nm,
            peaks: 1,
            window_nm: [band.nm(left), band.nm(right)],
        };
        if constraints.leave.iter().any(|nm| found.covers(*nm)) {
            continue;
        }
        for (v, r) in parts.smooth[left..].iter_mut().zip(&residue) {
            *v -= r;
        }
        parts.spikes.push(found);
        from = right;
    }
    parts
}

/// Walks from a peak down a flank: past the rounded top, along the steep part, to where it turns
/// gentle. `None` when nothing steep is within reach.
fn foot(
    values: &[f64],
    peak: usize,
    reach: usize,
    steep: f64,
    next: impl Fn(usize) -> Option<usize>,
) -> Option<usize> {
    let mut i = peak;
    let mut was_steep = false;
    for _ in 0..reach {
        let Some(j) = next(i) else { break };
        let fall = values[i] - values[j];
        if fall > steep {
            was_steep = true;
        } else if was_steep || fall < 0.0 {
            break;
        }
        i = j;
    }
    was_steep.then_some(i)
}
