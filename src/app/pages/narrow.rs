//! What the page "One filter" keeps.

use serde::{Deserialize, Serialize};

use super::{
    Page, Place, Row,
    knob::{Knob, Reach, knob},
    row,
    states::PageState,
};

pub(super) const ROW: Row = row(
    Page::Narrow,
    Place::Through,
    (later!("One filter"), "filter"),
    "samples",
    later!("A narrow band-pass moved over the light, at equal numbers."),
)
.once(&["narrow"]);

/// What the narrow band-pass remembers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct NarrowMemory {
    /// Centre of the band-pass, nm.
    pub centre_nm: f64,
    /// Its full width at half maximum, nm.
    pub width_nm: f64,
    /// The key of a real filter that stands in the band-pass's place; `None` for the Gaussian.
    pub filter: Option<String>,
    /// Whether errors of luminance are drawn instead of those of colour.
    pub luminance: bool,
}

impl Default for NarrowMemory {
    fn default() -> Self {
        Self {
            centre_nm: 546.0,
            width_nm: 10.0,
            filter: None,
            luminance: false,
        }
    }
}

/// Full widths of the band-pass at half its maximum, nm.
pub const PASS_WIDTHS_NM: [f64; 2] = [2.0, 100.0];

impl NarrowMemory {
    pub const WIDTH: Knob<Self> = knob!(width_nm: later!("Width"),
        Reach::Within(PASS_WIDTHS_NM[0], PASS_WIDTHS_NM[1]), 1 " nm",
        later!("The full width of the band-pass at half its maximum."));
}

impl PageState for NarrowMemory {
    const KNOBS: &'static [Knob<Self>] = &[
        knob!(centre_nm: later!("Centre"), Reach::Within(200.0, 20_000.0), 1 " nm",
            later!("The wavelength in the middle of the band-pass.")),
        Self::WIDTH,
    ];

    const NAMES: &'static [(&'static str, &'static str)] = &[
        ("filter", later!("the filter")),
        ("luminance", later!("the error drawn")),
    ];
}
