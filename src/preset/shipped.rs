//! The texts of the shipped files.

use std::sync::OnceLock;

use super::group::Group;
use crate::spectrum::Sampled;

// Statics: a constant may stand in the program once for each place that uses it.

/// The shipped files, in the order in which the library lists their groups.
pub(super) static SHIPPED: [&str; 24] = [
    include_str!("../../presets/cie_illuminants.json"),
    include_str!("../../presets/cie_fluorescent_1nm.json"),
    include_str!("../../presets/cie_fluorescent_5nm.json"),
    include_str!("../../presets/cie_led_1nm.json"),
    include_str!("../../presets/cie_led_5nm.json"),
    include_str!("../../presets/cie_hp_5nm.json"),
    include_str!("../../presets/lamps_nist_traditional.json"),
    include_str!("../../presets/lamps_nist_philips.json"),
    include_str!("../../presets/lamps_nist_led.json"),
    include_str!("../../presets/lamps_rit.json"),
    include_str!("../../presets/lamps_common.json"),
    include_str!("../../presets/solar_astm_g173.json"),
    include_str!("../../presets/paper.json"),
    include_str!("../../presets/atomic_lines.json"),
    include_str!("../../presets/colorchecker_ohta.json"),
    include_str!("../../presets/cri_tcs.json"),
    include_str!("../../presets/nist_cqs_vs.json"),
    include_str!("../../presets/tm30_ces99_5nm.json"),
    include_str!("../../presets/pmc_chart.json"),
    include_str!("../../presets/aces_training_190.json"),
    include_str!("../../presets/metals_refractiveindex.json"),
    include_str!("../../presets/usgs_splib07.json"),
    include_str!("../../presets/filters_glass_cc0.json"),
    include_str!("../../presets/observers.json"),
];

/// Descriptions of the shipped spectra, in words.
pub(crate) static FAMILIES: &str = include_str!("../../presets/families.json");

/// The set of shipped surfaces under everyday names.
pub(crate) static EVERYDAY: &str = include_str!("../../presets/everyday_surfaces.json");

/// Tables that figures are computed from and that no library lists: it has their items already, in
/// a coarser step.
pub(super) static UNLISTED: [&str; 1] = [include_str!("../../presets/tm30_ces99_1nm.json")];

/// The groups in the order of their files, those that no library lists last, each read when it is
/// first asked for.
static GROUPS: [OnceLock<Group>; SHIPPED.len() + UNLISTED.len()] =
    [const { OnceLock::new() }; SHIPPED.len() + UNLISTED.len()];

fn texts() -> impl Iterator<Item = &'static str> {
    SHIPPED.into_iter().chain(UNLISTED)
}

fn read(index: usize, text: &str) -> &'static Group {
    GROUPS[index].get_or_init(|| {
        Group::from_json(text).expect("a shipped file, read in a test of this room")
    })
}

/// The shipped group with an id, listed or not.
pub fn group(id: &str) -> Option<&'static Group> {
    // What a group is called stands in the first lines of its file: no other file is read for it.
    let stated = format!("\"group\":\"{id}\"");
    let is_it = |text: &str| text.lines().take(6).any(|line| line.contains(&stated));
    let (index, text) = texts().enumerate().find(|(_, text)| is_it(text))?;
    Some(read(index, text))
}

/// All groups that a library lists, in its order.
pub(crate) fn groups() -> impl Iterator<Item = &'static Group> {
    let listed = SHIPPED.into_iter().enumerate();
    listed.map(|(index, text)| read(index, text))
}

/// The groups that figures are computed from and that no library lists.
pub(crate) fn unlisted() -> impl Iterator<Item = &'static Group> {
    let behind = UNLISTED.into_iter().zip(SHIPPED.len()..);
    behind.map(|(text, index)| read(index, text))
}

/// A shipped table by its group and name.
pub fn table(group_id: &str, name: &str) -> Option<&'static Sampled> {
    let item = group(group_id)?
        .items
        .iter()
        .find(|item| item.name == name)?;
    item.spectrum().map(|spectrum| &spectrum.samples)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_shipped_group_is_found_by_its_id() {
        for text in texts() {
            let stated = Group::from_json(text).expect("a shipped file");
            assert_eq!(group(&stated.id), Some(&stated));
        }
        assert_eq!(groups().count(), SHIPPED.len());
        assert_eq!(group("tm30_ces99"), None);
        assert!(table("cie_fluorescent_1nm", "FL2").is_some());
        assert!(table("cie_fluorescent_1nm", "FL200").is_none());
    }

    #[test]
    fn what_is_not_listed_is_listed_in_a_coarser_step_under_the_same_terms() {
        for text in UNLISTED {
            let fine = Group::from_json(text).expect("a shipped file");
            let coarse = fine.id.replace("_1nm", "_5nm");
            let coarse = groups().find(|group| group.id == coarse);
            let coarse = coarse.expect("the listed group");
            assert_eq!(fine.licence, coarse.licence);
            assert_eq!(fine.attribution, coarse.attribution);
            assert_eq!(fine.items.len(), coarse.items.len());
            for (fine, coarse) in fine.items.iter().zip(&coarse.items) {
                assert_eq!(fine.name, coarse.name);
                let table = |preset: &crate::preset::Preset| {
                    preset.spectrum().expect("a table").samples.clone()
                };
                let (fine, coarse) = (table(fine), table(coarse));
                for (nm, value) in coarse.nm().iter().zip(coarse.values()) {
                    assert_eq!(fine.at(*nm, crate::spectrum::Outside::Zero), *value);
                }
            }
        }
    }
}
