//! Preview of a file for viewers: its picture under its own light, reduced, in eight bits.

use crate::color::srgb::{Srgb, WHITE, linear_from_xyz};
use crate::color::{Xyz, adapted};
use crate::study::Progress;

use super::kernel::Kernel;
use super::strips::over_strips;
use super::survey::percentile;
use super::{Operator, PictureError, Pixels, Relit};

/// Longest side.
pub(super) const MOST_SIDE: usize = 256;
/// Share of the pixels that are no brighter than full.
const FULL: f64 = 0.99;

/// A reduced picture.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Preview {
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Each of its pixels is the mean of so many across and down.
    pub step: usize,
    /// Red, green, blue of each pixel.
    pub rgb: Vec<u8>,
}

/// Linear sRGB of the own colour against its white, Y = 1 for the white.
pub(super) fn to_linear(relit: &Relit) -> impl Fn(Xyz) -> [f64; 3] + '_ {
    let white = relit.white;
    move |xyz| {
        let scale = if white.y > 0.0 { 1.0 / white.y } else { 1.0 };
        let relative = xyz * scale;
        linear_from_xyz(adapted(relative, white, WHITE).unwrap_or(relative))
    }
}

impl Preview {
    /// The preview of a picture by its decoded numbers' own colours.
    ///
    /// # Errors
    /// Those of the source, and [`PictureError::Cancelled`].
    pub(crate) fn of(
        pixels: &dyn Pixels,
        operator: &Operator,
        progress: &Progress,
    ) -> Result<Self, PictureError> {
        let (width, height) = pixels.size();
        let step = width.max(height).div_ceil(MOST_SIDE).max(1);
        let across = width.div_ceil(step);
        let own = operator.own_colour();
        let rows: Vec<&[f64]> = operator.own_weights().iter().map(Vec::as_slice).collect();
        let kernel = Kernel::of_rows(&rows);
        progress.expect(height.div_ceil(step));
        let drawn = over_strips(pixels, step, progress, |strip| {
            let mut xyz = vec![0.0; 3 * strip.pixels];
            kernel.apply(strip.values, strip.pixels, &mut xyz);
            let mut blocks = vec![([0.0; 3], 0.0); across];
            for i in 0..strip.pixels {
                let value: [f64; 3] = std::array::from_fn(|k| f64::from(xyz[k * strip.pixels + i]));
                if value.iter().all(|v| v.is_finite()) {
                    let block = &mut blocks[i % width / step];
                    (0..3).for_each(|k| block.0[k] += value[k]);
                    block.1 += 1.0;
                }
            }
            Ok(blocks)
        })?;
        let linear = to_linear(&own);
        let mean = |(sum, count): ([f64; 3], f64)| {
            (count > 0.0).then(|| linear(Xyz::from_array(sum.map(|s| s / count))))
        };
        let pixels: Vec<_> = drawn.into_iter().flatten().map(mean).collect();
        let strongest = |rgb: &[f64; 3]| rgb.iter().copied().fold(0.0, f64::max);
        let mut strongest: Vec<f64> = pixels.iter().flatten().map(strongest).collect();
        let full = percentile(&mut strongest, FULL);
        let full = if full > 0.0 { full } else { 1.0 };
        let rgb = pixels.iter().enumerate().flat_map(|(i, pixel)| {
            let is_dark = (i % across / 4 + i / across / 4) % 2 == 0;
            match pixel {
                Some(linear) => Srgb::from_linear(linear.map(|v| (v / full).clamp(0.0, 1.0))).0,
                // Not measured: chequered.
                None => [if is_dark { 96 } else { 160 }; 3],
            }
        });
        Ok(Self {
            width: across,
            height: height.div_ceil(step),
            step,
            rgb: rgb.collect(),
        })
    }
}
