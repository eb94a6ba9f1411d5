//! Writing CSV: comment lines that say what it is, a line of titles, one row a wavelength.
//!
//! The plain columns reader takes it back: kind, unit and name stand in the comments under the
//! words that it looks for.

use std::fmt::Write;

use crate::spectrum::NamedSpectrum;

use super::write::{Columns, Provenance, one_line, shortest};

/// Title of the column of wavelengths.
const FIRST_TITLE: &str = "wavelength_nm";

/// Whether a text starts as [`write`] starts it: comments with keys, then the titles.
pub fn is_own(head: &str) -> bool {
    let mut lines = head.lines();
    let titles = lines.by_ref().find(|line| !line.starts_with("# "));
    let is_titles = |line: &str| {
        line.strip_prefix(FIRST_TITLE)
            .is_some_and(|rest| rest.starts_with(','))
    };
    head.starts_with("# ") && titles.is_some_and(is_titles)
}

/// A spectrum and what was computed from it as CSV.
pub fn write(spectrum: &NamedSpectrum, columns: &Columns, provenance: &Provenance) -> String {
    let mut out = String::new();
    for (key, value) in provenance.of(spectrum) {
        let _ = writeln!(out, "# {key}: {value}");
    }
    out.push_str(FIRST_TITLE);
    for column in &columns.columns {
        out.push(',');
        out.push_str(&cell(&column.title));
    }
    out.push('\n');
    for (row, nm) in columns.nm.iter().enumerate() {
        out.push_str(&shortest(*nm));
        for column in &columns.columns {
            out.push(',');
            match column.values.get(row) {
                Some(value) if value.is_finite() => out.push_str(&shortest(*value)),
                _ => {}
            }
        }
        out.push('\n');
    }
    out
}

/// A text cell, quoted where it must be; a double quote inside becomes a single one.
fn cell(text: &str) -> String {
    let text = one_line(text);
    if text.contains([',', '"', ';']) {
        format!("\"{}\"", text.replace('"', "'"))
    } else {
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::read_bytes;
    use crate::io::write::Column;
    use crate::io::write::tests::awkward_spectrum;
    use crate::spectrum::Kind;

    #[test]
    fn several_columns_come_back_by_their_titles_and_gaps_stay_gaps() {
        let spectrum = awkward_spectrum(Kind::Light);
        let mut columns = Columns::measured(&spectrum);
        columns.columns.push(Column {
            title: "model, order 7".to_owned(),
            values: vec![f64::NAN, 1.0, 2.0, 3.0, 4.0, f64::NAN],
        });
        let text = write(&spectrum, &columns, &Provenance::default());
        let reading = read_bytes("x.csv", text.as_bytes()).unwrap();
        assert_eq!(reading.spectra.len(), 2);
        assert_eq!(reading.spectra[0].samples, spectrum.samples);
        assert_eq!(reading.spectra[1].name, "model, order 7");
        assert_eq!(reading.spectra[1].samples.values(), [1.0, 2.0, 3.0, 4.0]);
        assert!(reading.guesses.is_empty(), "{:?}", reading.guesses);
    }
}
