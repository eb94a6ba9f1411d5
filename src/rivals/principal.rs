//! A linear model: projection on the principal components of a training set.
//!
//! The components are uncentred: a mean spectrum would have to know the light's scale. Every
//! training spectrum counts the same, at unit norm under the trapezoid product
//! `<f, g> = sum w_i f_i g_i` (nm), and the rows are orthonormal under that product. The numbers
//! mean nothing without the rows, which are shared by all fits and not counted.

use std::sync::Arc;

use nalgebra::{DMatrix, SymmetricEigen};

use super::Representation;
use crate::spectrum::{Band, dot};

/// Share of the largest eigenvalue below which one has vanished: a few thousand roundings.
const VANISHED: f64 = 1e-12;

/// The rows that principal coefficients multiply.
#[derive(Clone, Debug, PartialEq)]
pub struct PrincipalBasis {
    band: Band,
    /// Rows of `band.points()` values, the strongest first, in nm^-1/2.
    rows: Vec<Vec<f64>>,
}

impl PrincipalBasis {
    /// The `most` strongest components of spectra given on the band's grid; fewer where the
    /// spectra span less. Zero spectra and those of another length are left out.
    pub(crate) fn train(band: Band, spectra: &[Vec<f64>], most: usize) -> Self {
        let units: Vec<Vec<f64>> = spectra
            .iter()
            .filter(|s| s.len() == band.points())
            .filter_map(|s| weighted_unit(band, s))
            .collect();
        if units.is_empty() {
            return Self::empty(band);
        }
        let directions = if units.len() <= band.points() {
            directions_by_gram(&units, most)
        } else {
            directions_by_covariance(&units, most)
        };
        let rows = orthonormal(directions);
        Self {
            band,
            rows: rows.into_iter().map(|row| unweighted(band, row)).collect(),
        }
    }

    /// A basis of no rows.
    pub(crate) fn empty(band: Band) -> Self {
        Self {
            band,
            rows: Vec::new(),
        }
    }

    /// The rows, the strongest first, orthonormal under the trapezoid product.
    pub(crate) fn rows(&self) -> &[Vec<f64>] {
        &self.rows
    }
}

/// Values times the root of the trapezoid weights, at unit length; `None` for an all-zero (or
/// not finite) spectrum. Under these roots the trapezoid product is an ordinary dot product.
fn weighted_unit(band: Band, values: &[f64]) -> Option<Vec<f64>> {
    let top = values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    if top == 0.0 || values.iter().any(|v| !v.is_finite()) {
        return None;
    }
    let weighted = values.iter().enumerate();
    let mut unit: Vec<f64> = weighted
        .map(|(i, v)| v / top * band.weight(i).sqrt())
        .collect();
    let length = dot(&unit, &unit).sqrt();
    unit.iter_mut().for_each(|v| *v /= length);
    Some(unit)
}

fn unweighted(band: Band, mut row: Vec<f64>) -> Vec<f64> {
    for (i, v) in row.iter_mut().enumerate() {
        *v /= band.weight(i).sqrt();
    }
    row
}

/// Components from the products of the spectra with one another: fewer spectra than points.
fn directions_by_gram(units: &[Vec<f64>], most: usize) -> Vec<Vec<f64>> {
    let count = units.len();
    let gram = DMatrix::from_fn(count, count, |i, j| dot(&units[i], &units[j]));
    let eigen = gram.symmetric_eigen();
    strongest(&eigen, most)
        .into_iter()
        .map(|k| {
            let mut row = vec![0.0; units[0].len()];
            for (share, unit) in eigen.eigenvectors.column(k).iter().zip(units) {
                row.iter_mut().zip(unit).for_each(|(r, u)| *r += share * u);
            }
            row
        })
        .collect()
}

/// Components from the products of the points with one another: more spectra than points.
fn directions_by_covariance(units: &[Vec<f64>], most: usize) -> Vec<Vec<f64>> {
    let spectra = DMatrix::from_fn(units[0].len(), units.len(), |i, j| units[j][i]);
    let eigen = (&spectra * spectra.transpose()).symmetric_eigen();
    strongest(&eigen, most)
        .into_iter()
        .map(|k| eigen.eigenvectors.column(k).iter().copied().collect())
        .collect()
}

/// Indices of the largest eigenvalues, without those that have vanished.
fn strongest(eigen: &SymmetricEigen<f64, nalgebra::Dyn>, most: usize) -> Vec<usize> {
    let values = &eigen.eigenvalues;
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*b].total_cmp(&values[*a]));
    let largest = order.first().map_or(0.0, |k| values[*k]);
    order.retain(|k| values[*k] > VANISHED * largest);
    order.truncate(most);
    order
}

/// Gram-Schmidt, twice over, because components of small eigenvalues come out of the Gram matrix
/// with the roundings of the large ones in them. The sign is fixed: each row's sum is positive.
fn orthonormal(directions: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let mut rows: Vec<Vec<f64>> = Vec::with_capacity(directions.len());
    for mut row in directions {
        for _ in 0..2 {
            for earlier in &rows {
                let share = dot(&row, earlier);
                row.iter_mut()
                    .zip(earlier)
                    .for_each(|(r, e)| *r -= share * e);
            }
            let length = dot(&row, &row).sqrt();
            row.iter_mut().for_each(|r| *r /= length);
        }
        let sign = row.iter().sum::<f64>().signum();
        row.iter_mut().for_each(|r| *r *= sign);
        rows.push(row);
    }
    rows
}

/// A spectrum as multiples of the basis rows.
#[derive(Clone, Debug)]
pub(crate) struct Principal {
    basis: Arc<PrincipalBasis>,
    /// In the spectrum's own unit x nm^1/2; none when the basis has no row.
    coefficients: Vec<f64>,
}

impl Principal {
    /// The projection on the first `numbers` rows, or as many as there are. A basis of another
    /// band has nothing to say about this one: no coefficient, zero everywhere.
    pub(super) fn fit(
        band: Band,
        basis: &Arc<PrincipalBasis>,
        values: &[f64],
        numbers: usize,
    ) -> Self {
        let basis = if basis.band == band {
            Arc::clone(basis)
        } else {
            Arc::new(PrincipalBasis::empty(band))
        };
        let rows = basis.rows.iter().take(numbers.max(1));
        Self {
            coefficients: rows.map(|row| band.inner(row, values)).collect(),
            basis,
        }
    }
}

impl Representation for Principal {
    fn band(&self) -> Band {
        self.basis.band
    }

    fn stored(&self) -> Vec<f64> {
        self.coefficients.clone()
    }

    fn scale(&mut self, factor: f64) {
        self.coefficients.iter_mut().for_each(|v| *v *= factor);
    }

    fn inside(&self, at_nm: f64) -> f64 {
        let rows = self.coefficients.iter().zip(&self.basis.rows);
        rows.map(|(c, row)| c * self.basis.band.interpolate(row, at_nm))
            .sum()
    }

    fn on_band(&self) -> Vec<f64> {
        let mut out = vec![0.0; self.basis.band.points()];
        for (c, row) in self.coefficients.iter().zip(&self.basis.rows) {
            out.iter_mut().zip(row).for_each(|(o, r)| *o += c * r);
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rivals::example_spectra::{fluorescent, leaf, thermal};

    const BAND: Band = Band::VISIBLE;

    fn blackbodies(band: Band) -> Vec<Vec<f64>> {
        (2..=20)
            .map(|k| thermal(band, 1000.0 * f64::from(k)))
            .collect()
    }

    fn worst(fit: &Principal, values: &[f64]) -> f64 {
        let differences = fit.on_band().into_iter().zip(values);
        differences.fold(0.0, |worst, (a, b)| worst.max((a - b).abs()))
    }

    #[test]
    fn rows_are_orthonormal_under_the_trapezoid_product() {
        // Blackbodies are nearly dependent: the hard case, where plain Gram rows are not.
        let basis = PrincipalBasis::train(BAND, &blackbodies(BAND), 31);
        for (i, a) in basis.rows().iter().enumerate() {
            for (j, b) in basis.rows().iter().enumerate() {
                let wanted = if i == j { 1.0 } else { 0.0 };
                // Sums of 401 terms.
                assert!((BAND.inner(a, b) - wanted).abs() < 1e-13);
            }
        }
    }

    #[test]
    fn rows_end_where_the_spectra_span_no_more() {
        let spectra = [thermal(BAND, 3000.0), leaf(BAND)];
        let twice: Vec<Vec<f64>> = spectra.iter().chain(&spectra).cloned().collect();
        assert_eq!(PrincipalBasis::train(BAND, &twice, 31).rows().len(), 2);
        assert!(
            PrincipalBasis::train(BAND, &blackbodies(BAND), 31)
                .rows()
                .len()
                < 12
        );
    }

    #[test]
    fn a_spectrum_of_the_training_set_comes_back_when_all_rows_are_used() {
        let spectra = blackbodies(BAND);
        let basis = Arc::new(PrincipalBasis::train(BAND, &spectra, 31));
        for values in &spectra {
            let top = values.iter().fold(0.0_f64, |m, v| m.max(*v));
            // What lies in eigenvalues below the cut: its root, for 19 spectra.
            let cut = (19.0 * VANISHED).sqrt();
            assert!(worst(&Principal::fit(BAND, &basis, values, 31), values) < cut * top * 3.0);
        }
    }

    #[test]
    fn a_blackbody_between_those_trained_on_needs_five_numbers() {
        let basis = Arc::new(PrincipalBasis::train(BAND, &blackbodies(BAND), 5));
        let values = thermal(BAND, 3500.0);
        let fit = Principal::fit(BAND, &basis, &values, 5);
        assert_eq!(fit.stored().len(), 5);
        // Under a thousandth of its largest value, about 2.
        assert!(worst(&fit, &values) < 2e-3);
    }

    #[test]
    fn more_spectra_than_points_give_the_same_rows_as_their_like_once() {
        let band = Band::new(540.0, 560.0).unwrap();
        let once = vec![fluorescent(band), leaf(band), thermal(band, 3000.0)];
        let often: Vec<Vec<f64>> = once.iter().cycle().take(30).cloned().collect();
        let few = PrincipalBasis::train(band, &once, 3);
        let many = PrincipalBasis::train(band, &often, 3);
        for (a, b) in few.rows().iter().zip(many.rows()) {
            for (a, b) in a.iter().zip(b) {
                // Rounding over the root of the smallest eigenvalue's share, 1e-4.
                assert!((a - b).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn the_strength_of_a_training_spectrum_does_not_matter() {
        let spectra = blackbodies(BAND);
        let mut uneven = spectra.clone();
        uneven[3].iter_mut().for_each(|v| *v *= 1e200);
        let (a, b) = (
            PrincipalBasis::train(BAND, &spectra, 3),
            PrincipalBasis::train(BAND, &uneven, 3),
        );
        for (a, b) in a.rows().iter().flatten().zip(b.rows().iter().flatten()) {
            // A rounding, over the third eigenvalue's share of about 1e-3.
            assert!((a - b).abs() < 1e-11);
        }
    }

    #[test]
    fn zero_spectra_and_those_of_another_length_are_left_out() {
        let spectra = vec![vec![0.0; 401], vec![1.0; 7], vec![1.0; 401]];
        assert_eq!(PrincipalBasis::train(BAND, &spectra, 31).rows().len(), 1);
        assert_eq!(
            PrincipalBasis::train(BAND, &[], 31),
            PrincipalBasis::empty(BAND)
        );
    }

    #[test]
    fn a_basis_of_another_band_or_of_no_row_says_nothing() {
        let elsewhere = Arc::new(PrincipalBasis::train(Band::PAPER, &[vec![1.0; 301]], 5));
        for basis in [elsewhere, Arc::new(PrincipalBasis::empty(BAND))] {
            let fit = Principal::fit(BAND, &basis, &[1.0; 401], 5);
            assert!(fit.stored().is_empty());
            assert_eq!(fit.on_band(), [0.0; 401]);
        }
    }
}
