//! Refusals of texts that hold no table, each with the line at fault.

use super::alternating;
use super::block::NoTable;
use super::pick;
use crate::io::error::quoted;
use crate::io::text::dialect::{Dialect, MOST_COLUMNS};
use crate::io::text::lines;
use crate::io::text::number::number;
use crate::io::{Input, ReadError, budget};
use crate::languages::said;

/// The expected content stated in a refusal.
pub(crate) const A_TABLE: &str = later!("two or more columns of numbers: wavelengths and values");

/// A line longer than this, in bytes, is named by its length.
const LONG_LINE: usize = 1 << 20;

pub(crate) fn refusal(input: &Input, text: &str, why: NoTable) -> ReadError {
    match why {
        NoTable::Bad(bad) => bad.refusal(input),
        NoTable::At {
            line,
            found,
            expected,
        } => input.error_at(line, found, expected),
        NoTable::NoRows => no_rows(input, text),
    }
}

fn no_rows(input: &Input, text: &str) -> ReadError {
    let start = pick::start(text);
    let is_part = start.len() < text.len();
    let size = budget::in_words(start.len());
    if let Some((count, line)) = alternating::lone_numbers(start) {
        let found = match is_part {
            true => tr!("more than {n} line of one number"
                | "more than {n} lines of one number each" % count),
            false => {
                tr!("{n} line of one number" | "{n} lines of one number each" % count)
            }
        };
        let error = input.error(found, said!("a wavelength beside each value"));
        return error.at_line(line);
    }
    if let Some((line, long)) = lines(start).find(|(_, line)| line.len() > LONG_LINE) {
        let found = tr!("a line of {size}", size = budget::in_words(long.len()));
        let expected = tr!("rows of at most {most} columns", most = MOST_COLUMNS);
        return input.error(found, expected).at_line(line);
    }
    let mut rows = lines(start).filter(|(_, line)| is_row(line));
    if let Some((line, _)) = rows.next() {
        let found = match rows.next() {
            Some(_) => said!("rows of numbers, no two below one another with as many"),
            None => said!("one row of numbers"),
        };
        return input.error(found, said!("two rows at least")).at_line(line);
    }
    let Some((line, first)) = lines(start).find(|(_, line)| !line.trim().is_empty()) else {
        let found = match is_part {
            true => tr!("{size} of blank lines", size),
            false => said!("blank lines").to_owned(),
        };
        return input.error(found, said(A_TABLE)).at_line(1);
    };
    let first = quoted(first);
    let found = match is_part {
        true => tr!("no table in {size} after {first}", size, first),
        false => tr!("no table after {first}", first),
    };
    input.error(found, said(A_TABLE)).at_line(line)
}

/// True if a line consists of numbers only, at least two, however separated.
fn is_row(line: &str) -> bool {
    let mut cells = Vec::new();
    let begins = |c: char| c.is_ascii_digit() || ['+', '-', '.'].contains(&c);
    line.len() <= LONG_LINE
        && line.trim_start().starts_with(begins)
        && Dialect::ALL.into_iter().any(|dialect| {
            dialect.split(line, &mut cells);
            let is_number = |cell: &&str| number(cell, dialect.decimal_comma).is_some();
            cells.len() > 1 && cells.iter().all(is_number)
        })
}

/// The refusal of tables whose every column or row (`of`) has next to no values.
pub(crate) fn too_sparse(input: &Input, of: &str, line: usize) -> ReadError {
    let found = match of {
        "row" => said!("fewer than two values in every row"),
        _ => said!("fewer than two values in every column"),
    };
    let refusal = input.error(found, said!("at least two values of a spectrum"));
    refusal.at_line(line)
}

/// The refusal of a column of wavelengths, from 0, that a table of `width` does not have.
pub(crate) fn no_such_column(input: &Input, width: usize, column: usize) -> ReadError {
    input.error(
        tr!("a table of {n} columns" | "a table of {n} columns" % width),
        tr!(
            "wavelengths in column {column}, as chosen",
            column = column + 1
        ),
    )
}

pub(crate) fn empty_column(column: usize) -> String {
    tr!(
        "column {column} holds no values and was left out",
        column = column + 1
    )
}
