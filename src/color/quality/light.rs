//! A light as figures see it: whole nm 360-830, and lines without width beside them.
//!
//! Measured data go to whole nm once, by [`Sampled::on_whole_nm`]: linear between samples, finer
//! data by their exact mean, zero outside the table. A model's smooth part stands on the same nm
//! and counts in full at both ends of its band, as tables do in the sums of the CIE, so that a
//! comparison with the measured light measures the model and not the quadrature.

use crate::{
    color::xyz,
    spectrum::{Band, Composite, Line, Outside, Sampled},
};

use super::no_figure::{Dark, NoFigure};

/// First whole nm of every sum.
pub(crate) const FIRST_NM: u32 = xyz::FIRST_NM;

/// Last whole nm of every sum.
pub(crate) const LAST_NM: u32 = xyz::LAST_NM;

/// Number of whole nm.
pub const POINTS: usize = xyz::POINTS;

/// A light on whole nm 360-830 and its lines, scaled so that the largest number of either is 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// One value a nm, in units of `scale`.
    values: Vec<f64>,
    /// Lines within 360-830 nm, weights in units of `scale` x nm.
    lines: Vec<Line>,
    /// The source's unit of 1.
    scale: f64,
    /// Indices of the first and last whole nm that the table has.
    ends: [usize; 2],
    /// Why there is nothing to weigh.
    dark: Option<Dark>,
}

impl Light {
    /// A measured light; zero outside its table.
    pub fn of_sampled(samples: &Sampled) -> Self {
        let values = samples.on_whole_nm(FIRST_NM, LAST_NM, Outside::Zero);
        Self::new(
            values,
            Vec::new(),
            [samples.first_nm(), samples.last_nm()],
            samples.values().iter().all(|v| *v == 0.0),
        )
    }

    /// A composite model: its series on its band, zero outside, and its spikes as they are.
    pub fn of_composite(model: &Composite) -> Self {
        Self::of_parts(model.band(), &model.smooth().on_band(), model.lines())
    }

    /// A smooth part on a band's grid and spikes.
    ///
    /// # Panics
    /// When `smooth` does not have [`Band::points`] values.
    pub(crate) fn of_parts(band: Band, smooth: &[f64], spikes: &[Line]) -> Self {
        assert_eq!(smooth.len(), band.points(), "one value per grid point");
        let mut values = vec![0.0; POINTS];
        for (value, nm) in values.iter_mut().zip(FIRST_NM..) {
            let nm = f64::from(nm);
            if band.contains(nm) {
                *value = smooth[(nm - band.min_nm()) as usize];
            }
        }
        let is_zero = smooth.iter().all(|v| *v == 0.0) && spikes.iter().all(|s| s.weight == 0.0);
        let ends_nm = [band.min_nm(), band.max_nm()];
        Self::new(values, spikes.to_vec(), ends_nm, is_zero)
    }

    /// A light given on every nm of 360-830.
    ///
    /// # Panics
    /// When there are not [`POINTS`] values.
    pub(crate) fn of_nm_values(values: &[f64]) -> Self {
        assert_eq!(values.len(), POINTS, "one value per nm of 360-830");
        let is_zero = values.iter().all(|v| *v == 0.0);
        let ends_nm = [FIRST_NM, LAST_NM].map(f64::from);
        Self::new(values.to_vec(), Vec::new(), ends_nm, is_zero)
    }

    /// A single line without width.
    #[cfg(test)]
    pub(crate) fn of_line(line: Line) -> Self {
        let ends_nm = [line.at_nm, line.at_nm];
        Self::new(vec![0.0; POINTS], vec![line], ends_nm, line.weight == 0.0)
    }

    /// The part of it in a band, for a comparison with a model of that band.
    pub fn within(&self, band: Band) -> Self {
        let mut values = self.values.clone();
        for (value, nm) in values.iter_mut().zip(FIRST_NM..) {
            if !band.contains(f64::from(nm)) {
                *value = 0.0;
            }
        }
        let unscaled = values.iter().map(|v| v * self.scale).collect();
        let lines = self.lines.iter().filter(|l| band.contains(l.at_nm));
        let lines = lines.map(|l| l.weighing(l.weight * self.scale));
        let ends_nm = [
            band.min_nm().max(f64::from(FIRST_NM) + self.ends[0] as f64),
            band.max_nm().min(f64::from(FIRST_NM) + self.ends[1] as f64),
        ];
        Self::new(unscaled, lines.collect(), ends_nm, false)
    }

    fn new(
        mut values: Vec<f64>,
        mut lines: Vec<Line>,
        [first_nm, last_nm]: [f64; 2],
        is_zero: bool,
    ) -> Self {
        let range = f64::from(FIRST_NM)..=f64::from(LAST_NM);
        let is_finite = values.iter().all(|v| v.is_finite())
            && lines
                .iter()
                .all(|l| l.at_nm.is_finite() && l.weight.is_finite());
        lines.retain(|l| range.contains(&l.at_nm));
        let sizes = values.iter().chain(lines.iter().map(|l| &l.weight));
        let scale = sizes.fold(0.0_f64, |most, v| most.max(v.abs()));
        let dark = if !is_finite {
            Some(Dark::NotFinite)
        } else if scale > 0.0 {
            None
        } else if is_zero {
            Some(Dark::AllZero)
        } else {
            Some(Dark::Outside { first_nm, last_nm })
        };
        if dark.is_some() {
            values.fill(0.0);
            lines.clear();
        } else {
            // Divided, not multiplied by the inverse, which the smallest numbers do not have.
            values.iter_mut().for_each(|v| *v /= scale);
            lines.iter_mut().for_each(|l| l.weight /= scale);
        }
        let index = |nm: f64| (nm - f64::from(FIRST_NM)).clamp(0.0, (POINTS - 1) as f64);
        Self {
            values,
            lines,
            scale: if dark.is_some() { 1.0 } else { scale },
            ends: [
                index(first_nm).ceil() as usize,
                index(last_nm).floor() as usize,
            ],
            dark,
        }
    }

    /// One value a nm of 360-830, in units of [`Light::scale`].
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Lines within 360-830 nm; weights in units of [`Light::scale`] x nm.
    pub fn lines(&self) -> &[Line] {
        &self.lines
    }

    /// Factor from the values to the source's own unit.
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// First and last whole nm that the table has, within 360-830.
    pub(crate) fn ends_nm(&self) -> [u32; 2] {
        self.ends.map(|index| FIRST_NM + index as u32)
    }

    /// The light itself, where there is any.
    ///
    /// # Errors
    /// [`NoFigure::Dark`] says why there is nothing.
    pub fn lit(&self) -> Result<&Self, NoFigure> {
        match self.dark {
            None => Ok(self),
            Some(dark) => Err(dark.into()),
        }
    }

    /// Number of values below zero, on whole nm or as lines.
    pub(crate) fn negatives(&self) -> usize {
        let lines = self.lines.iter().filter(|l| l.weight < 0.0).count();
        self.values.iter().filter(|v| **v < 0.0).count() + lines
    }

    /// Plain sum of values and lines, in units of scale x nm.
    pub fn power(&self) -> f64 {
        self.values.iter().sum::<f64>() + self.lines.iter().map(|l| l.weight).sum::<f64>()
    }
}

/// A sum that a figure is divided by.
pub(super) fn positive(value: f64, sum: &'static str) -> Result<f64, NoFigure> {
    // What is left of cancelling sums of 471 products near 1.
    const ROUNDING: f64 = 1e-13;
    if value > ROUNDING && value.is_finite() {
        Ok(value)
    } else {
        Err(NoFigure::NotPositive { sum })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_light_says_why_there_is_none() {
        let zero = Sampled::new(vec![400.0, 700.0], vec![0.0, 0.0]).unwrap();
        let dark = Light::of_sampled(&zero).lit().map(|_| ());
        assert_eq!(dark, Err(NoFigure::Dark(Dark::AllZero)));
        let infrared = Sampled::new(vec![900.0, 1000.0], vec![1.0, 1.0]).unwrap();
        let dark = Light::of_sampled(&infrared).lit().map(|_| ());
        assert_eq!(
            dark,
            Err(NoFigure::Dark(Dark::Outside {
                first_nm: 900.0,
                last_nm: 1000.0
            }))
        );
        let mut broken = vec![1.0; POINTS];
        broken[7] = f64::NAN;
        assert!(Light::of_nm_values(&broken).lit().is_err());
    }

    #[test]
    fn the_smallest_and_the_largest_numbers_are_lights_like_others() {
        for size in [5e-324, 1e-310, 1.0, 1e300, f64::MAX] {
            let light = Light::of_nm_values(&[size; POINTS]);
            assert_eq!(light.lit().map(Light::scale), Ok(size));
            assert!(light.values().iter().all(|v| *v == 1.0));
        }
    }

    #[test]
    fn a_part_of_a_light_keeps_its_scale_and_ends_at_the_band() {
        let values: Vec<f64> = (0..POINTS).map(|i| i as f64).collect();
        let part = Light::of_nm_values(&values).within(Band::PAPER);
        assert_eq!(part.ends_nm(), [400, 700]);
        assert_eq!(part.values()[39], 0.0);
        // One division and one product.
        assert!((part.values()[340] * part.scale() - 340.0).abs() < 1e-12);
    }
}
