//! The mixtures that are best by figures of samples, and the fewest channels that do.

use super::{
    interior::{Interior, Limit, Reached},
    part::Part,
    polytope::Polytope,
    problem::{Care, Floors, Objective, Problem},
    solution::{Best, Mixer},
};
use crate::design::{
    programme::End,
    scales::{Against, BASIC, LUMENS_PER_WATT, MELANOPIC_OF_D65, Scales, Sums},
};

/// Sets of channels that are looked through for the fewest.
const MOST_SETS: usize = 4000;

/// Mixtures that a careful search starts from. On 64 random and made sets of eight channels every
/// start ended at the same best.
const STARTS: usize = 5;

/// Floors are kept to this share of themselves: half of what is told as met.
const ROUNDING: f64 = 5e-7;

/// A floor as what is looked for: lower by rounding.
fn eased(floor: f64) -> f64 {
    floor - ROUNDING * floor.abs()
}

/// A floor, the figure it is of, and the limit that its number sets.
type Floor<'a> = (Option<f64>, Objective, &'a dyn Fn(f64) -> f64);

/// The floors as limits of sums and of mean differences.
fn limits(within: &Polytope, floors: Floors) -> Vec<Limit> {
    // Y = 1.
    let most_power = |floor: f64| LUMENS_PER_WATT / floor;
    let all: [Floor; 4] = [
        (floors.ler.filter(|f| *f > 0.0), Objective::Ler, &most_power),
        (floors.melanopic, Objective::Melanopic, &|floor| -floor),
        (floors.ra, Objective::Ra, &|floor| Against::Ra.mean(floor)),
        (floors.rf, Objective::Rf, &|floor| Against::Rf.mean(floor)),
    ];
    let one = |(floor, objective, most): Floor| {
        let (part, most) = (part_of(within, objective), most(eased(floor?)));
        most.is_finite().then_some(Limit { part, most })
    };
    all.into_iter().filter_map(one).collect()
}

/// The number that a objective makes small.
fn part_of(within: &Polytope, objective: Objective) -> Part {
    let sum =
        |of: &dyn Fn(&[f64; BASIC]) -> f64| Part::Sum(within.columns.iter().map(of).collect());
    match objective {
        Objective::Ler | Objective::Fewest => sum(&|sums| sums[4]),
        Objective::Melanopic => sum(&|sums| -sums[3] / *MELANOPIC_OF_D65),
        Objective::Ra => Part::Mean(Against::Ra),
        Objective::Rf => Part::Mean(Against::Rf),
    }
}

impl Mixer<'_> {
    /// The mixtures of free channels of the colour asked for and its linear floors.
    pub(super) fn possible(&self, free: &[usize], problem: &Problem<'_>) -> Result<Polytope, End> {
        let target = problem.target.ok_or(End::Impossible)?.xyz() * 0.01;
        let sums: Vec<[f64; BASIC]> = free.iter().map(|i| self.sums[*i].basic).collect();
        let Floors { ler, melanopic, .. } = problem.floors;
        let [ler, melanopic] = [ler, melanopic].map(|floor| floor.map(eased));
        let fixed = self.fixed_sums().basic;
        Polytope::new(&sums, fixed, target.to_array(), ler, melanopic)
    }

    /// The best by a figure of samples, or by another within floors of such figures.
    pub(super) fn by_samples(
        &self,
        within: &Polytope,
        free: &[usize],
        problem: &Problem<'_>,
        scales: &Scales,
    ) -> Option<Reached> {
        let mut fixed = Sums::default();
        let whole = self.fixed_sums();
        fixed.add(&whole, 1.0 / whole.basic[4]);
        let mut sums: Vec<&Sums> = free.iter().map(|i| &self.sums[*i]).collect();
        sums.extend(within.least_fixed.is_some().then_some(&fixed));
        let starts = match problem.care {
            Care::Quick => 1,
            Care::Full => STARTS,
        };
        let limits = limits(within, problem.floors);
        let goal = part_of(within, problem.objective);
        Interior::new(within, sums, scales, starts).best(&goal, &limits)
    }

    /// The best of a set of channels for what is favoured; `None` where none keeps the floors.
    fn of_set(
        &self,
        set: &[usize],
        problem: &Problem<'_>,
        scales: Option<&Scales>,
    ) -> Option<Vec<f64>> {
        let within = self.possible(set, problem).ok()?;
        let unknowns = match scales {
            Some(scales) if problem.floors.of_samples() => {
                let found = self.by_samples(&within, set, problem, scales)?;
                (found.missing <= 0.0).then_some(found.unknowns)?
            }
            _ => within.most_lumens().ok()?,
        };
        Some(self.spread(set, &within.weights(&unknowns)))
    }

    /// The fewest channels that meet the problem, by efficacy among those.
    pub(super) fn fewest(
        &self,
        problem: &Problem<'_>,
        free: &[usize],
        scales: Option<&Scales>,
    ) -> Option<Best> {
        // More channels are never worse: what all cannot do is not looked for among fewer.
        let all = self.of_set(free, problem, scales)?;
        let mut looked = 0;
        for count in 0..=free.len() {
            let mut best: Option<(f64, Vec<f64>)> = None;
            let mut set: Vec<usize> = (0..count).collect();
            loop {
                looked += 1;
                if looked > MOST_SETS {
                    let found = best.map_or(all, |(_, weights)| weights);
                    return Some(self.fewer(found, free, problem, scales));
                }
                let chosen: Vec<usize> = set.iter().map(|i| free[*i]).collect();
                if let Some(weights) = self.of_set(&chosen, problem, scales) {
                    let efficacy = self.summed(&weights).efficacy();
                    if best.as_ref().is_none_or(|(most, _)| efficacy > *most) {
                        best = Some((efficacy, weights));
                    }
                }
                if !next_set(&mut set, free.len()) {
                    break;
                }
            }
            if let Some((_, weights)) = best {
                return Some(weights.into());
            }
        }
        Some(all.into())
    }

    /// Channels left out one after the other, the weakest first, while the rest still does: for
    /// more sets than can be looked through.
    fn fewer(
        &self,
        mut weights: Vec<f64>,
        free: &[usize],
        problem: &Problem<'_>,
        scales: Option<&Scales>,
    ) -> Best {
        let lit = |weights: &[f64]| -> Vec<usize> {
            let mut lit: Vec<usize> = free.iter().copied().filter(|i| weights[*i] > 0.0).collect();
            lit.sort_by(|a, b| weights[*a].total_cmp(&weights[*b]));
            lit
        };
        loop {
            let now = lit(&weights);
            let without = |out: &usize| {
                let mut rest: Vec<usize> = now.iter().copied().filter(|i| i != out).collect();
                rest.sort_unstable();
                self.of_set(&rest, problem, scales)
            };
            match now.iter().find_map(without) {
                Some(found) => weights = found,
                None => break,
            }
        }
        let note = Some(tr!(
            "{sets} sets of channels were looked through; fewer than these may do",
            sets = MOST_SETS
        ));
        Best { weights, note }
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
