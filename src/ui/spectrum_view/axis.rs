//! The vertical axis: the scale in force and, if wanted, logarithms.

use crate::app::ticks;

/// The vertical axis: the scale in force and, if wanted, logarithms.
#[derive(Clone, Copy)]
pub(super) struct Axis {
    pub factor: f64,
    pub log: bool,
    /// Smallest value shown on a logarithmic axis.
    pub floor: f64,
}

impl Axis {
    /// Where a value of the spectrum stands; `None` when a logarithmic axis cannot show it.
    pub fn place(self, value: f64) -> Option<f64> {
        let value = value * self.factor;
        if !self.log {
            return Some(value);
        }
        (value >= self.floor).then(|| value.log10())
    }

    /// The value of the spectrum at a height.
    pub fn value(self, height: f64) -> f64 {
        let value = if self.log {
            10_f64.powf(height)
        } else {
            height
        };
        value / self.factor
    }

    /// The number written at a height.
    pub fn words(self, height: f64) -> String {
        ticks::short(if self.log {
            10_f64.powf(height)
        } else {
            height
        })
    }
}
