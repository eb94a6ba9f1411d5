//! Planes of whole numbers to bytes and back, without loss.
//!
//! Coder 0: the predictor MED of JPEG-LS, what it misses folded to positive numbers, low bytes
//! then high bytes, zlib: any library reads it. Coder 1: a linear predictor of ten neighbours with
//! whole weights fitted to the plane ([`super::predictor`]), what it misses in unary and Exp-Golomb bits by adaptive
//! chances in twelve contexts.

use super::super::PictureError;
use super::predictor::{COUNT, Framed, Misses, Weights};
use super::range_coder::{Chance, Decoder, Encoder};

const CONTEXTS: usize = 12;
/// Largest number in unary.
const UNARY: u32 = 14;
/// Most bits behind it: 32-bit differences folded to 33 bits.
const LENGTHS: usize = 34;
/// No plane holds larger numbers.
pub(super) const MOST: i64 = 1 << 30;
/// Bytes of a plane's parameters: mean, weights, thresholds.
const HEAD: usize = 4 + 2 * COUNT + 4 * (CONTEXTS - 1);

/// A plane of a tile.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Plane {
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Row after row.
    pub values: Vec<i32>,
}

pub(super) fn folded(error: i64) -> u64 {
    ((error << 1) ^ (error >> 63)) as u64
}

pub(super) fn unfolded(folded: u64) -> i64 {
    (folded >> 1) as i64 ^ -((folded & 1) as i64)
}

pub(super) fn checked(value: i64) -> Result<i32, PictureError> {
    if value.abs() > MOST {
        return Err(PictureError::broken(
            tr!("the number {value} in a plane", value),
            said!("one below 2^30"),
        ));
    }
    Ok(value as i32)
}

/// Parameters of a plane's coder 1, besides the bits.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Parameters {
    mean: i64,
    weights: Weights,
    thresholds: [i64; CONTEXTS - 1],
}

impl Parameters {
    fn to_bytes(&self) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(HEAD);
        bytes.extend((self.mean as i32).to_be_bytes());
        self.weights
            .iter()
            .for_each(|w| bytes.extend((*w as i16).to_be_bytes()));
        self.thresholds
            .iter()
            .for_each(|t| bytes.extend((*t as u32).to_be_bytes()));
        bytes
    }

    fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let word = |at: usize| bytes.get(at..at + 4).and_then(|b| b.try_into().ok());
        let half = |at: usize| bytes.get(at..at + 2).and_then(|b| b.try_into().ok());
        let mut weights = [0; COUNT];
        for (k, weight) in weights.iter_mut().enumerate() {
            *weight = i64::from(i16::from_be_bytes(half(4 + 2 * k)?));
        }
        let mut thresholds = [0; CONTEXTS - 1];
        for (k, threshold) in thresholds.iter_mut().enumerate() {
            *threshold = i64::from(u32::from_be_bytes(word(4 + 2 * COUNT + 4 * k)?));
        }
        let mean = i64::from(i32::from_be_bytes(word(0)?));
        (mean.abs() <= MOST).then_some(Self {
            mean,
            weights,
            thresholds,
        })
    }

    fn context(&self, activity: i64) -> usize {
        self.thresholds.iter().filter(|t| activity > **t).count()
    }
}

/// Chances of one context.
#[derive(Clone)]
struct Chances {
    unary: [Chance; UNARY as usize],
    length: [Chance; LENGTHS],
    /// The first bits behind the leading one, by the length.
    high: [[Chance; 4]; LENGTHS],
}

impl Default for Chances {
    fn default() -> Self {
        Self {
            unary: [Chance::default(); UNARY as usize],
            length: [Chance::default(); LENGTHS],
            high: [[Chance::default(); 4]; LENGTHS],
        }
    }
}

/// A bit's chance within Exp-Golomb's tail: the two highest by what is above them, the others
/// nearly even.
fn tail_chance(chances: &mut Chances, length: usize, bit: usize, seen: u64) -> &mut Chance {
    let depth = length - 1 - bit;
    let index = match depth {
        0 => 0,
        1 => 1 + (seen & 1) as usize,
        _ => 3,
    };
    &mut chances.high[length.min(LENGTHS - 1)][index]
}

fn put(encoder: &mut Encoder, chances: &mut Chances, code: u64) {
    for k in 0..u64::from(UNARY) {
        let more = code > k;
        encoder.bit(&mut chances.unary[k as usize], more);
        if !more {
            return;
        }
    }
    let rest = code - u64::from(UNARY) + 1;
    let length = 63 - rest.leading_zeros() as usize;
    for k in 0..length {
        encoder.bit(&mut chances.length[k], true);
    }
    encoder.bit(&mut chances.length[length], false);
    for bit in (0..length).rev() {
        let seen = rest >> (bit + 1);
        encoder.bit(
            tail_chance(chances, length, bit, seen),
            (rest >> bit) & 1 == 1,
        );
    }
}

fn get(decoder: &mut Decoder, chances: &mut Chances) -> Option<u64> {
    for k in 0..UNARY {
        if !decoder.bit(&mut chances.unary[k as usize]) {
            return Some(u64::from(k));
        }
    }
    let mut length = 0;
    while decoder.bit(&mut chances.length[length]) {
        length += 1;
        if length >= LENGTHS {
            return None;
        }
    }
    let mut rest: u64 = 1;
    for bit in (0..length).rev() {
        let one = decoder.bit(tail_chance(chances, length, bit, rest));
        rest = (rest << 1) | u64::from(one);
    }
    Some(rest - 1 + u64::from(UNARY))
}

/// Coder 1. `before` are the misses of the plane before (empty for the first) and becomes this
/// one's.
pub(super) fn encode_fitted(plane: &Plane, before: &mut Vec<u32>) -> Vec<u8> {
    let (width, height) = (plane.width, plane.height);
    let count = plane.values.len().max(1) as i64;
    let sum: i64 = plane.values.iter().map(|v| i64::from(*v)).sum();
    let mean = (sum + count / 2).div_euclid(count);
    let mut framed = Framed::new(width, height);
    for y in 0..height {
        for x in 0..width {
            let at = framed.at(x, y);
            framed.values[at] = i64::from(plane.values[y * width + x]) - mean;
        }
    }
    let weights = framed.fitted(before);
    let missed = framed.missed(&weights);
    let mut misses = Misses::new(width, height);
    let sizes: Vec<u32> = missed
        .iter()
        .enumerate()
        .map(|(i, missed)| misses.put(i % width, i / width, *missed))
        .collect();
    let activity = |i: usize| misses.activity(i % width, i / width, before);
    let activities: Vec<i64> = (0..missed.len()).map(activity).collect();
    let parameters = Parameters {
        mean,
        weights,
        thresholds: thresholds(&activities),
    };
    let mut encoder = Encoder::default();
    let mut chances = vec![Chances::default(); CONTEXTS];
    for (missed, activity) in missed.iter().zip(&activities) {
        let chances = &mut chances[parameters.context(*activity)];
        put(&mut encoder, chances, folded(*missed));
    }
    *before = sizes;
    let mut bytes = parameters.to_bytes();
    bytes.extend(encoder.finish());
    bytes
}

/// Activity thresholds that divide the pixels into twelve groups: finer where activity is high,
/// since that is where the bits are.
fn thresholds(activities: &[i64]) -> [i64; CONTEXTS - 1] {
    let mut sorted = activities.to_vec();
    sorted.sort_unstable();
    let last = sorted.len().saturating_sub(1) as f64;
    std::array::from_fn(|k| {
        let share = (k + 1) as f64 / CONTEXTS as f64;
        sorted
            .get((last * share).round() as usize)
            .map_or(0, |t| (*t).min(i64::from(u32::MAX)))
    })
}

pub(super) fn decode_fitted(
    bytes: &[u8],
    width: usize,
    height: usize,
    before: &mut Vec<u32>,
) -> Result<Plane, PictureError> {
    let broken = || {
        PictureError::broken(
            said!("a plane whose bits end early or are no numbers"),
            said!("a whole one"),
        )
    };
    let parameters = Parameters::from_bytes(bytes).ok_or_else(broken)?;
    let mut decoder = Decoder::new(bytes.get(HEAD..).unwrap_or(&[]));
    let mut chances = vec![Chances::default(); CONTEXTS];
    let mut framed = Framed::new(width, height);
    let mut misses = Misses::new(width, height);
    let mut sizes = Vec::with_capacity(width * height);
    let mut values = Vec::with_capacity(width * height);
    for y in 0..height {
        if decoder.is_beyond_end() {
            return Err(broken());
        }
        for x in 0..width {
            let at = framed.at(x, y);
            let activity = misses.activity(x, y, before);
            let code =
                get(&mut decoder, &mut chances[parameters.context(activity)]).ok_or_else(broken)?;
            let error = unfolded(code);
            let expected = parameters.mean + framed.predicted(&parameters.weights, at);
            let value = checked(expected.saturating_add(error))?;
            framed.values[at] = i64::from(value) - parameters.mean;
            sizes.push(misses.put(x, y, error));
            values.push(value);
        }
    }
    *before = sizes;
    Ok(Plane {
        width,
        height,
        values,
    })
}

#[cfg(test)]
mod tests {
    use super::super::simple::{decode_simple, encode_simple};
    use super::super::zlib;
    use super::*;
    use proptest::prelude::*;

    fn planes() -> impl Strategy<Value = Vec<Plane>> {
        (1_usize..40, 1_usize..30, 0_u32..29).prop_flat_map(|(width, height, bits)| {
            let most = 1_i32 << bits;
            let plane = proptest::collection::vec(-most..=most, width * height);
            proptest::collection::vec(plane, 1..4).prop_map(move |planes| {
                planes
                    .into_iter()
                    .map(|values| Plane {
                        width,
                        height,
                        values,
                    })
                    .collect()
            })
        })
    }

    proptest! {
        #[test]
        fn every_plane_comes_back_from_either_coder(planes in planes()) {
            let (mut before, mut again) = (Vec::new(), Vec::new());
            for plane in &planes {
                let bytes = encode_fitted(plane, &mut before);
                prop_assert_eq!(&decode_fitted(&bytes, plane.width, plane.height, &mut again).unwrap(), plane);
                prop_assert_eq!(&before, &again);
                let simple = encode_simple(plane);
                prop_assert_eq!(&decode_simple(&simple, plane.width, plane.height).unwrap(), plane);
            }
        }

        #[test]
        fn no_bytes_make_a_decoder_panic(bytes in proptest::collection::vec(any::<u8>(), 0..400)) {
            let _ = decode_fitted(&bytes, 9, 7, &mut Vec::new());
            let _ = decode_simple(&bytes, 9, 7);
            let _ = decode_simple(&zlib::packed(&bytes), 9, 7);
        }
    }
}
