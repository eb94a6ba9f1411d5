//! Weights of channels for a wish.

use super::{
    climb::{Place, Worth, climbed, worth},
    figures::MixFigures,
    polytope::Polytope,
    wish::{Favour, Floors, Wish},
};
use crate::{
    color::{uv_1976_from_xyz, xyz::POINTS},
    design::{
        gamut::{nearest_mix, reach},
        least_squares::{Squares, least_squares},
        mixture::{Channel, MOST_CHANNELS, MixError},
        scales::{BASIC, SampleTables, Scales, Sums, basic_sums},
    },
    spectrum::band::dot,
};

/// Mixtures looked at for a figure of samples: some 4 ms of Rf.
const MOST_LOOKS: usize = 240;

/// How often what is left between the best found and what no floor would forbid is halved.
const HALVINGS: usize = 8;

/// Less than this share is not worth a further look.
const NEAR_ENOUGH: f64 = 1e-3;

/// Sets of channels that are looked through for the fewest.
const MOST_SETS: usize = 4000;

/// What was missing to a floor and is rounding.
const ROUNDING: f64 = 1e-9;

/// Channels weighed for a wish.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// Power of each channel; Y = 100 for the whole where nothing is fixed.
    pub weights: Vec<f64>,
    /// The figures of the mixture.
    pub figures: MixFigures,
    /// Distance to the target in CIE 1976 u'v'; `None` without a target or a colour.
    pub delta_uv_to_target: Option<f64>,
    /// Whether the colour and all floors are met.
    pub reached: bool,
    /// What was reached, or what stands in the way, in words.
    pub why: String,
}

/// Channels with the sums that their figures need: made once, solved at every move of a fader.
#[derive(Clone, Debug)]
pub struct Mixer<'a> {
    channels: &'a [Channel],
    tables: &'a SampleTables,
    sums: Vec<Sums>,
}

impl<'a> Mixer<'a> {
    /// Prepares channels.
    ///
    /// # Errors
    /// [`MixError::Channels`] for none or more than [`MOST_CHANNELS`].
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
    pub fn reachable_uv(&self) -> Vec<[f64; 2]> {
        let xyz = |sums: &Sums| [sums.basic[0], sums.basic[1], sums.basic[2]];
        reach(&self.sums.iter().map(xyz).collect::<Vec<_>>())
    }

    /// Weights for a wish.
    pub fn solve(&self, wish: &Wish<'_>) -> Solution {
        let Some(target) = wish.target else {
            let weights: Vec<f64> = self
                .channels
                .iter()
                .map(|c| c.spec.fixed.unwrap_or(1.0))
                .collect();
            return self.told(weights, wish, String::new());
        };
        let free = self.free();
        let unit = target.xyz() * 0.01;
        let possible = |floors: [Option<f64>; 2]| {
            let sums: Vec<[f64; BASIC]> = free.iter().map(|i| self.sums[*i].basic).collect();
            let fixed = self.fixed_sums().basic;
            Polytope::new(&sums, fixed, unit.to_array(), floors[0], floors[1])
        };
        let Some(all) = possible([None, None]) else {
            return self.nearest(wish);
        };
        if let Some(alike) = wish.alike {
            return self.alike(wish, alike);
        }
        let floors = [wish.floors.ler, wish.floors.melanopic];
        let Some(within) = possible(floors) else {
            // The nearest to the floor that cannot be met.
            let weights = if wish.floors.ler.is_some() {
                all.most_lumens()
            } else {
                all.most_melanopic()
            };
            return self.told(self.spread(&free, &weights), wish, String::new());
        };
        let scales = Scales::new(target.xyz(), self.tables);
        let by_samples = matches!(wish.favour, Favour::Ra | Favour::Rf) || wish.floors.of_samples();
        let found = match (wish.favour, &scales) {
            (Favour::Fewest, _) => self.fewest(wish, &free, scales.as_ref()),
            (Favour::Ler | Favour::Melanopic, Some(scales)) if by_samples => {
                self.traded(&within, &free, wish, scales, &possible)
            }
            (_, Some(scales)) if by_samples => {
                let found = self.climbed(&within, &free, wish, scales, MOST_LOOKS, &|_| false);
                found.map(|(weights, _)| weights)
            }
            (Favour::Melanopic, _) => Some(self.spread(&free, &within.most_melanopic())),
            _ => Some(self.spread(&free, &within.most_lumens())),
        };
        let found = found.unwrap_or_else(|| self.spread(&free, &within.most_lumens()));
        self.told(found, wish, String::new())
    }

    fn free(&self) -> Vec<usize> {
        let channels = self.channels.iter().enumerate();
        let free = channels.filter(|(_, c)| c.spec.fixed.is_none());
        free.map(|(i, _)| i).collect()
    }

    fn fixed_sums(&self) -> Sums {
        let mut sums = Sums::default();
        for (channel, part) in self.channels.iter().zip(&self.sums) {
            if let Some(weight) = channel.spec.fixed {
                sums.add(part, weight, true);
            }
        }
        sums
    }

    fn summed(&self, weights: &[f64]) -> Sums {
        let mut sums = Sums::default();
        for (part, weight) in self.sums.iter().zip(weights) {
            sums.add(part, *weight, true);
        }
        sums
    }

    /// Weights of all channels from those of the free ones at Y = 1: at Y = 100, or as they are
    /// where something is fixed.
    fn spread(&self, free: &[usize], weights: &[f64]) -> Vec<f64> {
        let is_fixed = self
            .channels
            .iter()
            .any(|c| c.spec.fixed.is_some_and(|w| w > 0.0));
        let scale = if is_fixed { 1.0 } else { 100.0 };
        let mut all: Vec<f64> = self
            .channels
            .iter()
            .map(|c| c.spec.fixed.unwrap_or(0.0))
            .collect();
        free.iter()
            .zip(weights)
            .for_each(|(i, w)| all[*i] = scale * w.max(0.0));
        all
    }

    /// The best by a figure of samples.
    fn climbed(
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
    fn traded(
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
    fn fewest(&self, wish: &Wish<'_>, free: &[usize], scales: Option<&Scales>) -> Option<Vec<f64>> {
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

    /// The mixture nearest to a light in the least squares, of exactly the target's colour.
    fn alike(&self, wish: &Wish<'_>, alike: &[f64]) -> Solution {
        let free = self.free();
        let Some(found) = self.matched(&free, wish, alike) else {
            return self.nearest(wish);
        };
        let mut weights: Vec<f64> = self
            .channels
            .iter()
            .map(|c| c.spec.fixed.unwrap_or(0.0))
            .collect();
        free.iter().zip(&found).for_each(|(i, w)| weights[*i] = *w);
        let nearest = self.told(weights, wish, String::new());
        if nearest.reached || wish.floors == Floors::default() {
            return nearest;
        }
        self.up_to_floors(wish, nearest)
    }

    /// The mixture on the way from the nearest to a light to the best within the floors that meets
    /// them first: both have the colour, so all between them have.
    fn up_to_floors(&self, wish: &Wish<'_>, nearest: Solution) -> Solution {
        let best = self.solve(&Wish {
            alike: None,
            ..*wish
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
            if self.told(between(middle), wish, String::new()).reached {
                high = middle;
            } else {
                low = middle;
            }
        }
        let why = format!(
            "colour and floors are met; the nearest spectrum alone is not enough: {}",
            nearest.why
        );
        self.told(between(high), wish, why)
    }

    /// Weights of free channels nearest to a light (471 values) at the target's Y = 100; `None`
    /// where the colour cannot be met or the light has none.
    fn matched(&self, free: &[usize], wish: &Wish<'_>, alike: &[f64]) -> Option<Vec<f64>> {
        let fixed = self.fixed_sums().basic;
        let target = wish.target?.xyz();
        let y = basic_sums(alike)[1];
        if alike.len() != POINTS || y.is_nan() || y <= 0.0 {
            return None;
        }
        let mut goal: Vec<f64> = alike.iter().map(|v| v * 100.0 / y).collect();
        for channel in self.channels {
            if let Some(weight) = channel.spec.fixed {
                let both = goal.iter_mut().zip(&channel.values);
                both.for_each(|(g, v)| *g -= weight * v);
            }
        }
        let values = |i: &usize| &self.channels[*i].values[..];
        let squares = Squares {
            products: free
                .iter()
                .flat_map(|i| free.iter().map(move |j| dot(values(i), values(j))))
                .collect(),
            right: free.iter().map(|i| dot(values(i), &goal)).collect(),
        };
        let row = |i: &usize| {
            let sums = self.sums[*i].basic;
            [sums[0], sums[1], sums[2]]
        };
        let rows: Vec<[f64; 3]> = free.iter().map(row).collect();
        let met = [
            target.x - fixed[0],
            target.y - fixed[1],
            target.z - fixed[2],
        ];
        least_squares(&squares, &rows, met)
    }

    /// The mixture nearest to a target that cannot be met.
    fn nearest(&self, wish: &Wish<'_>) -> Solution {
        let free = self.free();
        let uv = wish.target.map(|t| t.uv()).unwrap_or_default();
        let fixed = self.fixed_sums().basic;
        let row = |sums: &[f64; BASIC]| [sums[0], sums[1], sums[2]];
        let mut rows: Vec<[f64; 3]> = free.iter().map(|i| row(&self.sums[*i].basic)).collect();
        // What is fixed is a channel of its own, without which nothing may be.
        let is_fixed = fixed[4] > 0.0;
        if is_fixed {
            rows.push(row(&fixed));
        }
        let found = nearest_mix(&rows, uv, 100.0);
        let Some(found) = found else {
            let why = "no channel has a colour".to_owned();
            return self.told(vec![0.0; self.channels.len()], wish, why);
        };
        let mut weights: Vec<f64> = self
            .channels
            .iter()
            .map(|c| c.spec.fixed.unwrap_or(0.0))
            .collect();
        if is_fixed && found.weights[free.len()] <= 0.0 {
            let why = "the fixed channels keep it from the target".to_owned();
            return self.told(weights, wish, why);
        }
        let scale = if is_fixed {
            1.0 / found.weights[free.len()]
        } else {
            1.0
        };
        free.iter()
            .zip(&found.weights)
            .for_each(|(i, w)| weights[*i] = scale * w);
        let all: Vec<[f64; 3]> = self.sums.iter().map(|s| row(&s.basic)).collect();
        // Were every channel free, a target among their colours would be met to rounding.
        let is_inside = nearest_mix(&all, uv, 100.0).is_some_and(|all| all.distance < 1e-9);
        let outside = match is_inside {
            true => "the fixed channels keep it from the target",
            false => "the target lies outside the colours of these channels",
        };
        let why = format!("{outside}: {:.4} in u'v' from the nearest", found.distance);
        self.told(weights, wish, why)
    }

    fn told(&self, weights: Vec<f64>, wish: &Wish<'_>, mut why: String) -> Solution {
        let figures = self.figures(&weights);
        let found = figures.xyz.and_then(uv_1976_from_xyz);
        let distance = wish.target.zip(found).map(|(target, [u, v])| {
            let [tu, tv] = target.uv();
            (u - tu).hypot(v - tv)
        });
        let mut missing = Vec::new();
        let mut check = |word: &str, floor: Option<f64>, found: Option<f64>| {
            if let Some(floor) = floor {
                match found {
                    Some(found) if found >= floor - 1e-6 * floor.abs() => {}
                    Some(found) => missing.push(format!("{word} {found:.2} instead of {floor}")),
                    None => missing.push(format!("no {word} for this colour")),
                }
            }
        };
        check("Rf", wish.floors.rf, figures.rf);
        check("Ra", wish.floors.ra, figures.ra);
        check("LER", wish.floors.ler, Some(figures.ler));
        check(
            "melanopic DER",
            wish.floors.melanopic,
            Some(figures.melanopic_der),
        );
        let met = wish.target.is_none() || distance.is_some_and(|d| d < 1e-6);
        if why.is_empty() {
            why = if missing.is_empty() {
                "colour and floors are met".to_owned()
            } else {
                format!("the best found has {}", missing.join(", "))
            };
        }
        Solution {
            weights,
            delta_uv_to_target: distance,
            reached: met && missing.is_empty(),
            why,
            figures,
        }
    }
}

/// The next set of that size in the order of words; false behind the last.
fn next_set(set: &mut [usize], of: usize) -> bool {
    let count = set.len();
    let Some(at) = (0..count).rev().find(|i| set[*i] < of - count + i) else {
        return false;
    };
    set[at] += 1;
    (at + 1..count).for_each(|i| set[i] = set[i - 1] + 1);
    true
}
