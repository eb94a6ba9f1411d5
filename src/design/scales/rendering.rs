//! Colour rendering from sums: Ra of CIE 13.3-1995, not rounded, negative values as they are.
//!
//! The same formula as the program's figure; here the reference is prepared once and a light is
//! 27 sums.

use super::weighed;
use crate::{
    color::{Xyz, uv_1960_from_xyz},
    design::whole_nm,
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
        let sums = weighed(rows, &reference(kelvin)?);
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
        let [from_c, from_d] = cd(uv_1960_from_xyz(white)?);
        let [to_c, to_d] = cd(self.white);
        let (gain_c, gain_d) = (to_c / from_c, to_d / from_d);
        let mut total = 0.0;
        for (xyz, expected) in samples.into_iter().zip(&self.expected) {
            let [c, d] = cd(uv_1960_from_xyz(xyz)?);
            let (c, d) = (gain_c * c, gain_d * d);
            let below = 16.518 + 1.481 * c - d;
            let shifted = [(10.872 + 0.404 * c - 4.0 * d) / below, 5.520 / below];
            let found = uvw(shifted, xyz.y, self.white);
            let square: f64 = (0..3).map(|k| (found[k] - expected[k]).powi(2)).sum();
            total += 100.0 - 4.6 * square.sqrt();
        }
        let ra = total / SAMPLES as f64;
        ra.is_finite().then_some(ra)
    }
}

/// A blackbody below 5000 K, else daylight.
pub(super) fn reference(kelvin: f64) -> Option<Vec<f64>> {
    if kelvin < 5000.0 {
        whole_nm::planck(kelvin)
    } else {
        whole_nm::daylight(kelvin)
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

fn cd([u, v]: [f64; 2]) -> [f64; 2] {
    [
        (4.0 - u - 10.0 * v) / v,
        (1.708 * v + 0.404 - 1.481 * u) / v,
    ]
}

/// CIE 1964 U*V*W* against a white.
fn uvw([u, v]: [f64; 2], y: f64, white: [f64; 2]) -> [f64; 3] {
    let w = 25.0 * y.cbrt() - 17.0;
    [13.0 * w * (u - white[0]), 13.0 * w * (v - white[1]), w]
}
