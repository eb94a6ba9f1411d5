//! A picture and its peers as JSON.

use serde::Serialize;
use serde_json::{Value, json};

use super::lines::Line;
use super::measure::Errors;
use super::peers::Peer;
use super::{Operator, Trust};

/// Bytes of a picture in each form.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Bytes {
    /// Of the full form.
    pub full: Option<u64>,
    /// Of the compact form.
    pub compact: Option<u64>,
    /// Of the exact picture as spectral OpenEXR, half, ZIP.
    pub exact: Option<u64>,
}

fn errors(error: &Errors) -> Value {
    json!({"own": error.own, "lights": error.lights, "relative_rms": error.relative_rms})
}

/// Summary of a picture in few numbers: `picture IN --json`.
pub(crate) fn picture_json(
    operator: &Operator,
    bytes: Bytes,
    error: &Errors,
    noise: f64,
    trust: Option<&Trust>,
) -> Value {
    let plan = operator.plan();
    let line = |line: &Line| json!({"at_nm": line.at_nm, "share": line.share});
    json!({
        "numbers": plan.numbers(),
        "reference": {"kind": plan.reference.kind, "name": plan.reference.name},
        "lines": plan.lines.iter().map(line).collect::<Value>(),
        "bytes": bytes,
        "error": errors(error),
        "noise": noise,
        "trust": trust.map(|t| json!({
            "blind": t.blind, "noise": t.noise, "verdict": t.verdict.word(), "words": t.words(),
        })),
    })
}

/// The table of peers: `picture IN --peers --json`.
pub(crate) fn peers_json(peers: &[Peer]) -> Value {
    let rows = peers.iter().map(|peer| {
        json!({
            "name": peer.name,
            "numbers": peer.numbers,
            "bytes": peer.bytes,
            "error": peer.error.as_ref().map(errors),
            "said": peer.description,
        })
    });
    json!({"peers": rows.collect::<Value>()})
}
