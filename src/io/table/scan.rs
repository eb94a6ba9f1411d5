//! Goes once over a text and finds its blocks of numbers, whatever stands around them.
//!
//! A row is a line of at least two numbers (or gaps) with no more words than numbers. A block is
//! a run of rows; blank lines and comments do not end it. Lines that are no rows, and runs of a
//! single row, are the header of the block that follows. One number is kept a cell, so time and
//! memory grow with the text's length only. Lines without a figure or a delimiter are no rows at a
//! glance; every other line is looked at cell by cell.

use super::block::{Block, LONGEST_BREAK, NoTable, Row, SETTLED};
use crate::io::budget;
use crate::io::text::dialect::{Delimiter, Dialect, MOST_COLUMNS};
use crate::io::text::first_line;
use crate::io::text::number::{self, Cell};
use crate::languages::said;

/// Most cells of numbers that one file may hold; 64 million take 512 MiB of memory.
pub(crate) const MOST_CELLS: usize = 64_000_000;

/// Longest line that may be a row, in bytes: as many columns as may be, of 256 characters each.
const LONGEST_ROW: usize = 256 * MOST_COLUMNS;

/// Most header lines kept before a block: the first hundred and the last hundred are enough.
const HEADER_LINES: usize = 200;

/// Rows after which a block is long enough to make room for all that may follow. For each of many
/// short ones it would be room for the whole file.
const LONG: usize = 1024;

/// All blocks of at least two rows in a text that stands behind a number of lines of its file.
pub(crate) fn scan(text: &str, lines: usize, dialect: Dialect) -> Result<Vec<Block<'_>>, NoTable> {
    Scanner::of(text, lines, dialect).run()
}

/// The first blocks of a text: as many as a scan takes, so that they are never too many.
pub(crate) fn scan_start(text: &str, dialect: Dialect) -> Result<Vec<Block<'_>>, NoTable> {
    let scanner = Scanner::of(text, 0, dialect);
    let is_start = true;
    Scanner {
        is_start,
        ..scanner
    }
    .run()
}

struct Scanner<'a> {
    dialect: Dialect,
    /// The text not scanned yet.
    rest: &'a str,
    /// Lines that were.
    line: usize,
    blocks: Vec<Block<'a>>,
    /// Lines since the last block.
    header: Vec<(usize, &'a str)>,
    /// The block that rows are added to.
    open: Option<Block<'a>>,
    /// The line that is looked at; without cells where that was not needed.
    row: Row<'a>,
    /// Cells in all blocks.
    held: usize,
    /// Memory that the blocks take beside them, and may take.
    beside: usize,
    most_beside: usize,
    /// True if too many blocks end the scan instead of being refused.
    is_start: bool,
}

impl<'a> Scanner<'a> {
    fn of(text: &'a str, line: usize, dialect: Dialect) -> Self {
        Self {
            dialect,
            rest: text,
            line,
            blocks: Vec::new(),
            header: Vec::new(),
            open: None,
            row: Row::default(),
            held: 0,
            beside: 0,
            // The spectra that become of them take the other half.
            most_beside: budget::of_text(text.len()) / 2,
            is_start: false,
        }
    }

    fn run(mut self) -> Result<Vec<Block<'a>>, NoTable> {
        while let Some((raw, after)) = first_line(self.rest) {
            let from = std::mem::replace(&mut self.rest, after);
            self.line += 1;
            if !raw.is_empty() {
                self.look_at(raw, from)?;
            }
        }
        self.close()?;
        if let Some(last) = self.blocks.last_mut() {
            self.header.truncate(LONGEST_BREAK);
            last.behind = self.header;
        }
        Ok(self.blocks)
    }

    /// Takes a line of any kind, with which `from` starts.
    fn look_at(&mut self, raw: &'a str, from: &'a str) -> Result<(), NoTable> {
        let content = raw[..raw.floor_char_boundary(LONGEST_ROW)].trim_ascii();
        if content.is_empty() {
            return Ok(());
        }
        if let Some(comment) = comment(content, self.dialect.delimiter) {
            push_header(&mut self.header, self.line, comment);
            return Ok(());
        }
        let is_row = self.is_row(raw)? || self.is_wavelength_alone(content);
        let (used, all) = (self.row.used(), self.row.cells.len());
        let goes_on = |open: &Block| is_row && open.takes(used, all);
        if !self.open.as_ref().is_some_and(goes_on) {
            if let Some(open) = &mut self.open {
                open.ended_by = open.gone_wrong(&self.row);
            }
            self.close()?;
            if !is_row {
                push_header(&mut self.header, self.line, content);
                return Ok(());
            }
            trim(&mut self.header);
        }
        let open = self.open.get_or_insert_with(|| {
            let header = std::mem::take(&mut self.header);
            Block::new(header, all, (self.line, from))
        });
        if open.rows() == LONG {
            // Lines are about as long as this one: no array grows twice.
            let rows = self.rest.len() / (raw.len() + 1) + 1;
            open.reserve(rows.min(MOST_CELLS / open.width));
        }
        open.push(&self.row);
        self.held += open.width;
        if self.held > MOST_CELLS {
            let found = said!("more than 64 million numbers");
            return self.too_much(found, said!("a smaller table"));
        }
        Ok(())
    }

    fn too_much<T>(&self, found: impl Into<String>, expected: &str) -> Result<T, NoTable> {
        Err(NoTable::At {
            line: self.line,
            found: found.into(),
            expected: expected.to_owned(),
        })
    }

    /// Takes a line apart, unless it is plain at a glance that it is no row; whether it is one.
    fn is_row(&mut self, raw: &'a str) -> Result<bool, NoTable> {
        self.row.line = self.line;
        self.row.cells.clear();
        self.row.kinds.clear();
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
        if self.row.has_words()
            && self.dialect.delimiter != Delimiter::Cell
            && let Some(before) = before_comment(raw)
        {
            let is_whole = self.take_apart(before) && !self.row.has_words();
            is_row = is_whole || self.take_apart(raw);
        }
        // Words with blanks between them are no columns.
        let are_cells = is_row || self.dialect.delimiter != Delimiter::Space;
        if self.row.cells.len() > MOST_COLUMNS && are_cells {
            let found = self.dialect.count(content_with_tabs(raw));
            let most = tr!("at most {most} columns", most = MOST_COLUMNS);
            return self.too_much(tr!("{n} column" | "{n} columns" % found), &most);
        }
        Ok(is_row)
    }

    /// True if a line is a lone number that continues the first column of a table: a row with every
    /// value missing. Its cell is kept.
    fn is_wavelength_alone(&mut self, content: &'a str) -> bool {
        let settled = self.open.as_ref().filter(|open| open.rows() >= SETTLED);
        // Most lines that are no rows are looked at in a dialect that is not theirs: nothing is open.
        let Some(open) = settled.filter(|_| self.row.cells.is_empty()) else {
            return false;
        };
        let kind = number::parse(content, self.dialect.decimal_comma);
        if !matches!(kind, Cell::Number(nm) if open.goes_on_with(nm)) {
            return false;
        }
        self.row.cells.push(content);
        self.row.kinds.push(kind);
        true
    }

    /// Takes a line apart; whether it looks like a row.
    fn take_apart(&mut self, line: &'a str) -> bool {
        let content = content_with_tabs(line);
        self.row.take_apart(self.line, content, self.dialect);
        looks_like_row(&self.row.kinds)
    }

    /// Ends the open block. A single row is a header line ("Index,13,14,15"): it goes back to where
    /// it stood.
    fn close(&mut self) -> Result<(), NoTable> {
        let Some(mut block) = self.open.take() else {
            return Ok(());
        };
        if block.rows() < 2 {
            self.held -= block.width;
            let row = (block.lines[0] as usize, block.first_row());
            let after = std::mem::replace(&mut self.header, block.header);
            push_header(&mut self.header, row.0, row.1);
            self.header.extend(after);
            // Else it would grow with every single row.
            trim(&mut self.header);
            return Ok(());
        }
        block.shrink();
        self.beside += block.bytes_beside();
        self.blocks.push(block);
        if self.beside <= self.most_beside {
            return Ok(());
        }
        if self.is_start {
            self.rest = "";
            return Ok(());
        }
        let count = self.blocks.len();
        let found = tr!("{n} table of a few rows" | "{n} tables of a few rows each" % count);
        self.too_much(found, said(budget::TEXT_WORDS))
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

    fn blocks(text: &str) -> Vec<Block<'_>> {
        scan(text, 0, Dialect::new(Delimiter::Comma, false)).unwrap_or_default()
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
