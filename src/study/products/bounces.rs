//! Errors of a chain as it grows longer.
//!
//! Both sides are brightened so that the exact product has half the light's Y: after eight
//! bounces off an ordinary surface hardly any light is left, and no difference of colour either.

use super::{Colours, Product};
use crate::{
    color::{delta_e_of_xyz, xyz_of_parts},
    spectrum::{
        ChainTables, Factor, Sampling,
        product::{chain_points, multiply},
    },
};

/// Most bounces that are followed.
pub(crate) const MOST_BOUNCES: usize = 16;

/// Share of the light's Y that both sides are brought to.
const BRIGHT: f64 = 0.5;

/// One way of forming products over K = 1 to `MOST_BOUNCES` bounces.
#[derive(Clone, Debug, PartialEq)]
pub struct BounceErrors {
    /// Method of forming products.
    pub sampling: Sampling,
    /// CIEDE2000 against the exact product, K = 1 first; `None` where nothing is left to see.
    pub total: Vec<Option<f64>>,
    /// Error that forming the products adds to the same series' exact product.
    pub added: Vec<Option<f64>>,
}

/// Error against the number of bounces off the same surface (on the band's grid) for every way;
/// the product's own `sampling` is not looked at.
///
/// # Panics
/// When a curve does not have [`crate::spectrum::Band::points`] values.
pub(crate) fn bounce_errors(product: Product<'_>, surface: &Factor) -> Vec<BounceErrors> {
    let by = |sampling| Product {
        sampling,
        ..product
    };
    let ways = Sampling::ALL.into_iter().map(by);
    ways.map(|product| one_way(product, surface)).collect()
}

fn one_way(product: Product<'_>, surface: &Factor) -> BounceErrors {
    let band = product.model.band();
    let white = product.white();
    let numbers = product.model.smooth().coefficients.len();
    let factors = vec![surface.clone(); MOST_BOUNCES];
    let long = ChainTables::for_light(product.model, product.sampling, MOST_BOUNCES);
    let mut stages = long.pass(product.model, &factors);
    if product.sampling == Sampling::Double {
        // Short chains get fewer points than long ones.
        let few = chain_points(numbers, 1);
        let short = (1..=MOST_BOUNCES)
            .take_while(|count| chain_points(numbers, *count) == few)
            .count();
        let tables = ChainTables::for_light(product.model, product.sampling, short);
        let first = tables.pass(product.model, &factors[..short]);
        stages.splice(..short, first);
    }
    let mut exact = product.measured.to_vec();
    let mut errors = BounceErrors {
        sampling: product.sampling,
        total: Vec::with_capacity(MOST_BOUNCES),
        added: Vec::with_capacity(MOST_BOUNCES),
    };
    for stage in stages {
        exact = multiply(&exact, surface.values());
        let truth = xyz_of_parts(band, &exact, &[], product.seen);
        let model = xyz_of_parts(band, &stage.smooth, &stage.spikes, product.seen);
        let unfolded = xyz_of_parts(band, &stage.unfolded, &stage.spikes, product.seen);
        let has_light = truth.y > 0.0;
        let bright = Colours::brightened(truth, model, white, BRIGHT * white.y, f64::MAX);
        errors.total.push(bright.delta_e_2000.filter(|_| has_light));
        let gain = BRIGHT * white.y / truth.y;
        errors
            .added
            .push(delta_e_of_xyz(unfolded * gain, model * gain, white).filter(|_| has_light));
    }
    errors
}
