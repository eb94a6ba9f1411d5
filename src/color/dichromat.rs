//! Colours as an eye sees them that has two of the three kinds of cones.
//!
//! After Viénot, Brettel and Mollon 1999 (Color Research and Application 24, 243-252): of all
//! colours that only the missing cones would tell apart, the one on the plane through the screen's
//! white and its blue is shown. Cones of Hunt, Pointer and Estévez.

use std::sync::LazyLock;

use serde::{Deserialize, Serialize};

use super::{
    matrix::{Matrix3, inverse, times_matrix},
    srgb::{Srgb, XYZ_FROM_LINEAR},
};

/// The cones that are missing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum MissingCones {
    /// Those of long waves: protanopia.
    Long,
    /// Those of middle waves: deuteranopia.
    Middle,
}

/// Answers of the long, middle and short cones to XYZ, equal to each other for D65.
const CONES_FROM_XYZ: Matrix3 = [
    [0.400_24, 0.707_60, -0.080_81],
    [-0.226_30, 1.165_32, 0.045_70],
    [0.0, 0.0, 0.918_22],
];

/// In each column the linear sRGB that only one kind of cones answers to.
static LINEAR_FROM_CONES: LazyLock<Matrix3> =
    LazyLock::new(|| inverse(&times_matrix(&CONES_FROM_XYZ, &XYZ_FROM_LINEAR)));

impl MissingCones {
    /// A colour as such an eye sees it; cut to the screen's colours.
    pub fn seen(self, colour: Srgb) -> Srgb {
        Srgb::from_linear(self.linear(colour.to_linear()))
    }

    fn linear(self, colour: [f64; 3]) -> [f64; 3] {
        let column = match self {
            Self::Long => 0,
            Self::Middle => 1,
        };
        let unseen = LINEAR_FROM_CONES.map(|row| row[column]);
        // On the plane through white and blue there is as much red as green.
        let by = (colour[0] - colour[1]) / (unseen[0] - unseen[1]);
        std::array::from_fn(|k| colour[k] - by * unseen[k])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::matrix::times_vector;

    const BOTH: [MissingCones; 2] = [MissingCones::Long, MissingCones::Middle];

    #[test]
    fn greys_and_the_blue_of_the_screen_stay_and_a_second_look_changes_nothing() {
        for eye in BOTH {
            for colour in [[0, 0, 0], [90, 90, 90], [255, 255, 255], [0, 0, 255]] {
                assert_eq!(eye.seen(Srgb(colour)), Srgb(colour));
            }
            let once = eye.linear([0.7, 0.2, 0.1]);
            let twice = eye.linear(once);
            for (a, b) in once.into_iter().zip(twice) {
                // Rounding of one division.
                assert!((a - b).abs() < 1e-12, "{once:?} {twice:?}");
            }
        }
    }

    #[test]
    fn the_other_cones_answer_as_before_and_what_only_the_missing_ones_see_is_not_seen() {
        let cones = times_matrix(&CONES_FROM_XYZ, &XYZ_FROM_LINEAR);
        for (missing, eye) in BOTH.into_iter().enumerate() {
            let colour = [0.5, 0.3, 0.2];
            let [before, after] = [colour, eye.linear(colour)].map(|c| times_vector(&cones, c));
            for cone in (0..3).filter(|cone| *cone != missing) {
                assert!((before[cone] - after[cone]).abs() < 1e-12, "{eye:?} {cone}");
            }
            assert!((before[missing] - after[missing]).abs() > 0.01);
            let unseen = LINEAR_FROM_CONES.map(|row| row[missing]);
            let other = std::array::from_fn(|k| colour[k] + 0.01 * unseen[k]);
            for (a, b) in eye.linear(colour).into_iter().zip(eye.linear(other)) {
                assert!((a - b).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn a_red_is_darker_to_an_eye_without_long_cones() {
        let [long, middle] = BOTH.map(|eye| eye.seen(Srgb([255, 0, 0])).0[0]);
        assert!(long < middle, "{long} {middle}");
    }
}
