//! CIE 1976 L\*a\*b\* (CIE 15:2018, ISO/CIE 11664-4).
//!
//! ```text
//! f(t) = cbrt(t)              t > (6/29)^3
//!        (kappa t + 16)/116   otherwise
//! L* = 116 f(Y/Yn) - 16    a* = 500 (f(X/Xn) - f(Y/Yn))    b* = 200 (f(Y/Yn) - f(Z/Zn))
//! ```

use super::xyz::Xyz;

/// `(6/29)^3`, where the cube root gives way to a straight line.
pub(crate) const LAB_EPSILON: f64 = 216.0 / 24389.0;

/// `(29/3)^3`, the slope of the straight line.
pub(crate) const LAB_KAPPA: f64 = 24389.0 / 27.0;

/// Share of the white's Y below which an X or Z of the white is taken as absent.
///
/// z-bar of the CIE 1931 table is exactly 0 from 651 nm on, so a red laser has no Z at all and
/// a ratio to it would be a division by zero.
const ABSENT: f64 = 1e-9;

/// A colour in CIE 1976 L\*a\*b\*; the white it refers to is the caller's.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lab {
    /// Lightness, 100 for the white.
    pub l: f64,
    /// Green (negative) to red.
    pub a: f64,
    /// Blue (negative) to yellow.
    pub b: f64,
}

impl Lab {
    /// From L\*, a\*, b\*.
    pub const fn new(l: f64, a: f64, b: f64) -> Self {
        Self { l, a, b }
    }

    /// Chroma `C*ab`.
    pub fn chroma(self) -> f64 {
        self.a.hypot(self.b)
    }

    /// Hue angle `h_ab` in degrees, `0 <= h < 360`; `None` for a neutral colour, which has none.
    pub fn hue_degrees(self) -> Option<f64> {
        if self.a == 0.0 && self.b == 0.0 {
            return None;
        }
        let degrees = self.b.atan2(self.a).to_degrees();
        // Adding 360 to a tiny negative angle rounds to 360 itself.
        let turned = if degrees < 0.0 {
            degrees + 360.0
        } else {
            degrees
        };
        Some(if turned >= 360.0 { 0.0 } else { turned })
    }

    /// CIE 1976 difference: the straight distance.
    pub(crate) fn delta_e_1976(self, other: Self) -> f64 {
        ((self.l - other.l).powi(2) + (self.a - other.a).powi(2) + (self.b - other.b).powi(2))
            .sqrt()
    }
}

/// L\*a\*b\* of a colour against a white in the same scale.
///
/// When the white has no X or no Z, the ratio of Y stands in for it, which is what the limit of
/// a single line gives for a reflectance and adds no hue. A white without Y makes everything black.
pub fn lab_from_xyz(xyz: Xyz, white: Xyz) -> Lab {
    if white.y <= 0.0 {
        return Lab::default();
    }
    let y = xyz.y / white.y;
    let absent = ABSENT * white.y;
    let ratio = |value: f64, of_white: f64| {
        // A negative component (the daylight component S2) still scales as it should.
        if of_white.abs() > absent {
            value / of_white
        } else {
            y
        }
    };
    let (fx, fy, fz) = (
        compressed(ratio(xyz.x, white.x)),
        compressed(y),
        compressed(ratio(xyz.z, white.z)),
    );
    Lab {
        l: 116.0 * fy - 16.0,
        a: 500.0 * (fx - fy),
        b: 200.0 * (fy - fz),
    }
}

/// The inverse of [`lab_from_xyz`], in the white's scale.
pub(crate) fn xyz_from_lab(lab: Lab, white: Xyz) -> Xyz {
    let fy = (lab.l + 16.0) / 116.0;
    Xyz::new(
        white.x * expanded(fy + lab.a / 500.0),
        white.y * expanded(fy),
        white.z * expanded(fy - lab.b / 200.0),
    )
}

fn compressed(t: f64) -> f64 {
    if t > LAB_EPSILON {
        t.cbrt()
    } else {
        (LAB_KAPPA * t + 16.0) / 116.0
    }
}

fn expanded(f: f64) -> f64 {
    let cube = f * f * f;
    if cube > LAB_EPSILON {
        cube
    } else {
        (116.0 * f - 16.0) / LAB_KAPPA
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WHITE: Xyz = Xyz::new(95.047, 100.0, 108.883);

    #[test]
    fn the_white_is_l_100_and_neutral_and_black_is_0() {
        assert_eq!(lab_from_xyz(WHITE, WHITE), Lab::new(100.0, 0.0, 0.0));
        let black = lab_from_xyz(Xyz::ZERO, WHITE);
        assert_eq!(black, Lab::new(0.0, 0.0, 0.0));
        assert_eq!(black.hue_degrees(), None);
    }

    #[test]
    fn colours_survive_the_round_trip_dark_bright_and_negative() {
        for xyz in [
            Xyz::new(20.0, 12.0, 3.0),
            Xyz::new(0.2, 0.1, 0.5),
            Xyz::new(-1.0, 0.01, -0.3),
            Xyz::new(180.0, 140.0, 5.0),
        ] {
            let back = xyz_from_lab(lab_from_xyz(xyz, WHITE), WHITE);
            // Cube root and cube of numbers up to 200: some ulps of 200.
            assert!((back.x - xyz.x).abs() < 1e-12);
            assert!((back.y - xyz.y).abs() < 1e-12);
            assert!((back.z - xyz.z).abs() < 1e-12);
        }
    }

    #[test]
    fn cube_root_and_line_meet() {
        // Both constants were chosen by the CIE so that value and slope agree at epsilon.
        assert!((LAB_EPSILON.cbrt() - (LAB_KAPPA * LAB_EPSILON + 16.0) / 116.0).abs() < 1e-15);
    }

    #[test]
    fn hue_runs_round_the_circle() {
        assert_eq!(Lab::new(50.0, 1.0, 0.0).hue_degrees(), Some(0.0));
        assert_eq!(Lab::new(50.0, 0.0, -2.0).hue_degrees(), Some(270.0));
        assert_eq!(Lab::new(50.0, 1.0, -1e-30).hue_degrees(), Some(0.0));
        assert_eq!(Lab::new(50.0, 3.0, 4.0).chroma(), 5.0);
    }

    #[test]
    fn a_white_that_lacks_a_component_gives_numbers() {
        let red_line = Xyz::new(30.0, 10.0, 0.0);
        let grey = lab_from_xyz(red_line * 0.5, red_line);
        assert_eq!((grey.a, grey.b), (0.0, 0.0));
        assert_eq!(lab_from_xyz(WHITE, Xyz::ZERO), Lab::default());
    }
}
