//! The trade between luminous efficacy and colour rendering, with lines that are free to move.
//!
//! A net over all places of two and of three lines is looked at once. For each floor of efficacy the
//! best of the net are moved to where no move helps, further lines join one by one wherever each
//! helps most, and after each what other floors found is tried. Floors are shared out
//! among threads and each is its own search, so that the result is the same bits whatever their
//! number.

use super::{
    figures::MixFigures,
    light::{Light, Line, LineSearch},
    net::{Net, net_of},
    polytope::Polytope,
    target::Target,
};
use crate::{
    design::{
        mixture::MixError,
        scales::{Against, SampleTables, Scales, Sums, basic_of_line},
    },
    study::{Progress, in_parallel, processors},
};

/// Places that lines may have, nm.
const RANGE_NM: [f64; 2] = [400.0, 700.0];

/// Worth of a light that misses its floor, or has no figure, is below this.
const LEAST_WORTH: f64 = -1e5;

/// Specification of a front.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct FrontProblem {
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
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct FrontLine {
    /// Its place.
    pub at_nm: f64,
    /// Its share of the power.
    pub share_of_power: f64,
}

/// A light of the front.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
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
    problem: &FrontProblem,
    tables: &SampleTables,
    progress: &Progress,
) -> Result<Option<Vec<FrontPoint>>, MixError> {
    if !FREE_LINES.contains(&problem.lines) {
        return Err(MixError::Channels {
            found: problem.lines,
        });
    }
    let refused = |expected: &str| MixError::Target {
        found: problem.target.to_string(),
        expected: expected.to_owned(),
    };
    let xyz = problem.target.xyz();
    let scales = Scales::new(xyz, tables).ok_or_else(|| {
        refused(said!(
            "a colour near the blackbody locus, where Ra and Rf have a meaning"
        ))
    })?;
    let target = (xyz * 0.01).to_array();
    let search = LineSearch::new(RANGE_NM, target, problem.against, tables, &scales);
    let brightest = brightest(target).and_then(|lines| search.judged(&lines, 0.0, true));
    let course = Course {
        brightest: brightest
            .ok_or_else(|| refused(said!("a colour that lines of 400-700 nm can show")))?,
        search,
        problem,
        progress,
    };
    let Some(found) = course.lights() else {
        return Ok(None);
    };
    let worthy = found.iter().filter(|(_, light)| light.worth > LEAST_WORTH);
    let mut points: Vec<FrontPoint> = worthy
        .map(|(floor, light)| point(*floor, light, tables))
        .collect();
    if problem.floors.is_none() {
        points.sort_by(|a, b| a.figures.ler.total_cmp(&b.figures.ler));
        points.dedup_by(|a, b| a.lines == b.lines);
        let mut best = f64::NEG_INFINITY;
        let mut unbeaten: Vec<FrontPoint> = Vec::new();
        for point in points.into_iter().rev() {
            let figure = problem.against.of(&point.figures).unwrap_or(LEAST_WORTH);
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
    /// The light of the greatest efficacy.
    brightest: Light,
    problem: &'a FrontProblem,
    progress: &'a Progress,
}

impl Course<'_> {
    fn points(&self) -> usize {
        self.problem.points.clamp(2, 100)
    }

    /// The floors asked for, or even ones from the efficacy of the best light to the greatest.
    fn floors(&self, lowest: f64, greatest: f64) -> Vec<f64> {
        self.problem.floors.clone().unwrap_or_else(|| {
            let points = self.points();
            // The last floor leaves rounding room below what only two lines reach.
            let last = greatest - 1e-3;
            let at = |i: usize| lowest + (last - lowest) * i as f64 / (points - 1) as f64;
            (0..points).map(at).collect()
        })
    }

    /// The best light that is found at each floor.
    fn lights(&self) -> AtFloors {
        let floors = self.problem.floors.as_ref().map_or(self.points(), Vec::len);
        self.progress
            .expect(1 + 2 * (self.problem.lines - 1) * (1 + floors));
        let net = |count| net_of(&self.search, count, self.progress);
        let nets: Vec<Net> = (2..=self.problem.lines.min(3))
            .map(net)
            .collect::<Option<_>>()?;
        self.progress.step();
        let free = self.at_floors(&nets, &[0.0])?.pop().flatten();
        let lowest = free.map_or(0.0, |free| free.ler);
        let floors = self.floors(lowest, self.brightest.ler);
        let found = self.at_floors(&nets, &floors)?;
        let lights = floors.into_iter().zip(found);
        Some(lights.filter_map(|(f, light)| Some((f, light?))).collect())
    }

    /// The best lights at each floor, one line after the other: from a net and from fewer lines,
    /// then from what other floors found.
    fn at_floors(&self, nets: &[Net], floors: &[f64]) -> Option<Vec<Option<Light>>> {
        let indices: Vec<usize> = (0..floors.len()).collect();
        let bright = Some(&self.brightest).filter(|light| light.lines.len() <= self.problem.lines);
        let allowed = |floor: &f64| bright.filter(|light| light.ler >= *floor);
        let begun = floors.iter().map(allowed);
        let mut all: Vec<Vec<Light>> = begun
            .map(|light| light.into_iter().cloned().collect())
            .collect();
        for count in 2..=self.problem.lines {
            let grown = |index: &usize| {
                let (floor, before) = (floors[*index], &all[*index]);
                let mut starts: Vec<Light> = Vec::new();
                if let Some(net) = nets.get(count - 2) {
                    let lights = net.starts(floor).into_iter();
                    starts.extend(lights.filter_map(|l| self.search.judged(&l.lines, floor, true)));
                }
                for light in before.iter().filter(|light| light.lines.len() < count) {
                    starts.extend(self.search.with_one_more(light, floor));
                }
                self.search.best_of(before, starts, floor)
            };
            let first = in_parallel(&indices, processors(), self.progress, grown)?;
            let from_others = |index: &usize| {
                let (floor, own) = (floors[*index], &first[*index]);
                let others = first.iter().filter_map(|lights| lights.first());
                let others = others.filter(|light| own.first() != Some(light));
                let starts = others.filter_map(|l| self.search.judged(&l.lines, floor, true));
                self.search.best_of(own, starts.collect(), floor)
            };
            all = in_parallel(&indices, processors(), self.progress, from_others)?;
            // A light that is good at a high floor is allowed at every lower one.
            for index in (1..all.len()).rev() {
                let worth = |at: usize| all[at].first().map(|light| (light.worth, light.ler));
                let is_better = match (worth(index - 1), worth(index)) {
                    (Some((own, ler)), Some(above)) => above.0 > own && above.1 >= ler,
                    (None, above) => above.is_some(),
                    _ => false,
                };
                if is_better {
                    let above = all[index][0].clone();
                    all[index - 1].insert(0, above);
                }
            }
        }
        Some(
            all.into_iter()
                .map(|lights| lights.into_iter().next())
                .collect(),
        )
    }
}

/// The lines of the greatest efficacy of the colour; neighbours a nm apart are one between them.
fn brightest(target: [f64; 3]) -> Option<Vec<Line>> {
    let places = (RANGE_NM[0] as u32..=RANGE_NM[1] as u32).map(f64::from);
    let channels: Vec<_> = places.clone().map(basic_of_line).collect();
    let all = Polytope::new(&channels, [0.0; 5], target, None, None).ok()?;
    let weights = all.most_lumens().ok()?;
    let mut lines: Vec<Line> = Vec::new();
    for (at_nm, power) in places.zip(weights).filter(|(_, power)| *power > 1e-9) {
        match lines.last_mut() {
            Some(last) if at_nm - last.at_nm <= 1.0 => {
                last.power += power;
                last.at_nm += (at_nm - last.at_nm) * power / last.power;
            }
            _ => lines.push(Line { at_nm, power }),
        }
    }
    Some(lines)
}

fn point(floor: f64, light: &Light, tables: &SampleTables) -> FrontPoint {
    let whole: f64 = light.lines.iter().map(|line| line.power).sum();
    let mut lines: Vec<FrontLine> = Vec::new();
    let mut sums = Sums::default();
    for Line { at_nm, power } in &light.lines {
        sums.add(&tables.line_sums(*at_nm), *power);
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
