//! The photograph on its page, as far as others ask for it: lessons have tasks about it.

use super::App;
use crate::app::photograph::{Photograph, Seen, Staged};

impl App {
    /// The photograph that the page shows, and what was found in it.
    pub fn photograph(&self) -> Option<&Photograph> {
        self.on_page.photograph()
    }

    /// The picture that a lesson has put in its place.
    pub fn staged_photograph(&self) -> Option<Staged> {
        self.on_page.staged
    }

    /// Puts a picture in the place of a person's own, or gives the place back.
    pub fn stage_photograph(&mut self, staged: Option<Staged>) {
        if self.on_page.staged != staged {
            self.on_page.staged = staged;
            self.changes += 1;
        }
    }

    /// Takes note of the photograph that the page shows.
    pub fn note_photograph(&mut self, seen: &Seen) {
        if self.on_page.note(seen) {
            self.changes += 1;
        }
    }
}
