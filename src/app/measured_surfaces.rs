//! All measured surfaces that ship, each once: what more than a few patches tells of a light.
//!
//! Each in one table: TM-30's samples in 5 nm, the CIE's test colours of 1995 with the skin of 2024;
//! not the metals, whose reflectance is computed, and no table with values above 1.

use std::sync::LazyLock;

use super::library::Library;
use crate::{
    color::{Observer, PatchSet},
    preset::Preset,
    spectrum::Band,
};

/// The groups of measured surfaces.
const GROUPS: [&str; 7] = [
    "tm30_ces99_5nm",
    "aces_training_190",
    "cri_tcs",
    "colorchecker_ohta",
    "nist_cqs_vs",
    "pmc_chart",
    "usgs_splib07",
];

/// The test colours of 2024 are those of 1995 again, but for one.
const AGAIN: &str = "CIE 2024: ";
const NOT_AGAIN: &str = "CIE 2024: TCS15";

static MEASURED: LazyLock<Vec<&'static Preset>> = LazyLock::new(|| {
    let groups = GROUPS.iter().filter_map(|id| Library::bundled().group(id));
    let is_one = |preset: &&Preset| {
        let table = preset.spectrum().filter(|table| table.kind.is_factor());
        let is_share = |v: &f64| (0.0..=1.0).contains(v);
        table.is_some_and(|table| table.samples.values().iter().all(is_share))
            && (preset.name == NOT_AGAIN || !preset.name.starts_with(AGAIN))
    };
    groups
        .flat_map(|group| &group.items)
        .filter(is_one)
        .collect()
});

/// All measured surfaces on a band's grid, the ends of their tables held.
pub(super) fn measured_surfaces(band: Band, observer: Observer) -> PatchSet {
    let tables = MEASURED.iter().filter_map(|preset| preset.spectrum());
    let values = tables.map(|table| table.samples.on_band(band, table.kind.outside()));
    let names = MEASURED.iter().map(|preset| preset.name.clone()).collect();
    PatchSet::new(&values.collect::<Vec<_>>(), names, band, observer)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_measured_surface_stands_once() {
        // 99 samples, 190 less 5 above 1, 15 test colours, 24, 30, 30 and 18.
        assert_eq!(MEASURED.len(), 99 + 185 + 15 + 24 + 30 + 30 + 18);
        let tables: Vec<_> = MEASURED.iter().filter_map(|p| p.spectrum()).collect();
        for (i, table) in tables.iter().enumerate() {
            let again = tables[..i].iter().find(|t| t.samples == table.samples);
            assert!(again.is_none(), "{} is {again:?}", table.name);
        }
        // The documents name the count.
        for (text, words) in [
            (include_str!("../../README.md"), "all {} measured ones"),
            (
                include_str!("../../docs/window.md"),
                "the {} measured surfaces",
            ),
        ] {
            let words = words.replace("{}", &MEASURED.len().to_string());
            assert!(text.contains(&words), "{words}");
        }
    }
}
