//! Light through filters and off surfaces: what the model's products are off by.
//!
//! ```text
//! chain        a light through factors, exact beside model at every stage; sets of factors
//! resampling   one product formed in every way; the factor at the spikes by Eq. 17
//! timing       what one product takes on this machine
//! bounces      error against the number of bounces, every way of forming products
//! narrow       a band-pass that moves over the light: composite, series alone, plain samples
//! two_lights   the same surfaces under two lights; metameric pairs and metameric blacks
//! same_surface is this light that one off this surface? (the paper's image understanding)
//! dips         how deep the absorption lines of a spectrum are
//! ```
//!
//! Exact is the measured light times the measured factors on the 1 nm grid of the band; the white
//! of every CIEDE2000 is the exact light. What does not exist (a colour without light) is `None`.

mod bounces;
mod chain;
mod dips;
mod narrow;
mod resampling;
mod same_surface;
pub(crate) mod timing;
mod two_lights;

pub(crate) use bounces::{BounceErrors, MOST_BOUNCES, bounce_errors};
pub use chain::Product;
pub(crate) use chain::{Passage, SetErrors, Step};
pub(crate) use dips::depths;
pub(crate) use narrow::{Narrow, NarrowPoint};
pub use resampling::resampled;
pub(crate) use resampling::{Formed, Resampled, SpikeCosts, spike_costs};
pub(crate) use same_surface::{Checker, Compared, Reflection, measured_check};
pub use same_surface::{SAME_RESIDUAL, Sameness};
pub(crate) use timing::{ProductTime, Sizes, product_times};
pub(crate) use two_lights::{
    Black, MATCH_DELTA_E, MetamericPair, Metamers, TwoLights, metameric_black, metameric_pairs,
    two_lights,
};

use super::error::ratio;
use crate::color::{Xyz, delta_e_of_xyz};

/// One light as it is and as the model has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Colours {
    /// Exact, in value x nm.
    pub exact: Xyz,
    /// The model's.
    pub model: Xyz,
    /// CIEDE2000 between the two; `None` without a white.
    pub delta_e_2000: Option<f64>,
    /// `Y model / Y exact - 1`; `None` where the exact Y is not positive.
    pub luminance_error: Option<f64>,
}

impl Colours {
    /// Compares two colours against a white in the same scale.
    pub(crate) fn of(exact: Xyz, model: Xyz, white: Xyz) -> Self {
        Self {
            exact,
            model,
            delta_e_2000: delta_e_of_xyz(exact, model, white),
            luminance_error: ratio(model.y, exact.y).map(|share| share - 1.0),
        }
    }

    /// `Y out / Y in`, exact and model, where `before` comes in; `None` where no light does.
    fn transmission(&self, before: &Self) -> [Option<f64>; 2] {
        [
            ratio(self.exact.y, before.exact.y),
            ratio(self.model.y, before.model.y),
        ]
    }

    /// The same, both sides brightened so that the exact one has the Y that `y` says, but by no
    /// more than `most`; what is too dark to have a colour gets one that way.
    fn brightened(exact: Xyz, model: Xyz, white: Xyz, y: f64, most: f64) -> Self {
        let gain = (y / exact.y.max(0.0)).min(most);
        let gain = if gain.is_finite() { gain } else { 1.0 };
        Self {
            delta_e_2000: delta_e_of_xyz(exact * gain, model * gain, white),
            ..Self::of(exact, model, white)
        }
    }
}
