//! Eq. 12: terms beyond order N contribute under 5 %.

use super::STATED_ORDER;
use crate::{
    color::gaussian_cmf::{self, Gaussian, NEGLIGIBLE_SHARE},
    study::harmonics::{Harmonics, Order},
};

/// "Terms beyond N contribute under 5 %", for X, Y and Z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FivePercent {
    /// The highest order looked at; every tail reaches beyond it, single terms do not.
    pub highest_order: usize,
    /// X, Y and Z.
    pub channels: [ChannelTerms; 3],
}

/// From where on the terms of one channel are negligible: below `STATED_SHARE` of its exact
/// total, spikes included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChannelTerms {
    /// The first order n >= 1 from which every single term is negligible. `None` when the highest
    /// order looked at is not, or the channel has no positive total.
    pub first_negligible: Option<usize>,
    /// The lowest N such that all that is neglected beyond N, and beyond every higher order, is
    /// negligible as a whole. `None` when no order looked at is enough.
    pub sufficient_order: Option<usize>,
    /// The first order n at which the corrected Eq. 12 falls below the share, for Fourier series
    /// on this range that meet Eq. 11; for X the later one of its two lobes.
    pub promised: usize,
    /// The same by Eq. 12 as printed.
    pub promised_as_printed: usize,
    /// Part neglected at the paper's N = 5; `None` when fewer orders were looked at or the channel
    /// has no positive total.
    pub at_stated_order: Option<Neglected>,
}

/// Part neglected beyond an order, as shares of a channel's exact total.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Neglected {
    /// The first term left out, signed.
    pub next_term: f64,
    /// The largest single term left out, of those looked at; not negative.
    pub largest_term: f64,
    /// All terms left out together, signed: positive when the model shows too little.
    pub tail: f64,
}

/// Measures from which order on terms are negligible.
pub(crate) fn five_percent(harmonics: &Harmonics) -> FivePercent {
    FivePercent {
        highest_order: harmonics.orders.last().map_or(0, |o| o.order),
        channels: std::array::from_fn(|k| channel_terms(harmonics, k)),
    }
}

pub(super) fn channel_terms(harmonics: &Harmonics, k: usize) -> ChannelTerms {
    let (orders, length_nm) = (&harmonics.orders, harmonics.band.length_nm());
    let exact = harmonics.exact[k];
    let share = |order: &Order| {
        Some(order.contribution[k] / exact).filter(|s| exact > 0.0 && s.is_finite())
    };
    let is_negligible = |share: Option<f64>| share.is_some_and(|s| s.abs() < NEGLIGIBLE_SHARE);
    let latest = |first: &dyn Fn(Gaussian) -> usize| {
        let firsts = gaussian_cmf::FIT[k].iter().map(|lobe| first(*lobe));
        firsts.max().unwrap_or(1)
    };
    ChannelTerms {
        first_negligible: start_of_end_run(orders.get(1..).unwrap_or_default(), |o| {
            is_negligible(share(o))
        }),
        sufficient_order: start_of_end_run(orders, |o| is_negligible(o.neglected[k])),
        promised: latest(&|lobe| lobe.first_negligible_order(length_nm)),
        promised_as_printed: latest(&|lobe| lobe.first_negligible_as_printed(length_nm)),
        at_stated_order: neglected_beyond(STATED_ORDER.figure as usize, orders, k, share),
    }
}

/// The order at which the unbroken run of orders that pass, up to the highest, begins.
pub(super) fn start_of_end_run(orders: &[Order], passes: impl Fn(&Order) -> bool) -> Option<usize> {
    let run = orders.iter().rev().take_while(|o| passes(o));
    run.last().map(|o| o.order)
}

pub(super) fn neglected_beyond(
    order: usize,
    orders: &[Order],
    k: usize,
    share: impl Fn(&Order) -> Option<f64>,
) -> Option<Neglected> {
    let beyond = orders.get(order + 1..)?;
    let sizes = beyond.iter().filter_map(&share).map(f64::abs);
    Some(Neglected {
        next_term: share(beyond.first()?)?,
        largest_term: sizes.fold(0.0, f64::max),
        tail: orders[order].neglected[k]?,
    })
}
