//! Which columns of a table are spectra and which are something beside them.

use super::kinds::kind_of_title;
use super::table::Block;
use super::titles::Titles;
use super::units::names_wavelength;

/// Columns that are spectra, and why others were left out, a sentence each.
pub fn value_columns(
    block: &Block,
    titles: &Titles,
    wavelength: usize,
) -> (Vec<usize>, Vec<String>) {
    let (mut values, mut notes) = (Vec::new(), Vec::new());
    let raw_beside = beside_processed(titles, wavelength);
    for column in (0..block.width).filter(|c| *c != wavelength) {
        let stats = &block.columns[column];
        let title = titles.whole(column);
        let shown = if title.is_empty() {
            format!("column {}", column + 1)
        } else {
            format!("column {} ({})", column + 1, title)
        };
        if stats.numbers == 0 {
            if stats.texts > 0 {
                notes.push(format!("{shown} holds words and was left out"));
            }
        } else if block.counts_rows(column) && column < wavelength {
            notes.push(format!("{shown} counts the rows and was left out"));
        } else if is_spread(&title) {
            notes.push(format!("{shown} is a spread and was left out"));
        } else if names_wavelength(&title) {
            notes.push(format!("{shown} is a second axis and was left out"));
        } else if raw_beside.contains(&column) {
            notes.push(format!("{shown} is a raw reading and was left out"));
        } else {
            values.push(column);
        }
    }
    // The ratio before the readings that it was made of, where all are kept.
    let made_of = |column: &usize| {
        let title = titles.whole(*column).to_lowercase();
        title.contains("(ref") || title.contains("target")
    };
    if values.iter().any(made_of) {
        values.sort_by_key(made_of);
    }
    (values, notes)
}

/// A column of standard deviations or uncertainties.
fn is_spread(title: &str) -> bool {
    let title = title.to_lowercase();
    let words = [
        "std",
        "st.dev",
        "stdev",
        "standard dev",
        "uncert",
        "sigma",
        "error",
        "±",
        "variance",
    ];
    words.iter().any(|w| title.contains(w))
}

/// Raw readings that stand beside the processed values: dark, reference and sample counts next to
/// a transmittance, or the letters W D R S P that Ocean Optics writes.
fn beside_processed(titles: &Titles, wavelength: usize) -> Vec<usize> {
    let others: Vec<usize> = (0..titles.names.len())
        .filter(|c| *c != wavelength)
        .collect();
    let letters: Vec<&str> = others.iter().map(|c| titles.names[*c].as_str()).collect();
    if letters == ["D", "R", "S", "P"] {
        return others[..3].to_vec();
    }
    let raw = |column: usize| {
        let title = titles.whole(column).to_lowercase();
        let word = title.split([' ', '[', '(', '.']).next().unwrap_or("");
        matches!(
            word,
            "dark" | "ref" | "reference" | "sample" | "scope" | "raw" | "norm" | "background"
        ) && (kind_of_title(&title).is_none() || title.contains("counts"))
    };
    let raws: Vec<usize> = others.iter().copied().filter(|c| raw(*c)).collect();
    let processed = others
        .iter()
        .any(|c| !raw(*c) && kind_of_title(&titles.whole(*c)).is_some());
    if processed { raws } else { Vec::new() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::dialect::{Delimiter, Dialect};
    use crate::io::table::scan;

    fn values(text: &str) -> (Vec<usize>, Vec<String>) {
        let dialect = Dialect {
            delimiter: Delimiter::Semicolon,
            decimal_comma: false,
        };
        let scan = scan(text, dialect).unwrap();
        let block = &scan.blocks[0];
        value_columns(block, &Titles::of(block, dialect), 0)
    }

    #[test]
    fn raw_counts_beside_a_transmittance_are_left_out_and_said() {
        let text = "Wave;Dark;Ref;Sample;Transmittance\n[nm];[counts];[counts];[counts];[%]\n300;1;9;5;50\n301;1;9;4;40\n";
        let (columns, notes) = values(text);
        assert_eq!(columns, [4]);
        assert_eq!(notes.len(), 3);
        assert!(notes[0].contains("Dark"));
    }

    #[test]
    fn a_reflectance_comes_before_the_radiances_that_it_was_made_of() {
        let text = "Wvl;Rad. (Ref.);Rad. (Target);Reflect. %\n350;1;9;50\n351;1;9;40\n";
        assert_eq!(values(text).0, [3, 1, 2]);
    }

    #[test]
    fn a_spread_is_no_spectrum_but_a_sample_alone_is() {
        assert_eq!(values("nm;T;Std.Dev.\n300;1;0.1\n301;2;0.1\n").0, [1]);
        assert_eq!(values("nm;Sample\n300;1\n301;2\n").0, [1]);
    }
}
