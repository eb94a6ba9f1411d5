//! Lights whose values count photons, as power: colours, errors and models are of power.
//!
//! A photon of wavelength `l` carries `h c / l`, so that a µmol of them a second is
//! `119.627 / l` W with `l` in nm. Files say photons by their unit (µmol m-2 s-1 nm-1, µE/m2/s/nm,
//! photons/s/cm2/nm) or by the title alone; readers leave such numbers alone, and whoever opens the
//! file for its light turns them here.

use super::spectral_unit::{Counted, SpectralUnit};
pub(super) use crate::color::quality::JOULE_NM_PER_MICROMOLE;
use crate::io;
use crate::spectrum::{Kind, NamedSpectrum};

/// The wavelength, nm, whose photons keep their number where their unit does not tell their power:
/// where the eye is most sensitive.
const KEPT_NM: f64 = 555.0;

/// Whether a spectrum is a light whose values count photons.
pub(super) fn counts_photons(spectrum: &NamedSpectrum) -> bool {
    power_of(spectrum).is_some()
}

/// What photons are multiplied by for power, before that is divided by the wavelength in nm, and the
/// unit of the power: none where theirs does not say how many they are in what time.
fn power_of(spectrum: &NamedSpectrum) -> Option<(f64, String)> {
    if spectrum.kind != Kind::Light {
        return None;
    }
    match SpectralUnit::of(&spectrum.unit) {
        Some(unit) if unit.counted == Counted::Micromoles => {
            let power = SpectralUnit {
                counted: Counted::Watts,
                factor: 1.0,
                ..unit
            };
            Some((unit.factor * JOULE_NM_PER_MICROMOLE, power.words()))
        }
        Some(_) => None,
        None => io::counts_photons(&spectrum.unit).then(|| (KEPT_NM, String::new())),
    }
}

/// Turns photons into power: W per what the photons were per. Other spectra stay as they are.
pub(super) fn to_power(spectrum: &mut NamedSpectrum) {
    let Some((factor, unit)) = power_of(spectrum) else {
        return;
    };
    let samples = &spectrum.samples;
    let power = |(nm, value): (&f64, &f64)| value * factor / nm;
    let values = samples.nm().iter().zip(samples.values()).map(power);
    // Values near the largest double might overflow; such a table is left alone.
    let Ok(samples) = samples.sharing(values.collect()) else {
        return;
    };
    spectrum.samples = samples;
    spectrum.notes.push(tr!(
        "photons turned into power: each value in {unit} times {factor} / wavelength in nm",
        unit = spectrum.unit,
        factor = super::ticks::short(factor)
    ));
    spectrum.unit = unit;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spectrum::Sampled;

    fn light(unit: &str) -> NamedSpectrum {
        NamedSpectrum {
            name: "a".to_owned(),
            kind: Kind::Light,
            unit: unit.to_owned(),
            scale: 1.0,
            samples: Sampled::even(400.0, 200.0, vec![1.0, 2.0]).expect("two points"),
            notes: Vec::new(),
            source: String::new(),
        }
    }

    #[test]
    fn a_photon_of_half_the_wavelength_carries_twice_the_power() {
        for unit in ["µmol m-2 s-1 nm-1", "µE/m2/s/nm", "umol/(m² s nm)"] {
            let mut spectrum = light(unit);
            assert!(counts_photons(&spectrum), "{unit}");
            to_power(&mut spectrum);
            // 119.6266 J nm / µmol: the SI's h c N_A = 0.119 626 565 8 J m / mol.
            let values = spectrum.samples.values();
            assert!(
                (values[0] - 119.626_565_8 / 400.0).abs() < 1e-9,
                "{values:?}"
            );
            assert!((values[1] - 2.0 * 119.626_565_8 / 600.0).abs() < 1e-9);
            assert_eq!(spectrum.unit, "W m-2 nm-1");
            assert!(spectrum.notes[0].contains("photons turned into power"));
            assert_eq!(spectrum.notes.len(), 1);
        }
    }

    #[test]
    fn photons_are_known_in_every_spelling_and_without_a_band_or_a_time() {
        for (unit, at_400, power) in [
            // A photon of 400 nm: 6.626 070 15e-34 x 299 792 458 / 4e-7 J.
            ("photons/s/m2/nm", 4.966_114_6e-19, "W m-2 nm-1"),
            ("1e15 photons/s/cm2/nm", 4.966_114_6, "W m-2 nm-1"),
            ("quanta/cm2/s/nm", 4.966_114_6e-15, "W m-2 nm-1"),
            ("µmol m-2 s-1", 0.299_066_414_5, "W m-2"),
            ("nmol/m2/s/nm", 0.299_066_414_5e-3, "W m-2 nm-1"),
            ("photons", 555.0 / 400.0, ""),
            ("photons/cm2/nm", 555.0 / 400.0, ""),
        ] {
            let mut spectrum = light(unit);
            to_power(&mut spectrum);
            let value = spectrum.samples.values()[0];
            assert!((value / at_400 - 1.0).abs() < 1e-7, "{unit}: {value}");
            assert_eq!(spectrum.unit, power, "{unit}");
        }
    }

    #[test]
    fn power_and_what_is_no_light_stays_as_it_is() {
        let filter = NamedSpectrum {
            kind: Kind::Transmittance,
            ..light("µmol m-2 s-1 nm-1")
        };
        for spectrum in [light("W m-2 nm-1"), light(""), filter] {
            let mut turned = spectrum.clone();
            to_power(&mut turned);
            assert_eq!(turned, spectrum);
        }
    }
}
