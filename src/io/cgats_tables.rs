//! The tables of a CGATS text: keywords, fields, and the sets below them.
//!
//! Cells are set apart by blanks or TABs and may be quoted; a row may run over several lines. Rows
//! whose cells are set apart by TABs, semicolons or commas alone (blanks in names, empty cells)
//! are known by having one cell a field.

use super::error::quoted;
use super::number::{self, Cell};
use super::text::{kept_line, lines};
use super::{Input, ReadError};

/// Most keywords kept from one file.
const MOST_KEYS: usize = 10_000;

/// Most tables in one file.
const MOST_TABLES: usize = 1000;

/// One table.
#[derive(Debug, Default)]
pub struct CgatsTable<'a> {
    /// What its first line calls it: `SPECT`, `CTI3`, `CGATS.17`, ...; of the first table where a
    /// later one says nothing.
    pub kind: &'a str,
    /// Keywords and values, quotes removed, in file order.
    pub keys: Vec<(&'a str, &'a str)>,
    /// The names of the columns.
    pub fields: Vec<&'a str>,
    /// Line of `BEGIN_DATA_FORMAT`, from 1.
    pub format_line: usize,
    /// The columns kept as numbers, rising.
    pub number_columns: Vec<usize>,
    /// The columns kept as words, rising.
    pub word_columns: Vec<usize>,
    /// `number_columns` numbers a set; NaN where one is missing.
    pub numbers: Vec<f64>,
    /// `word_columns` words a set.
    pub words: Vec<&'a str>,
    /// First line of each set, from 1.
    pub lines: Vec<u32>,
    /// Whether decimals are marked by commas.
    pub decimal_comma: bool,
    /// What is odd, a sentence each.
    pub notes: Vec<String>,
}

impl<'a> CgatsTable<'a> {
    /// Number of sets.
    pub fn sets(&self) -> usize {
        self.lines.len()
    }

    /// The last value of a keyword.
    pub fn key(&self, key: &str) -> Option<&'a str> {
        self.keys
            .iter()
            .rev()
            .find(|(k, v)| k.eq_ignore_ascii_case(key) && !v.is_empty())
            .map(|(_, v)| *v)
    }

    /// The number that a keyword states.
    pub fn number(&self, key: &str) -> Option<f64> {
        let value = self.key(key)?;
        match (number::parse(value, false), number::parse(value, true)) {
            (Cell::Number(v), _) | (Cell::Text, Cell::Number(v)) => Some(v),
            _ => None,
        }
    }
}

/// Which columns are kept: as numbers, and as words.
pub type Wanted<'f> = &'f dyn Fn(&[&str]) -> (Vec<usize>, Vec<usize>);

enum State {
    Header,
    Fields,
    Data,
    /// Inside another `BEGIN_...`.
    Other(String),
}

/// Words set apart by blanks and TABs, quotes honoured and removed, up to a comment.
fn words<'a>(line: &'a str, out: &mut Vec<&'a str>) {
    out.clear();
    let mut rest = line.trim_start();
    while !rest.is_empty() && !rest.starts_with('#') {
        let (word, behind) = match rest.strip_prefix('"') {
            Some(inside) => match inside.find('"') {
                Some(end) => (&inside[..end], &inside[end + 1..]),
                None => (inside, ""),
            },
            None => {
                let end = rest.find([' ', '\t', '\u{a0}']).unwrap_or(rest.len());
                (&rest[..end], &rest[end..])
            }
        };
        out.push(word);
        rest = behind.trim_start();
    }
}

/// The cells of a row if some way of splitting it gives one a field.
fn cells<'a>(line: &'a str, fields: usize, out: &mut Vec<&'a str>) -> bool {
    for mark in ['\t', ';', ','] {
        if line.contains(mark) {
            out.clear();
            // One cell more may be an empty one at the end; two more are too many.
            let all = line.split(mark).map(|c| c.trim().trim_matches('"'));
            out.extend(all.take(fields + 2));
            if out.len() == fields + 1 && out.last().is_some_and(|c| c.is_empty()) {
                out.pop();
            }
            if out.len() == fields && fields > 1 {
                return true;
            }
        }
    }
    words(line, out);
    out.len() == fields
}

/// All tables of a text.
///
/// # Errors
/// [`ReadError`] for a word among the numbers, a row of the wrong length, or data without fields.
pub fn tables<'a>(
    input: &Input,
    text: &'a str,
    wanted: Wanted,
) -> Result<Vec<CgatsTable<'a>>, ReadError> {
    let mut done: Vec<CgatsTable> = Vec::new();
    let mut open = CgatsTable::default();
    let mut state = State::Header;
    let mut row: Vec<&str> = Vec::new();
    let mut pending: Vec<&str> = Vec::new();
    let mut pending_line = 0;
    for (line, content) in lines(text) {
        let content = content.trim();
        if content.is_empty() || content.starts_with('#') {
            continue;
        }
        match &state {
            State::Header => {
                words(content, &mut row);
                let Some(first) = row.first().copied() else {
                    continue;
                };
                match first {
                    "BEGIN_DATA_FORMAT" => {
                        open.fields.clear();
                        open.format_line = line;
                        state = State::Fields;
                        if take_fields(&row[1..], &mut open, wanted) {
                            state = State::Header;
                        }
                    }
                    "BEGIN_DATA" => {
                        if open.fields.is_empty() {
                            // A further table may go on with the fields of the one before.
                            let Some(before) = done.last() else {
                                return Err(input
                                    .error("BEGIN_DATA", "BEGIN_DATA_FORMAT before it")
                                    .at_line(line));
                            };
                            open.fields.clone_from(&before.fields);
                            open.number_columns.clone_from(&before.number_columns);
                            open.word_columns.clone_from(&before.word_columns);
                            open.format_line = before.format_line;
                        }
                        state = State::Data;
                    }
                    "KEYWORD" => {}
                    other if other.starts_with("BEGIN_") => {
                        state = State::Other(other.replacen("BEGIN_", "END_", 1));
                    }
                    key if row.len() == 1 && open.kind.is_empty() && open.keys.is_empty() => {
                        open.kind = key;
                    }
                    key => {
                        if open.keys.len() < MOST_KEYS {
                            let value = row.get(1).copied().unwrap_or("");
                            open.keys.push((key, value));
                        }
                    }
                }
            }
            State::Fields => {
                words(content, &mut row);
                if take_fields(&row, &mut open, wanted) {
                    state = State::Header;
                }
            }
            State::Data => {
                if content.starts_with("END_DATA") {
                    if !pending.is_empty() {
                        return Err(row_error(input, &open, pending.len(), pending_line));
                    }
                    close(&mut open, &mut done);
                    state = State::Header;
                    if done.len() >= MOST_TABLES {
                        return Err(input
                            .error(format!("more than {MOST_TABLES} tables"), "a smaller file")
                            .at_line(line));
                    }
                    continue;
                }
                let fields = open.fields.len();
                if pending.is_empty() {
                    if cells(content, fields, &mut row) {
                        take_row(input, &row, line, &mut open)?;
                    } else if row.len() > fields {
                        return Err(row_error(input, &open, row.len(), line));
                    } else {
                        pending.append(&mut row);
                        pending_line = line;
                    }
                    continue;
                }
                words(content, &mut row);
                if pending.len() + row.len() > fields {
                    return Err(row_error(input, &open, pending.len(), pending_line));
                }
                pending.append(&mut row);
                if pending.len() == fields {
                    let whole = std::mem::take(&mut pending);
                    take_row(input, &whole, pending_line, &mut open)?;
                }
            }
            State::Other(end) => {
                if content.starts_with(end.as_str()) {
                    state = State::Header;
                }
            }
        }
    }
    if matches!(state, State::Data) {
        if !pending.is_empty() {
            return Err(row_error(input, &open, pending.len(), pending_line));
        }
        open.notes.push("the file ends without END_DATA".to_owned());
        close(&mut open, &mut done);
    }
    Ok(done)
}

/// Takes fields up to `END_DATA_FORMAT`; whether it was there.
fn take_fields<'a>(row: &[&'a str], open: &mut CgatsTable<'a>, wanted: Wanted) -> bool {
    for field in row {
        if *field == "END_DATA_FORMAT" {
            (open.number_columns, open.word_columns) = wanted(&open.fields);
            return true;
        }
        open.fields.push(field);
    }
    false
}

fn close<'a>(open: &mut CgatsTable<'a>, done: &mut Vec<CgatsTable<'a>>) {
    let mut table = std::mem::take(open);
    if table.kind.is_empty()
        && let Some(first) = done.first()
    {
        table.kind = first.kind;
    }
    let stated = [
        ("NUMBER_OF_FIELDS", table.fields.len(), "fields"),
        ("NUMBER_OF_SETS", table.sets(), "sets"),
    ];
    for (key, found, what) in stated {
        if let Some(says) = table.number(key)
            && says != found as f64
        {
            table
                .notes
                .push(format!("{key} says {says} and there are {found} {what}"));
        }
    }
    done.push(table);
}

fn row_error(input: &Input, open: &CgatsTable, found: usize, line: usize) -> ReadError {
    let expected = format!("{}, one for each field", open.fields.len());
    input
        .error(format!("{found} cells"), expected)
        .at_line(line)
}

fn take_row<'a>(
    input: &Input,
    row: &[&'a str],
    line: usize,
    open: &mut CgatsTable<'a>,
) -> Result<(), ReadError> {
    for column in &open.number_columns {
        let cell = row[*column];
        let value = match number::parse(cell, open.decimal_comma).value() {
            Some(value) => value,
            None => match number::parse(cell, !open.decimal_comma) {
                Cell::Number(value) => {
                    open.decimal_comma |= cell.contains(',');
                    value
                }
                _ => {
                    let expected = format!("a number for {}", open.fields[*column]);
                    return Err(input.error(quoted(cell), expected).at_line(line));
                }
            },
        };
        open.numbers.push(value);
    }
    open.words.extend(open.word_columns.iter().map(|c| row[*c]));
    open.lines.push(kept_line(line));
    Ok(())
}
