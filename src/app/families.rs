//! What each shipped spectrum is, in words: `presets/families.json`, read once.
//!
//! The one place for a lamp's family, what it is in a few words, a sentence about it and the other
//! words that people search it by. Numbers are computed elsewhere (`about`).

use std::{
    collections::{BTreeMap, HashMap},
    sync::LazyLock,
};

use serde::{Deserialize, Deserializer};

use crate::preset::FAMILIES;

/// Spectra of one nature.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Family {
    /// Its word in reports: "three-band".
    pub key: String,
    /// The heading that several families stand under: "Fluorescent".
    pub heading: String,
    /// Its title: "Fluorescent lamps, three bands".
    pub title: String,
    /// One of it: "three-band fluorescent lamp".
    pub one: String,
    /// Words that all of it is found by.
    pub words: Vec<String>,
    /// A question to try on a light of this family; empty where there is none.
    pub question: String,
}

/// What is said of one shipped spectrum.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Item {
    /// `group/name`.
    pub id: String,
    /// Its family's key; the group's where there is none.
    pub family: Option<String>,
    /// What it is in a few words: "cool white fluorescent tube".
    pub what: String,
    /// A sentence about it; may be empty.
    #[serde(default)]
    pub about: String,
    /// Words that it is found by before others.
    #[serde(default)]
    pub words: Vec<String>,
}

/// What is said of all spectra of a group.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Table {
    /// Whose table it is: "CIE table".
    pub of: String,
    /// The family of an item that names none.
    pub family: String,
    /// The step of the data that the table was interpolated from, nm.
    pub from_nm: Option<u32>,
    /// What an item is that says nothing of itself.
    #[serde(default)]
    pub what: String,
    /// Words that all of it is found by.
    #[serde(default)]
    pub words: Vec<String>,
}

/// One of the lights on top of the library.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Favourite {
    /// What people call it: "Bulb".
    pub label: String,
    /// `group/name`.
    pub id: String,
}

/// All that is said of the shipped spectra, as the file has it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Families {
    #[serde(rename = "format")]
    _format: String,
    #[serde(rename = "version")]
    _version: u32,
    #[serde(rename = "note")]
    _note: String,
    #[serde(rename = "families")]
    all: Vec<Family>,
    tables: BTreeMap<String, Table>,
    #[serde(deserialize_with = "by_id")]
    items: HashMap<String, Item>,
    /// Pairs of groups whose items of one name are one lamp, the finer first.
    twins: Vec<[String; 2]>,
    /// Pairs of items that are one light, the first to be shown.
    same: Vec<[String; 2]>,
    favourites: Vec<Favourite>,
}

fn by_id<'de, D: Deserializer<'de>>(list: D) -> Result<HashMap<String, Item>, D::Error> {
    let items = Vec::<Item>::deserialize(list)?.into_iter();
    Ok(items.map(|item| (item.id.clone(), item)).collect())
}

static SHIPPED: LazyLock<Families> = LazyLock::new(|| {
    serde_json::from_str(FAMILIES).expect("the shipped file is read in a test of this module")
});

impl Families {
    /// Those of the shipped spectra.
    pub fn shipped() -> &'static Self {
        &SHIPPED
    }

    /// Every family, in the order of the library.
    pub fn all(&self) -> &[Family] {
        &self.all
    }

    /// The family with a key.
    pub fn family(&self, key: &str) -> Option<&Family> {
        self.all.iter().find(|family| family.key == key)
    }

    /// The family of a shipped spectrum, by `group/name`.
    pub fn family_of(&self, id: &str) -> Option<&Family> {
        let own = self.item(id).and_then(|item| item.family.as_deref());
        self.family(own.or_else(|| Some(self.table_of(id)?.family.as_str()))?)
    }

    /// Where the family of a shipped spectrum stands among all.
    pub fn place_of(&self, id: &str) -> Option<usize> {
        let own = &self.family_of(id)?.key;
        self.all.iter().position(|family| family.key == *own)
    }

    /// What is said of a shipped spectrum, or of the twin that it is shown as.
    pub fn item(&self, id: &str) -> Option<&Item> {
        self.items
            .get(id)
            .or_else(|| self.items.get(&self.finer(id)?))
    }

    /// What is said of its group.
    pub fn table_of(&self, id: &str) -> Option<&Table> {
        self.tables.get(id.split_once('/')?.0)
    }

    /// The spectrum that another is shown as, where both are one light: the CIE's 1 nm tables for
    /// its 5 nm ones, its A for the copy of it.
    pub fn shown_as(&self, id: &str) -> Option<String> {
        let same = self.same.iter().find(|[_, folded]| folded == id);
        same.map(|[shown, _]| shown.clone())
            .or_else(|| self.finer(id))
    }

    /// The twelve lights on top of the library.
    pub fn favourites(&self) -> &[Favourite] {
        &self.favourites
    }

    fn finer(&self, id: &str) -> Option<String> {
        let (group, name) = id.split_once('/')?;
        let pair = self.twins.iter().find(|[_, coarse]| coarse == group)?;
        Some(format!("{}/{name}", pair[0]))
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::app::library::Library;

    #[test]
    fn the_file_is_read_and_speaks_of_what_is_shipped_only() {
        let families = Families::shipped();
        let library = Library::bundled();
        let ids: BTreeSet<String> = library.everything().map(|preset| preset.id()).collect();
        for id in families.items.keys() {
            assert!(ids.contains(id), "{id}");
        }
        for [shown, folded] in &families.same {
            assert!(ids.contains(shown) && ids.contains(folded), "{folded}");
        }
        for favourite in families.favourites() {
            assert!(ids.contains(&favourite.id), "{}", favourite.id);
        }
        for item in families.items.values() {
            let mut key = item.family.iter();
            assert!(key.all(|key| families.family(key).is_some()), "{}", item.id);
        }
        for table in families.tables.values() {
            assert!(families.family(&table.family).is_some(), "{}", table.of);
        }
        for id in &ids {
            assert!(families.family_of(id).is_some(), "{id}");
        }
    }

    #[test]
    fn each_5_nm_twin_is_shown_as_its_1_nm_table() {
        let families = Families::shipped();
        assert_eq!(
            families.shown_as("cie_fluorescent_5nm/FL2").as_deref(),
            Some("cie_fluorescent_1nm/FL2")
        );
        assert_eq!(families.shown_as("cie_fluorescent_1nm/FL2"), None);
        assert_eq!(
            families.shown_as("lamps_rit/SA").as_deref(),
            Some("cie_illuminants/CIE A")
        );
        let library = Library::bundled();
        for preset in library.everything() {
            if let Some(shown) = families.shown_as(&preset.id()) {
                assert!(library.find(&shown).is_ok(), "{shown}");
            }
        }
    }

    #[test]
    fn there_are_twelve_favourites() {
        let favourites = Families::shipped().favourites();
        assert_eq!(favourites.len(), 12);
        let labels: BTreeSet<&str> = favourites.iter().map(|f| f.label.as_str()).collect();
        assert_eq!(labels.len(), 12);
    }
}
