//! What an encoder or a decoder cannot do.

use std::fmt;

use crate::spectrum::Band;

/// Why there is no encoding, or no spectrum of one.
#[derive(Clone, Debug, PartialEq)]
pub enum EncodingError {
    /// Fewer numbers than any way of encoding takes, or more than the grid carries.
    Numbers {
        /// What was asked for.
        found: usize,
        /// Fewest and most.
        expected: [usize; 2],
    },
    /// Values and grid differ in number.
    Points {
        /// Values.
        found: usize,
        /// Grid points.
        expected: usize,
    },
    /// A value that is no finite number (`index` counts from 0).
    NotFinite {
        /// Where it stands.
        index: usize,
    },
    /// A spectrum without a positive Y on the band.
    NoColour {
        /// The band.
        band: Band,
    },
    /// The band misses so much of the visible that X, Y and Z cannot be told apart.
    Unseen {
        /// The band.
        band: Band,
    },
    /// The band is longer than an encoder takes.
    TooLong {
        /// The band.
        band: Band,
        /// Most nm.
        most: usize,
    },
    /// Another band.
    Band {
        /// The encoding's.
        found: Band,
        /// The decoder's.
        expected: Band,
    },
    /// A known lamp that is not in the list, or does not cover the band.
    Lamp {
        /// Its index.
        found: u8,
    },
    /// Words that are no encoding.
    Words {
        /// What stands there.
        found: String,
        /// What should.
        expected: &'static str,
    },
    /// A number too large for a 32-bit word.
    TooLarge {
        /// The number.
        found: f64,
    },
    /// Values too small for numbers that keep their digits in 32-bit words.
    TooSmall {
        /// The largest of them.
        found: f64,
        /// What the largest should be at least.
        least: f64,
    },
}

/// Ends of a band in words.
fn range(band: Band) -> String {
    format!("{}-{} nm", band.min_nm(), band.max_nm())
}

impl fmt::Display for EncodingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Numbers {
                found,
                expected: [least, most],
            } => write!(f, "numbers: expected {least} to {most}, found {found}"),
            Self::Points { found, expected } => {
                write!(f, "expected {expected} values, one a nm, found {found}")
            }
            Self::NotFinite { index } => write!(f, "value {}: expected a finite number", index + 1),
            Self::NoColour { band } => write!(
                f,
                "expected light that the eye sees within {}, found none",
                range(*band)
            ),
            Self::Unseen { band } => write!(
                f,
                "expected a range that holds the visible, found {}",
                range(*band)
            ),
            Self::TooLong { band, most } => write!(
                f,
                "expected a range of at most {most} nm, found {}",
                range(*band)
            ),
            Self::Band { found, expected } => {
                write!(f, "expected {}, found {}", range(*expected), range(*found))
            }
            Self::Lamp { found } => write!(
                f,
                "expected a known lamp that covers the range, found index {found}"
            ),
            Self::Words { found, expected } => write!(f, "expected {expected}, found {found}"),
            Self::TooLarge { found } => {
                write!(f, "expected numbers below 1e38, found {found:e}")
            }
            Self::TooSmall { found, least } => write!(
                f,
                "expected values that reach {least:e}, as words hold no smaller ones, found {found:.2e} \
                 at most (multiply them all)"
            ),
        }
    }
}

impl std::error::Error for EncodingError {}
