//! The result of `combine` in words and as JSON.

use std::fmt::Write as _;

use serde_json::{Map, Value, json};

use crate::{
    app::measured::is_light,
    app::ticks::short,
    measurements::{
        Changed, Doubted, Drift, Feature, Figure, Measurement, Part, Quantity, Spliced, Verdict,
        doubts, rounded,
    },
};

/// One scan of a mean.
pub(super) struct ScanRow {
    pub name: String,
    /// Its level less that of the mean, a share.
    pub level: f64,
    pub shift_nm: f64,
    pub residual: f64,
    /// Why it does not belong to the others.
    pub why: Option<String>,
}

/// What `combine` found.
pub(super) struct Found {
    /// The spectrum that was made; none where two sets were compared.
    pub result: Option<Measurement>,
    pub made_by: String,
    /// Where its doubt is from: repeats, residuals, stated.
    pub doubt_from: &'static str,
    pub scans: Vec<ScanRow>,
    pub drift: Option<Drift>,
    pub splice: Option<Spliced>,
    pub changed: Option<Changed>,
    pub notes: Vec<String>,
    /// Finest step of the inputs, nm.
    pub step_nm: f64,
    /// Wavelengths of the inputs, as --grid names them.
    pub first_nm: Vec<Vec<f64>>,
}

/// Where counts are no light.
const COUNTS: &str = "Counts, not light: the instrument's response is still in it. Correct with a \
                      known light.";

/// What a doubt is of where nothing but the readings' own noise is known.
const NOISE_ONLY: &str = "\u{b1} is of the noise alone: what level and wavelengths are known to was \
                          not stated (--level, --axis).";

impl Found {
    /// A spectrum and nothing beside it.
    pub(super) fn of(result: Measurement, made_by: String, doubt_from: &'static str) -> Self {
        Self {
            step_nm: result.samples.step_nm(),
            result: Some(result),
            made_by,
            doubt_from,
            scans: Vec::new(),
            drift: None,
            splice: None,
            changed: None,
            notes: Vec::new(),
            first_nm: Vec::new(),
        }
    }

    /// What differs between two sets.
    pub(super) fn of_change(changed: Changed) -> Self {
        Self {
            result: None,
            made_by: String::new(),
            doubt_from: "repeats",
            scans: Vec::new(),
            drift: None,
            splice: None,
            notes: vec![sentence(&changed)],
            changed: Some(changed),
            step_nm: 0.0,
            first_nm: Vec::new(),
        }
    }

    /// The spectrum that was made.
    ///
    /// # Panics
    /// For a comparison, which makes none and is told before any is asked for.
    pub(super) fn result(&self) -> &Measurement {
        self.result.as_ref().expect("a spectrum was made")
    }
}

/// Figures of a light with their doubt; none where some of it is missing or it is no light.
fn figures(of: &Measurement) -> Option<Vec<Doubted>> {
    is_light(of).then(|| doubts(of))
}

/// All that was found, with stable keys.
pub(super) fn json(found: &Found) -> Value {
    let mut all = Map::new();
    let mut notes = found.notes.clone();
    if let Some(result) = &found.result {
        of_result(found, result, &mut all, &mut notes);
    }
    if !found.scans.is_empty() {
        let row = |scan: &ScanRow| {
            json!({
                "name": scan.name,
                "level": scan.level,
                "shift_nm": scan.shift_nm,
                "residual": scan.residual,
                "kept": true,
                "why": scan.why,
            })
        };
        let rows: Vec<Value> = found.scans.iter().map(row).collect();
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
    if let Some(changed) = &found.changed {
        let part = |part: &Part| {
            let at_nm = match part.feature {
                Feature::Line(at) => Some(at),
                _ => None,
            };
            json!({
                "what": part.feature.to_string(),
                "at_nm": at_nm,
                "change": part.change,
                "u": part.u,
                "p": part.p,
            })
        };
        let parts: Vec<Value> = changed.parts.iter().map(part).collect();
        let changed = json!({
            "verdict": changed.verdict.word(),
            "parts": parts,
            "least_seen_percent": changed.least_seen_percent,
        });
        all.insert("changed".to_owned(), changed);
    }
    all.insert("notes".to_owned(), notes.into());
    Value::Object(all)
}

/// The keys of the spectrum that was made.
fn of_result(
    found: &Found,
    result: &Measurement,
    all: &mut Map<String, Value>,
    notes: &mut Vec<String>,
) {
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
    let is_counts = result.quantity == Quantity::Counts;
    let figures = figures(result).map(|all| {
        let each = all.iter().map(|doubted| {
            let value = doubted.doubt.map(|d| {
                json!({
                    "value": d.value,
                    "u": d.u,
                    // Stated doubt has no end of degrees.
                    "dof": Some(d.dof).filter(|dof| *dof < 1e15),
                    "half_width_95": d.half_width_95,
                    "bias": d.bias,
                })
            });
            (
                doubted.figure.key().to_owned(),
                value.unwrap_or(Value::Null),
            )
        });
        Value::Object(each.collect())
    });
    if is_counts {
        notes.push(COUNTS.to_owned());
    }
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
        "figures": figures,
        "counts": { "is": is_counts, "why": is_counts.then_some(COUNTS) },
        "slit": result.slit.map(|slit| json!({ "fwhm_nm": slit.fwhm_nm, "shape": slit.shape.word() })),
    });
    if let Value::Object(keys) = keys {
        all.extend(keys);
    }
}

/// All that was found, in words.
pub(super) fn text(found: &Found) -> String {
    let mut text = String::new();
    if let Some(result) = &found.result {
        words_of(found, result, &mut text);
    }
    for scan in &found.scans {
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "Scan      {}: level {:+.2} %, moved {:+.3} nm",
            scan.name,
            100.0 * scan.level,
            scan.shift_nm
        );
    }
    for note in &found.notes {
        let _ = writeln!(text, "Note      {note}");
    }
    text
}

fn words_of(found: &Found, result: &Measurement, text: &mut String) {
    let samples = &result.samples;
    let unit = match result.unit.as_str() {
        "" => String::new(),
        unit => format!(", {unit}"),
    };
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "{}\n{}{unit}, {} points, {}-{} nm",
        found.made_by,
        result.quantity,
        samples.len(),
        samples.first_nm(),
        samples.last_nm()
    );
    let kept = result.kept_values();
    let kept: Vec<f64> = kept.into_iter().flatten().collect();
    let most = kept.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let least = kept.iter().copied().fold(f64::INFINITY, f64::min);
    let _ = writeln!(text, "Values    {} to {}", short(least), short(most));
    if result.level > 0.0 || result.axis_nm > 0.0 {
        let (level, axis) = (100.0 * result.level, result.axis_nm);
        let _ = writeln!(
            text,
            "Doubt     level {level:.2} %, axis {axis:.3} nm ({})",
            found.doubt_from
        );
    }
    match figures(result) {
        Some(all) => {
            for doubted in &all {
                let _ = writeln!(text, "{}", in_words(doubted));
            }
            let of = |d: &Doubted| {
                d.doubt
                    .as_ref()
                    .is_some_and(|doubt| doubt.half_width_95 > 0.0)
            };
            if all.iter().any(of) && result.level == 0.0 && result.axis_nm == 0.0 {
                let _ = writeln!(text, "Note      {NOISE_ONLY}");
            }
        }
        None if result.quantity == Quantity::Counts => {
            let _ = writeln!(text, "Note      {COUNTS}");
        }
        None => {}
    }
}

/// `CCT       4224 ± 11 K`.
fn in_words(doubted: &Doubted) -> String {
    let name = doubted.figure.words();
    let Some(doubt) = doubted.doubt else {
        return format!("{name:<9} -");
    };
    let unit = if doubted.figure == Figure::Cct {
        " K"
    } else {
        ""
    };
    let value = match doubted.figure {
        // An index is shown cut at its top.
        Figure::Ra | Figure::R9 | Figure::Rf => doubt.value.min(100.0),
        _ => doubt.value,
    };
    if doubt.half_width_95 <= 0.0 {
        return format!("{name:<9} {}{unit}", short(value));
    }
    let (value, half) = rounded(value, doubt.half_width_95);
    format!("{name:<9} {value} ± {half}{unit}")
}

/// What differs, in a sentence.
fn sentence(changed: &Changed) -> String {
    let percent = |part: &Part| {
        let (change, u) = rounded(100.0 * part.change, 196.0 * part.u);
        let place = match part.feature {
            Feature::Line(at) => format!(" at {at:.1} nm"),
            _ => String::new(),
        };
        let sign = if part.change > 0.0 { "+" } else { "" };
        format!("{}{place} {sign}{change} ± {u} %", part.feature)
    };
    let parts: Vec<String> = changed.parts.iter().map(percent).collect();
    match changed.verdict {
        Verdict::Different => format!("Different: {}.", parts.join(", ")),
        Verdict::Same => {
            let level = match parts.first() {
                Some(level) => format!(" ({level})"),
                None => String::new(),
            };
            format!(
                "Same{level}: no difference beyond the noise (a part would have to change by {:.1} %).",
                changed.least_seen_percent
            )
        }
    }
}
