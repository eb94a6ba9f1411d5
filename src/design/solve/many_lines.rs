//! Five lines and more: a line joins a light where it helps most, then all move.
//!
//! Powers of so many lines are free but for the colour. Every move of a place or a power is followed
//! by the smallest change of the powers, each weighed by itself, that brings the colour back, and
//! the floor of efficacy where that was left: so moves slide along both.

use super::{
    light::{Light, Line},
    line_search::LineSearch,
};
use crate::design::{scales::LUMENS_PER_WATT, small::solved};

/// Distance of the places at which a new line is tried, nm.
const GRID_NM: usize = 10;

/// Power that a new line is tried with, share of the whole.
const NEW_POWERS: [f64; 2] = [0.03, 0.12];

/// Places that are followed.
const STARTS: usize = 3;

/// Moves of one line, nm; a power moves by a twelfth of that, as a share of itself.
const MOVES_NM: [f64; 5] = [4.0, 2.0, 1.0, 0.4, 0.1];

/// Moves of two lines at once, for what came out best, nm.
const PAIRS_NM: [f64; 2] = [1.0, 0.3];

/// A gain of the figure that a move is made for.
const LEAST_GAIN: f64 = 1e-4;

/// A gain of the figure that is worth another round.
const GAIN: f64 = 2e-3;

/// How far a sum may be from its target, Y = 1: lines that nearly coincide have none.
const ROUNDING: f64 = 1e-11;

/// Turns of the repair: each leaves out lines whose power would turn negative.
const MOST_TURNS: usize = 4;

impl LineSearch<'_> {
    /// The light with one line more, as good as it can be made; the same light where none helps.
    pub(super) fn with_one_more(&self, light: &Light, floor: f64) -> Light {
        let whole: f64 = light.lines.iter().map(|line| line.power).sum();
        let mut tried: Vec<Light> = Vec::new();
        let (first, last) = (self.first_nm as usize, self.last_nm() as usize);
        for nm in (first..=last).step_by(GRID_NM) {
            let at_nm = nm as f64;
            let with = NEW_POWERS.iter().filter_map(|share| {
                let mut lines = light.lines.clone();
                let place = lines.partition_point(|line| line.at_nm < at_nm);
                let power = share * whole;
                lines.insert(place, Line { at_nm, power });
                self.judged(lines, floor)
            });
            tried.extend(with.max_by(|a, b| a.worth.total_cmp(&b.worth)));
        }
        tried.sort_by(|a, b| b.worth.total_cmp(&a.worth));
        tried.truncate(STARTS);
        let mut best = light.clone();
        for mut start in tried {
            for step in MOVES_NM {
                self.settled(&mut start, floor, step);
            }
            if start.worth > best.worth {
                best = start;
            }
        }
        for step in PAIRS_NM {
            self.polished(&mut best, floor, step);
        }
        best
    }

    /// Moves places and powers one at a time while that helps.
    fn settled(&self, light: &mut Light, floor: f64, step: f64) {
        loop {
            let before = light.worth;
            for index in 0..light.lines.len() {
                for sign in [1.0, -1.0] {
                    let place = |line: &mut Line| line.at_nm += sign * step;
                    while self.changed(light, floor, &[index], &place) {}
                    let power = |line: &mut Line| line.power *= 1.0 + sign * step / 12.0;
                    while self.changed(light, floor, &[index], &power) {}
                }
            }
            if light.worth <= before + GAIN {
                return;
            }
        }
    }

    /// Moves every two lines together, apart and in one direction, while that helps.
    fn polished(&self, light: &mut Light, floor: f64, step: f64) {
        loop {
            let before = light.worth;
            let count = light.lines.len();
            for first in 0..count {
                for second in first + 1..count {
                    for [a, b] in [[1.0, 1.0], [-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0]] {
                        let middle = light.lines[second].at_nm;
                        let both = |line: &mut Line| {
                            let sign = if line.at_nm < middle { a } else { b };
                            line.at_nm += sign * step;
                        };
                        self.changed(light, floor, &[first, second], &both);
                    }
                }
            }
            self.settled(light, floor, step);
            if light.worth <= before + GAIN {
                return;
            }
        }
    }

    /// Whether a change of some lines makes the light better; if so it is made.
    fn changed(
        &self,
        light: &mut Light,
        floor: f64,
        which: &[usize],
        change: &dyn Fn(&mut Line),
    ) -> bool {
        let mut lines = light.lines.clone();
        for index in which {
            change(&mut lines[*index]);
            let within = self.first_nm..=self.last_nm();
            if !within.contains(&lines[*index].at_nm) {
                return false;
            }
        }
        if lines.windows(2).any(|two| two[0].at_nm > two[1].at_nm) {
            return false;
        }
        match self.judged(lines, floor) {
            Some(found) if found.worth > light.worth + LEAST_GAIN => {
                *light = found;
                true
            }
            _ => false,
        }
    }

    /// Lines with powers that have the colour and the floor; `None` where they cannot have them.
    fn judged(&self, mut lines: Vec<Line>, floor: f64) -> Option<Light> {
        let most = match floor > 0.0 {
            true => LUMENS_PER_WATT / floor,
            false => f64::INFINITY,
        };
        let columns: Vec<[f64; 3]> = lines.iter().map(|line| self.basic_at(line.at_nm)).collect();
        let [x, y, z] = self.target();
        self.repaired(&mut lines, |i| columns[i], [x, y, z])?;
        let power = |lines: &[Line]| -> f64 { lines.iter().map(|line| line.power).sum() };
        if power(&lines) > most {
            let column = |i: usize| {
                let [x, y, z] = columns[i];
                [x, y, z, 1.0]
            };
            self.repaired(&mut lines, column, [x, y, z, most])?;
        }
        let places: Vec<f64> = lines.iter().map(|line| line.at_nm).collect();
        let powers: Vec<f64> = lines.iter().map(|line| line.power).collect();
        let worth = self.figure(&self.sums(&places, &powers));
        let ler = LUMENS_PER_WATT / power(&lines);
        Some(Light { lines, ler, worth })
    }

    /// Changes powers, each weighed by itself, until their columns sum up to the target; `None`
    /// where that takes powers below zero or to no end.
    fn repaired<const M: usize>(
        &self,
        lines: &mut [Line],
        column: impl Fn(usize) -> [f64; M],
        target: [f64; M],
    ) -> Option<()> {
        for _ in 0..MOST_TURNS {
            let mut matrix = [[0.0; M]; M];
            let mut missing = target;
            for (index, line) in lines.iter().enumerate() {
                let column = column(index);
                for row in 0..M {
                    missing[row] -= line.power * column[row];
                    (0..M).for_each(|k| matrix[row][k] += line.power * column[row] * column[k]);
                }
            }
            let towards = solved(matrix, missing)?;
            let mut is_whole = true;
            for (index, line) in lines.iter_mut().enumerate() {
                let both = column(index).into_iter().zip(towards);
                line.power *= 1.0 + both.map(|(a, b)| a * b).sum::<f64>();
                if !line.power.is_finite() {
                    return None;
                }
                if line.power < 0.0 {
                    line.power = 0.0;
                    is_whole = false;
                }
            }
            if is_whole {
                return met(lines, &column, target).then_some(());
            }
        }
        None
    }
}

/// Whether the columns of lines sum up to the target.
fn met<const M: usize>(
    lines: &[Line],
    column: impl Fn(usize) -> [f64; M],
    target: [f64; M],
) -> bool {
    let mut missing = target;
    for (index, line) in lines.iter().enumerate() {
        let column = column(index);
        (0..M).for_each(|k| missing[k] -= line.power * column[k]);
    }
    missing.iter().all(|v| v.abs() < ROUNDING)
}
