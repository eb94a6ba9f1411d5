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
    on_nm::OnWholeNm,
    repeats::slope,
    statistics::student_95,
};
use crate::{
    color::{
        quality::fidelity_reference,
        xyz::{FIRST_NM, LAST_NM},
    },
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

/// Every figure of a light with its doubt: by its own sigma, level, axis and memory. `scans` is how
/// many told them; where an instrument states them, none.
pub fn doubts(light: &Measurement) -> Vec<Doubted> {
    let on_nm = OnWholeNm::of(light, FIRST_NM, LAST_NM);
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
    let shared: Vec<[[Option<f64>; 8]; 2]> = shared_sums(light, &on_nm.values)
        .iter()
        .map(|along| moved(&|i| along[i]))
        .collect();
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
        let mut by_shared = 0.0;
        for pair in &shared {
            let [square, more] = part(pair)?;
            by_shared += square;
            bias += more;
        }
        let variance = by_level + by_axis + by_white + by_shared;
        let u = variance.sqrt();
        let dof = degrees([by_level, by_axis, by_white, by_shared], told_by);
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

/// Largest share of the light's Y that may be masked before its figures have no doubt worth the name.
const MOST_MISSING: f64 = 0.01;

/// The masked stretches of a light (nm), where they hold more of Y than counts for nothing: by the
/// reference light of its CCT, since what is missing is not known.
pub fn missing_light(light: &Measurement) -> Vec<[f64; 2]> {
    let masked = light.masked();
    if masked.is_empty() {
        return Vec::new();
    }
    let on_nm = OnWholeNm::of(light, FIRST_NM, LAST_NM);
    let kelvin = figures_of_sums(&sums_of(&on_nm.values))[3].unwrap_or(5000.0);
    let reference = fidelity_reference(kelvin).on_nm();
    let y = |nm: usize| rows()[1][nm] * reference[nm];
    let whole: f64 = (0..reference.len()).map(y).sum();
    let inside = |[from, to]: [f64; 2]| -> f64 {
        let nm = (0..reference.len()).filter(|i| {
            let at = f64::from(FIRST_NM) + *i as f64;
            (from..=to).contains(&at)
        });
        nm.map(y).sum()
    };
    let stretches: Vec<[f64; 2]> = masked.iter().map(|m| [m.from_nm, m.to_nm]).collect();
    let missing: f64 = stretches.iter().map(|s| inside(*s)).sum();
    match missing > MOST_MISSING * whole {
        true => stretches,
        false => Vec::new(),
    }
}

/// Degrees of freedom of a variance that is the sum of level, axis and white noise, and of what all
/// samples share, which is stated.
fn degrees([level, axis, white, shared]: [f64; 4], scans: Option<usize>) -> f64 {
    let all = level + axis + white + shared;
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

/// The colour sums of each error that all samples share.
fn shared_sums(light: &Measurement, values: &[f64]) -> Vec<Vec<f64>> {
    let light = light.bridged();
    let of = |shared: &Vec<f64>| -> Option<Vec<f64>> {
        let table = light.samples.sharing(shared.clone()).ok()?;
        let on_nm = table.on_whole_nm(FIRST_NM, LAST_NM, Outside::Hold);
        let moved: Vec<f64> = on_nm.iter().zip(values).map(|(s, v)| s * v).collect();
        Some(sums_of(&moved))
    };
    light.shared.iter().filter_map(of).collect()
}

/// Slope of a light within its table; none across its ends.
fn shifted(nm: &[f64], values: &[f64], light: &Measurement) -> Vec<f64> {
    let inside = light.bridged();
    let (first, last) = (inside.samples.first_nm(), inside.samples.last_nm());
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
