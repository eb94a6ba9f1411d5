//! The axis of a photograph: which lamp's lines its peaks are, and how sure that is.
//!
//! Axes are suggested by pairs of peaks and landmarks (`search`), refined and scored (`refine`), held
//! against those beside them (`beside`) and judged (`odds`, `judged`): found, suggested, or nothing
//! can be said. A wrong axis shown as right is the one fault that is not allowed.

mod beside;
mod curve;
mod judged;
mod odds;
mod pins;
mod refine;
mod search;
mod verdict;

pub use curve::{Curve, LeftOut};
pub use judged::State;
pub use pins::{Pin, PinError, snapped, through_pins, with_line_at};
pub use refine::{Match, Solution};
pub use verdict::{Answer, Wanted, find};

use super::peaks::{Peak, Peaks};

/// Input of the search for an axis.
struct Scene<'p> {
    peaks: &'p Peaks,
    columns: usize,
    /// Places and wavelengths that the axis must keep, with how far it may be off.
    pins: Vec<(Pin, f64)>,
    /// Wavelengths fall along the strip, where that is known.
    falls: Option<bool>,
}

impl Scene<'_> {
    /// A place in columns as the axis counts it.
    fn x_of(&self, px: f64) -> f64 {
        px / self.columns as f64 - 0.5
    }

    fn x(&self, peak: usize) -> f64 {
        self.x_of(self.peaks.peaks[peak].px)
    }

    /// Cost of a peak's colour at a wavelength.
    fn colour_cost(&self, peak: usize, nm: f64) -> f64 {
        let peak: &Peak = &self.peaks.peaks[peak];
        peak.hue.map_or(0.0, |hue| hue.cost(nm))
    }

    /// True if an axis keeps the pins.
    fn is_kept(&self, nm: impl Fn(f64) -> f64) -> bool {
        let is_near = |(pin, most): &(Pin, f64)| (nm(pin.px) - pin.nm).abs() <= *most;
        self.pins.iter().all(is_near)
    }

    /// The width of lines on an axis.
    fn width_nm(&self, curve: &Curve) -> f64 {
        self.peaks.width_px * curve.c[1].abs() / curve.scale_px
    }

    /// The wavelengths of the first and last column, the shorter first.
    fn range_nm(&self, curve: &Curve) -> (f64, f64) {
        let ends = [curve.nm(0.0), curve.nm(self.columns as f64 - 1.0)];
        (ends[0].min(ends[1]), ends[0].max(ends[1]))
    }

    /// The least height at which a line is missed.
    fn visible(&self) -> f64 {
        let mut heights: Vec<f64> = self.peaks.peaks.iter().map(|p| p.height).collect();
        heights.sort_by(f64::total_cmp);
        let second = heights.get(1).copied().unwrap_or(0.0);
        self.peaks.limit.max(0.7 * second)
    }
}
