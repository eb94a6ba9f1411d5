//! Writing IES TM-27 `.spdx`.

use std::fmt::Write;

use crate::io::provenance::{Provenance, shortest};
use crate::languages::said;
use crate::spectrum::{Kind, NamedSpectrum};

/// The spectral quantities of TM-27 with kind and unit.
pub(crate) const QUANTITIES: [(&str, Kind, &str); 14] = [
    ("flux", Kind::Light, "W nm-1"),
    ("absorptance", Kind::Other, "fraction"),
    ("transmittance", Kind::Transmittance, "fraction"),
    ("reflectance", Kind::Reflectance, "fraction"),
    ("intensity", Kind::Light, "W sr-1 nm-1"),
    ("irradiance", Kind::Light, "W m-2 nm-1"),
    ("radiance", Kind::Light, "W m-2 sr-1 nm-1"),
    ("exitance", Kind::Light, "W m-2 nm-1"),
    ("r-values", Kind::Reflectance, "fraction"),
    ("t-values", Kind::Transmittance, "fraction"),
    ("r-factor", Kind::Reflectance, "fraction"),
    ("t-factor", Kind::Transmittance, "fraction"),
    ("relative", Kind::Light, "relative"),
    ("other", Kind::Other, ""),
];

/// The TM-27 word for a spectrum.
fn quantity_of(spectrum: &NamedSpectrum) -> &'static str {
    match spectrum.kind {
        Kind::Reflectance => "reflectance",
        Kind::Transmittance => "transmittance",
        Kind::Light => QUANTITIES
            .iter()
            .find(|(_, kind, unit)| *kind == Kind::Light && *unit == spectrum.unit)
            .map_or("relative", |(word, ..)| word),
        Kind::Absorbance | Kind::Weighting | Kind::Lines | Kind::Other => "other",
    }
}

/// The properties without a word in the format, a sentence each; they go into the comments.
pub(crate) fn losses(spectrum: &NamedSpectrum) -> Vec<String> {
    let NamedSpectrum { kind, unit, .. } = spectrum;
    match quantity_of(spectrum) {
        "other" => vec![tr!(
            "TM-27 has no word for {kind} values: written as other.",
            kind = said(kind.word())
        )],
        "relative" if !unit.is_empty() && unit != "relative" => vec![tr!(
            "TM-27 has no word for the unit {unit}: written as relative, the unit in the comments.",
            unit
        )],
        _ => Vec::new(),
    }
}

/// A spectrum as TM-27 XML.
pub(crate) fn write(spectrum: &NamedSpectrum, provenance: &Provenance) -> String {
    let about = provenance.of(spectrum);
    // Notes may hold the separators of the others, so they come last.
    let (last, first): (Vec<_>, Vec<_>) = about.iter().partition(|(key, _)| *key == "notes");
    let comments = first
        .into_iter()
        .filter(|(key, _)| !matches!(*key, "name" | "source"))
        .chain(last)
        .map(|(key, value)| format!("{key}: {value}"))
        .collect::<Vec<_>>()
        .join("; ");
    let mut out = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    out.push_str("<IESTM2714 xmlns=\"iestm2714\" version=\"1.0\">\n  <Header>\n");
    for (element, value) in [
        ("Manufacturer", provenance.source_of(spectrum)),
        ("Description", &spectrum.name),
        ("DocumentCreator", &provenance.program),
        ("Comments", &comments),
    ] {
        let _ = writeln!(out, "    <{element}>{}</{element}>", escaped(value));
    }
    let _ = writeln!(
        out,
        "  </Header>\n  <SpectralDistribution>\n    <SpectralQuantity>{}</SpectralQuantity>",
        quantity_of(spectrum)
    );
    for (nm, value) in spectrum.samples.nm().iter().zip(spectrum.samples.values()) {
        let (nm, value) = (shortest(*nm), shortest(*value));
        let _ = writeln!(
            out,
            "    <SpectralData wavelength=\"{nm}\">{value}</SpectralData>"
        );
    }
    out.push_str("  </SpectralDistribution>\n</IESTM2714>\n");
    out
}

/// Text for XML: markup escaped, characters that XML forbids left out.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => out.push(' '),
            c => out.push(c),
        }
    }
    out
}
