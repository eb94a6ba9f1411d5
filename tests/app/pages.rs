//! What pages keep: undone, kept in files and moved to what is allowed, whatever page it is.

use serde_json::{Map, Value, json};
use spectral_explorer::app::{
    App, Command, Document,
    pages::PageStates,
    workspace::{self, Preferences},
};

use crate::full::{D65, full_document, full_pages, full_preferences};

fn tree(pages: &PageStates) -> Map<String, Value> {
    match serde_json::to_value(pages) {
        Ok(Value::Object(pages)) => pages,
        other => panic!("a group a page: {other:?}"),
    }
}

fn of_tree(tree: &Map<String, Value>) -> Option<PageStates> {
    serde_json::from_value(Value::Object(tree.clone())).ok()
}

/// Values that a field may have instead of its own.
fn others(now: &Value, full: &Value) -> Vec<Value> {
    let near = match now {
        Value::Bool(is) => vec![json!(!is)],
        Value::Number(number) => {
            let number = number.as_f64().expect("a number");
            let near = [2.0 * number, number + 1.0, number - 1.0, 0.5 * number];
            let whole = near.map(|n| json!(n as i64)).into_iter();
            whole.chain(near.map(|n| json!(n))).collect()
        }
        Value::Null => vec![json!(D65)],
        _ => Vec::new(),
    };
    near.into_iter().chain([full.clone()]).collect()
}

/// The pages with one field changed to something allowed, for every field of every page.
fn every_change() -> Vec<(String, PageStates)> {
    let usual = tree(&PageStates::default());
    let full = tree(&full_document().pages);
    let mut all = Vec::new();
    for (page, fields) in &usual {
        for (key, now) in fields.as_object().expect("a page's fields") {
            let changed = others(now, &full[page][key]).into_iter().find_map(|other| {
                let mut tree = usual.clone();
                tree[page][key] = other;
                let pages = of_tree(&tree)?.in_reach();
                (pages != PageStates::default()).then_some(pages)
            });
            let place = format!("{page}.{key}");
            all.push((
                place.clone(),
                changed.unwrap_or_else(|| panic!("{place} is never another")),
            ));
        }
    }
    all
}

#[test]
fn whatever_is_set_on_a_page_is_undone_and_done_again_in_words_of_its_own() {
    let all = every_change();
    assert!(all.len() > 90, "{} fields", all.len());
    for (place, pages) in all {
        let mut app = App::new();
        app.edit_pages(|now| *now = pages.clone());
        assert_eq!(app.document().pages, pages, "{place}");
        let words = app.undo_words().expect("a step");
        assert!(
            !words.is_empty() && !words.contains('_') && words != "a change",
            "{place}: {words}"
        );
        app.apply(Command::Undo);
        assert_eq!(app.document().pages, PageStates::default(), "{place}");
        app.apply(Command::Redo);
        assert_eq!(app.document().pages, pages, "{place}");
    }
}

#[test]
fn every_setting_of_a_page_has_a_name_for_undo() {
    for (place, pages) in every_change() {
        let change = pages.change(&PageStates::default(), &str::to_owned);
        let (page, words) = change.expect("it differs");
        let key = place.split('.').nth(1).expect("a key").replace('_', " ");
        // A name that is the field's own was not given.
        assert_ne!(words, format!("{}: {key}", page.title()), "{place}");
    }
}

#[test]
fn whatever_is_set_on_a_page_comes_back_from_a_project() {
    for (place, pages) in every_change() {
        let mut app = App::new();
        app.edit_pages(|now| *now = pages.clone());
        let text = workspace::to_json(app.document(), None).expect("text");
        let restored = workspace::from_json(&text).expect("our own text");
        assert!(restored.losses.is_empty(), "{place}: {:?}", restored.losses);
        assert_eq!(restored.document.pages, pages, "{place}");
    }
}

#[test]
fn a_page_is_set_back_alone() {
    let mut pages = full_pages();
    for page in PageStates::PAGES {
        pages.set_back(*page);
    }
    assert_eq!(pages, PageStates::default());
}

/// A project whose pages are changed by hand.
fn with_pages(change: impl FnOnce(&mut Value)) -> workspace::Restored {
    let mut app = App::new();
    app.edit_pages(|pages| *pages = full_pages());
    let text = workspace::to_json(app.document(), Some(&Preferences::default())).expect("text");
    let mut whole: Value = serde_json::from_str(&text).expect("JSON");
    change(&mut whole["pages"]);
    workspace::from_json(&whole.to_string()).expect("a project")
}

#[test]
fn a_damaged_field_of_a_page_costs_itself_alone() {
    let sound = with_pages(|_| {}).document.pages;
    let restored = with_pages(|pages| pages["filter"]["width_nm"] = json!("wide"));
    let expected = {
        let mut pages = sound.clone();
        pages.narrow.width_nm = PageStates::default().narrow.width_nm;
        pages
    };
    assert_eq!(restored.document.pages, expected);
    assert_eq!(restored.losses.len(), 1, "{:?}", restored.losses);
    assert!(
        restored.losses[0].contains("pages.filter.width_nm"),
        "{:?}",
        restored.losses
    );
    // A number out of its range is the nearest that is allowed, and said.
    let restored = with_pages(|pages| pages["prism"]["apex_deg"] = json!(1e9));
    assert_eq!(restored.document.pages.prism.apex_deg, 90.0);
    assert!(
        restored.losses[0].contains("pages.prism.apex_deg"),
        "{:?}",
        restored.losses
    );
}

#[test]
fn pages_and_fields_of_another_version_go_back_as_they_came() {
    let restored = with_pages(|pages| {
        pages["hologram"] = json!({"depth": 3, "of": ["a", "b"]});
        pages["gem"]["facets"] = json!([1, {"two": 2}]);
    });
    assert!(restored.losses.is_empty(), "{:?}", restored.losses);
    // Something else is set meanwhile.
    let mut app = App::with_document(restored.document);
    app.edit_pages(|pages| pages.gem.turn_deg = -30.0);
    let text = workspace::to_json(app.document(), None).expect("text");
    let whole: Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(
        whole["pages"]["hologram"],
        json!({"depth": 3, "of": ["a", "b"]})
    );
    assert_eq!(whole["pages"]["gem"]["facets"], json!([1, {"two": 2}]));
    assert_eq!(whole["pages"]["gem"]["turn_deg"], json!(-30.0));
}

#[test]
fn a_knob_that_is_held_is_one_step_and_what_follows_by_itself_is_none() {
    let mut app = App::new();
    for apex in [50.0, 45.0, 40.0] {
        app.edit_pages(|pages| pages.prism.apex_deg = apex);
    }
    app.end_gesture();
    assert_eq!(
        app.undo_words().as_deref(),
        Some("Apex angle 60 to 40\u{b0}")
    );
    app.pages_follow(|pages| pages.why.partial_order = 9);
    app.apply(Command::Undo);
    assert_eq!(app.document().pages, PageStates::default());
    assert!(app.undo_words().is_none());
}

#[test]
fn what_pages_keep_derives_nothing_of_the_model_anew() {
    let mut app = App::new();
    let (revision, changes) = (app.revision(), app.changes());
    let derived = app.derived().clone();
    app.edit_pages(|pages| pages.gem.height_deg = 30.0);
    assert_eq!(app.revision(), revision);
    assert!(app.changes() > changes && std::sync::Arc::ptr_eq(app.derived(), &derived));
}

/// A project: of what pages keep it had the desk alone.
fn of_a_project(document: Document) -> Document {
    let mut project = document;
    let desk = std::mem::take(&mut project.pages.mix.desk);
    project.pages = PageStates::default();
    project.pages.mix.desk = desk;
    project
}

/// A file of an earlier version, everything in it another than at first.
fn opens_as(text: &str, document: &Document, preferences: Option<&Preferences>) {
    let restored = workspace::from_json(text).expect("a file of ours");
    assert!(restored.losses.is_empty(), "{:?}", restored.losses);
    let tree = |document: &Document, preferences: Option<&Preferences>| -> Value {
        let text = workspace::to_json(document, preferences).expect("text");
        serde_json::from_str(&text).expect("JSON")
    };
    let now = tree(&restored.document, restored.preferences.as_ref());
    // Its name is that of a field of another page, too.
    let mut document = document.clone();
    document.pages.relit.under = None;
    let then = tree(&document, preferences);
    let usual = preferences.map(|_| Preferences::default());
    let first = tree(App::new().document(), usual.as_ref());
    same_but_for_what_is_new(text, &mut Vec::new(), [&now, &then, &first]);
}

/// Now as then; what that version did not have, by a name that its file lacks, as at first.
fn same_but_for_what_is_new(text: &str, at: &mut Vec<String>, [now, then, first]: [&Value; 3]) {
    let is_new = |name: &String| !text.contains(&format!("\"{name}\":"));
    match (now, then) {
        _ if now == then => {}
        _ if now == first && at.iter().any(is_new) => {}
        (Value::Object(now), Value::Object(then)) => {
            assert!(now.keys().eq(then.keys()), "{at:?}");
            for (key, now) in now {
                at.push(key.clone());
                let first = first.get(key).unwrap_or(&Value::Null);
                same_but_for_what_is_new(text, at, [now, &then[key], first]);
                at.pop();
            }
        }
        _ => panic!("{at:?}: {now} in place of {then}"),
    }
}

#[test]
fn a_workspace_of_the_version_before_opens_as_it_was() {
    let text = include_str!("../data/workspaces/before_slices.json");
    opens_as(text, &full_document(), Some(&full_preferences()));
}

#[test]
fn a_project_of_the_version_before_opens_as_it_was() {
    let text = include_str!("../data/workspaces/project_before_slices.json");
    opens_as(text, &of_a_project(full_document()), None);
}

#[test]
fn files_from_before_the_second_light_open_as_they_were() {
    // They had no such fields.
    let (mut document, usual) = (full_document(), PageStates::default());
    document.pages.two_lights.makes = usual.two_lights.makes;
    document.pages.rendition.large = usual.rendition.large;
    document.pages.chromaticity.surfaces = usual.chromaticity.surfaces;
    let preferences = Preferences {
        last_of_places: Vec::new(),
        lesson_language: Preferences::default().lesson_language,
        ..full_preferences()
    };
    let text = include_str!("../data/workspaces/before_second_light.json");
    opens_as(text, &document, Some(&preferences));
    let text = include_str!("../data/workspaces/project_before_second_light.json");
    opens_as(text, &of_a_project(document), None);
}
