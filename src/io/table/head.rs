//! Rows that stand above a block because one among the first of a table is short, or has a cell too
//! many: before a table has shown its width such a row breaks it off.

use super::block::{Block, carries_on, is_no_comment, place_in};
use crate::io::text::dialect::{Dialect, used};
use crate::io::text::number::{self, Cell};

/// Most lines above a block that are looked at.
const MOST_LINES: usize = 40;

/// The block with the rows of its header, and those lines among them that are none. The rows are
/// the lines just above whose first cell carries on the block's first column upwards, from a row
/// of the block's width on.
pub(crate) fn with_rows_above<'a>(
    block: Block<'a>,
    text: &'a str,
    dialect: Dialect,
) -> (Block<'a>, Vec<(usize, &'a str)>) {
    let mut cells = Vec::new();
    let parse = |cell: &&str| number::parse(cell, dialect.decimal_comma);
    let (mut before, mut last) = (block.first(1), block.first(0));
    // From the lowest up: whether each line is a row, and how many reach up to a whole one.
    let (mut rows, mut whole) = (Vec::new(), 0);
    let header = block.header.iter().copied();
    let lines: Vec<_> = header.filter(|line| is_no_comment(text, line.1)).collect();
    for (_, content) in lines.iter().rev().take(MOST_LINES) {
        dialect.split(content, &mut cells);
        let kinds: Vec<Cell> = cells.iter().map(parse).collect();
        let nm = match kinds.first() {
            Some(Cell::Number(nm) | Cell::Nanometres(nm)) if carries_on(before, last, *nm) => *nm,
            _ => break,
        };
        let used = used(&cells);
        // A word in a row is a fault of the table, and told as that.
        if used <= block.width && kinds.contains(&Cell::Text) {
            break;
        }
        (before, last) = (last, nm);
        rows.push(used <= block.width);
        if used == block.width {
            whole = rows.len();
        }
    }
    rows.truncate(whole);
    let taken = rows.iter().filter(|is_row| **is_row).count();
    if 2 * taken < rows.len() || rows.is_empty() {
        return (block, Vec::new());
    }
    let lines = &lines[lines.len() - rows.len()..];
    let (first_line, first_row) = lines[0];
    let header = block.header.iter().copied();
    let header = header.take_while(|(line, _)| *line < first_line).collect();
    let from = &text[place_in(text, first_row)..];
    let mut table = Block::new(header, block.width, (first_line, from));
    let mut left = Vec::new();
    for ((line, content), is_row) in lines.iter().zip(rows.into_iter().rev()) {
        if !is_row {
            left.push((*line, *content));
            continue;
        }
        dialect.split(content, &mut cells);
        let kinds: Vec<Cell> = cells.iter().map(parse).collect();
        table.push(*line, &cells, &kinds);
    }
    table.append(block);
    (table, left)
}
