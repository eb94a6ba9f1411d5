//! What earlier versions wrote in other words: read as what it is called now.

use serde_json::{Map, Value};

use crate::app::{
    document::USUAL_SECOND,
    pages::{Page, PageStates},
};

/// Settings that stand for themselves no more: what they were is no part of the window now.
const GONE: [&str; 3] = ["no_library", "spikes_below", "larger_answered"];

/// Preferences that stood among what pages keep.
const MOVED: [&str; 4] = [
    "page",
    "last_of_places",
    "lessons_finished",
    "lesson_language",
];

/// Puts the words of earlier versions into those of this one.
pub(super) fn translate(rest: &mut Map<String, Value>) {
    if let Some(Value::Object(view)) = rest.get_mut("view")
        && let Some(log) = view.remove("log_axis")
    {
        let height = match log.as_bool() {
            Some(true) => "log",
            _ => "even",
        };
        view.entry("height").or_insert_with(|| height.into());
    }
    take_second(rest);
    // The desk stood beside the pages.
    if let Some(desk) = rest.remove("mix") {
        let mix = Map::from_iter([("desk".to_owned(), desk)]);
        merge(
            pages_of(rest),
            Map::from_iter([("mix".to_owned(), Value::Object(mix))]),
        );
    }
    let Some(Value::Object(preferences)) = rest.get_mut("preferences") else {
        return;
    };
    for key in GONE {
        preferences.remove(key);
    }
    if let Some(present) = preferences.remove("projector") {
        preferences.entry("present").or_insert(present);
    }
    if preferences.get("pages").is_some_and(Value::is_object)
        && let Some(Value::Object(mut memory)) = preferences.remove("pages")
    {
        page_of(&mut memory);
        for key in MOVED {
            if let Some(value) = memory.remove(key) {
                preferences.entry(key).or_insert(value);
            }
        }
        let found = by_page(&mut memory);
        merge(pages_of(rest), found);
        // What nobody knows is told where it was found.
        if !memory.is_empty()
            && let Some(Value::Object(preferences)) = rest.get_mut("preferences")
        {
            preferences.insert("pages".to_owned(), Value::Object(memory));
        }
    }
}

/// The page "Products" had parts, which are pages now.
fn page_of(memory: &mut Map<String, Value>) {
    let products = memory.get_mut("products").and_then(Value::as_object_mut);
    let part = products.and_then(|products| products.remove("part"));
    if memory.get("page").and_then(Value::as_str) == Some("products") {
        let part = part.as_ref().and_then(Value::as_str).unwrap_or("chain");
        let page = Page::of_word(part).unwrap_or(Page::Chain);
        if let Ok(word) = serde_json::to_value(page) {
            memory.insert("page".to_owned(), word);
        }
    }
}

/// What one memory of all pages called a field, the page that keeps it now, and what that calls it;
/// "" where it is all that the page keeps.
const PLACES: [(&str, &str, &str); 31] = [
    ("partial_order", "why", "partial_order"),
    ("channel", "why", "channel"),
    ("measure", "tradeoff", "measure"),
    ("ways", "tradeoff", "ways"),
    ("many", "many-lights", ""),
    ("goal", "auction", "goal"),
    ("auction_numbers", "auction", "numbers"),
    ("spend_numbers", "look", "numbers"),
    ("spend_goal", "look", "goal"),
    ("field", "race", "field"),
    ("race_numbers", "race", "numbers"),
    ("race_measure", "race", "measure"),
    ("race_strict", "race", "strict"),
    ("words", "known-lamps", ""),
    ("products.chain", "chain", ""),
    ("products.forming", "resampling", ""),
    ("products.bounces", "bounces", ""),
    ("products.narrow", "filter", ""),
    ("products.lights", "two-lights", ""),
    ("products.check", "same-surface", ""),
    ("products.absorption", "dark-lines", ""),
    ("diagram", "chromaticity", ""),
    ("of_colours", "rendition", "large"),
    ("kept", "mix", "kept"),
    ("desk_surfaces", "mix", "surfaces"),
    ("wish", "solve", ""),
    ("colour", "from-colour", ""),
    ("dispersion.prism", "prism", ""),
    ("dispersion.rainbow", "rainbow", ""),
    ("dispersion.gem", "gem", ""),
    ("image", "image", ""),
];

/// The groups of that memory that held several pages' fields.
const GROUPS: [&str; 2] = ["products", "dispersion"];

/// Takes out of what was one memory of all pages what each page keeps now, under the page's word.
/// Workspaces and lessons of earlier versions are written so.
pub(in crate::app) fn by_page(memory: &mut Map<String, Value>) -> Map<String, Value> {
    let mut pages = Map::new();
    for (old, page, key) in PLACES {
        let found = match old.split_once('.') {
            None => memory.remove(old),
            Some((group, old)) => {
                let group = memory.get_mut(group).and_then(Value::as_object_mut);
                group.and_then(|group| group.remove(old))
            }
        };
        let Some(mut found) = found else { continue };
        if let Some(fields) = found.as_object_mut()
            && let Some(made_of) = fields.remove("stuff")
        {
            fields.entry("made_of").or_insert(made_of);
        }
        match (
            key,
            pages
                .entry(page)
                .or_insert_with(|| Value::Object(Map::new())),
        ) {
            ("", whole) => *whole = found,
            (key, Value::Object(fields)) => drop(fields.insert(key.to_owned(), found)),
            _ => {}
        }
    }
    for group in GROUPS {
        if memory
            .get(group)
            .and_then(Value::as_object)
            .is_some_and(Map::is_empty)
        {
            memory.remove(group);
        }
    }
    // "relit", and the words of pages themselves.
    let words: Vec<String> = PageStates::PAGES
        .iter()
        .map(|page| page.word().to_owned())
        .collect();
    for word in words {
        if let Some(found) = memory.remove(&word) {
            merge(&mut pages, Map::from_iter([(word, found)]));
        }
    }
    pages
}

/// Fields that are not there yet, page by page.
fn merge(pages: &mut Map<String, Value>, found: Map<String, Value>) {
    for (page, value) in found {
        match (pages.get_mut(&page), value) {
            (Some(Value::Object(fields)), Value::Object(more)) => {
                for (key, value) in more {
                    fields.entry(key).or_insert(value);
                }
            }
            (Some(_), _) => {}
            (None, value) => drop(pages.insert(page, value)),
        }
    }
}

/// The group of a file in which pages keep their fields.
fn pages_of(rest: &mut Map<String, Value>) -> &mut Map<String, Value> {
    let pages = rest
        .entry("pages")
        .or_insert_with(|| Value::Object(Map::new()));
    if !pages.is_object() {
        *pages = Value::Object(Map::new());
    }
    match pages {
        Value::Object(pages) => pages,
        _ => unreachable!("made an object just now"),
    }
}

/// The light that the page "Two lights" had of its own is the second light of every page now, where
/// it was another than the one that stood there at first.
fn take_second(rest: &mut Map<String, Value>) {
    let products = rest.get_mut("products").and_then(Value::as_object_mut);
    let other = products.and_then(|products| products.remove("other_light"));
    if let Some(Value::String(key)) = other
        && key != USUAL_SECOND[0]
    {
        rest.entry("second").or_insert(Value::String(key));
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn the_light_of_the_page_two_lights_is_the_second_one_where_it_was_chosen() {
        for (other, second) in [
            ("cie_fluorescent_1nm/FL11", Some("cie_fluorescent_1nm/FL11")),
            ("cie_illuminants/CIE A", None),
        ] {
            let mut old = json!({ "products": { "chain": [], "other_light": other } });
            let old = old.as_object_mut().expect("an object");
            translate(old);
            assert_eq!(old.get("second").and_then(Value::as_str), second);
            assert_eq!(old["products"], json!({ "chain": [] }));
        }
    }

    #[test]
    fn the_parts_of_the_page_products_are_pages() {
        for (part, page) in [("forming", "resampling"), ("check", "same_surface")] {
            let mut old = json!({
                "preferences": {
                    "projector": true,
                    "no_library": false,
                    "pages": { "page": "products", "products": { "part": part } },
                }
            });
            translate(old.as_object_mut().expect("an object"));
            let new = json!({
                "preferences": {
                    "present": true,
                    "page": page,
                },
                "pages": {},
            });
            assert_eq!(old, new);
        }
    }
}
