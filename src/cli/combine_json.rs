//! The result of `combine` as JSON.

use serde_json::{Map, Value, json};

use crate::{
    app::{
        combining::{Found, LineRow, ScanRow},
        instruments,
    },
    measurements::{Feature, Measurement, Part},
};

/// All that was found, with stable keys.
pub(super) fn json(found: &Found) -> Value {
    let mut all = keys(found);
    let (mut notes, rest) = found.notes();
    notes.extend(rest);
    all.insert("notes".to_owned(), notes.into());
    Value::Object(all)
}

/// All keys but the notes.
pub(super) fn keys(found: &Found) -> Map<String, Value> {
    let mut all = Map::new();
    if let Some(result) = &found.result {
        of_result(found, result, &mut all);
    }
    if !found.scans.is_empty() {
        let rows: Vec<Value> = found.scans.iter().map(scan).collect();
        all.insert("scans".to_owned(), rows.into());
    }
    if let Some(drift) = found.drift {
        let drift = json!({ "per_scan": drift.per_scan, "p": drift.p });
        all.insert("drift".to_owned(), drift);
    }
    if let Some(splice) = &found.splice {
        let splice = json!({
            "factor": splice.factor,
            "u": splice.u,
            "slope": splice.slope,
            "shift_nm": splice.shift_nm,
        });
        all.insert("splice".to_owned(), splice);
    }
    if let Some((changed, words)) = &found.changed {
        let part = |(part, what): (&Part, &String)| {
            let at_nm = match part.feature {
                Feature::Line(at) => Some(at),
                _ => None,
            };
            json!({
                "what": what,
                "at_nm": at_nm,
                "change": part.change,
                "u": part.u,
                "p": part.p,
            })
        };
        let parts: Vec<Value> = changed.parts.iter().zip(words).map(part).collect();
        let least = Some(changed.least_seen_percent).filter(|least| least.is_finite());
        let changed = json!({
            "verdict": changed.verdict.word(),
            "parts": parts,
            "least_seen_percent": least,
        });
        all.insert("changed".to_owned(), changed);
    }
    if let Some(instrument) = &found.instrument {
        all.insert("instrument".to_owned(), instruments::keys(instrument));
    }
    all
}

fn scan(scan: &ScanRow) -> Value {
    json!({
        "name": scan.name,
        "level": scan.level,
        "shift_nm": scan.shift_nm,
        "residual": scan.residual,
        "kept": scan.is_kept,
        "why": scan.why,
    })
}

fn line(line: &LineRow) -> Value {
    json!({
        "at_nm": line.at_nm,
        "weight": line.weight,
        "share": line.share,
        "u_at_nm": line.u[0],
        "u_weight": line.u[1],
        "u_share": line.u[2],
        "certain": line.is_certain,
    })
}

/// The keys of the spectrum that was made.
fn of_result(found: &Found, result: &Measurement, all: &mut Map<String, Value>) {
    let samples = &result.samples;
    let sigma = result.sigma.as_ref().map(|sigma| {
        let each = sigma.iter().enumerate();
        let kept = each.map(|(i, s)| result.is_kept(i).then_some(*s));
        kept.collect::<Vec<_>>()
    });
    let masked: Vec<Value> = result
        .masked()
        .iter()
        .map(|m| json!({ "from_nm": m.from_nm, "to_nm": m.to_nm, "why": m.why }))
        .collect();
    let memory: Vec<f64> = std::iter::once(1.0)
        .chain(result.memory.iter().copied())
        .collect();
    let keys = json!({
        "result": {
            "name": result.name,
            "quantity": result.quantity.word(),
            "kind": result.quantity.kind().word(),
            "unit": result.unit,
            "points": samples.len(),
            "first_nm": samples.first_nm(),
            "last_nm": samples.last_nm(),
            "scans": result.scans,
        },
        "wavelengths": samples.nm(),
        "values": result.kept_values(),
        "sigma": sigma,
        "masked": masked,
        "doubt": {
            "level": result.level,
            "axis_nm": result.axis_nm,
            "memory": memory,
            "from": found.doubt_from,
        },
        "figures": figures(found),
        "lines": found.lines.iter().map(line).collect::<Vec<_>>(),
        "slit": slit(found, result),
    });
    if let Value::Object(keys) = keys {
        all.extend(keys);
    }
    let readings = found.reading.keys().into_iter();
    all.extend(readings.map(|(key, value)| (key.to_owned(), value)));
    if let Some(intervals) = &found.intervals {
        all.insert("interval_95".to_owned(), json!(intervals));
    }
}

fn figures(found: &Found) -> Value {
    let Some((all, _)) = found.figures() else {
        return Value::Null;
    };
    let number = |v: f64| Some(v).filter(|v| v.is_finite());
    let each = all.iter().map(|doubted| {
        let value = doubted.doubt.map(|d| {
            json!({
                "value": d.value,
                "u": number(d.u),
                // Stated doubt has no end of degrees.
                "dof": Some(d.dof).filter(|dof| *dof < 1e15),
                "half_width_95": number(d.half_width_95),
                "bias": d.bias,
            })
        });
        (
            doubted.figure.key().to_owned(),
            value.unwrap_or(Value::Null),
        )
    });
    Value::Object(each.collect())
}

/// The slit that was found, with its lines; else the one that the result was seen through.
fn slit(found: &Found, result: &Measurement) -> Value {
    if let Some(found) = &found.slit {
        let lines = found.lines.iter().map(|line| {
            json!({
                "name": format!("{} {:.1}", line.symbol, line.nm),
                "at_nm": line.nm,
                "fwhm_nm": line.fwhm_nm,
                "shift_nm": line.shift_nm,
            })
        });
        return json!({
            "fwhm_nm": found.slit.fwhm_nm,
            "u": Some(found.u).filter(|u| *u > 0.0),
            "shape": found.slit.shape.word(),
            "lines": lines.collect::<Vec<_>>(),
            "shift_nm": found.shift_nm,
        });
    }
    match result.slit {
        Some(slit) => json!({
            "fwhm_nm": slit.fwhm_nm,
            "u": null,
            "shape": slit.shape.word(),
            "lines": [],
            "shift_nm": null,
        }),
        None => Value::Null,
    }
}
