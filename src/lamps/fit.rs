//! Least squares over the three goals, each weighed by one over its own error.
//!
//! Weights `t = q / (e + eps)` make the goal `sum q log(e + eps)`: free of scale, and no goal can buy
//! its gain with a larger loss of another.

use nalgebra::{DMatrix, DVector};

use super::{
    goals::{GOALS, Goals},
    orthonormal::{Orthonormal, subtract},
};
use crate::spectrum::dot;

/// Shares of the goals: patches, filters, spectrum. Patches have less, since their own reflectances,
/// approximated too, leave an error that no light can lower. They were set while lamps were looked at
/// (LINES.md 5); `tests/core/held_out.rs` races them on lamps that were not.
pub(super) const SHARES: [f64; GOALS] = [0.5, 1.25, 1.25];

/// Weights of the first fit, before errors are known.
pub(super) const FIRST_WEIGHTS: [f64; GOALS] = [10.0, 1.0, 20.0];

/// Errors below this share of the plain cosine's count as none, and so do those below the floor.
const SMALL: f64 = 0.03;
const FLOOR: [f64; GOALS] = [2e-6, 2e-5, 1e-6];

/// The errors that count as none, from those of the plain cosine.
pub(super) fn small_errors(plain: [f64; GOALS]) -> [f64; GOALS] {
    std::array::from_fn(|g| SMALL * plain[g] + FLOOR[g])
}

/// True if the filter and spectrum errors are at most the floor; the patches are approximated
/// themselves and are off by their own error.
pub(super) fn is_none(errors: [f64; GOALS]) -> bool {
    (1..GOALS).all(|g| errors[g] <= FLOOR[g])
}

/// `sum q log(e + eps)`: what is made least.
pub(super) fn score(errors: [f64; GOALS], small: [f64; GOALS]) -> f64 {
    (0..GOALS)
        .map(|g| SHARES[g] * (errors[g] + small[g]).ln())
        .sum()
}

/// Weights from errors.
pub(super) fn weights_of(errors: [f64; GOALS], small: [f64; GOALS]) -> [f64; GOALS] {
    std::array::from_fn(|g| SHARES[g] / (errors[g] + small[g]))
}

/// A fit of columns.
#[derive(Clone, Debug)]
pub(super) struct Fitted {
    /// The weight of each column.
    pub weights: Vec<f64>,
    /// The errors of the goals, linearised.
    pub errors: [f64; GOALS],
    /// Weights of the goals in the last fit.
    pub goals: [f64; GOALS],
}

/// Directions of columns (as errors of the goals) at weights of the goals.
pub(super) fn directions<'a>(
    at: &Goals,
    columns: impl Iterator<Item = &'a [f64]>,
    goals: [f64; GOALS],
) -> Orthonormal {
    let mut basis = Orthonormal::default();
    add_directions(at, &mut basis, columns, goals);
    basis
}

fn add_directions<'a>(
    at: &Goals,
    basis: &mut Orthonormal,
    columns: impl Iterator<Item = &'a [f64]>,
    goals: [f64; GOALS],
) {
    for column in columns {
        basis.push(&at.weighed(goals, column));
    }
}

/// Fits columns to a target, both as errors of the goals, beginning with weights `goals`; then
/// `again` times with weights from the errors. `basis` has the directions of the first columns at
/// these weights, `columns` are the others.
pub(super) fn fit(
    at: &Goals,
    mut basis: Orthonormal,
    columns: &[&[f64]],
    target: &[f64],
    goals: [f64; GOALS],
    (small, again): (Option<[f64; GOALS]>, usize),
) -> Fitted {
    add_directions(at, &mut basis, columns.iter().copied(), goals);
    let (mut rest, mut sums) = basis.rest_of(&at.weighed(goals, target));
    let errors_of = |rest: &[f64]| {
        let norms = at.norms(rest);
        std::array::from_fn(|g| norms[g] / goals[g])
    };
    let mut errors: [f64; GOALS] = errors_of(&rest);
    let mut last = goals;
    // In the basis that is orthonormal at the first weights, other weights make a small system that
    // is as well conditioned as the weights' ratios are.
    let grams = (again > 0).then(|| grams(at, &basis));
    for _ in 0..again {
        let (Some(small), Some(grams)) = (small, &grams) else {
            break;
        };
        let now = weights_of(errors, small);
        let ratios: [f64; GOALS] = std::array::from_fn(|g| (now[g] / goals[g]).powi(2));
        if let Some(step) = step(at, &basis, grams, &rest, ratios) {
            for (sum, (s, vector)) in sums.iter_mut().zip(step.iter().zip(&basis.vectors)) {
                *sum += s;
                subtract(&mut rest, *s, vector);
            }
            last = now;
        }
        errors = errors_of(&rest);
    }
    Fitted {
        weights: basis.solve(&sums),
        errors,
        goals: last,
    }
}

/// Sums of the vectors with one another, goal by goal.
fn grams(at: &Goals, basis: &Orthonormal) -> [DMatrix<f64>; GOALS] {
    let n = basis.vectors.len();
    at.ranges().map(|range| {
        let mut gram = DMatrix::zeros(n, n);
        for i in 0..n {
            for j in 0..=i {
                let sum = dot(
                    &basis.vectors[i][range.clone()],
                    &basis.vectors[j][range.clone()],
                );
                gram[(i, j)] = sum;
                gram[(j, i)] = sum;
            }
        }
        gram
    })
}

/// Change of the vectors' weights with the goals' weights; `None` where it cannot be determined.
fn step(
    at: &Goals,
    basis: &Orthonormal,
    grams: &[DMatrix<f64>; GOALS],
    rest: &[f64],
    ratios: [f64; GOALS],
) -> Option<Vec<f64>> {
    let n = basis.vectors.len();
    let mut gram = DMatrix::zeros(n, n);
    let mut right = DVector::zeros(n);
    for ((part, ratio), range) in grams.iter().zip(ratios).zip(at.ranges()) {
        gram += part * ratio;
        for (value, vector) in right.iter_mut().zip(&basis.vectors) {
            *value += ratio * dot(&vector[range.clone()], &rest[range.clone()]);
        }
    }
    let step = gram.cholesky()?.solve(&right);
    step.iter()
        .all(|s| s.is_finite())
        .then(|| step.as_slice().to_vec())
}
