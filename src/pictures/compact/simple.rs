//! Coder 0: the predictor MED of JPEG-LS and zlib, which any library reads.

use super::super::PictureError;
use super::coder::{Plane, checked, folded, unfolded};
use super::zlib;

/// Coder 0.
pub(super) fn encode_simple(plane: &Plane) -> Vec<u8> {
    let mut codes = Vec::with_capacity(plane.values.len());
    for at in 0..plane.values.len() {
        let predicted = med(&plane.values, plane.width, at);
        codes.push(folded(i64::from(plane.values[at]) - predicted));
    }
    let most = codes.iter().copied().max().unwrap_or(0);
    let bytes = (64 - most.leading_zeros()).div_ceil(8).max(1);
    let mut raw = vec![bytes as u8];
    for byte in 0..bytes {
        raw.extend(codes.iter().map(|code| (code >> (8 * byte)) as u8));
    }
    zlib::packed(&raw)
}

pub(super) fn decode_simple(
    bytes: &[u8],
    width: usize,
    height: usize,
) -> Result<Plane, PictureError> {
    let count = width * height;
    let raw = zlib::unpacked(bytes, 1 + 5 * count)?;
    let planes = raw.first().map_or(0, |n| usize::from(*n));
    if !(1..=5).contains(&planes) || raw.len() != 1 + planes * count {
        return Err(PictureError::broken(
            tr!("a plane of {found} bytes", found = raw.len()),
            tr!("{count} numbers of 1 to 5 bytes", count),
        ));
    }
    let mut values: Vec<i32> = Vec::with_capacity(count);
    for at in 0..count {
        let code = (0..planes).fold(0, |code, byte| {
            code | (u64::from(raw[1 + byte * count + at]) << (8 * byte))
        });
        let value = med(&values, width, at) + unfolded(code);
        values.push(checked(value)?);
    }
    Ok(Plane {
        width,
        height,
        values,
    })
}

/// The median of left, upper, and left + upper - upper left.
fn med(values: &[i32], width: usize, at: usize) -> i64 {
    let (x, y) = (at % width, at / width);
    let value = |i: usize| i64::from(values[i]);
    match (x, y) {
        (0, 0) => 0,
        (_, 0) => value(at - 1),
        (0, _) => value(at - width),
        _ => {
            let (w, n, nw) = (value(at - 1), value(at - width), value(at - width - 1));
            if nw >= w.max(n) {
                w.min(n)
            } else if nw <= w.min(n) {
                w.max(n)
            } else {
                w + n - nw
            }
        }
    }
}
