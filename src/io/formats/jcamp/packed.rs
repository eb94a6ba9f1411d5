//! `(X++(Y..Y))`: lines of one abscissa and many ordinates, plain (AFFN) or packed (ASDF).
//!
//! In the packed forms a letter stands for the first digit and the sign of a number, so that
//! nothing need stand between numbers:
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

use super::blocks::{Block, Data};
use super::pairs::{Points, too_many};
use crate::io::error::quoted;
use crate::io::text::number;
use crate::io::{Input, ReadError};

/// The points of a block as they are unpacked.
struct Unpacked {
    /// Ordinates in the file's whole numbers; NaN for a missing one.
    values: Vec<f64>,
    /// Abscissa at the start of each line, with line and index of its point.
    starts: Vec<(usize, f64, usize)>,
    /// Lines whose check is wrong: the first, and how many.
    wrong: Option<(usize, usize)>,
    most_points: usize,
}

/// Reads lines of ordinates.
///
/// # Errors
/// [`ReadError`] at the line with something that is no number, or with too many.
pub(crate) fn read(
    input: &Input,
    block: &Block,
    data: &Data,
    decimal_comma: bool,
    most_points: usize,
    notes: &mut Vec<String>,
) -> Result<Points, ReadError> {
    let get = |label| block.number(input, label, decimal_comma);
    let x_factor = get("XFACTOR")?.unwrap_or(1.0);
    let y_factor = get("YFACTOR")?.unwrap_or(1.0);
    let mut unpacked = Unpacked {
        values: Vec::new(),
        starts: Vec::new(),
        wrong: None,
        most_points,
    };
    // Whether the line before ended in differences, so that a check follows.
    let mut check_follows = false;
    for (line, row) in data.rows() {
        check_follows = unpacked
            .line(row, line, check_follows, decimal_comma)
            .map_err(|trouble| match trouble {
                Trouble::TooMany => too_many(input, line),
                Trouble::At(at) => {
                    let found = quoted(row.get(at..).unwrap_or(row));
                    let expected = "an abscissa and ordinates, plain or packed";
                    input.error(found, expected).at_line(line)
                }
            })?;
    }
    let mut starts = unpacked.starts;
    if let Some((line, count)) = unpacked.wrong {
        notes.push(format!(
            "{count} of {} checks at line starts are wrong, the first at line {line}",
            starts.len()
        ));
    }
    starts.iter_mut().for_each(|(_, x, _)| *x *= x_factor);
    let values: Vec<f64> = unpacked.values.iter().map(|y| y * y_factor).collect();
    let grid = Grid {
        first: get("FIRSTX")?,
        last: get("LASTX")?,
        delta: get("DELTAX")?,
        announced: get("NPOINTS")?,
    };
    let axis = grid.axis(&starts, values.len(), notes);
    if let (Some(said), Some(found)) = (get("FIRSTY")?, values.first())
        && (said - found).abs() > 1e-4 * said.abs().max(found.abs()) + y_factor.abs()
    {
        notes.push(format!("FIRSTY says {said}, found {found}"));
    }
    Ok((axis, values))
}

/// What a block says about its abscissas.
struct Grid {
    first: Option<f64>,
    last: Option<f64>,
    delta: Option<f64>,
    announced: Option<f64>,
}

impl Grid {
    /// The same ends the other way round, where every line start agrees with that and not with
    /// the ends as they are labelled: the abscissa beside a number is believed before a label.
    fn turned(&self, starts: &[(usize, f64, usize)], count: usize) -> Option<Self> {
        let (first, last) = (self.first?, self.last?);
        let step = (last - first) / count.checked_sub(1).filter(|steps| *steps > 0)? as f64;
        let agree = |from: f64, step: f64| {
            let near = |(_, x, index): &(usize, f64, usize)| {
                (from + *index as f64 * step - x).abs() <= step.abs()
            };
            !starts.is_empty() && starts.iter().all(near)
        };
        (!agree(first, step) && agree(last, -step)).then_some(Self {
            first: self.last,
            last: self.first,
            delta: self.delta.map(|delta| -delta),
            announced: self.announced,
        })
    }

    /// Evenly spaced abscissas for `count` points, compared with those at the line starts.
    fn axis(
        &self,
        starts: &[(usize, f64, usize)],
        count: usize,
        notes: &mut Vec<String>,
    ) -> Vec<f64> {
        if let Some(turned) = self.turned(starts, count) {
            notes.push(
                "FIRSTX and LASTX stand the wrong way round: the abscissas at the line starts tell"
                    .to_owned(),
            );
            return turned.axis(starts, count, notes);
        }
        let first = self.first.or(starts.first().map(|start| start.1));
        let first = first.unwrap_or(f64::NAN);
        let steps = count.saturating_sub(1) as f64;
        let complete = self.announced.is_none_or(|n| n == count as f64);
        let last = self.last.filter(|_| complete);
        let by_ends = last.map(|last| (last - first) / steps);
        let by_announced = match (self.last, self.announced) {
            (Some(last), Some(n)) if n > 1.0 => Some((last - first) / (n - 1.0)),
            _ => None,
        };
        let by_starts = match (starts.first(), starts.last()) {
            (Some(a), Some(b)) if b.2 > a.2 => Some((b.1 - a.1) / (b.2 - a.2) as f64),
            _ => None,
        };
        let step = by_ends
            .or(by_announced)
            .or(self.delta)
            .or(by_starts)
            .unwrap_or(f64::NAN);
        let mut axis: Vec<f64> = (0..count).map(|i| first + i as f64 * step).collect();
        // The last abscissa is stated: rounding of the step does not move it.
        if let (Some(last), Some(end)) = (last, axis.last_mut()) {
            *end = last;
        }
        // Writers round the abscissas at line starts, mostly to fewer digits than the step has.
        let off = |(_, x, index): &&(usize, f64, usize)| {
            let expected = first + *index as f64 * step;
            (expected - x).abs() > step.abs().max(1e-6 * x.abs())
        };
        if let Some((line, x, index)) = starts.iter().find(off) {
            notes.push(format!(
                "the abscissa {x} at line {line} is not the {} of even steps",
                first + *index as f64 * step
            ));
        }
        if let (Some(said), Some(delta)) = (self.delta, by_ends)
            && (said - delta).abs() > 0.01 * delta.abs()
        {
            notes.push(format!("DELTAX says {said}, the ends say {delta}"));
        }
        axis
    }
}

/// Why a line was not unpacked.
enum Trouble {
    /// Something that is no number, at this byte.
    At(usize),
    /// More points than the file may have.
    TooMany,
}

/// What a number on a line is.
#[derive(Clone, Copy, PartialEq)]
enum Form {
    /// An ordinate.
    Value,
    /// A difference.
    Difference,
}

impl Unpacked {
    /// Unpacks a line; returns whether it ends in differences.
    fn line(
        &mut self,
        row: &str,
        line: usize,
        check_follows: bool,
        decimal_comma: bool,
    ) -> Result<bool, Trouble> {
        let bytes = row.as_bytes();
        let is_gap = |b: u8| b.is_ascii_whitespace() || b == b';' || (b == b',' && !decimal_comma);
        let mut at = 0;
        let mut has_abscissa = false;
        let mut last: Option<(Form, f64)> = None;
        let mut checking = check_follows;
        while at < bytes.len() {
            let byte = bytes[at];
            if is_gap(byte) {
                at += 1;
                continue;
            }
            if byte == b'?' {
                self.put(Form::Value, f64::NAN)?;
                last = Some((Form::Value, f64::NAN));
                (at, checking) = (at + 1, false);
                continue;
            }
            if let Some(times) = dup(byte) {
                let (more, past) = digits(bytes, at + 1);
                let times = more.iter().fold(times, |n: u64, d| {
                    n.saturating_mul(10).saturating_add(u64::from(d - b'0'))
                });
                let (form, value) = last.ok_or(Trouble::At(at))?;
                for _ in 1..times {
                    self.put(form, value)?;
                }
                at = past;
                continue;
            }
            let (form, value, past) = number_at(row, at, decimal_comma).ok_or(Trouble::At(at))?;
            if !has_abscissa {
                if form == Some(Form::Difference) {
                    return Err(Trouble::At(at));
                }
                has_abscissa = true;
                let index = self.values.len() - usize::from(check_follows);
                self.starts.push((line, value, index));
                at = past;
                continue;
            }
            let form = form.unwrap_or(Form::Value);
            if checking && form == Form::Value {
                self.check(value, line);
            } else {
                self.put(form, value)?;
            }
            checking = false;
            last = Some((form, value));
            at = past;
        }
        Ok(matches!(last, Some((Form::Difference, _))))
    }

    fn put(&mut self, form: Form, value: f64) -> Result<(), Trouble> {
        let value = match form {
            Form::Value => value,
            Form::Difference => self.values.last().copied().unwrap_or(0.0) + value,
        };
        if self.values.len() >= self.most_points {
            return Err(Trouble::TooMany);
        }
        self.values.push(value);
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

fn dup(byte: u8) -> Option<u64> {
    match byte {
        b'S'..=b'Z' => Some(u64::from(byte - b'S') + 1),
        b's' => Some(9),
        _ => None,
    }
}

/// First digit with sign, and form, of a letter that starts a number.
fn letter(byte: u8) -> Option<(Form, bool, u8)> {
    let (form, negative, digit) = match byte {
        b'@' => (Form::Value, false, 0),
        b'A'..=b'I' => (Form::Value, false, byte - b'A' + 1),
        b'a'..=b'i' => (Form::Value, true, byte - b'a' + 1),
        b'%' => (Form::Difference, false, 0),
        b'J'..=b'R' => (Form::Difference, false, byte - b'J' + 1),
        b'j'..=b'r' => (Form::Difference, true, byte - b'j' + 1),
        _ => return None,
    };
    Some((form, negative, digit))
}

fn digits(bytes: &[u8], from: usize) -> (&[u8], usize) {
    let rest = &bytes[from..];
    let count = rest.iter().take_while(|b| b.is_ascii_digit()).count();
    (&rest[..count], from + count)
}

/// The number that starts at a byte, its form (`None` for a plain number), and where it ends.
fn number_at(row: &str, at: usize, decimal_comma: bool) -> Option<(Option<Form>, f64, usize)> {
    let bytes = row.as_bytes();
    let first = bytes[at];
    let packed = letter(first);
    let mut end = at;
    if packed.is_some() || matches!(first, b'+' | b'-') {
        end += 1;
    }
    end = digits(bytes, end).1;
    let is_mark = |b: &u8| *b == b'.' || (decimal_comma && *b == b',');
    if bytes.get(end).is_some_and(is_mark) {
        end = digits(bytes, end + 1).1;
    }
    // An exponent has a sign; without one an E is the packed digit 5.
    if matches!(bytes.get(end), Some(b'E' | b'e'))
        && matches!(bytes.get(end + 1), Some(b'+' | b'-'))
    {
        let (exponent, past) = digits(bytes, end + 2);
        if !exponent.is_empty() {
            end = past;
        }
    }
    // Letters and digits are ASCII, so that these are character boundaries.
    let text = row.get(at..end)?;
    match packed {
        None => Some((None, number::number(text, decimal_comma)?, end)),
        Some((form, negative, digit)) => {
            let text = format!("{digit}{}", text.get(1..)?);
            let value = number::number(&text, decimal_comma)?;
            Some((Some(form), if negative { -value } else { value }, end))
        }
    }
}
