//! From the rows of a strip to its profile: black taken off, dust evened out, doubt and clipped
//! columns told.

use super::{
    super::{
        picture::View,
        profile::Profile,
        smooth::{gaussian, median, percentile, robust_sigma},
    },
    Strip,
    rows::correlation,
    straighten::{LEAST_ALIKE, row_of, rows_of},
};

/// Rows beside the strip that tell the black level.
const BLACK_ROWS: usize = 8;
/// Rows beside the strip that are brighter than it by so much of full, in more than this share of
/// its columns, show something else than black.
const BRIGHTER: f64 = 0.02;
const MOST_BRIGHTER: f64 = 0.05;
/// Rows with this share of the strip's contrast or more are of the strip, or of something else.
const MOST_ALIKE: f64 = 0.5;
/// A row below this share of the brightness of the middle one is left out.
const LEAST_BRIGHTNESS: f64 = 0.3;
/// A column is clipped where more of its rows are at their end.
const CLIPPED: f64 = 0.05;
/// Rows that are left out at each end of a mean.
const TRIMMED: f64 = 0.15;
/// Neighbouring rows share pixels and blocks of a JPEG.
const SHARED: f64 = 1.1;
/// Share of the scatter along a strip that counts as noise.
const ALONG: f64 = 0.7;
/// A column above this share of the brightest is lit.
const LIT: f64 = 0.02;

/// The light along a strip, or along its middle row alone.
pub(super) fn profile(view: View<'_>, strip: &Strip, is_grey: bool, is_one_row: bool) -> Profile {
    let places = if is_one_row {
        vec![0.0]
    } else {
        rows_of(strip)
    };
    let rows: Vec<Vec<[f32; 3]>> = places.iter().map(|v| row_of(view, strip, *v)).collect();
    let seen = black(view, strip, &middle_of(&rows));
    let black = match &seen {
        Some(black) => black.clone(),
        None => [0, 1, 2].map(|k| {
            let all: Vec<f64> = rows.iter().flatten().map(|p| f64::from(p[k])).collect();
            vec![percentile(&all, 0.01); strip.columns]
        }),
    };
    let light: Vec<[Vec<f64>; 3]> = (rows.iter())
        .map(|row| {
            [0, 1, 2].map(|k| {
                let above = row.iter().zip(&black[k]);
                above.map(|(p, black)| f64::from(p[k]) - black).collect()
            })
        })
        .collect();
    let brightness: Vec<f64> = light.iter().map(|row| row.iter().flatten().sum()).collect();
    let middle = median(&brightness);
    let is_lit = |i: &usize| brightness[*i] > LEAST_BRIGHTNESS * middle && brightness[*i] > 0.0;
    let used: Vec<usize> = (0..rows.len()).filter(is_lit).collect();
    let used = without_strangers(used, &light);
    let scale = used.iter().map(|i| brightness[*i]).sum::<f64>() / used.len().max(1) as f64;
    let mut channels = [(); 3].map(|()| vec![0.0; strip.columns]);
    let mut scatter = [(); 3].map(|()| vec![0.0; strip.columns]);
    let effective = (0.5 * used.len() as f64).max(1.0).sqrt();
    for k in 0..3 {
        for column in 0..strip.columns {
            let values = used
                .iter()
                .map(|i| light[*i][k][column] * scale / brightness[*i]);
            let mut values: Vec<f64> = values.collect();
            channels[k][column] = trimmed_mean(&mut values);
            scatter[k][column] = SHARED * robust_sigma(&values) / effective;
        }
    }
    if is_grey {
        let mean = |c: usize| (channels[0][c] + channels[1][c] + channels[2][c]) / 3.0;
        let mean: Vec<f64> = (0..strip.columns).map(mean).collect();
        channels = [mean.clone(), mean.clone(), mean];
    }
    let sigma = [0, 1, 2].map(|k| noise(&channels[k], &scatter[k]));
    Profile {
        clipped: clipped(view, strip, &places, &used),
        channels,
        sigma,
        is_grey,
        black_seen: seen.is_some(),
        rows: used.len(),
    }
}

/// Rows without those that show something else than most do: words and lines drawn over a strip.
/// All of them where most are unlike each other, as faint ones are.
fn without_strangers(rows: Vec<usize>, light: &[[Vec<f64>; 3]]) -> Vec<usize> {
    let sums: Vec<Vec<f64>> = (rows.iter())
        .map(|i| {
            let [r, g, b] = &light[*i];
            r.iter()
                .zip(g)
                .zip(b)
                .map(|((r, g), b)| r + g + b)
                .collect()
        })
        .collect();
    let columns = sums.first().map_or(0, Vec::len);
    let of_column = |c: usize| median(&sums.iter().map(|row| row[c]).collect::<Vec<f64>>());
    let middle: Vec<f64> = (0..columns).map(of_column).collect();
    let alike: Vec<bool> = (sums.iter())
        .map(|row| correlation(row, &middle) >= LEAST_ALIKE)
        .collect();
    if 3 * alike.iter().filter(|a| **a).count() < 2 * rows.len() {
        return rows;
    }
    let kept = rows.into_iter().zip(alike).filter(|(_, alike)| *alike);
    kept.map(|(row, _)| row).collect()
}

/// The mean of the middle of a list, which is sorted by it.
fn trimmed_mean(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    let cut = (TRIMMED * values.len() as f64) as usize;
    let middle = &values[cut..values.len() - cut];
    if middle.is_empty() {
        return 0.0;
    }
    middle.iter().sum::<f64>() / middle.len() as f64
}

/// The noise of a channel: of its rows, and of its columns among each other.
fn noise(channel: &[f64], scatter: &[f64]) -> f64 {
    let top = channel.iter().copied().fold(0.0, f64::max);
    let lit = |i: &usize| channel[*i] > LIT * top;
    let places: Vec<usize> = (1..channel.len().saturating_sub(1)).filter(lit).collect();
    let of_rows: Vec<f64> = places.iter().map(|i| scatter[*i]).collect();
    let bend =
        |i: &usize| (channel[i - 1] - 2.0 * channel[*i] + channel[i + 1]).abs() / 6_f64.sqrt();
    let along: Vec<f64> = places.iter().map(bend).collect();
    // A channel without light has a noise all the same.
    median(&of_rows).hypot(ALONG * median(&along)).max(1e-6)
}

/// The median of rows, for each channel and column.
fn middle_of(rows: &[Vec<[f32; 3]>]) -> [Vec<f64>; 3] {
    [0, 1, 2].map(|k| {
        let of_column = |c: usize| {
            let all: Vec<f64> = rows.iter().map(|row| f64::from(row[c][k])).collect();
            median(&all)
        };
        (0..rows[0].len()).map(of_column).collect()
    })
}

/// How far the brightest column of all channels together stands out of the middle one.
fn contrast([r, g, b]: &[Vec<f64>; 3]) -> f64 {
    let sums = r.iter().zip(g).zip(b).map(|((r, g), b)| r + g + b);
    let sums: Vec<f64> = sums.collect();
    sums.iter().copied().fold(0.0, f64::max) - median(&sums)
}

/// The light of the rows above and below a strip, the lower of both for each column and channel;
/// `own` is that of its own rows. Words, edges and lamps beside a strip are no black, nor is what a
/// band by hand leaves of the strip.
fn black(view: View<'_>, strip: &Strip, own: &[Vec<f64>; 3]) -> Option<[Vec<f64>; 3]> {
    let [_, height] = view.size();
    let edge = strip.half + (0.25 * strip.half).max(2.0);
    let side = |sign: f64| -> Option<[Vec<f64>; 3]> {
        let rows: Vec<f64> = (0..BLACK_ROWS).map(|k| sign * (edge + k as f64)).collect();
        let lit = |v: &f64| {
            let ends = [0.0, strip.columns as f64 - 1.0].map(|k| strip.seen(k, *v).1);
            ends.iter().all(|y| *y >= 0.0 && *y <= height as f64 - 1.0)
        };
        if !rows.iter().all(lit) {
            return None;
        }
        let rows: Vec<Vec<[f32; 3]>> = rows.iter().map(|v| row_of(view, strip, *v)).collect();
        let found = middle_of(&rows);
        let is_bright = |c: &usize| (0..3).any(|k| found[k][*c] > own[k][*c] + BRIGHTER);
        let bright = (0..strip.columns).filter(is_bright).count();
        let is_dark = bright as f64 <= MOST_BRIGHTER * strip.columns as f64
            && contrast(&found) < MOST_ALIKE * contrast(own);
        is_dark.then_some(found)
    };
    let lower = match (side(-1.0), side(1.0)) {
        (Some(above), Some(below)) => [0, 1, 2].map(|k: usize| {
            let both = above[k].iter().zip(&below[k]);
            both.map(|(a, b): (&f64, &f64)| a.min(*b))
                .collect::<Vec<f64>>()
        }),
        (Some(one), None) | (None, Some(one)) => one,
        (None, None) => return None,
    };
    Some(lower.map(|channel| {
        let near = |i: usize| &channel[i.saturating_sub(4)..(i + 5).min(channel.len())];
        let calm: Vec<f64> = (0..channel.len()).map(|i| median(near(i))).collect();
        gaussian(&calm, 6.0)
    }))
}

/// Columns where a channel is at its end in some of the rows that are used.
fn clipped(view: View<'_>, strip: &Strip, places: &[f64], used: &[usize]) -> Vec<bool> {
    let is_clipped = |column: usize| {
        let full = used.iter().filter(|i| {
            let (x, y) = strip.seen(column as f64, places[**i]);
            view.is_full(x, y)
        });
        full.count() as f64 > CLIPPED * used.len() as f64
    };
    (0..strip.columns).map(is_clipped).collect()
}
