//! Lines of a strip made upright: how much they lean and bend, and which columns hold light.

use super::{
    super::{
        picture::View,
        smooth::{gaussian, largest, percentile, robust_sigma},
    },
    ByHand, Strip,
    rows::correlation,
};

/// Most rows that are sampled.
pub(super) const MOST_ROWS: usize = 48;
/// Search range for rows, as shares of the columns: first and later.
const SEARCH: [f64; 3] = [1.0 / 14.0, 1.0 / 40.0, 1.0 / 40.0];
/// Rows that are less alike are left out.
pub(super) const LEAST_ALIKE: f64 = 0.35;
/// And rows that are farther off than this, columns.
const MOST_OFF: f64 = 1.2;

/// Rows of a strip, from its upper to its lower edge.
pub(super) fn rows_of(strip: &Strip) -> Vec<f64> {
    let count = ((2.0 * strip.half) as usize + 1).clamp(3, MOST_ROWS);
    let step = 2.0 * strip.half / (count - 1) as f64;
    (0..count).map(|i| i as f64 * step - strip.half).collect()
}

/// The light of a row; black beside the picture.
pub(super) fn row_of(view: View<'_>, strip: &Strip, v: f64) -> Vec<[f32; 3]> {
    (0..strip.columns)
        .map(|k| {
            let (x, y) = strip.seen(k as f64, v);
            view.light(x, y).unwrap_or_default()
        })
        .collect()
}

/// Signal by which rows are compared: colour, or light for grey pictures.
fn signal(row: &[[f32; 3]], is_grey: bool) -> Vec<f64> {
    let of = |&[r, g, b]: &[f32; 3]| {
        let most = r.max(g).max(b);
        f64::from(if is_grey {
            most
        } else {
            most - r.min(g).min(b)
        })
    };
    row.iter().map(of).collect()
}

/// A row without its slow changes.
fn high_passed(signal: &[f64]) -> Vec<f64> {
    // A box twice behind another is near enough to a Gaussian here, and a row long at any width.
    let slow = boxed(&boxed(signal, 20), 20);
    signal.iter().zip(slow).map(|(s, m)| s - m).collect()
}

/// Means of a window of one part in so many of a list.
fn boxed(values: &[f64], part: usize) -> Vec<f64> {
    let reach = (values.len() / part / 2).max(1);
    let mut sums = vec![0.0];
    for value in values {
        sums.push(sums[sums.len() - 1] + value);
    }
    let mean = |i: usize| {
        let (from, to) = (i.saturating_sub(reach), (i + reach + 1).min(values.len()));
        (sums[to] - sums[from]) / (to - from) as f64
    };
    (0..values.len()).map(mean).collect()
}

/// Finds shear and smile where no hand has set them, and gives how alike the rows are then.
pub(super) fn lean(view: View<'_>, strip: &mut Strip, is_grey: bool, by_hand: &ByHand) -> f64 {
    strip.shear = by_hand.shear.unwrap_or(0.0);
    strip.smile = by_hand.smile.unwrap_or(0.0);
    let rows = rows_of(strip);
    let count = strip.columns;
    let mut alike = 0.0;
    for part in SEARCH {
        let sampled: Vec<Vec<f64>> = (rows.iter())
            .map(|v| high_passed(&gaussian(&signal(&row_of(view, strip, *v), is_grey), 1.0)))
            .collect();
        let reference = reference(&sampled);
        let reach = ((part * count as f64) as isize).max(4);
        let matches: Vec<(f64, f64, f64)> = (rows.iter().zip(&sampled))
            .map(|(v, row)| (*v, shift(&reference, row, reach)))
            .map(|(v, (shift, alike))| (v, shift, alike))
            .filter(|(_, _, alike)| *alike >= LEAST_ALIKE)
            .collect();
        alike = matches.iter().map(|m| m.2).sum::<f64>() / rows.len() as f64;
        let Some((shear, smile)) = fitted(&matches, rows.len()) else {
            return alike;
        };
        strip.shear = by_hand.shear.unwrap_or(strip.shear + shear);
        strip.smile = by_hand.smile.unwrap_or(strip.smile + smile);
    }
    alike
}

/// The mean of the sharpest run of a sixth of the rows.
fn reference(rows: &[Vec<f64>]) -> Vec<f64> {
    let sharpness: Vec<f64> = (rows.iter())
        .map(|row| {
            let steps: f64 = row.windows(2).map(|two| (two[1] - two[0]).powi(2)).sum();
            let all: f64 = row.iter().map(|v| v * v).sum();
            if all > 0.0 {
                steps / all * all.sqrt()
            } else {
                0.0
            }
        })
        .collect();
    let run = (rows.len() / 6).max(1);
    let sum = |first: usize| sharpness[first..first + run].iter().sum::<f64>();
    let first = (0..=rows.len() - run).max_by(|a, b| sum(*a).total_cmp(&sum(*b)));
    let first = first.unwrap_or(0);
    let mut mean = vec![0.0; rows[0].len()];
    for row in &rows[first..first + run] {
        mean.iter_mut().zip(row).for_each(|(m, v)| *m += v);
    }
    mean
}

/// By how many columns a row lies to the right of another, and how alike they are then.
fn shift(reference: &[f64], row: &[f64], reach: isize) -> (f64, f64) {
    let overlap = |by: isize| {
        let (from, to) = (by.max(0) as usize, (-by).max(0) as usize);
        let count = row.len().saturating_sub(from.max(to));
        (&reference[to..to + count], &row[from..from + count])
    };
    let product = |by: isize| {
        let (a, b) = overlap(by);
        a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>()
    };
    let products: Vec<f64> = (-reach..=reach).map(product).collect();
    let best = (0..products.len()).max_by(|a, b| products[*a].total_cmp(&products[*b]));
    let best = best.unwrap_or(reach as usize);
    let by = best as isize - reach;
    let (a, b) = overlap(by);
    let alike = correlation(a, b);
    let part = match (
        best.checked_sub(1).map(|i| products[i]),
        products.get(best + 1),
    ) {
        (Some(left), Some(right)) => {
            let bend = left - 2.0 * products[best] + right;
            if bend < 0.0 {
                (0.5 * (left - right) / bend).clamp(-0.5, 0.5)
            } else {
                0.0
            }
        }
        _ => 0.0,
    };
    (by as f64 + part, alike)
}

/// Shear and smile through the shifts of rows; `None` of too few.
fn fitted(matches: &[(f64, f64, f64)], rows: usize) -> Option<(f64, f64)> {
    let mut kept: Vec<(f64, f64)> = matches.iter().map(|m| (m.0, m.1)).collect();
    let mut coefficients = nalgebra::Vector3::zeros();
    for round in 0..4 {
        if kept.len() < 3 || 4 * kept.len() < rows {
            return None;
        }
        let reach = kept.iter().map(|k| k.0.abs()).fold(1.0, f64::max);
        let powers = |v: f64| nalgebra::Vector3::new(1.0, v / reach, (v / reach).powi(2));
        let mut scale = if round == 0 { 4.0 } else { 1.0 };
        for _ in 0..8 {
            // A weak prior: lines are straight and upright until rows say otherwise.
            let mut normal =
                nalgebra::Matrix3::from_diagonal(&nalgebra::Vector3::new(1e-6, 1e-4, 1e-2));
            let mut right = nalgebra::Vector3::zeros();
            for (v, by) in &kept {
                let powers = powers(*v);
                let off: f64 = by - powers.dot(&coefficients);
                let weight = 1.0 / (1.0 + (off / scale).powi(2));
                normal += weight * powers * powers.transpose();
                right += weight * *by * powers;
            }
            coefficients = normal.cholesky()?.solve(&right);
            let off: Vec<f64> = kept
                .iter()
                .map(|(v, by)| by - powers(*v).dot(&coefficients))
                .collect();
            scale = (2.0 * robust_sigma(&off)).clamp(0.15, scale);
        }
        let off: Vec<f64> = kept
            .iter()
            .map(|(v, by)| by - powers(*v).dot(&coefficients))
            .collect();
        let most = (3.0 * robust_sigma(&off)).max(MOST_OFF);
        let fits: Vec<(f64, f64)> = (kept.iter().zip(&off))
            .filter(|(_, off)| off.abs() <= most)
            .map(|(k, _)| *k)
            .collect();
        if fits.len() == kept.len() {
            return Some((coefficients[1] / reach, coefficients[2] / reach.powi(2)));
        }
        // The next round counts v in other units.
        let next = fits.iter().map(|k| k.0.abs()).fold(1.0, f64::max);
        coefficients[1] *= next / reach;
        coefficients[2] *= (next / reach).powi(2);
        kept = fits;
    }
    let reach = kept.iter().map(|k| k.0.abs()).fold(1.0, f64::max);
    (kept.len() >= 3).then(|| (coefficients[1] / reach, coefficients[2] / reach.powi(2)))
}

/// A column with no more colour than this share of its light is white,
const WHITE: f64 = 0.18;
/// if it is brighter than this share of the brightest
const BRIGHT: f64 = 0.15;
/// and has less colour than this share of the coloured ones.
const UNCOLOURED: f64 = 0.5;
/// Colour beyond a white run is none of the strip where it holds less of all.
const BEYOND: f64 = 0.04;
/// Colour that is left out at each end, and how much is added there.
const ENDS: (f64, f64) = (0.004, 0.12);

/// Cuts a strip to the columns that hold light, or to those that were drawn.
pub(super) fn columns(view: View<'_>, strip: &mut Strip, is_grey: bool, drawn: Option<[f64; 2]>) {
    if let Some([from, to]) = drawn {
        strip.x0 = from;
        strip.columns = (to - from).round() as usize + 1;
        return;
    }
    let rows = rows_of(strip);
    let mut mean = vec![[0.0_f64; 3]; strip.columns];
    for v in &rows {
        for (mean, light) in mean.iter_mut().zip(row_of(view, strip, *v)) {
            mean.iter_mut()
                .zip(light)
                .for_each(|(m, l)| *m += f64::from(l));
        }
    }
    for k in 0..3 {
        let channel: Vec<f64> = mean.iter().map(|m| m[k]).collect();
        let black = percentile(&channel, 0.05);
        mean.iter_mut().for_each(|m| m[k] = (m[k] - black).max(0.0));
    }
    let most: Vec<f64> = mean.iter().map(|m| m[0].max(m[1]).max(m[2])).collect();
    let least = |m: &[f64; 3]| m[0].min(m[1]).min(m[2]);
    let colour: Vec<f64> = (mean.iter().zip(&most))
        .map(|(m, most)| if is_grey { *most } else { most - least(m) })
        .collect();
    let floor = 0.01 * largest(&colour);
    let colour: Vec<f64> = colour.iter().map(|c| (c - floor).max(0.0)).collect();
    let total: f64 = colour.iter().sum();
    if total <= 0.0 {
        return;
    }
    let (mut low, mut high) = (0, colour.len() - 1);
    if !is_grey {
        (low, high) = without_white(&most, &colour, total);
    }
    let inside: f64 = colour[low..=high].iter().sum();
    let mut sum = 0.0;
    let (mut from, mut to) = (high, high);
    for (i, c) in colour.iter().enumerate().take(high + 1).skip(low) {
        sum += c;
        if sum < ENDS.0 * inside {
            continue;
        }
        from = from.min(i);
        if sum >= (1.0 - ENDS.0) * inside {
            to = i;
            break;
        }
    }
    let more = (ENDS.1 * (to - from) as f64).round() as usize;
    let first = from.saturating_sub(more).max(low);
    let last = (to + more).min(high);
    strip.x0 += first as f64;
    strip.columns = last - first + 1;
}

/// The range of columns between white runs that stand outside the coloured part.
fn without_white(most: &[f64], colour: &[f64], total: f64) -> (usize, usize) {
    let top = largest(most);
    let coloured: Vec<f64> = colour.iter().copied().filter(|c| *c > 0.05 * top).collect();
    let level = UNCOLOURED * percentile(&coloured, 0.5);
    let is_white = |i: usize| {
        most[i] > BRIGHT * top && colour[i] < WHITE * most[i] && colour[i] < level.max(0.05 * top)
    };
    let (mut low, mut high) = (0, colour.len() - 1);
    let mut before = 0.0;
    for i in 0..colour.len() {
        before += colour[i];
        if !is_white(i) {
            continue;
        }
        if before < BEYOND * total {
            low = (i + 1).min(colour.len() - 1);
        } else if total - before < BEYOND * total && high == colour.len() - 1 {
            high = i.saturating_sub(1);
        }
    }
    if high > low {
        (low, high)
    } else {
        (0, colour.len() - 1)
    }
}
