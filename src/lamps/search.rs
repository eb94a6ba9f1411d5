//! The orthogonal greedy search: which known lamps and which lines lower the weighed error most.
//!
//! Per light, each cosine becomes an orthonormal direction once, and its sums with every column of
//! the pool are formed once. What a chosen column changes follows from its sums with the pool, which
//! are kept too: most makeups choose among the same few columns.

use std::collections::BTreeMap;

use super::{
    columns::{Columns, LEADING},
    fit::score,
    goals::{GOALS, Goals},
    orthonormal::{Orthonormal, subtract},
};
use crate::spectrum::dot;

/// A column of which less than this share of the square is left is not looked at.
const LEAST_LEFT: f64 = 1e-9;

/// Components of an encoding, before places and widths are refined.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Selection {
    /// Smooth numbers.
    pub cosines: usize,
    /// Known lamps, as places in the columns' atoms.
    pub atoms: Vec<usize>,
    /// Lines, as places in the pool.
    pub lines: Vec<usize>,
    /// Linearised score: the less the better.
    pub score: f64,
}

/// Counts of the components of a makeup.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Counts {
    /// Smooth numbers.
    pub cosines: usize,
    /// Known lamps.
    pub atoms: usize,
    /// Lines.
    pub lines: usize,
}

/// Sums of one direction with everything.
#[derive(Clone, Debug)]
struct Sums {
    atoms: Vec<f64>,
    lines: Vec<f64>,
}

impl Sums {
    /// Takes what a direction explains off the squares of all columns and off their sums with the
    /// target, of which the direction has so much.
    fn take_off(&self, target: f64, squares: &mut Self, towards: &mut Self) {
        for (sums, squares, towards) in [
            (&self.atoms, &mut squares.atoms, &mut towards.atoms),
            (&self.lines, &mut squares.lines, &mut towards.lines),
        ] {
            for ((square, toward), sum) in squares.iter_mut().zip(towards).zip(sums) {
                *square -= sum * sum;
                *toward -= target * sum;
            }
        }
    }
}

/// A direction and its sums with everything.
#[derive(Clone, Debug)]
struct Direction {
    vector: Vec<f64>,
    sums: Sums,
    target: f64,
}

/// The chosen column.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Pick {
    Atom(usize),
    Line(usize),
}

impl Pick {
    /// Its entry among the values of all columns.
    fn of(self, sums: &Sums) -> f64 {
        match self {
            Self::Atom(i) => sums.atoms[i],
            Self::Line(i) => sums.lines[i],
        }
    }
}

/// The search for one light at fixed weights of the goals.
pub(super) struct Search<'a> {
    columns: &'a Columns,
    at: &'a Goals,
    goals: [f64; GOALS],
    small: [f64; GOALS],
    /// The known lamps' rows as weighed errors; only those that may be used have any.
    atoms: Vec<Option<Vec<f64>>>,
    /// Directions of the cosines after the leading ones.
    cosines: Vec<Option<Direction>>,
    target: Vec<f64>,
    /// Squares of all columns.
    squares: Sums,
    /// Sums of all columns with the target.
    towards: Sums,
    /// Chosen columns as weighed errors, with their sums with all columns once they were asked for:
    /// nothing is chosen after the last of a makeup.
    chosen: BTreeMap<Pick, (Vec<f64>, Option<Sums>)>,
    /// Kept for the next makeup of as many cosines.
    room: Vec<ResidualState>,
}

/// Residuals of all columns with some cosines projected out.
#[derive(Clone, Debug)]
struct ResidualState {
    cosines: usize,
    squares: Sums,
    towards: Sums,
    rest: Vec<f64>,
}

impl<'a> Search<'a> {
    /// A search towards a target (as errors of the goals); `smooth` are the directions of the
    /// cosines after the leading ones at the same weights. Known lamps that may be used are marked.
    pub(super) fn new(
        columns: &'a Columns,
        at: &'a Goals,
        target: &[f64],
        (goals, small): ([f64; GOALS], [f64; GOALS]),
        usable: &[bool],
        smooth: &Orthonormal,
    ) -> Self {
        let weighed = |rows: &[f64]| at.weighed(goals, &at.errors_of(rows));
        let atoms: Vec<Option<Vec<f64>>> = columns
            .atoms
            .iter()
            .zip(usable)
            .map(|(column, usable)| usable.then(|| weighed(&column.rows)))
            .collect();
        let squares = Sums {
            atoms: atoms
                .iter()
                .map(|a| a.as_ref().map_or(0.0, |a| dot(a, a)))
                .collect(),
            lines: line_squares(columns, at, goals),
        };
        let mut search = Self {
            columns,
            at,
            goals,
            small,
            atoms,
            cosines: Vec::new(),
            towards: Sums {
                atoms: Vec::new(),
                lines: Vec::new(),
            },
            squares,
            target: at.weighed(goals, target),
            chosen: BTreeMap::new(),
            room: Vec::new(),
        };
        search.towards = search.sums_with(&search.target, true);
        let mut vectors = smooth.vectors.iter();
        for column in &smooth.columns {
            let vector = column.as_ref().and_then(|_| vectors.next());
            let direction = vector.map(|vector| Direction {
                sums: search.sums_with(vector, true),
                target: dot(vector, &search.target),
                vector: vector.clone(),
            });
            search.cosines.push(direction);
        }
        search
    }

    /// Sums of all lines, and of all known lamps where they are wanted, with weighed errors.
    fn sums_with(&self, vector: &[f64], with_atoms: bool) -> Sums {
        let weighed = self.at.weighed(self.goals, vector);
        let h = self
            .columns
            .operators
            .adjoint(&self.at.transposed(&weighed));
        // Lamps are chosen before lines, so no line's sums with them are asked for.
        let atoms = self.atoms.iter().filter(|_| with_atoms);
        Sums {
            lines: self.columns.line_sums(&h),
            atoms: atoms
                .map(|a| a.as_ref().map_or(0.0, |a| dot(a, vector)))
                .collect(),
        }
    }

    /// The best makeup of these counts; `None` when the pool has no such columns.
    pub(super) fn makeup(&mut self, counts: Counts) -> Option<Selection> {
        let room = self.room(counts.cosines);
        let (mut squares, mut towards, mut rest) = (room.squares, room.towards, room.rest);
        let mut directions: Vec<Direction> = Vec::new();
        let mut picks: Vec<Pick> = Vec::new();
        for place in 0..counts.atoms + counts.lines {
            let is_atom = place < counts.atoms;
            let pick = self.best(is_atom, &squares, &towards, &picks)?;
            let is_last = place + 1 == counts.atoms + counts.lines;
            let wanted = (place + 1 < counts.atoms, !is_last && counts.lines > 0);
            let direction =
                self.direction(pick, counts.cosines, &directions, pick.of(&squares), wanted);
            let length = pick.of(&squares).sqrt();
            let target = pick.of(&towards) / length;
            direction.sums.take_off(target, &mut squares, &mut towards);
            subtract(&mut rest, target, &direction.vector);
            directions.push(direction);
            picks.push(pick);
        }
        let norms = self.at.norms(&rest);
        let errors = std::array::from_fn(|g| norms[g] / self.goals[g]);
        let (atoms, lines) = picks.split_at(counts.atoms);
        let places = |picks: &[Pick]| {
            let place = |pick: &Pick| match pick {
                Pick::Atom(i) | Pick::Line(i) => *i,
            };
            picks.iter().map(place).collect()
        };
        Some(Selection {
            cosines: counts.cosines,
            atoms: places(atoms),
            lines: places(lines),
            score: score(errors, self.small),
        })
    }

    /// Residuals of all columns with a number of cosines projected out.
    fn room(&mut self, cosines: usize) -> ResidualState {
        if let Some(room) = self.room.iter().find(|room| room.cosines == cosines) {
            return room.clone();
        }
        // From the nearest room with fewer, or from nothing.
        let before = self.room.iter().filter(|room| room.cosines < cosines);
        let mut room = before
            .max_by_key(|room| room.cosines)
            .cloned()
            .unwrap_or(ResidualState {
                cosines: LEADING,
                squares: self.squares.clone(),
                towards: self.towards.clone(),
                rest: self.target.clone(),
            });
        let from = room.cosines - LEADING;
        let to = (cosines.max(LEADING) - LEADING).min(self.cosines.len());
        for direction in self.cosines.get(from..to).unwrap_or(&[]).iter().flatten() {
            let Direction {
                vector,
                sums,
                target,
            } = direction;
            sums.take_off(*target, &mut room.squares, &mut room.towards);
            subtract(&mut room.rest, *target, vector);
        }
        room.cosines = cosines;
        self.room.push(room.clone());
        room
    }

    /// The column that lowers the square of what is left most.
    fn best(&self, is_atom: bool, squares: &Sums, towards: &Sums, picks: &[Pick]) -> Option<Pick> {
        type Of = fn(&Sums) -> &Vec<f64>;
        let (pick, of): (fn(usize) -> Pick, Of) = match is_atom {
            true => (Pick::Atom, |s| &s.atoms),
            false => (Pick::Line, |s| &s.lines),
        };
        let all = of(squares).iter().zip(of(towards)).zip(of(&self.squares));
        let mut best = (0.0, None);
        for (i, ((square, toward), whole)) in all.enumerate() {
            let drop = toward * toward / square;
            if drop > best.0 && *square > LEAST_LEFT * whole && !picks.contains(&pick(i)) {
                best = (drop, Some(pick(i)));
            }
        }
        best.1
    }

    /// The direction that a column adds to those before it; of its sums only those that are wanted
    /// (atoms, lines).
    fn direction(
        &mut self,
        pick: Pick,
        cosines: usize,
        before: &[Direction],
        square: f64,
        wanted: (bool, bool),
    ) -> Direction {
        self.choose(pick, wanted.0 || wanted.1);
        let (vector, sums) = &self.chosen[&pick];
        let smooth = self.cosines.iter().take(cosines.saturating_sub(LEADING));
        let unit = 1.0 / square.sqrt();
        let mut vector = vector.clone();
        let of = |wanted: bool, sums_of: fn(&Sums) -> &Vec<f64>| {
            let all = sums.as_ref().filter(|_| wanted);
            all.map_or_else(Vec::new, |all| sums_of(all).clone())
        };
        let mut sums = Sums {
            atoms: of(wanted.0, |s| &s.atoms),
            lines: of(wanted.1, |s| &s.lines),
        };
        for earlier in smooth.flatten().chain(before) {
            let shared = pick.of(&earlier.sums);
            subtract(&mut vector, shared, &earlier.vector);
            subtract(&mut sums.atoms, shared, &earlier.sums.atoms);
            subtract(&mut sums.lines, shared, &earlier.sums.lines);
        }
        for values in [&mut vector, &mut sums.atoms, &mut sums.lines] {
            values.iter_mut().for_each(|v| *v *= unit);
        }
        Direction {
            vector,
            sums,
            target: 0.0,
        }
    }

    /// Sees to it that a chosen column is known, with its sums where they are wanted.
    fn choose(&mut self, pick: Pick, with_sums: bool) {
        if matches!(self.chosen.get(&pick), Some((_, sums)) if sums.is_some() || !with_sums) {
            return;
        }
        let vector = self.errors_of(pick);
        let is_atom = matches!(pick, Pick::Atom(_));
        let sums = with_sums.then(|| self.sums_with(&vector, is_atom));
        self.chosen.insert(pick, (vector, sums));
    }

    /// A column's weighed errors.
    fn errors_of(&self, pick: Pick) -> Vec<f64> {
        match pick {
            Pick::Atom(i) => self.atoms[i]
                .clone()
                .unwrap_or_else(|| vec![0.0; self.target.len()]),
            Pick::Line(i) => {
                let line = &self.columns.lines[i];
                let rows = self
                    .columns
                    .column(line.first, &self.columns.values_of(line))
                    .rows;
                self.at.weighed(self.goals, &self.at.errors_of(&rows))
            }
        }
    }
}

/// Squares of the pool's lines, colour by colour over all lines.
fn line_squares(columns: &Columns, at: &Goals, goals: [f64; GOALS]) -> Vec<f64> {
    let (forms, blur) = at.squares(goals);
    let mut squares: Vec<f64> = columns.line_blurs.iter().map(|b| b * blur).collect();
    for (rows, h) in columns.line_colours.chunks_exact(3).zip(&forms) {
        let [x, y, z] = [&rows[0], &rows[1], &rows[2]];
        for (i, square) in squares.iter_mut().enumerate() {
            let (x, y, z) = (x[i], y[i], z[i]);
            *square +=
                x * (h[0] * x + h[3] * y + h[4] * z) + y * (h[1] * y + h[5] * z) + h[2] * z * z;
        }
    }
    squares
}
