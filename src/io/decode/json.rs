//! JSON as a whole, and its faults in words.

use serde_json::Value;

use crate::io::error::{kept, quoted};
use crate::io::{Input, ReadError, budget};
use crate::languages::said;

/// Memory that the parser takes for a value in a list, and for one with a key, in bytes.
const VALUE_BYTES: usize = 40;
const KEYED_BYTES: usize = 130;

/// A whole text as JSON.
///
/// # Errors
/// [`ReadError`] for broken JSON, or more values than fit into the memory that the file may take.
pub(crate) fn any_json(input: &Input, text: &str) -> Result<Value, ReadError> {
    let most = budget::of(text.len()) / 2;
    check_room(input, text, [VALUE_BYTES, KEYED_BYTES], most)?;
    serde_json::from_str(text).map_err(|error| json_error(input, &error))
}

/// Refuses a text whose parsed form takes more than `most` bytes: that of short values is far
/// larger than their text, so they are counted first.
///
/// # Errors
/// [`ReadError`] if it takes more.
pub(super) fn check_room(
    input: &Input,
    text: &str,
    [value_bytes, keyed_bytes]: [usize; 2],
    most: usize,
) -> Result<(), ReadError> {
    let count = |marks: &[u8]| text.bytes().filter(|b| marks.contains(b)).count();
    if count(b",[{") * value_bytes + count(b":") * keyed_bytes <= most {
        return Ok(());
    }
    let found = said!("JSON of far more values than its size allows");
    Err(input.error(found, said(budget::WORDS)))
}

/// An error of the JSON parser as one of the file.
pub(crate) fn json_error(input: &Input, error: &serde_json::Error) -> ReadError {
    // The parser's sentence ends in "at line L column C" and mostly holds "X, expected Y".
    let text = error.to_string();
    let text = text
        .rsplit_once(" at line ")
        .map_or(&*text, |(head, _)| head);
    if text.starts_with("recursion limit") {
        let found = said!("JSON of more than 127 lists in one another");
        return input.error(found, said!("fewer")).at_line(error.line());
    }
    let parted = text.split_once(", expected ");
    let parted = parted.or_else(|| text.split_once(" expected "));
    let (found, expected) = parted.unwrap_or((text, said!("valid JSON of this format")));
    let refusal = input.error(tr!("JSON with {found}", found), expected);
    match error.line() {
        0 => refusal,
        line => refusal.at_line(line),
    }
}

/// A word at a place in the JSON, unless it is empty.
pub(crate) fn word<'a>(value: &'a Value, pointer: &str) -> Option<&'a str> {
    let text = value.pointer(pointer)?.as_str()?.trim();
    (!text.is_empty()).then(|| kept(text))
}

/// A list of numbers.
pub(crate) fn numbers(input: &Input, list: &Value, what: &str) -> Result<Vec<f64>, ReadError> {
    let other = || {
        input.error(
            tr!("{what} that is no list", what),
            said!("a list of numbers"),
        )
    };
    let list = list.as_array().ok_or_else(other)?;
    list.iter().map(|item| number(input, item, what)).collect()
}

/// A number; `null` for a missing one.
pub(crate) fn number(input: &Input, item: &Value, what: &str) -> Result<f64, ReadError> {
    match item {
        Value::Null => Ok(f64::NAN),
        Value::Number(number) => Ok(number.as_f64().unwrap_or(f64::NAN)),
        other => {
            let found = tr!(
                "{value} in {what}",
                value = quoted(&other.to_string()),
                what
            );
            Err(input.error(found, said!("a number")))
        }
    }
}
