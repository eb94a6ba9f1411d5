//! An image with a spectrum in every pixel: numbers only, kept as the bytes of its file.
//!
//! A cube of 512 x 512 pixels and 31 bands is 8 million numbers. They stay in the form in which
//! the file holds them and are turned into `f64` when they are asked for, so that opening one
//! costs no more than reading it. Clones share the bytes.

use std::fmt;
use std::sync::Arc;

use super::{rect::Rect, sampled::Sampled};

/// Numbers of this size and beyond stand for "not measured" (-1.23e34 in many libraries).
const ABSURD: f64 = 1e30;

/// Number format of a cube's file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Number {
    /// Unsigned, 1 byte.
    U8,
    /// Signed, 2 bytes.
    I16,
    /// Signed, 4 bytes.
    I32,
    /// Floating point, 4 bytes.
    F32,
    /// Floating point, 8 bytes.
    F64,
    /// Unsigned, 2 bytes.
    U16,
    /// Unsigned, 4 bytes.
    U32,
    /// Signed, 8 bytes.
    I64,
    /// Unsigned, 8 bytes.
    U64,
}

impl Number {
    /// Bytes of one number.
    pub fn bytes(self) -> usize {
        match self {
            Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::I64 | Self::U64 | Self::F64 => 8,
        }
    }

    /// The number that starts at a place; NaN beyond the end.
    pub fn read(self, bytes: &[u8], at: usize, big_endian: bool) -> f64 {
        let mut value = [f64::NAN];
        let bytes = bytes.get(at..).unwrap_or_default();
        self.read_many(bytes, self.bytes(), big_endian, &mut value);
        value[0]
    }

    /// Numbers that start every `step` bytes; places that the bytes do not reach keep what they
    /// had.
    fn read_many(self, bytes: &[u8], step: usize, big_endian: bool, into: &mut [f64]) {
        macro_rules! numbers {
            ($kind:ty) => {{
                const SIZE: usize = size_of::<$kind>();
                for (value, piece) in into.iter_mut().zip(bytes.chunks(step)) {
                    if let Some(b) = piece.first_chunk::<SIZE>() {
                        *value = if big_endian {
                            <$kind>::from_be_bytes(*b) as f64
                        } else {
                            <$kind>::from_le_bytes(*b) as f64
                        };
                    }
                }
            }};
        }
        match self {
            Self::U8 => numbers!(u8),
            Self::I16 => numbers!(i16),
            Self::I32 => numbers!(i32),
            Self::F32 => numbers!(f32),
            Self::F64 => numbers!(f64),
            Self::U16 => numbers!(u16),
            Self::U32 => numbers!(u32),
            Self::I64 => numbers!(i64),
            Self::U64 => numbers!(u64),
        }
    }
}

/// Storage order of row, column and band in the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interleave {
    /// One whole plane after the other (BSQ).
    Bands,
    /// One row of every band after the other (BIL).
    Lines,
    /// One whole pixel after the other (BIP).
    Pixels,
}

/// Layout of a cube's numbers in its bytes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layout {
    /// Byte offset of the first number.
    pub first_byte: usize,
    /// Format of a number.
    pub number: Number,
    /// Most significant byte first.
    pub big_endian: bool,
    /// Storage order of row, column and band.
    pub interleave: Interleave,
    /// Bands in the bytes, also those that the cube passes over.
    pub stored_bands: usize,
    /// The number that stands for "not measured".
    pub missing: Option<f64>,
}

impl Layout {
    /// Byte offset of a number in an image of `size` columns and rows.
    pub(crate) fn place(&self, size: (usize, usize), (x, y): (usize, usize), band: usize) -> usize {
        let (width, height) = size;
        let index = match self.interleave {
            Interleave::Bands => (band * height + y) * width + x,
            Interleave::Lines => (y * self.stored_bands + band) * width + x,
            Interleave::Pixels => (y * width + x) * self.stored_bands + band,
        };
        self.first_byte + index * self.number.bytes()
    }

    /// Numbers of one band in neighbouring pixels of a row, from where the first starts; NaN where
    /// one is missing or of a size that nothing has. Many at once are read far faster than one by
    /// one.
    pub(crate) fn read_row(&self, bytes: &[u8], into: &mut [f64]) {
        let size = self.number.bytes();
        let step = match self.interleave {
            Interleave::Bands | Interleave::Lines => size,
            Interleave::Pixels => self.stored_bands * size,
        };
        self.number.read_many(bytes, step, self.big_endian, into);
        for value in into {
            if self.is_missing(*value) || value.abs() >= ABSURD {
                *value = f64::NAN;
            }
        }
    }

    /// True if a number means "not measured": a header writes that in decimals, single precision
    /// rounds it.
    pub(crate) fn is_missing(&self, value: f64) -> bool {
        let is_single = self.number == Number::F32;
        self.missing
            .is_some_and(|missing| value == missing || is_single && value as f32 == missing as f32)
    }
}

/// An image whose every pixel is a spectrum on the same wavelengths.
#[derive(Clone, PartialEq)]
pub struct Cube {
    width: usize,
    height: usize,
    nm: Vec<f64>,
    /// Index of the stored band of each wavelength.
    bands: Vec<usize>,
    bytes: Arc<Vec<u8>>,
    layout: Layout,
}

/// Why bytes are no cube.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CubeError {
    /// No pixel.
    #[error("{}", said!("expected at least one pixel, found none"))]
    Empty,
    /// Fewer than two bands, wavelengths that do not rise strictly, or a band that is not stored.
    #[error("{}", said!("expected two or more bands at rising wavelengths above 0"))]
    Bands,
    /// Fewer bytes than its numbers take (`expected` is `None` beyond what can be counted).
    #[error("{}", short(*found, *expected))]
    Short {
        found: usize,
        expected: Option<usize>,
    },
}

fn short(found: usize, expected: Option<usize>) -> String {
    match expected {
        Some(expected) => tr!(
            "expected {expected} bytes, found {found} bytes",
            expected,
            found
        ),
        None => tr!(
            "expected a size that can be counted, found {found} bytes",
            found
        ),
    }
}

impl Cube {
    /// A cube of `width` x `height` pixels. `bands` pairs a wavelength (nm, strictly rising) with
    /// the stored band (from 0) that holds it.
    ///
    /// # Errors
    /// [`CubeError`] when the bytes are too few, or the bands are no axis of a spectrum.
    pub fn new(
        width: usize,
        height: usize,
        bands: &[(f64, usize)],
        layout: Layout,
        bytes: Arc<Vec<u8>>,
    ) -> Result<Self, CubeError> {
        if width == 0 || height == 0 {
            return Err(CubeError::Empty);
        }
        let rising = bands.windows(2).all(|pair| pair[0].0 < pair[1].0);
        let stored = bands.iter().all(|(_, band)| *band < layout.stored_bands);
        let finite = bands.iter().all(|(nm, _)| *nm > 0.0 && *nm < ABSURD);
        if bands.len() < 2 || !rising || !stored || !finite {
            return Err(CubeError::Bands);
        }
        let expected = bytes_of(width, height, layout.stored_bands, layout.number)
            .and_then(|size| size.checked_add(layout.first_byte));
        if expected.is_none_or(|expected| bytes.len() < expected) {
            return Err(CubeError::Short {
                found: bytes.len(),
                expected,
            });
        }
        Ok(Self {
            width,
            height,
            nm: bands.iter().map(|(nm, _)| *nm).collect(),
            bands: bands.iter().map(|(_, band)| *band).collect(),
            bytes,
            layout,
        })
    }

    /// Columns.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows.
    pub fn height(&self) -> usize {
        self.height
    }

    /// Wavelengths of the bands, nm, strictly rising.
    pub fn nm(&self) -> &[f64] {
        &self.nm
    }

    /// The whole image.
    pub fn all(&self) -> Rect {
        Rect {
            x: 0,
            y: 0,
            width: self.width,
            height: self.height,
        }
    }

    /// Bytes of memory that the cube takes.
    pub fn memory(&self) -> usize {
        self.bytes.len()
    }

    /// The band nearest to a wavelength.
    pub fn nearest_band(&self, nm: f64) -> usize {
        let distance = |band: &usize| (self.nm[*band] - nm).abs();
        (0..self.nm.len())
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
            .unwrap_or(0)
    }

    /// One number, as the file has it; NaN where it is missing, of a size that nothing has (1e30),
    /// or outside the image.
    pub fn value(&self, x: usize, y: usize, band: usize) -> f64 {
        let mut value = [f64::NAN];
        self.row(y, band, x, &mut value);
        value[0]
    }

    /// The numbers of one pixel, a band each, as the file has them; NaN where one is missing.
    pub fn values_at(&self, x: usize, y: usize) -> Vec<f64> {
        (0..self.nm.len())
            .map(|band| self.value(x, y, band))
            .collect()
    }

    /// The spectrum of one pixel; `None` where fewer than two of its bands were measured.
    pub(crate) fn spectrum_at(&self, x: usize, y: usize) -> Option<Sampled> {
        self.sampled(&self.values_at(x, y))
    }

    /// A piece of one row of one band, as the file has it, from column `x` on: as many numbers as
    /// `into` has places; NaN where one is missing or outside the image.
    pub fn row(&self, y: usize, band: usize, x: usize, into: &mut [f64]) {
        let inside = into.len().min(self.width.saturating_sub(x));
        let (inside, outside) = into.split_at_mut(inside);
        outside.fill(f64::NAN);
        if y >= self.height || band >= self.bands.len() || inside.is_empty() {
            return inside.fill(f64::NAN);
        }
        let size = (self.width, self.height);
        let start = self.layout.place(size, (x, y), self.bands[band]);
        self.layout.read_row(&self.bytes[start..], inside);
    }

    /// One band as a picture, row after row, in the file's own numbers; NaN where one is missing.
    pub fn plane(&self, band: usize) -> Vec<f32> {
        let mut plane = Vec::with_capacity(self.width * self.height);
        let mut row = vec![0.0; self.width];
        for y in 0..self.height {
            self.row(y, band, 0, &mut row);
            plane.extend(row.iter().map(|value| *value as f32));
        }
        plane
    }

    pub(super) fn sampled(&self, values: &[f64]) -> Option<Sampled> {
        let points = self.nm.iter().zip(values).filter(|(_, v)| v.is_finite());
        let (nm, values) = points.unzip();
        Sampled::new(nm, values).ok()
    }
}

impl fmt::Debug for Cube {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Cube")
            .field("width", &self.width)
            .field("height", &self.height)
            .field("bands", &self.nm.len())
            .field("layout", &self.layout)
            .finish_non_exhaustive()
    }
}

/// Bytes that the numbers of a cube take; `None` where they cannot be counted.
pub fn bytes_of(width: usize, height: usize, bands: usize, number: Number) -> Option<usize> {
    width
        .checked_mul(height)?
        .checked_mul(bands)?
        .checked_mul(number.bytes())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 3 x 2 pixels of 4 bands: value = 100 y + 10 x + band.
    fn cube(interleave: Interleave) -> Cube {
        let (width, height, bands) = (3, 2, 4);
        let mut bytes = vec![0xff; 6];
        let mut put = |x: usize, y: usize, band: usize| {
            let value = (100 * y + 10 * x + band) as i16;
            bytes.extend(value.to_be_bytes());
        };
        match interleave {
            Interleave::Bands => (0..bands).for_each(|b| {
                (0..height).for_each(|y| (0..width).for_each(|x| put(x, y, b)));
            }),
            Interleave::Lines => (0..height).for_each(|y| {
                (0..bands).for_each(|b| (0..width).for_each(|x| put(x, y, b)));
            }),
            Interleave::Pixels => (0..height).for_each(|y| {
                (0..width).for_each(|x| (0..bands).for_each(|b| put(x, y, b)));
            }),
        }
        let layout = Layout {
            first_byte: 6,
            number: Number::I16,
            big_endian: true,
            interleave,
            stored_bands: bands,
            missing: Some(111.0),
        };
        // The stored bands run from long to short wavelengths; the second is passed over.
        let bands = [(400.0, 3), (500.0, 1), (600.0, 0)];
        Cube::new(width, height, &bands, layout, Arc::new(bytes)).unwrap()
    }

    #[test]
    fn every_interleave_reads_to_the_same_image() {
        for interleave in [Interleave::Bands, Interleave::Lines, Interleave::Pixels] {
            let cube = cube(interleave);
            assert_eq!(cube.values_at(2, 1), [123.0, 121.0, 120.0]);
            assert_eq!(cube.plane(2), [0.0, 10.0, 20.0, 100.0, 110.0, 120.0]);
            let mut row = [0.0; 3];
            cube.row(1, 1, 1, &mut row);
            assert!(row[0].is_nan() && row[1] == 121.0 && row[2].is_nan());
            assert_eq!(cube.spectrum_at(0, 0).unwrap().values(), [3.0, 1.0, 0.0]);
        }
    }

    #[test]
    fn what_is_missing_is_left_out_of_spectra_and_means() {
        let cube = cube(Interleave::Pixels);
        assert_eq!(cube.spectrum_at(1, 1).unwrap().nm(), [400.0, 600.0]);
        let region = Rect {
            x: 1,
            y: 0,
            width: 1,
            height: 99,
        };
        // Rows 0 and 1 of column 1; 111 at 500 nm is missing.
        assert_eq!(cube.mean_of(region).unwrap().values(), [63.0, 11.0, 60.0]);
        assert!(cube.mean_of(Rect { x: 7, ..region }).is_none());
        assert!(cube.value(3, 0, 0).is_nan());
    }

    #[test]
    fn too_few_bytes_and_sizes_beyond_counting_are_no_cube() {
        let good = cube(Interleave::Bands);
        let make = |width, bytes: Vec<u8>| {
            Cube::new(
                width,
                2,
                &[(400.0, 0), (500.0, 1)],
                good.layout,
                Arc::new(bytes),
            )
        };
        assert_eq!(
            make(3, vec![0; 53]).unwrap_err(),
            CubeError::Short {
                found: 53,
                expected: Some(54)
            }
        );
        assert!(make(usize::MAX / 2, vec![0; 54]).is_err());
        assert_eq!(make(0, vec![]).unwrap_err(), CubeError::Empty);
    }

    #[test]
    fn the_nearest_band_is_found() {
        let cube = cube(Interleave::Bands);
        assert_eq!(
            [380.0, 520.0, 900.0].map(|nm| cube.nearest_band(nm)),
            [0, 1, 2]
        );
    }
}
