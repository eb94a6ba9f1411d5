//! Ocean Optics ProcSpec: a zip archive of `ps_0.xml`, ... written by SpectraSuite's XML streams.
//!
//! `channelWavelengths` and `processedPixels` hold a `<double>` a pixel; the raw pixels of sample,
//! dark and reference stand in `sourceSpectra`, `darkSpectrum` and `referenceSpectrum` as
//! `pixelValues`. The processed pixels are read, and the raw ones where there are none. The XML
//! may hold bytes that no encoding knows; they are read as Windows-1252.

use roxmltree::Node;

use crate::spectrum::Kind;

use super::{Confidence, Format};
use crate::io::decode::archive::{Archive, is_zip, seems_to_hold};
use crate::io::decode::xml;
use crate::io::interpret::heading::Heading;
use crate::io::interpret::interpret;
use crate::io::interpret::raw::{RawSpectrum, Scale};
use crate::io::text::{self, number};
use crate::io::{Input, ReadError, Reading};

/// Ocean Optics ProcSpec.
pub(crate) const FORMAT: Format = Format {
    name: "Ocean Optics ProcSpec",
    extensions: &["procspec"],
    sniff,
    read,
};

/// Share of the memory that may come out of the archive; the parsed XML takes the rest.
const SHARE: f64 = 0.2;

fn sniff(input: &Input) -> Confidence {
    let bytes = input.bytes;
    let by_name = is_zip(bytes) && input.has_extension("procspec");
    if by_name || seems_to_hold(bytes, "OOISignatures.xml") || seems_to_hold(bytes, "ps_0.xml") {
        Confidence::Certain
    } else {
        Confidence::No
    }
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let mut archive = Archive::open(input, SHARE)?;
    let members: Vec<usize> = (0..archive.names.len())
        .filter(|index| {
            let name = archive.names[*index].rsplit('/').next().unwrap_or("");
            let number = name
                .strip_prefix("ps_")
                .and_then(|n| n.strip_suffix(".xml"));
            number.is_some_and(|n| n.bytes().all(|b| b.is_ascii_digit()))
        })
        .collect();
    if members.is_empty() {
        return Err(input.error(
            "an archive without ps_0.xml",
            "an Ocean Optics ProcSpec archive",
        ));
    }
    let several = members.len() > 1;
    let mut reading = Reading::default();
    for (place, index) in members.into_iter().enumerate() {
        let bytes = archive.member(index)?;
        let decoded = text::decode(&bytes);
        // Control characters that XML forbids come out of broken writers.
        let clean: String = decoded
            .text
            .chars()
            .map(|c| {
                if c < ' ' && !"\t\r\n".contains(c) {
                    ' '
                } else {
                    c
                }
            })
            .collect();
        let document = xml::parse(input, &clean)?;
        let name = if several {
            format!("{} {}", input.stem(), place + 1)
        } else {
            input.stem().to_owned()
        };
        read_spectrum(input, document.root_element(), name, &mut reading)?;
    }
    Ok(reading)
}

/// The numbers of the first element of a name that holds any.
fn doubles(input: &Input, root: Node, name: &str) -> Result<Vec<f64>, ReadError> {
    for node in xml::named(root, name).take(100) {
        let mut numbers = Vec::new();
        for item in node.children().filter(|n| n.has_tag_name("double")) {
            let text = item.text().unwrap_or("").trim();
            let value = match number::number(text, false) {
                Some(value) => value,
                None if text.eq_ignore_ascii_case("nan") || text.contains("Infinity") => f64::NAN,
                None => {
                    return Err(input
                        .error(crate::io::error::quoted(text), "a number in <double>")
                        .at_line(xml::line(item)));
                }
            };
            numbers.push(value);
        }
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
        return Err(input.error("no <channelWavelengths>", "one with a <double> a pixel"));
    }
    let mut values = doubles(input, root, "processedPixels")?;
    let mut title = "processed";
    if values.is_empty() {
        values = doubles(input, root, "pixelValues")?;
        title = "counts";
    }
    if values.len() != axis.len() {
        let found = format!("{} pixels for {} wavelengths", values.len(), axis.len());
        return Err(input.error(found, "as many pixels as wavelengths"));
    }
    // SpectraSuite names the quantity in the class of its processing: "Transmission", "Reflection",
    // "Absorbance", "Irradiance".
    let words = [
        "yUnits",
        "yAxisLabel",
        "units",
        "processingName",
        "dataType",
    ];
    let said = words
        .iter()
        .find_map(|word| xml::named(root, word).find_map(|n| n.text()))
        .unwrap_or("")
        .to_owned();
    let title = if said.trim().is_empty() {
        title
    } else {
        said.trim()
    };
    let index = reading.spectra.len();
    let (scale, heading) = (Scale::new(&axis), Heading::default());
    let raw = RawSpectrum {
        title: title.to_owned(),
        ..RawSpectrum::written(name, &scale, "nm", values, &heading).saying_nm(true)
    };
    interpret(raw, input, reading)?;
    let spectrum = &mut reading.spectra[index];
    if spectrum.kind == Kind::Light && title == "counts" {
        spectrum
            .notes
            .push("raw counts: nothing processed in the file".to_owned());
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use crate::io::decode::archive::zipped;
    use crate::io::read_bytes;

    const XML: &str = "<com.oceanoptics.omnidriver.spectra.OmniSpectrum>\n<sourceSpectra><pixelValues>\
        <double>10</double><double>20</double><double>30</double></pixelValues>\n\
        <channelWavelengths><double>400.1</double><double>400.5</double><double>400.9</double>\
        </channelWavelengths></sourceSpectra>\n<processedPixels><double>50.5</double>\
        <double>NaN</double><double>60.5</double></processedPixels>\n\
        </com.oceanoptics.omnidriver.spectra.OmniSpectrum>";

    #[test]
    fn processed_pixels_go_before_raw_ones() {
        let archive = zipped(&[("OOISignatures.xml", b"<a/>"), ("ps_0.xml", XML.as_bytes())]);
        let reading = read_bytes("a.ProcSpec", &archive).expect("a spectrum");
        assert_eq!(reading.spectra[0].samples.nm(), [400.1, 400.9]);
        let raw = XML.replace("processedPixels", "other");
        let archive = zipped(&[("ps_0.xml", raw.as_bytes())]);
        let reading = read_bytes("a.zip", &archive).expect("a spectrum");
        assert_eq!(reading.spectra[0].samples.values(), [10.0, 20.0, 30.0]);
    }

    #[test]
    fn what_does_not_fit_is_said() {
        let short = XML.replace("<double>60.5</double>", "");
        let archive = zipped(&[("ps_0.xml", short.as_bytes())]);
        let said = read_bytes("a.ProcSpec", &archive).unwrap_err().to_string();
        assert!(said.contains("2 pixels for 3 wavelengths"), "{said}");
        let said = read_bytes("a.ProcSpec", &zipped(&[("x", b"")]))
            .unwrap_err()
            .to_string();
        assert!(said.contains("without ps_0.xml"), "{said}");
    }
}
