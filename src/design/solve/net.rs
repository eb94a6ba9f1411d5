//! A net over all places of two or three lines.

use super::{
    best::next_set,
    light::{Light, Line, LineSearch},
};
use crate::{
    design::scales::LUMENS_PER_WATT,
    study::{Progress, in_parallel, processors},
};

/// Distance of the places of the net, nm.
const STEP_NM: usize = 4;

/// Starts from the net for each floor.
const STARTS: usize = 8;

/// Starts that are nearer than this in every line end at the same light, nm.
const NEAR_NM: f64 = 6.0;

/// Classes of efficacy, up to [`LUMENS_PER_WATT`], among which the net keeps its best.
const CLASSES: usize = 64;

fn class_of(ler: f64) -> usize {
    ((ler / LUMENS_PER_WATT * CLASSES as f64) as usize).min(CLASSES - 1)
}

/// The best lights of a net over all places, by class of efficacy.
pub(super) struct Net {
    classes: Vec<Vec<Light>>,
}

impl Default for Net {
    fn default() -> Self {
        Self {
            classes: vec![Vec::new(); CLASSES],
        }
    }
}

impl Net {
    fn take(&mut self, light: Light) {
        let class = &mut self.classes[class_of(light.ler)];
        let at = class.partition_point(|old| old.worth >= light.worth);
        if at < STARTS && !class.contains(&light) {
            class.insert(at, light);
            class.truncate(STARTS);
        }
    }

    /// The best lights at a floor, apart from each other.
    pub(super) fn starts(&self, floor: f64) -> Vec<&Light> {
        let mut all: Vec<&Light> = self.classes[class_of(floor)..].iter().flatten().collect();
        // Equal figures keep the order of the net.
        all.sort_by(|a, b| b.worth.total_cmp(&a.worth));
        let mut starts: Vec<&Light> = Vec::new();
        for light in all {
            let is_near = |old: &&Light| {
                let mut both = old.lines.iter().zip(&light.lines);
                both.all(|(a, b)| (a.at_nm - b.at_nm).abs() <= NEAR_NM)
            };
            if starts.len() < STARTS && !starts.iter().any(is_near) {
                starts.push(light);
            }
        }
        starts
    }
}

/// Looks at a net over all places of two or three lines; `None` when cancelled.
pub(super) fn net_of(search: &LineSearch<'_>, count: usize, progress: &Progress) -> Option<Net> {
    let whole = search.first_nm as usize..=search.last_nm() as usize;
    let places: Vec<f64> = whole.step_by(STEP_NM).map(|nm| nm as f64).collect();
    let one = |first: &usize| {
        let mut net = Net::default();
        let mut rest: Vec<usize> = (first + 1..first + count).collect();
        while rest.last().is_some_and(|last| *last < places.len()) && !progress.is_cancelled() {
            let line = |index: &usize| Line {
                at_nm: places[*index],
                power: 1.0,
            };
            let lines: Vec<Line> = std::iter::once(first).chain(&rest).map(line).collect();
            // Two lines have the colour at few places alone.
            if let Some(light) = search.judged(&lines, 0.0, count == 2) {
                net.take(light);
            }
            if !next_set(&mut rest, places.len()) {
                break;
            }
        }
        net
    };
    // The steps that are counted are those of the floors.
    let firsts: Vec<usize> = (0..places.len()).collect();
    let nets = in_parallel(&firsts, processors(), &Progress::default(), one)?;
    let mut whole = Net::default();
    let lights = nets.into_iter().flat_map(|net| net.classes).flatten();
    lights.for_each(|light| whole.take(light));
    (!progress.is_cancelled()).then_some(whole)
}
