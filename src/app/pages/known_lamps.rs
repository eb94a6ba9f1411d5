//! What the page "Known lamps" keeps.

use serde::{Deserialize, Serialize};

use super::{
    Page, Place, Row,
    knob::{Knob, Reach, knob},
    row,
    states::PageState,
};
use crate::lamps::NUMBERS;

pub(super) const ROW: Row = row(
    Page::KnownLamps,
    Place::Numbers,
    (later!("Known lamps"), "known-lamps"),
    "spend",
    later!("The light as a sum of known lamps, a short series and a few lines."),
)
.under(Page::Coefficients);

/// How a light is put into few words.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct WordsMemory {
    /// Most numbers.
    pub numbers: usize,
    /// Without known lamps: whoever has the formula can decode the words.
    pub portable: bool,
    /// Whether a shipped lamp may be said to be itself.
    pub itself: bool,
    /// Whether Automatic may use known lamps.
    pub automatic: bool,
}

impl Default for WordsMemory {
    fn default() -> Self {
        Self {
            numbers: 20,
            portable: false,
            itself: false,
            automatic: false,
        }
    }
}

impl PageState for WordsMemory {
    const KNOBS: &'static [Knob<Self>] = &[knob!(numbers: later!("Numbers"),
        Reach::Within(NUMBERS[0] as f64, NUMBERS[1] as f64), 0 "",
        later!("The most numbers that the light may take."))];

    const NAMES: &'static [(&'static str, &'static str)] = &[
        ("portable", later!("known lamps")),
        ("itself", later!("lamps that are the light itself")),
        ("automatic", later!("known lamps for Automatic")),
    ];
}
