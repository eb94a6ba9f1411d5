//! Box bins: the average over each of a few equal intervals.
//!
//! A bin's value is the exact integral of the piecewise-linear spectrum over its interval divided
//! by its width, so a spectrum and its bins have the same energy whatever the count.

use super::{Representation, midpoints_nm};
use crate::spectrum::Band;

/// Averages over equal intervals of the band.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Bins {
    band: Band,
    /// At least one, in the spectrum's own unit.
    values: Vec<f64>,
}

impl Bins {
    /// Averages values on the band's grid, straight lines between them, over `numbers` boxes.
    pub(super) fn fit(band: Band, values: &[f64], numbers: usize) -> Self {
        let count = numbers.clamp(1, band.points());
        let edge = |i: usize| i as f64 * band.length_nm() / count as f64;
        Self {
            band,
            values: (0..count)
                .map(|i| average_of_lines(values, edge(i), edge(i + 1)))
                .collect(),
        }
    }

    /// Average of the boxes over an interval given in bins from the band's start.
    fn average_of_boxes(&self, from: f64, to: f64) -> f64 {
        let last = self.values.len() - 1;
        let area: f64 = ((from as usize).min(last)..=(to as usize).min(last))
            .map(|i| {
                let overlap = to.min((i + 1) as f64) - from.max(i as f64);
                self.values[i] * overlap.max(0.0)
            })
            .sum();
        area / (to - from)
    }
}

/// Average of straight lines through values one nm apart over an interval, in nm from the first.
fn average_of_lines(values: &[f64], from: f64, to: f64) -> f64 {
    let last_segment = values.len() - 2;
    let area: f64 = ((from as usize).min(last_segment)..=(to as usize).min(last_segment))
        .map(|i| {
            let (a, b) = (from.max(i as f64), to.min((i + 1) as f64));
            let middle = 0.5 * (a + b) - i as f64;
            (b - a).max(0.0) * (values[i] * (1.0 - middle) + values[i + 1] * middle)
        })
        .sum();
    area / (to - from)
}

impl Representation for Bins {
    fn band(&self) -> Band {
        self.band
    }

    fn stored(&self) -> Vec<f64> {
        self.values.clone()
    }

    fn scale(&mut self, factor: f64) {
        self.values.iter_mut().for_each(|v| *v *= factor);
    }

    fn inside(&self, at_nm: f64) -> f64 {
        let count = self.values.len();
        let x = (at_nm - self.band.min_nm()) * count as f64 / self.band.length_nm();
        self.values[(x as usize).min(count - 1)]
    }

    /// Each grid point has the average over its own cell, half a nm to both sides (inside the
    /// band): the trapezoid sum of these averages is the boxes' own energy.
    fn on_band(&self) -> Vec<f64> {
        let (length, per_nm) = (
            self.band.length_nm(),
            self.values.len() as f64 / self.band.length_nm(),
        );
        (0..self.band.points())
            .map(|i| {
                let (from, to) = ((i as f64 - 0.5).max(0.0), (i as f64 + 0.5).min(length));
                self.average_of_boxes(from * per_nm, to * per_nm)
            })
            .collect()
    }

    fn places_nm(&self) -> Vec<f64> {
        midpoints_nm(self.band, self.values.len())
    }

    fn points(&self) -> Vec<f64> {
        self.values.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rivals::example_spectra::{fluorescent, thermal};

    const BAND: Band = Band::VISIBLE;

    #[test]
    fn bins_keep_the_energy_whatever_their_count() {
        let values = fluorescent(BAND);
        let whole = BAND.integral(&values);
        for count in [1, 2, 7, 20, 31, 399, 400, 401] {
            let bins = Bins::fit(BAND, &values, count);
            let boxes = bins.values.iter().sum::<f64>() * BAND.length_nm() / count as f64;
            let grid = BAND.integral(&bins.on_band());
            // Sums of up to 401 terms in another order.
            assert!((boxes - whole).abs() < 1e-12 * whole);
            assert!((grid - whole).abs() < 1e-12 * whole);
        }
    }

    #[test]
    fn a_bin_is_the_average_of_the_straight_lines_in_its_interval() {
        let ramp: Vec<f64> = (0..401).map(f64::from).collect();
        let bins = Bins::fit(BAND, &ramp, 3);
        for (v, nm) in bins.values.iter().zip(bins.places_nm()) {
            // A ramp's average is its value in the middle; sums of a hundred numbers up to 400.
            assert!((v - (nm - 380.0)).abs() < 1e-10);
        }
    }

    #[test]
    fn boxes_that_end_between_grid_points_share_that_nm() {
        let band = Band::new(400.0, 420.0).unwrap();
        let boxes = Bins {
            band,
            values: vec![0.0, 1.0, 1.0],
        };
        // The first box ends at 20/3 = 6.667: a sixth of the cell 6.5-7.5 of point 7 is in it.
        let on_band = boxes.on_band();
        assert_eq!(on_band[6], 0.0);
        assert!((on_band[7] - 5.0 / 6.0).abs() < 1e-12);
        assert!((on_band[8] - 1.0).abs() < 1e-12);
    }

    #[test]
    fn a_bin_for_every_nm_of_a_smooth_light_is_nearly_the_light() {
        let values = thermal(BAND, 4000.0);
        let read = Bins::fit(BAND, &values, 400).on_band();
        for (a, b) in read.iter().zip(&values).skip(1).take(399) {
            // Two averages of neighbours leave a quarter of the second difference, 1e-4 here.
            assert!((a - b).abs() < 1e-4);
        }
    }

    #[test]
    fn bins_of_a_spectrum_that_is_not_negative_are_not_negative() {
        let mut values = vec![0.0; 401];
        values[55] = 1e6;
        let bins = Bins::fit(BAND, &values, 31);
        assert!(bins.values.iter().chain(&bins.on_band()).all(|v| *v >= 0.0));
    }
}
