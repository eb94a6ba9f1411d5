//! Counts that say so, and those that do not.
//!
//! An instrument's counts are no light: its response is still in them. Words of unit and title say
//! so, as does a percentage far above 100; numbers without a unit that look like those of a
//! converter, on the axis of a row of pixels or whole, are probably counts too.

use super::quantity::says_counts;
use crate::{
    languages::with_sign,
    spectrum::{Kind, NamedSpectrum},
};

/// Largest value of 8 bit; what exceeds it and has no unit may be counts.
const ABOVE: f64 = 255.0;
/// Share of the values that are whole numbers.
const WHOLE: f64 = 0.95;
/// A percentage above which nothing lets light through or sends it back.
const MOST_PER_CENT: f64 = 1000.0;
/// Least share by which the steps of a pixel axis change.
const STEPS_CHANGE: f64 = 0.01;
/// Most that a pixel axis is away from its cubic, in steps.
const CUBIC: f64 = 0.2;
/// Pixels of rows that are sold.
const PIXELS: [usize; 5] = [1024, 2048, 2068, 3648, 4096];

/// Why values are counts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CountsSign {
    /// True if the file says so; else it is asked.
    pub is_certain: bool,
    /// The reason, in words.
    pub why: String,
}

/// Why the values of a spectrum are counts; `None` where nothing points to it.
pub fn counts_sign(of: &NamedSpectrum) -> Option<CountsSign> {
    let sign = |is_certain, why: String| Some(CountsSign { is_certain, why });
    let scale = if of.scale == 0.0 { 1.0 } else { of.scale };
    let own = || of.samples.values().iter().map(|v| v / scale);
    let highest = own().fold(0.0, f64::max);
    let shown = || with_sign(highest.to_string());
    let unit = of.unit.trim();
    match of.kind {
        Kind::Light | Kind::Other if says_counts(unit) => {
            sign(true, tr!("the unit says {unit}", unit))
        }
        Kind::Light | Kind::Other if says_counts(&of.name) && has_no_unit(unit) => {
            sign(true, tr!("the title says {name}", name = of.name))
        }
        Kind::Transmittance | Kind::Reflectance if of.scale == 0.01 && highest > MOST_PER_CENT => {
            sign(true, tr!("{share} % is no share of light", share = shown()))
        }
        Kind::Light if has_no_unit(unit) && highest > ABOVE => {
            if is_pixel_axis(of.samples.nm()) || PIXELS.contains(&of.samples.len()) {
                return sign(
                    false,
                    tr!(
                        "no unit, values up to {highest} and the axis of a row of pixels",
                        highest = shown()
                    ),
                );
            }
            let whole = own().filter(|v| v.fract().abs() < 1e-9).count();
            let is_whole = whole as f64 >= WHOLE * of.samples.len() as f64;
            match is_whole {
                true => sign(
                    false,
                    tr!(
                        "no unit and whole numbers up to {highest}",
                        highest = shown()
                    ),
                ),
                false => None,
            }
        }
        _ => None,
    }
}

fn has_no_unit(unit: &str) -> bool {
    unit.is_empty()
}

/// True if wavelengths are those of a row of pixels: steps that change along the axis as a cubic
/// of the pixel's number says.
fn is_pixel_axis(nm: &[f64]) -> bool {
    let n = nm.len();
    if n < 16 {
        return false;
    }
    let is_rising = nm.windows(2).all(|w| w[1] > w[0]);
    let mean = (nm[n - 1] - nm[0]) / (n - 1) as f64;
    // Steps of three parts, so that the rounding of an even axis is none.
    let third = (n - 1) / 3;
    let step = |from: usize, to: usize| (nm[to] - nm[from]) / (to - from) as f64;
    let parts = [
        step(0, third),
        step(third, 2 * third),
        step(2 * third, n - 1),
    ];
    let change = parts.iter().copied().fold(0.0_f64, f64::max)
        - parts.iter().copied().fold(f64::INFINITY, f64::min);
    if !is_rising || change / mean <= STEPS_CHANGE {
        return false;
    }
    let x: Vec<f64> = (0..n)
        .map(|i| 2.0 * i as f64 / (n - 1) as f64 - 1.0)
        .collect();
    cubic_misfit(&x, nm) <= CUBIC * mean
}

/// Largest distance of values from their cubic in `x`, by Legendre polynomials on -1 to 1 made
/// orthogonal on these points.
fn cubic_misfit(x: &[f64], values: &[f64]) -> f64 {
    let mut left = values.to_vec();
    let mut basis: Vec<Vec<f64>> = Vec::new();
    for power in 0..4 {
        let mut column: Vec<f64> = x.iter().map(|x| x.powi(power)).collect();
        for other in &basis {
            let share: f64 = column.iter().zip(other).map(|(a, b)| a * b).sum();
            column
                .iter_mut()
                .zip(other)
                .for_each(|(c, o)| *c -= share * o);
        }
        let size = column.iter().map(|c| c * c).sum::<f64>().sqrt();
        column.iter_mut().for_each(|c| *c /= size);
        let share: f64 = left.iter().zip(&column).map(|(a, b)| a * b).sum();
        left.iter_mut()
            .zip(&column)
            .for_each(|(l, c)| *l -= share * c);
        basis.push(column);
    }
    left.iter().fold(0.0, |most, v| most.max(v.abs()))
}
