//! The three goals as linear functions of a spectrum on the grid, the same for every light.
//!
//! ```text
//! patches   X, Y, Z of the ColorChecker's reflectances
//! filters   X, Y, Z behind Gaussian 10 nm band-passes at 418, 422 ... 678 nm
//! spectrum  the spectrum behind a 10 nm blur at every fourth nm
//! ```
//!
//! One value each is a row. No band-pass here has a centre that chooses or judges.

use super::judge::EvaluationSet;
use crate::{
    spectrum::{Band, Line, dot},
    study::{bandpass, error::BLUR_NM},
};

/// Centres of the band-passes: first, distance, last, nm.
const FILTERS_NM: [u32; 3] = [418, 4, 678];

/// The blurred spectrum is looked at every so many nm.
const BLUR_STEP: usize = 4;

/// The rows of the three goals on one band for one observer.
#[derive(Clone, Debug)]
pub(super) struct Operators {
    band: Band,
    /// Colour-matching functions times trapezoid weights.
    seen: [Vec<f64>; 3],
    patches: Vec<Vec<f64>>,
    filters: Vec<Window>,
    blur: Vec<Window>,
}

impl Operators {
    /// The operators beside a panel that chooses.
    pub(super) fn new(panel: &EvaluationSet) -> Self {
        let band = panel.band();
        let [first, step, last] = FILTERS_NM;
        let centres = (first..=last).step_by(step as usize).map(f64::from);
        let inside = centres.filter(|nm| band.contains(*nm));
        // A Gaussian of the filters' width and of area 1.
        let height = Line::ideal(0.0, 1.0).stem_height(BLUR_NM);
        let blurred = |centre_nm: f64| {
            let mut bell = bandpass(band, centre_nm);
            for (i, v) in bell.iter_mut().enumerate() {
                *v *= band.weight(i) * height;
            }
            Window::of(&bell)
        };
        Self {
            band,
            seen: panel
                .measures()
                .patches
                .observer()
                .table()
                .weighted_on_band(band),
            patches: panel.reflectances().to_vec(),
            filters: inside.map(|nm| Window::of(&bandpass(band, nm))).collect(),
            blur: band.grid().step_by(BLUR_STEP).map(blurred).collect(),
        }
    }

    /// The band.
    pub(super) fn band(&self) -> Band {
        self.band
    }

    /// Colours among the rows: patches, then filters, three rows each.
    pub(super) fn colours(&self) -> [usize; 2] {
        [self.patches.len(), self.filters.len()]
    }

    /// Rows in all; the blurred spectrum comes last.
    pub(super) fn rows(&self) -> usize {
        3 * (self.patches.len() + self.filters.len()) + self.blur.len()
    }

    /// X, Y, Z of values that begin at grid point `first`, in value x nm.
    pub(super) fn xyz(&self, first: usize, values: &[f64]) -> [f64; 3] {
        self.seen
            .each_ref()
            .map(|row| dot(&row[first..first + values.len()], values))
    }

    /// The rows of values that begin at grid point `first` and are zero elsewhere.
    pub(super) fn rows_of(&self, first: usize, values: &[f64]) -> Vec<f64> {
        let here = first..first + values.len();
        let mut rows = vec![0.0; self.rows()];
        let seen = self.seen.each_ref().map(|row| -> Vec<f64> {
            let weighed = row[here.clone()].iter().zip(values);
            weighed.map(|(w, v)| w * v).collect()
        });
        let (patches, rest) = rows.split_at_mut(3 * self.patches.len());
        for (triple, reflectance) in patches.chunks_exact_mut(3).zip(&self.patches) {
            for (row, seen) in triple.iter_mut().zip(&seen) {
                *row = dot(&reflectance[here.clone()], seen);
            }
        }
        let (filters, blur) = rest.split_at_mut(3 * self.filters.len());
        for (triple, filter) in filters.chunks_exact_mut(3).zip(&self.filters) {
            for (row, seen) in triple.iter_mut().zip(&seen) {
                *row = filter.dot(first, seen);
            }
        }
        for (row, blur) in blur.iter_mut().zip(&self.blur) {
            *row = blur.dot(first, values);
        }
        rows
    }

    /// The function `h` on the grid with `sum h x = sum rows (rows of x)` for every `x`.
    pub(super) fn adjoint(&self, rows: &[f64]) -> Vec<f64> {
        let points = self.band.points();
        let mut through = [(); 3].map(|()| vec![0.0; points]);
        let (patches, rest) = rows.split_at(3 * self.patches.len());
        for (triple, reflectance) in patches.chunks_exact(3).zip(&self.patches) {
            for (through, weight) in through.iter_mut().zip(triple) {
                for (t, r) in through.iter_mut().zip(reflectance) {
                    *t += weight * r;
                }
            }
        }
        let (filters, blur) = rest.split_at(3 * self.filters.len());
        for (triple, filter) in filters.chunks_exact(3).zip(&self.filters) {
            for (through, weight) in through.iter_mut().zip(triple) {
                filter.add_to(*weight, through);
            }
        }
        let mut h = vec![0.0; points];
        for (through, seen) in through.iter().zip(&self.seen) {
            for ((h, t), s) in h.iter_mut().zip(through).zip(seen) {
                *h += t * s;
            }
        }
        for (weight, blur) in blur.iter().zip(&self.blur) {
            blur.add_to(*weight, &mut h);
        }
        h
    }
}

/// Below this share of its height a function is left out.
const NEGLIGIBLE: f64 = 1e-12;

/// A function that is zero outside a window of the grid.
#[derive(Clone, Debug)]
struct Window {
    first: usize,
    values: Vec<f64>,
}

impl Window {
    /// The part of a function that counts.
    fn of(values: &[f64]) -> Self {
        let height = values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let counts = |v: &f64| v.abs() > NEGLIGIBLE * height;
        let first = values.iter().position(counts).unwrap_or(0);
        let last = values.iter().rposition(counts).unwrap_or(0);
        Self {
            first,
            values: values[first..=last].to_vec(),
        }
    }

    /// Sum of products with values that begin at grid point `first`.
    fn dot(&self, first: usize, values: &[f64]) -> f64 {
        let from = self.first.max(first);
        let to = (self.first + self.values.len()).min(first + values.len());
        if from >= to {
            return 0.0;
        }
        dot(
            &self.values[from - self.first..to - self.first],
            &values[from - first..to - first],
        )
    }

    /// Adds the function times a weight to values on the whole grid.
    fn add_to(&self, weight: f64, out: &mut [f64]) {
        for (o, v) in out[self.first..].iter_mut().zip(&self.values) {
            *o += weight * v;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{color::Observer, spectrum::LineProfile};

    fn operators() -> Operators {
        Operators::new(&EvaluationSet::choosing(Band::VISIBLE, Observer::CIE_1931))
    }

    #[test]
    fn rows_of_a_window_are_rows_of_the_whole() {
        let operators = operators();
        let shape = LineProfile::new(Band::VISIBLE, 546.1, 12.0);
        let mut whole = vec![0.0; 401];
        shape.add_to(1.0, &mut whole);
        let (part, all) = (
            operators.rows_of(shape.first, &shape.values),
            operators.rows_of(0, &whole),
        );
        // Sums of a hundred products below 1 in another order.
        assert!(part.iter().zip(&all).all(|(a, b)| (a - b).abs() < 1e-12));
    }

    #[test]
    fn the_adjoint_weighs_a_spectrum_as_its_rows_are_weighed() {
        let operators = operators();
        let spectrum: Vec<f64> = Band::VISIBLE.grid().map(|nm| (nm / 31.0).sin()).collect();
        let weights: Vec<f64> = (0..operators.rows())
            .map(|i| (i as f64 * 0.7).cos())
            .collect();
        let by_rows = dot(&weights, &operators.rows_of(0, &spectrum));
        let by_grid = dot(&operators.adjoint(&weights), &spectrum);
        // 150 000 products of size 1.
        assert!((by_rows - by_grid).abs() < 1e-9 * by_rows.abs().max(1.0));
    }
}
