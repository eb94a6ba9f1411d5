//! The fits behind an operator: D from a plan, E by least squares.

use std::f64::consts::PI;

use nalgebra::DMatrix;

use super::light::emissive_weights;
use super::plan::{LEAST_NOISE, LineFit, Plan, ReferenceKind};
use super::{Bands, PictureError};

/// Ridge, as a share of the mean diagonal: it bounds the condition by about 1e9, which leaves seven
/// of sixteen digits, and shifts what the bands do tell by no more than 1e-9.
const RIDGE: f64 = 1e-9;
/// What weighs colours against the spectrum in the weighted fit, nm: a colour that is off by .001
/// of white in X, Y and Z counts as an rms of `sqrt(3000 x 3e-6)`, .095. The one value tried: with
/// it 1269 Munsell chips under 318 lamps, none of them weighed, came to .30 / .87 (mean, 95 %) from
/// the plain fit's .34 / 1.07 with 11 numbers.
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
    if plan.line_fit == LineFit::Window && !plan.lines.is_empty() {
        return window_fit(bands, plan, decode);
    }
    let right = weighed(bands, plan, decode);
    let inverse = inverse_of(&right * decode)?;
    Ok(Fit {
        encode: &inverse * right,
        inverse,
    })
}

/// Columns as rows times the metric of the bands: their lengths, and what weighs colours. It takes no
/// number for each pair of bands, of which tables have many.
fn weighed(bands: &Bands, plan: &Plan, columns: &DMatrix<f64>) -> DMatrix<f64> {
    let length = bands.length_nm();
    let mut rows = columns.transpose();
    for (mut row, weight) in rows.column_iter_mut().zip(bands.weights_nm()) {
        row *= weight / length;
    }
    if let (Some(weighting), true) = (&plan.weighting, bands.is_factor()) {
        let colours = &weighting.rows * columns;
        rows += colours.transpose() * &weighting.rows * (COLOUR_NM / length);
    }
    rows
}

/// Lines from their windows, the series on what they leave.
fn window_fit(bands: &Bands, plan: &Plan, decode: &DMatrix<f64>) -> Result<Fit, PictureError> {
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
    let right = weighed(bands, plan, &smooth);
    let inverse_smooth = inverse_of(&right * &smooth)?;
    let of_all = &inverse_smooth * right;
    let of_series = &of_all - (&of_all * shapes) * &of_lines;
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
