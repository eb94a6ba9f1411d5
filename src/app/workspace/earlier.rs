//! What earlier versions wrote in other words: read as what it is called now.

use serde_json::{Map, Value};

use crate::app::{document::USUAL_SECOND, pages::Page};

/// Settings that stand for themselves no more: what they were is no part of the window now.
const GONE: [&str; 2] = ["no_library", "spikes_below"];

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
    let Some(Value::Object(preferences)) = rest.get_mut("preferences") else {
        return;
    };
    for key in GONE {
        preferences.remove(key);
    }
    if let Some(present) = preferences.remove("projector") {
        preferences.entry("present").or_insert(present);
    }
    let Some(Value::Object(pages)) = preferences.get_mut("pages") else {
        return;
    };
    let products = pages.get_mut("products").and_then(Value::as_object_mut);
    let part = products.and_then(|products| products.remove("part"));
    // The page "Products" had parts, which are pages now.
    if pages.get("page").and_then(Value::as_str) == Some("products") {
        let part = part.as_ref().and_then(Value::as_str).unwrap_or("chain");
        let page = Page::of_word(part).unwrap_or(Page::Chain);
        if let Ok(word) = serde_json::to_value(page) {
            pages.insert("page".to_owned(), word);
        }
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
                    "pages": { "page": page, "products": {} },
                }
            });
            assert_eq!(old, new);
        }
    }
}
