//! Channels and their mixture.

use super::{
    error::MixError,
    spec::{Source, Spec},
};
use crate::{
    design::whole_nm::{self, of_unit_power},
    spectrum::{Band, Basis, BasisTable, Composite, Line, Sampled, Series},
};

/// Numbers of the series that a mixture's smooth part is told by, half-range cosines.
const COSINES: usize = 61;

/// A channel: a light of unit power in 360-830 nm, to be weighed; behind a filter of less.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// Its specification, in words.
    pub spec: Spec,
    /// Power a nm on 360-830; a line is split over its two neighbours.
    pub values: Vec<f64>,
}

impl Channel {
    /// A channel of its words; `light` is the table of a name.
    ///
    /// # Errors
    /// [`MixError::NoPower`] for a light without power, or with less than none anywhere in sum;
    /// [`MixError::Spec`] for a name without a table.
    pub fn new(spec: Spec, light: Option<&Sampled>) -> Result<Self, MixError> {
        let values = match (&spec.source, light) {
            (Source::Line { at_nm }, _) => whole_nm::line(*at_nm),
            (Source::Gauss { centre_nm, fwhm_nm }, _) => whole_nm::gauss(*centre_nm, *fwhm_nm),
            (Source::Blackbody { kelvin }, _) => whole_nm::planck(*kelvin),
            (Source::Daylight { kelvin }, _) => whole_nm::daylight(*kelvin),
            (Source::Named(_), Some(light)) => of_unit_power(whole_nm::table(light)),
            (Source::Named(name), None) => {
                return Err(MixError::Spec {
                    found: name.clone(),
                    expected: said!("a light that is known").to_owned(),
                });
            }
        };
        match values {
            Some(values) => Ok(Self { spec, values }),
            None => Err(MixError::NoPower { spec: spec.words }),
        }
    }

    /// The same behind a filter, given as shares on 360-830: of less power by what it keeps back.
    ///
    /// # Errors
    /// [`MixError::NoPower`] where nothing passes.
    pub fn through(mut self, shares: &[f64]) -> Result<Self, MixError> {
        let both = self.values.iter_mut().zip(shares);
        both.for_each(|(value, share)| *value *= share.max(0.0));
        if self.power() > 0.0 {
            Ok(self)
        } else {
            Err(MixError::NoPower {
                spec: self.spec.words,
            })
        }
    }

    /// Its power: 1, less behind a filter.
    pub fn power(&self) -> f64 {
        self.values.iter().sum()
    }

    /// Its place, if it is a line.
    pub(crate) fn line_nm(&self) -> Option<f64> {
        match self.spec.source {
            Source::Line { at_nm } => Some(at_nm),
            _ => None,
        }
    }
}

/// The light of channels with weights on whole nm 360-830, power a nm.
pub fn mixed(channels: &[Channel], weights: &[f64]) -> Vec<f64> {
    let mut sum = vec![0.0; crate::color::xyz::POINTS];
    for (channel, weight) in channels.iter().zip(weights) {
        let both = sum.iter_mut().zip(&channel.values);
        both.for_each(|(s, v)| *s += weight * v);
    }
    sum
}

/// Index range of 380-780 nm within the whole nm of 360-830.
fn within_composite() -> std::ops::Range<usize> {
    let first = (Band::VISIBLE.min_nm() - f64::from(crate::color::xyz::FIRST_NM)) as usize;
    first..first + Band::VISIBLE.points()
}

/// The share of a mixture's power that [`composite`] leaves out, below 380 and above 780 nm.
pub(crate) fn left_out(channels: &[Channel], weights: &[f64]) -> f64 {
    let (mut all, mut inside) = (0.0, 0.0);
    for (channel, weight) in channels.iter().zip(weights) {
        let power = weight * channel.power();
        all += power;
        inside += match channel.line_nm() {
            Some(at_nm) if Band::VISIBLE.contains(at_nm) => power,
            Some(_) => 0.0,
            None => weight * channel.values[within_composite()].iter().sum::<f64>(),
        };
    }
    if all > 0.0 { 1.0 - inside / all } else { 0.0 }
}

/// The mixture as a composite on 380-780 nm: lines stay spikes, the rest is a series of cosines.
pub fn composite(channels: &[Channel], weights: &[f64]) -> Composite {
    let band = Band::VISIBLE;
    let mut smooth = vec![0.0; band.points()];
    let mut spikes = Vec::new();
    for (channel, weight) in channels.iter().zip(weights) {
        match channel.line_nm() {
            Some(at_nm) if *weight > 0.0 && band.contains(at_nm) => {
                spikes.push(Line::ideal(at_nm, weight * channel.power()))
            }
            Some(_) => {}
            None => {
                let values = &channel.values[within_composite()];
                let both = smooth.iter_mut().zip(values);
                both.for_each(|(s, v)| *s += weight * v);
            }
        }
    }
    spikes.sort_by(|a, b| a.at_nm.total_cmp(&b.at_nm));
    let table = BasisTable::new(band, Basis::Cosine, COSINES);
    Composite::of_lines_inside(
        Series {
            band,
            basis: Basis::Cosine,
            coefficients: table.project(&smooth, COSINES),
        },
        spikes,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_out_is_what_the_composite_lacks_of_the_power() {
        let line = |at_nm: f64| {
            let spec = format!("line:{at_nm}").parse().expect("a line");
            Channel::new(spec, None).expect("a line")
        };
        for (at_nm, out) in [(546.1, 0.0), (780.5, 1.0), (379.5, 1.0), (780.0, 0.0)] {
            let channels = [line(at_nm)];
            assert_eq!(left_out(&channels, &[2.0]), out, "{at_nm}");
            let kept = composite(&channels, &[2.0]).lines().len();
            assert_eq!(kept as f64, 1.0 - out, "{at_nm}");
        }
    }
}
