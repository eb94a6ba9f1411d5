//! The product of the light with one patch, as measured and by the model.

use super::{derived::Derived, tables::PatchTables};
use crate::spectrum::{Line, Sampling, Series, product::resampled};

/// The model off a surface on the grid, lines that have a width with it, and its ideal lines.
fn times_on_grid(derived: &Derived, reflectance: &[f64]) -> (Vec<f64>, Vec<Line>) {
    let mut values = derived.outline();
    values
        .iter_mut()
        .zip(reflectance)
        .for_each(|(v, r)| *v *= r);
    let weighed = derived.ideal_spikes().into_iter().map(|spike| Line {
        weight: spike.weight * derived.band.interpolate(reflectance, spike.at_nm),
        ..spike
    });
    (values, weighed.collect())
}

/// The product of the light with one patch, exact and by the model.
#[derive(Clone, Debug, PartialEq)]
pub struct ProductView {
    /// The patch's name.
    pub name: String,
    /// The patch's reflectance on the grid.
    pub reflectance: Vec<f64>,
    /// Measured light times reflectance on the grid.
    pub exact: Vec<f64>,
    /// The model's product without its spikes, on the grid.
    pub smooth: Vec<f64>,
    /// The spikes, weighed by the reflectance where they stand.
    pub spikes: Vec<Line>,
    /// How the product was formed.
    pub sampling: Sampling,
}

impl ProductView {
    /// The product with patch `index`, formed as `sampling` says; `None` for a patch that is not
    /// there.
    pub fn of(
        derived: &Derived,
        patches: &PatchTables,
        index: usize,
        sampling: Sampling,
    ) -> Option<Self> {
        let reflectance = patches.reflectances.get(index)?;
        let (smooth, spikes) = match sampling {
            Sampling::Exact => times_on_grid(derived, reflectance),
            Sampling::Paper
            | Sampling::ThreeN
            | Sampling::FourN
            | Sampling::Double
            | Sampling::Convolution => {
                let numbers = derived.model.smooth().coefficients.len();
                let factor = Series {
                    coefficients: patches.coefficients[index][..numbers].to_vec(),
                    ..derived.model.smooth().clone()
                };
                let (smooth, spikes) =
                    resampled(&derived.model.idealised(), &factor, sampling).into_parts();
                (smooth.on_band(), spikes)
            }
        };
        let exact = derived.measured.iter().zip(reflectance);
        Some(Self {
            name: patches.set.names().get(index)?.clone(),
            reflectance: reflectance.clone(),
            exact: exact.map(|(s, r)| s * r).collect(),
            smooth,
            spikes,
            sampling,
        })
    }
}
