//! JSON with its keys in the order of the file, which name spectra and put them in order.

use std::fmt;

use serde::de::{Deserialize, Deserializer, MapAccess, SeqAccess, Visitor};

use crate::io::decode::json::{check_room, json_error};
use crate::io::{Input, ReadError, budget};

/// Memory that a value in a list takes, and one with a key, in bytes, while the list grows.
const VALUE_BYTES: usize = 64;
const KEYED_BYTES: usize = 88;

/// A value of JSON.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Tree {
    /// `null`, `true` or `false`.
    Nothing,
    /// A number.
    Number(f64),
    /// Words.
    Text(String),
    /// Values one behind another.
    List(Vec<Tree>),
    /// Keys and their values.
    Object(Object),
}

/// Keys and their values in the order of the file.
pub(crate) type Object = Vec<(String, Tree)>;

/// A whole text as JSON; a list if values follow one another, as on lines of their own.
///
/// # Errors
/// [`ReadError`] for broken JSON, or more values than fit into the memory that the file may take.
pub(crate) fn of(input: &Input, text: &str) -> Result<Tree, ReadError> {
    let most = budget::of(text.len()) / 4 * 3;
    check_room(input, text, [VALUE_BYTES, KEYED_BYTES], most)?;
    let values = serde_json::Deserializer::from_str(text).into_iter::<Tree>();
    let values: Result<Vec<Tree>, _> = values.collect();
    let mut values = values.map_err(|error| json_error(input, &error))?;
    match values.len() {
        1 => Ok(values.pop().unwrap_or(Tree::Nothing)),
        _ => Ok(Tree::List(values)),
    }
}

impl Tree {
    /// The text, if it is one.
    pub(crate) fn text(&self) -> Option<&str> {
        match self {
            Self::Text(text) => Some(text),
            _ => None,
        }
    }

    /// The keys and values, where it is an object.
    pub(crate) fn object(&self) -> Option<&Object> {
        match self {
            Self::Object(object) => Some(object),
            _ => None,
        }
    }

    /// True for a list or an object.
    pub(crate) fn holds_values(&self) -> bool {
        matches!(self, Self::List(_) | Self::Object(_))
    }
}

impl<'de> Deserialize<'de> for Tree {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Builder)
    }
}

struct Builder;

impl<'de> Visitor<'de> for Builder {
    type Value = Tree;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("JSON")
    }

    fn visit_bool<E>(self, _: bool) -> Result<Tree, E> {
        Ok(Tree::Nothing)
    }

    fn visit_unit<E>(self) -> Result<Tree, E> {
        Ok(Tree::Nothing)
    }

    fn visit_i64<E>(self, number: i64) -> Result<Tree, E> {
        Ok(Tree::Number(number as f64))
    }

    fn visit_u64<E>(self, number: u64) -> Result<Tree, E> {
        Ok(Tree::Number(number as f64))
    }

    fn visit_f64<E>(self, number: f64) -> Result<Tree, E> {
        Ok(Tree::Number(number))
    }

    fn visit_str<E>(self, text: &str) -> Result<Tree, E> {
        Ok(Tree::Text(text.to_owned()))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Tree, A::Error> {
        let all = std::iter::from_fn(|| items.next_element().transpose());
        let mut list: Vec<Tree> = all.collect::<Result<_, _>>()?;
        list.shrink_to_fit();
        Ok(Tree::List(list))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Tree, A::Error> {
        let all = std::iter::from_fn(|| entries.next_entry().transpose());
        let mut object: Object = all.collect::<Result<_, _>>()?;
        object.shrink_to_fit();
        Ok(Tree::Object(object))
    }
}
