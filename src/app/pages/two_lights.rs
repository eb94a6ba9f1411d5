//! What the page "Two lights" keeps.

use serde::{Deserialize, Serialize};

use super::{
    Page, Place, Row,
    knob::{Knob, Reach, knob},
    row,
    states::PageState,
};

pub(super) const ROW: Row = row(
    Page::TwoLights,
    Place::Through,
    (later!("Two lights"), "two-lights"),
    "metamers",
    later!("The same surfaces under two lights: which colours change."),
)
.once(&["lights"]);

pub(super) const METAMERS: Row = row(
    Page::Metamers,
    Place::Through,
    (later!("Metamers"), "metamers"),
    "metamers",
    later!("Surfaces that look alike under one light and differ under another, found and made."),
);

/// What the comparison of two lights remembers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct TwoLightsMemory {
    /// The patch whose metamer is made.
    pub patch: usize,
    /// The pair that is drawn.
    pub pair: usize,
    /// A metamer is made for a patch; else pairs are looked for.
    pub makes: bool,
    /// Pairs are looked for among all shipped reflectances, not the patches alone.
    pub everywhere: bool,
    /// Part of the room that the metameric black takes, percent; below 0 the other way.
    pub room_percent: i32,
}

impl Default for TwoLightsMemory {
    fn default() -> Self {
        Self {
            patch: 0,
            pair: 0,
            makes: false,
            everywhere: true,
            room_percent: 100,
        }
    }
}

impl TwoLightsMemory {
    pub const ROOM: Knob<Self> = knob!(room_percent: later!("Part of the room"),
        Reach::Within(-100.0, 100.0), 0 " %",
        later!("The part of the room up to 0 and 1 that the metameric black takes."));
}

impl PageState for TwoLightsMemory {
    const KNOBS: &'static [Knob<Self>] = &[Self::ROOM];

    const NAMES: &'static [(&'static str, &'static str)] = &[
        ("patch", later!("the surface chosen")),
        ("pair", later!("the pair drawn")),
        ("makes", later!("found or made")),
        ("everywhere", later!("where pairs are looked for")),
    ];
}
