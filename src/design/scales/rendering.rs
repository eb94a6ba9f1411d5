//! Colour rendering from sums: Ra of CIE 13.3-1995, not rounded, negative values as they are.
//!
//! The formulas are those of the program's figure; here the reference is prepared once and a light
//! is 27 sums.

use super::{colours, weighed};
use crate::color::{
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
    expected: Vec<[f64; 3]>,
}

impl RenderingScale {
    pub(super) fn new(kelvin: f64, rows: &[f64]) -> Option<Self> {
        let sums = weighed(rows, &rendering_reference(kelvin).on_nm());
        let (samples, white_xyz) = colours(&sums)?;
        let white = uv_1960_from_xyz(white_xyz)?;
        let expected = samples.map(|xyz| Some(uvw(uv_1960_from_xyz(xyz)?, xyz.y, white)));
        Some(Self {
            white,
            expected: expected.collect::<Option<_>>()?,
        })
    }

    /// `[U*, V*, W*]` of each sample less those under the reference.
    pub(super) fn differences(&self, sums: &[f64]) -> Option<Vec<[f64; 3]>> {
        let (samples, white) = colours(sums)?;
        let shift = Shift::new(uv_1960_from_xyz(white)?, self.white);
        let one = |(xyz, expected): (crate::color::Xyz, &[f64; 3])| {
            let found = uvw(shift.of(uv_1960_from_xyz(xyz)?), xyz.y, self.white);
            Some(std::array::from_fn(|k| found[k] - expected[k]))
        };
        let both = samples.zip(&self.expected);
        both.map(one).collect()
    }
}
