//! Why a text is not a preset file: one line that says what was found and what was expected.

use std::fmt;

/// Why a text is not a preset file.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("preset file{}: expected {expected}, found {found}", at(*line))]
pub(crate) struct PresetError {
    /// Line in the file, counted from 1, where it is known.
    pub line: Option<usize>,
    /// Content found.
    pub found: String,
    /// Content expected.
    pub expected: String,
}

fn at(line: Option<usize>) -> String {
    line.map_or_else(String::new, |line| format!(", line {line}"))
}

impl PresetError {
    pub(super) fn of_item(
        item: &str,
        expected: impl Into<String>,
        found: impl fmt::Display,
    ) -> Self {
        Self {
            line: None,
            found: format!("item \"{item}\": {found}"),
            expected: expected.into(),
        }
    }

    pub(super) fn of_json(error: &serde_json::Error) -> Self {
        let line = Some(error.line()).filter(|line| *line > 0);
        // The parser's sentence ends in "at line L column C" and mostly holds "X, expected Y".
        let text = error.to_string();
        let text = text
            .rsplit_once(" at line ")
            .map_or(&*text, |(head, _)| head);
        let (found, expected) = text
            .split_once(", expected ")
            .unwrap_or((text, "a preset file"));
        Self {
            line,
            found: found.to_owned(),
            expected: expected.to_owned(),
        }
    }
}
