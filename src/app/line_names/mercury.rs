//! Mercury: the vapour in every fluorescent tube and in most discharge lamps.

use super::{
    scene::{Scene, middle},
    table::{HG_BLUE, HG_FAINT, HG_GREEN, HG_VIOLET, HG_YELLOW, TB},
};

/// Mercury's symbol.
pub(super) const HG: &str = "Hg";

/// The violet line is weaker than the blue one; other lines may stand in it where all four are
/// seen.
const VIOLET_AT_MOST: [f64; 2] = [1.3, 2.0];
/// A phosphor's hump under the yellow pair may be this wide, nm.
const WIDEST_YELLOW_NM: f64 = 20.0;
/// A faint line has at most this share of the blue one.
const FAINT: f64 = 0.1;
/// A faint line is not wider than this, nm.
const WIDEST_FAINT_NM: f64 = 8.0;

/// How many of mercury's violet, green and yellow stand beside its blue; `None` where mercury is
/// not there.
pub(super) fn witnesses(scene: &Scene<'_>) -> Option<usize> {
    let blue = scene.near(HG_BLUE)?;
    let violet = scene.near(HG_VIOLET);
    // On coarse data terbium's green band swallows the green line.
    let green = scene
        .near(HG_GREEN)
        .or_else(|| (!scene.is_fine).then(|| scene.between(TB[1].within_nm))?);
    let seen = [violet, green, yellow(scene)].iter().flatten().count();
    let most = VIOLET_AT_MOST[usize::from(seen == 3)];
    let is_in_order = scene.height(violet) <= most * scene.height(Some(blue));
    (seen >= if scene.is_fine { 1 } else { 2 } && is_in_order).then_some(seen)
}

/// Names mercury's lines; the green one only where terbium has no band around it.
pub(super) fn name_mercury(scene: &mut Scene<'_>, with_terbium: bool, with_phosphor: bool) {
    let blue = scene.height(scene.near(HG_BLUE));
    let mut lines = vec![HG_VIOLET, HG_BLUE];
    if !with_terbium {
        lines.push(HG_GREEN);
    }
    for line in lines {
        scene.name_near(HG, &[line]);
    }
    let mut both: Vec<usize> = Vec::new();
    if scene.is_fine {
        both.extend(HG_YELLOW.iter().filter_map(|nm| scene.near(*nm)));
    }
    both.extend(yellow(scene).filter(|_| !with_terbium));
    if both.is_empty() && !with_terbium {
        let reach = scene.reach_nm + half_the_pair();
        both.extend(scene.highest(|peak| {
            (peak.at_nm - middle(&HG_YELLOW)).abs() <= reach && peak.width_nm() <= WIDEST_YELLOW_NM
        }));
    }
    scene.name_peak(both, HG, &HG_YELLOW);
    if with_phosphor {
        return;
    }
    for line in HG_FAINT {
        let peak = scene.within(line, 0.5 * scene.reach_nm).filter(|peak| {
            let peak = scene.peaks[*peak];
            peak.height < FAINT * blue && peak.width_nm() <= WIDEST_FAINT_NM
        });
        scene.name_peak(peak, HG, &[line]);
    }
}

/// The yellow pair, or its stronger half.
fn yellow(scene: &Scene<'_>) -> Option<usize> {
    scene.within(middle(&HG_YELLOW), scene.reach_nm + half_the_pair())
}

fn half_the_pair() -> f64 {
    0.5 * (HG_YELLOW[1] - HG_YELLOW[0])
}
