//! The colour of a small picture: where it is coloured, and which way colours run.

use super::super::{picture::Small, smooth::percentile};

/// Amount of coloured light at each place.
pub(super) struct Light {
    pub size: [usize; 2],
    /// Chroma above its floor; of a grey picture the light above its own.
    pub chroma: Vec<f64>,
    /// What all but the brightest places have at most.
    pub most: f64,
    pub is_grey: bool,
    /// From the blue to the red middle, as far as there are colours.
    vector: Option<[f64; 2]>,
    /// Pixels of the photograph in one of this, along a side.
    pub block: usize,
}

/// A picture whose chroma holds less of its light is grey.
const LEAST_CHROMA: f64 = 0.025;
/// A channel whose places hold less of the chroma has no middle.
const LEAST_SHARE: f64 = 0.01;
/// Share of the lit places that are not the brightest.
const MOST: f64 = 0.995;

impl Light {
    pub(super) fn of(small: &Small) -> Self {
        let [width, height] = small.size;
        let above: [Vec<f64>; 3] = small.channels.each_ref().map(|channel| {
            let values: Vec<f64> = channel.iter().map(|v| f64::from(*v)).collect();
            let black = percentile(&sparse(&values), 0.15);
            let light: Vec<f64> = values.iter().map(|v| (v - black).max(0.0)).collect();
            blurred(&light, width, height)
        });
        let [r, g, b] = &above;
        let places = 0..width * height;
        let spread = |i: usize| r[i].max(g[i]).max(b[i]) - r[i].min(g[i]).min(b[i]);
        let chroma = above_floor(&places.clone().map(spread).collect::<Vec<f64>>(), width);
        let bright: Vec<f64> = places.map(|i| (r[i] + g[i] + b[i]) / 3.0).collect();
        let total: f64 = bright.iter().sum();
        let is_grey = chroma.iter().sum::<f64>() < LEAST_CHROMA * total;
        let middles = middles(&above, &chroma, width);
        let vector = (!is_grey).then(|| vector(&middles)).flatten();
        let chroma: Vec<f64> = if is_grey {
            let floor = 3.0 * percentile(&sparse(&bright), 0.5);
            bright.iter().map(|v| (v - floor).max(0.0)).collect()
        } else {
            chroma
        };
        let lit: Vec<f64> = chroma.iter().copied().filter(|c| *c > 0.0).collect();
        Self {
            size: small.size,
            most: percentile(&lit, MOST).max(f64::MIN_POSITIVE),
            chroma,
            is_grey,
            vector,
            block: small.block,
        }
    }

    /// The same with columns and rows changed for each other.
    pub(super) fn transposed(&self) -> Self {
        let [columns, rows] = self.size;
        let places = (0..columns).flat_map(|x| (0..rows).map(move |y| y * columns + x));
        Self {
            size: [rows, columns],
            chroma: places.map(|at| self.chroma[at]).collect(),
            vector: self.vector.map(|[x, y]| [y, x]),
            ..*self
        }
    }

    /// Blue lies to the right, as far as colours tell.
    pub(super) fn blue_is_right(&self) -> Option<bool> {
        self.vector.map(|[x, _]| x < 0.0)
    }

    /// Ways in which colours may run, true where from top to bottom.
    pub(super) fn ways(&self) -> Vec<bool> {
        let Some([x, y]) = self.vector else {
            return vec![false, true];
        };
        match y.abs().atan2(x.abs()).to_degrees() {
            ..40.0 => vec![false],
            50.0.. => vec![true],
            _ => vec![false, true],
        }
    }
}

/// At most some ten thousand of many values, evenly taken: enough for a percentile.
fn sparse(values: &[f64]) -> Vec<f64> {
    let step = (values.len() / 20_000).max(1);
    values.iter().step_by(step).copied().collect()
}

/// A picture behind a Gaussian of one pixel.
fn blurred(values: &[f64], width: usize, height: usize) -> Vec<f64> {
    const KERNEL: [f64; 7] = [
        0.00443, 0.05400, 0.24204, 0.39905, 0.24204, 0.05400, 0.00443,
    ];
    let along = |values: &[f64], at: usize, step: usize, place: usize, count: usize| {
        let near = |i: usize| (place + i).saturating_sub(3).min(count - 1);
        let at = |i: usize| at + near(i) * step - place * step;
        (0..7).map(|i| KERNEL[i] * values[at(i)]).sum::<f64>()
    };
    let places = |i: usize| (i % width, i / width);
    let level: Vec<f64> = (0..width * height)
        .map(|i| along(values, i, 1, places(i).0, width))
        .collect();
    (0..width * height)
        .map(|i| along(&level, i, width, places(i).1, height))
        .collect()
}

/// Chroma above the floor that noise and casts give it.
fn above_floor(chroma: &[f64], width: usize) -> Vec<f64> {
    let steps: Vec<f64> = (chroma.chunks(width))
        .flat_map(|row| row.windows(2).map(|two| (two[1] - two[0]).abs()))
        .collect();
    let noise = 1.4826 * percentile(&sparse(&steps), 0.5);
    let some = sparse(chroma);
    let floor = percentile(&some, 0.5).min(percentile(&some, 0.2) + 4.0 * noise) + 3.0 * noise;
    chroma.iter().map(|c| (c - floor).max(0.0)).collect()
}

/// The chroma of the places of each channel, and their middle.
fn middles(light: &[Vec<f64>; 3], chroma: &[f64], width: usize) -> [(f64, [f64; 2]); 3] {
    let mut sums = [(0.0, [0.0, 0.0]); 3];
    for (i, weight) in chroma.iter().enumerate().filter(|(_, c)| **c > 0.0) {
        let [r, g, b] = [light[0][i], light[1][i], light[2][i]];
        let largest = if r >= g && r >= b {
            0
        } else if g >= b {
            1
        } else {
            2
        };
        let (sum, place) = &mut sums[largest];
        *sum += weight;
        place[0] += weight * (i % width) as f64;
        place[1] += weight * (i / width) as f64;
    }
    sums.map(|(sum, [x, y])| (sum, [x, y].map(|p| p / sum.max(f64::MIN_POSITIVE))))
}

/// From the blue to the red middle, or what is nearest to it.
fn vector(middles: &[(f64, [f64; 2]); 3]) -> Option<[f64; 2]> {
    let total: f64 = middles.iter().map(|m| m.0).sum();
    let is_there = |k: usize| middles[k].0 > LEAST_SHARE * total;
    let (from, to) = match (is_there(0), is_there(1), is_there(2)) {
        (true, _, true) => (2, 0),
        (true, true, false) => (1, 0),
        (false, true, true) => (2, 1),
        _ => return None,
    };
    let (from, to) = (middles[from].1, middles[to].1);
    Some([to[0] - from[0], to[1] - from[1]])
}
