//! Tables whose wavelengths stand down a column: which rows make a spectrum of which column, and
//! what it is called.

use std::collections::HashSet;
use std::ops::Range;

use super::block::{Block, has_values};
use super::pick::Table;
use super::roles::{self, Group, LeftOut};
use super::titles::Titles;
use super::{layout, no_table, row_order, samples};
use crate::io::interpret::heading::Heading;
use crate::io::interpret::raw::{RawSpectrum, Scale};
use crate::io::interpret::{check_room, interpret, kinds};
use crate::io::text::dialect::Dialect;
use crate::io::text::units::names_wavelength;
use crate::io::{Input, ReadError, Reading};

/// A file of tables that is being read.
pub(crate) struct File<'a, 'i> {
    /// Its bytes and what a person decided about it.
    pub input: &'a Input<'i>,
    /// The delimiter and decimal mark of its cells.
    pub dialect: Dialect,
}

/// Rows under one column of wavelengths.
struct Rows<'a> {
    axis_column: usize,
    axis: &'a [f64],
    values: &'a [usize],
    run: Range<usize>,
    part: String,
    /// The names of the columns of values.
    names: &'a [String],
    /// True if the columns are a camera's R, G and B.
    is_rgb: bool,
    /// The name of these rows in a column of words.
    sample: Option<&'a str>,
}

/// Adds the spectra of columns, each group of them beside its wavelengths. `part` tells the table
/// apart from others of the file.
pub(crate) fn read_groups(
    file: &File,
    table: &mut Table,
    groups: &[Group],
    part: &str,
    mut left_out: Vec<LeftOut>,
    reading: &mut Reading,
) -> Result<(), ReadError> {
    let all: Vec<usize> = groups.iter().flat_map(|g| g.values.clone()).collect();
    let (columns, is_rgb) = (all.len(), are_rgb(&table.titles, &all));
    let heading = Heading::of(&table.block.header).shared_by(columns);
    let titles = (&table.titles, groups.len() == columns);
    let above = names_above(&table.block, file.dialect, titles, &all).unwrap_or_default();
    let (mut told_apart, mut before) = (Vec::new(), 0);
    for group in groups {
        let mut values = group.values.clone();
        let (rows, named) = match groups {
            [_] => {
                let block = &mut table.block;
                let named = samples::together(block, file.dialect, group.axis, &group.values);
                if named.is_none() {
                    no_single_points(file, table, group.axis)?;
                    let block = &mut table.block;
                    let notes = row_order::put_right(file.input, block, group.axis, &group.values)?;
                    reading.notes.extend(notes);
                }
                (table.block.rows(), named)
            }
            _ => (rows_of(table, group), None),
        };
        let axis = table.block.column(group.axis)[..rows].to_vec();
        let runs: Vec<(Range<usize>, Option<String>)> = match named {
            Some((columns, samples)) => {
                left_out.retain(|other| !columns.contains(&other.column));
                values.retain(|column| !columns.contains(column));
                told_apart.push(said_of_samples(table, &columns));
                // A number is no name without the title above it.
                let title = match table.block.columns[columns[0]].numbers {
                    0 => "",
                    _ => table.titles.names[columns[0]].trim(),
                };
                let named = |name| Some(format!("{title} {name}").trim().to_owned());
                let runs = samples.into_iter();
                runs.map(|(name, run)| (run, named(name))).collect()
            }
            None => layout::runs(&axis).into_iter().map(|r| (r, None)).collect(),
        };
        let several = runs.len() > 1;
        let columns_read = values.iter().map(|column| table.block.column(*column));
        let filled =
            columns_read.flat_map(|of| runs.iter().filter(|run| has_values(&of[run.0.clone()])));
        check_room(file.input, reading.spectra.len() + filled.count())?;
        let columns = columns - (group.values.len() - values.len());
        let name_of = |(column, at): (&usize, usize)| match above.get(at) {
            Some(name) => name.clone(),
            None => column_name(&table.titles, *column, columns),
        };
        let names: Vec<String> = values.iter().zip(before..).map(name_of).collect();
        for (number, (run, sample)) in runs.into_iter().enumerate() {
            let rows = Rows {
                axis_column: group.axis,
                axis: &axis,
                values: &values,
                run,
                part: match several && sample.is_none() {
                    true => format!("{part}, part {}", number + 1),
                    false => part.to_owned(),
                },
                names: &names,
                is_rgb,
                sample: sample.as_deref(),
            };
            read_columns(file, table, &heading, &rows, reading)?;
        }
        before += group.values.len();
    }
    let left_out = left_out.iter().map(|column| column.words(&table.titles));
    reading.notes.extend(left_out.chain(told_apart));
    Ok(())
}

fn said_of_samples(table: &Table, columns: &[usize]) -> String {
    let shown = columns.iter().map(|c| roles::shown(&table.titles, *c));
    let shown = shown.reduce(|one, other| tr!("{one} and {other}", one, other));
    let shown = shown.unwrap_or_default();
    match columns {
        [_] => tr!("{column} tells the spectra apart", column = shown),
        _ => tr!("{columns} tell the spectra apart", columns = shown),
    }
}

/// The note on values known only to lie beyond a limit.
fn said_of_limits(count: usize) -> Option<String> {
    (count > 0).then(|| {
        tr!(
            "{n} value lies below or above a limit (\"<\", \">\"): the limit was taken"
                | "{n} values lie below or above a limit (\"<\", \">\"): the limit was taken"
                    % count
        )
    })
}

/// Refuses a list in which each row is another thing: its values are no curve.
fn no_single_points(file: &File, table: &Table, axis: usize) -> Result<(), ReadError> {
    let Some(names) = samples::names_of_rows(&table.block, file.dialect, axis) else {
        return Ok(());
    };
    let found = tr!(
        "another name in every row ({column}) and wavelengths that go to and fro",
        column = roles::shown(&table.titles, names)
    );
    let expected = said!("several wavelengths of each spectrum");
    let line = table.block.lines[0] as usize;
    Err(file.input.error(found, expected).at_line(line))
}

/// Rows of a table beside another, without those below its end.
fn rows_of(table: &Table, group: &Group) -> usize {
    let is_filled = |row: usize| {
        let mut columns = group.values.iter().chain([&group.axis]);
        columns.any(|column| !table.block.column(*column)[row].is_nan())
    };
    let last = (0..table.block.rows()).rposition(is_filled);
    last.map_or(0, |row| row + 1)
}

fn read_columns(
    file: &File,
    table: &mut Table,
    heading: &Heading,
    rows: &Rows,
    reading: &mut Reading,
) -> Result<(), ReadError> {
    let Table { block, titles, .. } = table;
    let values = rows.values;
    let says_nm = block.columns[rows.axis_column].nanometres > 0;
    let axis_title = titles.whole(rows.axis_column);
    let stem = heading.name.unwrap_or(file.input.stem());
    let is_whole = rows.run.len() == block.rows();
    let scale = Scale::new(&rows.axis[rows.run.clone()]);
    for (column, name) in values.iter().zip(rows.names) {
        let of_column = &mut block.values[*column];
        // A long column is moved, not copied.
        let of_column = match is_whole {
            true => std::mem::take(of_column),
            false => of_column[rows.run.clone()].to_vec(),
        };
        // A column that is empty in this part of the table is no spectrum; others still are.
        if values.len() > 1 && !has_values(&of_column) {
            reading.notes.push(no_table::empty_column(*column));
            continue;
        }
        let name = match (rows.sample, name.is_empty()) {
            (Some(sample), true) => format!("{sample}{}", rows.part),
            (Some(sample), false) => format!("{sample} {name}{}", rows.part),
            (None, _) => name_with_part(stem, name, &rows.part),
        };
        let title = match &block.columns[*column].unit {
            _ if rows.is_rgb => String::new(),
            Some(unit) => format!("{} [{unit}]", titles.whole(*column)),
            None => titles.whole(*column),
        };
        let raw = RawSpectrum {
            title,
            lines: block.lines.get(rows.run.clone()).unwrap_or(&[]),
            notes: said_of_limits(block.columns[*column].limits)
                .into_iter()
                .collect(),
            percent_signs: block.columns[*column].percents > 0,
            ..RawSpectrum::written(name, &scale, &axis_title, of_column, heading)
        };
        let raw = raw
            .saying_nm(says_nm)
            .with_comma(file.dialect.decimal_comma);
        interpret(raw, file.input, reading)?;
    }
    Ok(())
}

/// Names of columns that all have one title, or where each has wavelengths of its own a title that
/// only says what is measured, from the line above their titles: a sample's name over its values, or
/// over the wavelengths to the left of them. `None` where none tells them apart.
fn names_above(
    block: &Block,
    dialect: Dialect,
    (titles, are_pairs): (&Titles, bool),
    values: &[usize],
) -> Option<Vec<String>> {
    let title = |column: &usize| titles.names[*column].trim();
    let first = title(values.first()?);
    let tells_nothing =
        |column: &usize| title(column) == first || are_pairs && is_generic(title(column));
    if values.len() < 2 || first.is_empty() || !values.iter().all(tells_nothing) {
        return None;
    }
    let mut lines = block.header.iter().rev().map(|(_, line)| *line).take(6);
    lines.find(|line| line.contains(first))?;
    let cells = dialect.cells(lines.next()?);
    let mut left = 0;
    let mut names: Vec<String> = Vec::with_capacity(values.len());
    let mut seen = HashSet::new();
    for column in values {
        let over = (left..=*column).rev().filter_map(|at| cells.get(at));
        let mut filled = over.map(|cell| cell.trim().trim_matches('"').trim());
        let name = filled.find(|cell| !cell.is_empty())?;
        names.push(seen.insert(name).then(|| name.to_owned())?);
        left = column + 1;
    }
    Some(names)
}

/// True if columns are a camera's or a display's R, G and B: then R is no reflectance.
fn are_rgb(titles: &Titles, values: &[usize]) -> bool {
    ["r", "g", "b"].iter().all(|letter| {
        let mut names = values.iter().map(|column| titles.names[*column].trim());
        names.any(|name| name.eq_ignore_ascii_case(letter))
    })
}

/// Title of one of several value columns, else its number in the file; empty for the only one, which
/// is called after the file: of a folder of files with a column each all have the same title.
fn column_name(titles: &Titles, column: usize, columns: usize) -> String {
    let title = titles.names[column].trim();
    match (title.is_empty(), columns) {
        (_, 1) => String::new(),
        (true, _) => format!("column {}", column + 1),
        (false, _) => title.to_owned(),
    }
}

/// True if a title names only the kind of value below it.
fn is_generic(title: &str) -> bool {
    kinds::kind_of_title(title).is_some()
        || title.len() == 1
        || roles::is_processed(title)
        || names_wavelength(title)
        || ["value", "values", "data", "measured"].contains(&title.to_lowercase().as_str())
}

fn name_with_part(stem: &str, name: &str, part: &str) -> String {
    match (name.is_empty(), name.starts_with("column ")) {
        (true, _) => format!("{stem}{part}"),
        (false, true) => format!("{stem}, {name}{part}"),
        (false, false) => format!("{name}{part}"),
    }
}
