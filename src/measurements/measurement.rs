//! A measured table with what is known of its doubt.

use std::borrow::Cow;

use super::{kernel::Slit, quantity::Quantity};
use crate::spectrum::Sampled;

/// A measured table with what is known of its doubt; all but the table is optional.
#[derive(Clone, Debug, PartialEq)]
pub struct Measurement {
    /// Name.
    pub name: String,
    /// Quantity of the values.
    pub quantity: Quantity,
    /// Unit of the values; empty where it is not known.
    pub unit: String,
    /// The table; a sample that the mask leaves out holds 0.
    pub samples: Sampled,
    /// Standard deviation of the white part of the noise, one a sample, in the unit of the values.
    pub sigma: Option<Vec<f64>>,
    /// Relative standard error of one common factor; 0 where it is not known.
    pub level: f64,
    /// Standard error of one common shift of the axis, nm; 0 where it is not known.
    pub axis_nm: f64,
    /// Correlation of the noise at 1, 2, ... samples apart; empty where it is white.
    pub memory: Vec<f64>,
    /// Errors that all samples share, one standard deviation long: shares of the value, one a
    /// sample. What a known light was wrong by moves all that is corrected with it.
    pub shared: Vec<Vec<f64>>,
    /// Scans that it is the mean of.
    pub scans: Option<usize>,
    /// The slit that it was seen through.
    pub slit: Option<Slit>,
    /// Exposure, ms.
    pub exposure_ms: Option<f64>,
    /// True for samples without a value; empty where all have one.
    pub mask: Vec<bool>,
    /// Why they hold none, in words.
    pub why_masked: String,
}

/// A stretch without values.
#[derive(Clone, Debug, PartialEq)]
pub struct Masked {
    /// First wavelength without a value, nm.
    pub from_nm: f64,
    /// Last wavelength without a value, nm.
    pub to_nm: f64,
    pub why: String,
}

/// The letter of an input by its place: A, B, ...
pub fn letter(index: usize) -> char {
    // At most 26 inputs have letters; formulas name no others.
    char::from(b'A' + (index.min(25)) as u8)
}

impl Measurement {
    /// A table of which nothing else is known.
    pub fn new(name: &str, quantity: Quantity, unit: &str, samples: Sampled) -> Self {
        Self {
            name: name.to_owned(),
            quantity,
            unit: unit.to_owned(),
            samples,
            sigma: None,
            level: 0.0,
            axis_nm: 0.0,
            memory: Vec::new(),
            shared: Vec::new(),
            scans: None,
            slit: None,
            exposure_ms: None,
            mask: Vec::new(),
            why_masked: String::new(),
        }
    }

    /// True if a sample holds a value.
    pub fn is_kept(&self, index: usize) -> bool {
        !self.mask.get(index).copied().unwrap_or(false)
    }

    /// The same without the samples that hold no value: straight lines over gaps, nothing at ends
    /// that are masked.
    pub(super) fn bridged(&self) -> Cow<'_, Self> {
        let kept: Vec<usize> = (0..self.samples.len())
            .filter(|i| self.is_kept(*i))
            .collect();
        if kept.len() == self.samples.len() {
            return Cow::Borrowed(self);
        }
        let of = |values: &[f64]| -> Vec<f64> { kept.iter().map(|i| values[*i]).collect() };
        match Sampled::new(of(self.samples.nm()), of(self.samples.values())) {
            Ok(samples) => Cow::Owned(Self {
                samples,
                sigma: self.sigma.as_deref().map(of),
                shared: self.shared.iter().map(|s| of(s)).collect(),
                mask: Vec::new(),
                ..self.clone()
            }),
            // Fewer than two are kept: the mask's zeros are all there is.
            Err(_) => Cow::Borrowed(self),
        }
    }

    /// The values, `None` where masked.
    pub fn kept_values(&self) -> Vec<Option<f64>> {
        let values = self.samples.values().iter().enumerate();
        values
            .map(|(index, value)| self.is_kept(index).then_some(*value))
            .collect()
    }

    /// The stretches without values.
    pub fn masked(&self) -> Vec<Masked> {
        let nm = self.samples.nm();
        let mut found: Vec<Masked> = Vec::new();
        let mut is_open = false;
        for (index, at) in nm.iter().enumerate() {
            match (self.is_kept(index), is_open) {
                (false, false) => found.push(Masked {
                    from_nm: *at,
                    to_nm: *at,
                    why: self.why_masked.clone(),
                }),
                (false, true) => {
                    if let Some(last) = found.last_mut() {
                        last.to_nm = *at;
                    }
                }
                (true, _) => {}
            }
            is_open = !self.is_kept(index);
        }
        found
    }

    /// Sigma at a wavelength within the table, by straight lines; 0 where none is known.
    pub(super) fn sigma_at(&self, left: usize, share: f64) -> f64 {
        self.sigma.as_ref().map_or(0.0, |sigma| {
            // Two samples of noise of their own: their weighted sum has less than either.
            let (a, b) = (sigma[left] * (1.0 - share), sigma[left + 1] * share);
            a.hypot(b)
        })
    }
}
