//! Found, suggested, or nothing can be said: what an axis must show to be used.

use crate::languages::{fixed, said, with_sign};

use super::{
    super::{
        landmarks::Lamp,
        peaks::{Peak, Peaks},
    },
    Scene, ends, odds,
    pins::Pin,
    refine::{Match, Solution, refine},
    search,
};

/// Permitted use of an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// Used at once.
    Found,
    /// Shown, and used when a person says so.
    Suggested,
    /// Nothing can be said.
    Nothing,
}

/// Constraints on the light, set by hand.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Wanted {
    pub lamp: Option<Lamp>,
    /// Places whose wavelengths are known; two or more narrow the search.
    pub pins: Vec<Pin>,
    /// Wavelengths fall along the strip.
    pub falls: Option<bool>,
}

/// The axis of a photograph.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// Permitted use of the best axis.
    pub state: State,
    /// The likeliest axis, also where nothing can be said.
    pub best: Option<Solution>,
    /// The likeliest other one.
    pub runner_up: Option<Solution>,
    /// By how much the score is better than the other's.
    pub margin: f64,
    /// Why it was not found, in words.
    pub why: Option<String>,
}

/// The score of no other solution at all.
const NO_OTHER: f64 = -5.0;
/// Least lead of a suggested axis over the next.
const LEAST_LEAD: f64 = 1.0;
/// Least log-odds of an axis that is used at once.
const LEAST_ODDS: f64 = 1.0;
/// Least log-odds of a suggested axis of more than three lines.
const SUGGESTED_ODDS: f64 = -3.0;
/// Axes that are nowhere farther apart than this are one, nm.
const SAME_NM: f64 = 4.0;
/// Lines nearer to one another count as one place, nm.
const PLACE_NM: f64 = 10.0;
/// Least span of the lines, nm.
const LEAST_SPAN_NM: f64 = 90.0;
/// A peak of this height must be a line of the lamp, so far beyond the shortest also, nm.
const STRONG: f64 = 0.3;
const BEYOND_NM: f64 = 25.0;
/// A wider gap parts groups of lines, nm.
const GAP_NM: f64 = 90.0;
/// A single peak of this height is a line and no bump of smooth light.
const ALONE: f64 = 0.5;
/// Cameras see next to nothing below this wavelength, nm.
const VIOLET_NM: f64 = 412.0;
/// Largest height there, as a multiple of what the lamp's line has; lines beside the violet that
/// were taken for it have six to eight times as much.
const MOST_VIOLET: f64 = 5.0;
/// Fewer columns have no axis by themselves.
const LEAST_COLUMNS: usize = 60;

/// Looks for the axis: `bright` lines for lamps, `dark` ones for daylight.
pub fn find(columns: usize, bright: &Peaks, dark: Option<&Peaks>, wanted: &Wanted) -> Answer {
    let of_lamp = |lamp: Lamp| if lamp.is_dark() { dark } else { Some(bright) };
    let all = axes(columns, of_lamp, wanted);
    let Some(best) = all.first().cloned() else {
        return Answer {
            state: State::Nothing,
            best: None,
            runner_up: None,
            margin: 0.0,
            why: Some(no_axis(columns, bright)),
        };
    };
    let peaks = of_lamp(best.lamp).unwrap_or(bright);
    let runner_up = all.into_iter().find(|other| differs(&best, other, peaks));
    let margin = best.score - runner_up.as_ref().map_or(NO_OTHER, |other| other.score);
    let judged = Judged {
        solution: &best,
        peaks,
        margin,
        is_named: wanted.lamp.is_some(),
        is_pinned: wanted.lamp.is_some() && wanted.pins.len() > 1,
    };
    let (state, why) = judged.verdict(runner_up.as_ref());
    Answer {
        state,
        best: Some(best),
        runner_up,
        margin,
        why,
    }
}

/// Axes through the lines of a lamp, the likeliest first.
fn axes<'p>(
    columns: usize,
    of_lamp: impl Fn(Lamp) -> Option<&'p Peaks>,
    wanted: &Wanted,
) -> Vec<Solution> {
    let scene_of = |lamp| {
        let peaks = of_lamp(lamp).filter(|p| p.peaks.len() > 2)?;
        (columns >= LEAST_COLUMNS).then(|| scene(columns, peaks, wanted))
    };
    let counts = |scene: &Scene, axis: &Solution| {
        axis.matches.len() > 2 && scene.is_kept(|px| axis.curve.nm(px))
    };
    let mut all = Vec::new();
    let lamps = Lamp::ALL.into_iter();
    for lamp in lamps.filter(|lamp| wanted.lamp.is_none_or(|named| named == *lamp)) {
        let Some(scene) = scene_of(lamp) else {
            continue;
        };
        let starts = search::of_lamp(&scene, lamp);
        let refined = starts.iter().filter_map(|one| refine(&scene, one));
        all.extend(refined.filter(|axis| counts(&scene, axis)));
    }
    // The best is held against its like with other lines at an end, and so is what beats it.
    for _ in 0..2 {
        all.sort_by(|a, b| b.score.total_cmp(&a.score));
        let Some(best) = all.first() else { break };
        if let Some(scene) = scene_of(best.lamp) {
            let others = ends::others(&scene, best).into_iter();
            all.extend(others.filter(|axis| counts(&scene, axis)));
        }
    }
    all.sort_by(|a, b| b.score.total_cmp(&a.score));
    all
}

fn scene<'p>(columns: usize, peaks: &'p Peaks, wanted: &Wanted) -> Scene<'p> {
    // One pin narrows nothing down to a side.
    let span = match &wanted.pins[..] {
        [first, .., last] => ((last.nm - first.nm) / (last.px - first.px)).abs(),
        _ => 0.0,
    };
    let most = (4.0 * span).max(5.0);
    Scene {
        peaks,
        columns,
        pins: wanted.pins.iter().map(|pin| (*pin, most)).collect(),
        falls: wanted.falls,
    }
}

fn no_axis(columns: usize, bright: &Peaks) -> String {
    match bright.peaks.len() {
        _ if columns < LEAST_COLUMNS => tr!(
            "found a strip of {columns} columns, expected {least} and more for an axis",
            columns,
            least = LEAST_COLUMNS
        ),
        1 if bright.peaks[0].height > ALONE => match bright.peaks[0].hue {
            // Low-pressure sodium: the one lamp of one line that is common.
            Some(hue) if hue.is_yellow() => said!("one sodium line is no axis").to_owned(),
            _ => said!("one line is no axis").to_owned(),
        },
        0 | 1 => said!(
            "this is smooth light without lines: take a picture of an energy-saving lamp with \
                 the same set-up, then this one with it"
        )
        .to_owned(),
        count => tr!(
            "found {count} lines that fit no lamp, expected those of one",
            count
        ),
    }
}

/// True if two axes are apart somewhere on the lines of the first.
fn differs(best: &Solution, other: &Solution, peaks: &Peaks) -> bool {
    let px = best.matches.iter().map(|m| peaks.peaks[m.peak].px);
    let off = |px: f64| (best.curve.nm(px) - other.curve.nm(px)).abs();
    px.map(off).fold(0.0, f64::max) > SAME_NM
}

/// An axis before its verdict.
struct Judged<'s> {
    solution: &'s Solution,
    peaks: &'s Peaks,
    margin: f64,
    is_named: bool,
    is_pinned: bool,
}

impl Judged<'_> {
    fn verdict(&self, runner_up: Option<&Solution>) -> (State, Option<String>) {
        let solution = self.solution;
        let lines = solution.matches.len();
        let (low, high) = solution.span_nm();
        let spans = high - low >= LEAST_SPAN_NM;
        let fits = match () {
            () if self.is_named && !solution.lamp.is_dark() => solution.score >= 0.5,
            () if solution.lamp.is_dark() || self.is_grey() => solution.score >= 7.0,
            () => solution.score >= 6.0 || lines > 3 && self.log_odds() >= SUGGESTED_ODDS,
        };
        let is_first = self.is_named || self.margin >= LEAST_LEAD;
        let is_suggested = spans && lines >= 3 && fits && is_first;
        match self.against(runner_up) {
            None => (State::Found, None),
            Some(why) if is_suggested => (State::Suggested, Some(why)),
            Some(why) => (State::Nothing, Some(why)),
        }
    }

    /// Reason not to use the axis at once.
    fn against(&self, runner_up: Option<&Solution>) -> Option<String> {
        let solution = self.solution;
        let (lines, places) = (solution.matches.len(), self.places());
        let name = said(solution.lamp.name());
        if solution.span_nm().1 - solution.span_nm().0 < LEAST_SPAN_NM {
            return Some(tr!(
                "the lines span less than {least} nm: that is no axis",
                least = fixed(LEAST_SPAN_NM, 0)
            ));
        }
        if lines < 4 || places < 4 {
            return Some(self.so_few(lines, name));
        }
        let is_grey = self.is_grey();
        let least = self.least_score(is_grey);
        let least_margin = self.least_margin(is_grey);
        if solution.score < least {
            return Some(tr!(
                "the lines fit {name} too loosely: score {score}, expected {least}",
                name,
                score = fixed(solution.score, 1),
                least = with_sign(least.to_string())
            ));
        }
        if !self.is_named && !solution.lamp.is_dark() && self.log_odds() < LEAST_ODDS {
            return Some(tr!(
                "the {lines} lines may fit {name} by chance: set one pin, or name the lamp",
                lines,
                name
            ));
        }
        if self.margin < least_margin {
            return Some(match runner_up.map(|other| other.lamp) {
                None => tr!("fits {name} and nothing about equally: set one pin", name),
                Some(other) if other == solution.lamp => {
                    tr!("fits {name} in two ways about equally: set one pin", name)
                }
                Some(other) => tr!(
                    "fits {name} and {other} about equally: set one pin",
                    name,
                    other = said(other.name())
                ),
            });
        }
        if let Some(nm) = self.strong_stranger() {
            return Some(tr!(
                "the strong line at {nm} nm is none of {name}'s",
                nm = fixed(nm, 0),
                name
            ));
        }
        if let Some(nm) = self.bright_violet() {
            return Some(tr!(
                "the line at {nm} nm is too bright for the violet, where cameras see little",
                nm = fixed(nm, 0)
            ));
        }
        if !self.is_named && self.has_lonely_group() {
            return Some(tr!(
                "a gap of more than {gap} nm is left open, and few lines stand beyond it",
                gap = fixed(GAP_NM, 0)
            ));
        }
        if is_grey && self.widest_gap() > 120.0 {
            return Some(
                said!("without colours a gap of more than 120 nm is left open").to_owned(),
            );
        }
        let most = self.most_left_out();
        let left_out = solution.left_out_rms_nm();
        (left_out >= most).then(|| {
            tr!(
                "a line that is left out is missed by {left_out} nm, expected {most}",
                left_out = fixed(left_out, 1),
                most = fixed(most, 1)
            )
        })
    }

    /// So few lines prove nothing.
    fn so_few(&self, lines: usize, name: &str) -> String {
        let nm: Vec<String> = self
            .sorted_nm()
            .iter()
            .map(|nm| format!("{nm:.0}"))
            .collect();
        let places = nm.join(", ");
        match lines {
            3 => tr!(
                "{lines} lines only ({places}): this fits {name}, but three lines prove \
                 nothing. Right?",
                lines,
                places,
                name
            ),
            _ => tr!(
                "{lines} lines only ({places}): this fits {name}, but so few prove nothing. \
                 Right?",
                lines,
                places,
                name
            ),
        }
    }

    fn least_score(&self, is_grey: bool) -> f64 {
        match () {
            // Dark lines are many and alike: a name does not tell them apart.
            () if self.is_named && !self.solution.lamp.is_dark() => 0.5,
            () if self.is_named => 2.5,
            () if is_grey || self.solution.lamp.is_dark() => 9.0,
            () => 3.0,
        }
    }

    fn log_odds(&self) -> f64 {
        odds::log_odds(self.solution, self.peaks)
    }

    fn least_margin(&self, is_grey: bool) -> f64 {
        match () {
            () if self.is_pinned => 0.0,
            () if self.is_named && self.solution.lamp.is_dark() => 8.0,
            () if self.is_named => 4.0,
            () if is_grey => 9.0,
            () => self.solution.lamp.least_margin(),
        }
    }

    /// The most that lines may be off by when left out, nm.
    fn most_left_out(&self) -> f64 {
        let peak = |m: &Match| self.peaks.peaks[m.peak];
        let curve = &self.solution.curve;
        let width = |p: Peak| p.fwhm_px * curve.slope(p.px).abs();
        let widths: Vec<f64> = self
            .solution
            .matches
            .iter()
            .map(|m| width(peak(m)))
            .collect();
        let fwhm = super::super::smooth::median(&widths);
        if self.is_named || self.solution.matches.len() < 6 {
            3.0
        } else {
            (0.35 * fwhm + 0.5).max(1.2)
        }
    }

    /// Most of the lines have no colour.
    fn is_grey(&self) -> bool {
        let matches = &self.solution.matches;
        let grey = (matches.iter()).filter(|m| self.peaks.peaks[m.peak].hue.is_none());
        2 * grey.count() > matches.len()
    }

    fn sorted_nm(&self) -> Vec<f64> {
        let mut nm: Vec<f64> = self.solution.lines_nm().collect();
        nm.sort_by(f64::total_cmp);
        nm
    }

    /// Number of lines that are not near one another.
    fn places(&self) -> usize {
        let mut last = f64::MIN;
        let mut places = 0;
        for nm in self.sorted_nm() {
            if nm - last > PLACE_NM {
                (last, places) = (nm, places + 1);
            }
        }
        places
    }

    /// The wavelength of a strong peak among the lines that is none of them.
    fn strong_stranger(&self) -> Option<f64> {
        let (low, high) = self.solution.span_nm();
        let mut peaks = self.peaks.peaks.iter().enumerate();
        peaks.find_map(|(i, peak)| {
            let nm = self.solution.curve.nm(peak.px);
            let counts = peak.height >= STRONG && (low - BEYOND_NM..=high).contains(&nm);
            let is_matched = self.solution.matches.iter().any(|m| m.peak == i);
            (counts && !is_matched).then_some(nm)
        })
    }

    /// The wavelength of a line in the violet, where cameras see next to nothing, that is much
    /// brighter than the lamp's.
    fn bright_violet(&self) -> Option<f64> {
        let mut violet = (self.solution.matches.iter()).filter(|m| m.landmark.nm < VIOLET_NM);
        let height = |m: &Match| self.peaks.peaks[m.peak].height;
        let found = violet.find(|m| height(m) > MOST_VIOLET * m.landmark.strength);
        found
            .filter(|_| !self.solution.lamp.is_dark())
            .map(|m| m.landmark.nm)
    }

    /// A line stands apart at an end, or two where a group may be slipped by one.
    fn has_lonely_group(&self) -> bool {
        let least = if self.solution.lamp.crowds() { 3 } else { 2 };
        let nm = self.sorted_nm();
        let gaps = nm.windows(2).enumerate();
        let mut wide = gaps.filter(|(_, pair)| pair[1] - pair[0] > GAP_NM);
        wide.any(|(i, _)| (i + 1).min(nm.len() - i - 1) < least)
    }

    fn widest_gap(&self) -> f64 {
        let nm = self.sorted_nm();
        nm.windows(2)
            .map(|pair| pair[1] - pair[0])
            .fold(0.0, f64::max)
    }
}
