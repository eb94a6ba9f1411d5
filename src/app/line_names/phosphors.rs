//! Phosphors that shine in narrow bands: terbium and europium.

use super::{
    mercury::HG,
    scene::{BandTold, Scene, Told},
    table::{BandOf, EU_OXIDE, EU_VANADATE, HG_GREEN, NO_EU, TB},
};
use crate::languages::fixed;

/// Symbols of the phosphors' elements.
pub(super) const TERBIUM: &str = "Tb";
pub(super) const EUROPIUM: &str = "Eu";

/// Terbium's green band is at least so many times as high as its others.
const TB_GREEN_OVER: f64 = 2.0;
/// Its blue-green band has at least this share of the green one.
const TB_BLUE_AT_LEAST: f64 = 0.02;
/// Europium's red band is at least so many times as high as its others.
const EU_RED_OVER: f64 = 1.5;

/// The host that europium stands in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Host {
    /// Yttrium oxide.
    Oxide,
    /// Yttrium vanadate.
    Vanadate,
}

/// Whether terbium's bands are there, the green one the highest.
pub(super) fn has_terbium(scene: &Scene<'_>) -> bool {
    let [blue, green, yellow, red] = TB.each_ref().map(|band| scene.between(band.within_nm));
    let height = scene.height(green);
    blue.is_some()
        && (yellow.is_some() || red.is_some())
        && height >= TB_GREEN_OVER * scene.highest_of([blue, yellow])
        && scene.height(blue) > TB_BLUE_AT_LEAST * height
}

/// The host whose europium bands are there, the red one the highest.
pub(super) fn host_of_europium(scene: &Scene<'_>) -> Option<Host> {
    let seen = |band: &BandOf| scene.between(band.within_nm);
    let elsewhere = scene.between(NO_EU);
    let [orange, beside, red, deep, _, far] = EU_OXIDE.each_ref().map(seen);
    let is_highest = |red: Option<usize>, others: [Option<usize>; 4]| {
        red.is_some() && scene.height(red) >= EU_RED_OVER * scene.highest_of(others)
    };
    if is_highest(red, [orange, beside, deep, elsewhere])
        && (far.is_some() || deep.is_some() && orange.is_some())
    {
        return Some(Host::Oxide);
    }
    let [orange, red, deep, far] = EU_VANADATE.each_ref().map(seen);
    let others = [orange, deep, elsewhere, None];
    let is_there = is_highest(red, others) && far.is_some() && (orange.is_some() || deep.is_some());
    is_there.then_some(Host::Vanadate)
}

/// Names terbium's bands; where mercury is there, its green line stands in the green one.
pub(super) fn name_terbium(scene: &mut Scene<'_>) {
    for band in &TB {
        let has_green = (band.within_nm[0]..=band.within_nm[1]).contains(&HG_GREEN);
        let with = (has_green && scene.has(HG)).then(|| scene.name_of(HG, &[HG_GREEN]).words);
        let words = tr!("terbium band {nm}", nm = fixed(band.about_nm, 0));
        name_band(scene, (TERBIUM, words), band, with.as_deref());
    }
}

/// Names europium's bands.
pub(super) fn name_europium(scene: &mut Scene<'_>, host: Host) {
    let bands: &[BandOf] = match host {
        Host::Oxide => &EU_OXIDE,
        Host::Vanadate => &EU_VANADATE,
    };
    for band in bands {
        let words = tr!("europium band {nm}", nm = fixed(band.about_nm, 0));
        name_band(scene, (EUROPIUM, words), band, None);
    }
}

fn name_band(
    scene: &mut Scene<'_>,
    (symbol, words): (&'static str, String),
    band: &BandOf,
    with: Option<&str>,
) {
    let told = match with {
        Some(line) => Told {
            symbol,
            words: tr!("{band}, with {line} in it", band = words, line),
            label: tr!("{symbol} band + {line}", symbol, line),
            is_reversed: false,
        },
        None => Told {
            symbol,
            words,
            label: tr!("{symbol} band {nm}", symbol, nm = fixed(band.about_nm, 0)),
            is_reversed: false,
        },
    };
    while let Some(peak) = scene.between(band.within_nm) {
        scene.tell([peak], &told);
    }
    scene.bands.push(BandTold {
        about_nm: band.about_nm,
        within_nm: band.within_nm,
        told,
    });
}
