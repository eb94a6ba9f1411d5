//! Why a picture cannot be made, stored, opened or relit.

use std::fmt;

use crate::io::{WriteError, part_of_message};

/// Why a picture cannot be made, stored, opened or relit.
#[derive(Clone, Debug, PartialEq)]
pub enum PictureError {
    /// Fewer than three bands are left.
    TooFewBands { found: usize },
    /// Wavelengths that do not rise strictly, or are no numbers.
    NotRising { index: usize },
    /// No pixel has all of its bands.
    NothingMeasured,
    /// Every measured value is zero, or nothing is above it.
    AllZero,
    /// The own light does not shine on the bands.
    NoOwnLight { light: String },
    /// A known light and the bands have no wavelength in common.
    NoOverlap { light: String },
    /// A line stands outside the bands.
    LineOutside {
        at_nm: f64,
        first_nm: f64,
        last_nm: f64,
    },
    /// A count of numbers, of a pixel or a spectrum, that cannot be had.
    Numbers { found: usize, most: usize },
    /// The bands do not tell the coefficients apart.
    NotSolved,
    /// Relighting what cannot be relit; the words say why and what to do.
    NoRelighting(String),
    /// Content of a file that is not as it should be.
    Broken { found: String, expected: String },
    /// More memory than a file of its size may take.
    Memory { needs: usize, most: usize },
    /// Reading or writing failed.
    Trouble(String),
    /// More lines by hand than numbers beside three of the series.
    TooManyLines { lines: usize, numbers: usize },
    /// A file that could not be saved; the words name it.
    Unsaved(String),
    /// It was cancelled.
    Cancelled,
}

impl PictureError {
    pub(super) fn broken(found: impl Into<String>, expected: impl Into<String>) -> Self {
        Self::Broken {
            found: part_of_message(&found.into()),
            expected: part_of_message(&expected.into()),
        }
    }
}

impl fmt::Display for PictureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFewBands { found } => write!(f, "expected 3 bands or more, found {found}"),
            Self::NotRising { index } => write!(
                f,
                "expected bands at rising wavelengths above 0 nm, found band {} out of order",
                index + 1
            ),
            Self::NothingMeasured => {
                f.write_str("expected a measured pixel, found none that has all of its bands")
            }
            Self::AllZero => f.write_str(
                "expected values above zero that a file of 32-bit numbers holds, found none",
            ),
            Self::NoOwnLight { light } => write!(
                f,
                "expected an own light that shines on the bands, found {light}, which is zero there"
            ),
            Self::NoOverlap { light } => write!(
                f,
                "expected a known light that overlaps the bands, found {light}, which does not"
            ),
            Self::LineOutside {
                at_nm,
                first_nm,
                last_nm,
            } => write!(
                f,
                "expected a line between the bands' ends {first_nm} and {last_nm} nm, found {at_nm}"
            ),
            Self::Numbers { found, most } => write!(
                f,
                "expected 3 to {most} numbers, fewer than there are wavelengths, found {found}"
            ),
            Self::NotSolved => {
                f.write_str("expected bands that tell the numbers apart, found some that do not")
            }
            Self::NoRelighting(why) => f.write_str(why),
            Self::Broken { found, expected } => write!(f, "expected {expected}, found {found}"),
            Self::Memory { needs, most } => write!(
                f,
                "expected a picture of at most {} MiB for a file of its size, found {} MiB",
                most >> 20,
                needs >> 20
            ),
            Self::Trouble(words) | Self::Unsaved(words) => f.write_str(words),
            Self::TooManyLines { lines, numbers } => write!(
                f,
                "expected at most {} lines of {numbers} numbers a pixel, three of which are the \
                 series', found {lines}",
                numbers.saturating_sub(3)
            ),
            Self::Cancelled => f.write_str("cancelled"),
        }
    }
}

impl std::error::Error for PictureError {}

impl From<WriteError> for PictureError {
    fn from(error: WriteError) -> Self {
        Self::Unsaved(error.to_string())
    }
}

impl From<std::io::Error> for PictureError {
    fn from(error: std::io::Error) -> Self {
        Self::Trouble(error.to_string())
    }
}
