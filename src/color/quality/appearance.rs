//! CIECAM02 and its uniform space CAM02-UCS, as far as TM-30 needs them.
//!
//! Sources: CIE 159:2004; Luo, Cui and Li 2006 for the uniform space. Viewing conditions of TM-30:
//! adapting luminance 100 cd/m2, background Y 20, average surround, complete adaptation.

use crate::color::{
    Xyz,
    matrix::{Matrix3, inverse, times_matrix, times_vector},
};

const CAT02: Matrix3 = [
    [0.7328, 0.4296, -0.1624],
    [-0.7036, 1.6975, 0.0061],
    [0.0030, 0.0136, 0.9834],
];
const XYZ_FROM_CAT02: Matrix3 = inverse(&CAT02);
const HUNT_POINTER_ESTEVEZ: Matrix3 = [
    [0.38971, 0.68898, -0.07868],
    [-0.22981, 1.18340, 0.04641],
    [0.0, 0.0, 1.0],
];

/// Adapting luminance, cd/m2.
const ADAPTING: f64 = 100.0;
/// Background over white.
const BACKGROUND: f64 = 0.2;
/// Impact of the average surround.
const SURROUND: f64 = 0.69;

/// An eye adapted to a white.
#[derive(Clone, Debug)]
pub(crate) struct ViewingConditions {
    /// From XYZ to adapted cone signals: adaptation and the change to cones are one matrix.
    to_cones: Matrix3,
    luminance_factor: f64,
    luminance_root: f64,
    background_factor: f64,
    lightness_exponent: f64,
    chroma_factor: f64,
    white_response: f64,
}

impl ViewingConditions {
    /// An eye adapted to a white with Y = 100; `None` for a white that leaves a signal dark.
    pub(crate) fn adapted_to(white: Xyz) -> Option<Self> {
        let signals = times_vector(&CAT02, white.to_array());
        if signals.iter().any(|v| v.is_nan() || *v <= 0.0) {
            return None;
        }
        let k = 1.0 / (5.0 * ADAPTING + 1.0);
        let k4 = k.powi(4);
        let luminance_factor =
            0.2 * k4 * 5.0 * ADAPTING + 0.1 * (1.0 - k4).powi(2) * (5.0 * ADAPTING).cbrt();
        let cone = times_matrix(&HUNT_POINTER_ESTEVEZ, &XYZ_FROM_CAT02);
        let adapted = std::array::from_fn(|k| CAT02[k].map(|v| v * 100.0 / signals[k]));
        let mut eye = Self {
            to_cones: times_matrix(&cone, &adapted),
            luminance_factor,
            luminance_root: luminance_factor.powf(0.25),
            background_factor: 0.725 * BACKGROUND.powf(-0.2),
            lightness_exponent: SURROUND * (1.48 + BACKGROUND.sqrt()),
            chroma_factor: (1.64 - 0.29_f64.powf(BACKGROUND)).powf(0.73),
            white_response: 1.0,
        };
        eye.white_response = eye.achromatic(eye.responses(white));
        (eye.white_response > 0.0).then_some(eye)
    }

    /// `[J', a', b']` of a colour in the white's scale.
    pub(crate) fn uniform(&self, xyz: Xyz) -> [f64; 3] {
        let [red, green, blue] = self.responses(xyz);
        let a = red - 12.0 * green / 11.0 + blue / 11.0;
        let b = (red + green - 2.0 * blue) / 9.0;
        let response = self.achromatic([red, green, blue]) / self.white_response;
        let lightness = response.max(0.0).powf(self.lightness_exponent);
        let size = a.hypot(b);
        if size == 0.0 {
            return [uniform_lightness(100.0 * lightness), 0.0, 0.0];
        }
        let (cos, sin) = (a / size, b / size);
        let (sin_2, cos_2) = 2.0_f64.sin_cos();
        let eccentricity = 0.25 * (cos * cos_2 - sin * sin_2 + 3.8);
        let t = 50_000.0 / 13.0 * self.background_factor * eccentricity * size
            / (red + green + 1.05 * blue);
        let chroma = t.max(0.0).powf(0.9) * lightness.sqrt() * self.chroma_factor;
        let colourfulness = (0.0228 * chroma * self.luminance_root).ln_1p() / 0.0228;
        [
            uniform_lightness(100.0 * lightness),
            colourfulness * cos,
            colourfulness * sin,
        ]
    }

    /// Compressed cone responses.
    fn responses(&self, xyz: Xyz) -> [f64; 3] {
        times_vector(&self.to_cones, xyz.to_array()).map(|cone| {
            let power = (self.luminance_factor * cone.abs() / 100.0).powf(0.42);
            (400.0 * power / (power + 27.13)).copysign(cone) + 0.1
        })
    }

    fn achromatic(&self, [red, green, blue]: [f64; 3]) -> f64 {
        (2.0 * red + green + blue / 20.0 - 0.305) * self.background_factor
    }
}

fn uniform_lightness(lightness: f64) -> f64 {
    1.7 * lightness / (1.0 + 0.007 * lightness)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_white_is_white_and_black_is_black() {
        let white = Xyz::new(95.0, 100.0, 108.0);
        let eye = ViewingConditions::adapted_to(white).unwrap();
        let [lightness, a, b] = eye.uniform(white);
        // J is 100 of the white by definition. The published matrices have five digits (a row sums
        // to 1.00001), which leaves the white a relative difference of 1e-5 between its signals:
        // 4e-5 in a and b, some 0.01 in a' and b' by the formula, where 1 is hardly seen.
        assert!((lightness - 100.0).abs() < 1e-9, "{lightness}");
        assert!(a.hypot(b) < 0.02, "{a} {b}");
        let [black, a, b] = eye.uniform(Xyz::ZERO);
        assert!(black.abs() < 1e-9 && a.hypot(b) < 1e-9);
    }

    #[test]
    fn only_the_chromaticity_of_the_white_counts_for_hue() {
        let eye = ViewingConditions::adapted_to(Xyz::new(109.85, 100.0, 35.58)).unwrap();
        let [_, a, b] = eye.uniform(Xyz::new(40.0, 25.0, 5.0));
        assert!(a > 20.0 && b > 0.0, "a red is red: {a} {b}");
        assert!(ViewingConditions::adapted_to(Xyz::new(10.0, 100.0, -5.0)).is_none());
    }
}
