//! The lamps that are known: shipped tables and formulas in a fixed order, each of unit power.
//!
//! A lamp's index is its place in `known_lamps.json`; 255 stands for none, so at most 255 fit.

use crate::languages::with_sign;
use std::sync::LazyLock;

use serde::Deserialize;

use crate::{
    color::{blackbody::C2_CODATA_M_K, quality::daylight_factors},
    languages::{self, Language},
    preset,
    spectrum::{Band, Outside},
};

/// The list: names and formulas, no numbers.
const LIST: &str = include_str!("known_lamps.json");

/// The index that stands for no lamp.
pub(super) const NONE: u8 = 255;

/// Lamps whose cosine with a lamp exceeds this are the lamp itself, or a copy of its table.
pub(super) const ALIKE: f64 = 0.9999;

/// Lamps whose cosine exceeds this are alike: the rule of the principal components' training.
pub(super) const LIKES: f64 = 0.9995;

#[derive(Deserialize)]
struct List {
    lamps: Vec<Entry>,
}

#[derive(Clone, Deserialize)]
#[serde(untagged, deny_unknown_fields)]
enum Entry {
    Table { group: String, name: String },
    Planck { planck: f64 },
    Daylight { cie_daylight: f64 },
}

/// A lamp of the list.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct KnownLamp {
    /// Its place in the list, below 255.
    pub index: u8,
    /// `group/name` of its preset; `None` for a formula.
    pub key: Option<String>,
    /// The preset's name, which tables of one lamp at several steps share; empty for a formula.
    pub name: String,
    /// Its display name: the preset's name, "blackbody 2600 K", "daylight 5700 K".
    pub title: String,
}

/// A lamp's values on a band's grid, of trapezoid integral 1.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Atom {
    /// The lamp's index.
    pub index: u8,
    /// One value a grid point, per nm.
    pub values: Vec<f64>,
}

static ENTRIES: LazyLock<Vec<Entry>> = LazyLock::new(|| {
    let list: List = serde_json::from_str(LIST).expect("a shipped list, read in a test");
    list.lamps
});

static LAMPS: LazyLock<Vec<KnownLamp>> = LazyLock::new(|| {
    let entries = ENTRIES.iter().enumerate();
    entries
        .map(|(index, entry)| {
            let (key, name) = match entry {
                Entry::Table { group, name } => (Some(format!("{group}/{name}")), name.clone()),
                Entry::Planck { .. } | Entry::Daylight { .. } => (None, String::new()),
            };
            KnownLamp {
                index: index as u8,
                key,
                name,
                title: languages::in_language(Language::English, || title(entry)),
            }
        })
        .collect()
});

/// Every known lamp, by index.
pub(crate) fn known_lamps() -> &'static [KnownLamp] {
    &LAMPS
}

/// A lamp's title in the language spoken.
pub(super) fn title_of(index: u8) -> Option<String> {
    ENTRIES.get(usize::from(index)).map(title)
}

/// The indices of the lamps of a name, which are the tables of one lamp at several steps.
pub(crate) fn namesakes(name: &str) -> Vec<u8> {
    let is_called = |lamp: &&KnownLamp| !name.is_empty() && lamp.name.eq_ignore_ascii_case(name);
    let called = LAMPS.iter().filter(is_called);
    called.map(|lamp| lamp.index).collect()
}

/// A name that no other lamp of the list has.
fn title(entry: &Entry) -> String {
    match entry {
        Entry::Planck { planck } => tr!(
            "blackbody {kelvin} K",
            kelvin = with_sign(planck.to_string())
        ),
        Entry::Daylight { cie_daylight } => tr!(
            "daylight {kelvin} K",
            kelvin = with_sign(cie_daylight.to_string())
        ),
        Entry::Table { group, name } => {
            let is_same =
                |other: &Entry| matches!(other, Entry::Table { name: n, .. } if n == name);
            if ENTRIES.iter().filter(|other| is_same(other)).count() < 2 {
                return name.clone();
            }
            let step = if group.ends_with("5nm") {
                "5 nm"
            } else {
                "1 nm"
            };
            tr!("{name} ({step} table)", name, step)
        }
    }
}

/// The known lamps on a band's grid; left out are those whose table does not cover the band.
pub(crate) fn atoms_on(band: Band) -> Vec<Atom> {
    let mut atoms = Vec::with_capacity(ENTRIES.len());
    for (index, entry) in ENTRIES.iter().enumerate() {
        let values = match entry {
            Entry::Table { group, name } => covering(group, name, band),
            Entry::Planck { planck } => Some(blackbody(band, *planck)),
            Entry::Daylight { cie_daylight } => daylight(band, *cie_daylight),
        };
        if let Some(values) = values.and_then(|values| of_unit_power(band, values)) {
            atoms.push(Atom {
                index: index as u8,
                values,
            });
        }
    }
    atoms
}

/// A shipped table on a band's grid; `None` where it does not cover the band.
fn covering(group: &str, name: &str, band: Band) -> Option<Vec<f64>> {
    preset::table(group, name)
        .filter(|table| table.first_nm() <= band.min_nm() && table.last_nm() >= band.max_nm())
        .map(|table| table.on_band(band, Outside::Zero))
}

fn of_unit_power(band: Band, mut values: Vec<f64>) -> Option<Vec<f64>> {
    values.iter_mut().for_each(|v| *v = v.max(0.0));
    let power = band.integral(&values);
    let unit = 1.0 / power;
    values.iter_mut().for_each(|v| *v *= unit);
    (power > 0.0 && unit.is_finite()).then_some(values)
}

/// Planck's law by wavelength, over its largest value on the grid.
fn blackbody(band: Band, kelvin: f64) -> Vec<f64> {
    // In logarithms, so that no power overflows from 1 nm to the far infrared.
    let log = |nm: f64| {
        let t = C2_CODATA_M_K * 1e9 / (nm * kelvin);
        -5.0 * nm.ln() - t - (-(-t).exp()).ln_1p()
    };
    let logs: Vec<f64> = band.grid().map(|nm| log(nm.max(1.0))).collect();
    let top = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    logs.iter().map(|v| (v - top).exp()).collect()
}

/// Daylight of a colour temperature (CIE 15:2018, 4.1.2), 4000-25000 K; `None` where the shipped
/// components do not cover the band.
fn daylight(band: Band, kelvin: f64) -> Option<Vec<f64>> {
    let [m1, m2] = daylight_factors(kelvin);
    let part = |k: u8| {
        covering(
            "cie_illuminants",
            &format!("CIE daylight component S{k}"),
            band,
        )
    };
    let (mean, first, second) = (part(0)?, part(1)?, part(2)?);
    let sum = mean.iter().zip(first.iter().zip(&second));
    Some(sum.map(|(s0, (s1, s2))| s0 + m1 * s1 + m2 * s2).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn every_lamp_of_the_list_is_found_and_has_a_name_of_its_own() {
        let lamps = known_lamps();
        assert!(!lamps.is_empty() && lamps.len() <= usize::from(NONE));
        let titles: BTreeSet<&str> = lamps.iter().map(|l| l.title.as_str()).collect();
        assert_eq!(titles.len(), lamps.len());
        assert_eq!(
            atoms_on(Band::VISIBLE).len(),
            lamps.len(),
            "all cover 380-780 nm"
        );
    }

    #[test]
    fn every_atom_carries_unit_power() {
        for atom in atoms_on(Band::VISIBLE) {
            // 401 numbers that sum to 1.
            assert!((Band::VISIBLE.integral(&atom.values) - 1.0).abs() < 1e-13);
            assert!(atom.values.iter().all(|v| *v >= 0.0 && v.is_finite()));
        }
    }

    #[test]
    fn a_wider_range_leaves_out_the_tables_that_end_before_it() {
        let wide = Band::new(300.0, 830.0).expect("a range");
        let atoms = atoms_on(wide);
        assert!(atoms.len() < known_lamps().len());
        let formulas = known_lamps()
            .iter()
            .filter(|l| l.title.starts_with("blackbody"))
            .count();
        assert!(atoms.len() >= formulas);
    }
}
