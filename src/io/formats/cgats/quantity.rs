//! The quantity and unit of the values of a CGATS table.

use super::bands::Bands;
use super::tables::CgatsTable;
use crate::io::Input;
use crate::io::error::quoted;
use crate::io::interpret::kinds::{is_plain_name, kind_of_name, kind_of_words};
use crate::io::reading::decision::Decision;
use crate::spectrum::Kind;

/// A kind, the unit of a light, and a note on it.
pub(super) struct Quantity<'a> {
    pub kind: Decision<Kind>,
    pub unit: &'a str,
    pub note: Option<String>,
}

/// Kinds by Argyll's `MEAS_TYPE` and the terms of other programs: words contained, the kind, and
/// Argyll's unit.
const STATED: [([&str; 2], Kind, &str); 9] = [
    (["AMBIENT", "FLASH"], Kind::Light, "mW s m-2 nm-1"),
    (["AMBIENT", ""], Kind::Light, "mW m-2 nm-1"),
    (["IRRADIAN", ""], Kind::Light, "mW m-2 nm-1"),
    (["FLASH", ""], Kind::Light, "mW s m-2 sr-1 nm-1"),
    (["EMISS", ""], Kind::Light, "mW m-2 sr-1 nm-1"),
    (["RADIANCE", ""], Kind::Light, "mW m-2 sr-1 nm-1"),
    (["REFLECT", ""], Kind::Reflectance, ""),
    (["TRANSMI", ""], Kind::Transmittance, ""),
    (["SENSITIV", ""], Kind::Weighting, ""),
];

fn stated_kind(value: &str) -> Option<(Kind, &'static str)> {
    let value = value.to_uppercase();
    let mut rows = STATED.into_iter();
    let (_, kind, unit) = rows.find(|(words, ..)| words.iter().all(|word| value.contains(word)))?;
    Some((kind, unit))
}

/// Words of a description that name a light although no kind is stated.
const LIGHTS: &str = "illum;light;lamp;daylight;tungsten;led;d50;d55;d65;d75;power;emission";

/// Words of a description that name samples.
const SAMPLES: &str = "sample;chart;checker;paint;paper;target;munsell";

/// The quantity of a table's values: by its keywords, else by labels, descriptions or the file's
/// name, else by their size.
pub(super) fn quantity<'a>(
    input: &Input,
    table: &CgatsTable<'a>,
    group: &Bands,
    values: &[Vec<f64>],
) -> Quantity<'a> {
    stated_quantity(table).unwrap_or_else(|| Quantity {
        kind: kind_of_labels(group)
            .or_else(|| kind_of_measurement(table))
            .or_else(|| kind_of_description(table))
            .unwrap_or_else(|| kind_of_rest(input, table, values)),
        unit: "",
        note: None,
    })
}

/// The quantity stated by keywords.
fn stated_quantity<'a>(table: &CgatsTable<'a>) -> Option<Quantity<'a>> {
    let stated = |kind, unit| Quantity {
        kind: Decision::of_format(kind),
        unit,
        note: None,
    };
    let own = table.key("KIND").filter(|_| table.is_own());
    if let Some(kind) = own.and_then(|word| Kind::ALL.into_iter().find(|k| k.word() == word)) {
        return Some(stated(kind, table.key("UNIT").unwrap_or("")));
    }
    let types = ["MEAS_TYPE", "MEASUREMENT_TYPE", "MEASUREMENT_MODE", "TYPE"];
    let mut types = types.iter().filter_map(|key| stated_kind(table.key(key)?));
    if let Some((kind, unit)) = types.next() {
        let by_argyll = table.number("SPECTRAL_NORM").is_none_or(|norm| norm == 1.0)
            && table
                .key("ORIGINATOR")
                .is_some_and(|v| v.contains("Argyll"));
        if !by_argyll || unit.is_empty() {
            return Some(stated(kind, ""));
        }
        return Some(Quantity {
            note: Some(tr!("{unit} is Argyll's unit; the file states none", unit)),
            ..stated(kind, unit)
        });
    }
    if table.kind == "CCSS" {
        return Some(stated(Kind::Light, "relative"));
    }
    match table.key("DEVICE_CLASS")? {
        "DISPLAY" => Some(stated(Kind::Light, "")),
        "OUTPUT" | "INPUT" => Some(stated(Kind::Reflectance, "")),
        _ => None,
    }
}

/// The kind by the labels of the columns.
fn kind_of_labels(group: &Bands) -> Option<Decision<Kind>> {
    let word = group.word.to_uppercase();
    let starts = |start: &&str| word.starts_with(start);
    let kind = if ["SPECTRAL_DEC", "SPECTRAL_PCT", "R|"].iter().any(starts) {
        Kind::Reflectance
    } else {
        starts(&"T|").then_some(Kind::Transmittance)?
    };
    Some(Decision::guessed(kind, true, said!("the columns' labels")))
}

/// The kind by the first of some keywords that implies one, marked as evident or as a guess.
fn kind_of_keywords(
    table: &CgatsTable,
    keys: &[&str],
    kind: impl Fn(&str) -> Option<(Kind, bool)>,
) -> Option<Decision<Kind>> {
    keys.iter().find_map(|key| {
        let value = table.key(key)?;
        let (kind, is_evident) = kind(value)?;
        let says = tr!("{key} says {value}", key, value = quoted(value.trim()));
        Some(Decision::guessed(kind, is_evident, says))
    })
}

/// The kind by the measurement conditions.
fn kind_of_measurement(table: &CgatsTable) -> Option<Decision<Kind>> {
    let keys = [
        "MEASUREMENT_SOURCE",
        "MEASUREMENT_GEOMETRY",
        "MEASUREMENT_CONDITIONS",
    ];
    kind_of_keywords(table, &keys, |value| {
        let lower = value.to_lowercase();
        // A white that values are counted from makes them factors.
        let has_white = ["whitebase", "45/0", "d/8"]
            .iter()
            .any(|w| lower.contains(w));
        let white = has_white.then_some(Kind::Reflectance);
        Some((stated_kind(value).map(|(kind, _)| kind).or(white)?, true))
    })
}

/// The kind by the descriptions.
fn kind_of_description(table: &CgatsTable) -> Option<Decision<Kind>> {
    let keys = ["DESCRIPTOR", "DISPLAY", "FILE_DESCRIPTOR", "TARGET_NAME"];
    kind_of_keywords(table, &keys, |value| {
        let whole = value.to_lowercase();
        // Argyll writes it over lights and samples alike.
        let words = whole.replace("spectral power/reflectance information", "");
        let light = LIGHTS.split(';').any(|w| words.contains(w));
        let sample = SAMPLES.split(';').any(|w| words.contains(w));
        let kind = match (light, sample) {
            (true, _) => Kind::Light,
            (false, true) => Kind::Reflectance,
            _ => kind_of_words(&words)?,
        };
        Some((kind, !(light && sample || words != whole)))
    })
}

/// The kind by the file's name, else by the size of the values.
fn kind_of_rest(input: &Input, table: &CgatsTable, values: &[Vec<f64>]) -> Decision<Kind> {
    if let Some(kind) = kind_of_name(&input.name) {
        return Decision::guessed(kind, is_plain_name(&input.name), said!("the file's name"));
    }
    let all_in = |low: f64, high: f64| {
        let mut known = values.iter().flatten().filter(|v| !v.is_nan());
        known.all(|v| (low..=high).contains(v))
    };
    // Several patches of a chart with per cent, by a program that is not Argyll.
    let is_chart = values.len() > 1 && table.kind.starts_with("CGATS") && all_in(-1.0, 130.0);
    let (kind, because) = match () {
        () if all_in(-0.05, 1.3) => (
            Kind::Reflectance,
            said!("nothing states it; all values lie in 0..1"),
        ),
        () if is_chart => (
            Kind::Reflectance,
            said!("nothing states it; several sets with values of 0..100"),
        ),
        () => (Kind::Light, said!("nothing states it")),
    };
    Decision::guessed(kind, false, because)
}
