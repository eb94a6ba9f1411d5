//! Refusals of texts that hold no table, each with the line at fault.

use super::alternating;
use super::pick::{self, NoTable};
use super::scan::TooMuch;
use crate::io::error::quoted;
use crate::io::text::dialect::{Dialect, MOST_COLUMNS};
use crate::io::text::lines;
use crate::io::text::number::number;
use crate::io::{Input, ReadError, budget};

/// What a refusal asks for.
pub(crate) const A_TABLE: &str = "two or more columns of numbers: wavelengths and values";

/// A line longer than this, in bytes, is named by its length.
const LONG_LINE: usize = 1 << 20;

/// The refusal of a text.
pub(crate) fn refusal(input: &Input, text: &str, why: NoTable) -> ReadError {
    match why {
        NoTable::TooMany(too_much) => too_many(input, too_much),
        NoTable::Bad(bad) => bad.refusal(input),
        NoTable::NoWavelengths {
            line,
            found,
            expected,
        } => input.error(found, expected).at_line(line),
        NoTable::NoRows => no_rows(input, text),
    }
}

fn too_many(input: &Input, too_much: TooMuch) -> ReadError {
    match too_much {
        TooMuch::Cells { line } => input
            .error("more than 64 million numbers", "a smaller table")
            .at_line(line),
        TooMuch::Columns { line, found } => {
            let most = format!("at most {MOST_COLUMNS} columns");
            input.error(format!("{found} columns"), most).at_line(line)
        }
        TooMuch::Blocks { line, found } => input
            .error(format!("{found} tables of a few rows each"), budget::WORDS)
            .at_line(line),
    }
}

fn no_rows(input: &Input, text: &str) -> ReadError {
    let start = pick::start(text);
    let is_part = start.len() < text.len();
    let size = budget::in_words(start.len());
    if let Some((count, line)) = alternating::lone_numbers(start) {
        let more = if is_part { "more than " } else { "" };
        let found = format!("{more}{count} lines of one number each");
        let error = input.error(found, "a wavelength beside each value");
        return error.at_line(line);
    }
    if let Some((line, long)) = lines(start).find(|(_, line)| line.len() > LONG_LINE) {
        let found = format!("a line of {}", budget::in_words(long.len()));
        let expected = format!("rows of at most {MOST_COLUMNS} columns");
        return input.error(found, expected).at_line(line);
    }
    let mut rows = lines(start).filter(|(_, line)| is_row(line));
    if let Some((line, _)) = rows.next() {
        let found = match rows.next() {
            Some(_) => "rows of numbers, no two below one another with as many",
            None => "one row of numbers",
        };
        return input.error(found, "two rows at least").at_line(line);
    }
    let Some((line, first)) = lines(start).find(|(_, line)| !line.trim().is_empty()) else {
        let found = match is_part {
            true => format!("{size} of blank lines"),
            false => "blank lines".to_owned(),
        };
        return input.error(found, A_TABLE).at_line(1);
    };
    let of_part = if is_part {
        format!(" in {size}")
    } else {
        String::new()
    };
    let found = format!("no table{of_part} after {}", quoted(first));
    input.error(found, A_TABLE).at_line(line)
}

/// Whether a line is numbers and nothing else, two at least, however they are set apart.
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
    let found = format!("fewer than two values in every {of}");
    let refusal = input.error(found, "at least two values of a spectrum");
    refusal.at_line(line)
}

/// The refusal of a column of wavelengths, from 0, that a table of `width` does not have.
pub(crate) fn no_such_column(input: &Input, width: usize, column: usize) -> ReadError {
    input.error(
        format!("a table of {width} columns"),
        format!("wavelengths in column {}, as chosen", column + 1),
    )
}

/// What is said of a column without values.
pub(crate) fn empty_column(column: usize) -> String {
    format!("column {} holds no values and was left out", column + 1)
}

#[cfg(test)]
mod tests {
    use crate::io::{ReadError, read_bytes};

    fn refusal(text: &str) -> ReadError {
        read_bytes("a.csv", text.as_bytes()).unwrap_err()
    }

    #[test]
    fn more_columns_than_are_read_are_refused_with_their_number_and_the_limit() {
        for mark in [",", ";", "\t"] {
            let row = |first: &str, cell: &str| {
                format!("{first}{}\n", (mark.to_owned() + cell).repeat(70_000))
            };
            let rows = row("380", "1") + &row("390", "2");
            for text in [
                rows.clone(),
                row("nm", "a") + &rows,
                "x".to_owned() + &mark.repeat(70_000),
            ] {
                let said = refusal(&text).to_string();
                let expected = "found 70001 columns, expected at most 65536 columns";
                assert_eq!(said, format!("a.csv, line 1: {expected}"));
            }
        }
        let blanks = "1 ".repeat(70_000);
        assert_eq!(refusal(&blanks).found, "70000 columns");
    }

    #[test]
    fn words_with_blanks_between_them_are_no_columns_however_many() {
        let words = "lorem ".repeat(70_000) + "\n";
        assert!(refusal(&words).found.starts_with("no table after"));
        let table = words + "380 1\n390 2\n400 3\n";
        assert!(read_bytes("a.txt", table.as_bytes()).is_ok());
    }

    #[test]
    fn a_long_text_is_looked_at_in_part_and_the_refusal_says_so() {
        for (line, found) in [
            ("a1", "no table in 732 KiB after \"a1\""),
            (" ", "488 KiB of blank lines"),
            ("0.5", "more than 250000 lines of one number each"),
        ] {
            let text = format!("{line}\n").repeat(300_000);
            assert_eq!(refusal(&text).found, found);
        }
    }

    #[test]
    fn a_row_alone_and_wavelengths_below_zero_are_refused_as_that() {
        let expected = "found one row of numbers, expected two rows at least";
        for text in ["500,1\n", "nm W\n500 1\nend\n"] {
            let said = refusal(text).to_string();
            assert!(said.ends_with(expected), "{said}");
        }
        let two = refusal("500,1\n505,1,2\n").found;
        assert!(two.starts_with("rows of numbers"), "{two}");
        let rows: String = (0..20).map(|i| format!("{},1.5\n", 5 * i - 5)).collect();
        let expected = "a.csv, line 1: found -5 in column 1, expected wavelengths above zero";
        assert_eq!(refusal(&rows).to_string(), expected);
    }

    #[test]
    fn a_table_behind_a_long_header_is_read_whole() {
        let header = "some words and the number 12\n".repeat(200_000);
        let rows: String = (0..60_000)
            .map(|i| format!("{},1\n", 300.0 + 0.01 * f64::from(i)))
            .collect();
        let reading = read_bytes("a.csv", (header + &rows).as_bytes()).unwrap();
        assert_eq!(reading.spectra[0].samples.len(), 60_000);
    }

    #[test]
    fn countless_tables_of_a_few_rows_are_refused_by_their_number() {
        let text = "380 1\n390 2\n400 3\nx\n".repeat(30_000);
        let said = refusal(&text).to_string();
        assert!(said.contains("tables of a few rows each"), "{said}");
    }
}
