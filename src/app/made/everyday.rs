//! The set of everyday surfaces: shipped tables under names that people use.

use serde::Deserialize;

use super::empty;
use crate::{
    preset::{self, Body, EVERYDAY, Group, Preset, Shelf},
    spectrum::Kind,
};

/// Id of the set, which patches can be taken from.
pub(crate) const EVERYDAY_SET: &str = "everyday_surfaces";

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(rename = "format")]
    _format: String,
    #[serde(rename = "version")]
    _version: u32,
    title: String,
    note: String,
    items: Vec<Named>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Named {
    /// The everyday name.
    name: String,
    /// The table, `group/name`.
    of: String,
}

/// The set, from the groups of the shipped files.
pub(super) fn group() -> Option<Group> {
    let file: File = serde_json::from_str(EVERYDAY).ok()?;
    let find = |id: &str| {
        let (group, name) = id.split_once('/')?;
        let items = &preset::group(group)?.items;
        items.iter().find(|item| item.name == name)
    };
    let named = |Named { name, of }: Named| -> Option<Preset> {
        let mut preset = find(&of)?.clone();
        preset
            .notes
            .insert(0, format!("The table {of} under an everyday name."));
        if let Body::Spectrum(spectrum) = &mut preset.body {
            spectrum.name.clone_from(&name);
            spectrum.notes.clone_from(&preset.notes);
        }
        preset.group = EVERYDAY_SET.to_owned();
        preset.name = name;
        Some(preset)
    };
    let items: Vec<Preset> = file.items.into_iter().filter_map(named).collect();
    let mut group = empty(
        EVERYDAY_SET,
        &file.title,
        Shelf::Reflectances,
        Kind::Reflectance,
        "tables of other groups, each named with its item",
    );
    group.licence.words = "as the group that each item is taken from".to_owned();
    group.attribution =
        "the groups that the items are taken from, each named with its item".to_owned();
    group.changes = "Names only; no number was changed.".to_owned();
    group.note = file.note;
    group.items = items;
    Some(group)
}
