//! Is this light that one off this surface? The paper's verification equation S3 = S1 S2.
//!
//! Everything is as the model has it: the light S1 and what comes from the surface S3 as
//! composites, the reflectance S2 as a series of as many numbers. The product is formed on twice
//! the numbers, where it is exact, and cut to the numbers of S3, which could hold no more. Both
//! are compared behind a 10 nm blur, so that a line and its spike are the same light, up to a
//! factor: how much of the light goes which way is geometry and says nothing about the surface.

use crate::{
    spectrum::{Band, BasisTable, Composite, Sampling, Series, product::resampled},
    study::error::{BLUR_NM, Blur, height, spikes_times, times},
};

/// Largest residual that still counts as the same light.
///
/// Measured on the shipped lights of all kinds and the 99 colour evaluation samples; the figures
/// stand in `tests/products_chain.rs`.
pub const SAME_RESIDUAL: f64 = 0.03;

/// How well a spectrum is explained as a light off a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reflection {
    /// Relative RMS behind a 10 nm blur of what the best factor leaves.
    pub residual: f64,
    /// That factor.
    pub factor: f64,
}

impl Reflection {
    /// The verdict: the residual is at most [`SAME_RESIDUAL`], and no light has turned negative.
    pub fn holds(self) -> bool {
        self.residual <= SAME_RESIDUAL && self.factor > 0.0
    }
}

/// Tests `outgoing = light x reflectance` (reflectance on the band's grid).
///
/// Both composites share band and basis. `None` when one of them is dark.
///
/// # Panics
/// When `reflectance` does not have [`Band::points`] values.
pub fn reflection_check(
    light: &Composite,
    reflectance: &[f64],
    outgoing: &Composite,
) -> Option<Reflection> {
    let band: Band = light.band();
    let numbers = light.smooth.coefficients.len();
    let table = BasisTable::new(band, light.smooth.basis, numbers);
    let surface = Series {
        coefficients: table.project(reflectance, numbers),
        ..light.smooth.clone()
    };
    let product = resampled(light, &surface, Sampling::Double);
    let product = Composite {
        smooth: product.smooth.truncated(outgoing.smooth.coefficients.len()),
        ..product
    };
    let blur = Blur::new(band, BLUR_NM);
    let (expected, expected_unit) = blurred(&blur, &product)?;
    let (found, found_unit) = blurred(&blur, outgoing)?;
    let (own, whole) = (band.inner(&expected, &expected), band.inner(&found, &found));
    let scale = band.inner(&expected, &found) / own;
    let rest: Vec<f64> = found
        .iter()
        .zip(&expected)
        .map(|(f, e)| f - scale * e)
        .collect();
    let reflection = Reflection {
        residual: (band.inner(&rest, &rest) / whole).sqrt(),
        // Both were brought to 1 at their highest.
        factor: scale * expected_unit / found_unit,
    };
    (reflection.residual.is_finite() && reflection.factor.is_finite()).then_some(reflection)
}

/// A composite behind a blur, on the grid, as shares of its largest value, and what it was
/// multiplied by for that; `None` in the dark.
fn blurred(blur: &Blur, composite: &Composite) -> Option<(Vec<f64>, f64)> {
    let unit = height(&composite.on_band())?;
    let mut values = blur.values(&times(&composite.smooth.on_band(), unit));
    blur.add_spikes(&spikes_times(&composite.spikes, unit), &mut values);
    Some((values, unit))
}
