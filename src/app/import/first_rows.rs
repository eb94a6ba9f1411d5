//! The first rows of a file, cut into cells as its table was.

use crate::io::{TableFound, text_lines, used};

/// Rows shown.
const ROWS: usize = 40;

/// Columns shown, and columns offered for the wavelengths.
pub const MOST_COLUMNS: usize = 10;

/// Lines shown of what stands above the table.
const LINES_ABOVE: usize = 3;

/// Letters shown of a cell and of a line.
const CELL_LETTERS: usize = 18;
const LINE_LETTERS: usize = 110;

/// What a column of the file was taken for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColumnRole {
    Wavelengths,
    /// Values of a spectrum.
    Values,
    /// Neither.
    LeftOut,
}

impl ColumnRole {
    /// A word and a mark for it.
    pub fn words(self) -> &'static str {
        match self {
            Self::Wavelengths => said!("λ wavelengths"),
            Self::Values => said!("● values"),
            Self::LeftOut => said!("– left out"),
        }
    }
}

/// The first rows of a file as its table was found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Head {
    /// Lines above the table, the last ones.
    pub above: Vec<String>,
    /// What each shown column was taken for.
    pub roles: Vec<ColumnRole>,
    /// Titles of the shown columns; empty when the line above is none of titles.
    pub titles: Vec<String>,
    /// Cells of the first rows.
    pub rows: Vec<Vec<String>>,
    /// Columns that are not shown.
    pub more_columns: usize,
    /// Whether the wavelengths stand in a row.
    pub along_rows: bool,
}

impl Head {
    /// Columns that are held of every row.
    pub fn width(&self) -> usize {
        self.roles.len()
    }
}

/// The first rows of a text, cut as its table was.
pub(super) fn head(text: &str, table: Option<&TableFound>) -> Head {
    let Some(table) = table else {
        return Head::default();
    };
    let mut head = Head {
        along_rows: table.axis_column.is_none(),
        more_columns: table.width.saturating_sub(MOST_COLUMNS),
        ..Head::default()
    };
    let columns = table.width.min(MOST_COLUMNS);
    head.roles = (0..columns).map(|column| role(table, column)).collect();
    let cut = |line: &str| -> (usize, Vec<String>) {
        let mut cells = Vec::new();
        table.dialect.split(line, &mut cells);
        let shown = cells.iter().take(columns);
        (
            used(&cells),
            shown.map(|cell| shortened(cell, CELL_LETTERS)).collect(),
        )
    };
    let mut above: Vec<&str> = Vec::new();
    for (number, line) in text_lines(text) {
        if number < table.first_line {
            if !line.trim().is_empty() {
                above.push(line);
            }
            continue;
        }
        if head.rows.len() == ROWS {
            break;
        }
        if !line.trim().is_empty() {
            head.rows.push(cut(line).1);
        }
    }
    if let Some(last) = above.last() {
        let (width, titles) = cut(last);
        if width == table.width && width > 1 {
            head.titles = titles;
            above.pop();
        }
    }
    let first = above.len().saturating_sub(LINES_ABOVE);
    head.above = above[first..]
        .iter()
        .map(|line| shortened(line, LINE_LETTERS))
        .collect();
    if first > 0 {
        head.above
            .insert(0, tr!("… {n} lines above" | "… {n} lines above" % first));
    }
    head
}

fn role(table: &TableFound, column: usize) -> ColumnRole {
    match table.axis_column {
        None => ColumnRole::Values,
        Some(axis) if axis == column => ColumnRole::Wavelengths,
        Some(_) if table.values.contains(&column) => ColumnRole::Values,
        Some(_) => ColumnRole::LeftOut,
    }
}

/// A text for the screen: no control signs (fonts have none), and not too long.
fn shortened(text: &str, letters: usize) -> String {
    let clean = |c: char| {
        if c.is_control() || c == '\u{fffd}' {
            ' '
        } else {
            c
        }
    };
    let mut shown: String = text.chars().take(letters).map(clean).collect();
    if text.chars().nth(letters).is_some() {
        shown.push('…');
    }
    shown
}
