//! The peaks of a measured curve, which are what names are looked for.

use crate::spectrum::{Band, Outside, Sampled};

/// Something that stands up from a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// Centroid of what stands above its foot, nm.
    pub at_nm: f64,
    /// How far one must come down on both sides before climbing higher, in the curve's unit.
    pub height: f64,
    /// Where it is half as high, nm.
    pub half_nm: [f64; 2],
}

impl Peak {
    /// Full width at half its height, nm.
    pub fn width_nm(&self) -> f64 {
        self.half_nm[1] - self.half_nm[0]
    }

    /// Height times width, which is nearly its power.
    pub(super) fn power(&self) -> f64 {
        self.height * self.width_nm()
    }

    /// Whether a wavelength lies where it is more than half as high.
    pub(super) fn is_over(&self, at_nm: f64) -> bool {
        (self.half_nm[0]..=self.half_nm[1]).contains(&at_nm)
    }
}

/// Where lines are looked for, nm: no lamp's names depend on what lies outside.
const RANGE_NM: [f64; 2] = [340.0, 860.0];
/// Finer data is averaged to this step, which parts all lines that names are of, nm.
const FINEST_NM: f64 = 0.75;
/// A foot is looked for this far from a peak, nm.
const WINDOW_NM: f64 = 25.0;
/// What is lower than this share of the curve's highest value is not looked at.
const LOWEST: f64 = 0.003;
/// What stands up by less than this share of the curve there is a ripple.
const RIPPLE: f64 = 0.03;
/// So few steps above half a peak's height do not tell its place.
const FEW: usize = 2;
/// What is wider is a colour, not a line or a phosphor's band, nm.
const WIDEST_NM: f64 = 20.0;

/// A curve as its table has it, within the range of names, by rising wavelength.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Points {
    pub nm: Vec<f64>,
    pub values: Vec<f64>,
    /// Mean step, nm.
    pub step_nm: f64,
}

impl Points {
    /// The points of a table: its own, averaged to 1 nm where they are finer.
    pub(super) fn of(samples: &Sampled, outside: Outside) -> Self {
        let inside = |nm: &f64| (RANGE_NM[0]..=RANGE_NM[1]).contains(nm);
        let own = samples.nm().iter().zip(samples.values());
        let (nm, values): (Vec<f64>, Vec<f64>) = own.filter(|(nm, _)| inside(nm)).unzip();
        let [Some(first), Some(last)] = [nm.first().copied(), nm.last().copied()] else {
            return Self::default();
        };
        let step_nm = (last - first) / (nm.len().max(2) - 1) as f64;
        if step_nm >= FINEST_NM {
            return Self {
                nm,
                values,
                step_nm,
            };
        }
        match Band::new(first.ceil(), last.floor()) {
            Ok(band) => Self {
                nm: band.grid().collect(),
                values: samples.on_band(band, outside),
                step_nm: 1.0,
            },
            Err(_) => Self::default(),
        }
    }

    /// The highest value; 0 in the dark.
    pub(super) fn top(&self) -> f64 {
        self.values.iter().copied().fold(0.0, f64::max)
    }

    /// The value at a wavelength, along straight lines; `None` outside.
    pub(super) fn at(&self, at_nm: f64) -> Option<f64> {
        let right = self.nm.partition_point(|nm| *nm < at_nm);
        if right == 0 {
            return (self.nm.first() == Some(&at_nm)).then(|| self.values[0]);
        }
        let (x, y) = (self.nm.get(right)?, self.values[right]);
        let (x0, y0) = (self.nm[right - 1], self.values[right - 1]);
        Some(y0 + (y - y0) * (at_nm - x0) / (x - x0))
    }

    /// The median of the values between two wavelengths; 0 where there are none.
    pub(super) fn median(&self, from_nm: f64, to_nm: f64) -> f64 {
        let places = self.nm.iter().zip(&self.values);
        let within = places.filter(|(nm, _)| (from_nm..=to_nm).contains(*nm));
        let mut values: Vec<f64> = within.map(|(_, v)| *v).collect();
        values.sort_by(f64::total_cmp);
        values.get(values.len() / 2).copied().unwrap_or(0.0)
    }

    /// The sum of values times the step.
    pub(super) fn power(&self) -> f64 {
        self.step_nm * self.values.iter().sum::<f64>()
    }

    /// All peaks that may be lines or bands, by rising wavelength.
    pub(super) fn peaks(&self) -> Vec<Peak> {
        let (values, top) = (&self.values, self.top());
        let mut peaks = Vec::new();
        for first in 1..values.len().saturating_sub(1) {
            let here = values[first];
            if here <= values[first - 1] {
                continue;
            }
            let plateau = values[first..].iter().take_while(|v| **v == here).count();
            let last = first + plateau - 1;
            if values.get(last + 1).is_none_or(|next| *next > here) {
                continue;
            }
            let foot = self.foot(first, last);
            let height = here - foot;
            if height < LOWEST * top || height < RIPPLE * here {
                continue;
            }
            let peak = self.shaped([first, last], foot);
            if peak.width_nm() <= WIDEST_NM {
                peaks.push(peak);
            }
        }
        peaks
    }

    /// The higher of the lowest values on both sides, as far as the curve does not climb above
    /// the peak.
    fn foot(&self, first: usize, last: usize) -> f64 {
        let here = self.values[first];
        let lowest = |side: &mut dyn Iterator<Item = usize>| {
            side.take_while(|i| (self.nm[*i] - self.nm[first]).abs() <= WINDOW_NM)
                .map(|i| self.values[i])
                .take_while(|v| *v <= here)
                .fold(here, f64::min)
        };
        let left = lowest(&mut (0..first).rev());
        left.max(lowest(&mut (last + 1..self.values.len())))
    }

    /// Centroid and half width of a peak between two points of equal height.
    fn shaped(&self, [first, last]: [usize; 2], foot: f64) -> Peak {
        let (nm, values) = (&self.nm, &self.values);
        let height = values[first] - foot;
        let half = foot + 0.5 * height;
        let low = (0..first).rev().find(|i| values[*i] <= half);
        let high = (last + 1..values.len()).find(|i| values[*i] <= half);
        // Straight lines cross the half height between its last point above and the one below.
        let crossing = |above: usize, below: usize| {
            let share = (values[above] - half) / (values[above] - values[below]);
            nm[above] + (nm[below] - nm[above]) * share
        };
        let left = low.map_or(nm[0], |i| crossing(i + 1, i));
        let right = high.map_or(nm[nm.len() - 1], |i| crossing(i - 1, i));
        let from = low.map_or(0, |i| i + 1);
        let to = high.map_or(values.len() - 1, |i| i - 1);
        // Where few points stand above half the height, those beside them tell where between them
        // the peak is.
        let (from, to, ground) = if to - from < FEW {
            (from.min(first - 1), to.max(last + 1), foot)
        } else {
            (from, to, half)
        };
        let weights = (from..=to).map(|i| (nm[i], (values[i] - ground).max(0.0)));
        let (mut sum, mut moment) = (0.0, 0.0);
        for (nm, weight) in weights {
            sum += weight;
            moment += weight * nm;
        }
        Peak {
            at_nm: moment / sum,
            height,
            half_nm: [left, right],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(step_nm: f64, of: impl Fn(f64) -> f64) -> Points {
        let count = (400.0 / step_nm) as usize + 1;
        let nm: Vec<f64> = (0..count).map(|i| 380.0 + step_nm * i as f64).collect();
        let values = nm.iter().map(|nm| of(*nm)).collect();
        Points {
            nm,
            values,
            step_nm,
        }
    }

    fn bell(nm: f64, at: f64, width: f64) -> f64 {
        (-4.0 * 2.0_f64.ln() * ((nm - at) / width).powi(2)).exp()
    }

    #[test]
    fn a_line_on_a_glow_keeps_its_place_height_and_width() {
        let peaks = points(1.0, |nm| 0.5 + 2.0 * bell(nm, 546.07, 4.0)).peaks();
        let [peak] = peaks[..] else {
            panic!("{peaks:?}");
        };
        // The centroid of samples above half height is a tenth of a step off at most.
        assert!((peak.at_nm - 546.07).abs() < 0.1, "{peak:?}");
        assert!((peak.height - 2.0).abs() < 0.02, "{peak:?}");
        assert!((peak.width_nm() - 4.0).abs() < 0.1, "{peak:?}");
    }

    #[test]
    fn a_broad_colour_and_a_ripple_are_no_peaks() {
        assert_eq!(points(1.0, |nm| bell(nm, 450.0, 25.0)).peaks(), []);
        assert_eq!(
            points(1.0, |nm| 1.0 + 0.02 * bell(nm, 450.0, 5.0)).peaks(),
            []
        );
        assert_eq!(points(5.0, |_| 0.0).peaks(), []);
    }

    #[test]
    fn a_line_between_two_coarse_samples_is_found_between_them() {
        // What a slit of 5 nm puts into the two samples beside 578.0 nm.
        let peaks = points(5.0, |nm| (1.0 - (nm - 578.0).abs() / 5.0).max(0.0)).peaks();
        assert!((peaks[0].at_nm - 578.0).abs() < 1e-9, "{peaks:?}");
    }
}
