//! The colours of single wavelengths, for the strip under a wavelength axis.
//!
//! No screen can show them: every spectral colour lies outside sRGB. The method, per nm:
//!
//! 1. the true colour from the CIE 1931 colour-matching functions, in linear sRGB;
//! 2. white of the *same luminance* mixed in, half of what would lift the lowest channel to zero:
//!    the dominant wavelength stays and only the purity falls;
//! 3. what is still negative is bent up to zero along a rounded corner. The whole way by white
//!    turns red into pink and cutting negatives off gives flat bands with hard edges; half and
//!    half has neither;
//! 4. scaled to full brightness, so that hue is readable where the eye is weak but not blind;
//! 5. faded at the ends by [`visibility`], so that the strip ends where sight does.

use super::{
    observer::Observer,
    srgb::{Srgb, linear_from_xyz},
    xyz::Xyz,
};

/// `x-bar + y-bar + z-bar` at which a wavelength is shown at half brightness.
///
/// Chosen so that 410-680 nm is clearly coloured while 390 and 700 nm are nearly gone.
const HALF_SEEN: f64 = 0.15;

/// Share of the white that would bring a colour into the gamut by itself; see the module's head.
const WHITE_SHARE: f64 = 0.5;

/// Radius of the rounded corner at zero, as a share of the largest channel.
const CORNER: f64 = 0.05;

/// Brightness at which a wavelength is shown, 0-1: 1 in the middle, 0 where the eye sees nothing.
///
/// Built on the sum of the three colour-matching functions rather than on y-bar alone, which
/// would leave violet black although it is plainly seen.
pub(super) fn visibility(at_nm: f64) -> f64 {
    let sum: f64 = Observer::CIE_1931.table().at(at_nm).iter().sum();
    let squared = sum * sum;
    squared / (squared + HALF_SEEN * HALF_SEEN)
}

/// Colour of a wavelength on the strip, fading to black at both ends of the visible range.
pub(crate) fn srgb_from_wavelength(at_nm: f64) -> Srgb {
    srgb_from_wavelength_over(at_nm, Srgb([0; 3]))
}

/// As [`srgb_from_wavelength`], fading to the colour of the ground that the strip lies on, mixed
/// in linear light: black or dark grey on a dark theme, near-white on a light one.
pub(crate) fn srgb_from_wavelength_over(at_nm: f64, ground: Srgb) -> Srgb {
    let share = visibility(at_nm);
    let (colour, ground) = (full_linear(at_nm), ground.to_linear());
    Srgb::from_linear(std::array::from_fn(|k| {
        share * colour[k] + (1.0 - share) * ground[k]
    }))
}

/// Share of full brightness that a filled curve keeps where the eye sees nothing: there is light,
/// and the area of a spectrum must not vanish.
const LEAST_FILL: f64 = 0.34;

/// Colour of a wavelength within a filled curve: as on the strip, but dimmed towards the ends, not
/// gone. Beyond 380 and 760 nm it is the colour at these.
pub(crate) fn srgb_of_fill(at_nm: f64) -> Srgb {
    let at_nm = at_nm.clamp(380.0, 760.0);
    // Between 690 and 760 nm the hue does not change any more, and its table runs out of digits.
    let colour = full_linear(at_nm.min(700.0));
    // In the encoding of screens, where equal steps look equal.
    let shown = (LEAST_FILL + (1.0 - LEAST_FILL) * visibility(at_nm)).powf(2.2);
    Srgb::from_linear(colour.map(|v| shown * v))
}

/// The colour at full brightness in linear sRGB; black outside the table.
fn full_linear(at_nm: f64) -> [f64; 3] {
    let xyz = Xyz::from_array(Observer::CIE_1931.table().at(at_nm));
    let linear = linear_from_xyz(xyz);
    let lowest = linear.into_iter().fold(f64::INFINITY, f64::min);
    let white = if lowest < 0.0 {
        // lowest < 0 <= Y, so the quotient lies in 0-1.
        WHITE_SHARE * lowest / (lowest - xyz.y)
    } else {
        0.0
    };
    let paler = linear.map(|v| v + white * (xyz.y - v));
    let largest = paler.into_iter().fold(0.0, f64::max);
    if largest <= 0.0 {
        return [0.0; 3];
    }
    let bent = paler.map(|v| rounded_corner(v / largest));
    // The fourth-power mean lies close to the largest channel but has no kink where two channels
    // cross, which would draw bright lines at cyan and yellow.
    let size = bent.iter().map(|v| v.powi(4)).sum::<f64>().powf(0.25);
    bent.map(|v| v / size)
}

/// `max(v, 0)` with its corner rounded: smooth, positive, and `v` itself far from zero.
fn rounded_corner(v: f64) -> f64 {
    0.5 * (v + v.hypot(CORNER))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rgb(at_nm: f64) -> [u8; 3] {
        srgb_from_wavelength(at_nm).0
    }

    #[test]
    fn wavelengths_have_the_colours_that_people_name() {
        let [r, g, b] = rgb(460.0);
        assert!(b > 200 && r < 100 && g < 100, "blue");
        let [r, g, b] = rgb(530.0);
        assert!(g > 200 && r < 150 && b < 200, "green");
        let [r, g, b] = rgb(578.0);
        assert!(r > 200 && g > 150 && b < 50, "yellow");
        let [r, g, b] = rgb(640.0);
        assert!(r > 200 && g < 60 && b < 80, "red");
        let [r, g, b] = rgb(420.0);
        assert!(b > r && r > g, "violet");
    }

    #[test]
    fn the_strip_ends_where_sight_does() {
        for at_nm in [300.0, 380.0, 720.0, 780.0, 830.0, 2000.0] {
            assert!(
                rgb(at_nm).iter().all(|v| *v < 16),
                "{at_nm}: {:?}",
                rgb(at_nm)
            );
        }
        let paper = Srgb([250, 250, 248]);
        assert_eq!(srgb_from_wavelength_over(1000.0, paper), paper);
        assert!(visibility(555.0) > 0.95);
    }

    #[test]
    fn neighbours_differ_little_so_that_the_strip_has_no_bands() {
        for tenth_nm in 3600..8300 {
            let at_nm = f64::from(tenth_nm) / 10.0;
            let (here, next) = (rgb(at_nm), rgb(at_nm + 0.1));
            for k in 0..3 {
                // A channel leaves zero on the steep foot of the sRGB curve, where 0.0015 of the
                // light is 5 of 255; elsewhere a full swing takes some 10 nm.
                assert!(
                    here[k].abs_diff(next[k]) <= 6,
                    "{at_nm} nm: {here:?} {next:?}"
                );
            }
        }
    }
}
