//! Undo and redo: two lists of documents.

use std::sync::Arc;

use super::document::Document;

/// Steps kept; a document shares its spectra, so a step is small.
const MOST_STEPS: usize = 500;

/// What was before and what was undone, shared by every copy of the program's state.
#[derive(Clone, Debug, Default)]
pub(super) struct History {
    past: Vec<Arc<Document>>,
    future: Vec<Arc<Document>>,
}

impl History {
    /// Remembers a document that is about to change; what was undone is forgotten.
    pub(super) fn remember(&mut self, before: Document) {
        if self.past.len() == MOST_STEPS {
            self.past.remove(0);
        }
        self.past.push(Arc::new(before));
        self.future.clear();
    }

    /// The document before, in exchange for the present one.
    pub(super) fn undo(&mut self, present: &Document) -> Option<Document> {
        let before = self.past.pop()?;
        self.future.push(Arc::new(present.clone()));
        Some(Arc::unwrap_or_clone(before))
    }

    /// The document that was undone last, in exchange for the present one.
    pub(super) fn redo(&mut self, present: &Document) -> Option<Document> {
        let after = self.future.pop()?;
        self.past.push(Arc::new(present.clone()));
        Some(Arc::unwrap_or_clone(after))
    }

    /// The document that a step back leads to.
    pub(super) fn before(&self) -> Option<&Document> {
        self.past.last().map(|before| &**before)
    }

    /// The document that a step forward leads to.
    pub(super) fn after(&self) -> Option<&Document> {
        self.future.last().map(|after| &**after)
    }

    /// Every document that is remembered.
    pub(super) fn all_mut(&mut self) -> impl Iterator<Item = &mut Document> {
        let all = self.past.iter_mut().chain(&mut self.future);
        all.map(Arc::make_mut)
    }
}
