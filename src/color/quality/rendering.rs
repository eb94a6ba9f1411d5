//! Colour rendering index: Ra and R1 to R15.
//!
//! Source: CIE 13.3-1995. Fourteen test colours and R15 of JIS Z 8726, a skin, under the light and
//! under a reference of the same CCT, in CIE 1964 U*V*W* with the von Kries shift of the standard;
//! Ri = 100 - 4.6 dE, Ra the mean of the first eight. The CCT is not rounded, nor is any Ri before
//! the mean. Sums are over 1 nm, 360-830; the test colours, given every 5 nm, are interpolated by
//! Sprague's formula. With straight lines between them a lamp of a few lines would differ: Ra of
//! low-pressure sodium by 0.17, R9 of three narrow LEDs by 0.7.

use std::sync::LazyLock;

use crate::{
    color::{Cct, Observer, Xyz, uv_1960_from_xyz},
    spectrum::{Outside, Sampled},
};

use super::{
    light::{FIRST_NM, LAST_NM, Light},
    no_figure::NoFigure,
    reference::{Reference, rendering_reference},
    sprague::sprague,
    test_colours::TestColours,
    weight::shipped,
};

/// Number of test colours.
pub(crate) const RENDERING_SAMPLES: usize = 15;

/// Appearance of the test colours in daylight; the last is the skin complexion of JIS Z 8726.
pub(crate) const RENDERING_NAMES: [&str; RENDERING_SAMPLES] = [
    later!("light greyish red"),
    later!("dark greyish yellow"),
    later!("strong yellow green"),
    later!("moderate yellowish green"),
    later!("light bluish green"),
    later!("light blue"),
    later!("light violet"),
    later!("light reddish purple"),
    later!("strong red"),
    later!("strong yellow"),
    later!("strong green"),
    later!("strong blue"),
    later!("light skin"),
    later!("leaf green"),
    later!("medium skin"),
];

/// Step of the tables of test colours, nm.
const TABLE_STEP_NM: usize = 5;

/// Test colours that Ra is the mean of.
pub(crate) const GENERAL: usize = 8;

/// Distance of the light from its reference in CIE 1960 uv up to which CIE 13.3 allows its index.
const FARTHEST_FROM_REFERENCE: f64 = 5.4e-3;

/// A test colour under the light and under its reference; Y = 100 for either light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RenderedSample {
    /// Its index Ri.
    pub index: f64,
    /// Under the light.
    pub test: Xyz,
    /// Under the reference.
    pub reference: Xyz,
}

/// The colour rendering of a light.
#[derive(Clone, Debug, PartialEq)]
pub struct Rendering {
    /// The general index Ra.
    pub ra: f64,
    /// R1 to R15 with the colours behind them (CIE 1931).
    pub samples: [RenderedSample; RENDERING_SAMPLES],
    /// The reference it was compared with.
    pub reference: Reference,
    /// The light itself, Y = 100.
    pub test_white: Xyz,
    /// The reference itself, Y = 100.
    pub reference_white: Xyz,
    /// Distance of light and reference in CIE 1960 uv.
    pub distance: f64,
}

impl Rendering {
    /// R1 to R15.
    pub(crate) fn indices(&self) -> [f64; RENDERING_SAMPLES] {
        self.samples.map(|sample| sample.index)
    }

    /// True if the light is too far from its reference for CIE 13.3 to vouch for the index.
    pub(crate) fn is_too_far(&self) -> bool {
        self.distance > FARTHEST_FROM_REFERENCE
    }
}

/// Index lost for each unit of difference in U*V*W*.
const RENDERING_PER_UNIT: f64 = 4.6;

/// The index of a difference in U*V*W*.
pub(crate) fn rendering_index(difference: f64) -> f64 {
    100.0 - RENDERING_PER_UNIT * difference
}

/// The difference in U*V*W* of an index.
pub(crate) fn rendering_difference(index: f64) -> f64 {
    (100.0 - index) / RENDERING_PER_UNIT
}

/// The colour rendering of a light of this CCT.
///
/// # Errors
/// [`NoFigure`] when there is no light, or a test colour leaves the formula's range.
pub fn rendering(light: &Light, cct: Cct) -> Result<Rendering, NoFigure> {
    let light = light.lit()?;
    let reference = rendering_reference(cct.kelvin);
    let (tests, test_white) = TEST_COLOURS.under(light)?;
    let (references, reference_white) =
        TEST_COLOURS.under(&Light::of_nm_values(&reference.on_nm()))?;
    let out = || NoFigure::OutOfRange {
        what: later!("a test colour has no chromaticity under this light"),
    };
    let scale = RenderingScale::new(references.iter().copied(), reference_white);
    let scale = scale.ok_or_else(out)?;
    let differences = scale.differences(tests.iter().copied(), test_white);
    let differences = differences.ok_or_else(out)?;
    let samples: [RenderedSample; RENDERING_SAMPLES] = std::array::from_fn(|i| RenderedSample {
        index: rendering_index(differences[i].iter().map(|d| d * d).sum::<f64>().sqrt()),
        test: tests[i],
        reference: references[i],
    });
    if samples.iter().any(|sample| !sample.index.is_finite()) {
        return Err(out());
    }
    let general = samples[..GENERAL].iter().map(|s| s.index).sum::<f64>();
    let [u, v] = uv_1960_from_xyz(test_white).ok_or_else(out)?;
    Ok(Rendering {
        ra: general / GENERAL as f64,
        samples,
        reference,
        test_white,
        reference_white,
        distance: (u - scale.white[0]).hypot(v - scale.white[1]),
    })
}

/// Test colours under a reference, which the same under a light are compared with; all colours with
/// Y = 100 for their light.
#[derive(Clone, Debug)]
pub(crate) struct RenderingScale {
    /// CIE 1960 uv of the reference.
    white: [f64; 2],
    /// U*V*W* of the test colours.
    expected: Vec<[f64; 3]>,
}

impl RenderingScale {
    /// `None` where a colour has no chromaticity.
    pub(crate) fn new(references: impl Iterator<Item = Xyz>, white: Xyz) -> Option<Self> {
        let white = uv_1960_from_xyz(white)?;
        let expected = references.map(|xyz| Some(uvw(uv_1960_from_xyz(xyz)?, xyz.y, white)));
        Some(Self {
            white,
            expected: expected.collect::<Option<_>>()?,
        })
    }

    /// `[U*, V*, W*]` of each test colour under a light less those under the reference; `None` where
    /// one has no chromaticity.
    pub(crate) fn differences(
        &self,
        tests: impl Iterator<Item = Xyz>,
        white: Xyz,
    ) -> Option<Vec<[f64; 3]>> {
        let shift = Shift::new(uv_1960_from_xyz(white)?, self.white);
        let one = |(xyz, expected): (Xyz, &[f64; 3])| {
            let found = uvw(shift.of(uv_1960_from_xyz(xyz)?), xyz.y, self.white);
            Some(std::array::from_fn(|k| found[k] - expected[k]))
        };
        tests.zip(&self.expected).map(one).collect()
    }
}

/// The von Kries shift of CIE 13.3 from a light's chromaticity to its reference's.
struct Shift {
    c: f64,
    d: f64,
}

impl Shift {
    fn new(from: [f64; 2], to: [f64; 2]) -> Self {
        let ([from_c, from_d], [to_c, to_d]) = (cd(from), cd(to));
        Self {
            c: to_c / from_c,
            d: to_d / from_d,
        }
    }

    fn of(&self, uv: [f64; 2]) -> [f64; 2] {
        let [c, d] = cd(uv);
        let (c, d) = (self.c * c, self.d * d);
        let below = 16.518 + 1.481 * c - d;
        [(10.872 + 0.404 * c - 4.0 * d) / below, 5.520 / below]
    }
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

/// Radiance factors of the test colours on whole nm 360-830.
pub(crate) fn rendering_factors() -> &'static [Vec<f64>] {
    &TEST_COLOURS.rows
}

/// Radiance factors on whole nm 360-830, end values held.
static TEST_COLOURS: LazyLock<TestColours> = LazyLock::new(|| {
    let table = |name: &str| {
        let table = shipped("cri_tcs", name);
        let fine = sprague(table.values(), TABLE_STEP_NM);
        let fine = Sampled::even(table.first_nm(), 1.0, fine).expect("finite values");
        fine.on_whole_nm(FIRST_NM, LAST_NM, Outside::Hold)
    };
    // The set of 2024 has the skin of R15, which the publication of 1995 has not.
    let classic = (1..=14).map(|i| table(&format!("TCS{i:02}")));
    TestColours {
        first_nm: FIRST_NM,
        rows: classic.chain([table("CIE 2024: TCS15")]).collect(),
        observer: Observer::CIE_1931,
        luminous_sum: later!("sum with V(λ)"),
    }
});

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_difference_of_an_index_has_that_index() {
        for index in [-40.0, 0.0, 80.0, 100.0] {
            // Rounding of a product and a sum of numbers around 100.
            assert!((rendering_index(rendering_difference(index)) - index).abs() < 1e-13);
        }
    }

    #[test]
    fn a_reference_renders_as_itself() {
        for kelvin in [2000.0, 4999.0, 5000.0, 6504.0, 20_000.0] {
            let light = Light::of_nm_values(&rendering_reference(kelvin).on_nm());
            let found = rendering(&light, Cct { kelvin, duv: 0.0 }).unwrap();
            // Both sides are the same numbers up to the light's scaling.
            assert!((found.ra - 100.0).abs() < 1e-9, "{kelvin}: {}", found.ra);
            assert!(found.indices().iter().all(|r| (r - 100.0).abs() < 1e-9));
            assert!(!found.is_too_far());
        }
    }

    #[test]
    fn the_shift_takes_the_light_to_its_reference() {
        let (from, to) = ([0.25, 0.35], [0.21, 0.32]);
        let moved = Shift::new(from, to).of(from);
        // The standard's coefficients have four digits.
        assert!((moved[0] - to[0]).abs() < 1e-4 && (moved[1] - to[1]).abs() < 1e-4);
    }
}
