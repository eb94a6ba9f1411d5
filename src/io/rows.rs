//! Tables with their wavelengths along a row: one spectrum in each further row.

use super::columns::bad_cell;
use super::dialect::Dialect;
use super::draft::Draft;
use super::heading::Heading;
use super::pick::Table;
use super::text::lines;
use super::{Input, ReadError, Reading};

/// Wavelengths along a row.
pub struct AlongRow<'a> {
    /// The first column with a wavelength.
    pub first: usize,
    /// The wavelengths in the file's unit.
    pub axis: &'a [f64],
    /// The first row of values.
    pub from_row: usize,
    /// Whether the axis says by itself that it counts nanometres.
    pub says_nm: bool,
}

/// Adds the spectra of such a table to a reading.
///
/// # Errors
/// [`ReadError`] for a word among the numbers, or numbers that are no spectrum.
pub fn read_rows(
    input: &Input,
    text: &str,
    dialect: Dialect,
    table: &Table,
    along: &AlongRow,
    reading: &mut Reading,
) -> Result<(), ReadError> {
    let block = &table.block;
    let labels = row_labels(text, dialect, block.lines.as_slice(), along.first);
    let heading = Heading::of(&block.header).shared_by(block.rows());
    let kind_title = titles_before(table, along.first);
    let columns = along.first..along.first + along.axis.len();
    if let Some(bad) = block.bad.iter().find(|bad| columns.contains(&bad.column)) {
        return Err(bad_cell(input, bad));
    }
    for row in along.from_row..block.rows() {
        let label = labels.get(row).filter(|l| !l.is_empty());
        let name = match label {
            Some(label) if label.parse::<f64>().is_ok() => format!("{}, row {label}", input.stem()),
            Some(label) => label.clone(),
            None => format!("{}, row {}", input.stem(), row + 1 - along.from_row),
        };
        let draft = Draft {
            name,
            title: String::new(),
            axis_title: kind_title.clone(),
            says_nm: along.says_nm,
            heading: &heading,
            axis: along.axis,
            values: block.values[columns.clone()]
                .iter()
                .map(|c| c[row])
                .collect(),
            lines: std::slice::from_ref(&block.lines[row]),
            percent_signs: false,
            decimal_comma: dialect.decimal_comma,
        };
        if draft.values.iter().filter(|v| !v.is_nan()).count() < 2 {
            reading.notes.push(format!(
                "line {} holds no values and was left out",
                block.lines[row]
            ));
            continue;
        }
        draft.finish(input, reading)?;
    }
    reading
        .notes
        .push("wavelengths in a row, one spectrum in each further row".to_owned());
    Ok(())
}

/// What stands before the wavelengths in their row ("wavelength (nm)").
fn titles_before(table: &Table, first: usize) -> String {
    (0..first)
        .map(|c| table.titles.whole(c))
        .collect::<Vec<_>>()
        .join(" ")
}

/// The words before the values in each row.
fn row_labels(text: &str, dialect: Dialect, rows: &[u32], first: usize) -> Vec<String> {
    let mut labels = Vec::with_capacity(rows.len());
    let mut cells = Vec::new();
    let mut wanted = rows.iter().copied().peekable();
    for (line, content) in lines(text) {
        let Some(next) = wanted.peek() else { break };
        if line as u64 == u64::from(*next) {
            wanted.next();
            dialect.split(content.trim_matches(' '), &mut cells);
            let words: Vec<&str> = cells
                .iter()
                .take(first)
                .copied()
                .filter(|c| !c.is_empty())
                .collect();
            labels.push(words.join(" "));
        }
    }
    labels
}
