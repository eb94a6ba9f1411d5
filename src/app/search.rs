//! Finding a spectrum by what people call it: the library's rows, folded, and the search over them.
//!
//! A light that is there twice (a 1 nm and a 5 nm table of one lamp) is one row. What is typed is
//! looked for among favourites, the words written for each spectrum, names, what each is, its
//! family's words, and only then inside of words; every word typed must be found. Of equals the
//! favourite comes first, then surfaces by everyday names, lights, what was measured, and the
//! library's order. The first row is what Enter takes.
//!
//! "2700 K" finds the white lights within 150 K, "Ra 90" those that reach it, the nearest first.
//! German, French and Spanish words find what their English finds. What nothing is called by is
//! taken for the beginning of such a word, or for a typing error.

mod foreign;
mod known;
mod score;
mod wanted;

use std::{
    collections::HashMap,
    sync::{Arc, OnceLock},
};

use super::{
    about::About,
    entry::Entry,
    families::Families,
    made::{EVERYDAY_SET, is_made},
};
pub use foreign::unaccented;
use known::Indices;
use score::{Doc, Score};
use wanted::{Figure, Wanted};

/// A row of the library: an entry, and those that are the same light in another table.
#[derive(Clone, Debug, PartialEq)]
pub struct Folded {
    /// The entry to show.
    pub entry: Arc<Entry>,
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
    /// The temperature of every row, where it is a white light; computed when it is asked for.
    kelvins: OnceLock<Vec<Option<f64>>>,
    /// The other figures of every row.
    indices: OnceLock<Vec<Indices>>,
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
            ..Self::default()
        }
    }

    /// The rows that what is typed means, the best first: Enter takes it. Nothing typed is all
    /// rows in their order. Where nothing is called that, what is called nearly that.
    pub fn search(&self, typed: &str) -> Vec<Folded> {
        let found = self.places(typed).into_iter();
        found.map(|place| self.rows[place].0.clone()).collect()
    }

    /// The places of those rows.
    fn places(&self, typed: &str) -> Vec<usize> {
        let words = score::plain(typed);
        if words.is_empty() {
            return (0..self.rows.len()).collect();
        }
        let own = self.called(&words);
        // A name is a name, whatever else its words may mean.
        if self.rows.iter().any(|(_, doc)| doc.is_called(&words)) {
            return own;
        }
        let (wanted, rest) = wanted::wanted(typed);
        if !wanted.is_empty() {
            let found = self.that_have(&wanted, &rest);
            if !found.is_empty() {
                return joined(found, own);
            }
        }
        if let Some(english) = foreign::english(&words) {
            let found = self.called(&english);
            if !found.is_empty() {
                return joined(found, own);
            }
        }
        if let Some((wanted, rest)) = wanted::bare_kelvin(typed) {
            return joined(own, self.that_have(&[wanted], &rest));
        }
        if own.is_empty() {
            self.nearly(&words)
        } else {
            own
        }
    }

    /// The rows that all words are found in, the best first.
    fn called(&self, words: &str) -> Vec<usize> {
        self.ranked(|doc| doc.score(words))
    }

    /// What is called nearly that, in English or another language.
    fn nearly(&self, words: &str) -> Vec<usize> {
        let near = self.ranked(|doc| doc.nearly(words));
        if !near.is_empty() {
            return near;
        }
        let english = foreign::english_nearly(words).map(str::to_owned);
        let mended = english.or_else(|| self.mended(words));
        mended.map_or_else(Vec::new, |mended| self.called(&mended))
    }

    /// Several words with typing errors, each replaced by the nearest that is known; `None` where
    /// one is far from all.
    fn mended(&self, words: &str) -> Option<String> {
        let each: Option<Vec<&str>> = words
            .split(' ')
            .map(|word| {
                if self.rows.iter().any(|(_, doc)| doc.has(word)) {
                    return Some(word);
                }
                let near = self.rows.iter().filter_map(|(_, doc)| doc.nearest(word));
                near.min_by_key(|(errors, _)| *errors).map(|(_, near)| near)
            })
            .collect();
        each.map(|each| each.join(" "))
    }

    /// The rows with these figures: those that some words mean in their order, all of them by how
    /// near they are.
    fn that_have(&self, wanted: &[Wanted], words: &str) -> Vec<usize> {
        let distance = |place: usize| {
            let each = wanted.iter().map(|wanted| {
                let value = self.figure(place, wanted.figure)?;
                wanted.distance(value)
            });
            each.sum::<Option<f64>>()
        };
        let words = score::plain(words);
        if !words.is_empty() {
            let rows = self
                .called(&foreign::english(&words).unwrap_or(words))
                .into_iter();
            return rows.filter(|place| distance(*place).is_some()).collect();
        }
        let rows = 0..self.rows.len();
        let mut found: Vec<(f64, usize)> = rows
            .filter_map(|place| Some((distance(place)?, place)))
            .collect();
        // A stable sort keeps the library's order among equals.
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        found.into_iter().map(|(_, place)| place).collect()
    }

    fn figure(&self, place: usize, figure: Figure) -> Option<f64> {
        let entries = || self.rows.iter().map(|(row, _)| &row.entry);
        if figure == Figure::Kelvin {
            let kelvins = || entries().map(|entry| known::kelvin(entry)).collect();
            return self.kelvins.get_or_init(kelvins)[place];
        }
        let indices = || entries().map(|entry| Indices::of(entry)).collect();
        self.indices.get_or_init(indices)[place].get(figure)
    }

    fn ranked(&self, score: impl Fn(&Doc) -> Option<Score>) -> Vec<usize> {
        let rows = self.rows.iter().enumerate();
        let mut found: Vec<(Score, usize)> = rows
            .filter_map(|(place, (_, doc))| Some((score(doc)?, place)))
            .collect();
        // A stable sort keeps the library's order among equals.
        found.sort_by_key(|found| std::cmp::Reverse(found.0));
        found.into_iter().map(|(_, place)| place).collect()
    }
}

/// Some rows, and others behind them that are not among them.
fn joined(mut first: Vec<usize>, others: Vec<usize>) -> Vec<usize> {
    let more: Vec<usize> = others
        .into_iter()
        .filter(|row| !first.contains(row))
        .collect();
    first.extend(more);
    first
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
