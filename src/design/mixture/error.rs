//! Why channels do not make a light.

use std::fmt;

/// Most channels of a mixture.
pub(crate) const MOST_CHANNELS: usize = 128;

/// Why channels do not make a light.
#[derive(Clone, Debug, PartialEq)]
pub enum MixError {
    /// A channel's words are not of a form that is known.
    Spec {
        /// The words.
        found: String,
        /// What they should have been.
        expected: String,
    },
    /// A light of a channel has no power in 360-830 nm, or less than none.
    NoPower {
        /// The channel.
        spec: String,
    },
    /// No channel, or too many.
    Channels {
        /// How many.
        found: usize,
    },
    /// A target that is no colour.
    Target {
        /// What it was.
        found: String,
        /// What it should have been.
        expected: String,
    },
    /// A floor or a figure that is not known.
    Word {
        /// The word.
        found: String,
        /// The words there are.
        expected: &'static str,
    },
}

impl fmt::Display for MixError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Spec { found, expected } => {
                write!(f, "channel: expected {expected}, found {found:?}")
            }
            Self::NoPower { spec } => write!(
                f,
                "channel {spec:?}: expected a light with power in 360-830 nm, found none"
            ),
            Self::Channels { found } => {
                write!(
                    f,
                    "channels: expected 1 to {}, found {found}",
                    MOST_CHANNELS
                )
            }
            Self::Target { found, expected } => {
                write!(f, "target: expected {expected}, found {found}")
            }
            Self::Word { found, expected } => write!(f, "expected {expected}, found {found:?}"),
        }
    }
}

impl std::error::Error for MixError {}
