//! Weights of channels for a problem.

use super::{
    figures::MixFigures,
    polytope::Polytope,
    problem::{Floors, Objective, Problem},
};
use crate::{
    color::{uv_1976_from_xyz, xyz::POINTS},
    design::{
        gamut::{nearest_mix, reach},
        least_squares::least_squares,
        mixture::{Channel, MOST_CHANNELS, MixError},
        programme::End,
        scales::{SampleTables, Scales, Sums, basic_sums},
        small::digits,
    },
    languages::{self, with_sign},
};

/// Channels weighed for a problem.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// Power of each channel; Y = 100 for the whole where nothing is fixed.
    pub weights: Vec<f64>,
    /// The figures of the mixture.
    pub figures: MixFigures,
    /// Distance to the target in CIE 1976 u'v'; `None` without a target or a colour.
    pub delta_uv_to_target: Option<f64>,
    /// True if the colour and all floors are met.
    pub reached: bool,
    /// The result reached, or the obstacle to it, in words.
    pub why: String,
}

/// Weights for a problem, and what is to be known of how they were found.
#[derive(Debug)]
pub(super) struct Best {
    pub(super) weights: Vec<f64>,
    pub(super) note: Option<String>,
}

impl From<Vec<f64>> for Best {
    fn from(weights: Vec<f64>) -> Self {
        let note = None;
        Self { weights, note }
    }
}

/// Channels with the sums that their figures need: made once, solved at every move of a fader.
#[derive(Clone, Debug)]
pub struct Mixer<'a> {
    channels: &'a [Channel],
    tables: &'a SampleTables,
    pub(super) sums: Vec<Sums>,
}

impl<'a> Mixer<'a> {
    /// Prepares channels.
    ///
    /// # Errors
    /// [`MixError::Channels`] for none or more than `MOST_CHANNELS`.
    pub fn new(channels: &'a [Channel], tables: &'a SampleTables) -> Result<Self, MixError> {
        if channels.is_empty() || channels.len() > MOST_CHANNELS {
            return Err(MixError::Channels {
                found: channels.len(),
            });
        }
        Ok(Self {
            channels,
            tables,
            sums: channels.iter().map(|c| tables.sums(&c.values)).collect(),
        })
    }

    /// The figures of the channels at these powers: what a moved fader shows.
    pub fn figures(&self, weights: &[f64]) -> MixFigures {
        MixFigures::new(&self.summed(weights), self.tables)
    }

    /// The corners of the region of CIE 1976 u'v' that the channels can show, against the clock.
    pub(crate) fn reachable_uv(&self) -> Vec<[f64; 2]> {
        reach(&self.colours())
    }

    /// X, Y, Z of each channel.
    fn colours(&self) -> Vec<[f64; 3]> {
        let colour = |sums: &Sums| sums.xyz().to_array();
        self.sums.iter().map(colour).collect()
    }

    /// Weights for a problem.
    pub fn solve(&self, problem: &Problem<'_>) -> Solution {
        let Some(target) = problem.target else {
            return self.described(self.fixed_or(1.0), problem, None);
        };
        let free = self.free();
        let colour = Problem {
            floors: Floors::default(),
            ..*problem
        };
        let all = match self.possible(&free, &colour) {
            Ok(all) => all,
            Err(end) => return self.nearest(problem, end),
        };
        if let Some(alike) = problem.alike {
            return self.alike(problem, alike);
        }
        let scales = Scales::new(target.xyz(), self.tables);
        match self.favoured(&all, &free, problem, scales.as_ref()) {
            Ok(best) => {
                let mut solution = self.described(best.weights, problem, None);
                let note = best.note.iter();
                note.for_each(|note| solution.why = format!("{}; {note}", solution.why));
                solution
            }
            Err(end) => self.nearest(problem, end),
        }
    }

    /// The best for what is favoured; where a floor cannot be kept the nearest to it.
    fn favoured(
        &self,
        all: &Polytope,
        free: &[usize],
        problem: &Problem<'_>,
        scales: Option<&Scales>,
    ) -> Result<Best, End> {
        let spread =
            |within: &Polytope, unknowns: &[f64]| self.spread(free, &within.weights(unknowns));
        let within = match self.possible(free, problem) {
            Ok(within) => within,
            Err(End::Impossible) if problem.floors.ler.is_some() => {
                return Ok(spread(all, &all.most_lumens()?).into());
            }
            Err(End::Impossible) => return Ok(spread(all, &all.most_melanopic()?).into()),
            Err(end) => return Err(end),
        };
        if problem.objective == Objective::Fewest
            && let Some(found) = self.fewest(problem, free, scales)
        {
            return Ok(found);
        }
        let by_samples = matches!(problem.objective, Objective::Ra | Objective::Rf)
            || problem.floors.of_samples();
        if by_samples
            && let Some(scales) = scales
            && let Some(found) = self.by_samples(&within, free, problem, scales)
        {
            return Ok(spread(&within, &found.unknowns).into());
        }
        let unknowns = match problem.objective {
            Objective::Melanopic => within.most_melanopic(),
            _ => within.most_lumens(),
        };
        Ok(spread(&within, &unknowns?).into())
    }

    pub(super) fn free(&self) -> Vec<usize> {
        let channels = self.channels.iter().enumerate();
        let free = channels.filter(|(_, c)| c.spec.fixed.is_none());
        free.map(|(i, _)| i).collect()
    }

    /// The weights that are fixed, and another one for all that are free.
    fn fixed_or(&self, free: f64) -> Vec<f64> {
        let channels = self.channels.iter();
        channels.map(|c| c.spec.fixed.unwrap_or(free)).collect()
    }

    pub(super) fn fixed_sums(&self) -> Sums {
        let mut sums = Sums::default();
        for (channel, part) in self.channels.iter().zip(&self.sums) {
            if let Some(weight) = channel.spec.fixed {
                sums.add(part, weight);
            }
        }
        sums
    }

    pub(super) fn summed(&self, weights: &[f64]) -> Sums {
        let mut sums = Sums::default();
        for (part, weight) in self.sums.iter().zip(weights) {
            sums.add(part, *weight);
        }
        sums
    }

    /// Weights of all channels from those of the free ones at Y = 1: at Y = 100, or as they are
    /// where something is fixed.
    pub(super) fn spread(&self, free: &[usize], weights: &[f64]) -> Vec<f64> {
        let is_fixed = self
            .channels
            .iter()
            .any(|c| c.spec.fixed.is_some_and(|w| w > 0.0));
        let scale = if is_fixed { 1.0 } else { 100.0 };
        let mut all = self.fixed_or(0.0);
        free.iter()
            .zip(weights)
            .for_each(|(i, w)| all[*i] = scale * w.max(0.0));
        all
    }

    /// The mixture nearest to a light in the least squares, of exactly the target's colour.
    fn alike(&self, problem: &Problem<'_>, alike: &[f64]) -> Solution {
        let free = self.free();
        let found = match self.matched(&free, problem, alike) {
            Ok(found) => found,
            Err(end) => return self.nearest(problem, end),
        };
        let mut weights = self.fixed_or(0.0);
        free.iter().zip(&found).for_each(|(i, w)| weights[*i] = *w);
        let nearest = self.described(weights, problem, None);
        if nearest.reached || problem.floors == Floors::default() {
            return nearest;
        }
        self.up_to_floors(problem, nearest)
    }

    /// The mixture on the way from the nearest to a light to the best within the floors that meets
    /// them first: both have the colour, so all between them have.
    fn up_to_floors(&self, problem: &Problem<'_>, nearest: Solution) -> Solution {
        let best = self.solve(&Problem {
            alike: None,
            ..*problem
        });
        if !best.reached {
            return best;
        }
        let between = |part: f64| -> Vec<f64> {
            let both = nearest.weights.iter().zip(&best.weights);
            both.map(|(a, b)| a + part * (b - a)).collect()
        };
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..12 {
            let middle = 0.5 * (low + high);
            if self.described(between(middle), problem, None).reached {
                high = middle;
            } else {
                low = middle;
            }
        }
        let why = tr!(
            "colour and floors are met; the nearest spectrum alone is not enough: {why}",
            why = nearest.why
        );
        self.described(between(high), problem, Some(why))
    }

    /// Weights of free channels nearest to a light (471 values) at the target's Y = 100.
    ///
    /// # Errors
    /// [`End::Impossible`] where the colour cannot be met or the light has none, [`End::Stuck`]
    /// where the search ended without an answer.
    fn matched(
        &self,
        free: &[usize],
        problem: &Problem<'_>,
        alike: &[f64],
    ) -> Result<Vec<f64>, End> {
        let target = problem.target.ok_or(End::Impossible)?.xyz();
        let y = basic_sums(alike)[1];
        if alike.len() != POINTS || y.is_nan() || y <= 0.0 {
            return Err(End::Impossible);
        }
        let mut goal: Vec<f64> = alike.iter().map(|v| v * 100.0 / y).collect();
        for channel in self.channels {
            if let Some(weight) = channel.spec.fixed {
                let both = goal.iter_mut().zip(&channel.values);
                both.for_each(|(g, v)| *g -= weight * v);
            }
        }
        let values = |i: &usize| &self.channels[*i].values[..];
        let columns: Vec<&[f64]> = free.iter().map(values).collect();
        let colours = self.colours();
        let rows: Vec<[f64; 3]> = free.iter().map(|i| colours[*i]).collect();
        let met = (target - self.fixed_sums().xyz()).to_array();
        least_squares(&columns, &goal, &rows, met)
    }

    /// The mixture nearest to a target that cannot be met, for the reason given.
    fn nearest(&self, problem: &Problem<'_>, end: End) -> Solution {
        let free = self.free();
        let uv = problem.target.map(|t| t.uv()).unwrap_or_default();
        let (fixed, colours) = (self.fixed_sums(), self.colours());
        let mut rows: Vec<[f64; 3]> = free.iter().map(|i| colours[*i]).collect();
        // What is fixed is a channel of its own, without which nothing may be.
        let is_fixed = fixed.basic[4] > 0.0;
        if is_fixed {
            rows.push(fixed.xyz().to_array());
        }
        let found = nearest_mix(&rows, uv, 100.0);
        let Some(found) = found else {
            let why = said!("no channel has a colour").to_owned();
            return self.described(vec![0.0; self.channels.len()], problem, Some(why));
        };
        let mut weights = self.fixed_or(0.0);
        if is_fixed && found.weights[free.len()] <= 0.0 {
            let why = said!("the fixed channels keep it from the target").to_owned();
            return self.described(weights, problem, Some(why));
        }
        let scale = if is_fixed {
            1.0 / found.weights[free.len()]
        } else {
            1.0
        };
        free.iter()
            .zip(&found.weights)
            .for_each(|(i, w)| weights[*i] = scale * w);
        // Were every channel free, a target among their colours would be met to rounding.
        let is_inside = nearest_mix(&colours, uv, 100.0).is_some_and(|all| all.distance < 1e-9);
        let outside = match is_inside {
            true => said!("the fixed channels keep it from the target"),
            false => said!("the target lies outside the colours of these channels"),
        };
        let why = match end {
            End::Impossible => tr!(
                "{outside}: {distance} in u'v' from the nearest",
                outside,
                distance = languages::fixed(found.distance, 4)
            ),
            // Nothing is known of what these channels can do.
            _ => tr!("not solved: {end}", end),
        };
        let mut solution = self.described(weights, problem, Some(why));
        solution.reached = false;
        solution
    }

    /// A solution with its figures; without a reason of its own it tells what is met.
    pub(super) fn described(
        &self,
        weights: Vec<f64>,
        problem: &Problem<'_>,
        why: Option<String>,
    ) -> Solution {
        let figures = self.figures(&weights);
        let found = figures.xyz.and_then(uv_1976_from_xyz);
        let distance = problem.target.zip(found).map(|(target, [u, v])| {
            let [tu, tv] = target.uv();
            (u - tu).hypot(v - tv)
        });
        let mut missing = Vec::new();
        let mut check = |word: &str, floor: Option<f64>, found: Option<f64>| {
            if let Some(floor) = floor {
                match found {
                    Some(found) if found >= floor - 1e-6 * floor.abs() => {}
                    Some(found) => missing.push(tr!(
                        "{figure} {found} instead of {floor}",
                        figure = word,
                        found = languages::fixed(found, 2),
                        floor = with_sign(digits(floor))
                    )),
                    None => missing.push(tr!("no {figure} for this colour", figure = word)),
                }
            }
        };
        check("Rf", problem.floors.rf, figures.rf);
        check("Ra", problem.floors.ra, figures.ra);
        check("LER", problem.floors.ler, Some(figures.ler));
        check(
            said!("melanopic DER"),
            problem.floors.melanopic,
            Some(figures.melanopic_der),
        );
        let met = problem.target.is_none() || distance.is_some_and(|d| d < 1e-6);
        let has_floors = problem.floors != Floors::default();
        let plain = || match (problem.target.is_some(), has_floors) {
            _ if !missing.is_empty() => {
                tr!("the best found has {figures}", figures = missing.join(", "))
            }
            (true, true) => said!("colour and floors are met").to_owned(),
            (true, false) => said!("the colour is met").to_owned(),
            (false, true) => said!("the floors are met").to_owned(),
            (false, false) => {
                said!("the channels as they stand: no colour was asked for").to_owned()
            }
        };
        let why = why.unwrap_or_else(plain);
        Solution {
            weights,
            delta_uv_to_target: distance,
            reached: met && missing.is_empty(),
            why,
            figures,
        }
    }
}
