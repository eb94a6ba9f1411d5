//! Found, suggested, or nothing can be said: what an axis must show to be used, in words.

use crate::languages::{fixed, said, with_sign};

use super::{
    super::{
        landmarks::Lamp,
        peaks::{Peak, Peaks},
    },
    odds,
    refine::{Match, Solution},
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

/// Least lead of a suggested axis over the next.
const LEAST_LEAD: f64 = 1.0;
/// Least log-odds of an axis that is used at once.
const LEAST_ODDS: f64 = 1.0;
/// Least log-odds of a suggested axis of more than three lines.
const SUGGESTED_ODDS: f64 = -3.0;
/// Axes that are nearer than this at two thirds of the lines are the same but for their ends, nm.
const BESIDE_NM: f64 = 1.0;
/// Lines nearer to one another count as one place, nm.
const PLACE_NM: f64 = 10.0;
/// Least span of the lines, nm.
const LEAST_SPAN_NM: f64 = 90.0;
/// A peak of this height must be a line of the lamp, so far beyond the shortest also, nm.
const STRONG: f64 = 0.3;
const BEYOND_NM: f64 = 25.0;
/// A wider gap parts groups of lines, nm.
const GAP_NM: f64 = 90.0;
/// Least height of a line that is no ripple.
const SURE: f64 = 0.03;
/// Ends of violet and of blue, nm.
const VIOLET_NM: f64 = 412.0;
const BLUE_NM: f64 = 500.0;

/// An axis before its verdict.
pub(super) struct Judged<'s> {
    pub solution: &'s Solution,
    pub peaks: &'s Peaks,
    /// Other axes, the likeliest first.
    pub rivals: &'s [Solution],
    pub margin: f64,
    pub is_named: bool,
    pub is_pinned: bool,
}

impl Judged<'_> {
    /// The permitted use, and why it is no more.
    pub(super) fn verdict(&self) -> (State, Option<String>) {
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
        match self.against() {
            None => (State::Found, None),
            Some(why) if is_suggested => (State::Suggested, Some(why)),
            Some(why) => (State::Nothing, Some(why)),
        }
    }

    /// Reason not to use the axis at once.
    fn against(&self) -> Option<String> {
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
        if solution.score < least {
            return Some(tr!(
                "the lines fit {name} too loosely: score {score}, expected {least}",
                name,
                score = fixed(solution.score, 1),
                least = with_sign(least.to_string())
            ));
        }
        let is_likely = self.log_odds() >= LEAST_ODDS && self.has_sure_line();
        if !self.is_named && !solution.lamp.is_dark() && !is_likely {
            return Some(tr!(
                "the {lines} lines may fit {name} by chance: set one pin, or name the lamp",
                lines,
                name
            ));
        }
        let is_near = |other: &&Solution| {
            solution.score - other.score < self.least_margin(is_grey, self.is_beside(other))
        };
        if let Some(other) = self.rivals.iter().find(is_near) {
            return Some(if other.lamp == solution.lamp {
                tr!("fits {name} in two ways about equally: set one pin", name)
            } else {
                tr!(
                    "fits {name} and {other} about equally: set one pin",
                    name,
                    other = said(other.lamp.name())
                )
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

    /// True if another axis is this one but for its ends.
    fn is_beside(&self, other: &Solution) -> bool {
        let px = (self.solution.matches.iter()).map(|m| self.peaks.peaks[m.peak].px);
        let off = |px: f64| (self.solution.curve.nm(px) - other.curve.nm(px)).abs();
        let same = px.filter(|px| off(*px) < BESIDE_NM).count();
        other.lamp == self.solution.lamp && 3 * same >= 2 * self.solution.matches.len()
    }

    /// By how much the score must be better than another axis's.
    fn least_margin(&self, is_grey: bool, is_beside: bool) -> f64 {
        let plain = Lamp::Fluorescent.least_margin();
        match () {
            () if self.is_pinned => 0.0,
            () if is_grey && !self.is_named => 9.0,
            () if is_beside => plain,
            () if self.is_named && self.solution.lamp.is_dark() => 8.0,
            () if self.is_named => plain,
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

    /// One of the lines is strong, narrow and not over-exposed: an axis does not hang on ripples
    /// beside bands alone.
    fn has_sure_line(&self) -> bool {
        let mut lines = self
            .solution
            .matches
            .iter()
            .map(|m| self.peaks.peaks[m.peak]);
        lines.any(|p| p.height >= SURE && !p.is_clipped && !p.is_band)
    }

    /// The wavelength of a line in the violet, where cameras see little, that is the brightest of
    /// all in violet and blue: no lamp's is, unless over-exposed.
    fn bright_violet(&self) -> Option<f64> {
        let lines = self.solution.matches.iter();
        let blue = lines.filter(|m| m.landmark.nm < BLUE_NM);
        let height = |m: &&Match| self.peaks.peaks[m.peak].height;
        let brightest = blue.max_by(|a, b| height(a).total_cmp(&height(b)))?;
        let nm = brightest.landmark.nm;
        if self.peaks.peaks[brightest.peak].is_clipped {
            return None;
        }
        (nm < VIOLET_NM && !self.solution.lamp.is_dark()).then_some(nm)
    }

    /// A line stands apart at an end, or two where a group may be slipped by one. Hydrogen's red
    /// line always does.
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
