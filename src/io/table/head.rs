//! Rows that stand above a block because one among the first of a table is short, or has a cell too
//! many: before a table has shown its width such a row breaks it off.

use super::block::{Block, carries_on, is_no_comment, place_in};
use crate::io::text::dialect::{Dialect, used};
use crate::io::text::number::Cell;

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
    let (mut before, mut last) = (block.first(1), block.first(0));
    // From the lowest line up, and how many of them reach up to a whole row.
    let (mut rows, mut whole) = (Vec::new(), 0);
    let header = block.header.iter().copied();
    let lines = header.clone().rev();
    let lines = lines.filter(|line| is_no_comment(text, line.1));
    for (line, content) in lines.take(MOST_LINES) {
        let (cells, kinds) = dialect.cells_and_kinds(content);
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
        let is_row = used <= block.width;
        rows.push(((line, content), is_row, cells, kinds));
        if used == block.width {
            whole = rows.len();
        }
    }
    rows.truncate(whole);
    rows.reverse();
    let taken = rows.iter().filter(|(_, is_row, ..)| *is_row).count();
    let Some(((first_line, first_row), ..)) = rows.first().filter(|_| 2 * taken >= rows.len())
    else {
        return (block, Vec::new());
    };
    let header = header.take_while(|(line, _)| line < first_line).collect();
    let from = &text[place_in(text, first_row)..];
    let mut table = Block::new(header, block.width, (*first_line, from));
    let mut left = Vec::new();
    for (line, is_row, cells, kinds) in &rows {
        if *is_row {
            table.push(line.0, cells, kinds);
        } else {
            left.push(*line);
        }
    }
    table.append(block);
    (table, left)
}
