//! Linear programmes with a few equations and many bounded unknowns, by the simplex method.
//!
//! ```text
//! sum_j x_j a_j = b,  0 <= x_j <= u_j,  greatest sum_j c_j x_j
//! ```
//!
//! The colours of light and matter give such programmes: three equations (X, Y, Z) or six, and as
//! many unknowns as there are wavelengths or channels. With so few equations the inverse of the
//! basis is computed anew at every step, so that rounding does not pile up, and going from one
//! goal to the next starts where the last one ended. Ties go to the lowest index: the same input
//! takes the same way.
//!
//! Source of the method with bounds: Dantzig, "Linear Programming and Extensions" (1963), chapter
//! 18; Bland's rule (1977) against going in circles.

use super::small::{add, combined, dot, inverse};

/// Tolerance for being on a bound or an equation, for columns of unit length.
const SLACK: f64 = 1e-11;

/// Feasibility tolerance on the equations and bounds: a thousand times finer than any colour is
/// known, and coarse enough for the rounding at the very edge.
const POSSIBLE: f64 = 1e-9;

/// A gain below this share of the numbers that it is the difference of is rounding: some ten
/// products, whose duals carry the rounding of an inverse of condition up to `1 / SMALLEST_PIVOT`
/// at worst and of some thousands as a rule.
const NO_GAIN: f64 = 1e-12;

/// Smallest number that is divided by in an exchange.
const SMALLEST_PIVOT: f64 = 1e-9;

/// Exchanges after which the slower rule that cannot go in circles is used. It decides about time
/// alone: programmes of up to six equations take some dozen exchanges.
const PATIENCE: usize = 400;

/// Exchanges after which nothing is known: far more than either rule takes.
const MOST_STEPS: usize = 4000;

/// Why a programme has no best corner that is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub(super) enum End {
    /// Nothing satisfies the equations and bounds.
    #[error("{}", said!("nothing satisfies the equations and bounds"))]
    Impossible,
    /// The sum grows without bound.
    #[error("{}", said!("the sum grows without bound"))]
    Endless,
    /// The way there ended for rounding or for patience: the best may be another.
    #[error("{}", said!("rounding or patience ended the search"))]
    Stuck,
}

/// Equations and bounds.
#[derive(Clone, Debug)]
pub(super) struct Programme<const M: usize> {
    /// Of length one each; those of the artificial unknowns stand behind the others.
    columns: Vec<[f64; M]>,
    /// In units of the scaled unknowns.
    upper: Vec<f64>,
    /// Divisors of the scaled unknowns; zero for a column of no length.
    lengths: Vec<f64>,
    right: [f64; M],
}

/// A corner of what the equations and bounds allow.
#[derive(Clone, Debug)]
pub(super) struct BasicSolution<const M: usize> {
    basis: [usize; M],
    place: Vec<BoundStatus>,
    values: [f64; M],
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum BoundStatus {
    Lower,
    Upper,
    Basic,
}

impl<const M: usize> Programme<M> {
    /// From columns, upper bounds (`f64::INFINITY` for none) and the right side.
    pub(super) fn new(columns: &[[f64; M]], upper: &[f64], right: [f64; M]) -> Self {
        let lengths: Vec<f64> = columns.iter().map(|c| dot(c, c).sqrt()).collect();
        // Each column by its own length, however weak: only what is nothing is left alone.
        let sound = |length: f64| if length.is_normal() { length } else { 0.0 };
        let lengths: Vec<f64> = lengths.into_iter().map(sound).collect();
        let mut scaled: Vec<[f64; M]> = columns
            .iter()
            .zip(&lengths)
            .map(|(c, length)| {
                let factor = if *length > 0.0 { 1.0 / length } else { 0.0 };
                c.map(|v| v * factor)
            })
            .collect();
        let mut bounds: Vec<f64> = upper.iter().zip(&lengths).map(|(u, l)| u * l).collect();
        for (row, value) in right.iter().enumerate() {
            let sign = if *value < 0.0 { -1.0 } else { 1.0 };
            let unit = std::array::from_fn(|k| if k == row { sign } else { 0.0 });
            scaled.push(unit);
            bounds.push(f64::INFINITY);
        }
        // 0 times infinity.
        bounds
            .iter_mut()
            .for_each(|b| *b = if b.is_nan() { 0.0 } else { *b });
        Self {
            columns: scaled,
            upper: bounds,
            lengths,
            right,
        }
    }

    /// A corner. Closes the artificial unknowns for good.
    ///
    /// # Errors
    /// [`End::Impossible`] where nothing satisfies the equations and bounds, [`End::Stuck`] where
    /// that is not known.
    pub(super) fn corner(&mut self) -> Result<BasicSolution<M>, End> {
        let count = self.lengths.len();
        let mut corner = BasicSolution {
            basis: std::array::from_fn(|row| count + row),
            place: vec![BoundStatus::Lower; count + M],
            values: self.right.map(f64::abs),
        };
        corner.place[count..].fill(BoundStatus::Basic);
        let mut gain = vec![0.0; count + M];
        gain[count..].fill(-1.0);
        let climbed = self.climb(&mut corner, &gain);
        let rest: f64 = (0..M)
            .filter(|row| corner.basis[*row] >= count)
            .map(|row| corner.values[row].abs())
            .sum();
        self.upper[count..].fill(0.0);
        // However it was found, a corner is one.
        if rest <= POSSIBLE * self.size() && self.is_inside(&corner) {
            return Ok(corner);
        }
        climbed.and(Err(End::Impossible))
    }

    /// Goes to the corner of the greatest `sum gain_j x_j` and tells it.
    ///
    /// # Errors
    /// [`End::Endless`] where it grows without bound, [`End::Stuck`] where the best is not known.
    pub(super) fn maximise(&self, corner: &mut BasicSolution<M>, gain: &[f64]) -> Result<f64, End> {
        let mut scaled: Vec<f64> = gain
            .iter()
            .zip(&self.lengths)
            .map(|(g, length)| if *length > 0.0 { g / length } else { 0.0 })
            .collect();
        scaled.resize(self.columns.len(), 0.0);
        self.climb(corner, &scaled)?;
        let found = self.solution(corner);
        Ok(found.iter().zip(gain).map(|(x, g)| x * g).sum())
    }

    /// Goes to the greatest (`sign` 1) or least (-1) value of one unknown and tells it; `None` for
    /// one whose column is nothing, which no equation holds.
    ///
    /// # Errors
    /// As [`Programme::maximise`].
    pub(super) fn extreme(
        &self,
        corner: &mut BasicSolution<M>,
        index: usize,
        sign: f64,
    ) -> Result<Option<f64>, End> {
        let length = self.lengths[index];
        if length == 0.0 {
            return Ok(None);
        }
        let mut gain = vec![0.0; self.columns.len()];
        gain[index] = sign;
        self.climb(corner, &gain)?;
        Ok(Some(self.value(corner, index) / length))
    }

    /// The unknowns at a corner.
    pub(super) fn solution(&self, corner: &BasicSolution<M>) -> Vec<f64> {
        let lengths = self.lengths.iter().enumerate();
        let value = |(index, length): (usize, &f64)| {
            if *length > 0.0 {
                self.value(corner, index) / length
            } else {
                0.0
            }
        };
        lengths.map(value).collect()
    }

    fn value(&self, corner: &BasicSolution<M>, index: usize) -> f64 {
        match corner.place[index] {
            BoundStatus::Lower => 0.0,
            BoundStatus::Upper => self.upper[index],
            BoundStatus::Basic => {
                let row = corner.basis.iter().position(|b| *b == index);
                let value = row.map_or(0.0, |row| corner.values[row]);
                value.clamp(0.0, self.upper[index])
            }
        }
    }

    /// The scale that rounding is measured against.
    fn size(&self) -> f64 {
        1.0 + self.right.iter().fold(0.0, |a, v| v.abs().max(a))
    }

    /// True if the basic unknowns keep their bounds to within rounding.
    fn is_inside(&self, corner: &BasicSolution<M>) -> bool {
        let rounding = POSSIBLE * self.size();
        let both = corner.basis.iter().zip(&corner.values);
        let mut kept = both.map(|(index, value)| (*value, self.upper[*index]));
        kept.all(|(value, upper)| value >= -rounding && value <= upper + rounding)
    }

    /// Exchanges until nothing gains.
    fn climb(&self, corner: &mut BasicSolution<M>, gain: &[f64]) -> Result<(), End> {
        for step in 0..MOST_STEPS {
            let basis: [[f64; M]; M] =
                std::array::from_fn(|row| corner.basis.map(|b| self.columns[b][row]));
            let inverse = inverse(&basis).ok_or(End::Stuck)?;
            corner.values = self.basic_values(corner, &inverse);
            let duals = combined(&inverse, &corner.basis.map(|index| gain[index]));
            let by_index = step > PATIENCE;
            let Some((entering, sign)) = self.entering(corner, gain, &duals, by_index) else {
                return self.is_inside(corner).then_some(()).ok_or(End::Stuck);
            };
            let column = &self.columns[entering];
            let turn: [f64; M] = std::array::from_fn(|row| sign * dot(&inverse[row], column));
            match self.first_stop(corner, &turn, self.upper[entering]) {
                Stop::Never => return Err(End::Endless),
                Stop::Own => {
                    corner.place[entering] = match corner.place[entering] {
                        BoundStatus::Lower => BoundStatus::Upper,
                        _ => BoundStatus::Lower,
                    };
                }
                Stop::At { row, place } => {
                    corner.place[corner.basis[row]] = place;
                    corner.place[entering] = BoundStatus::Basic;
                    corner.basis[row] = entering;
                }
            }
        }
        Err(End::Stuck)
    }

    fn basic_values(&self, corner: &BasicSolution<M>, inverse: &[[f64; M]; M]) -> [f64; M] {
        let mut right = self.right;
        for ((column, upper), place) in self.columns.iter().zip(&self.upper).zip(&corner.place) {
            if *place == BoundStatus::Upper {
                add(&mut right, column, -upper);
            }
        }
        std::array::from_fn(|row| dot(&inverse[row], &right))
    }

    /// The unknown that gains most by leaving its bound (or the first that gains), and the sense.
    fn entering(
        &self,
        corner: &BasicSolution<M>,
        gain: &[f64],
        duals: &[f64; M],
        by_index: bool,
    ) -> Option<(usize, f64)> {
        let mut best = None;
        let mut most = 0.0;
        for (index, place) in corner.place.iter().enumerate() {
            let sign = match place {
                BoundStatus::Basic => continue,
                BoundStatus::Lower => 1.0,
                BoundStatus::Upper => -1.0,
            };
            if self.upper[index] <= 0.0 {
                continue;
            }
            let column = &self.columns[index];
            let rise = sign * (gain[index] - dot(duals, column));
            let parts = duals.iter().zip(column).map(|(p, c)| (p * c).abs());
            let rounding = NO_GAIN * (gain[index].abs() + parts.sum::<f64>());
            if rise > most && rise > rounding {
                best = Some((index, sign));
                if by_index {
                    return best;
                }
                most = rise;
            }
        }
        best
    }

    /// The first stop of the unknown that leaves its bound: a basic one, or its own other bound.
    fn first_stop(&self, corner: &BasicSolution<M>, turn: &[f64; M], own: f64) -> Stop {
        let mut nearest = own;
        let mut stop = if own.is_finite() {
            Stop::Own
        } else {
            Stop::Never
        };
        let mut pivot = 0.0;
        for (row, turn) in turn.iter().enumerate() {
            let size = turn.abs();
            if size < SMALLEST_PIVOT {
                continue;
            }
            let (room, place) = if *turn > 0.0 {
                (corner.values[row], BoundStatus::Lower)
            } else {
                (
                    self.upper[corner.basis[row]] - corner.values[row],
                    BoundStatus::Upper,
                )
            };
            if room == f64::INFINITY {
                continue;
            }
            let reach = room.max(0.0) / size;
            // Of equal stops the one with the largest number to divide by.
            let is_first = reach < nearest - SLACK || (reach <= nearest + SLACK && size > pivot);
            if is_first {
                (nearest, pivot, stop) = (reach.min(nearest), size, Stop::At { row, place });
            }
        }
        stop
    }
}

enum Stop {
    Never,
    Own,
    At { row: usize, place: BoundStatus },
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_greatest_and_least_are_found_at_corners() {
        // x + y + z = 2, x - y = 0.5, each at most 1: z = 2.5 - 2x, x in 0.75..1.
        let columns = [[1.0, 1.0], [1.0, -1.0], [1.0, 0.0]];
        let mut programme = Programme::new(&columns, &[1.0; 3], [2.0, 0.5]);
        let mut corner = programme.corner().unwrap();
        // Sums of a few numbers of size one.
        let is = |found: f64, value: f64| (found - value).abs() < 1e-14;
        let most = programme.maximise(&mut corner, &[1.0, 1.0, 0.0]);
        assert!(is(most.unwrap(), 1.5));
        for (index, sign, value) in [(2, 1.0, 1.0), (2, -1.0, 0.5), (0, -1.0, 0.75)] {
            let found = programme.extreme(&mut corner, index, sign).unwrap();
            assert!(is(found.unwrap(), value));
        }
        assert_eq!(programme.solution(&corner).len(), 3);
    }

    #[test]
    fn what_cannot_be_and_what_has_no_end_are_told() {
        let columns = [[1.0], [1.0]];
        for beyond in [2.5, -0.1] {
            let end = Programme::new(&columns, &[1.0; 2], [beyond]).corner();
            assert_eq!(end.err(), Some(End::Impossible));
        }
        let open = [f64::INFINITY; 2];
        let mut endless = Programme::new(&[[1.0], [-1.0]], &open, [0.0]);
        let mut corner = endless.corner().unwrap();
        let end = endless.maximise(&mut corner, &[1.0, 0.0]);
        assert_eq!(end, Err(End::Endless));
    }

    #[test]
    fn a_search_that_rounding_ends_does_not_claim_the_best() {
        // A basis of two columns that are the same has no inverse: nothing is known from there.
        let programme = Programme::new(&[[1.0, 1.0], [1.0, 1.0], [0.0, 1.0]], &[1.0; 3], [1.0; 2]);
        let mut corner = BasicSolution {
            basis: [0, 1],
            place: vec![
                BoundStatus::Basic,
                BoundStatus::Basic,
                BoundStatus::Lower,
                BoundStatus::Lower,
                BoundStatus::Lower,
            ],
            values: [0.5, 0.5],
        };
        let end = programme.maximise(&mut corner, &[0.0, 0.0, 1.0]);
        assert_eq!(end, Err(End::Stuck));
        // Numbers that are none take no way at all.
        let mut none = Programme::new(&[[f64::NAN, 1.0]], &[1.0], [1.0; 2]);
        assert!(none.corner().is_err());
    }

    #[test]
    fn a_corner_beyond_its_bounds_is_not_the_best() {
        // x = 2 with x of 1 at most, as rounding could leave it.
        let programme = Programme::new(&[[1.0]], &[1.0], [2.0]);
        let mut corner = BasicSolution {
            basis: [0],
            place: vec![BoundStatus::Basic, BoundStatus::Lower],
            values: [2.0],
        };
        assert_eq!(programme.maximise(&mut corner, &[1.0]), Err(End::Stuck));
    }

    #[test]
    fn what_is_weak_beside_the_others_is_weighed_like_them() {
        // x / 10^10 + y = 1 and the least x + y: all of y. Then the least y + x / 10^11: all of x.
        let mut programme = Programme::new(&[[1e-10], [1.0]], &[f64::INFINITY; 2], [1.0]);
        let mut corner = programme.corner().unwrap();
        let least = -programme.maximise(&mut corner, &[-1.0, -1.0]).unwrap();
        assert!((least - 1.0).abs() < 1e-14, "{least}");
        let least = -programme.maximise(&mut corner, &[-1e-11, -1.0]).unwrap();
        assert!((least - 0.1).abs() < 1e-14, "{least}");
        // A third that costs much for what it brings does not hide what the others gain.
        let columns = [[1e-10], [1.0], [1.0]];
        let mut programme = Programme::new(&columns, &[f64::INFINITY; 3], [1.0]);
        let mut corner = programme.corner().unwrap();
        let least = -programme
            .maximise(&mut corner, &[-100.0, -1.0, -0.5])
            .unwrap();
        assert!((least - 0.5).abs() < 1e-14, "{least}");
    }

    #[test]
    fn equations_that_say_the_same_twice_do_no_harm() {
        let columns = [[1.0, 2.0], [3.0, 6.0], [0.5, 1.0]];
        let mut programme = Programme::new(&columns, &[1.0; 3], [2.0, 4.0]);
        let mut corner = programme.corner().unwrap();
        let found = programme.maximise(&mut corner, &[1.0, 0.0, 0.0]).unwrap();
        assert!((found - 1.0).abs() < 1e-14, "as above");
    }
}
