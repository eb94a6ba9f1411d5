//! What the page "Same surface?" keeps.

use serde::{Deserialize, Serialize};

use super::{Page, Place, Row, row, states::PageState};

pub(super) const ROW: Row = row(
    Page::SameSurface,
    Place::Through,
    ("Same surface?", "same-surface"),
    "filters",
    "Whether a spectrum is the light off a surface: S3 = S1 S2.",
)
.once(&["check"]);

/// What the check remembers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct SameSurfaceMemory {
    /// The best surface is looked for among all shipped reflectances, not the patches alone.
    pub everywhere: bool,
    /// The example's light meets its surface twice.
    pub twice: bool,
}

impl Default for SameSurfaceMemory {
    fn default() -> Self {
        Self {
            everywhere: true,
            twice: false,
        }
    }
}

impl PageState for SameSurfaceMemory {
    const NAMES: &'static [(&'static str, &'static str)] = &[
        ("everywhere", "where surfaces are looked for"),
        ("twice", "how often the example's light meets its surface"),
    ];
}
