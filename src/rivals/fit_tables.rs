//! Tables shared by the fits of one band, computed once.

use std::sync::Arc;

use super::{
    Bins, Bounds, Family, Legendre, Moments, Principal, PrincipalBasis, Representation, Rival,
    Samples, Wavelet, legendre::PolynomialTable, phases::PhaseTable, wavelet::WaveletTable,
};
use crate::spectrum::Band;

/// The tables of one band: polynomials, phases, wavelet norms. Cheap to share, never changed.
#[derive(Clone, Debug)]
pub(crate) struct FitTables {
    band: Band,
    polynomials: Arc<PolynomialTable>,
    phases: Arc<PhaseTable>,
    wavelets: Arc<WaveletTable>,
}

impl FitTables {
    /// Tables for fits of up to `most` numbers; cut to what the band's grid carries.
    ///
    /// Takes memory for `4 most` values a grid point.
    pub(crate) fn new(band: Band, most: usize) -> Self {
        Self {
            band,
            polynomials: Arc::new(PolynomialTable::new(band, most)),
            phases: Arc::new(PhaseTable::new(band, most)),
            wavelets: Arc::new(WaveletTable::new(band)),
        }
    }

    /// Fits values on the band's 1 nm grid (in the spectrum's own unit) with `numbers` numbers.
    ///
    /// A count that a family cannot have is brought to the nearest it can: at least one (a wavelet:
    /// two, place and value), at most the grid's points (a wavelet: all its coefficients), for
    /// polynomial and moments at most the tables' own, for principal components at most the rows of
    /// `basis`, which no other family looks at. An odd count leaves a wavelet one unused.
    /// [`Rival::numbers`] tells what was taken.
    ///
    /// # Panics
    /// When `values` does not have [`Band::points`] entries.
    pub(crate) fn fit(
        &self,
        family: Family,
        values: &[f64],
        numbers: usize,
        bounds: Bounds,
        basis: &Arc<PrincipalBasis>,
    ) -> Rival {
        assert_eq!(values.len(), self.band.points(), "one value per grid point");
        // A reflectance's own unit matters to its moments: it is bounded by 1.
        let height = match (family, bounds) {
            (Family::Moments, Bounds::Reflectance) => 1.0,
            _ => height(values),
        };
        let unit: Vec<f64> = values.iter().map(|v| v / height).collect();
        let mut fitted: Box<dyn Representation> = match family {
            Family::Samples => Box::new(Samples::fit(self.band, &unit, numbers)),
            Family::Bins => Box::new(Bins::fit(self.band, &unit, numbers)),
            Family::Legendre => Box::new(Legendre::fit(&self.polynomials, &unit, numbers)),
            Family::Principal => Box::new(Principal::fit(self.band, basis, &unit, numbers)),
            Family::Moments => Box::new(Moments::fit(&self.phases, &unit, numbers, bounds)),
            Family::Wavelet => Box::new(Wavelet::fit(&self.wavelets, &unit, numbers)),
        };
        fitted.scale(height);
        Rival(fitted)
    }
}

/// The power of two next to the largest absolute value, 1 for an all-zero spectrum. Values as
/// shares of it cannot overflow or vanish when squared, and a power of two costs no rounding.
fn height(values: &[f64]) -> f64 {
    let top = values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let power = top.log2().floor().exp2();
    if power.is_finite() && power > 0.0 {
        power
    } else {
        1.0
    }
}
