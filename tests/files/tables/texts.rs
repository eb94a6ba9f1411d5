//! Bytes as text: line ends, marks of the byte order, and what is no text.

use spectral_explorer::io::{
    Delimiter, Dialect, MOST_COLUMNS, decode_text as decode, is_binary, text_lines as lines, used,
};

#[test]
fn every_line_end_counts_as_one() {
    let found: Vec<_> = lines("a\nb\r\nc\rd\n\ne").collect();
    assert_eq!(
        found,
        [(1, "a"), (2, "b"), (3, "c"), (4, "d"), (5, ""), (6, "e")]
    );
    assert_eq!(lines("").count(), 0);
    assert_eq!(lines("a\n").count(), 1);
}

#[test]
fn a_byte_order_mark_is_obeyed_and_removed() {
    assert_eq!(decode(b"\xef\xbb\xbf380").text, "380");
    let pairs = || "\u{feff}38µ".encode_utf16();
    let little: Vec<u8> = pairs().flat_map(u16::to_le_bytes).collect();
    let read = decode(&little);
    assert_eq!((read.text.as_ref(), read.encoding), ("38µ", "UTF-16LE"));
    let big: Vec<u8> = pairs().flat_map(u16::to_be_bytes).collect();
    assert_eq!(decode(&big).text, "38µ");
}

#[test]
fn latin_1_headers_are_read_and_said() {
    let read = decode(b"N\xfamero [\xb5W]\n1 2");
    assert_eq!(read.text, "Número [µW]\n1 2");
    assert_eq!(read.notes(), ["text read as windows-1252"]);
}

#[test]
fn nul_bytes_are_dropped_and_said() {
    let read = decode(b"head\0\0er\n380 1");
    assert_eq!(read.text, "header\n380 1");
    assert_eq!(read.notes(), ["2 NUL bytes dropped from the text"]);
}

#[test]
fn numbers_as_bytes_are_not_text() {
    let floats: Vec<u8> = (0..500)
        .flat_map(|i| (0.1f64 + f64::from(i).sin()).to_le_bytes())
        .collect();
    assert!(is_binary(&floats));
    assert!(!is_binary(b"wavelength;value\r\n380;0,5\r\n"));
    assert!(!is_binary(b""));
}

fn dialect(delimiter: Delimiter, decimal_comma: bool) -> Dialect {
    Dialect {
        delimiter,
        decimal_comma,
    }
}

fn cells(dialect: Dialect, line: &str) -> Vec<&str> {
    let mut cells = Vec::new();
    dialect.split(line, &mut cells);
    cells
}

#[test]
fn a_line_of_marks_has_one_cell_more_than_a_table_may_and_all_are_counted() {
    for (marks, delimiter, count) in [
        (",", Delimiter::Comma, 200_001),
        ("\"\";", Delimiter::Semicolon, 200_001),
        ("1 ", Delimiter::Space, 200_000),
    ] {
        let line = marks.repeat(200_000);
        let dialect = dialect(delimiter, false);
        assert_eq!(cells(dialect, &line).len(), MOST_COLUMNS + 1);
        assert_eq!(dialect.count(&line), count);
    }
}

#[test]
fn delimiters_part_cells_but_not_in_quotes_and_a_list_stands_behind_its_key() {
    let quoted = dialect(Delimiter::Comma, true);
    let comma = dialect(Delimiter::Comma, false);
    let space = dialect(Delimiter::Space, false);
    for (dialect, line, parts) in [
        (quoted, "\"380,5\", \"0,25\" ,", "380,5|0,25|"),
        (comma, "nm: [1, 2, 3, 4, 5]", "nm|1|2|3|4|5"),
        (space, "x = [1 2 3 4 5];", "x|1|2|3|4|5"),
        (comma, "Limits: [380, 780]", "Limits: [380|780]"),
        (comma, "Wave [nm], a b c [W/m2]", "Wave [nm]|a b c [W/m2]"),
        (space, "  380 \t 0.5  ", "380|0.5"),
    ] {
        assert_eq!(cells(dialect, line).join("|"), parts);
    }
    assert_eq!(used(&["380,5", "0,25", ""]), 2);
}

#[test]
fn blanks_that_break_no_line_part_cells_but_no_thousands() {
    let space = dialect(Delimiter::Space, true);
    let found = cells(space, "380\u{a0}0,5 1\u{a0}630,3");
    assert_eq!(found, ["380", "0,5", "1\u{a0}630,3"]);
    assert!(space.parts("380\u{a0}0.5"));
}
