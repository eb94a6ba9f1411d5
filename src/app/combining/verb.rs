//! What can be done with measurements in the window, and the spectra that each verb needs.

use serde::{Deserialize, Serialize};

/// What is done with the spectra.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verb {
    #[default]
    Mean,
    Difference,
    Sum,
    Quotient,
    QuotientLessDark,
    Absorbance,
    Splice,
    Slit,
    Unslit,
    Changed,
}

/// One of the places that a verb needs a spectrum for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Slot {
    pub name: &'static str,
    pub meaning: &'static str,
}

const fn slot(name: &'static str, meaning: &'static str) -> Slot {
    Slot { name, meaning }
}

const LIGHT: Slot = slot("Light A", "The light that is looked at.");
const SAMPLE: Slot = slot("Sample A", "The light behind the sample, or off it.");
const REFERENCE: Slot = slot("Reference B", "The same light without the sample.");

impl Verb {
    /// Every verb, in the order offered.
    pub const ALL: [Self; 10] = [
        Self::Mean,
        Self::Difference,
        Self::Sum,
        Self::Quotient,
        Self::QuotientLessDark,
        Self::Absorbance,
        Self::Splice,
        Self::Slit,
        Self::Unslit,
        Self::Changed,
    ];

    /// What it is called.
    pub fn title(self) -> &'static str {
        match self {
            Self::Mean => "mean of scans",
            Self::Difference => "A less B",
            Self::Sum => "A and B together",
            Self::Quotient => "A over B",
            Self::QuotientLessDark => "A over B, less dark C",
            Self::Absorbance => "absorbance of A over B",
            Self::Splice => "A and B spliced",
            Self::Slit => "seen through a slit",
            Self::Unslit => "its slit taken off",
            Self::Changed => "what changed",
        }
    }

    /// What it is for, a sentence.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Mean => "Scans of one light: three or more tell how well every figure is known.",
            Self::Difference => "A light less its dark, or less a background.",
            Self::Sum => "Two lights at once.",
            Self::Quotient => {
                "A sample over its reference: the share that is let through or sent back."
            }
            Self::QuotientLessDark => "The same for counts, the instrument's dark taken off both.",
            Self::Absorbance => "The decadic absorbance of a sample over its reference.",
            Self::Splice => "Two ranges of one light that share 20 nm or more.",
            Self::Slit => "A light as an instrument of a wider slit sees it.",
            Self::Unslit => "A light without what the instrument's slit did to it.",
            Self::Changed => {
                "The differences between two sets of scans that are beyond their noise."
            }
        }
    }

    /// The places that it needs a spectrum for; none for verbs of any number of scans.
    pub fn slots(self) -> &'static [Slot] {
        match self {
            Self::Mean | Self::Changed => &[],
            Self::Difference => {
                const DARK: Slot = slot("Dark B", "The dark or the background that is taken off.");
                &const { [LIGHT, DARK] }
            }
            Self::Sum => &const { [LIGHT, slot("Light B", "The light that is added.")] },
            Self::Quotient | Self::Absorbance => &const { [SAMPLE, REFERENCE] },
            Self::QuotientLessDark => {
                const DARK: Slot = slot("Dark C", "What the instrument counts without light.");
                &const { [SAMPLE, REFERENCE, DARK] }
            }
            Self::Splice => {
                const FIRST: Slot = slot("Range A", "The range that keeps its level.");
                const SECOND: Slot = slot("Range B", "It is brought to the level of A.");
                &const { [FIRST, SECOND] }
            }
            Self::Slit | Self::Unslit => &const { [LIGHT] },
        }
    }
}
