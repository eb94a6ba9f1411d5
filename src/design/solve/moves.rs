//! The best lights of lines: starts, lines that join where they help most, then moves of places and
//! powers while they help.
//!
//! Every move is followed by the smallest change that brings the colour back, and the floor of
//! efficacy where that was left ([`LineSearch::judged`]): so moves slide along both.

use super::light::{Light, Line, LineSearch, PLACE_NM};

/// Distance of the places at which a new line is tried, nm.
const GRID_NM: usize = 10;

/// Power that a new line is tried with, share of the whole.
const NEW_POWERS: [f64; 2] = [0.03, 0.12];

/// Half the distance of two lines that one is split into, nm.
const SPLITS_NM: [f64; 2] = [3.0, 8.0];

/// Starts that are followed.
const STARTS: usize = 8;

/// Lights that are kept beside the best: what a further line joins.
const KEPT: usize = 3;

/// Moves of one line, nm; a power moves by the same share of itself as of [`PLACE_NM`].
const MOVES_NM: [f64; 5] = [4.0, 2.0, 1.0, 0.4, 0.1];

/// Moves of two lines at once, for what came out best, nm.
const PAIRS_NM: [f64; 2] = [1.0, 0.3];

/// A gain of the figure that a move is made for.
const LEAST_GAIN: f64 = 1e-4;

/// A gain of the figure that is worth another round.
const GAIN: f64 = 2e-3;

impl LineSearch<'_> {
    /// Lights with one line more than a light: one anywhere, or two in the place of one.
    pub(super) fn with_one_more(&self, light: &Light, floor: f64) -> Vec<Light> {
        let whole = Light::power(&light.lines);
        let (first, last) = (self.first_nm as usize, self.last_nm() as usize);
        let judged = |mut lines: Vec<Line>, at_nm: f64, power: f64| {
            let place = lines.partition_point(|line| line.at_nm < at_nm);
            lines.insert(place, Line { at_nm, power });
            self.judged(&lines, floor, true)
        };
        let better = |found: [Option<Light>; 2]| {
            let found = found.into_iter().flatten();
            found.max_by(|a, b| a.worth.total_cmp(&b.worth))
        };
        let joined = |nm: usize| {
            let lines = || light.lines.clone();
            better(NEW_POWERS.map(|share| judged(lines(), nm as f64, share * whole)))
        };
        let split = |index: usize| {
            let Line { at_nm, power } = light.lines[index];
            better(SPLITS_NM.map(|by_nm| {
                let mut lines = light.lines.clone();
                lines[index] = Line {
                    at_nm: at_nm - by_nm,
                    power: 0.5 * power,
                };
                judged(lines, at_nm + by_nm, 0.5 * power)
            }))
        };
        let places = (first..=last).step_by(GRID_NM).filter_map(joined);
        places
            .chain((0..light.lines.len()).filter_map(split))
            .collect()
    }

    /// The best of what the best starts lead to, and of lights that were found before; the first of
    /// them with moves of two lines at once.
    pub(super) fn best_of(
        &self,
        before: &[Light],
        mut starts: Vec<Light>,
        floor: f64,
    ) -> Vec<Light> {
        starts.sort_by(|a, b| b.worth.total_cmp(&a.worth));
        starts.truncate(STARTS);
        for start in &mut starts {
            for step in MOVES_NM {
                self.settled(start, floor, step);
            }
        }
        let mut all = before.to_vec();
        all.append(&mut starts);
        all.sort_by(|a, b| b.worth.total_cmp(&a.worth));
        all.dedup();
        all.truncate(KEPT);
        if let Some(best) = all.first_mut().filter(|best| before.first() != Some(best)) {
            for step in PAIRS_NM {
                self.polished(best, floor, step);
            }
        }
        all
    }

    /// Moves places and powers one at a time, and then all of them on the way that they went, while
    /// that helps (R. Hooke and T. A. Jeeves, "Direct search", Journal of the ACM 8 (1961) 212-229).
    fn settled(&self, light: &mut Light, floor: f64, step: f64) {
        loop {
            let before = light.clone();
            for index in 0..light.lines.len() {
                for step in [step, -step] {
                    while self.changed(light, floor, |lines| lines[index].at_nm += step) {}
                    let factor = 1.0 + step / PLACE_NM;
                    while self.changed(light, floor, |lines| lines[index].power *= factor) {}
                }
            }
            let mut from = before.lines;
            loop {
                let here = light.lines.clone();
                let ahead = |lines: &mut [Line]| {
                    for (line, from) in lines.iter_mut().zip(&from) {
                        line.at_nm += line.at_nm - from.at_nm;
                        if from.power > 0.0 {
                            line.power *= (line.power / from.power).clamp(0.5, 2.0);
                        }
                    }
                };
                if !self.changed(light, floor, ahead) {
                    break;
                }
                from = here;
            }
            if light.worth <= before.worth + GAIN {
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
                        self.changed(light, floor, |lines| {
                            lines[first].at_nm += a * step;
                            lines[second].at_nm += b * step;
                        });
                    }
                }
            }
            self.settled(light, floor, step);
            if light.worth <= before + GAIN {
                return;
            }
        }
    }

    /// True if a change of its lines improves the light; the change is then applied.
    fn changed(&self, light: &mut Light, floor: f64, change: impl Fn(&mut [Line])) -> bool {
        let mut lines = light.lines.clone();
        change(&mut lines);
        let within = self.first_nm..=self.last_nm();
        let is_sound = lines.iter().all(|line| within.contains(&line.at_nm));
        if !is_sound || !lines.is_sorted_by(|a, b| a.at_nm <= b.at_nm) {
            return false;
        }
        match self.judged(&lines, floor, true) {
            Some(found) if found.worth > light.worth + LEAST_GAIN => {
                *light = found;
                true
            }
            _ => false,
        }
    }
}
