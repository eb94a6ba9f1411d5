//! The fits behind an operator: D from a plan, E by least squares.

use std::f64::consts::PI;

use nalgebra::DMatrix;

use super::light::{Rows, emissive_weights};
use super::plan::{Plan, ReferenceKind, Weighting};
use super::{Bands, PictureError};

/// Ridge, as a share of the mean diagonal: it bounds the condition by about 1e9, which leaves seven
/// of sixteen digits, and shifts what the bands do tell by no more than 1e-9.
const RIDGE: f64 = 1e-9;
/// Weight of colours against the spectrum in the weighted fit, nm: a colour that is off by .001
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

pub(super) fn own_weights(bands: &Bands, plan: &Plan) -> Result<Rows, PictureError> {
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

/// The least squares of the bands, weighted with colours where there are any.
pub(super) fn plain_fit(
    bands: &Bands,
    weighting: Option<&Weighting>,
    columns: &DMatrix<f64>,
) -> Result<Fit, PictureError> {
    let length = bands.length_nm();
    let mut right = columns.transpose();
    for (mut row, weight) in right.column_iter_mut().zip(bands.weights_nm()) {
        row *= weight / length;
    }
    // It takes no number for each pair of bands, of which tables have many.
    if let Some(weighting) = weighting {
        let colours = &weighting.rows * columns;
        right += colours.transpose() * &weighting.rows * (COLOUR_NM / length);
    }
    let mut normal = &right * columns;
    let ridge = RIDGE * normal.trace() / normal.nrows() as f64;
    for i in 0..normal.nrows() {
        normal[(i, i)] += ridge;
    }
    solved(normal, right)
}

/// The regularised division by what lit the bands: their noise, and `moments` that say what the
/// first numbers usually are. The others are free: no reflectance says how strong a line is.
pub(super) fn lit_fit(
    bands: &Bands,
    columns: &DMatrix<f64>,
    moments: &[f64],
    noise: f64,
) -> Result<Fit, PictureError> {
    let largest = bands.weights_nm().iter().copied().fold(0.0, f64::max);
    let per_noise = 1.0 / (largest * noise * noise);
    let right = DMatrix::from_fn(columns.ncols(), bands.len(), |n, j| {
        columns[(j, n)] * bands.weights_nm()[j] * per_noise
    });
    let mut normal = &right * columns;
    for (i, moment) in moments.iter().enumerate() {
        normal[(i, i)] += 1.0 / moment;
    }
    solved(normal, right)
}

fn solved(normal: DMatrix<f64>, right: DMatrix<f64>) -> Result<Fit, PictureError> {
    let factors = normal.cholesky().ok_or(PictureError::NotSolved)?;
    let inverse = factors.inverse();
    Ok(Fit {
        encode: &inverse * right,
        inverse,
    })
}
