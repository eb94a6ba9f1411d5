//! Some 400 samples against about 20 numbers.

use super::{MOST_SPIKES, TOTAL_NUMBERS};
use crate::{
    color::{Weights, Xyz, delta_e_of_xyz, xyz_of_parts},
    spectrum::{Band, BasisTable, Line, LineShape},
    study::{
        error::{Blur, spectrum_errors},
        measure::{ByMeasure, Measure, Verdict},
    },
};

/// A spectrum with its lines, and how it is looked at.
#[derive(Clone, Copy, Debug)]
pub struct Question<'a> {
    /// Basis functions, at least the first 20.
    pub table: &'a BasisTable,
    /// The blur of 10 nm on the same band.
    pub blur: &'a Blur,
    /// The spectrum as measured, on the band's grid.
    pub measured: &'a [f64],
    /// Its lines, each with what it takes out of the spectrum.
    pub lines: &'a [LineShape],
    /// Weights of the spectrum for X, Y and Z, on the same grid.
    pub weights: &'a Weights,
    /// XYZ of the exact light in the same unit: the white.
    pub white: Xyz,
}

/// "400 samples or about 20 numbers": what each comes to on this spectrum.
#[derive(Clone, Debug, PartialEq)]
pub struct SamplesAgainstNumbers {
    /// Numbers for the smooth part of the composite.
    pub background: usize,
    /// Spikes of the composite, two numbers each.
    pub spikes: usize,
    /// Errors of the composite. On the 1 nm grid a spike is split over its two neighbouring nm: a
    /// line of some width counts as missed there, however accurate its weight.
    pub composite: Verdict,
    /// Every even grid that was tried, from 1 nm on: the curve to draw.
    pub tried: Vec<SampledErrors>,
    /// Sampling needed to do as well as the composite by each error; `None` for colours where there
    /// are none.
    pub needed: ByMeasure<Option<Match>>,
}

impl SamplesAgainstNumbers {
    /// Numbers that the composite takes.
    pub(crate) fn numbers(&self) -> usize {
        self.background + 2 * self.spikes
    }
}

/// Samples at even steps from end to end of the range, joined by straight lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SampledErrors {
    /// Number of samples.
    pub samples: usize,
    /// Errors of the straight lines.
    pub errors: Verdict,
}

/// Samplings that are off by no more than the composite.
///
/// The count that suffices depends on where the samples happen to fall, so there are two answers.
/// A step of 1 nm loses nothing on the grid and always suffices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Match {
    /// The fewest samples that do as well and so does every finer grid tried.
    pub surely: SampledErrors,
    /// The fewest tried that do as well, be it by good fortune.
    pub at_best: SampledErrors,
}

/// Sets the paper's 20 numbers (12 for the background and 8 for the four heaviest lines; what
/// fewer lines leave goes to the background) against samples; `None` for an all-zero spectrum.
///
/// The fit is the paper's plain one: made colour-exact, its own colour would have no error to
/// match.
///
/// # Panics
/// When the measured values or the weights are not on the grid of the table's band.
pub fn samples(question: Question<'_>) -> Option<SamplesAgainstNumbers> {
    let heaviest = heaviest(question.lines, MOST_SPIKES);
    let numbers = TOTAL_NUMBERS - 2 * heaviest.len();
    let (smooth, background) = background(question, &heaviest, numbers);
    let spikes: Vec<Line> = heaviest.iter().map(|line| line.spike).collect();
    let composite = question.errors(&smooth, &spikes)?;
    let tried: Vec<SampledErrors> = counts(question.table.band().points())
        .map(|samples| question.sampled(samples))
        .collect::<Option<_>>()?;
    let needed = ByMeasure::from_fn(|measure| {
        let is_error = Measure::COMPARED.contains(&measure);
        is_error.then(|| Match::of(&tried, composite, measure))?
    });
    // Whoever has values has these.
    needed[Measure::Rms].and(needed[Measure::RmsBlurred])?;
    Some(SamplesAgainstNumbers {
        background,
        spikes: spikes.len(),
        composite,
        needed,
        tried,
    })
}

/// The lines of largest weight, at most `most`.
pub(super) fn heaviest(lines: &[LineShape], most: usize) -> Vec<&LineShape> {
    let mut by_weight: Vec<&LineShape> = lines.iter().collect();
    by_weight.sort_by(|a, b| b.spike.weight.abs().total_cmp(&a.spike.weight.abs()));
    by_weight.truncate(most);
    by_weight
}

/// The fitted smooth part without some lines on the grid, and how many numbers it took.
pub(super) fn background(
    question: Question<'_>,
    without: &[&LineShape],
    numbers: usize,
) -> (Vec<f64>, usize) {
    let mut target = question.measured.to_vec();
    for line in without {
        line.take_from(&mut target);
    }
    let coefficients = question.table.project(&target, numbers);
    (question.table.evaluate(&coefficients), coefficients.len())
}

/// Counts of samples to try on a grid of so many points, falling to 2: every one below 440; above,
/// so that a long range stays quick, the fewer of them the more there are.
pub(super) fn counts(points: usize) -> impl Iterator<Item = usize> {
    let next = |count: &usize| count.checked_sub(1 + count.saturating_sub(400) / 40);
    std::iter::successors(Some(points), next).take_while(|count| *count >= 2)
}

impl Match {
    /// The matches among samplings of falling count; `None` when there is nothing to match.
    pub(super) fn of(
        tried: &[SampledErrors],
        composite: Verdict,
        measure: Measure,
    ) -> Option<Self> {
        let limit = composite[measure]?;
        let does = |s: &&SampledErrors| s.errors[measure].is_some_and(|off| off <= limit);
        Some(Self {
            surely: *tried.iter().take_while(does).last()?,
            at_best: *tried.iter().rfind(does)?,
        })
    }
}

impl Question<'_> {
    /// Errors of a smooth part on the grid and spikes; `None` for an all-zero spectrum.
    fn errors(self, smooth: &[f64], spikes: &[Line]) -> Option<Verdict> {
        let band = self.table.band();
        let mut errors = spectrum_errors(self.blur, self.measured, smooth, spikes)?;
        let exact = xyz_of_parts(band, self.measured, &[], self.weights);
        let found = xyz_of_parts(band, smooth, spikes, self.weights);
        errors[Measure::Own] = delta_e_of_xyz(exact, found, self.white);
        Some(errors)
    }

    /// So many samples from end to end, joined by straight lines.
    fn sampled(self, samples: usize) -> Option<SampledErrors> {
        let lines = straight_lines(self.table.band(), self.measured, samples);
        Some(SampledErrors {
            samples,
            errors: self.errors(&lines, &[])?,
        })
    }
}

/// Values on a band's grid read at so many even places (at least two) from end to end, and the
/// straight lines between.
pub(super) fn straight_lines(band: Band, values: &[f64], samples: usize) -> Vec<f64> {
    let step_nm = band.length_nm() / (samples - 1) as f64;
    // A place that rounding put beyond the end is the end.
    let place = |sample: usize| (band.min_nm() + step_nm * sample as f64).min(band.max_nm());
    let read: Vec<f64> = (0..samples)
        .map(|sample| band.interpolate(values, place(sample)))
        .collect();
    let line = |index: usize| {
        let at = index as f64 / step_nm;
        let left = (at as usize).min(samples - 2);
        let t = at - left as f64;
        read[left] * (1.0 - t) + read[left + 1] * t
    };
    (0..values.len()).map(line).collect()
}
