//! What efficacy is traded for along a front.

use std::str::FromStr;

use serde::{Deserialize, Serialize};

use super::figures::MixFigures;
use crate::design::{mixture::MixError, scales::Figure};

/// Which figure the efficacy is traded for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Against {
    /// The fidelity index.
    #[default]
    Rf,
    /// The colour rendering index.
    Ra,
}

impl Against {
    /// The figure by its samples.
    pub(super) fn figure(self) -> Figure {
        match self {
            Self::Rf => Figure::Rf,
            Self::Ra => Figure::Ra,
        }
    }

    /// The figure of a light, where it has one.
    pub fn of(self, figures: &MixFigures) -> Option<f64> {
        match self {
            Self::Rf => figures.rf,
            Self::Ra => figures.ra,
        }
    }
}

impl FromStr for Against {
    type Err = MixError;

    /// `rf,ler` or `ra,ler`.
    fn from_str(words: &str) -> Result<Self, MixError> {
        match words {
            "rf,ler" => Ok(Self::Rf),
            "ra,ler" => Ok(Self::Ra),
            _ => Err(MixError::Word {
                found: words.to_owned(),
                expected: "rf,ler or ra,ler",
            }),
        }
    }
}
