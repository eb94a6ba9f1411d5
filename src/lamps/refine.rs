//! Moving lines to better places and widths, everything else solved again at each trial.
//!
//! With `Q` an orthonormal basis of all columns, what the others span is `Q` without one direction
//! `w`, so a trial costs the sums of the moved line with `Q` and no new fit; an accepted move turns
//! `Q` so that `w` is its last vector and puts the moved line in its place.

use nalgebra::{DMatrix, DVector};

use super::{
    columns::Columns,
    encoding::WIDTH_NM,
    goals::{GOALS, Goals},
    orthonormal::{Orthonormal, project_out, subtract},
};
use crate::spectrum::{Line, NARROWEST_NM, dot};

/// Steps in place and width, nm.
const STEPS_NM: [f64; 3] = [2.0, 0.8, 0.32];

/// Width that an ideal line widens to, nm.
const WIDENED_NM: f64 = 3.0;

/// Most moves in one direction with one step.
const MOST_MOVES: usize = 3;

/// Least share by which the weighed error must fall.
const LEAST_DROP: f64 = 1e-4;

/// Least share of a moved line's square that must be new.
const LEAST_LEFT: f64 = 1e-10;

/// All columns of a fit with the lines last.
struct State<'a> {
    columns: &'a Columns,
    at: &'a Goals,
    goals: [f64; GOALS],
    /// Orthonormal vectors.
    vectors: Vec<Vec<f64>>,
    /// Sums of each column with the vectors, column by column.
    sums: DMatrix<f64>,
    /// Sums of the target with the vectors.
    target: DVector<f64>,
    rest: Vec<f64>,
    /// Columns before the first line.
    others: usize,
}

/// Refines lines beside `others` (rows as errors of the goals), towards a target, at fixed weights of
/// the goals. Lines keep their order; weights are not looked at.
pub(super) fn refine(
    columns: &Columns,
    at: &Goals,
    others: &[&[f64]],
    lines: &[Line],
    target: &[f64],
    goals: [f64; GOALS],
) -> Vec<Line> {
    let mut lines = lines.to_vec();
    let Some(mut state) = State::new(columns, at, others, &lines, target, goals) else {
        return lines;
    };
    for step_nm in STEPS_NM {
        for (index, line) in lines.iter_mut().enumerate() {
            for is_width in [false, true] {
                for direction in [1.0, -1.0] {
                    state.climb(index, line, is_width, direction * step_nm);
                }
            }
        }
    }
    lines
}

impl<'a> State<'a> {
    fn new(
        columns: &'a Columns,
        at: &'a Goals,
        others: &[&[f64]],
        lines: &[Line],
        target: &[f64],
        goals: [f64; GOALS],
    ) -> Option<Self> {
        let weighed = |column: &[f64]| at.weighed(goals, column);
        let mut basis = Orthonormal::default();
        let mut others_kept = 0;
        for column in others {
            others_kept += usize::from(basis.push(&weighed(column)));
        }
        for line in lines {
            // A line that is the sum of other columns has nothing to be refined by.
            if !basis.push(&weighed(&errors_of(columns, at, *line))) {
                return None;
            }
        }
        let (rest, sums) = basis.rest_of(&weighed(target));
        let n = basis.vectors.len();
        let mut matrix = DMatrix::zeros(n, n);
        for (j, column) in basis.columns.iter().flatten().enumerate() {
            for (i, value) in column.iter().enumerate() {
                matrix[(i, j)] = *value;
            }
        }
        Some(Self {
            columns,
            at,
            goals,
            vectors: basis.vectors,
            sums: matrix,
            target: DVector::from_vec(sums),
            rest,
            others: others_kept,
        })
    }

    /// Moves a line on by a step as long as it helps.
    fn climb(&mut self, index: usize, line: &mut Line, is_width: bool, step_nm: f64) {
        for _ in 0..MOST_MOVES {
            match self.moved(*line, is_width, step_nm) {
                Some(moved) if self.accepts(index, moved) => *line = moved,
                _ => return,
            }
        }
    }

    /// A line one step on; `None` where it would leave the band or not move.
    fn moved(&self, line: Line, is_width: bool, step_nm: f64) -> Option<Line> {
        let band = self.columns.band();
        let mut moved = line;
        if is_width {
            moved.fwhm_nm = if line.is_ideal() {
                if step_nm < 0.0 {
                    return None;
                }
                WIDENED_NM
            } else {
                (line.fwhm_nm + step_nm).min(WIDTH_NM[1])
            };
            if moved.fwhm_nm < NARROWEST_NM {
                moved.fwhm_nm = 0.0;
            }
        } else {
            moved.at_nm = (line.at_nm + step_nm).clamp(band.min_nm(), band.max_nm());
        }
        (moved != line).then_some(moved)
    }

    /// Takes a moved line in when it lowers the weighed error enough.
    fn accepts(&mut self, index: usize, moved: Line) -> bool {
        let place = self.others + index;
        let Some(free) = self.free_direction(place) else {
            return false;
        };
        let column = errors_of(self.columns, self.at, moved);
        let column = self.at.weighed(self.goals, &column);
        let sums = DVector::from_iterator(
            self.vectors.len(),
            self.vectors.iter().map(|v| dot(v, &column)),
        );
        let along = free.dot(&sums);
        let square = dot(&column, &column);
        let new = square - sums.norm_squared() + along * along;
        let freed = free.dot(&self.target);
        let toward = dot(&self.rest, &column) + freed * along;
        let now = dot(&self.rest, &self.rest);
        let then = now + freed * freed - toward * toward / new;
        let enough = (1.0 - LEAST_DROP).powi(2) * now;
        if !(new > LEAST_LEFT * square && then < enough) {
            return false;
        }
        self.replace(place, &free, &column);
        true
    }

    /// The direction, in terms of the vectors, that only this column has.
    fn free_direction(&self, place: usize) -> Option<DVector<f64>> {
        let n = self.vectors.len();
        let mut unit = DVector::zeros(n);
        unit[place] = 1.0;
        let direction = self.sums.clone().transpose().lu().solve(&unit)?;
        let norm = direction.norm();
        (norm.is_finite() && norm > 0.0).then(|| direction / norm)
    }

    /// Puts a column in a place whose own direction is `free`.
    fn replace(&mut self, place: usize, free: &DVector<f64>, column: &[f64]) {
        let n = self.vectors.len();
        // The mirror that takes the last vector to the free direction.
        let mut mirror = free.clone();
        mirror[n - 1] += if free[n - 1] < 0.0 { -1.0 } else { 1.0 };
        let scale = 2.0 / mirror.norm_squared();
        let mut along = vec![0.0; column.len()];
        for (m, vector) in mirror.iter().zip(&self.vectors) {
            subtract(&mut along, -m, vector);
        }
        for (m, vector) in mirror.iter().zip(&mut self.vectors) {
            subtract(vector, scale * m, &along);
        }
        let reflect = |values: &mut DVector<f64>| {
            let sum = scale * mirror.dot(values);
            values.axpy(-sum, &mirror, 1.0);
        };
        for j in 0..n {
            let mut values = self.sums.column(j).into_owned();
            reflect(&mut values);
            self.sums.set_column(j, &values);
        }
        reflect(&mut self.target);
        // The last vector is free now: what it had of the target is left over again.
        subtract(&mut self.rest, -self.target[n - 1], &self.vectors[n - 1]);
        let mut fresh = column.to_vec();
        let mut sums: DVector<f64> = DVector::zeros(n);
        for _ in 0..2 {
            project_out(&self.vectors[..n - 1], &mut fresh, sums.as_mut_slice());
        }
        let length = dot(&fresh, &fresh).sqrt();
        sums[n - 1] = length;
        fresh.iter_mut().for_each(|v| *v /= length);
        // Everything else has nothing of the free direction but rounding.
        for j in 0..n {
            self.sums[(n - 1, j)] = 0.0;
        }
        self.sums.set_column(place, &sums);
        self.target[n - 1] = dot(&fresh, &self.rest);
        subtract(&mut self.rest, self.target[n - 1], &fresh);
        self.vectors[n - 1] = fresh;
    }
}

/// A line of weight 1 as errors of the goals.
pub(super) fn errors_of(columns: &Columns, at: &Goals, line: Line) -> Vec<f64> {
    let shape = line.profile(columns.band());
    at.errors_of(&columns.column(shape.first, &shape.values).rows)
}
