//! Spectra Vista (and GER) `.sig`: reference, target and their ratio in per cent.
//!
//! ```text
//! /*** Spectra Vista SIG Data ***/
//! name= gr070214_003.sig
//! units= Radiance, Radiance              of reference and target
//! factors= 0.993, 0.990, 1.000 [Overlap: Remove @ 985,1906, ...]
//! data=
//! 337.9  351.54  30.69  8.73             nm, reference, target, reflectance in per cent
//! ```
//!
//! The reflectance comes first, reference and target follow as lights. Where the detectors overlap
//! the wavelengths step back; they are sorted, with a note.

use super::rows::{Rows, filled, numbers};
use super::{Confidence, Format};
use crate::io::interpret::{KnownScale, RawSpectrum, interpret};
use crate::io::text::{lines, number};
use crate::io::{Decision, Input, ReadError, Reading, quoted};
use crate::spectrum::Kind;

pub(crate) const FORMAT: Format = Format::new("SVC .sig", &["sig"], sniff, read);

fn sniff(input: &Input) -> Confidence {
    let first = input.first_line();
    let marked = first.starts_with("/***") && first.to_uppercase().contains("SIG");
    let mut keys = ["units", "data", "instrument"].into_iter();
    let has = |word: &str| lines(input.head()).any(|(_, l)| key(l).is_some_and(|(k, _)| k == word));
    Confidence::certain_if(marked || keys.all(has))
}

/// Key and value of a header line.
fn key(line: &str) -> Option<(&str, &str)> {
    let (key, value) = line.split_once('=')?;
    (key.len() <= 40).then(|| (key.trim(), value.trim()))
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let (mut units, mut name) = (Vec::new(), "");
    let mut content = filled(text);
    for (_, line) in content.by_ref() {
        match key(line) {
            Some(("data", _)) => break,
            Some(("units", value)) => units = value.split(',').map(str::trim).collect(),
            Some(("name", value)) => name = value,
            _ => {}
        }
    }
    let mut rows = Rows::default();
    let expected = said!("a wavelength, reference, target and reflectance");
    for (line, row) in content {
        let cells = row.split(|c: char| c.is_whitespace() || c == ';');
        let number = |cell: &str| number::parse(cell, cell.contains(',')).value();
        let row = numbers(cells, 5, number).map_err(|(before, cell)| {
            let expected = tr!("a number in column {column}", column = before + 1);
            input.error_at(line, quoted(cell), expected)
        })?;
        if !rows.add(line, &row) || !(2..=4).contains(&row.len()) {
            let found = tr!("{n} numbers" | "{n} numbers" % row.len());
            return Err(input.error_at(line, found, expected));
        }
    }
    if rows.lines.is_empty() {
        let found = said!("a Spectra Vista header and no rows behind \"data=\"");
        let expected = said!("a wavelength, reference, target and reflectance in each row");
        return Err(input.error(found, expected));
    }
    let width = rows.columns.len();
    let name = name.rsplit(['/', '\\']).next().unwrap_or("");
    let name = name.strip_suffix(".sig").unwrap_or(name);
    let name = input.named(name);
    let nm = rows.take(0);
    let lights = [(rows.take(1), "reference"), (rows.take(2), "target")];
    let mut reading = Reading::default();
    if width == 4 {
        let kind = Decision::of_format(Kind::Reflectance);
        let mut spectrum = RawSpectrum::known(name, &nm, rows.take(3), kind, "");
        spectrum.known.scale = KnownScale::Stated(0.01);
        spectrum.lines = &rows.lines;
        interpret(spectrum, input, &mut reading)?;
    }
    for (index, (values, role)) in lights.into_iter().enumerate() {
        // Reference or target alone may not have been measured: zeros or gaps throughout.
        let measured = values.iter().filter(|v| v.is_finite()).count();
        if values.is_empty() || width == 4 && measured < 2 {
            continue;
        }
        let word = units.get(index).or(units.first()).copied().unwrap_or("");
        let unit = match word.to_lowercase().as_str() {
            // The instrument's manual: 1e-10 W cm-2 nm-1 sr-1.
            "radiance" => "1e-10 W cm-2 nm-1 sr-1",
            "irradiance" => "1e-10 W cm-2 nm-1",
            _ => word,
        };
        let called = match width {
            2 => name.to_owned(),
            _ => format!("{name}, {role}"),
        };
        let spectrum = RawSpectrum {
            lines: &rows.lines,
            notes: vec![match role {
                "reference" => tr!("the reference, in the file's units \"{unit}\"", unit = word),
                _ => tr!("the target, in the file's units \"{unit}\"", unit = word),
            }],
            ..RawSpectrum::light(called, &nm, values, unit)
        };
        interpret(spectrum, input, &mut reading)?;
    }
    Ok(reading)
}
