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
//! the wavelengths step back; they are put in order, and it is said.

use super::{Confidence, Format};
use crate::io::interpret::{KnownScale, RawSpectrum, interpret};
use crate::io::text::{kept_line, lines, number};
use crate::io::{Decision, Input, ReadError, Reading, quoted};
use crate::spectrum::Kind;

pub(crate) const FORMAT: Format = Format {
    name: "SVC .sig",
    extensions: &["sig"],
    sniff,
    read,
};

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

/// Puts the numbers of a row under those above it; returns how many there are, five where there
/// are more.
fn take_row(
    input: &Input,
    (line, row): (usize, &str),
    columns: &mut [Vec<f64>; 4],
) -> Result<usize, ReadError> {
    let cells = row.split(|c: char| c.is_whitespace() || c == ';');
    let mut count = 0;
    for cell in cells.filter(|c| !c.is_empty()).take(5) {
        let value = number::parse(cell, cell.contains(',')).value();
        let expected = || format!("a number in column {}", count + 1);
        let value = value.ok_or_else(|| input.error_at(line, quoted(cell), expected()))?;
        if let Some(column) = columns.get_mut(count) {
            column.push(value);
        }
        count += 1;
    }
    Ok(count)
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let (mut units, mut name, mut in_data) = (Vec::new(), "", false);
    let mut columns: [Vec<f64>; 4] = Default::default();
    let (mut at, mut width) = (Vec::new(), 0);
    for (line, content) in lines(text) {
        let content = content.trim();
        if content.is_empty() {
            continue;
        }
        if !in_data {
            match key(content) {
                Some(("data", _)) => in_data = true,
                Some(("units", value)) => units = value.split(',').map(str::trim).collect(),
                Some(("name", value)) => name = value,
                _ => {}
            }
            continue;
        }
        let count = take_row(input, (line, content), &mut columns)?;
        if width == 0 {
            width = count;
        }
        if count != width || !(2..=4).contains(&count) {
            let expected = "a wavelength, reference, target and reflectance";
            return Err(input.error_at(line, format!("{count} numbers"), expected));
        }
        at.push(kept_line(line));
    }
    if at.is_empty() {
        return Err(input.error(
            "a Spectra Vista header and no rows behind \"data=\"",
            "a wavelength, reference, target and reflectance in each row",
        ));
    }
    let name = name.rsplit(['/', '\\']).next().unwrap_or("");
    let name = name.strip_suffix(".sig").unwrap_or(name);
    let name = if name.is_empty() { input.stem() } else { name };
    let [nm, reference, target, ratio] = columns;
    let mut reading = Reading::default();
    if width == 4 {
        let kind = Decision::of_format(Kind::Reflectance);
        let mut spectrum = RawSpectrum::known(name, &nm, ratio, kind, "");
        spectrum.known.scale = KnownScale::Stated(0.01);
        spectrum.lines = &at;
        interpret(spectrum, input, &mut reading)?;
    }
    let lights = [(reference, "reference"), (target, "target")];
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
            lines: &at,
            notes: vec![format!("the {role}, in the file's units \"{word}\"")],
            ..RawSpectrum::light(called, &nm, values, unit)
        };
        interpret(spectrum, input, &mut reading)?;
    }
    Ok(reading)
}
