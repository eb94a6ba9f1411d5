//! An instrument's response, learnt from a light that is known, and taken off its readings.

use nalgebra::{DMatrix, DVector};

use super::{
    axis::AxisFound, error::MeasurementError, kernel::Slit, mask::is_dark,
    measurement::Measurement, noise::noise_of, quantity::Quantity,
};
use crate::{
    color::{blackbody, quality::daylight, xyz::FIRST_NM},
    spectrum::{Outside, Sampled},
};

/// Order of the series of the logarithm, where the reading is noisy.
const ORDER: usize = 20;
/// Noise of the reading from which on the response is kept as that series.
const NOISY: f64 = 0.01;

/// A known light.
#[derive(Clone, Debug, PartialEq)]
pub enum Known {
    /// A black body of a temperature, K.
    BlackBody { kelvin: f64 },
    /// Daylight of a CCT, K.
    Daylight { kelvin: f64 },
    /// A table: a certificate, or another instrument's reading of the same light.
    Table(Box<Measurement>),
}

/// An instrument.
#[derive(Clone, Debug, PartialEq)]
pub struct Instrument {
    pub name: String,
    pub serial: String,
    /// The day it was learnt, as `2026-11-27`.
    pub date: String,
    /// Words of the light that it was learnt from.
    pub known: String,
    /// Unit of the lights that it makes; empty for relative ones.
    pub unit: String,
    /// What its axis is off by.
    pub axis: Option<AxisFound>,
    /// Light a count: values, sigma, errors that all share, mask; on the corrected axis.
    pub factor: Measurement,
    pub slit: Option<Slit>,
}

impl Known {
    /// Values at some wavelengths, with the shared error that a doubt of the temperature makes;
    /// `None` where it reaches none of them.
    fn on(&self, nm: &[f64], doubt: f64) -> Option<Measurement> {
        let of = |kelvin: f64| -> Vec<f64> {
            match self {
                Self::BlackBody { .. } => nm
                    .iter()
                    .map(|nm| blackbody::relative(*nm, kelvin))
                    .collect(),
                Self::Daylight { .. } => {
                    let table = Sampled::even(f64::from(FIRST_NM), 1.0, daylight(kelvin)).ok();
                    let at = |nm: &f64| table.as_ref().map_or(0.0, |t| t.at(*nm, Outside::Zero));
                    nm.iter().map(at).collect()
                }
                Self::Table(table) => {
                    let table = table.bridged();
                    nm.iter()
                        .map(|nm| table.samples.at(*nm, Outside::Zero))
                        .collect()
                }
            }
        };
        let light = |values: Vec<f64>| {
            let samples = Sampled::new(nm.to_vec(), values).ok()?;
            Some(Measurement::new(
                "known light",
                Quantity::Light,
                "",
                samples,
            ))
        };
        match self {
            Self::BlackBody { kelvin } | Self::Daylight { kelvin } => {
                let values = of(*kelvin);
                let ends = [of(kelvin + doubt), of(kelvin - doubt)];
                let shared = |i: usize| match values[i] > 0.0 {
                    true => (ends[0][i] - ends[1][i]) / (2.0 * values[i]),
                    false => 0.0,
                };
                let shared: Vec<f64> = (0..nm.len()).map(shared).collect();
                let mut found = light(values)?;
                if doubt > 0.0 {
                    found.shared = vec![shared];
                }
                Some(found)
            }
            Self::Table(table) => {
                let mut found = light(of(0.0))?;
                found.unit.clone_from(&table.unit);
                found.level = table.level;
                let sigma = table.sigma.as_ref();
                let sigma = sigma.and_then(|s| table.samples.sharing(s.clone()).ok());
                found.sigma = sigma.map(|s| nm.iter().map(|nm| s.at(*nm, Outside::Zero)).collect());
                Some(found)
            }
        }
    }
}

/// Learns an instrument's response from a reading (its dark taken off) of a known light; `doubt` is
/// the temperature's standard uncertainty, K.
///
/// # Errors
/// A sentence where the reading is too dark or the two share no wavelengths.
pub fn learn(
    reading: &Measurement,
    known: &Known,
    doubt: f64,
    axis: Option<AxisFound>,
) -> Result<Instrument, MeasurementError> {
    let nm: Vec<f64> = match &axis {
        Some(axis) => reading
            .samples
            .nm()
            .iter()
            .map(|nm| axis.corrected(*nm))
            .collect(),
        None => reading.samples.nm().to_vec(),
    };
    let apart = || {
        MeasurementError::Apart(
            said!("The reading and the known light share no wavelengths.").to_owned(),
        )
    };
    let light = known.on(&nm, doubt).ok_or_else(apart)?;
    let noise = reading.sigma.clone().or_else(|| noise_of(&reading.samples));
    let noise = noise.unwrap_or_else(|| vec![0.0; nm.len()]);
    let (counts, values) = (reading.samples.values(), light.samples.values());
    let mut mask = is_dark(counts, &noise);
    mask.iter_mut()
        .zip(values)
        .enumerate()
        .for_each(|(i, (masked, v))| *masked |= *v <= 0.0 || !reading.is_kept(i));
    let kept: Vec<usize> = (0..nm.len()).filter(|i| !mask[*i]).collect();
    if kept.len() < 2 {
        let why = said!(
            "The reading is below 10 of its noise everywhere the light is known: nothing is \
             learnt."
        );
        return Err(MeasurementError::AllMasked(why.to_owned()));
    }
    let mut factor = vec![0.0; nm.len()];
    let mut sigma = vec![0.0; nm.len()];
    for i in &kept {
        let of_light = light.sigma.as_ref().map_or(0.0, |s| s[*i] / values[*i]);
        factor[*i] = values[*i] / counts[*i];
        sigma[*i] = factor[*i] * (noise[*i] / counts[*i]).hypot(of_light);
    }
    let share = kept.iter().map(|i| sigma[*i] / factor[*i]).sum::<f64>() / kept.len() as f64;
    if share > NOISY && kept.len() > 2 * ORDER {
        smoothed(&nm, &kept, &mut factor, &mut sigma);
    }
    let samples = Sampled::new(nm, factor)?;
    let mut response = Measurement::new("response", Quantity::Factor, "factor", samples);
    response.sigma = Some(sigma);
    response.level = reading.level.hypot(light.level);
    response.shared = light.shared;
    if mask.contains(&true) {
        response.mask = mask;
        response.why_masked =
            said!("The known light's reading is below 10 of its noise").to_owned();
    }
    Ok(Instrument {
        name: String::new(),
        serial: String::new(),
        date: String::new(),
        known: String::new(),
        unit: light.unit,
        axis,
        factor: response,
        slit: None,
    })
}

/// A noisy response as the exponential of a weighted cosine series of its logarithm, within what is
/// kept only: outside the series explodes.
fn smoothed(nm: &[f64], kept: &[usize], factor: &mut [f64], sigma: &mut [f64]) {
    let (first, last) = (nm[kept[0]], nm[kept[kept.len() - 1]]);
    let cosine = |i: usize, k: usize| {
        (std::f64::consts::PI * k as f64 * (nm[i] - first) / (last - first)).cos()
    };
    let inverse: Vec<f64> = kept.iter().map(|i| factor[*i] / sigma[*i]).collect();
    let sound = kept
        .iter()
        .enumerate()
        .filter(|(k, i)| factor[**i] > 0.0 && inverse[*k].is_finite());
    let sound: Vec<(usize, usize)> = sound.map(|(k, i)| (k, *i)).collect();
    let design = DMatrix::from_fn(sound.len(), ORDER + 1, |row, k| {
        cosine(sound[row].1, k) * inverse[sound[row].0]
    });
    let values = DVector::from_fn(sound.len(), |row, _| {
        factor[sound[row].1].ln() * inverse[sound[row].0]
    });
    let Some(covariance) = (design.transpose() * &design).try_inverse() else {
        return;
    };
    let series = &covariance * design.transpose() * values;
    for i in kept {
        let row = DVector::from_fn(ORDER + 1, |k, _| cosine(*i, k));
        factor[*i] = row.dot(&series).exp();
        sigma[*i] = factor[*i] * (row.transpose() * &covariance * &row)[0].max(0.0).sqrt();
    }
}

impl Instrument {
    /// A reading of this instrument (its dark taken off) as the light that it is of: axis put
    /// right, response taken off, masked where the response is not known.
    ///
    /// # Errors
    /// A sentence where the reading lies outside the response.
    pub fn corrected(&self, reading: &Measurement) -> Result<Measurement, MeasurementError> {
        let nm: Vec<f64> = match &self.axis {
            Some(axis) => reading
                .samples
                .nm()
                .iter()
                .map(|nm| axis.corrected(*nm))
                .collect(),
            None => reading.samples.nm().to_vec(),
        };
        let own = &self.factor;
        let own_nm = own.samples.nm();
        let place = |at: f64| {
            let right = own_nm.partition_point(|nm| *nm < at - 1e-9);
            if right == own_nm.len() || right == 0 && own_nm[0] > at + 1e-9 {
                return None;
            }
            let right = right.max(1);
            let share = (at - own_nm[right - 1]) / (own_nm[right] - own_nm[right - 1]);
            let share = share.clamp(0.0, 1.0);
            let is_kept =
                (share >= 1.0 || own.is_kept(right - 1)) && (share <= 0.0 || own.is_kept(right));
            is_kept.then_some((right - 1, share))
        };
        let between = |values: &[f64], (left, share): (usize, f64)| {
            values[left] * (1.0 - share) + values[left + 1] * share
        };
        let noise = reading.sigma.clone().or_else(|| noise_of(&reading.samples));
        let (mut values, mut sigma, mut mask) = (Vec::new(), Vec::new(), Vec::new());
        let mut shared = vec![Vec::new(); own.shared.len()];
        for (i, at) in nm.iter().enumerate() {
            let found = place(*at).filter(|_| reading.is_kept(i));
            mask.push(found.is_none());
            let k = found.map_or(0.0, |p| between(own.samples.values(), p));
            let of_k = found.map_or(0.0, |p| own.sigma.as_ref().map_or(0.0, |s| between(s, p)));
            let count = reading.samples.values()[i];
            values.push(k * count);
            sigma.push((k * noise.as_ref().map_or(0.0, |s| s[i])).hypot(of_k * count));
            for (out, own) in shared.iter_mut().zip(&own.shared) {
                out.push(found.map_or(0.0, |p| between(own, p)));
            }
        }
        if !mask.contains(&false) {
            return Err(MeasurementError::Apart(
                said!("The reading lies where the instrument's response is not known.").to_owned(),
            ));
        }
        let mut light = Measurement::new(
            &reading.name,
            Quantity::Light,
            &self.unit,
            Sampled::new(nm, values)?,
        );
        light.sigma = Some(sigma);
        light.level = reading.level.hypot(own.level);
        light.axis_nm = reading.axis_nm;
        light.memory.clone_from(&reading.memory);
        light.scans = reading.scans;
        light.slit = reading.slit.or(self.slit);
        light.shared = shared;
        if mask.contains(&true) {
            light.mask = mask;
            light.why_masked = said!("The instrument's response is not known").to_owned();
        }
        Ok(light)
    }
}
