//! Colour rendering from sums: Ra of CIE 13.3-1995, not rounded, negative values as they are.
//!
//! The formulas are those of the program's figure; here the reference is prepared once and a light
//! is 27 sums.

use super::weighed;
use crate::color::{
    Xyz,
    quality::{Shift, rendering_reference, uvw},
    uv_1960_from_xyz,
};

/// Test colours that Ra is the mean of.
pub(super) const SAMPLES: usize = 8;

/// Ra of lights whose reference is prepared.
#[derive(Clone, Debug)]
pub(super) struct RenderingScale {
    white: [f64; 2],
    /// U*V*W* of the test colours under the reference.
    expected: [[f64; 3]; SAMPLES],
}

impl RenderingScale {
    pub(super) fn new(kelvin: f64, rows: &[f64]) -> Option<Self> {
        let sums = weighed(rows, &rendering_reference(kelvin).on_nm());
        let (samples, white_xyz) = colours(&sums)?;
        let white = uv_1960_from_xyz(white_xyz)?;
        let mut expected = [[0.0; 3]; SAMPLES];
        for (expected, xyz) in expected.iter_mut().zip(samples) {
            *expected = uvw(uv_1960_from_xyz(xyz)?, xyz.y, white);
        }
        Some(Self { white, expected })
    }

    pub(super) fn ra(&self, sums: &[f64]) -> Option<f64> {
        let (samples, white) = colours(sums)?;
        let shift = Shift::new(uv_1960_from_xyz(white)?, self.white);
        let mut total = 0.0;
        for (xyz, expected) in samples.into_iter().zip(&self.expected) {
            let shifted = shift.of(uv_1960_from_xyz(xyz)?);
            let found = uvw(shifted, xyz.y, self.white);
            let square: f64 = (0..3).map(|k| (found[k] - expected[k]).powi(2)).sum();
            total += 100.0 - 4.6 * square.sqrt();
        }
        let ra = total / SAMPLES as f64;
        ra.is_finite().then_some(ra)
    }
}

/// The test colours and the light itself, Y = 100 for the light.
fn colours(sums: &[f64]) -> Option<([Xyz; SAMPLES], Xyz)> {
    let at = |i: usize| Xyz::new(sums[3 * i], sums[3 * i + 1], sums[3 * i + 2]);
    if sums.len() != 3 * (SAMPLES + 1) {
        return None;
    }
    let white = at(SAMPLES);
    let unit = 100.0 / white.y;
    (white.y > 0.0 && unit.is_finite())
        .then(|| (std::array::from_fn(|i| at(i) * unit), white * unit))
}
