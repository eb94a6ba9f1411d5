//! Errors of encoders and decoders.

use crate::{languages::with_sign, spectrum::Band};

/// Why there is no encoding, or no spectrum of one.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum EncodingError {
    /// Fewer numbers than any way of encoding takes, or more than the grid carries; `expected` are
    /// fewest and most.
    #[error(
        "{}",
        tr!(
            "numbers: expected {least} to {most}, found {found}",
            least = expected[0],
            most = expected[1],
            found
        )
    )]
    Numbers { found: usize, expected: [usize; 2] },
    /// Values and grid differ in number.
    #[error("{}", tr!("expected {expected} values, one a nm, found {found}", expected, found))]
    Points { found: usize, expected: usize },
    /// A value that is no finite number (`index` counts from 0).
    #[error("{}", tr!("value {number}: expected a finite number", number = index + 1))]
    NotFinite { index: usize },
    /// A spectrum without a positive Y on the band.
    #[error(
        "{}",
        tr!("expected light that the eye sees within {range}, found none", range = range(band))
    )]
    NoColour { band: Band },
    /// The band misses so much of the visible that X, Y and Z cannot be told apart.
    #[error(
        "{}",
        tr!("expected a range that holds the visible, found {range}", range = range(band))
    )]
    Unseen { band: Band },
    /// The band is longer than an encoder takes.
    #[error(
        "{}",
        tr!("expected a range of at most {most} nm, found {range}", most, range = range(band))
    )]
    TooLong { band: Band, most: usize },
    /// Another band.
    #[error(
        "{}",
        tr!(
            "expected {expected}, found {found}",
            expected = range(expected),
            found = range(found)
        )
    )]
    Band { found: Band, expected: Band },
    /// A known lamp that is not in the list, or does not cover the band.
    #[error("{}", tr!("expected a known lamp that covers the range, found index {found}", found))]
    Lamp { found: u8 },
    /// Words that are no encoding.
    #[error("{}", tr!("expected {expected}, found {found}", expected, found))]
    Words {
        found: String,
        expected: &'static str,
    },
    /// A number too large for a 32-bit word.
    #[error(
        "{}",
        tr!(
            "expected numbers below 1e38, found {found}",
            found = with_sign(format!("{found:e}"))
        )
    )]
    TooLarge { found: f64 },
    /// Values too small for numbers that keep their digits in 32-bit words; `found` is the largest,
    /// `least` what it should be at least.
    #[error(
        "{}",
        tr!(
            "expected values that reach {least}, as words hold no smaller ones, found {found} at \
             most (multiply them all)",
            least = with_sign(format!("{least:e}")),
            found = with_sign(format!("{found:.2e}"))
        )
    )]
    TooSmall { found: f64, least: f64 },
}

/// Ends of a band in words.
fn range(band: &Band) -> String {
    format!("{}-{} nm", band.min_nm(), band.max_nm())
}
