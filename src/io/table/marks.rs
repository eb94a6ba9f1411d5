//! Marks in numbers that no dialect alone reads right: thousands without decimals (`10.202`,
//! `1,234`), decimal commas beside commas between cells (`380,0,5026`), and another decimal mark in
//! each column (`380.0;0,512`).
//!
//! A column tells by all of its numbers what its mark is. The text is then written anew with points
//! and without marks between thousands, line by line.

use super::row_order::runs_one_way;
use crate::io::text::dialect::{Delimiter, Dialect, used};
use crate::io::text::number::{is_grouped, number, parse};
use crate::io::text::{NumberedLines, lines};
use crate::io::{Input, ReadError};

/// Fewest rows whose numbers tell what their marks are.
const FEWEST_ROWS: usize = 5;

/// Fewest different whole numbers below 1000 beside marked ones that tell of thousands: of decimals
/// that lost the zeros at their end one in a thousand is whole.
const FEWEST_WHOLE: usize = 3;

/// The marks that part thousands or decimals.
const MARKS: [char; 2] = ['.', ','];

/// A text with numbers that every dialect reads.
pub(crate) struct Plain {
    pub text: String,
    /// What was done to get it.
    pub said: String,
    /// Whether it may be otherwise.
    pub is_doubtful: bool,
}

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

/// How one mark is used in a number.
#[derive(Clone, Copy, PartialEq)]
enum Use {
    Absent,
    /// Between thousands, or before three decimals.
    Either,
    Thousands,
    Decimals,
}

/// How a number uses a point and a comma; `None` for what is no number.
fn uses(cell: &str) -> Option<[Use; 2]> {
    let cell = cell.trim_start_matches(['-', '+', '−']);
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

/// What the marks of a column's numbers are.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Marks {
    thousands: Option<char>,
    decimals: Option<char>,
    /// Whether a number has thousands and no decimals.
    is_bare: bool,
    /// Whether all decimals are three, so that they may be thousands too.
    is_either: bool,
}

impl Marks {
    /// What all cells of a column tell; `None` where they are no numbers, or disagree.
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
                let value = number(cell, false)?;
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
        })
    }

    /// A number of the column with a point and without thousands.
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
        if cells.iter().filter(|cell| uses(cell).is_some()).count() >= 2 {
            rows.push(cells);
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
    let mut is_doubtful = false;
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
    let said = match bare {
        Some(column) => {
            let mark = marks[column]?.thousands?;
            format!("column {}: \"{mark}\" parts thousands", column + 1)
        }
        None if plain.contains(&'.') && plain.contains(&',') => {
            "some columns mark decimals with a point, others with a comma".to_owned()
        }
        None => return None,
    };
    let mark = dialect.mark().map_or(' ', char::from);
    let mut out = String::with_capacity(text.len());
    let mut cells = Vec::new();
    for (_, line) in lines(text) {
        dialect.split(line, &mut cells);
        let is_row = used(&cells) <= marks.len()
            && cells.iter().filter(|cell| uses(cell).is_some()).count() >= 2;
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
        said,
        is_doubtful,
    })
}

/// Rows of figures with commas between them, and how many titles stand above the first.
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

    /// Fewest and most cells of a row.
    fn widths(&self) -> (usize, usize) {
        let widths = self.rows.iter().map(|row| row.1.len());
        widths.fold((usize::MAX, 0), |(a, b), width| {
            (a.min(width), b.max(width))
        })
    }

    /// Whether all rows have something in common.
    fn agree<T: PartialEq>(&self, of: impl Fn(&[&'a str]) -> T) -> bool {
        self.rows
            .windows(2)
            .all(|pair| of(&pair[0].1) == of(&pair[1].1))
    }

    /// Whether a row ends in decimals that begin with a zero, as no whole number does.
    fn has_zeros(&self) -> bool {
        let is_one = |(_, cells): &(usize, Vec<&str>)| {
            let last = cells[cells.len() - 1];
            last.len() > 1 && last.starts_with('0') && last.bytes().all(|b| b.is_ascii_digit())
        };
        self.rows.iter().any(is_one)
    }

    /// How many numbers a row holds that has more cells than titles; `None` where no comma seems to
    /// stand within a number.
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

/// The same for cells with commas between them, where commas stand in numbers too.
fn beside_commas(input: &Input, text: &str, sample: &str) -> Result<Option<Plain>, ReadError> {
    let start: Vec<(usize, &str)> = lines(sample).collect();
    let Some(numbers) = Commas::of(&start).and_then(|found| found.numbers()) else {
        return Ok(None);
    };
    let all: Vec<(usize, &str)> = lines(text).collect();
    let Some(found) = Commas::of(&all) else {
        return Ok(None);
    };
    let by = found.of_thousands(numbers);
    let (rows, use_, is_doubtful) = match (by, found.of_decimals(numbers)) {
        (Some(rows), _) => (rows, "part thousands", false),
        (None, Some(rows)) => (rows, "mark decimals", !found.has_zeros()),
        (None, None) => {
            let is_whole = |cell: &&str| cell.bytes().all(|b| b.is_ascii_digit());
            let (line, cells) = &found.rows[0];
            let are_whole = found.rows.iter().all(|row| row.1.iter().all(is_whole));
            let is_plain = found.titles.is_none() || found.titles == Some(cells.len());
            if is_plain || !are_whole {
                return Ok(None);
            }
            let count = cells.len();
            let found = format!("{count} whole numbers under {numbers} titles");
            let expected = "decimals marked with a point, or cells set apart by semicolons";
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
    Ok(Some(Plain {
        text: out,
        said: format!("commas between the cells {use_} as well"),
        is_doubtful,
    }))
}
