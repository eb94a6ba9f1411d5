//! Errors of encoders and decoders.

use crate::spectrum::Band;

/// Why there is no encoding, or no spectrum of one.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum EncodingError {
    /// Fewer numbers than any way of encoding takes, or more than the grid carries; `expected` are
    /// fewest and most.
    #[error("numbers: expected {} to {}, found {found}", expected[0], expected[1])]
    Numbers { found: usize, expected: [usize; 2] },
    /// Values and grid differ in number.
    #[error("expected {expected} values, one a nm, found {found}")]
    Points { found: usize, expected: usize },
    /// A value that is no finite number (`index` counts from 0).
    #[error("value {}: expected a finite number", index + 1)]
    NotFinite { index: usize },
    /// A spectrum without a positive Y on the band.
    #[error("expected light that the eye sees within {}, found none", range(band))]
    NoColour { band: Band },
    /// The band misses so much of the visible that X, Y and Z cannot be told apart.
    #[error("expected a range that holds the visible, found {}", range(band))]
    Unseen { band: Band },
    /// The band is longer than an encoder takes.
    #[error("expected a range of at most {most} nm, found {}", range(band))]
    TooLong { band: Band, most: usize },
    /// Another band.
    #[error("expected {}, found {}", range(expected), range(found))]
    Band { found: Band, expected: Band },
    /// A known lamp that is not in the list, or does not cover the band.
    #[error("expected a known lamp that covers the range, found index {found}")]
    Lamp { found: u8 },
    /// Words that are no encoding.
    #[error("expected {expected}, found {found}")]
    Words {
        found: String,
        expected: &'static str,
    },
    /// A number too large for a 32-bit word.
    #[error("expected numbers below 1e38, found {found:e}")]
    TooLarge { found: f64 },
    /// Values too small for numbers that keep their digits in 32-bit words; `found` is the largest,
    /// `least` what it should be at least.
    #[error(
        "expected values that reach {least:e}, as words hold no smaller ones, found {found:.2e} \
         at most (multiply them all)"
    )]
    TooSmall { found: f64, least: f64 },
}

/// Ends of a band in words.
fn range(band: &Band) -> String {
    format!("{}-{} nm", band.min_nm(), band.max_nm())
}
