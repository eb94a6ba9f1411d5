//! Why a spectrum cannot be made from a colour.

use std::fmt;

use super::method::Method;
use crate::design::small::digits;

/// Why a spectrum cannot be made from a colour.
#[derive(Clone, Debug, PartialEq)]
pub enum RecoverError {
    /// The light has no visible power.
    NoLight,
    /// The light's waves are too few, or too much alike, for three independent numbers.
    FewColours {
        /// Ratio of the greatest to the least singular value of what it shows.
        condition: f64,
    },
    /// A colour is not made of finite numbers.
    NotAColour,
    /// The screen's colours cannot be adapted to so narrow a light.
    TooNarrowToAdapt,
    /// A method was given another number of colours than it takes.
    Colours {
        /// The method.
        method: Method,
        /// How many it was given.
        found: usize,
    },
    /// The two lights tell the same of every surface.
    SameLights {
        /// Condition number of the six equations.
        condition: f64,
    },
    /// A line stands where the eye sees nothing, or not at a wavelength at all.
    LineOutside {
        /// Its place.
        found_nm: f64,
    },
    /// No lines, or too many.
    Lines {
        /// How many.
        found: usize,
    },
    /// The background has no power in 380-780 nm, or less than none.
    NoBackground,
    /// A picture's pixels and its size do not agree.
    Picture {
        /// Numbers that its size asks for.
        expected: usize,
        /// Numbers given.
        found: usize,
    },
    /// Bands of a spectral picture that are no axis.
    Bands,
    /// The search for powers ended without an answer.
    NotSolved {
        /// Why.
        why: String,
    },
}

impl fmt::Display for RecoverError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoLight => f.write_str("light: expected visible power, found none"),
            Self::FewColours { condition } => write!(
                f,
                "light: expected one that shows three independent colours, found one whose waves \
                 are too few (condition number {condition:.1e})"
            ),
            Self::NotAColour => f.write_str("colour: expected three finite numbers, found others"),
            Self::TooNarrowToAdapt => f.write_str(
                "colour: expected XYZ or Lab under a light too narrow to adapt to, found a \
                 screen's colour",
            ),
            Self::Colours { method, found } => write!(
                f,
                "{}: expected {}, found {found}",
                method.word(),
                method.colours_words()
            ),
            Self::SameLights { condition } => write!(
                f,
                "lights: expected two that differ, found two that tell the same (condition number \
                 {condition:.1e})"
            ),
            Self::LineOutside { found_nm } => {
                let found = digits(*found_nm);
                write!(f, "lines: expected places in 380-780 nm, found {found}")
            }
            Self::Lines { found } => write!(f, "lines: expected 1 to 32, found {found}"),
            Self::NoBackground => {
                f.write_str("background: expected power in 380-780 nm, none of it negative")
            }
            Self::Picture { expected, found } => write!(
                f,
                "picture: expected {expected} numbers for its size, found {found}"
            ),
            Self::NotSolved { why } => write!(f, "powers: found no answer: {why}"),
            Self::Bands => f.write_str("bands: expected two or more rising places in 380-780 nm"),
        }
    }
}

impl std::error::Error for RecoverError {}
