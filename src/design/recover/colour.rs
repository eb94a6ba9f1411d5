//! A colour as a person gives it, and what it asks of a surface under a light.

use super::{error::RecoverError, viewing::Viewing};
use crate::color::{Lab, Srgb, Xyz, adapted, srgb, xyz_from_lab, xyz_from_xy};

/// A colour that a surface is to have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Colour {
    /// As a screen shows it, for an eye adapted to the light: the screen's white is the light's.
    Srgb(Srgb),
    /// The same with linear channels, 0-1 (pictures of more than 8 bits).
    Linear([f64; 3]),
    /// XYZ where the light has Y = 100.
    Xyz(Xyz),
    /// L\*a\*b\* against the light's own white.
    Lab(Lab),
    /// `[x, y, Y]` where the light has Y = 100.
    Xyy([f64; 3]),
}

impl Colour {
    /// The XYZ that a surface must have under the light, Y = 100 for the light.
    ///
    /// A screen's colour is what the program shows of a patch "adapted to the light", taken back
    /// by the same Bradford adaptation.
    ///
    /// # Errors
    /// [`RecoverError::NotAColour`] for numbers that are not finite or an xy without Y,
    /// [`RecoverError::TooNarrowToAdapt`] for a screen's colour under a light of few lines.
    pub fn under(self, viewing: &Viewing) -> Result<Xyz, RecoverError> {
        let white = viewing.white();
        let xyz = match self {
            Self::Srgb(srgb) => of_screen(srgb.to_linear(), white)?,
            Self::Linear(linear) => of_screen(linear, white)?,
            Self::Xyz(xyz) => xyz,
            Self::Lab(lab) => xyz_from_lab(lab, white),
            // Black has no chromaticity to be asked about.
            Self::Xyy([x, y, 0.0]) if x.is_finite() && y.is_finite() => Xyz::ZERO,
            Self::Xyy([x, y, luminance]) => {
                xyz_from_xy([x, y], luminance).ok_or(RecoverError::NotAColour)?
            }
        };
        xyz.is_finite()
            .then_some(xyz)
            .ok_or(RecoverError::NotAColour)
    }
}

fn of_screen(linear: [f64; 3], white: Xyz) -> Result<Xyz, RecoverError> {
    // The way back is asked first: under a light that the eye cannot adapt to, the screen's
    // colours mean nothing.
    adapted(srgb::WHITE, white, srgb::WHITE).ok_or(RecoverError::TooNarrowToAdapt)?;
    let seen = adapted(srgb::xyz_from_linear(linear), srgb::WHITE, white);
    Ok(seen.ok_or(RecoverError::TooNarrowToAdapt)? * 100.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        color::{Adaptation, Observer, Swatch},
        spectrum::Sampled,
    };

    fn warm() -> Viewing {
        let light = Sampled::new(vec![380.0, 780.0], vec![0.1, 2.0]).unwrap();
        Viewing::new(&light, Observer::CIE_1931).unwrap()
    }

    #[test]
    fn a_screens_colour_comes_back_as_the_swatch_that_the_program_shows_of_it() {
        for hex in ["#c08040", "#123456", "#ffffff", "#00ff00"] {
            let asked: Srgb = hex.parse().unwrap();
            let xyz = Colour::Srgb(asked).under(&warm()).unwrap();
            let swatch = Swatch::of_patch(xyz, warm().white(), Adaptation::ToLight);
            assert_eq!(swatch.rgb8, asked);
        }
    }

    #[test]
    fn what_is_no_colour_is_refused() {
        for colour in [
            Colour::Xyz(Xyz::new(f64::NAN, 1.0, 1.0)),
            Colour::Lab(Lab::new(50.0, f64::INFINITY, 0.0)),
            Colour::Xyy([0.3, 0.0, 20.0]),
        ] {
            assert_eq!(colour.under(&warm()), Err(RecoverError::NotAColour));
        }
        assert_eq!(Colour::Xyy([0.3, 0.0, 0.0]).under(&warm()), Ok(Xyz::ZERO));
    }
}
