//! A picture as its numbers, in memory.

use crate::study::{Progress, processors, side_by_side};

use super::header::{About, Header};
use super::measure::{Errors, Storage};
use super::strips::{joined, over_strips};
use super::{Operator, PictureError, Pixels, Relit};

/// Rows that one thread encodes at a time.
const ROWS: usize = 16;

/// The numbers of every pixel, and what they mean.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Header that gives the meaning of the numbers.
    pub header: Header,
    /// `[number * (width * height) + pixel]`; NaN where a pixel was not measured.
    pub planes: Vec<f32>,
}

impl Picture {
    /// A picture from its planes.
    ///
    /// # Errors
    /// [`PictureError::Broken`] when they are not as many as the header says.
    pub fn new(header: Header, planes: Vec<f32>) -> Result<Self, PictureError> {
        let expected = header
            .width
            .checked_mul(header.height)
            .and_then(|n| n.checked_mul(header.numbers));
        if expected != Some(planes.len()) {
            let found = tr!("{found} numbers", found = planes.len());
            let expected = format!("{} x {} x {}", header.width, header.height, header.numbers);
            return Err(PictureError::broken(found, expected));
        }
        Ok(Self { header, planes })
    }

    /// Encodes a picture into memory, its numbers as `storage` keeps them.
    ///
    /// # Errors
    /// Those of the source, and [`PictureError::Cancelled`].
    pub fn encode(
        pixels: &dyn Pixels,
        operator: &Operator,
        storage: &dyn Storage,
        (about, error): (&About, Errors),
        progress: &Progress,
    ) -> Result<Self, PictureError> {
        let (width, height) = pixels.size();
        let kernel = operator.encoder();
        progress.expect(height.div_ceil(ROWS));
        let parts = over_strips(pixels, ROWS, progress, |strip| {
            let mut numbers = vec![0.0; operator.numbers() * strip.pixels];
            kernel.apply(strip.values, strip.pixels, &mut numbers);
            storage.kept(&mut numbers, strip.pixels);
            Ok(numbers)
        })?;
        let planes = joined(parts.iter(), operator.numbers());
        let header = Header::of(operator, (width, height), about, error);
        Self::new(header, planes)
    }

    /// Pixels.
    pub fn pixels(&self) -> usize {
        self.header.width * self.header.height
    }
}

/// Planes of numbers to XYZ under a light, on as many threads as there are: `[k * pixels + i]`.
///
/// # Panics
/// When a slice is too short for the pixels.
pub fn relit_into(planes: &[f32], pixels: usize, relit: &Relit, out: &mut [f32]) {
    let rows: [Vec<f32>; 3] = relit
        .rows
        .each_ref()
        .map(|row| row.iter().map(|w| *w as f32).collect());
    let threads = processors().min(8);
    let share = pixels.div_ceil(threads).next_multiple_of(1024).max(1);
    let (x, rest) = out.split_at_mut(pixels);
    let (y, z) = rest.split_at_mut(pixels);
    let parts = x
        .chunks_mut(share)
        .zip(y.chunks_mut(share))
        .zip(z.chunks_mut(share));
    let work = |first: usize, out: [&mut [f32]; 3]| {
        let [x, y, z] = out;
        const BLOCK: usize = 1024;
        let blocks = x
            .chunks_mut(BLOCK)
            .zip(y.chunks_mut(BLOCK))
            .zip(z.chunks_mut(BLOCK));
        for (at, ((x, y), z)) in blocks.enumerate() {
            x.fill(0.0);
            y.fill(0.0);
            z.fill(0.0);
            let start = first + at * BLOCK;
            let mut n = 0;
            // Four planes at a time: the sums are loaded and stored a quarter as often.
            while n + 4 <= rows[0].len() {
                let p: [&[f32]; 4] =
                    std::array::from_fn(|k| &planes[(n + k) * pixels + start..][..x.len()]);
                let weights: [[f32; 4]; 3] =
                    std::array::from_fn(|c| std::array::from_fn(|k| rows[c][n + k]));
                for (row, out) in weights.iter().zip([&mut *x, &mut *y, &mut *z]) {
                    let values = p[0].iter().zip(p[1]).zip(p[2].iter().zip(p[3]));
                    for (sum, ((a, b), (c, d))) in out.iter_mut().zip(values) {
                        *sum += row[0] * a + row[1] * b + row[2] * c + row[3] * d;
                    }
                }
                n += 4;
            }
            for n in n..rows[0].len() {
                let plane = &planes[n * pixels + start..][..x.len()];
                for (row, out) in rows.iter().zip([&mut *x, &mut *y, &mut *z]) {
                    out.iter_mut()
                        .zip(plane)
                        .for_each(|(sum, v)| *sum += row[n] * v);
                }
            }
        }
    };
    side_by_side(parts.enumerate(), |(part, ((x, y), z))| {
        work(part * share, [x, y, z]);
    });
}
