//! `(X++(Y..Y))`: lines of one abscissa and many ordinates, plain (AFFN) or packed (ASDF).
//!
//! In the packed forms a letter represents the first digit and the sign of a number, so that
//! numbers need no separator:
//!
//! ```text
//! SQZ  @ = 0   A..I = 1..9   a..i = -1..-9    an ordinate
//! DIF  % = 0   J..R = 1..9   j..r = -1..-9    its difference from the one before
//! DUP          S..Z = 1..8       s = 9        the one before, this many times in all
//! PAC  + or - in front of every number
//! ```
//!
//! When a line ends in differences, the next one starts with the last ordinate again as a check,
//! and its abscissa belongs to that ordinate. Abscissas are evenly spaced from FIRSTX to LASTX;
//! those at the line starts are rounded and only compared.

use super::blocks::Curve;
use super::pairs::Points;
use crate::io::ReadError;
use crate::io::error::quoted;
use crate::io::text::number;
use crate::languages::with_sign;

/// The form of a number on a line.
#[derive(Clone, Copy, PartialEq)]
enum Form {
    /// A number without a letter: the abscissa, then ordinates.
    Plain,
    Value,
    Difference,
    /// The total count of repetitions of the number before.
    Repeat,
    /// A question mark for a missing ordinate.
    Gap,
}

/// The letters that are first digits: from and to, the form of the number, the digit and the sign
/// of the first one.
const LETTERS: [(u8, u8, Form, u8, f64); 7] = [
    (b'@', b'I', Form::Value, 0, 1.0),
    (b'a', b'i', Form::Value, 1, -1.0),
    (b'%', b'%', Form::Difference, 0, 1.0),
    (b'J', b'R', Form::Difference, 1, 1.0),
    (b'j', b'r', Form::Difference, 1, -1.0),
    (b'S', b'Z', Form::Repeat, 1, 1.0),
    (b's', b's', Form::Repeat, 9, 1.0),
];

/// The number that starts at a byte, its form, and where it ends.
fn number_at(row: &str, at: usize, decimal_comma: bool) -> Option<(Form, f64, usize)> {
    let bytes = row.as_bytes();
    let byte = bytes[at];
    if byte == b'?' {
        return Some((Form::Gap, f64::NAN, at + 1));
    }
    let letter = |(from, to, form, digit, sign): (u8, u8, Form, u8, f64)| {
        (from..=to)
            .contains(&byte)
            .then(|| (form, sign, digit + (byte - from)))
    };
    let packed = LETTERS.into_iter().find_map(letter);
    let past_digits = |from: usize| {
        let rest = bytes[from..].iter();
        from + rest.take_while(|b| b.is_ascii_digit()).count()
    };
    let has_sign = packed.is_some() || matches!(byte, b'+' | b'-');
    let mut end = past_digits(at + usize::from(has_sign));
    let is_count = packed.is_some_and(|(form, ..)| form == Form::Repeat);
    let is_mark = |b: &u8| !is_count && (*b == b'.' || (decimal_comma && *b == b','));
    if bytes.get(end).is_some_and(is_mark) {
        end = past_digits(end + 1);
    }
    // An exponent has a sign; without one an E is the packed digit 5.
    if let Some([b'E' | b'e', b'+' | b'-', b'0'..=b'9']) = bytes.get(end..end + 3)
        && !is_count
    {
        end = past_digits(end + 3);
    }
    // Letters and digits are ASCII, so that these are character boundaries.
    let text = row.get(at..end)?;
    let Some((form, sign, digit)) = packed else {
        return Some((Form::Plain, number::number(text, decimal_comma)?, end));
    };
    let text = format!("{digit}{}", text.get(1..)?);
    Some((form, sign * number::number(&text, decimal_comma)?, end))
}

/// The start of a line: its abscissa, and which of the points it belongs to.
struct Start {
    line: usize,
    x: f64,
    index: usize,
}

/// The points of a block as they are unpacked.
struct Unpacked<'c, 'b, 'i> {
    curve: &'c Curve<'b, 'i>,
    /// Ordinates in the file's whole numbers; NaN for a missing one.
    values: Vec<f64>,
    starts: Vec<Start>,
    /// Lines whose check is wrong: the first, and their count.
    wrong: Option<(usize, usize)>,
}

/// Reads lines of ordinates.
///
/// # Errors
/// [`ReadError`] at the line with something that is no number, or with too many.
pub(crate) fn read(curve: &Curve, notes: &mut Vec<String>) -> Result<Points, ReadError> {
    let (x_factor, y_factor) = curve.factors()?;
    let mut unpacked = Unpacked {
        curve,
        values: Vec::new(),
        starts: Vec::new(),
        wrong: None,
    };
    // Whether the line before ended in differences, so that a check follows.
    let mut check_follows = false;
    for (line, row) in curve.data.rows() {
        check_follows = unpacked.line(row, line, check_follows)?;
    }
    let Unpacked {
        mut starts,
        mut values,
        wrong,
        ..
    } = unpacked;
    if let Some((line, count)) = wrong {
        notes.push(tr!(
            "{n} of {checks} checks at line starts are wrong, the first at line {line}"
                | "{n} of {checks} checks at line starts are wrong, the first at line {line}"
                    % count,
            checks = starts.len(),
            line
        ));
    }
    starts.iter_mut().for_each(|start| start.x *= x_factor);
    values.iter_mut().for_each(|value| *value *= y_factor);
    let grid = Grid {
        first: curve.number("FIRSTX")?,
        last: curve.number("LASTX")?,
        delta: curve.number("DELTAX")?,
        announced: curve.number("NPOINTS")?,
    };
    let axis = grid.axis(&starts, values.len(), notes);
    curve.compare("FIRSTY", values.first(), (1e-4, y_factor.abs()), notes)?;
    Ok((axis, values))
}

impl Unpacked<'_, '_, '_> {
    /// Unpacks a line; returns true if it ends in differences.
    fn line(&mut self, row: &str, line: usize, check_follows: bool) -> Result<bool, ReadError> {
        let (bytes, decimal_comma) = (row.as_bytes(), self.curve.decimal_comma);
        let is_gap = |b: u8| b.is_ascii_whitespace() || b == b';' || (b == b',' && !decimal_comma);
        let input = self.curve.input;
        let odd = |at: usize| {
            let found = quoted(row.get(at..).unwrap_or(row));
            input.error_at(
                line,
                found,
                said!("an abscissa and ordinates, plain or packed"),
            )
        };
        let mut at = 0;
        let mut has_abscissa = false;
        let mut last: Option<(Form, f64)> = None;
        let mut checking = check_follows;
        while at < bytes.len() {
            if is_gap(bytes[at]) {
                at += 1;
                continue;
            }
            let (form, value, past) = number_at(row, at, decimal_comma).ok_or_else(|| odd(at))?;
            match form {
                Form::Repeat => {
                    let (form, repeated) = last.ok_or_else(|| odd(at))?;
                    for _ in 1..value as u64 {
                        self.put(form, repeated, line)?;
                    }
                }
                Form::Difference if !has_abscissa => return Err(odd(at)),
                Form::Plain | Form::Value if !has_abscissa => {
                    has_abscissa = true;
                    let (x, index) = (value, self.values.len() - usize::from(check_follows));
                    self.starts.push(Start { line, x, index });
                }
                _ => {
                    if checking && matches!(form, Form::Plain | Form::Value) {
                        self.check(value, line);
                    } else {
                        self.put(form, value, line)?;
                    }
                    checking = false;
                    last = Some((form, value));
                }
            }
            at = past;
        }
        Ok(matches!(last, Some((Form::Difference, _))))
    }

    fn put(&mut self, form: Form, value: f64, line: usize) -> Result<(), ReadError> {
        self.curve.check_room(self.values.len(), line)?;
        let before = self.values.last().copied().unwrap_or(0.0);
        self.values.push(match form {
            Form::Difference => before + value,
            _ => value,
        });
        Ok(())
    }

    /// Compares the ordinate at a line's start with the last one.
    fn check(&mut self, value: f64, line: usize) {
        // Ordinates are whole numbers; half of one is rounding.
        if let Some(last) = self.values.last_mut()
            && (*last - value).abs() > 0.5
        {
            // The stated ordinate is right: an error does not run on.
            *last = value;
            let (first, count) = self.wrong.unwrap_or((line, 0));
            self.wrong = Some((first, count + 1));
        }
    }
}

/// A block's statements about its abscissas.
struct Grid {
    first: Option<f64>,
    last: Option<f64>,
    delta: Option<f64>,
    announced: Option<f64>,
}

impl Grid {
    /// True if every line start agrees with the ends swapped, and not with the ends as labelled:
    /// the abscissa beside a number takes precedence over a label.
    fn is_turned(&self, starts: &[Start], count: usize) -> bool {
        let (Some(first), Some(last), 2..) = (self.first, self.last, count) else {
            return false;
        };
        let step = (last - first) / (count - 1) as f64;
        let agree = |from: f64, step: f64| {
            let off = |start: &Start| from + start.index as f64 * step - start.x;
            !starts.is_empty() && starts.iter().all(|start| off(start).abs() <= step.abs())
        };
        !agree(first, step) && agree(last, -step)
    }

    /// Evenly spaced abscissas for `count` points, compared with those at the line starts.
    fn axis(mut self, starts: &[Start], count: usize, notes: &mut Vec<String>) -> Vec<f64> {
        if self.is_turned(starts, count) {
            let note = said!(
                "FIRSTX and LASTX stand the wrong way round: the abscissas at the line starts tell"
            );
            notes.push(note.to_owned());
            std::mem::swap(&mut self.first, &mut self.last);
            self.delta = self.delta.map(|delta| -delta);
        }
        let first = self.first.or(starts.first().map(|start| start.x));
        let first = first.unwrap_or(f64::NAN);
        let announced = self.announced.unwrap_or(count as f64);
        let is_complete = announced == count as f64;
        let last = self.last.filter(|_| is_complete || announced > 1.0);
        let by_ends = last.map(|last| (last - first) / (announced - 1.0));
        let by_starts = || match starts {
            [a, .., b] if b.index > a.index => Some((b.x - a.x) / (b.index - a.index) as f64),
            _ => None,
        };
        let step = by_ends.or(self.delta).or_else(by_starts);
        let step = step.unwrap_or(f64::NAN);
        let at = |index: usize| first + index as f64 * step;
        let mut axis: Vec<f64> = (0..count).map(at).collect();
        // Writers round the abscissas at line starts, mostly to fewer digits than the step has.
        let is_off = |start: &&Start| {
            (at(start.index) - start.x).abs() > step.abs().max(1e-6 * start.x.abs())
        };
        if let Some(Start { line, x, index }) = starts.iter().find(is_off) {
            let even = at(*index);
            notes.push(tr!(
                "the abscissa {x} at line {line} is not the {even} of even steps",
                x = with_sign(x.to_string()),
                line,
                even = with_sign(even.to_string())
            ));
        }
        if is_complete {
            // The last abscissa is stated: rounding of the step does not move it.
            if let (Some(last), Some(end)) = (last, axis.last_mut()) {
                *end = last;
            }
            if let (Some(stated), Some(delta)) = (self.delta, by_ends)
                && (stated - delta).abs() > 0.01 * delta.abs()
            {
                notes.push(tr!(
                    "DELTAX says {stated}, the ends say {delta}",
                    stated = with_sign(stated.to_string()),
                    delta = with_sign(delta.to_string())
                ));
            }
        }
        axis
    }
}
