//! The second light beside the light: what both are compared by, computed where it is asked for.

use std::sync::{Arc, OnceLock};

use super::{
    comparison::{Compared, Side},
    document::Document,
    entry::Entry,
    lit::Lit,
};

/// Two lights that are compared.
#[derive(Clone, Debug)]
pub(super) struct Beside {
    lights: [Arc<Entry>; 2],
    compared: OnceLock<Compared>,
    surfaces: OnceLock<Option<Vec<Lit>>>,
}

impl Beside {
    /// Of a document that changed; what depends on the lights alone stays where they are the same.
    pub(super) fn of(document: &Document, before: Option<Self>) -> Option<Self> {
        let lights = [document.light.clone(), document.second.clone()?];
        let same = before.filter(|before| before.lights == lights);
        Some(Self {
            lights,
            compared: same.map_or_else(OnceLock::new, |before| before.compared),
            surfaces: OnceLock::new(),
        })
    }

    /// Which light is better for what.
    pub(super) fn compared(&self) -> &Compared {
        self.compared.get_or_init(|| {
            let side = |light: &Arc<Entry>| Side::of(light.name().to_owned(), &light.spectrum);
            Compared::of(self.lights.each_ref().map(side))
        })
    }

    /// The document's surfaces under both.
    pub(super) fn surfaces(&self, document: &Document) -> Option<&[Lit]> {
        let make = || Lit::beside(document, &self.lights[1]);
        self.surfaces.get_or_init(make).as_deref()
    }
}
