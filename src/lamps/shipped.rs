//! The shipped reflectances that choose and judge.

use crate::{preset, spectrum::Band};

/// The reflectances that choose.
pub(super) const PATCHES: &str = "colorchecker_ohta";

/// The reflectances that judge.
pub(super) const JUDGES: &str = "tm30_ces99_5nm";

/// Names and values on a band's grid of a group's tables.
pub(super) fn reflectances(group: &str, band: Band) -> (Vec<String>, Vec<Vec<f64>>) {
    let group = preset::group(group);
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
    fn as_many_surfaces_choose_and_judge_as_are_named() {
        assert_eq!(reflectances(PATCHES, Band::VISIBLE).0.len(), 24);
        assert_eq!(reflectances(JUDGES, Band::VISIBLE).0.len(), 99);
    }
}
