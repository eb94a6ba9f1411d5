//! `(XY..XY)`: pairs of abscissa and ordinate, any number on a line.
//!
//! With decimal commas, a comma may separate the two numbers as well: before a blank
//! (`400,5, 12,75`), or as the second of three (`400,5,12,75`).

use super::blocks::Curve;
use crate::io::ReadError;
use crate::io::error::quoted;
use crate::io::text::number;

/// Abscissas and ordinates, factors applied.
pub(crate) type Points = (Vec<f64>, Vec<f64>);

/// Reads pairs.
///
/// # Errors
/// [`ReadError`] at the line with a word, an odd number or too many.
pub(crate) fn read(curve: &Curve, notes: &mut Vec<String>) -> Result<Points, ReadError> {
    let (x_factor, y_factor) = curve.factors()?;
    let decimal_comma = curve.decimal_comma;
    let (mut axis, mut values) = (Vec::new(), Vec::new());
    let is_gap = |c: char| c.is_whitespace() || c == ';' || (c == ',' && !decimal_comma);
    // A pair may be broken over two lines.
    let mut abscissa = None;
    for (line, row) in curve.data.rows() {
        let cells = row
            .split(is_gap)
            .flat_map(|cell| parted_by_comma(cell, decimal_comma));
        for cell in cells.filter(|cell| !cell.is_empty()) {
            let word = || {
                curve
                    .input
                    .error_at(line, quoted(cell), said!("pairs of numbers"))
            };
            let value = match cell {
                "?" => f64::NAN,
                _ => number::number(cell, decimal_comma).ok_or_else(word)?,
            };
            match abscissa.take() {
                None => abscissa = Some(value),
                Some(x) => {
                    curve.check_room(axis.len(), line)?;
                    axis.push(x * x_factor);
                    values.push(value * y_factor);
                }
            }
        }
    }
    if abscissa.is_some() {
        notes.push(said!("the last abscissa has no ordinate: dropped").to_owned());
    }
    curve.compare("FIRSTX", axis.first(), (1e-6, 0.0), notes)?;
    curve.compare("LASTX", axis.last(), (1e-6, 0.0), notes)?;
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
