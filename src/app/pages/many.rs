//! What the page "Many lights" keeps.

use serde::{Deserialize, Serialize};

use super::{
    Page, Place, Row,
    knob::{Knob, Reach, knob},
    race::FieldChoice,
    row,
    states::PageState,
};
use crate::{app::verdicts::HARD_TO_SEE, study::Measure};

pub(super) const ROW: Row = row(
    Page::Many,
    Place::Numbers,
    (later!("Many lights"), "many-lights"),
    "spend",
    later!("How many numbers most of your lights need: a set, or your folders."),
)
.under(Page::Tradeoff);

/// What is asked of many lights.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ManyMemory {
    /// Which lights.
    pub field: FieldChoice,
    /// The figure that has a limit.
    pub measure: Measure,
    /// What it may be at most, in its unit on screen: ΔE₀₀ or percent.
    pub limit: f64,
    /// For how many of the lights, percent.
    pub share_percent: u8,
}

impl Default for ManyMemory {
    fn default() -> Self {
        Self {
            field: FieldChoice::Shipped,
            measure: Measure::Patches,
            limit: Self::usual_limit(Measure::Patches),
            share_percent: 95,
        }
    }
}

impl ManyMemory {
    /// A limit worth beginning with: the difference is hard to see, or 5 % of a spectrum.
    pub fn usual_limit(measure: Measure) -> f64 {
        if measure.is_colour() {
            HARD_TO_SEE
        } else {
            5.0
        }
    }
}

impl ManyMemory {
    pub const SHARE: Knob<Self> = knob!(share_percent: later!("Share of the lights"),
        Reach::Within(1.0, 100.0), 0 " %",
        later!("The part of the lights that are to keep the limit."));
    pub const LIMIT: Knob<Self> = knob!(limit: later!("Limit"), Reach::Within(0.01, 100.0), 2 "",
        later!("The most that the error may be."));
}

impl PageState for ManyMemory {
    const KNOBS: &'static [Knob<Self>] = &[Self::LIMIT, Self::SHARE];

    const NAMES: &'static [(&'static str, &'static str)] = &[
        ("field", later!("the lights")),
        ("measure", later!("the error that has a limit")),
    ];
}
