//! Why a figure does not exist, in words.

use crate::{
    color::{NoCct, Observer},
    languages::{fixed, said, with_sign},
};

/// Why there is no light to weigh.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Dark {
    /// Every value is zero.
    #[error("{}", said!("no light: every value is zero"))]
    AllZero,
    /// Nothing of it lies where the tables of the CIE reach.
    #[error(
        "{}",
        tr!(
            "no light between 360 and 830 nm: the table is of {first_nm} to {last_nm} nm",
            first_nm = with_sign(first_nm.to_string()),
            last_nm = with_sign(last_nm.to_string())
        )
    )]
    Outside {
        /// First wavelength of its table, nm.
        first_nm: f64,
        /// Last wavelength of its table, nm.
        last_nm: f64,
    },
    /// A value, or an area on the way to whole nm, is no finite number.
    #[error("{}", said!("expected finite values, found one that is too large"))]
    NotFinite,
}

/// Why a figure does not exist.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NoFigure {
    /// There is no light.
    #[error(transparent)]
    Dark(#[from] Dark),
    /// A sum that divides is not positive: negative samples outweigh the rest, or the light lies
    /// where the weight is zero.
    #[error(
        "{}",
        tr!(
            "expected a positive {sum}, found none: nothing visible, or negative samples outweigh \
             the rest",
            sum = said(sum)
        )
    )]
    NotPositive {
        /// Name of the sum.
        sum: &'static str,
    },
    /// No correlated colour temperature, so no reference light.
    #[error(transparent)]
    NoCct(#[from] NoCct),
    /// The light has nothing where an observer's tables begin.
    #[error(
        "{}",
        tr!(
            "the tables of {observer} begin at {first_nm} nm, and the light has nothing from \
             there on",
            observer,
            first_nm
        )
    )]
    BelowObserver {
        /// The observer.
        observer: Observer,
        /// First wavelength of its tables, nm.
        first_nm: u32,
    },
    /// Too near the white to have a hue.
    #[error(
        "{}",
        tr!(
            "no hue: {distance} from the equal-energy white in xy, nearer than 0.0003",
            distance = fixed(distance, 5)
        )
    )]
    NearWhite {
        /// Distance from E in xy.
        distance: f64,
    },
    /// The ray meets the violet end of the locus, which hardly moves there.
    #[error(
        "{}",
        said!("violet end: the hue is that of the locus below 400 nm, where it hardly moves")
    )]
    VioletEnd,
    /// The ray meets the red end of the locus, which hardly moves there.
    #[error(
        "{}",
        said!("red end: the hue is that of the locus above 690 nm, where it hardly moves")
    )]
    RedEnd,
    /// The formula leaves its range for this light.
    #[error("{}", tr!("out of the formula's range: {what}", what = said(what)))]
    OutOfRange {
        /// Quantity or condition that failed.
        what: &'static str,
    },
    /// Not computed, and why.
    #[error("{}", said(.0))]
    LeftOut(&'static str),
    /// The unit does not say what is measured.
    #[error(
        "{}",
        said!(
            "needs values in W per nm (and per m2 or sr), and the unit here does not say that \
             they are"
        )
    )]
    NoUnit,
    /// A line of no width has no height.
    #[error(
        "{}",
        tr!(
            "a line of no width has no height; the heaviest stands at {heaviest_nm} nm",
            heaviest_nm = fixed(heaviest_nm, 1)
        )
    )]
    LineWithoutHeight {
        /// Wavelength of the heaviest line, nm.
        heaviest_nm: f64,
    },
    /// More than one stretch reaches half of the maximum.
    #[error("{}", tr!("{runs} separate stretches reach half of the maximum", runs))]
    ManyRuns {
        /// Number of stretches.
        runs: usize,
    },
    /// The stretch above half of the maximum touches an end of the table.
    #[error(
        "{}",
        tr!(
            "still above half of the maximum at {at_nm} nm, where the table or the visible ends",
            at_nm
        )
    )]
    TouchesEnd {
        /// Wavelength of that end, nm.
        at_nm: u32,
    },
    /// A reference light is dark in the range that is compared.
    #[error("{}", said!("the reference has no light in 375-675 nm"))]
    DarkReference,
    /// Left out for want of tables.
    #[error("{}", said(which))]
    NoTables {
        /// Which.
        which: &'static str,
    },
}
