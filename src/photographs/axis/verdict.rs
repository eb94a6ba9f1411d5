//! The axis of a photograph: the likeliest by the lines of all lamps, and the verdict on it.

use super::{
    super::{landmarks::Lamp, peaks::Peaks},
    Scene, beside,
    judged::{Judged, State},
    pins::Pin,
    refine::{Solution, refine},
    search,
};

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
    /// The likeliest of another lamp.
    pub other_lamp: Option<Solution>,
    /// By how much the score is better than the other's.
    pub margin: f64,
    /// Why it was not found, in words.
    pub why: Option<String>,
}

/// The score of no other solution at all.
const NO_OTHER: f64 = -5.0;
/// Axes that are nowhere farther apart than this are one, nm.
const SAME_NM: f64 = 4.0;
/// A single peak of this height is a line and no bump of smooth light.
const ALONE: f64 = 0.5;
/// Most rounds in which a better axis is looked for beside the best.
const MOST_ROUNDS: usize = 4;
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
            other_lamp: None,
            margin: 0.0,
            why: Some(no_axis(columns, bright)),
        };
    };
    let peaks = of_lamp(best.lamp).unwrap_or(bright);
    let rivals: Vec<Solution> = (all.into_iter())
        .filter(|other| differs(&best, other, peaks))
        .collect();
    let margin = best.score - rivals.first().map_or(NO_OTHER, |other| other.score);
    let judged = Judged {
        solution: &best,
        peaks,
        rivals: &rivals,
        margin,
        is_named: wanted.lamp.is_some(),
        is_pinned: wanted.lamp.is_some() && wanted.pins.len() > 1,
    };
    let (state, why) = judged.verdict();
    let is_other = |other: &&Solution| other.lamp != best.lamp;
    Answer {
        state,
        other_lamp: rivals.iter().find(is_other).cloned(),
        runner_up: rivals.into_iter().next(),
        best: Some(best),
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
    // The best is held against those beside it, and so is what beats it.
    let mut held = None;
    for _ in 0..MOST_ROUNDS {
        all.sort_by(|a, b| b.score.total_cmp(&a.score));
        let best = all.first().cloned();
        let Some(axis) = best.as_ref().filter(|_| best != held) else {
            break;
        };
        if let Some(scene) = scene_of(axis.lamp) {
            let others = beside::others(&scene, axis).into_iter();
            all.extend(others.filter(|axis| counts(&scene, axis)));
        }
        held = best;
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
