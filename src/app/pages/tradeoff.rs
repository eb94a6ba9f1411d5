//! What the page "Trade-off" keeps.

use serde::{Deserialize, Serialize};

use super::{Page, Place, Row, row, states::PageState};
use crate::study::Measure;

pub(super) const ROW: Row = row(
    Page::Tradeoff,
    Place::Numbers,
    ("Trade-off", "tradeoff"),
    "spend",
    "Error against numbers: every order, with and without spikes.",
)
.among_modes("Curve");

/// The curve's axis and its lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct TradeoffState {
    /// The figure on the vertical axis.
    pub measure: Measure,
    /// The lines that are drawn.
    pub ways: WaysShown,
}

impl Default for TradeoffState {
    fn default() -> Self {
        Self {
            measure: Measure::Patches,
            ways: WaysShown::default(),
        }
    }
}

impl PageState for TradeoffState {
    const NAMES: &'static [(&'static str, &'static str)] = &[
        ("measure", "the error on the axis"),
        ("ways", "the lines drawn"),
    ];

    /// Both of a pair where neither was chosen: there is always something drawn.
    fn settle(&mut self) {
        let WaysShown {
            fourier,
            cosine,
            without_spikes,
            with_spikes,
            plain,
            colour_exact,
        } = &mut self.ways;
        for (a, b) in [
            (fourier, cosine),
            (without_spikes, with_spikes),
            (plain, colour_exact),
        ] {
            if !*a && !*b {
                (*a, *b) = (true, true);
            }
        }
    }
}

/// Which of the eight ways are drawn: a way is when all three of its choices are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct WaysShown {
    /// The periodic Fourier basis.
    pub fourier: bool,
    /// The half-range cosine basis.
    pub cosine: bool,
    /// Models without spikes.
    pub without_spikes: bool,
    /// Models with spikes.
    pub with_spikes: bool,
    /// Plain least squares.
    pub plain: bool,
    /// The colour-exact fit.
    pub colour_exact: bool,
}

impl Default for WaysShown {
    fn default() -> Self {
        Self {
            fourier: true,
            cosine: true,
            without_spikes: true,
            with_spikes: true,
            plain: true,
            colour_exact: true,
        }
    }
}
