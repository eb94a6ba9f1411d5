//! Searches among many surfaces: pairs that match under one light and part under another.

use super::Question;
use crate::{
    app::{Entry, library::Library, memo::ByAddress},
    color::Observer,
    preset::Group,
    spectrum::{Band, Kind},
    study::{
        Progress,
        products::{MATCH_DELTA_E, Metamers, TwoLights, metameric_pairs, two_lights},
    },
};

/// A shipped surface on a grid.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// What finds it again: `group/name`.
    pub key: String,
    pub name: String,
    /// Its shares of light.
    pub values: Vec<f64>,
}

impl Surface {
    /// What people call it: a numbered sample of a set by its number.
    pub fn words(&self) -> String {
        let number = self.name.strip_prefix("rawtoaces ");
        let number = number.and_then(|rest| rest.split_once("patch"));
        number.map_or_else(
            || self.name.clone(),
            |(_, number)| tr!("ACES sample {number}", number),
        )
    }
}

/// The factors of a group, or every shipped reflectance, on a band's grid.
pub(crate) fn surfaces(group: Option<&str>, band: Band) -> Vec<Surface> {
    let library = Library::bundled();
    let groups: Vec<&Group> = match group {
        Some(id) => library.group(id).into_iter().collect(),
        None => library.groups().to_vec(),
    };
    groups
        .into_iter()
        .flat_map(|group| &group.items)
        .filter_map(|preset| Some((preset, preset.spectrum()?)))
        .filter(|(_, s)| match group {
            Some(_) => s.kind.is_factor(),
            None => s.kind == Kind::Reflectance,
        })
        .map(|(preset, s)| Surface {
            key: preset.id(),
            name: s.name.clone(),
            values: s.samples.on_band(band, s.kind.outside()),
        })
        .collect()
}

/// How many reflectances are shipped.
pub fn shipped_reflectances() -> usize {
    let spectra = Library::bundled().spectra();
    spectra.filter(|s| s.kind == Kind::Reflectance).count()
}

/// What metameric pairs are asked of.
#[derive(Clone, Debug, PartialEq)]
pub struct PairsAsk {
    /// The light that pairs match under, and the one that they part under.
    pub lights: [ByAddress<Entry>; 2],
    /// The range.
    pub band: Band,
    /// Whose colour-matching functions.
    pub observer: Observer,
    /// The group that is searched; `None` for all shipped reflectances.
    pub group: Option<String>,
}

/// Pairs that were found, with what they were found among.
#[derive(Clone, Debug, PartialEq)]
pub struct Pairs {
    /// What was searched.
    pub surfaces: Vec<Surface>,
    /// Their colours under both lights.
    pub both: TwoLights,
    /// The pairs.
    pub metamers: Metamers,
}

impl Question for PairsAsk {
    type Answer = Pairs;

    /// The answer; `None` when a light is not seen or it was cancelled.
    fn answer(&self, progress: &Progress) -> Option<Pairs> {
        let surfaces = surfaces(self.group.as_deref(), self.band);
        let values: Vec<Vec<f64>> = surfaces.iter().map(|s| s.values.clone()).collect();
        progress.expect(surfaces.len());
        let [first, second] = [0, 1].map(|i| self.lights[i].0.on_band(self.band));
        let seen = self.observer.table().on_band(self.band);
        let both = two_lights(self.band, &values, [&first, &second], &seen)?;
        let metamers = metameric_pairs(self.band, &values, &both, MATCH_DELTA_E, progress)?;
        Some(Pairs {
            surfaces,
            both,
            metamers,
        })
    }
}
