//! CSV as this program writes it: comments with keys, a line of titles, one row a wavelength.
//!
//! Names of spectra may look like anything (numbers, units, spreads), so nothing in the titles is
//! examined: every column behind the wavelengths is a spectrum, and the keys describe it.

use super::{Confidence, Format, columns};
use crate::io::interpret::{Heading, RawSpectrum, Scale, check_room, interpret};
use crate::io::provenance::MEASURED;
use crate::io::reading::TableFound;
use crate::io::table::block::Block;
use crate::io::table::read::without_words;
use crate::io::table::{no_table, pick, row_order};
use crate::io::text::dialect::{Delimiter, Dialect, MOST_COLUMNS};
use crate::io::text::lines;
use crate::io::write::csv::{FIRST_TITLE, as_it_was};
use crate::io::{Input, ReadError, Reading};

pub(crate) const FORMAT: Format = Format::new("Spectral Explorer CSV", &["csv"], sniff, read);

/// More comments than the program writes.
const MOST_COMMENTS: usize = 50;

/// The separator of its cells.
const DIALECT: Dialect = Dialect::new(Delimiter::Comma, false);

fn sniff(input: &Input) -> Confidence {
    match input.text().and_then(|text| Own::of(&text.text)) {
        Some(_) => Confidence::Own,
        None => Confidence::No,
    }
}

/// A text that this program wrote, taken apart.
struct Own<'a> {
    /// The comments with their lines, marks removed.
    header: Vec<(usize, &'a str)>,
    titles: Vec<&'a str>,
    rows: &'a str,
}

impl<'a> Own<'a> {
    /// Takes a text apart; `None` where it does not start as an own file.
    fn of(text: &'a str) -> Option<Self> {
        let mut header = Vec::new();
        let mut all = lines(text);
        let titles = loop {
            let (number, line) = all.next()?;
            match line.strip_prefix("# ") {
                Some(comment) => header.push((number, comment)),
                None => break line,
            }
            if header.len() > MOST_COMMENTS {
                return None;
            }
        };
        let others = titles.strip_prefix(FIRST_TITLE)?;
        let titles = DIALECT.cells(titles);
        let is_own = !header.is_empty() && others.starts_with(',') && titles.len() <= MOST_COLUMNS;
        is_own.then_some(Self {
            header,
            titles,
            rows: all.rest(),
        })
    }

    /// The name of a column's spectrum; the header's name for the measured one.
    fn name(&self, column: usize) -> Option<&'a str> {
        let title = as_it_was(self.titles.get(column)?);
        (title != MEASURED || self.titles.len() > 2).then_some(title)
    }
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_long_text()?.text;
    let choices = &input.choices;
    let is_chosen = choices.dialect.is_some() || choices.delimiter.is_some();
    let Some(own) = Own::of(text).filter(|_| !is_chosen) else {
        // With a chosen separator the table is read as plain columns.
        return (columns::FORMAT.read)(input);
    };
    let lines_before = own.header.len() + 1;
    let blocks = pick::blocks_behind(own.rows, lines_before, DIALECT)
        .map_err(|why| no_table::refusal(input, text, why))?;
    check_room(input, blocks.len())?;
    let mut reading = Reading::default();
    for mut block in blocks {
        reading.notes.append(&mut block.notes);
        read_block(input, &own, block, &mut reading)?;
    }
    if reading.spectra.is_empty() {
        return Err(no_table::too_sparse(input, "column", lines_before + 1));
    }
    reading.notes.push(DIALECT.words());
    Ok(reading)
}

/// Adds a spectrum for each column beside the wavelengths.
fn read_block(
    input: &Input,
    own: &Own,
    mut block: Block,
    reading: &mut Reading,
) -> Result<(), ReadError> {
    let axis_column = input.choices.axis_column.unwrap_or(0);
    if axis_column >= block.width {
        return Err(no_table::no_such_column(input, block.width, axis_column));
    }
    let columns: Vec<usize> = (0..block.width).filter(|c| *c != axis_column).collect();
    let words = without_words(input, &block, |_| true, true)?;
    let order = row_order::put_right(input, &mut block, axis_column, &columns)?;
    reading.notes.extend(words.into_iter().chain(order));
    reading.table.get_or_insert_with(|| TableFound {
        dialect: DIALECT,
        axis_column: Some(axis_column),
        width: block.width,
        first_line: block.lines[0] as usize,
        values: columns.clone(),
    });
    let heading = Heading::own(&own.header).shared_by(columns.len());
    let axis = std::mem::take(&mut block.values[axis_column]);
    let scale = Scale::new(&axis);
    check_room(input, reading.spectra.len() + columns.len())?;
    for column in &columns {
        let values = std::mem::take(&mut block.values[*column]);
        if columns.len() > 1 && values.iter().filter(|v| !v.is_nan()).nth(1).is_none() {
            reading.notes.push(no_table::empty_column(*column));
            continue;
        }
        let name = own.name(*column).or(heading.name).unwrap_or(input.stem());
        let raw = RawSpectrum {
            lines: &block.lines,
            percent_signs: block.columns[*column].percents > 0,
            ..RawSpectrum::written(name, &scale, FIRST_TITLE, values, &heading)
        };
        interpret(raw, input, reading)?;
    }
    Ok(())
}
