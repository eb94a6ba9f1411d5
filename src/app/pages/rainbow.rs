//! What the page "Rainbow" keeps.

use serde::{Deserialize, Serialize};

use super::{
    Page, Place, Row,
    knob::{Knob, Reach, knob},
    prism::{Beside, EXPOSED, STOPS},
    row,
    states::PageState,
};
use crate::app::dispersion::Sent;

pub(super) const ROW: Row = row(
    Page::Rainbow,
    Place::Picture,
    (later!("Rainbow"), "rainbow"),
    "prism",
    later!("The light in drops of water: both bows, and where each line stands in them."),
)
.under(Page::Prism);

/// The rainbow's page.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct RainbowMemory {
    /// The source is as wide as the sun's disc; else it is a point.
    pub disc: bool,
    /// Where the drawn rays meet the drop, radii off its middle.
    pub impact: f64,
    /// The drawn rays are reflected twice in the drop; else once.
    pub twice: bool,
    /// Exposure, stops.
    pub stops: f64,
    /// The second strip.
    pub beside: Beside,
    /// What of the light is sent through.
    pub sent: Sent,
}

/// Where rays of green light meet the drop that make the first and the second bow, radii.
const BOW_IMPACTS: [f64; 2] = [0.86, 0.95];

impl RainbowMemory {
    pub const IMPACT: Knob<Self> = knob!(impact: later!("Rays meet the drop at"),
        Reach::Within(0.0, 0.995), 3 later!(" radii"),
        later!("How far off its middle the coloured rays meet the drop; where the thin rays crowd \
        together they make the bow."));
    const EXPOSURE: Knob<Self> =
        knob!(stops: later!("Exposure"), STOPS, 1 later!(" stops"), EXPOSED);

    /// Draws the rays of one of the two bows, from where they meet the drop.
    pub fn look_at(&mut self, twice: bool) {
        self.twice = twice;
        self.impact = BOW_IMPACTS[usize::from(twice)];
    }
}

impl Default for RainbowMemory {
    fn default() -> Self {
        Self {
            disc: true,
            impact: BOW_IMPACTS[0],
            twice: false,
            stops: 0.0,
            beside: Beside::Sun,
            sent: Sent::Measured,
        }
    }
}

impl PageState for RainbowMemory {
    const KNOBS: &'static [Knob<Self>] = &[Self::IMPACT, Self::EXPOSURE];

    const NAMES: &'static [(&'static str, &'static str)] = &[
        ("disc", later!("the width of the source")),
        ("twice", later!("the bow whose rays are drawn")),
        ("beside", later!("the light beside it")),
        ("sent", later!("the light sent through")),
    ];
}
