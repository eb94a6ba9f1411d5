//! Finding a spectrum by what people call it: the library's rows, folded, and the search over them.
//!
//! A light that is there twice (a 1 nm and a 5 nm table of one lamp) is one row. What is typed is
//! looked for among favourites, the words written for each spectrum, names, what each is, its
//! family's words, and only then inside of words; every word typed must be found. Of equals the
//! favourite comes first, then surfaces by everyday names, lights, what was measured, and the
//! library's order. The first row is what Enter takes.

mod score;

use std::{collections::HashMap, sync::Arc};

use super::{
    about::About,
    entry::Entry,
    families::Families,
    made::{EVERYDAY_SET, is_made},
};
use score::{Doc, Score};

/// A row of the library: an entry, and those that are the same light in another table.
#[derive(Clone, Debug, PartialEq)]
pub struct Folded {
    /// The entry to show.
    pub entry: Arc<Entry>,
    /// Its twins.
    pub twins: Vec<Arc<Entry>>,
}

/// One of the lights on top of the library.
#[derive(Clone, Debug, PartialEq)]
pub struct Favourite {
    /// What people call it: "Bulb".
    pub label: &'static str,
    /// The light.
    pub entry: Arc<Entry>,
}

/// Entries in rows, in their order; a twin whose light is not among them is a row of its own.
pub fn fold<'a>(entries: impl IntoIterator<Item = &'a Arc<Entry>>) -> Vec<Folded> {
    let entries: Vec<&Arc<Entry>> = entries.into_iter().collect();
    let families = Families::shipped();
    let mut rows: Vec<Folded> = Vec::new();
    let mut places: HashMap<&str, usize> = HashMap::new();
    let mut twins = Vec::new();
    let keys: std::collections::HashSet<&str> = entries.iter().map(|e| e.key.as_str()).collect();
    for entry in entries {
        match families.shown_as(&entry.key) {
            Some(shown) if keys.contains(shown.as_str()) => twins.push((shown, entry)),
            _ => {
                places.insert(&entry.key, rows.len());
                rows.push(Folded {
                    entry: entry.clone(),
                    twins: Vec::new(),
                });
            }
        }
    }
    for (shown, twin) in twins {
        if let Some(place) = places.get(shown.as_str()) {
            rows[*place].twins.push(twin.clone());
        }
    }
    rows
}

/// The twelve lights on top of the library, as far as they are among some entries.
pub fn favourites(entries: &[Arc<Entry>]) -> Vec<Favourite> {
    let find = |id: &str| entries.iter().find(|entry| entry.key == id);
    let favourites = Families::shipped().favourites().iter();
    favourites
        .filter_map(|favourite| {
            Some(Favourite {
                label: &favourite.label,
                entry: find(&favourite.id)?.clone(),
            })
        })
        .collect()
}

/// What can be searched, made once for some entries: nothing of it depends on what is typed.
#[derive(Clone, Debug, Default)]
pub struct Index {
    rows: Vec<(Folded, Doc)>,
}

impl Index {
    /// The index of some entries, in the library's order.
    pub fn of<'a>(entries: impl IntoIterator<Item = &'a Arc<Entry>>) -> Self {
        let rows = fold(entries).into_iter();
        Self {
            rows: rows
                .map(|row| {
                    let doc = doc_of(&row);
                    (row, doc)
                })
                .collect(),
        }
    }

    /// The rows that what is typed means, the best first: Enter takes it. Nothing typed is all
    /// rows in their order. Where nothing is called that, what is called nearly that.
    pub fn search(&self, typed: &str) -> Vec<Folded> {
        let typed = score::plain(typed);
        if typed.is_empty() {
            return self.rows.iter().map(|(row, _)| row.clone()).collect();
        }
        let found = self.ranked(|doc| doc.score(&typed));
        if found.is_empty() {
            self.ranked(|doc| doc.nearly(&typed))
        } else {
            found
        }
    }

    fn ranked(&self, score: impl Fn(&Doc) -> Option<Score>) -> Vec<Folded> {
        let rows = self.rows.iter();
        let mut found: Vec<(Score, &Folded)> = rows
            .filter_map(|(row, doc)| Some((score(doc)?, row)))
            .collect();
        // A stable sort keeps the library's order among equals.
        found.sort_by_key(|found| std::cmp::Reverse(found.0));
        found.into_iter().map(|(_, row)| row.clone()).collect()
    }
}

fn doc_of(row: &Folded) -> Doc {
    let (entry, families) = (&row.entry, Families::shipped());
    let about = About::words_of(entry);
    let favourite = families.favourites().iter().find(|f| f.id == entry.key);
    let item = families.item(&entry.key);
    let table = families.table_of(&entry.key);
    let family = entry.shelf().and_then(|_| families.family_of(&entry.key));
    let mut ids = vec![entry.key.clone()];
    ids.extend(row.twins.iter().map(|twin| twin.key.clone()));
    let mut of_all: Vec<String> = Vec::new();
    if let Some(family) = family {
        of_all.extend(family.words.iter().cloned());
        of_all.extend([family.title.clone(), family.heading.clone()]);
    }
    of_all.extend(
        table
            .into_iter()
            .flat_map(|table| table.words.iter().cloned()),
    );
    // A spectrum of the user's own is found by the file that it came from, too.
    let source = match entry.shelf() {
        None => entry.spectrum.source.clone(),
        Some(_) => String::new(),
    };
    Doc::new(
        score::Texts {
            label: favourite.map(|f| f.label.clone()).unwrap_or_default(),
            words: item.map(|item| item.words.clone()).unwrap_or_default(),
            name: entry.name().to_owned(),
            ids,
            what: about.what,
            about: about.about,
            of_all,
            source,
        },
        [
            favourite.is_some(),
            entry.key.split('/').next() == Some(EVERYDAY_SET),
            entry.kind() == crate::spectrum::Kind::Light,
            !is_made(&entry.key),
        ],
    )
}

#[cfg(test)]
mod tests;
