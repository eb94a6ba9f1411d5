//! The trade between luminous efficacy and colour rendering, with lines that are free to move.
//!
//! Two lines of a colour have one place free: all of them are looked at. For three and four a net
//! over all places (4 nm for three lines, 10 nm for four) is looked at once; for each floor of
//! efficacy the best of the net are moved to where no move helps, then what the neighbouring floors
//! found is tried. To four further ones join one by one, wherever each helps most. Floors are shared
//! out among threads and each is its own search, so that the result is the same bits whatever their
//! number.

use super::{
    against::Against,
    figures::MixFigures,
    light::{Light, Line},
    line_search::{Found, LineSearch},
    net::{Net, RANGE_NM, net_of},
    polytope::Polytope,
    target::Target,
};
use crate::{
    design::{
        mixture::MixError,
        scales::{LUMENS_PER_WATT, SampleTables, Scales, Sums, basic_of_line},
    },
    study::{Progress, in_parallel, processors},
};

/// Worth of a light that misses its floor, or has no figure, is below this.
const LEAST_WORTH: f64 = -1e5;

/// Which front is wanted.
#[derive(Clone, Debug, PartialEq)]
pub struct FrontWish {
    /// The colour of every light.
    pub target: Target,
    /// The figure.
    pub against: Against,
    /// Lines of each light, `FREE_LINES`.
    pub lines: usize,
    /// Points, 2 to 100, between the best of the figure and the greatest efficacy.
    pub points: usize,
    /// Floors of efficacy instead of even ones, lm/W.
    pub floors: Option<Vec<f64>>,
}

/// A line of a light.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
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

/// Lines that a light of a front may have.
pub(crate) const FREE_LINES: std::ops::RangeInclusive<usize> = 2..=8;

/// The front by rising efficacy; `None` when cancelled. With even floors a light that another one
/// beats in both is left out.
///
/// # Errors
/// [`MixError::Channels`] for a number of lines that is not of `FREE_LINES`, [`MixError::Target`]
/// for a colour without a temperature (no figure) or outside of what lines can show.
pub fn front(
    wish: &FrontWish,
    tables: &SampleTables,
    progress: &Progress,
) -> Result<Option<Vec<FrontPoint>>, MixError> {
    if !FREE_LINES.contains(&wish.lines) {
        return Err(MixError::Channels { found: wish.lines });
    }
    let refused = |expected: &str| MixError::Target {
        found: wish.target.to_string(),
        expected: expected.to_owned(),
    };
    let xyz = wish.target.xyz();
    let scales = Scales::new(xyz, tables).ok_or_else(|| {
        refused("a colour near the blackbody locus, where Ra and Rf have a meaning")
    })?;
    let target = (xyz * 0.01).to_array();
    let brightest =
        brightest(target).ok_or_else(|| refused("a colour that lines of 400-700 nm can show"))?;
    let course = Course {
        search: LineSearch::new(RANGE_NM, target, wish.against, tables, &scales),
        brightest,
        wish,
        progress,
    };
    let found = match wish.lines {
        2 => course.pairs(),
        3 => course.few::<3>(),
        4 => course.few::<4>(),
        _ => course.many(),
    };
    let Some(found) = found else {
        return Ok(None);
    };
    let worthy = found.iter().filter(|(_, light)| light.worth > LEAST_WORTH);
    let mut points: Vec<FrontPoint> = worthy
        .map(|(floor, light)| point(*floor, light, tables))
        .collect();
    if wish.floors.is_none() {
        points.sort_by(|a, b| a.figures.ler.total_cmp(&b.figures.ler));
        points.dedup_by(|a, b| a.lines == b.lines);
        let mut best = f64::NEG_INFINITY;
        let mut unbeaten: Vec<FrontPoint> = Vec::new();
        for point in points.into_iter().rev() {
            let figure = wish.against.of(&point.figures).unwrap_or(LEAST_WORTH);
            if figure > best {
                best = figure;
                unbeaten.push(point);
            }
        }
        unbeaten.reverse();
        points = unbeaten;
    }
    Ok(Some(points))
}

/// Lights by the floors that they were sought at; `None` when cancelled.
type AtFloors = Option<Vec<(f64, Light)>>;

/// A search for a front.
struct Course<'a> {
    search: LineSearch<'a>,
    /// The lines of the greatest efficacy.
    brightest: Brightest,
    wish: &'a FrontWish,
    progress: &'a Progress,
}

/// The greatest efficacy of any lines of the colour, lm/W, and their places.
struct Brightest {
    ler: f64,
    places: Vec<f64>,
}

/// What all floors begin with.
struct Begun<const L: usize> {
    net: Net<L>,
    /// Three lines, one of them doubled, are four: so these are never worse than those.
    threes: Net<3>,
    /// The best without a floor.
    free: Option<Found<L>>,
}

impl Course<'_> {
    fn points(&self) -> usize {
        self.wish.points.clamp(2, 100)
    }

    fn count(&self) -> usize {
        self.wish.floors.as_ref().map_or(self.points(), Vec::len)
    }

    /// The floors asked for, or even ones from the efficacy of the best light to the greatest.
    fn floors(&self, lowest: f64, greatest: f64) -> Vec<f64> {
        self.wish.floors.clone().unwrap_or_else(|| {
            let points = self.points();
            // The last floor leaves rounding room below what only two lines reach.
            let last = greatest - 1e-3;
            let at = |i: usize| lowest + (last - lowest) * i as f64 / (points - 1) as f64;
            (0..points).map(at).collect()
        })
    }

    /// Two lines: all that have the colour, and of those the best at each floor.
    fn pairs(&self) -> AtFloors {
        self.progress.expect(1);
        let all = self.search.pairs(self.progress)?;
        let best = |floor: f64| {
            let bright = all.iter().filter(|pair| pair.ler >= floor);
            bright.max_by(|a, b| a.worth.total_cmp(&b.worth)).cloned()
        };
        let lowest = best(0.0).map_or(0.0, |best| best.ler);
        let greatest = all.iter().map(|pair| pair.ler).fold(0.0, f64::max);
        let floors = self.floors(lowest, greatest).into_iter();
        self.progress.step();
        Some(floors.filter_map(|f| Some((f, best(f)?))).collect())
    }

    /// Three or four lines.
    fn few<const L: usize>(&self) -> AtFloors {
        self.progress.expect(2 * self.count() + 2);
        let begun = self.begun::<L>()?;
        let lowest = begun.free.as_ref().map_or(0.0, |found| found.ler);
        let floors = self.floors(lowest, self.brightest.ler);
        let found = self.at_floors(&begun, &floors)?;
        let lights = floors.into_iter().zip(found);
        Some(
            lights
                .filter_map(|(f, found)| Some((f, found?.into())))
                .collect(),
        )
    }

    /// Five lines and more: four to which one after the other joins.
    fn many(&self) -> AtFloors {
        let more = self.wish.lines - 4;
        self.progress.expect((2 + more) * self.count() + 2 + more);
        let begun = self.begun::<4>()?;
        let mut free: Option<Light> = begun.free.clone().map(Light::from);
        for _ in 0..more {
            free = free.map(|free| self.search.with_one_more(&free, 0.0));
            self.progress.step();
        }
        let lowest = free.as_ref().map_or(0.0, |found| found.ler);
        let floors = self.floors(lowest, self.brightest.ler);
        let found = self.at_floors(&begun, &floors)?.into_iter();
        let mut lights: Vec<Option<Light>> = found.map(|f| f.map(Light::from)).collect();
        for _ in 0..more {
            let one = |index: usize| {
                let light = lights[index].as_ref()?;
                Some(self.search.with_one_more(light, floors[index]))
            };
            let grown = self.each(&floors, one)?;
            lights = spread_down(grown, |light| [light.ler, light.worth]);
        }
        let lights = floors.into_iter().zip(lights);
        Some(lights.filter_map(|(f, light)| Some((f, light?))).collect())
    }

    fn begun<const L: usize>(&self) -> Option<Begun<L>> {
        let net = net_of::<L>(&self.search, self.progress)?;
        self.progress.step();
        let free = self.search.best_of::<L>(&net.starts(0.0), 0.0);
        self.progress.step();
        let threes = match L {
            3 => Net::new(),
            _ => net_of::<3>(&self.search, self.progress)?,
        };
        Some(Begun { net, threes, free })
    }

    /// What is found at each floor, by its index.
    fn each<F: Send>(
        &self,
        floors: &[f64],
        at: impl Fn(usize) -> Option<F> + Sync,
    ) -> Option<Vec<Option<F>>> {
        let indices: Vec<usize> = (0..floors.len()).collect();
        in_parallel(&indices, processors(), self.progress, |index| at(*index))
    }

    /// The best lights at each floor: from the net, then from what neighbouring floors found.
    fn at_floors<const L: usize>(
        &self,
        begun: &Begun<L>,
        floors: &[f64],
    ) -> Option<Vec<Option<Found<L>>>> {
        let places = &self.brightest.places;
        let bright: [f64; L] = std::array::from_fn(|i| places[i * (places.len() - 1) / (L - 1)]);
        let from_net = |index: usize| {
            let mut starts: Vec<[f64; L]> = begun.net.starts(floors[index]);
            starts.push(bright);
            let threes = begun.threes.starts(floors[index]);
            let three = self.search.best_of::<3>(&threes, floors[index]);
            starts.extend(three.iter().flat_map(|three| doubled(three.places)));
            self.search.best_of(&starts, floors[index])
        };
        let first = self.each(floors, from_net)?;
        let from_beside = |index: usize| {
            let near = [index.checked_sub(1), Some(index + 1)]
                .into_iter()
                .flatten();
            let near = near
                .filter_map(|i| first.get(i)?.as_ref())
                .chain(begun.free.iter());
            let near: Vec<[f64; L]> = near.map(|found| found.places).collect();
            self.search
                .bettered(first[index].as_ref(), &near, floors[index])
        };
        let second = self.each(floors, from_beside)?;
        Some(spread_down(second, |found| [found.ler, found.worth]))
    }
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

/// A light that is good at a high floor is allowed at every lower one; `of` tells its efficacy and
/// what it is worth.
fn spread_down<F: Clone>(mut found: Vec<Option<F>>, of: impl Fn(&F) -> [f64; 2]) -> Vec<Option<F>> {
    for index in (0..found.len().saturating_sub(1)).rev() {
        let [here, above] = [index, index + 1].map(|i| found[i].as_ref().map(&of));
        let better = match (here, above) {
            (Some([ler, worth]), Some(above)) => above[1] > worth && above[0] >= ler,
            (None, Some(_)) => true,
            _ => false,
        };
        if better {
            found[index] = found[index + 1].clone();
        }
    }
    found
}

/// The brightest of all lines of the colour.
fn brightest(target: [f64; 3]) -> Option<Brightest> {
    let places: Vec<f64> = (RANGE_NM[0] as u32..=RANGE_NM[1] as u32)
        .map(f64::from)
        .collect();
    let channels: Vec<_> = places.iter().map(|nm| basic_of_line(*nm)).collect();
    let all = Polytope::new(&channels, [0.0; 5], target, None, None).ok()?;
    let weights = all.most_lumens().ok()?;
    let sums = all.sums(&weights);
    let lit = places.iter().zip(&weights).filter(|(_, w)| **w > 1e-9);
    let places: Vec<f64> = lit.map(|(nm, _)| *nm).collect();
    let ler = LUMENS_PER_WATT * sums[1] / sums[4];
    (!places.is_empty()).then_some(Brightest { ler, places })
}

fn point(floor: f64, light: &Light, tables: &SampleTables) -> FrontPoint {
    let whole: f64 = light.lines.iter().map(|line| line.power).sum();
    let mut lines: Vec<FrontLine> = Vec::new();
    let mut sums = Sums::default();
    for Line { at_nm, power } in &light.lines {
        sums.add(&tables.line_sums(*at_nm, true, true), *power, true);
        match lines.last_mut() {
            Some(last) if last.at_nm == *at_nm => last.share_of_power += power / whole,
            _ if *power > 0.0 => lines.push(FrontLine {
                at_nm: *at_nm,
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
