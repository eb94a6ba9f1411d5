//! GDTF, the General Device Type Format of stage lights (DIN SPEC 15800): a zip archive with
//! `description.xml`.
//!
//! `Emitter` and `Filter` elements hold `Measurement`s, each a spectrum of `MeasurementPoint`s
//! with `WaveLength` (nm) and `Energy`; `Physical` is the dimmer's value at which it was measured.
//! A wheel's `Slot` names the filter in it.

use std::collections::HashMap;

use roxmltree::Node;

use super::{Confidence, Format, add_element};
use crate::io::decode::archive::{Archive, seems_to_hold};
use crate::io::decode::xml;
use crate::io::error::kept;
use crate::io::interpret::RawSpectrum;
use crate::io::{Decision, Input, ReadError, Reading, text};
use crate::spectrum::Kind;

/// GDTF fixtures.
pub(crate) const FORMAT: Format = Format::new("GDTF", &["gdtf"], sniff, read);

/// The member with the spectra.
const DESCRIPTION: &str = "description.xml";

/// Share of the memory that may come out of the archive; the parsed XML takes the rest.
const SHARE: f64 = 0.2;

fn sniff(input: &Input) -> Confidence {
    Confidence::certain_if(seems_to_hold(input.bytes, DESCRIPTION))
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let mut archive = Archive::open(input, SHARE)?;
    let is_description = |name: &String| name.eq_ignore_ascii_case(DESCRIPTION);
    let index = archive.names.iter().position(is_description);
    let none = || {
        input.error(
            said!("an archive without description.xml"),
            said!("a GDTF fixture"),
        )
    };
    let bytes = archive.member(index.ok_or_else(none)?)?;
    let text = text::decode(&bytes);
    let document = xml::parse(input, &text.text)?;
    let root = document.root_element();
    let fixture = xml::named(root, "FixtureType")
        .find_map(|node| xml::attribute(node, "LongName").or(xml::attribute(node, "Name")))
        .map_or(input.stem(), kept);
    let slots = slots(root);
    let mut reading = Reading::default();
    let mut without = 0_usize;
    for (element, kind) in [("Emitter", Kind::Light), ("Filter", Kind::Transmittance)] {
        for node in xml::named(root, element) {
            let measurements: Vec<Node> = xml::children(node, "Measurement")
                .filter(|m| xml::children(*m, "MeasurementPoint").next().is_some())
                .collect();
            without += usize::from(measurements.is_empty());
            for measurement in &measurements {
                let of_element = xml::attribute(node, "Name").unwrap_or(element);
                let name = match xml::attribute(*measurement, "Physical") {
                    Some(physical) if measurements.len() > 1 => {
                        format!("{fixture} {of_element}, dimmer {physical}")
                    }
                    _ => format!("{fixture} {of_element}"),
                };
                let mut notes = read_measurement(input, *measurement, (name, kind), &mut reading)?;
                let slot = slots.get(of_element);
                if let Some(slot) = slot.filter(|_| kind == Kind::Transmittance) {
                    notes.push(tr!("in the wheel as {slot}", slot));
                }
                if let Some(spectrum) = reading.spectra.last_mut() {
                    spectrum.notes = notes;
                }
            }
        }
    }
    if reading.spectra.is_empty() {
        return Err(input.error(
            tr!(
                "a GDTF fixture of {n} emitters and filters without measurements"
                    | "a GDTF fixture of {n} emitters and filters without measurements" % without
            ),
            said!("<Measurement> with two or more <MeasurementPoint> elements"),
        ));
    }
    if without > 0 {
        let note = tr!("{n} emitters or filters have no measurement"
            | "{n} emitters or filters have no measurement" % without);
        reading.notes.push(note);
    }
    Ok(reading)
}

/// Adds the spectrum of a measurement; returns further notes on it.
fn read_measurement(
    input: &Input,
    node: Node,
    (name, kind): (String, Kind),
    reading: &mut Reading,
) -> Result<Vec<String>, ReadError> {
    let (mut nm, mut values) = (Vec::new(), Vec::new());
    for point in xml::children(node, "MeasurementPoint") {
        let get = |name: &str, expected: &str| {
            let text = xml::attribute(point, name).unwrap_or("");
            xml::number(input, point, text, expected)
        };
        nm.push(get("WaveLength", said!("a number as WaveLength=\"...\""))?);
        values.push(get("Energy", said!("a number as Energy=\"...\""))?);
    }
    let kind = Decision::of_format(kind);
    let raw = RawSpectrum::known(name, &nm, values, kind, "relative");
    add_element(input, raw, (node, &[]), reading)?;
    let stated = |name| xml::attribute(node, name);
    let notes = [
        stated("Physical").map(|value| tr!("dimmer at {value}", value)),
        stated("LuminousIntensity").map(|value| tr!("luminous intensity {value}", value)),
        stated("Transmission").map(|value| tr!("transmission {value}", value)),
    ];
    Ok(notes.into_iter().flatten().collect())
}

/// The wheel slots by the filters in them, the first of each.
fn slots<'a>(root: Node<'a, '_>) -> HashMap<&'a str, &'a str> {
    let mut slots = HashMap::new();
    for slot in xml::named(root, "Slot") {
        let filter = xml::attribute(slot, "Filter");
        if let (Some(filter), Some(name)) = (filter, xml::attribute(slot, "Name")) {
            // A link may name the collection too: "Filters.CTO".
            let filter = filter.rsplit('.').next().unwrap_or(filter);
            slots.entry(filter).or_insert(name);
        }
    }
    slots
}
