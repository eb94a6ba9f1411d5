//! What the page "Dark lines" keeps.

use serde::{Deserialize, Serialize};

use super::{Page, Place, Row, row, states::PageState};

pub(super) const ROW: Row = row(
    Page::Absorption,
    Place::Look,
    (later!("Dark lines"), "dark-lines"),
    "missing",
    later!("Absorption lines as lines of negative weight, with their names."),
)
.once(&["absorption"]);

/// What the absorption part remembers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct AbsorptionMemory {
    /// The example that is shown.
    pub example: usize,
}

impl PageState for AbsorptionMemory {
    const NAMES: &'static [(&'static str, &'static str)] = &[("example", later!("the example"))];
}
