//! Orthonormal directions in the space of the goals' rows.

use crate::spectrum::dot;

/// A column of which less than this share of its norm is new adds nothing but rounding.
const NEW: f64 = 1e-9;

/// Remaining share of a column's norm from which on one projection leaves no more than ten times
/// the rounding of a number in the directions before it.
const CLEARLY_NEW: f64 = 0.1;

/// Orthonormal vectors with the columns they were made from.
///
/// Nothing is squared: each column is projected on the complement of those before it, and once more
/// where little of it was left.
#[derive(Clone, Debug, Default)]
pub(super) struct Orthonormal {
    /// The vectors.
    pub vectors: Vec<Vec<f64>>,
    /// Of each column, its sums with the vectors up to its own; the last is the length that was
    /// new. `None` for a column that added nothing.
    pub columns: Vec<Option<Vec<f64>>>,
}

impl Orthonormal {
    /// Takes a column in; whether it added a direction.
    pub(super) fn push(&mut self, column: &[f64]) -> bool {
        let mut rest = column.to_vec();
        let mut sums = vec![0.0; self.vectors.len() + 1];
        let whole = dot(column, column).sqrt();
        let mut length = 0.0;
        for _ in 0..2 {
            project_out(&self.vectors, &mut rest, &mut sums);
            length = dot(&rest, &rest).sqrt();
            if length > CLEARLY_NEW * whole {
                break;
            }
        }
        let is_new = length > NEW * whole;
        if !is_new {
            self.columns.push(None);
            return false;
        }
        let unit = 1.0 / length;
        rest.iter_mut().for_each(|v| *v *= unit);
        sums[self.vectors.len()] = length;
        self.vectors.push(rest);
        self.columns.push(Some(sums));
        true
    }

    /// The same of the first columns only.
    pub(super) fn first(&self, columns: usize) -> Self {
        let columns = self.columns[..columns.min(self.columns.len())].to_vec();
        let kept = columns.iter().flatten().count();
        Self {
            vectors: self.vectors[..kept].to_vec(),
            columns,
        }
    }

    /// Residual of a target, and its inner products with the vectors.
    pub(super) fn rest_of(&self, target: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let mut rest = target.to_vec();
        let mut sums = vec![0.0; self.vectors.len()];
        for _ in 0..2 {
            project_out(&self.vectors, &mut rest, &mut sums);
        }
        (rest, sums)
    }

    /// The weight of each column in a sum of vectors; 0 for a column that added nothing.
    pub(super) fn solve(&self, sums: &[f64]) -> Vec<f64> {
        let mut left = sums.to_vec();
        let mut weights = vec![0.0; self.columns.len()];
        for (weight, column) in weights.iter_mut().zip(&self.columns).rev() {
            let Some(column) = column else { continue };
            let last = column.len() - 1;
            *weight = left[last] / column[last];
            for (l, c) in left.iter_mut().zip(column) {
                *l -= *weight * c;
            }
        }
        weights
    }
}

/// Takes orthonormal vectors out of what is left of values, and adds what there was of each to the
/// sums.
pub(super) fn project_out(vectors: &[Vec<f64>], rest: &mut [f64], sums: &mut [f64]) {
    for (sum, vector) in sums.iter_mut().zip(vectors) {
        let s = dot(vector, rest);
        *sum += s;
        subtract(rest, s, vector);
    }
}

/// `values - factor * vector`, in place.
pub(super) fn subtract(values: &mut [f64], factor: f64, vector: &[f64]) {
    for (value, v) in values.iter_mut().zip(vector) {
        *value -= factor * v;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sum_of_columns_is_taken_apart_into_its_weights() {
        let column = |k: usize| -> Vec<f64> {
            (0..40)
                .map(|i| ((i * (k + 1)) as f64 * 0.13).sin())
                .collect()
        };
        let mut basis = Orthonormal::default();
        for k in 0..5 {
            assert!(basis.push(&column(k)));
        }
        assert!(!basis.push(&column(2)), "it is there already");
        let wanted = [1.0, -2.0, 0.5, 3.0, 0.0];
        let mut target = vec![0.0; 40];
        for (k, w) in wanted.iter().enumerate() {
            subtract(&mut target, -w, &column(k));
        }
        let (rest, sums) = basis.rest_of(&target);
        // Ten projections of numbers of size 3.
        assert!(rest.iter().all(|r| r.abs() < 1e-13));
        for (found, wanted) in basis.solve(&sums).iter().zip(wanted) {
            assert!((found - wanted).abs() < 1e-12);
        }
    }
}
