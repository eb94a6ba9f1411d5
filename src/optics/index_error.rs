//! Why a material has no index at a wavelength.

use crate::languages::{fixed, translated, with_sign};

/// A material is clear while its extinction coefficient k is at most this: of 500 nm light 1e-4
/// leaves 8 % behind 1 mm (`exp(-4 pi k 1 mm / 500 nm)`), and a body of several mm is black.
pub(super) const MOST_EXTINCTION: f64 = 1e-4;

/// Why there is no index.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum IndexError {
    /// A wavelength that is not a positive number.
    #[error(
        "{}",
        tr!(
            "expected a wavelength above 0 nm, found {found_nm} nm",
            found_nm = with_sign(found_nm.to_string())
        )
    )]
    NotAWavelength { found_nm: f64 },
    /// Too near to a resonance in the ultraviolet or beyond one in the infrared.
    #[error(
        "{}",
        tr!(
            "{material}: expected a wavelength between its resonances, {from_nm} to {to_nm} nm, \
             found {found_nm} nm",
            material = translated(material),
            from_nm = fixed(from_nm, 1),
            to_nm = fixed(to_nm, 0),
            found_nm = with_sign(found_nm.to_string())
        )
    )]
    Resonance {
        material: String,
        found_nm: f64,
        from_nm: f64,
        to_nm: f64,
    },
    /// A wavelength at which no ray goes on through it: n of 1 or less, k above
    /// `MOST_EXTINCTION`, or no real n at all.
    #[error("{}", opaque(material, *.found_nm, *.n, *.k))]
    NotTransparent {
        material: String,
        found_nm: f64,
        n: f64,
        k: f64,
    },
    /// A table, or the formula of a file, knows nothing there.
    #[error(
        "{}",
        tr!(
            "{material}: expected a wavelength at which its index is known, {from_nm} to {to_nm} \
             nm, found {found_nm} nm",
            material = translated(material),
            from_nm = with_sign(from_nm.to_string()),
            to_nm = with_sign(to_nm.to_string()),
            found_nm = with_sign(found_nm.to_string())
        )
    )]
    OutsideTable {
        material: String,
        found_nm: f64,
        from_nm: f64,
        to_nm: f64,
    },
    /// An n_d of two numbers that is no denser than air.
    #[error(
        "{}",
        tr!(
            "n_d: expected a number from 1.0001 to 10, found {found}",
            found = with_sign(found.to_string())
        )
    )]
    TooThin { found: f64 },
    /// A V_d of two numbers that is not positive.
    #[error(
        "{}",
        tr!("V_d: expected a number above 0, found {found}", found = with_sign(found.to_string()))
    )]
    BadAbbe { found: f64 },
    /// A table whose values are no indices.
    #[error(
        "{}",
        tr!(
            "expected indices of refraction above 0, found {found} at {at_nm} nm",
            found = with_sign(found.to_string()),
            at_nm = with_sign(at_nm.to_string())
        )
    )]
    BadTable { found: f64, at_nm: f64 },
}

impl IndexError {
    /// True if the material transmits no ray there.
    pub(super) fn is_opaque(&self) -> bool {
        matches!(self, Self::NotTransparent { .. })
    }
}

fn opaque(material: &str, at_nm: f64, n: f64, k: f64) -> String {
    let (material, at) = (translated(material), with_sign(at_nm.to_string()));
    if !n.is_finite() {
        return tr!(
            "{material}: expected a transparent material, found no index at {at} nm",
            material,
            at
        );
    }
    tr!(
        "{material}: expected a transparent material (n above 1, k at most {most}), found n {n}, \
         k {k} at {at} nm",
        material,
        most = with_sign(MOST_EXTINCTION.to_string()),
        n = fixed(n, 4),
        k = fixed(k, 4),
        at
    )
}
