//! From a text to the spectra of its tables.
//!
//! [`pick`] finds delimiter and decimal mark, [`block`](super::block) the blocks of numbers,
//! [`titles`](super::titles) and [`layout`](super::layout) where the wavelengths are,
//! [`roles`] which columns are spectra, and [`interpret`](crate::io::interpret::interpret()) what
//! the values stand for. Each decision is a note, each guess an [`OpenQuestion`].

use super::block::{BadCell, Block, NoTable, most_left_out};
use super::columns::{File, read_groups};
use super::layout::Layout;
use super::pick::{self, Table};
use super::roles::{self, Group};
use super::rows::read_rows;
use super::{alternating, folded, marks, no_table};
use crate::io::interpret::check_room;
use crate::io::reading::TableFound;
use crate::io::text::dialect::{Delimiter, Dialect, used};
use crate::io::{Guessed, Input, OpenQuestion, ReadError, Reading};
use crate::languages::said;

/// The spectra of all tables of a text; how their cells are set apart is found where it is not
/// known, and not told.
pub(crate) fn read_tables(
    input: &Input,
    text: &str,
    known: Option<Dialect>,
) -> Result<Reading, ReadError> {
    let plain = match known {
        Some(_) => None,
        None => marks::made_plain(input, text, pick::sample(text))?,
    };
    let Some(plain) = plain else {
        return read_plain(input, text, known);
    };
    let mut reading = read_plain(input, &plain.text, known)?;
    if plain.is_doubtful {
        let chosen = said!("marks by the other numbers").to_owned();
        reading.guesses.push(doubt(0, chosen, plain.note.clone()));
    }
    reading.notes.push(plain.note);
    Ok(reading)
}

/// The same where no mark in a number misleads.
fn read_plain(input: &Input, text: &str, known: Option<Dialect>) -> Result<Reading, ReadError> {
    let look = match known {
        Some(dialect) => (dialect, text),
        None => pick::look(text, input.choices.delimiter),
    };
    let dialect = look.0;
    let mut tables = match pick::tables_of(text, look) {
        Ok(tables) => tables,
        // A table with a word in it is a table: read in another way it would be nonsense.
        Err(bad @ NoTable::Bad(_)) => return Err(no_table::refusal(input, text, bad)),
        Err(why) => {
            if let Some(pairs) = alternating::find(text) {
                return alternating::read(input, &pairs);
            }
            return Err(no_table::refusal(input, text, why));
        }
    };
    let file = File { input, dialect };
    check_room(input, tables.len())?;
    let left_out = without_false_tables(&file, &mut tables);
    if let Some(column) = input.choices.axis_column {
        for table in tables.iter_mut().filter(|table| !table.is_short) {
            if column >= table.block.width {
                return Err(no_table::no_such_column(input, table.block.width, column));
            }
            table.layout = Layout::Column(column);
        }
    }
    let mut reading = Reading {
        notes: left_out,
        table: tables.iter().find(|t| !t.is_short).map(|table| TableFound {
            dialect,
            axis_column: match table.layout {
                Layout::Column(column) => Some(column),
                Layout::Row(_) => None,
            },
            width: table.block.width,
            first_line: table.block.lines[0] as usize,
            values: Vec::new(),
        }),
        ..Reading::default()
    };
    let several = tables.len() > 1;
    for (number, table) in tables.iter_mut().enumerate() {
        let part = match several {
            true => format!(", table {}", number + 1),
            false => String::new(),
        };
        read_table(&file, table, &part, &mut reading)?;
    }
    // Columns and rows that are nearly empty were left out; here that was all of them.
    if reading.spectra.is_empty() {
        let of = match tables[0].layout {
            Layout::Row(_) => "row",
            Layout::Column(_) => "column",
        };
        let first = tables[0].block.lines[0] as usize;
        return Err(no_table::too_sparse(input, of, first));
    }
    Ok(reading)
}

/// Leaves out short tables that turn out to be none, and says so.
fn without_false_tables(file: &File, tables: &mut Vec<Table>) -> Vec<String> {
    let mut left_out = Vec::new();
    tables.retain(|table| {
        let read = || read_table(file, &mut table.clone(), "", &mut Reading::default());
        let Some(why) = table.is_short.then(read).and_then(Result::err) else {
            return true;
        };
        let lines = pick::lines_left_out(&table.block);
        left_out.push(tr!("{lines}: found {found}", lines, found = why.found));
        false
    });
    left_out
}

fn read_table(
    file: &File,
    table: &mut Table,
    part: &str,
    reading: &mut Reading,
) -> Result<(), ReadError> {
    reading.notes.extend(table.block.notes.iter().cloned());
    let first = reading.spectra.len();
    let short = titles_short_of_cells(table, file.dialect);
    if let Layout::Column(mut wavelength) = table.layout {
        let (mut groups, mut left_out) = roles::groups(&table.block, &table.titles, wavelength);
        if file.input.choices.take_sigma {
            roles::keep_spreads(&mut groups, &mut left_out);
        }
        if let Some((unfolded, note)) = folded::unfold(table, &groups, wavelength) {
            reading.notes.push(note);
            *table = unfolded;
            (wavelength, left_out) = (0, Vec::new());
            let (axis, values) = (0, vec![1]);
            groups = vec![Group { axis, values }];
        }
        let values: Vec<usize> = groups.iter().flat_map(|g| g.values.clone()).collect();
        let is_axis = |column| groups.iter().any(|group| group.axis == column);
        let is_used = |column| column == wavelength || is_axis(column) || values.contains(&column);
        let notes = without_words(file.input, &table.block, is_used, !values.is_empty())?;
        reading.notes.extend(notes);
        if let Some(found) = &mut reading.table
            && found.values.is_empty()
            && !table.is_short
        {
            found.values = values;
        }
        read_groups(file, table, &groups, part, left_out, reading)?;
    } else if let Layout::Row(along) = &table.layout {
        read_rows(file, table, along, reading)?;
    }
    if let Some(because) = short
        && first < reading.spectra.len()
    {
        let chosen = file.dialect.words();
        reading.guesses.push(doubt(first, chosen, because));
    }
    Ok(())
}

/// The question how a spectrum's table is taken apart.
fn doubt(spectrum: usize, chosen: String, because: String) -> OpenQuestion {
    OpenQuestion {
        spectrum,
        what: Guessed::Columns,
        chosen,
        because,
        plain: false,
    }
}

/// Refuses words among the numbers of the columns that count, and a table without values. Where a
/// column is all numbers but for a word or two, these are gaps, and said.
pub(crate) fn without_words(
    input: &Input,
    block: &Block,
    counts: impl Fn(usize) -> bool,
    has_values: bool,
) -> Result<Vec<String>, ReadError> {
    let most = most_left_out(block.rows());
    let bad = block.bad.iter().filter(|bad| counts(bad.column));
    let (few, many): (Vec<&BadCell>, Vec<&BadCell>) =
        bad.partition(|bad| block.columns[bad.column].texts <= most);
    if let Some(bad) = many.into_iter().min_by_key(|bad| bad.line) {
        return Err(bad.refusal(input));
    }
    if !has_values {
        return Err(input
            .error(
                said!(
                    "wavelengths and no values (empty cells, words such as NaN and numbers of \
                     1e30 and beyond count as missing)"
                ),
                said(no_table::A_TABLE),
            )
            .at_line(block.lines[0] as usize));
    }
    Ok(few.into_iter().map(|bad| bad.left_out("cell")).collect())
}

/// The evidence against commas between the cells of a table: fewer titles than numbers in each row,
/// as with decimal commas without quotes.
fn titles_short_of_cells(table: &Table, dialect: Dialect) -> Option<String> {
    let block = &table.block;
    let (line, titles) = block.header.last()?;
    let cells = dialect.cells(titles);
    let count = used(&cells);
    let is_title = |cell: &&str| cell.contains(char::is_alphabetic);
    (dialect.delimiter == Delimiter::Comma
        && !dialect.decimal_comma
        && !block.has_row_names()
        && (2..block.width).contains(&count)
        && cells[..count].iter().all(is_title)
        && block.columns[count..]
            .iter()
            .all(|column| column.numbers > 0))
    .then(|| {
        tr!(
            "line {line} has {titles} titles and the rows {cells} cells; commas may mark decimals",
            line,
            titles = count,
            cells = block.width
        )
    })
}
