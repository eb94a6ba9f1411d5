//! The shipped tables that the room needs, read once.

use std::sync::LazyLock;

use crate::{
    preset::{Group, SHIPPED},
    spectrum::{Band, Sampled},
};

/// Groups that known lamps, patches and judges come from.
const NEEDED: [&str; 13] = [
    "cie_fluorescent_1nm",
    "cie_fluorescent_5nm",
    "cie_hp_5nm",
    "cie_led_1nm",
    "cie_illuminants",
    "lamps_nist_led",
    "lamps_nist_philips",
    "lamps_nist_traditional",
    "lamps_rit",
    "lamps_common",
    PATCHES,
    JUDGES,
    "cri_tcs",
];

/// The reflectances that choose.
pub(super) const PATCHES: &str = "colorchecker_ohta";

/// The reflectances that judge.
pub(super) const JUDGES: &str = "tm30_ces99_5nm";

static GROUPS: LazyLock<Vec<Group>> = LazyLock::new(|| {
    let is_needed = |text: &str| {
        // A file says its group in its first lines; no other file is read for it.
        let head = text.get(..200).unwrap_or(text);
        NEEDED
            .iter()
            .any(|id| head.contains(&format!("\"group\":\"{id}\"")))
    };
    let needed = SHIPPED.iter().filter(|text| is_needed(text));
    needed
        .filter_map(|text| Group::from_json(text).ok())
        .collect()
});

/// A shipped table by its group and name.
pub fn table(group: &str, name: &str) -> Option<&'static Sampled> {
    let group = GROUPS.iter().find(|g| g.id == group)?;
    let preset = group.items.iter().find(|p| p.name == name)?;
    preset.spectrum().map(|spectrum| &spectrum.samples)
}

/// Names and values on a band's grid of a group's tables.
pub(super) fn reflectances(group: &str, band: Band) -> (Vec<String>, Vec<Vec<f64>>) {
    let group = GROUPS.iter().find(|g| g.id == group);
    let tables = group
        .into_iter()
        .flat_map(|g| &g.items)
        .filter_map(|p| p.spectrum());
    tables
        .map(|s| (s.name.clone(), s.samples.on_band(band, s.kind.outside())))
        .unzip()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_needed_group_is_shipped_and_read() {
        let found: Vec<&str> = GROUPS.iter().map(|g| g.id.as_str()).collect();
        for id in NEEDED {
            assert!(found.contains(&id), "{id}");
        }
        assert_eq!(reflectances(PATCHES, Band::VISIBLE).0.len(), 24);
        assert_eq!(reflectances(JUDGES, Band::VISIBLE).0.len(), 99);
    }
}
