//! CxF3, the Color Exchange Format (ISO 17972): XML with measured colours.
//!
//! An `Object` has a `Name` and under `ColorValues` spectra: `ReflectanceSpectrum`,
//! `TransmittanceSpectrum`, `EmissiveSpectrum`, blanks between values. `StartWL` is at the
//! spectrum or, with `Increment`, at the `WavelengthRange` of the `ColorSpecification` that it
//! names; without an increment it is 10 nm.

use std::collections::HashMap;

use roxmltree::Node;

use super::{Confidence, Format, add_element};
use crate::io::decode::xml;
use crate::io::interpret::RawSpectrum;
use crate::io::text::number;
use crate::io::{Decision, Input, ReadError, Reading, budget, quoted};
use crate::languages::said;
use crate::spectrum::Kind;

/// CxF3.
pub(crate) const FORMAT: Format = Format::new("CxF3", &["cxf"], sniff, read);

/// Memory of a spectrum besides its samples, in bytes.
const SPECTRUM_BYTES: usize = 1000;

/// The most levels above a spectrum at which its object is sought.
const DEEPEST: usize = 16;

const SPECTRA: [(&str, Kind); 4] = [
    ("ReflectanceSpectrum", Kind::Reflectance),
    ("TransmittanceSpectrum", Kind::Transmittance),
    ("EmissiveSpectrum", Kind::Light),
    ("EmissionSpectrum", Kind::Light),
];

/// Spectra of a quantity that only their writer knows.
const CUSTOM: &str = "CustomSpectrum";

fn sniff(input: &Input) -> Confidence {
    let head = input.head();
    let is_cxf = head.contains("colorexchangeformat.com") || head.contains(":CxF ");
    Confidence::certain_if(head.starts_with('<') && (is_cxf || head.contains("<CxF")))
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let document = xml::parse(input, text.trim_start())?;
    let root = document.root_element();
    let mut ranges: HashMap<&str, Node> = HashMap::new();
    for specification in xml::named(root, "ColorSpecification") {
        let range = xml::named(specification, "WavelengthRange").next();
        if let (Some(id), Some(range)) = (xml::attribute(specification, "Id"), range) {
            ranges.entry(id).or_insert(range);
        }
    }
    let mut reading = Reading::default();
    let mut left = budget::of_text(input.bytes.len()) / 2;
    for node in root.descendants().filter(Node::is_element) {
        let word = node.tag_name().name();
        if word == CUSTOM {
            let name = object_of(node).and_then(|object| xml::attribute(object, "Name"));
            reading.notes.push(tr!(
                "{name}: a {element}, of which the file does not tell what it is, was left out",
                name = name.unwrap_or(input.stem()),
                element = CUSTOM
            ));
        }
        let Some((_, kind)) = SPECTRA.iter().find(|(known, _)| *known == word) else {
            continue;
        };
        let Some(object) = object_of(node) else {
            continue;
        };
        let name = xml::attribute(object, "Name").or_else(|| xml::attribute(object, "Id"));
        let name = name.unwrap_or(input.stem());
        let points = read_spectrum(input, node, &ranges, (name, *kind), &mut reading)?;
        let too_many = || {
            input.error(
                said!("far more spectra than its size allows"),
                said(budget::TEXT_WORDS),
            )
        };
        left = left
            .checked_sub(SPECTRUM_BYTES + 32 * points)
            .ok_or_else(|| too_many().at_line(xml::line(node)))?;
    }
    if reading.spectra.is_empty() {
        let found = match reading.notes.first() {
            Some(why) => tr!("a CxF file without spectra ({why})", why),
            None => said!("a CxF file without spectra").to_owned(),
        };
        let expected = said!("an Object with a ReflectanceSpectrum or an EmissiveSpectrum");
        return Err(input.error(found, expected));
    }
    Ok(reading)
}

/// The object that a spectrum belongs to.
fn object_of<'a, 'i>(node: Node<'a, 'i>) -> Option<Node<'a, 'i>> {
    node.ancestors()
        .take(DEEPEST)
        .find(|n| n.tag_name().name().eq_ignore_ascii_case("Object"))
}

/// Adds the spectrum of an element; its number of points.
fn read_spectrum(
    input: &Input,
    node: Node,
    ranges: &HashMap<&str, Node>,
    (name, kind): (&str, Kind),
    reading: &mut Reading,
) -> Result<usize, ReadError> {
    // Counted from the file's start, so only where there is trouble.
    let at = || xml::line(node);
    let range = xml::attribute(node, "ColorSpecification").and_then(|id| ranges.get(id));
    let number = |name: &str| {
        xml::attribute(node, name).or_else(|| range.and_then(|r| xml::attribute(*r, name)))
    };
    let positive = |name: &str, text: &str| {
        let number = number::number(text, false).filter(|x| x.is_finite() && *x > 0.0);
        let found = || format!("{name}={}", quoted(text));
        number.ok_or_else(|| {
            input
                .error(found(), said!("a wavelength in nm"))
                .at_line(at())
        })
    };
    let start = number("StartWL").ok_or_else(|| {
        let found = tr!(
            "<{element}> without StartWL",
            element = node.tag_name().name()
        );
        let expected = said!("StartWL=\"nm\" there or in its ColorSpecification");
        input.error(found, expected).at_line(at())
    })?;
    let start = positive("StartWL", start)?;
    let mut notes = Vec::new();
    let step = match number("Increment") {
        Some(text) => positive("Increment", text)?,
        None => {
            notes.push(said!("no increment in the file: taken as 10 nm").to_owned());
            10.0
        }
    };
    let value = |word: &str| {
        let refusal = || input.error(quoted(word), said!("numbers with blanks between them"));
        number::number(word, false).ok_or_else(|| refusal().at_line(at()))
    };
    let words = node.text().unwrap_or("").split_whitespace();
    let values: Vec<f64> = words.map(value).collect::<Result<_, _>>()?;
    if values.len() < 2 {
        let note = tr!(
            "{name}: {n} value, too few for a spectrum: left out"
                | "{name}: {n} values, too few for a spectrum: left out" % values.len(),
            name
        );
        reading.notes.push(note);
        return Ok(values.len());
    }
    let nm: Vec<f64> = (0..values.len()).map(|i| start + i as f64 * step).collect();
    let mut raw = RawSpectrum::known(name, &nm, values, Decision::of_format(kind), "");
    raw.notes = notes;
    add_element(input, raw, (node, &[]), reading)?;
    Ok(nm.len())
}
