//! The measurement that a column of a combination is: sigma, level, axis, memory and mask.

use super::{
    columns::{Column, Grid, OnGrid},
    error::MeasurementError,
    measurement::Measurement,
    quantity::Meaning,
};
use crate::spectrum::Sampled;

/// The measurement that a column is.
pub(super) fn finished(
    grid: &Grid,
    found: Column,
    meaning: &Meaning,
    mask: &[bool],
    why: &str,
) -> Result<Measurement, MeasurementError> {
    let has_sigma = grid.used().any(|(_, input)| input.of.sigma.is_some());
    let sigma = found.sigma(grid);
    let is_no_number = |i: usize| !found.values[i].is_finite() || !sigma[i].is_finite();
    let mask: Vec<bool> = (0..grid.nm.len())
        .map(|i| mask.get(i).copied().unwrap_or(false) || is_no_number(i))
        .collect();
    let or_zero = |values: &[f64]| -> Vec<f64> {
        let pairs = values.iter().zip(&mask);
        pairs
            .map(|(v, masked)| if *masked { 0.0 } else { *v })
            .collect()
    };
    let samples = Sampled::new(grid.nm.to_vec(), or_zero(&found.values))?;
    let mut result = Measurement::new(&meaning.text, meaning.quantity, &meaning.unit, samples);
    result.level = level(grid, &found, &mask);
    result.axis_nm = grid
        .used()
        .map(|(_, input)| input.of.axis_nm)
        .fold(0.0, f64::max);
    result.exposure_ms = meaning.exposure_ms;
    if has_sigma {
        result.memory = memory(grid, &found, &mask);
        result.sigma = Some(or_zero(&sigma));
    }
    let slits: Vec<_> = grid.used().map(|(_, input)| input.of.slit).collect();
    result.slit = slits[0].filter(|_| slits.iter().all(|slit| *slit == slits[0]));
    if mask.contains(&true) {
        result.mask = mask;
        result.why_masked = match why {
            "" => said!("No finite number").to_owned(),
            why => why.to_owned(),
        };
    }
    Ok(result)
}

/// Relative error of the result's total by the common factors of the inputs.
fn level(grid: &Grid, found: &Column, mask: &[bool]) -> f64 {
    let total = |of: &dyn Fn(usize) -> f64| -> f64 {
        (0..grid.nm.len())
            .filter(|i| !mask[*i])
            .map(|i| width(grid.nm, i) * of(i))
            .sum()
    };
    let whole = total(&|i| found.values[i].abs());
    let part = |(index, input): (usize, &OnGrid)| {
        let slopes = found.slopes[index]
            .as_ref()
            .map(|slopes| total(&|i| slopes[i] * input.values[i]));
        (input.of.level * slopes.unwrap_or(0.0)).powi(2)
    };
    let squares: f64 = grid.used().map(part).sum();
    if whole > 0.0 {
        squares.sqrt() / whole
    } else {
        0.0
    }
}

/// The stretch that a point stands for, nm.
fn width(nm: &[f64], i: usize) -> f64 {
    0.5 * (nm[(i + 1).min(nm.len() - 1)] - nm[i.saturating_sub(1)])
}

/// Least correlation that is kept.
const LEAST_MEMORY: f64 = 0.01;

/// Correlation of the noise of neighbouring points of the result: points between samples share
/// the noise of both, samples have the memory that they had.
fn memory(grid: &Grid, found: &Column, mask: &[bool]) -> Vec<f64> {
    let weight = |(index, input): (usize, &OnGrid)| -> f64 {
        let slopes = found.slopes[index].as_ref();
        let squares = slopes.map(|slopes| {
            let kept = (0..mask.len()).filter(|i| !mask[*i]);
            kept.map(|i| (slopes[i] * input.sigma[i]).powi(2)).sum()
        });
        squares.unwrap_or(0.0)
    };
    let weights: Vec<(f64, &OnGrid)> = grid
        .used()
        .map(|(i, input)| (weight((i, input)), input))
        .collect();
    let all: f64 = weights.iter().map(|(weight, _)| weight).sum();
    if all <= 0.0 {
        return Vec::new();
    }
    let of_input = |input: &OnGrid, lag: usize| {
        let lag = lag as f64 / input.points_a_sample;
        let rho = |k: usize| match k {
            0 => 1.0,
            k => input.of.memory.get(k - 1).copied().unwrap_or(0.0),
        };
        let (below, share) = (lag as usize, lag.fract());
        rho(below) * (1.0 - share) + rho(below + 1) * share
    };
    let at = |lag: usize| -> f64 {
        weights
            .iter()
            .map(|(weight, input)| weight * of_input(input, lag))
            .sum::<f64>()
            / all
    };
    (1..grid.nm.len())
        .map(at)
        .take_while(|rho| *rho > LEAST_MEMORY)
        .collect()
}
