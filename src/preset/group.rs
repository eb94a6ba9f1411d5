//! The spectra of one preset file, each with its source and its terms.

use std::fmt;

use serde::Deserialize;

use super::shelf::Shelf;
use crate::spectrum::{Kind, NamedSpectrum};

/// The spectra of one file.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// Short name, as in `group/name`, which is also the file's name.
    pub id: String,
    /// One-line description of the group.
    pub title: String,
    /// Heading of most of its items; ask the item for its own.
    pub shelf: Shelf,
    /// Kind of most of its items; ask the item for its own.
    pub kind: Kind,
    /// Origin of the numbers.
    pub source: String,
    /// Terms of most of its items; ask the item for its own.
    pub licence: Terms,
    /// Whom to name, with title and DOI where the licence asks for them.
    pub attribution: String,
    /// Changes made to the source's numbers.
    pub changes: String,
    /// Notes on using the group; may be empty.
    pub note: String,
    /// Its items in the file's order.
    pub items: Vec<Preset>,
}

/// One shipped item.
#[derive(Clone, Debug, PartialEq)]
pub struct Preset {
    /// Its group's [`Group::id`].
    pub group: String,
    /// Its name, unique in the group.
    pub name: String,
    /// Kind of quantity that its values represent.
    pub kind: Kind,
    /// Under which heading it is listed.
    pub shelf: Shelf,
    /// Unit of its values.
    pub unit: String,
    /// Origin of its numbers.
    pub source: String,
    /// Its terms.
    pub licence: Terms,
    /// Notes on it, a sentence or two each.
    pub notes: Vec<String>,
    /// Thickness for which a transmittance holds, mm.
    pub thickness_mm: Option<f64>,
    /// Refractive index n and extinction coefficient k at the table's wavelengths (metals).
    pub optical: Option<OpticalConstants>,
    /// The numbers.
    pub body: Body,
}

impl Preset {
    /// The name that is never ambiguous: `group/name`.
    pub fn id(&self) -> String {
        format!("{}/{}", self.group, self.name)
    }

    /// The table, if it is one.
    pub fn spectrum(&self) -> Option<&NamedSpectrum> {
        match &self.body {
            Body::Spectrum(spectrum) => Some(spectrum),
            Body::Composite(_) | Body::Lines(_) => None,
        }
    }

    /// The composite, if it is one.
    pub fn composite(&self) -> Option<&Composite> {
        match &self.body {
            Body::Composite(composite) => Some(composite),
            Body::Spectrum(_) | Body::Lines(_) => None,
        }
    }

    /// The list of lines, if it is one.
    pub fn line_list(&self) -> Option<&LineList> {
        match &self.body {
            Body::Lines(list) => Some(list),
            Body::Spectrum(_) | Body::Composite(_) => None,
        }
    }
}

/// Contents of an item.
#[derive(Clone, Debug, PartialEq)]
pub enum Body {
    /// A table.
    Spectrum(NamedSpectrum),
    /// A smooth part and spikes, as printed in the paper.
    Composite(Composite),
    /// Spectral lines, which are not a spectrum.
    Lines(LineList),
}

/// Under which terms numbers may be passed on.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Terms {
    /// SPDX expression; `LicenseRef-facts` for bare numbers that nobody owns.
    pub id: String,
    /// The same in plain words.
    pub words: String,
}

impl fmt::Display for Terms {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({})", self.id, self.words)
    }
}

/// Complex refractive index n + ik, one value a wavelength of the item's table.
#[derive(Clone, Debug, PartialEq)]
pub struct OpticalConstants {
    /// Refractive index.
    pub n: Vec<f64>,
    /// Extinction coefficient.
    pub k: Vec<f64>,
}

/// A smooth part and spikes, as printed in the paper.
///
/// The basis is Fourier's: `a0/2 + sum a_n cos(2 pi n x/L) + b_n sin(2 pi n x/L)`, x = nm above the
/// range's start, L its length.
#[derive(Clone, Debug, PartialEq)]
pub struct Composite {
    /// First and last wavelength of the model, nm.
    pub range_nm: [f64; 2],
    /// `a0` (to be halved) to `aN`.
    pub a: Vec<f64>,
    /// `b1` to `bN`.
    pub b: Vec<f64>,
    /// Spikes with the weights as printed.
    pub spikes: Vec<PrintedSpike>,
    /// Factor that takes a printed weight to unit x nm (the paper does not state it).
    pub weight_factor: f64,
}

impl Composite {
    /// Places (nm) and weights in unit x nm, the factor applied.
    pub(crate) fn spikes_in_unit_nm(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        self.spikes
            .iter()
            .map(|spike| (spike.at_nm, spike.weight * self.weight_factor))
    }
}

/// A spike with its weight as printed.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PrintedSpike {
    /// Place, nm.
    pub at_nm: f64,
    /// Weight as printed; times [`Composite::weight_factor`] it is in unit x nm.
    pub weight: f64,
}

/// Spectral lines of one element, or named absorption lines.
#[derive(Clone, Debug, PartialEq)]
pub struct LineList {
    /// Name of the list.
    pub name: String,
    /// Symbol of the element, if all lines are of one.
    pub element: Option<String>,
    /// Unit of the strengths.
    pub unit: String,
    /// Weakest strength kept, if the list was cut.
    pub threshold: Option<f64>,
    /// The lines in the file's order, which need not rise.
    pub lines: Vec<AtomicLine>,
}

/// One spectral line.
#[derive(Clone, Debug, PartialEq)]
pub struct AtomicLine {
    /// Place in air, nm.
    pub at_nm: f64,
    /// Place in vacuum, nm, where the source gives it.
    pub vacuum_nm: Option<f64>,
    /// Strength on the list's own scale, never radiometric; none where unknown.
    pub strength: Option<f64>,
    /// Its name, such as "D2 Na".
    pub label: Option<String>,
}
