//! JSON as a whole, and its faults in words.

use crate::io::{Input, ReadError, budget};

/// Memory that the parser takes for a value in a list, and for one with a key, in bytes.
const VALUE_BYTES: usize = 40;
const KEYED_BYTES: usize = 130;

/// A whole text as JSON. The parsed form of short values is far larger than their text, so they
/// are counted first.
///
/// # Errors
/// [`ReadError`] for broken JSON, or more values than fit into the memory that the file may take.
pub(crate) fn any_json(input: &Input, text: &str) -> Result<serde_json::Value, ReadError> {
    let count = |marks: &[u8]| text.bytes().filter(|b| marks.contains(b)).count();
    let memory = count(b",[{") * VALUE_BYTES + count(b":") * KEYED_BYTES;
    if memory > budget::of(text.len()) / 2 {
        return Err(input.error(
            "JSON of far more values than its size allows",
            budget::WORDS,
        ));
    }
    serde_json::from_str(text).map_err(|error| json_error(input, &error))
}

/// An error of the JSON parser as one of the file.
pub(crate) fn json_error(input: &Input, error: &serde_json::Error) -> ReadError {
    // The parser's sentence ends in "at line L column C" and mostly holds "X, expected Y".
    let text = error.to_string();
    let text = text
        .rsplit_once(" at line ")
        .map_or(&*text, |(head, _)| head);
    let (found, expected) = text
        .split_once(", expected ")
        .or_else(|| text.split_once(" expected "))
        .unwrap_or((text, "valid JSON of this format"));
    let refusal = input.error(format!("JSON with {found}"), expected);
    if error.line() > 0 {
        refusal.at_line(error.line())
    } else {
        refusal
    }
}
