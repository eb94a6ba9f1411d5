//! What is known of a measurement beside its values, as JSON of workspaces, projects and spectra.

use serde::{Deserialize, Serialize};

use crate::{
    measurements::{Measurement, Quantity, Slit},
    spectrum::{NamedSpectrum, Sampled},
};

/// Sigma, mask and the rest, beside a spectrum that holds the values.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct StoredDoubt {
    /// One a sample, those without a value among them.
    #[serde(skip_serializing_if = "Option::is_none")]
    sigma: Option<Vec<f64>>,
    level: f64,
    axis_nm: f64,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    memory: Vec<f64>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    shared: Vec<Vec<f64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    scans: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    slit: Option<Slit>,
    #[serde(skip_serializing_if = "Option::is_none")]
    exposure_ms: Option<f64>,
    /// Wavelengths of the samples without a value.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    masked_nm: Vec<f64>,
    #[serde(skip_serializing_if = "String::is_empty")]
    why_masked: String,
}

impl StoredDoubt {
    pub fn of(of: &Measurement) -> Self {
        let nm = of.samples.nm().iter().enumerate();
        let masked = nm.filter(|(i, _)| !of.is_kept(*i)).map(|(_, nm)| *nm);
        Self {
            sigma: of.sigma.clone(),
            level: of.level,
            axis_nm: of.axis_nm,
            memory: of.memory.clone(),
            shared: of.shared.clone(),
            scans: of.scans,
            slit: of.slit,
            exposure_ms: of.exposure_ms,
            masked_nm: masked.collect(),
            why_masked: of.why_masked.clone(),
        }
    }

    /// The measurement whose values a spectrum holds; `None` where it is none of that spectrum.
    pub fn on(self, spectrum: &NamedSpectrum, quantity: Quantity) -> Option<Measurement> {
        let pairs = spectrum.samples.nm().iter().zip(spectrum.samples.values());
        let kept = pairs.map(|(nm, v)| (*nm, *v, false));
        let masked = self.masked_nm.iter().map(|nm| (*nm, 0.0, true));
        let mut all: Vec<(f64, f64, bool)> = kept.chain(masked).collect();
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (nm, rest): (Vec<f64>, Vec<(f64, bool)>) =
            all.into_iter().map(|(nm, v, m)| (nm, (v, m))).unzip();
        let (values, mask): (Vec<f64>, Vec<bool>) = rest.into_iter().unzip();
        let points = nm.len();
        let is_sound = |list: &Vec<f64>| list.len() == points && list.iter().all(|v| v.is_finite());
        let is_positive = |v: f64| v.is_finite() && v >= 0.0;
        let sigma_is_sound = self.sigma.as_ref().is_none_or(is_sound);
        let sigma = self.sigma.filter(|s| s.iter().all(|v| *v >= 0.0));
        let slit_is_sound = self.slit.is_none_or(|slit| slit.fwhm_nm > 0.0);
        if !(sigma_is_sound
            && slit_is_sound
            && self.shared.iter().all(is_sound)
            && self.memory.iter().all(|rho| rho.abs() <= 1.0)
            && is_positive(self.level)
            && is_positive(self.axis_nm))
        {
            return None;
        }
        let samples = Sampled::new(nm, values).ok()?;
        let mut found = Measurement::new(&spectrum.name, quantity, &spectrum.unit, samples);
        found.sigma = sigma;
        (found.level, found.axis_nm) = (self.level, self.axis_nm);
        (found.memory, found.shared) = (self.memory, self.shared);
        (found.scans, found.slit) = (self.scans, self.slit);
        found.exposure_ms = self.exposure_ms;
        if mask.contains(&true) {
            (found.mask, found.why_masked) = (mask, self.why_masked);
        }
        Some(found)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{app::measured::spectrum, measurements::Kernel};

    #[test]
    fn all_that_is_known_comes_back_to_the_bit_and_what_is_of_another_grid_does_not() {
        let samples = Sampled::even(400.0, 0.7, vec![1.0, 0.0, 1.0 / 3.0, 2.0]).expect("finite");
        let mut of = Measurement::new("lamp", Quantity::Light, "W m-2 nm-1", samples);
        of.sigma = Some(vec![0.1, 0.0, 1.0 / 7.0, 0.2]);
        of.mask = vec![false, true, false, false];
        of.why_masked = "The reference is below 10 of its noise".to_owned();
        (of.level, of.axis_nm, of.scans) = (0.01, 0.1, Some(5));
        of.memory = vec![0.5, 1.0 / 3.0];
        of.shared = vec![vec![0.0, 0.1, 0.2, -0.3]];
        of.exposure_ms = Some(30.0);
        of.slit = Some(Slit {
            shape: Kernel::Gauss,
            fwhm_nm: 7.5,
        });
        let text = serde_json::to_string(&StoredDoubt::of(&of)).expect("JSON");
        let back: StoredDoubt = serde_json::from_str(&text).expect("JSON");
        let named = spectrum(&of, "");
        assert_eq!(back.clone().on(&named, Quantity::Light), Some(of));
        let longer = NamedSpectrum {
            samples: Sampled::even(400.0, 1.0, vec![1.0; 9]).expect("finite"),
            ..named
        };
        assert_eq!(back.on(&longer, Quantity::Light), None);
    }
}
