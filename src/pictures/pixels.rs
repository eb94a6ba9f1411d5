//! Sources of a picture's pixels: memory, a cube as the file has it, a file on disk.

use crate::spectrum::SpectralImage;

use super::{Bands, KeptBands, PictureError};

/// Rows of a strip: what is worked on at a time.
pub const STRIP_ROWS: usize = 64;

/// Pixels that are asked for some rows at a time.
pub trait Pixels: Sync {
    /// Columns and rows.
    fn size(&self) -> (usize, usize);

    /// The bands of every pixel.
    fn bands(&self) -> &Bands;

    /// Some rows, band after band: `into[band * (count * width) + pixel]`, in the picture's unit;
    /// NaN where a number is missing.
    ///
    /// # Errors
    /// [`PictureError::Trouble`] when they cannot be read.
    fn rows(&self, first: usize, count: usize, into: &mut [f32]) -> Result<(), PictureError>;
}

/// Pixels in memory, band after band.
#[derive(Clone, Debug, PartialEq)]
pub struct InMemory {
    width: usize,
    height: usize,
    bands: Bands,
    values: Vec<f32>,
}

impl InMemory {
    /// Pixels from values `[band * (width * height) + pixel]`.
    ///
    /// # Errors
    /// [`PictureError::Broken`] when there are not as many values as pixels and bands.
    pub fn new(
        width: usize,
        height: usize,
        bands: Bands,
        values: Vec<f32>,
    ) -> Result<Self, PictureError> {
        let expected = width
            .checked_mul(height)
            .and_then(|n| n.checked_mul(bands.len()));
        if expected != Some(values.len()) || values.is_empty() {
            let found = tr!("{found} values", found = values.len());
            let expected = tr!(
                "one a pixel and band of {width} x {height} x {bands}",
                width,
                height,
                bands = bands.len()
            );
            return Err(PictureError::broken(found, expected));
        }
        Ok(Self {
            width,
            height,
            bands,
            values,
        })
    }

    /// All pixels of a source, kept.
    ///
    /// # Errors
    /// Those of the source.
    pub fn of(source: &dyn Pixels) -> Result<Self, PictureError> {
        let (width, height) = source.size();
        let bands = source.bands().clone();
        let mut values = vec![0.0; width * height * bands.len()];
        source.rows(0, height, &mut values)?;
        Self::new(width, height, bands, values)
    }

    /// The values, band after band.
    pub fn values(&self) -> &[f32] {
        &self.values
    }

    /// One pixel.
    pub fn pixel(&self, x: usize, y: usize) -> Vec<f64> {
        let pixels = self.width * self.height;
        let at = y * self.width + x;
        (0..self.bands.len())
            .map(|j| f64::from(self.values[j * pixels + at]))
            .collect()
    }
}

impl Pixels for InMemory {
    fn size(&self) -> (usize, usize) {
        (self.width, self.height)
    }

    fn bands(&self) -> &Bands {
        &self.bands
    }

    fn rows(&self, first: usize, count: usize, into: &mut [f32]) -> Result<(), PictureError> {
        let (from, pixels) = (first * self.width, count * self.width);
        let all = self.width * self.height;
        for (j, band) in into.chunks_mut(pixels).enumerate().take(self.bands.len()) {
            band.copy_from_slice(&self.values[j * all + from..][..pixels]);
        }
        Ok(())
    }
}

/// A spectral image as the program holds it, its kept bands in the image's unit.
#[derive(Clone, Debug)]
pub(crate) struct OfImage<'a> {
    image: &'a SpectralImage,
    kept: KeptBands,
    bands: Bands,
}

/// Pixels that decide which bands are missing.
const LOOKED_AT: usize = 4096;

impl<'a> OfImage<'a> {
    /// The pixels of an image; `all` keeps bands that nobody sees.
    ///
    /// # Errors
    /// [`PictureError::TooFewBands`] when fewer than three bands are left.
    pub(crate) fn new(image: &'a SpectralImage, all: bool) -> Result<Self, PictureError> {
        let cube = &image.cube;
        let pixels = cube.width() * cube.height();
        let step = pixels.div_ceil(LOOKED_AT).max(1);
        let looked_at = pixels.div_ceil(step);
        let is_gone = |i: usize, band| {
            let value = cube.value(i % cube.width(), i / cube.width(), band);
            value.is_nan()
        };
        let missing = |band: usize| {
            let places = (0..pixels).step_by(step);
            places.filter(|i| is_gone(*i, band)).count() as f64 / looked_at as f64
        };
        let missing: Vec<f64> = (0..cube.nm().len()).map(missing).collect();
        let kept = KeptBands::of_file(cube.nm(), &missing, all);
        let bands = kept.bands(image.kind)?;
        let bands = bands.with_bandwidth(image.bandwidth_nm);
        Ok(Self { image, kept, bands })
    }

    /// Notes on merging and omissions, one sentence each.
    pub(crate) fn notes(&self) -> &[String] {
        &self.kept.notes
    }
}

impl Pixels for OfImage<'_> {
    fn size(&self) -> (usize, usize) {
        (self.image.cube.width(), self.image.cube.height())
    }

    fn bands(&self) -> &Bands {
        &self.bands
    }

    fn rows(&self, first: usize, count: usize, into: &mut [f32]) -> Result<(), PictureError> {
        let cube = &self.image.cube;
        let width = cube.width();
        let (mut row, mut sum) = (vec![0.0; width], vec![0.0; width]);
        for (j, group) in self.kept.of.iter().enumerate() {
            let factor = self.image.scale / group.len() as f64;
            for y in 0..count {
                sum.fill(0.0);
                for band in group {
                    cube.row(first + y, *band, 0, &mut row);
                    sum.iter_mut().zip(&row).for_each(|(s, v)| *s += v);
                }
                let out = &mut into[(j * count + y) * width..][..width];
                for (value, sum) in out.iter_mut().zip(&sum) {
                    *value = (sum * factor) as f32;
                }
            }
        }
        Ok(())
    }
}
