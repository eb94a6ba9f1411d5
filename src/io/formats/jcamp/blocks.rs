//! The records of a JCAMP-DX file, block by block.

use std::collections::HashMap;

use crate::io::error::quoted;
use crate::io::text::{lines, number};
use crate::io::{Input, ReadError, budget};
use crate::languages::{said, with_sign};

/// Most blocks of one file: each may become a spectrum.
const MOST_BLOCKS: usize = 10_000;

/// One block: its records by label, and its data.
#[derive(Debug, Default)]
pub(crate) struct Block<'a> {
    /// The line on which it starts.
    pub line: usize,
    records: HashMap<String, (usize, &'a str)>,
    data: Option<Data<'a>>,
}

/// A record with numbers.
#[derive(Debug)]
pub(crate) struct Data<'a> {
    /// The line of its label.
    pub line: usize,
    /// The text behind its line.
    text: &'a str,
    /// True if they are pairs.
    pub is_pairs: bool,
}

impl<'a> Data<'a> {
    /// The rows of numbers with their lines, comments removed.
    pub(crate) fn rows(&self) -> impl Iterator<Item = (usize, &'a str)> {
        let rows = lines(self.text).take_while(|(_, row)| label_of(row).is_none());
        let rows = rows.map(|(line, row)| (self.line + line, without_comment(row)));
        rows.filter(|(_, row)| !row.is_empty())
    }
}

/// A label and the text behind its equals sign: `## DATA TYPE = x` is `DATATYPE` and `x`.
pub(crate) fn label_of(line: &str) -> Option<(String, &str)> {
    let rest = line.trim_start().strip_prefix("##")?;
    let (label, value) = rest.split_once('=')?;
    let label = label
        .chars()
        .filter(|c| !matches!(c, ' ' | '-' | '/' | '_' | '\t'))
        .flat_map(char::to_uppercase)
        .collect();
    Some((label, value.trim()))
}

fn without_comment(line: &str) -> &str {
    line.split_once("$$")
        .map_or(line, |(before, _)| before)
        .trim()
}

/// The blocks of a file.
///
/// # Errors
/// [`ReadError`] when there are far too many records or blocks.
pub(crate) fn of<'a>(input: &Input, text: &'a str) -> Result<Vec<Block<'a>>, ReadError> {
    let mut blocks: Vec<Block> = Vec::new();
    let mut records = 0_usize;
    // A record takes about 200 bytes of book-keeping.
    let most_records = budget::of_text(text.len()) / 400;
    let mut rows = lines(text);
    while let Some((line, row)) = rows.next() {
        let Some((label, value)) = label_of(row) else {
            continue;
        };
        records += 1;
        if records > most_records || blocks.len() > MOST_BLOCKS {
            let found = said!("too many records or blocks");
            return Err(input.error_at(line, found, said!("at most 10000 blocks")));
        }
        if label == "TITLE" || blocks.is_empty() && !label.is_empty() {
            blocks.push(Block {
                line,
                ..Block::default()
            });
        }
        let Some(block) = blocks.last_mut().filter(|_| !label.is_empty()) else {
            continue;
        };
        let value = without_comment(value);
        let holds_data = matches!(&*label, "XYDATA" | "XYPOINTS" | "PEAKTABLE" | "DATATABLE");
        if holds_data && block.data.is_none() {
            block.data = Some(Data {
                line,
                text: rows.rest(),
                is_pairs: !value.contains("++"),
            });
        }
        block.records.entry(label).or_insert((line, value));
    }
    Ok(blocks)
}

impl<'a> Block<'a> {
    /// True if it only holds other blocks.
    pub(crate) fn is_link(&self) -> bool {
        let of_type = self
            .text("DATATYPE")
            .is_some_and(|t| t.eq_ignore_ascii_case("LINK"));
        of_type && self.data.is_none()
    }

    /// A record's text, unless it is empty.
    pub(crate) fn text(&self, label: &str) -> Option<&'a str> {
        let (_, text) = self.records.get(label)?;
        (!text.is_empty()).then_some(text)
    }

    /// The line of a record, or of the block.
    pub(crate) fn line_of(&self, label: &str) -> usize {
        self.records.get(label).map_or(self.line, |(line, _)| *line)
    }

    /// The numbers of the block, of at most `most_points` points.
    ///
    /// # Errors
    /// [`ReadError`] when there are none, or of a form that is no spectrum.
    pub(crate) fn curve<'b, 'i>(
        &'b self,
        input: &'b Input<'i>,
        most_points: usize,
    ) -> Result<Curve<'b, 'i>, ReadError> {
        let expected = said!("##XYDATA= or ##XYPOINTS=");
        let peaks = said!("a curve in ##XYDATA= or ##XYPOINTS=");
        for (label, found, expected) in [
            ("NTUPLES", said!("NTUPLES (several variables)"), expected),
            ("PEAKTABLE", said!("a table of peaks"), peaks),
        ] {
            if let Some((line, _)) = self.records.get(label) {
                return Err(input.error_at(*line, found, expected));
            }
        }
        let nothing = || input.error_at(self.line, said!("a block without data"), expected);
        let data = self.data.as_ref().ok_or_else(nothing)?;
        Ok(Curve {
            input,
            block: self,
            data,
            decimal_comma: self.has_decimal_comma(data),
            most_points,
        })
    }

    /// True if decimals are marked by commas: in a limit or an increment, or in a first row of
    /// pairs that is two numbers of one comma each.
    fn has_decimal_comma(&self, data: &Data) -> bool {
        // Factors are no evidence: SpectraSuite writes 1.0 over numbers with commas.
        const NUMBERS: [&str; 9] = [
            "FIRSTX", "LASTX", "FIRSTY", "LASTY", "DELTAX", "MAXX", "MINX", "MAXY", "MINY",
        ];
        let texts = || NUMBERS.iter().filter_map(|label| self.text(label));
        if texts().any(|text| number::number(text, false).is_some() && text.contains('.')) {
            return false;
        }
        let is_comma = |text: &str| text.contains(',') && number::number(text, true).is_some();
        let row = data.rows().next().map_or("", |(_, row)| row);
        let cells = || row.split([' ', '\t', ';']).filter(|c| !c.is_empty());
        texts().any(is_comma) || data.is_pairs && cells().count() == 2 && cells().all(is_comma)
    }
}

/// The numbers of a block, and the records that describe them.
pub(crate) struct Curve<'b, 'i> {
    pub input: &'b Input<'i>,
    block: &'b Block<'b>,
    pub data: &'b Data<'b>,
    pub decimal_comma: bool,
    most_points: usize,
}

impl Curve<'_, '_> {
    /// A record's number; `None` where it is missing.
    pub(crate) fn number(&self, label: &str) -> Result<Option<f64>, ReadError> {
        let Some(text) = self.block.text(label) else {
            return Ok(None);
        };
        let number = number::number(text, self.decimal_comma)
            .or_else(|| number::number(text, false))
            .filter(|x| x.is_finite());
        let line = self.block.line_of(label);
        let expected = || tr!("a number as ##{label}=", label);
        let refusal = || self.input.error_at(line, quoted(text), expected());
        number.map(Some).ok_or_else(refusal)
    }

    /// The factors of abscissas and ordinates.
    pub(crate) fn factors(&self) -> Result<(f64, f64), ReadError> {
        let factor = |label| Ok(self.number(label)?.unwrap_or(1.0));
        Ok((factor("XFACTOR")?, factor("YFACTOR")?))
    }

    /// Notes a record that differs from the data by more than a relative and an absolute tolerance.
    pub(crate) fn compare(
        &self,
        label: &str,
        found: Option<&f64>,
        (share, rest): (f64, f64),
        notes: &mut Vec<String>,
    ) -> Result<(), ReadError> {
        if let (Some(stated), Some(found)) = (self.number(label)?, found)
            && (stated - found).abs() > share * stated.abs().max(found.abs()) + rest
        {
            notes.push(tr!(
                "{label} says {stated}, found {found}",
                label,
                stated = with_sign(stated.to_string()),
                found = with_sign(found.to_string())
            ));
        }
        Ok(())
    }

    /// Refuses one point more than a file of its size may unfold to.
    pub(crate) fn check_room(&self, points: usize, line: usize) -> Result<(), ReadError> {
        if points < self.most_points {
            return Ok(());
        }
        let found = said!("far more points than the file has text");
        Err(self.input.error_at(line, found, said(budget::TEXT_WORDS)))
    }
}
