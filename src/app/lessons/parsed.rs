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
        for (start, instead) in [
            ("unknown field", "field"),
            ("unknown variant", "word"),
            ("unknown page", "page"),
        ] {
            if let Some(rest) = why.strip_prefix(start) {
                return format!("found the {instead}{rest}");
            }
        }
        for start in ["invalid type: ", "invalid value: ", "invalid length "] {
            if let Some(rest) = why.strip_prefix(start) {
                return format!("found {rest}");
            }
        }
        // Enums whose kinds are the keys of a file have those as their name.
        let of_enum = why.strip_prefix("no variant of enum ");
        if let Some(keys) = of_enum.and_then(|rest| rest.strip_suffix(" found in flattened data")) {
            return format!("found none of {keys}, expected one");
        }
        match why.strip_prefix("missing field ") {
            Some(field) => format!("found no {field}, expected it"),
            None => format!("found what is no part of a lesson: {why}"),
        }
    })
}
