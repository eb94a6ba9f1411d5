//! `--repeats` of `light` and `report`: all inputs are scans of one light.

use std::ffi::OsString;

use serde_json::{Map, Value};

use super::{
    arguments::Stated, combine_inputs::read, combine_json, inputs::Inputs, refusal::Refusal,
};
use crate::{
    app::{
        Entry,
        combining::{Act, Found, words::doubt_words},
        measured::spectrum,
        readings::Reading,
    },
    spectrum::Kind,
};

/// The mean of scans, with all that is known of its doubt.
pub(super) struct Scans {
    pub entry: Entry,
    pub found: Found,
}

impl Scans {
    /// The mean of all that some words mean.
    ///
    /// # Errors
    /// [`Refusal`] for what cannot be read or taken together, and for what is no light.
    pub(super) fn of<'w>(
        words: impl Iterator<Item = &'w OsString>,
        stated: Stated,
        inputs: &mut Inputs,
    ) -> Result<Self, Refusal> {
        let mut parts = Vec::new();
        for word in words {
            parts.extend(read(word, true, stated, inputs)?);
        }
        let mean = Act::Mean { keep_all: false };
        let found = mean.of(&parts).map_err(Refusal::File)?;
        let mut made = spectrum(found.result(), &found.made_by);
        if parts.len() > 1 {
            made.name = mean.name(&parts);
        }
        if made.kind == Kind::Other {
            // Counts: told as a light that has no figures.
            made.kind = Kind::Light;
        }
        if made.kind != Kind::Light {
            return Err(Refusal::File(format!(
                "INPUT: found {}, expected scans of a light",
                found.result().quantity
            )));
        }
        Ok(Self {
            entry: Entry::own(1, made),
            found,
        })
    }

    /// A command's JSON with the keys of the doubt.
    pub(super) fn json(&self, told: Value) -> Value {
        with_keys(told, combine_json::keys(&self.found), &self.found)
    }

    /// What the doubt is in words.
    pub(super) fn words(&self) -> String {
        let mut text = doubt_words(&self.found, self.found.result());
        let (own, rest) = self.found.notes();
        for note in own.iter().chain(&rest) {
            text += &format!("Note      {note}\n");
        }
        text
    }
}

fn with_keys(told: Value, keys: Map<String, Value>, found: &Found) -> Value {
    let told = without_figures(told, &found.reading);
    let Value::Object(mut all) = told else {
        return told;
    };
    let mut notes = match all.remove("notes") {
        Some(Value::Array(notes)) => notes,
        _ => Vec::new(),
    };
    let (own, rest) = found.notes();
    let more: Vec<Value> = own
        .into_iter()
        .chain(rest)
        .map(Value::from)
        .filter(|note| !notes.contains(note))
        .collect();
    notes.extend(more);
    all.extend(keys);
    all.insert("notes".to_owned(), notes.into());
    Value::Object(all)
}

/// What `light` tells of a reading: with the keys of counts and cut tops, and without figures where
/// those would be an instrument's response.
pub(super) fn without_figures(mut told: Value, reading: &Reading) -> Value {
    let Some(object) = told.as_object_mut() else {
        return told;
    };
    if reading.has_no_figures() {
        let kept = [
            "name", "notes", "program", "input", "settings", "model", "error",
        ];
        for (key, value) in object.iter_mut() {
            if !kept.contains(&key.as_str()) {
                *value = Value::Null;
            }
        }
        if let Some(model) = object.get_mut("model") {
            // The model of a report is a series, that of a light figures.
            if model.get("coefficients").is_none() {
                *model = Value::Null;
            }
        }
        if let Some(input) = object.get_mut("input").and_then(Value::as_object_mut) {
            add_notes(input, reading);
        }
    }
    add_notes(object, reading);
    object.extend(reading.keys().map(|(key, value)| (key.to_owned(), value)));
    told
}

/// Puts what is said of a reading before the other notes.
fn add_notes(object: &mut Map<String, Value>, reading: &Reading) {
    if let Some(Value::Array(notes)) = object.get_mut("notes") {
        let mut all: Vec<Value> = reading.sentences().into_iter().map(Value::from).collect();
        if reading.has_no_figures() {
            // The reasons of figures that are not told.
            notes.clear();
        }
        all.append(notes);
        *notes = all;
    }
}
