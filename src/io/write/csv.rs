//! Writing CSV: comment lines that say what it is, a line of titles, one row a wavelength.
//!
//! The plain columns reader takes it back: kind, unit and name stand in the comments under the
//! words that it looks for.

use std::fmt::Write;

use crate::spectrum::NamedSpectrum;

use crate::io::provenance::{Columns, MEASURED, Provenance, one_line, shortest};
use crate::io::text::dialect::{Delimiter, Dialect, MOST_COLUMNS};
use crate::io::text::first_line;

/// Title of the column of wavelengths.
const FIRST_TITLE: &str = "wavelength_nm";

/// More comments than [`write`] writes.
const MOST_COMMENTS: usize = 50;

/// What stands between the cells of our own files.
pub(crate) const DIALECT: Dialect = Dialect {
    delimiter: Delimiter::Comma,
    decimal_comma: false,
};

/// Whether a text starts as [`write`] starts it: comments with keys, then the titles.
pub(crate) fn is_own(text: &str) -> bool {
    Own::of(text).is_some()
}

/// A text that [`write`] wrote, taken apart. Names of spectra may look like anything (numbers,
/// units, spreads), so nothing in them is looked at.
#[derive(Clone, Debug)]
pub(crate) struct Own<'a> {
    /// The comments with their lines, marks removed.
    pub header: Vec<(usize, &'a str)>,
    /// The title of each column.
    pub titles: Vec<String>,
    /// The rows.
    pub rows: &'a str,
}

impl<'a> Own<'a> {
    /// Takes a text apart; `None` where it does not start as an own file.
    pub(crate) fn of(text: &'a str) -> Option<Self> {
        let mut rest = text;
        let mut header = Vec::new();
        loop {
            let (line, after) = first_line(rest)?;
            rest = after;
            if let Some(comment) = line.strip_prefix("# ") {
                if header.len() == MOST_COMMENTS {
                    return None;
                }
                header.push((header.len() + 1, comment));
                continue;
            }
            let others = line.strip_prefix(FIRST_TITLE)?;
            if header.is_empty() || !others.starts_with(',') {
                return None;
            }
            let mut cells = Vec::new();
            DIALECT.split(line, &mut cells);
            if cells.len() > MOST_COLUMNS {
                return None;
            }
            return Some(Self {
                header,
                titles: cells.into_iter().map(str::to_owned).collect(),
                rows: rest,
            });
        }
    }

    /// Lines in front of the rows.
    pub(crate) fn lines_before(&self) -> usize {
        self.header.len() + 1
    }

    /// What a column's spectrum is called; the header's name for what was measured.
    pub(crate) fn name(&self, column: usize) -> Option<&str> {
        let title = self.titles.get(column)?.as_str();
        (title != MEASURED || self.titles.len() > 2).then_some(title)
    }
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
    use crate::io::provenance::Column;
    use crate::io::read_bytes;
    use crate::io::write::tests::awkward_spectrum;
    use crate::spectrum::Kind;

    #[test]
    fn names_that_look_like_something_else_come_back() {
        let names = [
            "standard deviation lamp",
            "Zinc sigma",
            "Raman shift std",
            "wavelength panel",
            "x",
            "[nm]",
            "5%",
            "380nm",
            "n/a",
            "R(ref) target",
            "LED (1/2)",
            "column 7",
            MEASURED,
            &"long ".repeat(50),
        ];
        let named = |name: &str| NamedSpectrum {
            name: name.to_owned(),
            unit: "mW m-2 nm-1".to_owned(),
            ..awkward_spectrum(Kind::Light)
        };
        let all = names.map(named);
        for spectra in [&all[..], &all[..1], &all[6..7]] {
            let columns = Columns::together(spectra).unwrap();
            let text = write(&spectra[0], &columns, &Provenance::default());
            let reading = read_bytes("x.csv", text.as_bytes()).unwrap();
            assert_eq!(reading.guesses, []);
            assert_eq!(reading.spectra.len(), spectra.len());
            for (back, was) in reading.spectra.iter().zip(spectra) {
                assert_eq!(back.name, was.name.trim());
                assert_eq!((back.kind, &back.unit), (was.kind, &was.unit));
                assert_eq!(back.samples, was.samples);
            }
        }
    }

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
