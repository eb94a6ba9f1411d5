//! What the page "Chromaticity" keeps.

use serde::{Deserialize, Serialize};

use super::{Page, Place, Row, row, states::PageState};

pub(super) const ROW: Row = row(
    Page::Chromaticity,
    Place::Quality,
    ("Chromaticity", "chromaticity"),
    "quality",
    "Where the light is among colours, whites and screens.",
);

/// What the diagram shows beside the light.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct DiagramShows {
    /// CIE 1976 u'v', else CIE 1931 xy.
    pub uniform: bool,
    /// sRGB, P3 and Rec. 2020.
    pub gamuts: bool,
    /// The nominal whites of ANSI C78.377.
    pub whites: bool,
    /// MacAdam's ellipses, ten times enlarged.
    pub ellipses: bool,
    /// The neighbourhood of the light alone.
    pub near: bool,
}

impl Default for DiagramShows {
    fn default() -> Self {
        Self {
            uniform: true,
            gamuts: false,
            whites: true,
            ellipses: false,
            near: false,
        }
    }
}

impl PageState for DiagramShows {
    const NAMES: &'static [(&'static str, &'static str)] = &[
        ("uniform", "the plane"),
        ("gamuts", "gamuts of screens"),
        ("whites", "nominal whites"),
        ("ellipses", "ellipses"),
        ("near", "the neighbourhood of the light"),
    ];
}
