//! Parts of a lesson's file, and what is said of those that are none.

use serde::de::DeserializeOwned;
use serde_json::Value;

/// A value as what it is to be.
///
/// # Errors
/// What was found and what was expected.
pub(super) fn parsed<T: DeserializeOwned>(value: Value) -> Result<T, String> {
    serde_json::from_value(value).map_err(|why| {
        let why = why.to_string();
        for (start, instead) in [("unknown field", "field"), ("unknown variant", "word")] {
            if let Some(rest) = why.strip_prefix(start) {
                return format!("found the {instead}{rest}");
            }
        }
        for start in ["invalid type: ", "invalid value: ", "invalid length "] {
            if let Some(rest) = why.strip_prefix(start) {
                return format!("found {rest}");
            }
        }
        match why.strip_prefix("missing field ") {
            Some(field) => format!("found no {field}, expected it"),
            None => format!("found what is no part of a lesson: {why}"),
        }
    })
}
