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
//! whatever the order. It is solved by orthonormal rows, not by that 3 x 3 matrix, whose condition
//! is the square of the map's ([`ThreeSums`]).

use super::{band::Band, condition::ThreeSums, series::BasisTable};

/// Three weights whose inner products with a series are known by its coefficients.
#[derive(Clone, Debug)]
pub struct InnerProducts {
    /// `G`: for each coefficient the three inner products of its function, value x nm.
    per_number: Vec<[f64; 3]>,
    /// The norm of each function.
    norms: Vec<f64>,
}

/// Outcome of a fit with exact inner products.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Exactness {
    /// The three inner products are exact.
    Exact {
        /// Largest over smallest singular value of the inner products.
        condition: f64,
    },
    /// Fewer than three numbers: no freedom to repair anything.
    TooFewNumbers,
    /// The weights cannot be told apart on this band: plain least squares was used.
    IllConditioned {
        /// Largest over smallest singular value of the inner products.
        condition: f64,
    },
}

impl Exactness {
    /// True if the inner products are exact.
    pub(crate) fn is_exact(self) -> bool {
        matches!(self, Self::Exact { .. })
    }
}

impl InnerProducts {
    /// Inner products of three weights (values on the band's grid) with a table's functions.
    pub(crate) fn new(table: &BasisTable, weights: &[Vec<f64>; 3]) -> Self {
        let band: Band = table.band();
        Self {
            per_number: (0..table.numbers())
                .map(|k| std::array::from_fn(|j| band.inner(table.row(k), &weights[j])))
                .collect(),
            norms: (0..table.numbers())
                .map(|k| table.basis().norm_squared(k, band).sqrt())
                .collect(),
        }
    }

    /// Eq. 7, corrected: the three inner products of a series, from its coefficients alone.
    pub(crate) fn of(&self, coefficients: &[f64]) -> [f64; 3] {
        let mut sums = [0.0; 3];
        for (c, g) in coefficients.iter().zip(&self.per_number) {
            for (sum, g) in sums.iter_mut().zip(g) {
                *sum += c * g;
            }
        }
        sums
    }

    /// Inner products of one function.
    pub(crate) fn row(&self, number: usize) -> [f64; 3] {
        self.per_number[number]
    }

    /// Corrects coefficients in place so that their inner products become `totals`.
    pub(crate) fn make_exact(&self, coefficients: &mut [f64], totals: [f64; 3]) -> Exactness {
        let numbers = coefficients.len();
        if numbers < 3 {
            return Exactness::TooFewNumbers;
        }
        let rows = self.per_number[..numbers].iter().zip(&self.norms);
        let sums = ThreeSums::new(rows.map(|(g, norm)| g.map(|g| g / norm)));
        let condition = sums.condition();
        let now = self.of(coefficients);
        let missing = std::array::from_fn(|j| totals[j] - now[j]);
        let Some(change) = sums.change(missing) else {
            return Exactness::IllConditioned { condition };
        };
        for ((c, change), norm) in coefficients.iter_mut().zip(change).zip(&self.norms) {
            *c += change / norm;
        }
        Exactness::Exact { condition }
    }
}
