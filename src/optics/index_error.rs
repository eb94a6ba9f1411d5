//! Why a material has no index at a wavelength.

use std::fmt;

/// A material is clear while its extinction coefficient k is at most this: of 500 nm light 1e-4
/// leaves 8 % behind 1 mm (`exp(-4 pi k 1 mm / 500 nm)`), and a body of several mm is black.
pub(super) const MOST_EXTINCTION: f64 = 1e-4;

/// Why there is no index.
#[derive(Clone, Debug, PartialEq)]
pub enum IndexError {
    /// A wavelength that is not a positive number.
    NotAWavelength { found_nm: f64 },
    /// Too near to a resonance in the ultraviolet or beyond one in the infrared.
    Resonance {
        material: String,
        found_nm: f64,
        from_nm: f64,
        to_nm: f64,
    },
    /// A wavelength at which no ray goes on through it: n of 1 or less, k above
    /// `MOST_EXTINCTION`, or no real n at all.
    NotTransparent {
        material: String,
        found_nm: f64,
        n: f64,
        k: f64,
    },
    /// A table, or the formula of a file, knows nothing there.
    OutsideTable {
        material: String,
        found_nm: f64,
        from_nm: f64,
        to_nm: f64,
    },
    /// An n_d of two numbers that is no denser than air.
    TooThin { found: f64 },
    /// A V_d of two numbers that is not positive.
    BadAbbe { found: f64 },
    /// A table whose values are no indices.
    BadTable { found: f64, at_nm: f64 },
}

impl fmt::Display for IndexError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotAWavelength { found_nm } => {
                write!(f, "expected a wavelength above 0 nm, found {found_nm} nm")
            }
            Self::Resonance {
                material,
                found_nm,
                from_nm,
                to_nm,
            } => write!(
                f,
                "{material}: expected a wavelength between its resonances, {from_nm:.1} to \
                 {to_nm:.0} nm, found {found_nm} nm"
            ),
            Self::NotTransparent {
                material,
                found_nm,
                n,
                ..
            } if !n.is_finite() => write!(
                f,
                "{material}: expected a transparent material, found no index at {found_nm} nm"
            ),
            Self::NotTransparent {
                material,
                found_nm,
                n,
                k,
            } => write!(
                f,
                "{material}: expected a transparent material (n above 1, k at most \
                 {MOST_EXTINCTION}), found n {n:.4}, k {k:.4} at {found_nm} nm"
            ),
            Self::OutsideTable {
                material,
                found_nm,
                from_nm,
                to_nm,
            } => write!(
                f,
                "{material}: expected a wavelength at which its index is known, {from_nm} to {to_nm} \
                 nm, found {found_nm} nm"
            ),
            Self::TooThin { found } => {
                write!(f, "n_d: expected a number from 1.0001 to 10, found {found}")
            }
            Self::BadAbbe { found } => write!(f, "V_d: expected a number above 0, found {found}"),
            Self::BadTable { found, at_nm } => write!(
                f,
                "expected indices of refraction above 0, found {found} at {at_nm} nm"
            ),
        }
    }
}

impl std::error::Error for IndexError {}
