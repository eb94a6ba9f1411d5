//! The ways to tell a colour: a screen's three bytes, or three numbers.

use serde::{Deserialize, Serialize};

use crate::{
    app::recipe::Given,
    color::{Swatch, Xyz, lab_from_xyz, xy_from_xyz},
};

/// A way to tell a colour.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Telling {
    /// sRGB, picked or in hexadecimal.
    #[default]
    Srgb,
    /// X, Y, Z with Y = 100 for the light.
    Xyz,
    /// L*, a*, b* against the light.
    Lab,
    /// x, y and Y with Y = 100 for the light.
    Xyy,
}

/// One of the three numbers of a way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Number {
    /// Its letter.
    pub title: &'static str,
    /// Least and greatest value.
    pub range: [f64; 2],
    /// Digits behind the point.
    pub digits: usize,
}

/// Greatest X, Y or Z: a light of one narrow LED has a white of some hundreds.
const MOST: f64 = 2000.0;

const fn number(title: &'static str, range: [f64; 2], digits: usize) -> Number {
    Number {
        title,
        range,
        digits,
    }
}

impl Telling {
    /// Every way.
    pub const ALL: [Self; 4] = [Self::Srgb, Self::Xyz, Self::Lab, Self::Xyy];

    /// Its name on the page.
    pub fn title(self) -> &'static str {
        match self {
            Self::Srgb => "sRGB",
            Self::Xyz => "XYZ",
            Self::Lab => "L*a*b*",
            Self::Xyy => "xyY",
        }
    }

    /// What its numbers are, a sentence.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Srgb => said!("As a screen shows it to an eye that is adapted to the light."),
            Self::Xyz => said!("CIE 1931, a perfect white having Y = 100 under the light."),
            Self::Lab => said!("CIE 1976, against the light's own white."),
            Self::Xyy => {
                said!("CIE 1931 chromaticity, and Y = 100 for a perfect white under the light.")
            }
        }
    }

    /// Its numbers; a screen's colour has its own field.
    pub fn numbers(self) -> Option<[Number; 3]> {
        let whole = [0.0, MOST];
        match self {
            Self::Srgb => None,
            Self::Xyz => Some(["X", "Y", "Z"].map(|title| number(title, whole, 2))),
            Self::Lab => Some([
                number("L*", [0.0, 100.0], 1),
                number("a*", [-200.0, 200.0], 1),
                number("b*", [-200.0, 200.0], 1),
            ]),
            Self::Xyy => Some([
                number("x", [0.0, 1.0], 4),
                number("y", [0.0, 1.0], 4),
                number("Y", [0.0, 100.0], 1),
            ]),
        }
    }

    /// The colour of three such numbers; a screen's of red, green and blue of 0-255.
    pub fn given(self, numbers: [f64; 3]) -> Given {
        match self {
            Self::Srgb => Given::Srgb(numbers.map(|v| v.round() as u8)),
            Self::Xyz => Given::Xyz(numbers),
            Self::Lab => Given::Lab(numbers),
            Self::Xyy => Given::Xyy(numbers),
        }
    }

    /// The numbers of a colour (XYZ, under a light of that white): as they were given where they
    /// were given this way.
    pub fn told(self, given: &Given, xyz: Xyz, white: Xyz) -> [f64; 3] {
        match (self, given) {
            (Self::Xyz, Given::Xyz(own))
            | (Self::Lab, Given::Lab(own))
            | (Self::Xyy, Given::Xyy(own)) => *own,
            (Self::Srgb, _) => {
                let adapted = crate::color::Adaptation::ToLight;
                Swatch::of_patch(xyz, white, adapted).rgb8.0.map(f64::from)
            }
            (Self::Xyz, _) => xyz.to_array(),
            (Self::Lab, _) => {
                let lab = lab_from_xyz(xyz, white);
                [lab.l, lab.a, lab.b]
            }
            (Self::Xyy, _) => {
                // Black has the chromaticity of the light.
                let [x, y] = xy_from_xyz(xyz).or(xy_from_xyz(white)).unwrap_or_default();
                [x, y, xyz.y]
            }
        }
    }
}

impl Given {
    /// Moves every number to the nearest one that is allowed; what is no number to the lowest.
    pub fn settle(&mut self) {
        let (way, numbers) = match self {
            Self::Xyz(numbers) => (Telling::Xyz, numbers),
            Self::Lab(numbers) => (Telling::Lab, numbers),
            Self::Xyy(numbers) => (Telling::Xyy, numbers),
            Self::Srgb(_) | Self::Of(_) => return,
        };
        let ranges = way.numbers().map(|all| all.map(|number| number.range));
        for (number, [least, most]) in numbers.iter_mut().zip(ranges.unwrap_or([[0.0, MOST]; 3])) {
            *number = number.max(least).min(most);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_way_tells_the_same_colour() {
        let (xyz, white) = (Xyz::new(20.0, 30.0, 12.0), Xyz::new(95.0, 100.0, 108.0));
        let told = |way: Telling| way.told(&Given::Of(String::new()), xyz, white);
        assert_eq!(told(Telling::Xyz), [20.0, 30.0, 12.0]);
        let [x, y, whole] = told(Telling::Xyy);
        assert!((x - 20.0 / 62.0).abs() < 1e-12 && (y - 30.0 / 62.0).abs() < 1e-12);
        assert_eq!(whole, 30.0);
        assert!(told(Telling::Lab)[1] < 0.0, "it is green");
        let [red, green, blue] = told(Telling::Srgb);
        assert!(green > red && green > blue);
        // What was given this way comes back as it was given.
        let own = [0.3, 0.4, 50.0];
        assert_eq!(Telling::Xyy.told(&Given::Xyy(own), xyz, white), own);
    }

    #[test]
    fn numbers_that_make_no_sense_are_moved() {
        let settled = |mut given: Given| {
            given.settle();
            given
        };
        let lab = settled(Given::Lab([f64::NAN, 1e9, 0.0]));
        assert_eq!(lab, Given::Lab([0.0, 200.0, 0.0]));
        let xyy = settled(Given::Xyy([2.0, -1.0, 500.0]));
        assert_eq!(xyy, Given::Xyy([1.0, 0.0, 100.0]));
        let xyz = settled(Given::Xyz([-1.0, f64::INFINITY, 5.0]));
        assert_eq!(xyz, Given::Xyz([0.0, MOST, 5.0]));
    }
}
