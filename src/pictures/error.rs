//! Why a picture cannot be made, stored, opened or relit.

use crate::{
    io::{WriteError, part_of_message},
    languages::with_sign,
};

/// Why a picture cannot be made, stored, opened or relit.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PictureError {
    /// Fewer than three bands are left.
    #[error("{}", tr!("expected 3 bands or more, found {found}", found))]
    TooFewBands { found: usize },
    /// Wavelengths that do not rise strictly, or are no numbers.
    #[error(
        "{}",
        tr!(
            "expected bands at rising wavelengths above 0 nm, found band {number} out of order",
            number = index + 1
        )
    )]
    NotRising { index: usize },
    /// No pixel has all of its bands.
    #[error("{}", said!("expected a measured pixel, found none that has all of its bands"))]
    NothingMeasured,
    /// Every measured value is zero, or nothing is above it.
    #[error(
        "{}",
        said!("expected values above zero that a file of 32-bit numbers holds, found none")
    )]
    AllZero,
    /// The own light does not shine on the bands.
    #[error(
        "{}",
        tr!(
            "expected an own light that shines on the bands, found {light}, which is zero there",
            light
        )
    )]
    NoOwnLight { light: String },
    /// A known light and the bands have no wavelength in common.
    #[error(
        "{}",
        tr!("expected a known light that overlaps the bands, found {light}, which does not", light)
    )]
    NoOverlap { light: String },
    /// A line stands outside the bands.
    #[error(
        "{}",
        tr!(
            "expected a line between the bands' ends {first_nm} and {last_nm} nm, found {at_nm}",
            first_nm = with_sign(first_nm.to_string()),
            last_nm = with_sign(last_nm.to_string()),
            at_nm = with_sign(at_nm.to_string())
        )
    )]
    LineOutside {
        at_nm: f64,
        first_nm: f64,
        last_nm: f64,
    },
    /// A count of numbers, of a pixel or a spectrum, that cannot be had.
    #[error(
        "{}",
        tr!(
            "expected 3 to {most} numbers, fewer than there are wavelengths, found {found}",
            most,
            found
        )
    )]
    Numbers { found: usize, most: usize },
    /// The bands do not tell the coefficients apart.
    #[error("{}", said!("expected bands that tell the numbers apart, found some that do not"))]
    NotSolved,
    /// Relighting what cannot be relit; the words say why and what to do.
    #[error("{0}")]
    NoRelighting(String),
    /// Content of a file that is not as it should be.
    #[error("{}", tr!("expected {expected}, found {found}", expected, found))]
    Broken { found: String, expected: String },
    /// More memory than a file of its size may take.
    #[error(
        "{}",
        tr!(
            "expected a picture of at most {most} MiB for a file of its size, found {needs} MiB",
            most = most >> 20,
            needs = needs >> 20
        )
    )]
    Memory { needs: usize, most: usize },
    /// Reading or writing failed.
    #[error("{0}")]
    Trouble(String),
    /// More lines by hand than numbers beside three of the series.
    #[error(
        "{}",
        tr!(
            "expected at most {most} lines of {numbers} numbers a pixel, three of which are the \
             series', found {lines}",
            most = numbers.saturating_sub(3),
            numbers,
            lines
        )
    )]
    TooManyLines { lines: usize, numbers: usize },
    /// A file that could not be saved; the words name it.
    #[error("{0}")]
    Unsaved(String),
    /// It was cancelled.
    #[error("{}", said!("cancelled"))]
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
