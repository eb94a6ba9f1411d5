//! What pages keep: a value a page, all of them in the document, so that every knob of a page is
//! undone, kept in files, set back and moved to what is allowed by what is written here.
//! `PageStates` is made of these in the `mod.rs` beside it, which lists the pages.

use std::collections::BTreeMap;

use serde::{Serialize, de::DeserializeOwned};
use serde_json::{Map, Value};

use super::{
    Page,
    knob::{Knob, keep_in_reach, moved_words},
};
use crate::{app::recipe::NameOf, languages::said};

/// What one page keeps: plain data, spectra by their keys, each field with its default.
pub trait PageState: Clone + Default + PartialEq + Serialize + DeserializeOwned + 'static {
    /// Its numbers.
    const KNOBS: &'static [Knob<Self>] = &[];

    /// What its other fields are, by their names in files: words of undo.
    const NAMES: &'static [(&'static str, &'static str)] = &[];

    /// Moves what the knobs do not reach to what is allowed.
    fn settle(&mut self) {}

    /// Lets go of a spectrum that left the library.
    fn forget(&mut self, _key: &str) {}

    /// What changed, where it has words of its own.
    fn changed_since(&self, _before: &Self, _name_of: NameOf<'_>) -> Option<String> {
        None
    }
}

/// The state with every value moved to the nearest one that is allowed.
pub fn in_reach<S: PageState>(mut state: S) -> S {
    keep_in_reach(S::KNOBS, &mut state);
    state.settle();
    state
}

/// What changed of a page, in words; `None` for nothing.
pub(super) fn words_of<S: PageState>(
    page: Page,
    from: &S,
    to: &S,
    name_of: NameOf<'_>,
) -> Option<String> {
    if from == to {
        return None;
    }
    let own = to.changed_since(from, name_of);
    let own = own.or_else(|| moved_words(S::KNOBS, from, to));
    Some(own.unwrap_or_else(|| {
        let (from, to) = (fields(from), fields(to));
        let key = to.iter().find(|(key, now)| from.get(*key) != Some(now));
        let key = key.map_or("", |(key, _)| key.as_str());
        let name = S::NAMES.iter().find(|(named, _)| *named == key);
        let name = name.map_or_else(|| key.replace('_', " "), |(_, name)| said(name).to_owned());
        crate::languages::with_colon(page.title(), name)
    }))
}

fn fields<S: Serialize>(state: &S) -> Map<String, Value> {
    match serde_json::to_value(state) {
        Ok(Value::Object(fields)) => fields,
        _ => Map::new(),
    }
}

/// A page's part of a file, what this version does not know taken out to `unknown`.
pub(super) fn read<S: PageState>(
    page: Page,
    found: &mut Map<String, Value>,
    unknown: &mut BTreeMap<String, Value>,
) -> Result<S, serde_json::Error> {
    let Some(value) = found.remove(page.word()) else {
        return Ok(S::default());
    };
    let state = S::deserialize(&value)?;
    if let Value::Object(mut rest) = value {
        let known = fields(&state);
        rest.retain(|key, _| !known.contains_key(key));
        if !rest.is_empty() {
            unknown.insert(page.word().to_owned(), Value::Object(rest));
        }
    }
    Ok(state)
}

/// A page's part of a file, with what other versions wrote into it.
pub(super) fn written<S: PageState>(page: Page, state: &S, all: &mut Map<String, Value>) {
    let mut fields = fields(state);
    if let Some(Value::Object(rest)) = all.remove(page.word()) {
        fields.extend(rest);
    }
    all.insert(page.word().to_owned(), Value::Object(fields));
}

/// Lists the pages that keep something: the field, what it is, the page.
macro_rules! states {
    ($($field:ident: $state:ty = $page:ident,)*) => {
        /// What every page keeps, under the page's word in files.
        #[derive(Clone, Debug, Default, PartialEq)]
        pub struct PageStates {
            $(pub $field: $state,)*
            /// Pages, and fields of pages, that another version wrote: they go back as they came.
            unknown: BTreeMap<String, Value>,
        }

        impl PageStates {
            /// Every value moved to the nearest one that is allowed.
            #[must_use]
            pub fn in_reach(self) -> Self {
                Self {
                    $($field: in_reach(self.$field),)*
                    unknown: self.unknown,
                }
            }

            /// Lets go of a spectrum that left the library.
            pub fn forget(&mut self, key: &str) {
                $(PageState::forget(&mut self.$field, key);)*
            }

            /// The first page that differs, and how, in words.
            pub fn change(&self, before: &Self, name_of: NameOf<'_>) -> Option<(Page, String)> {
                $(
                    let words = words_of(Page::$page, &before.$field, &self.$field, name_of);
                    if let Some(words) = words {
                        return Some((Page::$page, words));
                    }
                )*
                None
            }

            /// Sets a page back to what it is at first.
            pub fn set_back(&mut self, page: Page) {
                match page {
                    $(Page::$page => self.$field = Default::default(),)*
                    _ => {}
                }
            }

            /// The pages that keep something.
            pub const PAGES: &'static [Page] = &[$(Page::$page),*];
        }

        impl Serialize for PageStates {
            fn serialize<W: Serializer>(&self, writer: W) -> Result<W::Ok, W::Error> {
                let mut all: Map<String, Value> = self.unknown.clone().into_iter().collect();
                $(written(Page::$page, &self.$field, &mut all);)*
                all.serialize(writer)
            }
        }

        impl<'de> Deserialize<'de> for PageStates {
            fn deserialize<R: Deserializer<'de>>(reader: R) -> Result<Self, R::Error> {
                let mut found = Map::deserialize(reader)?;
                let mut unknown = BTreeMap::new();
                $(
                    let $field = read(Page::$page, &mut found, &mut unknown);
                    let $field = $field.map_err(R::Error::custom)?;
                )*
                unknown.extend(found);
                Ok(Self { $($field,)* unknown })
            }
        }
    };
}

pub(super) use states;
