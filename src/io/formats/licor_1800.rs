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

use super::rows::{Rows, filled};
use super::{Confidence, Format};
use crate::io::interpret::value_unit::PHOTONS;
use crate::io::interpret::{KnownScale, RawSpectrum, alone};
use crate::io::reading::remark::PHOTON_NOTE;
use crate::io::text::lines;
use crate::io::text::number::{self, Cell};
use crate::io::{Decision, Input, MakersResult, Quantity, ReadError, Reading};
use crate::languages::said;
use crate::spectrum::Kind;

pub(crate) const FORMAT: Format = Format::new("LI-COR LI-1800", &["prn"], sniff, read);

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
    let (mut remark, mut peak, mut rows) = ("", None, Rows::default());
    for (line, content) in filled(text) {
        if let Some(found) = field(content, "REM") {
            remark = found;
        } else if let Some(found) = field(content, "MAX") {
            peak = Some(found);
        } else if content.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
            let number = |word: &str| match number::parse(word, content.contains(',')) {
                Cell::Percent(_) => None,
                cell => cell.value(),
            };
            let expected = said!("a wavelength in nm and a value");
            rows.add_pair(input, (line, content), number, expected)?;
        }
    }
    let upper = remark.to_uppercase();
    let (unit, because) = if upper.contains("QNTM") {
        (PHOTONS, said!("QNTM in the remark: photons"))
    } else if upper.contains("WATT") {
        ("W m-2 nm-1", said!("WATT in the remark: energy"))
    } else {
        let because = said!("the remark names neither WATT nor QNTM: the unit is not known");
        ("", because)
    };
    // A remark without a unit may name the object under the meter instead.
    let factor = unit.is_empty().then(|| factor_of_remark(&upper)).flatten();
    let mut name = remark;
    for unit in ["(QNTM", "(WATT"] {
        name = name.split(unit).next().unwrap_or("").trim();
    }
    let (nm, values) = (rows.take(0), rows.take(1));
    let mut spectrum = RawSpectrum::light(input.named(name), &nm, values, unit);
    spectrum.lines = &rows.lines;
    if let Some(kind) = factor {
        let kind = Decision::guessed(kind, false, said!("the words of the remark"));
        (spectrum.known.kind, spectrum.known.scale) = (Some(kind), KnownScale::Open);
    } else {
        spectrum.notes.push(because.to_owned());
    }
    if unit == PHOTONS {
        spectrum.notes.push(said(PHOTON_NOTE).to_owned());
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
