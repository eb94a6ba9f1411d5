//! Other lights in coefficients: XYZ of a pixel is three weighted sums of its numbers, and a new
//! light is new weights.

use nalgebra::DMatrix;

use crate::color::{Observer, Xyz};
use crate::spectrum::{Kind, Outside, Sampled};

use super::fitting::{cosines, lit_fit};
use super::light::{Rows, sums, times};
use super::plan::LEAST_NOISE;
use super::prior::prior;
use super::{Bands, Illuminant, Operator, PictureError, ReferenceKind};

/// Interpolation of the spectrum between bands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Between {
    /// Straight lines, as everywhere in the program: errors go to zero with the count of numbers.
    #[default]
    Bands,
    /// The series itself, which is nearer to the truth where bands are 10 nm apart or more.
    Series,
}

/// Weights of a picture's numbers under a light.
#[derive(Clone, Debug, PartialEq)]
pub struct Relit {
    /// Name of the light.
    pub light: String,
    /// X, Y and Z: a weight a number.
    pub rows: Rows,
    /// Colour of the light itself, Y = 1.
    pub white: Xyz,
}

impl Relit {
    /// XYZ of one pixel, Y = 1 for the light.
    pub fn xyz(&self, numbers: &[f64]) -> Xyz {
        sums(&self.rows, numbers)
    }
}

impl Operator {
    /// Weights of the numbers for the own colour: what the picture shows by itself. The white is
    /// the own light's, a known light's as it fell on the bands, or what is equal everywhere.
    pub fn own_colour(&self) -> Relit {
        let plan = self.plan();
        let of_bands = |values: &[f64]| sums(self.own_weights(), values);
        let white = match (&plan.own, plan.reference.kind) {
            (Some(light), _) if self.bands().is_factor() => light.white(plan.observer),
            (_, ReferenceKind::Light) => Some(of_bands(&plan.reference.values)),
            _ => Some(of_bands(&vec![1.0; self.bands().len()])),
        };
        let own = plan.own.as_ref().filter(|_| self.bands().is_factor());
        Relit {
            light: own
                .map_or(&plan.reference.name[..], Illuminant::name)
                .to_owned(),
            rows: self.of_numbers(self.own_weights()),
            white: white.unwrap_or_default(),
        }
    }

    /// Weights of the numbers under another light. `known` is the light that lit a picture whose
    /// reference is another; one whose reference is the light needs none.
    ///
    /// # Errors
    /// [`PictureError::NoRelighting`] where nobody knows what lit the picture, and
    /// [`PictureError::NoOwnLight`] for a light that does not shine on the bands.
    pub(crate) fn relit(
        &self,
        light: &Illuminant,
        known: Option<&Illuminant>,
        between: Between,
    ) -> Result<Relit, PictureError> {
        let plan = self.plan();
        let observer = plan.observer;
        let reflectance = Bands::new(self.bands().nm().to_vec(), Kind::Reflectance)?;
        let weights = light.weights(&reflectance, observer)?;
        let white = light.white(observer).unwrap_or_default();
        let rows = if self.bands().is_factor() {
            let mut rows = self.of_numbers(&weights);
            if between == Between::Series {
                let of_series = self.series_rows(light, observer, true);
                for (row, series) in rows.iter_mut().zip(of_series) {
                    row[..series.len()].copy_from_slice(&series);
                }
            }
            rows
        } else if plan.reference.kind == ReferenceKind::Light {
            self.divided_rows(light, &weights, between)
        } else {
            let known = known.ok_or_else(|| {
                PictureError::NoRelighting(
                    said!(
                        "no relighting: nobody knows what lit this picture; choose the light, or \
                         a white place in the picture, whose spectrum then is the light"
                    )
                    .to_owned(),
                )
            })?;
            self.divided_later(known, &weights)?
        };
        Ok(Relit {
            light: light.name().to_owned(),
            rows,
            white,
        })
    }

    /// Of a picture with its known light (or two) as reference: the series without it.
    fn divided_rows(&self, light: &Illuminant, weights: &Rows, between: Between) -> Rows {
        let plan = self.plan();
        let (one, two) = plan.shares();
        let of_series = if between == Between::Series {
            self.series_rows(light, plan.observer, false)
        } else {
            times(weights, &cosines(self.bands().nm(), self.range_nm(), one))
        };
        // Both halves are parts of one reflectance; lines beside a known light are light.
        of_series.map(|mut row: Vec<f64>| {
            let first: Vec<f64> = row.iter().copied().take(two).collect();
            row.extend(first);
            row.resize(self.numbers(), 0.0);
            row
        })
    }

    /// The series at every whole nm rather than at the bands, times its reference where asked.
    fn series_rows(&self, light: &Illuminant, observer: Observer, with_reference: bool) -> Rows {
        let (plan, bands) = (self.plan(), self.bands());
        let count = plan.shares().0;
        let nm = bands.nm();
        let (first, last) = (nm[0], nm[nm.len() - 1]);
        let y = light.xyz(observer).y;
        let places = light.seen(observer);
        let held: Vec<f64> = places.iter().map(|(at, _)| at.clamp(first, last)).collect();
        let waves = cosines(&held, self.range_nm(), count);
        let reference = Sampled::new(nm.to_vec(), plan.reference.values.clone());
        let factor = |at: f64| match &reference {
            Ok(reference) if with_reference => reference.at(at, Outside::Hold),
            _ => 1.0,
        };
        let mut rows = [0; 3].map(|_| vec![0.0; count]);
        for (m, (_, weights)) in places.iter().enumerate() {
            let factor = factor(held[m]) / y;
            for (row, weight) in rows.iter_mut().zip(weights) {
                for (n, value) in row.iter_mut().enumerate() {
                    *value += weight * factor * waves[(m, n)];
                }
            }
        }
        rows
    }

    /// Of a picture stored without its light: the regularised division, folded into the weights.
    fn divided_later(&self, known: &Illuminant, weights: &Rows) -> Result<Rows, PictureError> {
        let bands = self.bands();
        let light = known.on_bands(bands)?;
        let (count, range) = (self.numbers(), self.range_nm());
        let waves = cosines(bands.nm(), range, count);
        let lit = DMatrix::from_fn(bands.len(), count, |j, n| waves[(j, n)] * light[j]);
        let moments = prior(bands, range, count)?;
        let noise = self.plan().noise.max(LEAST_NOISE);
        let divided = lit_fit(bands, &lit, &moments, noise)?.encode * &self.decode;
        Ok(times(&times(weights, &waves), &divided))
    }
}
