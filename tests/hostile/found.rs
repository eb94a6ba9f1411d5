//! What the fuzzer found, reduced by hand: one file for each promise that was broken.

use spectral_explorer::io::read_bytes;

use super::harness::attack;

/// The refusal of a file that keeps the harness's promises.
fn refusal(format: &str, name: &str, file: &str) -> String {
    attack(format, file.as_bytes());
    read_bytes(name, file.as_bytes()).unwrap_err().to_string()
}

#[test]
fn a_table_whose_columns_hold_a_value_each_is_refused_and_not_read_as_nothing() {
    let columns = "400,1,,\n410,,2,\n420,,,\n430,,,3\n";
    assert_eq!(
        refusal("plain columns", "a.csv", columns),
        "a.csv, line 1: found fewer than two values in every column, \
         expected at least two values of a spectrum"
    );
}

#[test]
fn a_table_whose_rows_hold_a_value_each_is_refused_and_not_read_as_nothing() {
    let rows = "nm,400,410,420,430,440\n1,0.1,,,,\n2,,0.2,,,\n3,,,0.3,,\n";
    assert_eq!(
        refusal("plain columns", "a.csv", rows),
        "a.csv, line 1: found fewer than two values in every row, \
         expected at least two values of a spectrum"
    );
}
