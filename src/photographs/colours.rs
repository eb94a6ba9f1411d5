//! Wavelengths that a camera may show in a colour, measured on published cameras.

/// A channel of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Channel {
    /// Red.
    R,
    /// Green.
    G,
    /// Blue.
    B,
}

use Channel::{B, G, R};

/// The largest channel of a peak, and the next where it stands out of the noise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hue {
    first: Channel,
    second: Option<Channel>,
}

/// Channels that lie closer together than this share of the largest are no colour.
const LEAST_SPREAD: f64 = 0.25;
/// A second channel below this share of the largest says nothing.
const LEAST_SECOND: f64 = 0.05;
/// A clipped peak whose third channel is above this share of the largest is no colour.
const MOST_THIRD: f64 = 0.25;
/// From here on cameras differ in all but their red, nm.
const RED_END_NM: f64 = 700.0;
/// Largest cost of a colour that does not fit.
const MOST_COST: f64 = 6.0;

impl Hue {
    /// The colour of three channels with their noise; `None` where they have none.
    pub fn of(light: [f64; 3], sigma: [f64; 3], is_clipped: bool) -> Option<Self> {
        let mut order = [(light[0], 0, R), (light[1], 1, G), (light[2], 2, B)];
        order.sort_by(|a, b| b.0.total_cmp(&a.0));
        let [first, second, third] = order;
        let noise = 3.0 * sigma[first.1].hypot(sigma[third.1]);
        let spread = first.0 - third.0;
        if first.0 <= 0.0 || spread < LEAST_SPREAD * first.0 || spread < noise {
            return None;
        }
        if is_clipped && third.0 > MOST_THIRD * first.0 {
            return None;
        }
        // An order within the noise is none.
        let tells = second.0 > LEAST_SECOND * first.0
            && second.0 - third.0 > 2.0 * sigma[second.1].hypot(sigma[third.1])
            && first.0 - second.0 > 2.0 * sigma[first.1].hypot(sigma[second.1]);
        if !tells && first.0 - second.0 <= 2.0 * sigma[first.1].hypot(sigma[second.1]) {
            return None;
        }
        Some(Self {
            first: first.2,
            second: tells.then_some(second.2),
        })
    }

    /// The largest channel.
    pub fn first(self) -> Channel {
        self.first
    }

    /// Red before green: yellow to red.
    pub fn is_yellow(self) -> bool {
        self.first == R && self.second == Some(G)
    }

    /// Ranges in nm in which cameras show this colour.
    fn ranges(self) -> &'static [(f64, f64)] {
        match (self.first, self.second) {
            (B, Some(R)) => &[(385.0, 468.0)],
            (B, Some(_)) => &[(393.0, 508.0)],
            (G, Some(B)) => &[(478.0, 552.0)],
            (G, Some(_)) => &[(508.0, 592.0)],
            (R, Some(G)) => &[(563.0, 705.0)],
            (R, Some(_)) => &[(385.0, 430.0), (590.0, 705.0)],
            (B, None) => &[(385.0, 508.0)],
            (G, None) => &[(478.0, 602.0)],
            (R, None) => &[(562.0, 705.0)],
        }
    }

    /// Cost, in log-likelihood, of this colour for a line of this wavelength.
    pub fn cost(self, nm: f64) -> f64 {
        if nm > RED_END_NM {
            return if self.first == R { 0.0 } else { 1.0 };
        }
        let outside = |&(low, high): &(f64, f64)| (low - nm).max(nm - high).max(0.0);
        let away = self.ranges().iter().map(outside).fold(f64::MAX, f64::min);
        (0.5 * (away / 8.0).powi(2)).min(MOST_COST)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_colour_costs_nothing_where_cameras_show_it_and_more_the_farther_off() {
        let green = Hue::of([0.1, 1.0, 0.3], [0.001; 3], false).expect("a colour");
        assert_eq!(green.cost(500.0), 0.0);
        assert!(green.cost(560.0) > 0.4 && green.cost(560.0) < 0.6);
        assert_eq!(green.cost(620.0), MOST_COST);
        let red = Hue::of([1.0, 0.3, 0.0], [0.001; 3], false).expect("a colour");
        assert_eq!(
            (red.cost(640.0), red.cost(760.0), green.cost(760.0)),
            (0.0, 0.0, 1.0)
        );
    }

    #[test]
    fn white_is_no_colour_and_noise_is_none() {
        assert_eq!(Hue::of([1.0, 0.9, 0.8], [0.001; 3], false), None);
        assert_eq!(Hue::of([0.01, 0.0, 0.0], [0.01; 3], false), None);
        assert_eq!(Hue::of([1.0, 0.5, 0.4], [0.001; 3], true), None);
        assert_eq!(Hue::of([0.0; 3], [0.0; 3], false), None);
    }
}
