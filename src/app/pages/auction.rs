//! What the page "Auction" keeps.

use serde::{Deserialize, Serialize};

use super::{
    Page, Place, Row,
    knob::{Knob, knob},
    look::SPENT,
    row,
    states::PageState,
};
use crate::study::Goal;

pub(super) const ROW: Row = row(
    Page::Auction,
    Place::Numbers,
    (later!("Auction"), "auction"),
    "spend",
    later!("The best use of the next numbers: a wave, a line or the lines' widths."),
)
.under(Page::Tradeoff);

/// What is bought, and with how many numbers.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct AuctionState {
    /// What is to be made small.
    pub goal: Goal,
    /// Most numbers.
    pub numbers: usize,
}

impl Default for AuctionState {
    fn default() -> Self {
        Self {
            goal: Goal::PATCHES,
            numbers: 41,
        }
    }
}

impl PageState for AuctionState {
    const KNOBS: &'static [Knob<Self>] = &[knob!(numbers: later!("Most numbers"), SPENT, 0 "",
        later!("The most numbers that are bought."))];

    const NAMES: &'static [(&'static str, &'static str)] =
        &[("goal", later!("what is made small"))];

    fn settle(&mut self) {
        self.goal = self.goal.clamped();
    }
}
