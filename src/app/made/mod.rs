//! What the library holds that nobody measured: line tubes, lasers, black bodies, gels and filters,
//! made from tables and formulas and marked as made, and the set of everyday surfaces, which
//! gathers shipped tables under names that people use.
//!
//! They stand beside the shipped groups and in none of them: what a study says of all shipped
//! lights or surfaces it says of tables.

mod everyday;
mod filters;
mod gels;
mod thermal;
mod tubes;

pub(super) use everyday::EVERYDAY_SET;

use crate::preset::{Body, Group, Preset, Terms};
use crate::spectrum::{Kind, NamedSpectrum, Sampled};

/// Ids of the groups whose spectra are made.
const MADE: [&str; 5] = [
    tubes::TUBES,
    tubes::LASERS,
    thermal::THERMAL,
    gels::GELS,
    filters::FILTERS,
];

/// The groups that are made.
pub(super) fn groups() -> Vec<Group> {
    let mut groups = tubes::groups();
    groups.push(thermal::group());
    groups.push(gels::group());
    groups.push(filters::group());
    groups.extend(everyday::group());
    groups
}

/// What is made when it is asked for by a name that says how: an ideal filter at any place, a
/// black body of any temperature.
pub(super) fn on_demand(name: &str) -> Option<Preset> {
    let name = name.trim();
    let plain = name.split_once('/').map_or(name, |(group, rest)| {
        if MADE.contains(&group.to_lowercase().as_str()) {
            rest
        } else {
            name
        }
    });
    filters::on_demand(plain).or_else(|| thermal::on_demand(plain))
}

/// Whether a spectrum of the library was made, by `group/name`.
pub fn is_made(id: &str) -> bool {
    id.split_once('/')
        .is_some_and(|(group, _)| MADE.contains(&group))
}

/// The terms of what the program made from nothing but a formula.
fn nobodys() -> Terms {
    Terms {
        id: "LicenseRef-facts".to_owned(),
        words: "made by this program from a formula; no rights claimed".to_owned(),
    }
}

/// A table as an item of a group that has no items yet.
fn item(group: &Group, name: &str, unit: &str, notes: Vec<String>, samples: Sampled) -> Preset {
    let spectrum = NamedSpectrum {
        name: name.to_owned(),
        kind: group.kind,
        unit: unit.to_owned(),
        scale: 1.0,
        samples,
        notes: notes.clone(),
        source: group.source.clone(),
    };
    preset(group, name, unit, notes, Body::Spectrum(spectrum))
}

fn preset(group: &Group, name: &str, unit: &str, notes: Vec<String>, body: Body) -> Preset {
    Preset {
        group: group.id.clone(),
        name: name.to_owned(),
        kind: group.kind,
        shelf: group.shelf,
        unit: unit.to_owned(),
        source: group.source.clone(),
        licence: group.licence.clone(),
        notes,
        thickness_mm: None,
        optical: None,
        body,
    }
}

/// The range of tables that are made by a formula, nm.
const RANGE_NM: [f64; 2] = [300.0, 1100.0];

/// Such a table, of whole nm.
fn by_formula(of: impl Fn(f64) -> f64) -> Option<Sampled> {
    let [first_nm, last_nm] = RANGE_NM;
    let count = (last_nm - first_nm) as usize;
    let values = (0..=count).map(|i| of(first_nm + i as f64));
    Sampled::even(first_nm, 1.0, values.collect()).ok()
}

/// A group without items.
fn empty(id: &str, title: &str, shelf: crate::preset::Shelf, kind: Kind, source: &str) -> Group {
    Group {
        id: id.to_owned(),
        title: title.to_owned(),
        shelf,
        kind,
        source: source.to_owned(),
        licence: nobodys(),
        attribution: "made by this program".to_owned(),
        changes: "Everything: no number was measured.".to_owned(),
        note: String::new(),
        items: Vec::new(),
    }
}

#[cfg(test)]
mod tests;
