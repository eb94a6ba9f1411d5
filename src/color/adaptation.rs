//! Bradford chromatic adaptation: how a colour under one light would have to look under another
//! to seem the same to an eye used to it.
//!
//! Source of the cone-like matrix: Lam 1985, as given in ICC.1:2022 Annex E.

use super::{
    matrix::{Matrix3, inverse, times_vector},
    xyz::Xyz,
};

const CONES_FROM_XYZ: Matrix3 = [
    [0.8951, 0.2664, -0.1614],
    [-0.7502, 1.7135, 0.0367],
    [0.0389, -0.0685, 1.0296],
];

const XYZ_FROM_CONES: Matrix3 = inverse(&CONES_FROM_XYZ);

/// Smallest cone signal of a white, as a share of its Y, that an eye can still be said to adapt to.
///
/// Low-pressure sodium drives the blue signal slightly negative: dividing by it would invert
/// colours. One per cent already means a gain of a hundred.
const SMALLEST_SIGNAL: f64 = 0.01;

/// Rendering of a patch: as it is, or as it looks to an eye adapted to the light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Adaptation {
    /// As it is: under incandescent light everything is orange.
    #[default]
    None,
    /// Adapted to the light: the light itself becomes the screen's white.
    ToLight,
}

impl Adaptation {
    /// In words for people.
    pub fn words(self) -> &'static str {
        match self {
            Self::None => said!("as seen beside daylight"),
            Self::ToLight => said!("as the eye sees it after a minute"),
        }
    }
}

/// An eye whose white moves: many colours follow it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Adapter {
    from: [f64; 3],
    to: [f64; 3],
}

impl Adapter {
    /// The white moves from `from_white` to `to_white` (each in any scale; each white's own Y
    /// counts as 1).
    ///
    /// `None` when `from_white` leaves one of the eye's signals practically dark (a single line,
    /// low-pressure sodium), because no gain can restore what is not there.
    pub(crate) fn new(from_white: Xyz, to_white: Xyz) -> Option<Self> {
        let from = times_vector(&CONES_FROM_XYZ, from_white.with_y(1.0)?.to_array());
        let to = times_vector(&CONES_FROM_XYZ, to_white.with_y(1.0)?.to_array());
        let is_seen = from.iter().all(|signal| *signal >= SMALLEST_SIGNAL);
        is_seen.then_some(Self { from, to })
    }

    /// The colour that corresponds to another one.
    pub(crate) fn moved(&self, xyz: Xyz) -> Xyz {
        let cones = times_vector(&CONES_FROM_XYZ, xyz.to_array());
        let moved = std::array::from_fn(|k| cones[k] * self.to[k] / self.from[k]);
        Xyz::from_array(times_vector(&XYZ_FROM_CONES, moved))
    }
}

/// The colour that corresponds to `xyz` when the eye's white moves from `from_white` to
/// `to_white`; `None` where there is no [`Adapter`] for them.
pub(crate) fn adapted(xyz: Xyz, from_white: Xyz, to_white: Xyz) -> Option<Xyz> {
    Some(Adapter::new(from_white, to_white)?.moved(xyz))
}

#[cfg(test)]
mod tests {
    use super::*;

    const A: Xyz = Xyz::new(109.85, 100.0, 35.585);
    const D65: Xyz = Xyz::new(95.047, 100.0, 108.883);

    #[test]
    fn the_old_white_becomes_the_new_white() {
        let seen = adapted(A, A, D65).unwrap();
        // Two 3x3 products with numbers near 100.
        assert!((seen - D65).to_array().iter().all(|d| d.abs() < 1e-12));
    }

    #[test]
    fn there_and_back_changes_nothing() {
        let colour = Xyz::new(20.0, 30.0, 10.0);
        let back = adapted(adapted(colour, A, D65).unwrap(), D65, A).unwrap();
        // Four 3x3 products with numbers near 30.
        assert!((back - colour).to_array().iter().all(|d| d.abs() < 1e-12));
        let same = adapted(colour, A, A * 0.01).unwrap();
        // Only the chromaticity of a white counts.
        assert!((same - colour).to_array().iter().all(|d| d.abs() < 1e-12));
    }

    #[test]
    fn nobody_adapts_to_a_single_line() {
        let sodium = Xyz::new(136.0, 100.0, 0.0);
        assert_eq!(adapted(D65, sodium, D65), None);
        assert_eq!(adapted(D65, Xyz::ZERO, D65), None);
    }
}
