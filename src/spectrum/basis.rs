//! The smooth part: a short series over the band in one of two bases.
//!
//! ```text
//! fourier  S(l) = a0/2 + sum a_n cos(2 pi n (l - min)/L) + b_n sin(2 pi n (l - min)/L)   (Eq. 4)
//! cosine   S(l) = c0   + sum c_n cos(pi n (l - min)/L),  n = 0..2N
//! ```
//!
//! Coefficients are kept in **prefix order**, `a0 a1 b1 a2 b2 ...` or `c0 c1 c2 ...`, so that a
//! lower order is a prefix of a higher one: fit once to the largest order, truncate for a slider.

use std::f64::consts::PI;

use serde::{Deserialize, Serialize};

use super::band::{Band, dot};

/// The family of basis functions that make up the smooth part.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Basis {
    /// The paper's periodic Fourier series: rings where the two ends of the band differ.
    Fourier,
    /// Half-range cosines: the same count of numbers, no jump at the ends.
    Cosine,
}

impl Basis {
    /// Both bases, the paper's first.
    pub const ALL: [Self; 2] = [Self::Fourier, Self::Cosine];

    /// The word used in files and on the command line.
    pub fn word(self) -> &'static str {
        match self {
            Self::Fourier => "fourier",
            Self::Cosine => "cosine",
        }
    }

    /// The basis of that word.
    pub(crate) fn from_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|basis| basis.word() == word)
    }

    /// Highest order that the band's 1 nm grid can carry: above it the functions are not
    /// independent on the grid any more.
    pub fn highest_order(band: Band) -> usize {
        (band.steps() - 1) / 2
    }

    /// Value of the function that coefficient `index` (prefix order) multiplies.
    pub fn function(self, index: usize, band: Band, at_nm: f64) -> f64 {
        let x = (at_nm - band.min_nm()) / band.length_nm();
        match self {
            Self::Fourier if index == 0 => 0.5,
            Self::Fourier => {
                let (sin, cos) = (2.0 * PI * index.div_ceil(2) as f64 * x).sin_cos();
                if index % 2 == 1 { cos } else { sin }
            }
            Self::Cosine => (PI * index as f64 * x).cos(),
        }
    }

    /// Integral of the square of function `index` over the band, in nm.
    ///
    /// Holds to rounding for the trapezoid sum on the 1 nm grid too, which is why the projection
    /// of Eq. 5 is the least-squares fit.
    pub fn norm_squared(self, index: usize, band: Band) -> f64 {
        match (self, index) {
            (Self::Fourier, 0) => band.length_nm() / 4.0,
            (Self::Cosine, 0) => band.length_nm(),
            _ => band.length_nm() / 2.0,
        }
    }

    /// Integral of function `index` over the band, in nm.
    pub(crate) fn integral(self, index: usize, band: Band) -> f64 {
        match (self, index) {
            (Self::Fourier, 0) => band.length_nm() / 2.0,
            (Self::Cosine, 0) => band.length_nm(),
            _ => 0.0,
        }
    }
}

/// Numbers that a series of an order takes: `2N + 1` in either basis.
pub fn numbers_of_order(order: usize) -> usize {
    2 * order + 1
}

/// The basis functions on a band's grid, computed once and shared by every fit.
#[derive(Clone, Debug)]
pub struct BasisTable {
    band: Band,
    basis: Basis,
    numbers: usize,
    /// `numbers` rows of `band.points()` values: the functions themselves.
    functions: Vec<f64>,
    /// The same rows with trapezoid weight over norm: a dot product with a row is a coefficient.
    projectors: Vec<f64>,
}

impl BasisTable {
    /// The first `numbers` functions of a basis on a band.
    ///
    /// The count is cut to what the grid carries ([`Basis::highest_order`]).
    pub fn new(band: Band, basis: Basis, numbers: usize) -> Self {
        let numbers = numbers.clamp(1, numbers_of_order(Basis::highest_order(band)));
        let points = band.points();
        let mut functions = Vec::with_capacity(numbers * points);
        let mut projectors = Vec::with_capacity(numbers * points);
        for index in 0..numbers {
            let norm = basis.norm_squared(index, band);
            for i in 0..points {
                let value = basis.function(index, band, band.nm(i));
                functions.push(value);
                projectors.push(value * band.weight(i) / norm);
            }
        }
        Self {
            band,
            basis,
            numbers,
            functions,
            projectors,
        }
    }

    /// The band whose grid the rows stand on.
    pub fn band(&self) -> Band {
        self.band
    }

    /// The basis of the rows.
    pub fn basis(&self) -> Basis {
        self.basis
    }

    /// Number of rows.
    pub fn numbers(&self) -> usize {
        self.numbers
    }

    /// Function `index` on the grid.
    pub fn row(&self, index: usize) -> &[f64] {
        let points = self.band.points();
        &self.functions[index * points..(index + 1) * points]
    }

    /// Eq. 5 by the trapezoid rule: the first `numbers` coefficients of values on the grid.
    pub fn project(&self, values: &[f64], numbers: usize) -> Vec<f64> {
        self.projectors
            .chunks_exact(self.band.points())
            .take(numbers)
            .map(|row| dot(row, values))
            .collect()
    }

    /// The series on the grid, added to `out`.
    pub fn add_series(&self, coefficients: &[f64], out: &mut [f64]) {
        let rows = self.functions.chunks_exact(self.band.points());
        for (row, c) in rows.zip(coefficients) {
            for (o, f) in out.iter_mut().zip(row) {
                *o += c * f;
            }
        }
    }

    /// The series on the grid.
    pub fn evaluate(&self, coefficients: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; self.band.points()];
        self.add_series(coefficients, &mut out);
        out
    }
}

/// A finite series: the smooth part of a composite.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Band on which the series is defined.
    pub band: Band,
    /// Its functions.
    pub basis: Basis,
    /// Coefficients in prefix order, in the spectrum's own unit; at least one.
    pub coefficients: Vec<f64>,
}

impl Series {
    /// A series of these coefficients in prefix order.
    pub fn new(band: Band, basis: Basis, coefficients: Vec<f64>) -> Self {
        Self {
            band,
            basis,
            coefficients,
        }
    }

    /// A Fourier series from the paper's `a_0..a_N` and `b_1..b_N`; `None` unless there is
    /// exactly one `a` more than there are `b`.
    pub(crate) fn fourier(band: Band, a: &[f64], b: &[f64]) -> Option<Self> {
        if a.len() != b.len() + 1 {
            return None;
        }
        let mut coefficients = vec![a[0]];
        for (a, b) in a[1..].iter().zip(b) {
            coefficients.extend([*a, *b]);
        }
        Some(Self::new(band, Basis::Fourier, coefficients))
    }

    /// The order `N`: the highest with any of its numbers present.
    pub fn order(&self) -> usize {
        self.coefficients.len() / 2
    }

    /// `a_0..a_N` and `b_1..b_N` of a Fourier series (a dropped last sine reads as zero).
    pub(crate) fn a_b(&self) -> (Vec<f64>, Vec<f64>) {
        let a = std::iter::once(self.coefficients[0])
            .chain(self.coefficients[1..].iter().copied().step_by(2))
            .collect();
        let mut b: Vec<f64> = self.coefficients[1..]
            .iter()
            .copied()
            .skip(1)
            .step_by(2)
            .collect();
        b.resize(self.order(), 0.0);
        (a, b)
    }

    /// The first `numbers` coefficients.
    pub fn truncated(&self, numbers: usize) -> Self {
        let count = numbers.clamp(1, self.coefficients.len());
        Self::new(self.band, self.basis, self.coefficients[..count].to_vec())
    }

    /// Value at a wavelength inside the band; zero outside it.
    ///
    /// The cosines of all orders come from one `sin_cos` by the angle-addition recurrence.
    pub fn at(&self, at_nm: f64) -> f64 {
        if !self.band.contains(at_nm) {
            return 0.0;
        }
        let x = (at_nm - self.band.min_nm()) / self.band.length_nm();
        let c = &self.coefficients;
        match self.basis {
            Basis::Fourier => {
                let (s1, c1) = (2.0 * PI * x).sin_cos();
                let (mut sin, mut cos) = (s1, c1);
                let mut sum = 0.5 * c[0];
                for pair in c[1..].chunks(2) {
                    sum += pair[0] * cos + pair.get(1).map_or(0.0, |b| b * sin);
                    (sin, cos) = (sin * c1 + cos * s1, cos * c1 - sin * s1);
                }
                sum
            }
            Basis::Cosine => {
                let (s1, c1) = (PI * x).sin_cos();
                let (mut sin, mut cos) = (s1, c1);
                let mut sum = c[0];
                for c in &c[1..] {
                    sum += c * cos;
                    (sin, cos) = (sin * c1 + cos * s1, cos * c1 - sin * s1);
                }
                sum
            }
        }
    }

    /// The series on the band's grid.
    pub fn on_band(&self) -> Vec<f64> {
        self.band.grid().map(|nm| self.at(nm)).collect()
    }

    /// Exact integral over the band, in value x nm.
    pub(crate) fn integral(&self) -> f64 {
        self.coefficients[0] * self.basis.integral(0, self.band)
    }
}
