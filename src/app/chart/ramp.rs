//! Colours for values: dark blue over teal to yellow.
//!
//! Equal steps of value are equal steps of lightness (CIE L* from 20 to 91), because lightness is
//! what the eye reads as "more"; hue alone is lost on colour-blind eyes and on grey paper. The
//! anchors were set in CIELAB, nine L* apart, on a path from blue to yellow, which are also the two
//! hues that the common forms of colour blindness leave apart; in between sRGB is straight enough.

use super::Rgb;

/// Evenly spaced from the lowest value to the highest.
const ANCHORS: [Rgb; 9] = [
    [24, 45, 102],
    [22, 68, 126],
    [9, 93, 151],
    [38, 119, 155],
    [50, 147, 158],
    [91, 173, 142],
    [136, 197, 117],
    [197, 217, 82],
    [252, 230, 63],
];

/// The colour of a place from 0 (lowest) to 1 (highest); what is outside has the end's colour.
pub fn ramp_colour(place: f64) -> Rgb {
    let steps = (ANCHORS.len() - 1) as f64;
    // NaN becomes 0: callers leave it out, and no colour is no answer.
    let along = place.clamp(0.0, 1.0).max(0.0) * steps;
    let below = (along as usize).min(ANCHORS.len() - 2);
    let part = along - below as f64;
    let [low, high] = [ANCHORS[below], ANCHORS[below + 1]];
    [0, 1, 2].map(|c| {
        let [low, high] = [low[c], high[c]].map(f64::from);
        (low + (high - low) * part).round() as u8
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::{Srgb, lab_from_xyz, srgb::xyz_from_linear};

    fn lightness(place: f64) -> f64 {
        let of = |colour: Rgb| xyz_from_linear(Srgb(colour).to_linear());
        lab_from_xyz(of(ramp_colour(place)), of([255; 3])).l
    }

    #[test]
    fn equal_steps_of_value_are_equal_steps_of_lightness() {
        let [dark, light] = [lightness(0.0), lightness(1.0)];
        assert!(light - dark > 65.0, "{dark} to {light}");
        for step in 0..=100 {
            let place = f64::from(step) / 100.0;
            let even = dark + (light - dark) * place;
            // Two units of L* are about what one can tell apart side by side.
            let off = lightness(place) - even;
            assert!(off.abs() < 2.0, "{off} at {place}");
        }
    }

    #[test]
    fn what_is_outside_has_the_colour_of_the_end() {
        assert_eq!(ramp_colour(-3.0), ANCHORS[0]);
        assert_eq!(ramp_colour(f64::INFINITY), ANCHORS[8]);
        assert_eq!(ramp_colour(f64::NAN), ANCHORS[0]);
    }
}
