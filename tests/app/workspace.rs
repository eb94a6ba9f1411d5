//! What is kept of a program and comes back: one word that is not understood costs one setting,
//! and nothing is too much.

use std::{fs, path::PathBuf, sync::Arc};

use crate::full::{D65, RED, awkward, full_document, full_preferences, preset, slope, spectrum};
use crate::plain::plain;
use serde_json::{Value, json};
use spectral_explorer::{
    app::{
        App, Command, MOST_OVERLAYS, Tone,
        open::{Loaded, load_bytes},
        workspace::{self, Restored, StoredImage},
    },
    io::Choices,
    spectrum::{Band, Kind, Sampling},
};

/// An image that is read again, with a person's decisions about it.
fn waiting() -> StoredImage {
    StoredImage {
        key: "image/7".to_owned(),
        path: PathBuf::from("scene.hdr"),
        index: 1,
        choices: Choices {
            kind: Some(Kind::Reflectance),
            each_image: [(0, Default::default())].into(),
            ..Choices::default()
        },
    }
}

/// A workspace in which everything is set.
fn stored() -> Value {
    let mut document = full_document();
    // The image has a number as well.
    document.next_own = 8;
    let text = workspace::to_json_with(&document, Some(&full_preferences()), &[waiting()]);
    serde_json::from_str(&text.unwrap()).expect("our own JSON")
}

fn read(value: &Value) -> Restored {
    workspace::from_json(&value.to_string()).expect("a workspace")
}

/// What would be written of it.
fn written(restored: &Restored) -> Value {
    let Restored {
        document,
        images,
        preferences,
        losses: _,
    } = restored;
    let text = workspace::to_json_with(document, preferences.as_ref(), images).unwrap();
    serde_json::from_str(&text).expect("our own JSON")
}

type Place = Vec<String>;

/// Every key of a value and every item of its lists, from the top down; of the own spectra's many
/// numbers the first two.
fn places(value: &Value, at: &Place, all: &mut Vec<Place>) {
    let below = |key: String| at.iter().cloned().chain([key]).collect::<Place>();
    let pieces: Vec<(Place, &Value)> = match value {
        Value::Object(fields) => fields.iter().map(|(k, v)| (below(k.clone()), v)).collect(),
        Value::Array(items) => {
            let numbered = items.iter().enumerate().take(8);
            numbered.map(|(i, v)| (below(i.to_string()), v)).collect()
        }
        _ => Vec::new(),
    };
    for (place, piece) in pieces {
        all.push(place.clone());
        places(piece, &place, all);
    }
}

fn at<'v>(value: &'v mut Value, place: &[String]) -> &'v mut Value {
    place.iter().fold(value, |value, step| match value {
        Value::Array(items) => &mut items[step.parse::<usize>().expect("a number")],
        other => &mut other[step.as_str()],
    })
}

fn found<'v>(value: &'v Value, place: &[String]) -> Option<&'v Value> {
    place.iter().try_fold(value, |value, step| match value {
        Value::Array(items) => items.get(step.parse::<usize>().ok()?),
        other => other.get(step.as_str()),
    })
}

/// The setting that a place belongs to: lists move up when an item goes, and a spike, a selection,
/// a size or a goal of several weights is one thing.
fn setting_of(place: &Place) -> Place {
    let is = |from: usize, name: &str| place.get(from).is_some_and(|step| step == name);
    let length = match place[0].as_str() {
        "overlays" | "images" | "own_patches" if place.len() < 4 => 1,
        "products" if is(1, "chain") && place.len() < 5 => 2,
        "settings" if is(1, "band") => 2,
        "edits" => place.len().min(3),
        "preferences" if is(1, "recent") || is(1, "folded") || is(1, "window") => 2,
        "preferences" if is(1, "lessons_finished") || is(1, "last_of_places") => 2,
        "pages" if is(3, "channels") || is(3, "gels") => 4,
        "pages" if is(2, "kept") => place.len().min(4),
        "pages" if is(3, "lines") => place.len().min(5),
        "pages"
            if [
                "goal",
                "selection",
                "hidden",
                "given",
                "second",
                "lines",
                "pixel",
                "xy",
                "slots",
                "scans",
                "others",
                "instruments",
                "figures",
            ]
            .iter()
            .any(|key| is(2, key)) =>
        {
            3
        }
        _ => place.len(),
    };
    place[..length].to_vec()
}

/// Where two values differ.
fn differences(a: &Value, b: &Value, at: &Place, all: &mut Vec<Place>) {
    let below = |key: &str| {
        at.iter()
            .cloned()
            .chain([key.to_owned()])
            .collect::<Place>()
    };
    match (a, b) {
        _ if a == b => {}
        (Value::Object(a), Value::Object(b)) => {
            for key in a.keys().chain(b.keys().filter(|key| !a.contains_key(*key))) {
                let (a, b) = (a.get(key), b.get(key));
                let nothing = Value::Null;
                differences(
                    a.unwrap_or(&nothing),
                    b.unwrap_or(&nothing),
                    &below(key),
                    all,
                );
            }
        }
        (Value::Array(a), Value::Array(b)) if a.len() == b.len() => {
            for (i, (a, b)) in a.iter().zip(b).enumerate() {
                differences(a, b, &below(&i.to_string()), all);
            }
        }
        _ => all.push(at.clone()),
    }
}

/// What holds for a workspace with one damaged place outside the own spectra.
fn assert_costs_one_setting(whole: &Value, place: &Place, damage: &Value) {
    let mut damaged = whole.clone();
    *at(&mut damaged, place) = damage.clone();
    let restored = read(&damaged);
    let now = written(&restored);
    let setting = setting_of(place);
    let mut others = Vec::new();
    differences(whole, &now, &Vec::new(), &mut others);
    others.retain(|other| !other.starts_with(&setting));
    let losses = &restored.losses;
    assert_eq!(
        others,
        [] as [Place; 0],
        "{place:?} as {damage} costs more than {setting:?}: {losses:?}"
    );
    // What pages do not know goes back as it came, beside what they do know.
    let kept = |now: &Value| match (now, damage) {
        (Value::Object(now), Value::Object(damage)) if place[0] == "pages" && place.len() < 3 => {
            damage
                .iter()
                .all(|(key, value)| now.get(key) == Some(value))
        }
        _ => now == damage,
    };
    let stands = found(&now, place).is_some_and(kept);
    let last_name = |place: &Place| {
        let mut names = place.iter().filter(|step| step.parse::<usize>().is_err());
        names.next_back().expect("a name").clone()
    };
    let names = [last_name(place), last_name(&setting)];
    let is_named = |loss: &str| {
        let is_band = names[0] == "band" && loss.starts_with("The model's range");
        is_band || loss.contains("wibble") || names.iter().any(|name| loss.contains(name))
    };
    let is_told = losses
        .iter()
        .any(|loss| loss.lines().count() == 1 && is_named(loss));
    assert!(
        stands || is_told,
        "nothing tells of {place:?} as {damage}: {losses:?}"
    );
    assert!(!stands || losses.is_empty(), "{place:?}: {losses:?}");
}

const DAMAGES: [fn() -> Value; 3] = [
    || json!("wibble"),
    || json!(17.5),
    || json!({"wibble": ["wobble"]}),
];

#[test]
fn an_unknown_word_or_a_wrong_type_costs_one_setting_and_is_said() {
    let whole = stored();
    assert_eq!(written(&read(&whole)), whole, "the test's own ground");
    let mut all = Vec::new();
    places(&whole, &Vec::new(), &mut all);
    // The format is what makes it a workspace; the program's version is a note.
    let is_setting = |place: &Place| !["format", "program", "own"].contains(&place[0].as_str());
    all.retain(is_setting);
    assert!(all.len() > 120, "only {} places", all.len());
    for page in [
        "settings",
        "view",
        "edits",
        "products",
        "preferences",
        "pages",
        "scale",
        "images",
    ] {
        assert!(all.iter().any(|place| place[0] == page), "{page}");
    }
    for place in &all {
        for damage in DAMAGES {
            assert_costs_one_setting(&whole, place, &damage());
        }
    }
}

#[test]
fn whatever_is_damaged_about_one_own_spectrum_the_other_and_all_settings_stay() {
    let whole = stored();
    let mut all = Vec::new();
    places(&whole["own"], &Vec::new(), &mut all);
    assert!(all.len() > 20, "only {} places", all.len());
    for place in all {
        for damage in DAMAGES {
            let mut damaged = whole.clone();
            *at(&mut damaged["own"], &place) = damage();
            let restored = read(&damaged);
            let words = format!("{place:?} as {}: {:?}", damage(), restored.losses);
            let now = written(&restored);
            for key in [
                "settings",
                "preferences",
                "view",
                "scale",
                "patch_set",
                "images",
            ] {
                assert_eq!(now[key], whole[key], "{key}: {words}");
            }
            let own = now["own"].as_array().expect("a list");
            let index: usize = place[0].parse().expect("a number");
            assert!(own.contains(&whole["own"][1 - index]), "the other: {words}");
            // All that is not its numbers can be done without.
            let is_numbers = place.len() == 1 || ["nm", "values"].contains(&place[1].as_str());
            if !is_numbers {
                assert_eq!(own.len(), 2, "{words}");
                assert_eq!(
                    own[index]["values"], whole["own"][index]["values"],
                    "{words}"
                );
                assert_eq!(own[index]["nm"], whole["own"][index]["nm"], "{words}");
            }
            let stands = found(&now["own"], &place) == Some(&damage());
            assert!(stands || !restored.losses.is_empty(), "{words}");
            assert!(App::with_document(restored.document).derived().has_errors());
        }
    }
}

#[test]
fn several_damages_cost_themselves_alone_and_are_each_told() {
    let mut value = stored();
    value["settings"]["observer"] = json!("1066");
    value["settings"]["basis"] = json!("wavelets");
    value["preferences"]["page"] = json!("poetry");
    // A word of another menu.
    value["preferences"]["curve"] = json!("filters");
    value["scale"] = json!(5);
    value["own"][0]["kind"] = json!("sound");
    value["overlays"][0] = json!(null);
    let restored = read(&value);
    let losses = &restored.losses;
    for (place, found, stands) in [
        ("settings.observer", "\"1066\"", "\"1931\" stands"),
        ("settings.basis", "\"wavelets\"", "\"cosine\" stands"),
        ("preferences.page", "\"poetry\"", "\"spectrum\" stands"),
        (
            "preferences.curve",
            "\"filters\"",
            "\"patches_worst\" stands",
        ),
        ("scale", "5", "\"as_measured\" stands"),
        ("kind", "\"sound\"", "\"other\" stands"),
        ("overlays", "null", "left out"),
    ] {
        let told = losses
            .iter()
            .filter(|l| l.contains(place) && l.contains(found) && l.contains(stands));
        assert_eq!(told.count(), 1, "{place}: {losses:?}");
    }
    let document = &restored.document;
    assert_eq!(document.own.len(), 2);
    assert_eq!(document.own[0].spectrum.samples, awkward().samples);
    assert_eq!(document.settings.order, 13);
    assert_eq!(document.settings.threshold_percent, 1.0 / 3.0);
}

#[test]
fn a_range_that_is_none_is_read_as_the_nearest_and_said() {
    for (stored_band, taken) in [
        (json!([380.4, 780.25]), [380.0, 780.0]),
        (json!([0.0, 30_000.0]), [0.0, 20_000.0]),
        (json!([400.0, 410.0]), [400.0, 420.0]),
        (json!([780.0, 380.0]), [380.0, 780.0]),
        (json!([-7, 1e300]), [0.0, 20_000.0]),
        (json!("wide"), [380.0, 780.0]),
        (json!([300]), [380.0, 780.0]),
        (json!([500, "end"]), [500.0, 780.0]),
    ] {
        let mut value = stored();
        value["settings"]["band"] = stored_band.clone();
        let restored = read(&value);
        let band = <[f64; 2]>::from(restored.document.settings.band);
        assert_eq!(band, taken, "{stored_band}");
        assert_eq!(restored.losses.len(), 1, "{:?}", restored.losses);
        assert_eq!(restored.document.own.len(), 2);
    }
    let mut value = stored();
    value["settings"]["band"] = json!([0, 20_000]);
    let restored = read(&value);
    assert!(restored.losses.is_empty(), "{:?}", restored.losses);
    assert_eq!(restored.document.settings.band.points(), 20_001);
}

#[test]
fn a_byte_order_mark_is_no_part_of_a_workspace_or_project() {
    let document = full_document();
    let text = workspace::to_json(&document, Some(&full_preferences())).unwrap();
    let text = format!("\u{feff}{text}");
    let restored = workspace::from_json(&text).expect("a workspace");
    assert_eq!(restored.document, document);
    assert!(restored.losses.is_empty(), "{:?}", restored.losses);
    match load_bytes("lesson.json", text.as_bytes()) {
        Loaded::Project { restored, .. } => assert_eq!(restored.document, document),
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_workspace_of_which_something_is_lost_is_kept_as_it_was_found() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("workspace.json");
    let mut value = stored();
    value["settings"]["observer"] = json!("1066");
    let text = value.to_string();
    fs::write(&path, &text).expect("a file");
    let kept = folder.path().join("workspace.damaged.json");
    // Killed before it is saved again it is the same once more: one copy is enough.
    for _ in 0..2 {
        let restored = workspace::load(&path).expect("readable").expect("there");
        let losses = &restored.losses;
        assert_eq!(losses.len(), 2, "{losses:?}");
        assert!(losses[1].contains("workspace.damaged.json"), "{losses:?}");
        assert_eq!(fs::read_to_string(&kept).expect("kept"), text);
        assert_eq!(fs::read_to_string(&path).expect("in its place"), text);
        assert_eq!(fs::read_dir(folder.path()).expect("listed").count(), 2);
    }
}

#[test]
fn what_the_program_itself_wrote_is_never_a_loss() {
    let mut preferences = full_preferences();
    // Folded away, and more files than are remembered.
    preferences.window = Some([0.0, f32::NAN]);
    preferences.zoom = f32::INFINITY;
    preferences.recent = (0..40).map(|i| PathBuf::from(format!("{i}.csv"))).collect();
    let mut app = App::with_document(full_document());
    app.edit_pages(|pages| {
        pages.auction.numbers = 0;
        pages.narrow.centre_nm = f64::NAN;
        for way in [Sampling::Convolution, Sampling::Paper, Sampling::Double] {
            pages.resampling.show(way, false);
        }
    });
    let text = workspace::to_json(app.document(), Some(&preferences)).unwrap();
    let restored = workspace::from_json(&text).expect("our own text");
    assert!(restored.losses.is_empty(), "{:?}", restored.losses);
    assert_eq!(restored.document.pages, app.document().pages);
    assert_eq!(restored.preferences.expect("the window's").window, None);
}

// -------------------------------------------------------------------------------------- overlays

/// More spectra than may be laid over.
fn many() -> App {
    let mut app = plain();
    let entries: Vec<_> = app.bundled()[..MOST_OVERLAYS + 20].to_vec();
    for entry in entries {
        app.apply(Command::ToggleOverlay(entry));
    }
    app
}

#[test]
fn the_overlay_beyond_the_most_is_left_out_and_said_whatever_asks_for_it() {
    let mut app = many();
    assert_eq!(app.document().overlays.len(), MOST_OVERLAYS);
    let message = app.message().expect("a word");
    assert_eq!(message.tone, Tone::Problem);
    assert!(
        message.text.contains("100 overlays are the most"),
        "{message:?}"
    );
    let first = app.document().overlays[0].clone();
    let weighting = preset(&app, "observers/V(lambda) photopic");
    app.apply(Command::Show(weighting.clone()));
    assert_eq!(app.document().overlays.len(), MOST_OVERLAYS);
    let other = spectrum("other", Kind::Other, 380.0, 5.0, vec![1.0; 81]);
    app.apply(Command::Adopt(vec![other]));
    assert_eq!(app.document().overlays.len(), MOST_OVERLAYS);
    assert_eq!(app.document().own.len(), 1, "the spectrum itself is there");
    let mut document = app.document().clone();
    document.overlays.extend([weighting, preset(&app, D65)]);
    app.apply(Command::Replace(Box::new(document)));
    assert_eq!(app.document().overlays.len(), MOST_OVERLAYS);
    // Where one goes there is room for another.
    app.apply(Command::ToggleOverlay(first));
    app.apply(Command::Adopt(vec![slope("light")]));
    let own = app.document().own[1].clone();
    app.apply(Command::ToggleOverlay(own.clone()));
    assert!(app.document().overlays.iter().any(|o| Arc::ptr_eq(o, &own)));
}

#[test]
fn a_workspace_with_very_many_overlays_loads_with_the_most_there_may_be() {
    let mut value = stored();
    for keys in [
        vec![RED.to_owned(); 100_000],
        (0..100_000).map(|i| format!("gone/{i}")).collect(),
    ] {
        value["overlays"] = json!(keys);
        let restored = read(&value);
        assert!(restored.document.overlays.len() <= MOST_OVERLAYS);
        assert!(restored.losses.len() <= MOST_OVERLAYS + 1);
        let told = restored.losses.last().expect("a word");
        assert!(told.contains("99900 more are left out"), "{told}");
        assert_eq!(restored.document.own.len(), 2);
        assert_eq!(
            restored.document.settings.band,
            Band::new(400.0, 701.0).expect("a range")
        );
    }
}

#[test]
fn the_formula_of_an_index_comes_back_with_its_table() {
    let text = "REFERENCES: A\nDATA:\n  - type: formula 5\n    wavelength_range: 0.4 0.7\n    \
                coefficients: 1.5 0.004 -2\n";
    let Loaded::File(opened) = load_bytes("glass.yml", text.as_bytes()) else {
        panic!("it is a material");
    };
    let mut app = App::new();
    app.apply(Command::Open(vec![*opened]));
    let text = workspace::to_json_with(app.document(), None, &[]).expect("a workspace");
    let restored = workspace::from_json(&text).expect("a workspace");
    let formula = |own: &[Arc<spectral_explorer::app::Entry>]| {
        own.iter()
            .find_map(|entry| entry.spectrum.samples.formula().cloned())
    };
    let found = formula(&restored.document.own).expect("a formula");
    assert_eq!(Some(&found), formula(&app.document().own).as_ref());
    // 1.5 + .004 / .5876^2.
    assert!((found.index(0.5876) - 1.511_585_01).abs() < 1e-8);
}
