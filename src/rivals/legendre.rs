//! Least-squares polynomial, written in the polynomials that are orthogonal on the 1 nm grid.
//!
//! Under the mean product `<f, g> = (1/L) sum w_i f_i g_i` (trapezoid weights) and with x running
//! from -1 to 1 over the band, the grid's orthonormal polynomials follow from one another:
//!
//! ```text
//! p_0 = 1,   b_{n+1} p_{n+1} = x p_n - b_n p_{n-1},   b_{n+1} = | x p_n - b_n p_{n-1} |
//! ```
//!
//! (Stieltjes; the middle coefficient is zero because the grid is symmetric.) A projection on
//! them is the least-squares polynomial, the same as a fit of ordinary Legendre polynomials, and
//! `b_1, b_2, ...` follow from the band alone: no table goes with the numbers.

use std::sync::Arc;

use super::{Representation, midpoints_nm};
use crate::spectrum::{Band, dot};

/// Largest inner product of two rows that still counts as rounding.
///
/// Forward recurrence on equally spaced points loses orthogonality at some degree (near 6 times
/// the square root of the point count: 121 on 401 points); there the table ends, and with it what
/// is fitted. Above twice the square root a polynomial swings between grid points near the ends
/// of the band, as every least-squares polynomial on equal steps does.
const LOST_ORTHOGONALITY: f64 = 1e-9;

/// The grid's polynomials on a band.
#[derive(Debug)]
pub(super) struct PolynomialTable {
    band: Band,
    /// `b_1, b_2, ...`: one less than there are rows.
    links: Vec<f64>,
    /// Rows of `band.points()` values.
    rows: Vec<f64>,
    /// The same rows with trapezoid weight over L.
    projectors: Vec<f64>,
}

impl PolynomialTable {
    /// The first `most` polynomials, or fewer where rounding ends their independence.
    pub(super) fn new(band: Band, most: usize) -> Self {
        let mut table = Self {
            band,
            links: Vec::new(),
            rows: vec![1.0; band.points()],
            projectors: Vec::new(),
        };
        table.project_on(&vec![1.0; band.points()]);
        while table.count() < most.min(band.points()) && table.grow().is_some() {}
        table
    }

    fn count(&self) -> usize {
        self.links.len() + 1
    }

    fn row(&self, index: usize) -> &[f64] {
        let points = self.band.points();
        &self.rows[index * points..(index + 1) * points]
    }

    /// Adds the next polynomial; `None` where it is no longer orthogonal to the others.
    fn grow(&mut self) -> Option<()> {
        let degree = self.count() - 1;
        let mut next: Vec<f64> = (0..self.band.points())
            .map(|i| position(self.band, self.band.nm(i)) * self.row(degree)[i])
            .collect();
        if degree > 0 {
            let link = self.links[degree - 1];
            let before = self.row(degree - 1);
            next.iter_mut()
                .zip(before)
                .for_each(|(n, b)| *n -= link * b);
        }
        let link = (self.band.inner(&next, &next) / self.band.length_nm()).sqrt();
        if link.is_nan() || link <= 0.0 {
            return None;
        }
        next.iter_mut().for_each(|n| *n /= link);
        if self
            .project(&next, self.count())
            .iter()
            .any(|c| c.abs() > LOST_ORTHOGONALITY)
        {
            return None;
        }
        self.project_on(&next);
        self.links.push(link);
        self.rows.append(&mut next);
        Some(())
    }

    fn project_on(&mut self, row: &[f64]) {
        let band = self.band;
        let weighted = row.iter().enumerate();
        self.projectors
            .extend(weighted.map(|(i, v)| v * band.weight(i) / band.length_nm()));
    }

    fn project(&self, values: &[f64], numbers: usize) -> Vec<f64> {
        self.projectors
            .chunks_exact(self.band.points())
            .take(numbers)
            .map(|row| dot(row, values))
            .collect()
    }
}

/// -1 at the band's start, 1 at its end.
fn position(band: Band, at_nm: f64) -> f64 {
    let from_middle_nm = (at_nm - band.min_nm()) - 0.5 * band.length_nm();
    2.0 * from_middle_nm / band.length_nm()
}

/// A polynomial over the band.
#[derive(Clone, Debug)]
pub struct Legendre {
    table: Arc<PolynomialTable>,
    /// Lowest degree first; the first is the mean. In the spectrum's own unit.
    coefficients: Vec<f64>,
}

impl Legendre {
    /// The least-squares polynomial of `numbers` coefficients, or as many as the table has.
    pub(super) fn fit(table: &Arc<PolynomialTable>, values: &[f64], numbers: usize) -> Self {
        Self {
            table: Arc::clone(table),
            coefficients: table.project(values, numbers.max(1)),
        }
    }
}

impl Representation for Legendre {
    fn band(&self) -> Band {
        self.table.band
    }

    fn stored(&self) -> Vec<f64> {
        self.coefficients.clone()
    }

    fn scale(&mut self, factor: f64) {
        self.coefficients.iter_mut().for_each(|v| *v *= factor);
    }

    fn inside(&self, at_nm: f64) -> f64 {
        let x = position(self.table.band, at_nm);
        let (mut before, mut now, mut link_before) = (0.0, 1.0, 0.0);
        let mut sum = self.coefficients[0];
        for (c, link) in self.coefficients[1..].iter().zip(&self.table.links) {
            let next = (x * now - link_before * before) / link;
            (before, now, link_before) = (now, next, *link);
            sum += c * now;
        }
        sum
    }

    fn on_band(&self) -> Vec<f64> {
        let mut out = vec![0.0; self.table.band.points()];
        for (k, c) in self.coefficients.iter().enumerate() {
            let row = self.table.row(k);
            out.iter_mut().zip(row).for_each(|(o, p)| *o += c * p);
        }
        out
    }

    fn places_nm(&self) -> Vec<f64> {
        midpoints_nm(self.table.band, 2 * self.coefficients.len())
    }

    fn points(&self) -> Vec<f64> {
        let places = self.places_nm();
        places.iter().map(|nm| self.inside(*nm)).collect()
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{DMatrix, DVector};

    use super::*;
    use crate::rivals::example_spectra::{fluorescent, thermal};

    const BAND: Band = Band::VISIBLE;

    fn table(band: Band, most: usize) -> Arc<PolynomialTable> {
        Arc::new(PolynomialTable::new(band, most))
    }

    #[test]
    fn rows_are_orthonormal_under_the_mean_product() {
        let table = table(BAND, 40);
        for i in 0..40 {
            for j in 0..40 {
                let product = BAND.inner(table.row(i), table.row(j)) / BAND.length_nm();
                let wanted = if i == j { 1.0 } else { 0.0 };
                // What the recurrence has lost by degree 40; it doubles every few degrees.
                assert!((product - wanted).abs() < 1e-11, "{i} {j}");
            }
        }
    }

    #[test]
    fn the_fit_is_the_least_squares_fit_of_ordinary_legendre_polynomials() {
        let values = fluorescent(BAND);
        let numbers = 20;
        let root = |i: usize| BAND.weight(i).sqrt();
        // Bonnet's recurrence (n+1) P_{n+1} = (2n+1) x P_n - n P_{n-1}.
        let ordinary = |i: usize, degree: usize| {
            let x = position(BAND, BAND.nm(i));
            let (mut before, mut now) = (0.0, 1.0);
            for n in 0..degree {
                let n = n as f64;
                (before, now) = (now, ((2.0 * n + 1.0) * x * now - n * before) / (n + 1.0));
            }
            now
        };
        let design = DMatrix::from_fn(401, numbers, |i, k| root(i) * ordinary(i, k));
        let target = DVector::from_fn(401, |i, _| root(i) * values[i]);
        let solution = design.clone().svd(true, true).solve(&target, 0.0).unwrap();
        let reference = design * solution;
        let fit = Legendre::fit(&table(BAND, numbers), &values, numbers).on_band();
        for (i, v) in fit.iter().enumerate() {
            // The design's condition number is under 100: some hundred roundings.
            assert!((v - reference[i] / root(i)).abs() < 1e-11);
        }
    }

    #[test]
    fn a_smooth_light_is_reached_to_rounding() {
        let values = thermal(BAND, 5000.0);
        let fit = Legendre::fit(&table(BAND, 31), &values, 31).on_band();
        for (a, b) in fit.iter().zip(&values) {
            // Convergence is geometric: 31 terms are enough for rounding.
            assert!((a - b).abs() < 1e-12);
        }
    }

    #[test]
    fn as_many_numbers_as_points_give_the_spectrum_itself_on_a_short_band() {
        let band = Band::new(530.0, 560.0).unwrap();
        let values = fluorescent(band);
        let fit = Legendre::fit(&table(band, 31), &values, 31);
        assert_eq!(fit.stored().len(), 31);
        for (a, b) in fit.on_band().iter().zip(&values) {
            // What orthogonality may have lost.
            assert!((a - b).abs() < 31.0 * LOST_ORTHOGONALITY * 4.0);
        }
    }

    #[test]
    fn the_table_ends_where_the_recurrence_does() {
        let count = table(BAND, 401).count();
        // 121 where this was written; a different rounding may move it a little.
        assert!((110..=130).contains(&count), "{count}");
    }

    #[test]
    fn the_first_coefficient_is_the_mean() {
        let values = fluorescent(BAND);
        let fit = Legendre::fit(&table(BAND, 5), &values, 5);
        let mean = BAND.integral(&values) / BAND.length_nm();
        // A sum of 401 terms in another order.
        assert!((fit.coefficients[0] - mean).abs() < 1e-13);
    }
}
