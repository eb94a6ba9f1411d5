//! The fits behind an operator: D from a plan, E by least squares.

use std::f64::consts::PI;

use nalgebra::{DMatrix, DVector};

use super::light::emissive_weights;
use super::plan::{LEAST_NOISE, LineFit, Plan, ReferenceKind};
use super::{Bands, PictureError};

/// Ridge, as a share of the mean diagonal.
const RIDGE: f64 = 1e-9;
/// What weighs colours against the spectrum in the weighted fit, nm.
const COLOUR_NM: f64 = 3000.0;

/// A fit: E, and the inverse of its normal matrix.
pub(super) struct Fit {
    pub(super) encode: DMatrix<f64>,
    pub(super) inverse: DMatrix<f64>,
}

/// `cos(pi n (l - lo) / (hi - lo))` on the bands: B x N.
pub(super) fn cosines(nm: &[f64], [lo, hi]: [f64; 2], count: usize) -> DMatrix<f64> {
    DMatrix::from_fn(nm.len(), count, |j, n| {
        (PI * n as f64 * (nm[j] - lo) / (hi - lo)).cos()
    })
}

pub(super) fn columns(bands: &Bands, plan: &Plan, range_nm: [f64; 2]) -> DMatrix<f64> {
    let (one, two) = plan.shares();
    let waves = cosines(bands.nm(), range_nm, plan.series);
    DMatrix::from_fn(bands.len(), plan.numbers(), |j, n| {
        if n < one {
            plan.reference.values[j] * waves[(j, n)]
        } else if n < one + two {
            let second = plan.second.as_ref().map_or(0.0, |r| r.values[j]);
            second * waves[(j, n - one)]
        } else {
            plan.lines[n - one - two].shape[j]
        }
    })
}

pub(super) fn own_weights(bands: &Bands, plan: &Plan) -> Result<[Vec<f64>; 3], PictureError> {
    match &plan.own {
        Some(light) if bands.is_factor() => light.weights(bands, plan.observer),
        _ => {
            let known = plan.reference.kind == ReferenceKind::Light;
            let one = vec![1.0; bands.len()];
            let white = if known { &plan.reference.values } else { &one };
            let weights = emissive_weights(bands, plan.observer, white);
            // Bands beyond the visible have no colour, and none is kept exact.
            Ok(weights.unwrap_or_else(|_| std::array::from_fn(|_| vec![0.0; bands.len()])))
        }
    }
}

/// A ridge that makes a normal matrix safe, and its inverse.
fn inverse_of(mut normal: DMatrix<f64>) -> Result<DMatrix<f64>, PictureError> {
    let ridge = RIDGE * normal.trace() / normal.nrows() as f64;
    for i in 0..normal.nrows() {
        normal[(i, i)] += ridge;
    }
    normal
        .cholesky()
        .map(|c| c.inverse())
        .ok_or(PictureError::NotSolved)
}

pub(super) fn plain_fit(
    bands: &Bands,
    plan: &Plan,
    decode: &DMatrix<f64>,
) -> Result<Fit, PictureError> {
    let length = bands.length_nm();
    let mut metric = DMatrix::from_diagonal(&DVector::from_fn(bands.len(), |j, _| {
        bands.weights_nm()[j] / length
    }));
    if let (Some(weighting), true) = (&plan.weighting, bands.is_factor()) {
        metric += &weighting.gram * (COLOUR_NM / length);
    }
    if plan.line_fit == LineFit::Window && !plan.lines.is_empty() {
        return window_fit(bands, plan, decode, &metric);
    }
    let right = decode.transpose() * &metric;
    let inverse = inverse_of(&right * decode)?;
    Ok(Fit {
        encode: &inverse * right,
        inverse,
    })
}

/// Lines from their windows, the series on what they leave.
fn window_fit(
    bands: &Bands,
    plan: &Plan,
    decode: &DMatrix<f64>,
    metric: &DMatrix<f64>,
) -> Result<Fit, PictureError> {
    let (count, series, lines) = (bands.len(), plan.series, plan.lines.len());
    let (nm, weights) = (bands.nm(), bands.weights_nm());
    let mut of_lines = DMatrix::zeros(lines, count);
    for (row, line) in plan.lines.iter().enumerate() {
        let [first, last] = line.window;
        for j in first..=last {
            let t = (nm[j] - nm[first]) / (nm[last] - nm[first]).max(f64::MIN_POSITIVE);
            of_lines[(row, j)] += weights[j];
            of_lines[(row, first)] -= weights[j] * (1.0 - t);
            of_lines[(row, last)] -= weights[j] * t;
        }
    }
    let smooth = decode.columns(0, series).into_owned();
    let shapes = decode.columns(series, lines).into_owned();
    let right = smooth.transpose() * metric;
    let inverse_smooth = inverse_of(&right * &smooth)?;
    let left_over = DMatrix::identity(count, count) - shapes * &of_lines;
    let of_series = &inverse_smooth * right * left_over;
    let mut encode = DMatrix::zeros(series + lines, count);
    encode.rows_mut(0, series).copy_from(&of_series);
    encode.rows_mut(series, lines).copy_from(&of_lines);
    // Only the series is moved to make own colour exact: the weights were read off.
    let mut inverse = DMatrix::zeros(series + lines, series + lines);
    inverse
        .view_mut((0, 0), (series, series))
        .copy_from(&inverse_smooth);
    Ok(Fit { encode, inverse })
}

/// The regularised division by a known light (or two); `moments` say what reflectances usually do.
pub(super) fn lit_fit(
    bands: &Bands,
    plan: &Plan,
    decode: &DMatrix<f64>,
    moments: &[f64],
) -> Result<Fit, PictureError> {
    let largest = bands.weights_nm().iter().copied().fold(0.0, f64::max);
    let noise = if plan.noise.is_finite() {
        plan.noise.max(1e-6)
    } else {
        LEAST_NOISE
    };
    let per_noise = 1.0 / (largest * noise * noise);
    let right = DMatrix::from_fn(plan.numbers(), bands.len(), |n, j| {
        decode[(j, n)] * bands.weights_nm()[j] * per_noise
    });
    let mut normal = &right * decode;
    // A line beside a known light is free: no reflectance says how strong it is.
    for (i, moment) in moments.iter().enumerate() {
        normal[(i, i)] += 1.0 / moment;
    }
    let inverse = normal
        .cholesky()
        .map(|c| c.inverse())
        .ok_or(PictureError::NotSolved)?;
    Ok(Fit {
        encode: &inverse * right,
        inverse,
    })
}
