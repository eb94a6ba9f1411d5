//! The smoothest reflectance within 0-1 that has given colours.
//!
//! ```text
//! r_j = (1 + tanh z_j) / 2        least  sum (z_{j+1} - z_j)^2 / 2    with  sum r_j c_j = colour
//! ```
//!
//! `tanh` keeps every value inside, so that only the equations of the colour are left, three for
//! each light. Newton's method on them and the multipliers (the Karush-Kuhn-Tucker system): its
//! matrix is a tridiagonal one with a border of three or six rows, so a step costs a few passes
//! over the nodes. Its factors tell whether it leads to a least and not to a saddle: where it does
//! not, the diagonal grows until it does, and an end counts only where nothing had to grow. A step
//! is as long as it halves what is left of the equations, or lowers the squares and what the
//! colours miss together. Near the edge of what a surface can do the path goes there from grey in
//! smaller steps; at the very edge, where the solution is a step function that `tanh` reaches only
//! at infinity, the last bit is a mixture with the one reflectance that the edge has.
//!
//! Source of the idea: S. A. Burns, "Numerical methods for smoothest reflectance reconstruction",
//! Color Research and Application 45 (2020) 8-21, "least hyperbolic tangent slope squared".

use super::{
    edge::{edge_behind, white},
    viewing::NODES,
};
use crate::design::small::{add, dot, negative_pivots, solved};

/// Newton's steps from one start; most colours take six to ten.
const MOST_STEPS: usize = 60;

/// Largest change of z in one step: beyond it `tanh` is no straight line any more.
const LONGEST_STEP: f64 = 3.0;

/// |z| beyond which 1 - r is nothing to f64.
const FARTHEST: f64 = 19.0;

/// A step this small was the last: the next one would be its square.
const LAST_STEP: f64 = 1e-6;

/// Tolerance on the colours, white = 1: four digits finer than dE00 .01 requires.
const EXACT: f64 = 1e-10;

/// A pivot this small has no sign that is known.
const SMALLEST_PIVOT: f64 = 1e-12;

/// Added to the diagonal of the differences, which by themselves do not see a constant.
const STIFFNESS: f64 = 1e-7;

/// First growth of the diagonal where Newton's step would lead to a saddle, and its factor.
const GROWTH: [f64; 2] = [1e-4, 8.0];

/// Halvings of a step.
const MOST_HALVINGS: usize = 24;

/// Steps of z as small as this, where the diagonal has to grow, lead to a saddle.
const NEAR_SADDLE: f64 = 0.05;

/// Amplitude, in z, of the push off a saddle: a wave that no node or border shares.
const PUSH: f64 = 0.05;

/// A colour this near to a grey is one: rounding of sums of 81 products, which no colour told in
/// twelve digits is nearer to.
const GREY: f64 = 1e-12;

/// Smallest piece of the way from grey.
const SHORTEST_WAY: f64 = 1.0 / 512.0;

/// Start of the mixture with the edge's reflectance, as a share of the way from grey.
const SAFE_SHARE: f64 = 0.999;

/// A colour that is beyond the edge by no more than this share is on it but for rounding.
const EDGE: f64 = 1e-9;

/// Unknowns of the equations: where a search starts and ends.
#[derive(Clone, Debug)]
pub(super) struct State<const M: usize> {
    z: [f64; NODES],
    multipliers: [f64; M],
}

impl<const M: usize> State<M> {
    /// The same reflectance everywhere.
    pub(super) fn grey(reflectance: f64) -> Self {
        let share = reflectance.clamp(1e-4, 1.0 - 1e-4);
        Self {
            z: [0.5 * (share / (1.0 - share)).ln(); NODES],
            multipliers: [0.0; M],
        }
    }

    /// The reflectance.
    pub(super) fn reflectance(&self) -> [f64; NODES] {
        self.z.map(reflectance_of)
    }
}

/// The reflectance of an unknown: (1 + tanh z) / 2.
fn reflectance_of(z: f64) -> f64 {
    1.0 / (1.0 + (-2.0 * z).exp())
}

/// The smoothest reflectance of these colours (white = 1), from a start near by or grey; `None`
/// where no reflectance has them. Values lie in 0-1.
pub(super) fn smoothest<const M: usize>(
    columns: &[[f64; M]; NODES],
    target: [f64; M],
    start: Option<&State<M>>,
) -> Option<([f64; NODES], Option<State<M>>)> {
    let greys = white(columns);
    let level = dot(&greys, &target) / dot(&greys, &greys);
    // Black, white and the greys between them are what they are.
    let is_grey = (0..M).all(|k| (target[k] - level * greys[k]).abs() < GREY);
    if is_grey {
        let inside = level.clamp(0.0, 1.0);
        return ((level - inside).abs() < EDGE).then_some(([inside; NODES], None));
    }
    if let Some(start) = start {
        let mut state = start.clone();
        if newton(columns, target, &mut state) {
            return Some((state.reflectance(), Some(state)));
        }
    }
    let mut state = State::grey(level);
    if newton(columns, target, &mut state) {
        return Some((state.reflectance(), Some(state)));
    }
    let level = level.clamp(0.02, 0.98);
    let grey = greys.map(|v| v * level);
    let (state, reached) = from_grey(columns, target, grey, level);
    if reached == 1.0 {
        return Some((state.reflectance(), Some(state)));
    }
    let mixed = mixed_with_edge(columns, target, grey, level)?;
    Some((mixed, None))
}

/// Goes from grey towards the target as far as Newton's method leads.
fn from_grey<const M: usize>(
    columns: &[[f64; M]; NODES],
    target: [f64; M],
    grey: [f64; M],
    level: f64,
) -> (State<M>, f64) {
    let on_way = |share: f64| std::array::from_fn(|k| grey[k] + share * (target[k] - grey[k]));
    let mut state = State::grey(level);
    let (mut reached, mut step) = (0.0_f64, 0.5);
    while reached < 1.0 && step >= SHORTEST_WAY {
        let next = (reached + step).min(1.0);
        let mut trial = state.clone();
        if newton(columns, on_way(next), &mut trial) {
            (state, reached) = (trial, next);
        } else {
            step *= 0.5;
        }
    }
    (state, reached)
}

/// A reflectance of exactly these colours: that of a colour a little nearer to grey mixed with
/// the one of the edge behind it. `None` where the target lies beyond the edge.
fn mixed_with_edge<const M: usize>(
    columns: &[[f64; M]; NODES],
    target: [f64; M],
    grey: [f64; M],
    level: f64,
) -> Option<[f64; NODES]> {
    let away: [f64; M] = std::array::from_fn(|k| target[k] - grey[k]);
    let (edge, at_edge) = edge_behind(columns, grey, away)?;
    if edge < 1.0 - EDGE {
        return None;
    }
    let edge = edge.max(1.0);
    let mut share = SAFE_SHARE;
    for _ in 0..8 {
        let inner = std::array::from_fn(|k| grey[k] + share * away[k]);
        let (state, reached) = from_grey(columns, inner, grey, level);
        if reached == 1.0 {
            let part = (1.0 - share) / (edge - share);
            let inside = state.reflectance();
            return Some(std::array::from_fn(|j| {
                ((1.0 - part) * inside[j] + part * at_edge[j]).clamp(0.0, 1.0)
            }));
        }
        share = 1.0 - 2.0 * (1.0 - share);
    }
    // The edge itself, taken back towards grey.
    Some(std::array::from_fn(|j| {
        (level + (at_edge[j] - level) / edge).clamp(0.0, 1.0)
    }))
}

/// Newton's method from a state; false where it does not arrive at a least.
fn newton<const M: usize>(
    columns: &[[f64; M]; NODES],
    target: [f64; M],
    state: &mut State<M>,
) -> bool {
    let mut is_pushed = false;
    let mut now = Measure::of(columns, &target, state);
    for _ in 0..MOST_STEPS {
        let Some((step, growth)) = downwards(columns, &target, state) else {
            return false;
        };
        let longest = step.change.iter().fold(0.0, |a: f64, v| a.max(v.abs()));
        if !longest.is_finite() {
            return false;
        }
        match walked(columns, &target, state, &now, &step, longest) {
            Some(found) => now = found,
            None => return false,
        }
        let is_there = longest < LAST_STEP && now.missed[1] < EXACT;
        match growth > 0.0 {
            false if is_there => return true,
            // Small steps towards a saddle: away from it, once.
            true if longest < NEAR_SADDLE && !is_pushed => {
                let wave = |(j, z): (usize, &mut f64)| *z += PUSH * (1.7 * j as f64).sin();
                state.z.iter_mut().enumerate().for_each(wave);
                is_pushed = true;
                now = Measure::of(columns, &target, state);
            }
            true if is_there => return false,
            _ => {}
        }
    }
    false
}

/// A step of z, and the multipliers behind it.
struct Step<const M: usize> {
    change: [f64; NODES],
    multipliers: [f64; M],
}

/// The step towards a least, and what the diagonal had to grow by for it.
fn downwards<const M: usize>(
    columns: &[[f64; M]; NODES],
    target: &[f64; M],
    state: &State<M>,
) -> Option<(Step<M>, f64)> {
    let mut growth = 0.0;
    while growth < 1e6 {
        if let Some(step) = step(columns, target, state, growth) {
            return Some((step, growth));
        }
        growth = (GROWTH[1] * growth).max(GROWTH[0]);
    }
    None
}

/// Objective and residuals of a state.
struct Measure {
    /// Half the sum of squared steps.
    squares: f64,
    /// Sum and greatest of what the colours miss, white = 1.
    missed: [f64; 2],
    /// The greatest of what is left of the slopes.
    slopes: f64,
}

impl Measure {
    fn of<const M: usize>(
        columns: &[[f64; M]; NODES],
        target: &[f64; M],
        state: &State<M>,
    ) -> Self {
        let z = &state.z;
        let values = state.reflectance();
        let mut slopes = 0.0_f64;
        for (j, value) in values.iter().enumerate() {
            let (left, right) = (z[j.saturating_sub(1)], z[(j + 1).min(NODES - 1)]);
            let bent = 2.0 * value * (1.0 - value) * dot(&columns[j], &state.multipliers);
            slopes = greater(slopes, 2.0 * z[j] - left - right + bent);
        }
        let rest = missed(columns, target, &values);
        Self {
            squares: 0.5 * z.windows(2).map(|w| (w[1] - w[0]).powi(2)).sum::<f64>(),
            missed: [
                rest.iter().map(|v| v.abs()).sum(),
                rest.iter().fold(0.0, |a, v| greater(a, *v)),
            ],
            slopes,
        }
    }

    fn merit(&self, price: f64) -> f64 {
        self.squares + price * self.missed[0]
    }

    fn unsolved(&self) -> f64 {
        greater(self.missed[1], self.slopes)
    }
}

/// The greater size; NaN must not pass for small.
fn greater(a: f64, b: f64) -> f64 {
    if b.abs() <= a { a } else { b.abs() }
}

/// Goes as much of a step as helps; `None` where none of it does.
fn walked<const M: usize>(
    columns: &[[f64; M]; NODES],
    target: &[f64; M],
    state: &mut State<M>,
    now: &Measure,
    step: &Step<M>,
    longest: f64,
) -> Option<Measure> {
    // More than any multiplier, so that a step which Newton's method means is downwards.
    let price = step
        .multipliers
        .iter()
        .fold(1e-3, |a: f64, v| a.max(2.0 * v.abs()));
    let mut part = (LONGEST_STEP / longest).min(1.0);
    for _ in 0..MOST_HALVINGS {
        let mut there = state.clone();
        for (z, change) in there.z.iter_mut().zip(&step.change) {
            *z = (*z + part * change).clamp(-FARTHEST, FARTHEST);
        }
        for (old, new) in there.multipliers.iter_mut().zip(&step.multipliers) {
            *old += part * (new - *old);
        }
        let found = Measure::of(columns, target, &there);
        let helps = found.merit(price) < now.merit(price)
            || found.unsolved() < 0.5 * now.unsolved()
            // At rounding nothing falls any more.
            || longest < LAST_STEP;
        if helps {
            *state = there;
            return Some(found);
        }
        part *= 0.5;
    }
    None
}

/// Residuals of the colours against the target, white = 1.
fn missed<const M: usize>(
    columns: &[[f64; M]; NODES],
    target: &[f64; M],
    reflectance: &[f64; NODES],
) -> [f64; M] {
    let mut rest = *target;
    for (column, value) in columns.iter().zip(reflectance) {
        add(&mut rest, column, -value);
    }
    rest
}

/// Newton's step with the diagonal grown; `None` where it does not lead to a least: the matrix of
/// the equations must have as many negative pivots as there are equations (its inertia).
fn step<const M: usize>(
    columns: &[[f64; M]; NODES],
    target: &[f64; M],
    state: &State<M>,
    growth: f64,
) -> Option<Step<M>> {
    let z = &state.z;
    let mut rest = *target;
    // H = differences + curvature of the equations; its factors, with the border B and the
    // right side solved along the way.
    let mut border = [[0.0; M]; NODES];
    let mut pivots = [0.0; NODES];
    let mut solved_border = [[0.0; M]; NODES];
    let mut solved_right = [0.0; NODES];
    let mut before = (0.0, [0.0; M], 0.0);
    let mut negative = 0;
    for j in 0..NODES {
        let value = reflectance_of(z[j]);
        let slope = 2.0 * value * (1.0 - value);
        add(&mut rest, &columns[j], -value);
        border[j] = columns[j].map(|c| c * slope);
        let bend = 2.0 * (1.0 - 2.0 * value) * dot(&border[j], &state.multipliers);
        let (left, right) = (z[j.saturating_sub(1)], z[(j + 1).min(NODES - 1)]);
        let neighbours = if j == 0 || j == NODES - 1 { 1.0 } else { 2.0 };
        let (over_before, border_before, right_before) = before;
        let pivot = neighbours + STIFFNESS + growth + bend - over_before;
        if pivot.abs() < SMALLEST_PIVOT {
            return None;
        }
        negative += usize::from(pivot < 0.0);
        let over = 1.0 / pivot;
        pivots[j] = over;
        for k in 0..M {
            solved_border[j][k] = (border[j][k] + border_before[k]) * over;
        }
        solved_right[j] = (left + right - 2.0 * z[j] + right_before) * over;
        before = (over, solved_border[j], solved_right[j]);
    }
    for j in (0..NODES - 1).rev() {
        let over = pivots[j];
        solved_right[j] += over * solved_right[j + 1];
        let next = solved_border[j + 1];
        add(&mut solved_border[j], &next, over);
    }
    let mut matrix = [[0.0; M]; M];
    let mut right = rest.map(|v| -v);
    for j in 0..NODES {
        for row in 0..M {
            add(&mut matrix[row], &solved_border[j], border[j][row]);
        }
        add(&mut right, &border[j], solved_right[j]);
    }
    if negative_pivots(matrix) != Some(negative) {
        return None;
    }
    let multipliers = solved(matrix, right)?;
    let mut change = solved_right;
    for (value, row) in change.iter_mut().zip(&solved_border) {
        *value -= dot(row, &multipliers);
    }
    Some(Step {
        change,
        multipliers,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Half the sum of squared steps of z.
    fn squares(reflectance: &[f64; NODES]) -> f64 {
        let z = reflectance.map(|r| 0.5 * (r / (1.0 - r)).ln());
        0.5 * z.windows(2).map(|w| (w[1] - w[0]).powi(2)).sum::<f64>()
    }

    #[test]
    fn the_smoothest_is_a_least_and_no_saddle() {
        // Two nodes far apart share .2, the one between them has .0025: alike on both sides is a
        // saddle, one side doing all of it is smoother.
        let mut columns = [[0.0; 2]; NODES];
        (columns[20][0], columns[60][0], columns[40][1]) = (1.0, 1.0, 1.0);
        let target = [0.2, 0.0025];
        let (found, _) = smoothest(&columns, target, None).unwrap();
        assert!((found[20] + found[60] - 0.2).abs() < EXACT && (found[40] - 0.0025).abs() < EXACT);
        let z = |r: f64| 0.5 * (r / (1.0 - r)).ln();
        // Straight lines of z between those nodes, level beyond them: alike on both sides, and
        // the best split of the .2 by looking at a thousand.
        let split = |p: f64| {
            let away = |r: f64| (z(r) - z(0.0025)).powi(2) / 20.0;
            0.5 * (away(p) + away(0.2 - p))
        };
        let alike = split(0.1);
        let best = (1..2000).map(|i| split(0.2 * f64::from(i) / 2000.0));
        let best = best.fold(f64::INFINITY, f64::min);
        assert!(best < 0.8 * alike);
        // A look every 1e-4 misses the valley's floor by less than 1e-4 of its height.
        assert!(
            (squares(&found) - best).abs() < 1e-4 * best,
            "{} {best} {alike}",
            squares(&found)
        );
    }
}
