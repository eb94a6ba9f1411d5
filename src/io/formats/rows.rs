//! Rows of numbers under an instrument's own header.

use crate::io::text::{kept_line, lines};
use crate::io::{Input, ReadError, quoted};

/// The lines that are not empty with their numbers, blanks around them removed.
pub(super) fn filled(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let trimmed = lines(text).map(|(line, content)| (line, content.trim()));
    trimmed.filter(|(_, content)| !content.is_empty())
}

/// The numbers of cells, empty ones passed over.
///
/// # Errors
/// The first cell that is not a number, preceded by the count of numbers before it.
pub(super) fn numbers<'r>(
    cells: impl Iterator<Item = &'r str>,
    most: usize,
    number: impl Fn(&str) -> Option<f64>,
) -> Result<Vec<f64>, (usize, &'r str)> {
    let cells = cells.filter(|cell| !cell.is_empty()).take(most).enumerate();
    let numbers = cells.map(|(place, cell)| number(cell).ok_or((place, cell)));
    numbers.collect()
}

/// Rows of equally many numbers.
#[derive(Default)]
pub(super) struct Rows {
    /// The numbers below one another; NaN where one is missing.
    pub columns: Vec<Vec<f64>>,
    /// The line of each row.
    pub lines: Vec<u32>,
}

impl Rows {
    /// Adds a row; true if it is as wide as the first one.
    pub(super) fn add(&mut self, line: usize, row: &[f64]) -> bool {
        if self.lines.is_empty() {
            self.columns = vec![Vec::new(); row.len()];
        }
        self.lines.push(kept_line(line));
        for (column, number) in self.columns.iter_mut().zip(row) {
            column.push(*number);
        }
        self.columns.len() == row.len()
    }

    /// Adds a row of a wavelength and a value with blanks or a semicolon between them.
    ///
    /// # Errors
    /// [`ReadError`] with the cell that is no number, or the row where there are not two.
    pub(super) fn add_pair(
        &mut self,
        input: &Input,
        (line, row): (usize, &str),
        number: impl Fn(&str) -> Option<f64>,
        expected: &str,
    ) -> Result<(), ReadError> {
        let cells = || row.split(['\t', ' ', ';']);
        let pair = match cells().filter(|cell| !cell.is_empty()).take(3).count() {
            2 => numbers(cells(), 2, number).map_err(|(_, cell)| cell),
            _ => Err(row),
        };
        let pair = pair.map_err(|found| input.error_at(line, quoted(found), expected))?;
        self.add(line, &pair);
        Ok(())
    }

    /// The numbers of a column; none where there is no such column, or they were taken before.
    pub(super) fn take(&mut self, column: usize) -> Vec<f64> {
        let column = self.columns.get_mut(column);
        column.map(std::mem::take).unwrap_or_default()
    }
}
