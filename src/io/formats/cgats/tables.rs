//! The tables of a CGATS text: keywords, fields, and the sets below them.
//!
//! Cells are set apart by blanks or TABs and may be quoted; a row may run over several lines. Rows
//! whose cells are set apart by TABs, semicolons or commas alone (blanks in names, empty cells)
//! are known by having one cell a field.

use crate::io::error::quoted;
use crate::io::provenance::ORIGINATOR;
use crate::io::text::number::{self, Cell};
use crate::io::text::{kept_line, lines};
use crate::io::{Input, ReadError};

/// Most keywords kept from one file.
const MOST_KEYS: usize = 10_000;

/// Most tables in one file.
const MOST_TABLES: usize = 1000;

/// One table.
#[derive(Debug, Default)]
pub(super) struct CgatsTable<'a> {
    /// What its first line calls it: `SPECT`, `CTI3`, `CGATS.17`, ...; of the first table where a
    /// later one says nothing.
    pub kind: &'a str,
    /// Keywords and values, quotes removed, in file order.
    pub keys: Vec<(&'a str, &'a str)>,
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
    pub decimal_comma: bool,
    /// What is odd, a sentence each.
    pub notes: Vec<String>,
}

impl<'a> CgatsTable<'a> {
    pub(super) fn sets(&self) -> usize {
        self.lines.len()
    }

    /// The last value of a keyword.
    pub(super) fn key(&self, key: &str) -> Option<&'a str> {
        self.keys
            .iter()
            .rev()
            .find(|(k, v)| k.eq_ignore_ascii_case(key) && !v.is_empty())
            .map(|(_, v)| *v)
    }

    /// Whether this program wrote it: its keywords tell name, kind, unit and source.
    pub(super) fn is_own(&self) -> bool {
        self.key("ORIGINATOR")
            .is_some_and(|v| v.starts_with(ORIGINATOR))
    }

    /// The number that a keyword states.
    pub(super) fn number(&self, key: &str) -> Option<f64> {
        let value = self.key(key)?;
        match (number::parse(value, false), number::parse(value, true)) {
            (Cell::Number(v), _) | (Cell::Text, Cell::Number(v)) => Some(v),
            _ => None,
        }
    }
}

/// Which columns are kept: as numbers, and as words.
pub(super) type Wanted<'f> = &'f dyn Fn(&[&str]) -> (Vec<usize>, Vec<usize>);

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
pub(super) fn tables<'a>(
    input: &Input,
    text: &'a str,
    wanted: Wanted,
) -> Result<Vec<CgatsTable<'a>>, ReadError> {
    let mut walk = Walk {
        input,
        wanted,
        done: Vec::new(),
        open: CgatsTable::default(),
        pending: Vec::new(),
        pending_line: 0,
    };
    let mut state = State::Header;
    let mut row: Vec<&str> = Vec::new();
    for (line, content) in lines(text) {
        let content = content.trim();
        if content.is_empty() || content.starts_with('#') {
            continue;
        }
        state = match state {
            State::Header => {
                words(content, &mut row);
                walk.header(&row, line)?
            }
            State::Fields => {
                words(content, &mut row);
                walk.fields(&row)
            }
            State::Data if content.starts_with("END_DATA") => {
                walk.close(line)?;
                State::Header
            }
            State::Data => {
                walk.data(content, &mut row, line)?;
                State::Data
            }
            State::Other(end) if content.starts_with(end.as_str()) => State::Header,
            State::Other(end) => State::Other(end),
        };
    }
    if matches!(state, State::Data) {
        walk.whole_rows()?;
        walk.open
            .notes
            .push("the file ends without END_DATA".to_owned());
        walk.finish();
    }
    Ok(walk.done)
}

/// On the way through a text, line by line.
struct Walk<'a, 'w, 'i> {
    input: &'w Input<'i>,
    wanted: Wanted<'w>,
    done: Vec<CgatsTable<'a>>,
    open: CgatsTable<'a>,
    /// Cells of a row that goes on in the next line, and its first line.
    pending: Vec<&'a str>,
    pending_line: usize,
}

impl<'a> Walk<'a, '_, '_> {
    /// Takes the words of a line of a header; what follows it.
    fn header(&mut self, row: &[&'a str], line: usize) -> Result<State, ReadError> {
        let open = &mut self.open;
        match row {
            [] | ["KEYWORD", ..] => {}
            ["BEGIN_DATA_FORMAT", fields @ ..] => {
                open.fields.clear();
                open.format_line = line;
                return Ok(self.fields(fields));
            }
            ["BEGIN_DATA", ..] => {
                if open.fields.is_empty() {
                    // A further table may go on with the fields of the one before.
                    let Some(before) = self.done.last() else {
                        let expected = "BEGIN_DATA_FORMAT before it";
                        return Err(self.input.error("BEGIN_DATA", expected).at_line(line));
                    };
                    open.fields.clone_from(&before.fields);
                    open.number_columns.clone_from(&before.number_columns);
                    open.word_columns.clone_from(&before.word_columns);
                    open.format_line = before.format_line;
                }
                return Ok(State::Data);
            }
            [other, ..] if other.starts_with("BEGIN_") => {
                return Ok(State::Other(other.replacen("BEGIN_", "END_", 1)));
            }
            [kind] if open.kind.is_empty() && open.keys.is_empty() => open.kind = kind,
            [key, values @ ..] => {
                if open.keys.len() < MOST_KEYS {
                    let value = values.first().copied().unwrap_or("");
                    open.keys.push((*key, value));
                }
            }
        }
        Ok(State::Header)
    }

    /// Takes fields up to `END_DATA_FORMAT`; what follows them.
    fn fields(&mut self, row: &[&'a str]) -> State {
        let open = &mut self.open;
        for field in row {
            if *field == "END_DATA_FORMAT" {
                (open.number_columns, open.word_columns) = (self.wanted)(&open.fields);
                return State::Header;
            }
            open.fields.push(field);
        }
        State::Fields
    }

    /// Takes a line of data: a row, or a part of one.
    fn data(
        &mut self,
        content: &'a str,
        row: &mut Vec<&'a str>,
        line: usize,
    ) -> Result<(), ReadError> {
        let fields = self.open.fields.len();
        if self.pending.is_empty() {
            if cells(content, fields, row) {
                return self.take_row(row, line);
            }
            if row.len() > fields {
                return Err(self.row_error(row.len(), line));
            }
            self.pending.append(row);
            self.pending_line = line;
            return Ok(());
        }
        words(content, row);
        if self.pending.len() + row.len() > fields {
            return self.whole_rows();
        }
        self.pending.append(row);
        if self.pending.len() == fields {
            let whole = std::mem::take(&mut self.pending);
            return self.take_row(&whole, self.pending_line);
        }
        Ok(())
    }

    /// Takes `END_DATA`.
    fn close(&mut self, line: usize) -> Result<(), ReadError> {
        self.whole_rows()?;
        self.finish();
        if self.done.len() < MOST_TABLES {
            return Ok(());
        }
        let found = format!("more than {MOST_TABLES} tables");
        Err(self.input.error(found, "a smaller file").at_line(line))
    }

    /// Refuses a row that was begun and does not end.
    fn whole_rows(&self) -> Result<(), ReadError> {
        match self.pending.len() {
            0 => Ok(()),
            begun => Err(self.row_error(begun, self.pending_line)),
        }
    }

    fn row_error(&self, found: usize, line: usize) -> ReadError {
        let expected = format!("{}, one for each field", self.open.fields.len());
        self.input
            .error(format!("{found} cells"), expected)
            .at_line(line)
    }

    /// Puts the open table to those that are done.
    fn finish(&mut self) {
        let mut table = std::mem::take(&mut self.open);
        if table.kind.is_empty()
            && let Some(first) = self.done.first()
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
                let note = format!("{key} says {says} and there are {found} {what}");
                table.notes.push(note);
            }
        }
        self.done.push(table);
    }

    /// Takes the cells of a whole row.
    fn take_row(&mut self, row: &[&'a str], line: usize) -> Result<(), ReadError> {
        let open = &mut self.open;
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
                        return Err(self.input.error(quoted(cell), expected).at_line(line));
                    }
                },
            };
            open.numbers.push(value);
        }
        open.words.extend(open.word_columns.iter().map(|c| row[*c]));
        open.lines.push(kept_line(line));
        Ok(())
    }
}
