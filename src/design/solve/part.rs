//! A quantity to be minimised or kept below a limit: its value, slope and bend at a mixture.
//!
//! A mean of the sizes of samples' differences is nearly hollow upwards; its bend is taken from the
//! slopes of the differences alone.

use nalgebra::{DMatrix, DVector};

use super::polytope::Polytope;
use crate::design::scales::{Against, Scales, Sums};

/// A quantity to be minimised or kept below a limit.
#[derive(Clone, Debug)]
pub(super) enum Part {
    /// A number a column of the polytope.
    Sum(Vec<f64>),
    /// The mean difference that a figure falls with.
    Mean(Against),
}

/// A part at a place: its value, slope and bend.
pub(super) struct Local {
    pub(super) value: f64,
    pub(super) slope: DVector<f64>,
    pub(super) bend: Option<DMatrix<f64>>,
}

/// The mixtures of a polytope, scaled, with the sums that parts need.
pub(super) struct Parts<'a> {
    pub(super) scales: &'a Scales,
    pub(super) within: &'a Polytope,
    /// Columns that some mixture has, and the greatest unknown of each.
    pub(super) kept: Vec<(usize, f64)>,
    /// Sums of each column of the polytope.
    pub(super) sums: Vec<&'a Sums>,
}

impl Parts<'_> {
    /// A part at a place; `None` where it has no value.
    pub(super) fn at(
        &self,
        part: &Part,
        place: &DVector<f64>,
        rounded: f64,
        slopes: bool,
    ) -> Option<Local> {
        match part {
            Part::Sum(numbers) => {
                let scaled = self.kept.iter().map(|(i, most)| numbers[*i] * most);
                let mut slope = DVector::zeros(place.len());
                slope.iter_mut().zip(scaled).for_each(|(s, v)| *s = v);
                if place.len() > self.kept.len() {
                    slope[self.kept.len()] =
                        numbers.get(self.within.columns.len()).map_or(0.0, |v| *v);
                }
                let least = self.within.least_fixed.unwrap_or(0.0);
                let base = least * numbers[self.within.columns.len() - 1];
                Some(Local {
                    value: base + slope.dot(place),
                    slope,
                    bend: None,
                })
            }
            Part::Mean(figure) => self.mean(*figure, place, rounded, slopes),
        }
    }

    /// The mean size of the differences of a figure.
    fn mean(
        &self,
        figure: Against,
        place: &DVector<f64>,
        rounded: f64,
        slopes: bool,
    ) -> Option<Local> {
        let columns: Vec<(&[f64], f64)> = self
            .kept
            .iter()
            .map(|(i, most)| (figure.sums_of(self.sums[*i]), *most))
            .collect();
        let mut sums = vec![0.0; columns.first()?.0.len()];
        let mut add = |column: &[f64], weight: f64| {
            let both = sums.iter_mut().zip(column);
            both.for_each(|(sum, value)| *sum += weight * value);
        };
        for ((column, most), share) in columns.iter().zip(place.iter()) {
            add(column, most * share);
        }
        if let (Some(least), Some(fixed)) = (self.within.least_fixed, self.sums.last()) {
            add(figure.sums_of(fixed), least);
        }
        let all = self.scales.differences(figure, &sums)?;
        let size_of =
            |d: &[f64; 3]| (d.iter().map(|v| v * v).sum::<f64>() + rounded * rounded).sqrt();
        let share = 1.0 / all.len() as f64;
        let value = share * all.iter().map(size_of).sum::<f64>();
        let mut slope = DVector::zeros(place.len());
        if !slopes {
            return value.is_finite().then_some(Local {
                value,
                slope,
                bend: None,
            });
        }
        let by_sums = self.by_sums(figure, &sums, all.len())?;
        let white = sums.len() - 3;
        // Rows of the differences' slopes, each over the root of its size: their squares are the
        // bend, less what lies along a difference itself.
        let mut rows = DMatrix::zeros(4 * all.len(), place.len());
        for (sample, difference) in all.iter().enumerate() {
            let size = size_of(difference);
            let turned = &by_sums[sample];
            for (j, (column, most)) in columns.iter().enumerate() {
                let own = &column[3 * sample..3 * sample + 3];
                let parts: [f64; 3] = std::array::from_fn(|k| {
                    let of = |half: &[f64], values: &[f64]| -> f64 {
                        half.iter().zip(values).map(|(a, b)| a * b).sum()
                    };
                    most * (of(&turned[k][..3], own) + of(&turned[k][3..], &column[white..]))
                });
                let along = difference
                    .iter()
                    .zip(parts)
                    .map(|(d, p)| d * p)
                    .sum::<f64>()
                    / size;
                slope[j] += share * along;
                let root = (share / size).sqrt();
                let [l, m, n] = parts.map(|p| p * root);
                let at = 4 * sample;
                (rows[(at, j)], rows[(at + 1, j)], rows[(at + 2, j)]) = (l, m, n);
                rows[(at + 3, j)] = along * root;
            }
        }
        let mut signed = rows.clone();
        for sample in 0..all.len() {
            signed.row_mut(4 * sample + 3).neg_mut();
        }
        let bend = rows.tr_mul(&signed);
        Some(Local {
            value,
            slope,
            bend: Some(bend),
        })
    }

    /// Derivatives of each sample's three differences by its own X, Y, Z and by the light's:
    /// central differences, all samples at once, each independent of the others.
    fn by_sums(&self, figure: Against, sums: &[f64], samples: usize) -> Option<Vec<[[f64; 6]; 3]>> {
        // A cube root of f64's rounding, of the light's Y: as exact as a central difference gets.
        let step = 6e-6 * sums[sums.len() - 2];
        let mut found = vec![[[0.0; 6]; 3]; samples];
        for number in 0..6 {
            let at = |sign: f64| {
                let mut moved = sums.to_vec();
                let white = moved.len() - 3;
                let (own, light) = moved.split_at_mut(white);
                match number {
                    0..3 => own
                        .iter_mut()
                        .skip(number)
                        .step_by(3)
                        .for_each(|v| *v += sign * step),
                    _ => light[number - 3] += sign * step,
                }
                self.scales.differences(figure, &moved)
            };
            let (up, down) = (at(1.0)?, at(-1.0)?);
            for (sample, (up, down)) in found.iter_mut().zip(up.iter().zip(&down)) {
                (0..3).for_each(|k| sample[k][number] = (up[k] - down[k]) / (2.0 * step));
            }
        }
        Some(found)
    }
}
