//! Raman spectrometers' text: the axis counts wave numbers from a laser line, not nanometres.
//!
//! A shift `s` (1/cm) from a laser of `L` nm is light of `1e7 / (1e7 / L - s)` nm. The laser is told
//! by the header ("Laser wavelength 785 nm") or by the file's name as Horiba's instruments write it
//! (`iR785`, `iR532`) and the RRUFF project in its own (`__Raman__532__`); shifts from an unknown
//! laser are refused. A table that holds wavelengths beside the shifts is left to
//! [`columns`](super::columns).
//!
//! ```text
//! Horiba LabSpec  #Range (cm-1): 200 - 3198 / #Laser: 785
//! RRUFF           ##NAMES=Corundum / ##RRUFFID=R060020 / ##RAMAN WAVELENGTH=514
//! Renishaw WiRE   #Wave <TAB> <TAB> #Intensity; a map has #X and #Y before
//! WITec           rel. 1/cm <TAB> CCD cts
//! JASCO           DATA TYPE,RAMAN SPECTRUM / XUNITS,1/CM
//! ```

mod laser;

use super::{Confidence, Format, columns};
use crate::io::interpret::interpret;
use crate::io::interpret::raw::{RawAxis, RawSpectrum};
use crate::io::reading::decision::{AxisDecision, Decision};
use crate::io::reading::remark::taken_as;
use crate::io::table::block::Block;
use crate::io::table::layout::Layout;
use crate::io::table::pick;
use crate::io::table::roles::value_columns;
use crate::io::table::scan::scan;
use crate::io::table::titles::Titles;
use crate::io::text::dialect::Dialect;
use crate::io::text::lines;
use crate::io::text::words::holds_any;
use crate::io::{Input, ReadError, Reading};

/// Raman text.
pub(crate) const FORMAT: Format = Format {
    name: "Raman text",
    extensions: &["txt"],
    sniff,
    read,
};

/// Most lines of a header that are looked at.
const HEADER_LINES: usize = 60;

/// Words that name an axis of shifts, lower case.
const SHIFTS: [&str; 9] = [
    "raman shift",
    "ramanshift",
    "raman_shift",
    "rel. wavenumber",
    "relative wavenumber",
    "rel. 1/cm",
    "rel.1/cm",
    "rel 1/cm",
    "relative 1/cm",
];

fn headers(text: &str) -> impl Iterator<Item = &str> {
    lines(text)
        .take(HEADER_LINES)
        .map(|(_, line)| line.trim())
        .filter(|line| line.len() <= 400 && line.contains(|c: char| c.is_alphabetic()))
}

fn lower_headers(text: &str) -> impl Iterator<Item = String> {
    headers(text).map(str::to_lowercase)
}

/// Whether a header names shifts and no wavelengths beside them.
fn names_shifts(head: &str) -> bool {
    lower_headers(head).any(|line| holds_any(&line, &SHIFTS) && !line.contains("wavelength"))
}

/// Whether a header as Horiba's LabSpec writes it counts its first axis in 1/cm: shifts from the
/// laser.
fn counts_shifts(head: &str) -> bool {
    let unit = headers(head).find(|line| line.to_lowercase().contains("axisunit[1]"));
    unit.is_some_and(is_per_cm) && laser::of_header(headers(head)).is_some()
        || has_range_of_shifts(head)
}

/// Whether a text holds the unit of a shift.
fn is_per_cm(text: &str) -> bool {
    holds_any(text, &["1/cm", "1/CM", "cm-1", "cm-¹", "cm⁻¹", "cm^-1"])
}

/// Whether LabSpec's range is one of shifts (`#Range (cm-1):`): it has no other wave numbers. The
/// lines about the laser or the exposure tell it from other programs' headers.
fn has_range_of_shifts(head: &str) -> bool {
    let has = |word: &str| keys(head).any(|(key, _)| key.starts_with(word));
    let range = headers(head).any(|line| {
        let line = line.trim_start_matches('#').trim_start();
        let (key, _) = line.split_once(['=', ':', '\t']).unwrap_or((line, ""));
        key.to_lowercase().starts_with("range") && is_per_cm(key)
    });
    range && (has("laser") || has("acq"))
}

/// Keys of header lines (lower case letters and digits only) and what stands behind them.
fn keys(head: &str) -> impl Iterator<Item = (String, &str)> {
    headers(head).filter_map(|line| {
        let (key, value) = line.split_once(['=', ':', ',', ';', '\t'])?;
        let key = key.chars().filter(|c| c.is_alphanumeric());
        Some((key.flat_map(char::to_lowercase).collect(), value.trim()))
    })
}

/// Whether a header says that its data is a Raman spectrum, and nothing of wavelengths.
fn says_raman(head: &str) -> bool {
    let says = keys(head).any(|(key, value)| {
        matches!(&*key, "datatype" | "filetype" | "technique")
            && value.to_lowercase().contains("raman")
    });
    says && !lower_headers(head).any(|line| {
        let is_laser = holds_any(&line, &["laser", "excitation", "raman wavelength"]);
        !is_laser && holds_any(&line, &["wavelength", "nanomet"])
    })
}

/// Whether a file is one of the RRUFF project's Raman spectra: those of infrared light and X-rays
/// say what they are.
fn is_rruff(head: &str, name: &str) -> bool {
    let others = ["infrared", "x-ray", "xray", "powder"];
    let is_other = |text: &str| holds_any(&text.to_lowercase(), &others);
    let named = |word: &str| keys(head).find(|(key, _)| key == word);
    head.starts_with("##")
        && named("rruffid").is_some()
        && !is_other(name)
        && !named("filetype").is_some_and(|(_, value)| is_other(value))
}

/// The titles of a table of Renishaw's WiRE, lower case: `#Wave`, `#Intensity`, and in front of
/// them where in a map.
fn wire_titles(head: &str) -> Option<Vec<String>> {
    let line = headers(head).find(|line| line.starts_with('#'))?;
    let titles: Vec<String> = line.split_whitespace().map(str::to_lowercase).collect();
    let has = |title: &str| titles.iter().any(|other| other == title);
    (has("#wave") && has("#intensity")).then_some(titles)
}

fn sniff(input: &Input) -> Confidence {
    let head = input.head();
    if head.is_empty() || head.starts_with(['{', '<']) {
        Confidence::No
    } else if is_rruff(head, &input.name) {
        // Its labels are written as JCAMP-DX's, which is sure of its own.
        Confidence::Certain
    } else if head.starts_with("##") {
        Confidence::No
    } else if wire_titles(head).is_some() {
        // WiRE writes wavelengths under the same title: a person may say so.
        match input.choices.wavelengths {
            Some(_) => Confidence::No,
            None => Confidence::Likely,
        }
    } else if names_shifts(head)
        || counts_shifts(head)
        || says_raman(head)
        || laser::of_name(&input.name).is_some() && !names_nm(head)
    {
        Confidence::Likely
    } else {
        Confidence::No
    }
}

/// Whether a header names wavelengths.
fn names_nm(head: &str) -> bool {
    lower_headers(head).any(|line| holds_any(&line, &["wavelength", "nm"]))
}

/// Numbers with the column of shifts among them.
struct Shifts<'a> {
    block: Block<'a>,
    titles: Titles,
    axis: usize,
}

/// The tables of shifts of a text, and notes on what is left out.
fn tables_of(text: &str, dialect: Dialect) -> (Vec<Shifts<'_>>, Vec<String>) {
    let (mut found, mut notes) = (Vec::new(), Vec::new());
    for table in pick::tables(text, dialect).unwrap_or_default() {
        if table.is_short {
            notes.push(pick::lines_left_out(&table.block));
            continue;
        }
        let axis = match table.layout {
            // What rises beside shifts below zero looks more like wavelengths than they do.
            _ if leads(&table.block) => 0,
            Layout::Column(axis) => axis,
            _ => continue,
        };
        found.push(Shifts {
            block: table.block,
            titles: table.titles,
            axis,
        });
    }
    if found.is_empty() {
        // Shifts from zero or below are no wavelengths to the finder of tables.
        let blocks = scan(text, 0, dialect).unwrap_or_default();
        let longest = blocks.into_iter().filter(leads).max_by_key(Block::rows);
        found.extend(longest.map(|block| Shifts {
            titles: Titles::of(&block, dialect),
            block,
            axis: 0,
        }));
    }
    (found, notes)
}

/// Whether the first column of a block can be one of shifts.
fn leads(block: &Block) -> bool {
    if block.width < 2 || block.rows() < 2 || block.counts_rows(0) {
        return false;
    }
    let first = block.column(0);
    first.is_sorted_by(|a, b| a < b) || first.is_sorted_by(|a, b| a > b)
}

/// What the spectra of a file are called.
fn name_of(input: &Input, text: &str) -> String {
    let named = keys(text).find(|(key, value)| {
        matches!(&**key, "names" | "name") && !value.is_empty() && is_rruff(text, &input.name)
    });
    named.map_or_else(|| input.stem().to_owned(), |(_, name)| name.to_owned())
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_long_text()?.text;
    let head = input.head();
    if wire_titles(head).is_some_and(|titles| titles.len() > 2) {
        return Err(input.error(
            "a Raman map or series of several points",
            "the spectrum of one point: #Wave and #Intensity",
        ));
    }
    let laser = laser::decided(input, headers(text)).ok_or_else(|| {
        let found = "Raman shifts (1/cm) from a laser that is not named";
        let expected = "wavelengths, or the laser's wavelength in the header";
        input.error(found, expected)
    })?;
    let (dialect, seen) = pick::look(text, input.choices.delimiter);
    let (mut tables, mut notes) = tables_of(seen, dialect);
    if seen.len() < text.len() && !tables.is_empty() {
        (tables, notes) = tables_of(text, dialect);
    }
    if tables.is_empty() {
        // Plain columns know better what is wrong; what they make of shifts is not shown.
        let refusal = (columns::FORMAT.read)(input).err();
        return Err(refusal.unwrap_or_else(|| no_shifts(input)));
    }
    let mut reading = Reading {
        notes,
        cut_by: Some(dialect.delimiter),
        ..Reading::default()
    };
    for table in &tables {
        add(input, table, &laser, dialect, &mut reading)?;
    }
    if reading.spectra.is_empty() {
        return Err(no_shifts(input));
    }
    reading.notes.push(dialect.words());
    Ok(reading)
}

fn no_shifts(input: &Input) -> ReadError {
    input.error("no column of Raman shifts", "shifts (1/cm) and values")
}

/// Adds the spectra of a table; the laser in nm.
fn add(
    input: &Input,
    table: &Shifts,
    laser: &Decision<f64>,
    dialect: Dialect,
    reading: &mut Reading,
) -> Result<(), ReadError> {
    let (block, axis) = (&table.block, table.axis);
    let nm: Vec<f64> = block
        .column(axis)
        .iter()
        .map(|shift| 1e7 / (1e7 / laser.value - shift))
        .collect();
    let (values, _) = value_columns(block, &table.titles, axis, &[axis]);
    let is_used = |column| column == axis || values.contains(&column);
    if let Some(bad) = block.bad.iter().find(|bad| is_used(bad.column)) {
        return Err(bad.refusal(input));
    }
    let stem = name_of(input, input.head());
    for column in &values {
        let name = match values.len() {
            1 => stem.clone(),
            _ => format!("{stem}, column {}", column + 1),
        };
        let mut spectrum = RawSpectrum::light(name, &nm, block.column(*column).to_vec(), "");
        spectrum.lines = &block.lines;
        spectrum
            .how
            .push(format!("from Raman shifts of {} nm", laser.value));
        let chosen = format!("Raman shifts from {} nm", laser.value);
        spectrum.notes.push(taken_as(&chosen, &laser.reason));
        spectrum.axis = RawAxis::Nm(&nm, Some(AxisDecision::Laser(laser.clone())));
        interpret(spectrum.with_comma(dialect.decimal_comma), input, reading)?;
    }
    Ok(())
}
