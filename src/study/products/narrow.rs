//! A narrow band-pass that moves over a light: what each representation sees through it.
//!
//! Three ways with the same count of numbers: the composite, its basis without any spike, and
//! plain point samples with straight lines between. The filter is exact in all three. Both sides
//! are brightened so that the exact light behind it has half the Y of the whole light (by at most
//! fifty times as much as when the light has Y = 100), as in every figure "behind narrow filters".

use std::ops::Range;

use super::Colours;
use crate::{
    color::{Weights, Xyz, xyz_of_parts},
    rivals::{Representation, Samples},
    spectrum::{Band, BasisTable, InnerProducts, Line, Series, dot, gaussian},
};

/// Y that the light behind the filter is brought to, of the whole light's 1.
const BRIGHT: f64 = 0.5;

/// Most that it is brightened by.
const MOST_GAIN: f64 = 50.0;

/// Narrowest band-pass, full width at half maximum in nm: narrower ones fall between the points
/// of the 1 nm grid on which the exact light is summed.
pub(super) const NARROWEST_NM: f64 = 2.0;

/// Beyond this many widths a Gaussian is below 1e-19 of its top and not summed.
const REACH_WIDTHS: f64 = 4.0;

/// Values on the grid times each of three weights and the trapezoid rule's own.
type Weighed = [Vec<f64>; 3];

/// A light in three representations of equal size.
#[derive(Clone, Debug)]
pub(crate) struct Narrow {
    band: Band,
    seen: Weights,
    white: Xyz,
    /// The exact light, weighed.
    exact: Weighed,
    /// The values, weighed, with their spikes of no width.
    ways: [(Weighed, Vec<Line>); 3],
    numbers: usize,
}

/// Colours of the three representations behind one band-pass, each against the exact one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NarrowPoint {
    /// Centre of the band-pass, nm.
    pub centre_nm: f64,
    /// The composite.
    pub composite: Colours,
    /// The same count of numbers without spikes.
    pub series: Colours,
    /// The same count of point samples.
    pub samples: Colours,
}

impl Narrow {
    /// The light `measured` (on the band's grid), its model, and two others of as many numbers.
    ///
    /// With `colour_exact` the series without spikes has the light's own X, Y, Z too.
    #[cfg(test)]
    pub(crate) fn new(
        measured: &[f64],
        model: &crate::spectrum::Composite,
        colour_exact: bool,
        seen: &Weights,
    ) -> Self {
        let values = model.smooth().on_band();
        let parts = (&values[..], model.lines(), model.numbers());
        Self::of_parts(measured, model.smooth(), parts, colour_exact, seen)
    }

    /// The same of a model whose lines have widths: its values on the grid with those lines, so
    /// that a filter narrower than a line is seen as it is, its lines of no width, and the numbers
    /// that it takes. `smooth` is its smooth part.
    pub(crate) fn of_parts(
        measured: &[f64],
        smooth: &Series,
        (values, ideal, numbers): (&[f64], &[Line], usize),
        colour_exact: bool,
        seen: &Weights,
    ) -> Self {
        let band = smooth.band;
        let table = BasisTable::new(band, smooth.basis, numbers);
        let mut series = table.project(measured, numbers);
        if colour_exact {
            let totals = std::array::from_fn(|k| band.inner(measured, &seen[k]));
            InnerProducts::new(&table, seen).make_exact(&mut series, totals);
        }
        let samples = Samples::fit(band, measured, numbers);
        let weighed = |values: &[f64]| {
            seen.each_ref().map(|weight| {
                let products = values.iter().zip(weight).enumerate();
                products.map(|(i, (v, w))| v * w * band.weight(i)).collect()
            })
        };
        Self {
            band,
            white: xyz_of_parts(band, measured, &[], seen),
            seen: seen.clone(),
            exact: weighed(measured),
            ways: [
                (weighed(values), ideal.to_vec()),
                (weighed(&table.evaluate(&series)), Vec::new()),
                (weighed(&samples.on_band()), Vec::new()),
            ],
            numbers,
        }
    }

    /// XYZ of the exact light, value x nm: the white of every difference.
    pub(crate) fn white(&self) -> Xyz {
        self.white
    }

    /// Gain on both sides behind a filter that leaves `exact` of the light.
    pub(crate) fn gain(&self, exact: Xyz) -> f64 {
        let gain = BRIGHT * self.white.y / exact.y.max(0.0);
        if gain.is_nan() {
            1.0
        } else {
            gain.min(MOST_GAIN)
        }
    }

    /// Numbers that each of the three takes.
    pub(crate) fn numbers(&self) -> usize {
        self.numbers
    }

    /// The three behind a Gaussian band-pass of full width `width_nm` (at least
    /// `NARROWEST_NM`) at half its maximum.
    pub(crate) fn behind(&self, centre_nm: f64, width_nm: f64) -> NarrowPoint {
        let width_nm = width_nm.max(NARROWEST_NM);
        let bell = |nm: f64| gaussian((nm - centre_nm) / width_nm);
        let index = |nm: f64| (nm - self.band.min_nm()).clamp(0.0, self.band.points() as f64);
        let first = index((centre_nm - REACH_WIDTHS * width_nm).floor()) as usize;
        let beyond = index((centre_nm + REACH_WIDTHS * width_nm).ceil() + 1.0) as usize;
        let [composite, series, samples] = self.within(bell, first..beyond.max(first));
        NarrowPoint {
            centre_nm,
            composite,
            series,
            samples,
        }
    }

    /// The three behind any filter, given by its transmittance (0-1) at a wavelength in nm:
    /// composite, series alone, samples.
    pub(crate) fn through(&self, filter: impl Fn(f64) -> f64) -> [Colours; 3] {
        self.within(filter, 0..self.band.points())
    }

    /// The same for a filter that is dark but in some points of the grid.
    fn within(&self, filter: impl Fn(f64) -> f64, range: Range<usize>) -> [Colours; 3] {
        let on_grid: Vec<f64> = range.clone().map(|i| filter(self.band.nm(i))).collect();
        let product = |smooth: &Weighed, spikes: &[Line]| {
            Xyz::from_array(std::array::from_fn(|k| {
                let lines = spikes
                    .iter()
                    .map(|s| s.weight * filter(s.at_nm) * self.seen.at(s.at_nm)[k]);
                dot(&smooth[k][range.clone()], &on_grid) + lines.sum::<f64>()
            }))
        };
        let exact = product(&self.exact, &[]);
        self.ways.each_ref().map(|(smooth, spikes)| {
            let model = product(smooth, spikes);
            let y = BRIGHT * self.white.y;
            Colours::brightened(exact, model, self.white, y, MOST_GAIN)
        })
    }

    /// The whole curve: the band-pass at every whole nm of the band, or every `step_nm`-th.
    pub(crate) fn curve(&self, width_nm: f64, step_nm: usize) -> Vec<NarrowPoint> {
        let centres = self.band.grid().step_by(step_nm.max(1));
        centres.map(|nm| self.behind(nm, width_nm)).collect()
    }
}
