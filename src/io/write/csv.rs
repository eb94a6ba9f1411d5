//! Writing CSV: comment lines that describe it, a line of titles, one row a wavelength.
//!
//! [`own_csv`](crate::io::formats::own_csv) takes it back.

use crate::io::provenance::{Columns, Provenance, one_line, shortest};
use crate::spectrum::NamedSpectrum;

/// Title of the column of wavelengths.
pub(crate) const FIRST_TITLE: &str = "wavelength_nm";

/// A spectrum and the values computed from it as CSV.
pub fn write(spectrum: &NamedSpectrum, columns: &Columns, provenance: &Provenance) -> String {
    let mut out = provenance.comments(spectrum) + FIRST_TITLE;
    for column in &columns.columns {
        out.push(',');
        out.push_str(&title(&column.title));
    }
    out.push('\n');
    for (row, nm) in columns.nm.iter().enumerate() {
        out.push_str(&shortest(*nm));
        for column in &columns.columns {
            out.push(',');
            if let Some(value) = column.values.get(row).filter(|value| value.is_finite()) {
                out.push_str(&shortest(*value));
            }
        }
        out.push('\n');
    }
    out
}

/// Signs that table programs take for the beginning of a formula.
const FORMULA: [char; 4] = ['=', '+', '-', '@'];

/// A text that no table program takes for a formula: an apostrophe precedes its first character.
pub(crate) fn no_formula(text: String) -> String {
    match text.starts_with(FORMULA) {
        true => format!("'{text}"),
        false => text,
    }
}

/// The text before [`no_formula`].
pub(crate) fn as_it_was(text: &str) -> &str {
    let rest = text.strip_prefix('\'');
    rest.filter(|rest| rest.starts_with(FORMULA))
        .unwrap_or(text)
}

/// A cell of text; between double quotes, those inside doubled, where it holds a special sign.
pub(crate) fn quoted_where(is_special: bool, text: &str) -> String {
    match is_special {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text.to_owned(),
    }
}

/// A title: a double quote read back is the edge of a cell, so one inside becomes a single one.
fn title(text: &str) -> String {
    let text = no_formula(one_line(text));
    quoted_where(text.contains([',', '"', ';']), &text.replace('"', "'"))
}
