//! Gases and vapours of line tubes: many lines, which only fine data can tell.

use super::{
    peaks::Peak,
    scene::{Scene, Told, is_line},
    table::{GASES, Gas},
};

/// The strongest lines carry at least this share of the highest peak that the gas explains.
const LEAST_SHARE: f64 = 0.25;

/// Of lines within reach of a peak those with this share of the strongest one may name it.
const STRONG: f64 = 0.3;

/// Names the gases that are there, the one that explains most first.
pub(super) fn name_gases(scene: &mut Scene<'_>) {
    if !scene.is_fine {
        return;
    }
    let mut left: Vec<&Gas> = GASES.iter().collect();
    loop {
        let supported = left.iter().enumerate();
        let supported = supported.filter_map(|(i, gas)| Some((i, support(scene, gas)?)));
        let Some((best, _)) = supported.max_by(|a, b| a.1.total_cmp(&b.1)) else {
            return;
        };
        name(scene, left.remove(best));
    }
}

/// The power of the peaks that a gas explains; `None` where it is not there.
fn support(scene: &Scene<'_>, gas: &Gas) -> Option<f64> {
    let seen = |lines: &[f64]| -> Vec<Option<usize>> {
        let inside = lines.iter().filter(|nm| scene.covers(**nm));
        inside
            .map(|nm| scene.within(*nm, scene.gas_reach_nm))
            .collect()
    };
    let (strongest, others) = (seen(gas.strongest), seen(gas.others));
    if strongest.is_empty() || strongest.contains(&None) {
        return None;
    }
    let mut peaks: Vec<usize> = strongest.iter().chain(&others).flatten().copied().collect();
    peaks.sort_unstable();
    peaks.dedup();
    let highest = scene.highest_of(peaks.iter().map(|peak| Some(*peak)));
    let is_in_order = scene.highest_of(strongest) >= LEAST_SHARE * highest;
    (peaks.len() >= gas.least && is_in_order)
        .then(|| peaks.iter().map(|peak| scene.peaks[*peak].power()).sum())
}

/// Names peaks, the highest first: each after the nearest of the strong lines within reach, and
/// each line once.
fn name(scene: &mut Scene<'_>, gas: &Gas) {
    let mut lines = scene.lines_of(gas.symbol);
    while let Some((peak, line)) = next(scene, &lines) {
        let told = Told::plain(gas.symbol, format!("{} {:.1}", gas.symbol, lines[line].0));
        scene.tell([peak], &told);
        lines.remove(line);
    }
}

/// The highest peak without a name that has lines within reach, and the line it is.
fn next(scene: &Scene<'_>, lines: &[(f64, f64)]) -> Option<(usize, usize)> {
    let off = |peak: &Peak, line: usize| (lines[line].0 - peak.at_nm).abs();
    let within = |peak: &Peak| -> Vec<usize> {
        let all = 0..lines.len();
        all.filter(|line| off(peak, *line) <= scene.gas_reach_nm)
            .collect()
    };
    let peak = scene.highest(|peak| is_line(peak) && !within(peak).is_empty())?;
    let about = &scene.peaks[peak];
    let near = within(about);
    let strongest = near
        .iter()
        .fold(0.0_f64, |most, line| most.max(lines[*line].1));
    let strong = near
        .into_iter()
        .filter(|line| lines[*line].1 >= STRONG * strongest);
    let nearest = strong.min_by(|a, b| off(about, *a).total_cmp(&off(about, *b)))?;
    Some((peak, nearest))
}
