//! Lines of a light with their doubt: place, weight and share.
//!
//! Lines are found, not summed, so that their doubt is that of the whole analysis: with repeats it
//! is done again without each scan in turn, with one scan on twenty copies in which level, axis and
//! noise are drawn.

use super::{
    draws::normal,
    guards::lines_above_noise,
    measurement::Measurement,
    on_nm::OnWholeNm,
    repeats::{RepeatsError, mean_of, slope},
    statistics::student_95,
};
use crate::spectrum::{Band, Decomposition, Outside, SpikeSettings, detect};

/// Copies of one scan.
const COPIES: u64 = 20;
/// Half width of 95 % of copies, in their standard deviations.
const OF_COPIES: f64 = 2.1;
/// A line is the same up to this distance, nm.
const SAME_NM: f64 = 3.0;
/// A line that more than one run of five loses is uncertain.
const MOST_LOST: f64 = 0.2;

/// A line and what is known of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineWithDoubt {
    /// Place, nm.
    pub at_nm: f64,
    /// Power, value x nm.
    pub weight: f64,
    /// Its share of the light's power.
    pub share: f64,
    /// Standard uncertainties of place, weight and share; `None` for an uncertain line and where no
    /// noise is known.
    pub u: Option<[f64; 3]>,
    /// False where runs without one scan, or copies, often lose it.
    pub is_certain: bool,
}

/// The whole nm that a table reaches over.
fn band_of(of: &Measurement) -> Option<Band> {
    let inside = of.bridged();
    let (first, last) = (inside.samples.first_nm(), inside.samples.last_nm());
    Band::new(first.ceil(), last.floor()).ok()
}

/// The lines of the mean of scans, by leaving out each in turn.
///
/// # Errors
/// [`RepeatsError`] where the scans cannot be taken together.
pub fn lines_of_scans(
    mean: &Measurement,
    scans: &[Measurement],
) -> Result<Vec<LineWithDoubt>, RepeatsError> {
    let Some(band) = band_of(mean) else {
        return Ok(Vec::new());
    };
    let n = scans.len();
    let mut runs = Vec::with_capacity(n);
    for left_out in 0..n {
        let others: Vec<Measurement> = (0..n)
            .filter(|i| *i != left_out)
            .map(|i| scans[i].clone())
            .collect();
        let mean = mean_of(&others)?;
        let values = mean.samples.on_band(band, Outside::Zero);
        runs.push(detect(band, &values, SpikeSettings::default()));
    }
    // The runs share all scans but one: their spread is n - 1 times too small.
    let by = (n - 1) as f64 / (n as f64).sqrt();
    // What noise adds to the value on average is n - 1 times what leaving one out moves it by; a
    // weight above a lower hull has some.
    let bias_by = (n - 1) as f64 / student_95((n - 1) as f64);
    Ok(told(found(band, mean), &runs, |spread, bias| {
        by * spread + bias_by * bias.abs()
    }))
}

/// The lines of one scan by its own sigma, level and axis; without sigma no doubt is told.
pub fn lines_of(of: &Measurement) -> Vec<LineWithDoubt> {
    let Some(band) = band_of(of) else {
        return Vec::new();
    };
    let own = found(band, of);
    if of.sigma.is_none() {
        let lines = own.spikes.iter().map(|line| LineWithDoubt {
            at_nm: line.spike.at_nm,
            weight: line.spike.weight,
            share: line.spike.weight / own.power,
            u: None,
            is_certain: true,
        });
        return lines.collect();
    }
    let runs: Vec<Decomposition> = (1..=COPIES)
        .map(|seed| {
            let copy = copy_of(of, seed).on_band(band, Outside::Zero);
            detect(band, &copy, SpikeSettings::default())
        })
        .collect();
    told(own, &runs, |spread, bias| spread + bias.abs() / OF_COPIES)
}

/// The lines of the table itself that noise cannot have made.
fn found(band: Band, of: &Measurement) -> Decomposition {
    let on_nm = OnWholeNm::of(of, band.min_nm() as u32, band.max_nm() as u32);
    lines_above_noise(band, &on_nm, SpikeSettings::default())
}

/// Lines with the spread of some runs; `u` makes an uncertainty of a standard deviation and of the
/// mean's distance from the value.
fn told(
    own: Decomposition,
    runs: &[Decomposition],
    u: impl Fn(f64, f64) -> f64,
) -> Vec<LineWithDoubt> {
    let numbers = |parts: &Decomposition, at: f64| -> Option<[f64; 3]> {
        let away = |nm: f64| (nm - at).abs();
        let near = parts
            .spikes
            .iter()
            .filter(|s| away(s.spike.at_nm) <= SAME_NM);
        let line = near.min_by(|a, b| away(a.spike.at_nm).total_cmp(&away(b.spike.at_nm)))?;
        let (at_nm, weight) = (line.spike.at_nm, line.spike.weight);
        Some([at_nm, weight, weight / parts.power])
    };
    let line = |at: f64, value: [f64; 3]| {
        let again: Vec<[f64; 3]> = runs.iter().filter_map(|run| numbers(run, at)).collect();
        let lost = runs.len() - again.len();
        let is_certain = lost as f64 <= MOST_LOST * runs.len() as f64 && again.len() > 1;
        let doubt = |k: usize| {
            let n = again.len() as f64;
            let mean = again.iter().map(|v| v[k]).sum::<f64>() / n;
            let squares: f64 = again.iter().map(|v| (v[k] - mean).powi(2)).sum();
            u((squares / (n - 1.0)).sqrt(), mean - value[k])
        };
        LineWithDoubt {
            at_nm: value[0],
            weight: value[1],
            share: value[2],
            u: is_certain.then(|| [doubt(0), doubt(1), doubt(2)]),
            is_certain,
        }
    };
    let lines = own.spikes.iter().map(|s| {
        let (at, weight) = (s.spike.at_nm, s.spike.weight);
        line(at, [at, weight, weight / own.power])
    });
    lines.collect()
}

/// A copy of a measurement with level, axis and noise drawn.
fn copy_of(of: &Measurement, seed: u64) -> crate::spectrum::Sampled {
    let samples = &of.samples;
    let mut draws = normal(seed);
    let mut next = || draws.next().unwrap_or(0.0);
    let (level, shift) = (1.0 + of.level * next(), of.axis_nm * next());
    let slopes = slope(samples.nm(), samples.values());
    let white: Vec<f64> = (0..samples.len()).map(|_| next()).collect();
    let noise = remembered(&white, &of.memory);
    let sigma = of.sigma.as_deref().unwrap_or_default();
    let values = samples.values().iter().enumerate().map(|(i, v)| {
        level * v - shift * slopes[i] + sigma.get(i).copied().unwrap_or(0.0) * noise[i]
    });
    samples
        .sharing(values.collect())
        .unwrap_or_else(|_| samples.clone())
}

/// Noise of this memory out of white noise, by the Cholesky factor of its banded correlation.
fn remembered(white: &[f64], memory: &[f64]) -> Vec<f64> {
    let lags = memory.len();
    if lags == 0 {
        return white.to_vec();
    }
    let rho = |k: usize| if k == 0 { 1.0 } else { memory[k - 1] };
    // factor[i][k]: row i, k columns before the diagonal.
    let mut factor: Vec<Vec<f64>> = Vec::with_capacity(white.len());
    for i in 0..white.len() {
        let mut row = vec![0.0; lags + 1];
        for k in (0..=lags.min(i)).rev() {
            let j = i - k;
            let known: f64 = (k + 1..=lags.min(i))
                .filter(|l| l - k <= lags)
                .map(|l| {
                    let other: &[f64] = if k == 0 { &row } else { &factor[j] };
                    row[l] * other[l - k]
                })
                .sum();
            row[k] = match k {
                // A memory that was cut may be no correlation any more: no less than nothing.
                0 => (rho(0) - row[1..].iter().map(|v| v * v).sum::<f64>())
                    .max(0.0)
                    .sqrt(),
                _ if factor[j][0] > 0.0 => (rho(k) - known) / factor[j][0],
                _ => 0.0,
            };
        }
        factor.push(row);
    }
    let at = |i: usize| (0..=lags.min(i)).map(|k| factor[i][k] * white[i - k]).sum();
    (0..white.len()).map(at).collect()
}
