//! What the values of a CGATS table are.

use super::bands::Bands;
use super::tables::CgatsTable;
use crate::io::Input;
use crate::io::error::quoted;
use crate::io::interpret::kinds::{is_plain_name, kind_of_name, kind_of_words};
use crate::io::reading::decision::Decision;
use crate::spectrum::Kind;

/// A kind, the unit of a light, and what is to be said of it.
pub(super) struct Quantity<'a> {
    pub kind: Decision<Kind>,
    pub unit: &'a str,
    pub note: Option<String>,
}

impl<'a> Quantity<'a> {
    /// One that the file states.
    fn stated(kind: Kind, unit: &'a str) -> Self {
        Self {
            unit,
            ..Decision::of_format(kind).into()
        }
    }
}

impl From<Decision<Kind>> for Quantity<'_> {
    fn from(kind: Decision<Kind>) -> Self {
        Self {
            kind,
            unit: "",
            note: None,
        }
    }
}

/// What Argyll's `MEAS_TYPE` and the words of others say.
fn stated_kind(value: &str) -> Option<(Kind, &'static str)> {
    let value = value.to_uppercase();
    let has = |word: &str| value.contains(word);
    Some(if has("AMBIENT") && has("FLASH") {
        (Kind::Light, "mW s m-2 nm-1")
    } else if has("AMBIENT") || has("IRRADIAN") {
        (Kind::Light, "mW m-2 nm-1")
    } else if has("FLASH") {
        (Kind::Light, "mW s m-2 sr-1 nm-1")
    } else if has("EMISS") || has("RADIANCE") {
        (Kind::Light, "mW m-2 sr-1 nm-1")
    } else if has("REFLECT") {
        (Kind::Reflectance, "")
    } else if has("TRANSMI") {
        (Kind::Transmittance, "")
    } else if has("SENSITIV") {
        (Kind::Weighting, "")
    } else {
        return None;
    })
}

/// Words of a description that name a light although no kind is stated.
const LIGHTS: [&str; 12] = [
    "illum", "light", "lamp", "daylight", "tungsten", "led", "d50", "d55", "d65", "d75", "power",
    "emission",
];

/// Words of a description that name samples.
const SAMPLES: [&str; 7] = [
    "sample", "chart", "checker", "paint", "paper", "target", "munsell",
];

/// What the values of a table are: as its keywords state, else as labels, descriptions or the
/// file's name tell, else by their size.
pub(super) fn quantity<'a>(
    input: &Input,
    table: &CgatsTable<'a>,
    group: &Bands,
    values: &[Vec<f64>],
) -> Quantity<'a> {
    stated_quantity(table).unwrap_or_else(|| {
        kind_of_labels(group)
            .or_else(|| kind_of_measurement(table))
            .or_else(|| kind_of_description(table))
            .unwrap_or_else(|| kind_of_rest(input, table, values))
            .into()
    })
}

/// What keywords state.
fn stated_quantity<'a>(table: &CgatsTable<'a>) -> Option<Quantity<'a>> {
    let own = table.key("KIND").filter(|_| table.is_own());
    if let Some(kind) = own.and_then(|word| Kind::ALL.into_iter().find(|k| k.word() == word)) {
        return Some(Quantity::stated(kind, table.key("UNIT").unwrap_or("")));
    }
    let argyll = table.number("SPECTRAL_NORM").is_none_or(|norm| norm == 1.0)
        && table
            .key("ORIGINATOR")
            .is_some_and(|v| v.contains("Argyll"));
    for key in ["MEAS_TYPE", "MEASUREMENT_TYPE", "MEASUREMENT_MODE", "TYPE"] {
        if let Some(value) = table.key(key)
            && let Some((kind, unit)) = stated_kind(value)
        {
            let unit = if argyll { unit } else { "" };
            let note = || format!("{unit} is Argyll's unit; the file states none");
            return Some(Quantity {
                note: (!unit.is_empty()).then(note),
                ..Quantity::stated(kind, unit)
            });
        }
    }
    if table.kind == "CCSS" {
        return Some(Quantity::stated(Kind::Light, "relative"));
    }
    let kind = match table.key("DEVICE_CLASS")? {
        "DISPLAY" => Kind::Light,
        "OUTPUT" | "INPUT" => Kind::Reflectance,
        _ => return None,
    };
    Some(Quantity::stated(kind, ""))
}

/// What the labels of the columns tell.
fn kind_of_labels(group: &Bands) -> Option<Decision<Kind>> {
    let word = group.word.to_uppercase();
    let starts = |starts: &[&str]| starts.iter().any(|start| word.starts_with(start));
    let kind = if starts(&["SPECTRAL_DEC", "SPECTRAL_PCT", "R|"]) {
        Kind::Reflectance
    } else if starts(&["T|"]) {
        Kind::Transmittance
    } else {
        return None;
    };
    Some(Decision::guessed(kind, true, "the columns' labels"))
}

/// What the way of measuring tells.
fn kind_of_measurement(table: &CgatsTable) -> Option<Decision<Kind>> {
    const KEYS: [&str; 3] = [
        "MEASUREMENT_SOURCE",
        "MEASUREMENT_GEOMETRY",
        "MEASUREMENT_CONDITIONS",
    ];
    KEYS.iter().find_map(|key| {
        let value = table.key(key).unwrap_or("");
        let kind = stated_kind(value).map(|s| s.0);
        let lower = value.to_lowercase();
        // A white that values are counted from makes them factors.
        let white = lower.contains("whitebase") || lower.contains("45/0") || lower.contains("d/8");
        let kind = kind.or(white.then_some(Kind::Reflectance))?;
        Some(Decision::guessed(kind, true, says(key, value)))
    })
}

/// What descriptions tell.
fn kind_of_description(table: &CgatsTable) -> Option<Decision<Kind>> {
    const KEYS: [&str; 4] = ["DESCRIPTOR", "DISPLAY", "FILE_DESCRIPTOR", "TARGET_NAME"];
    KEYS.iter().find_map(|key| {
        let value = table.key(key).unwrap_or("");
        let whole = value.to_lowercase();
        // Argyll writes it over lights and samples alike.
        let words = whole.replace("spectral power/reflectance information", "");
        let light = LIGHTS.iter().any(|w| words.contains(w));
        let sample = SAMPLES.iter().any(|w| words.contains(w));
        let kind = if light {
            Some(Kind::Light)
        } else if sample {
            Some(Kind::Reflectance)
        } else {
            kind_of_words(&words)
        };
        let is_evident = !(light && sample || words != whole);
        kind.map(|kind| Decision::guessed(kind, is_evident, says(key, value)))
    })
}

/// What the file's name tells, else the size of the values.
fn kind_of_rest(input: &Input, table: &CgatsTable, values: &[Vec<f64>]) -> Decision<Kind> {
    if let Some(kind) = kind_of_name(&input.name) {
        return Decision::guessed(kind, is_plain_name(&input.name), "the file's name");
    }
    let all_in = |low: f64, high: f64| {
        let mut known = values.iter().flatten().filter(|v| !v.is_nan());
        known.all(|v| (low..=high).contains(v))
    };
    // Several patches of a chart with per cent, by a program that is not Argyll.
    let is_chart = values.len() > 1 && table.kind.starts_with("CGATS") && all_in(-1.0, 130.0);
    let (kind, because) = if all_in(-0.05, 1.3) {
        let because = "nothing states it; all values lie in 0..1";
        (Kind::Reflectance, because)
    } else if is_chart {
        let because = "nothing states it; several sets with values of 0..100";
        (Kind::Reflectance, because)
    } else {
        (Kind::Light, "nothing states it")
    };
    Decision::guessed(kind, false, because)
}

/// What a field says, in its own words.
fn says(key: &str, value: &str) -> String {
    format!("{key} says {}", quoted(value.trim()))
}
