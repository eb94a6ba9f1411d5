//! Rows of a table that do not stand where their wavelengths belong: a few stray ones are left out,
//! and a table in random order is sorted, both with a word.

use super::block::{Block, FEWEST_THAT_AGREE};
use crate::io::provenance::shortest;
use crate::io::text::units::WavelengthUnit;
use crate::io::{Input, ReadError};
use crate::languages::with_sign;

/// A row that is left out lies at least so many steps away from its neighbours: detectors that
/// overlap and curves traced by hand step back by less.
const FAR_STEPS: f64 = 10.0;

/// Fewest rows that can be said to stand in random order.
const FEWEST_SHUFFLED: usize = 10;

/// Leaves out rows of other numbers above and below a table and the few that break the order of
/// wavelengths while all others keep it, and sorts rows in random order. What was done, a sentence
/// each; `values` are the columns beside.
///
/// # Errors
/// [`ReadError`] where many rows break the order, and where a wavelength stands twice with two values.
pub(crate) fn put_right(
    input: &Input,
    block: &mut Block,
    axis: usize,
    values: &[usize],
) -> Result<Vec<String>, ReadError> {
    let beside = rows_beside(block.column(axis), &block.lines);
    let mut notes: Vec<String> = Vec::new();
    if !beside.is_empty() {
        let line = |row: &usize| block.lines[*row];
        notes.extend(beside.chunk_by(|a, b| a + 1 == *b).map(|run| {
            let (first, last) = (line(&run[0]), line(&run[run.len() - 1]));
            match run.len() {
                1 => tr!(
                    "line {first}: no wavelength of the table: the row was left out",
                    first
                ),
                _ => tr!(
                    "lines {first} to {last}: no wavelengths of the table: left out",
                    first,
                    last
                ),
            }
        }));
        without(block, &beside);
    }
    let numbers = block.column(axis);
    let stray = stray_rows(numbers);
    if stray.len() > most_stray(numbers.len()) {
        let (nm, others) = (numbers[stray[0]], stray.len() - 1);
        let found = tr!(
            "wavelength {nm} and {n} more out of order"
                | "wavelength {nm} and {n} more out of order" % others,
            nm = with_sign(nm.to_string())
        );
        let expected = said!("wavelengths that rise or fall throughout");
        let line = block.lines[stray[0]] as usize;
        return Err(input.error(found, expected).at_line(line));
    }
    if !stray.is_empty() {
        notes.extend(stray.iter().map(|row| {
            let first = values.first().map(|column| block.column(*column)[*row]);
            let value = first.filter(|value| !value.is_nan());
            let (line, nm) = (block.lines[*row], with_sign(shortest(numbers[*row])));
            match value {
                Some(value) => tr!(
                    "line {line}: wavelength {nm} (value {value}) is out of order: the row was \
                     left out",
                    line,
                    nm,
                    value = with_sign(shortest(value))
                ),
                None => tr!(
                    "line {line}: wavelength {nm} is out of order: the row was left out",
                    line,
                    nm
                ),
            }
        }));
        without(block, &stray);
    } else if is_shuffled(numbers) {
        let mut order: Vec<usize> = (0..block.rows()).collect();
        order.sort_by(|a, b| numbers[*a].total_cmp(&numbers[*b]));
        block.arrange(&order);
        notes.push(said!("rows in no order of wavelengths: put in rising order").to_owned());
    }
    no_doubles(input, block, axis, values)?;
    Ok(notes)
}

fn without(block: &mut Block, rows: &[usize]) {
    let kept = (0..block.rows()).filter(|row| rows.binary_search(row).is_err());
    block.arrange(&kept.collect::<Vec<_>>());
}

/// Refuses a wavelength that stands in two rows with two values. Where many of them do the readings
/// were repeated, and are averaged later on; so is what was traced from a plot, in more decimals than
/// anybody types.
fn no_doubles(
    input: &Input,
    block: &Block,
    axis: usize,
    values: &[usize],
) -> Result<(), ReadError> {
    let numbers = block.column(axis);
    let is_typed = |nm: f64| (100.0 * nm - (100.0 * nm).round()).abs() < 1e-6 * nm;
    let differ = |row: &usize| {
        let at = |column: usize| (block.column(column)[*row], block.column(column)[row + 1]);
        let (a, b) = at(axis);
        a == b
            && a > 0.0
            && is_typed(a)
            && values
                .iter()
                .map(|column| at(*column))
                .any(|(a, b)| a < b || b < a)
    };
    let mut doubles = (0..numbers.len().saturating_sub(1)).filter(differ);
    let Some(row) = doubles.next() else {
        return Ok(());
    };
    if 1 + doubles.count() > (numbers.len() / 20).max(1) {
        return Ok(());
    }
    let value = |row: usize, column: &usize| with_sign(shortest(block.column(*column)[row]));
    let mut pairs = values
        .iter()
        .map(|column| (value(row, column), value(row + 1, column)));
    let (a, b) = pairs.find(|(a, b)| a != b).unwrap_or_default();
    let (first, second) = (block.lines[row], block.lines[row + 1]);
    let at = with_sign(shortest(numbers[row]));
    let found = tr!(
        "{nm} with {value} in line {line} and with {other} in line {other_line}",
        nm = at,
        value = a,
        line = first,
        other = b,
        other_line = second
    );
    let expected = said!("one value at each wavelength");
    Err(input.error(found, expected).at_line(second as usize))
}

/// Most rows above or below a table that are none of it.
const MOST_BESIDE: usize = 6;

/// A row beside a table lies at least so many of its steps away.
const BESIDE_STEPS: f64 = 20.0;

/// Numbers under this are no wavelengths of a table in nanometres.
const LEAST_NM: f64 = 100.0;

/// The first and the last rows whose numbers are no wavelengths of the table between them: they do
/// not go on with it, and lie in no range that wavelengths have, or behind an empty line.
fn rows_beside(numbers: &[f64], lines: &[u32]) -> Vec<usize> {
    let Some((start, end)) = longest_run(numbers) else {
        return Vec::new();
    };
    let most = MOST_BESIDE.min((end - start) / 8);
    let (low, high) = extent(&numbers[start..end]);
    let mut steps: Vec<f64> = numbers[start..end]
        .windows(2)
        .map(|p| (p[1] - p[0]).abs())
        .collect();
    steps.sort_by(f64::total_cmp);
    let step = steps[steps.len() / 2];
    let is_even = steps[steps.len() - 1] - steps[0] <= 0.02 * step;
    // Where it is even the run ends with the first longer step.
    let is_beside = |row: usize, by_a_gap: bool| {
        let number = numbers[row];
        let away = (low - number).max(number - high);
        let is_none = low > 1.5 * LEAST_NM && number > 0.0 && number < LEAST_NM;
        away >= BESIDE_STEPS * step && (is_none || is_even && by_a_gap)
    };
    let gap = |row: usize| lines[row + 1] > lines[row] + 1;
    let head = start <= most && (0..start).all(|row| is_beside(row, gap(start - 1)));
    let tail = numbers.len() - end;
    // Some that carry on the wavelengths at wider steps are the table's own; of a single one that is
    // less sure.
    let reach = 0.5 * (high - low) * tail.min(2) as f64;
    let way = (numbers[end - 1] - numbers[start]).signum();
    let carry_on = (end..numbers.len()).all(|row| {
        let step = way * (numbers[row] - numbers[row - 1]);
        step > 0.0 && step <= reach
    });
    let is_beside = |row| is_beside(row, !carry_on && gap(end - 1));
    let tail = tail <= most && (end..numbers.len()).all(is_beside);
    let head = (0..start).filter(|_| head);
    head.chain((end..numbers.len()).filter(|_| tail)).collect()
}

/// The longest run of rows that rise, or fall, by steps that are not far longer or shorter than
/// the one before; `None` where it is short.
fn longest_run(numbers: &[f64]) -> Option<(usize, usize)> {
    let goes_on = |a: f64, b: f64, c: f64| {
        let (before, step) = ((b - a).abs(), (c - b) * (b - a).signum());
        step < BESIDE_STEPS * before && before < BESIDE_STEPS * step
    };
    let (mut best, mut start) = ((0, 0), 0);
    for row in 2..=numbers.len() {
        let is_whole =
            row < numbers.len() && goes_on(numbers[row - 2], numbers[row - 1], numbers[row]);
        if !is_whole {
            if row - start > best.1 - best.0 {
                best = (start, row);
            }
            start = row - 1;
        }
    }
    (best.1 - best.0 >= FEWEST_THAT_AGREE).then_some(best)
}

/// True if an untitled column holds wavelengths in random order: numbers in the range of
/// nanometres, all at one step, or with values beside them that form a curve once sorted.
pub(crate) fn are_shuffled_nanometres(numbers: &[f64], values: Option<&[f64]>) -> bool {
    let (low, high) = extent(numbers);
    let is_even = |steps: Vec<f64>| {
        let (least, most) = (steps[0], steps[steps.len() - 1]);
        most - least <= 1e-6 * most
    };
    WavelengthUnit::of_range(low, high) == Some(WavelengthUnit::Nanometre)
        && is_shuffled(numbers)
        && (sorted_steps(numbers).is_some_and(is_even)
            || values.is_some_and(|values| is_smoother_sorted(numbers, values)))
}

/// True if values are far smoother in the order of wavelengths than in that of the rows: then they
/// are a curve over them.
fn is_smoother_sorted(numbers: &[f64], values: &[f64]) -> bool {
    let mut rows: Vec<(f64, f64)> = numbers
        .iter()
        .copied()
        .zip(values.iter().copied())
        .collect();
    let way = |rows: &[(f64, f64)]| -> f64 {
        let steps = rows.windows(2).map(|pair| (pair[1].1 - pair[0].1).abs());
        steps.filter(|step| step.is_finite()).sum()
    };
    let before = way(&rows);
    rows.sort_by(|a, b| a.0.total_cmp(&b.0));
    3.0 * way(&rows) < before
}

/// The steps between numbers that were put in order, the least first; `None` where one is missing
/// or stands twice.
fn sorted_steps(numbers: &[f64]) -> Option<Vec<f64>> {
    let mut sorted = numbers.to_vec();
    sorted.sort_by(f64::total_cmp);
    let mut steps: Vec<f64> = sorted.windows(2).map(|pair| pair[1] - pair[0]).collect();
    steps.sort_by(f64::total_cmp);
    // Not a number is not above zero either.
    (steps.first()? > &0.0 && steps.last()?.is_finite()).then_some(steps)
}

/// True if numbers are strictly increasing or strictly decreasing.
pub(in crate::io) fn runs_one_way(numbers: &[f64]) -> bool {
    numbers.is_sorted_by(|a, b| a < b) || numbers.is_sorted_by(|a, b| a > b)
}

/// True if numbers are strictly monotonic within a range of wavelengths.
pub(super) fn may_be_wavelengths(numbers: &[f64]) -> bool {
    let (Some(first), Some(last)) = (numbers.first(), numbers.last()) else {
        return false;
    };
    runs_one_way(numbers) && WavelengthUnit::of_range(first.min(*last), first.max(*last)).is_some()
}

pub(super) fn extent(numbers: &[f64]) -> (f64, f64) {
    let ends = (f64::INFINITY, f64::NEG_INFINITY);
    let wider = |(low, high): (f64, f64), v: &f64| (low.min(*v), high.max(*v));
    numbers.iter().fold(ends, wider)
}

pub(super) fn steps_up_and_down(numbers: &[f64]) -> (usize, usize) {
    let up = numbers.windows(2).filter(|pair| pair[1] > pair[0]).count();
    let down = numbers.windows(2).filter(|pair| pair[1] < pair[0]).count();
    (up, down)
}

/// True if numbers alternately rise and fall, with hardly any duplicates.
fn is_shuffled(numbers: &[f64]) -> bool {
    let (up, down) = steps_up_and_down(numbers);
    if numbers.len() < FEWEST_SHUFFLED || 5 * up.min(down) < numbers.len() {
        return false;
    }
    let mut sorted = numbers.to_vec();
    sorted.sort_by(f64::total_cmp);
    let doubles = sorted.windows(2).filter(|pair| pair[0] == pair[1]).count();
    sorted[0] > 0.0 && sorted[sorted.len() - 1].is_finite() && 20 * doubles <= numbers.len()
}

/// The most rows of a table that may be left out as mistyped: one in twenty.
fn most_stray(rows: usize) -> usize {
    (rows / 20).max(1)
}

/// The rows without which wavelengths rise or fall throughout, where they are no more than one in
/// five, stand alone and lie far from their neighbours.
fn stray_rows(numbers: &[f64]) -> Vec<usize> {
    let rows: Vec<usize> = (0..numbers.len())
        .filter(|row| numbers[*row] > 0.0)
        .collect();
    let (up, down) = steps_up_and_down(numbers);
    let most = rows.len() / 5;
    if rows.len() < FEWEST_THAT_AGREE || up.min(down) == 0 || up.min(down) > 2 * most {
        return Vec::new();
    }
    let sign = if down > up { -1.0 } else { 1.0 };
    let rising: Vec<f64> = rows.iter().map(|row| sign * numbers[*row]).collect();
    let kept = longest_rising(&rising);
    if kept.len() + most < rows.len() {
        return Vec::new();
    }
    let mut steps: Vec<f64> = kept
        .windows(2)
        .map(|pair| rising[pair[1]] - rising[pair[0]])
        .collect();
    steps.sort_by(f64::total_cmp);
    let far = FAR_STEPS * steps[steps.len() / 2];
    let mut stray = Vec::new();
    for at in (0..rows.len()).filter(|at| kept.binary_search(at).is_err()) {
        let behind = kept.partition_point(|kept| *kept < at);
        let before = behind.checked_sub(1).map(|before| kept[before]);
        let below = before.map_or(0.0, |before| rising[before] - rising[at]);
        let above = kept
            .get(behind)
            .map_or(0.0, |next| rising[at] - rising[*next]);
        let stands_alone = before.is_none_or(|before| before + 1 == at)
            && kept.get(behind).is_none_or(|next| *next == at + 1);
        if below.max(above) < far || !stands_alone {
            return Vec::new();
        }
        stray.push(rows[at]);
    }
    stray
}

/// Places of a longest sequence that never falls.
fn longest_rising(numbers: &[f64]) -> Vec<usize> {
    // For each length the place where the lowest last number of such a sequence stands.
    let mut ends: Vec<usize> = Vec::new();
    let mut before: Vec<Option<usize>> = Vec::with_capacity(numbers.len());
    for (at, number) in numbers.iter().enumerate() {
        let length = ends.partition_point(|end| numbers[*end] <= *number);
        before.push(length.checked_sub(1).map(|shorter| ends[shorter]));
        if length == ends.len() {
            ends.push(at);
        } else {
            ends[length] = at;
        }
    }
    let mut found = Vec::with_capacity(ends.len());
    let mut next = ends.last().copied();
    while let Some(at) = next {
        found.push(at);
        next = before[at];
    }
    found.reverse();
    found
}
