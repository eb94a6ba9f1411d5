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
    Corrected,
    Learnt,
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

const LIGHT: Slot = slot(later!("Light A"), later!("The light that is looked at."));
const SAMPLE: Slot = slot(
    later!("Sample A"),
    later!("The light behind the sample, or off it."),
);
const REFERENCE: Slot = slot(
    later!("Reference B"),
    later!("The same light without the sample."),
);

impl Verb {
    /// Every verb, in the order offered.
    pub const ALL: [Self; 12] = [
        Self::Mean,
        Self::Difference,
        Self::Sum,
        Self::Quotient,
        Self::QuotientLessDark,
        Self::Absorbance,
        Self::Splice,
        Self::Slit,
        Self::Unslit,
        Self::Corrected,
        Self::Learnt,
        Self::Changed,
    ];

    /// What it is called.
    pub fn title(self) -> &'static str {
        match self {
            Self::Mean => said!("mean of scans"),
            Self::Difference => said!("A less B"),
            Self::Sum => said!("A and B together"),
            Self::Quotient => said!("A over B"),
            Self::QuotientLessDark => said!("A over B, less dark C"),
            Self::Absorbance => said!("absorbance of A over B"),
            Self::Splice => said!("A and B spliced"),
            Self::Slit => said!("seen through a slit"),
            Self::Unslit => said!("its slit taken off"),
            Self::Corrected => said!("corrected by an instrument"),
            Self::Learnt => said!("an instrument, learnt"),
            Self::Changed => said!("what changed"),
        }
    }

    /// What it is for, a sentence.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Mean => {
                said!("Scans of one light: three or more tell how well every figure is known.")
            }
            Self::Difference => said!("A light less its dark, or less a background."),
            Self::Sum => said!("Two lights at once."),
            Self::Quotient => {
                said!("A sample over its reference: the share that is let through or sent back.")
            }
            Self::QuotientLessDark => {
                said!("The same for counts, the instrument's dark taken off both.")
            }
            Self::Absorbance => said!("The decadic absorbance of a sample over its reference."),
            Self::Splice => said!("Two ranges of one light that share 20 nm or more."),
            Self::Slit => said!("A light as an instrument of a wider slit sees it."),
            Self::Unslit => said!("A light without what the instrument's slit did to it."),
            Self::Corrected => {
                said!("A reading in counts as a light: the instrument's response taken off.")
            }
            Self::Learnt => {
                said!("An instrument's response, by its reading of a light that is known.")
            }
            Self::Changed => {
                said!("The differences between two sets of scans that are beyond their noise.")
            }
        }
    }

    /// The places that it needs a spectrum for; none for verbs of any number of scans.
    pub fn slots(self) -> &'static [Slot] {
        match self {
            Self::Mean | Self::Changed => &[],
            Self::Difference => {
                const DARK: Slot = slot(
                    later!("Dark B"),
                    later!("The dark or the background that is taken off."),
                );
                &const { [LIGHT, DARK] }
            }
            Self::Sum => {
                &const {
                    [
                        LIGHT,
                        slot(later!("Light B"), later!("The light that is added.")),
                    ]
                }
            }
            Self::Quotient | Self::Absorbance => &const { [SAMPLE, REFERENCE] },
            Self::QuotientLessDark => {
                const DARK: Slot = slot(
                    later!("Dark C"),
                    later!("What the instrument counts without light."),
                );
                &const { [SAMPLE, REFERENCE, DARK] }
            }
            Self::Splice => {
                const FIRST: Slot =
                    slot(later!("Range A"), later!("The range that keeps its level."));
                const SECOND: Slot = slot(
                    later!("Range B"),
                    later!("It is brought to the level of A."),
                );
                &const { [FIRST, SECOND] }
            }
            Self::Slit | Self::Unslit => &const { [LIGHT] },
            Self::Corrected | Self::Learnt => {
                &const {
                    [slot(
                        later!("Reading A"),
                        later!("A reading, its dark taken off before."),
                    )]
                }
            }
        }
    }
}
