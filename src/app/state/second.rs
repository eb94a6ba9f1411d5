//! The second light of the document.

use std::sync::Arc;

use super::{App, Tone};
use crate::{
    app::{beside::Beside, comparison::Compared, entry::Entry, lit::Lit},
    spectrum::Kind,
};

impl App {
    /// The light compared with the second light, computed at the first call; `None` where there is
    /// no second light.
    pub fn compared(&self) -> Option<&Compared> {
        self.beside.as_ref().map(Beside::compared)
    }

    /// The surfaces under the light and the second light, computed at the first call after a change;
    /// `None` where there is no second light, or one of them is not seen.
    pub fn surfaces_beside(&self) -> Option<&[Lit]> {
        self.beside.as_ref()?.surfaces(&self.document)
    }

    /// Compares the light with another one, or with none.
    pub(super) fn compare(&mut self, second: Option<Arc<Entry>>) {
        if let Some(entry) = second.as_ref().filter(|e| e.kind() != Kind::Light) {
            let (name, kind) = (entry.name(), entry.kind());
            let words = format!("{name} is no light to compare with: it holds {kind} values.");
            return self.say(Tone::Problem, words);
        }
        self.document.second = second;
        self.document.weigh_the_papers_lamps();
    }
}
