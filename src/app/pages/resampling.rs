//! What the page "Products in few numbers" keeps.

use serde::{Deserialize, Serialize};

use super::{Page, Place, Row, row, states::PageState};
use crate::spectrum::Sampling;

pub(super) const ROW: Row = row(
    Page::Resampling,
    Place::Numbers,
    (later!("Products in few numbers"), "resampling"),
    "filters",
    later!("One product formed on few points, by convolution and at every nm."),
)
.once(&["forming"])
.under(Page::Coefficients);

/// What the resampling bench remembers.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ResamplingMemory {
    /// Ways whose curves are not drawn.
    pub hidden: Vec<Sampling>,
}

impl ResamplingMemory {
    /// Shows or hides a way's curve.
    pub fn show(&mut self, way: Sampling, shown: bool) {
        self.hidden.retain(|one| *one != way);
        if !shown {
            self.hidden.push(way);
        }
        // In the order that they are kept in.
        self.settle();
    }
}

impl PageState for ResamplingMemory {
    const NAMES: &'static [(&'static str, &'static str)] = &[("hidden", later!("the ways drawn"))];

    fn settle(&mut self) {
        let hidden = |way: &Sampling| self.hidden.contains(way);
        self.hidden = Sampling::ALL.into_iter().filter(hidden).collect();
    }
}
