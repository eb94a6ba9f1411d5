//! What the page "Live" keeps.

use serde::{Deserialize, Serialize};

use super::{
    Page, Place, Row,
    knob::{Knob, Reach},
    row,
    states::PageState,
};
use crate::live::{MOST_AVERAGED, Track};

pub(super) const ROW: Row = row(
    Page::Live,
    Place::Look,
    (later!("Live"), "live"),
    "light",
    later!("A light that changes: from a file, a folder, an instrument or a recording."),
);

/// Figures that are shown at first.
const FIRST_FIGURES: [&str; 3] = ["cct", "Y", "ra"];

/// What the page remembers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct LiveMemory {
    /// Frames that are averaged.
    pub average: usize,
    /// Counts are taken as a light.
    pub as_light: bool,
    /// Keys of the figures that are shown.
    pub figures: Vec<String>,
    /// What is drawn over time.
    pub track: Track,
}

impl Default for LiveMemory {
    fn default() -> Self {
        Self {
            average: 1,
            as_light: false,
            figures: FIRST_FIGURES.map(str::to_owned).to_vec(),
            track: Track::Y,
        }
    }
}

impl LiveMemory {
    pub const AVERAGE: Knob<Self> = Knob::new(
        ("average", later!("Average")),
        later!("The mean of so many frames is shown, the newest."),
        Reach::Within(1.0, MOST_AVERAGED as f64),
        (0, ""),
        |memory| &mut memory.average,
    );
}

impl PageState for LiveMemory {
    const KNOBS: &'static [Knob<Self>] = &[Self::AVERAGE];
    const NAMES: &'static [(&'static str, &'static str)] = &[
        ("as_light", later!("counts as a light")),
        ("figures", later!("its figures")),
        ("track", later!("what is drawn over time")),
    ];
}
