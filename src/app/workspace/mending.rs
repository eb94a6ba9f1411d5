//! One word that is not understood costs one setting: a value is put together from what was found,
//! piece by piece, and the usual stands where a piece does not fit.
//!
//! No list of fields is kept here. A tree of the usual value is changed in one place after the
//! other, and whether a piece fits is what the value's own reader says of the whole tree.

use std::marker::PhantomData;

use serde::{Serialize, de::DeserializeOwned};
use serde_json::{Map, Value, json};

use crate::io::quoted;

/// Pieces that are tried one by one where a list or group of fixed form does not fit.
const MOST_TRIED: usize = 64;

/// Longest value that is told as it was found, characters.
const LONGEST: usize = 60;

/// What was found as far as it is understood, over the usual value. A sentence for each piece that
/// is not goes to `losses`.
pub(super) fn mended<T: Serialize + DeserializeOwned>(
    usual: T,
    found: Map<String, Value>,
    losses: &mut Vec<String>,
) -> T {
    let Ok(tree) = serde_json::to_value(&usual) else {
        return usual;
    };
    let mut mender = Mender::<T> {
        tree,
        losses: Vec::new(),
        told: Vec::new(),
        reads: PhantomData,
    };
    let found = Value::Object(found);
    mender.put(&[], &found);
    let value = T::deserialize(&mender.tree).unwrap_or(usual);
    if let Ok(read) = serde_json::to_value(&value) {
        mender.tell_unknown(&[], &found, &read);
    }
    losses.append(&mut mender.losses);
    value
}

/// A value that stood where another one stands now, a sentence for each difference. Its place is
/// "" for a group whose fields stand at the top.
pub(super) fn moved<T: Serialize>(place: &str, before: &T, after: &T, losses: &mut Vec<String>) {
    if let (Ok(before), Ok(after)) = (serde_json::to_value(before), serde_json::to_value(after)) {
        differences(place, &before, &after, losses);
    }
}

fn differences(place: &str, before: &Value, after: &Value, losses: &mut Vec<String>) {
    match (before, after) {
        _ if before == after => {}
        (Value::Object(before), Value::Object(after)) => {
            for (key, value) in before {
                let now = after.get(key).unwrap_or(&Value::Null);
                let at = match place {
                    "" => key.clone(),
                    place => format!("{place}.{key}"),
                };
                differences(&at, value, now, losses);
            }
        }
        _ => losses.push(tr!(
            "The setting {place} was out of bounds: found {found}; {instead}.",
            place,
            found = brief(before),
            instead = instead(Some(after))
        )),
    }
}

/// What is said of a piece that does not fit.
pub(super) fn not_understood(place: &str, found: &Value, stands: Option<&Value>) -> String {
    tr!(
        "The setting {place} was not understood: found {found}; {instead}.",
        place,
        found = brief(found),
        instead = instead(stands)
    )
}

fn instead(stands: Option<&Value>) -> String {
    match stands {
        None | Some(Value::Null) => said!("it is left out").to_owned(),
        Some(Value::Object(_)) => said!("the usual values stand instead").to_owned(),
        Some(value) => tr!("{value} stands instead", value = brief(value)),
    }
}

/// A value in a few letters.
fn brief(value: &Value) -> String {
    if let Value::String(text) = value {
        return quoted(text);
    }
    let text = value.to_string();
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text,
    }
}

/// Puts pieces into the tree of a value.
struct Mender<T> {
    tree: Value,
    losses: Vec<String>,
    /// The places that the losses tell of.
    told: Vec<Vec<String>>,
    reads: PhantomData<fn() -> T>,
}

impl<T: DeserializeOwned> Mender<T> {
    fn fits(&self) -> bool {
        T::deserialize(&self.tree).is_ok()
    }

    /// Puts what was found in its place, as far as it is understood.
    fn put(&mut self, place: &[String], found: &Value) {
        let usual = self.set(place, Some(found.clone()));
        if self.fits() {
            return;
        }
        match found {
            Value::Object(fields) if self.holds(place, emptied(usual.as_ref())) => {
                for (key, value) in fields {
                    self.put(&below(place, key), value);
                }
            }
            Value::Array(items) if self.holds(place, json!([])) => self.put_items(place, items),
            Value::Object(_) | Value::Array(_) if self.patched(place, found, usual.as_ref()) => {}
            _ => {
                self.set(place, usual.clone());
                self.tell(place, found, usual.as_ref());
            }
        }
    }

    fn tell(&mut self, place: &[String], found: &Value, stands: Option<&Value>) {
        let words = not_understood(&words_of(place), found, stands);
        self.losses.push(words);
        self.told.push(place.to_vec());
    }

    /// Tells of keys that were found and are not in what was read.
    fn tell_unknown(&mut self, place: &[String], found: &Value, read: &Value) {
        for (key, piece) in pieces(found) {
            let at = below(place, &key);
            match piece_of(read, &key) {
                Some(read) => self.tell_unknown(&at, piece, read),
                None if found.is_object() && read.is_object() && !self.told.contains(&at) => {
                    self.tell(&at, piece, None);
                }
                None => {}
            }
        }
    }

    fn holds(&mut self, place: &[String], value: Value) -> bool {
        self.set(place, Some(value));
        self.fits()
    }

    /// Adds the items of a list that fit. Halves are tried as a whole: a long list is not tried
    /// item by item for the sake of one.
    fn put_items(&mut self, place: &[String], items: &[Value]) {
        let Some(Value::Array(list)) = slot(&mut self.tree, place) else {
            return;
        };
        let before = list.len();
        list.extend_from_slice(items);
        if self.fits() {
            return;
        }
        if let Some(Value::Array(list)) = slot(&mut self.tree, place) {
            list.truncate(before);
        }
        match items {
            [item] => self.put(&below(place, &before.to_string()), item),
            items => {
                let (first, second) = items.split_at(items.len() / 2);
                self.put_items(place, first);
                self.put_items(place, second);
            }
        }
    }

    /// Whether it fits but for one of its pieces: that one alone is mended or left out.
    fn patched(&mut self, place: &[String], found: &Value, usual: Option<&Value>) -> bool {
        self.set(place, Some(found.clone()));
        for (key, piece) in pieces(found).into_iter().take(MOST_TRIED) {
            let at = below(place, &key);
            let usual = usual.and_then(|usual| piece_of(usual, &key)).cloned();
            let others = [usual, Some(json!({})), Some(json!([])), Some(Value::Null)];
            let mut others: Vec<_> = others.into_iter().filter(Option::is_some).collect();
            if found.is_object() {
                others.push(None);
            }
            for other in others {
                self.set(&at, other);
                if self.fits() {
                    self.put(&at, piece);
                    return true;
                }
            }
            self.set(&at, Some(piece.clone()));
        }
        false
    }

    /// Puts a value, or nothing, in its place; gives what stood there.
    fn set(&mut self, place: &[String], value: Option<Value>) -> Option<Value> {
        let Some((last, before)) = place.split_last() else {
            return value.map(|value| std::mem::replace(&mut self.tree, value));
        };
        match (slot(&mut self.tree, before)?, value) {
            (Value::Object(fields), Some(value)) => fields.insert(last.clone(), value),
            (Value::Object(fields), None) => fields.remove(last),
            (Value::Array(list), value) => {
                let index: usize = last.parse().ok()?;
                match value {
                    Some(value) if index < list.len() => {
                        Some(std::mem::replace(&mut list[index], value))
                    }
                    Some(value) => {
                        list.push(value);
                        None
                    }
                    None => (index < list.len()).then(|| list.remove(index)),
                }
            }
            _ => None,
        }
    }
}

fn slot<'v>(tree: &'v mut Value, place: &[String]) -> Option<&'v mut Value> {
    place.iter().try_fold(tree, |at, step| match at {
        Value::Object(fields) => fields.get_mut(step),
        Value::Array(list) => list.get_mut(step.parse::<usize>().ok()?),
        _ => None,
    })
}

fn below(place: &[String], step: &str) -> Vec<String> {
    let mut below = place.to_vec();
    below.push(step.to_owned());
    below
}

/// A place in words: numbers of items say nothing once some are left out.
fn words_of(place: &[String]) -> String {
    let names = place.iter().filter(|step| step.parse::<usize>().is_err());
    names.map(String::as_str).collect::<Vec<_>>().join(".")
}

/// What a group of fields starts from.
fn emptied(usual: Option<&Value>) -> Value {
    let group = usual.filter(|usual| usual.is_object());
    group.cloned().unwrap_or_else(|| json!({}))
}

fn pieces(value: &Value) -> Vec<(String, &Value)> {
    match value {
        Value::Object(fields) => fields.iter().map(|(k, v)| (k.clone(), v)).collect(),
        Value::Array(list) => {
            let numbered = list.iter().enumerate();
            numbered.map(|(i, v)| (i.to_string(), v)).collect()
        }
        _ => Vec::new(),
    }
}

fn piece_of<'v>(value: &'v Value, key: &str) -> Option<&'v Value> {
    match value {
        Value::Object(fields) => fields.get(key),
        Value::Array(list) => list.get(key.parse::<usize>().ok()?),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use serde::Deserialize;

    use super::*;

    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    #[serde(rename_all = "lowercase")]
    enum Word {
        Red,
        Green,
    }

    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    struct Needy {
        name: String,
        word: Option<Word>,
    }

    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    struct Whole {
        word: Word,
        number: f64,
        pair: [f64; 2],
        list: Vec<Word>,
        map: BTreeMap<String, Needy>,
        tuples: Vec<(String, u8)>,
        maybe: Option<Needy>,
    }

    fn usual() -> Whole {
        Whole {
            word: Word::Red,
            number: 7.0,
            pair: [1.0, 2.0],
            list: vec![Word::Red],
            map: BTreeMap::new(),
            tuples: Vec::new(),
            maybe: None,
        }
    }

    fn read(found: Value) -> (Value, Vec<String>) {
        let mut losses = Vec::new();
        let Value::Object(found) = found else {
            panic!("a group");
        };
        let whole = mended(usual(), found, &mut losses);
        (serde_json::to_value(whole).expect("plain"), losses)
    }

    /// The found value with one change, or the usual one where nothing was found.
    fn with(change: impl FnOnce(&mut Value)) -> Value {
        let mut value = json!({
            "word": "green", "number": 1, "pair": [3.0, 4.0], "list": ["green", "red"],
            "map": {"a/b": {"name": "x", "word": "red"}},
            "tuples": [["t", 1], ["u", 2]], "maybe": {"name": "m", "word": null},
        });
        change(&mut value);
        value
    }

    #[test]
    fn what_is_sound_is_read_as_it_is() {
        let (value, losses) = read(with(|_| {}));
        assert_eq!(value["number"], 1.0);
        assert_eq!(
            value,
            with(|v| v["number"] = 1.0.into()),
            "and nothing is added"
        );
        assert!(losses.is_empty(), "{losses:?}");
        assert_eq!(
            read(json!({})).0,
            serde_json::to_value(usual()).expect("plain")
        );
    }

    #[test]
    fn each_piece_that_does_not_fit_costs_itself_alone_and_is_named() {
        type Case = (fn(&mut Value), fn(&mut Value), &'static str);
        let cases: [Case; 9] = [
            (
                |v| v["word"] = "blue".into(),
                |v| v["word"] = "red".into(),
                "The setting word was not understood: found \"blue\"; \"red\" stands instead.",
            ),
            (
                |v| v["number"] = json!(["x"]),
                |v| v["number"] = 7.0.into(),
                "number was not understood: found [\"x\"]; 7.0 stands instead",
            ),
            (
                |v| v["pair"][1] = "x".into(),
                |v| v["pair"][1] = 2.0.into(),
                "pair was not understood: found \"x\"; 2.0 stands instead",
            ),
            (
                |v| v["pair"] = json!([1.0]),
                |v| v["pair"] = json!([1.0, 2.0]),
                "pair was not understood: found [1.0]; [1.0,2.0] stands instead",
            ),
            (
                |v| v["list"] = json!(["green", "blue", "red"]),
                |v| v["list"] = json!(["green", "red"]),
                "list was not understood: found \"blue\"; it is left out",
            ),
            (
                |v| v["map"]["a/b"]["word"] = "blue".into(),
                |v| v["map"]["a/b"]["word"] = Value::Null,
                "map.a/b.word was not understood: found \"blue\"; it is left out",
            ),
            (
                |v| v["map"]["a/b"]["name"] = 5.into(),
                |v| v["map"] = json!({}),
                "map.a/b was not understood: found {\"name\":5,\"word\":\"red\"}; it is left out",
            ),
            (
                |v| v["tuples"][0] = json!(["t", 1000]),
                |v| v["tuples"] = json!([["u", 2]]),
                "tuples was not understood: found [\"t\",1000]; it is left out",
            ),
            (
                |v| v["maybe"]["word"] = "blue".into(),
                |v| v["maybe"]["word"] = Value::Null,
                "maybe.word was not understood: found \"blue\"; it is left out",
            ),
        ];
        for (damage, left, words) in cases {
            let (value, losses) = read(with(damage));
            let expected = with(|v| {
                v["number"] = 1.0.into();
                left(v);
            });
            assert_eq!(value, expected);
            assert_eq!(losses.len(), 1, "{losses:?}");
            assert!(losses[0].contains(words), "{losses:?} for {words}");
        }
    }

    #[test]
    fn several_pieces_at_once_are_each_named() {
        let (value, losses) = read(json!({
            "word": 5, "number": "x", "list": "y", "map": [], "novel": {"of": "a newer version"},
        }));
        assert_eq!(value, serde_json::to_value(usual()).expect("plain"));
        assert_eq!(losses.len(), 5, "{losses:?}");
        assert!(losses[4].contains("novel"), "{losses:?}");
    }

    #[test]
    fn a_long_list_with_a_few_bad_items_is_read_but_for_those() {
        let mut list = vec![json!("green"); 20_000];
        list[7] = json!(5);
        list[19_999] = json!("blue");
        let (value, losses) = read(json!({ "list": list }));
        assert_eq!(value["list"].as_array().map(Vec::len), Some(19_998));
        assert_eq!(losses.len(), 2);
    }

    #[test]
    fn what_was_moved_is_told_leaf_by_leaf() {
        let mut losses = Vec::new();
        let after = Whole {
            number: 1.0,
            ..usual()
        };
        moved("place", &usual(), &after, &mut losses);
        let words = "The setting place.number was out of bounds: found 7.0; 1.0 stands instead.";
        assert_eq!(losses, [words]);
    }
}
