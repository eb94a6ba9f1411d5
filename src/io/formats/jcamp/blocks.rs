//! The records of a JCAMP-DX file, block by block.

use std::collections::HashMap;

use crate::io::error::quoted;
use crate::io::text::{lines, number};
use crate::io::{Input, ReadError, budget};

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
    /// The lines behind it, up to the next label.
    text: &'a str,
    /// Whether they are pairs.
    pub is_pairs: bool,
}

impl<'a> Data<'a> {
    /// The rows of numbers with their lines, comments removed.
    pub(crate) fn rows(&self) -> impl Iterator<Item = (usize, &'a str)> {
        let rows = lines(self.text).map(|(line, row)| (self.line + line, without_comment(row)));
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
    // Whether the last block's data go on to here.
    let mut in_data = false;
    let mut records = 0_usize;
    // A record takes about 200 bytes of book-keeping.
    let most_records = budget::of_text(text.len()) / 400;
    let mut rows = lines(text);
    loop {
        let before = rows.rest();
        let Some((line, row)) = rows.next() else {
            break;
        };
        if let Some((label, value)) = label_of(row) {
            if let Some(data) = blocks.last_mut().and_then(|block| block.data.as_mut())
                && std::mem::take(&mut in_data)
            {
                data.text = &data.text[..data.text.len() - before.len()];
            }
            records += 1;
            if records > most_records || blocks.len() > MOST_BLOCKS {
                return Err(input
                    .error("too many records or blocks", "at most 10000 blocks")
                    .at_line(line));
            }
            if label.is_empty() {
                continue;
            }
            if label == "TITLE" || blocks.is_empty() {
                blocks.push(Block {
                    line,
                    ..Block::default()
                });
            }
            let Some(block) = blocks.last_mut() else {
                continue;
            };
            let value = without_comment(value);
            let holds_data = matches!(&*label, "XYDATA" | "XYPOINTS" | "PEAKTABLE" | "DATATABLE");
            if holds_data && block.data.is_none() {
                in_data = true;
                block.data = Some(Data {
                    line,
                    text: rows.rest(),
                    is_pairs: !value.contains("++"),
                });
            }
            block.records.entry(label).or_insert((line, value));
        }
    }
    Ok(blocks)
}

impl<'a> Block<'a> {
    /// Whether it only holds other blocks.
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

    /// A record's number; `None` where it is missing.
    pub(crate) fn number(
        &self,
        input: &Input,
        label: &str,
        decimal_comma: bool,
    ) -> Result<Option<f64>, ReadError> {
        let Some(text) = self.text(label) else {
            return Ok(None);
        };
        let number = number::number(text, decimal_comma)
            .or_else(|| number::number(text, false))
            .filter(|x| x.is_finite());
        let refusal = || input.error(quoted(text), format!("a number as ##{label}="));
        number
            .map(Some)
            .ok_or_else(|| refusal().at_line(self.line_of(label)))
    }

    /// The record with the block's numbers.
    ///
    /// # Errors
    /// [`ReadError`] when there is none, or one of a form that is no spectrum.
    pub(crate) fn data(&self, input: &Input) -> Result<&Data<'a>, ReadError> {
        const EXPECTED: &str = "##XYDATA= or ##XYPOINTS=";
        let peaks = "a curve in ##XYDATA= or ##XYPOINTS=";
        for (label, found, expected) in [
            ("NTUPLES", "NTUPLES (several variables)", EXPECTED),
            ("PEAKTABLE", "a table of peaks", peaks),
        ] {
            if let Some((line, _)) = self.records.get(label) {
                return Err(input.error(found, expected).at_line(*line));
            }
        }
        let nothing = || input.error("a block without data", EXPECTED);
        self.data
            .as_ref()
            .ok_or_else(|| nothing().at_line(self.line))
    }

    /// Whether numbers mark their decimals by commas: a limit or a factor does, or the first row
    /// of pairs is two numbers of one comma each.
    pub(crate) fn has_decimal_comma(&self, data: &Data) -> bool {
        // Factors do not tell: SpectraSuite writes 1.0 over numbers with commas.
        const NUMBERS: [&str; 9] = [
            "FIRSTX", "LASTX", "FIRSTY", "LASTY", "DELTAX", "MAXX", "MINX", "MAXY", "MINY",
        ];
        let texts = || NUMBERS.iter().filter_map(|label| self.text(label));
        if texts().any(|text| number::number(text, false).is_some() && text.contains('.')) {
            return false;
        }
        let is_comma = |text: &str| text.contains(',') && number::number(text, true).is_some();
        if texts().any(is_comma) {
            return true;
        }
        let Some((_, row)) = data.rows().next() else {
            return false;
        };
        let cells: Vec<&str> = row
            .split([' ', '\t', ';'])
            .filter(|c| !c.is_empty())
            .collect();
        data.is_pairs && cells.len() == 2 && cells.iter().all(|cell| is_comma(cell))
    }
}
