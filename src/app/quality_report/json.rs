//! A light's figures as JSON, with the keys of the command `light`.
//!
//! A figure that does not exist is `null`, and `notes` says why, behind its key and those of what
//! is measured with it.

use serde_json::{Map, Value, json};

use crate::{
    app::{cells::put, figures::OF_QUALITY},
    color::quality::{Figures, HueBin, NoFigure},
};

/// An object that stands even where none of its figures exists.
const ALWAYS: &str = "ssi";

/// Keys that share a note where they share its reason, in the order of notes; those in none of the
/// lists have notes of their own at the place of the empty one.
const TOGETHER: [&[&str]; 7] = [
    &["cct", "duv"],
    &["ra", "r"],
    &["rf", "rg", "hue_bins"],
    &["dominant_nm", "purity"],
    &["melanopic_der", "alphaopic"],
    &[],
    &[
        "ssi.reference",
        "ssi.value",
        "ssi.p3200",
        "ssi.d55",
        "ssi.d65",
    ],
];

/// A light and its model, if there is one; every key is present, `null` where there is no figure.
pub fn json(name: &str, measured: &Figures, model: Option<&Figures>) -> Value {
    beside(measured, model, |figures| of(name, figures, false))
}

/// As [`json()`] with what has no key there: all observers, single samples, shape, absolute values.
pub fn full_json(name: &str, measured: &Figures, model: Option<&Figures>) -> Value {
    beside(measured, model, |figures| {
        let mut object = of(name, figures, true);
        let reasons = super::rows(figures).into_iter();
        let reasons = reasons
            .filter_map(|row| Some(json!({ "key": row.figure.key, "why": row.value.err()? })));
        object["reasons"] = reasons.collect();
        object
    })
}

fn beside(measured: &Figures, model: Option<&Figures>, of: impl Fn(&Figures) -> Value) -> Value {
    let mut object = of(measured);
    object["model"] = model.map_or(Value::Null, of);
    object
}

fn of(name: &str, figures: &Figures, all: bool) -> Value {
    let mut found = Found::default();
    for row in OF_QUALITY.iter().filter(|row| all || !row.is_detail) {
        let applies = (row.applies)(figures);
        let value = applies.then(|| row.value(figures));
        for path in row.json {
            let others = OF_QUALITY.iter().filter(|row| row.json.contains(path));
            let is_list = others.filter(|row| (row.applies)(figures)).count() > 1;
            match &value {
                Some(value) => {
                    found.take(path, is_list, value.clone().map(Value::from), row.is_detail)
                }
                None => found.leave_open(path),
            }
        }
    }
    for other in OTHER_VALUES.iter().filter(|other| all || !other.is_detail) {
        found.take(other.json, false, (other.of)(figures), other.is_detail);
    }
    let reasons = found.notes();
    let mut object = found.object;
    for (key, value) in &mut object {
        let is_empty = match value {
            Value::Object(parts) => key != ALWAYS && parts.values().all(Value::is_null),
            Value::Array(parts) => parts.iter().all(Value::is_null),
            _ => false,
        };
        if is_empty {
            *value = Value::Null;
        }
    }
    let notes: Vec<String> = figures.notes.iter().cloned().chain(reasons).collect();
    object.insert("name".to_owned(), json!(name));
    object.insert("notes".to_owned(), json!(notes));
    Value::Object(object)
}

/// A value of JSON that is no single number.
struct OtherValue {
    json: &'static str,
    /// In JSON only where everything is asked for.
    is_detail: bool,
    of: fn(&Figures) -> Result<Value, NoFigure>,
}

const fn other(
    json: &'static str,
    is_detail: bool,
    of: fn(&Figures) -> Result<Value, NoFigure>,
) -> OtherValue {
    OtherValue {
        json,
        is_detail,
        of,
    }
}

/// Values of JSON beside the figures.
///
/// Hue bins are points of the vector graphic: mean a'b' under test and reference over the chroma
/// of the mean reference point, so that `reference_ab` lies on the unit circle.
static OTHER_VALUES: &[OtherValue] = &[
    other("hue_bins", false, |f| {
        let found = f.fidelity.as_ref().map_err(Clone::clone)?;
        Ok(found
            .bins
            .iter()
            .map(|bin| bin.as_ref().map(bin_json))
            .collect())
    }),
    other("ssi.reference", false, |f| {
        Ok(json!(f.similarity.clone()?.of_cct?.0.to_string()))
    }),
    other("peak_nm", true, |f| Ok(json!(f.shape.clone()?.peak?.nm))),
    other("xy_1964", true, |f| Ok(json!(f.xy[1].clone()?))),
    other("xy_2015_2", true, |f| Ok(json!(f.xy[2].clone()?))),
    other("xy_2015_10", true, |f| Ok(json!(f.xy[3].clone()?))),
    other("rf_samples", true, |f| {
        Ok(json!(
            f.fidelity
                .as_ref()
                .map_err(Clone::clone)?
                .samples
                .as_slice()
        ))
    }),
    other("alphaopic_elr", true, |f| {
        Ok(json!(f.alpha_opic.clone()?.elr))
    }),
    other("absolute.quantity", true, |f| {
        Ok(json!(f.absolute.clone()?.what.photometric_name()))
    }),
    other("absolute.unit", true, |f| {
        Ok(json!(f.absolute.clone()?.what.photometric_unit()))
    }),
];

fn bin_json(bin: &HueBin) -> Value {
    let HueBin {
        rf,
        rcs,
        rhs,
        test_ab,
        reference_ab,
        samples: _,
        test_xyz: _,
        reference_xyz: _,
    } = bin;
    json!({
        "rf": rf,
        "rcs": rcs,
        "rhs": rhs,
        "test_ab": test_ab,
        "reference_ab": reference_ab,
    })
}

/// The values by their places, and the reasons for what is `null` by their keys.
#[derive(Default)]
struct Found {
    object: Map<String, Value>,
    reasons: Vec<(&'static str, NoFigure)>,
}

impl Found {
    fn take(
        &mut self,
        path: &'static str,
        is_list: bool,
        value: Result<Value, NoFigure>,
        is_detail: bool,
    ) {
        let value = value.unwrap_or_else(|why| {
            if !is_detail {
                self.explain(path, why);
            }
            Value::Null
        });
        if !is_list {
            return self.put(path, value);
        }
        let list = self.object.entry(path).or_insert_with(|| json!([]));
        if let Value::Array(list) = list {
            list.push(value);
        }
    }

    /// `null` where no other figure stands.
    fn leave_open(&mut self, path: &str) {
        if self.value_at(path).is_none() {
            self.put(path, Value::Null);
        }
    }

    fn value_at(&self, path: &str) -> Option<&Value> {
        let (key, rest) = path.split_once('.').unwrap_or((path, ""));
        let value = self.object.get(key)?;
        if rest.is_empty() {
            Some(value)
        } else {
            value.get(rest)
        }
    }

    fn put(&mut self, path: &str, value: Value) {
        let mut whole = Value::Object(std::mem::take(&mut self.object));
        put(&mut whole, path, value);
        if let Value::Object(object) = whole {
            self.object = object;
        }
    }

    fn explain(&mut self, path: &'static str, why: NoFigure) {
        let key = path.split('.').next().filter(|key| *key != ALWAYS);
        let key = key.unwrap_or(path);
        if self.reasons.iter().all(|(known, _)| *known != key) {
            self.reasons.push((key, why));
        }
    }

    /// A sentence for each reason.
    fn notes(&self) -> Vec<String> {
        let mut notes = Vec::new();
        for group in TOGETHER {
            if group.is_empty() {
                let alone = self.reasons.iter();
                let alone = alone.filter(|(key, _)| !TOGETHER.iter().any(|all| all.contains(key)));
                notes.extend(alone.map(|(key, why)| format!("{key}: {why}")));
            }
            let why_of = |key| self.reasons.iter().find(|(known, _)| *known == key);
            let mut left: Vec<_> = group.iter().filter_map(|key| why_of(*key)).collect();
            while let Some((_, why)) = left.first().copied() {
                let is_same = |(_, other): &&(&str, NoFigure)| other == why;
                let (same, others): (Vec<_>, Vec<_>) = left.into_iter().partition(is_same);
                let keys: Vec<&str> = same.iter().map(|(key, _)| *key).collect();
                let is_whole = keys.len() == group.len() && group[0].starts_with(ALWAYS);
                let keys = if is_whole {
                    ALWAYS.to_owned()
                } else {
                    keys.join(", ")
                };
                notes.push(format!("{keys}: {why}"));
                left = others;
            }
        }
        notes
    }
}
