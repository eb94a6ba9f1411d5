//! Two ranges of one light, measured one by one, as one light.
//!
//! Over the overlap the second part is brought to the first: `a = exp(c0 + c1 x) b(nm + d)`, by
//! least squares that no outlier pulls (Huber). The level is always taken; a shift only where a
//! line stands in both, since a smooth curve tells none; a slope only where the shift is known so,
//! or the axis is stated to be sound, since a slope imitates a shift.

use super::{
    error::MeasurementError,
    measurement::{Measurement, letter},
    noise::noise_of,
    union::Union,
};
use crate::{
    languages::{fixed, with_sign},
    spectrum::{Band, Outside, Sampled, SpikeSettings, detect},
};

/// Least overlap, nm.
const LEAST_OVERLAP_NM: f64 = 20.0;
/// Margin left out at each end of the overlap, nm.
const ENDS_NM: f64 = 2.0;
/// Residuals from so many sigmas on count less.
const HUBER: f64 = 3.0;
/// Largest distance between a line of one part and the same line of the other, nm.
const SAME_LINE_NM: f64 = 1.5;
/// Least ratio of a slope to its uncertainty.
const SLOPE: f64 = 3.0;
/// Most uncertainty of level and slope.
const MOST_U: f64 = 0.01;
/// Largest shift that is believed, nm.
const MOST_SHIFT_NM: f64 = 1.5;
/// Rounds of the fit.
const ROUNDS: usize = 30;

/// Two ranges as one, and how the second was brought to the first.
#[derive(Clone, Debug, PartialEq)]
pub struct Spliced {
    /// The whole.
    pub result: Measurement,
    /// Factor applied to the second part, in the middle of the overlap.
    pub factor: f64,
    /// Its relative standard uncertainty.
    pub u: f64,
    /// Change of the logarithm of that factor from the middle of the overlap to its end; 0 where
    /// none was taken.
    pub slope: f64,
    /// Shift applied to the second part, nm; 0 where no line determines it.
    pub shift_nm: f64,
    /// The overlap, nm.
    pub overlap_nm: [f64; 2],
}

/// Parameters free in the fit besides the level, which always is.
#[derive(Clone, Copy, Debug)]
struct Free {
    slope: bool,
    shift: bool,
}

/// Level, slope and shift with their uncertainties.
#[derive(Clone, Copy, Debug)]
struct Fitted {
    values: [f64; 3],
    u: [f64; 3],
}

/// The first part and the second, brought to it, as one.
///
/// # Errors
/// A sentence where they share less than 20 nm or the overlap is too dark.
pub fn splice(
    first: &Measurement,
    second: &Measurement,
    axis_is_sound: bool,
) -> Result<Spliced, MeasurementError> {
    if first.quantity != second.quantity {
        return Err(MeasurementError::Meaningless(tr!(
            "A is {first} and B {second}: ranges of one light are of one quantity.",
            first = first.quantity,
            second = second.quantity
        )));
    }
    let overlap = overlap_of([first, second])?;
    let inside = [overlap[0] + ENDS_NM, overlap[1] - ENDS_NM];
    let fit = Overlap::new(first, second, inside)?;
    let has_line = share_a_line(first, second, overlap);
    let mut free = Free {
        slope: false,
        shift: has_line,
    };
    let mut found = fit.fitted(free)?;
    if has_line || axis_is_sound {
        free.slope = true;
        let with_slope = fit.fitted(free)?;
        if with_slope.values[1].abs() > SLOPE * with_slope.u[1] && with_slope.u[1] <= MOST_U {
            found = with_slope;
        }
    }
    let worst = found.u[0].max(found.u[1]);
    if worst.is_nan() || worst > MOST_U {
        return Err(MeasurementError::AllMasked(tr!(
            "The overlap is too dark: the level of the second part is known to {doubt} % only.",
            doubt = fixed((100.0 * worst).min(999.0).ceil(), 0)
        )));
    }
    let [level, slope, shift_nm] = found.values;
    Ok(Spliced {
        result: joined(first, second, overlap, found.values)?,
        factor: level.exp(),
        u: found.u[0],
        slope,
        shift_nm,
        overlap_nm: overlap,
    })
}

/// Range in which both parts have values.
fn overlap_of(parts: [&Measurement; 2]) -> Result<[f64; 2], MeasurementError> {
    let from = parts.map(|m| m.samples.first_nm());
    let to = parts.map(|m| m.samples.last_nm());
    let overlap = [from[0].max(from[1]), to[0].min(to[1])];
    let shared = overlap[1] - overlap[0];
    if shared >= LEAST_OVERLAP_NM {
        return Ok(overlap);
    }
    let (lower, upper) = if from[0] <= from[1] { (0, 1) } else { (1, 0) };
    let nm = |nm: f64| with_sign(nm.to_string());
    let (first, second) = (letter(lower), letter(upper));
    let (end, begin) = (nm(to[lower]), nm(from[upper]));
    Err(MeasurementError::Apart(match shared > 0.0 {
        true => tr!(
            "{first} ends at {end} nm and {second} begins at {begin} nm: they share {shared} nm; \
             {least} are needed.",
            first,
            end,
            second,
            begin,
            shared = nm(shared),
            least = nm(LEAST_OVERLAP_NM)
        ),
        false => tr!(
            "{first} ends at {end} nm and {second} begins at {begin} nm: they share no \
             wavelengths.",
            first,
            end,
            second,
            begin
        ),
    }))
}

/// True if both parts have a line at the same place within the overlap.
fn share_a_line(first: &Measurement, second: &Measurement, overlap: [f64; 2]) -> bool {
    let Ok(band) = Band::new(overlap[0].ceil(), overlap[1].floor()) else {
        return false;
    };
    let lines = |m: &Measurement| -> Vec<f64> {
        let values = m.samples.on_band(band, Outside::Hold);
        let found = detect(band, &values, SpikeSettings::default());
        let inside = found.spikes.iter().map(|s| s.spike.at_nm);
        inside
            .filter(|nm| *nm > overlap[0] + ENDS_NM && *nm < overlap[1] - ENDS_NM)
            .collect()
    };
    let (a, b) = (lines(first), lines(second));
    a.iter()
        .any(|a| b.iter().any(|b| (a - b).abs() <= SAME_LINE_NM))
}

/// Both parts in the overlap.
struct Overlap<'m> {
    nm: Vec<f64>,
    /// From -1 at its beginning to 1 at its end.
    x: Vec<f64>,
    first: Vec<f64>,
    sigma: [Vec<f64>; 2],
    second: &'m Sampled,
}

impl<'m> Overlap<'m> {
    fn new(
        first: &Measurement,
        second: &'m Measurement,
        inside: [f64; 2],
    ) -> Result<Self, MeasurementError> {
        // The samples of the first: points between them would count its noise twice.
        let union = Union::of(&[first, second], false)?;
        let is_inside = |nm: &&f64| (inside[0]..=inside[1]).contains(*nm);
        let own = first.samples.nm().iter().filter(is_inside);
        let mut nm: Vec<f64> = own.copied().collect();
        if nm.len() < 4 {
            nm = union.nm.iter().filter(is_inside).copied().collect();
        }
        let [middle, half] = [0.5 * (inside[0] + inside[1]), 0.5 * (inside[1] - inside[0])];
        let sigma_of = |m: &Measurement| -> Vec<f64> {
            let own = m.sigma.clone().or_else(|| noise_of(&m.samples));
            let own = own.and_then(|sigma| m.samples.sharing(sigma).ok());
            nm.iter()
                .map(|at| own.as_ref().map_or(0.0, |s| s.at(*at, Outside::Hold)))
                .collect()
        };
        Ok(Self {
            x: nm.iter().map(|nm| (nm - middle) / half).collect(),
            first: nm
                .iter()
                .map(|at| first.samples.at(*at, Outside::Hold))
                .collect(),
            sigma: [sigma_of(first), sigma_of(second)],
            second: &second.samples,
            nm,
        })
    }

    fn fitted(&self, free: Free) -> Result<Fitted, MeasurementError> {
        let dark = || {
            MeasurementError::AllMasked(
                said!("The overlap is too dark: the level of the second part is not known.")
                    .to_owned(),
            )
        };
        let second = |at: f64, d: f64| self.second.at(at + d, Outside::Hold);
        let points = self.nm.len();
        let start: [f64; 2] = [
            (0..points)
                .map(|i| self.first[i] * second(self.nm[i], 0.0))
                .sum(),
            (0..points).map(|i| second(self.nm[i], 0.0).powi(2)).sum(),
        ];
        let ratio = start[0] / start[1];
        if !ratio.is_finite() || ratio <= 0.0 {
            return Err(dark());
        }
        let mut values = [ratio.ln(), 0.0, 0.0];
        let which: Vec<usize> = [true, free.slope, free.shift]
            .iter()
            .enumerate()
            .filter_map(|(k, is_free)| is_free.then_some(k))
            .collect();
        let highest = self.first.iter().fold(0.0_f64, |top, v| top.max(v.abs()));
        let mut u = [0.0; 3];
        for _ in 0..ROUNDS {
            let [level, slope, shift] = values;
            let mut normal = vec![vec![0.0; which.len()]; which.len()];
            let mut right = vec![0.0; which.len()];
            for i in 0..points {
                let factor = (level + slope * self.x[i]).exp();
                let model = factor * second(self.nm[i], shift);
                let sigma = self.sigma[0][i]
                    .hypot(factor * self.sigma[1][i])
                    .max(1e-9 * highest);
                let off = (self.first[i] - model) / sigma;
                let weight = (HUBER / off.abs()).min(1.0) / (sigma * sigma);
                let along = factor
                    * 0.5
                    * (second(self.nm[i], shift + 0.5) - second(self.nm[i], shift - 0.5))
                    * 2.0;
                let slopes = [model, model * self.x[i], along];
                for (a, p) in which.iter().enumerate() {
                    right[a] += weight * slopes[*p] * (self.first[i] - model);
                    for (b, q) in which.iter().enumerate() {
                        normal[a][b] += weight * slopes[*p] * slopes[*q];
                    }
                }
            }
            let inverse = inverse(&normal).ok_or_else(dark)?;
            let mut largest = 0.0_f64;
            for (a, p) in which.iter().enumerate() {
                let step: f64 = (0..which.len()).map(|b| inverse[a][b] * right[b]).sum();
                values[*p] += step;
                u[*p] = inverse[a][a].max(0.0).sqrt();
                largest = largest.max(step.abs());
            }
            values[2] = values[2].clamp(-MOST_SHIFT_NM, MOST_SHIFT_NM);
            if largest < 1e-12 {
                break;
            }
        }
        match values.iter().chain(&u).all(|v| v.is_finite()) {
            true => Ok(Fitted { values, u }),
            false => Err(dark()),
        }
    }
}

/// The inverse of a small symmetric matrix; `None` where it has none.
fn inverse(matrix: &[Vec<f64>]) -> Option<Vec<Vec<f64>>> {
    let n = matrix.len();
    let mut a: Vec<Vec<f64>> = matrix.to_vec();
    let unit = |i: usize| (0..n).map(|j| f64::from(u8::from(i == j))).collect();
    let mut b: Vec<Vec<f64>> = (0..n).map(unit).collect();
    for k in 0..n {
        let pivot = (k..n).max_by(|i, j| a[*i][k].abs().total_cmp(&a[*j][k].abs()))?;
        a.swap(k, pivot);
        b.swap(k, pivot);
        let by = a[k][k];
        if by == 0.0 || !by.is_finite() {
            return None;
        }
        for j in 0..n {
            a[k][j] /= by;
            b[k][j] /= by;
        }
        for i in (0..n).filter(|i| *i != k) {
            let share = a[i][k];
            for j in 0..n {
                a[i][j] -= share * a[k][j];
                b[i][j] -= share * b[k][j];
            }
        }
    }
    Some(b)
}

/// Both parts on the union of their grids, cross-faded over the overlap.
fn joined(
    first: &Measurement,
    second: &Measurement,
    overlap: [f64; 2],
    [level, slope, shift_nm]: [f64; 3],
) -> Result<Measurement, MeasurementError> {
    let [middle, half] = [
        0.5 * (overlap[0] + overlap[1]),
        0.5 * (overlap[1] - overlap[0]) - ENDS_NM,
    ];
    // Held beyond the overlap, where nothing tells it.
    let factor = |nm: f64| (level + slope * ((nm - middle) / half).clamp(-1.0, 1.0)).exp();
    let second_nm: Vec<f64> = second.samples.nm().iter().map(|nm| nm - shift_nm).collect();
    let mut nm: Vec<f64> = first
        .samples
        .nm()
        .iter()
        .chain(&second_nm)
        .copied()
        .collect();
    nm.sort_by(f64::total_cmp);
    nm.dedup_by(|later, earlier| *later - *earlier < 1e-6);
    let moved = Sampled::new(second_nm, second.samples.values().to_vec())?;
    let sigma = |m: &Measurement, axis: &Sampled| {
        m.sigma.as_ref().and_then(|s| axis.sharing(s.clone()).ok())
    };
    let sigmas = [sigma(first, &first.samples), sigma(second, &moved)];
    let first_is_lower = first.samples.first_nm() <= second.samples.first_nm();
    let (mut values, mut doubt) = (Vec::new(), Vec::new());
    for at in &nm {
        let share = ((at - overlap[0]) / (overlap[1] - overlap[0])).clamp(0.0, 1.0);
        let has = |s: &Sampled| *at >= s.first_nm() - 1e-9 && *at <= s.last_nm() + 1e-9;
        let of_second = match (has(&first.samples), has(&moved)) {
            (true, true) if first_is_lower => share,
            (true, true) => 1.0 - share,
            (true, false) => 0.0,
            (false, _) => 1.0,
        };
        let by = factor(*at);
        let at_first = first.samples.at(*at, Outside::Hold);
        let at_second = by * moved.at(*at, Outside::Hold);
        values.push(at_first * (1.0 - of_second) + at_second * of_second);
        let [a, b] = sigmas
            .each_ref()
            .map(|s| s.as_ref().map_or(0.0, |s| s.at(*at, Outside::Hold)));
        doubt.push(((1.0 - of_second) * a).hypot(of_second * by * b));
    }
    let mut result = Measurement::new(
        &first.name,
        first.quantity,
        &first.unit,
        Sampled::new(nm, values)?,
    );
    if sigmas.iter().any(Option::is_some) {
        result.sigma = Some(doubt);
    }
    result.level = first.level;
    result.axis_nm = first.axis_nm;
    result.slit = first.slit.filter(|_| first.slit == second.slit);
    Ok(result)
}
