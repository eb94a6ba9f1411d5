//! IES TM-27-14 `.spdx`: XML with a header, a spectral quantity and irregular samples.
//!
//! Elements are matched by their local names, since files use two namespaces or none. Numeric
//! header fields may be "Unknown". Entities and document type declarations are refused by the
//! XML parser, so a small file cannot unfold into a large one.

use roxmltree::Node;

use super::{Confidence, Format, add_element};
use crate::io::decode::xml::{self, children, line};
use crate::io::error::kept;
use crate::io::interpret::{RawSpectrum, kinds};
use crate::io::provenance::{ORIGINATOR, notes_of_a_line};
use crate::io::reading::remark::Remark;
use crate::io::text::kept_line;
use crate::io::write::spdx::QUANTITIES;
use crate::io::{Decision, Input, ReadError, Reading, quoted};
use crate::spectrum::Kind;

/// Precedes the notes in the comments of a file of this program.
const NOTES_AT: &str = "; notes: ";

pub(crate) const FORMAT: Format = Format::new("IES TM-27 .spdx", &["spdx"], sniff, read);

fn sniff(input: &Input) -> Confidence {
    let head = input.head();
    let is_xml = head.trim_start().starts_with('<');
    if is_xml && (head.contains("IESTM2714") || head.contains("iestm2714")) {
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
        let expected = said!("an IES TM-27 .spdx file, which is XML");
        return Err(input.error_at(1, said!("text that is no XML"), expected));
    }
    let text = without_declaration(text);
    let document = xml::parse(input, &text)?;
    let root = document.root_element();
    let name = root.tag_name().name();
    if !name.eq_ignore_ascii_case("IESTM2714") {
        let name = quoted(name).replace('"', "");
        let found = tr!("<{name}> as the outermost element", name);
        return Err(input.error_at(line(root), found, "<IESTM2714>"));
    }
    read_root(input, root)
}

/// Blanks the XML declaration: some writers put a version there that XML does not know.
fn without_declaration(text: &str) -> String {
    let end = match text.trim_start().starts_with("<?xml") {
        true => text.find("?>").map_or(0, |end| end + 2),
        false => 0,
    };
    let (declaration, rest) = text.split_at(end);
    let blank = |c| if c == '\n' { '\n' } else { ' ' };
    declaration.chars().map(blank).collect::<String>() + rest
}

/// A header field, unless it is empty or marked as unknown.
fn field<'a>(header: Option<Node<'a, 'a>>, name: &str) -> Option<&'a str> {
    let text = children(header?, name).next()?.text()?.trim();
    (!text.is_empty() && !text.eq_ignore_ascii_case("unknown")).then(|| kept(text))
}

fn read_root<'a>(input: &Input, root: Node<'a, 'a>) -> Result<Reading, ReadError> {
    let header = children(root, "Header").next();
    let name = field(header, "Description")
        .or_else(|| field(header, "CatalogNumber"))
        .unwrap_or(input.stem());
    let maker = ["Manufacturer", "Laboratory", "ReportNumber", "ReportDate"]
        .iter()
        .filter_map(|f| field(header, f))
        .collect::<Vec<_>>()
        .join(", ");
    let is_own =
        field(header, "DocumentCreator").is_some_and(|program| program.starts_with(ORIGINATOR));
    let mut reading = Reading::default();
    let source = match maker.is_empty() {
        true => input.name.clone(),
        false => maker,
    };
    for distribution in children(root, "SpectralDistribution") {
        let width = read_distribution(input, distribution, (name, &source), &mut reading)?;
        let (Some(spectrum), Some(facts)) = (reading.spectra.last_mut(), reading.facts.last_mut())
        else {
            continue;
        };
        spectrum.notes.extend(width);
        let Some(comments) = field(header, "Comments") else {
            continue;
        };
        if is_own {
            let notes = comments.split_once(NOTES_AT);
            let notes = notes_of_a_line(notes.map_or("", |(_, notes)| notes));
            let notes = notes.map(|note| Remark::Before(note.to_owned()));
            facts.remarks.extend(notes);
        } else {
            let note = tr!("comment in the file: {comment}", comment = comments);
            spectrum.notes.push(note);
        }
    }
    if reading.spectra.is_empty() {
        let expected = said!("one with <SpectralData> elements");
        return Err(input.error_at(line(root), said!("no <SpectralDistribution>"), expected));
    }
    Ok(reading)
}

/// Adds the spectrum of an element; returns a note on its bandwidth.
fn read_distribution<'a>(
    input: &Input,
    node: Node<'a, 'a>,
    (name, source): (&str, &str),
    reading: &mut Reading,
) -> Result<Option<String>, ReadError> {
    let (mut nm, mut values, mut at) = (vec![], vec![], vec![]);
    for data in children(node, "SpectralData") {
        let wavelength = data.attribute("wavelength").ok_or_else(|| {
            let found = said!("<SpectralData> with no wavelength");
            input.error_at(line(data), found, "wavelength=\"nm\"")
        })?;
        let expected = said!("a wavelength in nm");
        nm.push(xml::number(input, data, wavelength, expected)?);
        let value = data.text().unwrap_or("");
        values.push(xml::number(
            input,
            data,
            value,
            said!("a number as spectral value"),
        )?);
        at.push(data);
    }
    let points: Vec<u32> = (0..at.len()).map(kept_line).collect();
    let stated = field(Some(node), "SpectralQuantity").unwrap_or("");
    let (kind, unit) = quantity(stated);
    let mut raw = RawSpectrum::known(name, &nm, values, kind, &unit);
    raw.lines = &points;
    raw.source = Some(source.to_owned());
    add_element(input, raw, (node, &at), reading)?;
    let width = field(Some(node), "BandwidthFWHM");
    Ok(width.map(|width| tr!("bandwidth {width} nm (FWHM)", width)))
}

/// Kind and unit of a spectral quantity; writers put units there too ("W/nm").
fn quantity(stated: &str) -> (Decision<Kind>, String) {
    let known = QUANTITIES
        .iter()
        .find(|(word, ..)| word.eq_ignore_ascii_case(stated));
    if let Some((_, kind, unit)) = known {
        return (Decision::of_format(*kind), (*unit).to_owned());
    }
    let by_words = kinds::kind_of_words(stated);
    let kind = by_words.unwrap_or(Kind::Light);
    let stated_words = quoted(stated);
    let because = tr!(
        "the spectral quantity {quantity} is none of TM-27's",
        quantity = stated_words
    );
    // Writers put units there too ("W/nm"), which imply as much.
    let kind = Decision::guessed(kind, by_words.is_some(), because);
    (kind, stated.to_owned())
}
