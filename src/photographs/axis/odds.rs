//! How surely the lines of an axis are a lamp's and not there by chance.

use super::{
    super::peaks::Peaks,
    refine::{Solution, table_for},
};

/// Weights of what speaks for an axis and against it: the constant, the logarithm of the number of
/// lines, the score for a line, the share of the lamp's light that is there, the mean square of
/// errors in their doubt, the curvature squared, the error of lines left out in nm, the span in
/// 100 nm, and the share of the peaks that are lines.
///
/// By logistic regression of 1,100 right answers and 460 wrong ones, a wrong one counted three
/// times: the best axes of drawn lamps, and of drawn lamps that no table knows. These were found
/// when the doubt of its own place alone weighted the error of a line left out; weights found anew
/// part right from wrong no better.
const WEIGHTS: [f64; 9] = [-29.6, 8.35, 1.5, 15.6, -4.3, -4.0, -0.9, -2.1, 8.0];
/// Errors beyond this many squared doubts count no more.
const MOST_ERROR: f64 = 3.0;
/// A landmark this near to a line of the axis is there, nm.
const THERE_NM: f64 = 3.0;
/// Range in which a lamp's light is expected, nm.
const EXPECTED_NM: (f64, f64) = (400.0, 690.0);

/// Log-odds of an axis.
pub(super) fn log_odds(solution: &Solution, peaks: &Peaks) -> f64 {
    let lines = solution.matches.len() as f64;
    if lines < 1.0 {
        return f64::MIN;
    }
    let errors = (solution.matches.iter()).map(|m| (m.error_nm / m.sigma_nm).powi(2));
    let error = (errors.sum::<f64>() / lines).min(MOST_ERROR);
    let (low, high) = solution.span_nm();
    let about = [
        1.0,
        lines.ln(),
        solution.score / lines,
        share_there(solution, peaks),
        error,
        solution.curve.curvature().powi(2),
        solution.left_out_rms_nm(),
        (high - low) / 100.0,
        lines / peaks.peaks.len() as f64,
    ];
    WEIGHTS.iter().zip(about).map(|(w, v)| w * v).sum()
}

/// The share of what a lamp shows in the range of an axis that is there.
fn share_there(solution: &Solution, peaks: &Peaks) -> f64 {
    let curve = &solution.curve;
    let width_nm = peaks.width_px * curve.c[1].abs() / curve.scale_px;
    let first = curve.centre_px - 0.5 * curve.scale_px;
    let ends = [curve.nm(first), curve.nm(first + curve.scale_px - 1.0)];
    let low = ends[0].min(ends[1]).max(EXPECTED_NM.0);
    let high = ends[0].max(ends[1]).min(EXPECTED_NM.1);
    let is_there = |nm: f64| solution.lines_nm().any(|l| (l - nm).abs() < THERE_NM);
    let (mut there, mut all) = (0.0, 0.0);
    for mark in &table_for(solution.lamp, width_nm).landmarks {
        if mark.is_clipped || mark.nm <= low || mark.nm >= high {
            continue;
        }
        let weight = mark.chance * mark.strength.min(0.5).sqrt();
        all += weight;
        if is_there(mark.nm) {
            there += weight;
        }
    }
    if all > 0.0 { there / all } else { 0.0 }
}
