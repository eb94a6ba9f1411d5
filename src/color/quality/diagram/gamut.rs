//! Colour gamuts of screens.

use crate::color::srgb::{self, WHITE_XY as D65};

/// A triangle of primaries with its white, xy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Gamut {
    /// Its name.
    pub name: &'static str,
    /// The standard that says so.
    pub standard: &'static str,
    /// Red, green and blue.
    pub primaries: [[f64; 2]; 3],
    /// The white.
    pub white: [f64; 2],
}

const P3: [[f64; 2]; 3] = [[0.680, 0.320], [0.265, 0.690], [0.150, 0.060]];

/// The gamuts that a diagram offers.
pub(crate) const GAMUTS: [Gamut; 4] = [
    Gamut {
        name: "sRGB / Rec.709",
        standard: "IEC 61966-2-1, ITU-R BT.709",
        primaries: srgb::PRIMARIES_XY,
        white: D65,
    },
    Gamut {
        name: "Display P3",
        standard: "SMPTE EG 432-1",
        primaries: P3,
        white: D65,
    },
    Gamut {
        name: "DCI-P3",
        standard: "SMPTE RP 431-2",
        primaries: P3,
        white: [0.314, 0.351],
    },
    Gamut {
        name: "Rec.2020",
        standard: "ITU-R BT.2020",
        primaries: [[0.708, 0.292], [0.170, 0.797], [0.131, 0.046]],
        white: D65,
    },
];
