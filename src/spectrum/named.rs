//! A spectrum with what a person needs to know about it.

use super::{kind::Kind, sampled::Sampled};

/// A measured spectrum with its name, meaning and provenance.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedSpectrum {
    /// Name shown in lists and plots.
    pub name: String,
    /// Kind of quantity that its values represent.
    pub kind: Kind,
    /// Unit of the values as the source states it ("W m-2 nm-1", "relative", "fraction"); empty
    /// when the source is silent.
    pub unit: String,
    /// Factor that takes the file's numbers to `unit` (0.01 for percent); already applied to
    /// `samples`, kept so that the file's own numbers can be told.
    pub scale: f64,
    /// The table, `scale` applied.
    pub samples: Sampled,
    /// Notes on how it was read and on any oddities, a sentence each.
    pub notes: Vec<String>,
    /// Origin of the numbers (file, publication); empty when unknown.
    pub source: String,
}
