//! Titles of a table's columns, found in the lines above it.

use super::block::Block;
use crate::io::interpret::value_unit::looks_like_unit;
use crate::io::text::dialect::{Delimiter, Dialect, used};
use crate::io::text::units::names_wavelength;
use crate::io::text::words::holds_one;

/// Longest cell that can be a title; longer ones are sentences.
const LONGEST_TITLE: usize = 80;

/// The titles and units above each column; empty strings where there are none.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Titles {
    /// One title a column.
    pub names: Vec<String>,
    /// One unit a column, from a line of units in brackets below the titles.
    pub units: Vec<String>,
}

impl Titles {
    /// Title and unit of a column in one text, for the words that it holds.
    pub(crate) fn whole(&self, column: usize) -> String {
        let (name, unit) = (&self.names[column], &self.units[column]);
        format!("{name} {unit}").trim().to_owned()
    }

    /// The titles that lines of keys above a block tell of its columns (`YUNITS`, `Y2UNITS`), where
    /// it has several: such a line says nothing of the others then, and goes.
    pub(crate) fn of_keys(block: &mut Block, dialect: Dialect) -> Option<Self> {
        let mut names = vec![String::new(); block.width];
        let mut lines = Vec::new();
        for (line, content) in &block.header {
            let [key, what, ..] = dialect.cells(content)[..] else {
                continue;
            };
            let column = match key {
                "YUNITS" => Some(1),
                _ => key
                    .strip_prefix('Y')
                    .and_then(|key| key.strip_suffix("UNITS")?.parse().ok()),
            };
            if let Some(name) = column.and_then(|column: usize| names.get_mut(column)) {
                what.clone_into(name);
                lines.push(*line);
            }
        }
        let are_all = block.width > 2 && names[1..].iter().all(|name| !name.is_empty());
        are_all.then(|| {
            block.header.retain(|(line, _)| !lines.contains(line));
            let units = vec![String::new(); block.width];
            Self { names, units }
        })
    }

    /// Finds the titles of a block.
    ///
    /// The line next above the block is one if it has a cell for each column; further lines count
    /// only above a line of units or of empty cells, or when they name the wavelength column.
    pub(crate) fn of(block: &Block, dialect: Dialect) -> Self {
        let width = block.width;
        let mut found = Self {
            names: vec![String::new(); width],
            units: vec![String::new(); width],
        };
        let mut next_above = true;
        // Rows that begin with a name or a count are titled from the second column on.
        let row_names = block.has_row_names();
        for (_, line) in block.header.iter().rev().take(12) {
            let Some(cells) = cells_for(line, dialect, block, row_names) else {
                next_above = false;
                continue;
            };
            let filled = cells.iter().filter(|c| !c.is_empty()).count();
            if is_setting(&cells) {
                next_above = false;
            } else if is_plain_unit_line(&cells) || is_bracketed_unit_line(&cells) {
                found.units = cells;
            } else if filled < 2 && width > 2 {
                // A row of empty cells ("Name,,,,"): look above it.
            } else if (next_above || names_wavelength(&cells[0])) && !is_key_and_value(&cells) {
                found.names = with_label(cells);
                break;
            } else {
                next_above = false;
            }
        }
        found
    }
}

/// A line's cells, one for each column, or `None` when it cannot be a line of titles.
fn cells_for(line: &str, dialect: Dialect, block: &Block, row_names: bool) -> Option<Vec<String>> {
    let width = block.width;
    let mut cells = dialect.cells(line);
    let filled = used(&cells);
    if dialect.delimiter == Delimiter::Space && filled != width && filled + 1 != width {
        // Titles of several words each, set apart by TABs or by two blanks and more.
        cells.clear();
        let apart = if line.contains('\t') { "\t" } else { "  " };
        cells.extend(line.split(apart).map(str::trim).filter(|c| !c.is_empty()));
    }
    let filled = used(&cells);
    let is_bracketed = |cell: &&str| cell.starts_with('[') && names_wavelength(cell);
    let bracketed = cells.first().is_some_and(is_bracketed);
    let whole = cells.len() >= width && filled <= width.max(1);
    // Tables written with row names have no title above the first column.
    let one_less = filled + 1 == width && filled >= 2;
    if !(whole && filled > 0 || one_less || bracketed && filled <= width)
        || cells.iter().any(|c| c.chars().count() > LONGEST_TITLE)
    {
        return None;
    }
    let mut titles: Vec<String> = Vec::with_capacity(width);
    if one_less && cells.len() < width && row_names {
        titles.push(String::new());
    }
    let bare = |cell: &&str| cell.trim_matches('"').trim().to_owned();
    titles.extend(cells.iter().take(filled).map(bare));
    // Nobody knows which column has none: two titles of several may have run into one.
    if one_less && !row_names && block.columns[width - 1].numbers > 0 && width > 2 {
        titles.truncate(1);
        titles.retain(|title| names_wavelength(title));
    }
    titles.resize(width, String::new());
    Some(titles)
}

/// A line of nothing but units, plain ones behind the wavelengths' own: "nm, W/m^2/nm, %"; that may
/// be missing, or the word for it stand there.
fn is_plain_unit_line(cells: &[String]) -> bool {
    let of_values = cells.get(1..).unwrap_or(&[]);
    let is_unit = |cell: &String| {
        let cell = cell.trim_matches(['(', ')', '[', ']']);
        // "R%" is a title.
        let is_title = cell.ends_with('%') && cell.len() > 1;
        cell.is_empty() || looks_like_unit(cell) && !is_title
    };
    const AXIS: &str = "^nm$;^um$;^µm$;^μm$;^cm-1$;^1/cm$;^нм$;^å$;^a$;^ev$;^thz$;^unit$;^units$;\
         ^einheit$;^unité$";
    let axis = cells[0]
        .trim_matches(['(', ')', '[', ']', ' ', ':'])
        .to_lowercase();
    (axis.is_empty() || holds_one(&axis, AXIS))
        && of_values.iter().any(|cell| !cell.is_empty())
        && of_values.iter().all(is_unit)
}

/// The same in brackets, all of them.
fn is_bracketed_unit_line(cells: &[String]) -> bool {
    let mut filled = cells.iter().filter(|c| !c.is_empty()).peekable();
    filled.peek().is_some()
        && filled.all(|c| {
            c.starts_with('[') && c.ends_with(']') || c.starts_with('(') && c.ends_with(')')
        })
}

/// A line such as "Time: 130msec" or "#AxisUnit[1]= nm": its first cell ends with the mark of a key.
fn is_setting(cells: &[String]) -> bool {
    let first = cells[0].trim_matches(['"', ' ']);
    first.ends_with([':', '=']) && !names_wavelength(first)
}

/// A line such as "Integration time, 92.0" above two columns, or "Remarks: none".
fn is_key_and_value(cells: &[String]) -> bool {
    let is_key = cells[0].ends_with(':') && !names_wavelength(&cells[0]);
    is_key || cells.len() == 2 && !cells[1].contains(char::is_alphabetic)
}

/// Titles that are bare numbers take the first column's word: "Index 13".
fn with_label(mut cells: Vec<String>) -> Vec<String> {
    let label = cells[0].clone();
    let is_number = |cell: &String| cell.parse::<f64>().is_ok();
    let is_axis = names_wavelength(&label);
    // Above wavelengths a number is what somebody calls a column.
    let are_names = is_axis && cells.iter().filter(|cell| is_number(cell)).count() > 1;
    let is_label = !label.is_empty() && !is_axis && !is_number(&label);
    for cell in &mut cells[usize::from(is_label)..] {
        if is_label && is_number(cell) {
            *cell = format!("{label} {cell}");
        } else if !(cell.contains(char::is_alphabetic) || are_names && is_number(cell)) {
            cell.clear();
        }
    }
    cells
}
