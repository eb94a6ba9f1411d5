//! Metal halide lamps: sodium, thallium, scandium, lithium, indium and dysprosium.
//!
//! Most of these have one or two lines in the visible, which prove nothing by themselves. They are
//! named beside sodium or mercury only, and only where they are among the strongest.

use super::{
    mercury::HG,
    scene::{Scene, Told, is_line},
    sodium::{self, Yellow, candidate, name_others, name_yellow},
    table::{
        DY_OTHERS, DY_STRONGEST, HG_GREEN, IN_BLUE, IN_VIOLET, LI_RED, NA_OTHERS, SC_GROUPS,
        SC_STRONGEST, SC_YELLOW, TL_GREEN,
    },
};

/// Symbols.
pub(super) const HALIDES: [&str; 5] = [TL, "Sc", "Li", "In", "Dy"];
const TL: &str = "Tl";
const SC: &str = "Sc";
const LI: &str = "Li";
const IN: &str = "In";
const DY: &str = "Dy";

/// Thallium's green line has at least this share of mercury's: scandium has lines there too.
const TL_BESIDE_HG: f64 = 0.5;
/// A broadened thallium line stands within these places, nm.
const TL_BROADENED_NM: [f64; 2] = [532.0, 540.0];
/// Groups of scandium's lines that must be seen.
const SC_LEAST: usize = 4;
/// Lithium's red line has at least this share of the highest value.
const LI_AT_LEAST: f64 = 0.03;
/// Indium's blue line has at least this share of its violet one.
const IN_BLUE_OVER: f64 = 0.7;
/// Lines of dysprosium that must be seen beside the strongest.
const DY_LEAST: usize = 2;

/// Names sodium and the halides, where they are there. Where terbium or europium shines there are
/// no halides.
pub(super) fn name_sodium_and_halides(scene: &mut Scene<'_>) {
    let has_mercury = scene.has(HG);
    let thallium = thallium(scene);
    let mut yellow = sodium::yellow(scene);
    // Thallium and sodium are witnesses of each other beside mercury.
    if yellow.is_none() && thallium.is_some() && has_mercury {
        yellow = high_candidate(scene);
    }
    let thallium = thallium.filter(|_| yellow.is_some() || has_mercury);
    scene.name_peak(thallium, TL, &[TL_GREEN]);
    let is_reversed = matches!(yellow, Some(Yellow::Reversed(_)));
    let scandium = scandium(scene).filter(|_| (yellow.is_some() || has_mercury) && !is_reversed);
    if yellow.is_none() && scandium.is_some() {
        yellow = high_candidate(scene);
    }
    if let Some(yellow) = &yellow {
        name_yellow(scene, yellow);
    }
    if let Some(groups) = scandium {
        name_scandium(scene, groups, yellow.is_some());
    }
    let has_halides = thallium.is_some() || scandium.is_some();
    if yellow.is_some() {
        name_others(scene, is_reversed && !has_halides);
    }
    if has_halides {
        name_lithium_and_indium(scene);
        name_dysprosium(scene);
    }
}

/// The yellow line that would be sodium's, where it is one of the strongest.
fn high_candidate(scene: &Scene<'_>) -> Option<Yellow> {
    candidate(scene).filter(|yellow| match yellow {
        Yellow::Plain(peak) | Yellow::Broadened(peak) => scene.is_of_the_three_highest(*peak),
        Yellow::Reversed(_) => false,
    })
}

/// The green line that would be thallium's, broadened or not.
fn thallium(scene: &Scene<'_>) -> Option<usize> {
    let [from, to] = TL_BROADENED_NM;
    let peak = scene.near(TL_GREEN).or_else(|| {
        scene.highest(|peak| {
            is_line(peak) && (from..=to).contains(&peak.at_nm) && peak.is_over(TL_GREEN)
        })
    })?;
    // Mercury's green line may have its name already.
    let green = scene
        .peaks
        .iter()
        .filter(|p| (p.at_nm - HG_GREEN).abs() <= scene.reach_nm);
    let green = green.fold(0.0_f64, |highest, p| highest.max(p.height));
    let is_strong = scene.peaks[peak].height >= TL_BESIDE_HG * green;
    (is_strong && scene.is_of_the_three_highest(peak)).then_some(peak)
}

/// The groups of scandium's lines; `None` where too few are there.
fn scandium(scene: &Scene<'_>) -> Option<[Option<usize>; 7]> {
    let groups = SC_GROUPS.map(|(at_nm, half_nm)| scene.within(at_nm, scene.reach_nm + half_nm));
    // Mercury's violet line may stand in the group at 402 nm, and then is no witness.
    let is_there = SC_STRONGEST.iter().all(|group| groups[*group].is_some());
    let seen = groups.iter().flatten().count();
    (is_there && seen >= SC_LEAST).then_some(groups)
}

fn name_scandium(scene: &mut Scene<'_>, groups: [Option<usize>; 7], with_sodium: bool) {
    for (index, ((at_nm, _), peak)) in SC_GROUPS.iter().zip(groups).enumerate() {
        let Some(peak) = peak.filter(|peak| scene.told[*peak].is_none()) else {
            continue;
        };
        let mut told = Told::plain(SC, format!("{SC} {at_nm:.0}"));
        if index == SC_YELLOW && with_sodium {
            let sodium = scene.name_of(sodium::NA, &NA_OTHERS[0]).words;
            told = Told {
                words: tr!(
                    "{scandium}, with {sodium} in it",
                    scandium = told.words,
                    sodium
                ),
                label: format!("{SC} + {sodium}"),
                ..told
            };
        }
        scene.tell([peak], &told);
    }
}

fn name_lithium_and_indium(scene: &mut Scene<'_>) {
    let least = LI_AT_LEAST * scene.points.top();
    let lithium = scene.near(LI_RED);
    let lithium = lithium.filter(|peak| scene.peaks[*peak].height > least);
    scene.name_peak(lithium, LI, &[LI_RED]);
    if let (Some(blue), Some(violet)) = (scene.near(IN_BLUE), scene.near(IN_VIOLET))
        && scene.peaks[blue].height >= IN_BLUE_OVER * scene.peaks[violet].height
    {
        for (peak, line) in [(blue, IN_BLUE), (violet, IN_VIOLET)] {
            scene.name_peak([peak], IN, &[line]);
        }
    }
}

fn name_dysprosium(scene: &mut Scene<'_>) {
    if !scene.is_fine {
        return;
    }
    let is_there = DY_STRONGEST.iter().all(|nm| scene.near(*nm).is_some());
    let others = DY_OTHERS.iter().filter(|nm| scene.near(**nm).is_some());
    if !is_there || others.count() < DY_LEAST {
        return;
    }
    for (at_nm, _) in scene.lines_of(DY) {
        scene.name_near(DY, &[at_nm]);
    }
}
