//! sRGB (IEC 61966-2-1): what a screen can show, and how the rest is mapped onto it.
//!
//! The matrices are derived here from the primaries and the white, not pasted: with the XYZ of
//! the three primaries (each at Y = 1 of its chromaticity) as columns `P`, the amounts `s` of the
//! primaries that make the white solve `P s = W`, and linear RGB to XYZ is `P diag(s)`. The
//! standard prints the inverse rounded to four digits; ours differs from it by at most 5e-4.

use std::{fmt, str::FromStr};

use super::{
    adaptation::{Adaptation, adapted},
    matrix::{Matrix3, inverse, times_vector},
    xyz::Xyz,
};

/// Chromaticities of the primaries (IEC 61966-2-1, the same as Rec. ITU-R BT.709).
pub(crate) const PRIMARIES_XY: [[f64; 2]; 3] = [[0.64, 0.33], [0.30, 0.60], [0.15, 0.06]];

/// Chromaticity of the white, D65 as the standard rounds it.
pub(crate) const WHITE_XY: [f64; 2] = [0.3127, 0.3290];

/// The screen's white, Y = 1.
pub(crate) const WHITE: Xyz = Xyz::from_array(unit_luminance(WHITE_XY));

/// Linear sRGB (0-1) to XYZ with Y = 1 for white.
pub(crate) const XYZ_FROM_LINEAR: Matrix3 = derived();

/// XYZ (Y = 1 for white) to linear sRGB.
pub(crate) const LINEAR_FROM_XYZ: Matrix3 = inverse(&XYZ_FROM_LINEAR);

/// Rounding tolerance for channels outside 0-1 to count as in gamut, in linear light (1 = full).
const GAMUT_SLACK: f64 = 1e-9;

/// Brighter than full by this much is cut without a word: half a step of an 8-bit screen.
const BRIGHT_SLACK: f64 = 4e-3;

const fn unit_luminance([x, y]: [f64; 2]) -> [f64; 3] {
    [x / y, 1.0, (1.0 - x - y) / y]
}

const fn derived() -> Matrix3 {
    let mut columns = [[0.0; 3]; 3];
    let mut primary = 0;
    while primary < 3 {
        let xyz = unit_luminance(PRIMARIES_XY[primary]);
        let mut k = 0;
        while k < 3 {
            columns[k][primary] = xyz[k];
            k += 1;
        }
        primary += 1;
    }
    let amounts = times_vector(&inverse(&columns), unit_luminance(WHITE_XY));
    let mut k = 0;
    while k < 3 {
        let mut primary = 0;
        while primary < 3 {
            columns[k][primary] *= amounts[primary];
            primary += 1;
        }
        k += 1;
    }
    columns
}

/// Linear sRGB of XYZ with Y = 1 for the screen's white; may leave 0-1.
pub(crate) fn linear_from_xyz(xyz: Xyz) -> [f64; 3] {
    times_vector(&LINEAR_FROM_XYZ, xyz.to_array())
}

/// XYZ (Y = 1 for white) of linear sRGB.
pub(crate) fn xyz_from_linear(linear: [f64; 3]) -> Xyz {
    Xyz::from_array(times_vector(&XYZ_FROM_LINEAR, linear))
}

/// The sRGB transfer function: linear light to encoded value, odd about zero.
pub(crate) fn encoded_from_linear(linear: f64) -> f64 {
    let size = linear.abs();
    let encoded = if size <= 0.003_130_8 {
        12.92 * size
    } else {
        1.055 * size.powf(1.0 / 2.4) - 0.055
    };
    encoded.copysign(linear)
}

/// The inverse of `encoded_from_linear`.
pub(crate) fn linear_from_encoded(encoded: f64) -> f64 {
    let size = encoded.abs();
    let linear = if size <= 0.040_45 {
        size / 12.92
    } else {
        ((size + 0.055) / 1.055).powf(2.4)
    };
    linear.copysign(encoded)
}

/// An 8-bit sRGB colour, red first; prints and parses as `#rrggbb`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Srgb(pub [u8; 3]);

impl Srgb {
    /// From encoded channels; what lies outside 0-1 is cut off.
    pub(crate) fn from_encoded(encoded: [f64; 3]) -> Self {
        // `as u8` saturates and takes NaN to 0.
        Self(encoded.map(|v| (v * 255.0).round() as u8))
    }

    /// From linear channels; what lies outside 0-1 is cut off.
    pub(crate) fn from_linear(linear: [f64; 3]) -> Self {
        Self::from_encoded(linear.map(encoded_from_linear))
    }

    /// Linear channels, 0-1.
    pub(crate) fn to_linear(self) -> [f64; 3] {
        self.0.map(|v| linear_from_encoded(f64::from(v) / 255.0))
    }

    /// `#rrggbb`.
    pub(crate) fn hex(self) -> String {
        self.to_string()
    }
}

impl fmt::Display for Srgb {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [r, g, b] = self.0;
        write!(f, "#{r:02x}{g:02x}{b:02x}")
    }
}

/// A text that is not `#rrggbb`.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "{}",
    tr!(
        "colour: expected #rrggbb with six hexadecimal digits, found {found}",
        found = format!("{found:?}")
    )
)]
pub struct NotHex {
    /// The text.
    pub found: String,
}

impl FromStr for Srgb {
    type Err = NotHex;

    fn from_str(text: &str) -> Result<Self, NotHex> {
        let not_hex = || NotHex {
            found: text.to_owned(),
        };
        let digits = text.trim();
        let digits = digits.strip_prefix('#').unwrap_or(digits);
        // from_str_radix alone would accept a sign.
        if digits.len() != 6 || !digits.bytes().all(|b| b.is_ascii_hexdigit()) {
            return Err(not_hex());
        }
        let all = u32::from_str_radix(digits, 16).map_err(|_| not_hex())?;
        let [_, r, g, b] = all.to_be_bytes();
        Ok(Self([r, g, b]))
    }
}

/// Method of mapping a colour onto the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Mapping {
    /// A light: negative channels to 0, then all divided by the largest.
    ScaledToMaximum,
    /// A patch relative to the light's Y: channels cut to 0-1.
    Clipped,
    /// A patch adapted to the light by Bradford, then cut to 0-1.
    AdaptedAndClipped,
    /// A patch that was to be adapted, but the light is too narrow for that: only cut to 0-1.
    TooNarrowToAdapt,
    /// By the exposure of a picture, channels cut to 0-1.
    Exposed,
    /// There is no light to show: black.
    NoLight,
}

impl Mapping {
    /// Description of the mapping for a tooltip or a report.
    pub(crate) fn words(self) -> &'static str {
        match self {
            Self::ScaledToMaximum => later!("negative channels to 0, scaled by the largest"),
            Self::Clipped => later!("relative to the light's Y, channels cut to 0-1"),
            Self::AdaptedAndClipped => {
                later!("adapted to the light (Bradford), channels cut to 0-1")
            }
            Self::TooNarrowToAdapt => {
                later!(
                    "the light is too narrow to adapt to: relative to its Y, channels cut to 0-1"
                )
            }
            Self::Exposed => later!("by the picture's exposure, channels cut to 0-1"),
            Self::NoLight => later!("no light: black"),
        }
    }
}

/// A colour as a screen shows it, and how true that is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Swatch {
    /// Encoded channels, 0-1.
    pub encoded: [f64; 3],
    /// The same, in 8 bits.
    pub rgb8: Srgb,
    /// True if the screen shows the exact colour (a light: the exact chromaticity).
    pub in_gamut: bool,
    /// Method by which it was mapped onto the screen.
    pub mapping: Mapping,
}

impl Swatch {
    /// A light of any brightness, shown as bright as the screen can: its chromaticity matters.
    pub(crate) fn of_light(xyz: Xyz) -> Self {
        let linear = linear_from_xyz(xyz);
        let largest = linear.into_iter().fold(0.0, f64::max);
        if !(largest > 0.0 && largest.is_finite()) {
            return Self::black();
        }
        let scaled = linear.map(|v| v / largest);
        let in_gamut = scaled.iter().all(|v| *v >= -GAMUT_SLACK);
        Self::new(scaled, in_gamut, Mapping::ScaledToMaximum)
    }

    /// A patch under a light, both XYZ in the same scale; the light's Y is the screen's full white.
    pub(crate) fn of_patch(xyz: Xyz, light: Xyz, adaptation: Adaptation) -> Self {
        let relative = xyz.scaled(1.0 / light.y);
        if !(light.y > 0.0 && relative.is_finite()) {
            return Self::black();
        }
        let (shown, mapping) = match adaptation {
            Adaptation::None => (relative, Mapping::Clipped),
            Adaptation::ToLight => match adapted(relative, light, WHITE) {
                Some(seen) => (seen, Mapping::AdaptedAndClipped),
                None => (relative, Mapping::TooNarrowToAdapt),
            },
        };
        let linear = linear_from_xyz(shown);
        let in_gamut = linear
            .iter()
            .all(|v| (-GAMUT_SLACK..=1.0 + GAMUT_SLACK).contains(v));
        Self::new(linear, in_gamut, mapping)
    }

    /// Light of the same source, both XYZ in the same scale, beside the source itself as
    /// [`Swatch::of_light`] shows it: one factor for both, the one that brings the source's largest
    /// channel to the screen's full.
    pub(crate) fn beside_light(xyz: Xyz, light: Xyz) -> Self {
        let largest = linear_from_xyz(light).into_iter().fold(0.0, f64::max);
        if !(largest > 0.0 && largest.is_finite() && xyz.is_finite()) {
            return Self::black();
        }
        let linear = linear_from_xyz(xyz).map(|v| v / largest);
        // A model that is a trifle brighter than its light is no colour the screen lacks.
        let in_gamut = linear
            .iter()
            .all(|v| (-GAMUT_SLACK..=1.0 + BRIGHT_SLACK).contains(v));
        Self::new(linear, in_gamut, Mapping::ScaledToMaximum)
    }

    /// XYZ with 1 for the screen's white, channels cut to 0-1. What is brighter than the screen is
    /// cut and still of its gamut.
    pub(crate) fn exposed(xyz: Xyz) -> Self {
        let linear = linear_from_xyz(xyz);
        let largest = linear.into_iter().fold(1.0, f64::max);
        let in_gamut = linear.iter().all(|v| *v >= -GAMUT_SLACK * largest);
        Self::new(linear, in_gamut, Mapping::Exposed)
    }

    /// `#rrggbb`.
    pub(crate) fn hex(self) -> String {
        self.rgb8.hex()
    }

    fn black() -> Self {
        Self::new([0.0; 3], true, Mapping::NoLight)
    }

    fn new(linear: [f64; 3], in_gamut: bool, mapping: Mapping) -> Self {
        let encoded = linear.map(|v| encoded_from_linear(v.clamp(0.0, 1.0)));
        Self {
            encoded,
            rgb8: Srgb::from_encoded(encoded),
            in_gamut,
            mapping,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn equal_channels_are_the_white() {
        let white = xyz_from_linear([1.0; 3]);
        // A matrix product of numbers near 1.
        assert!((white - WHITE).to_array().iter().all(|d| d.abs() < 1e-15));
        let linear = linear_from_xyz(WHITE);
        assert!(linear.iter().all(|v| (v - 1.0).abs() < 1e-14));
    }

    #[test]
    fn the_derived_matrix_is_the_standards_before_rounding() {
        let printed = [
            [3.2406, -1.5372, -0.4986],
            [-0.9689, 1.8758, 0.0415],
            [0.0557, -0.2040, 1.0570],
        ];
        for (row, printed_row) in LINEAR_FROM_XYZ.iter().zip(printed) {
            for (found, rounded) in row.iter().zip(printed_row) {
                // The standard inverts a matrix already rounded to four digits, which an inverse
                // with entries up to 3.2 magnifies to a few units of the fourth digit.
                assert!((found - rounded).abs() < 5e-4, "{found} {rounded}");
            }
        }
    }

    #[test]
    fn both_branches_of_the_transfer_function_meet() {
        // The standard's rounded constants leave a step of this size.
        assert!(
            (12.92 * 0.003_130_8 - (1.055 * 0.003_130_8_f64.powf(1.0 / 2.4) - 0.055)).abs() < 1e-7
        );
        assert_eq!(encoded_from_linear(0.0), 0.0);
        assert!((encoded_from_linear(1.0) - 1.0).abs() < 1e-15);
    }

    #[test]
    fn a_light_outside_the_gamut_says_so_and_has_a_full_channel() {
        let laser = Swatch::of_light(Xyz::new(0.005, 0.323, 0.272));
        assert!(!laser.in_gamut);
        assert_eq!(laser.encoded[0], 0.0);
        assert_eq!(laser.rgb8.0[1], 255);
        assert_eq!(laser.mapping, Mapping::ScaledToMaximum);
        let dim_white = Swatch::of_light(WHITE * 1e-6);
        assert!(dim_white.in_gamut);
        assert_eq!(dim_white.hex(), "#ffffff");
    }

    #[test]
    fn the_light_itself_becomes_white_when_adapted_and_only_then() {
        let a = Xyz::new(109.85, 100.0, 35.585);
        let plain = Swatch::of_patch(a, a, Adaptation::None);
        assert!(!plain.in_gamut);
        assert_ne!(plain.hex(), "#ffffff");
        let adapted = Swatch::of_patch(a, a, Adaptation::ToLight);
        assert!(adapted.in_gamut);
        assert_eq!(adapted.hex(), "#ffffff");
        let sodium = Xyz::new(136.0, 100.0, 0.0);
        let patch = Swatch::of_patch(sodium * 0.5, sodium, Adaptation::ToLight);
        assert_eq!(patch.mapping, Mapping::TooNarrowToAdapt);
    }

    #[test]
    fn darkness_is_black_and_named() {
        for swatch in [
            Swatch::of_light(Xyz::ZERO),
            Swatch::of_light(Xyz::new(-1.0, -1.0, -1.0)),
            Swatch::of_patch(Xyz::ZERO, Xyz::ZERO, Adaptation::ToLight),
        ] {
            assert_eq!(swatch.hex(), "#000000");
            assert_eq!(swatch.mapping, Mapping::NoLight);
        }
    }

    #[test]
    fn texts_that_are_no_colour_are_refused_in_words() {
        for text in ["", "#12345", "#12345g", "#+12345", "#éééé", "1234567"] {
            let error = text.parse::<Srgb>().unwrap_err();
            assert!(error.to_string().contains("#rrggbb"), "{text}");
        }
        assert_eq!("  A0b1C2 ".parse::<Srgb>(), Ok(Srgb([0xa0, 0xb1, 0xc2])));
    }

    proptest! {
        #[test]
        fn a_hex_code_leads_back_to_its_colour(rgb: [u8; 3]) {
            prop_assert_eq!(Srgb(rgb).hex().parse::<Srgb>(), Ok(Srgb(rgb)));
        }

        #[test]
        fn eight_bits_survive_linear_light(rgb: [u8; 3]) {
            prop_assert_eq!(Srgb::from_linear(Srgb(rgb).to_linear()), Srgb(rgb));
        }

        #[test]
        fn the_transfer_function_can_be_undone(linear in -2.0..2.0_f64) {
            let back = linear_from_encoded(encoded_from_linear(linear));
            // Two powers near 1; at the seam the rounded constants may pick the other branch,
            // which differs by the step of 3e-8 over the slope of 12.92.
            prop_assert!((back - linear).abs() < 1e-8);
        }

        #[test]
        fn swatches_never_leave_the_screen(x in -2.0..200.0_f64, y in -2.0..200.0_f64, z in -2.0..200.0_f64) {
            let xyz = Xyz::new(x, y, z);
            for swatch in [Swatch::of_light(xyz), Swatch::of_patch(xyz, WHITE, Adaptation::None)] {
                prop_assert!(swatch.encoded.iter().all(|v| (0.0..=1.0).contains(v)));
            }
        }
    }
}
