//! Two lights compared, with the keys of the command `light --against`.

use serde_json::{Value, json as object};

use super::{better::Better, compared::Compared, rule::Which};

/// A comparison beside the figures of both lights, which are handed in as JSON.
pub fn json(compared: &Compared, [a, b]: [Value; 2]) -> Value {
    let better: Vec<Value> = compared.better.iter().map(of).collect();
    object!({
        "better": better,
        "summary": compared.summary,
        "notes": compared.notes,
        "a": a,
        "b": b,
    })
}

fn of(better: &Better) -> Value {
    let [a, b] = better.values;
    object!({
        "for": better.purpose.key,
        "a": a,
        "b": b,
        "which": better.which.map(Which::word),
        "words": better.words,
    })
}
