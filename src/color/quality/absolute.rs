//! Absolute figures of a light: lux and the like, and photons.

use super::{
    light::Light,
    no_figure::NoFigure,
    photometry::{LUMENS_PER_WATT, photopic_sum},
    photons::photon_sums,
};

/// Radiometric meaning of a light's values, each per nm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Radiometric {
    /// W m-2 nm-1.
    Irradiance,
    /// W m-2 sr-1 nm-1.
    Radiance,
    /// W nm-1.
    Power,
    /// W sr-1 nm-1.
    Intensity,
}

/// Quantity and unit of a light's values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// The quantity.
    pub what: Radiometric,
    /// Factor that converts a value to the quantity's unit of W, m, sr and nm.
    pub factor: f64,
}

impl Radiometric {
    /// Unit of its photometric counterpart.
    pub(crate) fn photometric_unit(self) -> &'static str {
        match self {
            Self::Irradiance => "lx",
            Self::Radiance => "cd/m²",
            Self::Power => "lm",
            Self::Intensity => "cd",
        }
    }

    /// Name of its photometric counterpart.
    pub(crate) fn photometric_name(self) -> &'static str {
        match self {
            Self::Irradiance => "illuminance",
            Self::Radiance => "luminance",
            Self::Power => "luminous flux",
            Self::Intensity => "luminous intensity",
        }
    }
}

/// Absolute figures of a light with a unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Absolute {
    /// The quantity measured.
    pub what: Radiometric,
    /// Lux for an irradiance; cd/m², lm or cd else.
    pub photometric: f64,
    /// Watts (per m2, sr) over 360-830 nm.
    pub radiometric: f64,
    /// Photons of 400-700 nm, µmol a second (per m2, sr).
    pub ppfd: f64,
    /// Photons of 400-750 nm.
    pub eppfd: f64,
}

/// Computes the absolute figures of a light whose values are `measured`.
///
/// # Errors
/// [`NoFigure`] when there is no light, the unit does not say what is measured, or the numbers are
/// too large.
pub fn absolute(light: &Light, measured: Option<Measured>) -> Result<Absolute, NoFigure> {
    let light = light.lit()?;
    let Measured { what, factor } = measured.ok_or(NoFigure::NoUnit)?;
    let unit = light.scale() * factor;
    let [ppfd, eppfd] = photon_sums(light);
    let found = Absolute {
        what,
        photometric: LUMENS_PER_WATT * unit * photopic_sum(light),
        radiometric: unit * light.power(),
        ppfd: unit * ppfd,
        eppfd: unit * eppfd,
    };
    let all = [
        found.photometric,
        found.radiometric,
        found.ppfd,
        found.eppfd,
    ];
    if all.iter().all(|v| v.is_finite()) {
        Ok(found)
    } else {
        Err(NoFigure::OutOfRange {
            what: later!("the values are too large for a sum"),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spectrum::Line;

    #[test]
    fn absolute_values_need_a_unit() {
        let light = Light::of_line(Line::ideal(555.0, 0.25));
        assert_eq!(absolute(&light, None), Err(NoFigure::NoUnit));
        let measured = Measured {
            what: Radiometric::Irradiance,
            factor: 1e-3,
        };
        let found = absolute(&light, Some(measured)).unwrap();
        // A quarter of a mW of light at the peak; products of a few numbers.
        assert!((found.photometric - 0.25e-3 * 683.002).abs() < 1e-15);
        assert!((found.radiometric - 0.25e-3).abs() < 1e-18);
    }
}
