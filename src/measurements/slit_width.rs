//! The width of a slit, by lines that have none of their own.
//!
//! Two named lines of an atom at least, each alone in its window, are fitted with one width and one
//! shift of the axis common to all: weight and a parabola as ground are free. The window stays as
//! wide as the line was seen; one that shrinks with the trial width ends at the narrowest always.
//! The width is told where the lines agree when each is asked alone.

use nalgebra::{Matrix4, Vector4};

use super::{
    atoms::named,
    error::MeasurementError,
    kernel::{Kernel, Slit},
    measurement::Measurement,
    noise::noise_of,
};
use crate::spectrum::{Band, FoundSpike, Outside, SpikeSettings, detect};

/// Widths that the detector looks for, nm, the first with two named lines is taken.
const WIDTHS_NM: [f64; 6] = [4.0, 6.0, 9.0, 13.0, 18.0, 24.0];
/// Trial widths, nm.
const TRIALS_NM: [f64; 2] = [1.5, 25.0];
/// Number of trial widths.
const TRIALS: usize = 41;
/// Greatest shift of the axis, nm, and the step of its trials.
const SHIFT_NM: [f64; 2] = [1.0, 0.1];
/// Half of a line's window, in its width.
const WINDOW: f64 = 1.25;
/// No other line within so many widths.
const ALONE: f64 = 1.5;
/// Least weight of a line, in sigma times the root of its width.
const LEAST_WEIGHT: f64 = 30.0;
/// A line's own width is the common one to this share, and three of its doubts.
const SAME_WIDTH: f64 = 0.08;
/// A line's own shift is the common one to so many nm, or this share of the width.
const SAME_SHIFT: [f64; 2] = [0.35, 0.05];
/// A width is told surely up to so many nm and down to this ratio of signal to noise.
const SURE: [f64; 2] = [12.0, 50.0];

/// A line that told the width.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlitLine {
    /// Element.
    pub symbol: &'static str,
    /// True place, nm.
    pub nm: f64,
    /// Width that this line alone tells, nm.
    pub fwhm_nm: f64,
    /// So much too high it is read, nm.
    pub shift_nm: f64,
}

/// The slit of an instrument, seen in one of its tables.
#[derive(Clone, Debug, PartialEq)]
pub struct SlitFound {
    /// Shape and width.
    pub slit: Slit,
    /// Standard uncertainty of the width, nm.
    pub u: f64,
    /// Shift of the axis: so many nm too high.
    pub shift_nm: f64,
    /// The lines that agree.
    pub lines: Vec<SlitLine>,
    /// False for wide slits and noisy tables: "about".
    pub is_sure: bool,
}

/// One line's samples.
struct Window {
    symbol: &'static str,
    true_nm: f64,
    nm: Vec<f64>,
    values: Vec<f64>,
    inverse_variance: Vec<f64>,
}

/// A width and a shift, with what is left and how sharp the width's minimum is.
#[derive(Clone, Copy, Debug)]
struct Fit {
    fwhm_nm: f64,
    shift_nm: f64,
    chi: f64,
    /// Half the second derivative of chi squared against the logarithm of the width.
    bend: f64,
}

/// The slit that a table was seen through.
///
/// # Errors
/// A sentence where no two lines without width agree.
pub fn slit_of(of: &Measurement, shape: Kernel) -> Result<SlitFound, MeasurementError> {
    let sigma = of.sigma.clone().or_else(|| noise_of(&of.samples));
    let samples = &of.samples;
    let band = Band::new(samples.first_nm().ceil(), samples.last_nm().floor());
    let told = band.ok().and_then(|band| {
        let values = samples.on_band(band, Outside::Zero);
        WIDTHS_NM.into_iter().find_map(|max_width_nm| {
            let settings = SpikeSettings {
                max_width_nm,
                ..SpikeSettings::default()
            };
            let spikes = detect(band, &values, settings).spikes;
            let lines = chosen(of, sigma.as_deref(), &spikes, band);
            (lines.len() >= 2)
                .then(|| agreed(of, sigma.as_deref(), lines, shape))
                .flatten()
        })
    });
    told.ok_or_else(|| {
        MeasurementError::Meaningless(
            said!("No line without width was found: the slit cannot be told. Give its width.")
                .to_owned(),
        )
    })
}

/// Named lines that stand alone and far above the noise: element, true place, width as seen.
fn chosen(
    of: &Measurement,
    sigma: Option<&[f64]>,
    spikes: &[FoundSpike],
    band: Band,
) -> Vec<(&'static str, f64, f64)> {
    let places: Vec<f64> = spikes.iter().map(|s| s.spike.at_nm).collect();
    let step = of.samples.step_nm();
    let noise_at = |nm: f64| {
        let at = of.samples.nm().partition_point(|own| *own < nm);
        sigma.map_or(0.0, |s| s[at.min(s.len() - 1)])
    };
    let lines = named(&places, [band.min_nm(), band.max_nm()]);
    let good = lines.into_iter().filter_map(|line| {
        let own = &spikes[line.peak];
        let width = own.width_nm.max(step);
        let is_alone = places
            .iter()
            .enumerate()
            .all(|(i, at)| i == line.peak || (at - own.spike.at_nm).abs() > ALONE * width);
        let is_strong =
            own.spike.weight > LEAST_WEIGHT * noise_at(own.spike.at_nm) * (width * step).sqrt();
        (is_alone && own.peaks == 1 && is_strong).then_some((line.symbol, line.nm, width))
    });
    good.collect()
}

/// The width that at least two lines agree on.
fn agreed(
    of: &Measurement,
    sigma: Option<&[f64]>,
    lines: Vec<(&'static str, f64, f64)>,
    shape: Kernel,
) -> Option<SlitFound> {
    let windows = |width: &dyn Fn(f64) -> f64| -> Vec<Window> {
        let each = lines.iter();
        each.filter_map(|(symbol, nm, seen)| window(of, sigma, symbol, *nm, width(*seen)))
            .collect()
    };
    let first = common(&windows(&|seen| seen), shape, TRIALS_NM)?;
    let mut all = windows(&|_| first.fwhm_nm);
    while all.len() >= 2 {
        let near = [0.7 * first.fwhm_nm, 1.4 * first.fwhm_nm];
        let fit = common(&all, shape, near)?;
        let freedom: f64 = all.iter().map(|w| w.nm.len() as f64 - 4.0).sum::<f64>() - 2.0;
        let scatter = (fit.chi / freedom.max(1.0)).max(1.0);
        let alone: Vec<Fit> = all
            .iter()
            .filter_map(|w| common(std::slice::from_ref(w), shape, near))
            .collect();
        if alone.len() < all.len() {
            return None;
        }
        // How many of its allowances each line is away.
        let away = alone.iter().zip(&all).map(|(own, window)| {
            let own_scatter = (own.chi / (window.nm.len() as f64 - 6.0).max(1.0)).max(1.0);
            let u = own.fwhm_nm * (own_scatter / own.bend).sqrt();
            let width = (own.fwhm_nm - fit.fwhm_nm).abs() / (SAME_WIDTH * fit.fwhm_nm + 3.0 * u);
            let shift = (own.shift_nm - fit.shift_nm).abs()
                / SAME_SHIFT[0].max(SAME_SHIFT[1] * fit.fwhm_nm);
            width.max(shift)
        });
        let away: Vec<f64> = away.collect();
        let worst = (0..away.len()).max_by(|a, b| away[*a].total_cmp(&away[*b]))?;
        // A shift at the end of what was tried is no place where the lines fit.
        if fit.shift_nm.abs() > SHIFT_NM[0] - SHIFT_NM[1] {
            return None;
        }
        if away[worst] <= 1.0 {
            let lines = alone.iter().zip(&all).map(|(own, window)| SlitLine {
                symbol: window.symbol,
                nm: window.true_nm,
                fwhm_nm: own.fwhm_nm,
                shift_nm: own.shift_nm,
            });
            let top = of.samples.values().iter().copied().fold(0.0, f64::max);
            let noise = sigma.map_or(0.0, |s| s.iter().sum::<f64>() / s.len() as f64);
            return Some(SlitFound {
                slit: Slit {
                    shape,
                    fwhm_nm: fit.fwhm_nm,
                },
                u: fit.fwhm_nm * (scatter / fit.bend).sqrt(),
                shift_nm: fit.shift_nm,
                lines: lines.collect(),
                is_sure: fit.fwhm_nm <= SURE[0] && top >= SURE[1] * noise,
            });
        }
        all.remove(worst);
    }
    None
}

/// Width that a line near a place tells alone, nm, and its uncertainty; `None` where the window
/// holds too little.
pub(super) fn own_width(
    of: &Measurement,
    sigma: Option<&[f64]>,
    at_nm: f64,
    slit: Slit,
) -> Option<[f64; 2]> {
    let window = window(of, sigma, "", at_nm, slit.fwhm_nm)?;
    let fit = common(
        std::slice::from_ref(&window),
        slit.shape,
        [0.6 * slit.fwhm_nm, 2.5 * slit.fwhm_nm],
    )?;
    let scatter = (fit.chi / (window.nm.len() as f64 - 6.0).max(1.0)).max(1.0);
    Some([fit.fwhm_nm, fit.fwhm_nm * (scatter / fit.bend).sqrt()])
}

/// A line's samples, as far as its seen width reaches; `None` where they are too few.
fn window(
    of: &Measurement,
    sigma: Option<&[f64]>,
    symbol: &'static str,
    true_nm: f64,
    seen_nm: f64,
) -> Option<Window> {
    let step = of.samples.step_nm();
    // Four numbers of weight and ground, width and shift: eight samples at least.
    let reach = (WINDOW * seen_nm).max(4.0 * step);
    let own = of.samples.nm();
    let from = own.partition_point(|nm| *nm < true_nm - reach);
    let to = own.partition_point(|nm| *nm <= true_nm + reach);
    let top = of.samples.values()[from..to]
        .iter()
        .copied()
        .fold(0.0, f64::max);
    (to >= from + 8 && from > 0 && to < own.len()).then(|| Window {
        symbol,
        true_nm,
        nm: own[from..to].to_vec(),
        values: of.samples.values()[from..to].to_vec(),
        inverse_variance: (from..to)
            .map(|i| {
                // Rounding is noise too.
                let sigma = sigma.map_or(0.0, |s| s[i]).max(1e-6 * top);
                sigma.powi(-2)
            })
            .collect(),
    })
}

/// Width and shift common to some lines, by trial and then by the parabola through the best.
fn common(windows: &[Window], shape: Kernel, range_nm: [f64; 2]) -> Option<Fit> {
    if windows.is_empty() {
        return None;
    }
    let chi = |fwhm_nm: f64, shift: f64| -> f64 {
        let slit = Slit { shape, fwhm_nm };
        windows.iter().map(|w| w.chi(slit, shift)).sum()
    };
    let ratio = (range_nm[1] / range_nm[0]).ln() / (TRIALS - 1) as f64;
    let width = |k: f64| range_nm[0] * (ratio * k).exp();
    let shifts = (SHIFT_NM[0] / SHIFT_NM[1]).round() as i32;
    let shift = |j: f64| SHIFT_NM[1] * j;
    let trials =
        (0..TRIALS).flat_map(|k| (-shifts..=shifts).map(move |j| (k as f64, f64::from(j))));
    let (k, j) = trials
        .map(|(k, j)| ((k, j), chi(width(k), shift(j))))
        .min_by(|a, b| a.1.total_cmp(&b.1))?
        .0;
    let (mut k, mut j, mut bend) = (k, j, 0.0);
    // Each pass a parabola in shift and one in the logarithm of the width, on finer steps.
    for step in [1.0, 0.3, 0.1, 0.03] {
        let by_shift = |d: f64| chi(width(k), shift(j + d * step));
        let (at, _) = bottom(by_shift(-1.0), by_shift(0.0), by_shift(1.0));
        j = (j + at * step).clamp(-f64::from(shifts), f64::from(shifts));
        let by_width = |d: f64| chi(width(k + d * step), shift(j));
        let (at, sharp) = bottom(by_width(-1.0), by_width(0.0), by_width(1.0));
        k = (k + at * step).clamp(0.0, (TRIALS - 1) as f64);
        bend = sharp / (ratio * step).powi(2);
    }
    (bend > 0.0).then(|| Fit {
        fwhm_nm: width(k),
        shift_nm: shift(j),
        chi: chi(width(k), shift(j)),
        bend,
    })
}

/// Place of the bottom of a parabola through three neighbours, at most one step away, and half its
/// second derivative.
fn bottom(left: f64, middle: f64, right: f64) -> (f64, f64) {
    let bend = 0.5 * (left - 2.0 * middle + right);
    match bend > 0.0 {
        true => ((0.25 * (left - right) / bend).clamp(-1.0, 1.0), bend),
        false if left < right => (-1.0, 0.0),
        false => (1.0, 0.0),
    }
}

impl Window {
    /// What a slit leaves of chi squared, weight and parabola fitted.
    fn chi(&self, slit: Slit, shift_nm: f64) -> f64 {
        let middle = self.true_nm;
        let reach = self.nm[self.nm.len() - 1] - self.nm[0];
        let (mut normal, mut right) = (Matrix4::zeros(), Vector4::zeros());
        let mut whole = 0.0;
        for (i, nm) in self.nm.iter().enumerate() {
            let x = (nm - middle) / reach;
            let row = Vector4::new(
                slit.height(nm - middle - shift_nm) * slit.fwhm_nm,
                1.0,
                x,
                x * x,
            );
            let weight = self.inverse_variance[i];
            normal += weight * row * row.transpose();
            right += weight * self.values[i] * row;
            whole += weight * self.values[i].powi(2);
        }
        let Some(solved) = normal.cholesky().map(|c| c.solve(&right)) else {
            return f64::INFINITY;
        };
        (whole - solved.dot(&right)).max(0.0)
    }
}
