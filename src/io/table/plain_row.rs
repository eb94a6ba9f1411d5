//! Rows of nothing but plain numbers, read in one go over their bytes.
//!
//! A long table is nearly all such rows. Everything else (gaps, quotes, words, units) is left to
//! [`block`](super::block), which looks at a line cell by cell; both ways give the same numbers to
//! the last bit.

use crate::io::text::dialect::Dialect;
use crate::io::text::number;

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
///
/// The rows of a table look alike, so a cell is first tried in the shape of the one above it. Where
/// that holds, the place of the next cell is known before this one's figures are, and the processor
/// works on several cells at a time.
#[derive(Debug)]
pub(crate) struct PlainRow {
    /// What stands between two cells; `None` for blanks and TABs in any number.
    separator: Option<u8>,
    mark: u8,
    row: Vec<f64>,
    /// How each column's last cell was written.
    shapes: Vec<Shape>,
}

/// How a number without sign and exponent is written, eight figures at most; masks over eight bytes
/// of which the first is lowest.
#[derive(Clone, Copy, Debug, Default)]
struct Shape {
    /// Figures before the mark; none for a number of another kind.
    before: usize,
    /// Figures behind the mark; there is no mark without them.
    behind: usize,
    /// The high bit of the byte behind the figures before the mark, and of that behind the others.
    stops: [u64; 2],
    /// How far the figures have to move to stand behind zeros.
    shift: u32,
    /// What the figures, as a whole number, are divided by.
    divisor: f64,
}

impl PlainRow {
    /// A reader for a dialect.
    pub(crate) fn new(dialect: Dialect) -> Self {
        Self {
            separator: dialect.mark(),
            mark: if dialect.decimal_comma { b',' } else { b'.' },
            row: Vec::new(),
            shapes: Vec::new(),
        }
    }

    /// The numbers of the first line and the place behind its end, if the line is `width` plain
    /// numbers and nothing else.
    pub(crate) fn read(&mut self, text: &str, width: usize) -> Option<(&[f64], usize)> {
        let bytes = text.as_bytes();
        self.row.resize(width, 0.0);
        self.shapes.resize(width, Shape::default());
        let separator = self.separator;
        // Where one mark does both, cells are quoted, and not plain.
        if separator == Some(self.mark) {
            return None;
        }
        let blanks = |from| match separator {
            Some(_) => past(bytes, from, |byte| byte == b' '),
            None => past(bytes, from, |byte| matches!(byte, b' ' | b'\t')),
        };
        let mut at = blanks(0);
        let (last, others) = self.row.split_last_mut()?;
        let (last_shape, shapes) = self.shapes.split_last_mut()?;
        for (cell, shape) in others.iter_mut().zip(shapes) {
            let (value, past) = cell_at(bytes, at, self.mark, shape)?;
            *cell = value;
            let behind = blanks(past);
            at = match separator {
                Some(mark) if bytes.get(behind) == Some(&mark) => blanks(behind + 1),
                None if behind > past => behind,
                _ => return None,
            };
        }
        let (value, past) = cell_at(bytes, at, self.mark, last_shape)?;
        *last = value;
        let behind = blanks(past);
        let end = match bytes.get(behind) {
            None => behind,
            Some(b'\n') => behind + 1,
            Some(b'\r') if bytes.get(behind + 1) == Some(&b'\n') => behind + 2,
            Some(b'\r') => behind + 1,
            Some(_) => return None,
        };
        Some((&self.row, end))
    }
}

/// The place behind all bytes of a kind.
#[inline(always)]
fn past(bytes: &[u8], from: usize, is_one: impl Fn(u8) -> bool) -> usize {
    let mut at = from;
    while bytes.get(at).is_some_and(|byte| is_one(*byte)) {
        at += 1;
    }
    at
}

/// Whether a minus stands at a place, and the place behind it or behind a plus.
fn sign(bytes: &[u8], at: usize) -> (bool, usize) {
    match bytes.get(at) {
        Some(b'-') => (true, at + 1),
        Some(b'+') => (false, at + 1),
        _ => (false, at),
    }
}

/// As [`plain`], first in the shape of the cell above.
#[inline(always)]
fn cell_at(bytes: &[u8], from: usize, mark: u8, shape: &mut Shape) -> Option<(f64, usize)> {
    if let Some(found) = shape.read(bytes, from, mark) {
        return Some(found);
    }
    let (value, past, found) = plain(bytes, from, mark)?;
    *shape = found;
    Some((value, past))
}

impl Shape {
    /// `before` figures, 1 to 7, and `behind` more behind a mark; eight together at most.
    fn new(before: usize, behind: usize) -> Self {
        Self {
            before,
            behind,
            stops: [before, behind].map(|count| 0x80 << (8 * count)),
            shift: 64 - 8 * (before + behind) as u32,
            divisor: EXACT_POWERS[behind],
        }
    }

    /// A number of this shape with nothing of a number behind it, and the place behind it.
    #[inline(always)]
    fn read(&self, bytes: &[u8], from: usize, mark: u8) -> Option<(f64, usize)> {
        if self.before == 0 {
            return None;
        }
        let head = eight_at(bytes, from)?;
        let at_mark = from + self.before;
        let next = *bytes.get(at_mark)?;
        if !stops_at(head, self.stops[0]) {
            return None;
        }
        if self.behind == 0 {
            let ends = !matches!(next, b'e' | b'E') && next != mark;
            return ends.then(|| (all_joined(head << self.shift) as f64, at_mark));
        }
        let tail = eight_at(bytes, at_mark + 1)?;
        let past = at_mark + 1 + self.behind;
        if next != mark
            || !stops_at(tail, self.stops[1])
            || matches!(bytes.get(past), Some(b'e' | b'E'))
        {
            return None;
        }
        let figures = side_by_side(head, self.before, tail);
        let whole = all_joined(figures << self.shift) as f64;
        Some((whole / self.divisor, past))
    }
}

/// A plain number from a place on, the place behind it, and its shape; `None` where the slow way
/// must look.
#[inline(never)]
fn plain(bytes: &[u8], from: usize, mark: u8) -> Option<(f64, usize, Shape)> {
    let (is_negative, mut at) = sign(bytes, from);
    let mut shape = Shape::default();
    let (whole, places, past) = match short(bytes, at, mark) {
        Some((whole, places, past)) => {
            if at == from {
                let marks = usize::from(places > 0);
                shape = Shape::new(past - at - places - marks, places);
            }
            (Some(whole), places, past)
        }
        None => long(bytes, at, mark)?,
    };
    at = past;
    let mut power = -i32::try_from(places).ok()?;
    if matches!(bytes.get(at), Some(b'e' | b'E')) {
        let (exponent, past) = exponent(bytes, at + 1)?;
        power += exponent;
        at = past;
        shape = Shape::default();
    }
    let factor = EXACT_POWERS.get(power.unsigned_abs() as usize);
    let value = match (whole, factor) {
        (Some(whole), Some(factor)) => {
            let size = if power < 0 {
                whole as f64 / factor
            } else {
                whole as f64 * factor
            };
            if is_negative { -size } else { size }
        }
        // More figures than a double holds.
        _ => {
            let cell = std::str::from_utf8(&bytes[from..at]).ok()?;
            number::number(cell, mark == b',')?
        }
    };
    number::is_measured(value).then_some((value, at, shape))
}

/// The figures of a number as one whole number, how many of them stand behind the mark, and the
/// place behind them, where they are eight at most: the usual case.
fn short(bytes: &[u8], from: usize, mark: u8) -> Option<(u64, usize, usize)> {
    let head = eight_at(bytes, from)?;
    let before = leading_count(head);
    if before == 0 || before == 8 {
        return None;
    }
    if bytes[from + before] != mark {
        return Some((joined(head, before), 0, from + before));
    }
    let tail = eight_at(bytes, from + before + 1)?;
    let behind = leading_count(tail);
    let count = before + behind;
    if behind == 0 || count > 8 {
        return None;
    }
    let both = side_by_side(head, before, tail);
    Some((joined(both, count), behind, from + count + 1))
}

/// The figures on either side of a mark together: `before` of one, 1 to 7, and those of the other.
fn side_by_side(head: u64, before: usize, tail: u64) -> u64 {
    head & ((1 << (8 * before)) - 1) | (tail << (8 * before))
}

/// The same for any number of figures, without the whole number where they do not surely fit;
/// `None` where the slow way must look.
fn long(bytes: &[u8], from: usize, mark: u8) -> Option<(Option<u64>, usize, usize)> {
    let mut whole: u64 = 0;
    let mut at = figures(bytes, from, &mut whole);
    let mut count = at - from;
    let mut places = 0;
    if bytes.get(at) == Some(&mark) {
        let places_from = at + 1;
        at = figures(bytes, places_from, &mut whole);
        places = at - places_from;
        if places == 0 {
            // "5." is a number and "5," a word: the slow way knows.
            return None;
        }
        count += places;
    }
    let fits = count <= MOST_FIGURES && whole <= EXACT_WHOLE;
    (count > 0).then_some((fits.then_some(whole), places, at))
}

/// Powers of ten by which up to eight more figures move a whole number.
const MOVES: [u64; 9] = [
    1,
    10,
    100,
    1_000,
    10_000,
    100_000,
    1_000_000,
    10_000_000,
    100_000_000,
];

/// Reads figures onto a whole number; more than fit are counted by the caller.
///
/// Eight bytes are looked at together (SIMD within a register): numbers of tables mostly have
/// two to eight figures on either side of the mark.
fn figures(bytes: &[u8], from: usize, whole: &mut u64) -> usize {
    let mut at = from;
    while let Some(eight) = eight_at(bytes, at) {
        let count = leading_count(eight);
        if count > 0 {
            *whole = whole
                .wrapping_mul(MOVES[count])
                .wrapping_add(joined(eight, count));
        }
        at += count;
        if count < 8 {
            return at;
        }
    }
    while let Some(figure) = bytes.get(at).map(|b| b.wrapping_sub(b'0'))
        && figure < 10
    {
        *whole = whole.wrapping_mul(10).wrapping_add(u64::from(figure));
        at += 1;
    }
    at
}

/// Eight bytes from a place on, less the character zero each; the first of them lowest.
fn eight_at(bytes: &[u8], at: usize) -> Option<u64> {
    let eight = bytes.get(at..)?.first_chunk::<8>()?;
    Some(u64::from_le_bytes(*eight) ^ (u64::from(b'0') * EACH))
}

/// A byte of 1 in each of eight.
const EACH: u64 = 0x0101_0101_0101_0101;

/// How many of eight bytes, less the character zero, are figures from the first on.
fn leading_count(eight: u64) -> usize {
    // The high bit of every byte above 9. A carry out of a byte disturbs only bytes behind it, and
    // nothing behind the first mark counts.
    let marks = (eight.wrapping_add(0x76 * EACH) | eight) & (0x80 * EACH);
    marks.trailing_zeros() as usize / 8
}

/// Whether eight bytes, less the character zero, are figures up to the byte with this high bit and
/// that one is none.
fn stops_at(eight: u64, stop: u64) -> bool {
    let marks = (eight.wrapping_add(0x76 * EACH) | eight) & (0x80 * EACH);
    marks & (stop | (stop - 1)) == stop
}

/// The number that the first `count` of eight figures write, 1 to 8.
fn joined(eight: u64, count: usize) -> u64 {
    all_joined(eight << (64 - 8 * count))
}

/// The number of eight figures, the first of them lowest.
fn all_joined(moved: u64) -> u64 {
    // Neighbours are joined to pairs, pairs to fours, fours to eight.
    let pairs = moved.wrapping_mul(10).wrapping_add(moved >> 8) & 0x00ff_00ff_00ff_00ff;
    let fours = pairs.wrapping_mul(100).wrapping_add(pairs >> 16) & 0x0000_ffff_0000_ffff;
    fours.wrapping_mul(10_000).wrapping_add(fours >> 32) & 0xffff_ffff
}

fn exponent(bytes: &[u8], from: usize) -> Option<(i32, usize)> {
    let (is_negative, first) = sign(bytes, from);
    let mut size = 0;
    let at = figures(bytes, first, &mut size);
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
    use crate::io::text::dialect::Delimiter;
    use crate::io::text::number::{Cell, parse};

    fn read(text: &str, dialect: Dialect, width: usize) -> Option<(Vec<f64>, usize)> {
        let mut reader = PlainRow::new(dialect);
        let row = reader.read(text, width);
        row.map(|(row, past)| (row.to_vec(), past))
    }

    const COMMA: Dialect = Dialect::new(Delimiter::Comma, false);

    #[test]
    fn a_plain_row_ends_where_its_line_does() {
        let space = Dialect::new(Delimiter::Space, true);
        for (dialect, text, row, past) in [
            (COMMA, "380,0.5\n385", [380.0, 0.5], 8),
            (COMMA, " 380 , -.5e1 \r\nx", [380.0, -5.0], 15),
            (COMMA, "380,1", [380.0, 1.0], 5),
            (space, "\t380,5   0,25\r385", [380.5, 0.25], 14),
        ] {
            assert_eq!(read(text, dialect, 2), Some((row.to_vec(), past)));
        }
    }

    #[test]
    fn whatever_is_not_plain_is_left_to_the_slow_way() {
        let odd = "380|380,1,2\n|380,\n|380,NaN\n|380,\"1\"\n|380,1e999\n|380,1e30\n|380,5.\n|\
             380nm,1\n|380,1 2\n|380;1\n||\n|#380,1\n|380,1%\n|380,--1\n|380,1e\n";
        for text in odd.split('|') {
            assert_eq!(read(text, COMMA, 2), None, "{text:?}");
        }
    }

    proptest! {
        #[test]
        fn eight_bytes_at_once_are_read_as_one_by_one(
            text in "[0-9]{0,24}",
            behind in prop::collection::vec(any::<u8>(), 0..12),
        ) {
            let bytes = [text.as_bytes(), &behind].concat();
            let mut slow = 0_u64;
            let figures_in = bytes.iter().take_while(|b| b.is_ascii_digit());
            let mut count = 0;
            for figure in figures_in {
                slow = slow.wrapping_mul(10).wrapping_add(u64::from(figure - b'0'));
                count += 1;
            }
            let mut fast = 0;
            prop_assert_eq!(figures(&bytes, 0, &mut fast), count);
            prop_assert_eq!(fast, slow);
        }

        #[test]
        fn both_ways_read_the_same_bits(
            sign in prop::sample::select(vec!["", "-", "+"]),
            whole in "[0-9]{0,12}",
            places in "[0-9]{0,24}",
            exponent in prop::option::of(-40..40i32),
            comma in any::<bool>(),
        ) {
            let mark = if comma { "," } else { "." };
            let mut cell = format!("{sign}{whole}{mark}{places}");
            if let Some(exponent) = exponent {
                cell.push_str(&format!("e{exponent}"));
            }
            let row = format!("{cell};1\n");
            if let Some((row, _)) = read(&row, Dialect::new(Delimiter::Semicolon, comma), 2) {
                let Cell::Number(slow) = parse(&cell, comma) else {
                    return Err(TestCaseError::fail(format!("{cell} is no number")));
                };
                prop_assert_eq!(row[0].to_bits(), slow.to_bits(), "{}", cell);
            }
        }

        #[test]
        fn a_cell_below_another_is_read_as_it_would_be_alone(
            cells in prop::collection::vec(
                "[-+]?[0-9]{1,9}([.][0-9]{1,9})?(e-?[0-9])?", 1..12
            ),
            behind in prop::sample::select(vec!["", " ", "e", ".", "x"]),
        ) {
            let dialect = Dialect::new(Delimiter::Semicolon, false);
            let mut reader = PlainRow::new(dialect);
            for cell in cells {
                let row = format!("{cell}{behind};{cell}\n");
                let below = reader.read(&row, 2).map(|(row, past)| (row.to_vec(), past));
                prop_assert_eq!(below, read(&row, dialect, 2), "{}", row);
            }
        }
    }
}
