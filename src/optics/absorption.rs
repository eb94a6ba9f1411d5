//! Loss along a path through a body.

use crate::{
    languages::with_sign,
    spectrum::{Outside, Sampled},
};

/// A transmittance below this counts as this: what lets nothing through has no coefficient.
const LEAST_TRANSMITTANCE: f64 = 1e-6;

/// Absorption of a body per unit of length: `exp(-a d)` is left after a path `d`.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Absorption {
    /// Clear.
    #[default]
    None,
    /// The same at every wavelength, per unit of length.
    Even(f64),
    /// From the transmittance of a known thickness.
    Filter {
        /// Coefficients, per unit of length.
        coefficients: Sampled,
        /// True if some transmittance was so low that 1e-6 was taken for it.
        floored: bool,
    },
}

/// Why there is no absorption.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum AbsorptionError {
    /// A coefficient that is negative or not finite.
    #[error(
        "{}",
        tr!(
            "absorption: expected a number from 0 to 1e6 per unit of length, found {found}",
            found = with_sign(found.to_string())
        )
    )]
    Coefficient { found: f64 },
    /// A thickness that is not above 0.
    #[error(
        "{}",
        tr!(
            "thickness: expected a length above 0, up to 1e6, found {found}",
            found = with_sign(found.to_string())
        )
    )]
    Thickness { found: f64 },
}

impl Absorption {
    /// The same coefficient at every wavelength.
    ///
    /// # Errors
    /// For a coefficient that is negative, above 1e6 or not a number.
    pub fn even(per_unit: f64) -> Result<Self, AbsorptionError> {
        if !(0.0..=1e6).contains(&per_unit) {
            return Err(AbsorptionError::Coefficient { found: per_unit });
        }
        if per_unit == 0.0 {
            return Ok(Self::None);
        }
        Ok(Self::Even(per_unit))
    }

    /// `a = -ln(transmittance) / thickness` at the table's wavelengths, straight between, its ends
    /// held. Transmittances above 1 are 1, those below 1e-6 are 1e-6 ([`Absorption::is_floored`]).
    ///
    /// # Errors
    /// For a thickness that is not above 0.
    pub(crate) fn of_filter(
        transmittance: &Sampled,
        thickness: f64,
    ) -> Result<Self, AbsorptionError> {
        let refused = AbsorptionError::Thickness { found: thickness };
        if !(thickness > 0.0 && thickness <= 1e6) {
            return Err(refused);
        }
        let values = transmittance.values();
        let coefficient = |tau: &f64| -tau.clamp(LEAST_TRANSMITTANCE, 1.0).ln() / thickness;
        // A thickness near zero leaves no finite number.
        let coefficients = values.iter().map(coefficient).collect();
        let coefficients = transmittance.sharing(coefficients).map_err(|_| refused)?;
        Ok(Self::Filter {
            coefficients,
            floored: values.iter().any(|tau| *tau < LEAST_TRANSMITTANCE),
        })
    }

    /// Coefficient at a wavelength, per unit of length.
    pub fn at(&self, at_nm: f64) -> f64 {
        match self {
            Self::None => 0.0,
            Self::Even(a) => *a,
            Self::Filter { coefficients, .. } => coefficients.at(at_nm, Outside::Hold),
        }
    }

    /// True if some transmittance was so low that 1e-6 was taken for it.
    pub(crate) fn is_floored(&self) -> bool {
        matches!(self, Self::Filter { floored: true, .. })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_filter_of_its_own_thickness_lets_through_what_it_says() {
        let glass = Sampled::new(vec![400.0, 500.0, 600.0], vec![0.9, 0.5, 0.0]).unwrap();
        let loss = Absorption::of_filter(&glass, 2.0).unwrap();
        for (nm, left) in [(400.0, 0.9), (500.0, 0.5), (600.0, 1e-6), (900.0, 1e-6)] {
            assert!(
                ((-2.0 * loss.at(nm)).exp() / left - 1.0).abs() < 1e-12,
                "{nm}"
            );
        }
        assert!(loss.is_floored());
    }

    #[test]
    fn what_is_no_absorption_is_refused_in_words() {
        let said = |a: f64| Absorption::even(a).unwrap_err().to_string();
        assert_eq!(
            said(-1.0),
            "absorption: expected a number from 0 to 1e6 per unit of length, found -1"
        );
        assert!(Absorption::even(f64::NAN).is_err());
        assert_eq!(Absorption::even(0.0).unwrap(), Absorption::None);
        let glass = Sampled::new(vec![400.0, 500.0], vec![0.9, 0.5]).unwrap();
        for thickness in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(Absorption::of_filter(&glass, thickness).is_err());
        }
    }
}
