//! The tables of a CGATS text: keywords, fields, and the sets below them.
//!
//! Cells are set apart by blanks or TABs and may be quoted; a row may run over several lines. Rows
//! whose cells are set apart by TABs, semicolons or commas alone (blanks in names, empty cells)
//! are known by having one cell a field.

use std::rc::Rc;

use super::bands::{Bands, bands};
use crate::io::error::quoted;
use crate::io::provenance::ORIGINATOR;
use crate::io::text::number::{self, Cell};
use crate::io::text::{kept_line, lines};
use crate::io::{Input, ReadError};
use crate::languages::with_sign;

/// Most keywords kept from one file.
const MOST_KEYS: usize = 10_000;

/// Most tables in one file.
const MOST_TABLES: usize = 1000;

/// Fields that name a set, the best first.
const NAMES: &str = "SAMPLE_NAME;SAMPLENAME;SAMPLE_ID;SAMPLEID;SAMPLE_LOC;PATCH_NAME;NAME;STRING";

/// One table.
#[derive(Debug, Default)]
pub(super) struct CgatsTable<'a> {
    /// Its type by its first line: `SPECT`, `CTI3`, `CGATS.17`, ...; that of the first table where
    /// a later one gives none.
    pub kind: &'a str,
    /// Keywords and values, quotes removed, in file order.
    keys: Vec<(&'a str, &'a str)>,
    pub fields: Rc<Fields<'a>>,
    /// One for each of the spectral columns, set by set; NaN where one is missing.
    numbers: Vec<f64>,
    /// The name of each set; empty where nothing names it.
    pub names: Vec<&'a str>,
    /// First line of each set, from 1.
    pub lines: Vec<u32>,
    pub decimal_comma: bool,
    /// Notes on irregularities, a sentence each.
    pub notes: Vec<String>,
}

/// The columns of a table, which later ones may share.
#[derive(Debug, Default)]
pub(super) struct Fields<'a> {
    pub titles: Vec<&'a str>,
    /// Line of `BEGIN_DATA_FORMAT`, from 1.
    pub line: usize,
    /// The spectra that they make.
    pub bands: Vec<Bands>,
    /// The columns of those, rising.
    spectral: Vec<usize>,
    /// Those that name a set, the best first.
    naming: Vec<usize>,
}

impl<'a> Fields<'a> {
    fn new(titles: Vec<&'a str>, line: usize, stated: Option<f64>) -> Self {
        let bands = bands(&titles, stated);
        let columns = bands
            .iter()
            .flat_map(|group| group.columns.iter().chain(&group.nm_columns));
        let mut spectral: Vec<usize> = columns.copied().collect();
        spectral.sort_unstable();
        let place = |name: &str| titles.iter().position(|t| t.eq_ignore_ascii_case(name));
        let naming = NAMES.split(';').filter_map(place).collect();
        Self {
            titles,
            line,
            bands,
            spectral,
            naming,
        }
    }
}

impl<'a> CgatsTable<'a> {
    pub(super) fn sets(&self) -> usize {
        self.lines.len()
    }

    /// The numbers of some spectral columns, set by set.
    pub(super) fn rows(&self, columns: &[usize]) -> Vec<Vec<f64>> {
        let spectral = &self.fields.spectral;
        let place = |column| spectral.binary_search(column).ok();
        let places: Vec<usize> = columns.iter().filter_map(place).collect();
        let sets = self.numbers.chunks(spectral.len().max(1));
        sets.map(|set| places.iter().map(|place| set[*place]).collect())
            .collect()
    }

    /// The last value of a keyword.
    pub(super) fn key(&self, key: &str) -> Option<&'a str> {
        self.keys
            .iter()
            .rev()
            .find(|(k, v)| k.eq_ignore_ascii_case(key) && !v.is_empty())
            .map(|(_, v)| *v)
    }

    /// True if this program wrote it: its keywords give name, kind, unit and source.
    pub(super) fn is_own(&self) -> bool {
        self.key("ORIGINATOR")
            .is_some_and(|v| v.starts_with(ORIGINATOR))
    }

    /// The number that a keyword states.
    pub(super) fn number(&self, key: &str) -> Option<f64> {
        let value = self.key(key)?;
        match (number::parse(value, false), number::parse(value, true)) {
            (Cell::Number(v), _) | (Cell::Text, Cell::Number(v)) => Some(v),
            _ => None,
        }
    }
}

/// Words set apart by blanks and TABs, quotes honoured and removed, up to a comment.
fn words<'a>(line: &'a str, out: &mut Vec<&'a str>) {
    out.clear();
    let mut rest = line.trim_start();
    while !rest.is_empty() && !rest.starts_with('#') {
        let (word, behind) = match rest.strip_prefix('"') {
            Some(inside) => match inside.find('"') {
                Some(end) => (&inside[..end], &inside[end + 1..]),
                None => (inside, ""),
            },
            None => {
                let end = rest.find([' ', '\t', '\u{a0}']).unwrap_or(rest.len());
                (&rest[..end], &rest[end..])
            }
        };
        out.push(word);
        rest = behind.trim_start();
    }
}

/// The cells of a row, one a field if some way of splitting it gives that.
fn cells<'a>(line: &'a str, fields: usize, out: &mut Vec<&'a str>) {
    for mark in ['\t', ';', ','] {
        if fields > 1 && line.contains(mark) {
            out.clear();
            // One cell more may be an empty one at the end; two more are too many.
            let all = line.split(mark).map(|c| c.trim().trim_matches('"'));
            out.extend(all.take(fields + 2));
            if out.len() == fields + 1 && out.last().is_some_and(|c| c.is_empty()) {
                out.pop();
            }
            if out.len() == fields {
                return;
            }
        }
    }
    words(line, out);
}

/// All tables of a text.
///
/// # Errors
/// [`ReadError`] for a word among the numbers, a row of the wrong length, or data without fields.
pub(super) fn tables<'a>(input: &Input, text: &'a str) -> Result<Vec<CgatsTable<'a>>, ReadError> {
    let stated = text.lines().find_map(|line| {
        let bands = line.trim_start().strip_prefix("SPECTRAL_BANDS")?;
        bands.trim_matches([' ', '\t', '"']).parse().ok()
    });
    let mut lines = lines(text)
        .map(|(line, content)| (line, content.trim()))
        .filter(|(_, content)| !content.is_empty() && !content.starts_with('#'));
    let mut done: Vec<CgatsTable> = Vec::new();
    let mut open = CgatsTable::default();
    let mut row: Vec<&str> = Vec::new();
    while let Some((line, content)) = lines.next() {
        words(content, &mut row);
        match row.as_slice() {
            [] | ["KEYWORD", ..] => {}
            ["BEGIN_DATA_FORMAT", first @ ..] => {
                let mut titles = Vec::new();
                let mut more = first.to_vec();
                while !take_titles(&more, &mut titles) {
                    let Some((_, content)) = lines.next() else {
                        return Ok(done);
                    };
                    words(content, &mut more);
                }
                open.fields = Rc::new(Fields::new(titles, line, stated));
            }
            ["BEGIN_DATA", ..] => {
                if open.fields.titles.is_empty() {
                    // A further table may go on with the fields of the one before.
                    let expected = said!("BEGIN_DATA_FORMAT before it");
                    let nothing = || input.error_at(line, "BEGIN_DATA", expected);
                    open.fields = done.last().ok_or_else(nothing)?.fields.clone();
                }
                let mut table = std::mem::take(&mut open);
                let end = table.data(input, &mut lines)?;
                table.finish(done.first());
                done.push(table);
                if let Some(end) = end.filter(|_| done.len() >= MOST_TABLES) {
                    let found = tr!("more than {most} tables", most = MOST_TABLES);
                    return Err(input.error_at(end, found, said!("a smaller file")));
                }
            }
            [other, ..] if other.starts_with("BEGIN_") => {
                let end = other.replacen("BEGIN_", "END_", 1);
                lines.find(|(_, content)| content.starts_with(&end));
            }
            [kind] if open.kind.is_empty() && open.keys.is_empty() => open.kind = kind,
            [key, values @ ..] => {
                if open.keys.len() < MOST_KEYS {
                    let value = values.first().copied().unwrap_or("");
                    open.keys.push((*key, value));
                }
            }
        }
    }
    Ok(done)
}

/// Takes titles of columns up to `END_DATA_FORMAT`; true if that is among them.
fn take_titles<'a>(row: &[&'a str], titles: &mut Vec<&'a str>) -> bool {
    let end = row.iter().position(|word| *word == "END_DATA_FORMAT");
    titles.extend(&row[..end.unwrap_or(row.len())]);
    end.is_some()
}

impl<'a> CgatsTable<'a> {
    /// Takes the rows up to `END_DATA`; its line, where it is there.
    fn data(
        &mut self,
        input: &Input,
        lines: &mut impl Iterator<Item = (usize, &'a str)>,
    ) -> Result<Option<usize>, ReadError> {
        let width = self.fields.titles.len();
        // Cells of a row, which may continue on further lines, and its first line.
        let (mut row, mut more, mut first) = (Vec::new(), Vec::new(), 0);
        let mut end = None;
        for (line, content) in lines {
            if content.starts_with("END_DATA") {
                end = Some(line);
                break;
            }
            if row.is_empty() {
                first = line;
                cells(content, width, &mut row);
            } else {
                words(content, &mut more);
                if row.len() + more.len() > width {
                    break;
                }
                row.append(&mut more);
            }
            if row.len() == width {
                self.take_row(input, &row, first)?;
                row.clear();
            } else if row.len() > width {
                break;
            }
        }
        if !row.is_empty() {
            let expected = tr!("{number}, one for each field", number = width);
            let found = tr!("{n} cells" | "{n} cells" % row.len());
            return Err(input.error_at(first, found, expected));
        }
        if end.is_none() {
            let note = said!("the file ends without END_DATA");
            self.notes.push(note.to_owned());
        }
        Ok(end)
    }

    /// Takes the cells of a whole row.
    fn take_row(&mut self, input: &Input, row: &[&'a str], line: usize) -> Result<(), ReadError> {
        for column in &self.fields.spectral {
            let cell = row[*column];
            let value = match number::parse(cell, self.decimal_comma).value() {
                Some(value) => value,
                None => match number::parse(cell, !self.decimal_comma) {
                    Cell::Number(value) => {
                        self.decimal_comma |= cell.contains(',');
                        value
                    }
                    _ => {
                        let expected = tr!(
                            "a number for {column}",
                            column = self.fields.titles[*column]
                        );
                        return Err(input.error_at(line, quoted(cell), expected));
                    }
                },
            };
            self.numbers.push(value);
        }
        let mut names = self.fields.naming.iter().map(|column| row[*column].trim());
        self.names
            .push(names.find(|name| !name.is_empty()).unwrap_or(""));
        self.lines.push(kept_line(line));
        Ok(())
    }

    /// Adopts the type of the first table where this one has none, and notes keywords that
    /// contradict the data.
    fn finish(&mut self, first: Option<&Self>) {
        if let Some(first) = first.filter(|_| self.kind.is_empty()) {
            self.kind = first.kind;
        }
        for (key, found, what) in [
            ("NUMBER_OF_FIELDS", self.fields.titles.len(), "fields"),
            ("NUMBER_OF_SETS", self.sets(), "sets"),
        ] {
            if let Some(says) = self.number(key).filter(|says| *says != found as f64) {
                let says = with_sign(says.to_string());
                let note = match what {
                    "sets" => tr!(
                        "{key} says {number} and there are {n} sets"
                            | "{key} says {number} and there are {n} sets" % found,
                        key,
                        number = says
                    ),
                    _ => tr!(
                        "{key} says {number} and there are {n} fields"
                            | "{key} says {number} and there are {n} fields" % found,
                        key,
                        number = says
                    ),
                };
                self.notes.push(note);
            }
        }
    }
}
