//! IES TM-27-14 `.spdx`: XML with a header, a spectral quantity and irregular samples.
//!
//! Elements are matched by their local names, since files use two namespaces or none. Numeric
//! header fields may say "Unknown". Entities and document type declarations are refused by the
//! XML parser, so a small file cannot unfold into a large one.

use std::fmt::Write;

use roxmltree::{Document, Node};

use crate::spectrum::{Kind, NamedSpectrum};

use super::curve;
use super::error::quoted;
use super::meaning;
use super::number;
use super::reading::provenance as provenance_line;
use super::write::{Provenance, shortest};
use super::{Confidence, Format, Guess, Guessed, Input, ReadError, Reading};

/// IES TM-27.
pub const FORMAT: Format = Format {
    name: "IES TM-27 .spdx",
    extensions: &["spdx"],
    sniff,
    read,
};

/// The twelve spectral quantities of TM-27 with kind and unit.
const QUANTITIES: [(&str, Kind, &str); 12] = [
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
    ("relative", Kind::Light, "relative"),
    ("other", Kind::Other, ""),
];

fn sniff(input: &Input) -> Confidence {
    let head = input.head();
    if head.contains("IESTM2714") || head.contains("iestm2714") {
        Confidence::Certain
    } else if head.starts_with("<?xml") || input.has_extension("spdx") {
        Confidence::Likely
    } else {
        Confidence::No
    }
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    if !text.trim_start().starts_with('<') {
        return Err(input
            .error("text that is no XML", "an IES TM-27 .spdx file, which is XML")
            .at_line(1));
    }
    let text = without_declaration(text);
    let document = Document::parse(&text).map_err(|error| {
        input
            .error(format!("broken XML ({error})"), "well-formed XML")
            .at_line(error.pos().row as usize)
    })?;
    let root = document.root_element();
    if !root.tag_name().name().eq_ignore_ascii_case("IESTM2714") {
        return Err(input
            .error(
                format!("<{}> as the outermost element", quoted(root.tag_name().name()).replace('"', "")),
                "<IESTM2714>",
            )
            .at_line(line(root)));
    }
    read_root(input, root)
}

/// Blanks the XML declaration: some writers put a version there that XML does not know.
fn without_declaration(text: &str) -> String {
    let mut text = text.to_owned();
    let start = text.len() - text.trim_start().len();
    if text[start..].starts_with("<?xml")
        && let Some(end) = text[start..].find("?>")
    {
        let blank: String = text[start..start + end + 2]
            .chars()
            .map(|c| if c == '\n' { '\n' } else { ' ' })
            .collect();
        text.replace_range(start..start + end + 2, &blank);
    }
    text
}

fn line(node: Node) -> usize {
    node.document().text_pos_at(node.range().start).row as usize
}

fn child<'a>(node: Node<'a, 'a>, name: &str) -> Option<Node<'a, 'a>> {
    node.children()
        .find(|n| n.is_element() && n.tag_name().name().eq_ignore_ascii_case(name))
}

/// A header field, unless it is empty or says that it is unknown.
fn field<'a>(header: Option<Node<'a, 'a>>, name: &str) -> Option<&'a str> {
    let text = child(header?, name)?.text()?.trim();
    (!text.is_empty() && !text.eq_ignore_ascii_case("unknown")).then_some(text)
}

fn read_root<'a>(input: &Input, root: Node<'a, 'a>) -> Result<Reading, ReadError> {
    let header = child(root, "Header");
    let name = field(header, "Description")
        .or_else(|| field(header, "CatalogNumber"))
        .unwrap_or(input.stem());
    let maker = ["Manufacturer", "Laboratory", "ReportNumber", "ReportDate"]
        .iter()
        .filter_map(|f| field(header, f))
        .collect::<Vec<_>>()
        .join(", ");
    let mut reading = Reading::default();
    let distributions = || {
        root.children().filter(|n| {
            n.is_element() && n.tag_name().name().eq_ignore_ascii_case("SpectralDistribution")
        })
    };
    for distribution in distributions() {
        let mut spectrum = read_distribution(input, distribution, &mut reading)?;
        name.clone_into(&mut spectrum.name);
        spectrum.source = if maker.is_empty() { input.name.clone() } else { maker.clone() };
        if let Some(comments) = field(header, "Comments") {
            spectrum.notes.push(format!("comment in the file: {comments}"));
        }
        if reading.spectra.is_empty() {
            reading.notes.insert(0, spectrum.notes[0].clone());
        }
        reading.spectra.push(spectrum);
    }
    if reading.spectra.is_empty() {
        return Err(input
            .error("no <SpectralDistribution>", "one with <SpectralData> elements")
            .at_line(line(root)));
    }
    Ok(reading)
}

fn read_distribution<'a>(
    input: &Input,
    node: Node<'a, 'a>,
    reading: &mut Reading,
) -> Result<NamedSpectrum, ReadError> {
    let (mut nm, mut values, mut at) = (vec![], vec![], vec![]);
    for data in node
        .children()
        .filter(|n| n.is_element() && n.tag_name().name().eq_ignore_ascii_case("SpectralData"))
    {
        let at_line = line(data);
        let number = |text: &str, expected: &str| {
            number::number(text.trim(), false)
                .filter(|v| v.is_finite())
                .ok_or_else(|| input.error(quoted(text), expected).at_line(at_line))
        };
        let wavelength = data.attribute("wavelength").ok_or_else(|| {
            input
                .error("<SpectralData> with no wavelength", "wavelength=\"nm\"")
                .at_line(at_line)
        })?;
        nm.push(number(wavelength, "a wavelength in nm")?);
        values.push(number(data.text().unwrap_or(""), "a number as spectral value")?);
        at.push(at_line);
    }
    let cleaned = curve::clean(&nm, &values).map_err(|trouble| {
        let at_line = trouble.index().and_then(|i| at.get(i)).copied();
        input
            .error(trouble.to_string(), trouble.expected())
            .at_line(at_line.unwrap_or_else(|| line(node)))
    })?;
    let mut notes = cleaned.notes;
    let stated = field(Some(node), "SpectralQuantity").unwrap_or("");
    let index = reading.spectra.len();
    let (kind, unit) = quantity(stated, index, &mut notes, reading);
    if let Some(width) = field(Some(node), "BandwidthFWHM") {
        notes.push(format!("bandwidth {width} nm (FWHM)"));
    }
    let mut scale = 1.0;
    let mut samples = cleaned.samples;
    if kind.is_factor() {
        let percent = meaning::percent("", &[], false, samples.values());
        if percent.percent {
            scale = 0.01;
            samples = samples.scaled(scale);
            notes.push(format!("taken as percent: {}", percent.because));
            reading.guesses.push(Guess {
                spectrum: index,
                what: Guessed::Percent,
                chosen: "percent".to_owned(),
                because: percent.because,
            });
        }
    }
    let mut spectrum = NamedSpectrum {
        name: String::new(),
        kind,
        unit,
        scale,
        samples,
        notes: Vec::new(),
        source: String::new(),
    };
    spectrum.notes.push(provenance_line(&spectrum, &[]));
    spectrum.notes.extend(notes);
    Ok(spectrum)
}

/// Kind and unit of a spectral quantity; writers put units there too ("W/nm").
fn quantity(
    stated: &str,
    index: usize,
    notes: &mut Vec<String>,
    reading: &mut Reading,
) -> (Kind, String) {
    let known = QUANTITIES
        .iter()
        .find(|(word, ..)| word.eq_ignore_ascii_case(stated));
    if let Some((_, kind, unit)) = known {
        return (*kind, (*unit).to_owned());
    }
    let kind = meaning::kind_of_words(stated).unwrap_or(Kind::Light);
    let because = format!("the spectral quantity {} is none of TM-27's", quoted(stated));
    notes.push(format!("taken as {}: {because}", kind.word()));
    reading.guesses.push(Guess {
        spectrum: index,
        what: Guessed::Kind,
        chosen: kind.word().to_owned(),
        because,
    });
    (kind, stated.to_owned())
}

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

/// A spectrum as TM-27 XML.
pub fn write(spectrum: &NamedSpectrum, provenance: &Provenance) -> String {
    let comments = provenance
        .of(spectrum)
        .iter()
        .filter(|(key, _)| !matches!(*key, "name" | "source"))
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
        let _ = writeln!(
            out,
            "    <SpectralData wavelength=\"{}\">{}</SpectralData>",
            shortest(*nm),
            shortest(*value)
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
