//! Ocean Optics ProcSpec: a zip archive of `ps_0.xml`, ... written by SpectraSuite's XML streams.
//!
//! `channelWavelengths` and `processedPixels` hold a `<double>` a pixel; the raw pixels of sample,
//! dark and reference are in `sourceSpectra`, `darkSpectrum` and `referenceSpectrum` as
//! `pixelValues`. The processed pixels are read, and the raw ones where there are none. The XML
//! may hold bytes that no encoding knows; they are read as Windows-1252.

use roxmltree::Node;

use super::{Confidence, Format};
use crate::io::decode::archive::{Archive, is_zip, seems_to_hold};
use crate::io::decode::xml;
use crate::io::interpret::{Heading, RawSpectrum, Scale, interpret};
use crate::io::text::{self, number};
use crate::io::{Input, ReadError, Reading, quoted};
use crate::spectrum::Kind;

pub(crate) const FORMAT: Format = Format::new("Ocean Optics ProcSpec", &["procspec"], sniff, read);

/// Share of the memory that may come out of the archive; the parsed XML takes the rest.
const SHARE: f64 = 0.2;

fn sniff(input: &Input) -> Confidence {
    let bytes = input.bytes;
    let by_name = is_zip(bytes) && input.has_extension("procspec");
    let holds = |name| seems_to_hold(bytes, name);
    Confidence::certain_if(by_name || holds("OOISignatures.xml") || holds("ps_0.xml"))
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let mut archive = Archive::open(input, SHARE)?;
    let is_spectrum = |index: &usize| {
        let name = archive.names[*index].rsplit('/').next().unwrap_or("");
        let number = name.strip_prefix("ps_");
        let number = number.and_then(|n| n.strip_suffix(".xml"));
        number.is_some_and(|n| n.bytes().all(|b| b.is_ascii_digit()))
    };
    let members: Vec<usize> = (0..archive.names.len()).filter(is_spectrum).collect();
    if members.is_empty() {
        let expected = said!("an Ocean Optics ProcSpec archive");
        return Err(input.error(said!("an archive without ps_0.xml"), expected));
    }
    let several = members.len() > 1;
    let mut reading = Reading::default();
    for (place, index) in members.into_iter().enumerate() {
        let bytes = archive.member(index)?;
        let decoded = text::decode(&bytes);
        // Control characters that XML forbids come out of broken writers.
        let is_forbidden = |c: char| c < ' ' && !matches!(c, '\t' | '\r' | '\n');
        let clean = decoded.text.replace(is_forbidden, " ");
        let document = xml::parse(input, &clean)?;
        let name = match several {
            true => format!("{} {}", input.stem(), place + 1),
            false => input.stem().to_owned(),
        };
        read_spectrum(input, document.root_element(), name, &mut reading)?;
    }
    Ok(reading)
}

/// The numbers of the first element of a name that holds any.
fn doubles(input: &Input, root: Node, name: &str) -> Result<Vec<f64>, ReadError> {
    let value = |item: Node| {
        let text = item.text().unwrap_or("").trim();
        match number::number(text, false) {
            Some(value) => Ok(value),
            None if text.eq_ignore_ascii_case("nan") || text.contains("Infinity") => Ok(f64::NAN),
            None => {
                let expected = said!("a number in <double>");
                Err(input.error_at(xml::line(item), quoted(text), expected))
            }
        }
    };
    for node in xml::named(root, name).take(100) {
        let items = node.children().filter(|n| n.has_tag_name("double"));
        let numbers: Vec<f64> = items.map(value).collect::<Result<_, _>>()?;
        if !numbers.is_empty() {
            return Ok(numbers);
        }
    }
    Ok(Vec::new())
}

fn read_spectrum(
    input: &Input,
    root: Node,
    name: String,
    reading: &mut Reading,
) -> Result<(), ReadError> {
    let axis = doubles(input, root, "channelWavelengths")?;
    if axis.is_empty() {
        let expected = said!("one with a <double> a pixel");
        return Err(input.error(said!("no <channelWavelengths>"), expected));
    }
    let mut values = doubles(input, root, "processedPixels")?;
    let mut title = "processed";
    if values.is_empty() {
        values = doubles(input, root, "pixelValues")?;
        title = "counts";
    }
    if values.len() != axis.len() {
        let found = tr!(
            "{n} pixels for {wavelengths} wavelengths"
                | "{n} pixels for {wavelengths} wavelengths" % values.len(),
            wavelengths = axis.len()
        );
        return Err(input.error(found, said!("as many pixels as wavelengths")));
    }
    // SpectraSuite names the quantity in the class of its processing: "Transmission", "Reflection",
    // "Absorbance", "Irradiance".
    let mut words = "yUnits yAxisLabel units processingName dataType".split(' ');
    let stated = words.find_map(|word| xml::named(root, word).find_map(|n| n.text()));
    let stated = stated.map(str::trim).filter(|stated| !stated.is_empty());
    let title = stated.unwrap_or(title);
    let (scale, heading) = (Scale::new(&axis), Heading::default());
    let raw = RawSpectrum {
        title: title.to_owned(),
        ..RawSpectrum::written(name, &scale, "nm", values, &heading).saying_nm(true)
    };
    interpret(raw, input, reading)?;
    if let Some(spectrum) = reading.spectra.last_mut()
        && spectrum.kind == Kind::Light
        && title == "counts"
    {
        let note = said!("raw counts: nothing processed in the file").to_owned();
        spectrum.notes.push(note);
    }
    Ok(())
}
