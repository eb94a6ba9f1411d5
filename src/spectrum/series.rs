//! A finite series of a basis on a band: the smooth part of a composite, and the tables that fit it.

use std::f64::consts::PI;

use super::{
    band::{Band, dot},
    basis::{Basis, numbers_of_order},
};

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
        let most = numbers_of_order(Basis::highest_order(band));
        Self::beyond_the_grid(band, basis, numbers.clamp(1, most))
    }

    /// As [`BasisTable::new`] for any count: functions beyond those that the grid carries are not
    /// orthogonal on it to the others.
    pub(super) fn beyond_the_grid(band: Band, basis: Basis, numbers: usize) -> Self {
        let functions = basis.rows(band, numbers);
        let rows = functions.chunks_exact(band.points());
        let projectors = rows.enumerate().flat_map(|(index, row)| {
            let norm = basis.norm_squared(index, band);
            let weighted = row.iter().enumerate();
            weighted.map(move |(i, value)| value * band.weight(i) / norm)
        });
        let projectors = projectors.collect();
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

    /// A series from the lists of a file ([`Basis::lists`]), a missing one being empty; `None` unless
    /// they are one run of numbers in prefix order, at least one.
    pub(crate) fn from_lists(band: Band, basis: Basis, lists: &[(&str, &[f64])]) -> Option<Self> {
        let mut left: Vec<(&str, std::slice::Iter<'_, f64>)> = lists
            .iter()
            .map(|(name, list)| (*name, list.iter()))
            .collect();
        let coefficients: Vec<f64> = (0..)
            .map_while(|index| {
                let own = basis.wave(index).list;
                let (_, list) = left.iter_mut().find(|(name, _)| *name == own)?;
                list.next().copied()
            })
            .collect();
        let is_whole =
            left.iter().all(|(_, list)| list.as_slice().is_empty()) && !coefficients.is_empty();
        is_whole.then(|| Self::new(band, basis, coefficients))
    }

    /// The coefficients as files have them, list by list; where the last wave has another number
    /// in another list, that is written as zero.
    pub(crate) fn lists(&self) -> Vec<(&'static str, Vec<f64>)> {
        let last = self.basis.wave(self.coefficients.len() - 1).multiple;
        let waves = (0..).map(|index| self.basis.wave(index));
        let numbers: Vec<_> = waves
            .take_while(|wave| wave.multiple <= last)
            .zip(
                self.coefficients
                    .iter()
                    .copied()
                    .chain(std::iter::repeat(0.0)),
            )
            .collect();
        let of = |list: &'static str| {
            let own = numbers.iter().filter(|(wave, _)| wave.list == list);
            (list, own.map(|(_, c)| *c).collect())
        };
        self.basis.lists().into_iter().map(of).collect()
    }

    /// The order `N`: the highest with any of its numbers present.
    pub fn order(&self) -> usize {
        self.coefficients.len() / 2
    }

    /// The first `numbers` coefficients.
    pub fn truncated(&self, numbers: usize) -> Self {
        let count = numbers.clamp(1, self.coefficients.len());
        Self::new(self.band, self.basis, self.coefficients[..count].to_vec())
    }

    /// Value at a wavelength inside the band; zero outside it.
    pub fn at(&self, at_nm: f64) -> f64 {
        if !self.band.contains(at_nm) {
            return 0.0;
        }
        self.values([at_nm])[0]
    }

    /// The series on the band's grid.
    pub fn on_band(&self) -> Vec<f64> {
        // Enough side by side that none waits for the step before it.
        const LANES: usize = 8;
        let points = self.band.points();
        let starts = (0..points).step_by(LANES);
        let mut values: Vec<f64> = starts
            .flat_map(|start| {
                let nm = |lane: usize| self.band.nm((start + lane).min(points - 1));
                self.values::<LANES>(std::array::from_fn(nm))
            })
            .collect();
        values.truncate(points);
        values
    }

    /// Values at wavelengths of the band. The waves of all orders come from one `sin_cos` by the
    /// angle-addition recurrence.
    fn values<const N: usize>(&self, at_nm: [f64; N]) -> [f64; N] {
        let half_turns = PI * self.basis.half_turns() as f64;
        let first = at_nm.map(|nm| {
            let x = (nm - self.band.min_nm()) / self.band.length_nm();
            (half_turns * x).sin_cos()
        });
        let (mut sin, mut cos, mut sums) = ([0.0; N], [1.0; N], [0.0; N]);
        let mut multiple = 0;
        for (index, c) in self.coefficients.iter().enumerate() {
            let wave = self.basis.wave(index);
            if wave.multiple > multiple {
                multiple = wave.multiple;
                for (lane, (s1, c1)) in first.into_iter().enumerate() {
                    let (s, c) = (sin[lane], cos[lane]);
                    (sin[lane], cos[lane]) = (s * c1 + c * s1, c * c1 - s * s1);
                }
            }
            for (lane, sum) in sums.iter_mut().enumerate() {
                *sum += c * wave.value(sin[lane], cos[lane]);
            }
        }
        sums
    }

    /// Exact integral over the band, in value x nm.
    pub(crate) fn integral(&self) -> f64 {
        self.basis.mean(self.coefficients[0]) * self.band.length_nm()
    }
}
