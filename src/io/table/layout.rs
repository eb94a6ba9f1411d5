//! The position of the wavelengths in a block of numbers: down a column or along a row.

use std::ops::Range;

use super::block::Block;
use super::row_order::{are_shuffled_nanometres, extent, runs_one_way};
use super::titles::Titles;
use crate::io::text::dialect::{Dialect, used};
use crate::io::text::number::label_nm;
use crate::io::text::units::{
    WavelengthUnit, looks_like_metres, names_another_quantity, names_wavelength,
};

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Layout {
    /// Down a column, one spectrum in each other column.
    Column(usize),
    /// Along a row, one spectrum in each row.
    Row(AlongRow),
}

/// Wavelengths along a row.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct AlongRow {
    /// The first column with a wavelength; names may stand before it.
    pub first: usize,
    /// The wavelengths in the file's unit, one each column from `first` on.
    pub axis: Vec<f64>,
    /// The first row of values: 1 when the wavelengths are the block's first row, 0 when they
    /// stand in the header.
    pub from_row: usize,
    /// True if the axis itself states that it is in nanometres.
    pub says_nm: bool,
}

/// Fewest wavelengths in a row that make a table of spectra in rows.
const FEWEST_IN_A_ROW: usize = 5;

const FILLED: f64 = 0.9;

/// The same under a title that names wavelengths.
const FILLED_TITLED: f64 = 0.25;

/// The score of a column of nanometres labelled as such.
const SUREST: u32 = 14;

/// Steps in a hundred that may go against the others: rounding and overlapping detectors.
const FEW_REVERSALS: usize = 10;

/// The same under a title that names wavelengths: a curve traced by hand goes back and forth.
const TRACED_REVERSALS: usize = 50;

/// The score of nanometres in random order: less than any that rise or fall.
const SHUFFLED: u32 = 1;

/// The score of numbers in the range of nanometres, reached by every axis titled so: the threshold
/// for a few rows beside a long table.
pub(crate) const CLEAR: u32 = 4;

/// Some tables begin with zeros or end with a few that are no wavelengths.
fn without_zero_ends(numbers: &[f64]) -> &[f64] {
    let counts = |v: &f64| !v.is_nan() && *v != 0.0;
    let first = numbers.iter().position(counts).unwrap_or(numbers.len());
    let behind = numbers.iter().rposition(counts).map_or(first, |at| at + 1);
    let zeros = numbers[behind..].iter().filter(|v| **v == 0.0).count();
    // Readings, too, may end with zeros.
    match zeros {
        1 => &numbers[first..behind],
        2.. if 10 * zeros <= behind - first => &numbers[first..behind],
        _ => &numbers[first..],
    }
}

/// Confidence that a sequence of numbers is a wavelength axis; 0 if it is not.
fn strength(numbers: &[f64], most_reversals: usize) -> u32 {
    let mut min = f64::INFINITY;
    let mut max = f64::NEG_INFINITY;
    let (mut count, mut up, mut down, mut ones) = (0usize, 0usize, 0usize, 0usize);
    let mut last = f64::NAN;
    for v in without_zero_ends(numbers).iter().filter(|v| !v.is_nan()) {
        count += 1;
        min = min.min(*v);
        max = max.max(*v);
        up += usize::from(*v > last);
        down += usize::from(*v < last);
        ones += usize::from(*v - last == 1.0);
        last = *v;
    }
    let reversals = up.min(down);
    // Numbers that hardly ever change are readings, unless a title says otherwise.
    let is_untitled = most_reversals == FEW_REVERSALS;
    if is_untitled && (up + down) * 3 + 1 < count {
        return 0;
    }
    if count < 2 || up + down == 0 || reversals * 100 > count * most_reversals {
        return 0;
    }
    let counts_rows = ones + 1 == count && min <= 1.0 && min.fract() == 0.0;
    match WavelengthUnit::of_range(min, max) {
        Some(WavelengthUnit::Nanometre) => CLEAR,
        Some(WavelengthUnit::PerCentimetre) => 3,
        Some(_) if !counts_rows => 2,
        None if looks_like_metres(min, max) => 2,
        _ => u32::from(!counts_rows && min > 0.0 && max > 100.0),
    }
}

/// The block's layout and how sure it is, or `None` when it holds no wavelengths.
pub(crate) fn of(block: &Block, titles: &Titles, dialect: Dialect) -> Option<(Layout, u32)> {
    let (down, down_strength) = wavelength_column(block, titles);
    let along = wavelength_row(block).or_else(|| wavelength_header(block, dialect));
    let surer = along.filter(|(_, strength)| {
        *strength > down_strength || *strength == down_strength && block.width > block.rows()
    });
    match surer {
        Some((along, strength)) => Some((Layout::Row(along), strength)),
        None => (down_strength > 0).then_some((Layout::Column(down), down_strength)),
    }
}

fn wavelength_column(block: &Block, titles: &Titles) -> (usize, u32) {
    let mut best = (0, 0);
    let mut is_one_number = false;
    // Columns far to the right are not searched, so that a wide table stays cheap.
    for column in 0..block.width.min(17) {
        let stats = &block.columns[column];
        let titled =
            names_wavelength(&titles.names[column]) || names_wavelength(&titles.units[column]);
        if !titled && names_another_quantity(&titles.whole(column)) {
            continue;
        }
        // Detectors reach beyond the range that was calibrated: only a title is worth more then.
        let (filled, most_reversals) = match titled {
            true => (FILLED_TITLED, TRACED_REVERSALS),
            false => (FILLED, FEW_REVERSALS),
        };
        if (stats.numbers as f64) < filled * block.rows() as f64 {
            continue;
        }
        let numbers = block.column(column);
        let by_values = match strength(numbers, most_reversals) {
            0 if column == 0
                && !titled
                && are_shuffled_nanometres(numbers, block.values.get(1).map(Vec::as_slice)) =>
            {
                SHUFFLED
            }
            found => found,
        };
        // One line at many times: no other column is its wavelengths.
        is_one_number |= titled && block.is_constant(column);
        let says_so = titled || stats.nanometres * 2 > stats.numbers;
        let score = by_values + if by_values > 0 && says_so { 10 } else { 0 };
        if score > best.1 {
            best = (column, score);
        }
        if best.1 == SUREST {
            break;
        }
    }
    let is_titled = best.1 > 10;
    if is_one_number && !is_titled {
        (0, 0)
    } else {
        best
    }
}

/// Wavelengths along the first row of the block: `wavelength, 380, 385, ...`.
fn wavelength_row(block: &Block) -> Option<(AlongRow, u32)> {
    let row = &block.row(0);
    let first = row.iter().position(|v| !v.is_nan())?;
    let last = row.iter().rposition(|v| !v.is_nan())?;
    let axis = row[first..=last].to_vec();
    let strength = strength_of_row(&axis)?;
    let along = AlongRow {
        first,
        axis,
        from_row: 1,
        says_nm: block.columns[first].nanometres > 0,
    };
    Some((along, strength))
}

/// Wavelengths in titles with a common word: `R_400, R_410, ...` or `400 nm, 410 nm, ...`.
fn wavelength_header(block: &Block, dialect: Dialect) -> Option<(AlongRow, u32)> {
    block.header.iter().rev().take(3).find_map(|(_, line)| {
        let cells = dialect.cells(line);
        let labels: Vec<_> = cells[..used(&cells)].iter().map(|c| label_nm(c)).collect();
        if labels.len() != block.width {
            return None;
        }
        let first = labels
            .iter()
            .rposition(Option::is_none)
            .map_or(0, |at| at + 1);
        let (axis, say_nm): (Vec<f64>, Vec<bool>) =
            labels.into_iter().skip(first).flatten().unzip();
        let strength = strength_of_row(&axis)?;
        let along = AlongRow {
            first,
            axis,
            from_row: 0,
            says_nm: !say_nm.contains(&false),
        };
        Some((along, strength))
    })
}

fn strength_of_row(axis: &[f64]) -> Option<u32> {
    let found = strength(axis, FEW_REVERSALS);
    (axis.len() >= FEWEST_IN_A_ROW && runs_one_way(axis) && found >= 2).then_some(found)
}

/// Rows of a wavelength column from one jump back to the start to the next: a file that lists the
/// same range twice holds two tables. A short step back (detectors that overlap) is no jump.
pub(crate) fn runs(axis: &[f64]) -> Vec<Range<usize>> {
    let mut runs = Vec::new();
    let (mut start, mut low, mut high) = (0, f64::INFINITY, f64::NEG_INFINITY);
    let mut rising = None;
    let mut last = f64::NAN;
    let rows = axis.iter().copied().enumerate();
    for (row, v) in rows.filter(|(_, v)| !v.is_nan() && *v != 0.0) {
        let against = match rising {
            Some(true) => last - v,
            Some(false) => v - last,
            None => 0.0,
        };
        if against > 0.5 * (high - low) && row - start >= 5 {
            runs.push(start..row);
            (start, low, high, rising) = (row, v, v, None);
        } else {
            if rising.is_none() && v != last && !last.is_nan() {
                rising = Some(v > last);
            }
            (low, high) = (low.min(v), high.max(v));
        }
        last = v;
    }
    runs.push(start..axis.len());
    if are_apart(axis, &runs) {
        // One curve in several pieces, as people trace them from a plot.
        runs = std::iter::once(0..axis.len()).collect();
    }
    runs
}

fn are_apart(axis: &[f64], runs: &[Range<usize>]) -> bool {
    let mut spans: Vec<(f64, f64)> = runs.iter().map(|run| extent(&axis[run.clone()])).collect();
    spans.sort_by(|a, b| a.0.total_cmp(&b.0));
    spans.windows(2).all(|pair| pair[0].1 <= pair[1].0)
}
