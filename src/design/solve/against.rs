//! What efficacy is traded for along a front.

use std::str::FromStr;

use crate::design::mixture::MixError;

/// Which figure the efficacy is traded for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Against {
    /// The fidelity index.
    Rf,
    /// The colour rendering index.
    Ra,
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
