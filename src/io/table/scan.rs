//! Goes once over a text and finds its blocks of numbers, whatever stands around them.
//!
//! A row is a line of at least two numbers (or gaps) with no more words than numbers. A block is
//! a run of rows; blank lines and comments do not end it. Lines that are no rows, and runs of a
//! single row, are the header of the block that follows. One number is kept a cell, so time and
//! memory grow with the text's length only. Once a block has shown its width, rows that are nothing
//! but plain numbers take a short way; lines without a figure or a delimiter are no rows at a glance;
//! every other line is looked at cell by cell.

use super::block::{Block, LONGEST_BREAK, SETTLED, row_gone_wrong};
use crate::io::budget;
use crate::io::text::dialect::{Delimiter, Dialect, MOST_COLUMNS, used};
use crate::io::text::first_line;
use crate::io::text::number::{self, Cell};

/// Most cells of numbers that one file may hold; 64 million take 512 MiB of memory.
pub const MOST_CELLS: usize = 64_000_000;

/// Longest line that may be a row, in bytes: as many columns as may be, of 256 characters each.
const LONGEST_ROW: usize = 256 * MOST_COLUMNS;

/// Most header lines kept before a block: the first hundred and the last hundred are enough.
const HEADER_LINES: usize = 200;

/// Rows after which a block is long enough to make room for all that may follow. For each of many
/// short ones it would be room for the whole file.
const LONG: usize = 1024;

/// More than the program keeps, found at a line of the file (from 1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TooMuch {
    /// More cells than [`MOST_CELLS`].
    Cells { line: usize },
    /// More columns than [`MOST_COLUMNS`].
    Columns { line: usize, found: usize },
    /// More blocks of a few rows than fit into the memory that the text may take.
    Blocks { line: usize, found: usize },
}

/// All blocks of at least two rows in a text that stands behind a number of lines of its file.
pub(crate) fn scan(text: &str, lines: usize, dialect: Dialect) -> Result<Vec<Block<'_>>, TooMuch> {
    let (blocks, end) = scan_as_far(text, lines, dialect);
    end.map(|()| blocks)
}

/// The first blocks of a text: as many as a scan takes, so that they are never too many.
pub(crate) fn scan_start(text: &str, dialect: Dialect) -> Result<Vec<Block<'_>>, TooMuch> {
    match scan_as_far(text, 0, dialect) {
        (blocks, Ok(()) | Err(TooMuch::Blocks { .. })) => Ok(blocks),
        (_, Err(too_much)) => Err(too_much),
    }
}

/// The blocks of a text as far as they are kept, and why no further.
fn scan_as_far(text: &str, line: usize, dialect: Dialect) -> (Vec<Block<'_>>, Result<(), TooMuch>) {
    let mut scanner = Scanner {
        dialect,
        rest: text,
        line,
        blocks: Vec::new(),
        header: Vec::new(),
        open: None,
        cells: Vec::new(),
        kinds: Vec::new(),
        held: 0,
        beside: 0,
        // The spectra that become of them take the other half.
        most_beside: budget::of_text(text.len()) / 2,
    };
    let end = scanner.run();
    (scanner.blocks, end)
}

/// A scan on its way through a text.
struct Scanner<'a> {
    dialect: Dialect,
    /// What was not looked at yet.
    rest: &'a str,
    /// Lines that were.
    line: usize,
    blocks: Vec<Block<'a>>,
    /// Lines since the last block.
    header: Vec<(usize, &'a str)>,
    /// The block that rows are added to.
    open: Option<Block<'a>>,
    /// The cells of a line and what they hold.
    cells: Vec<&'a str>,
    kinds: Vec<Cell>,
    /// Cells in all blocks.
    held: usize,
    /// Memory that the blocks take beside them, and may take.
    beside: usize,
    most_beside: usize,
}

impl<'a> Scanner<'a> {
    fn run(&mut self) -> Result<(), TooMuch> {
        loop {
            self.plain_rows()?;
            self.skip_line_ends();
            let from = self.rest;
            let Some((raw, after)) = first_line(from) else {
                self.close()?;
                if let Some(last) = self.blocks.last_mut() {
                    self.header.truncate(LONGEST_BREAK);
                    last.behind = std::mem::take(&mut self.header);
                }
                return Ok(());
            };
            self.rest = after;
            self.line += 1;
            self.look_at(raw, from)?;
        }
    }

    /// Passes over empty lines: there may be any number of them.
    fn skip_line_ends(&mut self) {
        let bytes = self.rest.as_bytes();
        let mut at = 0;
        while let Some(b'\n' | b'\r') = bytes.get(at) {
            at += usize::from(bytes[at..].starts_with(b"\r\n"));
            at += 1;
            self.line += 1;
        }
        self.rest = &self.rest[at..];
    }

    /// Takes the rows that go on with the open block and are nothing but plain numbers.
    fn plain_rows(&mut self) -> Result<(), TooMuch> {
        let Some(open) = &mut self.open else {
            return Ok(());
        };
        if open.rows() < SETTLED || open.has_signs() {
            return Ok(());
        }
        let mut row = vec![0.0; open.width];
        while let Some((line, after)) = first_line(self.rest)
            && plain_row(line, self.dialect, &mut row)
        {
            self.line += 1;
            if self.held + open.width > MOST_CELLS {
                return Err(TooMuch::Cells { line: self.line });
            }
            if open.rows() == LONG {
                // Lines are about as long as this one: no array grows twice.
                let rows = self.rest.len() / (line.len() + 1) + 1;
                open.reserve(rows.min(MOST_CELLS / open.width));
            }
            self.held += open.width;
            open.push_plain(self.line, &row);
            self.rest = after;
        }
        open.count();
        Ok(())
    }

    /// Takes a line of any kind, with which `from` starts.
    fn look_at(&mut self, raw: &'a str, from: &'a str) -> Result<(), TooMuch> {
        let content = raw[..raw.floor_char_boundary(LONGEST_ROW)].trim_ascii();
        if content.is_empty() {
            return Ok(());
        }
        if let Some(comment) = comment(content, self.dialect.delimiter) {
            push_header(&mut self.header, self.line, comment);
            return Ok(());
        }
        let is_row = self.is_row(raw)? || self.is_wavelength_alone(content);
        let used = used(&self.cells);
        if let Some(open) = &mut self.open {
            if is_row && open.takes(used, self.cells.len()) {
                self.held += open.width;
                open.push(self.line, &self.cells, &self.kinds);
            } else {
                open.ended_by = row_gone_wrong(open, self.line, &self.cells, &self.kinds);
                self.close()?;
            }
        }
        if self.open.is_none() {
            if is_row {
                trim(&mut self.header);
                let header = std::mem::take(&mut self.header);
                let mut open = Block::new(header, self.cells.len(), (self.line, from));
                self.held += open.width;
                open.push(self.line, &self.cells, &self.kinds);
                self.open = Some(open);
            } else {
                push_header(&mut self.header, self.line, content);
            }
        }
        if self.held > MOST_CELLS {
            return Err(TooMuch::Cells { line: self.line });
        }
        Ok(())
    }

    /// Takes a line apart, unless it is plain at a glance that it is no row; whether it is one.
    fn is_row(&mut self, raw: &'a str) -> Result<bool, TooMuch> {
        self.cells.clear();
        self.kinds.clear();
        // A row has a figure. Titles without any are cells, too, where there are too many of them.
        let has_figure = || raw.bytes().any(|byte| byte.is_ascii_digit());
        let is_short = raw.len() <= MOST_COLUMNS;
        if raw.len() > LONGEST_ROW
            || !self.dialect.parts(content_with_tabs(raw))
            || is_short && !has_figure()
        {
            return Ok(false);
        }
        let mut is_row = self.take_apart(raw);
        if self.kinds.contains(&Cell::Text)
            && self.dialect.delimiter != Delimiter::Cell
            && let Some(before) = before_comment(raw)
        {
            let is_whole = self.take_apart(before) && !self.kinds.contains(&Cell::Text);
            is_row = is_whole || self.take_apart(raw);
        }
        // Words with blanks between them are no columns.
        let are_cells = is_row || self.dialect.delimiter != Delimiter::Space;
        if self.cells.len() > MOST_COLUMNS && are_cells {
            return Err(TooMuch::Columns {
                line: self.line,
                found: self.dialect.count(content_with_tabs(raw)),
            });
        }
        Ok(is_row)
    }

    /// Whether a line is a number alone that carries on the first column of a table: a row with
    /// every value missing. Its cell is kept.
    fn is_wavelength_alone(&mut self, content: &'a str) -> bool {
        let settled = self.open.as_ref().filter(|open| open.rows() >= SETTLED);
        // Most lines that are no rows are looked at in a dialect that is not theirs: nothing is open.
        let Some(open) = settled.filter(|_| self.cells.is_empty()) else {
            return false;
        };
        let kind = number::parse(content, self.dialect.decimal_comma);
        if !matches!(kind, Cell::Number(nm) if open.goes_on_with(nm)) {
            return false;
        }
        self.cells.push(content);
        self.kinds.push(kind);
        true
    }

    /// The cells of a line and what they hold; whether it looks like a row.
    fn take_apart(&mut self, line: &'a str) -> bool {
        self.dialect.split(content_with_tabs(line), &mut self.cells);
        let decimal_comma = self.dialect.decimal_comma;
        let kinds = self.cells.iter();
        self.kinds.clear();
        self.kinds
            .extend(kinds.map(|cell| number::parse(cell, decimal_comma)));
        looks_like_row(&self.kinds)
    }

    /// Ends the open block. A single row is a header line ("Index,13,14,15"): it goes back to where
    /// it stood.
    fn close(&mut self) -> Result<(), TooMuch> {
        let Some(mut block) = self.open.take() else {
            return Ok(());
        };
        if block.rows() >= 2 {
            block.shrink();
            self.beside += block.bytes_beside();
            self.blocks.push(block);
            if self.beside > self.most_beside {
                return Err(TooMuch::Blocks {
                    line: self.line,
                    found: self.blocks.len(),
                });
            }
            return Ok(());
        }
        self.held -= block.width;
        let row = (block.lines[0] as usize, block.first_row());
        let after = std::mem::replace(&mut self.header, block.header);
        push_header(&mut self.header, row.0, row.1);
        self.header.extend(after);
        // Else it would grow with every single row.
        trim(&mut self.header);
        Ok(())
    }
}

/// Blanks at the ends go, TABs stay: an empty first or last cell counts.
fn content_with_tabs(raw: &str) -> &str {
    raw.trim_matches(' ')
}

/// The words of a comment line, or `None` when the line is none. A semicolon, and a per cent
/// sign, may also begin a row whose first cell is empty, and a cell of a sheet.
fn comment(content: &str, delimiter: Delimiter) -> Option<&str> {
    let marks = match delimiter {
        Delimiter::Cell => &["#", "//"][..],
        _ => &["#", "//", "%", ";"],
    };
    let body = marks.iter().find_map(|mark| content.strip_prefix(mark))?;
    let starts_row =
        content.starts_with(';') && body.trim_start().starts_with(|c: char| c.is_ascii_digit());
    (!starts_row).then(|| body.trim_start_matches(['#', '/', '%', ';']).trim_ascii())
}

/// A line without the comment behind it: `380,1 # at noon`. A mark with a word close behind it may
/// be a cell: `#1`, `#VALUE!`.
fn before_comment(line: &str) -> Option<&str> {
    let at = [" # ", "\t# ", " //", "\t//"]
        .iter()
        .filter_map(|mark| line.find(mark))
        .min()?;
    Some(line[..at].trim_end_matches([',', ';', ' ']))
}

/// Puts the numbers of a line into `row`; whether they are as many and stand alone. Gaps, quotes,
/// words and units are left to the slow way, which reads the same numbers.
fn plain_row(line: &str, dialect: Dialect, row: &mut [f64]) -> bool {
    fn fill<'a>(mut cells: impl Iterator<Item = &'a str>, comma: bool, row: &mut [f64]) -> bool {
        let mut next = || cells.next().and_then(|cell| number::number(cell, comma));
        let is_full = row.iter_mut().all(|to| {
            let value = next().filter(|value| number::is_measured(*value));
            value.map(|value| *to = value).is_some()
        });
        is_full && cells.next().is_none()
    }
    let comma = dialect.decimal_comma;
    match dialect.mark() {
        // Where one mark does both, cells are quoted, and not plain.
        Some(b',') if comma => false,
        Some(mark) => {
            let cells = line.split(char::from(mark));
            fill(cells.map(|cell| cell.trim_matches(' ')), comma, row)
        }
        None => fill(line.split_ascii_whitespace(), comma, row),
    }
}

fn looks_like_row(kinds: &[Cell]) -> bool {
    let (mut numbers, mut gaps, mut empty, mut texts) = (0, 0, 0, 0);
    for kind in kinds {
        match kind {
            Cell::Gap => gaps += 1,
            Cell::Empty => empty += 1,
            Cell::Text => texts += 1,
            _ => numbers += 1,
        }
    }
    // A wavelength with nothing but empty cells behind it is a row with every value missing.
    let lone = numbers == 1 && texts == 0 && empty > 0 && matches!(kinds[0], Cell::Number(_));
    texts <= numbers && (numbers + gaps >= 2 && numbers >= 1 || lone)
}

fn push_header<'a>(header: &mut Vec<(usize, &'a str)>, line: usize, content: &'a str) {
    header.push((line, content));
    // Now and then: every line that is lost costs all that stay.
    if header.len() >= 2 * HEADER_LINES {
        trim(header);
    }
}

/// Keeps the first and the last lines of a long header.
fn trim(header: &mut Vec<(usize, &str)>) {
    if header.len() > HEADER_LINES {
        header.drain(HEADER_LINES / 2..header.len() - HEADER_LINES / 2);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const COMMA: Dialect = Dialect::new(Delimiter::Comma, false);

    fn blocks(text: &str) -> Vec<Block<'_>> {
        scan(text, 0, COMMA).unwrap_or_default()
    }

    #[test]
    fn a_block_keeps_no_room_for_rows_that_did_not_come() {
        let row = "380,1\n";
        let short = format!("{}x\n", row.repeat(5)).repeat(100);
        let text = short + &row.repeat(3 * LONG) + &"words\n".repeat(100_000);
        let found = blocks(&text);
        assert_eq!(found.len(), 101);
        for block in found {
            let room = block.values[0].capacity().max(block.lines.capacity());
            assert!(room <= 2 * block.rows(), "{room} for {}", block.rows());
        }
    }

    #[test]
    fn a_plain_row_is_numbers_alone() {
        let read = |text: &str, dialect| {
            let mut row = [0.0; 2];
            plain_row(text, dialect, &mut row).then_some(row)
        };
        let space = Dialect::new(Delimiter::Space, true);
        for (dialect, text, row) in [
            (COMMA, "380,0.5", [380.0, 0.5]),
            (COMMA, " 380 , -.5e1 ", [380.0, -5.0]),
            (space, "\t380,5   0,25", [380.5, 0.25]),
        ] {
            assert_eq!(read(text, dialect), Some(row));
        }
        let odd = "380|380,1,2|380,|380,NaN|380,\"1\"|380,1e999|380,1e30|380nm,1|380,1 2|380;1||\
             #380,1|380,1%|380,--1|380,1e";
        for text in odd.split('|') {
            assert_eq!(read(text, COMMA), None, "{text:?}");
        }
    }

    #[test]
    fn single_rows_among_comments_do_not_lengthen_the_header() {
        let text: String = (0..20)
            .map(|i| "1,2\n1,2,3\n".repeat(i % 2) + &"# c\n".repeat(150))
            .collect();
        let text = text + "380,1\n385,2\n";
        let found = blocks(&text);
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].header.len(), HEADER_LINES);
    }
}
