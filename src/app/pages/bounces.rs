//! What the page "Bounces" keeps.

use serde::{Deserialize, Serialize};

use super::states::PageState;

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
    const NAMES: &'static [(&'static str, &'static str)] =
        &[("added", "the error drawn"), ("log", "the vertical axis")];
}
