//! Tables with their wavelengths along a row: one spectrum in each further row.

use super::block::has_values;
use super::columns::File;
use super::layout::AlongRow;
use super::pick::Table;
use crate::io::interpret::heading::Heading;
use crate::io::interpret::kinds::{kind_of_title, kind_of_words};
use crate::io::interpret::raw::{RawSpectrum, Scale};
use crate::io::interpret::{check_room, interpret};
use crate::io::text::dialect::Dialect;
use crate::io::text::number::number;
use crate::io::text::units::names_wavelength;
use crate::io::{ReadError, Reading};

pub(crate) fn read_rows(
    file: &File,
    table: &Table,
    along: &AlongRow,
    reading: &mut Reading,
) -> Result<(), ReadError> {
    let (block, input, dialect) = (&table.block, file.input, file.dialect);
    let heading = Heading::of(&block.header).shared_by(block.rows());
    let kind_title = titles_before(table, along.first);
    let columns = along.first..along.first + along.axis.len();
    if let Some(bad) = block.bad.iter().find(|bad| columns.contains(&bad.column)) {
        return Err(bad.refusal(input));
    }
    let values_of = |row: usize| block.values[columns.clone()].iter().map(move |c| c[row]);
    let rows = along.from_row..block.rows();
    let spectra = rows.filter(|row| has_values(values_of(*row))).count();
    check_room(input, reading.spectra.len() + spectra)?;
    let scale = Scale::new(&along.axis);
    let corner = corner(table, dialect, along);
    let mut cells = Vec::new();
    for (row, content) in block.row_texts().enumerate().skip(along.from_row) {
        dialect.split(content.trim_matches(' '), &mut cells);
        let before = cells.iter().take(along.first).copied();
        let words: Vec<&str> = before.filter(|cell| !cell.is_empty()).collect();
        let words = words.as_slice();
        let name = name_of(words).unwrap_or_else(|| (row + 1 - along.from_row).to_string());
        let name = match name.parse::<f64>() {
            Ok(_) => format!("{}, row {name}", input.stem()),
            Err(_) => name,
        };
        if !has_values(values_of(row)) {
            let line = block.lines[row];
            let note = tr!("line {line} holds no values and was left out", line);
            reading.notes.push(note);
            continue;
        }
        let values = values_of(row).collect();
        let raw = RawSpectrum::written(name, &scale, &kind_title, values, &heading);
        let raw = RawSpectrum {
            title: kind_word(words)
                .map(str::to_owned)
                .or_else(|| percent_label(words))
                .unwrap_or_else(|| corner.clone()),
            lines: std::slice::from_ref(&block.lines[row]),
            ..raw.saying_nm(along.says_nm)
        };
        interpret(raw.with_comma(dialect.decimal_comma), input, reading)?;
    }
    reading
        .notes
        .push(said!("wavelengths in a row, one spectrum in each further row").to_owned());
    Ok(())
}

/// A row's name: its words, and its numbers only where there are none. Meters write results such
/// as lux and chromaticity before the values.
fn name_of(words: &[&str]) -> Option<String> {
    let is_word = |cell: &&&str| number(cell.trim_matches('"'), false).is_none();
    let named: Vec<&str> = words.iter().filter(is_word).copied().collect();
    let all = if named.is_empty() { words } else { &named };
    (!all.is_empty()).then(|| all.join(" "))
}

/// A cell before the values that says nothing but what kind of value follows: "Transmittance".
fn kind_word<'a>(words: &[&'a str]) -> Option<&'a str> {
    words
        .iter()
        .copied()
        .find(|cell| !cell.trim().contains(' ') && cell.len() > 2 && kind_of_words(cell).is_some())
}

/// A row's words where they say with a per cent sign what is measured: "Refl %".
fn percent_label(words: &[&str]) -> Option<String> {
    let label = words.join(" ");
    (label.contains('%') && kind_of_title(&label).is_some()).then_some(label)
}

/// The word in the corner of the table, where it says what is measured and not that wavelengths
/// follow; empty otherwise.
fn corner(table: &Table, dialect: Dialect, along: &AlongRow) -> String {
    let corner = if along.from_row > 0 {
        let cells = dialect.cells(table.block.first_row());
        let before = cells.iter().take(along.first);
        let before: Vec<&str> = before.map(|cell| cell.trim_matches('"')).collect();
        before.join(" ").trim().to_owned()
    } else {
        titles_before(table, along.first)
    };
    let tells = corner.len() > 1 && kind_of_title(&corner).is_some() && !names_wavelength(&corner);
    if tells { corner } else { String::new() }
}

/// The titles before the wavelengths in their row ("wavelength (nm)").
fn titles_before(table: &Table, first: usize) -> String {
    (0..first)
        .map(|c| table.titles.whole(c))
        .collect::<Vec<_>>()
        .join(" ")
}
