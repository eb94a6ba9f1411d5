//! The page "Solve"; what it keeps is the wish.

use super::{Page, Place, Row, row};

pub(super) const ROW: Row = row(
    Page::Solve,
    Place::Design,
    ("Solve", "solve"),
    "white",
    "Find fader settings for a colour, and the best that several searches find with free lines.",
);
