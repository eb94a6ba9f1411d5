//! Lights whose values count photons, as power: colours, errors and models are of power.
//!
//! A photon of wavelength `l` carries `h c / l`, so that a µmol of them a second is
//! `119.627 / l` W with `l` in nm. Files say photons by their unit (µmol m-2 s-1 nm-1, µE/m2/s/nm);
//! readers leave such numbers alone, and whoever opens the file for its light turns them here.

use super::spectral_unit::{Counted, SpectralUnit};
pub(super) use crate::color::quality::JOULE_NM_PER_MICROMOLE;
use crate::spectrum::{Kind, NamedSpectrum};

/// Whether a spectrum is a light whose values count photons per nm.
pub(super) fn counts_photons(spectrum: &NamedSpectrum) -> bool {
    unit_of(spectrum).is_some()
}

fn unit_of(spectrum: &NamedSpectrum) -> Option<SpectralUnit> {
    let unit = SpectralUnit::of(&spectrum.unit)?;
    let counts = unit.counted == Counted::Micromoles && unit.per_nm;
    (counts && spectrum.kind == Kind::Light).then_some(unit)
}

/// Turns photons into power: W per what the photons were per. Other spectra stay as they are.
pub(super) fn to_power(spectrum: &mut NamedSpectrum) {
    let Some(unit) = unit_of(spectrum) else {
        return;
    };
    let samples = &spectrum.samples;
    let power = |(nm, value): (&f64, &f64)| value * unit.factor * JOULE_NM_PER_MICROMOLE / nm;
    let values = samples.nm().iter().zip(samples.values()).map(power);
    // Values near the largest double might overflow; such a table is left alone.
    let Ok(samples) = samples.sharing(values.collect()) else {
        return;
    };
    spectrum.samples = samples;
    spectrum.notes.push(format!(
        "photons turned into power: each value in {} times {} / wavelength in nm",
        spectrum.unit,
        super::ticks::short(unit.factor * JOULE_NM_PER_MICROMOLE)
    ));
    spectrum.unit = SpectralUnit {
        counted: Counted::Watts,
        factor: 1.0,
        ..unit
    }
    .words();
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
    fn power_and_what_is_no_light_stays_as_it_is() {
        let filter = NamedSpectrum {
            kind: Kind::Transmittance,
            ..light("µmol m-2 s-1 nm-1")
        };
        for spectrum in [
            light("W m-2 nm-1"),
            light("µmol m-2 s-1"),
            light(""),
            filter,
        ] {
            let mut turned = spectrum.clone();
            to_power(&mut turned);
            assert_eq!(turned, spectrum);
        }
    }
}
