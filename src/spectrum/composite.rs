//! The composite model: a smooth series and a few spikes (Eq. 2 and 3).

use super::{band::Band, basis::Series};

/// A line of no width: the integral of a delta function at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spike {
    /// Where, in nm.
    pub at_nm: f64,
    /// Radiant power in the spectrum's own unit x nm; negative for absorption.
    pub weight: f64,
}

/// A full width at half maximum times the peak height times this is a Gaussian's area:
/// `sqrt(pi / (4 ln 2))`.
pub const GAUSSIAN_AREA: f64 = 1.064_467_019_431_226_2;

impl Spike {
    /// Height of the stem drawn for the spike above the smooth curve: the peak of a Gaussian of
    /// full width `width_nm` and this weight.
    pub fn stem_height(self, width_nm: f64) -> f64 {
        self.weight / (GAUSSIAN_AREA * width_nm)
    }

    /// The weight whose stem has a height; dragging a stem's tip uses it.
    pub fn weight_from_stem(height: f64, width_nm: f64) -> f64 {
        height * GAUSSIAN_AREA * width_nm
    }
}

/// A spectrum as a smooth series and spikes.
#[derive(Clone, Debug, PartialEq)]
pub struct Composite {
    /// The smooth part.
    pub smooth: Series,
    /// The spikes, by rising wavelength.
    pub spikes: Vec<Spike>,
}

impl Composite {
    /// The band of the model.
    pub fn band(&self) -> Band {
        self.smooth.band
    }

    /// How many numbers the model takes: one each coefficient, two each spike.
    pub fn numbers(&self) -> usize {
        self.smooth.coefficients.len() + 2 * self.spikes.len()
    }

    /// Integral of the spectrum times a weight over the band, in value x nm.
    ///
    /// A delta can only be weighed, never evaluated: the smooth part is summed on the 1 nm
    /// trapezoid grid and each spike weighs the function exactly where it stands.
    pub fn integrate(&self, weight: impl Fn(f64) -> f64) -> f64 {
        let band = self.band();
        let smooth: f64 = self
            .smooth
            .on_band()
            .iter()
            .enumerate()
            .map(|(i, v)| band.weight(i) * v * weight(band.nm(i)))
            .sum();
        let spikes: f64 = self.on_its_band().map(|s| s.weight * weight(s.at_nm)).sum();
        smooth + spikes
    }

    /// Total power over the band: the exact integral of the series and the spikes' weights.
    pub fn power(&self) -> f64 {
        self.smooth.integral() + self.on_its_band().map(|s| s.weight).sum::<f64>()
    }

    /// The spikes that count: nothing is known of the spectrum outside its band.
    fn on_its_band(&self) -> impl Iterator<Item = &Spike> {
        let band = self.band();
        self.spikes.iter().filter(move |s| band.contains(s.at_nm))
    }

    /// Values on the band's grid, each spike split linearly over its two neighbouring nm.
    pub fn on_band(&self) -> Vec<f64> {
        let mut values = self.smooth.on_band();
        add_spikes(self.band(), &self.spikes, &mut values);
        values
    }
}

/// Adds spikes to values on a band's grid, each split linearly over its two neighbouring nm so
/// that the trapezoid integral grows by its weight; spikes outside the band are left out.
pub fn add_spikes(band: Band, spikes: &[Spike], values: &mut [f64]) {
    for spike in spikes.iter().filter(|s| band.contains(s.at_nm)) {
        let x = spike.at_nm - band.min_nm();
        let i = (x as usize).min(band.steps() - 1);
        let t = x - i as f64;
        values[i] += spike.weight * (1.0 - t) / band.weight(i);
        values[i + 1] += spike.weight * t / band.weight(i + 1);
    }
}
