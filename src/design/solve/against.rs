//! The figures that efficacy is traded against along a front.

use std::str::FromStr;

use super::figures::MixFigures;
use crate::design::{mixture::MixError, scales::Against};

impl Against {
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
