//! Equally spaced point samples, straight lines between them: what renderers mostly do.

use super::{Representation, midpoints_nm};
use crate::spectrum::Band;

/// Values at equally spaced wavelengths, first and last at the ends of the band.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Samples {
    band: Band,
    /// At least one, in the spectrum's own unit.
    values: Vec<f64>,
}

impl Samples {
    /// Reads `numbers` samples off values on the band's grid; a single one is read in the middle.
    ///
    /// # Panics
    /// When `values` does not have [`Band::points`] entries.
    pub(crate) fn fit(band: Band, values: &[f64], numbers: usize) -> Self {
        let places = places_nm(band, numbers.clamp(1, band.points()));
        Self {
            band,
            values: places
                .iter()
                .map(|nm| band.interpolate(values, *nm))
                .collect(),
        }
    }
}

/// Wavelengths of `count` samples, nm.
fn places_nm(band: Band, count: usize) -> Vec<f64> {
    if count == 1 {
        return midpoints_nm(band, 1);
    }
    let gaps = (count - 1) as f64;
    // Multiplied before divided, so that the last one stands on the end to the last bit.
    (0..count)
        .map(|i| band.min_nm() + i as f64 * band.length_nm() / gaps)
        .collect()
}

impl Representation for Samples {
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
        let gaps = self.values.len() - 1;
        if gaps == 0 {
            return self.values[0];
        }
        let x = (at_nm - self.band.min_nm()) * gaps as f64 / self.band.length_nm();
        let left = (x as usize).min(gaps - 1);
        let t = x - left as f64;
        self.values[left] * (1.0 - t) + self.values[left + 1] * t
    }

    fn on_band(&self) -> Vec<f64> {
        self.band.grid().map(|nm| self.inside(nm)).collect()
    }

    fn places_nm(&self) -> Vec<f64> {
        places_nm(self.band, self.values.len())
    }

    fn points(&self) -> Vec<f64> {
        self.values.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rivals::example_spectra::{fluorescent, thermal};

    fn worst(band: Band, values: &[f64], numbers: usize) -> f64 {
        let read = Samples::fit(band, values, numbers).on_band();
        let differences = read.iter().zip(values).map(|(a, b)| (a - b).abs());
        differences.fold(0.0, f64::max)
    }

    #[test]
    fn a_sample_on_every_grid_point_is_the_spectrum_itself() {
        let values = fluorescent(Band::VISIBLE);
        let samples = Samples::fit(Band::VISIBLE, &values, 401);
        assert_eq!(samples.stored(), values);
        assert_eq!(samples.on_band(), values);
    }

    #[test]
    fn first_and_last_sample_stand_on_the_ends_of_the_band() {
        for numbers in 2..=401 {
            let places = Samples::fit(Band::VISIBLE, &[0.0; 401], numbers).places_nm();
            assert_eq!((places[0], places[numbers - 1]), (380.0, 780.0));
        }
    }

    #[test]
    fn a_single_sample_is_the_value_in_the_middle() {
        let samples = Samples::fit(Band::VISIBLE, &thermal(Band::VISIBLE, 5000.0), 1);
        assert_eq!(samples.places_nm(), [580.0]);
        assert!(samples.on_band().iter().all(|v| *v == samples.values[0]));
    }

    #[test]
    fn twice_as_many_samples_of_a_smooth_light_are_four_times_as_close() {
        let values = thermal(Band::VISIBLE, 6000.0);
        let gain = worst(Band::VISIBLE, &values, 21) / worst(Band::VISIBLE, &values, 41);
        // The second-order law of straight lines; higher orders are a few percent here.
        assert!((gain - 4.0).abs() < 0.3, "{gain}");
    }
}
