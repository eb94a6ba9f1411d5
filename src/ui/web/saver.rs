//! Keeps the workspace in the browser, a moment after it changed.

use std::{
    cell::RefCell,
    path::{Path, PathBuf},
    time::Duration,
};

use web_time::Instant;

use super::web::keep;
use crate::app::{
    Document,
    workspace::{self, Preferences, StoredImage},
};

/// A change is kept at most this long after it was made.
pub(super) const AFTER: Duration = Duration::from_millis(700);

/// What is kept, and when it must be.
struct Kept {
    document: Document,
    preferences: Preferences,
    waiting: Vec<StoredImage>,
    due: Instant,
}

thread_local! {
    /// The newest workspace; what came in between is skipped.
    static WAITING: RefCell<Option<Kept>> = RefCell::default();
}

/// Writes what waits; what went wrong.
pub(super) fn write() -> Option<String> {
    let Kept {
        document,
        preferences,
        waiting,
        ..
    } = WAITING.take()?;
    let why = match workspace::to_json_with(&document, Some(&preferences), &waiting) {
        Ok(text) => keep(&text),
        Err(why) => why.to_string(),
    };
    (!why.is_empty()).then(|| {
        tr!(
            "Workspace not kept in this browser: {reason}.",
            reason = why
        )
    })
}

/// Hands the workspace to the browser.
pub struct Saver {
    path: PathBuf,
    /// What was told last: it is told once.
    told: Option<String>,
}

impl Saver {
    /// A saver under a name.
    pub fn new(path: PathBuf) -> Self {
        Self { path, told: None }
    }

    /// The name.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Hands over what is to be written at once.
    pub fn keep_with(
        &self,
        document: &Document,
        preferences: &Preferences,
        waiting: &[StoredImage],
    ) {
        self.keep_by(Instant::now(), (document, preferences, waiting));
    }

    /// The same, and it is written before anything else happens.
    pub fn keep_and_wait(
        &self,
        document: &Document,
        preferences: &Preferences,
        waiting: &[StoredImage],
    ) {
        self.keep_with(document, preferences, waiting);
        // Where it fails the next writing fails too, and tells it.
        write();
    }

    /// Hands over what is to be written soon: what follows within a moment is written with it.
    pub fn keep_soon(
        &self,
        document: &Document,
        preferences: &Preferences,
        waiting: &[StoredImage],
    ) {
        self.keep_by(Instant::now() + AFTER, (document, preferences, waiting));
    }

    fn keep_by(
        &self,
        due: Instant,
        (document, preferences, waiting): (&Document, &Preferences, &[StoredImage]),
    ) {
        WAITING.with_borrow_mut(|kept| {
            *kept = Some(Kept {
                document: document.clone(),
                preferences: preferences.clone(),
                waiting: waiting.to_vec(),
                due: kept.as_ref().map_or(due, |kept| kept.due.min(due)),
            });
        });
    }

    /// Writes what is due; what went wrong since the last call.
    pub fn trouble(&mut self) -> Option<String> {
        let now = Instant::now();
        let is_due = WAITING.with_borrow(|kept| kept.as_ref().is_some_and(|kept| kept.due <= now));
        let why = is_due.then(write)?;
        let is_new = why.is_some() && why != self.told;
        self.told.clone_from(&why);
        why.filter(|_| is_new)
    }
}
