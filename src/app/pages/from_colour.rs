//! The page "From a colour"; what it keeps is the colour.

use super::{Page, Place, Row, row};

pub(super) const ROW: Row = row(
    Page::FromColour,
    Place::Design,
    ("From a colour", "from-colour"),
    "recover",
    "Which spectra have this colour?",
);
