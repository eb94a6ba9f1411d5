//! Chooses the dialect of a text table and finds its tables.

use super::block::{Block, LONGEST_BREAK, NoTable, most_left_out};
use super::head::with_rows_above;
use super::layout::{self, Layout};
use super::row_order::{may_be_wavelengths, runs_one_way, steps_up_and_down};
use super::scan::{scan, scan_start};
use super::titles::Titles;
use crate::io::text::dialect::{Delimiter, Dialect};
use crate::io::text::first_line;
use crate::io::text::units::names_wavelength;
use crate::languages::with_sign;

/// The amount of text that decides the dialect, in bytes: many times the longest header.
const SAMPLE_BYTES: usize = 256 * 1024;

/// The amount examined when the first sample holds no table, in bytes and in lines. If that holds
/// none either, there is none: every dialect scans all of it.
const LONG_SAMPLE_BYTES: usize = 16 * 1024 * 1024;
const LONG_SAMPLE_LINES: usize = 250_000;

/// A block that holds much fewer rows than the longest may be part of a header or footer: it must
/// say clearly that it holds wavelengths.
const SHORTEST_SHARE: usize = 8;

/// Fewest rows of such a short block that make a table.
const FEWEST_SHORT_ROWS: usize = 3;

#[derive(Clone, Debug)]
pub(crate) struct Table<'a> {
    pub block: Block<'a>,
    pub titles: Titles,
    pub layout: Layout,
    /// True if it is far shorter than the longest: possibly no table, and irrelevant to the others.
    pub is_short: bool,
}

/// The dialect of a text with a table, and the part examined that holds no wavelengths; all of the
/// text where some were found.
pub(crate) type Look<'a> = (Dialect, &'a str);

/// All tables of a text. Where a look at its first part saw none, its rest is not gone over.
pub(crate) fn tables_of<'a>(
    text: &'a str,
    (dialect, seen): Look<'a>,
) -> Result<Vec<Table<'a>>, NoTable> {
    let found = tables(seen, dialect);
    if found.is_ok() && seen.len() < text.len() {
        return tables(text, dialect);
    }
    found
}

/// The dialect under which a text has most numbers in tables with wavelengths.
///
/// Words among the numbers count against a dialect: `380,5 0,3` has two numbers and a word with
/// commas between cells, and two numbers and no word with decimal commas and blanks.
///
/// A delimiter that a person chose is the only one that is tried.
pub(crate) fn look(text: &str, chosen: Option<Delimiter>) -> Look<'_> {
    let sample = sample(text);
    let (found, dialect) = best_of(sample, chosen);
    if found || sample.len() == text.len() {
        return (dialect, text);
    }
    let start = start(text);
    let (found, dialect) = best_of(start, chosen);
    (dialect, if found { text } else { start })
}

/// As much of a text as tells how it is written.
pub(crate) fn sample(text: &str) -> &str {
    first_lines(text, (SAMPLE_BYTES, usize::MAX))
}

/// As much of a text as is looked at for a table, and for what to say where there is none.
pub(crate) fn start(text: &str) -> &str {
    first_lines(text, (LONG_SAMPLE_BYTES, LONG_SAMPLE_LINES))
}

/// True if a text has a table with wavelengths under any dialect, and the best dialect. If there
/// are no rows at all, the dialect under which they are too many is the most informative.
fn best_of(sample: &str, chosen: Option<Delimiter>) -> (bool, Dialect) {
    // Only quotes let one mark part cells and decimals.
    let has_quotes = memchr::memchr(b'"', sample.as_bytes()).is_some();
    let may_be = |dialect: &Dialect| {
        chosen.is_none_or(|chosen| dialect.delimiter == chosen)
            && (has_quotes || dialect.delimiter != Delimiter::Comma || !dialect.decimal_comma)
    };
    let mut dialects = Dialect::ALL.into_iter().filter(may_be).peekable();
    let first = dialects.peek().copied().unwrap_or(Dialect::ALL[0]);
    let mut best = ((0, 0), first);
    let mut too_much = None;
    for dialect in dialects {
        match scan_start(sample, dialect).map(|blocks| score(&blocks, dialect)) {
            Ok(score) if score > best.0 => best = (score, dialect),
            Ok(_) => {}
            Err(_) => too_much = too_much.or(Some(dialect)),
        }
    }
    match best {
        ((0, 0), none) => (false, too_much.unwrap_or(none)),
        ((with_wavelengths, _), dialect) => (with_wavelengths > 0, dialect),
    }
}

/// The first lines of a text, up to the end of the one where so many bytes or lines are reached.
fn first_lines(text: &str, (bytes, lines): (usize, usize)) -> &str {
    let mut rest = text;
    let mut count = 0;
    while count < lines && text.len() - rest.len() <= bytes {
        let Some((_, after)) = first_line(rest) else {
            break;
        };
        rest = after;
        count += 1;
    }
    &text[..text.len() - rest.len()]
}

/// Numbers in tables with wavelengths, then numbers in any table, less the words among them.
fn score(blocks: &[Block], dialect: Dialect) -> (usize, usize) {
    let mut score = (0, 0);
    for block in blocks {
        // Words among numbers are worse than a column of names beside them.
        let (mut gained, mut lost) = (0, 0);
        for column in &block.columns {
            gained += 4 * column.numbers;
            lost += column.texts * if column.numbers == 0 { 3 } else { 8 };
        }
        let worth: usize = gained.saturating_sub(lost);
        score.1 += worth;
        if layout::of(block, &Titles::of(block, dialect), dialect).is_some() {
            score.0 += worth;
        }
    }
    score
}

pub(crate) fn tables(text: &str, dialect: Dialect) -> Result<Vec<Table<'_>>, NoTable> {
    let blocks = scan(text, 0, dialect)?;
    // Of equally long ones the first.
    let Some(block) = blocks.iter().rev().max_by_key(|block| block.rows()) else {
        return Err(NoTable::NoRows);
    };
    let (longest, no_wavelengths) = (block.rows(), no_wavelengths(block));
    let mut tables: Vec<Table> = Vec::new();
    let (mut left_out, mut above) = (Vec::new(), Vec::new());
    for mut block in joined(blocks, text, dialect)? {
        if !above.is_empty() {
            let own = std::mem::replace(&mut block.header, std::mem::take(&mut above));
            block.header.extend(own);
        }
        if begins_with_titles(&block, dialect) {
            block.head_first_row();
        }
        let keyed = Titles::of_keys(&mut block, dialect);
        let titles = keyed.unwrap_or_else(|| Titles::of(&block, dialect));
        let is_short = block.rows() * SHORTEST_SHARE < longest;
        let may_be = !is_short || block.rows() >= FEWEST_SHORT_ROWS;
        let layout = may_be.then(|| layout::of(&block, &titles, dialect));
        match layout.flatten() {
            Some((layout, strength)) if !is_short || strength >= layout::CLEAR => {
                tables.push(Table {
                    block,
                    titles,
                    layout,
                    is_short,
                })
            }
            _ => {
                left_out.push(lines_left_out(&block));
                // Times or angles over the columns: what stands above them is the next block's
                // header.
                if is_short {
                    above = block.header;
                }
            }
        }
    }
    // A few rows beside a long block that is no table are none either.
    let Some(first) = tables.iter_mut().find(|table| !table.is_short) else {
        return Err(no_wavelengths);
    };
    first.block.notes.extend(left_out);
    Ok(tables)
}

/// True if the first row holds numbers as titles ("Wavelength, 1, 2, 3") above a column of
/// wavelengths. Where they look like wavelengths themselves, and outnumber the rows, the table lies
/// along its rows.
fn begins_with_titles(block: &Block, dialect: Dialect) -> bool {
    let column = block.column(0);
    if block.rows() < 3 || !column[0].is_nan() {
        return false;
    }
    let cells = dialect.cells(block.first_row());
    let first = cells.first().map(|cell| cell.trim_matches(['"', ' ']));
    first.is_none_or(|first| first.is_empty() || names_wavelength(first))
        && may_be_wavelengths(&column[1..])
        && !(block.width > block.rows() && may_be_wavelengths(&block.row(0)[1..]))
}

/// The note on a block that is not read.
pub(crate) fn lines_left_out(block: &Block) -> String {
    let (first, last) = (block.lines[0], block.lines[block.rows() - 1]);
    tr!("lines {first} to {last} left out", first, last)
}

/// The blocks of a text that is known to be one table behind a number of lines of its file.
pub(crate) fn blocks_behind(
    text: &str,
    lines: usize,
    dialect: Dialect,
) -> Result<Vec<Block<'_>>, NoTable> {
    let blocks = joined(scan(text, lines, dialect)?, text, dialect)?;
    (!blocks.is_empty())
        .then_some(blocks)
        .ok_or(NoTable::NoRows)
}

/// The reason why the first column of a block is not wavelengths: a number not above zero in a
/// monotonic column, or the first step against the prevailing direction where all are in range.
fn no_wavelengths(block: &Block) -> NoTable {
    let axis = block.column(0);
    let why = |row: usize, found, expected: &str| NoTable::At {
        line: block.lines[row] as usize,
        found,
        expected: expected.to_owned(),
    };
    let below = axis.iter().position(|x| *x <= 0.0);
    if let Some(at) = below.filter(|_| runs_one_way(axis) && !block.counts_rows(0)) {
        let found = tr!(
            "{number} in column 1",
            number = with_sign(axis[at].to_string())
        );
        return why(at, found, said!("wavelengths above zero"));
    }
    let (up, down) = steps_up_and_down(axis);
    let is_back = |p: &[f64]| if up >= down { p[1] < p[0] } else { p[1] > p[0] };
    let are_right = || axis.iter().all(|v| (100.0..=20_000.0).contains(v));
    if let Some(at) = axis.windows(2).position(is_back).filter(|_| are_right()) {
        let found = tr!(
            "{number} after {before} in column 1",
            number = with_sign(axis[at + 1].to_string()),
            before = with_sign(axis[at].to_string())
        );
        let expected = said!("wavelengths that rise or fall throughout");
        return why(at + 1, found, expected);
    }
    let found = said!("numbers with no wavelengths among them").to_owned();
    let expected = said!("a column or row of wavelengths that rises or falls throughout");
    why(0, found, expected)
}

/// Joins blocks that one table was broken into by a page head or a stray line. Of a table whose
/// other rows agree a row with a word is left out.
fn joined<'a>(
    blocks: Vec<Block<'a>>,
    text: &'a str,
    dialect: Dialect,
) -> Result<Vec<Block<'a>>, NoTable> {
    let mut out: Vec<Block> = Vec::new();
    for mut block in blocks {
        let above = block.gone_wrong_above(text, dialect);
        let before = out.last_mut();
        let Some(last) = before.filter(|last| goes_on(last, &block, dialect)) else {
            let (mut block, left) = with_rows_above(block, text, dialect);
            block.lost.extend(above.filter(|_| left.is_empty()));
            let notes = left.iter().flat_map(|line| no_rows(&[*line], &[0]));
            block.notes.extend(notes);
            out.push(block);
            continue;
        };
        let between = last.ended_by.take().or(above);
        let lines = std::mem::take(&mut block.header);
        let left = last.take_lines(&lines, (text, dialect));
        match between {
            Some(row) if lines.len() == 1 => last.lost.push(row),
            Some(row) if left.words.is_empty() || left.all.len() > left.words.len() => {
                return Err(NoTable::Bad(row));
            }
            Some(_) => last.lost.extend(left.words),
            None if lines.is_empty() => {
                last.notes
                    .push(said!("the table is interrupted once").to_owned());
            }
            None => last.notes.extend(no_rows(&lines, &left.all)),
        }
        last.append(block);
    }
    for block in &mut out {
        let behind = std::mem::take(&mut block.behind);
        let left = block.take_lines(&behind, (text, dialect));
        block.notes.extend(no_rows(&behind, &left.numbers));
        // A word in the very last row, with nothing behind it that would tell.
        let last = block.ended_by.take().filter(|row| row.certain);
        block.lost.extend(last);
        if block.lost.len() > most_left_out(block.rows()) {
            return Err(NoTable::Bad(block.lost.swap_remove(0)));
        }
        let lost = block.lost.iter().map(|row| row.left_out("row"));
        block.notes.extend(lost);
    }
    Ok(out)
}

/// The notes on the lines at these places, which are not rows: a sentence for each run of them.
fn no_rows(lines: &[(usize, &str)], places: &[usize]) -> Vec<String> {
    let runs = places.chunk_by(|a, b| a + 1 == *b);
    let notes = runs.map(|run| {
        let (first, last) = (lines[run[0]].0, lines[run[run.len() - 1]].0);
        match first == last {
            true => tr!(
                "line {first} is no row of the table and was left out",
                first
            ),
            false => tr!(
                "lines {first} to {last} are no rows of the table and were left out",
                first,
                last
            ),
        }
    });
    notes.collect()
}

/// True if `next` continues `block`: as wide, close behind, without other titles, and with a first
/// column that carries on.
fn goes_on(block: &Block, next: &Block, dialect: Dialect) -> bool {
    let has_titles = |(_, line): &(usize, &str)| {
        let cells = dialect.cells(line);
        let is_new = !block.header.iter().any(|(_, own)| own == line);
        is_new && cells.len() > 1 && names_wavelength(cells[0])
    };
    block.width == next.width
        && next.header.len() <= LONGEST_BREAK
        && !next.header.last().is_some_and(has_titles)
        && block.goes_on_with(next.first(0))
}
