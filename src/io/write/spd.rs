//! Writing pbrt and Mitsuba `.spd`.

use std::fmt::Write;

use crate::io::provenance::{Provenance, shortest};
use crate::spectrum::NamedSpectrum;

/// A spectrum as `.spd` text, with name, kind, unit and provenance in comments.
pub(crate) fn write(spectrum: &NamedSpectrum, provenance: &Provenance) -> String {
    let mut out = provenance.comments(spectrum);
    for (nm, value) in spectrum.samples.nm().iter().zip(spectrum.samples.values()) {
        let _ = writeln!(out, "{} {}", shortest(*nm), shortest(*value));
    }
    out
}
