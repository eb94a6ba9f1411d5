//! What the page "Bounces" keeps.

use serde::{Deserialize, Serialize};

use super::{Page, Place, Row, row, states::PageState};

pub(super) const ROW: Row = row(
    Page::Bounces,
    Place::Numbers,
    (later!("Bounces"), "bounces"),
    "filters",
    later!("Cost of each way of forming products, as bounces add up."),
)
.under(Page::Coefficients);

/// What the bounces remember.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct BouncesMemory {
    /// Whether only what forming the products adds is told.
    pub added: bool,
    /// Whether the vertical axis is logarithmic.
    pub log: bool,
}

impl Default for BouncesMemory {
    fn default() -> Self {
        Self {
            added: false,
            log: true,
        }
    }
}

impl PageState for BouncesMemory {
    const NAMES: &'static [(&'static str, &'static str)] = &[
        ("added", later!("the error drawn")),
        ("log", later!("the vertical axis")),
    ];
}
