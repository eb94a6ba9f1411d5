//! Excel workbooks `.xlsx`: each sheet a table of plain columns.

use crate::containers;
use crate::told::{assert_told, first, read, refusal};
use spectral_explorer::spectrum::Kind;
use zip::CompressionMethod;

/// A workbook of one sheet with these rows.
fn workbook(rows: &str) -> Vec<u8> {
    let main = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
    let sheet = format!("<worksheet xmlns=\"{main}\"><sheetData>{rows}</sheetData></worksheet>");
    containers::workbook(sheet.as_bytes(), b"", CompressionMethod::Deflated)
}

fn word(place: &str, text: &str) -> String {
    format!("<c r=\"{place}\" t=\"inlineStr\"><is><t>{text}</t></is></c>")
}

fn rows() -> String {
    format!(
        "<row r=\"1\">{}{}{}</row><row r=\"2\">{}<c r=\"C2\"><v>600.5</v></c><c r=\"D2\"><v>80</v></c></row>\
         <row r=\"4\"><c r=\"C4\"><v>500</v></c><c r=\"D4\"><v>2.5</v></c></row>",
        word("A1", "Item 7"),
        word("C1", "Wavelength (nm)"),
        word("D1", "% Transmission"),
        word("A2", "A disclaimer")
    )
}

#[test]
fn a_sheet_is_read_as_columns_and_what_stands_beside_is_noted() {
    let spectrum = first("a.xlsx", workbook(&rows()));
    assert_eq!(spectrum.samples.nm(), [500.0, 600.5]);
    assert_eq!((spectrum.kind, spectrum.scale), (Kind::Transmittance, 0.01));
    let beside = "beside the table: Item 7".to_owned();
    assert!(spectrum.notes.contains(&beside));
}

#[test]
fn numbers_typed_as_text_with_a_decimal_comma_are_numbers() {
    let row = |row: usize, nm: usize, value: &str| {
        let nm = format!("<c r=\"A{row}\"><v>{nm}</v></c>");
        let value = word(&format!("B{row}"), value);
        format!("<row r=\"{row}\">{nm}{value}</row>")
    };
    let rows = row(1, 380, "0,5") + &row(2, 390, "0,25") + &row(3, 400, "1");
    let reading = read("a.xlsx", workbook(&rows));
    let spectrum = &reading.spectra[0];
    assert_eq!(spectrum.samples.values(), [0.5, 0.25, 1.0]);
    let notes = [&reading.notes[..], &spectrum.notes[..]].concat();
    assert_told(&notes, "decimal comma: 2 cells");
    assert!(!notes.concat().contains("TAB"), "{notes:?}");
}

#[test]
fn marks_that_part_a_texts_cells_are_words_in_a_sheet() {
    let rows = rows()
        .replace("% Transmission", "5\" lens; 1/2 // A, [1, 2, 3, 4, 5]")
        .replace("<v>80</v>", "<v>8</v>")
        .replace("Item 7", "; no, comment");
    let spectrum = first("a.xlsx", workbook(&rows));
    assert_eq!(spectrum.samples.values(), [2.5, 8.0]);
    let beside = "beside the table: ; no, comment".to_owned();
    assert!(spectrum.notes.contains(&beside), "{:?}", spectrum.notes);
    assert_eq!(spectrum.name, "5\" lens; 1/2 // A, [1, 2, 3, 4, 5]");
}

#[test]
fn a_sheet_without_a_table_is_refused_by_its_row() {
    let none = workbook(&format!("<row r=\"1\">{}</row>", word("A1", "only words")));
    let said = refusal("a.xlsx", none);
    assert!(said.contains("a workbook without cells"), "{said}");
    let bad = rows().replace("r=\"D4\"", "r=\"XFD1048576\"");
    let _ = spectral_explorer::io::read_bytes("a.xlsx", &workbook(&bad));
}

#[test]
fn bombs_are_refused() {
    let said = refusal("a.xlsx", workbook(&" ".repeat(64 << 20)));
    assert!(said.contains("unfolds to far more"), "{said}");
}
