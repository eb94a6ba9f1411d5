//! A picture of colours as a spectral picture: the smoothest reflectance in every pixel.
//!
//! Colours are solved once for each piece of the picture in which they occur, from the solution
//! of the nearest of 9 x 9 x 9 colours spread over the screen's cube: a few steps of Newton's
//! method instead of ten. A colour that no surface has under the light is brought in towards the
//! grey of its luminance. Every colour is solved for itself, so that the result is the same bits
//! whatever the number of threads.

#[cfg(test)]
use std::sync::Arc;

use super::{
    colour::Colour,
    edge::towards_grey,
    error::RecoverError,
    smoothest::{State, smoothest},
    viewing::{BAND, NODES, Nodes, STEP_NM, Viewing},
};
#[cfg(test)]
use crate::spectrum::{Cube, cube::Interleave, cube::Layout, cube::Number};
use crate::{
    color::srgb::linear_from_encoded, study::Progress, study::in_parallel, study::processors,
};

/// Colours along each edge of the cube that starts are taken from.
const STARTS: usize = 9;

/// Pixels of one piece: its distinct colours are solved once.
const PIECE: usize = 1 << 14;

/// The pixels of a picture, red, green and blue one behind the other, row after row, encoded as
/// sRGB (IEC 61966-2-1).
#[derive(Clone, Copy, Debug)]
pub enum Encoded<'a> {
    /// 8 bits a channel.
    U8(&'a [u8]),
    /// 16 bits a channel.
    U16(&'a [u16]),
}

impl Encoded<'_> {
    fn len(self) -> usize {
        match self {
            Self::U8(values) => values.len(),
            Self::U16(values) => values.len(),
        }
    }

    /// A pixel in 16 bits; 255 becomes 65535.
    fn pixel(self, index: usize) -> [u16; 3] {
        match self {
            Self::U8(values) => std::array::from_fn(|k| u16::from(values[3 * index + k]) * 257),
            Self::U16(values) => std::array::from_fn(|k| values[3 * index + k]),
        }
    }
}

/// A picture of colours.
#[derive(Clone, Copy, Debug)]
pub struct ColourPicture<'a> {
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Its pixels, `width x height` of them.
    pub pixels: Encoded<'a>,
}

/// Pixel counts of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PictureCount {
    /// Pixels.
    pub pixels: usize,
    /// Pixels whose colour no surface has under the light, so that a nearby one was taken.
    pub impossible: usize,
}

/// Every 10 nm of 380-780: bands that keep a smooth reflectance well below what an eye sees.
pub fn usual_bands() -> Vec<f64> {
    (0..NODES).step_by(2).map(super::viewing::node_nm).collect()
}

/// The rows of the spectral picture, in order, to `each(y, values)`: one value a band, pixel after
/// pixel. `None` when cancelled.
///
/// # Errors
/// [`RecoverError::Picture`] where size and pixels do not agree, [`RecoverError::Bands`] for
/// places that do not rise in 380-780 nm, [`RecoverError::TooNarrowToAdapt`] for a light under
/// which a screen's colours mean nothing.
pub fn spectral_rows(
    picture: ColourPicture<'_>,
    viewing: &Viewing,
    bands_nm: &[f64],
    progress: &Progress,
    mut each: impl FnMut(usize, &[f32]),
) -> Result<Option<PictureCount>, RecoverError> {
    let ColourPicture {
        width,
        height,
        pixels,
    } = picture;
    let expected = width.saturating_mul(height).saturating_mul(3);
    let found = pixels.len();
    if expected != found || found == 0 {
        return Err(RecoverError::Picture { expected, found });
    }
    let rising = bands_nm.windows(2).all(|pair| pair[0] < pair[1]);
    if bands_nm.len() < 2 || !rising || !bands_nm.iter().all(|nm| BAND.contains(*nm)) {
        return Err(RecoverError::Bands);
    }
    let solver = Solver::new(viewing, bands_nm)?;
    progress.expect(height);
    let rows_a_piece = (PIECE / width).max(1);
    let mut count = PictureCount::default();
    for first in (0..height).step_by(rows_a_piece) {
        let rows = rows_a_piece.min(height - first);
        let colours: Vec<[u16; 3]> = (first * width..(first + rows) * width)
            .map(|index| pixels.pixel(index))
            .collect();
        let mut distinct = colours.clone();
        distinct.sort_unstable();
        distinct.dedup();
        let Some(solved) = solver.solved(&distinct, progress) else {
            return Ok(None);
        };
        for row in 0..rows {
            let mut values = Vec::with_capacity(width * bands_nm.len());
            for colour in &colours[row * width..(row + 1) * width] {
                // Every colour of the piece is in the list.
                let at = distinct.binary_search(colour).unwrap_or(0);
                values.extend_from_slice(&solved[at].bands);
                count.impossible += usize::from(!solved[at].possible);
            }
            count.pixels += width;
            each(first + row, &values);
            progress.step();
        }
    }
    Ok(Some(count))
}

/// The spectral picture as a cube of single precision, pixel after pixel. `None` when cancelled.
///
/// # Errors
/// As [`spectral_rows`].
#[cfg(test)]
pub(crate) fn spectral_cube(
    picture: ColourPicture<'_>,
    viewing: &Viewing,
    bands_nm: &[f64],
    progress: &Progress,
) -> Result<Option<(Cube, PictureCount)>, RecoverError> {
    let mut bytes = Vec::new();
    let row = |_, values: &[f32]| values.iter().for_each(|v| bytes.extend(v.to_le_bytes()));
    let Some(count) = spectral_rows(picture, viewing, bands_nm, progress, row)? else {
        return Ok(None);
    };
    let places: Vec<(f64, usize)> = bands_nm.iter().copied().zip(0..).collect();
    let layout = Layout {
        first_byte: 0,
        number: Number::F32,
        big_endian: false,
        interleave: Interleave::Pixels,
        stored_bands: bands_nm.len(),
        missing: None,
    };
    let cube = Cube::new(
        picture.width,
        picture.height,
        &places,
        layout,
        Arc::new(bytes),
    );
    cube.map(|cube| Some((cube, count)))
        .map_err(|_| RecoverError::Bands)
}

/// One colour's reflectance at the bands.
#[derive(Clone, Debug, Default)]
struct Solved {
    bands: Vec<f32>,
    possible: bool,
}

/// Data shared by all pixels.
struct Solver<'a> {
    viewing: &'a Viewing,
    /// Per band the node on its left and the share of the next one.
    bands: Vec<(usize, f64)>,
    starts: Vec<Option<State<3>>>,
}

impl<'a> Solver<'a> {
    fn new(viewing: &'a Viewing, bands_nm: &[f64]) -> Result<Self, RecoverError> {
        let place = |nm: &f64| {
            let x = (nm - BAND.min_nm()) / STEP_NM as f64;
            let left = (x as usize).min(NODES - 2);
            (left, x - left as f64)
        };
        let mut solver = Self {
            viewing,
            bands: bands_nm.iter().map(place).collect(),
            starts: Vec::new(),
        };
        let mut starts = Vec::with_capacity(STARTS * STARTS * STARTS);
        for index in 0..STARTS * STARTS * STARTS {
            let along = [
                index / STARTS / STARTS,
                index / STARTS % STARTS,
                index % STARTS,
            ];
            let channel = |k: usize| (along[k] * 0xffff / (STARTS - 1)) as u16;
            let target = solver.target([channel(0), channel(1), channel(2)])?;
            let found = smoothest(&viewing.columns, target, None);
            starts.push(found.and_then(|(_, state)| state));
        }
        solver.starts = starts;
        Ok(solver)
    }

    fn target(&self, pixel: [u16; 3]) -> Result<[f64; 3], RecoverError> {
        let linear = pixel.map(|v| linear_from_encoded(f64::from(v) / 65535.0));
        let xyz = Colour::Linear(linear).under(self.viewing)?;
        Ok((xyz * 0.01).to_array())
    }

    fn one(&self, pixel: [u16; 3]) -> Solved {
        let nearest = |v: u16| (usize::from(v) * (STARTS - 1) + 0x7fff) / 0xffff;
        let [r, g, b] = pixel.map(nearest);
        let start = self.starts[(r * STARTS + g) * STARTS + b].as_ref();
        // That the light can be adapted to was seen when the starts were made.
        let target = self.target(pixel).unwrap_or_default();
        let (nodes, possible) = match smoothest(&self.viewing.columns, target, start) {
            Some((nodes, _)) => (nodes, true),
            None => (towards_grey(&self.viewing.columns, target), false),
        };
        let bands = self
            .bands
            .iter()
            .map(|band| at(&nodes, *band) as f32)
            .collect();
        Solved { bands, possible }
    }

    /// Every colour, on as many threads as there are; `None` when cancelled.
    fn solved(&self, colours: &[[u16; 3]], progress: &Progress) -> Option<Vec<Solved>> {
        const BLOCK: usize = 64;
        let blocks: Vec<&[[u16; 3]]> = colours.chunks(BLOCK).collect();
        // The steps that are counted are rows.
        let solved = in_parallel(&blocks, processors(), &Progress::default(), |block| {
            if progress.is_cancelled() {
                return Vec::new();
            }
            block.iter().map(|colour| self.one(*colour)).collect()
        });
        (!progress.is_cancelled()).then_some(solved?.concat())
    }
}

fn at(nodes: &Nodes, (left, share): (usize, f64)) -> f64 {
    nodes[left] * (1.0 - share) + nodes[left + 1] * share
}
