//! One of the 16 hue bins of TM-30.

use super::appearance::ViewingConditions;
use crate::color::Xyz;

/// Number of hue bins.
pub(crate) const BINS: usize = 16;

/// Width of a bin, degrees.
const WIDTH_DEG: f64 = 360.0 / BINS as f64;

/// The local figures of a hue bin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HueBin {
    /// Local fidelity, 0-100.
    pub rf: f64,
    /// Local chroma shift as a fraction; positive is more chroma.
    pub rcs: f64,
    /// Local hue shift, radians; positive turns to greater hue (red to yellow to green).
    pub rhs: f64,
    /// Point of the vector graphic under the light: mean a'b' over the reference's mean chroma.
    pub test_ab: [f64; 2],
    /// Point under the reference, on the unit circle at its own hue.
    pub reference_ab: [f64; 2],
    /// Number of samples in the bin.
    pub samples: usize,
    /// Mean colour of its samples under the light (CIE 1964, Y = 100 for the light).
    pub test_xyz: Xyz,
    /// Mean colour of its samples under the reference.
    pub reference_xyz: Xyz,
}

/// Middle of a bin (0-15), degrees of hue.
pub(crate) fn bin_middle_deg(bin: usize) -> f64 {
    (bin as f64 + 0.5) * WIDTH_DEG
}

/// The bin that a hue falls into; hues are of samples under the reference.
pub(crate) fn bin_of([a, b]: [f64; 2]) -> usize {
    let degrees = b.atan2(a).to_degrees().rem_euclid(360.0);
    // A hue a rounding below 360 may come out as 360 itself.
    ((degrees / WIDTH_DEG) as usize).min(BINS - 1)
}

/// Colourfulness in CAM02-UCS below which a surface is called grey: this program's border.
const LEAST_COLOURFULNESS: f64 = 4.0;

/// The bin of a surface's hue under a light whose white is given, both with Y = 100 for the light;
/// `None` for a grey, and where no eye adapts to the light.
pub(crate) fn hue_of(xyz: Xyz, white: Xyz) -> Option<usize> {
    let [_, a, b] = ViewingConditions::adapted_to(white)?.uniform(xyz);
    (a.hypot(b) >= LEAST_COLOURFULNESS).then(|| bin_of([a, b]))
}

/// Names of the bins from hue 0 on, by the hues that look unmixed in CIECAM02: red at 20.1 degrees,
/// yellow at 90, green at 164.3, blue at 237.5.
pub(crate) const HUE_NAMES: [&str; BINS] = [
    later!("red"),
    later!("orange red"),
    later!("orange"),
    later!("yellowish orange"),
    later!("yellow"),
    later!("yellow green"),
    later!("yellowish green"),
    later!("green"),
    later!("bluish green"),
    later!("blue green"),
    later!("blue"),
    later!("purplish blue"),
    later!("bluish violet"),
    later!("violet"),
    later!("purple"),
    later!("reddish purple"),
];

/// Fidelity lost for each unit of difference in CAM02-UCS, before the bend near zero.
const FIDELITY_PER_UNIT: f64 = 6.73;

/// The index of a mean colour difference: 100 for none, never below 0. The formula itself gives
/// 100.0005 for none, which is more than the index has.
pub(crate) fn index_of(difference: f64) -> f64 {
    let index = 10.0
        * ((100.0 - FIDELITY_PER_UNIT * difference) / 10.0)
            .exp()
            .ln_1p();
    index.min(100.0)
}

/// The mean colour difference of an index; infinite for one of zero or less, which every light has.
pub(crate) fn difference_of(index: f64) -> f64 {
    if index <= 0.0 {
        return f64::INFINITY;
    }
    (100.0 - 10.0 * (index / 10.0).exp_m1().ln()) / FIDELITY_PER_UNIT
}

/// Sums over a bin's samples.
#[derive(Clone, Copy, Default)]
pub(super) struct BinSum {
    pub(super) samples: usize,
    pub(super) difference: f64,
    pub(super) test_ab: [f64; 2],
    pub(super) reference_ab: [f64; 2],
    pub(super) test_xyz: Xyz,
    pub(super) reference_xyz: Xyz,
}

impl BinSum {
    /// The sums over the number of samples; `None` for an empty bin.
    pub(super) fn mean(self) -> Option<Self> {
        let share = 1.0 / self.samples as f64;
        (self.samples > 0).then(|| Self {
            samples: self.samples,
            difference: self.difference * share,
            test_ab: self.test_ab.map(|v| v * share),
            reference_ab: self.reference_ab.map(|v| v * share),
            test_xyz: self.test_xyz * share,
            reference_xyz: self.reference_xyz * share,
        })
    }

    /// The figures of a bin from its means; `None` where the reference has no chroma.
    pub(super) fn figures(self, bin: usize) -> Option<HueBin> {
        let chroma = self.reference_ab[0].hypot(self.reference_ab[1]);
        if chroma.is_nan() || chroma <= 1e-9 {
            return None;
        }
        let (sin, cos) = bin_middle_deg(bin).to_radians().sin_cos();
        let [a, b] = [0, 1].map(|k| (self.test_ab[k] - self.reference_ab[k]) / chroma);
        Some(HueBin {
            rf: index_of(self.difference),
            rcs: a * cos + b * sin,
            rhs: b * cos - a * sin,
            test_ab: self.test_ab.map(|v| v / chroma),
            reference_ab: self.reference_ab.map(|v| v / chroma),
            samples: self.samples,
            test_xyz: self.test_xyz,
            reference_xyz: self.reference_xyz,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bins_begin_at_hue_zero_and_go_round() {
        for bin in 0..BINS {
            let (sin, cos) = bin_middle_deg(bin).to_radians().sin_cos();
            assert_eq!(bin_of([cos, sin]), bin);
        }
        assert_eq!(bin_of([1.0, 0.0]), 0);
        assert_eq!(bin_of([1.0, -1e-18]), 15);
    }

    #[test]
    fn the_difference_of_an_index_has_that_index() {
        for tenths in 1..=1000 {
            let index = 0.1 * f64::from(tenths);
            // An index near 0 lies in the tail of the bend, where differences are many.
            assert!((index_of(difference_of(index)) - index).abs() < 1e-12 * 100.0);
        }
        assert_eq!(difference_of(0.0), f64::INFINITY);
    }

    #[test]
    fn no_difference_is_100_and_a_large_one_0() {
        assert_eq!(index_of(0.0), 100.0);
        assert!(index_of(1e-3) < 100.0);
        assert!(index_of(1000.0) >= 0.0 && index_of(1000.0) < 1e-9);
    }
}
