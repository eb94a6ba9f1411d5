//! Excel workbooks `.xlsx`: each sheet a table of plain columns.
//!
//! A sheet's cells are read like every table, a row a line, with a known separator
//! ([`Dialect::SHEET`]); so lines in messages are rows of the sheet. Columns without
//! numbers (pictures' captions, disclaimers beside the table) are left out and their texts noted.
//! Everything in the archive is unpacked once to count it before the workbook is opened; cells are
//! read one by one, so that a lone cell far down costs nothing.

use std::collections::BTreeMap;
use std::io::Cursor;

use calamine::{DataRef, Reader, SheetVisible, Xlsx};

use super::{Confidence, Format};
use crate::io::decode::archive::{Archive, seems_to_hold};
use crate::io::decode::guarded::guarded;
use crate::io::table::read::read_tables;
use crate::io::text::dialect::Dialect;
use crate::io::text::number::{self, Cell as Number};
use crate::io::{Choices, Input, ReadError, Reading, budget};
use crate::languages::said;

pub(crate) const FORMAT: Format =
    Format::new(later!("Excel workbook"), &["xlsx", "xlsm"], sniff, read);

/// Shares of the memory that parts of the archive ([`part_of`]) may unpack to, by their memory once
/// the workbook is opened: sheets are streamed, a text of 5 bytes takes 24, a style hundreds.
const SHARES: [f64; 3] = [1.0, 0.1, 0.03];

/// Folders of members read piece by piece or not at all.
const STREAMED: [&str; 5] = [
    "worksheets/",
    "charts/",
    "media/",
    "drawings/",
    "printersettings/",
];

/// The place in [`SHARES`] of a member: 0 if streamed, 1 for the workbook's list of texts, 2 if
/// kept in memory (styles, names of sheets, links).
fn part_of(name: &str) -> usize {
    let name = name.to_lowercase();
    let is_streamed = || STREAMED.iter().any(|folder| name.contains(folder));
    match () {
        () if name.contains("sharedstrings") => 1,
        () if is_streamed() && !name.ends_with(".rels") => 0,
        () => 2,
    }
}

/// Memory of a cell on its way, in bytes.
const CELL_BYTES: usize = 120;

/// Fewest numbers in a column of a table.
const FEWEST_NUMBERS: usize = 2;

/// Most texts beside the table that are noted.
const MOST_NOTED: usize = 6;

fn sniff(input: &Input) -> Confidence {
    let bytes = input.bytes;
    let holds = |name| seems_to_hold(bytes, name);
    Confidence::certain_if(holds("xl/workbook") || holds("xl/worksheets"))
}

/// A cell as text, marked if it is a number.
struct Cell {
    text: String,
    is_number: bool,
    /// True if it is a number that was typed as text with a decimal comma.
    had_comma: bool,
}

impl Cell {
    /// A cell; numbers that were typed as text are numbers, with a decimal comma too, or with their
    /// unit.
    fn of(text: String, is_number: bool) -> Self {
        let cell = number::parse(&text, false);
        let has_unit = matches!(cell, Number::Nanometres(_) | Number::WithUnit(_));
        let is_number = is_number || has_unit || text.parse::<f64>().is_ok();
        let with_comma = number::number(&text, true).filter(|_| !is_number);
        Self {
            is_number: is_number || with_comma.is_some(),
            had_comma: with_comma.is_some(),
            text: with_comma.map_or(text, |value| format!("{value:?}")),
        }
    }
}

/// Cells by row and column.
type Sheet = BTreeMap<(u32, u32), Cell>;

fn read(input: &Input) -> Result<Reading, ReadError> {
    for (part, share) in SHARES.into_iter().enumerate() {
        Archive::open(input, share)?.count(|name| part_of(name) == part)?;
    }
    let (sheets, hidden) =
        guarded(|| sheets(input)).ok_or_else(|| broken(input, "unreadable"))??;
    let mut reading = Reading::default();
    let mut refusals = Vec::new();
    let several = sheets.iter().filter(|(_, sheet)| !sheet.is_empty()).count() > 1;
    for (title, sheet) in &sheets {
        let (text, aside) = table_of(input, sheet)?;
        if text.trim().is_empty() {
            continue;
        }
        // The user's choices for a sheet concern the meaning of its numbers.
        let choices = Choices {
            axis_column: None,
            ..input.choices.from(reading.spectra.len())
        };
        let as_text = Input::new(&input.name, text.as_bytes()).deciding(&choices);
        match read_tables(&as_text, &text, Some(Dialect::SHEET)) {
            Ok(one) => {
                let first = reading.spectra.len();
                for mut spectrum in one.spectra {
                    if several {
                        spectrum.name = format!("{title}: {}", spectrum.name);
                    }
                    spectrum.notes.extend(aside.iter().cloned());
                    reading.spectra.push(spectrum);
                }
                for mut guess in one.guesses {
                    guess.spectrum += first;
                    reading.guesses.push(guess);
                }
                reading.facts.extend(one.facts);
                reading.notes.extend(one.notes);
            }
            Err(refusal) => refusals.push((title, refusal)),
        }
    }
    if reading.spectra.is_empty() {
        let nothing = || {
            input.error(
                said!("a workbook without cells"),
                said!("a sheet with a table"),
            )
        };
        let first = refusals.into_iter().next().map(|(_, why)| why);
        return Err(first.unwrap_or_else(nothing));
    }
    let hidden = hidden.iter().take(MOST_NOTED);
    let unread = |title: &String| tr!("sheet {title} is hidden and was not read", title);
    reading.notes.extend(hidden.map(unread));
    let refusals = refusals.iter().take(MOST_NOTED);
    let left_out = |(title, why): &(_, ReadError)| {
        tr!(
            "sheet {title} left out: found {found}",
            title,
            found = why.found
        )
    };
    reading.notes.extend(refusals.map(left_out));
    Ok(reading)
}

fn broken(input: &Input, why: &str) -> ReadError {
    input.error(tr!("a broken workbook ({why})", why), said!("a whole one"))
}

/// The visible sheets by their names, and the names of the hidden ones.
type Sheets = (Vec<(String, Sheet)>, Vec<String>);

fn sheets(input: &Input) -> Result<Sheets, ReadError> {
    let broken = |error: calamine::XlsxError| broken(input, &error.to_string());
    let too_many = || {
        input.error(
            said!("far more cells than its size allows"),
            said(budget::WORDS),
        )
    };
    let mut book = Xlsx::new(Cursor::new(input.bytes)).map_err(broken)?;
    let mut left = budget::of(input.bytes.len()) / 2;
    let mut sheets = Vec::new();
    // Hidden sheets are not part of the data passed on.
    let all = book.sheets_metadata().iter().cloned();
    let (shown, hidden): (Vec<_>, Vec<_>) =
        all.partition(|sheet| sheet.visible == SheetVisible::Visible);
    for name in shown.into_iter().map(|sheet| sheet.name) {
        // Sheets of charts have no cells.
        let Ok(mut cells) = book.worksheet_cells_reader(&name) else {
            continue;
        };
        let mut sheet = Sheet::new();
        while let Some(cell) = cells.next_cell().map_err(broken)? {
            let (text, is_number) = match cell.get_value() {
                DataRef::Int(value) => (value.to_string(), true),
                DataRef::Float(value) => (format!("{value:?}"), true),
                DataRef::String(text) => (flat(text), false),
                DataRef::SharedString(text) => (flat(text), false),
                _ => continue,
            };
            if text.is_empty() {
                continue;
            }
            left = left
                .checked_sub(CELL_BYTES + text.len())
                .ok_or_else(too_many)?;
            sheet.insert(cell.get_position(), Cell::of(text, is_number));
        }
        sheets.push((name, sheet));
    }
    Ok((sheets, hidden.into_iter().map(|sheet| sheet.name).collect()))
}

/// A text on one line, without tabs.
fn flat(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The columns with numbers, a row a line with a TAB at the edge of each cell, and notes of the
/// texts beside them.
fn table_of(input: &Input, sheet: &Sheet) -> Result<(String, Vec<String>), ReadError> {
    let mut numbers: BTreeMap<u32, usize> = BTreeMap::new();
    for ((_, column), cell) in sheet {
        *numbers.entry(*column).or_default() += usize::from(cell.is_number);
    }
    numbers.retain(|_, count| *count >= FEWEST_NUMBERS);
    let places: BTreeMap<u32, usize> = numbers.into_keys().zip(0..).collect();
    let most = budget::of(input.bytes.len()) / 8;
    let far = || {
        input.error(
            said!("a sheet far larger than its file"),
            said(budget::WORDS),
        )
    };
    let (mut text, mut aside) = (String::new(), Vec::new());
    let (mut row, mut place) = (0, 0);
    for ((cell_row, column), cell) in sheet {
        let Some(cell_place) = places.get(column) else {
            if aside.len() < MOST_NOTED {
                aside.push(tr!("beside the table: {text}", text = cell.text));
            }
            continue;
        };
        // Rows without cells are lines too, and a cell may claim any position.
        let lines = (*cell_row - row) as usize;
        if text.len().saturating_add(lines) > most {
            return Err(far());
        }
        if lines > 0 {
            text.extend(std::iter::repeat_n('\n', lines));
            (row, place) = (*cell_row, 0);
        }
        text.extend(std::iter::repeat_n('\t', cell_place - place));
        place = *cell_place;
        text.push_str(&cell.text);
        if text.len() > most {
            return Err(far());
        }
    }
    text.push('\n');
    let commas = sheet.values().filter(|cell| cell.had_comma).count();
    if commas > 0 {
        aside.push(tr!("numbers typed as text with a decimal comma: {n} cells"
            | "numbers typed as text with a decimal comma: {n} cells" % commas));
    }
    Ok((text, aside))
}
