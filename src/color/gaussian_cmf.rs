//! The paper's Gaussian fit of the colour-matching functions, and what it proves.
//!
//! Source: Sun, Fracchia, Drew, "A Composite Spectral Model and Its Applications", Eq. 8-12 and
//! Table 2. It shows *why* a short series carries colour: the Fourier coefficients of a Gaussian
//! fall like `exp(-c n^2)`. It is never used to compute colour (z-bar is off by up to 0.2).
//!
//! Two misprints are corrected. Eq. 10 has `L` outside the root:
//!
//! ```text
//! A_n = sqrt(pi) h w / (sqrt(ln 2) L) cos(2 pi n (c - min)/L) exp(-pi^2 n^2 w^2 / (4 ln2 L^2))
//! ```
//!
//! and Eq. 12, with the `a0/2` convention of Eq. 4 in Parseval's sum, bounds a term's share of
//! the first one by `2/n exp(...)`, not `4/n exp(...)`.

use std::f64::consts::{LN_2, PI};

use crate::spectrum::{Band, gaussian};

/// `height * exp(-4 ln2 (nm - centre)^2 / width^2)`; the width is taken at half height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Gaussian {
    /// Place of the maximum, nm.
    pub centre_nm: f64,
    /// Full width at half height, nm.
    pub width_nm: f64,
    /// Value at the centre.
    pub height: f64,
}

/// Small (blue) lobe of x-bar, Table 2.
pub(crate) const X_SMALL: Gaussian = Gaussian::new(445.0, 45.0, 0.38);
/// Large (red) lobe of x-bar, Table 2.
pub(crate) const X_LARGE: Gaussian = Gaussian::new(595.0, 80.0, 1.06);
/// y-bar, Table 2.
pub(crate) const Y: Gaussian = Gaussian::new(560.0, 100.0, 1.0);
/// z-bar, Table 2.
pub(crate) const Z: Gaussian = Gaussian::new(451.0, 55.0, 1.8);

/// The Gaussians whose sums stand for x-bar, y-bar and z-bar (Eq. 9).
pub(crate) const FIT: [&[Gaussian]; 3] = [&[X_SMALL, X_LARGE], &[Y], &[Z]];

/// The share below which the paper neglects a term.
pub(crate) const NEGLIGIBLE_SHARE: f64 = 0.05;

/// x-bar, y-bar and z-bar of the fit at a wavelength (Eq. 9).
pub(crate) fn fitted_at(at_nm: f64) -> [f64; 3] {
    FIT.map(|lobes| lobes.iter().map(|lobe| lobe.at(at_nm)).sum())
}

/// Fourier coefficients `[A_n, B_n]` of the fitted x-bar, y-bar and z-bar (Eq. 10).
pub(crate) fn fitted_fourier(order: usize, band: Band) -> [[f64; 2]; 3] {
    FIT.map(|lobes| {
        lobes.iter().fold([0.0, 0.0], |[a, b], lobe| {
            let [da, db] = lobe.fourier(order, band);
            [a + da, b + db]
        })
    })
}

impl Gaussian {
    /// From centre (nm), width at half height (nm) and height.
    pub(crate) const fn new(centre_nm: f64, width_nm: f64, height: f64) -> Self {
        Self {
            centre_nm,
            width_nm,
            height,
        }
    }

    /// Value at a wavelength (Eq. 8).
    pub(crate) fn at(self, at_nm: f64) -> f64 {
        self.height * gaussian((at_nm - self.centre_nm) / self.width_nm)
    }

    /// `[A_n, B_n]` over a band in closed form (Eq. 10 with `L` outside the root); the tails
    /// outside the band are counted in.
    pub(crate) fn fourier(self, order: usize, band: Band) -> [f64; 2] {
        let length_nm = band.length_nm();
        let size = PI.sqrt() * self.height * self.width_nm / (LN_2.sqrt() * length_nm)
            * self.decay(order, length_nm);
        let phase = 2.0 * PI * order as f64 * (self.centre_nm - band.min_nm()) / length_nm;
        let (sin, cos) = phase.sin_cos();
        [size * cos, size * sin]
    }

    /// The largest share that term `order` can have of the first, when the light's coefficients
    /// fall like `1/n`: `2/n exp(...)`, the corrected Eq. 12. `order` counts from 1.
    pub(crate) fn bound(self, order: usize, length_nm: f64) -> f64 {
        2.0 / order as f64 * self.decay(order, length_nm)
    }

    /// Eq. 12 as printed, `4/n exp(...)`: twice [`Gaussian::bound`], kept for comparison.
    pub(crate) fn bound_as_printed(self, order: usize, length_nm: f64) -> f64 {
        4.0 / order as f64 * self.decay(order, length_nm)
    }

    /// The first order whose [`Gaussian::bound`] falls below [`NEGLIGIBLE_SHARE`].
    pub(crate) fn first_negligible_order(self, length_nm: f64) -> usize {
        first_below(|order| self.bound(order, length_nm))
    }

    /// The same of [`Gaussian::bound_as_printed`].
    pub(crate) fn first_negligible_as_printed(self, length_nm: f64) -> usize {
        first_below(|order| self.bound_as_printed(order, length_nm))
    }

    /// `exp(-pi^2 n^2 w^2 / (4 ln2 L^2))`.
    fn decay(self, order: usize, length_nm: f64) -> f64 {
        let x = PI * order as f64 * self.width_nm / length_nm;
        (-x * x / (4.0 * LN_2)).exp()
    }
}

/// The first order whose bound, at most `4/n`, is below [`NEGLIGIBLE_SHARE`].
fn first_below(bound: impl Fn(usize) -> f64) -> usize {
    let surely = (4.0 / NEGLIGIBLE_SHARE) as usize + 1;
    let mut orders = 1..surely;
    orders
        .find(|n| bound(*n) < NEGLIGIBLE_SHARE)
        .unwrap_or(surely)
}

#[cfg(test)]
mod tests {
    use super::*;

    const LOBES: [Gaussian; 4] = [Y, X_LARGE, Z, X_SMALL];

    #[test]
    fn half_height_is_reached_half_a_width_away() {
        for lobe in LOBES {
            let half = lobe.at(lobe.centre_nm + 0.5 * lobe.width_nm);
            // One exponential of a number near 0.7.
            assert!((half / lobe.height - 0.5).abs() < 1e-15);
        }
    }

    #[test]
    fn the_closed_form_is_the_integral_over_all_wavelengths() {
        for band in [Band::PAPER, Band::VISIBLE] {
            for lobe in LOBES {
                for order in 0..=10 {
                    let [a, b] = lobe.fourier(order, band);
                    let (mut cos_sum, mut sin_sum) = (0.0, 0.0);
                    for nm in 0..1200 {
                        let nm = f64::from(nm);
                        let phase =
                            2.0 * PI * order as f64 * (nm - band.min_nm()) / band.length_nm();
                        cos_sum += lobe.at(nm) * phase.cos();
                        sin_sum += lobe.at(nm) * phase.sin();
                    }
                    let scale = 2.0 / band.length_nm();
                    // A 1 nm sum of a smooth, wholly covered bell is exact but for rounding.
                    assert!((a - scale * cos_sum).abs() < 1e-13);
                    assert!((b - scale * sin_sum).abs() < 1e-13);
                }
            }
        }
    }

    #[test]
    fn terms_beyond_these_orders_are_negligible() {
        let orders = |length_nm| LOBES.map(|lobe| lobe.first_negligible_order(length_nm));
        assert_eq!(orders(300.0), [3, 4, 5, 6]);
        assert_eq!(orders(400.0), [4, 5, 6, 7]);
    }

    #[test]
    fn the_printed_bound_would_ask_for_one_more_order_on_the_wide_range() {
        let printed = |length_nm| LOBES.map(|lobe| lobe.first_negligible_as_printed(length_nm));
        // On 300 nm both forms agree; on 400 nm the narrow lobes tell them apart.
        assert_eq!(printed(300.0), [3, 4, 5, 6]);
        assert_eq!(printed(400.0), [4, 5, 7, 8]);
    }

    #[test]
    fn the_printed_root_would_not_give_the_area_of_the_bell() {
        // A_0 = 2/L times the area; the area of a bell is h w sqrt(pi / (4 ln 2)).
        let area = Y.height * Y.width_nm * (PI / (4.0 * LN_2)).sqrt();
        let [a0, _] = Y.fourier(0, Band::PAPER);
        // The same product in another order.
        assert!((a0 - 2.0 / 300.0 * area).abs() < 1e-15);
        let with_l_under_the_root = PI.sqrt() * Y.height * Y.width_nm / (LN_2 * 300.0).sqrt();
        assert!(with_l_under_the_root > 10.0 * a0);
    }

    #[test]
    fn the_fit_resembles_the_functions_but_cannot_replace_them() {
        let table = super::super::observer::Observer::CIE_1931.table();
        let mut worst = [0.0_f64; 3];
        for nm in Band::VISIBLE.grid() {
            let (real, fitted) = (table.at(nm), fitted_at(nm));
            for k in 0..3 {
                worst[k] = worst[k].max((real[k] - fitted[k]).abs());
            }
        }
        // The fit of Table 2 misses z-bar by up to 0.2 of its 1.78.
        assert!(worst.iter().all(|w| (0.02..0.25).contains(w)), "{worst:?}");
    }
}
