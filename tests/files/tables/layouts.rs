//! Where a text keeps its table, and a table its wavelengths.

use crate::told::{assert_told, first, has, names, read};
use spectral_explorer::io::{Delimiter, Dialect, Reading, read_bytes};

/// How the text was taken apart, and the column of wavelengths.
fn found(reading: &Reading) -> (Dialect, Option<usize>) {
    let table = reading.table.as_ref().expect("a plain table");
    (table.dialect, table.axis_column)
}

#[test]
fn delimiter_and_decimal_mark_are_found_together() {
    for (row, delimiter, decimal_comma) in [
        ("380.5,0.25", Delimiter::Comma, false),
        ("380,5;0,25", Delimiter::Semicolon, true),
        ("380.5; 0.25 ", Delimiter::Semicolon, false),
        ("380,5\t0,25", Delimiter::Tab, true),
        ("380,5 0,25 0,26", Delimiter::Space, true),
        ("380.5  0.25", Delimiter::Space, false),
        ("380.5,\t0.25", Delimiter::Comma, false),
        ("\"380,5\",\"0,25\"", Delimiter::Comma, true),
    ] {
        let rows = (0..5).map(|i| row.replacen("380", &(380 + i).to_string(), 1) + "\n");
        let reading = read("a.csv", rows.collect::<String>());
        let dialect = Dialect {
            delimiter,
            decimal_comma,
        };
        assert_eq!(found(&reading).0, dialect, "{row}");
    }
}

#[test]
fn wavelengths_stand_behind_a_count_of_the_rows_and_under_a_title() {
    for text in [
        "0,380,1.5\n1,385,1.6\n2,390,1.7\n",
        "counts,nm\n500,380\n510,385\n520,390\n",
    ] {
        assert_eq!(found(&read("a.csv", text)).1, Some(1), "{text}");
    }
    assert!(read_bytes("a.csv", b"1,2\n3,1\n2,7\n1,0\n").is_err());
    let traced = "735,1\n734.5,0\n734.7,3\n734.1,0\n734.3,4\n733,0\n";
    assert!(read_bytes("a.csv", traced.as_bytes()).is_err());
    assert_eq!(
        first("a.csv", format!("w.length,response\n{traced}"))
            .samples
            .len(),
        6
    );
}

#[test]
fn wavelengths_in_the_first_row_or_in_labels_make_spectra_in_rows() {
    for text in [
        "wavelength,380,385,390,395,400\n1,.1,.2,.3,.2,.1\n2,.2,.3,.4,.3,.2\n",
        "name,R_380,R_385,R_390,R_395,R_400\nred,1,2,3,4,5\nblue,2,3,4,5,6\n",
        "id,380 nm,385 nm,390 nm,395 nm,400 nm\nred,.1,.2,.3,.4,.5\nblue,.5,.4,.3,.2,.1\n",
        "wavelength,380,385,390,395,400\n101,1,2,3,4,5\n102,2,3,4,5,6\n",
    ] {
        let reading = read("a.csv", text);
        assert_eq!(
            (reading.spectra.len(), found(&reading).1),
            (2, None),
            "{text}"
        );
        assert_eq!(
            reading.spectra[0].samples.nm(),
            [380.0, 385.0, 390.0, 395.0, 400.0]
        );
    }
    // Numbers above a column of wavelengths are titles.
    let titled = read(
        "a.csv",
        "Wavelength,1,2,405\n380,1,2,3\n385,2,3,4\n390,3,4,5\n",
    );
    assert_eq!(names(&titled).len(), 3);
    assert_eq!(titled.spectra[0].samples.nm(), [380.0, 385.0, 390.0]);
}

#[test]
fn a_page_head_inside_a_table_is_passed_over_and_said() {
    let reading = read("a.csv", "380 1\n385 2\n390 3\nPage two\n395 4\n400 5\n");
    assert_eq!(reading.spectra[0].samples.len(), 5);
    assert_told(
        &reading.notes,
        "line 4 is no row of the table and was left out",
    );
}

#[test]
fn a_word_in_any_row_of_a_short_table_is_refused_at_its_line() {
    for (at, word) in (0..5).map(|at| (at, "1.234.5")).chain([(2, "abc")]) {
        let mut rows = ["nm,value", "380,1", "381,2", "382,3", "383,4", "384,5"];
        let bad = format!("38{at},{word}");
        rows[at + 1] = &bad;
        let why = read_bytes("a.csv", (rows.join("\n") + "\n").as_bytes()).expect_err("a word");
        let said = format!(
            "line {}: found \"{word}\", expected a number in column 2",
            at + 2
        );
        assert!(why.to_string().contains(&said), "{why}");
    }
}

#[test]
fn the_header_above_a_few_rows_of_numbers_is_the_table_s() {
    let mut text =
        String::from("Irradiance, W m-2 nm-1\nsza = 1 2\n 12.0 12.5 13.0\n 1.8 5.7 13.2\nend\n");
    for nm in 290..330 {
        text += &format!("{nm} 0.5 0.25\n");
    }
    let notes = first("a.txt", text).notes;
    assert!(!has(&notes, "nothing states it"), "{notes:?}");
}

/// The values of each column, whatever their kind.
fn columns(text: &str) -> Vec<Vec<f64>> {
    let spectra = read("a.csv", text).spectra;
    spectra
        .iter()
        .map(|s| s.samples.values().iter().map(|v| v / s.scale).collect())
        .collect()
}

#[test]
fn words_around_a_table_are_its_header_and_between_tables_divide_them() {
    let text = "Lamp A\n# note\nIndex,13,14\nnm,a,b\n380,1,2\n\n385,3,4\n";
    assert_eq!(columns(text), [[1.0, 3.0], [2.0, 4.0]]);
    let two = read("a.csv", "380,1\n385,2\nSecond\n380,3\n385,4\n");
    assert_eq!(two.spectra.len(), 2);
}

#[test]
fn a_comment_behind_a_row_is_no_cell_of_it_and_other_lines_are_no_rows() {
    for (text, last) in [
        (
            "380,1,2 # first\n385,2,3\n390,3,4 // c\n395,7,5\n400,5,6\n",
            vec![2.0, 3.0, 4.0, 5.0, 6.0],
        ),
        ("380,0.1,1\n385,0.2,2 # c\n390,0.3,3\n", vec![1.0, 2.0, 3.0]),
        (
            "380,1,\n381,2,peak\n382,3,\n383,4,\n",
            vec![1.0, 2.0, 3.0, 4.0],
        ),
        (
            "380,1\n385,2\n390,3\n395,4\n400,NaN\n\n405, 6 \r\n410,\"7\"\n# c\n415,8",
            vec![1.0, 2.0, 3.0, 4.0, 6.0, 7.0, 8.0],
        ),
    ] {
        assert_eq!(columns(text).last(), Some(&last), "{text}");
    }
}
