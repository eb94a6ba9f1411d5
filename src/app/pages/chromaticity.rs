//! What the page "Chromaticity" keeps.

use super::{Page, Place, Row, row, states::PageState};
use crate::app::charts::quality::DiagramShows;

pub(super) const ROW: Row = row(
    Page::Chromaticity,
    Place::Quality,
    ("Chromaticity", "chromaticity"),
    "quality",
    "Where the light is among colours, whites and screens.",
);

impl PageState for DiagramShows {
    const NAMES: &'static [(&'static str, &'static str)] = &[
        ("uniform", "the plane"),
        ("gamuts", "gamuts of screens"),
        ("whites", "nominal whites"),
        ("ellipses", "MacAdam's ellipses"),
        ("surfaces", "the outline of surfaces"),
        ("near", "the neighbourhood of the light"),
    ];
}
