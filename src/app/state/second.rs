//! The second light of the document, and how spectra are laid over the subject.

use std::sync::Arc;

use super::{App, Tone};
use crate::{
    app::{beside::Beside, comparison::Compared, entry::Entry, laid::Laid, lit::Lit},
    languages::said,
    spectrum::Kind,
};

impl App {
    /// The largest measured size on the scale in force.
    pub(in crate::app) fn top(&self) -> f64 {
        let sizes = self.derived.measured.iter().map(|v| v.abs());
        self.scale_factor * sizes.fold(0.0, f64::max)
    }

    /// How spectra are laid over the subject, in the order of `Document::laid_over`.
    pub fn laid(&self) -> impl Iterator<Item = (&Arc<Entry>, Laid)> {
        let over = || self.document.laid_over();
        let scale = || (self.scale_factor, self.top());
        let make = || {
            over()
                .map(|entry| Laid::of(&self.document, scale(), entry))
                .collect()
        };
        over().zip(self.laid.get_or_init(make).iter().copied())
    }

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
            let (name, kind) = (entry.name(), said(entry.kind().word()));
            let words = tr!(
                "{name} is no light to compare with: it holds {kind} values.",
                name,
                kind
            );
            return self.say(Tone::Problem, words);
        }
        self.document.second = second;
        self.document.weigh_the_papers_lamps();
    }
}
