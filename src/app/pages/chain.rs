//! What the page "Chain" keeps.

use serde::{Deserialize, Serialize};

use super::{Page, Place, Row, row, states::PageState};

pub(super) const ROW: Row = row(
    Page::Chain,
    Place::Through,
    (later!("Chain"), "chain"),
    "filters",
    later!("The light through filters and off surfaces, exact beside model."),
)
.once(&["products"]);

/// What the chain remembers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct ChainMemory {
    /// The stage that is drawn, 0 the first factor; `None` for the last.
    pub stage: Option<usize>,
    /// The light before any factor is drawn, whatever stage is remembered.
    pub light: bool,
}

impl PageState for ChainMemory {
    const NAMES: &'static [(&'static str, &'static str)] = &[
        ("stage", later!("the step drawn")),
        ("light", later!("the step drawn")),
    ];
}
