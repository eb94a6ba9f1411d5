//! Colour fidelity and gamut from sums: Rf and Rg of ANSI/IES TM-30-20 (Rf = CIE 224:2017).
//!
//! The same definition as the program's figure, 380-780 nm, CIE 1964 observer, CAM02-UCS; here
//! the reference is prepared once and a light is 300 sums. Sources: CIE 159:2004 for the
//! appearance model, Luo, Cui and Li 2006 for its uniform space.

use std::f64::consts::TAU;

use super::{inner, weighed};
use crate::{
    color::{
        Observer, Xyz,
        matrix::{Matrix3, inverse, times_vector},
    },
    design::whole_nm,
};

/// Hue bins of the gamut index.
const BINS: usize = 16;

/// Scale of the fidelity index.
const PER_DIFFERENCE: f64 = 6.73;

/// Rf and Rg of lights whose reference is prepared.
#[derive(Clone, Debug)]
pub(super) struct FidelityScale {
    /// `[J', a', b']` of the samples under the reference.
    expected: Vec<[f64; 3]>,
    bins: Vec<usize>,
    area: f64,
}

impl FidelityScale {
    pub(super) fn new(kelvin: f64, rows: &[f64]) -> Option<Self> {
        let expected = appearances(&weighed(rows, &reference(kelvin)?))?;
        let bin = |[_, a, b]: &[f64; 3]| {
            let turn = b.atan2(*a) / TAU;
            ((turn - turn.floor()) * BINS as f64) as usize % BINS
        };
        let bins: Vec<usize> = expected.iter().map(bin).collect();
        let area = gamut_area(&expected, &bins);
        Some(Self {
            expected,
            bins,
            area,
        })
    }

    pub(super) fn rf(&self, sums: &[f64]) -> Option<f64> {
        let found = appearances(sums).filter(|found| found.len() == self.expected.len())?;
        let both = found.iter().zip(&self.expected);
        let total: f64 = both
            .map(|(a, b)| (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt())
            .sum();
        let raw = 100.0 - PER_DIFFERENCE * total / self.expected.len() as f64;
        let rf = 10.0 * (raw / 10.0).exp().ln_1p();
        rf.is_finite().then_some(rf)
    }

    pub(super) fn rg(&self, sums: &[f64]) -> Option<f64> {
        let found = appearances(sums).filter(|found| found.len() == self.expected.len())?;
        let rg = 100.0 * gamut_area(&found, &self.bins) / self.area;
        rg.is_finite().then_some(rg)
    }
}

/// A blackbody to 4000 K, daylight from 5000 K, mixed at equal luminance in between.
fn reference(kelvin: f64) -> Option<Vec<f64>> {
    if kelvin <= 4000.0 {
        return whole_nm::planck(kelvin);
    }
    let day = whole_nm::daylight(kelvin)?;
    if kelvin >= 5000.0 {
        return Some(day);
    }
    let black = whole_nm::planck(kelvin)?;
    let share = (kelvin - 4000.0) / 1000.0;
    let v = &Observer::Cie1931.table().xyz[1];
    let (black_y, day_y) = (inner(&black, v), inner(&day, v));
    let both = black.iter().zip(&day);
    let mixed = both.map(|(b, d)| (1.0 - share) * b / black_y + share * d / day_y);
    Some(mixed.collect())
}

/// Area of the polygon of the bins' mean a'b'.
fn gamut_area(found: &[[f64; 3]], bins: &[usize]) -> f64 {
    let mut sums = [[0.0; 3]; BINS];
    for ([_, a, b], bin) in found.iter().zip(bins) {
        let sum = &mut sums[*bin];
        *sum = [sum[0] + a, sum[1] + b, sum[2] + 1.0];
    }
    let filled = sums.iter().filter(|sum| sum[2] > 0.0);
    let points: Vec<[f64; 2]> = filled.map(|[a, b, n]| [a / n, b / n]).collect();
    let next = points.iter().cycle().skip(1);
    let twice: f64 = points
        .iter()
        .zip(next)
        .map(|(p, q)| p[0] * q[1] - q[0] * p[1])
        .sum();
    0.5 * twice.abs()
}

const CAT02: Matrix3 = [
    [0.7328, 0.4296, -0.1624],
    [-0.7036, 1.6975, 0.0061],
    [0.0030, 0.0136, 0.9834],
];
const XYZ_FROM_CAT02: Matrix3 = inverse(&CAT02);
const HUNT_POINTER_ESTEVEZ: Matrix3 = [
    [0.38971, 0.68898, -0.07868],
    [-0.22981, 1.18340, 0.04641],
    [0.0, 0.0, 1.0],
];

/// Adapting luminance 100 cd/m2: the luminance-level adaptation factor.
fn luminance_factor() -> f64 {
    let five_la = 500.0_f64;
    let k4 = (1.0 / (five_la + 1.0)).powi(4);
    0.2 * k4 * five_la + 0.1 * (1.0 - k4).powi(2) * five_la.cbrt()
}

/// `[J', a', b']` of every sample, the last sum being the light; `None` where no eye adapts.
fn appearances(sums: &[f64]) -> Option<Vec<[f64; 3]>> {
    let samples = (sums.len() / 3).checked_sub(1)?;
    let at = |i: usize| Xyz::new(sums[3 * i], sums[3 * i + 1], sums[3 * i + 2]);
    let white = at(samples);
    let unit = 100.0 / white.y;
    if !(white.y > 0.0 && unit.is_finite()) {
        return None;
    }
    let signals = times_vector(&CAT02, (white * unit).to_array());
    if signals.iter().any(|v| v.is_nan() || *v <= 0.0) {
        return None;
    }
    // Complete adaptation and the change to cones are one matrix.
    let cone = times_matrix(&HUNT_POINTER_ESTEVEZ, &XYZ_FROM_CAT02);
    let adapted = std::array::from_fn(|k| CAT02[k].map(|v| v * 100.0 / signals[k]));
    let to_cones = times_matrix(&cone, &adapted);
    let level = luminance_factor();
    let background = 0.2_f64;
    let induction = 0.725 * background.powf(-0.2);
    let exponent = 0.69 * (1.48 + background.sqrt());
    let of_chroma = (1.64 - 0.29_f64.powf(background)).powf(0.73);
    let root = level.powf(0.25);
    let responses = |xyz: Xyz| {
        times_vector(&to_cones, xyz.to_array()).map(|cone| {
            let power = (level * cone.abs() / 100.0).powf(0.42);
            (400.0 * power / (power + 27.13)).copysign(cone) + 0.1
        })
    };
    let achromatic = |[r, g, b]: [f64; 3]| (2.0 * r + g + b / 20.0 - 0.305) * induction;
    let of_white = achromatic(responses(white * unit));
    let (sin_2, cos_2) = 2.0_f64.sin_cos();
    let one = |i: usize| {
        let seen = responses(at(i) * unit);
        let [red, green, blue] = seen;
        let a = red - 12.0 * green / 11.0 + blue / 11.0;
        let b = (red + green - 2.0 * blue) / 9.0;
        let lightness = (achromatic(seen) / of_white).max(0.0).powf(exponent);
        let j = 170.0 * lightness / (1.0 + 0.7 * lightness);
        let size = (a * a + b * b).sqrt();
        if size == 0.0 {
            return [j, 0.0, 0.0];
        }
        let (cos, sin) = (a / size, b / size);
        let eccentricity = 0.25 * (cos * cos_2 - sin * sin_2 + 3.8);
        let t = 50_000.0 / 13.0 * induction * eccentricity * size / (red + green + 1.05 * blue);
        let chroma = t.max(0.0).powf(0.9) * lightness.sqrt() * of_chroma;
        let colourfulness = (0.0228 * chroma * root).ln_1p() / 0.0228;
        [j, colourfulness * cos, colourfulness * sin]
    };
    Some((0..samples).map(one).collect())
}

fn times_matrix(a: &Matrix3, b: &Matrix3) -> Matrix3 {
    std::array::from_fn(|row| {
        std::array::from_fn(|column| (0..3).map(|k| a[row][k] * b[k][column]).sum())
    })
}
