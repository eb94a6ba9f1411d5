//! The bounded maximum-entropy estimate: a signal inside \[0, 1\] from its trigonometric moments
//! (Peters et al. 2019, after Markov's exponential moments).
//!
//! With `H(z) = c_0 + 2 sum c_j z^j`, whose real part on the unit circle is the signal g, the
//! function `F = exp(i pi (H - 1/2))` has a real part of at least zero exactly when g stays inside
//! \[0, 1\]. Its power series follows from the moments by `k F_k = sum_j j E_j F_{k-j}` with
//! `E_j = 2 pi i c_j`, and `Re F_0, F_1/2, F_2/2, ...` are moments of the positive density Re F.
//! Maximum entropy gives that density as `s / |A|^2`, so `F = B/A` with a polynomial B, and
//!
//! ```text
//! g(phi) = 1/2 + arg(B conj(A)) / pi,     Re(B conj(A)) = s > 0
//! ```
//!
//! An even signal has `1/F` for the mirror image of F, whence `B_j = F_0 conj(A_j)`: one
//! polynomial is enough.

use std::f64::consts::PI;

use nalgebra::Complex;

use super::{
    levinson::{Predictor, predictor},
    phases::PhaseTable,
};

/// Quantities computed once from the moments of a bounded even signal.
#[derive(Clone, Debug)]
pub(super) struct BoundedReading {
    /// `F_0`, of modulus 1.
    first: Complex<f64>,
    predictor: Predictor<Complex<f64>>,
}

impl BoundedReading {
    /// From `c_0, c_1, ...`; at least one.
    pub(super) fn of(moments: &[f64]) -> Self {
        let series = exponential_series(moments);
        let mut density: Vec<Complex<f64>> = series.iter().map(|f| f * 0.5).collect();
        density[0] = Complex::new(series[0].re, 0.0);
        Self {
            first: series[0],
            predictor: predictor(&density),
        }
    }

    /// The signal at a phase, 0 to pi.
    pub(super) fn at_phase(&self, phi: f64) -> f64 {
        let (sin, cos) = phi.sin_cos();
        let z = Complex::new(cos, sin);
        let (mut plain, mut turned) = (Complex::ZERO, Complex::ZERO);
        for a in self.predictor.coefficients.iter().rev() {
            plain = plain * z + a;
            turned = turned * z + a.conj();
        }
        self.value(plain, turned)
    }

    /// The signal on the grid of the phases.
    pub(super) fn on_band(&self, phases: &PhaseTable) -> Vec<f64> {
        let coefficients = &self.predictor.coefficients;
        // The polynomials of the real and of the imaginary parts of A, as (real, imaginary).
        let (rc, rs) = phases.sums(coefficients.iter().map(|a| a.re));
        let (ic, is) = phases.sums(coefficients.iter().map(|a| a.im));
        (0..rc.len())
            .map(|k| {
                let plain = Complex::new(rc[k] - is[k], rs[k] + ic[k]);
                let turned = Complex::new(rc[k] + is[k], rs[k] - ic[k]);
                self.value(plain, turned)
            })
            .collect()
    }

    /// From A and the polynomial of its conjugate coefficients at one place. The real part is
    /// known beforehand, which keeps the angle inside its bounds whatever the rounding.
    fn value(&self, plain: Complex<f64>, turned: Complex<f64>) -> f64 {
        let imaginary = (self.first * turned * plain.conj()).im;
        let angle = imaginary.atan2(self.predictor.error.max(0.0));
        (0.5 + angle / PI).clamp(0.0, 1.0)
    }
}

/// `F_0, F_1, ...`, as many as there are moments.
fn exponential_series(moments: &[f64]) -> Vec<Complex<f64>> {
    let mean = moments[0].clamp(0.0, 1.0);
    // sin(pi c_0), by the nearer bound so that it is zero at 1 too and never negative.
    let real = (PI * mean.min(1.0 - mean)).sin();
    let mut series = vec![Complex::new(real, -(PI * mean).cos())];
    for k in 1..moments.len() {
        let sum: Complex<f64> = (1..=k)
            .map(|j| series[k - j] * (j as f64 * moments[j]))
            .sum();
        series.push(sum * Complex::new(0.0, 2.0 * PI / k as f64));
    }
    series
}
