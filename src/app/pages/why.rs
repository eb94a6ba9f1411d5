//! What the page "Why few suffice" keeps.

use serde::{Deserialize, Serialize};

use super::knob::{Knob, Reach, knob};
use super::{Page, Place, Row, row, states::PageState};

pub(super) const ROW: Row = row(
    Page::Coefficients,
    Place::Numbers,
    (later!("Why few suffice"), "why"),
    "colour",
    later!("Why few numbers carry colour: the coefficients of the light beside those of the eye."),
)
.once(&["coefficients"])
.titled_tab(later!("For authors"));

/// The partial sum and the bars.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct WhyState {
    /// The partial sum's order.
    pub partial_order: usize,
    /// Which of X, Y, Z the bars are of.
    pub channel: usize,
}

impl Default for WhyState {
    fn default() -> Self {
        Self {
            partial_order: 3,
            channel: 1,
        }
    }
}

impl PageState for WhyState {
    const KNOBS: &'static [Knob<Self>] = &[
        knob!(partial_order: later!("Sum of waves up to"), Reach::Within(0.0, 100.0), 0 "",
            later!("The order up to which the terms are summed.")),
        knob!(channel: later!("Bars of"), Reach::Within(0.0, 2.0), 0 "",
        later!(
            "The colour-matching function whose terms are drawn: 0 for X, 1 for Y, 2 for Z."
        )),
    ];
}
