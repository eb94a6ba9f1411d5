//! From a cube to three numbers for every pixel that is drawn.
//!
//! An image of more pixels than the screen has is drawn reduced: a block of pixels becomes its
//! mean. Rows are shared out over threads.

use super::BandWeights;
use crate::{
    app::{memo::ByAddress, studies::Question},
    color::{Xyz, srgb::linear_from_xyz},
    spectrum::{Cube, SpectralImage, quantile},
    study::{Progress, processors, side_by_side},
};

/// Most pixels that are drawn.
const MOST_PIXELS: usize = 1 << 20;

/// Longest side that is drawn: nearly every graphics driver takes a texture of it.
pub const MOST_SIDE: usize = 2048;

/// Share of the pixels that are no brighter than full brightness.
const FULL: f64 = 0.99;

/// Values that decide about the exposure.
const LOOKED_AT: usize = 1 << 16;

/// Most threads that share out the rows.
const MOST_THREADS: usize = 8;

/// What the three numbers of a pixel are.
#[derive(Clone, Debug, PartialEq)]
pub enum Source {
    /// X, Y and Z.
    TrueColour(Box<BandWeights>),
    /// One band, or one each for red, green and blue, in the file's own numbers.
    Bands(Vec<usize>),
}

/// What a picture is made of.
#[derive(Clone, Debug, PartialEq)]
pub struct RasterAsk {
    pub image: ByAddress<SpectralImage>,
    /// What its numbers become.
    pub source: Source,
    /// Longest side that the graphics driver takes; [`MOST_SIDE`] where it takes more.
    pub most_side: usize,
}

/// A picture before its exposure.
#[derive(Clone, Debug, PartialEq)]
pub struct Raster {
    /// Drawn columns.
    pub width: usize,
    /// Drawn rows.
    pub height: usize,
    /// Each drawn pixel is the mean of so many pixels across and down.
    pub step: usize,
    /// X, Y, Z, or the numbers of the bands, of each drawn pixel; NaN where it was not measured.
    pub values: Vec<[f32; 3]>,
    /// Whether the values are XYZ.
    pub is_xyz: bool,
    /// What is shown at full brightness at exposure 0: the 99th percentile of the strongest of
    /// red, green and blue (linear, 1 for white of Y = 1), or of each band; 0 where nothing shines.
    pub full: [f64; 3],
}

/// By how much an image is reduced, across and down, to be drawn with sides of at most
/// `most_side`.
pub fn step_of(width: usize, height: usize, most_side: usize) -> usize {
    let most_side = most_side.clamp(1, MOST_SIDE);
    let fits = |step: usize| {
        let (across, down) = (width.div_ceil(step), height.div_ceil(step));
        across <= most_side && down <= most_side && across * down <= MOST_PIXELS
    };
    let mut step = (width.max(height).div_ceil(most_side)).max(1);
    while !fits(step) {
        step += 1;
    }
    step
}

impl Question for RasterAsk {
    type Answer = Raster;

    /// The picture; `None` when it was cancelled.
    fn answer(&self, progress: &Progress) -> Option<Raster> {
        let cube = &self.image.0.cube;
        let step = step_of(cube.width(), cube.height(), self.most_side);
        let (width, height) = (cube.width().div_ceil(step), cube.height().div_ceil(step));
        progress.expect(height);
        let rows = Rows::new(self, step);
        let mut values = vec![[f32::NAN; 3]; width * height];
        let share = height.div_ceil(processors().min(MOST_THREADS)).max(1);
        let parts = values.chunks_mut(share * width).enumerate();
        side_by_side(parts, |(part, into)| {
            rows.fill(part * share, into, width, progress);
        });
        if progress.is_cancelled() {
            return None;
        }
        let is_xyz = matches!(self.source, Source::TrueColour(_));
        let full = if is_xyz {
            // The strongest of red, green and blue: a saturated red is cut long before its Y is 1.
            let strongest = |xyz: [f32; 3]| {
                if !xyz.iter().all(|v| v.is_finite()) {
                    return f32::NAN;
                }
                let linear = linear_from_xyz(Xyz::from_array(xyz.map(f64::from)));
                linear.into_iter().fold(f64::NEG_INFINITY, f64::max) as f32
            };
            [percentile(&values, strongest); 3]
        } else {
            std::array::from_fn(|k| percentile(&values, |value| value[k]))
        };
        Some(Raster {
            width,
            height,
            step,
            values,
            is_xyz,
            full,
        })
    }
}

/// The weighted sums that make up a picture.
struct Rows<'a> {
    ask: &'a RasterAsk,
    cube: &'a Cube,
    /// Bands that are seen, with their weights.
    bands: Vec<(usize, [f64; 3])>,
    step: usize,
}

impl<'a> Rows<'a> {
    fn new(ask: &'a RasterAsk, step: usize) -> Self {
        let bands = match &ask.source {
            Source::TrueColour(weights) => {
                let weights = weights.weights().iter().copied().enumerate();
                weights.filter(|(_, w)| *w != [0.0; 3]).collect()
            }
            Source::Bands(bands) => {
                let channel = |index: usize| match bands.len() {
                    1 => [1.0; 3],
                    _ => std::array::from_fn(|k| f64::from(u8::from(k == index))),
                };
                let named = bands.iter().enumerate().take(3);
                named.map(|(index, band)| (*band, channel(index))).collect()
            }
        };
        Self {
            cube: &ask.image.0.cube,
            ask,
            bands,
            step,
        }
    }

    /// Drawn rows from `first` on.
    fn fill(&self, first: usize, into: &mut [[f32; 3]], width: usize, progress: &Progress) {
        let mut sums = vec![[0.0; 3]; self.cube.width()];
        let mut row = vec![0.0; self.cube.width()];
        let mut blocks = vec![([0.0; 3], 0.0); width];
        for (index, drawn) in into.chunks_mut(width).enumerate() {
            if progress.is_cancelled() {
                return;
            }
            blocks.fill(([0.0; 3], 0.0));
            let top = (first + index) * self.step;
            for y in top..(top + self.step).min(self.cube.height()) {
                self.sum(y, &mut sums, &mut row);
                for (block, pixels) in blocks.iter_mut().zip(sums.chunks(self.step)) {
                    for pixel in pixels.iter().filter(|p| p.iter().all(|v| v.is_finite())) {
                        (0..3).for_each(|k| block.0[k] += pixel[k]);
                        block.1 += 1.0;
                    }
                }
            }
            for (pixel, (sum, count)) in drawn.iter_mut().zip(&blocks) {
                // 0 / 0: nothing of the block was measured.
                *pixel = sum.map(|sum| (sum / count) as f32);
            }
            progress.step();
        }
    }

    /// The three sums of every pixel of a row of the image.
    fn sum(&self, y: usize, sums: &mut [[f64; 3]], row: &mut [f64]) {
        sums.fill([0.0; 3]);
        for (band, weight) in &self.bands {
            self.cube.row(y, *band, 0, row);
            for (sum, value) in sums.iter_mut().zip(&*row) {
                for k in 0..3 {
                    // A channel that does not use the band must not catch its NaN.
                    if weight[k] != 0.0 {
                        sum[k] += weight[k] * value;
                    }
                }
            }
        }
        let Source::TrueColour(weights) = &self.ask.source else {
            return;
        };
        for (x, sum) in sums.iter_mut().enumerate() {
            if !sum.iter().all(|v| v.is_finite()) {
                // A pixel without some of its bands: straight lines over the gaps.
                let seen = weights.pixel(&self.ask.image.0, x, y);
                *sum = seen.map_or([f64::NAN; 3], |xyz| xyz.to_array());
            }
        }
    }
}

/// What 99 % of the drawn pixels do not exceed; 0 where nothing is above it.
fn percentile(values: &[[f32; 3]], of: impl Fn([f32; 3]) -> f32) -> f64 {
    let every = values.len().div_ceil(LOOKED_AT).max(1);
    let looked_at = values.iter().step_by(every).map(|value| of(*value));
    let mut sample: Vec<f32> = looked_at.filter(|v| v.is_finite()).collect();
    let found = quantile(&mut sample, FULL).unwrap_or(0.0);
    if found > 0.0 {
        return found;
    }
    // A few bright pixels on a dark ground: the brightest.
    f64::from(sample.into_iter().fold(0.0, f32::max))
}
