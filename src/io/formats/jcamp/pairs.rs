//! `(XY..XY)`: pairs of abscissa and ordinate, any number on a line.
//!
//! Where decimals are marked by commas, a comma may part the two numbers as well: before a blank
//! (`400,5, 12,75`), or as the second of three (`400,5,12,75`).

use super::blocks::{Block, Data};
use crate::io::error::quoted;
use crate::io::text::number;
use crate::io::{Input, ReadError, budget};

/// Abscissas and ordinates, factors applied.
pub(crate) type Points = (Vec<f64>, Vec<f64>);

/// Reads pairs.
///
/// # Errors
/// [`ReadError`] at the line with a word, an odd number or too many.
pub(crate) fn read(
    input: &Input,
    block: &Block,
    data: &Data,
    decimal_comma: bool,
    most_points: usize,
    notes: &mut Vec<String>,
) -> Result<Points, ReadError> {
    let factor = |label| {
        block
            .number(input, label, decimal_comma)
            .map(|x| x.unwrap_or(1.0))
    };
    let (x_factor, y_factor) = (factor("XFACTOR")?, factor("YFACTOR")?);
    let (mut axis, mut values) = (Vec::new(), Vec::new());
    let is_gap = |c: char| c.is_whitespace() || c == ';' || (c == ',' && !decimal_comma);
    // A pair may be broken over two lines.
    let mut abscissa = None;
    for (line, row) in data.rows() {
        let cells = row
            .split(is_gap)
            .flat_map(|cell| parted_by_comma(cell, decimal_comma));
        for cell in cells.filter(|cell| !cell.is_empty()) {
            let value = match cell {
                "?" => f64::NAN,
                _ => number::number(cell, decimal_comma)
                    .ok_or_else(|| input.error(quoted(cell), "pairs of numbers").at_line(line))?,
            };
            match abscissa.take() {
                None => abscissa = Some(value),
                Some(x) => {
                    if axis.len() >= most_points {
                        return Err(too_many(input, line));
                    }
                    axis.push(x * x_factor);
                    values.push(value * y_factor);
                }
            }
        }
    }
    if abscissa.is_some() {
        notes.push("the last abscissa has no ordinate: dropped".to_owned());
    }
    for (label, found) in [("FIRSTX", axis.first()), ("LASTX", axis.last())] {
        if let (Some(said), Some(found)) = (block.number(input, label, decimal_comma)?, found)
            && (said - found).abs() > 1e-6 * said.abs().max(found.abs())
        {
            notes.push(format!("{label} says {said}, found {found}"));
        }
    }
    Ok((axis, values))
}

/// The one or two numbers of a cell between blanks: a comma at its end, and the middle one of
/// three, part numbers whose decimals are marked by commas too.
fn parted_by_comma(cell: &str, decimal_comma: bool) -> [&str; 2] {
    if !decimal_comma {
        return [cell, ""];
    }
    let cell = cell.trim_end_matches(',');
    let mut commas = cell.match_indices(',').map(|(at, _)| at);
    match (commas.next(), commas.next(), commas.next(), commas.next()) {
        (Some(_), Some(middle), Some(_), None) => [&cell[..middle], &cell[middle + 1..]],
        _ => [cell, ""],
    }
}

/// The refusal of points beyond what a file of its size may unfold to.
pub(crate) fn too_many(input: &Input, line: usize) -> ReadError {
    input
        .error("far more points than the file has text", budget::TEXT_WORDS)
        .at_line(line)
}
