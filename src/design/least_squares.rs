//! Least squares over weights that are not negative, some equations being met exactly.
//!
//! ```text
//! least |A w - b|^2,  C w = d,  w >= 0
//! ```
//!
//! An active-set method: on the weights that are free the problem is a plain one of least squares
//! along what the equations leave; a weight that would turn negative is held at zero, one whose
//! release helps is released. It ends after finitely many exchanges at the one answer there is. The
//! columns themselves are factored, each at length one and the most different first, so that the
//! condition is theirs and not its square: two lines 3 nm apart are told apart. Source: Lawson and
//! Hanson, "Solving Least Squares Problems" (1974), chapters 20 and 23.
//!
//! Why not a crate: `nnls` (BSD-2-Clause) knows no equations, and a colour that is only weighted
//! heavily is not exact; `clarabel` (Apache-2.0) solves the problem to a tolerance from inside,
//! which leaves tiny weights where zeros belong, and is built for thousands of unknowns;
//! `levenberg-marquardt` (MIT) and `argmin` (MIT or Apache-2.0) know no bounds.

use nalgebra::{DMatrix, DVector};

use super::programme::{End, Programme};

/// A slope below this share of what is to be matched is rounding: some fifty times that of f64, for
/// sums of up to some hundred products of columns of length one.
const NO_SLOPE: f64 = 1e-14;

/// Relative size below which the part of a column outside the span of the others is rounding.
const NOTHING_OF_ITS_OWN: f64 = 1e-13;

/// Weights of the least squares among those that meet the equations (one column of `equations` a
/// weight). Columns that are the same share evenly.
///
/// # Errors
/// [`End::Impossible`] where no weights meet the equations, [`End::Stuck`] where rounding or
/// patience ended the search.
pub(super) fn least_squares<const M: usize>(
    columns: &[&[f64]],
    goal: &[f64],
    equations: &[[f64; M]],
    met: [f64; M],
) -> Result<Vec<f64>, End> {
    let count = columns.len();
    let norm = |column: &&[f64]| column.iter().map(|v| v * v).sum::<f64>().sqrt();
    let lengths: Vec<f64> = columns
        .iter()
        .map(norm)
        .map(|l| if l > 0.0 { l } else { 1.0 })
        .collect();
    let matrix = DMatrix::from_fn(goal.len(), count, |row, i| columns[i][row] / lengths[i]);
    // The squares ask for no more than its triangle.
    let factors = matrix.qr();
    let mut right = DVector::from_column_slice(goal);
    factors.q_tr_mul(&mut right);
    let rows = goal.len().min(count);
    let fit = Fit {
        triangle: factors.r(),
        right: right.rows(0, rows).into_owned(),
        equations: DMatrix::from_fn(M, count, |k, i| equations[i][k] / lengths[i]),
        met: DVector::from_column_slice(&met),
    };
    let mut weights = if M == 0 {
        vec![0.0; count]
    } else {
        let mut programme = Programme::new(equations, &vec![f64::INFINITY; count], met);
        let corner = programme.corner()?;
        programme.solution(&corner)
    };
    let scaled = weights.iter_mut().zip(&lengths);
    scaled.for_each(|(weight, length)| *weight *= length);
    fit.exchanged(&mut weights)?;
    let plain = weights.iter_mut().zip(&lengths);
    plain.for_each(|(weight, length)| *weight /= length);
    shared(columns, equations, &mut weights);
    Ok(weights)
}

/// Columns that are the same get the same.
fn shared<const M: usize>(columns: &[&[f64]], equations: &[[f64; M]], weights: &mut [f64]) {
    let mut is_done = vec![false; columns.len()];
    for first in 0..columns.len() {
        let is_same = |i: &usize| {
            !is_done[*i] && columns[*i] == columns[first] && equations[*i] == equations[first]
        };
        let same: Vec<usize> = (first..columns.len()).filter(is_same).collect();
        let share = same.iter().map(|i| weights[*i]).sum::<f64>() / same.len() as f64;
        for i in same {
            (weights[i], is_done[i]) = (share, true);
        }
    }
}

/// Squares and equations of weights, each column at length one.
struct Fit {
    triangle: DMatrix<f64>,
    right: DVector<f64>,
    equations: DMatrix<f64>,
    met: DVector<f64>,
}

impl Fit {
    /// Goes from weights that meet the equations to the least squares.
    fn exchanged(&self, weights: &mut [f64]) -> Result<(), End> {
        let count = weights.len();
        let mut free: Vec<usize> = (0..count).filter(|i| weights[*i] > 0.0).collect();
        // Released, and pushed back at once: rounding alone said that they help.
        let mut barred: Vec<usize> = Vec::new();
        for _ in 0..60 * (count + 1) {
            let goal = self.on_free(&free, weights)?;
            let both = free.iter().zip(&goal);
            let blocked = both
                .filter(|(_, goal)| **goal < 0.0)
                .map(|(i, goal)| (weights[*i] / (weights[*i] - goal), *i))
                .min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            if let Some((part, stopped)) = blocked {
                for (i, goal) in free.iter().zip(&goal) {
                    weights[*i] += part * (goal - weights[*i]);
                }
                weights[stopped] = 0.0;
                free.retain(|i| *i != stopped);
                if part <= 0.0 {
                    barred.push(stopped);
                } else {
                    barred.clear();
                }
                continue;
            }
            let both = free.iter().zip(&goal);
            both.for_each(|(i, goal)| weights[*i] = *goal);
            match self.helpful(&free, &barred, weights)? {
                Some(index) => free.insert(free.partition_point(|i| *i < index), index),
                None => return Ok(()),
            }
        }
        Err(End::Stuck)
    }

    /// The held weight whose release lowers the squares most.
    fn helpful(
        &self,
        free: &[usize],
        barred: &[usize],
        weights: &[f64],
    ) -> Result<Option<usize>, End> {
        let left = &self.triangle * DVector::from_column_slice(weights) - &self.right;
        let fit = self.triangle.tr_mul(&left);
        let mut slopes = fit.clone();
        if self.equations.nrows() > 0 && !free.is_empty() {
            // What the equations are worth, by the free weights, whose slopes are none.
            let kept = self.equations.select_columns(free).transpose();
            let right = DVector::from_iterator(free.len(), free.iter().map(|i| fit[*i]));
            let duals = pseudo_solved(kept, &right)?;
            slopes -= self.equations.tr_mul(&duals);
        }
        let size = self
            .right
            .norm()
            .max((fit - &slopes).amax())
            .max(left.norm());
        let mut best: Option<(f64, usize)> = None;
        for (i, slope) in slopes.iter().enumerate() {
            let is_held = !free.contains(&i) && !barred.contains(&i);
            if is_held && *slope < -NO_SLOPE * size && best.is_none_or(|(least, _)| *slope < least)
            {
                best = Some((*slope, i));
            }
        }
        Ok(best.map(|(_, i)| i))
    }

    /// Weights of the free columns, the others being zero: the least squares of those that meet
    /// the equations.
    fn on_free(&self, free: &[usize], weights: &[f64]) -> Result<Vec<f64>, End> {
        let size = free.len();
        if size == 0 {
            return Ok(Vec::new());
        }
        let triangle = self.triangle.select_columns(free);
        let equations = self.equations.select_columns(free);
        let mut now = DVector::from_iterator(size, free.iter().map(|i| weights[*i]));
        let mut along = DMatrix::identity(size, size);
        if equations.nrows() > 0 {
            // Rounding since the equations were met last.
            now += pseudo_solved(equations.clone(), &(&self.met - &equations * &now))?;
            let factors = equations.transpose().col_piv_qr();
            // More equations than columns leave a triangle that is wider than high.
            let triangle = factors.r();
            let corners =
                (0..triangle.nrows().min(triangle.ncols())).map(|i| triangle[(i, i)].abs());
            let least = corners.clone().fold(0.0, f64::max) * NOTHING_OF_ITS_OWN;
            let rank = corners.filter(|v| *v > least).count();
            factors.q_tr_mul(&mut along);
            along = along.rows(rank, size - rank).transpose();
        }
        if along.ncols() > 0 {
            let right = &self.right - &triangle * &now;
            now += &along * solved(triangle * &along, right)?;
        }
        let found: Vec<f64> = now.iter().copied().collect();
        let is_finite = found.iter().all(|v| v.is_finite());
        is_finite.then_some(found).ok_or(End::Stuck)
    }
}

/// The least squares of plain equations, the most different columns first; of columns that have
/// nothing of their own the shortest solution.
fn solved(matrix: DMatrix<f64>, right: DVector<f64>) -> Result<DVector<f64>, End> {
    let columns = matrix.ncols();
    if matrix.nrows() >= columns {
        let factors = matrix.clone().col_piv_qr();
        let triangle = factors.r();
        let corners = triangle.diagonal().map(f64::abs);
        if corners.amin() > NOTHING_OF_ITS_OWN * corners.amax() {
            let mut turned = right;
            factors.q_tr_mul(&mut turned);
            let mut found = turned.rows(0, columns).into_owned();
            if triangle.solve_upper_triangular_mut(&mut found) {
                factors.p().inv_permute_rows(&mut found);
                return Ok(found);
            }
            return Err(End::Stuck);
        }
    }
    pseudo_solved(matrix, &right)
}

fn pseudo_solved(matrix: DMatrix<f64>, right: &DVector<f64>) -> Result<DVector<f64>, End> {
    let svd = matrix.svd(true, true);
    let least = svd.singular_values.amax() * NOTHING_OF_ITS_OWN;
    svd.solve(right, least).map_err(|_| End::Stuck)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(found: Result<Vec<f64>, End>, expected: &[f64]) {
        let found = found.unwrap();
        for (a, b) in found.iter().zip(expected) {
            // A handful of operations on numbers of size one.
            assert!((a - b).abs() < 1e-14, "{found:?} {expected:?}");
        }
    }

    #[test]
    fn without_equations_it_is_least_squares_with_negative_weights_held_at_zero() {
        let columns: [&[f64]; 2] = [&[1.0, 0.0], &[0.0, 1.0]];
        close(
            least_squares::<0>(&columns, &[2.0, -3.0], &[[]; 2], []),
            &[2.0, 0.0],
        );
        close(
            least_squares::<0>(&columns, &[2.0, 3.0], &[[]; 2], []),
            &[2.0, 3.0],
        );
    }

    #[test]
    fn an_equation_is_met_and_the_rest_is_as_near_as_it_can_be() {
        let columns: [&[f64]; 2] = [&[1.0, 0.0], &[0.0, 1.0]];
        let sum = [[1.0], [1.0]];
        // On a + b = 1 the nearest to (2, 2) is (1/2, 1/2), to (2, 0.5) is (1, 0).
        close(
            least_squares(&columns, &[2.0, 2.0], &sum, [1.0]),
            &[0.5, 0.5],
        );
        close(
            least_squares(&columns, &[2.0, 0.5], &sum, [1.0]),
            &[1.0, 0.0],
        );
        assert_eq!(
            least_squares(&columns, &[2.0, 2.0], &sum, [-1.0]),
            Err(End::Impossible)
        );
    }

    #[test]
    fn two_channels_that_are_the_same_get_half_each() {
        let columns: [&[f64]; 3] = [&[1.0, 1.0], &[1.0, 1.0], &[0.0, 1.0]];
        close(
            least_squares::<0>(&columns, &[2.0, 3.0], &[[]; 3], []),
            &[1.0, 1.0, 1.0],
        );
    }

    #[test]
    fn columns_that_are_nearly_the_same_are_told_apart() {
        // They differ by 1e-5, products by 1e-10: less than rounding of f32, and than any ridge.
        let columns: [&[f64]; 3] = [&[1.0, 0.0, 1.0], &[1.0, 1e-5, 1.0], &[0.0, 1.0, 0.5]];
        let goal = [2.5, 3.0 + 0.5e-5, 4.0];
        let found = least_squares::<0>(&columns, &goal, &[[]; 3], []).unwrap();
        for (a, b) in found.iter().zip([2.0, 0.5, 3.0]) {
            // The rounding of numbers of size one, times the condition of 1e5.
            assert!((a - b).abs() < 1e-9, "{found:?}");
        }
    }

    #[test]
    fn a_weak_column_is_weighed_like_a_strong_one() {
        let columns: [&[f64]; 2] = [&[1.0, 0.0], &[0.0, 1e-12]];
        let found = least_squares::<0>(&columns, &[1.0, 3e-12], &[[]; 2], []).unwrap();
        assert!((found[1] - 3.0).abs() < 1e-3, "{found:?}");
    }
}
