//! Lines that noise cannot make, and the order at which a series begins to draw the noise.
//!
//! The detector asks for eight standard deviations of the second differences, which see white noise
//! alone: an instrument that smooths its tables makes lines of noise. Two tests stop that. Noise
//! makes as many dips as peaks, so that a line must stand twice as high as the deepest narrow dip but
//! one near it: noise makes many, a lamp's own dip between two strong lines is alone. And where scans
//! tell sigma and memory, the line's weight must be six of its own doubts.

use nalgebra::{DMatrix, DVector};

use super::{measurement::Measurement, on_nm::OnWholeNm};
use crate::spectrum::{
    Band, Basis, BasisTable, Decomposition, GAUSSIAN_AREA, SpikeSettings, detect, detect_shapes,
    gaussian, narrow_dips, numbers_of_order,
};

/// A line is so many times as high as the deepest dip but one near it.
const MIRROR: f64 = 2.0;
/// Reach of "near it", nm.
const NEAR_NM: f64 = 100.0;
/// Least weight of a line in its doubts.
const LEAST_WEIGHT: f64 = 6.0;
/// Window of the weight test: so many widths, and nm more, to either side.
const WINDOW: [f64; 2] = [2.2, 3.0];
/// Least fall of chi squared for two numbers of a series.
const LEAST_FALL: f64 = 13.8;
/// Pairs of numbers looked ahead.
const AHEAD: usize = 3;
/// Highest order that is asked for.
pub const MOST_ORDER: usize = 40;

/// What the detector finds, without the lines that noise may have made.
pub(super) fn lines_above_noise(
    band: Band,
    on_nm: &OnWholeNm,
    settings: SpikeSettings,
) -> Decomposition {
    let (mut found, shapes) = detect_shapes(band, &on_nm.values, settings);
    if settings.dips || on_nm.sigma.iter().all(|s| *s == 0.0) {
        return found;
    }
    let dips = narrow_dips(band, &found.smooth, settings.max_width_nm);
    let windows: Vec<[f64; 2]> = found.spikes.iter().map(|s| s.window_nm).collect();
    let is_free = |nm: f64| !windows.iter().any(|w| (w[0]..=w[1]).contains(&nm));
    let deep = |at: f64| {
        let near = dips
            .iter()
            .filter(|(nm, _)| (nm - at).abs() <= NEAR_NM && is_free(*nm));
        let two = near.fold([0.0, 0.0], |[most, next]: [f64; 2], (_, depth)| {
            [most.max(*depth), next.max(most.min(*depth))]
        });
        two[1]
    };
    let (kept, gone): (Vec<_>, Vec<_>) = found.spikes.iter().partition(|line| {
        let height = line.spike.weight / (GAUSSIAN_AREA * line.width_nm);
        let is_heavy = || {
            let (weight, u) = weight_of(on_nm, line.spike.at_nm, line.width_nm);
            weight >= LEAST_WEIGHT * u
        };
        height >= MIRROR * deep(line.spike.at_nm) && (!on_nm.is_of_scans || is_heavy())
    });
    found.spikes = kept;
    for line in gone {
        if let Some(shape) = shapes.iter().find(|shape| shape.spike == line.spike) {
            shape.give_back_to(&mut found.smooth);
        }
    }
    found
}

/// Weight of a line of this place and width above a local parabola, and its standard uncertainty.
pub(super) fn weight_of(on_nm: &OnWholeNm, at_nm: f64, width_nm: f64) -> (f64, f64) {
    let width = width_nm.max(1.0);
    let reach = WINDOW[0] * width + WINDOW[1];
    let index = at_nm - f64::from(on_nm.first_nm);
    let first = (index - reach).ceil().max(0.0) as usize;
    let last = ((index + reach).floor() as usize).min(on_nm.values.len() - 1);
    let points = last + 1 - first.min(last);
    if points < 6 {
        return (0.0, f64::INFINITY);
    }
    let most = on_nm.sigma[first..=last]
        .iter()
        .copied()
        .fold(0.0, f64::max);
    let inverse = |i: usize| match most > 0.0 {
        true => on_nm.sigma[first + i].max(1e-3 * most).recip(),
        false => 1.0,
    };
    let row = |i: usize| {
        let away = (first + i) as f64 - index;
        let x = away / reach;
        [
            gaussian(away / width) / (GAUSSIAN_AREA * width),
            1.0,
            x,
            x * x,
        ]
    };
    let design = DMatrix::from_fn(points, 4, |i, k| row(i)[k] * inverse(i));
    let values = DVector::from_fn(points, |i, _| on_nm.values[first + i] * inverse(i));
    let Some(solver) = (design.transpose() * &design).try_inverse() else {
        return (0.0, f64::INFINITY);
    };
    let weights = solver.row(0) * design.transpose();
    let weight = (&weights * values)[0];
    let own: Vec<f64> = (0..points).map(|i| weights[i] * inverse(i)).collect();
    (weight, on_nm.doubt_of(first, &own))
}

/// The lines that the detector finds and that noise may have made: place, nm, and share of the power,
/// in 0-1; none where no noise is known.
pub fn lines_of_the_noise(
    of: &Measurement,
    band: Band,
    settings: SpikeSettings,
) -> Vec<(f64, f64)> {
    if of.sigma.is_none() {
        return Vec::new();
    }
    let on_nm = OnWholeNm::of(of, band.min_nm() as u32, band.max_nm() as u32);
    let all = detect(band, &on_nm.values, settings);
    let kept = lines_above_noise(band, &on_nm, settings).spikes;
    let of_noise = all.spikes.iter().filter(|line| !kept.contains(line));
    let told = of_noise.map(|line| (line.spike.at_nm, line.spike.weight / all.power));
    told.filter(|(_, share)| share.is_finite()).collect()
}

/// The order of a series from which on more numbers draw the noise of a light and no longer the
/// light: pairs of numbers are bought while chi squared falls by enough for one, two or three of
/// them at once. `None` where no noise is known.
pub fn order_of_the_noise(of: &Measurement, band: Band, basis: Basis) -> Option<usize> {
    of.sigma.as_ref()?;
    let on_nm = OnWholeNm::of(of, band.min_nm() as u32, band.max_nm() as u32);
    let smooth = lines_above_noise(band, &on_nm, SpikeSettings::default()).smooth;
    let table = BasisTable::new(band, basis, numbers_of_order(MOST_ORDER));
    let coefficients = table.project(&smooth, table.numbers());
    let doubts = doubts_on(&on_nm, &table, band, basis);
    let projections: Vec<(f64, f64)> = coefficients.into_iter().zip(doubts).collect();
    Some(bought(&projections))
}

/// Standard uncertainties of the first numbers of a series of a light, in the unit of its values.
/// `None` where no noise is known.
pub fn doubts_of_numbers(
    of: &Measurement,
    band: Band,
    basis: Basis,
    numbers: usize,
) -> Option<Vec<f64>> {
    of.sigma.as_ref()?;
    let on_nm = OnWholeNm::of(of, band.min_nm() as u32, band.max_nm() as u32);
    let table = BasisTable::new(band, basis, numbers);
    Some(doubts_on(&on_nm, &table, band, basis))
}

fn doubts_on(on_nm: &OnWholeNm, table: &BasisTable, band: Band, basis: Basis) -> Vec<f64> {
    let doubt = |k: usize| {
        let row = table.row(k).iter().enumerate();
        let norm = basis.norm_squared(k, band);
        let weights: Vec<f64> = row.map(|(i, f)| f * band.weight(i) / norm).collect();
        on_nm.doubt_of(0, &weights)
    };
    (0..table.numbers()).map(doubt).collect()
}

/// Pairs of numbers behind the first that pay; each with its standard uncertainty.
fn bought(projections: &[(f64, f64)]) -> usize {
    let fall = |pair: usize| -> f64 {
        let at = |k: usize| {
            projections.get(k).map_or(0.0, |(c, u)| match *u > 0.0 {
                true => (c / u).powi(2),
                false => f64::INFINITY,
            })
        };
        at(2 * pair + 1) + at(2 * pair + 2)
    };
    let pairs = projections.len().saturating_sub(1) / 2;
    let mut bought = 0;
    while bought < pairs {
        let step = (1..=AHEAD).find(|ahead| {
            let all: f64 = (bought..bought + ahead).map(fall).sum();
            bought + ahead <= pairs && all > LEAST_FALL * *ahead as f64
        });
        match step {
            Some(step) => bought += step,
            None => break,
        }
    }
    bought
}
