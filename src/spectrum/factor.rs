//! Transmitting or reflecting factors: glass of any thickness, a surface met any number of times.

use super::{
    band::Band,
    line::GAUSSIAN_AREA,
    spikes::{SpikeSettings, dip_shapes},
};

/// Transmittance of another thickness of the same glass (Beer-Lambert): `T^(d/d0)`.
///
/// `values` are internal transmittances of the thickness `d0`; what noise put below 0 is 0. A
/// negative or absent ratio is no glass at all.
pub fn glass(values: &[f64], thickness_ratio: f64) -> Vec<f64> {
    let ratio = thickness_ratio.max(0.0);
    // A value above 1 (noise, a wrong unit) may not grow beyond all numbers.
    let through = |value: &f64| value.max(0.0).powf(ratio).min(f64::MAX);
    values.iter().map(through).collect()
}

/// Reflectance of `count` bounces off the same surface: `R^count`.
pub(crate) fn bounces(values: &[f64], count: u32) -> Vec<f64> {
    let count = i32::try_from(count).unwrap_or(i32::MAX);
    let off = |value: &f64| value.powi(count).clamp(-f64::MAX, f64::MAX);
    values.iter().map(off).collect()
}

/// An absorption line of a filter or surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Dip {
    /// Centroid, nm.
    pub at_nm: f64,
    /// Integral of the missing share, in share x nm; negative.
    pub weight: f64,
    /// Share of what would pass without it that is missing at its deepest, 0-1.
    pub depth: f64,
    /// Full width at half maximum of a Gaussian of that weight and of what is missing at its
    /// deepest, nm.
    pub width_nm: f64,
}

/// A transmittance or reflectance: shares on the 1 nm grid of a band.
#[derive(Clone, Debug, PartialEq)]
pub struct Factor {
    values: Vec<f64>,
    /// Curve that series are fitted to; the values themselves unless dips are kept.
    background: Option<Vec<f64>>,
    dips: Vec<Dip>,
}

impl Factor {
    /// A factor with its dips, if it has any, as part of the curve.
    pub fn new(values: Vec<f64>) -> Self {
        Self {
            values,
            background: None,
            dips: Vec::new(),
        }
    }

    /// A factor whose absorption lines are kept as spikes, found as `settings` say.
    ///
    /// The exact product on the 1 nm grid has them in the measured curve and needs no spikes.
    ///
    /// # Panics
    /// When `values` does not have [`Band::points`] entries.
    pub(crate) fn keeping_dips(band: Band, values: Vec<f64>, settings: SpikeSettings) -> Self {
        assert_eq!(values.len(), band.points(), "one value per grid point");
        let mut background = values.clone();
        let mut dips = Vec::new();
        for shape in dip_shapes(band, &values, settings) {
            shape.take_from(&mut background);
            let share = |(whole, missing): (&f64, &f64)| {
                let share = -missing / whole;
                if share.is_finite() { share } else { 0.0 }
            };
            let depth = background[shape.first..]
                .iter()
                .zip(&shape.residue)
                .map(share)
                .fold(0.0, f64::max);
            let deepest = shape
                .residue
                .iter()
                .fold(0.0_f64, |most, r| most.max(r.abs()));
            dips.push(Dip {
                width_nm: shape.spike.weight.abs() / (GAUSSIAN_AREA * deepest),
                at_nm: shape.spike.at_nm,
                weight: shape.spike.weight,
                depth: depth.min(1.0),
            });
        }
        dips.sort_by(|a, b| a.at_nm.total_cmp(&b.at_nm));
        Self {
            background: (!dips.is_empty()).then_some(background),
            values,
            dips,
        }
    }

    /// The measured shares on the grid.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// The measured shares without the dips that are kept.
    pub(crate) fn background(&self) -> &[f64] {
        self.background.as_deref().unwrap_or(&self.values)
    }

    /// The dips that are kept, by rising wavelength.
    pub(crate) fn dips(&self) -> &[Dip] {
        &self.dips
    }
}
