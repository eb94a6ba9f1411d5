//! The smooth part of a reading without its slit: Richardson and Lucy's steps, which stop at the
//! noise and make no line that was not there.

use super::kernel::Slit;
use crate::spectrum::{Band, Outside, Sampled, SpikeSettings, detect};

/// Most steps of Richardson and Lucy.
const MOST_STEPS: usize = 200;
/// A line of the result that is so far from those of the reading is a new one, nm.
const NEW_NM: f64 = 4.0;
/// The kernel on a table's own grid, a row a sample.
struct Rows(Vec<(usize, Vec<f64>)>);

impl Rows {
    fn of(nm: &[f64], slit: Slit) -> Self {
        Self(nm.iter().map(|at| slit.weights(nm, *at)).collect())
    }

    fn seen(&self, values: &[f64]) -> Vec<f64> {
        let row = |(first, weights): &(usize, Vec<f64>)| -> f64 {
            weights
                .iter()
                .zip(&values[*first..])
                .map(|(w, v)| w * v)
                .sum()
        };
        self.0.iter().map(row).collect()
    }

    fn back(&self, values: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; values.len()];
        for ((first, weights), v) in self.0.iter().zip(values) {
            for (o, w) in out[*first..].iter_mut().zip(weights) {
                *o += w * v;
            }
        }
        out
    }
}

/// What a table without lines was before the slit.
pub(super) fn sharpened(
    samples: &Sampled,
    rest: &[f64],
    sigma: Option<&[f64]>,
    slit: Slit,
) -> Vec<f64> {
    let rows = Rows::of(samples.nm(), slit);
    let seen: Vec<f64> = rest.iter().map(|v| v.max(0.0)).collect();
    let whole = rows.back(&vec![1.0; rest.len()]);
    let is_noise = |values: &[f64]| {
        let Some(sigma) = sigma else { return false };
        let again = rows.seen(values);
        let squares = (0..rest.len()).map(|i| match sigma[i] > 0.0 {
            true => ((again[i] - rest[i]) / sigma[i]).powi(2),
            false => 0.0,
        });
        squares.sum::<f64>() <= rest.len() as f64
    };
    let step = |values: &[f64]| -> Vec<f64> {
        let again = rows.seen(values);
        let ratio = seen.iter().zip(&again);
        let ratio: Vec<f64> = ratio
            .map(|(s, a)| if *a > 0.0 { s / a } else { 0.0 })
            .collect();
        let back = rows.back(&ratio);
        (0..values.len())
            .map(|i| match whole[i] > 0.0 {
                true => values[i] * back[i] / whole[i],
                false => values[i],
            })
            .collect()
    };
    let after = |steps: usize| (0..steps).fold(seen.clone(), |values, _| step(&values));
    let (mut values, mut steps) = (seen.clone(), 0);
    while steps < MOST_STEPS && !is_noise(&values) {
        values = step(&values);
        steps += 1;
    }
    let before = lines(samples, rest);
    while steps > 0 && is_new(&before, &lines(samples, &values)) {
        steps /= 2;
        values = after(steps);
    }
    // What noise took below zero stays so: none of it is light.
    if steps == 0 { rest.to_vec() } else { values }
}

/// Places of the lines that the detector finds.
fn lines(samples: &Sampled, values: &[f64]) -> Vec<f64> {
    let band = Band::new(samples.first_nm().ceil(), samples.last_nm().floor());
    let Some((band, own)) = band.ok().zip(samples.sharing(values.to_vec()).ok()) else {
        return Vec::new();
    };
    let found = detect(
        band,
        &own.on_band(band, Outside::Zero),
        SpikeSettings::default(),
    );
    found.spikes.iter().map(|s| s.spike.at_nm).collect()
}

fn is_new(before: &[f64], after: &[f64]) -> bool {
    let known = |at: &f64| before.iter().any(|b| (b - at).abs() <= NEW_NM);
    !after.iter().all(known)
}
