//! Sodium: the yellow pair alone at low pressure; at high pressure it takes its own light back in
//! the middle (self-reversal), and weaker pairs stand beside it.

use super::{
    scene::{Scene, Told, middle},
    table::{K_RED, NA_D, NA_FAINT, NA_INFRARED, NA_OTHERS},
};

/// Symbols.
pub(super) const NA: &str = "Na";
const K: &str = "K";

/// How sodium's yellow pair looks.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Yellow {
    /// One line at its place.
    Plain(usize),
    /// One line, broadened to the red of its place.
    Broadened(usize),
    /// Dark in the middle: the peaks at its sides, which may be too wide to be any.
    Reversed(Vec<usize>),
}

/// The yellow pair is at least so many times as high as the pair at 568.5 nm.
const OVER_OTHERS: f64 = 2.0;
/// Above this share of all light the pair needs no witness: a lamp of one line.
const ALONE: f64 = 0.5;
/// Such a line is not wider than this, nm: yellow diodes measure 14 and more.
const WIDEST_ALONE_NM: f64 = 8.0;
/// A broadened line stands within these places, nm, and is at most so wide.
const BROADENED_NM: [f64; 2] = [586.0, 600.0];
const WIDEST_BROADENED_NM: f64 = 16.0;
/// In the middle of a reversed line there is at most this share of its lower side.
const DARK: f64 = 0.95;
/// The sides of a reversed line reach at most so far, nm.
const SIDES_NM: f64 = 35.0;
/// They are at least so many times as high as the light between 480 and 550 nm is in the middle:
/// the sun's yellow pair is dark too.
const OVER_GREEN: f64 = 2.0;
const GREEN_NM: [f64; 2] = [480.0, 550.0];
/// Potassium's pair has at least this share of the highest value.
const K_AT_LEAST: f64 = 0.01;

/// The other pairs, in the table's order, as far as they are seen.
pub(super) fn others(scene: &Scene<'_>) -> [Option<usize>; 5] {
    NA_OTHERS.map(|pair| scene.near(middle(&pair)))
}

/// The yellow pair with witnesses enough to be sodium's.
pub(super) fn yellow(scene: &Scene<'_>) -> Option<Yellow> {
    let others = others(scene);
    let seen = others.iter().flatten().count();
    if let Some(sides) = reversed_sides(scene, &others) {
        let is_high = sides
            .iter()
            .any(|side| scene.is_of_the_three_highest(*side));
        if seen >= 2 || seen == 1 && is_high {
            return Some(Yellow::Reversed(sides));
        }
    }
    let candidate = candidate(scene)?;
    let (Yellow::Plain(peak) | Yellow::Broadened(peak)) = candidate else {
        return None;
    };
    let height = scene.peaks[peak].height;
    let [first, second, third, ..] = others;
    let is_over = |others: [Option<usize>; 2]| height >= OVER_OTHERS * scene.highest_of(others);
    let is_witnessed = first.is_some() && is_over([first, None])
        || second.is_some() && third.is_some() && is_over([second, third]);
    let is_alone = scene.peaks[peak].power() > ALONE * scene.points.power()
        && scene.peaks[peak].width_nm() <= WIDEST_ALONE_NM;
    (is_witnessed || is_alone).then_some(candidate)
}

/// What the yellow pair would be, if this is sodium.
pub(super) fn candidate(scene: &Scene<'_>) -> Option<Yellow> {
    let at_nm = middle(&NA_D);
    let reach = scene.reach_nm + 0.5 * (NA_D[1] - NA_D[0]);
    if let Some(peak) = scene.within(at_nm, reach) {
        return Some(Yellow::Plain(peak));
    }
    let [from, to] = BROADENED_NM;
    let peak = scene.highest(|peak| {
        (from..=to).contains(&peak.at_nm)
            && peak.is_over(at_nm)
            && peak.width_nm() <= WIDEST_BROADENED_NM
    });
    peak.filter(|peak| scene.is_of_the_three_highest(*peak))
        .map(Yellow::Broadened)
}

/// The peaks at the sides of a yellow pair that is dark in the middle; `None` where it is not.
fn reversed_sides(scene: &Scene<'_>, others: &[Option<usize>; 5]) -> Option<Vec<usize>> {
    let (nm, values) = (&scene.points.nm, &scene.points.values);
    let at_nm = middle(&NA_D);
    let reach = scene.reach_nm.max(scene.points.step_nm);
    let darkest = (1..nm.len().saturating_sub(1))
        .filter(|i| (nm[*i] - at_nm).abs() <= reach)
        .filter(|i| values[*i] <= values[i - 1] && values[*i] <= values[i + 1])
        .min_by(|a, b| values[*a].total_cmp(&values[*b]))?;
    let climb = |next: &dyn Fn(usize) -> Option<usize>| {
        let mut here = darkest;
        while let Some(there) = next(here) {
            let is_near = (nm[there] - nm[darkest]).abs() <= SIDES_NM;
            if !is_near || values[there] < values[here] {
                break;
            }
            here = there;
        }
        here
    };
    let left = climb(&|i| i.checked_sub(1));
    let right = climb(&|i| (i + 1 < nm.len()).then_some(i + 1));
    let lower = values[left].min(values[right]);
    let green = scene.points.median(GREEN_NM[0], GREEN_NM[1]);
    if scene.points.at(at_nm)? >= DARK * lower || lower < OVER_GREEN * green {
        return None;
    }
    // A side's peak stands about the highest place, unless it is one of the other pairs.
    const ABOUT_NM: f64 = 8.0;
    let is_side = |peak: usize| {
        let place = scene.peaks[peak].at_nm;
        let on_left = (nm[left] - ABOUT_NM..at_nm).contains(&place);
        let on_right = (at_nm..nm[right] + ABOUT_NM).contains(&place);
        let is_other = others.contains(&Some(peak)) && !is_at(place, nm[right]);
        scene.told[peak].is_none() && (on_left || on_right) && !is_other
    };
    Some(
        (0..scene.peaks.len())
            .filter(|peak| is_side(*peak))
            .collect(),
    )
}

/// Whether two places are one, nm.
fn is_at(place: f64, other: f64) -> bool {
    const SAME_NM: f64 = 5.0;
    (place - other).abs() <= SAME_NM
}

/// Names the yellow pair.
pub(super) fn name_yellow(scene: &mut Scene<'_>, yellow: &Yellow) {
    let words = format!("{NA} D {}", scene.number_of(NA, &NA_D));
    let label = format!("{NA} D");
    let (peaks, words) = match yellow {
        Yellow::Plain(peak) => (vec![*peak], words),
        Yellow::Broadened(peak) => (vec![*peak], tr!("{words}, broadened", words)),
        Yellow::Reversed(peaks) => (peaks.clone(), tr!("{words}, self-reversed", words)),
    };
    let told = Told {
        symbol: NA,
        words,
        label,
        is_reversed: matches!(yellow, Yellow::Reversed(_)),
    };
    scene.tell(peaks, &told);
}

/// Names sodium's other pairs: the three strongest, and of a lamp of high pressure without halides
/// all of them, with potassium.
pub(super) fn name_others(scene: &mut Scene<'_>, is_high_pressure: bool) {
    const STRONGEST: usize = 3;
    let mut pairs = NA_OTHERS[..STRONGEST].to_vec();
    pairs.push(NA_INFRARED);
    if is_high_pressure {
        pairs.extend_from_slice(&NA_OTHERS[STRONGEST..]);
        pairs.extend_from_slice(&NA_FAINT);
    }
    for pair in pairs {
        scene.name_near(NA, &pair);
    }
    let potassium = scene.near(middle(&K_RED));
    let least = K_AT_LEAST * scene.points.top();
    let potassium = potassium.filter(|peak| is_high_pressure && scene.peaks[*peak].height > least);
    scene.name_peak(potassium, K, &K_RED);
}
