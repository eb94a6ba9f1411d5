//! Lines that move: the best places.
//!
//! From starts a pattern of ever smaller moves leads to where no move helps: with four lines moves
//! of one and of two at once; with three, which have no share left to meet the floor of efficacy
//! with, moves along the surface of places of that very efficacy.

use super::{
    against::Against,
    light::cross,
    line_search::{Found, LineSearch},
};
use crate::design::scales::LUMENS_PER_WATT;

/// Moves of one of four lines, nm.
const MOVES_NM: [f64; 3] = [6.0, 3.0, 1.5];

/// Moves of one or two of four lines, nm, once one at a time lead no further.
const PAIRS_NM: [f64; 2] = [1.0, 0.5];

/// Moves of three lines, nm.
const SLIDES_NM: [f64; 7] = [8.0, 4.0, 2.0, 1.0, 0.5, 0.2, 0.05];

/// Starts of four lines that are followed; Rf costs fifty times Ra.
const STARTS_RF: usize = 4;
const STARTS_RA: usize = 12;

/// How far a neighbour may be behind to be followed.
const NEARLY: f64 = 0.3;

/// Directions along the surface of one efficacy.
const DIRECTIONS: usize = 8;

/// Turns of the way back to the surface.
const MOST_TURNS: usize = 6;

impl LineSearch<'_> {
    /// The best of some starts, lines moved until no move helps: the three that begin best go
    /// their way, the one that ends best goes on in small moves.
    pub(super) fn best_of<const L: usize>(
        &self,
        starts: &[[f64; L]],
        floor: f64,
    ) -> Option<Found<L>> {
        let begun = starts
            .iter()
            .filter_map(|s| self.best(*s, floor, f64::NEG_INFINITY));
        let mut begun: Vec<Found<L>> = begun.collect();
        begun.sort_by(|a, b| b.worth.total_cmp(&a.worth));
        if L > 3 {
            begun.truncate(if self.against == Against::Ra {
                STARTS_RA
            } else {
                STARTS_RF
            });
        }
        let mut best: Option<Found<L>> = None;
        for mut found in begun {
            if L == 3 {
                SLIDES_NM
                    .iter()
                    .for_each(|step| self.slide(&mut found, floor, *step));
            } else {
                self.walk(&mut found, floor, &MOVES_NM, false);
            }
            if best.as_ref().is_none_or(|best| found.worth > best.worth) {
                best = Some(found);
            }
        }
        let mut best = best?;
        self.polish(&mut best, floor);
        Some(best)
    }

    /// The same light, or one of others (of other floors) where that is better here, in small moves.
    pub(super) fn bettered<const L: usize>(
        &self,
        own: Option<&Found<L>>,
        others: &[[f64; L]],
        floor: f64,
    ) -> Option<Found<L>> {
        let least = own.map_or(f64::NEG_INFINITY, |own| own.worth);
        let found = others
            .iter()
            .filter_map(|places| self.best(*places, floor, least));
        let better = found.fold(None, |best: Option<Found<L>>, found| match best {
            Some(best) if best.worth >= found.worth => Some(best),
            _ => Some(found),
        });
        // A neighbour that is a little behind may lead past.
        match better.filter(|found| found.worth > least - NEARLY) {
            Some(mut found) => {
                if L == 3 {
                    SLIDES_NM
                        .iter()
                        .for_each(|step| self.slide(&mut found, floor, *step));
                }
                self.polish(&mut found, floor);
                Some(found)
                    .filter(|found| found.worth > least)
                    .or_else(|| own.cloned())
            }
            None => own.cloned(),
        }
    }

    fn polish<const L: usize>(&self, best: &mut Found<L>, floor: f64) {
        if L > 3 {
            self.walk(best, floor, &PAIRS_NM, true);
        }
    }

    fn walk<const L: usize>(&self, best: &mut Found<L>, floor: f64, steps: &[f64], pairs: bool) {
        let changes = changes::<L>(pairs);
        for step in steps {
            loop {
                let before = best.worth;
                for change in &changes {
                    // The same move goes on while it helps.
                    while self.moved(best, floor, change, *step) {}
                }
                if best.worth <= before + 1e-4 {
                    break;
                }
            }
        }
    }

    /// Whether a move makes it better; if so it is made.
    fn moved<const L: usize>(
        &self,
        best: &mut Found<L>,
        floor: f64,
        change: &[f64; L],
        step: f64,
    ) -> bool {
        let move_one = |i: usize| best.places[i] + step * change[i];
        let places: [f64; L] =
            std::array::from_fn(|i| move_one(i).clamp(self.first_nm, self.last_nm()));
        if places.windows(2).any(|w| w[0] > w[1]) {
            return false;
        }
        match self.best(places, floor, best.worth) {
            Some(found) if found.worth > best.worth + 1e-9 => {
                *best = found;
                true
            }
            _ => false,
        }
    }

    /// Efficacy of lines whose shares are fixed by the colour; zero where they cannot have it.
    fn efficacy<const L: usize>(&self, places: [f64; L]) -> f64 {
        let ends = self.ends(places);
        ends.map_or(0.0, |[first, _]| LUMENS_PER_WATT / Self::power(&first))
    }

    /// Moves along the surface of places of one efficacy, and off it, while that helps.
    fn slide<const L: usize>(&self, best: &mut Found<L>, floor: f64, step: f64) {
        const TURN: f64 = std::f64::consts::TAU / DIRECTIONS as f64;
        loop {
            let Some(normal) = self.normal(best.places) else {
                return;
            };
            let [first, second] = across(normal);
            let mut changes: Vec<[f64; L]> = (0..DIRECTIONS)
                .map(|turn| {
                    let (sin, cos) = (turn as f64 * TURN).sin_cos();
                    std::array::from_fn(|i| cos * first[i] + sin * second[i])
                })
                .collect();
            changes.extend([normal, normal.map(|v| -v)]);
            let mut helped = false;
            for change in &changes {
                let to: [f64; L] = std::array::from_fn(|i| best.places[i] + step * change[i]);
                let Some(places) = self.lifted(to, floor) else {
                    continue;
                };
                let found = self.best(places, floor, best.worth);
                if let Some(found) = found.filter(|found| found.worth > best.worth + 1e-7) {
                    *best = found;
                    helped = true;
                }
            }
            if !helped {
                return;
            }
        }
    }

    /// The direction in which efficacy grows fastest, of length one.
    fn normal<const L: usize>(&self, places: [f64; L]) -> Option<[f64; L]> {
        const STEP_NM: f64 = 0.02;
        let here = self.efficacy(places);
        let mut slope = [0.0; L];
        for i in 0..L {
            let side = |sign: f64| {
                let mut there = places;
                there[i] += sign * STEP_NM;
                let inside = (self.first_nm..=self.last_nm()).contains(&there[i]);
                Some(self.efficacy(there)).filter(|ler| inside && *ler > 0.0)
            };
            slope[i] = match (side(1.0), side(-1.0)) {
                (Some(up), Some(down)) => 0.5 * (up - down),
                (Some(up), None) => up - here,
                (None, Some(down)) => here - down,
                (None, None) => 0.0,
            };
        }
        let length = slope.iter().map(|v| v * v).sum::<f64>().sqrt();
        (length > 0.0 && length.is_finite()).then(|| slope.map(|v| v / length))
    }

    /// Places that reach the floor near to these; `None` where there are none at hand.
    fn lifted<const L: usize>(&self, mut places: [f64; L], floor: f64) -> Option<[f64; L]> {
        let ends = [self.first_nm, self.last_nm()];
        for _ in 0..MOST_TURNS {
            places = places.map(|nm| nm.clamp(ends[0], ends[1]));
            if places.windows(2).any(|w| w[0] > w[1]) {
                return None;
            }
            let here = self.efficacy(places);
            if here <= 0.0 {
                return None;
            }
            if here >= floor {
                return Some(places);
            }
            let normal = self.normal(places)?;
            let ahead = self.efficacy::<L>(std::array::from_fn(|i| places[i] + 0.05 * normal[i]));
            let slope = (ahead - here) / 0.05;
            // A trifle more than needed, so that the turns end.
            let needed = 1.02 * (floor - here) / slope + 1e-9;
            if !(0.0..20.0).contains(&needed) {
                return None;
            }
            (0..L).for_each(|i| places[i] += needed * normal[i]);
        }
        None
    }
}

/// Two directions of length one square to a third and to each other (the first three places).
fn across<const L: usize>(normal: [f64; L]) -> [[f64; L]; 2] {
    let n = [normal[0], normal[1], normal[2]];
    let least = (0..3).fold(0, |least, i| {
        if n[i].abs() < n[least].abs() {
            i
        } else {
            least
        }
    });
    let mut first = [0.0; 3];
    first[least] = 1.0;
    let along = n[least];
    (0..3).for_each(|i| first[i] -= along * n[i]);
    let length = first.iter().map(|v| v * v).sum::<f64>().sqrt();
    first = first.map(|v| v / length);
    let second = cross(n, first);
    [first, second].map(|v| std::array::from_fn(|i| if i < 3 { v[i] } else { 0.0 }))
}

/// One line to either side; with `pairs` also every two lines.
fn changes<const L: usize>(pairs: bool) -> Vec<[f64; L]> {
    let mut all = Vec::new();
    for i in 0..L {
        for sign in [1.0, -1.0] {
            let mut change = [0.0; L];
            change[i] = sign;
            all.push(change);
            for j in (i + 1..L).filter(|_| pairs) {
                for other in [1.0, -1.0] {
                    let mut both = change;
                    both[j] = other;
                    all.push(both);
                }
            }
        }
    }
    all
}
