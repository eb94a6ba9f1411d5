//! Masks of points lost in the noise: quotients over a reference in the dark.

use super::columns::{Column, Grid};

/// Samples whose mean is held against the noise of a divisor.
const AROUND: usize = 5;

/// Least value of that mean, in its sigmas.
const LEAST_SIGMAS: f64 = 10.0;

/// True where the mean of 11 samples of a divisor is below 10 of its sigmas.
pub(super) fn in_the_dark(r: &Column, grid: &Grid) -> Vec<bool> {
    is_dark(&r.values, &r.sigma(grid))
}

/// True where the mean of 11 values is below 10 of their sigmas. The mean, not the value: masking by
/// the noisy sample itself keeps the lucky ones.
pub(super) fn is_dark(values: &[f64], sigma: &[f64]) -> Vec<bool> {
    let is_dark = |i: usize| {
        let near = &values[i.saturating_sub(AROUND)..(i + AROUND + 1).min(values.len())];
        let mean = near.iter().sum::<f64>() / near.len() as f64;
        // A divisor that may as well be negative is one, noise or not.
        mean.is_nan() || mean <= 0.0 || mean < LEAST_SIGMAS * sigma[i] || values[i] == 0.0
    };
    (0..values.len()).map(is_dark).collect()
}

/// True where a quotient's doubt, noise and axis together, exceeds `most`.
pub(super) fn doubtful(t: &Column, r: &Column, grid: &Grid, most: f64) -> Vec<bool> {
    let axis_nm = grid
        .used()
        .map(|(_, input)| input.of.axis_nm)
        .fold(0.0, f64::max);
    let sigma = t.sigma(grid);
    let (nm, last) = (grid.nm, grid.nm.len() - 1);
    let is_doubtful = |i: usize| {
        let (left, right) = (i.saturating_sub(1), (i + 1).min(last));
        let slope = (r.values[right] - r.values[left]) / (nm[right] - nm[left]);
        let of_axis = t.values[i] * slope / r.values[i] * std::f64::consts::SQRT_2 * axis_nm;
        let doubt = sigma[i].hypot(of_axis);
        doubt.is_nan() || doubt > most
    };
    (0..nm.len()).map(is_doubtful).collect()
}

/// Points of the bare union without a value, and the reason.
pub(super) struct Mask {
    pub points: Vec<bool>,
    pub why: String,
}

impl Mask {
    /// Mask of the inputs themselves.
    pub(super) fn new(grid: &Grid) -> Self {
        let mut mask = Self {
            points: vec![false; grid.nm.len()],
            why: String::new(),
        };
        for (_, input) in grid.used() {
            let why = match input.of.why_masked.as_str() {
                "" => said!("An input has no value"),
                why => why,
            };
            mask.add(input.masked.clone(), why);
        }
        mask
    }

    pub(super) fn add(&mut self, points: Vec<bool>, why: &str) {
        if points.contains(&true) && self.why.is_empty() {
            why.clone_into(&mut self.why);
        }
        self.points
            .iter_mut()
            .zip(points)
            .for_each(|(a, b)| *a |= b);
    }

    /// The same for a finer grid: a piece holds a value where both its ends do.
    pub(super) fn on(&self, nm: &[f64], fine: &[f64]) -> Vec<bool> {
        let place = |at: &f64| {
            let right = nm.partition_point(|nm| nm < at).min(nm.len() - 1);
            self.points[right] || nm[right] != *at && right > 0 && self.points[right - 1]
        };
        fine.iter().map(place).collect()
    }
}
