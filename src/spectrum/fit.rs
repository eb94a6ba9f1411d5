//! Fitting the smooth part: plain projection, or least squares with exact inner products.
//!
//! The colour-exact fit is the projection plus the smallest correction in the span that repairs
//! three inner products (those with the colour-matching functions). With `G` the inner products
//! of the weights with the basis functions and `n` the functions' squared norms,
//!
//! ```text
//! c' = c + diag(1/n) G^T (G diag(1/n) G^T)^-1 (t - G c)
//! ```
//!
//! one 3 x 3 solve, whatever the order.

use nalgebra::{Matrix3, Vector3};

use super::{band::Band, basis::BasisTable};

/// Largest condition number of the 3 x 3 system that is still solved: beyond it the three weights
/// cannot be told apart on this band (a range that misses the visible).
pub const WORST_CONDITION: f64 = 1e8;

/// Three weights whose inner products with a series are known by its coefficients.
#[derive(Clone, Debug)]
pub struct InnerProducts {
    /// `G`: for each coefficient the three inner products of its function, value x nm.
    per_number: Vec<[f64; 3]>,
    /// One over the squared norm of each function.
    inverse_norms: Vec<f64>,
}

/// How a fit with exact inner products went.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Exactness {
    /// The three inner products are exact; the system's condition number.
    Exact {
        /// Largest over smallest eigenvalue of the 3 x 3 system.
        condition: f64,
    },
    /// Fewer than three numbers: no freedom to repair anything.
    TooFewNumbers,
    /// The weights cannot be told apart on this band: plain least squares was used.
    IllConditioned {
        /// Largest over smallest eigenvalue of the 3 x 3 system.
        condition: f64,
    },
}

impl Exactness {
    /// Whether the inner products are exact.
    pub fn is_exact(self) -> bool {
        matches!(self, Self::Exact { .. })
    }
}

impl InnerProducts {
    /// Inner products of three weights (values on the band's grid) with a table's functions.
    pub fn new(table: &BasisTable, weights: &[Vec<f64>; 3]) -> Self {
        let band: Band = table.band();
        Self {
            per_number: (0..table.numbers())
                .map(|k| std::array::from_fn(|j| band.inner(table.row(k), &weights[j])))
                .collect(),
            inverse_norms: (0..table.numbers())
                .map(|k| 1.0 / table.basis().norm_squared(k, band))
                .collect(),
        }
    }

    /// Eq. 7, corrected: the three inner products of a series, from its coefficients alone.
    pub fn of(&self, coefficients: &[f64]) -> [f64; 3] {
        let mut sums = [0.0; 3];
        for (c, g) in coefficients.iter().zip(&self.per_number) {
            for (sum, g) in sums.iter_mut().zip(g) {
                *sum += c * g;
            }
        }
        sums
    }

    /// Inner products of one function.
    pub fn row(&self, number: usize) -> [f64; 3] {
        self.per_number[number]
    }

    /// Corrects coefficients in place so that their inner products become `totals`.
    pub fn make_exact(&self, coefficients: &mut [f64], totals: [f64; 3]) -> Exactness {
        let numbers = coefficients.len();
        if numbers < 3 {
            return Exactness::TooFewNumbers;
        }
        let rows = self.per_number[..numbers].iter().zip(&self.inverse_norms);
        let mut gram = Matrix3::zeros();
        for (g, inverse) in rows.clone() {
            for i in 0..3 {
                for j in 0..=i {
                    gram[(i, j)] += g[i] * g[j] * inverse;
                }
            }
        }
        gram.fill_upper_triangle_with_lower_triangle();
        let condition = condition_number(&gram);
        if condition.is_nan() || condition >= WORST_CONDITION {
            return Exactness::IllConditioned { condition };
        }
        let now = self.of(coefficients);
        let missing = Vector3::from_fn(|j, _| totals[j] - now[j]);
        let Some(multipliers) = gram.cholesky().map(|c| c.solve(&missing)) else {
            return Exactness::IllConditioned { condition };
        };
        for (c, (g, inverse)) in coefficients.iter_mut().zip(rows) {
            *c += inverse * (0..3).map(|j| g[j] * multipliers[j]).sum::<f64>();
        }
        Exactness::Exact { condition }
    }
}

/// Ratio of the eigenvalues of a symmetric positive matrix; infinite when it is singular.
fn condition_number(gram: &Matrix3<f64>) -> f64 {
    let eigenvalues = gram.symmetric_eigenvalues();
    let (smallest, largest) = (eigenvalues.min(), eigenvalues.max());
    if smallest > 0.0 {
        largest / smallest
    } else {
        f64::INFINITY
    }
}
