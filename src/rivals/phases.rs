//! Moments of a signal that is laid on half a circle: cosines and sines of every multiple.

use std::f64::consts::PI;

use super::Bounds;
use crate::spectrum::{Band, dot};

/// Share by which all moments but the mean are drawn towards zero, which is the signal drawn
/// towards its mean. A signal with zeros has moments on the border of what a positive signal can
/// have, where the estimate does not exist; this steps inside, moves no energy, and is the same
/// at every count, so that fewer moments stay a prefix of more.
pub(super) const DRAWN_TO_MEAN: f64 = 1e-6;

/// Cosines and sines of the multiples of the phase on a band's grid.
#[derive(Debug)]
pub(super) struct PhaseTable {
    pub(super) band: Band,
    /// Rows of `band.points()` values: `cos(j phi)`.
    cosines: Vec<f64>,
    /// Rows of `band.points()` values: `sin(j phi)`.
    sines: Vec<f64>,
}

impl PhaseTable {
    /// The first `most` multiples.
    pub(super) fn new(band: Band, most: usize) -> Self {
        let (most, turn) = (most.clamp(1, band.points()), 2 * band.steps());
        let circle: Vec<(f64, f64)> = (0..turn)
            .map(|i| (PI * i as f64 / band.length_nm()).sin_cos())
            .collect();
        let places = (0..most).flat_map(|j| (0..band.points()).map(move |i| j * i % turn));
        Self {
            band,
            cosines: places.clone().map(|k| circle[k].1).collect(),
            sines: places.map(|k| circle[k].0).collect(),
        }
    }

    /// Rows of cosine and sine, multiple 0 first.
    pub(super) fn rows(&self) -> impl Iterator<Item = (&[f64], &[f64])> {
        let points = self.band.points();
        self.cosines
            .chunks_exact(points)
            .zip(self.sines.chunks_exact(points))
    }

    /// Real and imaginary part of the polynomial `sum a_j z^j` of real coefficients at every
    /// `z = e^{i phi}` of the grid.
    pub(super) fn sums(&self, coefficients: impl Iterator<Item = f64>) -> (Vec<f64>, Vec<f64>) {
        let points = self.band.points();
        let (mut re, mut im) = (vec![0.0; points], vec![0.0; points]);
        for (a, (cosine, sine)) in coefficients.zip(self.rows()) {
            re.iter_mut().zip(cosine).for_each(|(r, c)| *r += a * c);
            im.iter_mut().zip(sine).for_each(|(i, s)| *i += a * s);
        }
        (re, im)
    }

    /// The first `numbers` moments of values on the grid.
    ///
    /// Lights count as values at points, reflectances as cells of one nm, whose moments are those
    /// of points times `sin(x)/x` with x half of what a cell covers in phase: points of a bounded
    /// signal are not bounded themselves, and a filter with edges would have no estimate.
    pub(super) fn moments(&self, values: &[f64], numbers: usize, bounds: Bounds) -> Vec<f64> {
        let share = |i: usize, v: f64| v * self.band.weight(i) / self.band.length_nm();
        let weighted: Vec<f64> = values
            .iter()
            .enumerate()
            .map(|(i, v)| share(i, *v))
            .collect();
        let mut moments: Vec<f64> = self
            .rows()
            .take(numbers.max(1))
            .map(|(cosine, _)| dot(cosine, &weighted))
            .collect();
        for (j, c) in moments.iter_mut().enumerate().skip(1) {
            *c *= 1.0 - DRAWN_TO_MEAN;
            if bounds == Bounds::Reflectance {
                *c *= self.cell_factor(j);
            }
        }
        moments
    }

    /// `sin(x)/x` with x half of the angle by which `j phi` grows in one nm; `j` at least 1.
    fn cell_factor(&self, j: usize) -> f64 {
        let half = 0.5 * PI * j as f64 / self.band.length_nm();
        half.sin() / half
    }

    pub(super) fn phase(&self, at_nm: f64) -> f64 {
        PI * (at_nm - self.band.min_nm()) / self.band.length_nm()
    }
}
