//! Errors of a model against the spectrum it represents.
//!
//! With `m` the measured spectrum on the 1 nm grid and `d` the model (each spike split linearly
//! over its two neighbouring nm) minus `m`:
//!
//! ```text
//! Rms         sqrt(int d^2 / int m^2)
//! RmsBlurred  the same after a Gaussian blur of 10 nm full width, zero outside the range, spikes
//!             blurred analytically
//! MaxAbs      max |d| / max |m|
//! Energy      int d / int |m|
//! Lowest      min(smooth) / max |m|
//! Displacement  see displacement.rs
//! ```

use super::{
    displacement::displacement_nm,
    measure::{Measure, Verdict},
};
use crate::spectrum::{Band, Line, absolute_power, add_lines, quantile};

/// Full width at half maximum of the blur, nm.
pub(crate) const BLUR_NM: f64 = 10.0;

/// A Gaussian blur on a band's grid.
#[derive(Clone, Debug)]
pub struct Blur {
    band: Band,
    /// Density at 0, 1, 2, ... nm from the centre, per nm.
    taps: Vec<f64>,
    sigma_nm: f64,
}

/// Taps reach this many standard deviations: what lies beyond is under 1e-8 of the area.
const REACH_SIGMAS: f64 = 6.0;

impl Blur {
    /// A blur of full width `width_nm` at half maximum.
    pub(crate) fn new(band: Band, width_nm: f64) -> Self {
        let sigma_nm = width_nm / (8.0 * std::f64::consts::LN_2).sqrt();
        let reach = (REACH_SIGMAS * sigma_nm).ceil() as usize;
        Self {
            band,
            taps: (0..=reach).map(|i| density(i as f64, sigma_nm)).collect(),
            sigma_nm,
        }
    }

    /// Values on the grid blurred by the trapezoid rule; zero is assumed outside the band.
    pub(crate) fn values(&self, values: &[f64]) -> Vec<f64> {
        let n = self.band.points();
        let reach = self.taps.len() - 1;
        // Weighted and padded once, so that the inner loop has no edge.
        let mut padded = vec![0.0; n + 2 * reach];
        for (i, v) in values.iter().enumerate() {
            padded[reach + i] = v * self.band.weight(i);
        }
        let mut out: Vec<f64> = padded[reach..reach + n]
            .iter()
            .map(|v| v * self.taps[0])
            .collect();
        for (k, tap) in self.taps.iter().enumerate().skip(1) {
            let (left, right) = (&padded[reach - k..], &padded[reach + k..]);
            for (o, (l, r)) in out.iter_mut().zip(left.iter().zip(right)) {
                *o += tap * (l + r);
            }
        }
        out
    }

    /// Adds spikes, blurred analytically, to values that are blurred already.
    pub(crate) fn add_lines(&self, spikes: &[Line], blurred: &mut [f64]) {
        let reach = self.taps.len() as f64;
        for spike in spikes {
            let centre = spike.at_nm - self.band.min_nm();
            let from = (centre - reach).floor().max(0.0) as usize;
            let to = ((centre + reach).ceil().max(0.0) as usize).min(blurred.len());
            for (i, b) in blurred.iter_mut().enumerate().take(to).skip(from) {
                *b += spike.weight * density(i as f64 - centre, self.sigma_nm);
            }
        }
    }
}

fn density(distance_nm: f64, sigma_nm: f64) -> f64 {
    let t = distance_nm / sigma_nm;
    (-0.5 * t * t).exp() / (sigma_nm * (2.0 * std::f64::consts::PI).sqrt())
}

/// Compares a model with the measured spectrum, by shares alone; `None` for an all-zero spectrum.
///
/// `measured` and `smooth` are values on the band's grid.
pub(crate) fn spectrum_errors(
    blur: &Blur,
    measured: &[f64],
    smooth: &[f64],
    spikes: &[Line],
) -> Option<Verdict> {
    let band = blur.band;
    let unit = height(measured)?;
    // Everything as a share of the largest value, so that no square overflows or vanishes.
    let measured = &times(measured, unit);
    let smooth = &times(smooth, unit);
    let spikes = &spikes_times(spikes, unit);
    let square = band.inner(measured, measured);
    let smooth_difference: Vec<f64> = smooth.iter().zip(measured).map(|(s, m)| s - m).collect();
    let mut whole = smooth_difference.clone();
    add_lines(band, spikes, &mut whole);
    let mut blurred = blur.values(&smooth_difference);
    blur.add_lines(spikes, &mut blurred);
    let blurred_measured = blur.values(measured);
    let blurred_square = band.inner(&blurred_measured, &blurred_measured);
    Some(Verdict::from_fn(|measure| match measure {
        Measure::Own | Measure::Patches | Measure::PatchesWorst | Measure::Filters => None,
        Measure::Rms => Some((band.inner(&whole, &whole) / square).sqrt()),
        Measure::RmsBlurred => Some((band.inner(&blurred, &blurred) / blurred_square).sqrt()),
        Measure::MaxAbs => Some(whole.iter().fold(0.0_f64, |m, v| m.max(v.abs()))),
        Measure::Energy => Some(band.integral(&whole) / absolute_power(band, measured)),
        Measure::Lowest => Some(smooth.iter().copied().fold(f64::INFINITY, f64::min)),
        Measure::Displacement => displacement_nm(band, measured, smooth, spikes),
    }))
}

/// A quotient of what is not negative, where there is one.
pub(super) fn ratio(part: f64, whole: f64) -> Option<f64> {
    Some(part / whole).filter(|share| whole > 0.0 && share.is_finite())
}

/// One over the largest absolute value; `None` for an all-zero spectrum.
pub fn height(values: &[f64]) -> Option<f64> {
    let top = values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    Some(1.0 / top).filter(|unit| unit.is_finite())
}

/// Values times a factor.
pub fn times(values: &[f64], factor: f64) -> Vec<f64> {
    values.iter().map(|v| v * factor).collect()
}

/// Spikes with their weights times a factor.
pub(crate) fn spikes_times(spikes: &[Line], factor: f64) -> Vec<Line> {
    let times = |s: &Line| s.weighing(s.weight * factor);
    spikes.iter().map(times).collect()
}

/// Median, 95th percentile and largest of a set of errors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// Half of the values lie below.
    pub median: f64,
    /// 95 % of the values lie below.
    pub p95: f64,
    /// The largest.
    pub worst: f64,
}

impl Spread {
    /// The spread of some values, by linear interpolation between ranks; `None` for no value.
    pub fn of(values: &[f64]) -> Option<Self> {
        let mut values = values.to_vec();
        let worst = values.iter().copied().max_by(f64::total_cmp)?;
        Some(Self {
            median: quantile(&mut values, 0.5)?,
            p95: quantile(&mut values, 0.95)?,
            worst,
        })
    }
}
