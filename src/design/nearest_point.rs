//! The point of a sum of segments that is nearest to the origin.
//!
//! The colours of all reflectances of 0-1 under a light are such a body: each wavelength adds a
//! segment from nothing to its full share of X, Y and Z. Its corner farthest in a direction is
//! known at once (every wavelength that helps, no other), and that is all the method asks for.
//!
//! Source: P. Wolfe, "Finding the nearest point in a polytope", Mathematical Programming 11
//! (1976) 128-149.

use nalgebra::{DMatrix, DVector};

use super::small::{add, combined, dot};

/// Rounds of which each takes a corner in.
const MOST_ROUNDS: usize = 1000;

/// Rounding, as a share of the body's size: a corner that is nearer by less is none.
const CLOSE: f64 = 1e-13;

/// Shares below this are none.
const NO_SHARE: f64 = 1e-12;

/// A corner: the point, and which segments it takes.
struct Corner<const M: usize> {
    at: [f64; M],
    takes: Vec<bool>,
}

/// The shares (0-1) of segments `0..columns[j]` whose sum is nearest to `target`.
pub(super) fn nearest_shares<const M: usize>(columns: &[[f64; M]], target: [f64; M]) -> Vec<f64> {
    let corner = |direction: &[f64; M]| {
        let takes: Vec<bool> = columns.iter().map(|c| dot(c, direction) > 0.0).collect();
        let mut at = target.map(|v| -v);
        for (column, _) in columns.iter().zip(&takes).filter(|(_, takes)| **takes) {
            add(&mut at, column, 1.0);
        }
        Corner { at, takes }
    };
    let size = 1.0 + columns.iter().map(|c| dot(c, c).sqrt()).sum::<f64>();
    let mut held = vec![corner(&target)];
    let mut shares = vec![1.0];
    let mut point = held[0].at;
    for _ in 0..MOST_ROUNDS {
        let next = corner(&point.map(|v| -v));
        let gain = dot(&point, &point) - dot(&point, &next.at);
        let distance = dot(&point, &point).sqrt();
        if distance <= CLOSE * size || gain <= CLOSE * size * distance {
            break;
        }
        if held.iter().any(|old| old.takes == next.takes) {
            break;
        }
        held.push(next);
        shares.push(0.0);
        if !shrink(&mut held, &mut shares) {
            break;
        }
        point = combined(held.iter().map(|corner| &corner.at), &shares);
    }
    let mut found = vec![0.0; columns.len()];
    for (corner, share) in held.iter().zip(&shares) {
        for (value, _) in found
            .iter_mut()
            .zip(&corner.takes)
            .filter(|(_, takes)| **takes)
        {
            *value += share;
        }
    }
    found.iter_mut().for_each(|v| *v = v.clamp(0.0, 1.0));
    found
}

/// Moves to the nearest point of the flat through the corners, dropping those it would leave
/// behind; false where they lie too badly to tell.
fn shrink<const M: usize>(held: &mut Vec<Corner<M>>, shares: &mut Vec<f64>) -> bool {
    loop {
        let Some(goal) = flat_shares(held) else {
            held.pop();
            shares.pop();
            let whole: f64 = shares.iter().sum();
            shares.iter_mut().for_each(|s| *s /= whole);
            return false;
        };
        if goal.iter().all(|share| *share > NO_SHARE) {
            *shares = goal;
            return true;
        }
        let step = shares
            .iter()
            .zip(&goal)
            .filter(|(_, goal)| **goal <= NO_SHARE)
            .map(|(old, goal)| old / (old - goal).max(f64::MIN_POSITIVE))
            .fold(1.0, f64::min);
        let mut kept = Vec::with_capacity(held.len());
        let mut left = Vec::with_capacity(held.len());
        let mut lost_one = false;
        for ((corner, old), goal) in held.drain(..).zip(shares.iter()).zip(&goal) {
            let share = old + step * (goal - old);
            if share > NO_SHARE {
                kept.push(corner);
                left.push(share);
            } else {
                lost_one = true;
            }
        }
        *held = kept;
        *shares = left;
        if !lost_one || held.is_empty() {
            return !held.is_empty();
        }
    }
}

/// Shares (of sum one, of any sign) of the point nearest to the origin on the flat through the
/// corners.
fn flat_shares<const M: usize>(held: &[Corner<M>]) -> Option<Vec<f64>> {
    let count = held.len();
    // Differences from the first corner keep what is common to all out of the products.
    let mut normal = DMatrix::zeros(count - 1, count - 1);
    let mut right = DVector::zeros(count - 1);
    let from: Vec<[f64; M]> = held[1..]
        .iter()
        .map(|corner| std::array::from_fn(|k| corner.at[k] - held[0].at[k]))
        .collect();
    for (row, a) in from.iter().enumerate() {
        right[row] = -dot(a, &held[0].at);
        for (column, b) in from.iter().enumerate() {
            normal[(row, column)] = dot(a, b);
        }
    }
    if count == 1 {
        return Some(vec![1.0]);
    }
    let found = normal.full_piv_lu().solve(&right)?;
    let rest = 1.0 - found.iter().sum::<f64>();
    let shares: Vec<f64> = std::iter::once(rest).chain(found.iter().copied()).collect();
    shares.iter().all(|s| s.is_finite()).then_some(shares)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_inside_is_met_and_one_outside_is_approached_at_right_angles() {
        let cube = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        for (target, nearest) in [
            ([0.25, 0.5, 0.75], [0.25, 0.5, 0.75]),
            ([2.0, 0.5, -1.0], [1.0, 0.5, 0.0]),
            ([0.5, 0.5, 1.5], [0.5, 0.5, 1.0]),
        ] {
            let found = combined(&cube, &nearest_shares(&cube, target));
            for k in 0..3 {
                // The stop is at 1e-13 of the body's size.
                assert!((found[k] - nearest[k]).abs() < 1e-10, "{found:?}");
            }
        }
    }
}
