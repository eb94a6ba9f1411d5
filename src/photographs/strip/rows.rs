//! Rows of a small picture in which a strip lies, and how it is turned.

use super::{
    super::smooth::{gaussian, percentile},
    MOST_TURN_DEG,
    small::Light,
};

/// Rows that hold a strip, in pixels of the photograph.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rows {
    pub turn_deg: f64,
    /// Their middle in the middle of the picture.
    pub middle: f64,
    pub half: f64,
    /// Correlation of its rows, times the root of its share of the chroma.
    pub strength: f64,
}

/// Rows above this share of the strongest belong to a strip.
const RUN: f64 = 0.18;
/// Least size of a strip: rows of the small picture, and share of the chroma.
const LEAST_ROWS: usize = 3;
const LEAST_SHARE: f64 = 0.08;
/// Columns that a turn is fitted to are above this share of bright ones.
const LIT: f64 = 0.15;

/// Rows of the small picture.
#[derive(Clone, Copy)]
struct Run {
    first: usize,
    last: usize,
    /// Of the chroma of all rows.
    share: f64,
}

impl Run {
    /// How alike its rows are, times the root of its share.
    fn strength(&self, light: &Light, slope: f64) -> f64 {
        alike(light, slope, self.first, self.last) * self.share.sqrt()
    }
}

/// The strips of a picture, the strongest first.
pub(super) fn strips(light: &Light, turn_deg: Option<f64>) -> Vec<Rows> {
    let runs = runs(light, turn_deg.unwrap_or(0.0).to_radians().tan());
    let mut found: Vec<Rows> = (runs.iter())
        .filter_map(|run| {
            let mut middle = 0.5 * (run.first + run.last) as f64;
            let mut reach = 0.5 * (run.last - run.first + 1) as f64;
            let mut turn = turn_deg.unwrap_or(0.0).to_radians().tan();
            let mut last = *run;
            for _ in 0..3 {
                if turn_deg.is_none() {
                    (turn, middle) = turned(light, turn, middle, 1.3 * reach)?;
                }
                last = run_near(light, turn, middle)?;
                middle = 0.5 * (last.first + last.last) as f64;
                reach = 0.5 * (last.last - last.first + 1) as f64;
            }
            let scale = light.block as f64;
            Some(Rows {
                turn_deg: turn.atan().to_degrees(),
                middle: (middle + 0.5) * scale - 0.5,
                half: reach * scale * turn.atan().cos(),
                strength: last.strength(light, turn),
            })
        })
        .collect();
    found.sort_by(|a, b| b.strength.total_cmp(&a.strength));
    // Two runs may lead to one strip.
    let mut kept: Vec<Rows> = Vec::new();
    for one in found {
        let is_new = |k: &Rows| (k.middle - one.middle).abs() > k.half.min(one.half);
        if kept.iter().all(is_new) {
            kept.push(one);
        }
    }
    kept
}

/// Chroma of a place of the picture turned by a slope: between rows, none beside it.
fn turned_chroma(light: &Light, slope: f64, x: usize, row: f64, most: f64) -> f64 {
    let [width, height] = light.size;
    let y = row + slope * (x as f64 - 0.5 * (width as f64 - 1.0));
    if y < 0.0 || y > (height - 1) as f64 {
        return 0.0;
    }
    let above = y as usize;
    let part = y - above as f64;
    let at = |row: usize| light.chroma[row.min(height - 1) * width + x].min(most);
    at(above) * (1.0 - part) + at(above + 1) * part
}

/// The sums of rows of the turned picture.
fn sums(light: &Light, slope: f64) -> Vec<f64> {
    let [width, height] = light.size;
    let sum = |y: usize| {
        (0..width)
            .map(|x| turned_chroma(light, slope, x, y as f64, light.most))
            .sum::<f64>()
    };
    gaussian(&(0..height).map(sum).collect::<Vec<f64>>(), 1.0)
}

/// Runs of strong rows.
fn runs(light: &Light, slope: f64) -> Vec<Run> {
    let sums = sums(light, slope);
    let least = RUN * percentile(&sums, 0.99);
    let total: f64 = sums.iter().sum();
    let mut runs = Vec::new();
    let mut start = None;
    for y in 0..=sums.len() {
        let is_strong = y < sums.len() && sums[y] > least && least > 0.0;
        match (start, is_strong) {
            (None, true) => start = Some(y),
            (Some(first), false) => {
                start = None;
                let share = sums[first..y].iter().sum::<f64>() / total;
                if y - first >= LEAST_ROWS && share >= LEAST_SHARE {
                    runs.push(Run {
                        first,
                        last: y - 1,
                        share,
                    });
                }
            }
            _ => {}
        }
    }
    runs
}

/// The run of the turned picture that a row lies in or next to.
fn run_near(light: &Light, slope: f64, row: f64) -> Option<Run> {
    let away = |run: &Run| {
        let (first, last) = (run.first as f64, run.last as f64);
        (first - row).max(row - last).max(0.0)
    };
    let runs = runs(light, slope).into_iter();
    runs.min_by(|a, b| away(a).total_cmp(&away(b)))
}

/// The mean correlation of rows with their mean.
fn alike(light: &Light, slope: f64, first: usize, last: usize) -> f64 {
    let width = light.size[0];
    let row = |y: usize| -> Vec<f64> {
        (0..width)
            .map(|x| turned_chroma(light, slope, x, y as f64, f64::MAX))
            .collect()
    };
    let rows: Vec<Vec<f64>> = (first..=last).map(row).collect();
    let mut mean = vec![0.0; width];
    for row in &rows {
        mean.iter_mut().zip(row).for_each(|(m, v)| *m += v);
    }
    let all: f64 = rows.iter().map(|row| correlation(row, &mean)).sum();
    (all / rows.len() as f64).max(0.01)
}

/// Pearson's correlation; 0 where a list is flat.
pub(super) fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let count = a.len().min(b.len()) as f64;
    let mean = |v: &[f64]| v.iter().sum::<f64>() / count;
    let (ma, mb) = (mean(a), mean(b));
    let mut sums = [0.0; 3];
    for (a, b) in a.iter().zip(b) {
        let (a, b) = (a - ma, b - mb);
        sums[0] += a * b;
        sums[1] += a * a;
        sums[2] += b * b;
    }
    let scale = (sums[1] * sums[2]).sqrt();
    if scale > 0.0 { sums[0] / scale } else { 0.0 }
}

/// The slope and middle of a line through the middles of the light in each column.
fn turned(light: &Light, slope: f64, middle: f64, reach: f64) -> Option<(f64, f64)> {
    let [width, height] = light.size;
    let centre = 0.5 * (width as f64 - 1.0);
    let mut columns = Vec::new();
    for x in 0..width {
        let at = middle + slope * (x as f64 - centre);
        let from = (at - reach).floor().max(0.0) as usize;
        let to = (at + reach).ceil().clamp(0.0, height as f64 - 1.0) as usize;
        let rows = (from..=to).map(|y| (y as f64, light.chroma[y * width + x]));
        let (sum, moment) = rows.fold((0.0, 0.0), |(s, m), (y, c)| (s + c, m + c * y));
        if sum > 0.0 {
            columns.push((x as f64 - centre, moment / sum, sum));
        }
    }
    let sums: Vec<f64> = columns.iter().map(|c| c.2).collect();
    let least = LIT * percentile(&sums, 0.95);
    columns.retain(|c| c.2 > least);
    let (mut slope, mut middle) = (slope, middle);
    for _ in 0..6 {
        let off: Vec<f64> = columns
            .iter()
            .map(|(x, y, _)| y - middle - slope * x)
            .collect();
        let distances: Vec<f64> = off.iter().map(|o| o.abs()).collect();
        let scale = (1.5 * percentile(&distances, 0.5)).max(0.3);
        let mut sums = [0.0; 5];
        for ((x, y, light), off) in columns.iter().zip(&off) {
            let weight = light / (1.0 + (off / scale).powi(2));
            let parts = [1.0, *x, *y, x * x, x * y];
            sums.iter_mut()
                .zip(parts)
                .for_each(|(sum, part)| *sum += weight * part);
        }
        let [w, x, y, xx, xy] = sums;
        let spread = w * xx - x * x;
        if w <= 0.0 || spread <= 0.0 {
            return None;
        }
        slope = (w * xy - x * y) / spread;
        middle = (y - slope * x) / w;
    }
    let most = MOST_TURN_DEG.to_radians().tan();
    Some((slope.clamp(-most, most), middle))
}
