//! Trigonometric moments, read by maximum entropy: Peters, Merzbach, Hanika, Dachsbacher 2019,
//! "Using Moments to Represent Bounded Signals for Spectral Rendering", with their mirrored warp.
//!
//! The band is laid on half a circle, `phi = pi (l - min)/L`, and mirrored onto the other half, so
//! that the signal g is even and periodic without a jump and its moments are real:
//!
//! ```text
//! c_j = 1/(2 pi) int_{-pi}^{pi} g(phi) e^{-i j phi} dphi = 1/pi int_0^pi g(phi) cos(j phi) dphi
//!     = 1/L int g(l) cos(pi j (l - min)/L) dl
//! ```
//!
//! on the 1 nm trapezoid grid, whose positive weights make them the moments of a positive signal
//! (a reflectance's values count as cells of one nm, which keeps them those of a bounded one);
//! `c_0` is the mean. A light is read as Burg's density `s / |A(e^{i phi})|^2`, positive
//! everywhere; a reflectance by the bounded estimate ([`super::bounded_moments`]), inside \[0, 1\].
//! Either has exactly the stored moments. Both are nonlinear in the numbers.

use std::sync::Arc;

use super::{
    Bounds, Representation,
    bounded_moments::BoundedReading,
    levinson::{Predictor, predictor},
    midpoints_nm,
    phases::PhaseTable,
};
use crate::spectrum::Band;

/// The moments of a spectrum, and what is worked out from them once to read them.
#[derive(Clone, Debug)]
pub(crate) struct Moments {
    phases: Arc<PhaseTable>,
    /// The mean first, in the spectrum's own unit. These are the stored numbers.
    moments: Vec<f64>,
    reading: Reading,
}

#[derive(Clone, Debug)]
enum Reading {
    Light(Predictor<f64>),
    Reflectance(BoundedReading),
}

impl Moments {
    /// The first `numbers` moments, or as many as the table has. What lies outside the bounds
    /// (negative samples, reflectances above 1) is clipped.
    pub(super) fn fit(
        phases: &Arc<PhaseTable>,
        values: &[f64],
        numbers: usize,
        bounds: Bounds,
    ) -> Self {
        let highest = match bounds {
            Bounds::Light => f64::INFINITY,
            Bounds::Reflectance => 1.0,
        };
        let clipped: Vec<f64> = values.iter().map(|v| v.clamp(0.0, highest)).collect();
        Self::of_moments(phases, phases.moments(&clipped, numbers, bounds), bounds)
    }

    fn of_moments(phases: &Arc<PhaseTable>, moments: Vec<f64>, bounds: Bounds) -> Self {
        let reading = match bounds {
            Bounds::Light => Reading::Light(predictor(&moments)),
            Bounds::Reflectance => Reading::Reflectance(BoundedReading::of(&moments)),
        };
        Self {
            phases: Arc::clone(phases),
            moments,
            reading,
        }
    }

    /// The reconstruction at a phase, 0 to pi.
    fn at_phase(&self, phi: f64) -> f64 {
        match &self.reading {
            Reading::Light(predictor) => {
                let (mut re, mut im) = (0.0, 0.0);
                let (sin, cos) = phi.sin_cos();
                for a in predictor.coefficients.iter().rev() {
                    (re, im) = (re * cos - im * sin + a, re * sin + im * cos);
                }
                density(predictor.error, re, im)
            }
            Reading::Reflectance(reading) => reading.at_phase(phi),
        }
    }
}

/// `s / |A|^2`.
fn density(error: f64, re: f64, im: f64) -> f64 {
    error / (re * re + im * im).max(f64::MIN_POSITIVE)
}

/// Burg's density on the grid of the phases.
fn light_on_band(phases: &PhaseTable, predictor: &Predictor<f64>) -> Vec<f64> {
    let (re, im) = phases.sums(predictor.coefficients.iter().copied());
    let parts = re.iter().zip(&im);
    parts
        .map(|(re, im)| density(predictor.error, *re, *im))
        .collect()
}

impl Representation for Moments {
    fn band(&self) -> Band {
        self.phases.band
    }

    fn stored(&self) -> Vec<f64> {
        self.moments.clone()
    }

    /// Only of a light: a reflectance is bounded by 1 and has no scale.
    fn scale(&mut self, factor: f64) {
        if let Reading::Light(predictor) = &mut self.reading {
            predictor.error *= factor;
            self.moments.iter_mut().for_each(|c| *c *= factor);
        }
    }

    fn inside(&self, at_nm: f64) -> f64 {
        self.at_phase(self.phases.phase(at_nm))
    }

    fn on_band(&self) -> Vec<f64> {
        match &self.reading {
            Reading::Light(predictor) => light_on_band(&self.phases, predictor),
            Reading::Reflectance(reading) => reading.on_band(&self.phases),
        }
    }

    fn places_nm(&self) -> Vec<f64> {
        midpoints_nm(self.phases.band, 2 * self.moments.len())
    }

    fn points(&self) -> Vec<f64> {
        let places = self.places_nm();
        places.iter().map(|nm| self.inside(*nm)).collect()
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::rivals::phases::DRAWN_TO_MEAN;
    use crate::rivals::{
        Samples,
        example_spectra::{fluorescent, leaf, thermal},
    };

    const BAND: Band = Band::VISIBLE;

    fn table() -> Arc<PhaseTable> {
        Arc::new(PhaseTable::new(BAND, 60))
    }

    fn fit(values: &[f64], numbers: usize, bounds: Bounds) -> Moments {
        Moments::fit(&table(), values, numbers, bounds)
    }

    /// Midpoints of the fine integrals: for a smooth periodic function they converge
    /// geometrically, and here to rounding.
    const FINE: usize = 1 << 14;

    fn fine_phases() -> impl Iterator<Item = f64> {
        (0..FINE).map(|i| PI * (i as f64 + 0.5) / FINE as f64)
    }

    /// The moments of the reconstruction, finely integrated.
    fn moments_of(fitted: &Moments) -> Vec<f64> {
        let values: Vec<f64> = fine_phases().map(|phi| fitted.at_phase(phi)).collect();
        (0..fitted.moments.len())
            .map(|j| {
                let products = fine_phases()
                    .zip(&values)
                    .map(|(phi, v)| v * (j as f64 * phi).cos());
                products.sum::<f64>() / FINE as f64
            })
            .collect()
    }

    /// Box of ones: a reflectance on the border of what is bounded.
    fn edge_filter() -> Vec<f64> {
        BAND.grid()
            .map(|nm| f64::from(u8::from((500.0..600.0).contains(&nm))))
            .collect()
    }

    #[test]
    fn the_reconstruction_has_the_stored_moments() {
        // Rounding times the condition of the Toeplitz system, at most about 1e6; but an edge
        // falls anywhere between two of the fine phases, and this filter has two.
        let cases = [
            (thermal(BAND, 5000.0), Bounds::Light, 1e-9),
            (fluorescent(BAND), Bounds::Light, 1e-9),
            (leaf(BAND), Bounds::Reflectance, 1e-9),
            (edge_filter(), Bounds::Reflectance, 2.0 / FINE as f64),
        ];
        for (values, bounds, tolerance) in cases {
            for numbers in [1, 2, 5, 20, 31, 60] {
                let fitted = fit(&values, numbers, bounds);
                for (a, b) in moments_of(&fitted).iter().zip(&fitted.moments) {
                    assert!((a - b).abs() < tolerance, "{bounds:?} {numbers} {a} {b}");
                }
            }
        }
    }

    #[test]
    fn a_light_stays_positive_and_keeps_its_energy() {
        let values = fluorescent(BAND);
        for numbers in [1, 11, 20, 31, 60] {
            let fitted = fit(&values, numbers, Bounds::Light);
            assert!(fine_phases().all(|phi| fitted.at_phase(phi) > 0.0));
            let mean = BAND.integral(&values) / BAND.length_nm();
            // A sum of 401 terms in another order.
            assert!((fitted.moments[0] - mean).abs() < 1e-13 * mean);
        }
    }

    #[test]
    fn a_reflectance_stays_between_0_and_1() {
        for values in [leaf(BAND), edge_filter()] {
            for numbers in [1, 2, 11, 20, 31, 60] {
                let fitted = fit(&values, numbers, Bounds::Reflectance);
                assert!(fine_phases().all(|phi| (0.0..=1.0).contains(&fitted.at_phase(phi))));
            }
        }
    }

    #[test]
    fn a_constant_is_reconstructed_exactly() {
        for level in [0.0, 1e-9, 0.3, 0.5, 1.0 - 1e-9, 1.0] {
            for bounds in [Bounds::Light, Bounds::Reflectance] {
                for v in fit(&[level; 401], 20, bounds).on_band() {
                    // Twenty sums of 401 cosines, each zero to 1e-17.
                    assert!((v - level).abs() < 1e-14, "{level} {v}");
                }
            }
        }
    }

    #[test]
    fn values_outside_the_bounds_are_clipped() {
        let wild: Vec<f64> = leaf(BAND).iter().map(|v| 3.0 * v - 1.0).collect();
        let tame: Vec<f64> = wild.iter().map(|v| v.clamp(0.0, 1.0)).collect();
        for bounds in [Bounds::Light, Bounds::Reflectance] {
            let positive: Vec<f64> = wild.iter().map(|v| v.max(0.0)).collect();
            let clipped = if bounds == Bounds::Light {
                &positive
            } else {
                &tame
            };
            assert_eq!(
                fit(&wild, 11, bounds).stored(),
                fit(clipped, 11, bounds).stored()
            );
        }
    }

    #[test]
    fn moments_are_the_cosine_means_of_the_spectrum() {
        // 1 + cos(3 phi)/2 has c_0 = 1 and c_3 = 1/4, and no other.
        let values: Vec<f64> = (0..401)
            .map(|i| 1.0 + 0.5 * (3.0 * PI * f64::from(i) / 400.0).cos())
            .collect();
        for (j, c) in fit(&values, 6, Bounds::Light).moments.iter().enumerate() {
            let wanted = [1.0, 0.0, 0.0, 0.25 * (1.0 - DRAWN_TO_MEAN), 0.0, 0.0][j];
            // A sum of 401 terms.
            assert!((c - wanted).abs() < 1e-14);
        }
    }

    #[test]
    fn a_filter_with_edges_is_read_as_a_filter_with_edges() {
        let values = edge_filter();
        let read = fit(&values, 11, Bounds::Reflectance).on_band();
        for ((nm, a), b) in BAND.grid().zip(&read).zip(&values) {
            let from_edge_nm = (nm - 499.5).abs().min((nm - 599.5).abs());
            // Two edges take few moments; what was drawn to the mean is felt within 2 nm of them.
            assert!(from_edge_nm < 2.0 || (a - b).abs() < 1e-3, "{nm} {a} {b}");
        }
    }

    #[test]
    fn a_dark_and_a_light_reflectance_are_mirror_images() {
        let (dark, bright): (Vec<f64>, Vec<f64>) = leaf(BAND).iter().map(|v| (*v, 1.0 - v)).unzip();
        let dark = fit(&dark, 20, Bounds::Reflectance).on_band();
        let bright = fit(&bright, 20, Bounds::Reflectance).on_band();
        for (d, b) in dark.iter().zip(bright) {
            // Rounding times the condition of the system.
            assert!((d + b - 1.0).abs() < 1e-9);
        }
    }

    #[test]
    fn a_faint_reflectance_is_read_like_a_light() {
        // Near zero the upper bound is far away and both estimates are the same.
        let faint: Vec<f64> = thermal(BAND, 5000.0).iter().map(|v| 1e-7 * v).collect();
        let bounded = fit(&faint, 11, Bounds::Reflectance).on_band();
        let light = fit(&faint, 11, Bounds::Light).on_band();
        for (a, b) in bounded.iter().zip(light) {
            // They part where one counts cells and the other points, 3e-4 of the tenth moment.
            assert!((a / b - 1.0).abs() < 1e-4, "{a} {b}");
        }
    }

    #[test]
    fn a_blackbody_in_20_moments_weighs_far_better_than_in_20_samples() {
        // Pointwise the two are alike; what moments do better is every smooth weight, as in
        // colour: their errors swing around zero where straight lines stay on one side.
        let weights = [450.0, 555.0, 600.0].map(|centre_nm| {
            let bell = move |nm: f64| (-0.5 * ((nm - centre_nm) / 25.0).powi(2)).exp();
            BAND.grid().map(bell).collect::<Vec<f64>>()
        });
        let values = thermal(BAND, 5000.0);
        let worst = |read: Vec<f64>| {
            let shares = weights
                .iter()
                .map(|w| BAND.inner(&read, w) / BAND.inner(&values, w));
            shares.map(|s| (s - 1.0).abs()).fold(0.0, f64::max)
        };
        let moments = worst(fit(&values, 20, Bounds::Light).on_band());
        let samples = worst(Samples::fit(BAND, &values, 20).on_band());
        assert!(moments < 0.1 * samples, "{moments} {samples}");
    }
}
