//! Why a material has no index at a wavelength.

/// A material is clear while its extinction coefficient k is at most this: of 500 nm light 1e-4
/// leaves 8 % behind 1 mm (`exp(-4 pi k 1 mm / 500 nm)`), and a body of several mm is black.
pub(super) const MOST_EXTINCTION: f64 = 1e-4;

/// Why there is no index.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum IndexError {
    /// A wavelength that is not a positive number.
    #[error("expected a wavelength above 0 nm, found {found_nm} nm")]
    NotAWavelength { found_nm: f64 },
    /// Too near to a resonance in the ultraviolet or beyond one in the infrared.
    #[error(
        "{material}: expected a wavelength between its resonances, {from_nm:.1} to {to_nm:.0} nm, \
         found {found_nm} nm"
    )]
    Resonance {
        material: String,
        found_nm: f64,
        from_nm: f64,
        to_nm: f64,
    },
    /// A wavelength at which no ray goes on through it: n of 1 or less, k above
    /// `MOST_EXTINCTION`, or no real n at all.
    #[error("{material}: expected a transparent material{}", opaque(*.found_nm, *.n, *.k))]
    NotTransparent {
        material: String,
        found_nm: f64,
        n: f64,
        k: f64,
    },
    /// A table, or the formula of a file, knows nothing there.
    #[error(
        "{material}: expected a wavelength at which its index is known, {from_nm} to {to_nm} nm, \
         found {found_nm} nm"
    )]
    OutsideTable {
        material: String,
        found_nm: f64,
        from_nm: f64,
        to_nm: f64,
    },
    /// An n_d of two numbers that is no denser than air.
    #[error("n_d: expected a number from 1.0001 to 10, found {found}")]
    TooThin { found: f64 },
    /// A V_d of two numbers that is not positive.
    #[error("V_d: expected a number above 0, found {found}")]
    BadAbbe { found: f64 },
    /// A table whose values are no indices.
    #[error("expected indices of refraction above 0, found {found} at {at_nm} nm")]
    BadTable { found: f64, at_nm: f64 },
}

impl IndexError {
    /// True if the material transmits no ray there.
    pub(super) fn is_opaque(&self) -> bool {
        matches!(self, Self::NotTransparent { .. })
    }
}

fn opaque(at_nm: f64, n: f64, k: f64) -> String {
    if !n.is_finite() {
        return format!(", found no index at {at_nm} nm");
    }
    format!(" (n above 1, k at most {MOST_EXTINCTION}), found n {n:.4}, k {k:.4} at {at_nm} nm")
}
