//! Marks in numbers that no dialect alone reads right: thousands without decimals (`10.202`,
//! `1,234`), decimal commas beside commas between cells (`380,0,5026`), and another decimal mark in
//! each column (`380.0;0,512`).
//!
//! A column tells by all of its numbers what its mark is. The text is then written anew with points
//! and without marks between thousands, line by line.

use super::commas::{FEWEST_ROWS, FEWEST_WHOLE, Plain, beside_commas};
use crate::io::text::dialect::{Delimiter, Dialect, used};
use crate::io::text::lines;
use crate::io::text::number::{Cell, is_grouped, number, parse};
use crate::io::{Input, ReadError};

/// The marks that part thousands or decimals.
const MARKS: [char; 2] = ['.', ','];

/// The text in plain numbers; `None` where they are so already. `sample` is its start, which
/// decides.
///
/// # Errors
/// [`ReadError`] where commas part cells and mark decimals, and nothing tells which is which.
pub(crate) fn made_plain(
    input: &Input,
    text: &str,
    sample: &str,
) -> Result<Option<Plain>, ReadError> {
    let chosen = input.choices.delimiter;
    let has_quotes = memchr::memchr(b'"', sample.as_bytes()).is_some();
    let may_be = |delimiter: &Delimiter| {
        chosen.is_none_or(|chosen| chosen == *delimiter)
            && (has_quotes || *delimiter != Delimiter::Comma)
    };
    let mut delimiters = Delimiter::ALL.into_iter().filter(may_be);
    if let Some((dialect, marks)) = delimiters.find_map(|by| marks_by(sample, by)) {
        return Ok(written_anew(text, dialect, marks));
    }
    match chosen {
        None | Some(Delimiter::Comma) if !has_quotes => beside_commas(input, text, sample),
        _ => Ok(None),
    }
}

/// The role of one mark in a number.
#[derive(Clone, Copy, PartialEq)]
enum Use {
    Absent,
    /// Between thousands, or before three decimals.
    Either,
    Thousands,
    Decimals,
}

/// A number without the sign of a limit, its own sign, and a per cent sign.
fn bare(cell: &str) -> &str {
    let cell = cell.trim_start_matches(['<', '>', '≤', '≥']).trim_start();
    let cell = cell.trim_end_matches('%').trim_end();
    cell.trim_start_matches(['-', '+', '−'])
}

/// True if cells form a row: numbers, or one at the start followed by gaps.
fn is_row(cells: &[&str]) -> bool {
    let is_gap = |cell: &&str| matches!(parse(cell, false), Cell::Gap | Cell::Empty);
    match cells.iter().filter(|cell| uses(cell).is_some()).count() {
        0 => false,
        1 => cells.len() > 1 && uses(cells[0]).is_some() && cells[1..].iter().all(is_gap),
        _ => true,
    }
}

/// The roles of point and comma in a number; `None` for anything else.
fn uses(cell: &str) -> Option<[Use; 2]> {
    let cell = bare(cell);
    let (body, power) = match cell.split_once(['e', 'E']) {
        Some((body, power)) => (body, Some(power.trim_start_matches(['-', '+']))),
        None => (cell, None),
    };
    let is_figures = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    if body.ends_with(MARKS)
        || !is_figures(&body.replace(MARKS, ""))
        || power.is_some_and(|power| !is_figures(power))
    {
        return None;
    }
    let is_parted = |text: &str, by| is_grouped(text, by) && !text.starts_with('0');
    let counts = MARKS.map(|mark| body.matches(mark).count());
    let alone = |by: usize| match (is_parted(body, MARKS[by]), counts[by]) {
        (true, 1) if power.is_none() => Some(Use::Either),
        (true, 2..) if power.is_none() => Some(Use::Thousands),
        (_, 1) => Some(Use::Decimals),
        _ => None,
    };
    match counts {
        [0, 0] => Some([Use::Absent; 2]),
        [_, 0] => Some([alone(0)?, Use::Absent]),
        [0, _] => Some([Use::Absent, alone(1)?]),
        _ => {
            let last = usize::from(body.rfind(',') > body.rfind('.'));
            let (whole, _) = body.split_once(MARKS[last])?;
            let mut found = [Use::Thousands; 2];
            found[last] = Use::Decimals;
            (counts[last] == 1 && is_parted(whole, MARKS[1 - last])).then_some(found)
        }
    }
}

/// The thousands and decimal marks of a column's numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Marks {
    thousands: Option<char>,
    decimals: Option<char>,
    /// True if a number has thousands and no decimals.
    is_bare: bool,
    /// True if all decimals have three digits, so that they may be thousands too.
    is_either: bool,
    /// True if only whole numbers below 1000 are evidence of thousands.
    is_unsure: bool,
}

impl Marks {
    /// The marks shown by all cells of a column; `None` where they are no numbers, or disagree.
    fn of(cells: &[&str]) -> Option<Self> {
        let (mut odd, mut count, mut found) = (0, 0, [[0usize; 4]; 2]);
        let (mut whole, mut is_large, mut has_bare) = (Vec::new(), false, false);
        for cell in cells.iter().filter(|cell| !cell.is_empty()) {
            let Some(uses) = uses(cell) else {
                odd += usize::from(parse(cell, false).value().is_none());
                continue;
            };
            count += 1;
            for (of, use_) in found.iter_mut().zip(uses) {
                of[use_ as usize] += 1;
            }
            if uses == [Use::Absent; 2] {
                let value = number(bare(cell), false)?;
                is_large |= value.abs() >= 1000.0;
                if whole.len() < FEWEST_WHOLE && !whole.contains(&value) {
                    whole.push(value);
                }
            } else if !uses.contains(&Use::Decimals) {
                has_bare = true;
            }
        }
        if count < FEWEST_ROWS || 10 * odd > count {
            return None;
        }
        let has = |mark: usize, use_: Use| found[mark][use_ as usize] > 0;
        let parts_thousands = |mark: usize| {
            let other = 1 - mark;
            let by_others = !has(other, Use::Either) && !is_large && whole.len() == FEWEST_WHOLE;
            has(mark, Use::Thousands)
                || has(mark, Use::Either) && (has(other, Use::Decimals) || by_others)
        };
        let marks_decimals = |mark: usize| {
            has(mark, Use::Decimals) || has(mark, Use::Either) && !parts_thousands(mark)
        };
        let only = |is: &dyn Fn(usize) -> bool| match [is(0), is(1)] {
            [true, true] => None,
            [first, second] => Some(first.then_some(MARKS[0]).or(second.then_some(MARKS[1]))),
        };
        if (0..2).any(|mark| parts_thousands(mark) && has(mark, Use::Decimals)) {
            return None;
        }
        let (thousands, decimals) = (only(&parts_thousands)?, only(&marks_decimals)?);
        Some(Self {
            thousands,
            decimals,
            is_bare: has_bare && thousands.is_some(),
            is_either: !(0..2).any(|mark| has(mark, Use::Decimals)) && decimals.is_some(),
            is_unsure: (0..2).any(|mark| {
                let is_proven = has(mark, Use::Thousands) || has(1 - mark, Use::Decimals);
                has(mark, Use::Either) && parts_thousands(mark) && !is_proven
            }),
        })
    }

    fn plain(self, cell: &str) -> String {
        let without = match self.thousands {
            Some(mark) => cell.replace(mark, ""),
            None => cell.to_owned(),
        };
        match self.decimals {
            Some(mark) => without.replace(mark, "."),
            None => without,
        }
    }
}

/// The columns of a table whose cells this delimiter parts, and what their marks are.
fn marks_by(sample: &str, by: Delimiter) -> Option<(Dialect, Vec<Option<Marks>>)> {
    let dialect = Dialect::new(by, false);
    let (mut rows, mut lines_with_figures): (Vec<Vec<&str>>, usize) = (Vec::new(), 0);
    for (_, line) in lines(sample) {
        let has_figure = line.bytes().any(|byte| byte.is_ascii_digit());
        lines_with_figures += usize::from(has_figure);
        if !has_figure || !dialect.parts(line) {
            continue;
        }
        let cells = dialect.cells(line);
        let is_row = is_row(&cells);
        if is_row && used(&cells) > 1 {
            rows.push(cells);
        } else {
            // A wavelength alone speaks neither for nor against the rows.
            lines_with_figures -= usize::from(is_row);
        }
    }
    let width = used(rows.get(rows.len() / 2)?);
    rows.retain(|cells| used(cells) == width);
    if rows.len() < FEWEST_ROWS || 2 * rows.len() < lines_with_figures {
        return None;
    }
    let column = |at: usize| rows.iter().map(|cells| cells[at]).collect::<Vec<_>>();
    let marks: Vec<_> = (0..width).map(|at| Marks::of(&column(at))).collect();
    (marks.iter().flatten().count() >= 2).then_some((dialect, marks))
}

/// The text with plain numbers in the columns whose marks are known, where one dialect does not
/// read them all; and what was done.
fn written_anew(text: &str, dialect: Dialect, mut marks: Vec<Option<Marks>>) -> Option<Plain> {
    let known = || marks.iter().flatten().filter(|marks| !marks.is_either);
    let plain: Vec<char> = known().filter_map(|marks| marks.decimals).collect();
    // Where another column marks decimals otherwise, three figures are thousands.
    let mut is_doubtful = marks.iter().flatten().any(|of| of.is_unsure);
    for of in marks.iter_mut().flatten().filter(|of| of.is_either) {
        if of
            .decimals
            .is_some_and(|mark| !plain.is_empty() && !plain.contains(&mark))
        {
            (of.thousands, of.decimals, of.is_bare) = (of.decimals, None, true);
            is_doubtful = true;
        }
    }
    let bare = marks.iter().position(|of| of.is_some_and(|of| of.is_bare));
    let note = match bare {
        Some(column) => {
            let mark = marks[column]?.thousands?;
            tr!(
                "column {column}: \"{mark}\" parts thousands",
                column = column + 1,
                mark
            )
        }
        None if plain.contains(&'.') && plain.contains(&',') => {
            said!("some columns mark decimals with a point, others with a comma").to_owned()
        }
        None => return None,
    };
    let mark = dialect.mark().map_or(' ', char::from);
    let mut out = String::with_capacity(text.len());
    let mut cells = Vec::new();
    for (_, line) in lines(text) {
        dialect.split(line, &mut cells);
        let is_row = used(&cells) <= marks.len() && is_row(&cells);
        if !is_row {
            out.push_str(line);
        }
        for (at, cell) in cells.iter().enumerate().filter(|_| is_row) {
            if at > 0 {
                out.push(mark);
            }
            let of = marks.get(at).copied().flatten();
            match of.filter(|_| uses(cell).is_some()) {
                Some(marks) => out.push_str(&marks.plain(cell)),
                None if cell.contains(mark) => out.push_str(&format!("\"{cell}\"")),
                None => out.push_str(cell),
            }
        }
        out.push('\n');
    }
    Some(Plain {
        text: out,
        note,
        is_doubtful,
    })
}
