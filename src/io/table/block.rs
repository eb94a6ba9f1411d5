//! Blocks of numbers in a text, as [`scan`](super::scan) finds them.

mod bad_cell;

use std::borrow::Borrow;

use crate::io::text::dialect::{Dialect, used};
use crate::io::text::number::{self, Cell, unit_behind};
use crate::io::text::{first_line, is_no_comment, kept_line, lines};

pub(crate) use bad_cell::BadCell;

/// Rows after which a block has shown its width.
pub(crate) const SETTLED: usize = 3;

/// Longest break inside a table, in lines, that is passed over and said.
pub(crate) const LONGEST_BREAK: usize = 5;

/// Fewest rows of a table that agree so clearly that one which does not is left out.
pub(crate) const FEWEST_THAT_AGREE: usize = 20;

/// The most rows of a table that may be left out as mistyped: one in fifty, none of a short table.
pub(crate) fn most_left_out(rows: usize) -> usize {
    if rows < FEWEST_THAT_AGREE {
        return 0;
    }
    (rows / 50).max(1)
}

/// True if values are a spectrum's: at least two are not missing.
pub(crate) fn has_values<V: Borrow<f64>>(values: impl IntoIterator<Item = V>) -> bool {
    let mut filled = values.into_iter().filter(|value| !value.borrow().is_nan());
    filled.nth(1).is_some()
}

/// Why a text holds no table that can be read.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum NoTable {
    Bad(BadCell),
    /// The content of a line, and the content expected there.
    At {
        line: usize,
        found: String,
        expected: String,
    },
    /// No two lines of two numbers.
    NoRows,
}

/// Statistics of one column of a block.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Column {
    /// Cells with a number.
    pub numbers: usize,
    /// Cells with a word that is no gap.
    pub texts: usize,
    /// Numbers with a per cent sign.
    pub percents: usize,
    /// Limits that a number lies below or above.
    pub limits: usize,
    /// Numbers with "nm" behind them.
    pub nanometres: usize,
    /// The unit behind its first number that has one.
    pub unit: Option<String>,
    /// True if a word below a number is already in the block's list.
    has_bad: bool,
}

/// A line taken apart: its cells and what they hold.
#[derive(Default)]
pub(crate) struct Row<'a> {
    pub line: usize,
    pub cells: Vec<&'a str>,
    pub kinds: Vec<Cell>,
}

impl<'a> Row<'a> {
    pub(crate) fn of(line: usize, content: &'a str, dialect: Dialect) -> Self {
        let mut row = Self::default();
        row.take_apart(line, content, dialect);
        row
    }

    /// Becomes that of another line.
    pub(crate) fn take_apart(&mut self, line: usize, content: &'a str, dialect: Dialect) {
        self.line = line;
        dialect.split(content, &mut self.cells);
        let kind = |cell: &&str| number::parse(cell, dialect.decimal_comma);
        self.kinds.clear();
        self.kinds.extend(self.cells.iter().map(kind));
    }

    /// Cells without the empty ones at its end.
    pub(crate) fn used(&self) -> usize {
        used(&self.cells)
    }

    pub(crate) fn has_words(&self) -> bool {
        self.kinds.contains(&Cell::Text)
    }

    /// The number that its first cell holds, if it is a plain one.
    fn first(&self) -> Option<f64> {
        match self.kinds.first()? {
            Cell::Number(first) => Some(*first),
            _ => None,
        }
    }
}

/// Lines at a break of a block that are no rows of it.
#[derive(Debug, Default)]
pub(crate) struct LeftLines {
    /// Their places among the lines.
    pub all: Vec<usize>,
    /// Of these the lines of numbers that carry the block on.
    pub numbers: Vec<usize>,
    /// The rows with a word.
    pub words: Vec<BadCell>,
}

/// A run of rows and the lines before it.
#[derive(Clone, Debug)]
pub(crate) struct Block<'a> {
    /// The lines before the block with their numbers, comment marks removed.
    pub header: Vec<(usize, &'a str)>,
    /// Cells in a row.
    pub width: usize,
    /// `width` columns from top to bottom; NaN where a cell holds no number.
    pub values: Vec<Vec<f64>>,
    /// Line of each row, from 1.
    pub lines: Vec<u32>,
    pub columns: Vec<Column>,
    /// Words among numbers, at most one a column (the first).
    pub bad: Vec<BadCell>,
    /// The line that ended the block, if it looked like a row gone wrong.
    pub ended_by: Option<BadCell>,
    /// The first lines behind the last block of a text.
    pub behind: Vec<(usize, &'a str)>,
    /// The content skipped to get it, a sentence each.
    pub notes: Vec<String>,
    /// The rows with a word that it was broken by.
    pub lost: Vec<BadCell>,
    /// The text from the first row on, and that row's line.
    from: (usize, &'a str),
}

impl<'a> Block<'a> {
    /// A block without rows, of as many cells in a row; `from` is its first line, and the text from
    /// that line on.
    pub(crate) fn new(header: Vec<(usize, &'a str)>, width: usize, from: (usize, &'a str)) -> Self {
        Self {
            header,
            width,
            values: vec![Vec::new(); width],
            lines: Vec::new(),
            columns: vec![Column::default(); width],
            bad: Vec::new(),
            ended_by: None,
            behind: Vec::new(),
            notes: Vec::new(),
            lost: Vec::new(),
            from,
        }
    }

    /// A block of points in two columns, which are what two of its own are.
    pub(crate) fn of_points(&self, columns: [usize; 2], points: &[(f64, f64, u32)]) -> Self {
        let (nm, values) = points.iter().map(|point| (point.0, point.1)).unzip();
        Self {
            values: vec![nm, values],
            lines: points.iter().map(|point| point.2).collect(),
            columns: columns.map(|at| self.columns[at].clone()).into(),
            ..Self::new(self.header.clone(), 2, self.from)
        }
    }

    /// Memory that the block takes besides its numbers, its titles and layout to come included:
    /// many blocks of a few rows take far more than their text.
    pub(crate) fn bytes_beside(&self) -> usize {
        const OF_A_BLOCK: usize = 1024;
        const OF_A_COLUMN: usize = 256;
        let lines = self.header.capacity() * size_of::<(usize, &str)>();
        OF_A_BLOCK + OF_A_COLUMN * self.width + lines
    }

    /// Text of the first row, which returns to the header when the block stays a single row.
    pub(crate) fn first_row(&self) -> &'a str {
        first_line(self.from.1).map_or("", |(row, _)| row.trim_ascii())
    }

    /// The lines of the rows as they stand in the text, while the rows stand in its order.
    pub(crate) fn row_texts(&self) -> impl Iterator<Item = &'a str> {
        let (before, text) = (self.from.0 - 1, self.from.1);
        let mut all = lines(text);
        self.lines.iter().map_while(move |line| {
            let found = all.find(|(number, _)| before + number == *line as usize);
            found.map(|(_, content)| content)
        })
    }

    /// Makes the first row the last line of the header: it turned out to hold titles.
    pub(crate) fn head_first_row(&mut self) {
        let line = self.lines.remove(0) as usize;
        for (column, values) in self.columns.iter_mut().zip(&mut self.values) {
            let is_number = !values.remove(0).is_nan();
            column.numbers -= usize::from(is_number);
            column.texts = column.texts.saturating_sub(usize::from(!is_number));
        }
        self.bad.retain(|bad| bad.line != line);
        self.header.push((line, self.first_row()));
    }

    /// Leaves these rows, in this order.
    pub(crate) fn arrange(&mut self, order: &[usize]) {
        for values in &mut self.values {
            *values = order.iter().map(|row| values[*row]).collect();
        }
        self.lines = order.iter().map(|row| self.lines[*row]).collect();
    }

    pub(crate) fn rows(&self) -> usize {
        self.lines.len()
    }

    pub(crate) fn row(&self, row: usize) -> Vec<f64> {
        self.values.iter().map(|column| column[row]).collect()
    }

    pub(crate) fn first(&self, row: usize) -> f64 {
        self.values[0][row]
    }

    pub(crate) fn column(&self, column: usize) -> &[f64] {
        &self.values[column]
    }

    /// True if a column counts the rows, from 0 or 1.
    pub(crate) fn counts_rows(&self, column: usize) -> bool {
        let values = self.column(column);
        let first = values[0];
        let mut numbered = values.iter().enumerate();
        (first == 0.0 || first == 1.0) && numbered.all(|(row, v)| *v == first + row as f64)
    }

    /// True if rows begin with a name or a count.
    pub(crate) fn has_row_names(&self) -> bool {
        self.columns[0].numbers == 0 || self.counts_rows(0)
    }

    pub(crate) fn is_constant(&self, column: usize) -> bool {
        let values = self.column(column);
        values.len() >= SETTLED && values.windows(2).all(|pair| pair[0] == pair[1])
    }

    /// True if a row with `used` filled of `all` cells belongs to the block: as wide, or shorter
    /// where the block has shown its width.
    pub(crate) fn takes(&self, used: usize, all: usize) -> bool {
        used == self.width || used < self.width && (all == self.width || self.rows() >= SETTLED)
    }

    pub(crate) fn goes_on_with(&self, nm: f64) -> bool {
        let end = self.rows() - 1;
        end > 0 && carries_on(self.first(end - 1), self.first(end), nm)
    }

    /// Takes lines that broke the block as far as they are rows of it after all; what is to be said
    /// of the others.
    pub(crate) fn take_lines(
        &mut self,
        lines: &[(usize, &'a str)],
        (text, dialect): (&str, Dialect),
    ) -> LeftLines {
        let mut left = LeftLines::default();
        let lines = lines.iter().enumerate();
        for (at, (line, content)) in lines.filter(|(_, line)| is_no_comment(text, line.1)) {
            let row = Row::of(*line, content, dialect);
            let goes_on = row.first().is_some_and(|nm| self.goes_on_with(nm));
            let are_numbers = goes_on && !row.has_words();
            if are_numbers && row.used() <= self.width {
                self.push(&row);
                continue;
            }
            left.all.push(at);
            left.numbers.extend(are_numbers.then_some(at));
            left.words.extend(self.gone_wrong(&row));
        }
        left
    }

    pub(crate) fn reserve(&mut self, rows: usize) {
        self.lines.reserve(rows);
        for column in &mut self.values {
            column.reserve(rows);
        }
    }

    /// The first word of a row that stands in a column of numbers.
    fn word_among_numbers(&self, row: &Row, certain: bool) -> Option<BadCell> {
        let mut columns = row.kinds.iter().zip(&self.columns);
        let column = columns.position(|(kind, of)| *kind == Cell::Text && of.numbers > 0)?;
        Some(BadCell::of(row, column, certain))
    }

    /// A line of the block's width with numbers and words, where only numbers stood.
    ///
    /// Either its first number carries the first column on, or a word with digits in it stands there
    /// ("38x") and the block may tell by what follows.
    pub(crate) fn gone_wrong(&self, row: &Row) -> Option<BadCell> {
        if row.used() != self.width || self.rows() < 2 {
            return None;
        }
        let is_number = |kind: &Cell| matches!(kind, Cell::Number(_) | Cell::Nanometres(_));
        let certain = match row.kinds[0] {
            Cell::Number(first) | Cell::Nanometres(first) if self.goes_on_with(first) => true,
            Cell::Text if row.cells[0].contains(|c: char| c.is_ascii_digit()) => false,
            _ => return None,
        };
        let word = self.word_among_numbers(row, certain);
        word.filter(|_| row.kinds.iter().any(is_number))
    }

    /// The line above, if it is a row of the block that holds a word.
    pub(crate) fn gone_wrong_above(&self, text: &str, dialect: Dialect) -> Option<BadCell> {
        let (line, content) = self.header.last()?;
        let row = Row::of(*line, content, dialect);
        let goes_on = carries_on(self.first(1), self.first(0), row.first()?);
        (goes_on && row.used() == self.width && is_no_comment(text, content))
            .then(|| self.word_among_numbers(&row, true))?
    }

    /// Adds the rows of a block that goes on with this one.
    pub(crate) fn append(&mut self, more: Self) {
        for (column, more) in self.values.iter_mut().zip(&more.values) {
            column.extend(more);
        }
        self.lines.extend(&more.lines);
        for (sum, part) in self.columns.iter_mut().zip(more.columns) {
            sum.numbers += part.numbers;
            sum.texts += part.texts;
            sum.percents += part.percents;
            sum.limits += part.limits;
            sum.nanometres += part.nanometres;
            sum.unit = sum.unit.take().or(part.unit);
        }
        self.bad.extend(more.bad);
        self.ended_by = more.ended_by;
        self.behind = more.behind;
    }

    /// Gives back the room for rows that did not come.
    pub(crate) fn shrink(&mut self) {
        if self.lines.capacity() > 2 * self.rows() {
            self.lines.shrink_to_fit();
            self.values.iter_mut().for_each(Vec::shrink_to_fit);
        }
    }

    pub(crate) fn push(&mut self, row: &Row) {
        self.lines.push(kept_line(row.line));
        let columns = self.columns.iter_mut().zip(&mut self.values);
        for (column, (stats, values)) in columns.enumerate() {
            let mut kind = row.kinds.get(column).copied().unwrap_or(Cell::Empty);
            if let Cell::WithUnit(_) = kind {
                let unit = row.cells.get(column).and_then(|cell| unit_behind(cell));
                match (&stats.unit, unit) {
                    (None, unit) => stats.unit = unit.map(str::to_owned),
                    // Not the column's unit: its number counts something else.
                    (Some(own), Some(unit)) if own != unit => kind = Cell::Text,
                    _ => {}
                }
            }
            // Of two numbers with a per cent sign and without one, one is a hundred times too large.
            let others_differ = match kind {
                Cell::Percent(value) if value != 0.0 => {
                    stats.percents == 0 && values.iter().any(|v| v.abs() > 0.0)
                }
                Cell::Number(value) if value != 0.0 => stats.percents > 0,
                _ => false,
            };
            if others_differ {
                kind = Cell::Text;
            }
            match kind {
                Cell::Percent(_) => stats.percents += 1,
                Cell::Nanometres(_) => stats.nanometres += 1,
                Cell::Limit(_) => stats.limits += 1,
                Cell::Text => stats.texts += 1,
                _ => {}
            }
            if kind == Cell::Text && stats.numbers > 0 && !stats.has_bad {
                stats.has_bad = true;
                self.bad.push(BadCell::of(row, column, true));
            }
            let value = kind.value().unwrap_or(f64::NAN);
            stats.numbers += usize::from(!value.is_nan());
            values.push(value);
        }
    }
}

/// True if `next` continues two numbers of a column: in the same direction, by at most a few steps.
pub(crate) fn carries_on(before: f64, last: f64, next: f64) -> bool {
    let step = last - before;
    (next - last) * step > 0.0 && (next - last).abs() <= 20.0 * step.abs()
}
