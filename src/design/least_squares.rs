//! Least squares over weights that are not negative, some equations being met exactly.
//!
//! ```text
//! least |A w - b|^2,  C w = d,  w >= 0
//! ```
//!
//! An active-set method: on the weights that are free the problem is one linear system; a weight
//! that would turn negative is held at zero, one whose release helps is released. It ends after
//! finitely many exchanges at the one answer there is. Source: Lawson and Hanson, "Solving Least
//! Squares Problems" (1974), chapter 23, with the equations kept by multipliers (Nocedal and
//! Wright, "Numerical Optimization", 2006, algorithm 16.3).
//!
//! Why not a crate: `nnls` (BSD-2-Clause) knows no equations, and a colour that is only weighted
//! heavily is not exact; `clarabel` (Apache-2.0) solves the problem to a tolerance from inside,
//! which leaves tiny weights where zeros belong, and is built for thousands of unknowns;
//! `levenberg-marquardt` (MIT) and `argmin` (MIT or Apache-2.0) know no bounds.

use nalgebra::{DMatrix, DVector};

use super::programme::Programme;

/// Added to the squares of the weights, as a share of the mean diagonal: of two channels that are
/// the same, each gets half.
const EVENNESS: f64 = 1e-9;

/// Slopes below this share of the largest are none.
const NO_SLOPE: f64 = 1e-10;

/// Sum of squares as `w' G w - 2 g' w`, so that only products of columns are needed.
#[derive(Clone, Debug)]
pub(super) struct Squares {
    /// `G`: products of columns, row after row.
    pub(super) products: Vec<f64>,
    /// `g`: products of columns with what is to be matched.
    pub(super) right: Vec<f64>,
}

/// Weights of the least squares among those that meet the equations (one column of `equations` a
/// weight); `None` where no weights do.
pub(super) fn least_squares<const M: usize>(
    squares: &Squares,
    equations: &[[f64; M]],
    met: [f64; M],
) -> Option<Vec<f64>> {
    let count = squares.right.len();
    let mut weights = if M == 0 {
        vec![0.0; count]
    } else {
        let mut programme = Programme::new(equations, &vec![f64::INFINITY; count], met);
        let corner = programme.corner()?;
        programme.solution(&corner)
    };
    let mean = (0..count)
        .map(|i| squares.products[i * count + i])
        .sum::<f64>()
        / count as f64;
    let product = |i: usize, j: usize| {
        squares.products[i * count + j] + if i == j { EVENNESS * mean } else { 0.0 }
    };
    let mut free: Vec<usize> = (0..count).filter(|i| weights[*i] > 0.0).collect();
    for _ in 0..60 * (count + 1) {
        let (goal, prices) = on_free(&free, &product, squares, equations, met)?;
        let blocked = free
            .iter()
            .zip(&goal)
            .filter(|(_, goal)| **goal < 0.0)
            .map(|(i, goal)| (weights[*i] / (weights[*i] - goal), *i))
            .min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        if let Some((part, stopped)) = blocked {
            for (i, goal) in free.iter().zip(&goal) {
                weights[*i] += part * (goal - weights[*i]);
            }
            weights[stopped] = 0.0;
            free.retain(|i| *i != stopped);
            continue;
        }
        free.iter()
            .zip(&goal)
            .for_each(|(i, goal)| weights[*i] = *goal);
        // Held weights whose release lowers the squares.
        let mut largest = 0.0_f64;
        let mut best: Option<(f64, usize)> = None;
        for (i, equation) in equations.iter().enumerate() {
            let fit: f64 = (0..count).map(|j| product(i, j) * weights[j]).sum();
            let priced: f64 = equation.iter().zip(&prices).map(|(e, p)| e * p).sum();
            let slope = fit - squares.right[i] - priced;
            largest = largest
                .max(fit.abs())
                .max(squares.right[i].abs())
                .max(priced.abs());
            if !free.contains(&i) && best.is_none_or(|(least, _)| slope < least) {
                best = Some((slope, i));
            }
        }
        match best {
            Some((slope, index)) if slope < -NO_SLOPE * largest => {
                let at = free.partition_point(|i| *i < index);
                free.insert(at, index);
            }
            _ => break,
        }
    }
    weights.iter().all(|w| w.is_finite()).then_some(weights)
}

/// Weights of the free channels, the others being zero, and the multipliers of the equations.
fn on_free<const M: usize>(
    free: &[usize],
    product: &impl Fn(usize, usize) -> f64,
    squares: &Squares,
    equations: &[[f64; M]],
    met: [f64; M],
) -> Option<(Vec<f64>, [f64; M])> {
    let (n, size) = (free.len(), free.len() + M);
    if size == 0 {
        return Some((Vec::new(), [0.0; M]));
    }
    let mut matrix = DMatrix::zeros(size, size);
    let mut right = DVector::zeros(size);
    for (row, i) in free.iter().enumerate() {
        right[row] = squares.right[*i];
        for (column, j) in free.iter().enumerate() {
            matrix[(row, column)] = product(*i, *j);
        }
        for k in 0..M {
            matrix[(row, n + k)] = -equations[*i][k];
            matrix[(n + k, row)] = equations[*i][k];
        }
    }
    (0..M).for_each(|k| right[n + k] = met[k]);
    let direct = matrix.clone().full_piv_lu().solve(&right);
    let good = |found: &DVector<f64>| {
        let scale = matrix.amax() * found.amax() + right.amax();
        found.iter().all(|v| v.is_finite()) && (&matrix * found - &right).amax() <= 1e-9 * scale
    };
    // Fewer free weights than equations, all of which hold: any multipliers will do.
    let found = match direct.filter(good) {
        Some(found) => found,
        None => {
            let svd = matrix.clone().svd(true, true);
            let least = svd.singular_values.amax() * 1e-13;
            svd.solve(&right, least).ok()?
        }
    };
    let prices = std::array::from_fn(|k| found[n + k]);
    Some((found.iter().take(n).copied().collect(), prices))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Products of columns and of columns with the goal.
    fn squares(columns: &[&[f64]], goal: &[f64]) -> Squares {
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
        Squares {
            products: columns
                .iter()
                .flat_map(|a| columns.iter().map(move |b| dot(a, b)))
                .collect(),
            right: columns.iter().map(|a| dot(a, goal)).collect(),
        }
    }

    fn close(found: Option<Vec<f64>>, expected: &[f64]) {
        let found = found.unwrap();
        for (a, b) in found.iter().zip(expected) {
            // The evenness (1e-9) moves numbers of size one by about itself; between equal channels
            // it alone decides, and rounding over it is 1e-7.
            assert!((a - b).abs() < 1e-6, "{found:?} {expected:?}");
        }
    }

    #[test]
    fn without_equations_it_is_least_squares_with_negative_weights_held_at_zero() {
        let columns: [&[f64]; 2] = [&[1.0, 0.0], &[0.0, 1.0]];
        close(
            least_squares::<0>(&squares(&columns, &[2.0, -3.0]), &[[]; 2], []),
            &[2.0, 0.0],
        );
        close(
            least_squares::<0>(&squares(&columns, &[2.0, 3.0]), &[[]; 2], []),
            &[2.0, 3.0],
        );
    }

    #[test]
    fn an_equation_is_met_and_the_rest_is_as_near_as_it_can_be() {
        let columns: [&[f64]; 2] = [&[1.0, 0.0], &[0.0, 1.0]];
        let sum = [[1.0], [1.0]];
        // On a + b = 1 the nearest to (2, 2) is (1/2, 1/2), to (2, 0.5) is (1, 0).
        close(
            least_squares(&squares(&columns, &[2.0, 2.0]), &sum, [1.0]),
            &[0.5, 0.5],
        );
        close(
            least_squares(&squares(&columns, &[2.0, 0.5]), &sum, [1.0]),
            &[1.0, 0.0],
        );
        assert_eq!(
            least_squares(&squares(&columns, &[2.0, 2.0]), &sum, [-1.0]),
            None
        );
    }

    #[test]
    fn two_channels_that_are_the_same_get_half_each() {
        let columns: [&[f64]; 3] = [&[1.0, 1.0], &[1.0, 1.0], &[0.0, 1.0]];
        close(
            least_squares::<0>(&squares(&columns, &[2.0, 3.0]), &[[]; 3], []),
            &[1.0, 1.0, 1.0],
        );
    }
}
