//! Exposure: from the numbers of a picture to sRGB pixels.

use std::sync::LazyLock;

use super::Raster;
use crate::{
    color::{Srgb, Swatch, Xyz, srgb::linear_from_xyz},
    languages::fixed,
};

/// The two greys of the chequers where nothing was measured.
pub const NOT_MEASURED: [[u8; 3]; 2] = [[70; 3], [100; 3]];

/// How far a channel may leave 0-1 and still count as shown: half a step of 8 bits, in the dark
/// part of the curve.
const SLACK: f64 = 0.5 / (255.0 * 12.92);

/// Places of the table of the transfer function.
const PLACES: usize = 1 << 16;

/// The transfer function of sRGB in 8 bits, on even steps of linear light.
static ENCODED: LazyLock<Vec<u8>> = LazyLock::new(|| {
    let place = |i: usize| Srgb::from_linear([i as f64 / (PLACES - 1) as f64; 3]).0[0];
    (0..PLACES).map(place).collect()
});

/// A picture as a screen shows it.
#[derive(Clone, Debug, PartialEq)]
pub struct Exposed {
    /// Drawn columns.
    pub width: usize,
    /// Drawn rows.
    pub height: usize,
    /// Row after row.
    pub pixels: Vec<[u8; 3]>,
    /// Drawn pixels that no screen of sRGB shows: more saturated than its primaries.
    pub outside_gamut: usize,
    /// Drawn pixels brighter than the screen's white (and not outside the gamut), cut.
    pub too_bright: usize,
    /// Drawn pixels that were not measured, drawn as chequers.
    pub not_measured: usize,
}

/// XYZ as a picture shows it: with its exposure, channels cut to 0-1; `None` where it shows bands
/// or nothing shines.
pub fn seen_in(raster: &Raster, stops: f64, xyz: Xyz) -> Option<Swatch> {
    let full = raster.full[1];
    let is_lit = raster.is_xyz && full > 0.0 && xyz.is_finite();
    is_lit.then(|| Swatch::exposed(xyz.scaled(stops.exp2() / full)))
}

/// Exposes a picture: at 0 stops its 99th percentile is the screen's full brightness.
pub fn exposed(raster: &Raster, stops: f64) -> Exposed {
    let gain = |full: f64| if full > 0.0 { stops.exp2() / full } else { 0.0 };
    let gains = raster.full.map(gain);
    let mut exposed = Exposed {
        width: raster.width,
        height: raster.height,
        pixels: Vec::with_capacity(raster.values.len()),
        outside_gamut: 0,
        too_bright: 0,
        not_measured: 0,
    };
    let table = &*ENCODED;
    for (index, value) in raster.values.iter().enumerate() {
        let value = value.map(f64::from);
        if !value.iter().all(|v| v.is_finite()) {
            exposed.not_measured += 1;
            let (x, y) = (index % raster.width, index / raster.width);
            exposed.pixels.push(NOT_MEASURED[(x + y) % 2]);
            continue;
        }
        let channels = std::array::from_fn(|k| value[k] * gains[k]);
        let linear = if raster.is_xyz {
            linear_from_xyz(Xyz::from_array(channels))
        } else {
            channels
        };
        let largest = linear.into_iter().fold(0.0, f64::max);
        // A share of the pixel's own brightness: rounding leaves no dark pixel outside.
        let negative = linear.iter().any(|v| *v < -SLACK.max(1e-6 * largest));
        if negative && raster.is_xyz {
            exposed.outside_gamut += 1;
        } else if largest > 1.0 + SLACK {
            exposed.too_bright += 1;
        }
        // `as usize` takes what is negative to 0.
        let place = |v: f64| ((v * (PLACES - 1) as f64 + 0.5) as usize).min(PLACES - 1);
        exposed.pixels.push(linear.map(|v| table[place(v)]));
    }
    exposed
}

impl Exposed {
    /// What is not shown as it is, in words; empty when everything is.
    pub fn words(&self) -> String {
        let mut parts = Vec::new();
        // In percent; few pixels are counted instead.
        let share = |count: usize| match 100.0 * count as f64 / self.pixels.len().max(1) as f64 {
            p if p < 0.1 => None,
            p if p < 10.0 => Some(fixed(p, 1)),
            p => Some(fixed(p, 0)),
        };
        let [dark, strong, bright] = [self.not_measured, self.outside_gamut, self.too_bright];
        if dark > 0 {
            parts.push(match share(dark) {
                None => tr!("{n} pixel is not measured, chequered"
                    | "{n} pixels are not measured, chequered" % dark),
                Some(share) => tr!("{share} % of the pixels are not measured, chequered", share),
            });
        }
        if strong > 0 {
            parts.push(match share(strong) {
                None => tr!("{n} pixel is outside sRGB, cut to it"
                    | "{n} pixels are outside sRGB, cut to it" % strong),
                Some(share) => tr!("{share} % of the pixels are outside sRGB, cut to it", share),
            });
        }
        if bright > 0 {
            parts.push(match share(bright) {
                None => tr!("{n} pixel is brighter than white, cut"
                    | "{n} pixels are brighter than white, cut" % bright),
                Some(share) => tr!(
                    "{share} % of the pixels are brighter than white, cut",
                    share
                ),
            });
        }
        parts.join("; ")
    }
}
