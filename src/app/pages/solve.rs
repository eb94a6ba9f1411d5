//! The page "Solve": what is wished of a mixture.

use serde::{Deserialize, Serialize};

use super::{
    Page, Place, Row,
    knob::{Knob, Reach, knob},
    row,
    states::PageState,
};
use crate::design::solve::{Against, FREE_LINES, Floors, Objective};

pub(super) const ROW: Row = row(
    Page::Solve,
    Place::Design,
    (later!("Solve"), "solve"),
    "white",
    later!(
        "Find fader settings for a colour, and the best that several searches find with free lines."
    ),
);

/// What a mixture is wished to be.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct MixWish {
    /// The light whose colour it is to have, by its key; `None` for a temperature.
    pub light: Option<String>,
    /// CIE 1931 chromaticity that it is to have, where it is not that of a light; `None` for a
    /// temperature.
    pub xy: Option<[f64; 2]>,
    /// Its temperature, K.
    pub kelvin: f64,
    /// Its distance from the blackbodies.
    pub duv: f64,
    /// It is to come near to that light at every wavelength, whatever is favoured.
    pub alike: bool,
    /// What it is to be best at.
    pub favour: Objective,
    /// What it must not fall below.
    pub floors: Floors,
    /// The front: what efficacy is traded for.
    pub against: Against,
    /// The front: lines at free places, `FREE_LINES`.
    pub lines: usize,
}

impl Default for MixWish {
    fn default() -> Self {
        Self {
            light: None,
            xy: None,
            kelvin: 4000.0,
            duv: 0.0,
            alike: false,
            favour: Objective::Rf,
            floors: Floors::default(),
            against: Against::Rf,
            lines: 3,
        }
    }
}

impl PageState for MixWish {
    const KNOBS: &'static [Knob<Self>] = &[
        Self::KELVIN,
        Self::DUV,
        knob!(lines: later!("Lines of the front"),
            Reach::Within(*FREE_LINES.start() as f64, *FREE_LINES.end() as f64), 0 "",
            later!("Lines at free places.")),
    ];

    const NAMES: &'static [(&'static str, &'static str)] = &[
        ("light", later!("the colour aimed at")),
        ("xy", later!("the colour aimed at")),
        ("alike", later!("how near it comes to the light")),
        ("favour", later!("what it is best at")),
        ("floors", later!("the lower bounds")),
        ("against", later!("what efficacy is traded for")),
    ];

    fn settle(&mut self) {
        if let Some(xy) = &mut self.xy {
            // What is no number becomes the equal-energy white.
            *xy = xy.map(|v| Reach::Within(0.0, 1.0).nearest(v, 1.0 / 3.0));
        }
        let Floors {
            ler,
            rf,
            ra,
            melanopic,
        } = &mut self.floors;
        for floor in [ler, rf, ra, melanopic] {
            *floor = floor.filter(|value| value.is_finite());
        }
    }
}

impl MixWish {
    pub const KELVIN: Knob<Self> = knob!(kelvin: later!("Temperature"),
        Reach::Within(1000.0, 25_000.0), 0 " K",
        later!("The correlated colour temperature."));
    pub const DUV: Knob<Self> = knob!(duv: "Duv", Reach::Within(-0.05, 0.05), 4 "",
        later!("The distance from the blackbodies."));

    /// Whether two wishes ask for the same faders: the front's own settings do not matter.
    pub fn asks_as(&self, other: &Self) -> bool {
        let same_front = Self {
            against: other.against,
            lines: other.lines,
            ..self.clone()
        };
        same_front == *other
    }
}
