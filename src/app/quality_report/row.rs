//! The figures of one light, as tables show them.

use crate::{
    app::{
        figures::{Figure, OF_QUALITY},
        numbers::DASH,
    },
    color::quality::Figures,
};

/// A figure of a light.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    pub figure: &'static Figure,
    /// The number, or why there is none.
    pub value: Result<f64, String>,
    /// Meaning of the number in plain words; empty where there is nothing to add.
    pub reading: String,
}

impl Row {
    /// The value as shown: digits and unit, or a dash.
    pub fn shown(&self) -> String {
        let value = self.value.as_ref();
        value.map_or_else(|_| DASH.to_owned(), |value| self.figure.written(*value))
    }
}

/// Every figure that a screen shows, in the order of a report.
pub fn rows(figures: &Figures) -> Vec<Row> {
    let shown = OF_QUALITY.iter().filter(|row| !row.figure.title.is_empty());
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
            }
        })
        .collect()
}
