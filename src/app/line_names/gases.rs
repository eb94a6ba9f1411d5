//! Gases and vapours of line tubes: many lines, which only fine data can tell.

use super::{
    scene::{Scene, Told},
    table::{GASES, Gas},
};

/// The strongest lines carry at least this share of the highest peak that the gas explains.
const LEAST_SHARE: f64 = 0.25;

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

fn name(scene: &mut Scene<'_>, gas: &Gas) {
    for at_nm in scene.lines_of(gas.symbol) {
        if let Some(peak) = scene.within(at_nm, scene.gas_reach_nm) {
            let told = Told::plain(gas.symbol, format!("{} {at_nm:.1}", gas.symbol));
            scene.tell([peak], &told);
        }
    }
}
