//! Steps back and forth.

use super::{App, deriving::same_model, messages::Tone};
use crate::app::{document::Document, history::History, undo_words::difference};

impl App {
    /// Whether there is something to undo.
    pub fn can_undo(&self) -> bool {
        self.history.before().is_some()
    }

    /// Whether there is something to do again.
    pub fn can_redo(&self) -> bool {
        self.history.after().is_some()
    }

    /// What undo would take back, in words.
    pub fn undo_words(&self) -> Option<String> {
        let before = self.history.before()?;
        Some(difference(before, &self.document))
    }

    /// What would be done again, in words.
    pub fn redo_words(&self) -> Option<String> {
        let after = self.history.after()?;
        Some(difference(&self.document, after))
    }

    /// Takes a step that there is, or says that there is none.
    pub(super) fn step(
        &mut self,
        step: impl Fn(&mut History, &Document) -> Option<Document>,
        words: Option<String>,
        otherwise: &str,
    ) {
        match step(&mut self.history, &self.document) {
            Some(document) => {
                let has_same_model = same_model(&self.document, &document);
                self.document = document;
                self.gesture = None;
                self.recompute(has_same_model);
                if let Some(words) = words {
                    self.say_for_now(Tone::Info, words);
                }
            }
            None => self.say(Tone::Info, otherwise),
        }
    }
}
