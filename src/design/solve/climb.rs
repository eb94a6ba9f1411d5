//! The best mixture of a colour by a figure that is no sum: Ra, Rf, with floors of either.
//!
//! From each corner of what is possible the way leads towards and away from the other corners, in
//! steps that double while they help and halve when they do not. The figures have kinks (each is a
//! mean of distances), on which slopes mislead; so none is used. The order of everything is fixed:
//! the same input takes the same way. `argmin` and `levenberg-marquardt` know no bounds or kinks,
//! `clarabel` wants a convex problem.

use super::wish::{Favour, Floors};
use crate::design::scales::{Scales, Sums};

/// Mixtures looked at for a figure of samples: some 4 ms of Rf.
pub(super) const MOST_LOOKS: usize = 240;

/// A step this small is none.
const SMALLEST_STEP: f64 = 1e-4;

/// A mixture among corners: weights, and the sums that they make.
#[derive(Clone, Debug)]
pub(super) struct Place {
    pub(super) weights: Vec<f64>,
    pub(super) sums: Sums,
}

impl Place {
    /// `(1 - part) self + part other`.
    fn towards(&self, other: &Self, part: f64) -> Self {
        let mix = |a: &[f64], b: &[f64]| {
            let both = a.iter().zip(b);
            both.map(|(a, b)| a + part * (b - a)).collect::<Vec<f64>>()
        };
        let (a, b) = (&self.sums, &other.sums);
        Self {
            weights: mix(&self.weights, &other.weights),
            sums: Sums {
                basic: std::array::from_fn(|k| a.basic[k] + part * (b.basic[k] - a.basic[k])),
                rendering: mix(&a.rendering, &b.rendering),
                fidelity: mix(&a.fidelity, &b.fidelity),
            },
        }
    }

    /// How far one can go away from another place before a weight turns negative, as `part`.
    fn room_away(&self, other: &Self) -> f64 {
        let both = self.weights.iter().zip(&other.weights);
        both.filter(|(a, b)| b > a)
            .map(|(a, b)| a / (b - a))
            .fold(f64::INFINITY, f64::min)
            .max(0.0)
    }
}

/// What a place is worth: first how far it is below the floors, then the favour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Worth {
    /// Sum of what is missing to the floors of Ra and Rf.
    pub(super) missing: f64,
    pub(super) value: f64,
}

impl Worth {
    pub(super) const NONE: Self = Self {
        missing: f64::INFINITY,
        value: f64::NEG_INFINITY,
    };

    pub(super) fn beats(self, other: Self) -> bool {
        self.missing < other.missing || (self.missing == other.missing && self.value > other.value)
    }
}

/// A mixture judged.
pub(super) fn worth(sums: &Sums, favour: Favour, floors: Floors, scales: &Scales) -> Worth {
    let missing = |floor: Option<f64>, figure: &dyn Fn() -> Option<f64>| match floor {
        None => 0.0,
        Some(floor) => figure().map_or(f64::INFINITY, |value| (floor - value).max(0.0)),
    };
    let missing = missing(floors.ra, &|| scales.ra(sums)) + missing(floors.rf, &|| scales.rf(sums));
    let value = match favour {
        Favour::Ler | Favour::Fewest => Some(sums.efficacy()),
        Favour::Melanopic => Some(sums.melanopic_der()),
        Favour::Ra => scales.ra(sums),
        Favour::Rf => scales.rf(sums),
    };
    match value {
        Some(value) if missing.is_finite() => Worth { missing, value },
        _ => Worth::NONE,
    }
}

/// The best mixture of corners by `judge`, looked at no more than `most` times; the first that is
/// `enough`.
pub(super) fn climbed(
    corners: &[Place],
    judge: &dyn Fn(&Sums) -> Worth,
    most: usize,
    enough: &dyn Fn(Worth) -> bool,
) -> Option<(Place, Worth)> {
    let first = corners.first()?;
    let mut middle = first.clone();
    for (index, corner) in corners.iter().enumerate().skip(1) {
        middle = middle.towards(corner, 1.0 / (index + 1) as f64);
    }
    let mut starts: Vec<(Place, Worth)> = Vec::new();
    for place in std::iter::once(&middle).chain(corners) {
        starts.push((place.clone(), judge(&place.sums)));
    }
    let mut best = starts[0].clone();
    for start in &starts[1..] {
        if start.1.beats(best.1) {
            best = start.clone();
        }
    }
    // From the best corner and from the middle; where these are the same, once.
    let mut ways = vec![best.clone()];
    if best.0.weights != middle.weights {
        ways.push(starts[0].clone());
    }
    let share = most / ways.len().max(1);
    for start in ways {
        let (mut place, mut worth) = start;
        let mut steps: Vec<[f64; 2]> = vec![[0.25, 0.25]; corners.len()];
        let mut looked = 0;
        while looked < share && !enough(worth) {
            let mut largest = 0.0_f64;
            for (corner, steps) in corners.iter().zip(&mut steps) {
                for (sense, step) in [1.0, -1.0].into_iter().zip(steps.iter_mut()) {
                    let reach = if sense > 0.0 {
                        1.0
                    } else {
                        place.room_away(corner)
                    };
                    let part = f64::min(*step, reach);
                    if part < SMALLEST_STEP {
                        continue;
                    }
                    let trial = place.towards(corner, sense * part);
                    let found = judge(&trial.sums);
                    looked += 1;
                    if found.beats(worth) {
                        (place, worth) = (trial, found);
                        *step = (2.0 * part).min(1.0);
                    } else {
                        *step = 0.5 * part;
                    }
                    largest = largest.max(*step);
                }
            }
            if largest < SMALLEST_STEP {
                break;
            }
        }
        if worth.beats(best.1) {
            best = (place, worth);
        }
        if enough(best.1) {
            break;
        }
    }
    best.0.weights.iter_mut().for_each(|w| *w = w.max(0.0));
    Some(best)
}
