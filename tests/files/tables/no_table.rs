//! Refusals of texts that hold no table, each with the line at fault.

use spectral_explorer::io::{ReadError, read_bytes};

fn refusal(text: &str) -> ReadError {
    read_bytes("a.csv", text.as_bytes()).unwrap_err()
}

#[test]
fn more_columns_than_are_read_are_refused_with_their_number_and_the_limit() {
    for mark in [",", ";", "\t"] {
        let row = |first: &str, cell: &str| {
            format!("{first}{}\n", (mark.to_owned() + cell).repeat(70_000))
        };
        let rows = row("380", "1") + &row("390", "2");
        for text in [
            rows.clone(),
            row("nm", "a") + &rows,
            "x".to_owned() + &mark.repeat(70_000),
        ] {
            let said = refusal(&text).to_string();
            let expected = "found 70001 columns, expected at most 65536 columns";
            assert_eq!(said, format!("a.csv, line 1: {expected}"));
        }
    }
    let blanks = "1 ".repeat(70_000);
    assert_eq!(refusal(&blanks).found, "70000 columns");
}

#[test]
fn words_with_blanks_between_them_are_no_columns_however_many() {
    let words = "lorem ".repeat(70_000) + "\n";
    assert!(refusal(&words).found.starts_with("no table after"));
    let table = words + "380 1\n390 2\n400 3\n";
    assert!(read_bytes("a.txt", table.as_bytes()).is_ok());
}

#[test]
fn a_long_text_is_looked_at_in_part_and_the_refusal_says_so() {
    for (line, found) in [
        ("a1", "no table in 732 KiB after \"a1\""),
        (" ", "488 KiB of blank lines"),
        ("0.5", "more than 250000 lines of one number each"),
    ] {
        let text = format!("{line}\n").repeat(300_000);
        assert_eq!(refusal(&text).found, found);
    }
}

#[test]
fn a_row_alone_and_wavelengths_below_zero_are_refused_as_that() {
    let expected = "found one row of numbers, expected two rows at least";
    for text in ["500,1\n", "nm W\n500 1\nend\n"] {
        let said = refusal(text).to_string();
        assert!(said.ends_with(expected), "{said}");
    }
    let two = refusal("500,1\n505,1,2\n").found;
    assert!(two.starts_with("rows of numbers"), "{two}");
    let rows: String = (0..20).map(|i| format!("{},1.5\n", 5 * i - 5)).collect();
    let expected = "a.csv, line 1: found -5 in column 1, expected wavelengths above zero";
    assert_eq!(refusal(&rows).to_string(), expected);
}

#[test]
fn a_table_behind_a_long_header_is_read_whole() {
    let header = "some words and the number 12\n".repeat(200_000);
    let rows: String = (0..60_000)
        .map(|i| format!("{},1\n", 300.0 + 0.01 * f64::from(i)))
        .collect();
    let reading = read_bytes("a.csv", (header + &rows).as_bytes()).unwrap();
    assert_eq!(reading.spectra[0].samples.len(), 60_000);
}

#[test]
fn countless_tables_of_a_few_rows_are_refused_by_their_number() {
    let text = "380 1\n390 2\n400 3\nx\n".repeat(30_000);
    let said = refusal(&text).to_string();
    assert!(said.contains("tables of a few rows each"), "{said}");
}
