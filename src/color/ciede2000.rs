//! CIEDE2000 colour difference (ISO/CIE 11664-6), kL = kC = kH = 1.
//!
//! Source: Sharma, Wu, Dalal, "The CIEDE2000 color-difference formula: implementation notes,
//! supplementary test data, and mathematical observations", Color Res. Appl. 30 (2005) 21-30.
//!
//! This runs once per patch on every move of a slider, so hue angles are kept as unit vectors:
//! the mean hue is a bisector, its multiples come from products, and only the blue region, where
//! the rotation term lives, pays for an arc tangent and an exponential.
//!
//! ```text
//! a' = (1 + G) a      C' = |(a', b)|      h' = direction of (a', b)
//! dH' = 2 sqrt(C1' C2') sin(dh'/2)
//! dE = sqrt((dL/SL)^2 + (dC'/SC)^2 + (dH'/SH)^2 + RT (dC'/SC)(dH'/SH))
//! ```

use std::f64::consts::TAU;

use super::{
    lab::{Lab, lab_from_xyz},
    xyz::Xyz,
};

const COS_6: f64 = 0.994_521_895_368_273_3; // degrees, as all of these; a test compares with cos
const SIN_6: f64 = 0.104_528_463_267_653_47;
const COS_30: f64 = 0.866_025_403_784_438_6; // sqrt(3)/2
const SIN_30: f64 = 0.5;
const COS_63: f64 = 0.453_990_499_739_546_8;
const SIN_63: f64 = 0.891_006_524_188_367_9;

/// CIEDE2000 difference of two colours that refer to the same white.
///
/// Symmetric, zero for equal colours, finite for components up to 1e70.
pub fn delta_e_2000(first: Lab, second: Lab) -> f64 {
    let chroma_mean = 0.5 * (length(first.a, first.b) + length(second.a, second.b));
    let stretch = 1.5 - 0.5 * chroma_share(chroma_mean);
    let (a1, b1) = (first.a * stretch, first.b);
    let (a2, b2) = (second.a * stretch, second.b);
    let (c1, c2) = (length(a1, b1), length(a2, b2));
    let (hue, d_hue) = mean_hue_and_difference((a1, b1, c1), (a2, b2, c2));

    let d_lightness = second.l - first.l;
    let d_chroma = c2 - c1;
    let lightness_offset = 0.5 * (first.l + second.l) - 50.0;
    let chroma = 0.5 * (c1 + c2);

    let squared = lightness_offset * lightness_offset;
    let s_l = 1.0 + 0.015 * squared / (20.0 + squared).sqrt();
    let s_c = 1.0 + 0.045 * chroma;
    let s_h = 1.0 + 0.015 * chroma * hue_weight(hue);
    let (l, c, h) = (d_lightness / s_l, d_chroma / s_c, d_hue / s_h);
    let rotation = rotation(hue, chroma);
    // The form is positive definite (|rotation| < 2); max() only guards the last rounding.
    (l * l + c * c + h * h + rotation * c * h).max(0.0).sqrt()
}

/// Unit vector of a hue.
type Direction = (f64, f64);

fn length(a: f64, b: f64) -> f64 {
    (a * a + b * b).sqrt()
}

/// `sqrt(C^7 / (C^7 + 25^7))`.
fn chroma_share(chroma: f64) -> f64 {
    const C25_4: f64 = 25.0 * 25.0 * 25.0 * 25.0;
    const C25_7: f64 = C25_4 * 25.0 * 25.0 * 25.0;
    // At 1e40 the share has long been 1, and the seventh power is still a number.
    let c = chroma.min(1e40);
    let squared = c * c;
    let seventh = squared * squared * squared * c;
    (seventh / (seventh + C25_7)).sqrt()
}

/// The mean hue as the bisector of the shorter arc, and the signed hue difference `dH'`.
fn mean_hue_and_difference(
    (a1, b1, c1): (f64, f64, f64),
    (a2, b2, c2): (f64, f64, f64),
) -> (Direction, f64) {
    if c1 == 0.0 || c2 == 0.0 {
        // A neutral colour has no hue and takes the other's.
        let (a, b, c) = if c1 == 0.0 {
            (a2, b2, c2)
        } else {
            (a1, b1, c1)
        };
        let hue = if c == 0.0 { (1.0, 0.0) } else { (a / c, b / c) };
        return (hue, 0.0);
    }
    let (per_c1, per_c2) = (1.0 / c1, 1.0 / c2);
    let (u1, v1) = (a1 * per_c1, b1 * per_c1);
    let (u2, v2) = (a2 * per_c2, b2 * per_c2);
    // sine and cosine of the turn from the first hue to the second
    let (sine, cosine) = (u1 * v2 - v1 * u2, u1 * u2 + v1 * v2);
    let both = (c1 * c2).sqrt();
    if cosine > 0.0 {
        // Half the reciprocal of the cosine of half the turn.
        let scale = 0.5 / (0.5 + 0.5 * cosine).sqrt();
        (
            ((u1 + u2) * scale, (v1 + v2) * scale),
            2.0 * both * sine * scale,
        )
    } else {
        // Nearly opposite hues: their sum vanishes, the perpendicular of their difference does
        // not. Exactly opposite hues count as a turn from the smaller angle to the larger one.
        let first_is_smaller = v1 > 0.0 || (v1 == 0.0 && u1 > 0.0);
        let cross = a1 * b2 - b1 * a2;
        let turn = cross > 0.0 || (cross == 0.0 && first_is_smaller);
        let sign = if turn { 1.0 } else { -1.0 };
        let half_sine = (0.5 * (1.0 - cosine)).sqrt();
        let scale = sign * 0.5 / half_sine;
        (
            ((v2 - v1) * scale, (u1 - u2) * scale),
            sign * 2.0 * both * half_sine,
        )
    }
}

/// `T = 1 - 0.17 cos(h - 30) + 0.24 cos(2h) + 0.32 cos(3h + 6) - 0.20 cos(4h - 63)`.
fn hue_weight((cos, sin): Direction) -> f64 {
    let (cos_2, sin_2) = (cos * cos - sin * sin, 2.0 * sin * cos);
    let (cos_3, sin_3) = (cos_2 * cos - sin_2 * sin, sin_2 * cos + cos_2 * sin);
    let (cos_4, sin_4) = (cos_2 * cos_2 - sin_2 * sin_2, 2.0 * sin_2 * cos_2);
    1.0 - 0.17 * (cos * COS_30 + sin * SIN_30)
        + 0.24 * cos_2
        + 0.32 * (cos_3 * COS_6 - sin_3 * SIN_6)
        - 0.20 * (cos_4 * COS_63 + sin_4 * SIN_63)
}

/// `RT = -2 sqrt(C^7/(C^7 + 25^7)) sin(60 exp(-((h - 275)/25)^2))`, angles in degrees.
fn rotation((cos, sin): Direction, chroma: f64) -> f64 {
    // From 0 to 143 degrees (cosine -0.8) the exponent is below -27 and the term under 2e-12.
    if sin >= 0.0 && cos >= -0.8 {
        return 0.0;
    }
    // The offset from 275 degrees, counted from 0 without wrapping, as the formula has it.
    let angle = sin.atan2(cos);
    let turned = if angle < 0.0 { angle + TAU } else { angle };
    let offset = (turned - 275_f64.to_radians()) * (1.0 / 25_f64.to_radians());
    let turn = 60_f64.to_radians() * (-offset * offset).exp();
    -2.0 * chroma_share(chroma) * turn.sin()
}

/// CIEDE2000 of two colours against a white; `None` without light, and where it is no number.
pub fn delta_e_of_xyz(first: Xyz, second: Xyz, white: Xyz) -> Option<f64> {
    let is_light = white.y > 0.0 && white.is_finite() && first.is_finite() && second.is_finite();
    let found =
        is_light.then(|| delta_e_2000(lab_from_xyz(first, white), lab_from_xyz(second, white)));
    found.filter(|found| found.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_written_sines_are_those_of_their_angles() {
        for (found, expected) in [
            (COS_6, 6_f64.to_radians().cos()),
            (SIN_6, 6_f64.to_radians().sin()),
            (COS_30, 3_f64.sqrt() / 2.0),
            (COS_63, 63_f64.to_radians().cos()),
            (SIN_63, 63_f64.to_radians().sin()),
        ] {
            // The conversion to radians is itself rounded.
            assert!((found - expected).abs() < 2e-16, "{found} {expected}");
        }
    }

    #[test]
    fn along_the_grey_axis_only_lightness_counts() {
        let found = delta_e_2000(Lab::new(49.0, 0.0, 0.0), Lab::new(51.0, 0.0, 0.0));
        // The mean lightness is 50, where SL is exactly 1.
        assert_eq!(found, 2.0);
    }

    #[test]
    fn exactly_opposite_hues_follow_the_arithmetic_mean_of_the_angles() {
        let one = Lab::new(50.0, 2.49, -0.001);
        let other = Lab::new(50.0, -2.49, 0.001);
        // Pair 10 of the paper's Table 1, published to four digits.
        assert!((delta_e_2000(one, other) - 7.1792).abs() < 5e-5);
        assert_eq!(delta_e_2000(one, other), delta_e_2000(other, one));
    }

    /// The formula as the paper writes it, with angles: slow, and the judge of the fast one.
    fn by_angles(first: Lab, second: Lab) -> f64 {
        let power = |c: f64| (c.powf(7.0) / (c.powf(7.0) + 25_f64.powf(7.0))).sqrt();
        let g = 0.5 * (1.0 - power(0.5 * (first.chroma() + second.chroma())));
        let prime = |lab: Lab| Lab::new(lab.l, lab.a * (1.0 + g), lab.b);
        let (p, q) = (prime(first), prime(second));
        let (c1, c2) = (p.chroma(), q.chroma());
        let (h1, h2) = (
            p.hue_degrees().unwrap_or(0.0),
            q.hue_degrees().unwrap_or(0.0),
        );
        let neutral = c1 * c2 == 0.0;
        let gap = h2 - h1;
        let dh = match () {
            () if neutral => 0.0,
            () if gap > 180.0 => gap - 360.0,
            () if gap < -180.0 => gap + 360.0,
            () => gap,
        };
        let mean = match () {
            () if neutral => h1 + h2,
            () if gap.abs() <= 180.0 => 0.5 * (h1 + h2),
            () if h1 + h2 < 360.0 => 0.5 * (h1 + h2 + 360.0),
            () => 0.5 * (h1 + h2 - 360.0),
        };
        let cos = |degrees: f64| degrees.to_radians().cos();
        let t =
            1.0 - 0.17 * cos(mean - 30.0) + 0.24 * cos(2.0 * mean) + 0.32 * cos(3.0 * mean + 6.0)
                - 0.20 * cos(4.0 * mean - 63.0);
        let (l, c) = (0.5 * (p.l + q.l), 0.5 * (c1 + c2));
        let s_l = 1.0 + 0.015 * (l - 50.0).powi(2) / (20.0 + (l - 50.0).powi(2)).sqrt();
        let turn = 30.0 * (-((mean - 275.0) / 25.0).powi(2)).exp();
        let r = -(2.0 * turn).to_radians().sin() * 2.0 * power(c);
        let dl = (q.l - p.l) / s_l;
        let dc = (c2 - c1) / (1.0 + 0.045 * c);
        let dh = 2.0 * (c1 * c2).sqrt() * (0.5 * dh).to_radians().sin() / (1.0 + 0.015 * c * t);
        (dl * dl + dc * dc + dh * dh + r * dc * dh).sqrt()
    }

    fn any_lab() -> impl Strategy<Value = Lab> {
        (0.0..100.0, -120.0..120.0, -120.0..120.0).prop_map(|(l, a, b)| Lab::new(l, a, b))
    }

    proptest! {
        #[test]
        fn the_fast_form_is_the_formula(first in any_lab(), second in any_lab()) {
            let (fast, slow) = (delta_e_2000(first, second), by_angles(first, second));
            // The slow form subtracts angles of up to 360 degrees, which costs some 1e-14 of 100.
            prop_assert!((fast - slow).abs() < 1e-10, "{fast} {slow}");
        }

        #[test]
        fn it_is_symmetric_not_negative_and_zero_for_equals(first in any_lab(), second in any_lab()) {
            let there = delta_e_2000(first, second);
            prop_assert!(there.is_finite() && there >= 0.0);
            // Swapping only swaps operands of sums and the sign of two factors.
            prop_assert!((there - delta_e_2000(second, first)).abs() < 1e-12);
            prop_assert_eq!(delta_e_2000(first, first), 0.0);
        }

        #[test]
        fn small_steps_are_not_lost_to_rounding(lab in any_lab(), da in -1e-6..1e-6_f64, db in -1e-6..1e-6_f64) {
            let near = Lab::new(lab.l, lab.a + da, lab.b + db);
            let found = delta_e_2000(lab, near);
            // A step of 1e-6 in Lab is at most 1.5 (stretch) times that in dE; SC and SH exceed 1
            // except for T, which goes down to 0.6 or so of a small share.
            prop_assert!(found <= 3e-6, "{found}");
        }

        #[test]
        fn huge_and_tiny_colours_stay_numbers(l in -1e70..1e70_f64, a in -1e70..1e70_f64, tiny in -1e-300..1e-300_f64) {
            prop_assert!(delta_e_2000(Lab::new(l, a, tiny), Lab::new(-l, tiny, a)).is_finite());
        }
    }
}
