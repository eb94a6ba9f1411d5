//! Searches among many surfaces: pairs that match under one light and part under another, and the
//! surface that explains a spectrum best.

use std::sync::Arc;

use super::Question;
use crate::{
    app::{Entry, library::Library, memo::ByAddress},
    color::{Adaptation, Observer, Swatch, xyz_of_parts},
    preset::Group,
    spectrum::{Band, Composite, Kind},
    study::{
        Progress,
        products::{
            Checker, MATCH_DELTA_E, Metamers, Reflection, Sameness, TwoLights, measured_check,
            metameric_pairs, two_lights,
        },
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
            |(_, number)| format!("ACES sample {number}"),
        )
    }
}

/// The factors of a group, or every shipped reflectance, on a band's grid.
pub(super) fn surfaces(group: Option<&str>, band: Band) -> Vec<Surface> {
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

/// What the ranking of surfaces is asked of.
#[derive(Clone, Debug, PartialEq)]
pub struct RankAsk {
    /// The light and what came from the surface, as measured.
    pub measured: [ByAddress<Entry>; 2],
    /// The same in the model's numbers.
    pub models: Arc<[Composite; 2]>,
    /// What the two models leave out themselves, as [`Sameness::of`] takes it.
    pub left_out: f64,
    /// The range.
    pub band: Band,
    /// Whose colour-matching functions, for the swatches.
    pub observer: Observer,
    /// The group that is searched; `None` for all shipped reflectances.
    pub group: Option<String>,
}

/// A surface and how well it explains the outgoing spectrum.
#[derive(Clone, Debug, PartialEq)]
pub struct Ranked {
    /// What finds it again: `group/name`.
    pub key: String,
    pub name: String,
    /// Its colour under the light.
    pub swatch: Swatch,
    /// The check in the model's numbers.
    pub model: Option<Reflection>,
    pub verdict: Sameness,
    /// The check on measured curves.
    pub measured: Option<Reflection>,
}

impl Question for RankAsk {
    type Answer = Vec<Ranked>;

    /// Every surface, the smallest residual of the model first; `None` when one of the spectra is
    /// dark or it was cancelled.
    fn answer(&self, progress: &Progress) -> Option<Vec<Ranked>> {
        let band = self.band;
        let surfaces = surfaces(self.group.as_deref(), band);
        progress.expect(surfaces.len());
        let [light, outgoing] = &*self.models;
        let checker = Checker::new(light, outgoing);
        let [light, outgoing] = [0, 1].map(|i| self.measured[i].0.on_band(band));
        let seen = self.observer.table().on_band(band);
        let weigh = |values: &[f64]| xyz_of_parts(band, values, &[], &seen);
        let white = weigh(&light);
        let mut ranked = Vec::with_capacity(surfaces.len());
        for surface in surfaces {
            if progress.is_cancelled() {
                return None;
            }
            let lit: Vec<f64> = light
                .iter()
                .zip(&surface.values)
                .map(|(l, r)| l * r)
                .collect();
            let measured = measured_check(band, &light, &surface.values, &outgoing);
            let model = checker.against(&surface.values).map(|c| c.reflection);
            ranked.push(Ranked {
                swatch: Swatch::of_patch(weigh(&lit), white, Adaptation::None),
                verdict: Sameness::of(model, self.left_out),
                model,
                measured: measured.map(|c| c.reflection),
                key: surface.key,
                name: surface.name,
            });
            progress.step();
        }
        if ranked.iter().all(|r| r.model.is_none()) {
            return None;
        }
        // A light turned negative explains nothing.
        let residual = |r: &Ranked| match r.model {
            Some(model) if model.factor > 0.0 => model.residual,
            _ => f64::INFINITY,
        };
        ranked.sort_by(|a, b| residual(a).total_cmp(&residual(b)));
        Some(ranked)
    }
}
