//! Error against numbers, every order of all eight ways, and what the threshold changes.

use std::sync::Arc;

use super::{
    error::{height, times},
    measure::{Measure, Verdict},
    progress::Progress,
    projected_spectrum::{FitBasis, ProjectedSpectrum},
    reference::{Measures, Reference, scaled_to_one},
    way::FitVariant,
};
use crate::spectrum::{
    Band, Basis, Line, LineShape, PerBasis, SpikeSettings, detect_shapes, numbers_of_order,
};

/// The subject of a study on the band of its measures.
#[derive(Clone, Debug)]
pub struct Subject {
    /// Measures by which it is judged.
    pub measures: Arc<Measures>,
    /// The spectrum on the band's grid.
    pub values: Vec<f64>,
    /// The light on the grid when the subject is a reflectance; `None` when it is a light.
    pub under: Option<Vec<f64>>,
    /// Settings of the line detector.
    pub spikes: SpikeSettings,
    /// Function that gives lines their widths; without it all are ideal.
    pub profile: Option<ProfileOf>,
}

/// A line's own Gaussian on the grid of a band, from what the detector took out, in the same unit;
/// nothing for a line of no width. Made above this room.
pub(super) type ProfileOf = fn(Band, &LineShape, SpikeSettings) -> Option<LineShape>;

/// A subject scaled, judged and taken apart: what all studies of it begin with.
#[derive(Clone, Debug)]
pub struct Examined {
    /// The reference of the scaled spectrum.
    pub reference: Reference,
    /// Part of the spectrum that each line removes, heaviest first; the same scale.
    pub shapes: Vec<LineShape>,
    /// The profiles of those that have a width; empty where all lines are ideal.
    pub profiles: Vec<Option<LineShape>>,
    /// Each basis with its colours.
    pub bases: PerBasis<FitBasis>,
}

impl Examined {
    /// Looks at a subject with up to `numbers` smooth numbers; `None` for an all-zero spectrum.
    pub fn of(subject: &Subject, numbers: usize) -> Option<Self> {
        let measures = &subject.measures;
        let band = measures.band();
        let unit = height(&subject.values)?;
        let values = times(&subject.values, unit);
        let reference = match &subject.under {
            None => Reference::of_light(measures, &values),
            Some(light) => {
                let light = scaled_to_one(light).unwrap_or_else(|| light.clone());
                Reference::of_factor(measures, &values, &light, unit)
            }
        };
        let (_, shapes) = detect_shapes(band, &values, subject.spikes);
        let bases = PerBasis::of(|basis| FitBasis::new(band, basis, numbers, reference.seen()));
        let profile = subject.profile.filter(|_| !shapes.is_empty());
        let profiles = profile.map_or_else(Vec::new, |profile| {
            let profiles = shapes
                .iter()
                .map(|shape| profile(band, shape, subject.spikes));
            profiles.collect()
        });
        Some(Self {
            reference,
            shapes,
            profiles,
            bases,
        })
    }

    /// The spectrum in terms of a basis, with these lines.
    pub fn projected(&self, basis: Basis, shapes: &[LineShape]) -> ProjectedSpectrum {
        self.projected_with(basis, shapes, &[])
    }

    /// The same where lines have profiles.
    pub(crate) fn projected_with(
        &self,
        basis: Basis,
        shapes: &[LineShape],
        profiles: &[Option<LineShape>],
    ) -> ProjectedSpectrum {
        let fit_basis = &self.bases[basis];
        ProjectedSpectrum::with_profiles(
            fit_basis,
            self.reference.measured(),
            shapes,
            profiles,
            self.reference.seen(),
        )
    }

    /// Every order of every way: all orders of the first way, then of the next. `after_way` is called
    /// after each way; `None` when it was cancelled.
    pub(crate) fn every_way(
        &self,
        highest_order: usize,
        progress: &Progress,
        after_way: impl Fn(),
    ) -> Option<Vec<SweepPoint>> {
        let mut points = Vec::with_capacity(FitVariant::ALL.len() * (highest_order + 1));
        for way in FitVariant::ALL {
            let shapes = if way.spikes { &self.shapes[..] } else { &[] };
            let projected = self.projected(way.basis, shapes);
            let lines: Vec<usize> = (0..shapes.len()).collect();
            for order in 0..=highest_order {
                if progress.is_cancelled() {
                    return None;
                }
                points.push(SweepPoint {
                    way,
                    order,
                    spikes: lines.len(),
                    numbers: numbers_of_order(order) + 2 * lines.len(),
                    verdict: self.verdict(&projected, order, &lines, way.colour_exact),
                });
            }
            after_way();
        }
        Some(points)
    }

    fn verdict(
        &self,
        projected: &ProjectedSpectrum,
        order: usize,
        lines: &[usize],
        exact: bool,
    ) -> Verdict {
        let (model, _) = projected.model(numbers_of_order(order), lines, exact);
        self.reference
            .verdict(&projected.smooth(&model), model.lines())
    }
}

/// One model of the sweep.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct SweepPoint {
    /// Method of the fit.
    pub way: FitVariant,
    /// Order N.
    pub order: usize,
    /// Spikes it has.
    pub spikes: usize,
    /// Numbers it takes, `2N + 1 + 2M`.
    pub numbers: usize,
    /// Its errors.
    pub verdict: Verdict,
}

/// Effect of the threshold, with one basis and fit.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct ThresholdMap {
    /// Thresholds, percent of the power, rising.
    pub thresholds_percent: Vec<f64>,
    /// Spikes found at each threshold.
    pub spikes: Vec<usize>,
    /// Highest order; the orders are 0 to this.
    pub highest_order: usize,
    /// Errors of each model: all orders of the first threshold, then of the next.
    pub verdicts: Vec<Verdict>,
}

impl ThresholdMap {
    /// The verdict at a threshold's index and an order.
    #[cfg(test)]
    pub(crate) fn at(&self, threshold: usize, order: usize) -> &Verdict {
        &self.verdicts[threshold * (self.highest_order + 1) + order]
    }
}

/// Error against numbers for one spectrum.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Sweep {
    /// All orders of the first way, then of the next.
    pub points: Vec<SweepPoint>,
    /// The threshold's effect.
    pub map: ThresholdMap,
    /// Spikes at the threshold in force, heaviest first; weights over the spectrum's largest value.
    pub spikes: Vec<Line>,
}

/// An error below which nobody sees or measures a difference: CIEDE2000 of colours, a share of
/// spectra.
pub(crate) fn just_noticeable(measure: Measure) -> f64 {
    if measure.is_colour() { 1e-4 } else { 1e-6 }
}

/// Thresholds of the map: the slider's 0.1 to 5 %, even steps of its logarithm.
pub(super) const MAP_THRESHOLDS: usize = 25;

impl Sweep {
    /// Sweeps a subject to `highest_order`, with the map for one basis and fit.
    ///
    /// `None` when the spectrum is all zero or the study was cancelled.
    pub(crate) fn of(
        subject: &Subject,
        highest_order: usize,
        basis: Basis,
        colour_exact: bool,
        progress: &Progress,
    ) -> Option<Self> {
        let band = subject.measures.band();
        let highest_order = highest_order.min(Basis::highest_order(band));
        progress.expect(FitVariant::ALL.len() + MAP_THRESHOLDS);
        let examined = Examined::of(subject, numbers_of_order(highest_order))?;
        let points = examined.every_way(highest_order, progress, || progress.step())?;
        let map = threshold_map(
            subject,
            &examined,
            highest_order,
            basis,
            colour_exact,
            progress,
        )?;
        Some(Self {
            points,
            map,
            spikes: examined.shapes.iter().map(|s| s.spike).collect(),
        })
    }

    /// The points of one way, by rising order.
    #[cfg(test)]
    pub(crate) fn of_way(&self, way: FitVariant) -> impl Iterator<Item = &SweepPoint> {
        self.points.iter().filter(move |p| p.way == way)
    }

    /// The Pareto front of the ways that `counts`, as indices of points: by rising numbers, every
    /// point that is better than all cheaper ones. It ends with the first whose error is
    /// [`just_noticeable`].
    pub(crate) fn front(
        &self,
        measure: Measure,
        counts: impl Fn(FitVariant) -> bool,
    ) -> Vec<usize> {
        let mut by_cost: Vec<(usize, usize, f64)> = self
            .points
            .iter()
            .enumerate()
            .filter(|(_, point)| counts(point.way))
            .filter_map(|(i, p)| Some((i, p.numbers, p.verdict[measure]?)))
            .collect();
        by_cost.sort_by(|a, b| a.1.cmp(&b.1).then(a.2.total_cmp(&b.2)));
        let mut best = f64::INFINITY;
        by_cost.retain(|(_, _, error)| {
            let better = *error < best && best >= just_noticeable(measure);
            best = best.min(*error);
            better
        });
        by_cost.into_iter().map(|(index, ..)| index).collect()
    }
}

fn threshold_map(
    subject: &Subject,
    examined: &Examined,
    highest_order: usize,
    basis: Basis,
    colour_exact: bool,
    progress: &Progress,
) -> Option<ThresholdMap> {
    let (lowest, highest) = (0.1_f64, 5.0_f64);
    let step = (highest / lowest).powf(1.0 / (MAP_THRESHOLDS - 1) as f64);
    let thresholds_percent: Vec<f64> = (0..MAP_THRESHOLDS)
        .map(|i| lowest * step.powi(i as i32))
        .collect();
    let mut verdicts: Vec<Verdict> = Vec::new();
    let mut spikes = Vec::new();
    let mut before: Option<Vec<LineShape>> = None;
    for threshold in &thresholds_percent {
        let settings = SpikeSettings {
            threshold: threshold / 100.0,
            ..subject.spikes
        };
        let (_, shapes) = detect_shapes(
            subject.measures.band(),
            examined.reference.measured(),
            settings,
        );
        spikes.push(shapes.len());
        if before.as_ref() == Some(&shapes) {
            // The same lines give the same row.
            let row = verdicts.len() - (highest_order + 1);
            verdicts.extend_from_within(row..);
        } else {
            let projected = examined.projected(basis, &shapes);
            let lines: Vec<usize> = (0..shapes.len()).collect();
            for order in 0..=highest_order {
                if progress.is_cancelled() {
                    return None;
                }
                verdicts.push(examined.verdict(&projected, order, &lines, colour_exact));
            }
        }
        before = Some(shapes);
        progress.step();
    }
    Some(ThresholdMap {
        thresholds_percent,
        spikes,
        highest_order,
        verdicts,
    })
}
