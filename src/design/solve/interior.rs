//! The best mixture of a colour by figures of samples, by an interior method.
//!
//! ```text
//! least goal(x)    with  sum x_j XYZ_j = colour,  x_j > 0,  limit_k - part_k(x) > 0
//! ```
//!
//! Goals and parts are sums (power, melanopic light) or means of the sizes of samples' differences
//! from the reference. Differences are nearly straight in the weights, so such a mean is nearly
//! hollow upwards: its bend is taken from the slopes of the differences alone (Gauss-Newton), which
//! makes every step one downwards. At a size of zero a mean has a kink, where the best often lies;
//! sizes are rounded off there, less with every turn. Source of the method: Nocedal and Wright,
//! "Numerical Optimization" (2006), chapter 19. Crates: `argmin` and `levenberg-marquardt` know no
//! bounds, `clarabel` wants a convex problem.

use nalgebra::{DMatrix, DVector};

use super::{
    duals::{Duals, short_of_zero},
    part::{Local, Part, Parts},
    polytope::Polytope,
};
use crate::{
    design::scales::{Scales, Sums},
    spectrum::WORST_CONDITION,
};

/// Says of a place whether the way may end there.
type Enough<'a> = &'a dyn Fn(&DVector<f64>) -> bool;

/// The first weight of the barrier; a mean difference is some units.
const FIRST_BARRIER: f64 = 0.1;

/// The last: what is left to the best is that much for each unknown and limit.
const LAST_BARRIER: f64 = 1e-7;

/// Share of the barrier that a turn leaves.
const TURN: f64 = 0.1;

/// Newton's steps of a turn; two as a rule.
const MOST_STEPS: usize = 12;

/// Sizes of differences are rounded off by this where they are limits of another goal: .005 of Ra.
const ROUNDED: f64 = 1e-3;

/// A turn ends where a step would lower less than this share of the barrier.
const TURN_ENDS: f64 = 1e-3;

/// Share of the promised fall that a step must bring (Armijo's condition).
const LEAST_FALL: f64 = 1e-4;

/// A step shorter than this share of Newton's leads nowhere.
const SHORTEST_STEP: f64 = 1e-8;

/// Share of the middle in a start that lies towards a corner: a fifth of the way from the edge.
const OF_THE_MIDDLE: f64 = 0.2;

/// Excess of the extra unknown over the limits at the start, so that they can be more than met.
const EASED_ABOVE: f64 = 2.0;

/// A mixture without what it has nearly nothing of still has its colour to this, white = 1.
const SAME_COLOUR: f64 = 1e-12;

/// Room to its limits from which on a start is one, as a mean difference.
const ROOM: f64 = 1e-2;

/// Unknowns below this share of their greatest are tried as zeros.
const NEARLY_NONE: f64 = 1e-3;

/// Loss of a goal that zeros are worth: a thousandth of Ra.
const ZEROS_WORTH: f64 = 2e-4;

/// A part and what it is not to go beyond.
#[derive(Clone, Debug)]
pub(super) struct Limit {
    pub(super) part: Part,
    pub(super) most: f64,
}

/// A mixture that was found.
#[derive(Clone, Debug)]
pub(super) struct Reached {
    /// Unknowns of the polytope.
    pub(super) unknowns: Vec<f64>,
    /// Sum of what its parts are beyond their limits.
    pub(super) missing: f64,
    pub(super) goal: f64,
}

impl Reached {
    pub(super) fn beats(&self, other: &Self) -> bool {
        self.missing < other.missing || (self.missing == other.missing && self.goal < other.goal)
    }
}

/// The mixtures of a colour with the sums that their figures need.
pub(super) struct Interior<'a> {
    parts: Parts<'a>,
    /// Colour equations of the scaled unknowns, none of which follows from the others.
    equations: DMatrix<f64>,
    /// Mixtures to begin with, scaled: in the middle, then towards corners.
    starts: Vec<DVector<f64>>,
}

/// A question to the way down.
struct Ask<'a> {
    goal: &'a Part,
    limits: &'a [Limit],
    /// True if the last unknown, less one, eases the limits.
    is_eased: bool,
}

/// Slope and bend of a goal with its barrier, and of each limit the room and how it rises.
struct Bent {
    slope: DVector<f64>,
    bend: DMatrix<f64>,
    rooms: Vec<(f64, DVector<f64>)>,
}

impl<'a> Interior<'a> {
    /// The mixtures of a polytope; `sums` of each of its columns. `starts` are looked for.
    pub(super) fn new(
        within: &'a Polytope,
        sums: Vec<&'a Sums>,
        scales: &'a Scales,
        starts: usize,
    ) -> Self {
        let corners = within.corners();
        let greatest = |column: usize| corners.iter().map(|c| c[column]).fold(0.0, f64::max);
        let kept: Vec<(usize, f64)> = (0..within.columns.len())
            .map(|column| (column, greatest(column)))
            .filter(|(_, most)| most.is_normal())
            .collect();
        let scaled = |corner: &Vec<f64>| {
            DVector::from_iterator(kept.len(), kept.iter().map(|(i, most)| corner[*i] / most))
        };
        let corners: Vec<DVector<f64>> = corners.iter().map(scaled).collect();
        let mut middle = DVector::zeros(kept.len());
        corners
            .iter()
            .for_each(|corner| middle += corner / corners.len() as f64);
        let towards = corners
            .iter()
            .map(|corner| (1.0 - OF_THE_MIDDLE) * corner + OF_THE_MIDDLE * &middle);
        let rows = DMatrix::from_fn(3, kept.len(), |row, column| {
            let (index, most) = kept[column];
            within.columns[index][row] * most
        });
        Self {
            equations: independent(rows),
            starts: std::iter::once(middle.clone())
                .chain(towards)
                .take(if corners.len() > 1 { starts } else { 1 })
                .collect(),
            parts: Parts {
                scales,
                within,
                kept,
                sums,
            },
        }
    }

    /// The best mixture within limits that any start leads to; where none leads inside them, the
    /// one that is least beyond.
    pub(super) fn best(&self, goal: &Part, limits: &[Limit]) -> Option<Reached> {
        let mut best: Option<Reached> = None;
        for start in &self.starts {
            let found = self.from(start, goal, limits);
            if let Some(found) = found
                && best.as_ref().is_none_or(|best| found.beats(best))
            {
                best = Some(found);
            }
        }
        best
    }

    /// The best mixture that a start leads to.
    fn from(&self, start: &DVector<f64>, goal: &Part, limits: &[Limit]) -> Option<Reached> {
        let inside = match limits {
            [] => start.clone(),
            _ => self.inside(start, limits)?,
        };
        let room = limits
            .iter()
            .map(|limit| {
                Some(limit.most - self.parts.at(&limit.part, &inside, ROUNDED, false)?.value)
            })
            .collect::<Option<Vec<f64>>>()?;
        let found = match room.iter().all(|room| *room > 0.0) {
            true => self.descended(&inside, goal, limits, None)?,
            false => inside,
        };
        let plain = self.reached(&found, goal, limits)?;
        let bare = self.with_zeros(&found);
        let bare = bare.and_then(|bare| self.reached(&bare, goal, limits));
        let is_as_good = |bare: &Reached| {
            bare.missing <= plain.missing
                && bare.goal <= plain.goal + ZEROS_WORTH * plain.goal.abs().min(1.0)
        };
        Some(bare.filter(is_as_good).unwrap_or(plain))
    }

    /// A mixture inside the limits, or the one that is least beyond them: one more unknown, by
    /// which all limits are eased, is made as small as it can be.
    fn inside(&self, start: &DVector<f64>, limits: &[Limit]) -> Option<DVector<f64>> {
        let beyond = |place: &DVector<f64>, rounded: f64| {
            let one = |limit: &Limit| {
                Some(self.parts.at(&limit.part, place, rounded, false)?.value - limit.most)
            };
            let all = limits.iter().map(one).collect::<Option<Vec<f64>>>()?;
            Some(all.into_iter().fold(f64::NEG_INFINITY, f64::max))
        };
        let most = beyond(start, FIRST_BARRIER.sqrt())?;
        if beyond(start, ROUNDED)? < -ROOM {
            return Some(start.clone());
        }
        let eased = start.clone().push(most.max(0.0) + EASED_ABOVE);
        let mut goal = vec![0.0; self.parts.within.columns.len()];
        goal.push(1.0);
        let is_enough = |place: &DVector<f64>| {
            beyond(&place.rows(0, start.len()).into_owned(), ROUNDED).is_some_and(|b| b < -ROOM)
        };
        let found = self.descended(&eased, &Part::Sum(goal), limits, Some(&is_enough))?;
        Some(found.rows(0, start.len()).into_owned())
    }

    /// The way down from a start inside. With `enough` the limits are eased by the last unknown
    /// less one, and the way ends where it says so.
    fn descended(
        &self,
        start: &DVector<f64>,
        goal: &Part,
        limits: &[Limit],
        enough: Option<Enough<'_>>,
    ) -> Option<DVector<f64>> {
        let is_eased = enough.is_some();
        let ask = Ask {
            goal,
            limits,
            is_eased,
        };
        let mut place = start.clone();
        let mut barrier = FIRST_BARRIER;
        let mut duals = Duals {
            unknowns: place.map(|v| barrier / v),
            limits: None,
        };
        while barrier >= LAST_BARRIER {
            for _ in 0..MOST_STEPS {
                let here = self.bent(&ask, &place, barrier, &mut duals)?;
                let step = self.newton(here.bend, &here.slope)?;
                let fall = -here.slope.dot(&step);
                let before = self.merit(&ask, &place, barrier)?;
                // Downwards but for rounding, else the turn is over.
                if fall <= TURN_ENDS * barrier || !fall.is_finite() {
                    break;
                }
                let mut part = short_of_zero(&place, &step);
                let moved = loop {
                    let there = &place + part * &step;
                    let now = self.merit(&ask, &there, barrier);
                    if now.is_some_and(|now| now <= before - LEAST_FALL * part * fall) {
                        break Some(there);
                    }
                    part *= 0.5;
                    if part < SHORTEST_STEP {
                        break None;
                    }
                };
                let Some(moved) = moved else {
                    break;
                };
                duals.follow(&place, &step, barrier, &here.rooms);
                place = moved;
                duals.stay_near(&place, barrier);
                if enough.is_some_and(|enough| enough(&place)) {
                    return Some(place);
                }
            }
            barrier *= TURN;
        }
        Some(place)
    }

    /// The room to each limit with the part there; `None` where one has none.
    fn rooms(
        &self,
        ask: &Ask<'_>,
        place: &DVector<f64>,
        barrier: f64,
        slopes: bool,
    ) -> Option<Vec<(f64, Local)>> {
        let (rounded, ease) = match ask.is_eased {
            true => (barrier.sqrt(), place[place.len() - 1] - 1.0),
            false => (ROUNDED, 0.0),
        };
        let one = |limit: &Limit| {
            let local = self.parts.at(&limit.part, place, rounded, slopes)?;
            let room = limit.most + ease - local.value;
            (room > 0.0).then_some((room, local))
        };
        ask.limits.iter().map(one).collect()
    }

    /// The goal with the barrier at the edges; `None` beyond them.
    fn merit(&self, ask: &Ask<'_>, place: &DVector<f64>, barrier: f64) -> Option<f64> {
        let rooms = self.rooms(ask, place, barrier, false)?;
        let logs = place.iter().map(|v| v.ln()).sum::<f64>()
            + rooms.iter().map(|(room, _)| room.ln()).sum::<f64>();
        let goal = self.parts.at(ask.goal, place, barrier.sqrt(), false)?;
        let whole = goal.value - barrier * logs;
        whole.is_finite().then_some(whole)
    }

    /// Slope and bend of the goal with the barrier.
    fn bent(
        &self,
        ask: &Ask<'_>,
        place: &DVector<f64>,
        barrier: f64,
        duals: &mut Duals,
    ) -> Option<Bent> {
        let size = place.len();
        let here = self.parts.at(ask.goal, place, barrier.sqrt(), true)?;
        let held = self.rooms(ask, place, barrier, true)?;
        let tolls = duals
            .limits
            .get_or_insert_with(|| held.iter().map(|(room, _)| barrier / room).collect());
        let mut slope = here.slope - place.map(|v| barrier / v);
        let mut bend = here.bend.unwrap_or_else(|| DMatrix::zeros(size, size));
        (0..size).for_each(|j| bend[(j, j)] += duals.unknowns[j] / place[j]);
        let mut rooms = Vec::with_capacity(held.len());
        for ((room, local), toll) in held.into_iter().zip(tolls.iter()) {
            // Of the room: rising with the ease, falling with the part.
            let mut rise = -local.slope;
            if ask.is_eased {
                rise[size - 1] += 1.0;
            }
            slope.axpy(-barrier / room, &rise, 1.0);
            bend.ger(toll / room, &rise, &rise, 1.0);
            if let Some(curve) = &local.bend {
                bend += curve * *toll;
            }
            rooms.push((room, rise));
        }
        Some(Bent { slope, bend, rooms })
    }

    /// Newton's step along the equations.
    fn newton(&self, bend: DMatrix<f64>, slope: &DVector<f64>) -> Option<DVector<f64>> {
        let (size, rows) = (slope.len(), self.equations.nrows());
        let mut matrix = bend.resize(size + rows, size + rows, 0.0);
        let columns = self.equations.ncols();
        let view = &self.equations;
        matrix.view_mut((size, 0), (rows, columns)).copy_from(view);
        matrix
            .view_mut((0, size), (columns, rows))
            .copy_from(&view.transpose());
        let mut right = DVector::zeros(size + rows);
        right.rows_mut(0, size).copy_from(&-slope);
        let found = matrix.lu().solve(&right)?;
        let step = found.rows(0, size).into_owned();
        step.iter().all(|v| v.is_finite()).then_some(step)
    }

    /// The same mixture without what it has nearly nothing of, the rest being changed as little as
    /// the colour asks, each by its own share; `None` where that is no mixture.
    fn with_zeros(&self, place: &DVector<f64>) -> Option<DVector<f64>> {
        let mut bare = place.map(|v| if v < NEARLY_NONE { 0.0 } else { v });
        let missing = &self.equations * (place - &bare);
        let weighed = DMatrix::from_diagonal(&bare.map(|v| v * v));
        let turned = &weighed * self.equations.transpose();
        let duals = (&self.equations * &turned).lu().solve(&missing)?;
        bare += turned * duals;
        let left = (&self.equations * (place - &bare)).amax();
        let is_one = left < SAME_COLOUR && bare.iter().all(|v| *v >= 0.0 && v.is_finite());
        is_one.then_some(bare)
    }

    /// Evaluates a place exactly: its unknowns, excess over the limits and goal.
    fn reached(&self, place: &DVector<f64>, goal: &Part, limits: &[Limit]) -> Option<Reached> {
        let value = |part: &Part| Some(self.parts.at(part, place, 0.0, false)?.value);
        let beyond = |limit: &Limit| Some((value(&limit.part)? - limit.most).max(0.0));
        let mut unknowns = vec![0.0; self.parts.within.columns.len()];
        for ((index, most), share) in self.parts.kept.iter().zip(place.iter()) {
            unknowns[*index] = most * share;
        }
        Some(Reached {
            unknowns,
            missing: limits.iter().map(beyond).sum::<Option<f64>>()?,
            goal: value(goal)?,
        })
    }
}

/// Rows at right angles that span the same as those given, but for what rounding alone tells apart.
fn independent(rows: DMatrix<f64>) -> DMatrix<f64> {
    if rows.is_empty() {
        return rows;
    }
    let factors = rows.svd(false, true);
    let least = factors.singular_values.max() / WORST_CONDITION;
    let told_apart: Vec<usize> = (0..factors.singular_values.len())
        .filter(|row| factors.singular_values[*row] > least)
        .collect();
    factors.v_t.map_or_else(
        || DMatrix::zeros(0, 0),
        |rows| rows.select_rows(&told_apart),
    )
}
