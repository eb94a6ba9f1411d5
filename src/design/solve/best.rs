//! The mixtures that are best by figures of samples, and the fewest channels that do.

use super::{
    climb::{MOST_LOOKS, Place, Worth, climbed, worth},
    polytope::Polytope,
    solution::Mixer,
    wish::{Favour, Wish},
};
use crate::design::scales::{BASIC, Scales, Sums};

/// Sets of channels that are looked through for the fewest.
const MOST_SETS: usize = 4000;

/// What was missing to a floor and is rounding.
const ROUNDING: f64 = 1e-9;

/// How often what is left between the best found and what no floor would forbid is halved.
const HALVINGS: usize = 8;

/// Less than this share is not worth a further look.
const NEAR_ENOUGH: f64 = 1e-3;

impl Mixer<'_> {
    /// The best by a figure of samples.
    pub(super) fn climbed(
        &self,
        within: &Polytope,
        free: &[usize],
        wish: &Wish<'_>,
        scales: &Scales,
        looks: usize,
        enough: &dyn Fn(Worth) -> bool,
    ) -> Option<(Vec<f64>, Worth)> {
        let fixed = self.fixed_sums();
        let place = |weights: Vec<f64>| {
            let mut sums = fixed.clone();
            for (i, weight) in free.iter().zip(&weights) {
                sums.add(&self.sums[*i], *weight, true);
            }
            Place { weights, sums }
        };
        let mut corners: Vec<Place> = within.corners().into_iter().map(place).collect();
        // What is most like the reference shows colours much as it does: a start near the top.
        let like = scales
            .reference()
            .and_then(|light| self.matched(free, wish, &light));
        let like = like.map(|weights| weights.iter().map(|w| 0.01 * w).collect::<Vec<f64>>());
        corners.extend(
            like.and_then(|weights| within.completed(&weights))
                .map(place),
        );
        let judge = |sums: &Sums| worth(sums, wish.favour, wish.floors, scales);
        let (best, value) = climbed(&corners, &judge, looks, enough)?;
        Some((self.spread(free, &best.weights), value))
    }

    /// The most lumens or the most melanopic light that floors of Ra and Rf leave.
    ///
    /// On the edge of a floor each single step loses either the floor or the favour, so the climb
    /// stops short there. Whether a floor can be met at a given efficacy has no such edge: that is
    /// asked again, each time in half of what is left.
    pub(super) fn traded(
        &self,
        within: &Polytope,
        free: &[usize],
        wish: &Wish<'_>,
        scales: &Scales,
        possible: &dyn Fn([Option<f64>; 2]) -> Option<Polytope>,
    ) -> Option<Vec<f64>> {
        let (mut best, mut worth) =
            self.climbed(within, free, wish, scales, MOST_LOOKS, &|_| false)?;
        let met = |worth: Worth| worth.missing <= ROUNDING;
        let is_lumens = wish.favour == Favour::Ler;
        let figure = |weights: &[f64]| {
            let sums = self.summed(weights);
            if is_lumens {
                sums.efficacy()
            } else {
                sums.melanopic_der()
            }
        };
        let most = if is_lumens {
            within.most_lumens()
        } else {
            within.most_melanopic()
        };
        let mut high = figure(&self.spread(free, &most));
        let within = |value: f64| {
            possible(match is_lumens {
                true => [Some(value), wish.floors.melanopic],
                false => [wish.floors.ler, Some(value)],
            })
        };
        for _ in 0..HALVINGS {
            if !met(worth) || high - worth.value <= NEAR_ENOUGH * high {
                break;
            }
            let middle = 0.5 * (worth.value + high);
            let found = within(middle)
                .and_then(|within| self.climbed(&within, free, wish, scales, MOST_LOOKS, &met));
            match found {
                Some((weights, found)) if met(found) && found.beats(worth) => {
                    (best, worth) = (weights, found);
                }
                _ => high = middle,
            }
        }
        // The climb itself once more, among what is at least as good.
        let last = within(worth.value)
            .filter(|_| met(worth))
            .and_then(|within| self.climbed(&within, free, wish, scales, MOST_LOOKS, &|_| false));
        if let Some((weights, found)) = last
            && found.beats(worth)
        {
            best = weights;
        }
        Some(best)
    }

    /// The fewest channels that meet the wish, by efficacy among those.
    pub(super) fn fewest(
        &self,
        wish: &Wish<'_>,
        free: &[usize],
        scales: Option<&Scales>,
    ) -> Option<Vec<f64>> {
        let target = wish.target?.xyz() * 0.01;
        let mut looked = 0;
        for count in 0..=free.len() {
            let mut best: Option<(f64, Vec<f64>)> = None;
            let mut set: Vec<usize> = (0..count).collect();
            loop {
                looked += 1;
                if looked > MOST_SETS {
                    return best.map(|(_, weights)| weights);
                }
                let chosen: Vec<usize> = set.iter().map(|i| free[*i]).collect();
                let sums: Vec<[f64; BASIC]> = chosen.iter().map(|i| self.sums[*i].basic).collect();
                let fixed = self.fixed_sums().basic;
                let floors = wish.floors;
                let within = Polytope::new(
                    &sums,
                    fixed,
                    target.to_array(),
                    floors.ler,
                    floors.melanopic,
                );
                let found = within.and_then(|within| match scales {
                    Some(scales) if floors.of_samples() => {
                        let met = |worth: Worth| worth.missing <= ROUNDING;
                        let found = self.climbed(&within, &chosen, wish, scales, 80, &met)?;
                        met(found.1).then_some(found.0)
                    }
                    _ => Some(self.spread(&chosen, &within.most_lumens())),
                });
                if let Some(weights) = found {
                    let efficacy = self.summed(&weights).efficacy();
                    if best.as_ref().is_none_or(|(most, _)| efficacy > *most) {
                        best = Some((efficacy, weights));
                    }
                }
                if !next_set(&mut set, free.len()) {
                    break;
                }
            }
            if best.is_some() {
                return best.map(|(_, weights)| weights);
            }
        }
        None
    }
}

/// The next set of that size in the order of words; false behind the last.
pub(super) fn next_set(set: &mut [usize], of: usize) -> bool {
    let count = set.len();
    let Some(at) = (0..count).rev().find(|i| set[*i] < of - count + i) else {
        return false;
    };
    set[at] += 1;
    (at + 1..count).for_each(|i| set[i] = set[i - 1] + 1);
    true
}
