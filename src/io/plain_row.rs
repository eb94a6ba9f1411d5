//! Rows of nothing but plain numbers, read in one go over their bytes.
//!
//! A long table is nearly all such rows. Everything else (gaps, quotes, words, units, a number
//! with more figures than a double holds exactly) is left to [`table`](super::table), which looks
//! at a line cell by cell; both ways give the same numbers to the last bit.

use super::dialect::{Delimiter, Dialect};
use super::number::ABSURD;

/// Powers of ten that a double holds exactly: a whole number below 2^53 times or over one of them
/// is rounded once, so that it is the double nearest to the decimal (Clinger 1990).
const EXACT_POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];

/// Whole numbers up to here are doubles.
const EXACT_WHOLE: u64 = 1 << 53;

/// Figures that surely fit into 64 bits.
const MOST_FIGURES: usize = 19;

/// Reads plain rows of one dialect.
#[derive(Debug)]
pub struct PlainRow {
    delimiter: Delimiter,
    mark: u8,
    row: Vec<f64>,
}

impl PlainRow {
    /// A reader for a dialect.
    pub fn new(dialect: Dialect) -> Self {
        Self {
            delimiter: dialect.delimiter,
            mark: if dialect.decimal_comma { b',' } else { b'.' },
            row: Vec::new(),
        }
    }

    /// The numbers of the first line and the place behind its end, if the line is `width` plain
    /// numbers and nothing else.
    pub fn read(&mut self, text: &str, width: usize) -> Option<(&[f64], usize)> {
        let bytes = text.as_bytes();
        self.row.clear();
        let mut at = blanks(bytes, 0);
        if self.delimiter == Delimiter::Space {
            at = blanks_and_tabs(bytes, at);
        }
        loop {
            let (value, past) = number(bytes, at, self.mark)?;
            self.row.push(value);
            let behind = match self.delimiter {
                Delimiter::Space => blanks_and_tabs(bytes, past),
                Delimiter::Tab | Delimiter::Semicolon | Delimiter::Comma => blanks(bytes, past),
            };
            let end = match bytes.get(behind) {
                None => Some(behind),
                Some(b'\n') => Some(behind + 1),
                Some(b'\r') if bytes.get(behind + 1) == Some(&b'\n') => Some(behind + 2),
                Some(b'\r') => Some(behind + 1),
                Some(_) => None,
            };
            if let Some(end) = end {
                return (self.row.len() == width).then_some((&self.row[..], end));
            }
            if self.row.len() == width {
                return None;
            }
            let separates = |mark: u8| bytes[behind] == mark;
            at = match self.delimiter {
                Delimiter::Space => (behind > past).then_some(behind)?,
                Delimiter::Tab => separates(b'\t').then(|| blanks(bytes, behind + 1))?,
                Delimiter::Semicolon => separates(b';').then(|| blanks(bytes, behind + 1))?,
                Delimiter::Comma => separates(b',').then(|| blanks(bytes, behind + 1))?,
            };
        }
    }
}

fn blanks(bytes: &[u8], from: usize) -> usize {
    let mut at = from;
    while bytes.get(at) == Some(&b' ') {
        at += 1;
    }
    at
}

fn blanks_and_tabs(bytes: &[u8], from: usize) -> usize {
    let mut at = from;
    while matches!(bytes.get(at), Some(b' ' | b'\t')) {
        at += 1;
    }
    at
}

/// A plain number from a place on, and the place behind it; `None` where the slow way must look.
fn number(bytes: &[u8], from: usize, mark: u8) -> Option<(f64, usize)> {
    let mut at = from;
    let is_negative = bytes.get(at) == Some(&b'-');
    if is_negative || bytes.get(at) == Some(&b'+') {
        at += 1;
    }
    let mut whole: u64 = 0;
    let figures_from = at;
    at = figures(bytes, at, &mut whole);
    let mut count = at - figures_from;
    let mut power = 0;
    if bytes.get(at) == Some(&mark) {
        let places_from = at + 1;
        at = figures(bytes, places_from, &mut whole);
        let places = at - places_from;
        if places == 0 {
            // "5." is a number and "5," a word: the slow way knows.
            return None;
        }
        count += places;
        power = -i32::try_from(places).ok()?;
    }
    if count == 0 || count > MOST_FIGURES || whole > EXACT_WHOLE {
        return None;
    }
    if matches!(bytes.get(at), Some(b'e' | b'E')) {
        let (exponent, past) = exponent(bytes, at + 1)?;
        power += exponent;
        at = past;
    }
    let factor = *EXACT_POWERS.get(power.unsigned_abs() as usize)?;
    let size = if power < 0 {
        whole as f64 / factor
    } else {
        whole as f64 * factor
    };
    let value = if is_negative { -size } else { size };
    (size < ABSURD).then_some((value, at))
}

/// Reads figures onto a whole number; more than fit are counted by the caller.
fn figures(bytes: &[u8], from: usize, whole: &mut u64) -> usize {
    let mut at = from;
    while let Some(figure) = bytes.get(at).map(|b| b.wrapping_sub(b'0'))
        && figure < 10
    {
        *whole = whole.wrapping_mul(10).wrapping_add(u64::from(figure));
        at += 1;
    }
    at
}

fn exponent(bytes: &[u8], from: usize) -> Option<(i32, usize)> {
    let mut at = from;
    let is_negative = bytes.get(at) == Some(&b'-');
    if is_negative || bytes.get(at) == Some(&b'+') {
        at += 1;
    }
    let mut size = 0;
    let first = at;
    at = figures(bytes, at, &mut size);
    if at == first || at - first > 4 {
        return None;
    }
    let size = size as i32;
    Some((if is_negative { -size } else { size }, at))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::io::number::{Cell, parse};

    fn dialect(delimiter: Delimiter, decimal_comma: bool) -> Dialect {
        Dialect {
            delimiter,
            decimal_comma,
        }
    }

    fn read(
        text: &str,
        delimiter: Delimiter,
        comma: bool,
        width: usize,
    ) -> Option<(Vec<f64>, usize)> {
        let mut reader = PlainRow::new(dialect(delimiter, comma));
        reader
            .read(text, width)
            .map(|(row, past)| (row.to_vec(), past))
    }

    #[test]
    fn a_plain_row_ends_where_its_line_does() {
        let comma = |text, width| read(text, Delimiter::Comma, false, width);
        assert_eq!(comma("380,0.5\n385", 2), Some((vec![380.0, 0.5], 8)));
        assert_eq!(
            comma(" 380 , -.5e1 \r\nx", 2),
            Some((vec![380.0, -5.0], 15))
        );
        assert_eq!(comma("380,1", 2), Some((vec![380.0, 1.0], 5)));
        let space = |text| read(text, Delimiter::Space, true, 2);
        assert_eq!(space("\t380,5   0,25\r385"), Some((vec![380.5, 0.25], 14)));
    }

    #[test]
    fn whatever_is_not_plain_is_left_to_the_slow_way() {
        for text in [
            "380",
            "380,1,2\n",
            "380,\n",
            "380,NaN\n",
            "380,\"1\"\n",
            "380,1e999\n",
            "380,1e30\n",
            "380,0.12345678901234567890\n",
            "380,5.\n",
            "380nm,1\n",
            "380,1 2\n",
            "380;1\n",
            "",
            "\n",
            "#380,1\n",
            "380,1%\n",
            "380,--1\n",
            "380,1e\n",
        ] {
            assert_eq!(read(text, Delimiter::Comma, false, 2), None, "{text:?}");
        }
    }

    proptest! {
        #[test]
        fn both_ways_read_the_same_bits(
            sign in prop::sample::select(vec!["", "-", "+"]),
            whole in "[0-9]{0,12}",
            places in "[0-9]{0,12}",
            exponent in prop::option::of(-40..40i32),
            comma in any::<bool>(),
        ) {
            let mark = if comma { "," } else { "." };
            let mut cell = format!("{sign}{whole}{mark}{places}");
            if let Some(exponent) = exponent {
                cell.push_str(&format!("e{exponent}"));
            }
            let row = format!("{cell};1\n");
            if let Some((row, _)) = read(&row, Delimiter::Semicolon, comma, 2) {
                let Cell::Number(slow) = parse(&cell, comma) else {
                    return Err(TestCaseError::fail(format!("{cell} is no number")));
                };
                prop_assert_eq!(row[0].to_bits(), slow.to_bits(), "{}", cell);
            }
        }
    }
}
