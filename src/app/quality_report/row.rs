//! The figures of one light, as tables show them.

use crate::{
    app::{
        combining::words::figure_words,
        figures::{Figure, OF_QUALITY},
        numbers::DASH,
    },
    color::quality::Figures,
    measurements::Doubted,
};

/// A figure of a light.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    pub figure: &'static Figure,
    /// The number, or why there is none.
    pub value: Result<f64, String>,
    /// Meaning of the number in plain words; empty where there is nothing to add.
    pub reading: String,
    /// The same with its doubt, where that is known.
    pub doubt: Option<Doubted>,
}

impl Row {
    /// The value as shown: digits and unit with the half width of its 95 % interval, or a dash.
    pub fn shown(&self) -> String {
        let value = self.value.as_ref();
        if let Some(doubted) = self.doubt.filter(|_| value.is_ok()) {
            return figure_words(&doubted);
        }
        value.map_or_else(|_| DASH.to_owned(), |value| self.figure.written(*value))
    }
}

/// Every figure that a screen shows, in the order of a report.
pub fn rows(figures: &Figures) -> Vec<Row> {
    let shown = OF_QUALITY
        .iter()
        .filter(|row| !row.figure.title().is_empty());
    let of_this = shown.filter(|row| (row.applies)(figures));
    of_this
        .map(|row| {
            let value = row.value(figures);
            Row {
                figure: &row.figure,
                reading: match &value {
                    Ok(value) => row.reading(figures, *value),
                    Err(_) => String::new(),
                },
                value: value.map_err(|why| why.to_string()),
                doubt: None,
            }
        })
        .collect()
}

/// The same of a light some of whose figures have a known doubt.
pub fn rows_with(figures: &Figures, doubts: &[Doubted]) -> Vec<Row> {
    let with_doubt = |row: Row| Row {
        doubt: doubts
            .iter()
            .find(|doubted| doubted.figure.key() == row.figure.key)
            .copied(),
        ..row
    };
    rows(figures).into_iter().map(with_doubt).collect()
}
