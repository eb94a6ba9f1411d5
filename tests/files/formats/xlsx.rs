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
    assert_eq!(spectrum.name, "a");
}

#[test]
fn a_sheet_without_a_table_is_refused_by_its_row() {
    let none = workbook(&format!("<row r=\"1\">{}</row>", word("A1", "only words")));
    let said = refusal("a.xlsx", none);
    assert!(said.contains("a workbook without cells"), "{said}");
    let bad = rows().replace("r=\"D4\"", "r=\"XFD1048576\"");
    let _ = spectral_explorer::io::read_bytes("a.xlsx", &workbook(&bad));
}

/// What unfolds to 1 GiB is in `tests/hostile/large.rs`.
#[test]
fn a_sheet_of_many_columns_is_read_however_well_it_is_packed() {
    // 2048 wavelengths and 57 spectra: mostly zeros, which pack a hundredfold.
    let rows: String = (0..2048)
        .map(|row| {
            let values = (0..57).map(|column| {
                let value = if row == 1000 + column { "0.5" } else { "0" };
                format!("<c><v>{value}</v></c>")
            });
            let values: String = values.collect();
            format!(
                "<row><c><v>{}</v></c>{values}</row>",
                350.0 + 0.25 * f64::from(row)
            )
        })
        .collect();
    let file = workbook(&rows);
    assert!(file.len() < 300_000, "{} bytes", file.len());
    let reading = read("a.xlsx", file);
    assert_eq!(reading.spectra.len(), 57);
    for (column, spectrum) in reading.spectra.iter().enumerate() {
        assert_eq!(spectrum.samples.len(), 2048);
        assert_eq!(spectrum.samples.values()[1000 + column], 0.5);
    }
}

#[test]
fn wavelengths_typed_with_their_unit_are_read_as_in_a_text() {
    let row = |at: usize, nm: usize| {
        let place = format!("A{at}");
        format!(
            "<row r=\"{at}\">{}<c r=\"B{at}\"><v>{}</v></c></row>",
            word(&place, &format!("{nm} nm")),
            nm / 10
        )
    };
    let rows: String = (1..20).map(|at| row(at, 380 + 5 * at)).collect();
    let samples = first("a.xlsx", workbook(&rows)).samples;
    assert_eq!(
        (samples.first_nm(), samples.last_nm(), samples.len()),
        (385.0, 475.0, 19)
    );
}

#[test]
fn a_hidden_sheet_is_not_read_and_named() {
    let main = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
    let office = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
    let package = "http://schemas.openxmlformats.org/package/2006/relationships";
    let book = format!(
        "<workbook xmlns=\"{main}\" xmlns:r=\"{office}\"><sheets>\
         <sheet name=\"Old\" sheetId=\"1\" state=\"hidden\" r:id=\"rId1\"/>\
         <sheet name=\"New\" sheetId=\"2\" r:id=\"rId2\"/></sheets></workbook>"
    );
    let link = |id: usize| {
        format!(
            "<Relationship Id=\"rId{id}\" Type=\"{office}/worksheet\" Target=\"worksheets/sheet{id}.xml\"/>"
        )
    };
    let links = format!(
        "<Relationships xmlns=\"{package}\">{}{}</Relationships>",
        link(1),
        link(2)
    );
    let root = format!(
        "<Relationships xmlns=\"{package}\"><Relationship Id=\"rId1\" \
         Type=\"{office}/officeDocument\" Target=\"xl/workbook.xml\"/></Relationships>"
    );
    let sheet = |value: usize| {
        let row = |at: usize| {
            format!(
                "<row r=\"{at}\"><c r=\"A{at}\"><v>{}</v></c><c r=\"B{at}\"><v>{}</v></c></row>",
                380 + 5 * at,
                value + at
            )
        };
        let rows: String = (1..20).map(row).collect();
        format!("<worksheet xmlns=\"{main}\"><sheetData>{rows}</sheetData></worksheet>")
    };
    let (old, new) = (sheet(100), sheet(200));
    let members = [
        ("_rels/.rels", root.as_bytes()),
        ("xl/workbook.xml", book.as_bytes()),
        ("xl/_rels/workbook.xml.rels", links.as_bytes()),
        ("xl/worksheets/sheet1.xml", old.as_bytes()),
        ("xl/worksheets/sheet2.xml", new.as_bytes()),
    ];
    let reading = read(
        "a.xlsx",
        containers::zipped(&members, CompressionMethod::Deflated),
    );
    assert_eq!(reading.spectra.len(), 1);
    assert_eq!(reading.spectra[0].samples.values()[0], 201.0);
    assert_told(&reading.notes, "sheet Old is hidden and was not read");
}
