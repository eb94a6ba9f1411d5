//! Levinson's recursion: the maximum-entropy density that has some given moments.
//!
//! For moments `f_k` of a positive density on the circle (`f_-k` the conjugate of `f_k`) it finds
//!
//! ```text
//! sum_j A_j f_{k-j} = s if k = 0, 0 for k = 1..n,    A_0 = 1
//! ```
//!
//! and then `s / |A(e^{i phi})|^2` is the density of largest entropy with the moments `f_0..f_n`
//! (Burg 1975). `A` has no zero on or inside the unit circle.

use nalgebra::ComplexField;

/// `A_0..A_n` and the prediction error `s`, which has the unit of the moments.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Predictor<T> {
    pub(super) coefficients: Vec<T>,
    pub(super) error: f64,
}

/// Least share of the error that one step may leave. Moments of a positive density always leave
/// some; where less than a few roundings is left it is noise, and the recursion stops there.
const LEAST_LEFT: f64 = 1e-14;

/// Solves for moments `f_0..f_n` (at least one), of which the first is real.
pub(super) fn predictor<T>(moments: &[T]) -> Predictor<T>
where
    T: ComplexField<RealField = f64> + Copy,
{
    let mut a = vec![T::one()];
    let mut error = moments[0].real();
    for n in 1..moments.len() {
        let products = a.iter().enumerate().map(|(j, a)| *a * moments[n - j]);
        let missed = products.fold(T::zero(), |sum, product| sum + product);
        let reflection = -missed.unscale(error);
        let left = 1.0 - reflection.modulus_squared();
        // Not a number for an all-zero spectrum, whose answer is the error alone: zero.
        if left.is_nan() || left < LEAST_LEFT {
            break;
        }
        a.push(T::zero());
        let turned: Vec<T> = a.iter().rev().map(|a| a.conjugate()).collect();
        for (a, turned) in a.iter_mut().zip(turned) {
            *a += reflection * turned;
        }
        error *= left;
    }
    Predictor {
        coefficients: a,
        error,
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Complex;

    use super::*;

    #[test]
    fn a_density_of_one_pole_is_found_and_more_moments_add_nothing() {
        // 1 / |1 - r z|^2 has the moments r^k / (1 - r^2).
        let r = Complex::new(0.3, -0.6);
        let scale = 1.0 / (1.0 - r.norm_sqr());
        let moments: Vec<Complex<f64>> = (0..6).map(|k| r.powu(k) * scale).collect();
        let found = predictor(&moments);
        // A handful of roundings of numbers near 1.
        assert!((found.error - 1.0).abs() < 1e-14);
        assert!((found.coefficients[1] + r).norm() < 1e-14);
        assert!(found.coefficients[2..].iter().all(|a| a.norm() < 1e-14));
    }

    #[test]
    fn the_coefficients_solve_the_toeplitz_system() {
        let moments = [2.0, 0.9, 0.1, 0.2, -0.3];
        let found = predictor(&moments);
        for k in 0..moments.len() {
            let sum: f64 = (0..moments.len())
                .map(|j| found.coefficients[j] * moments[k.abs_diff(j)])
                .sum();
            let wanted = if k == 0 { found.error } else { 0.0 };
            // A handful of roundings of numbers near 1.
            assert!((sum - wanted).abs() < 1e-14);
        }
    }

    #[test]
    fn moments_that_no_positive_density_has_end_the_recursion() {
        let found = predictor(&[1.0, 0.5, -1.2, 0.3]);
        assert_eq!(found.coefficients.len(), 2);
        assert!(found.error > 0.0);
        assert_eq!(predictor(&[0.0, 0.0]).error, 0.0);
    }
}
