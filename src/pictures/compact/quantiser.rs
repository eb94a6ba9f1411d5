//! Numbers of a pixel to whole numbers and back, so that one step is the same colour difference in
//! every plane, in light and in shade.

use nalgebra::{DMatrix, DVector};

use crate::color::Xyz;

use super::super::header::StoredQuantiser;
use super::super::measure::Storage;
use super::super::relight::Between;
use super::super::survey::percentile;
use super::super::trust::{lab_by_xyz, matrix_of};
use super::super::{Illuminant, Operator, PictureError, Relit};

/// Lightness steps of the first plane, as a share of the others' step.
const OF_LIGHTNESS: f64 = 0.3 / 116.0;
/// Below so many steps of the first plane the others are no longer scaled down.
const FLOOR: f64 = 3.0;
/// Unit differences in colour, and in the spectrum relative to grey.
const ONE_COLOUR: f64 = 0.5;
const ONE_SPECTRUM: f64 = 0.01;
/// Least weight of a direction, as a share of the largest.
const LEAST: f64 = 1e-9;
/// 95th percentile of own dE00 that a step of 1 makes.
pub(crate) const P95_OF_STEP: f64 = 0.46;
/// Pixels on a side of a tile.
pub(super) const TILE: usize = 256;
/// Largest whole number.
const MOST: f64 = (1 << 29) as f64;

/// The numbers of a picture in steps.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantiser {
    stored: StoredQuantiser,
    /// Numbers to steps, row by row; empty where only decoding is needed.
    forward: Vec<f64>,
    metric_diagonal: Vec<f64>,
}

impl Quantiser {
    /// The quantiser of a picture by a sample of its numbers, with a step (1 makes a 95th
    /// percentile of own colour of 0.46). `c_ref` is the 99th percentile of the first number.
    ///
    /// # Errors
    /// [`PictureError::AllZero`] where no first number is above zero.
    pub fn new(
        operator: &Operator,
        sample: &[Vec<f64>],
        step: f64,
        c_ref: Option<f64>,
    ) -> Result<Self, PictureError> {
        let count = operator.numbers();
        let mut firsts: Vec<f64> = sample
            .iter()
            .map(|z| z[0])
            .filter(|c| c.is_finite())
            .collect();
        if firsts.is_empty() || !(step > 0.0 && step.is_finite()) {
            return Err(PictureError::NothingMeasured);
        }
        let high = percentile(&mut firsts, 0.99);
        let c_ref = c_ref.unwrap_or(if high > 0.0 {
            high
        } else {
            firsts.iter().copied().fold(0.0, f64::max)
        });
        if !(c_ref > 0.0 && c_ref.is_finite()) {
            return Err(PictureError::AllZero);
        }
        let metric = metric(operator, sample)?;
        let mut quantiser = Self {
            stored: StoredQuantiser {
                step,
                dc_step: OF_LIGHTNESS * step,
                c_ref,
                floor: FLOOR,
                mean: vec![0.0; count - 1],
                inverse: Vec::new(),
                tile: TILE,
                order: (0..count).collect(),
            },
            forward: Vec::new(),
            metric_diagonal: metric.diagonal().as_slice().to_vec(),
        };
        let relative: Vec<DVector<f64>> = sample
            .iter()
            .map(|z| DVector::from_vec(quantiser.relative(z).1))
            .filter(|a| a.iter().all(|v| v.is_finite()))
            .collect();
        quantiser.turn(&metric, &relative);
        Ok(quantiser)
    }

    /// Sets mean, transform and its inverse from the metric and a sample of relative numbers.
    fn turn(&mut self, metric: &DMatrix<f64>, relative: &[DVector<f64>]) {
        let others = metric.nrows() - 1;
        let eigen = metric
            .view((1, 1), (others, others))
            .into_owned()
            .symmetric_eigen();
        let largest = eigen.eigenvalues.max().max(f64::MIN_POSITIVE);
        let root = eigen.eigenvalues.map(|w| w.max(LEAST * largest).sqrt());
        let to_metric = DMatrix::from_diagonal(&root) * eigen.eigenvectors.transpose();
        let from_metric = &eigen.eigenvectors * DMatrix::from_diagonal(&root.map(|r| 1.0 / r));
        let count = relative.len().max(1) as f64;
        let mean = relative
            .iter()
            .fold(DVector::zeros(others), |sum, a| sum + a)
            / count;
        let mut spread = DMatrix::zeros(others, others);
        for a in relative {
            let off = &to_metric * (a - &mean);
            spread += &off * off.transpose();
        }
        let turned = (spread / count).symmetric_eigen();
        let mut order: Vec<usize> = (0..others).collect();
        order.sort_by(|a, b| turned.eigenvalues[*b].total_cmp(&turned.eigenvalues[*a]));
        let rows = DMatrix::from_fn(others, others, |row, k| {
            turned.eigenvectors[(k, order[row])]
        });
        let mut forward = &rows * &to_metric;
        let mut inverse = from_metric * rows.transpose();
        for row in 0..others {
            let strongest = (0..others)
                .max_by(|a, b| {
                    forward[(row, *a)]
                        .abs()
                        .total_cmp(&forward[(row, *b)].abs())
                })
                .unwrap_or(0);
            if forward[(row, strongest)] < 0.0 {
                forward.row_mut(row).neg_mut();
                inverse.column_mut(row).neg_mut();
            }
        }
        self.stored.mean = mean.as_slice().to_vec();
        // nalgebra keeps columns; files and loops have rows.
        self.forward = forward.transpose().as_slice().to_vec();
        self.stored.inverse = inverse.transpose().as_slice().to_vec();
    }

    /// The same with another step.
    pub(crate) fn with_step(&self, step: f64) -> Self {
        let mut other = self.clone();
        other.stored.step = step;
        other.stored.dc_step = OF_LIGHTNESS * step;
        other
    }

    /// One that only decodes, from a header.
    ///
    /// # Errors
    /// [`PictureError::Broken`] when its tables do not fit the numbers a pixel.
    pub fn stored(stored: &StoredQuantiser, numbers: usize) -> Result<Self, PictureError> {
        let others = numbers.saturating_sub(1);
        let fits = stored.mean.len() == others
            && stored.inverse.len() == others * others
            && stored.order == (0..numbers).collect::<Vec<_>>()
            && (16..=4096).contains(&stored.tile);
        let tables = stored.mean.iter().chain(&stored.inverse);
        let scales = [stored.step, stored.dc_step, stored.c_ref, stored.floor];
        let finite =
            tables.chain(&scales).all(|v| v.is_finite()) && scales.iter().all(|v| *v > 0.0);
        if !(fits && finite) {
            return Err(PictureError::broken(
                said!("a quantiser whose tables do not fit"),
                tr!("finite tables for {numbers} numbers a pixel", numbers),
            ));
        }
        Ok(Self {
            stored: stored.clone(),
            forward: Vec::new(),
            metric_diagonal: Vec::new(),
        })
    }

    /// As files have it.
    pub(crate) fn as_stored(&self) -> &StoredQuantiser {
        &self.stored
    }

    /// One step.
    pub fn step(&self) -> f64 {
        self.stored.step
    }

    /// The diagonal of the metric that the steps are even in.
    #[cfg(test)]
    pub(crate) fn metric_diagonal(&self) -> &[f64] {
        &self.metric_diagonal
    }

    /// Unit of the other numbers beside a first number of `first` steps.
    fn unit(&self, first: f64) -> f64 {
        let root = first.abs().max(self.stored.floor) * self.stored.dc_step;
        self.stored.c_ref * root * root
    }

    /// Steps of the first number, and the others relative to it.
    fn relative(&self, numbers: &[f64]) -> (f64, Vec<f64>) {
        let first = ((numbers[0] / self.stored.c_ref).cbrt() / self.stored.dc_step).round();
        let first = first.clamp(-MOST, MOST);
        let unit = self.unit(first);
        (first, numbers[1..].iter().map(|c| c / unit).collect())
    }

    /// The steps of a pixel's numbers; `None` for one that was not measured.
    pub fn steps(&self, numbers: &[f64]) -> Option<Vec<i32>> {
        if numbers.iter().any(|z| !z.is_finite()) {
            return None;
        }
        let (first, mut relative) = self.relative(numbers);
        relative
            .iter_mut()
            .zip(&self.stored.mean)
            .for_each(|(a, mean)| *a -= mean);
        let mut steps = Vec::with_capacity(numbers.len());
        steps.push(first as i32);
        for row in self.forward.chunks_exact(relative.len()) {
            let sum = crate::spectrum::dot(row, &relative) / self.stored.step;
            steps.push(sum.round().clamp(-MOST, MOST) as i32);
        }
        Some(steps)
    }

    /// The numbers of a pixel's steps.
    pub fn numbers(&self, steps: &[i32], into: &mut [f32]) {
        let first = f64::from(steps[0]);
        let root = first * self.stored.dc_step;
        let unit = self.unit(first);
        into[0] = (root * root * root * self.stored.c_ref) as f32;
        let scaled: Vec<f64> = steps[1..]
            .iter()
            .map(|y| f64::from(*y) * self.stored.step)
            .collect();
        let rows = self.stored.inverse.chunks_exact(scaled.len());
        for ((value, row), mean) in into[1..].iter_mut().zip(rows).zip(&self.stored.mean) {
            *value = ((mean + crate::spectrum::dot(row, &scaled)) * unit) as f32;
        }
    }
}

impl Storage for Quantiser {
    fn kept(&self, numbers: &mut [f32], pixels: usize) {
        let count = self.stored.mean.len() + 1;
        let (mut pixel, mut back) = (vec![0.0; count], vec![0.0; count]);
        for i in 0..pixels {
            pixel
                .iter_mut()
                .enumerate()
                .for_each(|(n, z)| *z = f64::from(numbers[n * pixels + i]));
            match self.steps(&pixel) {
                Some(steps) => self.numbers(&steps, &mut back),
                None => back.fill(f32::NAN),
            }
            back.iter()
                .enumerate()
                .for_each(|(n, z)| numbers[n * pixels + i] = *z);
        }
    }
}

/// Metric for the effect of a unit of each number on the colour and spectrum of a grey.
fn metric(operator: &Operator, sample: &[Vec<f64>]) -> Result<DMatrix<f64>, PictureError> {
    let (count, bands) = (operator.numbers(), operator.bands());
    let series = operator.plan().series;
    let mut grey = vec![0.0; count];
    grey[0] = 1.0;
    for (n, value) in grey.iter_mut().enumerate().skip(series) {
        let mean = |k: usize| sample.iter().map(|z| z[k]).sum::<f64>();
        let (weight, first) = (mean(n), mean(0));
        *value = if first > 0.0 { weight / first } else { 0.0 };
    }
    let mut lights: Vec<Relit> = vec![operator.own_colour()];
    if bands.is_factor() {
        let others = [
            Some(Illuminant::equal_energy()),
            Illuminant::named("LED-RGB1"),
        ];
        for light in others.into_iter().flatten() {
            lights.extend(operator.relit(&light, None, Between::Bands).ok());
        }
    }
    let mut metric = DMatrix::zeros(count, count);
    for relit in &lights {
        let white: Xyz = relit.xyz(&grey);
        let to_lab = lab_by_xyz(white, 1.0) * matrix_of(&relit.rows);
        metric += to_lab.transpose() * to_lab / (ONE_COLOUR * ONE_COLOUR * lights.len() as f64);
    }
    let weights = DMatrix::from_diagonal(&DVector::from_column_slice(bands.weights_nm()));
    let spectrum = DVector::from_vec(operator.pixel_of(&grey));
    let power = (spectrum.transpose() * &weights * &spectrum)[(0, 0)];
    if !(power > 0.0 && power.is_finite()) {
        return Err(PictureError::AllZero);
    }
    metric += operator.decode.transpose() * weights * &operator.decode
        / (ONE_SPECTRUM * ONE_SPECTRUM * power);
    Ok(metric)
}
