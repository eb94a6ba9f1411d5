//! A net over all places of lines.

use super::{best::next_set, line_search::LineSearch};
use crate::{
    design::scales::LUMENS_PER_WATT,
    study::{Progress, in_parallel, processors},
};

/// Places that lines may have, nm.
pub(super) const RANGE_NM: [f64; 2] = [400.0, 700.0];

/// Starts from the net for each floor.
const STARTS: usize = 8;

/// Starts that are nearer than this in every line end at the same light, nm.
const NEAR_NM: f64 = 6.0;

/// Classes of efficacy among which the net keeps its best.
const CLASSES: usize = 64;

/// Greatest efficacy of the classes, lm/W.
const GREATEST_LER: f64 = LUMENS_PER_WATT;

/// The best of a net over all places, by class of efficacy.
pub(super) struct Net<const L: usize> {
    classes: Vec<Vec<(f64, [f64; L])>>,
}

impl<const L: usize> Net<L> {
    pub(super) fn new() -> Self {
        Self {
            classes: vec![Vec::new(); CLASSES],
        }
    }

    fn take(&mut self, ler: f64, figure: f64, places: [f64; L]) {
        let class = (ler / GREATEST_LER * CLASSES as f64) as usize;
        let class = &mut self.classes[class.min(CLASSES - 1)];
        let at = class.partition_point(|(old, _)| *old >= figure);
        if at < STARTS && !class[..at].iter().any(|(_, old)| *old == places) {
            class.insert(at, (figure, places));
            class.truncate(STARTS);
        }
    }

    /// The best lights at a floor, of each class first its own best.
    pub(super) fn starts(&self, floor: f64) -> Vec<[f64; L]> {
        let first = (floor / GREATEST_LER * CLASSES as f64) as usize;
        let above = self.classes.iter().skip(first.min(CLASSES - 1));
        let mut all: Vec<(f64, [f64; L])> = above.flatten().copied().collect();
        // Equal figures keep the order of the net.
        all.sort_by(|a, b| b.0.total_cmp(&a.0));
        let mut starts: Vec<[f64; L]> = Vec::new();
        for (_, places) in all {
            // Neighbours of a start end where it does.
            let near = |old: &[f64; L]| {
                old.iter()
                    .zip(&places)
                    .all(|(a, b)| (a - b).abs() <= NEAR_NM)
            };
            if !starts.iter().any(near) {
                starts.push(places);
            }
            if starts.len() == STARTS {
                break;
            }
        }
        starts
    }
}

/// Looks at a net over all places; `None` when cancelled.
pub(super) fn net_of<const L: usize>(
    search: &LineSearch<'_>,
    progress: &Progress,
) -> Option<Net<L>> {
    let (step, shares) = if L == 3 { (4, 1) } else { (10, 5) };
    let whole = RANGE_NM[0] as u32..=RANGE_NM[1] as u32;
    let places: Vec<f64> = whole.step_by(step).map(f64::from).collect();
    let parts = places.len();
    let one = |first: &usize| {
        let first = *first;
        let mut net = Net::<L>::new();
        let mut rest: Vec<usize> = (first + 1..first + L).collect();
        while rest.last().is_some_and(|last| *last < parts) && !progress.is_cancelled() {
            let chosen: [f64; L] =
                std::array::from_fn(|i| places[if i == 0 { first } else { rest[i - 1] }]);
            search.look(chosen, shares, |ler, figure| net.take(ler, figure, chosen));
            // The next set behind the first place.
            if !next_set(&mut rest, parts) {
                break;
            }
        }
        net
    };
    // The steps that are counted are those of the floors.
    let firsts: Vec<usize> = (0..parts).collect();
    let nets = in_parallel(&firsts, processors(), &Progress::default(), one)?;
    let mut whole = Net::new();
    for net in nets {
        for (class, found) in net.classes.into_iter().enumerate() {
            let ler = (class as f64 + 0.5) / CLASSES as f64 * GREATEST_LER;
            found
                .into_iter()
                .for_each(|(figure, places)| whole.take(ler, figure, places));
        }
    }
    (!progress.is_cancelled()).then_some(whole)
}
