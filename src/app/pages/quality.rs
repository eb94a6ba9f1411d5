//! The pages of the place "Quality" beside the chromaticity.

use serde::{Deserialize, Serialize};

use super::{Page, Place, Row, row, states::PageState};
use crate::app::charts::quality::OfColours;

pub(super) const QUALITY: Row = row(
    Page::Quality,
    Place::Quality,
    (later!("Verdict"), "quality"),
    "quality",
    later!("Is it a good light? Surfaces under it, twelve figures in words, and all of them."),
);

pub(super) const RENDITION: Row = row(
    Page::Rendition,
    Place::Quality,
    (later!("Colours under it"), "rendition"),
    "quality",
    later!("Colours under the light: TM-30 and CRI, hue by hue."),
);

pub(super) const QUALITY_ORDER: Row = row(
    Page::QualityOrder,
    Place::Quality,
    (later!("Against waves"), "quality-order"),
    "quality",
    later!("How many numbers a model needs to give the light's own figures."),
);

/// What the page "Colours under it" keeps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct RenditionState {
    /// The large chart.
    pub large: OfColours,
}

impl PageState for RenditionState {
    const NAMES: &'static [(&'static str, &'static str)] = &[("large", later!("the large chart"))];
}
