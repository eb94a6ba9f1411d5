//! When a few sums no longer tell numbers apart: one limit for all rooms.
//!
//! A map of condition `k` (largest over smallest singular value) makes of the rounding of a number,
//! 2^-53, an error of `k` times that. With `k` below 1e8 what is solved for is right to 1e-8 of
//! itself, a hundred times finer than any figure is told. The limit is for the map itself: the
//! matrix of its normal equations has `k` squared, and is never solved.

use nalgebra::{DMatrix, Matrix3, Vector3};

/// Largest condition of a map that is still solved: its solution is right to 1e-8.
pub(crate) const WORST_CONDITION: f64 = 1e8;

/// Largest over smallest singular value of the matrix of some columns, at least as many as they are
/// long; infinite where the least is zero.
pub(crate) fn condition_number(columns: &[&[f64]]) -> f64 {
    let rows = columns.first().map_or(0, |c| c.len());
    let matrix = DMatrix::from_fn(rows, columns.len(), |row, column| columns[column][row]);
    ratio(matrix.singular_values().as_slice())
}

/// Largest over smallest of some singular values; infinite where the least is zero.
fn ratio(values: &[f64]) -> f64 {
    let greatest = values.iter().copied().fold(0.0, f64::max);
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    let ratio = greatest / least;
    if ratio.is_finite() {
        ratio
    } else {
        f64::INFINITY
    }
}

/// Three sums over some numbers, ready to be set by the smallest change of the numbers.
///
/// With the sums as the rows of `B`, `B^T = Q R` and `B x = t` has the least `x` in `Q R^-T t`:
/// the condition of `R` is that of `B`.
#[derive(Clone, Debug)]
pub struct ThreeSums {
    /// A row of `Q` a number.
    orthonormal: Vec<[f64; 3]>,
    triangle: Matrix3<f64>,
    condition: f64,
}

impl ThreeSums {
    /// Sums whose share of each number is a row of `shares`.
    pub fn new(shares: impl Iterator<Item = [f64; 3]>) -> Self {
        let mut rows: Vec<[f64; 3]> = shares.collect();
        let mut triangle = Matrix3::zeros();
        for j in 0..3 {
            // Twice: the second pass takes away what rounding left of the first.
            for _ in 0..2 {
                for i in 0..j {
                    let along: f64 = rows.iter().map(|row| row[i] * row[j]).sum();
                    triangle[(i, j)] += along;
                    rows.iter_mut().for_each(|row| row[j] -= along * row[i]);
                }
            }
            let length = rows.iter().map(|row| row[j] * row[j]).sum::<f64>().sqrt();
            triangle[(j, j)] = length;
            if length > 0.0 {
                rows.iter_mut().for_each(|row| row[j] /= length);
            }
        }
        let is_finite = triangle.iter().all(|v| v.is_finite());
        Self {
            orthonormal: rows,
            condition: if is_finite {
                ratio(triangle.singular_values().as_slice())
            } else {
                f64::INFINITY
            },
            triangle,
        }
    }

    /// Largest over smallest singular value of the sums.
    pub fn condition(&self) -> f64 {
        self.condition
    }

    /// True if the sums can be set independently: condition number below [`WORST_CONDITION`].
    pub(crate) fn are_told_apart(&self) -> bool {
        self.condition < WORST_CONDITION
    }

    /// The smallest change of the numbers that adds `missing` to the sums, number by number; `None`
    /// where the sums are not told apart.
    pub fn change(&self, missing: [f64; 3]) -> Option<impl Iterator<Item = f64>> {
        if !self.are_told_apart() {
            return None;
        }
        let wanted = Vector3::from(missing);
        let along = self.triangle.transpose().solve_lower_triangular(&wanted)?;
        let rows = self.orthonormal.iter();
        Some(rows.map(move |q| (0..3).map(|j| q[j] * along[j]).sum()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Three sums of five numbers, the third `apart` from the sum of the others.
    fn sums(apart: f64) -> Vec<[f64; 3]> {
        let numbers = (0..5).map(f64::from);
        let row = |n: f64| [1.0, n, 1.0 + n + apart * n * n];
        numbers.map(row).collect()
    }

    #[test]
    fn sums_that_hardly_differ_are_set_to_a_share_that_the_limit_states() {
        for apart in [1.0, 1e-3, 1e-6] {
            let shares = sums(apart);
            let of_all = ThreeSums::new(shares.iter().copied());
            assert!(of_all.are_told_apart(), "{apart}");
            let wanted = [0.3, -1.0, 0.25];
            let change: Vec<f64> = of_all.change(wanted).expect("told apart").collect();
            let size = change.iter().fold(0.0_f64, |most, c| most.max(c.abs()));
            for (k, wanted) in wanted.into_iter().enumerate() {
                let found: f64 = change.iter().zip(&shares).map(|(c, s)| c * s[k]).sum();
                // A sum of five products, each rounded at the size of the change.
                assert!(
                    (found - wanted).abs() < 1e-14 * size * 16.0,
                    "{apart} {found}"
                );
            }
        }
    }

    #[test]
    fn the_condition_is_that_of_the_sums_and_not_its_square() {
        for apart in [1.0, 1e-3, 1e-6] {
            let shares = sums(apart);
            let rows: [Vec<f64>; 3] =
                std::array::from_fn(|k| shares.iter().map(|s| s[k]).collect());
            let columns = rows.each_ref().map(|row| &row[..]);
            let whole = DMatrix::from_fn(5, 3, |i, k| columns[k][i]);
            let values = whole.singular_values();
            let expected = values.max() / values.min();
            let found = ThreeSums::new(shares.into_iter()).condition();
            // Singular values are right to rounding of the largest.
            assert!((found / expected - 1.0).abs() < 1e-14 * expected, "{apart}");
        }
        let twice = ThreeSums::new((0..4).map(|i| [1.0, f64::from(i), 2.0]));
        assert!(!twice.are_told_apart() && twice.change([1.0; 3]).is_none());
        assert!(!ThreeSums::new(std::iter::empty()).are_told_apart());
        assert!(!ThreeSums::new([[f64::NAN; 3]; 4].into_iter()).are_told_apart());
    }
}
