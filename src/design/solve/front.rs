//! The trade between luminous efficacy and colour rendering, with lines that are free to move.
//!
//! A net over all places (4 nm for three lines, 10 nm for four) is looked at once; for each floor of
//! efficacy the best of the net are moved to where no move helps, then what the neighbouring floors
//! found is tried. Floors are shared out among threads and each is its own search, so that the result is
//! the same bits whatever their number.

use std::{
    sync::atomic::{AtomicUsize, Ordering},
    thread,
};

use super::{
    against::Against,
    figures::MixFigures,
    line_search::{Found, LineSearch},
    polytope::Polytope,
    target::Target,
};
use crate::{
    design::{
        mixture::MixError,
        scales::{SampleTables, Scales, Sums, basic_of_line},
    },
    study::Progress,
};

/// Places that lines may have, nm.
const RANGE_NM: [f64; 2] = [400.0, 700.0];

/// Starts from the net for each floor.
const STARTS: usize = 8;

/// Starts that are nearer than this in every line end at the same light, nm.
const NEAR_NM: f64 = 6.0;

/// Classes of efficacy among which the net keeps its best.
const CLASSES: usize = 64;

/// Greatest efficacy of the classes, lm/W.
const GREATEST_LER: f64 = 683.0;

/// Which front is wanted.
#[derive(Clone, Debug, PartialEq)]
pub struct FrontWish {
    /// The colour of every light.
    pub target: Target,
    /// The figure.
    pub against: Against,
    /// Lines of each light, 3 or 4.
    pub lines: usize,
    /// Points, 2 to 100, between the best of the figure and the greatest efficacy.
    pub points: usize,
    /// Floors of efficacy instead of even ones, lm/W.
    pub floors: Option<Vec<f64>>,
}

/// A line of a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrontLine {
    /// Its place.
    pub at_nm: f64,
    /// Its share of the power.
    pub share_of_power: f64,
}

/// A light of the front.
#[derive(Clone, Debug, PartialEq)]
pub struct FrontPoint {
    /// The floor of efficacy it was sought at, lm/W.
    pub floor: f64,
    /// Its lines by rising place; those without power are left out.
    pub lines: Vec<FrontLine>,
    /// Its figures.
    pub figures: MixFigures,
}

/// The front by rising efficacy; `None` when cancelled. With even floors a light that another one
/// beats in both is left out.
///
/// # Errors
/// [`MixError::Channels`] for other numbers of lines than 3 and 4, [`MixError::Target`] for a
/// colour without a temperature (no figure) or outside of what lines can show.
pub fn front(
    wish: &FrontWish,
    tables: &SampleTables,
    progress: &Progress,
) -> Result<Option<Vec<FrontPoint>>, MixError> {
    match wish.lines {
        3 => front_of::<3>(wish, tables, progress),
        4 => front_of::<4>(wish, tables, progress),
        found => Err(MixError::Channels { found }),
    }
}

fn front_of<const L: usize>(
    wish: &FrontWish,
    tables: &SampleTables,
    progress: &Progress,
) -> Result<Option<Vec<FrontPoint>>, MixError> {
    let refused = |expected: &str| MixError::Target {
        found: wish.target.to_string(),
        expected: expected.to_owned(),
    };
    let xyz = wish.target.xyz();
    let scales = Scales::new(xyz, tables).ok_or_else(|| {
        refused("a colour near the blackbody locus, where Ra and Rf have a meaning")
    })?;
    let target = (xyz * 0.01).to_array();
    let (greatest, brightest) = greatest_ler(target)
        .ok_or_else(|| refused("a colour that lines of 400-700 nm can show"))?;
    let search = LineSearch::new(RANGE_NM, target, wish.against, tables, &scales);
    let points = wish.points.clamp(2, 100);
    let wanted = wish.floors.as_ref().map_or(points, Vec::len);
    progress.expect(2 * wanted + 2);
    let Some(net) = net_of::<L>(&search, progress) else {
        return Ok(None);
    };
    progress.step();
    let free = search.best_of::<L>(&net.starts(0.0), 0.0);
    progress.step();
    let lowest = free.as_ref().map_or(0.0, |found| found.ler);
    let floors = wish.floors.clone().unwrap_or_else(|| {
        // The last floor leaves rounding room below what only two lines reach.
        let last = greatest - 1e-3;
        let at = |i: usize| lowest + (last - lowest) * i as f64 / (points - 1) as f64;
        (0..points).map(at).collect()
    });
    let bright: [f64; L] = std::array::from_fn(|i| brightest[i * (brightest.len() - 1) / (L - 1)]);
    // Three lines, one of them doubled, are four: so these are never worse than those.
    let Some(threes) = (if L > 3 {
        net_of::<3>(&search, progress)
    } else {
        Some(Net::new())
    }) else {
        return Ok(None);
    };
    let from_net = |index: usize| {
        let mut starts: Vec<[f64; L]> = net.starts(floors[index]);
        starts.push(bright);
        let three = search.best_of::<3>(&threes.starts(floors[index]), floors[index]);
        starts.extend(three.iter().flat_map(|three| doubled(three.places)));
        search.best_of(&starts, floors[index])
    };
    let Some(first) = at_floors(floors.len(), &from_net, progress) else {
        return Ok(None);
    };
    let from_beside = |index: usize| {
        let near = [index.checked_sub(1), Some(index + 1)]
            .into_iter()
            .flatten();
        let near = near
            .filter_map(|i| first.get(i)?.as_ref())
            .chain(free.iter());
        let near: Vec<[f64; L]> = near.map(|found| found.places).collect();
        search.bettered(first[index].as_ref(), &near, floors[index])
    };
    let Some(second) = at_floors(floors.len(), &from_beside, progress) else {
        return Ok(None);
    };
    let found = spread_down(second);
    let points = floors.iter().zip(&found).filter_map(|(floor, found)| {
        let found = found.as_ref().filter(|found| found.worth > -1e5)?;
        Some(point(*floor, found, tables))
    });
    let mut points: Vec<FrontPoint> = points.collect();
    if wish.floors.is_none() {
        points.sort_by(|a, b| a.figures.ler.total_cmp(&b.figures.ler));
        points.dedup_by(|a, b| a.lines == b.lines);
    }
    Ok(Some(points))
}

/// Three lines as four or more, each of them doubled in turn.
fn doubled<const L: usize>(three: [f64; 3]) -> Vec<[f64; L]> {
    let of = |twice: usize| {
        std::array::from_fn(|i| {
            three[if i <= twice {
                i
            } else {
                i.saturating_sub(L - 3)
            }]
        })
    };
    if L == 3 {
        Vec::new()
    } else {
        (0..3).map(of).collect()
    }
}

/// A light that is good at a high floor is allowed at every lower one.
fn spread_down<const L: usize>(mut found: Vec<Option<Found<L>>>) -> Vec<Option<Found<L>>> {
    for index in (0..found.len().saturating_sub(1)).rev() {
        let (here, above) = (&found[index], &found[index + 1]);
        let better = match (here, above) {
            (Some(here), Some(above)) => above.worth > here.worth && above.ler >= here.ler,
            (None, Some(_)) => true,
            _ => false,
        };
        if better {
            found[index] = found[index + 1].clone();
        }
    }
    found
}

/// The greatest efficacy of any lines of the colour, and their places.
fn greatest_ler(target: [f64; 3]) -> Option<(f64, Vec<f64>)> {
    let places: Vec<f64> = (RANGE_NM[0] as u32..=RANGE_NM[1] as u32)
        .map(f64::from)
        .collect();
    let channels: Vec<_> = places.iter().map(|nm| basic_of_line(*nm)).collect();
    let all = Polytope::new(&channels, [0.0; 5], target, None, None)?;
    let weights = all.most_lumens();
    let sums = all.sums(&weights);
    let lit = places.iter().zip(&weights).filter(|(_, w)| **w > 1e-9);
    let lit: Vec<f64> = lit.map(|(nm, _)| *nm).collect();
    (!lit.is_empty()).then_some((GREATEST_LER * sums[1] / sums[4], lit))
}

fn point<const L: usize>(floor: f64, found: &Found<L>, tables: &SampleTables) -> FrontPoint {
    let whole: f64 = found.powers.iter().sum();
    let mut lines: Vec<FrontLine> = Vec::new();
    let mut sums = Sums::default();
    for (place, power) in found.places.iter().zip(&found.powers) {
        let at_nm = *place;
        sums.add(&tables.line_sums(at_nm, true, true), *power, true);
        match lines.last_mut() {
            Some(last) if last.at_nm == at_nm => last.share_of_power += power / whole,
            _ if *power > 0.0 => lines.push(FrontLine {
                at_nm,
                share_of_power: power / whole,
            }),
            _ => {}
        }
    }
    FrontPoint {
        floor,
        lines,
        figures: MixFigures::new(&sums, tables),
    }
}

/// The best of a net over all places, by class of efficacy.
struct Net<const L: usize> {
    classes: Vec<Vec<(f64, [f64; L])>>,
}

impl<const L: usize> Net<L> {
    fn new() -> Self {
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
    fn starts(&self, floor: f64) -> Vec<[f64; L]> {
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
fn net_of<const L: usize>(search: &LineSearch<'_>, progress: &Progress) -> Option<Net<L>> {
    let (step, shares) = if L == 3 { (4, 1) } else { (10, 5) };
    let whole = RANGE_NM[0] as u32..=RANGE_NM[1] as u32;
    let places: Vec<f64> = whole.step_by(step).map(f64::from).collect();
    let parts = places.len();
    let one = |first: usize| {
        let mut net = Net::<L>::new();
        let mut rest: Vec<usize> = (first + 1..first + L).collect();
        while rest.last().is_some_and(|last| *last < parts) && !progress.is_cancelled() {
            let chosen: [f64; L] =
                std::array::from_fn(|i| places[if i == 0 { first } else { rest[i - 1] }]);
            search.look(chosen, shares, |ler, figure| net.take(ler, figure, chosen));
            // The next set behind the first place.
            let Some(at) = (0..L - 1).rev().find(|i| rest[*i] < parts - (L - 1) + i) else {
                break;
            };
            rest[at] += 1;
            (at + 1..L - 1).for_each(|i| rest[i] = rest[i - 1] + 1);
        }
        net
    };
    let nets = shared_out(parts, &one);
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

/// What is found at each floor; `None` when cancelled.
fn at_floors<const L: usize>(
    floors: usize,
    at: &(dyn Fn(usize) -> Option<Found<L>> + Sync),
    progress: &Progress,
) -> Option<Vec<Option<Found<L>>>> {
    let one = |index: usize| {
        let found = if progress.is_cancelled() {
            None
        } else {
            at(index)
        };
        progress.step();
        found
    };
    let found = shared_out(floors, &one);
    (!progress.is_cancelled()).then_some(found)
}

/// Does tasks on as many threads as there are; results by task.
fn shared_out<T: Send>(tasks: usize, one: &(dyn Fn(usize) -> T + Sync)) -> Vec<T> {
    let next = AtomicUsize::new(0);
    let work = || {
        let mut done = Vec::new();
        loop {
            let task = next.fetch_add(1, Ordering::Relaxed);
            if task >= tasks {
                return done;
            }
            done.push((task, one(task)));
        }
    };
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let mut done: Vec<(usize, T)> = thread::scope(|scope| {
        let others: Vec<_> = (1..threads.min(tasks)).map(|_| scope.spawn(work)).collect();
        let mut done = work();
        for other in others {
            match other.join() {
                Ok(found) => done.extend(found),
                Err(panic) => std::panic::resume_unwind(panic),
            }
        }
        done
    });
    done.sort_by_key(|(task, _)| *task);
    done.into_iter().map(|(_, found)| found).collect()
}
