//! Who and what a race is run on.

use std::sync::Arc;

use super::{
    about::{Patches, reflectances},
    lamps::{encoder, most_numbers},
};
use crate::{
    app::{document::Document, entry::Entry, library::Library, memo::ByAddress, ticks::short},
    color::Observer,
    lamps::{Count, LONGEST_RANGE_NM, LeaveOut, NUMBERS, Racing},
    preset::{Preset, Shelf},
    rivals::PrincipalBasis,
    spectrum::{Band, Kind, NamedSpectrum, SpikeSettings},
    study::{
        Training,
        race::{Encode, Lamp, RaceConfig},
        scaled_to_one,
    },
};

/// The group that judges what was chosen on the patches.
pub const CHECK_SET: &str = "tm30_ces99_5nm";

/// The lights that race.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub enum Field {
    /// One light.
    One(ByAddress<Entry>),
    /// Every shipped light.
    Shipped,
    /// The shipped lights of one class.
    Class(Class),
    /// The shipped lights of one file.
    Group(String),
    /// Any lights, such as the user's own.
    These(Vec<ByAddress<Entry>>),
}

/// What a race is about.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct RaceAsk {
    /// The lights.
    pub field: Field,
    /// The model's range.
    pub band: Band,
    /// Whose colour-matching functions.
    pub observer: Observer,
    /// The surfaces that choose.
    pub patches: Patches,
    /// How lines are looked for.
    pub spikes: SpikeSettings,
    /// Counts of numbers, rising.
    pub budgets: Vec<usize>,
    /// Whether a known lamp's index and a line's width are numbers of their own.
    pub strict: bool,
}

impl RaceAsk {
    /// A race of these lights under a document's settings.
    pub fn of(document: &Document, field: Field, budgets: Vec<usize>) -> Self {
        let settings = document.settings;
        Self {
            field,
            band: settings.band,
            observer: settings.observer,
            patches: Patches::of(document),
            spikes: settings.spike_settings(),
            budgets,
            strict: false,
        }
    }

    /// Why nobody races on this range, in words; `None` where a race can be run.
    pub fn why_not(&self) -> Option<String> {
        let [least, most] = [self.band.min_nm(), self.band.max_nm()];
        (self.band.steps() > LONGEST_RANGE_NM).then(|| {
            tr!(
                "found {least}:{most}, expected a range of at most {longest} nm for a race",
                least = short(least),
                most = short(most),
                longest = LONGEST_RANGE_NM
            )
        })
    }

    /// The counts at which known lamps and wide lines are judged: those that they can have.
    pub fn judged_counts(&self) -> Vec<usize> {
        let range = NUMBERS[0]..=most_numbers(self.band);
        let budgets = self.budgets.iter().copied();
        budgets.filter(|n| range.contains(n)).collect()
    }

    /// Known lamps and wide lines in the race; none where nothing is seen.
    fn encoder(&self) -> Option<Arc<dyn Encode>> {
        let encoder = encoder((self.band, self.observer, self.spikes)).ok()?;
        Some(Arc::new(Racing {
            encoder,
            count: if self.strict {
                Count::Strict
            } else {
                Count::Words
            },
            leave_out: LeaveOut::Likes,
        }))
    }

    /// The lights on the grid.
    pub fn lamps(&self) -> Vec<Lamp> {
        let band = self.band;
        let lamp = |spectrum: &NamedSpectrum, class: &str| Lamp {
            name: spectrum.name.clone(),
            class: class.to_owned(),
            values: spectrum.samples.on_band(band, spectrum.kind.outside()),
        };
        let shipped = |wanted: &dyn Fn(&Preset) -> bool| -> Vec<Lamp> {
            shipped_lights()
                .filter(|(preset, _)| wanted(preset))
                .map(|(preset, spectrum)| lamp(spectrum, class_word(preset)))
                .collect()
        };
        match &self.field {
            Field::Shipped => shipped(&|_| true),
            Field::Class(class) => shipped(&|preset| Class::of(preset) == Some(*class)),
            Field::Group(group) => Library::bundled()
                .group(group)
                .into_iter()
                .flat_map(|group| &group.items)
                .filter_map(|preset| Some((preset, Entry::of_preset(preset)?)))
                .filter(|(_, entry)| entry.kind() == Kind::Light)
                .map(|(preset, entry)| lamp(&entry.spectrum, class_word(preset)))
                .collect(),
            Field::One(entry) => vec![lamp(&entry.0.spectrum, ONE)],
            Field::These(entries) => entries
                .iter()
                .map(|entry| lamp(&entry.0.spectrum, OWN))
                .collect(),
        }
    }

    /// Everything else that the race is run on.
    pub fn course(&self) -> RaceConfig {
        let band = self.band;
        let most = self.budgets.iter().copied().max().unwrap_or(1);
        let (_, patches) = self.patches.reflectances(band);
        let (_, check) = reflectances(CHECK_SET, band);
        let lights: Vec<Lamp> = shipped_lights()
            .map(|(preset, s)| Lamp {
                name: s.name.clone(),
                class: class_word(preset).to_owned(),
                values: s.samples.on_band(band, s.kind.outside()),
            })
            .collect();
        RaceConfig {
            measures: self.patches.measures(band, self.observer),
            lights: Arc::new(Training::new(band, &lights, most)),
            reflectances: Arc::new(taught_reflectances(
                band,
                &[&self.patches.set, CHECK_SET],
                &[&patches, &check],
                most,
            )),
            patches,
            check,
            spikes: self.spikes,
            encoder: self.encoder(),
            budgets: self.budgets.clone(),
        }
    }
}

/// The class of a light that races alone.
pub(super) const ONE: &str = "this light";

/// The class of lights that are not shipped.
pub(super) const OWN: &str = "own";

/// Every shipped table of a light.
fn shipped_lights() -> impl Iterator<Item = (&'static Preset, &'static NamedSpectrum)> {
    Library::bundled()
        .presets()
        .filter_map(|preset| Some((preset, preset.spectrum()?)))
        .filter(|(_, spectrum)| spectrum.kind == Kind::Light)
}

/// A class of shipped lights.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum Class {
    /// Standard lights, the sun and the sky.
    Smooth,
    /// Light-emitting diodes.
    Led,
    /// Fluorescent lamps.
    Fluorescent,
    /// Sodium, mercury, metal halide and xenon lamps.
    Discharge,
}

impl Class {
    /// Every class.
    pub const ALL: [Self; 4] = [Self::Smooth, Self::Led, Self::Fluorescent, Self::Discharge];

    /// The word used in tables and on the command line.
    pub fn word(self) -> &'static str {
        match self {
            Self::Smooth => "smooth",
            Self::Led => "LED",
            Self::Fluorescent => "fluorescent",
            Self::Discharge => "discharge",
        }
    }

    /// The class that a shipped light is counted in.
    pub fn of(preset: &Preset) -> Option<Self> {
        match preset.shelf {
            Shelf::Standard | Shelf::Sun => Some(Self::Smooth),
            Shelf::Led => Some(Self::Led),
            Shelf::Fluorescent => Some(Self::Fluorescent),
            Shelf::Discharge => Some(Self::Discharge),
            Shelf::Paper
            | Shelf::Lines
            | Shelf::Reflectances
            | Shelf::Filters
            | Shelf::Observers => None,
        }
    }
}

fn class_word(preset: &Preset) -> &'static str {
    Class::of(preset).map_or("other", Class::word)
}

/// Reflectances whose normalised inner product exceeds this are the same surface.
const SAME: f64 = 0.9999;

/// Components of all shipped reflectances but those that judge, and none that is all but one of
/// them.
fn taught_reflectances(
    band: Band,
    groups: &[&str],
    judges: &[&Vec<Vec<f64>>],
    most: usize,
) -> PrincipalBasis {
    let unit = |values: &[f64]| -> Option<Vec<f64>> {
        let scaled = scaled_to_one(values)?;
        let norm = band.inner(&scaled, &scaled).sqrt();
        Some(scaled.iter().map(|v| v / norm).collect())
    };
    let judging: Vec<Vec<f64>> = judges
        .iter()
        .flat_map(|set| set.iter())
        .filter_map(|r| unit(r))
        .collect();
    let taught: Vec<Vec<f64>> = Library::bundled()
        .presets()
        .filter(|preset| !groups.contains(&preset.group.as_str()))
        .filter_map(|preset| preset.spectrum())
        .filter(|spectrum| spectrum.kind == Kind::Reflectance)
        .filter_map(|s| unit(&s.samples.on_band(band, s.kind.outside())))
        .filter(|r| !judging.iter().any(|judge| band.inner(judge, r) > SAME))
        .collect();
    PrincipalBasis::train(band, &taught, most)
}
