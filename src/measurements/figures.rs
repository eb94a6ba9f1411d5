//! Figures of a light as functions of its 345 colour sums.
//!
//! X, Y, Z of the 2 and the 10 degree observer, and of 14 test colours of CRI and 99 of TM-30
//! under the light: all that the figures need, and linear in the light, so that its noise is known
//! in them exactly.

use std::sync::LazyLock;

use crate::color::{
    Observer, Xyz, cct_from_xyz,
    quality::{
        FidelityScale, RenderingScale, fidelity_factors, fidelity_reference, index_of,
        rendering_factors, rendering_index, rendering_reference,
    },
    xy_from_xyz,
    xyz::{FIRST_NM, POINTS},
};

/// Test colours of CRI that are summed.
const OF_RENDERING: usize = 14;

/// Test colours that Ra is the mean of.
const GENERAL: usize = 8;

/// R9 among the test colours.
const STRONG_RED: usize = 8;

/// Samples of TM-30.
const OF_FIDELITY: usize = 99;

/// Number of sums.
pub(super) const SUMS: usize = 6 + 3 * (OF_RENDERING + OF_FIDELITY);

/// A figure that doubt is told of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Figure {
    /// The sum with V.
    Y,
    /// Chromaticity.
    SmallX,
    /// Chromaticity.
    SmallY,
    /// Correlated colour temperature, K.
    Cct,
    /// Distance from the blackbodies in CIE 1960 uv.
    Duv,
    /// General colour rendering index.
    Ra,
    /// Index of the strong red.
    R9,
    /// Fidelity index.
    Rf,
}

/// Every figure, in the order told.
pub const FIGURES: [Figure; 8] = [
    Figure::Y,
    Figure::SmallX,
    Figure::SmallY,
    Figure::Cct,
    Figure::Duv,
    Figure::Ra,
    Figure::R9,
    Figure::Rf,
];

impl Figure {
    /// Its key in JSON.
    pub fn key(self) -> &'static str {
        match self {
            Self::Y => "Y",
            Self::SmallX => "x",
            Self::SmallY => "y",
            Self::Cct => "cct",
            Self::Duv => "duv",
            Self::Ra => "ra",
            Self::R9 => "r9",
            Self::Rf => "rf",
        }
    }

    /// Display name.
    pub fn words(self) -> &'static str {
        match self {
            Self::Y => "Y",
            Self::SmallX => "x",
            Self::SmallY => "y",
            Self::Cct => "CCT",
            Self::Duv => "Duv",
            Self::Ra => "Ra",
            Self::R9 => "R9",
            Self::Rf => "Rf",
        }
    }

    /// True if noise makes it smaller on average: a mean of colour differences.
    pub(super) fn is_biased(self) -> bool {
        matches!(self, Self::Ra | Self::R9 | Self::Rf)
    }
}

/// The rows that a light on whole nm is summed with.
static ROWS: LazyLock<Vec<Vec<f64>>> = LazyLock::new(|| {
    let nm = || (0..POINTS as u32).map(|i| f64::from(FIRST_NM + i));
    let table =
        |observer: Observer| -> Vec<[f64; 3]> { nm().map(|nm| observer.table().at(nm)).collect() };
    let (two, ten) = (table(Observer::CIE_1931), table(Observer::CIE_1964));
    let row = |of: &[[f64; 3]], factor: &dyn Fn(usize) -> f64, k: usize| -> Vec<f64> {
        of.iter()
            .enumerate()
            .map(|(i, xyz)| xyz[k] * factor(i))
            .collect()
    };
    // TM-30 sums the light, as its samples, over 380-780 nm.
    let is_inside: Vec<f64> = nm()
        .map(|nm| f64::from(u8::from((380.0..=780.0).contains(&nm))))
        .collect();
    let mut rows = Vec::with_capacity(SUMS);
    rows.extend((0..3).map(|k| row(&two, &|_| 1.0, k)));
    rows.extend((0..3).map(|k| row(&ten, &|i| is_inside[i], k)));
    for factors in &rendering_factors()[..OF_RENDERING] {
        rows.extend((0..3).map(|k| row(&two, &|i| factors[i], k)));
    }
    for factors in fidelity_factors() {
        rows.extend((0..3).map(|k| row(&ten, &|i| factors[i], k)));
    }
    assert_eq!(rows.len(), SUMS, "shipped tables, read in a test");
    rows
});

/// The rows of all sums, one value a whole nm each.
pub(super) fn rows() -> &'static [Vec<f64>] {
    &ROWS
}

/// Rows of the 2 degree observer, and those of the 10 degree one.
const TWO_DEGREES: [std::ops::Range<usize>; 2] = [0..3, 6..6 + 3 * OF_RENDERING];
const TEN_DEGREES: [std::ops::Range<usize>; 2] = [3..6, 6 + 3 * OF_RENDERING..SUMS];

/// The sums of a light on whole nm.
pub(super) fn sums_of(values: &[f64]) -> Vec<f64> {
    ROWS.iter().map(|row| dot(row, values)).collect()
}

/// Products summed in four lanes, which the processor adds side by side.
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let (a, b) = (a.as_chunks::<4>(), b.as_chunks::<4>());
    let mut lanes = [0.0; 4];
    for (a, b) in a.0.iter().zip(b.0) {
        for k in 0..4 {
            lanes[k] += a[k] * b[k];
        }
    }
    let rest: f64 = a.1.iter().zip(b.1).map(|(a, b)| a * b).sum();
    lanes.iter().sum::<f64>() + rest
}

/// White and samples of some rows, Y = 100 for the white.
fn colours(sums: &[f64], of: &[std::ops::Range<usize>; 2]) -> Option<(Xyz, Vec<Xyz>)> {
    let [white, samples] = of.clone().map(|range| &sums[range]);
    let unit = 100.0 / white[1];
    let at = |xyz: &[f64]| Xyz::new(xyz[0], xyz[1], xyz[2]).scaled(unit);
    (white[1] > 0.0 && unit.is_finite())
        .then(|| (at(white), samples.chunks_exact(3).map(at).collect()))
}

/// Every figure of a light by its sums, in the order of [`FIGURES`]; `None` for those that it does
/// not have.
pub(super) fn figures_of_sums(sums: &[f64]) -> [Option<f64>; 8] {
    let xyz = Xyz::new(sums[0], sums[1], sums[2]);
    let xy = xy_from_xyz(xyz).filter(|_| xyz.y > 0.0);
    let cct = xyz.with_y(100.0).and_then(|xyz| cct_from_xyz(xyz).ok());
    let rendering = cct.and_then(|cct| rendering_of(sums, cct.kelvin));
    [
        (xyz.y > 0.0).then_some(xyz.y),
        xy.map(|xy| xy[0]),
        xy.map(|xy| xy[1]),
        cct.map(|cct| cct.kelvin),
        cct.map(|cct| cct.duv),
        rendering.map(|r| r[0]),
        rendering.map(|r| r[1]),
        cct.and_then(|cct| fidelity_of(sums, cct.kelvin)),
    ]
}

/// The figures of a light on whole nm 360-830, in the order of [`FIGURES`].
pub fn figures_of(values: &[f64]) -> [Option<f64>; 8] {
    figures_of_sums(&sums_of(values))
}

/// The sums of a reference light in some rows; the others are 0.
fn reference(values: &[f64], of: &[std::ops::Range<usize>; 2]) -> Vec<f64> {
    let mut sums = vec![0.0; SUMS];
    for range in of {
        for i in range.clone() {
            sums[i] = dot(&ROWS[i], values);
        }
    }
    sums
}

/// Lengths of differences.
fn lengths(all: Vec<[f64; 3]>) -> impl Iterator<Item = f64> {
    let length = |d: [f64; 3]| d.iter().map(|v| v * v).sum::<f64>().sqrt();
    all.into_iter().map(length)
}

/// Ra and R9.
fn rendering_of(sums: &[f64], kelvin: f64) -> Option<[f64; 2]> {
    let expected = reference(&rendering_reference(kelvin).on_nm(), &TWO_DEGREES);
    let (expected_white, expected) = colours(&expected, &TWO_DEGREES)?;
    let scale = RenderingScale::new(expected.into_iter(), expected_white)?;
    let (white, samples) = colours(sums, &TWO_DEGREES)?;
    let differences = scale.differences(samples.into_iter(), white)?;
    let indices: Vec<f64> = lengths(differences).map(rendering_index).collect();
    let ra = indices[..GENERAL].iter().sum::<f64>() / GENERAL as f64;
    (ra.is_finite() && indices[STRONG_RED].is_finite()).then_some([ra, indices[STRONG_RED]])
}

/// Rf.
fn fidelity_of(sums: &[f64], kelvin: f64) -> Option<f64> {
    let expected = reference(&fidelity_reference(kelvin).on_nm(), &TEN_DEGREES);
    let (expected_white, expected) = colours(&expected, &TEN_DEGREES)?;
    let scale = FidelityScale::new(expected.into_iter(), expected_white)?;
    let (white, samples) = colours(sums, &TEN_DEGREES)?;
    let differences = scale.differences(samples.into_iter(), white)?;
    let rf = index_of(lengths(differences).sum::<f64>() / OF_FIDELITY as f64);
    rf.is_finite().then_some(rf)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        color::quality::{Figures, Light},
        preset,
        spectrum::Outside,
    };

    #[test]
    fn figures_by_sums_are_those_of_the_light() {
        for (group, name) in [
            ("cie_fluorescent_1nm", "FL2"),
            ("cie_fluorescent_1nm", "FL3.9"),
        ] {
            let lamp = preset::table(group, name).expect("a shipped lamp");
            let values = lamp.on_whole_nm(FIRST_NM, FIRST_NM + POINTS as u32 - 1, Outside::Zero);
            let found = figures_of(&values).map(|f| f.expect("it has all figures"));
            let light = Figures::of(&Light::of_sampled(lamp), None);
            let [x, y] = light.xy[0].clone().expect("it shines");
            let cct = light.cct.expect("near the locus");
            let rendering = light.rendering.expect("a CCT");
            let rf = light.fidelity.expect("a CCT").rf;
            let r9 = rendering.samples[STRONG_RED].index;
            let expected = [x, y, cct.kelvin, cct.duv, rendering.ra, r9, rf];
            for (found, expected) in found[1..].iter().zip(expected) {
                assert!(
                    (found - expected).abs() < 1e-8 * expected.abs().max(1.0),
                    "{found} {expected}"
                );
            }
        }
    }
}
