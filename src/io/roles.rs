//! Which columns of a table are spectra and which are something beside them.

use super::kinds::kind_of_title;
use super::table::Block;
use super::titles::Titles;
use super::units::names_wavelength;

/// Columns of wavelengths beside the table's own: such as are titled so, hold other numbers, and
/// have values between the two. "Lower wvl, upper wvl, value" has none.
pub fn other_axes(
    block: &Block,
    titles: &Titles,
    wavelength: usize,
    values: &[usize],
) -> Vec<usize> {
    let is_titled =
        |at: &usize| block.columns[*at].numbers > 0 && names_wavelength(&titles.whole(*at));
    let is_pair = |at: &usize| {
        let between = wavelength.min(*at)..wavelength.max(*at);
        !values.contains(at) && values.iter().any(|v| between.contains(v))
    };
    let differs = |at: &usize| {
        let (own, table) = (block.column(*at), block.column(wavelength));
        own.iter().zip(table).any(|(a, b)| a != b && !a.is_nan())
    };
    (0..block.width)
        .filter(|at| *at != wavelength)
        .filter(is_titled)
        .filter(is_pair)
        .filter(differs)
        .collect()
}

/// The column that holds the wavelengths of a column of values: the nearest axis to its left, where
/// pairs of wavelengths and values stand side by side with a grid each, else the table's own.
pub fn axis_of(others: &[usize], wavelength: usize, column: usize) -> usize {
    let nearest = others.iter().copied().rfind(|at| *at < column);
    match nearest {
        Some(at) if wavelength > column || at > wavelength => at,
        _ => wavelength,
    }
}

/// What is said of further columns of wavelengths.
pub const SECOND_AXIS: &str = "is a second axis and was left out";

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
        } else if column < wavelength && (block.counts_rows(column) || is_counter(&title)) {
            notes.push(format!("{shown} counts the rows and was left out"));
        } else if column < wavelength && title.is_empty() && block.is_constant(column) {
            notes.push(format!("{shown} is one number throughout and was left out"));
        } else if is_spread(&title) {
            notes.push(format!("{shown} is a spread and was left out"));
        } else if names_wavelength(&title) {
            notes.push(format!("{shown} {SECOND_AXIS}"));
        } else if raw_beside.contains(&column) {
            notes.push(format!("{shown} is a raw reading and was left out"));
        } else {
            values.push(column);
        }
    }
    // "AxisUnit = nm" above the values is no second axis: there is nothing else that they could be.
    if values.is_empty() {
        let second_axis = |column: &usize| {
            *column != wavelength
                && block.columns[*column].numbers > 0
                && names_wavelength(&titles.whole(*column))
        };
        values.extend((0..block.width).find(second_axis));
        notes.retain(|note| !note.ends_with(SECOND_AXIS));
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

/// A column that counts detector elements, by its title.
fn is_counter(title: &str) -> bool {
    let title = title.to_lowercase();
    let word = title.trim_matches(['"', '#', '.', ' ']);
    matches!(
        word,
        "chan" | "channel" | "pixel" | "pixels" | "index" | "no" | "nr" | "number" | "row"
    )
}

/// A column of standard deviations, uncertainties or widths of the spectrometer's bands.
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
        || ["sd", "se", "sem", "fwhm", "bandwidth"].contains(&title.trim())
}

/// Raw readings that stand beside the processed values: dark, reference and sample counts next to
/// a transmittance, in the same rows as a column called "Processed", or the letters W D R S P that
/// Ocean Optics writes (no R where nothing was compared, no D where no dark reading was taken).
fn beside_processed(titles: &Titles, wavelength: usize) -> Vec<usize> {
    let others: Vec<usize> = (0..titles.names.len())
        .filter(|c| *c != wavelength)
        .collect();
    let letters: Vec<&str> = others.iter().map(|c| titles.names[*c].as_str()).collect();
    if let [readings @ .., "P"] = letters.as_slice()
        && !readings.is_empty()
        && readings.iter().all(|l| ["D", "R", "S"].contains(l))
    {
        return others[..readings.len()].to_vec();
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
    let processed = others.iter().any(|c| {
        let title = titles.whole(*c);
        !raw(*c) && (kind_of_title(&title).is_some() || is_processed(&title))
    });
    if processed {
        return raws;
    }
    // A sample in counts beside what was measured without it.
    let is_sample = |column: &usize| {
        let title = titles.whole(*column).to_lowercase();
        title.starts_with("sample") || title.starts_with("scope")
    };
    let (samples, others): (Vec<usize>, Vec<usize>) = raws.into_iter().partition(is_sample);
    let has_dark = others
        .iter()
        .any(|column| titles.whole(*column).to_lowercase().starts_with("dark"));
    if samples.len() == 1 && has_dark {
        others
    } else {
        Vec::new()
    }
}

/// Whether a title says no more than that its column is the result.
pub fn is_processed(title: &str) -> bool {
    title.trim().eq_ignore_ascii_case("processed")
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
    fn of_counts_the_sample_is_kept_where_a_dark_reading_stands_beside_it() {
        let text =
            "Wave;Dark;Reference;Sample\n[nm];[counts];[counts];[counts]\n300;1;9;5\n301;1;9;4\n";
        let (columns, notes) = values(text);
        assert_eq!(columns, [3]);
        assert_eq!(notes.len(), 2);
        assert_eq!(values("nm;Reference;Sample\n300;9;5\n301;9;4\n").0, [1, 2]);
    }

    #[test]
    fn a_reflectance_comes_before_the_radiances_that_it_was_made_of() {
        let text = "Wvl;Rad. (Ref.);Rad. (Target);Reflect. %\n350;1;9;50\n351;1;9;40\n";
        assert_eq!(values(text).0, [3, 1, 2]);
    }

    #[test]
    fn of_letters_and_of_what_is_processed_only_the_result_is_a_spectrum() {
        assert_eq!(values("W;D;S;P\n300;1;5;4\n301;1;6;5\n").0, [3]);
        assert_eq!(values("W;S;P\n300;5;4\n301;6;5\n").0, [2]);
        assert_eq!(values("W;S\n300;5\n301;6\n").0, [1]);
        let text = "Wavelength;Processed;Raw;Dark;Reference\n300;0.1;8;1;5\n301;0.2;9;1;5\n";
        assert_eq!(values(text).0, [1]);
    }

    #[test]
    fn a_number_of_a_detector_element_is_no_spectrum_and_a_line_of_units_no_second_axis() {
        let text = "Chan.#;Wvl;Refl\n0;350;0.5\n7;351;0.4\n";
        let dialect = Dialect {
            delimiter: Delimiter::Semicolon,
            decimal_comma: false,
        };
        let scan = scan(text, dialect).unwrap();
        let titles = Titles::of(&scan.blocks[0], dialect);
        assert_eq!(value_columns(&scan.blocks[0], &titles, 1).0, [2]);
        assert_eq!(values("Unit;nm\n300;1\n301;2\n").0, [1]);
    }

    #[test]
    fn one_number_before_every_wavelength_is_no_spectrum() {
        let text = "210;290;1\n210;291;2\n210;292;5\n";
        let dialect = Dialect {
            delimiter: Delimiter::Semicolon,
            decimal_comma: false,
        };
        let scan = scan(text, dialect).unwrap();
        let (columns, notes) = value_columns(&scan.blocks[0], &Titles::default(), 1);
        assert_eq!(columns, [2]);
        assert!(notes[0].contains("one number throughout"), "{notes:?}");
    }

    #[test]
    fn a_spread_is_no_spectrum_but_a_sample_alone_is() {
        assert_eq!(values("nm;T;Std.Dev.\n300;1;0.1\n301;2;0.1\n").0, [1]);
        assert_eq!(values("nm;Sample\n300;1\n301;2\n").0, [1]);
        assert_eq!(values("nm;leaf;FWHM;sd\n300;1;5;2\n301;2;5;1\n").0, [1]);
    }
}
