//! Steps back and forth.

use super::{App, deriving::Kept, messages::Tone};
use crate::app::{
    command::Command, document::Document, history::History, pages::PageStates,
    undo_words::difference,
};

impl App {
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

    /// Changes what pages keep, as a person does.
    pub fn edit_pages(&mut self, change: impl FnOnce(&mut PageStates)) {
        let mut pages = Box::new(self.document.pages.clone());
        change(&mut pages);
        self.apply(Command::Page(pages));
    }

    /// Changes what pages keep, as a consequence of what was done before: no step of its own.
    pub fn pages_follow(&mut self, change: impl FnOnce(&mut PageStates)) {
        let before = self.document.pages.clone();
        change(&mut self.document.pages);
        self.document.pages = std::mem::take(&mut self.document.pages).in_reach();
        if self.document.pages != before {
            self.recompute(Kept::AllButPages);
        }
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
                let kept = Kept::of(&self.document, &document);
                self.document = document;
                self.gesture = None;
                self.recompute(kept);
                if let Some(words) = words {
                    self.say_for_now(Tone::Info, words);
                }
            }
            None => self.say(Tone::Info, otherwise),
        }
    }
}
