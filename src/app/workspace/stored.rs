//! What is written: the document by names, the user's own spectra with all their numbers, and the
//! window's preferences.

use std::{collections::BTreeMap, path::PathBuf, sync::Arc};

use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error};

use super::{FORMAT, Preferences, VERSION, name_of};
use crate::{
    app::{
        document::{Document, PAPER_WEIGHT_FACTOR, Subject, View},
        entry::{Entry, bundled_entries},
        measured::measured_of,
        memo::ByAddress,
        opened::ImageEntry,
        origin::{FileReading, MadeBy, Origin, SourceFile},
        pages::PageStates,
        products::{Link, Products},
        recipe::Times,
        scale::Scale,
        settings::Settings,
        stored_doubt::StoredDoubt,
        stored_path,
    },
    io::{Choices, MakersResult},
    spectrum::{
        Band, Basis, Composite, Formula, Kind, Line, NamedSpectrum, Sampled, Series, SpikeEdits,
    },
};

/// A spectrum of the user's own with all its numbers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct OwnSpectrum {
    key: String,
    pub name: String,
    kind: Kind,
    unit: String,
    scale: f64,
    pub nm: Vec<f64>,
    pub values: Vec<f64>,
    notes: Vec<String>,
    source: String,
    #[serde(default)]
    makers: Vec<MakersResult>,
    /// How it is made; the numbers are those of the last time.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    made: Option<MadeBy>,
    /// The composite that it is, which the numbers are the table of.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    composite: Option<StoredComposite>,
    /// What is known of it beside its values.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    doubt: Option<StoredDoubt>,
    /// The formula of a refractive index, which the numbers are the table of.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    formula: Option<Formula>,
}

/// An entry on its way to another instance of the program: a shipped one by its key.
#[derive(Serialize, Deserialize)]
enum Carried {
    Shipped(String),
    Own(Box<OwnSpectrum>),
}

impl Serialize for ByAddress<Entry> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut shipped = bundled_entries().iter();
        match shipped.any(|entry| Arc::ptr_eq(entry, &self.0)) {
            true => Carried::Shipped(self.0.key.clone()),
            false => Carried::Own(Box::new(OwnSpectrum::of(&self.0))),
        }
        .serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for ByAddress<Entry> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        match Carried::deserialize(deserializer)? {
            Carried::Own(own) => own.into_entry().map(|entry| Self(Arc::new(entry))),
            Carried::Shipped(key) => bundled_entries()
                .iter()
                .find(|entry| entry.key == key)
                .map(|entry| Self(entry.clone()))
                .ok_or_else(|| format!("found {key}, expected a shipped spectrum")),
        }
        .map_err(D::Error::custom)
    }
}

/// A composite: the series' functions, range and coefficients, place and weight of its spikes, and
/// their widths, nm, where any has one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct StoredComposite {
    basis: Basis,
    band: Band,
    coefficients: Vec<f64>,
    spikes: Vec<[f64; 2]>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    widths_nm: Vec<f64>,
}

impl StoredComposite {
    fn of(composite: &Composite) -> Self {
        let (smooth, lines) = (composite.smooth(), composite.lines());
        let widths_nm = || lines.iter().map(|line| line.fwhm_nm).collect();
        Self {
            basis: smooth.basis,
            band: smooth.band,
            coefficients: smooth.coefficients.clone(),
            spikes: lines.iter().map(|line| [line.at_nm, line.weight]).collect(),
            widths_nm: match composite.has_widths() {
                true => widths_nm(),
                false => Vec::new(),
            },
        }
    }

    /// `None` where its numbers are no composite.
    fn found(self) -> Option<Composite> {
        let numbers = self.coefficients.len();
        let widths = &self.widths_nm;
        let sound = numbers % 2 == 1
            && numbers <= self.band.points()
            && (widths.is_empty() || widths.len() == self.spikes.len())
            && widths.iter().all(|width| *width >= 0.0);
        let all = self.spikes.iter().flatten().chain(&self.coefficients);
        let is_finite = all.chain(widths).all(|v| v.is_finite());
        if !(sound && is_finite) {
            return None;
        }
        let widths = self.widths_nm.into_iter().chain(std::iter::repeat(0.0));
        let lines = self.spikes.into_iter().zip(widths);
        let lines = lines.map(|([at_nm, weight], fwhm_nm)| Line {
            at_nm,
            weight,
            fwhm_nm,
        });
        let smooth = Series {
            band: self.band,
            basis: self.basis,
            coefficients: self.coefficients,
        };
        Some(Composite::of_lines_inside(smooth, lines.collect()))
    }
}

/// An image by the file that it is read from again.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StoredImage {
    pub key: String,
    /// The file.
    #[serde(with = "stored_path")]
    pub path: PathBuf,
    /// Which of the file's images, from 0.
    pub index: usize,
    /// What a person decided about the file.
    #[serde(default)]
    pub choices: Choices,
}

impl StoredImage {
    /// `None` for an image that came without a path.
    fn of(image: &ImageEntry) -> Option<Self> {
        Some(Self {
            key: image.key.clone(),
            path: image.path()?.to_owned(),
            index: image.from.index,
            choices: image.from.reading.choices.clone(),
        })
    }

    /// The reading that brings it back.
    pub fn reading(&self) -> Arc<FileReading> {
        Arc::new(FileReading {
            file: Arc::new(SourceFile {
                path: Some(self.path.clone()),
                name: name_of(&self.path),
                images_only: true,
                ..SourceFile::default()
            }),
            choices: self.choices.clone(),
            spectra: 0,
        })
    }
}

/// What is written: the document by names, and the window's preferences.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Stored {
    format: String,
    version: u32,
    program: String,
    pub light: String,
    #[serde(default)]
    pub second: Option<String>,
    #[serde(default)]
    pub factor: Option<String>,
    #[serde(default)]
    pub subject: Subject,
    #[serde(default)]
    pub overlays: Vec<String>,
    #[serde(default)]
    own: Vec<OwnSpectrum>,
    #[serde(default)]
    pub images: Vec<StoredImage>,
    #[serde(default)]
    pub next_own: u64,
    #[serde(default)]
    pub settings: Settings,
    #[serde(default)]
    pub given: Option<Settings>,
    #[serde(default)]
    pub edits: BTreeMap<String, SpikeEdits>,
    pub patch_set: String,
    #[serde(default)]
    pub own_patches: Vec<String>,
    #[serde(default)]
    pub patch: Option<usize>,
    #[serde(default)]
    pub scale: Scale,
    #[serde(default = "paper_weight_factor")]
    pub weight_factor: f64,
    #[serde(default)]
    pub view: View,
    #[serde(default)]
    pub products: Option<StoredProducts>,
    #[serde(default)]
    pub pages: PageStates,
    #[serde(default)]
    pub preferences: Option<Preferences>,
}

/// What the page `Products` multiplies, by names.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct StoredProducts {
    pub chain: Vec<(String, Times)>,
    surface: Option<String>,
    outgoing: Option<String>,
}

impl Stored {
    /// A document and the window's preferences, `waiting` beside the images that are there.
    pub(super) fn of(
        document: &Document,
        preferences: Option<&Preferences>,
        waiting: &[StoredImage],
    ) -> Self {
        let Document {
            light,
            second,
            factor,
            subject,
            overlays,
            own,
            images,
            next_own,
            settings,
            given,
            edits,
            patch_set,
            own_patches,
            patch,
            scale,
            weight_factor,
            view,
            products,
            pages,
        } = document;
        Self {
            format: FORMAT.to_owned(),
            version: VERSION,
            program: env!("CARGO_PKG_VERSION").to_owned(),
            light: light.key.clone(),
            second: second.as_ref().map(|second| second.key.clone()),
            factor: factor.as_ref().map(|f| f.key.clone()),
            subject: *subject,
            overlays: overlays.iter().map(|o| o.key.clone()).collect(),
            own: own.iter().map(|entry| OwnSpectrum::of(entry)).collect(),
            images: images
                .iter()
                .filter_map(|image| StoredImage::of(image))
                .chain(waiting.iter().cloned())
                .collect(),
            next_own: *next_own,
            settings: *settings,
            given: *given,
            edits: edits.clone(),
            patch_set: patch_set.clone(),
            own_patches: own_patches.clone(),
            patch: *patch,
            scale: *scale,
            weight_factor: *weight_factor,
            view: *view,
            products: Some(StoredProducts::of(products)),
            pages: pages.clone(),
            // A window that is folded away has no size, and so on: what is written can be read.
            preferences: preferences.cloned().map(Preferences::clamped),
        }
    }
}

impl StoredProducts {
    /// The keys of what it holds.
    pub(super) fn of(products: &Products) -> Self {
        let Products {
            chain,
            surface,
            outgoing,
        } = products;
        let key = |entry: &Option<Arc<Entry>>| entry.as_ref().map(|e| e.key.clone());
        let link = |link: &Link| (link.entry.key.clone(), link.times());
        Self {
            chain: chain.iter().map(link).collect(),
            surface: key(surface),
            outgoing: key(outgoing),
        }
    }

    /// What it holds, as far as it is found.
    pub(super) fn found(self, mut find: impl FnMut(&str) -> Option<Arc<Entry>>) -> Products {
        let links = self
            .chain
            .into_iter()
            .filter_map(|(key, times)| Some(Link::new(find(&key)?, times)));
        Products {
            chain: links.collect(),
            surface: self.surface.as_deref().and_then(&mut find),
            outgoing: self.outgoing.as_deref().and_then(&mut find),
        }
    }
}

fn paper_weight_factor() -> f64 {
    PAPER_WEIGHT_FACTOR
}

impl OwnSpectrum {
    /// What stands where a file tells nothing else.
    pub(super) fn unnamed(name: &str) -> Self {
        Self {
            key: String::new(),
            name: name.to_owned(),
            kind: Kind::Other,
            unit: String::new(),
            scale: 1.0,
            nm: Vec::new(),
            values: Vec::new(),
            notes: Vec::new(),
            source: String::new(),
            makers: Vec::new(),
            made: None,
            composite: None,
            doubt: None,
            formula: None,
        }
    }

    fn of(entry: &Entry) -> Self {
        let NamedSpectrum {
            name,
            kind,
            unit,
            scale,
            samples,
            notes,
            source,
        } = &entry.spectrum;
        let makers = entry.makers.clone();
        Self {
            key: entry.key.clone(),
            name: name.clone(),
            kind: *kind,
            unit: unit.clone(),
            scale: *scale,
            nm: samples.nm().to_vec(),
            values: samples.values().to_vec(),
            notes: notes.clone(),
            source: source.clone(),
            makers,
            composite: entry.composite.as_deref().map(StoredComposite::of),
            doubt: entry.measured.as_deref().map(StoredDoubt::of),
            made: entry.origin.made().cloned(),
            formula: samples.formula().cloned(),
        }
    }

    /// The spectrum as the document holds it.
    ///
    /// # Errors
    /// Why its numbers are no spectrum.
    pub(super) fn into_entry(self) -> Result<Entry, String> {
        let mut samples = Sampled::new(self.nm, self.values).map_err(|e| e.to_string())?;
        if let Some(formula) = self.formula {
            samples = samples.of_formula(formula);
        }
        let spectrum = NamedSpectrum {
            name: self.name,
            kind: self.kind,
            unit: self.unit,
            scale: self.scale,
            samples,
            notes: self.notes,
            source: self.source,
        };
        let doubt = self.doubt.and_then(|doubt| measured_of(&spectrum, doubt));
        Ok(Entry {
            key: self.key,
            origin: self.made.map_or(Origin::Numbers, Origin::Made),
            spectrum,
            measured: doubt.map(Arc::new),
            licence: String::new(),
            makers: self.makers,
            composite: self
                .composite
                .and_then(StoredComposite::found)
                .map(Arc::new),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_composite_is_found_again_with_the_widths_of_its_lines() {
        let smooth = Series {
            band: Band::VISIBLE,
            basis: Basis::Cosine,
            coefficients: vec![1.0, 0.5, -0.25],
        };
        for fwhm_nm in [0.0, 7.5] {
            let wide = Line {
                at_nm: 611.0,
                weight: 2.0,
                fwhm_nm,
            };
            let lines = vec![Line::ideal(435.8, 3.0), wide];
            let composite = Composite::of_lines_inside(smooth.clone(), lines);
            let stored = serde_json::to_string(&StoredComposite::of(&composite)).expect("JSON");
            assert_eq!(stored.contains("widths_nm"), fwhm_nm > 0.0);
            let read: StoredComposite = serde_json::from_str(&stored).expect("its own");
            assert_eq!(read.clone().found(), Some(composite));
            // Widths of other lines are no composite's.
            let widths_nm = vec![1.0];
            assert_eq!(StoredComposite { widths_nm, ..read }.found(), None);
        }
    }
}
