//! Functions that are zero outside a part of the grid.

use crate::spectrum::dot;

/// Below this share of its height a function is left out.
const NEGLIGIBLE: f64 = 1e-12;

/// A function that is zero outside a window of the grid.
#[derive(Clone, Debug)]
pub(super) struct Window {
    first: usize,
    values: Vec<f64>,
}

impl Window {
    /// The part of a function that counts.
    pub(super) fn of(values: &[f64]) -> Self {
        let height = values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let counts = |v: &f64| v.abs() > NEGLIGIBLE * height;
        let first = values.iter().position(counts).unwrap_or(0);
        let last = values.iter().rposition(counts).unwrap_or(0);
        Self {
            first,
            values: values[first..=last].to_vec(),
        }
    }

    /// Sum of products with values that begin at grid point `first`.
    pub(super) fn dot(&self, first: usize, values: &[f64]) -> f64 {
        let from = self.first.max(first);
        let to = (self.first + self.values.len()).min(first + values.len());
        if from >= to {
            return 0.0;
        }
        dot(
            &self.values[from - self.first..to - self.first],
            &values[from - first..to - first],
        )
    }

    /// Adds the function times a weight to values on the whole grid.
    pub(super) fn add_to(&self, weight: f64, out: &mut [f64]) {
        for (o, v) in out[self.first..].iter_mut().zip(&self.values) {
            *o += weight * v;
        }
    }
}
