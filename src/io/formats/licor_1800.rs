//! LI-COR LI-1800 `.PRN`: quoted header lines, then wavelengths in nm and values.
//!
//! ```text
//! "FILE:FL2"
//! "REM: TLD 36W/865       (QNTM)"     QNTM: photons, µmol m-2 s-1 nm-1; WATT: W m-2 nm-1
//! "LIMS: 300- 900NM"
//! "INT:  1NM"
//! "MAX:  546NM  7.491E-01"            the maker's own peak
//!  300  1.518E-04
//! ```

use super::{Confidence, Format, pair};
use crate::io::interpret::value_unit::PHOTONS;
use crate::io::interpret::{KnownScale, RawSpectrum, alone};
use crate::io::reading::remark::PHOTON_NOTE;
use crate::io::text::number::{self, Cell};
use crate::io::text::{kept_line, lines};
use crate::io::{Decision, Input, MakersResult, Quantity, ReadError, Reading, quoted};
use crate::spectrum::Kind;

pub(crate) const FORMAT: Format = Format {
    name: "LI-COR LI-1800",
    extensions: &["prn"],
    sniff,
    read,
};

/// The header line of a word (`REM`), quotes removed.
fn field<'a>(line: &'a str, word: &str) -> Option<&'a str> {
    let line = line.trim().trim_matches('"').trim();
    let rest = line.strip_prefix(word)?.trim_start();
    rest.strip_prefix(':').map(str::trim)
}

/// Reflectance or transmittance, where a word of the remark (capitals) begins so.
fn factor_of_remark(remark: &str) -> Option<Kind> {
    remark.split_whitespace().find_map(|word| match word {
        _ if word.starts_with("REFL") => Some(Kind::Reflectance),
        "TRAN" | "TRANS" => Some(Kind::Transmittance),
        _ => word.starts_with("TRANSM").then_some(Kind::Transmittance),
    })
}

fn sniff(input: &Input) -> Confidence {
    let head = input.head();
    let has = |word: &str| lines(head).take(12).any(|(_, l)| field(l, word).is_some());
    Confidence::certain_if(has("LIMS") && (has("REM") || has("INT")))
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let (mut nm, mut values, mut at) = (vec![], vec![], vec![]);
    let (mut remark, mut peak) = ("", None);
    for (line, content) in lines(text) {
        let content = content.trim();
        if let Some(found) = field(content, "REM") {
            remark = found;
        } else if let Some(found) = field(content, "MAX") {
            peak = Some(found);
        } else if content.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
            let comma = content.contains(',');
            let cell = |word: &str| match number::parse(word, comma) {
                Cell::Percent(_) => None,
                cell => cell.value(),
            };
            let (wavelength, value) = pair(content, cell).map_err(|found| {
                input.error_at(line, quoted(found), "a wavelength in nm and a value")
            })?;
            nm.push(wavelength);
            values.push(value);
            at.push(kept_line(line));
        }
    }
    let upper = remark.to_uppercase();
    let (unit, because) = if upper.contains("QNTM") {
        (PHOTONS, "QNTM in the remark: photons")
    } else if upper.contains("WATT") {
        ("W m-2 nm-1", "WATT in the remark: energy")
    } else {
        (
            "",
            "the remark names neither WATT nor QNTM: the unit is not known",
        )
    };
    // A remark that names no unit may say what was held under the meter instead.
    let factor = unit.is_empty().then(|| factor_of_remark(&upper)).flatten();
    let name = remark
        .split("(QNTM")
        .flat_map(|part| part.split("(WATT"))
        .next()
        .unwrap_or("")
        .trim();
    let name = if name.is_empty() { input.stem() } else { name };
    let mut spectrum = RawSpectrum::light(name, &nm, values, unit);
    spectrum.lines = &at;
    if let Some(kind) = factor {
        let kind = Decision::guessed(kind, false, "the words of the remark");
        (spectrum.known.kind, spectrum.known.scale) = (Some(kind), KnownScale::Open);
    } else {
        spectrum.notes.push(because.to_owned());
    }
    if unit == PHOTONS {
        spectrum.notes.push(PHOTON_NOTE.to_owned());
    }
    let mut reading = alone(spectrum, input)?;
    if let Some(found) = peak
        && let Some(first) = found.split_whitespace().next()
        && let Cell::Nanometres(value) = number::parse(first, false)
    {
        reading.results.push(MakersResult {
            spectrum: Some(0),
            quantity: Quantity::PeakNm,
            value,
            unit: "nm".to_owned(),
            as_written: format!("MAX: {}", found.chars().take(60).collect::<String>()),
        });
    }
    Ok(reading)
}

#[cfg(test)]
mod tests {
    use crate::io::tests::{first, read, refusal};
    use crate::spectrum::Kind;

    const SMALL: &str = "\"FILE:FL2\"\n\"REM: TLD 36W       (QNTM)\"\n\"LIMS: 300- 302NM\"\n\"INT:  1NM\"\n\"MAX:  301NM  7.5E-01\"\n 300  1.5E-04\n 301  7.5E-01\n 302 -1E-04\n";

    #[test]
    fn photons_name_and_peak_are_read() {
        let reading = read("a.PRN", SMALL);
        let spectrum = &reading.spectra[0];
        assert_eq!(reading.format, "LI-COR LI-1800");
        assert_eq!(spectrum.name, "TLD 36W");
        assert_eq!(spectrum.unit, "µmol m-2 s-1 nm-1");
        assert_eq!(spectrum.samples.values(), [1.5e-4, 0.75, -1e-4]);
        assert_eq!(reading.results[0].value, 301.0);
        let watt = SMALL.replace("QNTM", "WATT").replace('\n', "\r\n");
        assert_eq!(first("a.PRN", watt).unit, "W m-2 nm-1");
    }

    #[test]
    fn a_remark_without_a_unit_may_name_a_reflectance() {
        let leaf = SMALL.replace("TLD 36W       (QNTM)", "REFL OAK AD 1 ");
        let spectrum = first("a.PRN", leaf);
        assert_eq!(spectrum.kind, Kind::Reflectance);
        assert_eq!((spectrum.unit.as_str(), spectrum.scale), ("fraction", 1.0));
        let lamp = SMALL.replace("TLD", "REFLECTOR TLD");
        assert_eq!(first("a.PRN", lamp).kind, Kind::Light);
    }

    #[test]
    fn a_broken_row_is_refused_with_its_line() {
        assert_eq!(
            refusal("a.PRN", SMALL.replace("7.5E-01\n 302", "x\n 302")),
            "a.PRN, line 7: found \"x\", expected a wavelength in nm and a value"
        );
    }
}
