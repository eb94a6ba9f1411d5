//! Why a spectrum cannot be made from a colour.

use super::method::Method;
use crate::{design::small::digits, languages::with_sign};

/// Why a spectrum cannot be made from a colour.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RecoverError {
    /// The light has no visible power.
    #[error("{}", said!("light: expected visible power, found none"))]
    NoLight,
    /// The light's waves are too few, or too much alike, for three independent numbers.
    #[error(
        "{}",
        tr!(
            "light: expected one that shows three independent colours, found one whose waves are \
             too few (condition number {condition})",
            condition = with_sign(format!("{condition:.1e}"))
        )
    )]
    FewColours {
        /// Ratio of the greatest to the least singular value of what it shows.
        condition: f64,
    },
    /// A colour is not made of finite numbers.
    #[error("{}", said!("colour: expected three finite numbers, found others"))]
    NotAColour,
    /// The screen's colours cannot be adapted to so narrow a light.
    #[error(
        "{}",
        said!(
            "colour: expected XYZ or Lab under a light too narrow to adapt to, found a screen's \
             colour"
        )
    )]
    TooNarrowToAdapt,
    /// A method was given another number of colours than it takes.
    #[error(
        "{}",
        tr!(
            "{method}: expected {expected}, found {found}",
            method = method.word(),
            expected = method.colours_words(),
            found
        )
    )]
    Colours {
        /// The method.
        method: Method,
        /// The number of colours given.
        found: usize,
    },
    /// The two lights tell the same of every surface.
    #[error(
        "{}",
        tr!(
            "lights: expected two that differ, found two that tell the same (condition number \
             {condition})",
            condition = with_sign(format!("{condition:.1e}"))
        )
    )]
    SameLights {
        /// Condition number of the six equations.
        condition: f64,
    },
    /// A line stands where the eye sees nothing, or not at a wavelength at all.
    #[error(
        "{}",
        tr!(
            "lines: expected places in 380-780 nm, found {place}",
            place = with_sign(digits(*found_nm))
        )
    )]
    LineOutside {
        /// Its place.
        found_nm: f64,
    },
    /// No lines, or too many.
    #[error("{}", tr!("lines: expected 1 to 32, found {found}", found))]
    Lines {
        /// The number of lines found.
        found: usize,
    },
    /// The background has no power in 380-780 nm, or less than none.
    #[error("{}", said!("background: expected power in 380-780 nm, none of it negative"))]
    NoBackground,
    /// A picture's pixels and its size do not agree.
    #[error(
        "{}",
        tr!("picture: expected {expected} numbers for its size, found {found}", expected, found)
    )]
    Picture {
        /// Numbers that its size asks for.
        expected: usize,
        /// Numbers given.
        found: usize,
    },
    /// Bands of a spectral picture that are no axis.
    #[error("{}", said!("bands: expected two or more rising places in 380-780 nm"))]
    Bands,
    /// The search for powers ended without an answer.
    #[error("{}", tr!("powers: found no answer: {why}", why))]
    NotSolved {
        /// Why.
        why: String,
    },
}
