//! The linear predictor of a plane: what a number is likely to be by ten of its neighbours, and how
//! much was missed about it.

use nalgebra::{SMatrix, SVector};

/// Neighbours of the linear predictor: W N NW NE WW NN NEE NWW and two rows up, one left and right.
const NEIGHBOURS: [(isize, isize); 10] = [
    (-1, 0),
    (0, -1),
    (-1, -1),
    (1, -1),
    (-2, 0),
    (0, -2),
    (2, -1),
    (-2, -1),
    (-1, -2),
    (1, -2),
];
pub(super) const COUNT: usize = NEIGHBOURS.len();
/// Denominator of the weights.
const ONE: i64 = 1024;
/// Rows and columns about a tile that count as its mean.
const PAD: usize = 2;
/// A miss counts at most this much in a context.
pub(super) const MOST_MISS: i64 = 1 << 24;

/// Times that the least squares are weighed anew; more gain less than a hundredth.
const ROUNDS: usize = 6;

/// Weights of the neighbours, in 1024ths.
pub(super) type Weights = [i64; COUNT];

/// A plane inside a frame of two rows and columns, its mean taken off.
pub(super) struct Framed {
    width: usize,
    height: usize,
    stride: usize,
    pub(super) values: Vec<i64>,
    offsets: [isize; COUNT],
}

impl Framed {
    pub(super) fn new(width: usize, height: usize) -> Self {
        let stride = width + 2 * PAD;
        Self {
            width,
            height,
            stride,
            values: vec![0; stride * (height + PAD)],
            offsets: NEIGHBOURS.map(|(dx, dy)| dy * stride as isize + dx),
        }
    }

    pub(super) fn at(&self, x: usize, y: usize) -> usize {
        (y + PAD) * self.stride + x + PAD
    }

    fn neighbours(&self, at: usize) -> [i64; COUNT] {
        self.offsets
            .map(|offset| self.values[(at as isize + offset) as usize])
    }

    /// Predicted value at a place.
    pub(super) fn predicted(&self, weights: &Weights, at: usize) -> i64 {
        let near = self.neighbours(at);
        let sum: i64 = weights.iter().zip(&near).map(|(w, v)| w * v).sum();
        (sum + ONE / 2).div_euclid(ONE)
    }

    /// Residuals of the prediction, row after row.
    pub(super) fn missed(&self, weights: &Weights) -> Vec<i64> {
        let places = (0..self.height).flat_map(|y| (0..self.width).map(move |x| (x, y)));
        let of = |(x, y)| {
            let at = self.at(x, y);
            self.values[at] - self.predicted(weights, at)
        };
        places.map(of).collect()
    }

    /// The weights that leave the fewest bits. Plain least squares would serve the few edges of a
    /// picture, whose squares are largest; bits grow with the logarithm of what is missed. So each
    /// place counts less the more is missed there and about it.
    pub(super) fn fitted(&self, before: &[u32]) -> Weights {
        let mut weights = self.least_squares(|_| 1.0);
        for _ in 0..ROUNDS {
            let missed = self.missed(&weights);
            let misses = Misses::of(&missed, self.width, self.height);
            let better = self.least_squares(|i| {
                // The sum has weights of 10.
                let usual = misses.activity(i % self.width, i / self.width, before) as f64 / 10.0;
                let usual = usual + 0.5;
                1.0 / (usual * (missed[i].abs() as f64 + 0.5 * usual + 0.25))
            });
            if better == weights {
                break;
            }
            weights = better;
        }
        weights
    }

    /// Least squares over the plane, to whole 1024ths.
    fn least_squares(&self, counts: impl Fn(usize) -> f64) -> Weights {
        let mut normal = SMatrix::<f64, COUNT, COUNT>::zeros();
        let mut right = SVector::<f64, COUNT>::zeros();
        for y in 0..self.height {
            for x in 0..self.width {
                let at = self.at(x, y);
                let near = self.neighbours(at).map(|v| v as f64);
                let count = counts(y * self.width + x);
                let value = self.values[at] as f64;
                for i in 0..COUNT {
                    let counted = count * near[i];
                    right[i] += counted * value;
                    for j in 0..=i {
                        normal[(i, j)] += counted * near[j];
                    }
                }
            }
        }
        let ridge = 1e-6 * normal.trace() + 1e-3;
        for i in 0..COUNT {
            for j in 0..i {
                normal[(j, i)] = normal[(i, j)];
            }
            normal[(i, i)] += ridge;
        }
        let solved = normal.cholesky().map(|c| c.solve(&right));
        let weights = solved.unwrap_or_else(SVector::zeros);
        let whole = |w: f64| {
            if w.is_finite() {
                (w * ONE as f64).round().clamp(-32767.0, 32767.0) as i64
            } else {
                0
            }
        };
        std::array::from_fn(|k| whole(weights[k]))
    }
}

/// Sizes of what the predictor missed, in a frame.
pub(super) struct Misses {
    width: usize,
    stride: usize,
    sizes: Vec<i64>,
}

impl Misses {
    pub(super) fn new(width: usize, height: usize) -> Self {
        let stride = width + 2 * PAD;
        Self {
            width,
            stride,
            sizes: vec![0; stride * (height + PAD)],
        }
    }

    fn of(missed: &[i64], width: usize, height: usize) -> Self {
        let mut misses = Self::new(width, height);
        for (i, missed) in missed.iter().enumerate() {
            misses.put(i % width, i / width, *missed);
        }
        misses
    }

    /// Stores the residual at a place and returns its size.
    pub(super) fn put(&mut self, x: usize, y: usize, missed: i64) -> u32 {
        let size = missed.abs().min(MOST_MISS);
        self.sizes[(y + PAD) * self.stride + x + PAD] = size;
        size as u32
    }

    /// Activity: size of the residuals around a place, and there in the plane before.
    pub(super) fn activity(&self, x: usize, y: usize, before: &[u32]) -> i64 {
        let (e, s) = (&self.sizes, self.stride);
        let at = (y + PAD) * s + x + PAD;
        let pixel = y * self.width + x;
        let of_plane_before = before.get(pixel).map_or(0, |miss| i64::from(*miss));
        2 * e[at - 1]
            + 2 * e[at - s]
            + e[at - s - 1]
            + e[at - s + 1]
            + e[at - 2]
            + e[at - 2 * s]
            + 2 * of_plane_before
    }
}
