//! The kind of quantity that the values of a spectrum represent.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::sampled::Outside;

/// The role of a spectrum: what its values mean and how it continues outside its table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// Radiant power, irradiance or radiance per nm, absolute or relative; zero outside its table.
    Light,
    /// Share of light sent back, 0-1; end values held outside its table.
    Reflectance,
    /// Share of light let through, 0-1; end values held outside its table.
    Transmittance,
    /// Decadic absorbance, `-log10(transmittance)`.
    Absorbance,
    /// A weighting function: colour-matching functions, luminous efficiency, action spectra.
    Weighting,
    /// Separate lines (places and strengths), not a curve.
    Lines,
    /// Optical constants n or k, or anything else that is a curve but none of the above.
    Other,
}

impl Kind {
    /// Every kind, in the order in which menus list them.
    pub const ALL: [Self; 7] = [
        Self::Light,
        Self::Reflectance,
        Self::Transmittance,
        Self::Absorbance,
        Self::Weighting,
        Self::Lines,
        Self::Other,
    ];

    /// The lower-case word used in files, in JSON and on the command line.
    pub fn word(self) -> &'static str {
        match self {
            Self::Light => later!("light"),
            Self::Reflectance => later!("reflectance"),
            Self::Transmittance => later!("transmittance"),
            Self::Absorbance => later!("absorbance"),
            Self::Weighting => later!("weighting"),
            Self::Lines => later!("lines"),
            Self::Other => later!("other"),
        }
    }

    /// Extrapolation of a spectrum of this kind outside its table.
    pub fn outside(self) -> Outside {
        match self {
            Self::Reflectance | Self::Transmittance => Outside::Hold,
            Self::Light | Self::Absorbance | Self::Weighting | Self::Lines | Self::Other => {
                Outside::Zero
            }
        }
    }

    /// True if the spectrum multiplies a light: a reflectance or a transmittance.
    pub fn is_factor(self) -> bool {
        matches!(self, Self::Reflectance | Self::Transmittance)
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())
    }
}
