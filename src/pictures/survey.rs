//! Survey of a picture before any decision: its mean, its noise, a sample of its pixels.

use crate::{spectrum::quantile, study::Progress};

use super::strips::over_strips;
use super::{Bands, PictureError, Pixels, STRIP_ROWS};

/// Most pixels of the sample that a choice is made on.
pub(super) const MOST_SAMPLED: usize = 4096;

/// Standard deviation of a normal number over the median of its absolute value: 1 / .67449, the
/// upper quartile of the normal distribution.
const NORMAL_OVER_MEDIAN: f64 = 1.4826;

/// A known light counts as at least this share of its mean where it is divided out: below a
/// thousandth the quotient of a 10-bit camera is noise alone.
const LEAST_LIGHT: f64 = 1e-3;

/// Statistics of a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Survey {
    /// Mean of the measured pixels, a value a band.
    pub mean: Vec<f64>,
    /// The 95th percentile, band by band, of the sample: it finds a lamp that few pixels see.
    pub high: Vec<f64>,
    /// Noise of each band.
    pub noise: Vec<f64>,
    /// Pixels with a number in every band.
    pub measured: usize,
    /// Pixels without.
    pub no_data: usize,
    /// Pixels on an even grid that were measured, one after the other.
    pub sample: Vec<Vec<f64>>,
}

impl Survey {
    /// Looks at every pixel once.
    ///
    /// # Errors
    /// [`PictureError::NothingMeasured`], [`PictureError::AllZero`], and those of the source.
    pub fn of(pixels: &dyn Pixels, progress: &Progress) -> Result<Self, PictureError> {
        let (width, height) = pixels.size();
        let bands = pixels.bands().len();
        let step = ((width * height) as f64 / MOST_SAMPLED as f64)
            .sqrt()
            .ceil()
            .max(1.0) as usize;
        let is_sampled = |x: usize, y: usize| {
            let middle = |at: usize, size: usize| at % step == (step / 2).min(size - 1);
            middle(x, width) && middle(y, height)
        };
        progress.expect(height.div_ceil(STRIP_ROWS));
        let parts = over_strips(pixels, STRIP_ROWS, progress, |strip| {
            let mut sums = vec![0.0; bands];
            let mut good = vec![true; strip.pixels];
            for band in strip.values.chunks_exact(strip.pixels) {
                good.iter_mut()
                    .zip(band)
                    .for_each(|(good, v)| *good &= v.is_finite());
            }
            for (sum, band) in sums.iter_mut().zip(strip.values.chunks_exact(strip.pixels)) {
                let values = band.iter().zip(&good).filter(|(_, good)| **good);
                *sum = values.map(|(v, _)| f64::from(*v)).sum::<f64>();
            }
            let all_good: Vec<usize> = (0..strip.pixels).filter(|i| good[*i]).collect();
            let on_grid = |i: &&usize| is_sampled(**i % width, strip.first + **i / width);
            let mut sampled: Vec<usize> = all_good.iter().filter(on_grid).copied().collect();
            if sampled.is_empty() {
                // A few measured pixels may all lie beside the grid.
                sampled.extend(all_good.first());
            }
            let value = |j: usize, i: usize| f64::from(strip.values[j * strip.pixels + i]);
            let pixel = |i: &usize| (0..bands).map(|j| value(j, *i)).collect();
            let sample: Vec<Vec<f64>> = sampled.iter().map(pixel).collect();
            Ok((sums, all_good.len(), sample))
        })?;
        let mut mean = vec![0.0; bands];
        let (mut measured, mut sample) = (0, Vec::new());
        for (sums, count, pixels) in parts {
            mean.iter_mut().zip(sums).for_each(|(m, s)| *m += s);
            measured += count;
            sample.extend(pixels);
        }
        if measured == 0 {
            return Err(PictureError::NothingMeasured);
        }
        mean.iter_mut().for_each(|m| *m /= measured as f64);
        if mean.iter().all(|m| *m == 0.0) && sample.iter().flatten().all(|v| *v == 0.0) {
            return Err(PictureError::AllZero);
        }
        sample.truncate(2 * MOST_SAMPLED);
        let high = |band: usize| {
            let mut values: Vec<f64> = sample.iter().map(|p| p[band]).collect();
            percentile(&mut values, 0.95)
        };
        Ok(Self {
            high: (0..bands).map(high).collect(),
            noise: noise_of(&sample, bands, &[]),
            mean,
            measured,
            no_data: width * height - measured,
            sample,
        })
    }

    /// The noise of a band in the middle of all.
    pub(crate) fn usual_noise(&self) -> f64 {
        median(&mut self.noise.clone())
    }

    /// Noise of each band of a picture that a known light lit: neighbours are compared after the
    /// light is divided out, so that its lines are not taken for noise.
    pub(crate) fn noise_under(&self, light: &[f64]) -> Vec<f64> {
        noise_of(&self.sample, self.mean.len(), light)
    }

    /// That of a band in the middle of all.
    pub(crate) fn usual_noise_under(&self, light: &[f64]) -> f64 {
        median(&mut self.noise_under(light))
    }

    /// Noise relative to what there is, bands weighed by their widths as in the relative rms: what
    /// no relative rms need go below.
    pub(crate) fn relative_noise(&self, bands: &Bands) -> f64 {
        let squares = |values: &[f64]| {
            let weighed = values.iter().zip(bands.weights_nm());
            weighed.map(|(v, q)| q * v * v).sum::<f64>()
        };
        let signal = self.sample.iter().map(|p| squares(p)).sum::<f64>() / self.sample.len() as f64;
        if signal > 0.0 {
            (squares(&self.noise) / signal).sqrt()
        } else {
            0.0
        }
    }
}

/// The value that a share (0-1) of all lies below; 0 of none.
pub(super) fn percentile(values: &mut [f64], share: f64) -> f64 {
    quantile(values, share).unwrap_or(0.0)
}

fn median(values: &mut [f64]) -> f64 {
    percentile(values, 0.5)
}

/// `1.4826 median |p_j - (p_(j-1) + p_(j+1))/2| / sqrt 1.5` under an even light, of which there is
/// no value; the ends are as noisy as their neighbours.
fn noise_of(sample: &[Vec<f64>], bands: usize, light: &[f64]) -> Vec<f64> {
    let g = |j: usize| light.get(j).copied().unwrap_or(1.0).max(LEAST_LIGHT);
    let mut noise = vec![0.0; bands];
    for j in 1..bands - 1 {
        let (left, right) = (0.5 * g(j) / g(j - 1), 0.5 * g(j) / g(j + 1));
        let spread = (1.0 + left * left + right * right).sqrt();
        let off = |p: &Vec<f64>| (p[j] - left * p[j - 1] - right * p[j + 1]).abs();
        let mut values: Vec<f64> = sample.iter().map(off).collect();
        noise[j] = NORMAL_OVER_MEDIAN * median(&mut values) / spread;
    }
    noise[0] = noise[1];
    noise[bands - 1] = noise[bands - 2];
    noise
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spectrum::Kind;

    #[test]
    fn a_percentile_lies_between_its_ranks() {
        // Of 0, 1, .. 20 the 95th is 19, of 0, .. 10 it is 9.5; of one number the number.
        let of = |count: i32| {
            percentile(
                &mut (0..=count).rev().map(f64::from).collect::<Vec<_>>(),
                0.95,
            )
        };
        assert_eq!((of(20), of(10), of(0)), (19.0, 9.5, 0.0));
    }

    #[test]
    fn the_noise_of_wide_bands_counts_as_their_signal_does() {
        // A flat signal of 1 and noise .1 in the last, ten times wider, band alone: the widths are
        // half the way to each neighbour, 5, 10, 10, 55 and 50 nm of 130.
        let bands = Bands::new(vec![400.0, 410.0, 420.0, 430.0, 530.0], Kind::Light).unwrap();
        let survey = Survey {
            mean: vec![1.0; 5],
            high: vec![1.0; 5],
            noise: vec![0.0, 0.0, 0.0, 0.0, 0.1],
            measured: 1,
            no_data: 0,
            sample: vec![vec![1.0; 5]],
        };
        let found = survey.relative_noise(&bands);
        assert!(
            (found - 0.1 * (50.0_f64 / 130.0).sqrt()).abs() < 1e-15,
            "{found}"
        );
    }

    #[test]
    fn the_percentile_that_chooses_is_the_one_that_is_told() {
        let mut tally = super::super::measure::Tally::default();
        let mut off: Vec<f64> = (1..=20).map(|i| 0.11 * f64::from(i)).collect();
        off.iter().for_each(|v| tally.add(*v));
        let spread = crate::study::Spread::of(&off).expect("twenty");
        let chosen = percentile(&mut off, 0.95);
        // Rank 18.05 of 20 by hand, and bins a 2000th of their size wide.
        assert!((chosen - 0.11 * 19.05).abs() < 1e-12);
        assert!((spread.p95 - chosen).abs() < 1e-12);
        assert!((tally.spread().p95 / chosen - 1.0).abs() < 1e-3);
    }
}
