//! The pages of the place "Quality" that keep nothing.

use super::{Page, Place, Row, row};

pub(super) const QUALITY: Row = row(
    Page::Quality,
    Place::Quality,
    ("Figures", "quality"),
    "quality",
    "Every figure of light quality, measured beside model, and what it means.",
);

pub(super) const RENDITION: Row = row(
    Page::Rendition,
    Place::Quality,
    ("Colours under it", "rendition"),
    "quality",
    "What the light does to colours: TM-30 and CRI, hue by hue.",
);

pub(super) const QUALITY_ORDER: Row = row(
    Page::QualityOrder,
    Place::Quality,
    ("Against order", "quality-order"),
    "quality",
    "How many numbers a model needs to give the light's own figures.",
);
