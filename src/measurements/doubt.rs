//! Doubt of figures by sigma points in the colour sums.
//!
//! The noise of a light is carried into its 345 colour sums exactly; its main directions there,
//! and the two shared errors of level and axis, are each taken one deviation up and down. Half of
//! what a figure moves by between the two is its error, half of what both together move it by its
//! bias: noise makes every index of colour differences smaller.

use nalgebra::DMatrix;

use super::{
    figures::{FIGURES, Figure, SUMS, dot, figures_of_sums, rows, sums_of},
    measurement::Measurement,
    repeats::slope,
    statistics::student_95,
};
use crate::{
    color::xyz::{FIRST_NM, LAST_NM, POINTS},
    spectrum::Outside,
};

/// Share of the noise in the sums that the directions hold.
const ENOUGH: f64 = 0.9999;

const MOST_DIRECTIONS: usize = 24;

/// Most columns of the factor that the directions are taken from.
const MOST_COLUMNS: usize = 72;

/// Largest share of the noise that the columns may leave.
const LEFT: f64 = 1e-7;

/// Samples that tell the white noise of each scan together: degrees of freedom a scan.
const TELLING: f64 = 40.0;

/// A figure with its doubt.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Doubt {
    /// The figure, its bias taken off where it has one.
    pub value: f64,
    /// The figure of the table as it is.
    pub of_the_table: f64,
    /// Mean offset added by noise.
    pub bias: f64,
    /// Standard uncertainty.
    pub u: f64,
    /// Degrees of freedom.
    pub dof: f64,
    /// Half width of the interval that holds the true figure 95 times of 100.
    pub half_width_95: f64,
}

/// A figure and what is known of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Doubted {
    pub figure: Figure,
    /// Its doubt; `None` for a figure that the light does not have.
    pub doubt: Option<Doubt>,
}

/// A light on whole nm with the deviation and memory of its noise.
struct OnWholeNm {
    values: Vec<f64>,
    sigma: Vec<f64>,
    memory: Vec<f64>,
}

impl OnWholeNm {
    fn of(light: &Measurement) -> Self {
        let samples = &light.samples;
        let step = samples.step_nm();
        let lags = |own: &dyn Fn(f64) -> f64| -> Vec<f64> {
            (1..POINTS)
                .map(|k| own(k as f64))
                .take_while(|rho| *rho > 0.01)
                .collect()
        };
        let rho = |samples_apart: f64| {
            let at = |k: usize| match k {
                0 => 1.0,
                k => light.memory.get(k - 1).copied().unwrap_or(0.0),
            };
            let (below, share) = (samples_apart as usize, samples_apart.fract());
            at(below) * (1.0 - share) + at(below + 1) * share
        };
        let in_a_nm = (1.0 / step).max(1.0);
        // The mean of all samples of a nm has less noise than one of them, and what noise of theirs
        // is alike stays; at steps of a nm and more a point is one sample or lies between two.
        let inside = in_a_nm.round() as usize;
        let pairs = (1..inside).map(|k| 2.0 * (inside - k) as f64 * rho(k as f64));
        let mean_of_nm = ((inside as f64 + pairs.sum::<f64>()).max(0.0)).sqrt() / inside as f64;
        let own = light.sigma.as_deref().unwrap_or_default();
        let nm = samples.nm();
        let sigma = (FIRST_NM..=LAST_NM).map(|at| {
            let at = f64::from(at);
            if own.is_empty() || at < nm[0] || at > nm[nm.len() - 1] {
                return 0.0;
            }
            let right = nm.partition_point(|nm| *nm < at).clamp(1, nm.len() - 1);
            let share = (at - nm[right - 1]) / (nm[right] - nm[right - 1]);
            if inside > 1 {
                return mean_of_nm * (own[right - 1] * (1.0 - share) + own[right] * share);
            }
            light.sigma_at(right - 1, share)
        });
        Self {
            values: samples.on_whole_nm(FIRST_NM, LAST_NM, Outside::Zero),
            sigma: sigma.collect(),
            memory: if inside > 1 {
                lags(&|k| shared(&rho, inside, k as usize))
            } else if (step - 1.0).abs() < 1e-9 {
                light.memory.clone()
            } else {
                lags(&|k| rho(k / step))
            },
        }
    }
}

/// Correlation of the means of all samples of two nm that lie so many nm apart.
fn shared(rho: &dyn Fn(f64) -> f64, inside: usize, apart: usize) -> f64 {
    let sum = |between: usize| -> f64 {
        let pairs = (0..inside).flat_map(|i| (0..inside).map(move |j| (i, j + between)));
        pairs.map(|(i, j)| rho(i.abs_diff(j) as f64)).sum()
    };
    sum(apart * inside) / sum(0)
}

/// Every figure of a light with its doubt: by its own sigma, level, axis and memory. `scans` is how
/// many told them; where an instrument states them, none.
pub fn doubts(light: &Measurement) -> Vec<Doubted> {
    let on_nm = OnWholeNm::of(light);
    let sums = sums_of(&on_nm.values);
    let own = figures_of_sums(&sums);
    let scale: Vec<f64> = sums
        .iter()
        .map(|s| s.abs().max(f64::MIN_POSITIVE))
        .collect();
    let moved = |by: &dyn Fn(usize) -> f64| {
        let at = |sign: f64| {
            let sums: Vec<f64> = (0..SUMS).map(|i| sums[i] + sign * by(i)).collect();
            figures_of_sums(&sums)
        };
        [at(1.0), at(-1.0)]
    };
    let white: Vec<[[Option<f64>; 8]; 2]> = directions(&on_nm, &scale)
        .iter()
        .map(|direction| moved(&|i| direction[i] * scale[i]))
        .collect();
    let nm: Vec<f64> = (FIRST_NM..=LAST_NM).map(f64::from).collect();
    let along_axis = sums_of(&shifted(&nm, &on_nm.values, light));
    let level = moved(&|i| light.level * sums[i]);
    let axis = moved(&|i| light.axis_nm * along_axis[i]);
    let told_by = light.scans.filter(|n| *n > 1);
    let one = |k: usize| -> Option<Doubt> {
        let f0 = own[k]?;
        let part = |pair: &[[Option<f64>; 8]; 2]| -> Option<[f64; 2]> {
            let (up, down) = (pair[0][k]?, pair[1][k]?);
            Some([((up - down) / 2.0).powi(2), (up + down) / 2.0 - f0])
        };
        let [by_level, bias_of_level] = part(&level)?;
        let [by_axis, bias_of_axis] = part(&axis)?;
        let mut by_white = 0.0;
        let mut bias = bias_of_level + bias_of_axis;
        for pair in &white {
            let [square, more] = part(pair)?;
            by_white += square;
            bias += more;
        }
        let variance = by_level + by_axis + by_white;
        let u = variance.sqrt();
        let dof = degrees([by_level, by_axis, by_white], told_by);
        let t = if u > 0.0 { student_95(dof) } else { 0.0 };
        let is_biased = FIGURES[k].is_biased();
        Some(Doubt {
            value: if is_biased { f0 - bias } else { f0 },
            of_the_table: f0,
            bias,
            u,
            dof,
            half_width_95: t * u + if is_biased { bias.abs() } else { 0.0 },
        })
    };
    let all = FIGURES.into_iter().enumerate();
    all.map(|(k, figure)| Doubted {
        figure,
        doubt: one(k),
    })
    .collect()
}

/// Degrees of freedom of a variance that is the sum of level, axis and white noise.
fn degrees([level, axis, white]: [f64; 3], scans: Option<usize>) -> f64 {
    let all = level + axis + white;
    match scans {
        Some(n) => {
            let n = (n - 1) as f64;
            let below = (level * level + axis * axis) / n + white * white / (TELLING * n);
            if below > 0.0 {
                (all * all / below).max(n)
            } else {
                n
            }
        }
        // What an instrument states is known.
        None if white > 0.0 => all * all / (white * white / TELLING),
        None => f64::MAX,
    }
}

/// Slope of a light within its table; none across its ends.
fn shifted(nm: &[f64], values: &[f64], light: &Measurement) -> Vec<f64> {
    let (first, last) = (light.samples.first_nm(), light.samples.last_nm());
    let from = nm.partition_point(|nm| *nm < first);
    let to = nm.partition_point(|nm| *nm <= last);
    let mut slopes = vec![0.0; nm.len()];
    if to >= from + 2 {
        slopes[from..to].copy_from_slice(&slope(&nm[from..to], &values[from..to]));
    }
    slopes
}

/// Main directions of the noise in the sums, each one deviation long, in units of `scale`.
fn directions(light: &OnWholeNm, scale: &[f64]) -> Vec<Vec<f64>> {
    if light.sigma.iter().all(|s| *s == 0.0) {
        return Vec::new();
    }
    let weighed = |(row, scale): (&Vec<f64>, &f64)| -> Vec<f64> {
        row.iter()
            .zip(&light.sigma)
            .map(|(r, s)| r * s / scale)
            .collect()
    };
    let rows: Vec<Vec<f64>> = rows().iter().zip(scale).map(weighed).collect();
    // Its row of the covariance, with the memory.
    let remembered = |row: &[f64]| -> Vec<f64> {
        let mut out = row.to_vec();
        for (lag, rho) in (1..).zip(&light.memory) {
            for i in 0..row.len().saturating_sub(lag) {
                out[i] += rho * row[i + lag];
                out[i + lag] += rho * row[i];
            }
        }
        out
    };
    let mut left: Vec<f64> = rows.iter().map(|row| dot(row, &remembered(row))).collect();
    let whole: f64 = left.iter().sum();
    let mut columns: Vec<Vec<f64>> = Vec::new();
    // Cholesky, the largest that is left first.
    while columns.len() < MOST_COLUMNS && left.iter().sum::<f64>() > LEFT * whole {
        let Some(pivot) = (0..SUMS).max_by(|a, b| left[*a].total_cmp(&left[*b])) else {
            break;
        };
        if left[pivot] <= 0.0 {
            break;
        }
        let of_pivot = remembered(&rows[pivot]);
        let root = left[pivot].sqrt();
        let entry = |i: usize| {
            let known: f64 = columns.iter().map(|c| c[i] * c[pivot]).sum();
            (dot(&rows[i], &of_pivot) - known) / root
        };
        let column: Vec<f64> = (0..SUMS).map(entry).collect();
        left.iter_mut()
            .zip(&column)
            .for_each(|(l, c)| *l = (*l - c * c).max(0.0));
        left[pivot] = 0.0;
        columns.push(column);
    }
    main_directions(&columns, whole)
}

/// The eigenvectors of the sum of columns times themselves, the largest first, each as long as the
/// root of its eigenvalue, until enough of the whole.
fn main_directions(columns: &[Vec<f64>], whole: f64) -> Vec<Vec<f64>> {
    let n = columns.len();
    // Without noise there is no direction, and an empty matrix has no eigenvalues.
    if n == 0 {
        return Vec::new();
    }
    let gram = DMatrix::from_fn(n, n, |i, j| dot(&columns[i], &columns[j])).symmetric_eigen();
    let (values, vectors) = (gram.eigenvalues, gram.eigenvectors);
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|a, b| values[*b].total_cmp(&values[*a]));
    let mut found = Vec::new();
    let mut held = 0.0;
    for k in order {
        if held >= ENOUGH * whole || found.len() == MOST_DIRECTIONS || values[k] <= 0.0 {
            break;
        }
        held += values[k];
        let at = |i: usize| (0..n).map(|c| columns[c][i] * vectors[(c, k)]).sum();
        found.push((0..SUMS).map(at).collect());
    }
    found
}

/// A value and its doubt, rounded so that the last digit is worth writing: two digits of doubt
/// where the first is 1 or 2, else one.
pub fn rounded(value: f64, doubt: f64) -> (String, String) {
    if !doubt.is_finite() || doubt <= 0.0 {
        return (value.to_string(), doubt.to_string());
    }
    let mut power = doubt.log10().floor() as i32;
    // 0.0996 is 0.10.
    let shown = (doubt / 10f64.powi(power - 1)).round();
    let digits = if (30.0..100.0).contains(&shown) { 1 } else { 2 };
    if shown >= 100.0 {
        power += 1;
    }
    let decimals = (digits - 1 - power).clamp(-300, 300);
    if decimals > 0 {
        let decimals = decimals as usize;
        return (format!("{value:.decimals$}"), format!("{doubt:.decimals$}"));
    }
    let unit = 10f64.powi(-decimals);
    let to_unit = |v: f64| format!("{:.0}", (v / unit).round() * unit);
    (to_unit(value), to_unit(doubt))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_doubt_has_two_digits_from_10_to_29_and_else_one() {
        let of = |value, doubt| {
            let (value, doubt) = rounded(value, doubt);
            format!("{value} ± {doubt}")
        };
        assert_eq!(of(4224.4, 11.4), "4224 ± 11");
        assert_eq!(of(64.2341, 0.31), "64.2 ± 0.3");
        assert_eq!(of(100.0, 1.16), "100.0 ± 1.2");
        assert_eq!(of(0.446_528_5, 0.000_995_9), "0.4465 ± 0.0010");
        assert_eq!(of(6512.0, 340.0), "6500 ± 300");
        assert_eq!(of(1.0, 0.0), "1 ± 0");
    }
}
