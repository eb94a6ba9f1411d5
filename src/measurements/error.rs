//! Why measurements cannot be taken together, in words.

use std::fmt;

use crate::spectrum::SampledError;

/// Why measurements cannot be taken together.
#[derive(Clone, Debug, PartialEq)]
pub enum MeasurementError {
    /// The combination means nothing; the sentence says which does.
    Meaningless(String),
    /// They share too little of the spectrum.
    Apart(String),
    /// There are more points than are computed with.
    TooMany { points: usize, most: usize },
    /// The result is no table.
    NoTable(SampledError),
    /// Nothing of the result is above the noise.
    AllMasked(String),
}

impl fmt::Display for MeasurementError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Meaningless(why) | Self::Apart(why) | Self::AllMasked(why) => f.write_str(why),
            Self::TooMany { points, most } => {
                let words = tr!(
                    "found {points} points, expected at most {most}",
                    points,
                    most
                );
                f.write_str(&words)
            }
            Self::NoTable(why) => f.write_str(&tr!("the result is no table: {why}", why)),
        }
    }
}

impl std::error::Error for MeasurementError {}

impl From<SampledError> for MeasurementError {
    fn from(why: SampledError) -> Self {
        Self::NoTable(why)
    }
}
