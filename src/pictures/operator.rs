//! One linear operator a picture: `coefficients = E pixel`, `pixel = D coefficients`.
//!
//! D holds cosines over a range a little wider than the bands, multiplied by a shared reference
//! spectrum, then one column a line. E is a least-squares fit, for reflectances weighted by the
//! colours under many lights, for what a known light lit regularised by what reflectances usually
//! do, and repaired so that the own colour of every pixel is exact.

use nalgebra::{DMatrix, DVector};

use super::fitting::{columns, lit_fit, own_weights, plain_fit};
use super::light::{Rows, times};
use super::plan::{LEAST_NOISE, Plan, ReferenceKind};
use super::prior::prior;
use super::{Bands, Kernel, PictureError};
use crate::spectrum::ThreeSums;

/// Above this noise gain the order is lowered.
pub(super) const MOST_NOISE_GAIN: f64 = 1.5;

/// The matrices of a plan.
#[derive(Clone, Debug, PartialEq)]
pub struct Operator {
    pub(super) bands: Bands,
    pub(super) plan: Plan,
    pub(super) decode: DMatrix<f64>,
    pub(super) encode: DMatrix<f64>,
    pub(super) own: Rows,
    range_nm: [f64; 2],
    prior: Option<Vec<f64>>,
    is_exact: bool,
    noise_gain: f64,
}

/// Prior second moments of reflectances in the coefficients of a known light's series, or of two.
fn moments(bands: &Bands, plan: &Plan, range_nm: [f64; 2]) -> Result<Vec<f64>, PictureError> {
    let (one, two) = plan.shares();
    let first = prior(bands, range_nm, one)?;
    if two == 0 {
        return Ok(first);
    }
    let second = prior(bands, range_nm, two)?;
    Ok(first.into_iter().chain(second).map(|v| 0.25 * v).collect())
}

impl Operator {
    /// The operator of a plan.
    ///
    /// # Errors
    /// [`PictureError`] when there are too many or too few numbers, the own light is dark, or the
    /// bands do not tell the numbers apart.
    pub fn new(bands: &Bands, plan: &Plan) -> Result<Self, PictureError> {
        Self::with_range(bands, plan, plan.range_nm(bands))
    }

    /// The operator of a plan with the very range of a file, nm: any that covers the bands is legal.
    ///
    /// # Errors
    /// As [`Operator::new`].
    pub(super) fn with_range(
        bands: &Bands,
        plan: &Plan,
        range_nm: [f64; 2],
    ) -> Result<Self, PictureError> {
        let (found, most) = (plan.numbers(), bands.len() - 1);
        if found < 3 || found > most || plan.series < 1 {
            return Err(PictureError::Numbers { found, most });
        }
        let decode = columns(bands, plan, range_nm);
        let own = own_weights(bands, plan)?;
        let lit = plan.reference.kind == ReferenceKind::Light;
        let (fit, prior) = if lit {
            let moments = moments(bands, plan, range_nm)?;
            let noise = match plan.noise.is_finite() {
                true => plan.noise.max(1e-6),
                false => LEAST_NOISE,
            };
            let fit = lit_fit(bands, &decode, &moments, noise)?;
            (fit, Some(moments))
        } else {
            let weighting = plan.weighting.as_deref().filter(|_| bands.is_factor());
            (plain_fit(bands, weighting, &decode)?, None)
        };
        let mut operator = Self {
            bands: bands.clone(),
            plan: plan.clone(),
            decode,
            encode: fit.encode,
            own,
            range_nm,
            prior,
            is_exact: false,
            noise_gain: 0.0,
        };
        if plan.exact {
            operator.make_exact(&fit.inverse);
        }
        if operator.encode.iter().any(|v| !v.is_finite()) {
            return Err(PictureError::NotSolved);
        }
        // D = QR has the norm of R: no number for each pair of bands.
        let triangle = operator.decode.clone().qr().r();
        operator.noise_gain = (triangle * &operator.encode).norm() / (bands.len() as f64).sqrt();
        Ok(operator)
    }

    /// The operator of a plan, its order lowered until it does not amplify noise.
    ///
    /// # Errors
    /// As [`Operator::new`].
    pub(crate) fn steady(bands: &Bands, plan: &Plan) -> Result<Self, PictureError> {
        let mut plan = plan.clone();
        loop {
            let found = Self::new(bands, &plan)?;
            if found.noise_gain <= MOST_NOISE_GAIN || plan.series <= 2 || plan.numbers() <= 3 {
                return Ok(found);
            }
            plan.series -= 1;
        }
    }

    /// Adds the smallest correction that makes X, Y and Z of every pixel right.
    fn make_exact(&mut self, inverse: &DMatrix<f64>) {
        let bands = self.bands.len();
        let seen = DMatrix::from_fn(3, bands, |k, j| self.own[k][j]);
        let of_numbers = &seen * &self.decode;
        // The cost of a change is the fit's own: its inverse in two factors.
        let Some(factor) = inverse.clone().cholesky() else {
            return;
        };
        let factor = factor.unpack();
        let map = &of_numbers * &factor;
        let sums = ThreeSums::new(map.column_iter().map(|c| [c[0], c[1], c[2]]));
        // Twice: the second pass takes away what rounding left of the first.
        for _ in 0..2 {
            let missing = &seen - &of_numbers * &self.encode;
            for (band, missing) in missing.column_iter().enumerate() {
                let Some(change) = sums.change([missing[0], missing[1], missing[2]]) else {
                    return;
                };
                let change = DVector::from_iterator(factor.ncols(), change);
                let mut column = self.encode.column_mut(band);
                column += &factor * change;
            }
        }
        self.is_exact = true;
    }

    /// E, ready for many pixels.
    pub fn encoder(&self) -> Kernel {
        Kernel::new(self.encode.nrows(), self.encode.ncols(), |r, c| {
            self.encode[(r, c)]
        })
    }

    /// D, ready for many pixels.
    pub(crate) fn decoder(&self) -> Kernel {
        Kernel::new(self.decode.nrows(), self.decode.ncols(), |r, c| {
            self.decode[(r, c)]
        })
    }

    /// The bands.
    pub fn bands(&self) -> &Bands {
        &self.bands
    }

    /// The plan that it was made from.
    pub(crate) fn plan(&self) -> &Plan {
        &self.plan
    }

    /// First and last wavelength of the series, nm.
    pub(crate) fn range_nm(&self) -> [f64; 2] {
        self.range_nm
    }

    /// Numbers a pixel.
    pub fn numbers(&self) -> usize {
        self.decode.ncols()
    }

    /// One entry of E: what a band adds to a number.
    pub fn encode(&self, number: usize, band: usize) -> f64 {
        self.encode[(number, band)]
    }

    /// One entry of D: what a number adds to a band.
    pub fn decode(&self, band: usize, number: usize) -> f64 {
        self.decode[(band, number)]
    }

    /// Weights of the bands for the own X, Y, Z.
    pub fn own_weights(&self) -> &[Vec<f64>; 3] {
        &self.own
    }

    /// True if own colour is exact (it is not where the bands miss the visible).
    pub(crate) fn is_exact(&self) -> bool {
        self.is_exact
    }

    /// Second moments of what reflectances usually do, where a known light lit the picture.
    #[cfg(test)]
    pub(crate) fn prior(&self) -> Option<&[f64]> {
        self.prior.as_deref()
    }

    /// Ratio of the noise after decoding to the noise of the bands; below 1 noise is removed.
    pub(crate) fn noise_gain(&self) -> f64 {
        self.noise_gain
    }

    /// The numbers of one pixel.
    ///
    /// # Panics
    /// When there is not one value a band.
    pub fn numbers_of(&self, pixel: &[f64]) -> Vec<f64> {
        (&self.encode * DVector::from_column_slice(pixel))
            .as_slice()
            .to_vec()
    }

    /// The pixel of some numbers.
    ///
    /// # Panics
    /// When there are not as many as [`Operator::numbers`].
    pub(crate) fn pixel_of(&self, numbers: &[f64]) -> Vec<f64> {
        (&self.decode * DVector::from_column_slice(numbers))
            .as_slice()
            .to_vec()
    }

    /// Weights of the numbers for something that is a weighted sum of the bands.
    pub(super) fn of_numbers(&self, weights: &Rows) -> Rows {
        times(weights, &self.decode)
    }
}
