//! Undo and redo: two lists of documents.

use super::document::Document;

/// Steps kept; a document shares its spectra, so a step is small.
const MOST_STEPS: usize = 500;

/// What was before and what was undone.
#[derive(Clone, Debug, Default)]
pub(super) struct History {
    past: Vec<Document>,
    future: Vec<Document>,
}

impl History {
    /// Remembers a document that is about to change; what was undone is forgotten.
    pub(super) fn remember(&mut self, before: Document) {
        if self.past.len() == MOST_STEPS {
            self.past.remove(0);
        }
        self.past.push(before);
        self.future.clear();
    }

    /// The document before, in exchange for the present one.
    pub(super) fn undo(&mut self, present: &Document) -> Option<Document> {
        let before = self.past.pop()?;
        self.future.push(present.clone());
        Some(before)
    }

    /// The document that was undone last, in exchange for the present one.
    pub(super) fn redo(&mut self, present: &Document) -> Option<Document> {
        let after = self.future.pop()?;
        self.past.push(present.clone());
        Some(after)
    }

    /// The document that a step back leads to.
    pub(super) fn before(&self) -> Option<&Document> {
        self.past.last()
    }

    /// The document that a step forward leads to.
    pub(super) fn after(&self) -> Option<&Document> {
        self.future.last()
    }

    /// Every document that is remembered.
    pub(super) fn all_mut(&mut self) -> impl Iterator<Item = &mut Document> {
        self.past.iter_mut().chain(&mut self.future)
    }
}
