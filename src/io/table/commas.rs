//! Commas between cells and within numbers too: decimals (`380,0,5026`) or thousands (`380,1,234`).
//! Titles, widths and the figures of all rows tell which; where nothing does, the table is refused.

use super::row_order::runs_one_way;
use crate::io::text::dialect::{Delimiter, Dialect};
use crate::io::text::number::number;
use crate::io::text::{NumberedLines, lines};
use crate::io::{Input, ReadError};

/// Fewest rows whose numbers tell what their marks are.
pub(super) const FEWEST_ROWS: usize = 5;

/// Fewest different whole numbers below 1000 beside marked ones that tell of thousands: of decimals
/// that lost the zeros at their end one in a thousand is whole.
pub(super) const FEWEST_WHOLE: usize = 3;

/// A text with numbers that every dialect reads.
pub(crate) struct Plain {
    pub text: String,
    /// The changes made to get it, in words.
    pub note: String,
    /// True if another reading is possible.
    pub is_doubtful: bool,
}

struct Commas<'a> {
    rows: Vec<(usize, Vec<&'a str>)>,
    titles: Option<usize>,
}

impl<'a> Commas<'a> {
    fn of(all: &NumberedLines<'a>) -> Option<Self> {
        let comma = Dialect::new(Delimiter::Comma, false);
        let mut rows: Vec<(usize, Vec<&str>)> = Vec::new();
        let (mut titles, mut others) = (None, 0);
        for (line, content) in all {
            let cells = comma.cells(content.trim_end_matches([',', ' ']));
            if cells.len() > 1 && cells.iter().all(|cell| number(cell, false).is_some()) {
                rows.push((*line, cells));
            } else if rows.is_empty() {
                let is_title = |cell: &&str| cell.contains(char::is_alphabetic);
                let are_titles = cells.len() > 1 && cells.iter().all(is_title);
                titles = are_titles.then_some(cells.len());
            } else {
                others += usize::from(!content.trim().is_empty());
            }
        }
        (rows.len() >= FEWEST_ROWS && others < rows.len()).then_some(Self { rows, titles })
    }

    fn widths(&self) -> (usize, usize) {
        let widths = self.rows.iter().map(|row| row.1.len());
        widths.fold((usize::MAX, 0), |(a, b), width| {
            (a.min(width), b.max(width))
        })
    }

    fn agree<T: PartialEq>(&self, of: impl Fn(&[&'a str]) -> T) -> bool {
        self.rows
            .windows(2)
            .all(|pair| of(&pair[0].1) == of(&pair[1].1))
    }

    /// True if a row ends in decimals that begin with a zero, as no whole number does, and the
    /// number before them is not zero-padded either.
    fn has_zeros(&self) -> bool {
        let is_padded = |cell: &str| {
            cell.len() > 1 && cell.starts_with('0') && cell.bytes().all(|b| b.is_ascii_digit())
        };
        let is = |behind: usize| {
            let rows = self.rows.iter().map(|row| row.1.iter().rev().nth(behind));
            rows.flatten().any(|cell| is_padded(cell))
        };
        is(0) && !is(1)
    }

    /// The count of numbers in a row with more cells than titles; `None` where no comma appears to
    /// lie within a number.
    fn numbers(&self) -> Option<usize> {
        let (least, most) = self.widths();
        let mut firsts = self
            .rows
            .iter()
            .zip(0..)
            .map(|((_, cells), at)| (cells[0].parse::<i32>(), at));
        let counts_rows = firsts.clone().all(|(first, at)| first == Ok(at))
            || firsts.all(|(first, at)| first == Ok(at + 1));
        if counts_rows || !(3..=16).contains(&most) {
            return None;
        }
        match self.titles {
            Some(titles) => (titles < most).then_some(titles),
            None if least == 2 && most == 3 => Some(2),
            None if least == most && most <= 4 && self.has_zeros() => Some(2),
            None => None,
        }
    }

    /// Each row without commas between thousands, where they can be nothing else.
    fn of_thousands(&self, numbers: usize) -> Option<Vec<String>> {
        let mut whole: Vec<&str> = Vec::new();
        let mut has_point = false;
        let rows = self.rows.iter().map(|(_, cells)| {
            let mut ways = Vec::new();
            grouped(&cells[1..], numbers - 1, &mut Vec::new(), &mut ways);
            if cells.len() == numbers {
                let small = cells[1..].iter().filter(|cell| cell.len() <= 3);
                whole.extend(small.filter(|cell| !cell.starts_with('0')));
            }
            has_point |= cells.iter().any(|cell| cell.contains('.'));
            let [only] = &ways[..] else {
                return None;
            };
            Some(format!("{},{}", cells[0], only.join(",")))
        });
        let rows: Vec<String> = rows.collect::<Option<_>>()?;
        whole.sort_unstable();
        whole.dedup();
        (has_point || whole.len() >= FEWEST_WHOLE).then_some(rows)
    }

    /// Each row with points for the commas before decimals, every number with decimals or all but
    /// the first; `None` where these make no wavelengths, or both do.
    fn of_decimals(&self, numbers: usize) -> Option<Vec<String>> {
        let (least, most) = self.widths();
        let is_whole = |(_, cells): &(usize, Vec<&str>)| {
            cells.iter().all(|cell| !cell.contains('.')) && !cells[0].contains(['e', 'E'])
        };
        if most > 2 * numbers || !self.rows.iter().all(is_whole) {
            return None;
        }
        let read = |first: usize| {
            let rows = self.rows.iter().map(|(_, cells)| {
                let (nm, values) = cells.split_at(first);
                let values: Vec<String> = values.chunks(2).map(|of| of.join(".")).collect();
                format!("{},{}", nm.join("."), values.join(","))
            });
            let rows: Vec<String> = rows.collect();
            let nm = rows.iter().map(|row| number(row.split(',').next()?, false));
            let nm: Vec<f64> = nm.collect::<Option<_>>()?;
            runs_one_way(&nm).then_some(rows)
        };
        let is_even = least == most;
        if is_even && most == 2 * numbers {
            return read(2);
        }
        // "380,0,5026" may be 380.0 and 5026: decimals begin with zeros or are equally long.
        let length = |cells: &[&str]| cells[cells.len() - 1].len();
        let is_plain = numbers != 2
            || !self.agree(|cells| cells.get(1).copied())
            || self.has_zeros()
            || self.agree(length) && length(&self.rows[0].1) > 1;
        // A cell too many in a row or two makes no decimals of the others.
        let wide = self.rows.iter().filter(|row| row.1.len() == most).count();
        let is_ragged = numbers == 2 && least == 2 && 2 * wide >= self.rows.len();
        let fits = most == 2 * numbers - 1 && (is_even || is_ragged);
        if fits && is_plain { read(1) } else { None }
    }
}

/// The ways in which cells are so many numbers, some of them in groups of three figures; two at most.
fn grouped(cells: &[&str], numbers: usize, before: &mut Vec<String>, ways: &mut Vec<Vec<String>>) {
    if numbers == 0 || cells.is_empty() || ways.len() > 1 {
        if numbers == 0 && cells.is_empty() {
            ways.push(before.clone());
        }
        return;
    }
    let digits = |cell: &str| cell.bytes().all(|b| b.is_ascii_digit());
    for length in 1..=cells.len() {
        let goes_on = length == 1 || {
            let (first, behind) = (cells[length - 2], cells[length - 1]);
            let begins = length > 2 || {
                let bare = first.trim_start_matches(['-', '+']);
                (1..=3).contains(&bare.len()) && digits(bare) && !bare.starts_with('0')
            };
            let (group, decimals) = behind.split_once('.').unwrap_or((behind, ""));
            begins
                && digits(first.trim_start_matches(['-', '+']))
                && group.len() == 3
                && digits(group)
                && digits(decimals)
        };
        if !goes_on {
            return;
        }
        before.push(cells[..length].concat());
        grouped(&cells[length..], numbers - 1, before, ways);
        before.pop();
    }
}

/// The text in plain numbers where commas part its cells; `None` where none stands in a number.
///
/// # Errors
/// [`ReadError`] where nothing tells whether a comma parts cells or marks decimals.
pub(super) fn beside_commas(
    input: &Input,
    text: &str,
    sample: &str,
) -> Result<Option<Plain>, ReadError> {
    let start: Vec<(usize, &str)> = lines(sample).collect();
    let Some(numbers) = Commas::of(&start).and_then(|found| found.numbers()) else {
        return Ok(None);
    };
    let all: Vec<(usize, &str)> = lines(text).collect();
    let Some(found) = Commas::of(&all) else {
        return Ok(None);
    };
    let by = found.of_thousands(numbers);
    let (rows, part_thousands, is_doubtful) = match (by, found.of_decimals(numbers)) {
        (Some(rows), _) => (rows, true, false),
        (None, Some(rows)) => (rows, false, !found.has_zeros()),
        (None, None) => {
            let is_whole = |cell: &&str| cell.bytes().all(|b| b.is_ascii_digit());
            let (line, cells) = &found.rows[0];
            let are_whole = found.rows.iter().all(|row| row.1.iter().all(is_whole));
            let is_plain = found.titles.is_none() || found.titles == Some(cells.len());
            if is_plain || !are_whole {
                return Ok(None);
            }
            let count = cells.len();
            let found = tr!(
                "{n} whole number under {titles} titles"
                    | "{n} whole numbers under {titles} titles" % count,
                titles = numbers
            );
            let expected = said!("decimals marked with a point, or cells set apart by semicolons");
            return Err(input.error(found, expected).at_line(*line));
        }
    };
    let places = found.rows.iter().map(|(line, _)| *line);
    let mut rows = places.zip(rows).peekable();
    let mut out = String::with_capacity(text.len());
    for (line, content) in all {
        match rows.next_if(|(at, _)| *at == line) {
            Some((_, row)) => out.push_str(&row),
            None => out.push_str(content),
        }
        out.push('\n');
    }
    let note = match part_thousands {
        true => said!("commas between the cells part thousands as well"),
        false => said!("commas between the cells mark decimals as well"),
    };
    Ok(Some(Plain {
        text: out,
        note: note.to_owned(),
        is_doubtful,
    }))
}
