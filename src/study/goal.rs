//! The goal that a model is optimised for.

use serde::{Deserialize, Serialize};

use super::{
    measure::{Measure, Verdict},
    reference::Reference,
};
use crate::spectrum::Line;

/// Objective to minimise: a weighted mix of four errors, each over its value at order 0.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Goal {
    /// Weight of the spectrum's own colour.
    pub own: f64,
    /// Weight of the patches' mean.
    pub patches: f64,
    /// Weight of the spectrum behind a 10 nm blur.
    pub spectrum: f64,
    /// Weight of the light behind narrow filters.
    pub filters: f64,
}

impl Default for Goal {
    fn default() -> Self {
        Self::PATCHES
    }
}

impl Goal {
    const NOTHING: Self = Self {
        own: 0.0,
        patches: 0.0,
        spectrum: 0.0,
        filters: 0.0,
    };
    /// The spectrum's own colour.
    pub const OWN: Self = Self {
        own: 1.0,
        ..Self::NOTHING
    };
    /// The patches' mean.
    pub const PATCHES: Self = Self {
        patches: 1.0,
        ..Self::NOTHING
    };
    /// The spectrum behind a 10 nm blur.
    pub const SPECTRUM: Self = Self {
        spectrum: 1.0,
        ..Self::NOTHING
    };
    /// The light behind narrow filters.
    pub const FILTERS: Self = Self {
        filters: 1.0,
        ..Self::NOTHING
    };

    /// The four plain goals with the words used on the command line.
    pub(crate) const PLAIN: [(&'static str, Self); 4] = [
        ("own", Self::OWN),
        ("patches", Self::PATCHES),
        ("spectrum", Self::SPECTRUM),
        ("filters", Self::FILTERS),
    ];

    /// Measures that the plain goals minimise, in the order of [`Goal::PLAIN`].
    pub(crate) const MEASURES: [Measure; 4] = [
        Measure::Own,
        Measure::Patches,
        Measure::RmsBlurred,
        Measure::Filters,
    ];

    /// Every weight finite and not negative; the patches' mean when nothing is wanted.
    #[must_use]
    pub(crate) fn clamped(self) -> Self {
        let within = |w: f64| {
            if w.is_finite() {
                w.clamp(0.0, 1e6)
            } else {
                0.0
            }
        };
        let goal = Self {
            own: within(self.own),
            patches: within(self.patches),
            spectrum: within(self.spectrum),
            filters: within(self.filters),
        };
        if goal == Self::NOTHING {
            Self::PATCHES
        } else {
            goal
        }
    }

    /// The weights in the order of `Goal::PLAIN`.
    pub fn weights(self) -> [f64; 4] {
        [self.own, self.patches, self.spectrum, self.filters]
    }

    /// The word of a plain goal, or the weights of a mixed one: `own 1, filters 2`.
    pub fn words(self) -> String {
        let wanted: Vec<(&str, f64)> = Self::PLAIN
            .iter()
            .zip(self.weights())
            .filter(|(_, weight)| *weight > 0.0)
            .map(|((word, _), weight)| (*word, weight))
            .collect();
        match wanted[..] {
            [(word, _)] => word.to_owned(),
            _ => wanted
                .iter()
                .map(|(word, weight)| format!("{word} {weight}"))
                .collect::<Vec<_>>()
                .join(", "),
        }
    }

    /// The figure of a goal that wants one thing only.
    pub(crate) fn plain_measure(self) -> Option<Measure> {
        let mut wanted = self.wanted();
        let (_, measure) = wanted.next()?;
        wanted.next().is_none().then_some(measure)
    }

    /// The goal's value for a model with these errors, from them and those at order 0; `None` where
    /// nothing of it exists.
    pub fn error(self, errors: &Verdict, at_start: &Verdict) -> Option<f64> {
        if let Some(measure) = self.plain_measure() {
            return errors[measure];
        }
        let (mut sum, mut whole) = (0.0, 0.0);
        for (weight, measure) in self.wanted() {
            if let (Some(error), Some(start)) = (errors[measure], at_start[measure]) {
                whole += weight;
                // What order 0 has right already stays right but for rounding.
                sum += if start > 0.0 {
                    weight * error / start
                } else {
                    0.0
                };
            }
        }
        (whole > 0.0).then(|| sum / whole)
    }

    fn wanted(self) -> impl Iterator<Item = (f64, Measure)> {
        let weighed = self.weights().into_iter().zip(Self::MEASURES);
        weighed.filter(|(weight, _)| *weight > 0.0)
    }

    /// The errors that the goal needs of a model.
    pub(super) fn errors(self, reference: &Reference, smooth: &[f64], spikes: &[Line]) -> Verdict {
        let mut errors = Verdict::default();
        for (_, measure) in self.wanted() {
            errors[measure] = reference.figure(measure, smooth, spikes);
        }
        errors
    }
}
