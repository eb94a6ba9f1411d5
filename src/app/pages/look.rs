//! What the first screen keeps: the numbers that may be spent, and for what.

use serde::{Deserialize, Serialize};

use super::knob::{Knob, Reach, knob};
use super::{Page, Place, Row, row, states::PageState};
use crate::study::Goal;

pub(super) const ROW: Row = row(
    Page::Spectrum,
    Place::Look,
    (later!("Spectrum"), "look"),
    "waves",
    later!("The spectrum, its model and surfaces under both."),
)
.once(&["spectrum"]);

/// "Spend ... numbers for me".
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct LookState {
    pub numbers: usize,
    /// What is then made small; `None` for the goal of the auction's page.
    pub goal: Option<Goal>,
}

impl Default for LookState {
    fn default() -> Self {
        Self {
            numbers: 21,
            goal: Some(Goal::PATCHES),
        }
    }
}

/// Counts of numbers that may be spent.
pub const SPENDABLE: std::ops::RangeInclusive<usize> = 1..=101;

/// The same for a knob.
pub(super) const SPENT: Reach = Reach::Within(*SPENDABLE.start() as f64, *SPENDABLE.end() as f64);

impl PageState for LookState {
    const KNOBS: &'static [Knob<Self>] = &[knob!(numbers: later!("Numbers to spend"), SPENT, 0 "",
        later!("The most numbers that Automatic may take."))];

    const NAMES: &'static [(&'static str, &'static str)] =
        &[("goal", later!("what Automatic makes small"))];

    fn settle(&mut self) {
        self.goal = self.goal.map(Goal::clamped);
    }
}
