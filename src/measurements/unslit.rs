//! A slit taken off: lines exactly, the rest by deconvolution that stops at the noise.
//!
//! Lines without width are taken out first, as the slit drew them; what is wider is a band and
//! stays. The rest is brought back by Richardson and Lucy's steps, which never make it negative,
//! until what is left is the noise. Where a step makes a line that was not there, half of the steps
//! are taken. A correction that moves the colour by less than its own doubt is not made: most of the
//! noise is in the colour before and after alike, and tells nothing of the move.

use super::statistics::OF_95;
use nalgebra::{DMatrix, DVector, Matrix2};

use super::{
    deconvolve::sharpened, error::MeasurementError, figures::rows, kernel::Slit,
    measurement::Measurement, noise::noise_behind, on_nm::OnWholeNm, slit_width::own_width,
};
use crate::{
    color::{
        Observer, Xyz, delta_e_of_xyz,
        xyz::{FIRST_NM, LAST_NM, xyz_from_nm_values},
    },
    languages::with_sign,
    spectrum::{Band, Outside, Sampled, SpikeSettings, detect, gaussian},
};

/// Widest line that is looked for, in slits, and its least share of the power.
const LOOKED_FOR: [f64; 2] = [1.35, 0.002];
/// Least weight of a line in its doubts.
const LEAST_WEIGHT: f64 = 5.0;
/// Most by which a line's own width exceeds the slit: shares of it, and doubts.
const WIDER: [f64; 3] = [0.12, 0.3, 2.0];
/// Second differences of the ground from knot to knot, as a share of the mean value: the light
/// penalty on its curvature.
const CURVATURE: f64 = 0.1;
/// Steps of the fit of places.
const ROUNDS: usize = 8;
/// Width of the lines that are drawn, nm.
const DRAWN_NM: f64 = 2.0;

/// A line that the slit had drawn wide.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NarrowLine {
    /// Place, nm.
    pub at_nm: f64,
    /// Power, value x nm.
    pub weight: f64,
    /// Standard uncertainty of the power.
    pub u_weight: f64,
    /// Standard uncertainty of the place, nm.
    pub u_at_nm: f64,
}

/// A reading without its slit.
#[derive(Clone, Debug, PartialEq)]
pub struct Unslit {
    /// The rest with the lines drawn 2 nm wide; the reading itself where nothing was done.
    pub result: Measurement,
    /// The part without lines.
    pub rest: Sampled,
    pub lines: Vec<NarrowLine>,
    /// False where the correction would move the colour by less than the noise does.
    pub is_made: bool,
}

/// A reading as it was before the slit.
///
/// # Errors
/// A sentence where the slit is no width or wider than the table.
pub fn unslit(of: &Measurement, slit: Slit) -> Result<Unslit, MeasurementError> {
    let samples = &of.samples;
    let reach = samples.last_nm() - samples.first_nm();
    if !(slit.fwhm_nm > 0.0 && 4.0 * slit.fwhm_nm < reach) {
        return Err(MeasurementError::Meaningless(tr!(
            "found a slit of {width} nm on {reach} nm, expected a width above 0 and below a \
             quarter",
            width = with_sign(slit.fwhm_nm.to_string()),
            reach = with_sign(reach.to_string())
        )));
    }
    let sigma = of.sigma.clone().or_else(|| noise_behind(samples, slit));
    let lines = Fit::lines(of, sigma.as_deref(), slit);
    let drawn = |slit: Slit, line: &NarrowLine, nm: f64| line.weight * slit.height(nm - line.at_nm);
    let rest: Vec<f64> = samples
        .nm()
        .iter()
        .zip(samples.values())
        .map(|(nm, v)| v - lines.iter().map(|line| drawn(slit, line, *nm)).sum::<f64>())
        .collect();
    let sharp = sharpened(samples, &rest, sigma.as_deref(), slit);
    let mut values = sharp.clone();
    for line in &lines {
        add_narrow(samples.nm(), line, &mut values);
    }
    let result = Measurement {
        samples: shared(samples, values)?,
        slit: None,
        ..of.clone()
    };
    let known = Measurement {
        sigma,
        ..of.clone()
    };
    let is_made = moves_more_than_noise(&known, &result.samples, slit);
    Ok(Unslit {
        result: if is_made { result } else { of.clone() },
        rest: shared(samples, sharp)?,
        lines,
        is_made,
    })
}

fn shared(samples: &Sampled, values: Vec<f64>) -> Result<Sampled, MeasurementError> {
    let found = samples.sharing(values).map_err(|(why, _)| why)?;
    Ok(found)
}

/// Adds a line of [`DRAWN_NM`] whose area on the table's own grid is its weight.
fn add_narrow(nm: &[f64], line: &NarrowLine, values: &mut [f64]) {
    let last = nm.len() - 1;
    let width = |i: usize| 0.5 * (nm[(i + 1).min(last)] - nm[i.saturating_sub(1)]);
    let from = nm.partition_point(|nm| *nm < line.at_nm - 3.0 * DRAWN_NM);
    let to = nm.partition_point(|nm| *nm < line.at_nm + 3.0 * DRAWN_NM);
    let heights: Vec<f64> = (from..to)
        .map(|i| gaussian((nm[i] - line.at_nm) / DRAWN_NM))
        .collect();
    let area: f64 = heights
        .iter()
        .enumerate()
        .map(|(k, h)| h * width(from + k))
        .sum();
    if area > 1e-3 {
        for (value, height) in values[from..to].iter_mut().zip(heights) {
            *value += line.weight * height / area;
        }
        return;
    }
    // A coarse table: the two samples beside it.
    let right = nm.partition_point(|nm| *nm < line.at_nm).clamp(1, last);
    let share = (line.at_nm - nm[right - 1]) / (nm[right] - nm[right - 1]);
    values[right - 1] += line.weight * (1.0 - share) / width(right - 1);
    values[right] += line.weight * share / width(right);
}

/// Places and weights of lines over a ground of straight pieces.
struct Fit<'m> {
    of: &'m Measurement,
    inverse: Vec<f64>,
    knots: Vec<f64>,
    slit: Slit,
}

impl<'m> Fit<'m> {
    /// The lines without width of a reading.
    fn lines(of: &'m Measurement, sigma: Option<&[f64]>, slit: Slit) -> Vec<NarrowLine> {
        let samples = &of.samples;
        let Ok(band) = Band::new(samples.first_nm().ceil(), samples.last_nm().floor()) else {
            return Vec::new();
        };
        let values = samples.on_band(band, Outside::Zero);
        let settings = SpikeSettings {
            threshold: LOOKED_FOR[1],
            max_width_nm: LOOKED_FOR[0] * slit.fwhm_nm,
            dips: false,
        };
        let found = detect(band, &values, settings);
        let top = samples.values().iter().fold(0.0_f64, |t, v| t.max(v.abs()));
        let pieces = ((samples.last_nm() - samples.first_nm()) / slit.fwhm_nm).ceil() as usize;
        let step = (samples.last_nm() - samples.first_nm()) / pieces as f64;
        let fit = Self {
            of,
            inverse: (0..samples.len())
                .map(|i| sigma.map_or(0.0, |s| s[i]).max(1e-6 * top).recip())
                .collect(),
            knots: (0..=pieces)
                .map(|k| samples.first_nm() + step * k as f64)
                .collect(),
            slit,
        };
        let mut places: Vec<f64> = found.spikes.iter().map(|s| s.spike.at_nm).collect();
        let mut lines = fit.fitted(&places);
        // The worst goes first: what it held may make another one worse or better.
        while let Some(out) = fit.worst(&lines, sigma, LOOKED_FOR[1] * found.power) {
            lines.remove(out);
            places = lines.iter().map(|line| line.at_nm).collect();
            lines = fit.fitted(&places);
        }
        lines
    }

    /// The line that is none, if there is one: too weak, or wider than the slit.
    fn worst(&self, lines: &[NarrowLine], sigma: Option<&[f64]>, least: f64) -> Option<usize> {
        let weak = |line: &NarrowLine| {
            (line.weight / (LEAST_WEIGHT * line.u_weight)).min(line.weight / least)
        };
        let weakest = (0..lines.len())
            .filter(|i| weak(&lines[*i]).is_nan() || weak(&lines[*i]) <= 1.0)
            .min_by(|a, b| weak(&lines[*a]).total_cmp(&weak(&lines[*b])));
        weakest.or_else(|| {
            (0..lines.len())
                .filter_map(|i| Some((i, self.too_wide(lines, i, sigma)?)))
                .max_by(|a, b| a.1.total_cmp(&b.1))
                .map(|(i, _)| i)
        })
    }

    /// By how much a line's own width exceeds what is allowed, nm; `None` where it does not.
    fn too_wide(&self, lines: &[NarrowLine], which: usize, sigma: Option<&[f64]>) -> Option<f64> {
        let samples = &self.of.samples;
        let others = |nm: f64| -> f64 {
            let all = lines.iter().enumerate().filter(|(i, _)| *i != which);
            all.map(|(_, l)| l.weight * self.slit.height(nm - l.at_nm))
                .sum()
        };
        let pairs = samples.nm().iter().zip(samples.values());
        let alone = samples
            .sharing(pairs.map(|(nm, v)| v - others(*nm)).collect())
            .ok()?;
        let alone = Measurement {
            samples: alone,
            ..self.of.clone()
        };
        let f = self.slit.fwhm_nm;
        let [width, u] = own_width(&alone, sigma, lines[which].at_nm, self.slit)?;
        let allowed = (WIDER[0] * f).max((WIDER[2] * u).min(WIDER[1] * f));
        (width - f > allowed).then_some(width - f - allowed)
    }

    /// Lines at some places, moved to where they fit best.
    fn fitted(&self, places: &[f64]) -> Vec<NarrowLine> {
        let mut places = places.to_vec();
        let count = places.len();
        let mut lines = Vec::new();
        if count == 0 {
            return lines;
        }
        let mut weights: Option<Vec<f64>> = None;
        for _ in 0..ROUNDS {
            let Some((found, covariance)) = self.solved(&places, weights.as_deref()) else {
                return Vec::new();
            };
            let own = |k: usize| covariance[(k, k)].max(0.0).sqrt();
            let has_moves = weights.is_some();
            lines = (0..count)
                .map(|k| NarrowLine {
                    at_nm: places[k],
                    weight: found[k],
                    u_weight: own(k),
                    u_at_nm: if has_moves { own(count + k) } else { 0.0 },
                })
                .collect();
            if has_moves {
                let most = 0.25 * self.slit.fwhm_nm;
                for (k, place) in places.iter_mut().enumerate() {
                    let inside = [self.knots[0], self.knots[self.knots.len() - 1]];
                    *place =
                        (*place + found[count + k].clamp(-most, most)).clamp(inside[0], inside[1]);
                }
            }
            weights = Some(found.iter().take(count).copied().collect());
        }
        lines
    }

    /// Weights, moves where weights are known, and the ground, with their covariance.
    fn solved(
        &self,
        places: &[f64],
        weights: Option<&[f64]>,
    ) -> Option<(DVector<f64>, DMatrix<f64>)> {
        let samples = &self.of.samples;
        let count = places.len();
        let moves = if weights.is_some() { count } else { 0 };
        let (first, knots) = (count + moves, self.knots.len());
        let numbers = first + knots;
        let mut normal: DMatrix<f64> = DMatrix::zeros(numbers, numbers);
        let mut right: DVector<f64> = DVector::zeros(numbers);
        let step = self.knots[1] - self.knots[0];
        let mut row: Vec<(usize, f64)> = Vec::new();
        for (i, nm) in samples.nm().iter().enumerate() {
            row.clear();
            for (k, at) in places.iter().enumerate() {
                let away = nm - at;
                if away.abs() > self.slit.reach_nm() + 0.1 {
                    continue;
                }
                row.push((k, self.slit.height(away)));
                if let Some(weights) = weights {
                    let slope =
                        (self.slit.height(away + 0.01) - self.slit.height(away - 0.01)) / 0.02;
                    row.push((count + k, -weights[k] * slope));
                }
            }
            let x = ((nm - self.knots[0]) / step).clamp(0.0, (knots - 1) as f64);
            let left = (x as usize).min(knots - 2);
            row.push((first + left, 1.0 - (x - left as f64)));
            row.push((first + left + 1, x - left as f64));
            let weight = self.inverse[i].powi(2);
            for (a, va) in &row {
                right[*a] += weight * va * samples.values()[i];
                for (b, vb) in &row {
                    normal[(*a, *b)] += weight * va * vb;
                }
            }
        }
        let mean = samples.values().iter().map(|v| v.abs()).sum::<f64>() / samples.len() as f64;
        let penalty = (CURVATURE * mean).max(f64::MIN_POSITIVE).powi(-2);
        for k in 1..knots - 1 {
            let bend = [(k - 1, 1.0), (k, -2.0), (k + 1, 1.0)];
            for (a, va) in bend {
                for (b, vb) in bend {
                    normal[(first + a, first + b)] += penalty * va * vb;
                }
            }
        }
        // Columns of one size: weights and moves differ by many powers of ten.
        let scale: Vec<f64> = (0..numbers)
            .map(|k| normal[(k, k)].sqrt().max(f64::MIN_POSITIVE).recip())
            .collect();
        let scaled = DMatrix::from_fn(numbers, numbers, |i, j| {
            normal[(i, j)] * scale[i] * scale[j]
        });
        let inverse = scaled.cholesky()?.inverse();
        let covariance = DMatrix::from_fn(numbers, numbers, |i, j| {
            inverse[(i, j)] * scale[i] * scale[j]
        });
        Some((&covariance * right, covariance))
    }
}

/// Weights on whole nm less the same seen through a slit.
fn less_blurred(weights: &[f64], slit: Slit) -> Vec<f64> {
    let reach = slit.reach_nm().ceil() as usize;
    let kernel: Vec<f64> = (0..=reach).map(|away| slit.height(away as f64)).collect();
    let blurred = |i: usize| {
        let near = i.saturating_sub(reach)..(i + reach + 1).min(weights.len());
        let pairs = near.map(|k| (kernel[k.abs_diff(i)], weights[k]));
        let (sum, all) = pairs.fold((0.0, 0.0), |(sum, all), (by, w)| (sum + by * w, all + by));
        if all > 0.0 { sum / all } else { weights[i] }
    };
    (0..weights.len())
        .map(|i| weights[i] - blurred(i))
        .collect()
}

/// True if a table's colour differs from a reading's by more than 95 % of what the noise makes of the
/// move. To first order a sharpened table is twice the table less what the slit makes of it, so that
/// the noise of the move is that of each weight less the weight seen through the slit.
fn moves_more_than_noise(of: &Measurement, changed: &Sampled, slit: Slit) -> bool {
    let on_nm = OnWholeNm::of(of, FIRST_NM, LAST_NM);
    let xyz = |values: &[f64]| xyz_from_nm_values(values, Observer::CIE_1931);
    let own = xyz(&on_nm.values);
    let after = xyz(&changed.on_whole_nm(FIRST_NM, LAST_NM, Outside::Zero));
    // Colours at Y = 100: how bright it is, is no matter of the slit.
    let (Some(white), Some(after)) = (own.with_y(100.0), after.with_y(100.0)) else {
        // A table in the dark has no colour to be careful with.
        return true;
    };
    let differ = |other: Xyz| delta_e_of_xyz(white, other, white).unwrap_or(f64::INFINITY);
    // X and Z over Y: what each nm adds to either.
    let y: f64 = rows()[1]
        .iter()
        .zip(&on_nm.values)
        .map(|(r, v)| r * v)
        .sum();
    let over_y = |k: usize, whole: f64| -> Vec<f64> {
        let pairs = rows()[k].iter().zip(&rows()[1]);
        let weights: Vec<f64> = pairs
            .map(|(row, of_y)| (100.0 * row - whole * of_y) / y)
            .collect();
        less_blurred(&weights, slit)
    };
    let (x, z) = (over_y(0, white.x), over_y(2, white.z));
    let both: Vec<f64> = x.iter().zip(&z).map(|(x, z)| x + z).collect();
    let variance = |row: &[f64]| on_nm.doubt_of(0, row).powi(2);
    let (of_x, of_z) = (variance(&x), variance(&z));
    let shared = 0.5 * (variance(&both) - of_x - of_z);
    let eigen = Matrix2::new(of_x, shared, shared, of_z).symmetric_eigen();
    let squares = [0, 1].map(|k| {
        let long = eigen.eigenvalues[k].max(0.0).sqrt();
        let e = eigen.eigenvectors.column(k) * long;
        differ(white + Xyz::new(e[0], 0.0, e[1])).powi(2)
    });
    let sum = squares[0] + squares[1];
    let fourth = squares[0].powi(2) + squares[1].powi(2);
    // From one direction (1.96^2) to two alike, whose squares exceed 6 once in twenty.
    let directions = if fourth > 0.0 {
        sum * sum / fourth
    } else {
        1.0
    };
    let quantile = OF_95 * OF_95 - (OF_95 * OF_95 - 3.0) * (directions - 1.0);
    differ(after) > (quantile * sum).sqrt()
}
