//! From a spectrum of a file or of the library to the light that figures are of.

use std::borrow::Cow;

use crate::{
    app::{
        photons,
        spectral_unit::{Counted, SpectralUnit},
    },
    color::quality::{Light, Measured, Radiometric},
    spectrum::NamedSpectrum,
};

/// A measured light, and what its values measure where their unit says so. Values that count
/// photons are turned into power.
pub fn light_of(spectrum: &NamedSpectrum) -> (Light, Option<Measured>) {
    let mut spectrum = Cow::Borrowed(spectrum);
    if photons::counts_photons(&spectrum) {
        photons::to_power(spectrum.to_mut());
    }
    (
        Light::of_sampled(&spectrum.samples),
        measured_in(&spectrum.unit),
    )
}

/// What values in a unit measure; `None` where it is no power per nm.
pub fn measured_in(unit: &str) -> Option<Measured> {
    let SpectralUnit {
        counted,
        factor,
        per_area,
        per_nm,
        per_steradian,
    } = SpectralUnit::of(unit)?;
    let what = match (per_area, per_steradian) {
        (true, false) => Radiometric::Irradiance,
        (true, true) => Radiometric::Radiance,
        (false, false) => Radiometric::Power,
        (false, true) => Radiometric::Intensity,
    };
    (counted == Counted::Watts && per_nm).then_some(Measured { what, factor })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        color::quality::Figures,
        spectrum::{Kind, Sampled},
    };

    #[test]
    fn a_unit_says_what_is_measured_or_nothing() {
        for (unit, what, factor) in [
            ("W m-2 nm-1", Radiometric::Irradiance, 1.0),
            ("mW m-2 nm-1", Radiometric::Irradiance, 1e-3),
            ("µW/cm²/nm", Radiometric::Irradiance, 1e-2),
            ("W m-2 sr-1 nm-1", Radiometric::Radiance, 1.0),
            ("mW/nm", Radiometric::Power, 1e-3),
            ("W sr-1 nm-1", Radiometric::Intensity, 1.0),
        ] {
            let found = measured_in(unit).unwrap_or_else(|| panic!("{unit}"));
            assert_eq!(found.what, what, "{unit}");
            // Products of powers of ten.
            assert!((found.factor / factor - 1.0).abs() < 1e-12, "{unit}");
        }
        for unit in ["relative", "", "counts", "W m-2", "µmol m-2 s-1 nm-1"] {
            assert_eq!(measured_in(unit), None, "{unit}");
        }
    }

    #[test]
    fn photons_are_weighed_as_the_power_that_they_are() {
        let of = |unit: &str, values: Vec<f64>| {
            let spectrum = NamedSpectrum {
                name: "a".to_owned(),
                kind: Kind::Light,
                unit: unit.to_owned(),
                scale: 1.0,
                samples: Sampled::even(400.0, 100.0, values).expect("finite values"),
                notes: Vec::new(),
                source: String::new(),
            };
            let (light, measured) = light_of(&spectrum);
            let figures = Figures::of(&light, measured);
            figures.absolute.expect("lux").photometric
        };
        let photons = [1.0, 2.0, 3.0, 1.0];
        let power = [400.0, 500.0, 600.0, 700.0].map(|nm| photons::JOULE_NM_PER_MICROMOLE / nm);
        let power = power.iter().zip(photons).map(|(p, n)| p * n);
        let of_photons = of("µmol m-2 s-1 nm-1", photons.to_vec());
        assert_eq!(of_photons, of("W m-2 nm-1", power.collect()));
    }
}
