//! What the page "Chromaticity" keeps.

use super::{Page, Place, Row, row, states::PageState};
use crate::app::charts::quality::DiagramShows;

pub(super) const ROW: Row = row(
    Page::Chromaticity,
    Place::Quality,
    (later!("Chromaticity"), "chromaticity"),
    "quality",
    later!("The light among colours, whites and screens."),
);

impl PageState for DiagramShows {
    const NAMES: &'static [(&'static str, &'static str)] = &[
        ("uniform", later!("the plane")),
        ("gamuts", later!("gamuts of screens")),
        ("whites", later!("nominal whites")),
        ("ellipses", later!("MacAdam's ellipses")),
        ("surfaces", later!("the outline of surfaces")),
        ("near", later!("the neighbourhood of the light")),
    ];
}
