//! JSON of no program in particular: lists of numbers beside a list of wavelengths.
//!
//! ```text
//! {"name": "lamp", "unit": "W/m2/nm", "wavelengths": [380, 390, ..], "values": [..], "other": [..]}
//! {"wavelength_nm": [..], "samples": [{"name": "A", "reflectance": [..]}, ..]}
//! [{"wavelength": 380, "value": 0.1}, ..]      [[380, 0.1], [390, 0.2], ..]      {"380": 0.1, ..}
//! {"start": 380, "end": 730, "interval": 10, "values": [..]}      {"bands": [400, 410, ..], ..}
//! {"wavelength": {"0": 380, "1": 390, ..}, "value": {"0": 0.1, "1": 0.2, ..}}
//! ```
//!
//! The meaning of words is decided as in a table of text: keys are the titles of columns, and other
//! words beside them are the lines above it. Keys above several tables are their names.

mod keys;
mod lists;
mod range;

use std::collections::BTreeSet;

use crate::io::decode::json_tree::{Object, Tree};
use crate::io::error::kept;
use crate::io::interpret::heading::Heading;
use crate::io::interpret::raw::{RawSpectrum, Scale};
use crate::io::interpret::{interpret, kinds};
use crate::io::table::roles;
use crate::io::text::number;
use crate::io::{Input, ReadError, Reading, quoted};
use keys::{NAMES, is_no_name, spaced};
use lists::{Column, Lists, of_keys, of_lists, of_points, of_rows};

/// The depth to which a file is searched for spectra.
pub(super) const DEPTH: usize = 8;

/// Most words beside a table that are kept, and most bytes of them: every table is read with all.
const MOST_WORDS: usize = 100;
const MOST_WORD_BYTES: usize = 4096;

/// Most keys reported of lists that are no spectra.
const MOST_LEFT_OUT: usize = 100;

/// Bytes of words that are read with the tables of one file altogether, besides twice its size;
/// with further tables only the start of the nearest line is.
const MOST_BYTES_READ: usize = 1 << 19;
const NEAREST_BYTES: usize = 60;

/// Adds all spectra that a JSON value holds; none where it holds no wavelengths.
pub(super) fn read(input: &Input, value: &Tree, reading: &mut Reading) -> Result<(), ReadError> {
    let mut finder = Finder {
        input,
        reading,
        words: Vec::new(),
        bytes_read: 0,
        left_out: BTreeSet::new(),
    };
    finder.look(value, DEPTH)?;
    let left_out = finder.left_out.iter();
    let notes = left_out.map(|(title, why)| roles::left_out_words(&quoted(title), why));
    finder.reading.notes.extend(notes);
    Ok(())
}

/// Looks for tables and adds their spectra.
struct Finder<'i, 'f, 'r> {
    input: &'i Input<'f>,
    reading: &'r mut Reading,
    /// Words of the objects around, the innermost last.
    words: Vec<String>,
    /// Of words read with tables so far.
    bytes_read: usize,
    /// Keys above lists that are no spectra, and why.
    left_out: BTreeSet<(String, &'static str)>,
}

impl Finder<'_, '_, '_> {
    fn look(&mut self, value: &Tree, depth: usize) -> Result<(), ReadError> {
        let Some(depth) = depth.checked_sub(1) else {
            return Ok(());
        };
        let outside = self.words.len();
        if let Tree::Object(object) = value {
            words_of(object).for_each(|line| self.push(line));
        }
        let tables = tables_in(value);
        match value {
            _ if !tables.is_empty() => tables.into_iter().try_for_each(|lists| self.add(lists))?,
            Tree::Object(object) => self.look_below(object, depth)?,
            Tree::List(list) => list.iter().try_for_each(|inner| self.look(inner, depth))?,
            _ => {}
        }
        self.words.truncate(outside);
        Ok(())
    }

    /// Searches the content under the keys, which are names where there are several.
    fn look_below(&mut self, object: &Object, depth: usize) -> Result<(), ReadError> {
        let below = || object.iter().filter(|(_, inner)| inner.holds_values());
        let several = below().nth(1).is_some();
        for (key, inner) in below() {
            let outside = self.words.len();
            let plain = spaced(key).to_lowercase();
            let is_kind = kinds::kind_of_title(&plain).is_some();
            if several && !is_no_name(plain.trim()) {
                let is_number = number::number(key.trim(), false).is_some();
                self.push(if is_kind || is_number {
                    format!("name: {} {}", self.input.stem(), kept(key))
                } else {
                    format!("name: {}", kept(key))
                });
            }
            if !several && is_kind {
                self.push(format!("y units: {plain}"));
            }
            self.look(inner, depth)?;
            self.words.truncate(outside);
        }
        Ok(())
    }

    /// Bytes of the words.
    fn bytes(&self) -> usize {
        self.words.iter().map(String::len).sum()
    }

    /// Remembers a line, unless there are many already.
    fn push(&mut self, line: String) {
        if self.words.len() < MOST_WORDS && self.bytes() + line.len() <= MOST_WORD_BYTES {
            self.words.push(line);
        }
    }

    fn add(&mut self, lists: Lists) -> Result<(), ReadError> {
        let title = |column: usize| spaced(lists.columns[column].title);
        let all = (0..lists.columns.len()).collect();
        let (spectra, mut left_out) = roles::by_titles(title, all);
        left_out.sort_unstable_by_key(|other| other.column);
        for other in left_out {
            if self.left_out.len() < MOST_LEFT_OUT {
                let title = kept(lists.columns[other.column].title);
                self.left_out.insert((title.to_owned(), other.why));
            }
        }
        let mut place = 0..;
        let mut columns = lists.columns;
        columns.retain(|_| {
            place
                .next()
                .is_some_and(|at| spectra.binary_search(&at).is_ok())
        });
        self.bytes_read += self.bytes();
        let most_read = MOST_BYTES_READ + 2 * self.input.bytes.len();
        let lines: Vec<(usize, &str)> = if self.bytes_read <= most_read {
            self.words.iter().map(|line| (0, &**line)).collect()
        } else {
            let start = |line: &str| line.floor_char_boundary(NEAREST_BYTES);
            let nearest = self.words.last().map(|line| (0, &line[..start(line)]));
            nearest.into_iter().collect()
        };
        let heading = Heading::of(&lines).shared_by(columns.len());
        let scale = Scale::new(&lists.axis);
        let (several, are_channels) = (columns.len() > 1, are_channels(&columns));
        let stem = heading.name.unwrap_or(self.input.stem());
        for column in columns {
            let name = match (column.name, several) {
                (Some(name), _) => name.into_owned(),
                (None, true) if !column.title.is_empty() => format!("{stem} {}", column.title),
                _ => stem.to_owned(),
            };
            let axis_title = &lists.axis_title;
            let raw = RawSpectrum::written(name, &scale, axis_title, column.values, &heading);
            let raw = RawSpectrum {
                title: match are_channels {
                    true => title_of_channel(column.title).to_owned(),
                    false => spaced(column.title),
                },
                ..raw.saying_nm(lists.says_nm)
            };
            interpret(raw, self.input, self.reading)?;
        }
        Ok(())
    }
}

/// The tables that a value holds in one of the ways that JSON has for them.
fn tables_in(value: &Tree) -> Vec<Lists<'_>> {
    let mut tables: Vec<Lists> = value.object().and_then(of_lists).into_iter().collect();
    if tables.is_empty() {
        tables = of_points(value);
    }
    if tables.is_empty() {
        tables.extend(match value {
            Tree::Object(object) => of_keys(object),
            Tree::List(list) => of_rows(list),
            _ => None,
        });
    }
    tables
}

/// True if columns are a camera's or a display's red, green and blue: then R is no reflectance.
fn are_channels(columns: &[Column]) -> bool {
    let first_word = |column: &Column| {
        let title = spaced(column.title).to_lowercase();
        title.split_whitespace().next().unwrap_or("").to_owned()
    };
    let words: Vec<String> = columns.iter().map(first_word).collect();
    [["r", "red"], ["g", "green"], ["b", "blue"]]
        .iter()
        .all(|names| words.iter().any(|word| names.contains(&&**word)))
}

/// The quantity implied by the title of a channel: `red_ssf` is a camera's sensitivity.
fn title_of_channel(title: &str) -> &'static str {
    let title = title.to_lowercase();
    let words = ["ssf", "sensitiv", "respons", "qe"];
    match words.iter().any(|word| title.contains(word)) {
        true => "spectral sensitivity",
        false => "",
    }
}

/// Words and numbers beside lists, as the lines above a lists.
fn words_of(object: &Object) -> impl Iterator<Item = String> {
    object.iter().filter_map(|(key, value)| {
        let key = if NAMES[..2].contains(&&*key.to_lowercase()) {
            "name".to_owned()
        } else {
            spaced(&kept(key).to_lowercase())
        };
        match value {
            Tree::Text(text) if !text.trim().is_empty() => Some(format!("{key}: {}", kept(text))),
            _ => None,
        }
    })
}
