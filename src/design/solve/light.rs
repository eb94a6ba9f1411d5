//! A light of lines as a search has it, and lights of two lines.

use super::line_search::{Found, LineSearch};
use crate::{design::scales::LUMENS_PER_WATT, study::Progress};

/// How densely first places are looked at, places a nm.
const DENSE: usize = 10;

/// A line with its power, Y = 1 for the whole light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Line {
    pub(super) at_nm: f64,
    pub(super) power: f64,
}

/// A light of lines by rising place.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Light {
    pub(super) lines: Vec<Line>,
    pub(super) ler: f64,
    /// The figure, or less than nothing.
    pub(super) worth: f64,
}

impl<const L: usize> From<Found<L>> for Light {
    fn from(found: Found<L>) -> Self {
        let both = found.places.into_iter().zip(found.powers);
        Self {
            lines: both.map(|(at_nm, power)| Line { at_nm, power }).collect(),
            ler: found.ler,
            worth: found.worth,
        }
    }
}

impl LineSearch<'_> {
    /// Every light of two lines of the colour, first places a tenth of a nm apart; `None` when
    /// cancelled.
    pub(super) fn pairs(&self, progress: &Progress) -> Option<Vec<Light>> {
        let (first, last) = (self.first_nm as usize, self.last_nm() as usize);
        let mut all = Vec::new();
        for step in 0..DENSE * (last - first) {
            if progress.is_cancelled() {
                return None;
            }
            let at_nm = self.first_nm + step as f64 / DENSE as f64;
            for nm in at_nm as usize..last {
                all.extend(self.pair(at_nm, nm as f64));
            }
        }
        Some(all)
    }

    /// The light of a line and one within the nm behind `from_nm`; `None` where none has the
    /// colour.
    ///
    /// Both lines and the target lie in one plane: a sum that is straight in the second place.
    fn pair(&self, at_nm: f64, from_nm: f64) -> Option<Light> {
        let target = self.target();
        let one = self.basic_at(at_nm);
        let across = cross(target, one);
        let ends = [from_nm, from_nm + 1.0].map(|nm| dot(across, self.basic_at(nm)));
        let share = ends[0] / (ends[0] - ends[1]);
        let second_nm = from_nm + share;
        if !(0.0..1.0).contains(&share) || second_nm <= at_nm {
            return None;
        }
        let two = self.basic_at(second_nm);
        let normal = cross(one, two);
        let size = dot(normal, normal);
        // target = a one + b two, all three in the plane of that normal.
        let powers = [
            dot(cross(target, two), normal) / size,
            dot(cross(one, target), normal) / size,
        ];
        if !powers.iter().all(|power| *power > 0.0 && power.is_finite()) {
            return None;
        }
        let places = [at_nm, second_nm];
        let worth = self.figure(&self.sums(&places, &powers));
        let both = places.into_iter().zip(powers);
        Some(Light {
            lines: both.map(|(at_nm, power)| Line { at_nm, power }).collect(),
            ler: LUMENS_PER_WATT / (powers[0] + powers[1]),
            worth,
        })
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}
