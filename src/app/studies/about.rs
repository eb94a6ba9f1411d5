//! What a study is about: the part of a document that its result depends on.

use std::sync::Arc;

use crate::{
    app::{document::Document, entry::Entry, library::Library, memo::ByAddress},
    color::{Observer, patches::PatchSet},
    spectrum::{Band, SpikeSettings},
    study::{Measures, Subject},
};

/// The subject of a study and what it is judged by.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct About {
    /// The spectrum.
    pub subject: ByAddress<Entry>,
    /// The light it is seen under; `None` when it is a light itself.
    pub under: Option<ByAddress<Entry>>,
    /// The model's range.
    pub band: Band,
    /// Whose colour-matching functions.
    pub observer: Observer,
    pub patches: Patches,
    /// How lines are looked for.
    pub spikes: SpikeSettings,
}

impl About {
    /// What a document's studies are about.
    pub fn of(document: &Document) -> Self {
        let settings = document.settings;
        Self {
            subject: ByAddress(document.subject_entry().clone()),
            under: (!document.is_about_light()).then(|| ByAddress(document.light.clone())),
            band: settings.band,
            observer: settings.observer,
            patches: Patches::of(document),
            spikes: settings.spike_settings(),
        }
    }

    /// The subject on the grid with its measures.
    pub fn subject(&self) -> Subject {
        Subject {
            measures: self.patches.measures(self.band, self.observer),
            values: self.subject.0.on_band(self.band),
            under: self.under.as_ref().map(|light| light.0.on_band(self.band)),
            spikes: self.spikes,
            profile: None,
        }
    }
}

/// The surfaces that a light is judged by: a shipped set, and the user's own behind it.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Patches {
    /// The group of the shipped ones.
    pub set: String,
    /// Those of the user's own.
    pub own: Vec<ByAddress<Entry>>,
}

impl Patches {
    /// Those of a document.
    pub fn of(document: &Document) -> Self {
        let own = document.patches_of_own().cloned();
        Self {
            set: document.patch_set.clone(),
            own: own.map(ByAddress).collect(),
        }
    }

    /// The group, and how many of the user's own stand behind it.
    pub fn words(&self) -> String {
        match self.own.len() {
            0 => self.set.clone(),
            own => tr!("{set} and {own} of your own", set = self.set, own),
        }
    }

    /// Their names and reflectances on a band's grid.
    pub fn reflectances(&self, band: Band) -> (Vec<String>, Vec<Vec<f64>>) {
        let (mut names, mut all) = reflectances(&self.set, band);
        for ByAddress(entry) in &self.own {
            names.push(entry.name().to_owned());
            all.push(entry.on_band(band));
        }
        (names, all)
    }

    /// Measures with them as the patches.
    pub fn measures(&self, band: Band, observer: Observer) -> Arc<Measures> {
        let (names, reflectances) = self.reflectances(band);
        let patches = PatchSet::new(&reflectances, names, band, observer);
        Arc::new(Measures::new(patches))
    }
}

/// Names and reflectances of a shipped group on a band's grid.
pub fn reflectances(group: &str, band: Band) -> (Vec<String>, Vec<Vec<f64>>) {
    let items = Library::bundled().group(group).map(|g| &g.items[..]);
    items
        .unwrap_or_default()
        .iter()
        .filter_map(|p| p.spectrum())
        .filter(|s| s.kind.is_factor())
        .map(|s| (s.name.clone(), s.samples.on_band(band, s.kind.outside())))
        .unzip()
}
