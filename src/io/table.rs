//! Finds the blocks of numbers in a text, whatever stands around them.
//!
//! A row is a line of at least two numbers (or gaps) with no more words than numbers. A block is
//! a run of rows; blank lines and comments do not end it. Lines that are no rows, and runs of a
//! single row, are the header of the block that follows. The scan goes once over the text and
//! keeps one number a cell, so its time and memory grow with the file's length only. Once a block
//! has shown its width, rows that are nothing but plain numbers take a short way
//! ([`plain_row`]); every other line is looked at cell by cell.

use super::dialect::{Dialect, used};
use super::error::quoted;
use super::number::{self, Cell};
use super::plain_row::PlainRow;
use super::text::{first_line, kept_line};
use super::{Input, ReadError};

/// Most cells of numbers that one file may hold; 64 million take 512 MiB of memory.
pub const MOST_CELLS: usize = 64_000_000;

/// Most columns of one table: far more than any instrument writes.
pub const MOST_COLUMNS: usize = 65_536;

/// Rows after which a block has shown its width.
const SETTLED: usize = 3;

/// Most header lines kept before a block: the first hundred and the last hundred are enough.
const HEADER_LINES: usize = 200;

/// What one column of a block holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Column {
    /// Cells with a number.
    pub numbers: usize,
    /// Cells with a word that is no gap.
    pub texts: usize,
    /// Numbers with a per cent sign.
    pub percents: usize,
    /// Numbers with "nm" behind them.
    pub nanometres: usize,
}

/// A word that stands where the column otherwise holds numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct BadCell {
    /// Line in the file, from 1.
    pub line: usize,
    /// Column, from 0.
    pub column: usize,
    /// The word.
    pub text: String,
    /// Whether its line is a row beyond doubt: its first number carries the column on.
    pub certain: bool,
}

impl BadCell {
    /// The refusal for a word among numbers.
    pub fn refusal(&self, input: &Input) -> ReadError {
        let expected = format!("a number in column {}", self.column + 1);
        input.error(quoted(&self.text), expected).at_line(self.line)
    }
}

/// A run of rows and the lines before it.
#[derive(Clone, Debug)]
pub struct Block<'a> {
    /// The lines before the block with their numbers, comment marks removed.
    pub header: Vec<(usize, &'a str)>,
    /// Cells in a row.
    pub width: usize,
    /// `width` columns from top to bottom; NaN where a cell holds no number.
    pub values: Vec<Vec<f64>>,
    /// Line of each row, from 1.
    pub lines: Vec<u32>,
    /// One entry a column.
    pub columns: Vec<Column>,
    /// Words among numbers, at most one a column (the first).
    pub bad: Vec<BadCell>,
    /// The line that ended the block, if it looked like a row gone wrong.
    pub ended_by: Option<BadCell>,
    /// Text of the first row, which returns to the header when the block stays a single row.
    first_row: &'a str,
    /// Plain rows that the columns have not counted yet.
    uncounted: usize,
}

impl<'a> Block<'a> {
    fn new(header: Vec<(usize, &'a str)>, width: usize, first_row: &'a str) -> Self {
        Self {
            header,
            width,
            values: vec![Vec::new(); width],
            lines: Vec::new(),
            columns: vec![Column::default(); width],
            bad: Vec::new(),
            ended_by: None,
            first_row,
            uncounted: 0,
        }
    }

    /// The cells of the first row.
    pub fn first_cells(&self, dialect: Dialect) -> Vec<&'a str> {
        let mut cells = Vec::new();
        dialect.split(self.first_row, &mut cells);
        cells
    }

    /// Makes the first row the last line of the header: it turned out to hold titles.
    pub fn head_first_row(&mut self) {
        let line = self.lines.remove(0) as usize;
        for (column, values) in self.columns.iter_mut().zip(&mut self.values) {
            let is_number = !values.remove(0).is_nan();
            column.numbers -= usize::from(is_number);
            column.texts = column.texts.saturating_sub(usize::from(!is_number));
        }
        self.bad.retain(|bad| bad.line != line);
        self.header.push((line, self.first_row));
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.lines.len()
    }

    /// One row's numbers.
    pub fn row(&self, row: usize) -> Vec<f64> {
        self.values.iter().map(|column| column[row]).collect()
    }

    /// The first column's number in a row.
    pub fn first(&self, row: usize) -> f64 {
        self.values[0][row]
    }

    /// One column's numbers from top to bottom.
    pub fn column(&self, column: usize) -> &[f64] {
        &self.values[column]
    }

    /// Whether a column counts the rows, from 0 or 1.
    pub fn counts_rows(&self, column: usize) -> bool {
        let first = self.values[column][0];
        (first == 0.0 || first == 1.0)
            && self
                .column(column)
                .iter()
                .enumerate()
                .all(|(row, v)| *v == first + row as f64)
    }

    /// Whether a column holds one number in every row.
    pub fn is_constant(&self, column: usize) -> bool {
        let values = self.column(column);
        values.len() >= SETTLED && values.windows(2).all(|pair| pair[0] == pair[1])
    }

    /// Whether a row with `used` filled of `all` cells belongs to the block: as wide, or shorter
    /// where the block has shown its width.
    fn takes(&self, used: usize, all: usize) -> bool {
        used == self.width || used < self.width && (all == self.width || self.rows() >= SETTLED)
    }

    /// Makes room for `rows` more.
    fn reserve(&mut self, rows: usize) {
        self.lines.reserve(rows);
        for column in &mut self.values {
            column.reserve(rows);
        }
    }

    /// A row of `width` plain numbers.
    fn push_plain(&mut self, line: usize, row: &[f64]) {
        self.lines.push(kept_line(line));
        self.uncounted += 1;
        for (column, value) in self.values.iter_mut().zip(row) {
            column.push(*value);
        }
    }

    /// Brings the columns' counts up to date after plain rows.
    fn count(&mut self) {
        let rows = std::mem::take(&mut self.uncounted);
        for column in &mut self.columns {
            column.numbers += rows;
        }
    }

    fn push(&mut self, line: usize, cells: &[&str], kinds: &[Cell]) {
        self.lines.push(kept_line(line));
        let columns = self.columns.iter_mut().zip(&mut self.values);
        for (column, (stats, values)) in columns.enumerate() {
            let kind = kinds.get(column).copied().unwrap_or(Cell::Empty);
            let value = match kind {
                Cell::Number(v) => v,
                Cell::Percent(v) => {
                    stats.percents += 1;
                    v
                }
                Cell::Nanometres(v) => {
                    stats.nanometres += 1;
                    v
                }
                Cell::Empty | Cell::Gap => f64::NAN,
                Cell::Text => {
                    stats.texts += 1;
                    if stats.numbers > 0 && !self.bad.iter().any(|b| b.column == column) {
                        self.bad.push(BadCell {
                            line,
                            column,
                            text: cells[column].to_owned(),
                            certain: true,
                        });
                    }
                    f64::NAN
                }
            };
            stats.numbers += usize::from(!value.is_nan());
            values.push(value);
        }
    }
}

/// More than the program keeps, found at a line of the file (from 1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TooMuch {
    /// More cells than [`MOST_CELLS`].
    Cells { line: usize },
    /// More columns than [`MOST_COLUMNS`].
    Columns { line: usize, found: usize },
}

/// What the lines after the last block were, and the blocks.
#[derive(Clone, Debug)]
pub struct Scan<'a> {
    /// Blocks of at least two rows, in file order.
    pub blocks: Vec<Block<'a>>,
    /// Lines after the last block.
    pub footer: Vec<(usize, &'a str)>,
}

/// All blocks of at least two rows in a text.
///
/// # Errors
/// [`TooMuch`] when the text holds more numbers than the program keeps.
pub fn scan(text: &str, dialect: Dialect) -> Result<Scan<'_>, TooMuch> {
    scan_behind(text, 0, dialect)
}

/// As [`scan`], for what stands in a file behind a number of lines.
///
/// # Errors
/// As [`scan`].
pub fn scan_behind(text: &str, lines: usize, dialect: Dialect) -> Result<Scan<'_>, TooMuch> {
    let mut blocks = Vec::new();
    let mut header: Vec<(usize, &str)> = Vec::new();
    let mut block: Option<Block> = None;
    let (mut cells, mut kinds) = (Vec::new(), Vec::new());
    let (mut held, mut line) = (0, lines);
    let mut rest = text;
    let mut plain = PlainRow::new(dialect);
    loop {
        if let Some(open) = &mut block
            && open.rows() >= SETTLED
        {
            let mut is_first = true;
            while let Some((row, past)) = plain.read(rest, open.width) {
                if held + open.width > MOST_CELLS {
                    return Err(TooMuch::Cells { line: line + 1 });
                }
                if std::mem::take(&mut is_first) {
                    // Lines are about as long as the first of them: no array grows twice.
                    open.reserve((rest.len() / past + 1).min(MOST_CELLS / open.width));
                }
                line += 1;
                held += open.width;
                open.push_plain(line, row);
                rest = &rest[past..];
            }
            open.count();
        }
        let Some((raw, after)) = first_line(rest) else {
            break;
        };
        rest = after;
        line += 1;
        let content = raw.trim_ascii();
        if content.is_empty() {
            continue;
        }
        if let Some(comment) = comment(content) {
            push_header(&mut header, line, comment);
            continue;
        }
        dialect.split(content_with_tabs(raw), &mut cells);
        if cells.len() > MOST_COLUMNS {
            let found = cells.len();
            return Err(TooMuch::Columns { line, found });
        }
        kinds.clear();
        kinds.extend(
            cells
                .iter()
                .map(|cell| number::parse(cell, dialect.decimal_comma)),
        );
        let is_row = looks_like_row(&kinds);
        let used = used(&cells);
        if let Some(open) = &mut block {
            if is_row && open.takes(used, cells.len()) {
                held += open.width;
                open.push(line, &cells, &kinds);
            } else {
                open.ended_by = row_gone_wrong(open, line, &cells, &kinds);
                close(block.take(), &mut blocks, &mut header);
            }
        }
        if block.is_none() {
            if is_row {
                let mut open = Block::new(std::mem::take(&mut header), cells.len(), content);
                held += open.width;
                open.push(line, &cells, &kinds);
                block = Some(open);
            } else {
                push_header(&mut header, line, content);
            }
        }
        if held > MOST_CELLS {
            return Err(TooMuch::Cells { line });
        }
    }
    close(block, &mut blocks, &mut header);
    Ok(Scan {
        blocks,
        footer: header,
    })
}

/// Blanks at the ends go, TABs stay: an empty first or last cell counts.
fn content_with_tabs(raw: &str) -> &str {
    raw.trim_matches(' ')
}

/// The words of a comment line, or `None` when the line is none. A semicolon, and a per cent
/// sign, may also begin a row whose first cell is empty.
fn comment(content: &str) -> Option<&str> {
    let body = ["#", "//", "%", ";"]
        .iter()
        .find_map(|mark| content.strip_prefix(mark))?;
    let starts_row =
        content.starts_with(';') && body.trim_start().starts_with(|c: char| c.is_ascii_digit());
    (!starts_row).then(|| body.trim_start_matches(['#', '/', '%', ';']).trim_ascii())
}

fn looks_like_row(kinds: &[Cell]) -> bool {
    let (mut numbers, mut gaps, mut texts) = (0, 0, 0);
    let mut first_gap_or_empty = 0;
    for kind in kinds {
        match kind {
            Cell::Number(_) | Cell::Percent(_) | Cell::Nanometres(_) => numbers += 1,
            Cell::Gap => gaps += 1,
            Cell::Empty => first_gap_or_empty += 1,
            Cell::Text => texts += 1,
        }
    }
    // A wavelength with nothing but empty cells behind it is a row with every value missing.
    let lone = numbers == 1
        && texts == 0
        && first_gap_or_empty > 0
        && kinds.len() > 1
        && matches!(kinds[0], Cell::Number(_));
    texts <= numbers && (numbers + gaps >= 2 && numbers >= 1 || lone)
}

/// A line of the block's width with numbers and words, where only numbers stood.
///
/// Either its first number carries the first column on, or a word with digits in it stands there
/// ("38x") and the block may tell by what follows.
fn row_gone_wrong(block: &Block, line: usize, cells: &[&str], kinds: &[Cell]) -> Option<BadCell> {
    if used(cells) != block.width || block.rows() < 2 {
        return None;
    }
    let column = kinds
        .iter()
        .zip(&block.columns)
        .position(|(kind, column)| matches!(kind, Cell::Text) && column.numbers > 0)?;
    let certain = match kinds[0] {
        Cell::Number(first) | Cell::Nanometres(first) => {
            let end = block.rows() - 1;
            if !carries_on(block.first(end - 1), block.first(end), first) {
                return None;
            }
            true
        }
        Cell::Text if cells[0].contains(|c: char| c.is_ascii_digit()) => false,
        _ => return None,
    };
    kinds
        .iter()
        .any(|kind| matches!(kind, Cell::Number(_)))
        .then(|| BadCell {
            line,
            column,
            text: cells[column].to_owned(),
            certain,
        })
}

/// Whether `next` follows two numbers of a column: the same way on, and by no more than a few
/// steps.
pub fn carries_on(before: f64, last: f64, next: f64) -> bool {
    let step = last - before;
    (next - last) * step > 0.0 && (next - last).abs() <= 20.0 * step.abs()
}

/// The line above a block, if it is a row of it that holds a word.
pub fn row_gone_wrong_above(block: &Block, dialect: Dialect) -> Option<BadCell> {
    let (line, content) = block.header.last()?;
    let mut cells = Vec::new();
    dialect.split(content, &mut cells);
    let Cell::Number(first) = number::parse(cells[..].first()?, dialect.decimal_comma) else {
        return None;
    };
    if used(&cells) != block.width || !carries_on(block.first(1), block.first(0), first) {
        return None;
    }
    let column = cells
        .iter()
        .zip(&block.columns)
        .position(|(cell, column)| {
            matches!(number::parse(cell, dialect.decimal_comma), Cell::Text) && column.numbers > 0
        })?;
    Some(BadCell {
        line: *line,
        column,
        text: cells[column].to_owned(),
        certain: true,
    })
}

fn close<'a>(
    block: Option<Block<'a>>,
    blocks: &mut Vec<Block<'a>>,
    header: &mut Vec<(usize, &'a str)>,
) {
    let Some(block) = block else { return };
    if block.rows() >= 2 {
        blocks.push(block);
        return;
    }
    // A single row is a header line ("Index,13,14,15"): put it back where it stood.
    let after = std::mem::take(header);
    *header = block.header;
    push_header(header, block.lines[0] as usize, block.first_row);
    header.extend(after);
    // Else it would grow with every single row, and each line that it loses cost all of it.
    if header.len() > HEADER_LINES {
        let over = header.len() - HEADER_LINES;
        header.drain(HEADER_LINES / 2..HEADER_LINES / 2 + over);
    }
}

fn push_header<'a>(header: &mut Vec<(usize, &'a str)>, line: usize, content: &'a str) {
    if header.len() >= HEADER_LINES {
        header.remove(HEADER_LINES / 2);
    }
    header.push((line, content));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::dialect::Delimiter;

    const COMMA: Dialect = Dialect {
        delimiter: Delimiter::Comma,
        decimal_comma: false,
    };

    fn blocks(text: &str) -> Vec<Block<'_>> {
        scan(text, COMMA).map(|s| s.blocks).unwrap_or_default()
    }

    #[test]
    fn words_around_a_block_are_its_header() {
        let found = blocks("Lamp A\n# note\nIndex,13,14\nnm,a,b\n380,1,2\n\n385,3,4\n");
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].values, [[380.0, 385.0], [1.0, 3.0], [2.0, 4.0]]);
        assert_eq!(found[0].lines, [5, 7]);
        assert_eq!(
            found[0].header,
            [
                (1, "Lamp A"),
                (2, "note"),
                (3, "Index,13,14"),
                (4, "nm,a,b")
            ]
        );
    }

    #[test]
    fn words_between_blocks_divide_them() {
        let found = blocks("380,1\n385,2\nSecond\n380,3\n385,4\n");
        assert_eq!(found.len(), 2);
        assert_eq!(found[1].header, [(3, "Second")]);
    }

    #[test]
    fn a_gap_is_kept_as_a_gap_and_a_word_is_remembered() {
        let found = blocks("380,1,NaN\n385,,2\n390,3,4\n395,abc,5\n400,6,\n");
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].rows(), 5);
        assert_eq!(found[0].columns[1].numbers, 3);
        assert_eq!(
            found[0].bad,
            [BadCell {
                line: 4,
                column: 1,
                text: "abc".to_owned(),
                certain: true,
            }]
        );
    }

    #[test]
    fn a_remark_that_only_some_rows_have_does_not_break_the_table() {
        let found = blocks("380,1,\n381,2,peak\n382,3,\n383,4,\n");
        assert_eq!((found.len(), found[0].rows()), (1, 4));
        let found = blocks("0,380,0.1,0.2\n1,390,0.2,0.3\n2,400,0.3,\n3,410,0.4,0.5\n");
        assert_eq!((found.len(), found[0].rows()), (1, 4));
    }

    #[test]
    fn plain_rows_and_others_stand_in_one_block_in_their_order() {
        let found =
            blocks("380,1\n385,2\n390,3\n395,4\n400,NaN\n\n405, 6 \r\n410,\"7\"\n# c\n415,8");
        assert_eq!(found.len(), 1);
        let values = &found[0].values;
        assert_eq!(
            values[0],
            [380.0, 385.0, 390.0, 395.0, 400.0, 405.0, 410.0, 415.0]
        );
        assert_eq!(values[1][..4], [1.0, 2.0, 3.0, 4.0]);
        assert!(values[1][4].is_nan());
        assert_eq!(values[1][5..], [6.0, 7.0, 8.0]);
        assert_eq!(found[0].lines, [1, 2, 3, 4, 5, 7, 8, 10]);
        assert_eq!(
            (found[0].columns[0].numbers, found[0].columns[1].numbers),
            (8, 7)
        );
    }

    #[test]
    fn a_million_columns_are_too_many() {
        let row = "1,".repeat(1_000_000);
        let text = format!("{row}\n{row}\n");
        let found = scan(&text, COMMA).map(|s| s.blocks.len());
        assert!(
            matches!(found, Err(TooMuch::Columns { line: 1, .. })),
            "{found:?}"
        );
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

    #[test]
    fn a_row_gone_wrong_is_remembered_where_it_ends_a_block() {
        let found = blocks("380,1\n385,2\n390,3\n395,abc\n400,5\n405,6\n");
        assert_eq!(found[0].ended_by.as_ref().map(|b| b.line), Some(4));
    }
}
