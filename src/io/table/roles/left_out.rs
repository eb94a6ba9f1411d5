//! Columns that are no spectra, in words.

use crate::io::table::titles::Titles;

/// A column that is no spectrum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct LeftOut {
    /// Its place, from 0.
    pub column: usize,
    /// Its actual role, and its treatment.
    pub why: &'static str,
}

/// The role and treatment of a column of standard deviations.
pub(super) const SPREAD: &str = "is a spread and was left out";

/// The role and treatment of wavelengths without values.
pub(super) const SECOND_AXIS: &str = "is a second axis and was left out";

impl LeftOut {
    pub(crate) fn words(&self, titles: &Titles) -> String {
        left_out_words(&shown(titles, self.column), self.why)
    }
}

/// What a column that is no spectrum is, and what was done with it, as a sentence.
pub(crate) fn left_out_words(column: &str, why: &str) -> String {
    match why {
        "holds the wavelengths of the columns behind it" => {
            tr!(
                "{column} holds the wavelengths of the columns behind it",
                column
            )
        }
        "holds words and was left out" => {
            tr!("{column} holds words and was left out", column)
        }
        "counts the rows and was left out" => {
            tr!("{column} counts the rows and was left out", column)
        }
        "is one number throughout and was left out" => {
            tr!("{column} is one number throughout and was left out", column)
        }
        "rises by the same from row to row and was left out" => {
            tr!(
                "{column} rises by the same from row to row and was left out",
                column
            )
        }
        "holds whole numbers below zero throughout, a setting, and was left out" => tr!(
            "{column} holds whole numbers below zero throughout, a setting, and was left out",
            column
        ),
        "is a raw reading and was left out" => {
            tr!("{column} is a raw reading and was left out", column)
        }
        "is no spectrum by its title and was left out" => {
            tr!(
                "{column} is no spectrum by its title and was left out",
                column
            )
        }
        "weighs a light and was left out" => {
            tr!("{column} weighs a light and was left out", column)
        }
        SECOND_AXIS => tr!("{column} is a second axis and was left out", column),
        // A spread is known by its words ([`SPREAD`]).
        other => format!("{column} {other}"),
    }
}

/// A column by its place and title, for notes.
pub(crate) fn shown(titles: &Titles, column: usize) -> String {
    let title = titles.whole(column);
    if title.is_empty() {
        tr!("column {column}", column = column + 1)
    } else {
        tr!("column {column} ({title})", column = column + 1, title)
    }
}
