//! Why a figure does not exist, in words.

use std::fmt;

use crate::color::{NoCct, Observer};

/// Why there is no light to weigh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Dark {
    /// Every value is zero.
    AllZero,
    /// Nothing of it lies where the tables of the CIE reach.
    Outside {
        /// First wavelength of its table, nm.
        first_nm: f64,
        /// Last wavelength of its table, nm.
        last_nm: f64,
    },
    /// A value, or an area on the way to whole nm, is no finite number.
    NotFinite,
}

/// Why a figure does not exist.
#[derive(Clone, Debug, PartialEq)]
pub enum NoFigure {
    /// There is no light.
    Dark(Dark),
    /// A sum that divides is not positive: negative samples outweigh the rest, or the light lies
    /// where the weight is zero.
    NotPositive {
        /// What was summed.
        sum: &'static str,
    },
    /// No correlated colour temperature, so no reference light.
    NoCct(NoCct),
    /// The light has nothing where an observer's tables begin.
    BelowObserver {
        /// The observer.
        observer: Observer,
        /// First wavelength of its tables, nm.
        first_nm: u32,
    },
    /// Too near the white to have a hue.
    NearWhite {
        /// Distance from E in xy.
        distance: f64,
    },
    /// The ray meets the violet end of the locus, which hardly moves there.
    VioletEnd,
    /// The ray meets the red end of the locus, which hardly moves there.
    RedEnd,
    /// The formula leaves its range for this light.
    OutOfRange {
        /// What broke.
        what: &'static str,
    },
    /// The unit does not say what is measured.
    NoUnit,
    /// A line of no width has no height.
    LineWithoutHeight {
        /// Where the heaviest stands, nm.
        heaviest_nm: f64,
    },
    /// More than one stretch reaches half of the maximum.
    ManyRuns {
        /// How many.
        runs: usize,
    },
    /// The stretch above half of the maximum touches an end of the table.
    TouchesEnd {
        /// Which end, nm.
        at_nm: u32,
    },
    /// A reference light is dark in the range that is compared.
    DarkReference,
    /// Left out for want of tables.
    NoTables {
        /// Which.
        which: &'static str,
    },
}

impl From<Dark> for NoFigure {
    fn from(dark: Dark) -> Self {
        Self::Dark(dark)
    }
}

impl From<NoCct> for NoFigure {
    fn from(no: NoCct) -> Self {
        Self::NoCct(no)
    }
}

impl fmt::Display for Dark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::AllZero => f.write_str("no light: every value is zero"),
            Self::Outside { first_nm, last_nm } => write!(
                f,
                "no light between 360 and 830 nm: the table is of {first_nm} to {last_nm} nm"
            ),
            Self::NotFinite => f.write_str("expected finite values, found one that is too large"),
        }
    }
}

impl fmt::Display for NoFigure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Dark(dark) => dark.fmt(f),
            Self::NotPositive { sum } => write!(
                f,
                "expected a positive {sum}, found none: nothing visible, or negative samples outweigh the rest"
            ),
            Self::NoCct(no) => no.fmt(f),
            Self::BelowObserver { observer, first_nm } => write!(
                f,
                "the tables of {observer} begin at {first_nm} nm, and the light has nothing from there on"
            ),
            Self::NearWhite { distance } => write!(
                f,
                "no hue: {distance:.5} from the equal-energy white in xy, nearer than 0.0003"
            ),
            Self::VioletEnd => f.write_str(
                "violet end: the hue is that of the locus below 400 nm, where it hardly moves",
            ),
            Self::RedEnd => f.write_str(
                "red end: the hue is that of the locus above 690 nm, where it hardly moves",
            ),
            Self::OutOfRange { what } => write!(f, "out of the formula's range: {what}"),
            Self::NoUnit => f.write_str(
                "needs values in W per nm (and per m2 or sr), and the unit here does not say that they are",
            ),
            Self::LineWithoutHeight { heaviest_nm } => write!(
                f,
                "a line of no width has no height; the heaviest stands at {heaviest_nm:.1} nm"
            ),
            Self::ManyRuns { runs } => {
                write!(f, "{runs} separate stretches reach half of the maximum")
            }
            Self::TouchesEnd { at_nm } => write!(
                f,
                "still above half of the maximum at {at_nm} nm, where the table or the visible ends"
            ),
            Self::DarkReference => f.write_str("the reference has no light in 375-675 nm"),
            Self::NoTables { which } => f.write_str(which),
        }
    }
}

impl std::error::Error for NoFigure {}
