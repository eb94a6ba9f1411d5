//! Eq. 16: a product takes 2N + 2 multiplications.

use super::eq_17::cut;
use crate::{
    color::{Weights, Xyz, delta_e_of_xyz, xyz_of_parts},
    spectrum::{
        BasisTable, Composite, Sampling,
        product::{folded_share, in_units, resampled},
    },
};

/// A product of a light and a factor, each cut to N, formed on a few points.
#[derive(Clone, Debug, PartialEq)]
pub struct Resampling {
    /// Order N of both factors.
    pub order: usize,
    /// Way by way, the paper's first.
    pub ways: Vec<ResamplingWay>,
}

/// Cost of forming a product on a number of points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ResamplingWay {
    /// The way.
    pub sampling: Sampling,
    /// Independent points: one multiplication each.
    pub points: usize,
    /// Share of the product's power that these points fold back into lower orders, 0-1 and more.
    pub folded_share: f64,
    /// CIEDE2000 of the product against the exact product of the same two series.
    pub delta_e_2000: Option<f64>,
}

/// Forms light times factor (values on the grid) in every way that the basis offers.
///
/// Arguments as for `eq_17`. Spikes are weighed by the factor's series in every way, so that
/// only the smooth product differs.
///
/// # Panics
/// As `eq_17`.
pub(crate) fn resampling(
    light: &Composite,
    factor: &[f64],
    table: &BasisTable,
    weights: &Weights,
    white: Xyz,
) -> Resampling {
    let band = table.band();
    let factor = cut(factor, table, light);
    let product = |sampling| {
        let (smooth, spikes) = resampled(light, &factor, sampling).into_parts();
        xyz_of_parts(band, &smooth.on_band(), &spikes, weights)
    };
    let exact = product(Sampling::Exact);
    let numbers = light.smooth().coefficients.len();
    let (light_unit, factor_unit) = (in_units(light.smooth()), in_units(&factor));
    Resampling {
        order: light.smooth().order(),
        ways: Sampling::on_points(table.basis())
            .filter_map(|sampling| {
                let points = sampling.points(numbers)?;
                Some(ResamplingWay {
                    sampling,
                    points,
                    folded_share: folded_share(&light_unit, &factor_unit, points),
                    delta_e_2000: delta_e_of_xyz(exact, product(sampling), white),
                })
            })
            .collect(),
    }
}
