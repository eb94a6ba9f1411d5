//! One tile: its planes one after the other.

use super::super::PictureError;
use super::coder::{Plane, decode_fitted, encode_fitted};
use super::quantiser::Quantiser;
use super::simple::{decode_simple, encode_simple};
use super::zlib;

/// Coder that turns planes into bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Coder {
    /// MED and zlib: any library reads it.
    Simple,
    /// Fitted predictor and adaptive chances: a quarter smaller.
    #[default]
    Fitted,
}

/// The coder of masks in files.
const MASK: u8 = 2;

/// A tile's numbers `[number * pixels + i]` as bytes, without its place.
pub(super) fn encode(
    numbers: &[f32],
    (width, height): (usize, usize),
    quantiser: &Quantiser,
    has_mask: bool,
    coder: Coder,
) -> Vec<u8> {
    let pixels = width * height;
    let count = numbers.len() / pixels;
    let mut planes = vec![vec![0_i32; pixels]; count];
    let mut mask = vec![0_u8; pixels.div_ceil(8)];
    let mut pixel = vec![0.0; count];
    let mut last = vec![0_i32; count];
    for i in 0..pixels {
        pixel
            .iter_mut()
            .enumerate()
            .for_each(|(n, z)| *z = f64::from(numbers[n * pixels + i]));
        if let Some(steps) = quantiser.steps(&pixel) {
            mask[i / 8] |= 0x80 >> (i % 8);
            last = steps;
        }
        // What was not measured goes on as its neighbour: cheap, and never shown.
        planes
            .iter_mut()
            .zip(&last)
            .for_each(|(plane, step)| plane[i] = *step);
    }
    let mut out = Vec::new();
    let mut put = |kind: u8, bytes: Vec<u8>| {
        out.push(kind);
        out.extend((bytes.len() as u32).to_be_bytes());
        out.extend(bytes);
    };
    if has_mask {
        put(MASK, zlib::packed(&mask));
    }
    let mut before = Vec::new();
    for values in planes {
        let plane = Plane {
            width,
            height,
            values,
        };
        match coder {
            Coder::Simple => put(0, encode_simple(&plane)),
            Coder::Fitted => put(1, encode_fitted(&plane, &mut before)),
        }
    }
    out
}

/// The numbers of a tile's bytes.
pub(super) fn decode(
    bytes: &[u8],
    (width, height): (usize, usize),
    quantiser: &Quantiser,
    count: usize,
    has_mask: bool,
) -> Result<Vec<f32>, PictureError> {
    let pixels = width * height;
    let mut rest = bytes;
    let mut next = || -> Result<(u8, &[u8]), PictureError> {
        let short = || {
            PictureError::broken(
                said!("a plane longer than its chunk"),
                said!("one that ends in it"),
            )
        };
        let (head, tail) = rest.split_at_checked(5).ok_or_else(short)?;
        let length = u32::from_be_bytes([head[1], head[2], head[3], head[4]]) as usize;
        let (plane, tail) = tail.split_at_checked(length).ok_or_else(short)?;
        rest = tail;
        Ok((head[0], plane))
    };
    let mut mask = None;
    if has_mask {
        let (kind, bytes) = next()?;
        let bits = zlib::unpacked(bytes, pixels.div_ceil(8))?;
        if kind != MASK || bits.len() != pixels.div_ceil(8) {
            return Err(PictureError::broken(
                said!("a mask that does not fit its tile"),
                said!("a bit a pixel"),
            ));
        }
        mask = Some(bits);
    }
    let mut planes = Vec::with_capacity(count);
    let mut before = Vec::new();
    for _ in 0..count {
        let (kind, bytes) = next()?;
        planes.push(match kind {
            0 => decode_simple(bytes, width, height)?,
            1 => decode_fitted(bytes, width, height, &mut before)?,
            other => {
                let found = tr!("the coder {number}", number = other);
                return Err(PictureError::broken(found, said!("coder 0 or 1")));
            }
        });
    }
    let mut numbers = vec![0.0; count * pixels];
    let (mut steps, mut back) = (vec![0; count], vec![0.0; count]);
    for i in 0..pixels {
        let is_measured = mask
            .as_ref()
            .is_none_or(|bits| bits[i / 8] & (0x80 >> (i % 8)) != 0);
        steps
            .iter_mut()
            .zip(&planes)
            .for_each(|(step, plane)| *step = plane.values[i]);
        if is_measured {
            quantiser.numbers(&steps, &mut back);
        } else {
            back.fill(f32::NAN);
        }
        back.iter()
            .enumerate()
            .for_each(|(n, z)| numbers[n * pixels + i] = *z);
    }
    Ok(numbers)
}
