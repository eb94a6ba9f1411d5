//! Colour fidelity and gamut from sums: Rf and Rg of ANSI/IES TM-30-20 (Rf = CIE 224:2017).
//!
//! The formulas are those of the program's figure, 380-780 nm, CIE 1964 observer, CAM02-UCS; here
//! the reference is prepared once and a light is 300 sums.

use super::{colours, weighed};
use crate::color::quality::{BINS, ViewingConditions, area, bin_of, fidelity_reference};

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
        let expected = appearances(&weighed(rows, &fidelity_reference(kelvin).on_nm()))?;
        let bins: Vec<usize> = expected.iter().map(|[_, a, b]| bin_of([*a, *b])).collect();
        let area = gamut_area(&expected, &bins);
        Some(Self {
            expected,
            bins,
            area,
        })
    }

    /// `[J', a', b']` of each sample less those under the reference.
    pub(super) fn differences(&self, sums: &[f64]) -> Option<Vec<[f64; 3]>> {
        let found = appearances(sums)?;
        let both = found.iter().zip(&self.expected);
        Some(
            both.map(|(a, b)| std::array::from_fn(|k| a[k] - b[k]))
                .collect(),
        )
    }

    pub(super) fn rg(&self, sums: &[f64]) -> Option<f64> {
        let found = appearances(sums).filter(|found| found.len() == self.expected.len())?;
        let rg = 100.0 * gamut_area(&found, &self.bins) / self.area;
        rg.is_finite().then_some(rg)
    }
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
    area(&points)
}

/// `[J', a', b']` of every sample, the last sum being the light; `None` where no eye adapts.
fn appearances(sums: &[f64]) -> Option<Vec<[f64; 3]>> {
    let (samples, white) = colours(sums)?;
    let eye = ViewingConditions::adapted_to(white)?;
    Some(samples.map(|xyz| eye.uniform(xyz)).collect())
}
