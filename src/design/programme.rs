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

use super::small::{add, dot, inverse};

/// How far from a bound or an equation counts as on it, where columns have length one.
const SLACK: f64 = 1e-11;

/// How far from the equations still counts as possible: a thousand times finer than any colour is
/// known, and coarse enough for what rounding does at the very edge.
const POSSIBLE: f64 = 1e-9;

/// Gains below this share of the largest are none.
const NO_GAIN: f64 = 1e-11;

/// Smallest number that is divided by in an exchange.
const SMALLEST_PIVOT: f64 = 1e-9;

/// Exchanges after which the slower rule that cannot go in circles is used.
const PATIENCE: usize = 400;

/// Exchanges after which the place reached is taken as it is.
const MOST_STEPS: usize = 4000;

/// Equations and bounds.
#[derive(Clone, Debug)]
pub(super) struct Programme<const M: usize> {
    /// Of length one each; those of the artificial unknowns stand behind the others.
    columns: Vec<[f64; M]>,
    /// In units of the scaled unknowns.
    upper: Vec<f64>,
    /// What a scaled unknown is divided by; zero for a column that is nothing.
    lengths: Vec<f64>,
    right: [f64; M],
}

/// A corner of what the equations and bounds allow.
#[derive(Clone, Debug)]
pub(super) struct Corner<const M: usize> {
    basis: [usize; M],
    place: Vec<Place>,
    values: [f64; M],
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Place {
    Lower,
    Upper,
    Basic,
}

impl<const M: usize> Programme<M> {
    /// From columns, upper bounds (`f64::INFINITY` for none) and the right side.
    pub(super) fn new(columns: &[[f64; M]], upper: &[f64], right: [f64; M]) -> Self {
        let lengths: Vec<f64> = columns.iter().map(|c| dot(c, c).sqrt()).collect();
        let longest = lengths.iter().copied().fold(0.0, f64::max);
        // What is too weak to be weighed is left alone.
        let lengths: Vec<f64> = lengths
            .into_iter()
            .map(|length| {
                if length > 1e-12 * longest {
                    length
                } else {
                    0.0
                }
            })
            .collect();
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

    /// A corner; `None` where nothing satisfies the equations and bounds. Closes the artificial
    /// unknowns for good.
    pub(super) fn corner(&mut self) -> Option<Corner<M>> {
        let count = self.lengths.len();
        let mut corner = Corner {
            basis: std::array::from_fn(|row| count + row),
            place: vec![Place::Lower; count + M],
            values: self.right.map(f64::abs),
        };
        corner.place[count..].fill(Place::Basic);
        let mut gain = vec![0.0; count + M];
        gain[count..].fill(-1.0);
        self.climb(&mut corner, &gain);
        let size = 1.0 + self.right.iter().fold(0.0, |a, v| v.abs().max(a));
        let rest: f64 = (0..M)
            .filter(|row| corner.basis[*row] >= count)
            .map(|row| corner.values[row].abs())
            .sum();
        self.upper[count..].fill(0.0);
        (rest <= POSSIBLE * size).then_some(corner)
    }

    /// Goes to the corner of the greatest `sum gain_j x_j`; `None` where it grows without bound.
    pub(super) fn maximise(&self, corner: &mut Corner<M>, gain: &[f64]) -> Option<f64> {
        let mut scaled: Vec<f64> = gain
            .iter()
            .zip(&self.lengths)
            .map(|(g, length)| if *length > 0.0 { g / length } else { 0.0 })
            .collect();
        scaled.resize(self.columns.len(), 0.0);
        if !self.climb(corner, &scaled) {
            return None;
        }
        Some(
            self.solution(corner)
                .iter()
                .zip(gain)
                .map(|(x, g)| x * g)
                .sum(),
        )
    }

    /// Goes to the greatest (`sign` 1) or least (-1) value of one unknown and tells it.
    pub(super) fn extreme(&self, corner: &mut Corner<M>, index: usize, sign: f64) -> Option<f64> {
        let length = self.lengths[index];
        if length == 0.0 {
            return None;
        }
        let mut gain = vec![0.0; self.columns.len()];
        gain[index] = sign;
        self.climb(corner, &gain)
            .then(|| self.value(corner, index) / length)
    }

    /// The unknowns at a corner.
    pub(super) fn solution(&self, corner: &Corner<M>) -> Vec<f64> {
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

    fn value(&self, corner: &Corner<M>, index: usize) -> f64 {
        match corner.place[index] {
            Place::Lower => 0.0,
            Place::Upper => self.upper[index],
            Place::Basic => {
                let row = corner.basis.iter().position(|b| *b == index);
                let value = row.map_or(0.0, |row| corner.values[row]);
                value.clamp(0.0, self.upper[index])
            }
        }
    }

    /// Exchanges until nothing gains; false where a gain is without bound.
    fn climb(&self, corner: &mut Corner<M>, gain: &[f64]) -> bool {
        let largest = gain.iter().fold(0.0, |a: f64, g| a.max(g.abs()));
        for step in 0..MOST_STEPS {
            let basis: [[f64; M]; M] =
                std::array::from_fn(|row| corner.basis.map(|b| self.columns[b][row]));
            let Some(inverse) = inverse(&basis) else {
                return true;
            };
            corner.values = self.basic_values(corner, &inverse);
            let mut prices = [0.0; M];
            for (row, line) in inverse.iter().enumerate() {
                add(&mut prices, line, gain[corner.basis[row]]);
            }
            let by_index = step > PATIENCE;
            let Some((entering, sign)) = self.entering(corner, gain, &prices, largest, by_index)
            else {
                return true;
            };
            let column = &self.columns[entering];
            let turn: [f64; M] = std::array::from_fn(|row| sign * dot(&inverse[row], column));
            match self.first_stop(corner, &turn, self.upper[entering]) {
                Stop::Never => return false,
                Stop::Own => {
                    corner.place[entering] = match corner.place[entering] {
                        Place::Lower => Place::Upper,
                        _ => Place::Lower,
                    };
                }
                Stop::At { row, place } => {
                    corner.place[corner.basis[row]] = place;
                    corner.place[entering] = Place::Basic;
                    corner.basis[row] = entering;
                }
            }
        }
        true
    }

    fn basic_values(&self, corner: &Corner<M>, inverse: &[[f64; M]; M]) -> [f64; M] {
        let mut right = self.right;
        for ((column, upper), place) in self.columns.iter().zip(&self.upper).zip(&corner.place) {
            if *place == Place::Upper {
                add(&mut right, column, -upper);
            }
        }
        std::array::from_fn(|row| dot(&inverse[row], &right))
    }

    /// The unknown that gains most by leaving its bound (or the first that gains), and the sense.
    fn entering(
        &self,
        corner: &Corner<M>,
        gain: &[f64],
        prices: &[f64; M],
        largest: f64,
        by_index: bool,
    ) -> Option<(usize, f64)> {
        let mut best = None;
        let mut most = NO_GAIN * largest;
        for (index, place) in corner.place.iter().enumerate() {
            let sign = match place {
                Place::Basic => continue,
                Place::Lower => 1.0,
                Place::Upper => -1.0,
            };
            if self.upper[index] <= 0.0 {
                continue;
            }
            let rise = sign * (gain[index] - dot(prices, &self.columns[index]));
            if rise > most {
                best = Some((index, sign));
                if by_index {
                    return best;
                }
                most = rise;
            }
        }
        best
    }

    /// What stops the unknown that leaves its bound: a basic one, or its own other bound.
    fn first_stop(&self, corner: &Corner<M>, turn: &[f64; M], own: f64) -> Stop {
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
                (corner.values[row], Place::Lower)
            } else {
                (
                    self.upper[corner.basis[row]] - corner.values[row],
                    Place::Upper,
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
    At { row: usize, place: Place },
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
        let is = |found: Option<f64>, value: f64| (found.unwrap() - value).abs() < 1e-14;
        assert!(is(programme.maximise(&mut corner, &[1.0, 1.0, 0.0]), 1.5));
        assert!(is(programme.extreme(&mut corner, 2, 1.0), 1.0));
        assert!(is(programme.extreme(&mut corner, 2, -1.0), 0.5));
        assert!(is(programme.extreme(&mut corner, 0, -1.0), 0.75));
        assert_eq!(programme.solution(&corner).len(), 3);
    }

    #[test]
    fn what_cannot_be_and_what_has_no_end_are_told() {
        let columns = [[1.0], [1.0]];
        assert!(
            Programme::new(&columns, &[1.0; 2], [2.5])
                .corner()
                .is_none()
        );
        assert!(
            Programme::new(&columns, &[1.0; 2], [-0.1])
                .corner()
                .is_none()
        );
        let open = [f64::INFINITY; 2];
        let mut endless = Programme::new(&[[1.0], [-1.0]], &open, [0.0]);
        let mut corner = endless.corner().unwrap();
        assert_eq!(endless.maximise(&mut corner, &[1.0, 0.0]), None);
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
