//! Writing the program's own spectrum as JSON, to the bit; its reader takes it back.

use serde::{Deserialize, Serialize};

use crate::io::provenance::Provenance;
use crate::spectrum::{Kind, NamedSpectrum};

/// The word in `format`.
pub(crate) const FORMAT_WORD: &str = "spectral-explorer-spectrum";

/// The version written and read.
pub(crate) const VERSION: u32 = 1;

/// A spectrum as stored in the file.
#[derive(Serialize, Deserialize)]
pub(crate) struct SpectrumFile {
    /// [`FORMAT_WORD`].
    pub format: String,
    /// [`VERSION`].
    pub version: u32,
    /// The name of the spectrum.
    #[serde(default)]
    pub name: String,
    /// The kind of its values.
    pub kind: Kind,
    /// The unit of its values.
    #[serde(default)]
    pub unit: String,
    /// Wavelengths in nm.
    pub wavelengths_nm: Vec<f64>,
    /// A value for each.
    pub values: Vec<f64>,
    /// The source of the values.
    #[serde(default)]
    pub source: String,
    /// Notes on the spectrum.
    #[serde(default)]
    pub notes: Vec<String>,
    /// The scale that was in force, for human readers.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub scale_in_force: String,
    /// The settings of the program, for human readers.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub settings: String,
    /// The program that wrote it, for human readers.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub written_by: String,
}

pub(crate) fn write(spectrum: &NamedSpectrum, provenance: &Provenance) -> String {
    let file = SpectrumFile {
        format: FORMAT_WORD.to_owned(),
        version: VERSION,
        name: spectrum.name.clone(),
        kind: spectrum.kind,
        unit: spectrum.unit.clone(),
        wavelengths_nm: spectrum.samples.nm().to_vec(),
        values: spectrum.samples.values().to_vec(),
        source: provenance.source_of(spectrum).to_owned(),
        notes: spectrum.notes.clone(),
        scale_in_force: provenance.scale_words.clone(),
        settings: provenance.settings.clone(),
        written_by: provenance.program.clone(),
    };
    // Numbers, words and lists only: there is nothing in it that JSON cannot hold.
    serde_json::to_string(&file).unwrap_or_default() + "\n"
}
