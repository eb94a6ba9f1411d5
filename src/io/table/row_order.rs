//! Rows of a table that do not stand where their wavelengths belong: a few stray ones are left out,
//! and a table in random order is sorted, both with a word.

use super::block::{Block, FEWEST_THAT_AGREE, most_left_out};
use crate::io::provenance::shortest;
use crate::io::text::units::WavelengthUnit;

/// A row that is left out lies at least so many steps away from its neighbours: detectors that
/// overlap and curves traced by hand step back by less.
const FAR_STEPS: f64 = 10.0;

/// Fewest rows that can be said to stand in random order.
const FEWEST_SHUFFLED: usize = 10;

/// The largest step between neighbours, in median steps, of a table that was shuffled.
const MOST_STEPS: f64 = 5.0;

/// Leaves out the few rows that break the order of wavelengths while all others keep it, and sorts
/// rows in random order. What was done, a sentence each; `values` are the columns beside.
pub(crate) fn put_right(block: &mut Block, axis: usize, values: &[usize]) -> Vec<String> {
    let numbers = block.column(axis);
    let stray = stray_rows(numbers);
    if !stray.is_empty() {
        let said = stray.iter().map(|row| {
            let first = values.first().map(|column| block.column(*column)[*row]);
            let value = first.filter(|value| !value.is_nan());
            let value = value.map_or(String::new(), |v| format!(" (value {})", shortest(v)));
            format!(
                "line {}: wavelength {}{value} is out of order: the row was left out",
                block.lines[*row],
                shortest(numbers[*row])
            )
        });
        let said = said.collect();
        let kept = (0..block.rows()).filter(|row| stray.binary_search(row).is_err());
        block.arrange(&kept.collect::<Vec<_>>());
        return said;
    }
    if !is_shuffled(numbers) {
        return Vec::new();
    }
    let mut order: Vec<usize> = (0..block.rows()).collect();
    order.sort_by(|a, b| numbers[*a].total_cmp(&numbers[*b]));
    block.arrange(&order);
    vec!["rows in no order of wavelengths: put in rising order".to_owned()]
}

/// Whether a column without a title is one of wavelengths in random order: numbers in the range of
/// nanometres, all at one step.
pub(crate) fn are_shuffled_nanometres(numbers: &[f64]) -> bool {
    let (low, high) = extent(numbers);
    WavelengthUnit::of_range(low, high) == Some(WavelengthUnit::Nanometre)
        && is_shuffled(numbers)
        && sorted_steps(numbers).is_some_and(|steps| {
            let (least, most) = (steps[0], steps[steps.len() - 1]);
            most - least <= 1e-6 * most
        })
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

/// Whether numbers rise throughout, or fall.
pub(super) fn runs_one_way(numbers: &[f64]) -> bool {
    numbers.is_sorted_by(|a, b| a < b) || numbers.is_sorted_by(|a, b| a > b)
}

/// Whether numbers run one way in a range of wavelengths.
pub(super) fn may_be_wavelengths(numbers: &[f64]) -> bool {
    let (Some(first), Some(last)) = (numbers.first(), numbers.last()) else {
        return false;
    };
    runs_one_way(numbers) && WavelengthUnit::of_range(first.min(*last), first.max(*last)).is_some()
}

/// The least of some numbers and the greatest; gaps do not matter.
pub(super) fn extent(numbers: &[f64]) -> (f64, f64) {
    let ends = (f64::INFINITY, f64::NEG_INFINITY);
    let wider = |(low, high): (f64, f64), v: &f64| (low.min(*v), high.max(*v));
    numbers.iter().fold(ends, wider)
}

/// How many steps go up, and down.
pub(super) fn steps_up_and_down(numbers: &[f64]) -> (usize, usize) {
    let up = numbers.windows(2).filter(|pair| pair[1] > pair[0]).count();
    let down = numbers.windows(2).filter(|pair| pair[1] < pair[0]).count();
    (up, down)
}

/// Whether all numbers differ, run to and fro, and lie evenly enough to be one table.
fn is_shuffled(numbers: &[f64]) -> bool {
    let (up, down) = steps_up_and_down(numbers);
    if numbers.len() < FEWEST_SHUFFLED || 4 * up.min(down) < numbers.len() {
        return false;
    }
    sorted_steps(numbers)
        .is_some_and(|steps| steps[steps.len() - 1] <= MOST_STEPS * steps[steps.len() / 2])
}

/// The rows without which wavelengths rise or fall throughout, where they are few, stand alone and
/// lie far from their neighbours.
fn stray_rows(numbers: &[f64]) -> Vec<usize> {
    let rows: Vec<usize> = (0..numbers.len())
        .filter(|row| numbers[*row] > 0.0)
        .collect();
    let (up, down) = steps_up_and_down(numbers);
    let most = most_left_out(rows.len());
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
