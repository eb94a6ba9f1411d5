//! Plain columns: CSV, TSV and whatever else writes wavelengths and values as text.
//!
//! Nothing about the table is taken from the extension. [`pick`] finds delimiter and
//! decimal mark, [`table`](super::table) the blocks of numbers, [`titles`](super::titles) and
//! [`layout`] where the wavelengths are, [`meaning`](super::meaning) what the
//! values stand for, [`curve`](super::curve) puts them in order. Each decision is a note, each
//! guess a [`Guess`](super::Guess).

use std::collections::HashSet;

use super::alternating;
use super::dialect::Dialect;
use super::draft::{Draft, header_field};
use super::error::quoted;
use super::layout::{self, Layout};
use super::pick::{self, NoTable, Table};
use super::roles::{self, value_columns};
use super::rows::{AlongRow, read_rows};
use super::table::{BadCell, MOST_COLUMNS, TooMuch};
use super::text::lines;
use super::titles::Titles;
use super::{Confidence, Format, Input, ReadError, Reading, budget, csv, reading::TableFound};

/// Plain columns of numbers.
pub const FORMAT: Format = Format {
    name: "plain columns",
    extensions: &["csv", "tsv", "txt", "dat", "asc", "prn"],
    sniff,
    read,
};

/// Longest line that may be a row of a table, in bytes; a longer one is said to be too long.
const LONGEST_ROW: usize = 1 << 20;

/// What a refusal asks for.
const A_TABLE: &str = "two or more columns of numbers: wavelengths and values";

fn sniff(input: &Input) -> Confidence {
    match input.text() {
        Some(_) if csv::is_own(input.head()) => Confidence::Own,
        Some(_) => Confidence::Possible,
        None => Confidence::No,
    }
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let dialect = input.choices.dialect.unwrap_or_else(|| pick::dialect(text));
    let mut tables = match pick::tables(text, dialect) {
        Ok(tables) => tables,
        // A table with a word in it is a table: read in another way it would be nonsense.
        Err(bad @ NoTable::Bad(_)) => return Err(refusal(input, text, bad)),
        Err(no_table) => {
            if let Some(pairs) = alternating::find(text) {
                return alternating::read(input, &pairs);
            }
            return Err(refusal(input, text, no_table));
        }
    };
    let mut reading = Reading {
        table: tables.first().map(|table| TableFound {
            dialect,
            axis_column: match table.layout {
                Layout::Column(column) => Some(column),
                Layout::Row { .. } => None,
            },
            width: table.block.width,
            first_line: table.block.lines[0] as usize,
            values: Vec::new(),
        }),
        ..Reading::default()
    };
    let several = tables.len() > 1;
    if let Some(column) = input.choices.axis_column {
        for table in &mut tables {
            if column >= table.block.width {
                return Err(input.error(
                    format!("a table of {} columns", table.block.width),
                    format!("wavelengths in column {}, as chosen", column + 1),
                ));
            }
            table.layout = Layout::Column(column);
        }
        if let Some(found) = &mut reading.table {
            found.axis_column = Some(column);
        }
    }
    for (number, table) in tables.iter_mut().enumerate() {
        let part = if several {
            format!(", table {}", number + 1)
        } else {
            String::new()
        };
        read_table(input, text, dialect, table, &part, &mut reading)?;
    }
    // Columns and rows that are nearly empty were left out; here that was all of them.
    if reading.spectra.is_empty() {
        return Err(too_sparse(input, &tables));
    }
    reading.notes.push(dialect.words());
    Ok(reading)
}

/// The refusal for a word among numbers.
pub fn bad_cell(input: &Input, bad: &BadCell) -> ReadError {
    input
        .error(
            quoted(&bad.text),
            format!("a number in column {}", bad.column + 1),
        )
        .at_line(bad.line)
}

fn refusal(input: &Input, text: &str, why: NoTable) -> ReadError {
    match why {
        NoTable::TooMany(TooMuch::Cells { line }) => input
            .error("more than 64 million numbers", "a smaller table")
            .at_line(line),
        NoTable::TooMany(TooMuch::Columns { line, found }) => input
            .error(
                format!("{found} columns"),
                format!("at most {MOST_COLUMNS} columns"),
            )
            .at_line(line),
        NoTable::Bad(bad) => bad_cell(input, &bad),
        NoTable::NoWavelengths {
            line,
            step_back: None,
        } => input
            .error(
                "numbers with no wavelengths among them",
                "a column or row of wavelengths that rises or falls throughout",
            )
            .at_line(line),
        NoTable::NoWavelengths {
            step_back: Some((line, found, after)),
            ..
        } => input
            .error(
                format!("{found} after {after} in column 1"),
                "wavelengths that rise or fall throughout",
            )
            .at_line(line),
        NoTable::NoRows => match alternating::lone_numbers(text) {
            Some((count, line)) => input
                .error(
                    format!("{count} lines of one number each"),
                    "a wavelength beside each value",
                )
                .at_line(line),
            None => {
                let first = lines(text).find(|(_, l)| !l.trim().is_empty());
                if let Some((line, long)) = first.filter(|(_, l)| l.len() > LONGEST_ROW) {
                    return input
                        .error(
                            format!("a line of {}", budget::in_words(long.len())),
                            format!("rows of at most {MOST_COLUMNS} columns"),
                        )
                        .at_line(line);
                }
                let (line, found) = first.map_or((1, String::new()), |(n, l)| (n, quoted(l)));
                let found = if found.is_empty() {
                    "blank lines".to_owned()
                } else {
                    format!("no table after {found}")
                };
                input.error(found, A_TABLE).at_line(line)
            }
        },
    }
}

/// The refusal for tables whose every column or row has next to no values.
fn too_sparse(input: &Input, tables: &[Table]) -> ReadError {
    let of = match tables.first().map(|table| &table.layout) {
        Some(Layout::Row { .. }) => "row",
        _ => "column",
    };
    let refusal = input.error(
        format!("fewer than two values in every {of}"),
        "at least two values of a spectrum",
    );
    match tables.first().and_then(|table| table.block.lines.first()) {
        Some(line) => refusal.at_line(*line as usize),
        None => refusal,
    }
}

fn read_table(
    input: &Input,
    text: &str,
    dialect: Dialect,
    table: &mut Table,
    part: &str,
    reading: &mut Reading,
) -> Result<(), ReadError> {
    reading.notes.extend(table.notes.iter().cloned());
    match &table.layout {
        Layout::Column(wavelength) => {
            let wavelength = *wavelength;
            let axis = table.block.column(wavelength).to_vec();
            let runs = layout::runs(&axis);
            let several = runs.len() > 1;
            for (number, run) in runs.into_iter().enumerate() {
                let run_part = if several {
                    format!("{part}, part {}", number + 1)
                } else {
                    part.to_owned()
                };
                let rows = Rows {
                    wavelength,
                    run,
                    part: run_part,
                };
                read_columns(input, dialect, table, &axis, &rows, reading)?;
            }
            Ok(())
        }
        Layout::Row {
            first,
            axis,
            from_row,
            says_nm,
        } => {
            let row = AlongRow {
                first: *first,
                axis,
                from_row: *from_row,
                says_nm: *says_nm,
            };
            read_rows(input, text, dialect, table, &row, reading)
        }
    }
}

/// A run of rows under one wavelength column.
struct Rows {
    wavelength: usize,
    run: std::ops::Range<usize>,
    part: String,
}

fn read_columns(
    input: &Input,
    dialect: Dialect,
    table: &mut Table,
    axis: &[f64],
    rows: &Rows,
    reading: &mut Reading,
) -> Result<(), ReadError> {
    let Table { block, titles, .. } = table;
    let (values, left_out) = value_columns(block, titles, rows.wavelength);
    if let Some(bad) = block
        .bad
        .iter()
        .filter(|bad| bad.column == rows.wavelength || values.contains(&bad.column))
        .min_by_key(|bad| bad.line)
    {
        return Err(bad_cell(input, bad));
    }
    if values.is_empty() {
        return Err(input
            .error(
                "wavelengths and no values (empty cells, words such as NaN and numbers of 1e30 \
                 and beyond count as missing)",
                A_TABLE,
            )
            .at_line(block.lines[0] as usize));
    }
    if let Some(found) = &mut reading.table
        && found.values.is_empty()
    {
        found.values.clone_from(&values);
    }
    let says_nm = block.columns[rows.wavelength].nanometres > 0;
    let title = titles.whole(rows.wavelength);
    let stem = header_field(&block.header, "name:").unwrap_or(input.stem());
    let is_whole = rows.run.len() == block.rows();
    let is_rgb = are_rgb(titles, &values);
    let above = names_above(block, dialect, titles, &values);
    let axes = roles::other_axes(block, titles, rows.wavelength, &values);
    let mut paired = Vec::new();
    for (number, column) in values.iter().enumerate() {
        let own_axis = roles::axis_of(&axes, rows.wavelength, *column);
        let own_numbers = (own_axis != rows.wavelength).then(|| block.column(own_axis).to_vec());
        if own_numbers.is_some() {
            paired.push((own_axis, *column));
        }
        let of_column = &mut block.values[*column];
        // A long column is moved, not copied.
        let of_column = if is_whole {
            std::mem::take(of_column)
        } else {
            of_column[rows.run.clone()].to_vec()
        };
        let name = match above.get(number) {
            Some(name) => name.clone(),
            None => column_name(titles, *column, values.len()),
        };
        let draft = Draft {
            name: name_with_part(stem, &name, &rows.part),
            title: if is_rgb {
                String::new()
            } else {
                titles.whole(*column)
            },
            axis_title: match own_numbers {
                Some(_) => titles.whole(own_axis),
                None => title.clone(),
            },
            says_nm,
            header: &block.header,
            axis: &own_numbers.as_deref().unwrap_or(axis)[rows.run.clone()],
            values: of_column,
            lines: block.lines.get(rows.run.clone()).unwrap_or(&[]),
            percent_signs: block.columns[*column].percents > 0,
            decimal_comma: dialect.decimal_comma,
        };
        // A column that is empty in this part of the table is no spectrum; others still are.
        if values.len() > 1 && draft.values.iter().filter(|v| !v.is_nan()).count() < 2 {
            reading.notes.push(format!(
                "column {} holds no values and was left out",
                column + 1
            ));
            continue;
        }
        draft.finish(input, reading)?;
    }
    for (axis, column) in &paired {
        let of = format!(
            "column {} has its wavelengths in column {}",
            column + 1,
            axis + 1
        );
        reading.notes.push(of);
    }
    let is_used = |note: &String| {
        let starts = |axis: usize| note.starts_with(&format!("column {} ", axis + 1));
        note.ends_with(roles::SECOND_AXIS) && paired.iter().any(|(axis, _)| starts(*axis))
    };
    for note in left_out.into_iter().filter(|note| !is_used(note)) {
        if !reading.notes.contains(&note) {
            reading.notes.push(note);
        }
    }
    Ok(())
}

/// Names of columns that all have one title, from the line above their titles: a sample's name over
/// its values, or over the wavelengths to the left of them. Empty where none tells them apart.
fn names_above(
    block: &super::table::Block,
    dialect: Dialect,
    titles: &Titles,
    values: &[usize],
) -> Vec<String> {
    let title = |column: &usize| titles.names[*column].trim();
    let (Some(first), true) = (values.first(), values.len() > 1) else {
        return Vec::new();
    };
    if title(first).is_empty() || values.iter().any(|column| title(column) != title(first)) {
        return Vec::new();
    }
    let mut cells = Vec::new();
    let mut lines = block.header.iter().rev().map(|(_, line)| *line).take(6);
    if !lines.any(|line| line.contains(title(first))) {
        return Vec::new();
    }
    let Some(line) = lines.next() else {
        return Vec::new();
    };
    dialect.split(line, &mut cells);
    let mut left = 0;
    let mut names: Vec<String> = Vec::with_capacity(values.len());
    let mut seen = HashSet::new();
    for column in values {
        let over = (left..=*column).rev().filter_map(|at| cells.get(at));
        let mut filled = over.map(|cell| cell.trim().trim_matches('"').trim());
        match filled.find(|cell| !cell.is_empty()) {
            Some(name) if seen.insert(name) => names.push(name.to_owned()),
            _ => return Vec::new(),
        }
        left = column + 1;
    }
    names
}

/// Whether columns are a camera's or a display's R, G and B: then R is no reflectance.
fn are_rgb(titles: &Titles, values: &[usize]) -> bool {
    ["r", "g", "b"].iter().all(|letter| {
        let mut names = values.iter().map(|column| titles.names[*column].trim());
        names.any(|name| name.eq_ignore_ascii_case(letter))
    })
}

/// Title of a value column where it says more than what kind of value it is, else its number in
/// the file: the same by which its other columns are called.
fn column_name(titles: &Titles, column: usize, columns: usize) -> String {
    let title = titles.names[column].trim();
    let generic = super::kinds::kind_of_title(title).is_some()
        || title.len() == 1
        || roles::is_processed(title)
        || super::units::names_wavelength(title)
        || ["value", "values", "data", "measured"].contains(&title.to_lowercase().as_str());
    match (title.is_empty(), columns) {
        (true, 1) => String::new(),
        (true, _) => format!("column {}", column + 1),
        (false, 1) if generic => String::new(),
        (false, _) => title.to_owned(),
    }
}

fn name_with_part(stem: &str, name: &str, part: &str) -> String {
    match (name.is_empty(), name.starts_with("column ")) {
        (true, _) => format!("{stem}{part}"),
        (false, true) => format!("{stem}, {name}{part}"),
        (false, false) => format!("{name}{part}"),
    }
}

#[cfg(test)]
mod tests {
    use crate::io::read_bytes;
    use crate::spectrum::Kind;

    #[test]
    fn the_r_of_rgb_is_no_reflectance() {
        let text = b"nm,R,G,B\n400,0.1,0.2,0.3\n410,0.2,0.3,0.4\n420,0.3,0.4,0.5\n";
        let spectra = read_bytes("a.csv", text).unwrap().spectra;
        assert!(spectra.iter().all(|s| s.kind == Kind::Light), "{spectra:?}");
        assert_eq!(spectra[0].name, "R");
        let alone = b"nm,R\n400,0.1\n410,0.2\n420,0.3\n";
        let leaf = &read_bytes("a.csv", alone).unwrap().spectra[0];
        assert_eq!(leaf.kind, Kind::Reflectance);
    }

    #[test]
    fn columns_of_one_title_are_named_by_the_line_above() {
        for text in [
            "WP,first,second\nWavelength,Processed,Processed\n400,1,2\n410,3,4\n420,5,6\n",
            "first,,second,,\nWavelength (nm),%T,Wavelength (nm),%T,\n400,1,400,2,\n410,3,410,4,\n420,5,420,6,\n",
        ] {
            let spectra = read_bytes("a.csv", text.as_bytes()).unwrap().spectra;
            let names: Vec<&str> = spectra.iter().map(|s| s.name.as_str()).collect();
            assert_eq!(names, ["first", "second"], "{text}");
        }
    }

    #[test]
    fn pairs_side_by_side_have_wavelengths_of_their_own() {
        let text = b"nm,%T,nm,%T\n400,1,402,5\n410,2,412,6\n420,3,422,7\n,,432,8\n";
        let reading = read_bytes("a.csv", text).unwrap();
        let samples: Vec<_> = reading.spectra.iter().map(|s| &s.samples).collect();
        assert_eq!(samples[0].nm(), [400.0, 410.0, 420.0]);
        assert_eq!(samples[1].nm(), [402.0, 412.0, 422.0, 432.0]);
        let said = "has its wavelengths in column";
        assert!(
            reading.notes.iter().any(|note| note.contains(said)),
            "{reading:?}"
        );
    }

    #[test]
    fn the_other_end_of_a_band_is_no_axis_of_its_own() {
        let text = b"wl_min,wl_max,E,F\n400,401,1,5\n401,402,2,6\n402,403,3,7\n";
        let spectra = read_bytes("a.csv", text).unwrap().spectra;
        assert!(
            spectra.iter().all(|s| s.samples.first_nm() == 400.0),
            "{spectra:?}"
        );
    }
}
