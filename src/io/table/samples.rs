//! Rows of several samples below one another, told apart by a column of words or of whole numbers,
//! `leaf, 400, 0.1`, or by several columns of words together.

use std::collections::{HashMap, HashSet};
use std::ops::Range;

use super::block::Block;
use super::row_order::{runs_one_way, steps_up_and_down};
use crate::io::text::dialect::Dialect;

/// Fewest rows of a sample that a number tells from others: values may be whole numbers too.
const FEWEST_ROWS: usize = 5;

/// The name of a sample in a column, and its contiguous rows.
pub(crate) type Sample = (String, Range<usize>);

/// Puts the rows of each sample together, in the order in which samples first appear: tables go
/// from sample to sample, or from wavelength to wavelength. Gives the columns that tell them apart
/// and the samples; `None` where the wavelengths run through once, or no columns make them run
/// through in each sample. Of the columns taken for `values` one at least stays what it is.
pub(crate) fn together(
    block: &mut Block,
    dialect: Dialect,
    axis: usize,
    values: &[usize],
) -> Option<(Vec<usize>, Vec<Sample>)> {
    let wavelengths = block.column(axis);
    if runs_through(wavelengths) {
        return None;
    }
    let mut columns = worded(block);
    let words = columns.len();
    let counted = |column: &usize| {
        let leaves_some = values.iter().any(|of_values| of_values != column);
        *column != axis && leaves_some && is_counted(block.column(*column))
    };
    columns.extend((0..block.width.min(MOST_COUNTED)).filter(counted));
    let cells = cells_of(block, dialect, &columns);
    let apart = |cells: &[&str], fewest: usize| {
        let found = by_word(cells, fewest)?;
        let is_sample = |rows: &[usize]| {
            let nm: Vec<f64> = rows.iter().map(|row| wavelengths[*row]).collect();
            rows.len() >= fewest && runs_through(&nm)
        };
        let is_told = found.len() > 1 && found.iter().all(|(_, rows)| is_sample(rows));
        let mut order = Vec::with_capacity(cells.len());
        let sample = |(name, rows): (&str, Vec<usize>)| {
            let start = order.len();
            order.extend(rows);
            (bare(name).to_owned(), start..order.len())
        };
        let samples: Vec<Sample> = is_told.then(|| found.into_iter().map(sample).collect())?;
        Some((samples, order))
    };
    let own = columns.iter().zip(&cells).enumerate();
    let by_one = own.into_iter().find_map(|(at, (column, cells))| {
        let fewest = if at < words { 2 } else { FEWEST_ROWS };
        Some((vec![*column], apart(cells, fewest)?))
    });
    let by_several = || {
        (2..=words.min(MOST_TOGETHER)).find_map(|count| {
            let row = |row: usize| cells[..count].iter().map(move |of| bare(of[row]));
            let cells = (0..block.rows()).map(|at| row(at).collect::<Vec<_>>().join(", "));
            let cells: Vec<String> = cells.collect();
            let cells: Vec<&str> = cells.iter().map(String::as_str).collect();
            Some((columns[..count].to_vec(), apart(&cells, 2)?))
        })
    };
    let (columns, (samples, order)) = by_one.or_else(by_several)?;
    if !order.is_sorted() {
        block.arrange(&order);
    }
    Some((columns, samples))
}

/// The column of words that names every row apart, where wavelengths go to and fro as in no table of
/// one spectrum: each row is another thing.
pub(crate) fn names_of_rows(block: &Block, dialect: Dialect, axis: usize) -> Option<usize> {
    let (up, down) = steps_up_and_down(block.column(axis));
    if block.rows() < FEWEST_ROWS || 4 * up.min(down) < block.rows() {
        return None;
    }
    let columns = worded(block);
    let cells = cells_of(block, dialect, &columns);
    let is_name = |cell: &&str| bare(cell).starts_with(char::is_alphabetic);
    let named = columns.into_iter().zip(cells).find(|(_, cells)| {
        let apart: HashSet<&str> = cells.iter().copied().collect();
        apart.len() == block.rows() && cells.iter().all(is_name)
    })?;
    Some(named.0)
}

fn worded(block: &Block) -> Vec<usize> {
    let is_worded = |column: &usize| {
        let stats = &block.columns[*column];
        stats.numbers == 0 && stats.texts == block.rows()
    };
    (0..block.width).filter(is_worded).collect()
}

fn bare(cell: &str) -> &str {
    cell.trim_matches(['"', '\'']).trim()
}

/// Most columns of words that tell samples apart together.
const MOST_TOGETHER: usize = 4;

/// Columns that are looked at for numbers of samples: they stand in front.
const MOST_COUNTED: usize = 20;

/// True if a column may number samples.
fn is_counted(values: &[f64]) -> bool {
    values.iter().any(|v| *v != values[0]) && values.iter().all(|v| v.fract() == 0.0)
}

/// True if wavelengths, at least two, are strictly monotonic.
fn runs_through(wavelengths: &[f64]) -> bool {
    wavelengths.len() > 1 && runs_one_way(wavelengths)
}

/// The cells of some columns in each row, a list a column.
fn cells_of<'a>(block: &Block<'a>, dialect: Dialect, columns: &[usize]) -> Vec<Vec<&'a str>> {
    if columns.is_empty() {
        return Vec::new();
    }
    let mut found = vec![Vec::with_capacity(block.rows()); columns.len()];
    let mut cells = Vec::new();
    for content in block.row_texts() {
        dialect.split(content.trim_matches(' '), &mut cells);
        for (column, found) in columns.iter().zip(&mut found) {
            found.push(cells.get(*column).map_or("", |cell| cell.trim()));
        }
    }
    found
}

/// Rows by their word, in the order in which words first appear; `None` where there are too many
/// words for each to have `fewest` rows.
fn by_word<'a>(words: &[&'a str], fewest: usize) -> Option<Vec<(&'a str, Vec<usize>)>> {
    let mut places: HashMap<&str, usize> = HashMap::new();
    let mut found: Vec<(&str, Vec<usize>)> = Vec::new();
    for (row, word) in words.iter().enumerate() {
        let place = *places.entry(word).or_insert(found.len());
        if place == found.len() {
            if (found.len() + 1) * fewest > words.len() {
                return None;
            }
            found.push((word, Vec::new()));
        }
        found[place].1.push(row);
    }
    Some(found)
}
