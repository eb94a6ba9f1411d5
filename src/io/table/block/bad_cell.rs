//! Words that stand among numbers.

use super::Row;
use crate::io::error::quoted;
use crate::io::{Input, ReadError};

/// A word that stands where the column otherwise holds numbers.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct BadCell {
    /// Line in the file, from 1.
    pub line: usize,
    /// Column, from 0.
    pub column: usize,
    pub text: String,
    /// True if its line is certainly a row: its first number carries the column on.
    pub certain: bool,
}

impl BadCell {
    pub(super) fn of(row: &Row, column: usize, certain: bool) -> Self {
        Self {
            line: row.line,
            column,
            text: row.cells[column].to_owned(),
            certain,
        }
    }

    pub(crate) fn refusal(&self, input: &Input) -> ReadError {
        let expected = tr!("a number in column {column}", column = self.column + 1);
        input.error(quoted(&self.text), expected).at_line(self.line)
    }

    /// The note that `what` (the row, the cell) was left out.
    pub(crate) fn left_out(&self, what: &str) -> String {
        let (line, column) = (self.line, self.column + 1);
        let text = quoted(&self.text);
        match what {
            "cell" => tr!(
                "line {line}: found {text} in column {column}: the cell was left out",
                line,
                text,
                column
            ),
            _ => tr!(
                "line {line}: found {text} in column {column}: the row was left out",
                line,
                text,
                column
            ),
        }
    }
}
