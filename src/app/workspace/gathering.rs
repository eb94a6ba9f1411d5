//! What a window starts with: its own workspace, and the files of windows that are gone.

use std::{collections::BTreeMap, path::Path, sync::Arc};

use super::{
    Place, Preferences, Restored, StoredImage,
    file::{load, no_file_at, save, sweep_leftovers},
    from_json, name_of, to_json_with,
};
use crate::app::{
    document::{Document, first_light},
    entry::{Entry, bundled_entries},
    state::Tone,
};

/// A file that a save left unfinished this long ago is nobody's any more.
const LEFT_OVER: std::time::Duration = std::time::Duration::from_secs(3600);

/// What a window starts with.
#[derive(Debug, Default)]
pub struct Begun {
    /// What was left the last time; `None` at a first start.
    pub restored: Option<Restored>,
    /// Where it is kept; `None` where nothing can be.
    pub place: Option<Place>,
    /// What is to be said.
    pub words: Vec<(Tone, String)>,
}

/// Claims the workspace at a path, or one beside it where another window has it, and brings in
/// what windows that are gone left beside it.
pub fn begin(path: &Path) -> Begun {
    let mut begun = Begun::default();
    if let Some(why) = no_file_at(path) {
        begun.words.push((Tone::Info, why));
        return begun;
    }
    sweep_leftovers(path, LEFT_OVER);
    let place = match Place::claim(path) {
        Ok(place) => place,
        Err(why) => {
            begun.words.push((Tone::Problem, why));
            return begun;
        }
    };
    match load(place.path()) {
        Ok(restored) => begun.restored = restored,
        Err(why) => begun.words.push((Tone::Problem, why)),
    }
    if place.is_beside() {
        if begun.restored.is_none() {
            begun.restored = looks_of(path);
        }
        let name = name_of(place.path());
        begun.words.push((
            Tone::Problem,
            tr!(
                "Another window uses this workspace: this one keeps its own beside it, {name}. \
                 The next start brings the files of both together.",
                name
            ),
        ));
    }
    if !place.is_locked() {
        let words =
            said!("The workspace cannot be locked here: do not open a second window on it.");
        begun.words.push((Tone::Problem, words.to_owned()));
    }
    for left in place.left_behind() {
        gather(&mut begun, &place, &left);
    }
    begun.place = Some(place);
    begun
}

/// A fresh document with the looks of another.
fn fresh(preferences: Option<Preferences>) -> Restored {
    Restored {
        document: Document::about(first_light(bundled_entries())),
        images: Vec::new(),
        preferences,
        losses: Vec::new(),
    }
}

/// A fresh document with the looks of the first window's.
fn looks_of(path: &Path) -> Option<Restored> {
    let text = std::fs::read_to_string(path).ok()?;
    Some(fresh(from_json(&text).ok()?.preferences))
}

/// Brings another window's spectra and images in. Its file goes out of the way only once they are
/// on disk here.
fn gather(begun: &mut Begun, place: &Place, left: &Place) {
    let other = match load(left.path()) {
        Ok(Some(other)) => other,
        Ok(None) => return,
        Err(why) => return begun.words.push((Tone::Problem, why)),
    };
    let restored = begun.restored.take();
    let mut restored = restored.unwrap_or_else(|| fresh(other.preferences.clone()));
    let (spectra, images) = bring(&mut restored, other);
    let text = to_json_with(
        &restored.document,
        restored.preferences.as_ref(),
        &restored.images,
    );
    begun.restored = Some(restored);
    if let Err(why) = text.and_then(|text| save(place.path(), &text)) {
        return begun.words.push((Tone::Problem, why));
    }
    let (from, to) = (left.path(), left.retired());
    let kept = match std::fs::rename(from, &to) {
        Ok(()) => name_of(&to),
        // It is looked at again at the next start, and nothing in it is new then.
        Err(_) => name_of(from),
    };
    let spectra = (spectra > 0).then(|| tr!("{n} spectrum" | "{n} spectra" % spectra));
    let images = (images > 0).then(|| tr!("{n} image" | "{n} images" % images));
    let brought: Vec<String> = spectra.into_iter().chain(images).collect();
    if !brought.is_empty() {
        let words = tr!(
            "Brought here from another window: {brought}. Its workspace is kept as {file}.",
            brought = brought.join(", "),
            file = kept
        );
        begun.words.push((Tone::Info, words));
    }
}

/// Adds what is not there yet; tells how many spectra and images.
fn bring(restored: &mut Restored, other: Restored) -> (usize, usize) {
    let document = &mut restored.document;
    let before = (document.own.len(), restored.images.len());
    let mut keys = BTreeMap::new();
    for entry in &other.document.own {
        let known = document
            .own
            .iter()
            .find(|own| own.spectrum == entry.spectrum);
        let key = known.map_or_else(|| format!("own/{}", document.next_own), |k| k.key.clone());
        if known.is_none() {
            document.next_own = document.next_own.saturating_add(1);
            let key = key.clone();
            let entry = Entry::clone(entry);
            document.own.push(Arc::new(Entry { key, ..entry }));
        }
        keys.insert(entry.key.clone(), key);
    }
    for (key, edits) in other.document.edits {
        // Shipped spectra are called the same everywhere.
        let key = keys.get(&key).cloned().unwrap_or(key);
        document.edits.entry(key).or_insert(edits);
    }
    for image in other.images {
        let is_known = |known: &StoredImage| {
            (&known.path, known.index, &known.choices) == (&image.path, image.index, &image.choices)
        };
        if !restored.images.iter().any(is_known) {
            restored.images.push(StoredImage {
                key: format!("image/{}", document.next_own),
                ..image
            });
            document.next_own = document.next_own.saturating_add(1);
        }
    }
    let spectra = document.own.len() - before.0;
    (spectra, restored.images.len() - before.1)
}
