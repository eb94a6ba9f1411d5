//! The light that is followed: it changes with every frame, and no frame is a step of undo.

use std::sync::Arc;

use super::{App, deriving::Kept};
use crate::app::{command::Command, entry::Entry};

impl App {
    /// Puts the light of a stream into the library, in every step of the history too, and shows it;
    /// one of the same source takes the place of the one before. Gives its key.
    pub fn follow(&mut self, entry: Entry) -> String {
        let source = &entry.spectrum.source;
        let mut own = self.document.own.iter();
        let known = own.find(|own| own.spectrum.source == *source);
        let key = match known.map(|own| own.key.clone()) {
            Some(key) => {
                self.put_frame(&key, &entry);
                key
            }
            None => {
                let entry = self.numbered(entry);
                let next = self.document.next_own;
                let documents = std::iter::once(&mut self.document).chain(self.history.all_mut());
                for document in documents {
                    document.own.push(entry.clone());
                    document.next_own = document.next_own.max(next);
                }
                entry.key.clone()
            }
        };
        if let Some(entry) = self.entry(&key) {
            self.apply(Command::Show(entry));
            self.end_gesture();
        }
        self.live = Some(key.clone());
        key
    }

    /// The light that is followed.
    pub fn live(&self) -> Option<Arc<Entry>> {
        self.entry(self.live.as_deref()?)
    }

    /// Follows what another state follows.
    pub fn follow_as(&mut self, other: &Self) {
        self.live.clone_from(&other.live);
    }

    /// Nothing is followed any more.
    pub fn follow_no_more(&mut self) {
        self.live = None;
    }

    /// Puts a frame in the place of the one before it.
    pub fn put_frame(&mut self, key: &str, frame: &Entry) {
        let before = self.document.clone();
        self.change_entry(key, |entry| {
            entry.spectrum.clone_from(&frame.spectrum);
            entry.measured.clone_from(&frame.measured);
        });
        self.make_again(&before);
        self.document.bound_patch();
        self.recompute(Kept::of(&before, &self.document));
    }

    /// One more of the user's own, which is not shown.
    pub(super) fn join(&mut self, made: Entry) -> Arc<Entry> {
        let entry = self.numbered(made);
        self.document.own.push(entry.clone());
        entry
    }
}
