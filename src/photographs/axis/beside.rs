//! Axes beside an axis: the same by the landmarks of another slit, or with other lines at an end.
//!
//! A wider slit joins lines that a narrower one parts, and the width of the lines tells the slit only
//! nearly. Beyond its last lines a curve is free to bend to the next landmark, and the axes that pairs
//! of strong peaks suggest need not hold the one that bends to another.

use std::ops::Range;

use super::{
    Scene,
    curve::{Curve, Degree, Point},
    refine::{Match, Solution, again, table_for},
};

/// Largest number of outermost lines that are taken for others together.
const MOST_LINES: usize = 3;
/// Fewest lines that stay.
const LEAST_LEFT: usize = 3;
/// Standard deviations of the place within which a landmark may be meant.
const REACH: f64 = 3.0;
/// The least and the largest reach, nm.
const REACH_NM: (f64, f64) = (8.0, 40.0);
/// Slits up to this ratio from the width of the lines may be meant.
const SLITS: f64 = 1.3;

/// Axes beside one.
pub(super) fn others(scene: &Scene, of: &Solution) -> Vec<Solution> {
    let count = of.matches.len();
    let most = MOST_LINES.min(count.saturating_sub(LEAST_LEFT));
    let width_nm = scene.width_nm(&of.curve);
    let may_be = |slit_nm: f64| (slit_nm / width_nm).ln().abs() < SLITS.ln();
    let tables = of.lamp.tables().iter().filter(|t| may_be(t.slit_nm));
    let mut found: Vec<Solution> = tables
        .filter_map(|table| again(scene, of.lamp, of.curve, &table.landmarks))
        .collect();
    for taken in 1..=most {
        for kept in [taken..count, 0..count - taken] {
            found.extend(with_other_end(scene, of, kept));
        }
    }
    found
}

/// Axes through the lines that are kept and one pair of a peak and a landmark beyond them.
fn with_other_end(scene: &Scene, of: &Solution, kept: Range<usize>) -> Vec<Solution> {
    let peaks = &scene.peaks.peaks;
    let slope = of.curve.c[1];
    let point = |m: &Match| Point {
        px: peaks[m.peak].px,
        nm: m.landmark.nm,
        sigma_nm: m.sigma_nm,
    };
    let mut points: Vec<Point> = of.matches[kept.clone()].iter().map(point).collect();
    let Some((rest, _)) = Curve::fit(&points, scene.columns, slope, Degree::Cubic) else {
        return Vec::new();
    };
    let beyond = if kept.start > 0 {
        0..of.matches[kept.start].peak
    } else {
        of.matches[kept.end - 1].peak + 1..peaks.len()
    };
    let table = table_for(of.lamp, scene.width_nm(&of.curve));
    let is_old = |peak: usize, nm: f64| {
        let mut matches = of.matches.iter();
        matches.any(|m| m.peak == peak && m.landmark.nm == nm)
    };
    let mut found = Vec::new();
    for i in beyond {
        let peak = peaks[i];
        let nm = rest.nm(peak.px);
        let reach = (REACH * rest.sigma(peak.px)).clamp(REACH_NM.0, REACH_NM.1);
        for mark in &table.landmarks {
            let may_be = (mark.nm - nm).abs() < reach
                && mark.is_clipped <= peak.is_clipped
                && !is_old(i, mark.nm);
            if !may_be {
                continue;
            }
            points.push(Point {
                px: peak.px,
                nm: mark.nm,
                sigma_nm: mark
                    .scatter_nm
                    .hypot(peak.error_px * rest.slope(peak.px).abs()),
            });
            let curve = Curve::fit(&points, scene.columns, slope, Degree::Quadratic);
            points.pop();
            found.extend(
                curve.and_then(|(curve, _)| again(scene, of.lamp, curve, &table.landmarks)),
            );
        }
    }
    found
}
