//! Statistics of the pixels in a rectangle: mean, spread and extremes of every band.

use super::{cube::Cube, rect::Rect, sampled::Sampled};

/// Every band of a region, in the file's own numbers; NaN where a band was measured nowhere in it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Region {
    /// The part of the rectangle that lies in the image.
    pub rect: Rect,
    /// Mean of each band over the pixels that were measured in it.
    pub mean: Vec<f64>,
    /// Standard deviation of each band (of these pixels, divided by their count).
    pub deviation: Vec<f64>,
    /// Smallest value of each band.
    pub least: Vec<f64>,
    /// Largest value of each band.
    pub most: Vec<f64>,
    /// Pixels measured in each band.
    pub measured: Vec<usize>,
}

/// Running figures of one band.
#[derive(Clone, Copy)]
struct Band {
    count: usize,
    sum: f64,
    /// Sum of squared distances from `pivot`, and of these distances.
    squares: f64,
    distances: f64,
    /// The first value: squares of large numbers that hardly differ would lose the difference.
    pivot: f64,
    least: f64,
    most: f64,
}

impl Region {
    /// The pixels of a rectangle, cut to the image; `None` when nothing is left of it, or when
    /// `goes_on`, which is asked once a row, said no.
    pub(crate) fn of(cube: &Cube, rect: Rect, goes_on: impl Fn() -> bool) -> Option<Self> {
        let rect = Rect {
            width: rect.width.min(cube.width().saturating_sub(rect.x)),
            height: rect.height.min(cube.height().saturating_sub(rect.y)),
            ..rect
        };
        if rect.pixels() == 0 {
            return None;
        }
        let mut bands = vec![Band::EMPTY; cube.nm().len()];
        let mut row = vec![0.0; rect.width];
        for y in rect.y..rect.y + rect.height {
            if !goes_on() {
                return None;
            }
            for (index, band) in bands.iter_mut().enumerate() {
                cube.row(y, index, rect.x, &mut row);
                band.take(&row);
            }
        }
        Some(Self {
            rect,
            mean: bands.iter().map(Band::mean).collect(),
            deviation: bands.iter().map(Band::deviation).collect(),
            least: bands.iter().map(|b| b.or_nan(b.least)).collect(),
            most: bands.iter().map(|b| b.or_nan(b.most)).collect(),
            measured: bands.iter().map(|b| b.count).collect(),
        })
    }
}

impl Cube {
    /// The mean spectrum of a region, cut to the image; each band over the pixels that were
    /// measured in it. `None` where that leaves fewer than two bands.
    pub fn mean_of(&self, region: Rect) -> Option<Sampled> {
        let about = Region::of(self, region, || true)?;
        self.sampled(&about.mean)
    }
}

impl Band {
    const EMPTY: Self = Self {
        count: 0,
        sum: 0.0,
        squares: 0.0,
        distances: 0.0,
        pivot: 0.0,
        least: f64::INFINITY,
        most: f64::NEG_INFINITY,
    };

    fn take(&mut self, row: &[f64]) {
        for value in row.iter().copied().filter(|value| value.is_finite()) {
            if self.count == 0 {
                self.pivot = value;
            }
            let distance = value - self.pivot;
            self.count += 1;
            self.sum += value;
            self.distances += distance;
            self.squares += distance * distance;
            self.least = self.least.min(value);
            self.most = self.most.max(value);
        }
    }

    fn or_nan(&self, value: f64) -> f64 {
        if self.count == 0 { f64::NAN } else { value }
    }

    fn mean(&self) -> f64 {
        self.sum / self.count as f64
    }

    fn deviation(&self) -> f64 {
        let count = self.count as f64;
        let shift = self.distances / count;
        (self.squares / count - shift * shift).max(0.0).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::spectrum::cube::{Interleave, Layout, Number};

    /// 4 x 2 pixels of 3 bands: 1000 + x + 10 y + 0.5 band, -1 is missing.
    fn cube() -> Cube {
        let mut bytes = Vec::new();
        for y in 0..2 {
            for x in 0..4 {
                for band in 0..3 {
                    let value = 1000.0 + x as f64 + 10.0 * y as f64 + 0.5 * band as f64;
                    let value = if (x, y, band) == (1, 0, 2) {
                        -1.0
                    } else {
                        value
                    };
                    bytes.extend(value.to_le_bytes());
                }
            }
        }
        let layout = Layout {
            first_byte: 0,
            number: Number::F64,
            big_endian: false,
            interleave: Interleave::Pixels,
            stored_bands: 3,
            missing: Some(-1.0),
        };
        let bands = [(400.0, 0), (500.0, 1), (600.0, 2)];
        Cube::new(4, 2, &bands, layout, Arc::new(bytes)).unwrap()
    }

    #[test]
    fn a_region_tells_mean_spread_and_extremes_of_what_was_measured() {
        let rect = Rect {
            x: 1,
            y: 0,
            width: 2,
            height: 9,
        };
        let region = Region::of(&cube(), rect, || true).unwrap();
        assert_eq!(region.rect.height, 2, "cut to the image");
        assert_eq!(region.measured, [4, 4, 3]);
        assert_eq!(region.mean[0], 1006.5);
        assert_eq!((region.least[0], region.most[0]), (1001.0, 1012.0));
        // 1001, 1002, 1011, 1012 about 1006.5.
        let expected = ((5.5_f64.powi(2) + 4.5_f64.powi(2)) / 2.0).sqrt();
        assert!((region.deviation[0] - expected).abs() < 1e-12);
        assert_eq!(region.mean[2], (1003.0 + 1012.0 + 1013.0) / 3.0);
    }

    #[test]
    fn nothing_inside_and_a_word_to_stop_are_no_region() {
        let cube = cube();
        let outside = Rect {
            x: 4,
            ..Rect::pixel(0, 0)
        };
        assert_eq!(Region::of(&cube, outside, || true), None);
        assert_eq!(Region::of(&cube, cube.all(), || false), None);
        let pixel = Region::of(&cube, Rect::pixel(1, 0), || true).unwrap();
        assert!(pixel.mean[2].is_nan() && pixel.least[2].is_nan());
        assert_eq!(pixel.deviation[0], 0.0);
    }
}
