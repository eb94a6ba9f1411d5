//! Today's eight ways at a count of numbers, as candidates beside known lamps and wide lines.
//!
//! A spike costs two numbers and there is no label: `P = B + 2M`. The heaviest lines of the detector
//! are spikes, as many as make the 10 nm-blurred error least.

use super::{encoding::Encoding, judge::Panel};
use crate::{
    color::Weights,
    spectrum::{Basis, Line, SpikeSettings, detect_shapes},
    study::{FitBasis, FitVariant, ProjectedSpectrum, error::Blur},
};

/// What today's ways share on one band.
#[derive(Clone, Debug)]
pub(super) struct Baselines {
    bases: [FitBasis; 2],
    seen: Weights,
    blur: Blur,
    spikes: SpikeSettings,
    numbers: usize,
}

impl Baselines {
    /// For `numbers` numbers, lines looked for as `spikes` say.
    pub(super) fn new(panel: &Panel, numbers: usize, spikes: SpikeSettings) -> Self {
        let (band, seen) = (panel.band(), panel.seen());
        Self {
            numbers,
            bases: Basis::ALL.map(|basis| FitBasis::new(band, basis, numbers, seen)),
            seen: seen.clone(),
            blur: panel.blur().clone(),
            spikes,
        }
    }

    /// The eight ways; without a line to be found, the four that have no spikes.
    pub(super) fn ways(&self, values: &[f64]) -> Vec<Encoding> {
        let numbers = self.numbers;
        let band = self.bases[0].table.band();
        let (_, shapes) = detect_shapes(band, values, self.spikes);
        let blurred = self.blur.values(values);
        let mut found = Vec::with_capacity(FitVariant::ALL.len());
        for (basis, fit) in Basis::ALL.iter().zip(&self.bases) {
            let projected = ProjectedSpectrum::new(fit, values, &shapes, &self.seen);
            for way in FitVariant::ALL.iter().filter(|way| way.basis == *basis) {
                let most = projected.lines().min(numbers.saturating_sub(3) / 2);
                if way.spikes && most == 0 {
                    // The same as without.
                    continue;
                }
                let count = if way.spikes {
                    self.best_count(&projected, &blurred, most, way.colour_exact)
                } else {
                    0
                };
                let lines: Vec<usize> = (0..count).collect();
                let (model, _) = projected.model(numbers - 2 * count, &lines, way.colour_exact);
                let ideal = |s: &Line| Line::ideal(s.at_nm, s.weight);
                found.push(Encoding {
                    atoms: Vec::new(),
                    lines: model.lines().iter().map(ideal).collect(),
                    smooth: model.smooth().clone(),
                    way: Some(*way),
                });
            }
        }
        found
    }

    /// How many of the heaviest lines make the blurred error least.
    fn best_count(
        &self,
        projected: &ProjectedSpectrum,
        blurred: &[f64],
        most: usize,
        colour_exact: bool,
    ) -> usize {
        let numbers = self.numbers;
        let band = self.bases[0].table.band();
        let error = |count: usize| {
            let lines: Vec<usize> = (0..count).collect();
            let (model, _) = projected.model(numbers - 2 * count, &lines, colour_exact);
            let mut rest = self.blur.values(&projected.smooth(&model));
            rest.iter_mut().zip(blurred).for_each(|(r, b)| *r -= b);
            self.blur.add_lines(model.lines(), &mut rest);
            band.inner(&rest, &rest)
        };
        (0..=most)
            .map(|count| (count, error(count)))
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .map_or(0, |(count, _)| count)
    }
}
