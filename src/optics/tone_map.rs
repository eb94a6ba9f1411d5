//! From X, Y, Z to what a screen shows.

use super::picture::Picture;
use crate::{
    color::{
        Adapter, Srgb, Xyz,
        srgb::{WHITE, linear_from_xyz},
    },
    spectrum::quantile,
};

/// A picture for a screen.
#[derive(Clone, Debug, PartialEq)]
pub struct Shown {
    /// Pixels, row after row from the top.
    pub pixels: Vec<[u8; 3]>,
    /// Share of the pixels whose colour is outside sRGB and was mixed with white of equal Y.
    pub share_outside: f64,
    /// Share of the pixels brighter than the screen, cut.
    pub share_too_bright: f64,
    /// Factor applied to the white's Y.
    pub gain: f64,
}

/// Share of the pixels that automatic exposure leaves below the screen's full brightness.
const EXPOSED_SHARE: f64 = 0.95;

/// Depth below 0 down to which a channel counts as inside, as a share of the largest.
const SLACK: f64 = 1e-6;

/// Linear sRGB of a colour (Y = 1 for the screen's white), not below 0: what is outside the gamut
/// is mixed with white of the same Y. The flag says whether that was needed.
pub(crate) fn into_gamut(xyz: Xyz) -> ([f64; 3], bool) {
    if !(xyz.is_finite() && xyz.y > 0.0) {
        return ([0.0; 3], xyz != Xyz::ZERO);
    }
    let linear = linear_from_xyz(xyz);
    let lowest = linear.into_iter().fold(f64::INFINITY, f64::min);
    let largest = linear.into_iter().fold(0.0, f64::max);
    if lowest >= 0.0 {
        return (linear, false);
    }
    let white = linear_from_xyz(WHITE * xyz.y);
    // The lowest channel of the mixture is 0.
    let mixed = (0..3)
        .map(|k| linear[k] / (linear[k] - white[k]))
        .zip(linear)
        .filter(|(_, v)| *v < 0.0)
        .fold(0.0, |most: f64, (share, _)| most.max(share));
    let shown = std::array::from_fn(|k| (linear[k] + mixed * (white[k] - linear[k])).max(0.0));
    (shown, lowest < -SLACK * largest)
}

impl Picture {
    /// The picture as an eye sees it that is adapted to the light: its white is the screen's
    /// (Bradford). `None` where the light is too narrow for an eye to adapt to.
    pub(crate) fn adapted(&self) -> Option<Self> {
        let eye = Adapter::new(self.white, WHITE)?;
        let moved = |xyz: &[f32; 3]| {
            let xyz = eye.moved(Xyz::from_array(xyz.map(f64::from)));
            xyz.to_array().map(|v| v as f32)
        };
        Some(Self {
            xyz: self.xyz.iter().map(moved).collect(),
            white: WHITE * self.white.y,
            ..self.clone()
        })
    }

    /// The picture as a screen shows it, `stops` brighter than the exposure that leaves 95 % of
    /// the pixels below full brightness.
    pub fn shown(&self, stops: f64) -> Shown {
        let gain = self.automatic_gain() * stops.clamp(-20.0, 20.0).exp2();
        self.shown_with(gain)
    }

    /// The gain, over a white of Y 1, that leaves 95 % of the pixels below full brightness.
    pub(crate) fn automatic_gain(&self) -> f64 {
        let mut levels: Vec<f32> = self.xyz.iter().map(|xyz| xyz[1]).collect();
        let level = quantile(&mut levels, EXPOSED_SHARE).unwrap_or(0.0);
        let gain = self.white.y / level;
        if gain.is_finite() && gain > 0.0 {
            gain
        } else {
            1.0
        }
    }

    /// The picture as a screen shows it: a place of the white's Y becomes `gain`.
    pub(crate) fn shown_with(&self, gain: f64) -> Shown {
        let scale = if self.white.y > 0.0 {
            gain / self.white.y
        } else {
            0.0
        };
        let (mut outside, mut bright) = (0_usize, 0_usize);
        let pixel = |xyz: &[f32; 3]| {
            let xyz = Xyz::from_array(xyz.map(f64::from)) * scale;
            let (linear, is_outside) = into_gamut(xyz);
            outside += usize::from(is_outside);
            bright += usize::from(linear.iter().any(|v| *v > 1.0));
            Srgb::from_linear(linear.map(|v| v.min(1.0))).0
        };
        let pixels: Vec<[u8; 3]> = self.xyz.iter().map(pixel).collect();
        let share = |count: usize| count as f64 / pixels.len().max(1) as f64;
        Shown {
            share_outside: share(outside),
            share_too_bright: share(bright),
            pixels,
            gain,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::Observer;

    #[test]
    fn an_eye_makes_the_light_white_and_a_line_is_none_to_adapt_to() {
        let bulb = Xyz::new(1.0985, 1.0, 0.35585) * 7.0;
        let of = |white: Xyz| Picture {
            size: 1,
            xyz: vec![(white * 0.5).to_array().map(|v| v as f32)],
            white,
            stand_ins_nm: Vec::new(),
            unfinished: false,
        };
        let as_it_is = of(bulb).shown_with(1.0).pixels[0];
        assert!(as_it_is[0] > as_it_is[2] + 50, "{as_it_is:?}");
        let seen = of(bulb).adapted().unwrap();
        let [r, g, b] = seen.shown_with(1.0).pixels[0];
        assert!(r.abs_diff(g) <= 1 && g.abs_diff(b) <= 1, "{r} {g} {b}");
        assert!((seen.white.y - bulb.y).abs() < 1e-12);
        let sodium = Xyz::from_array(Observer::CIE_1931.table().at(589.3));
        assert_eq!(of(sodium).adapted(), None);
    }

    #[test]
    fn what_a_screen_can_show_is_left_and_the_rest_keeps_its_luminance() {
        let grey = WHITE * 0.25;
        let (shown, outside) = into_gamut(grey);
        assert!(!outside && shown.iter().all(|v| (v - 0.25).abs() < 1e-12));
        for nm in [405.0, 436.0, 500.0, 546.0, 578.0, 650.0] {
            let line = Xyz::from_array(Observer::CIE_1931.table().at(nm));
            let (shown, outside) = into_gamut(line);
            assert!(outside && shown.iter().all(|v| *v >= 0.0), "{nm}");
            let back = crate::color::srgb::xyz_from_linear(shown);
            // Mixing with white of the same Y.
            assert!((back.y - line.y).abs() < 1e-9, "{nm}");
        }
        assert_eq!(into_gamut(Xyz::new(f64::NAN, 1.0, 1.0)).0, [0.0; 3]);
        assert_eq!(into_gamut(Xyz::new(0.1, -1.0, 0.0)).0, [0.0; 3]);
    }
}
