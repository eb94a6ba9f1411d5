//! What earlier versions wrote in other words: read as what it is called now.

use serde_json::{Map, Value};

use crate::app::pages::Page;

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

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

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
