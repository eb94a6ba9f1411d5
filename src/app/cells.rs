//! Cells of the tables that the program writes: numbers that read back exactly, and text that
//! cannot be taken for anything else.

use crate::{
    io::{Provenance, no_formula, one_line, quoted_where, shortest},
    spectrum::NamedSpectrum,
};

/// Comment lines over a table: where a spectrum and what was computed from it come from.
pub(super) fn comments(provenance: &Provenance, spectrum: &NamedSpectrum) -> String {
    provenance.comments(spectrum)
}

/// A number in the fewest digits that read back to it; nothing where there is none, since tables
/// know neither NaN nor infinity.
pub(super) fn number(value: impl Into<Option<f64>>) -> String {
    value
        .into()
        .filter(|v| v.is_finite())
        .map(shortest)
        .unwrap_or_default()
}

/// Text as one cell: in quotes where it holds a sign of the table's own or begins like a comment,
/// and never the beginning of a formula.
pub(super) fn words(text: &str) -> String {
    let text = no_formula(one_line(text));
    let is_special = text.contains([',', '"', ';']) || text.starts_with('#');
    quoted_where(is_special, &text)
}

/// A line of a table.
pub(super) fn line(cells: impl IntoIterator<Item = impl Into<String>>) -> String {
    let cells: Vec<String> = cells.into_iter().map(Into::into).collect();
    cells.join(",") + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_is_what_was_meant_or_nothing() {
        assert_eq!(number(0.1), "0.1");
        assert_eq!(number(f64::NAN), "");
        assert_eq!(number(None), "");
        assert_eq!(words("FL2"), "FL2");
        assert_eq!(words("a, \"b\"\nc"), "\"a, \"\"b\"\" c\"");
        assert_eq!(words("=1+1"), "'=1+1");
        assert_eq!(words("@a, b"), "\"'@a, b\"");
        assert_eq!(line([number(1.5), words("x")]), "1.5,x\n");
    }
}
