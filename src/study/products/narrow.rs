//! A narrow band-pass that moves over a light: what each representation sees through it.
//!
//! Three ways with the same count of numbers: the composite, its basis without any spike, and
//! plain point samples with straight lines between. The filter is exact in all three. Both sides
//! are brightened so that the exact light behind it has half the Y of the whole light (by at most
//! fifty times as much as when the light has Y = 100), as in every figure "behind narrow filters".

use super::{Colours, multiplied, xyz};
use crate::{
    color::Xyz,
    rivals::{Representation, Samples},
    spectrum::{Band, BasisTable, Composite, InnerProducts, Spike},
};

/// Y that the light behind the filter is brought to, of the whole light's 1.
const BRIGHT: f64 = 0.5;

/// Most that it is brightened by.
const MOST_GAIN: f64 = 50.0;

/// Narrowest band-pass, full width at half maximum in nm: narrower ones fall between the points
/// of the 1 nm grid on which the exact light is summed.
pub const NARROWEST_NM: f64 = 2.0;

/// A light in three representations of equal size.
#[derive(Clone, Debug)]
pub struct Narrow {
    band: Band,
    seen: [Vec<f64>; 3],
    white: Xyz,
    measured: Vec<f64>,
    /// Smooth values on the grid with their spikes.
    ways: [(Vec<f64>, Vec<Spike>); 3],
    numbers: usize,
}

/// What the three are off by behind one band-pass.
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
    pub fn new(
        measured: &[f64],
        model: &Composite,
        colour_exact: bool,
        seen: &[Vec<f64>; 3],
    ) -> Self {
        let band = model.band();
        let numbers = model.numbers();
        let table = BasisTable::new(band, model.smooth.basis, numbers);
        let mut series = table.project(measured, numbers);
        if colour_exact {
            let totals = std::array::from_fn(|k| band.inner(measured, &seen[k]));
            InnerProducts::new(&table, seen).make_exact(&mut series, totals);
        }
        let samples = Samples::fit(band, measured, numbers);
        Self {
            band,
            white: xyz(band, measured, &[], seen),
            seen: seen.clone(),
            measured: measured.to_vec(),
            ways: [
                (model.smooth.on_band(), model.spikes.clone()),
                (table.evaluate(&series), Vec::new()),
                (samples.on_band(), Vec::new()),
            ],
            numbers,
        }
    }

    /// Numbers that each of the three takes.
    pub fn numbers(&self) -> usize {
        self.numbers
    }

    /// The three behind a Gaussian band-pass of full width `width_nm` (at least
    /// [`NARROWEST_NM`]) at half its maximum.
    pub fn behind(&self, centre_nm: f64, width_nm: f64) -> NarrowPoint {
        let width_nm = width_nm.max(NARROWEST_NM);
        let bell = |nm: f64| {
            let x = (nm - centre_nm) / width_nm;
            (-4.0 * std::f64::consts::LN_2 * x * x).exp()
        };
        let [composite, series, samples] = self.through(bell);
        NarrowPoint {
            centre_nm,
            composite,
            series,
            samples,
        }
    }

    /// The three behind any filter, given by its transmittance (0-1) at a wavelength in nm:
    /// composite, series alone, samples.
    pub fn through(&self, filter: impl Fn(f64) -> f64) -> [Colours; 3] {
        let on_grid: Vec<f64> = self.band.grid().map(&filter).collect();
        let product = |smooth: &[f64], spikes: &[Spike]| {
            let behind: Vec<Spike> = spikes
                .iter()
                .map(|s| Spike {
                    weight: s.weight * filter(s.at_nm),
                    ..*s
                })
                .collect();
            xyz(
                self.band,
                &multiplied(smooth, &on_grid),
                &behind,
                &self.seen,
            )
        };
        let exact = product(&self.measured, &[]);
        self.ways.each_ref().map(|(smooth, spikes)| {
            let model = product(smooth, spikes);
            let y = BRIGHT * self.white.y;
            Colours::brightened(exact, model, self.white, y, MOST_GAIN)
        })
    }

    /// The whole curve: the band-pass at every whole nm of the band, or every `step_nm`-th.
    pub fn curve(&self, width_nm: f64, step_nm: usize) -> Vec<NarrowPoint> {
        let centres = self.band.grid().step_by(step_nm.max(1));
        centres.map(|nm| self.behind(nm, width_nm)).collect()
    }
}
