//! Rows that stand above a block because one among the first of a table is short, or has a cell too
//! many: before a table has shown its width such a row breaks it off.

use super::block::{Block, Row, carries_on};
use crate::io::text::dialect::Dialect;
use crate::io::text::number::Cell;
use crate::io::text::{is_no_comment, place_in};

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
        let row = Row::of(line, content, dialect);
        let nm = match row.kinds.first() {
            Some(Cell::Number(nm) | Cell::Nanometres(nm)) if carries_on(before, last, *nm) => *nm,
            _ => break,
        };
        // A word in a row is a fault of the table, and told as that.
        let used = row.used();
        if used <= block.width && row.has_words() {
            break;
        }
        (before, last) = (last, nm);
        rows.push((row, content));
        if used == block.width {
            whole = rows.len();
        }
    }
    rows.truncate(whole);
    rows.reverse();
    let is_row = |row: &Row| row.used() <= block.width;
    let taken = rows.iter().filter(|(row, _)| is_row(row)).count();
    let Some((first, content)) = rows.first().filter(|_| 2 * taken >= rows.len()) else {
        return (block, Vec::new());
    };
    let header = header.take_while(|(line, _)| *line < first.line).collect();
    let from = &text[place_in(text, content)..];
    let mut table = Block::new(header, block.width, (first.line, from));
    let mut left = Vec::new();
    for (row, content) in &rows {
        if is_row(row) {
            table.push(row);
        } else {
            left.push((row.line, *content));
        }
    }
    table.append(block);
    (table, left)
}
