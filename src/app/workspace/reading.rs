//! From the text of a workspace or project to a document. What is not understood costs itself
//! alone, and is said.

use std::{collections::HashSet, sync::Arc};

use serde::Deserialize;
use serde_json::{Map, Value};

use super::{
    FORMAT, Preferences, Restored, VERSION, earlier,
    mending::{mended, moved, not_understood},
    stored::{OwnSpectrum, Stored, StoredImage, StoredProducts},
};
use crate::{
    app::{
        document::{
            Document, FIRST_PATCH_SET, MOST_OVERLAYS, MOST_OWN_PATCHES, WEIGHT_FACTORS, first_light,
        },
        entry::{Entry, bundled_entries},
        library::Library,
        products::Products,
        settings::{Settings, range_words},
    },
    languages::said,
    spectrum::{Band, Kind},
};

/// Reads a workspace or project.
///
/// # Errors
/// One line that says what is wrong with the text.
pub fn from_json(text: &str) -> Result<Restored, String> {
    // Some editors put a byte order mark before a text.
    let text = text.trim_start_matches('\u{feff}');
    let mut losses = Vec::new();
    let Parts { own, mut rest } = parts(text, &mut losses)?;
    is_ours(&rest)?;
    earlier::translate(&mut rest);
    take_nearest_band(&mut rest, &mut losses);
    let bundled = bundled_entries();
    let first = first_light(bundled);
    let has_preferences = rest.get("preferences").is_some_and(|p| !p.is_null());
    let preferences = has_preferences.then(Preferences::default);
    let usual = Stored::of(&Document::about(first.clone()), preferences.as_ref(), &[]);
    let stored = mended(usual, rest, &mut losses);
    Ok(restored(stored, own, bundled, &first, losses))
}

/// A workspace taken apart: the user's own spectra, which are large, and all that is small.
#[derive(Deserialize)]
struct Parts {
    #[serde(default)]
    own: Vec<OwnSpectrum>,
    #[serde(flatten)]
    rest: Map<String, Value>,
}

fn parts(text: &str, losses: &mut Vec<String>) -> Result<Parts, String> {
    if let Ok(parts) = serde_json::from_str(text) {
        return Ok(parts);
    }
    let mut rest: Map<String, Value> =
        serde_json::from_str(text).map_err(|error| broken_json(&error))?;
    let own = match rest.remove("own") {
        Some(Value::Array(own)) => own,
        Some(other) => {
            losses.push(not_understood("own", &other, None));
            Vec::new()
        }
        None => Vec::new(),
    };
    let own = own.into_iter().enumerate();
    let own = own.filter_map(|(index, found)| own_spectrum(index, found, losses));
    Ok(Parts {
        own: own.collect(),
        rest,
    })
}

/// A spectrum in which something is not understood: without its numbers it is none, all else is
/// mended.
fn own_spectrum(index: usize, found: Value, losses: &mut Vec<String>) -> Option<OwnSpectrum> {
    let Value::Object(mut fields) = found else {
        losses.push(not_understood("own", &found, None));
        return None;
    };
    let name = fields.get("name").and_then(Value::as_str);
    let name = name.map_or_else(
        || tr!("Own spectrum {number}", number = index + 1),
        str::to_owned,
    );
    let mut numbers = |key: &str| {
        Vec::<f64>::deserialize(fields.remove(key).unwrap_or_default())
            .map_err(|why| tr!("{name} was not brought back: {key}: {why}.", name, key, why))
    };
    let (nm, values) = match (numbers("nm"), numbers("values")) {
        (Ok(nm), Ok(values)) => (nm, values),
        (Err(why), _) | (_, Err(why)) => {
            losses.push(why);
            return None;
        }
    };
    let before = losses.len();
    let mut spectrum = mended(OwnSpectrum::unnamed(&name), fields, losses);
    for loss in &mut losses[before..] {
        *loss = format!("{name}: {loss}");
    }
    (spectrum.nm, spectrum.values) = (nm, values);
    Some(spectrum)
}

fn is_ours(rest: &Map<String, Value>) -> Result<(), String> {
    match rest.get("format") {
        Some(Value::String(format)) if format == FORMAT => {}
        Some(format) => {
            return Err(tr!(
                "found the format {found}, expected \"{expected}\"",
                found = format,
                expected = FORMAT
            ));
        }
        None => {
            return Err(tr!(
                "found no format, expected \"{expected}\"",
                expected = FORMAT
            ));
        }
    }
    match rest.get("version").and_then(Value::as_u64) {
        Some(version) if version > u64::from(VERSION) => Err(tr!(
            "found version {found}, expected {expected} or lower: a newer Spectral Explorer wrote \
             it",
            found = version,
            expected = VERSION
        )),
        _ => Ok(()),
    }
}

/// A range that is none the program takes becomes the nearest one that is.
fn take_nearest_band(rest: &mut Map<String, Value>, losses: &mut Vec<String>) {
    let found = rest.get_mut("settings").and_then(|s| s.get_mut("band"));
    if let Some(found) = found
        && let Ok(asked) = <[f64; 2]>::deserialize(&*found)
        && let Some(band) = Band::nearest(asked)
        && let Some(words) = range_words(asked, band)
    {
        losses.push(words);
        *found = <[f64; 2]>::from(band).as_slice().into();
    }
}

/// The document that was stored, by the entries that this version has.
fn restored(
    stored: Stored,
    own: Vec<OwnSpectrum>,
    bundled: &[Arc<Entry>],
    first: &Arc<Entry>,
    mut losses: Vec<String>,
) -> Restored {
    let (own, next_own) = own_entries(own, stored.next_own, &stored.images, &mut losses);
    let mut missing = Vec::new();
    let mut find = |key: &str| {
        let found = own.iter().chain(bundled).find(|e| e.key == key).cloned();
        let found = found.or_else(|| made(key));
        if found.is_none() {
            missing.push(tr!("{key} is not in this version's library.", key));
        }
        found
    };
    let light = find(&stored.light);
    let keys = [stored.second, stored.factor];
    let [second, factor] = keys.map(|key| find(key.as_deref()?));
    let mut overlays = stored.overlays;
    let too_many = overlays.len().saturating_sub(MOST_OVERLAYS);
    overlays.truncate(MOST_OVERLAYS);
    let overlays = overlays.iter().filter_map(|key| find(key)).collect();
    let products = match stored.products {
        Some(products) => of_products(products, &mut find),
        None => (Products::first(), None),
    };
    for words in missing {
        // One spectrum may stand in several places.
        if !losses.contains(&words) {
            losses.push(words);
        }
    }
    losses.extend(products.1);
    losses.extend((too_many > 0).then(|| Document::overlays_left_out(too_many)));
    let patches = [stored.patch_set.as_str(), FIRST_PATCH_SET];
    let patch_set = if is_patch_set(patches[0]) { 0 } else { 1 };
    moved("patch_set", &patches[0], &patches[patch_set], &mut losses);
    let settings = stored.settings.clamped();
    moved("settings", &stored.settings, &settings, &mut losses);
    let weight_factor = stored
        .weight_factor
        .clamp(*WEIGHT_FACTORS.start(), *WEIGHT_FACTORS.end());
    moved(
        "weight_factor",
        &stored.weight_factor,
        &weight_factor,
        &mut losses,
    );
    let pages = stored.pages.clone().in_reach();
    moved("pages", &stored.pages, &pages, &mut losses);
    let preferences = stored.preferences.map(|preferences| {
        let clamped = preferences.clone().clamped();
        moved("preferences", &preferences, &clamped, &mut losses);
        clamped
    });
    let mut document = Document {
        light: of_kind(light, |kind| kind == Kind::Light, &mut losses)
            .unwrap_or_else(|| first.clone()),
        second: of_kind(second, |kind| kind == Kind::Light, &mut losses),
        factor: of_kind(factor, Kind::is_factor, &mut losses),
        subject: stored.subject,
        overlays,
        next_own,
        own,
        images: Vec::new(),
        settings,
        given: stored.given.map(Settings::clamped),
        edits: stored.edits,
        patch_set: patches[patch_set].to_owned(),
        own_patches: stored.own_patches,
        patch: stored.patch,
        scale: stored.scale,
        weight_factor,
        view: stored.view,
        products: products.0,
        pages,
    };
    document.weigh_the_papers_lamps();
    document.own_patches.truncate(MOST_OWN_PATCHES);
    Restored {
        document,
        images: stored.images,
        preferences,
        losses,
    }
}

/// What the library makes when it is asked for, such as an ideal filter at any place.
fn made(key: &str) -> Option<Arc<Entry>> {
    let preset = Library::bundled().find_or_make(key).ok()?;
    Entry::of_preset(&preset).map(Arc::new)
}

/// An entry where it is of the kind that its place asks for.
fn of_kind(
    entry: Option<Arc<Entry>>,
    is_it: impl Fn(Kind) -> bool,
    losses: &mut Vec<String>,
) -> Option<Arc<Entry>> {
    let entry = entry?;
    if is_it(entry.kind()) {
        return Some(entry);
    }
    losses.push(tr!(
        "{name} is not shown where it was: found {kind} values.",
        name = entry.name(),
        kind = said(entry.kind().word())
    ));
    None
}

fn is_patch_set(group: &str) -> bool {
    let group = Library::bundled().group(group);
    group.is_some_and(|group| group.items.iter().any(|item| item.kind.is_factor()))
}

/// What the page `Products` multiplies, and what is to be said where its chain is another one.
fn of_products(
    stored: StoredProducts,
    find: &mut impl FnMut(&str) -> Option<Arc<Entry>>,
) -> (Products, Option<String>) {
    let products = stored.found(find);
    let clamped = products.clone().clamped();
    let mut moves = Vec::new();
    if products.chain.len() == clamped.chain.len() {
        let times = |products: &Products| StoredProducts::of(products).chain;
        let (before, after) = (times(&products), times(&clamped));
        moved("products.chain", &before, &after, &mut moves);
    } else {
        let (found, kept) = (products.chain.len(), clamped.chain.len());
        moves.push(tr!(
            "The chain keeps {kept} of its {found} steps.",
            kept,
            found
        ));
    }
    (clamped, moves.pop())
}

/// The user's own spectra, each under a key of its own, and the next free number.
fn own_entries(
    stored: Vec<OwnSpectrum>,
    next: u64,
    images: &[StoredImage],
    losses: &mut Vec<String>,
) -> (Vec<Arc<Entry>>, u64) {
    let mut entries = Vec::new();
    for spectrum in stored {
        let name = spectrum.name.clone();
        match spectrum.into_entry() {
            Ok(entry) => entries.push(entry),
            Err(why) => losses.push(tr!("{name} was not brought back: {why}.", name, why)),
        }
    }
    let numbers = entries.iter().map(|e| e.key.strip_prefix("own/"));
    let numbers = numbers.chain(images.iter().map(|i| i.key.strip_prefix("image/")));
    let highest = numbers
        .filter_map(|number| number?.parse::<u64>().ok())
        .filter(|n| *n < MOST_OWN)
        .max()
        .unwrap_or(0);
    let mut next = next.min(MOST_OWN).max(highest + 1);
    let mut known = HashSet::new();
    for entry in &mut entries {
        if entry.key.is_empty() || !known.insert(entry.key.clone()) {
            entry.key = format!("own/{next}");
            known.insert(entry.key.clone());
            next += 1;
        }
    }
    (entries.into_iter().map(Arc::new).collect(), next)
}

/// Far more spectra than anybody opens; a file that claims more counts from here.
const MOST_OWN: u64 = 1 << 40;

/// What is wrong with a text that is no project, in words.
fn broken_json(error: &serde_json::Error) -> String {
    let line = error.line();
    match error.classify() {
        serde_json::error::Category::Eof if line <= 1 && error.column() == 0 => {
            tr!(
                "found an empty file, expected a {format} file",
                format = FORMAT
            )
        }
        serde_json::error::Category::Eof => {
            tr!(
                "line {line}: the file ends in the middle, expected a whole {format} file",
                line,
                format = FORMAT
            )
        }
        _ => {
            // serde repeats the place at the end.
            let words = error.to_string();
            let words = words.split(" at line ").next().unwrap_or_default();
            tr!(
                "line {line}: {why}, expected a {format} file",
                line,
                why = words,
                format = FORMAT
            )
        }
    }
}
