//! From a recipe to a spectrum: pure steps over a document.

use std::sync::Arc;

use super::{
    combining::{Act, Part},
    design::{
        light,
        recovered::{self, Shown},
    },
    document::Document,
    entry::Entry,
    library::Library,
    opened::ImageEntry,
    photons, picture,
    products::{
        Link,
        two_lights::{Made, NoMetamer, TwoLightsSheet},
    },
    recipe::{Gel, Given, Recipe},
};
use crate::{
    design::{
        mixture::{MixError, Source},
        recover::RecoverError,
    },
    languages::said,
    spectrum::{Band, Kind, NamedSpectrum, Sampled},
};

/// Why something cannot be made.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum WhyNot {
    /// Nothing has that key.
    Missing(String),
    /// It is not what it has to be: key, what it is, what was expected.
    OtherKind(String, Kind, &'static str),
    /// There is no such metamer.
    Metamer(NoMetamer),
    /// Its channels make no light.
    Mix(MixError),
    /// No spectrum is made of its colour.
    Colour(RecoverError),
    /// The combination means nothing.
    Combined(String),
    /// Nothing was measured there.
    Nothing,
    /// It would be made of itself.
    Circle,
}

impl std::fmt::Display for WhyNot {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Missing(key) => f.write_str(&tr!("found no {key}", key)),
            Self::OtherKind(key, kind, expected) => f.write_str(&tr!(
                "found {key} ({kind}), expected {expected}",
                key,
                kind = said(kind.word()),
                expected = said(expected)
            )),
            Self::Metamer(why) => write!(f, "{}", why.words()),
            Self::Mix(why) => write!(f, "{why}"),
            Self::Colour(why) => write!(f, "{why}"),
            // A sentence of its own, whose end is the caller's.
            Self::Combined(why) => write!(f, "{}", why.trim_end_matches('.')),
            Self::Nothing => f.write_str(said!("found nothing that was measured there")),
            Self::Circle => f.write_str(said!("it would be made of itself")),
        }
    }
}

/// Makes a spectrum.
///
/// # Errors
/// [`WhyNot`] when what it stands on is missing or unfit.
pub(super) fn make(recipe: &Recipe, document: &Document) -> Result<Entry, WhyNot> {
    let spectrum = match recipe {
        Recipe::Combined { act, parts } => return combined(document, act, parts),
        Recipe::Metamer {
            light,
            other,
            patch_set,
            patch,
            room_percent,
        } => {
            let lights = [lamp(document, light)?, lamp(document, other)?];
            let settings = document.settings;
            let sheet =
                TwoLightsSheet::measured(settings.band, settings.observer, lights, patch_set);
            Made::of(&sheet, *patch, *room_percent)
                .and_then(|made| made.spectrum(&sheet).ok_or(NoMetamer::NoRoom))
                .map_err(WhyNot::Metamer)
        }
        Recipe::Region { image, rect } => {
            let found = image_of(document, image).ok_or_else(|| WhyNot::Missing(image.clone()))?;
            picture::named(&found.image, *rect).ok_or(WhyNot::Nothing)
        }
        Recipe::Through { light, chain } => {
            let light = lamp(document, light)?;
            let links = chain
                .iter()
                .map(|(key, times)| Ok(Link::new(factor(document, key)?, *times)));
            through(&light, &links.collect::<Result<Vec<_>, _>>()?).ok_or(WhyNot::Nothing)
        }
        Recipe::Mix { channels, gels } => of_channels(document, channels, gels),
        Recipe::Colour {
            given,
            light,
            method,
            lines,
            second,
        } => {
            let mut shown = vec![shown(document, given, light)?];
            if let Some((given, light)) = second {
                shown.push(self::shown(document, given, light)?);
            }
            recovered::spectrum(*method, &shown, lines).map_err(WhyNot::Colour)
        }
    };
    spectrum.map(|spectrum| Entry::own(0, spectrum))
}

/// Measurements combined, with what is known of the result's doubt.
fn combined(document: &Document, act: &Act, keys: &[String]) -> Result<Entry, WhyNot> {
    let parts = keys.iter().map(|key| {
        let entry = found(document, key)?;
        Part::of_entry(&entry, false).map_err(WhyNot::Combined)
    });
    let parts = parts.collect::<Result<Vec<_>, _>>()?;
    let found = act.of(&parts).map_err(WhyNot::Combined)?;
    Ok(found.into_entry(&act.name(&parts)))
}

/// Channels mixed to a light, what stands before them with it.
fn of_channels(
    document: &Document,
    channels: &[(Source, f64)],
    gels: &[Gel],
) -> Result<NamedSpectrum, WhyNot> {
    for gel in gels {
        factor(document, &gel.key)?;
    }
    let before = light::gels_on_nm(gels, |key| entry_of(document, key));
    let lights = channels.iter().map(|(source, _)| {
        if let Source::Named(key) = source {
            lamp(document, key)?;
        }
        light::channel(source, |key| table_of(document, key), before.as_deref())
            .map_err(WhyNot::Mix)
    });
    let lights = lights.collect::<Result<Vec<_>, _>>()?;
    let powers: Vec<f64> = channels.iter().map(|(_, power)| *power).collect();
    light::spectrum(&lights, &powers, gels, &|key| document.name_of(key)).ok_or(WhyNot::Nothing)
}

/// A given colour under a light, with the names of both.
fn shown(document: &Document, given: &Given, light: &str) -> Result<Shown, WhyNot> {
    let lamp = lamp(document, light)?;
    let surface = given.surface().map(|key| found(document, key));
    let surface = surface.transpose()?;
    Ok(Shown {
        given: given.clone(),
        colour: match &surface {
            Some(surface) => surface.name().to_owned(),
            None => given.words(),
        },
        lamp: lamp.name().to_owned(),
        light: table_of(document, light).ok_or(WhyNot::Nothing)?,
        surface: surface.map(|entry| entry.spectrum.samples.clone()),
    })
}

/// What a chain leaves of a light, over the light's own range at every nm: it serves under another
/// range of the model too.
fn through(light: &Entry, chain: &[Link]) -> Option<NamedSpectrum> {
    let table = &light.spectrum.samples;
    let band = Band::new(table.first_nm().ceil(), table.last_nm().floor()).ok()?;
    let values = behind(chain, light.on_band(band), band);
    let met: Vec<String> = chain.iter().map(Link::met).collect();
    let keys: Vec<&str> = chain.iter().map(|link| link.entry.key.as_str()).collect();
    let names: Vec<&str> = chain.iter().map(|link| link.entry.name()).collect();
    Some(NamedSpectrum {
        name: format!("{} {}", light.name(), met.join(" ")),
        kind: Kind::Light,
        unit: light.spectrum.unit.clone(),
        scale: 1.0,
        samples: Sampled::even(band.min_nm(), 1.0, values).ok()?,
        notes: vec![format!(
            "Made: {} ({}) {} ({}), at every nm.",
            light.name(),
            light.key,
            met.join(" "),
            keys.join(", "),
        )],
        source: format!("made from {} and {}", light.name(), names.join(", ")),
    })
}

/// What a chain leaves of values on a band's grid.
pub(super) fn behind(chain: &[Link], mut values: Vec<f64>, band: Band) -> Vec<f64> {
    for link in chain {
        for (value, share) in values.iter_mut().zip(link.on_band(band)) {
            *value *= share;
        }
    }
    values
}

fn found(document: &Document, key: &str) -> Result<Arc<Entry>, WhyNot> {
    entry_of(document, key).ok_or_else(|| WhyNot::Missing(key.to_owned()))
}

fn factor(document: &Document, key: &str) -> Result<Arc<Entry>, WhyNot> {
    let entry = found(document, key)?;
    match entry.kind() {
        kind if kind.is_factor() => Ok(entry),
        kind => {
            let expected = later!("a reflectance or transmittance");
            Err(WhyNot::OtherKind(key.to_owned(), kind, expected))
        }
    }
}

fn lamp(document: &Document, key: &str) -> Result<Arc<Entry>, WhyNot> {
    let entry = found(document, key)?;
    match entry.kind() {
        Kind::Light => Ok(entry),
        kind => Err(WhyNot::OtherKind(key.to_owned(), kind, later!("a light"))),
    }
}

/// The light under a key as power a nm.
pub(super) fn table_of(document: &Document, key: &str) -> Option<Sampled> {
    let entry = lamp(document, key).ok()?;
    let mut spectrum = entry.spectrum.clone();
    if photons::counts_photons(&spectrum) {
        photons::to_power(&mut spectrum);
    }
    Some(spectrum.samples)
}

/// What a document holds under a key, its own or shipped; the paper's lamps as it weighs them.
pub(super) fn entry_of(document: &Document, key: &str) -> Option<Arc<Entry>> {
    let held = document.own.iter().chain([&document.light]);
    if let Some(entry) = held.into_iter().find(|entry| entry.key == key) {
        return Some(entry.clone());
    }
    let preset = Library::bundled().find_or_make(key).ok()?;
    Entry::of_preset_weighing(&preset, Some(document.weight_factor)).map(Arc::new)
}

fn image_of<'a>(document: &'a Document, key: &str) -> Option<&'a Arc<ImageEntry>> {
    let mut opened = document.images.iter();
    let made = || picture::at_hand().filter(|image| image.key == key);
    opened.find(|image| image.key == key).or_else(made)
}

/// What a recipe's result depends on, as a document has it: equal for two documents, the result is
/// the same. Spectra are compared by where they are in memory, shipped ones never change but for
/// the weights of the paper's lamps.
pub(super) fn signature(recipe: &Recipe, document: &Document) -> Vec<usize> {
    let held = |key: &str| {
        let own = document.own.iter().find(|entry| entry.key == key);
        let image = image_of(document, key);
        own.map(|entry| Arc::as_ptr(entry) as usize)
            .or(image.map(|image| Arc::as_ptr(&image.image) as usize))
            .unwrap_or_default()
    };
    let mut all: Vec<usize> = recipe.stands_on().into_iter().map(held).collect();
    all.push(document.weight_factor.to_bits() as usize);
    if let Recipe::Metamer { .. } = recipe {
        let settings = document.settings;
        let ends = [settings.band.min_nm(), settings.band.max_nm()];
        all.extend(ends.map(|nm| nm.to_bits() as usize));
        all.push(std::ptr::from_ref(settings.observer.table()) as usize);
    }
    all
}

/// Whether a recipe stands on an entry, directly or through what it is made of.
pub(super) fn stands_on(recipe: &Recipe, document: &Document, key: &str) -> bool {
    // Every entry is looked at once, so that a circle that a file brought in ends too.
    let mut seen: Vec<String> = Vec::new();
    let mut left: Vec<String> = recipe.stands_on().into_iter().map(str::to_owned).collect();
    while let Some(next) = left.pop() {
        if next == key {
            return true;
        }
        if seen.contains(&next) {
            continue;
        }
        let own = document.own.iter().find(|entry| entry.key == next);
        if let Some(recipe) = own.and_then(|entry| entry.origin.recipe()) {
            left.extend(recipe.stands_on().into_iter().map(str::to_owned));
        }
        seen.push(next);
    }
    false
}
