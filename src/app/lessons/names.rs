//! Spectra and pages by the names that a lesson calls them.

use std::sync::Arc;

use serde::Deserialize;

use crate::{
    app::{App, Entry, library::Library, pages::Page},
    languages::said,
};

/// A page by its word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(try_from = "String")]
pub struct PageWord(pub Page);

impl TryFrom<String> for PageWord {
    type Error = String;

    fn try_from(word: String) -> Result<Self, String> {
        let words = || Page::all().map(Page::word).collect::<Vec<_>>().join(", ");
        let page = Page::of_word(&word);
        page.map(Self)
            .ok_or_else(|| format!("unknown page {word}, expected one of {}", words()))
    }
}

/// The spectrum of a name: one of the person's own first, then of the library.
///
/// # Errors
/// What was found and what was expected.
pub(super) fn entry(app: &App, name: &str) -> Result<Arc<Entry>, String> {
    let own = app.document().own.iter().rev();
    if let Some(own) = own.into_iter().find(|own| own.name() == name) {
        return Ok(own.clone());
    }
    let preset = Library::bundled().find_or_make(name);
    let preset = preset.map_err(|why| tr!("found {why}", why))?;
    if let Some(shipped) = app.bundled().iter().find(|e| e.key == preset.id()) {
        return Ok(shipped.clone());
    }
    let made = Entry::of_preset(&preset).map(Arc::new);
    made.ok_or_else(|| tr!("found a list of lines, {name}, expected a spectrum", name))
}

/// What a lesson calls the light that is followed.
const LIVE: &str = "live";

/// What a name means where a light is asked for.
///
/// # Errors
/// As [`entry`], for a surface or a filter, and while nothing is followed.
pub(super) fn light(app: &App, name: &str) -> Result<Arc<Entry>, String> {
    let found = match name {
        LIVE => app
            .live()
            .ok_or(said!("no light is followed yet, expected one")),
        name => Ok(entry(app, name)?),
    }?;
    match found.kind().is_factor() {
        true => Err(tr!(
            "found {name} ({kind}), expected a light",
            name,
            kind = said(found.kind().word())
        )),
        false => Ok(found),
    }
}

/// Whether a name is in the library or among those that a lesson makes.
///
/// # Errors
/// What was found and what was expected.
pub(super) fn find(name: &str, made: &[&str]) -> Result<(), String> {
    if name == LIVE || made.contains(&name) {
        return Ok(());
    }
    let found = Library::bundled().find_or_make(name);
    found.map(drop).map_err(|why| tr!("found {why}", why))
}
