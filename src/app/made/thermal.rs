//! Black bodies by Planck's law, and a candle, whose flame glows almost like one.

use super::{by_formula, empty, item};
use crate::{
    color::blackbody,
    preset::{Group, Preset, Shelf},
    spectrum::Kind,
};

/// Id of the group.
pub(super) const THERMAL: &str = "thermal_lights";

/// Names and temperatures (K): soot in a candle's flame, a halogen bulb, the sun's surface (its
/// effective temperature), and a sky bluer than any lamp.
const NAMED: [(&str, f64); 4] = [
    ("Candle flame", 1900.0),
    ("Black body 3000 K", 3000.0),
    ("Black body 5772 K", 5772.0),
    ("Black body 15000 K", 15_000.0),
];

/// Temperatures that may be asked for, K.
const KELVIN: std::ops::RangeInclusive<f64> = 1000.0..=100_000.0;

/// Where the tables are 100, nm.
const HUNDRED_NM: f64 = 560.0;

/// The black bodies that are listed.
pub(super) fn group() -> Group {
    let mut group = bare();
    let made = NAMED
        .iter()
        .filter_map(|(name, kelvin)| planck(&group, name, *kelvin));
    group.items = made.collect();
    group
}

/// A black body of any temperature: "black body 2700 K".
pub(super) fn on_demand(name: &str) -> Option<Preset> {
    let lower = name.to_lowercase();
    let rest = lower
        .strip_prefix("black body")
        .or_else(|| lower.strip_prefix("blackbody"))?;
    let kelvin: f64 = rest.trim().trim_end_matches('k').trim().parse().ok()?;
    planck(&bare(), &format!("Black body {kelvin} K"), kelvin)
}

fn bare() -> Group {
    empty(
        THERMAL,
        "Candle and black bodies, made by Planck's law",
        Shelf::Standard,
        Kind::Light,
        &format!("Planck's law, c2 = {} m K", blackbody::C2_M_K),
    )
}

fn planck(group: &Group, name: &str, kelvin: f64) -> Option<Preset> {
    if !KELVIN.contains(&kelvin) {
        return None;
    }
    let at_hundred = blackbody::relative(HUNDRED_NM, kelvin);
    let samples = by_formula(|nm| 100.0 * blackbody::relative(nm, kelvin) / at_hundred)?;
    let mut notes = vec![format!("Made by this program: a black body at {kelvin} K.")];
    if !name.starts_with("Black body") {
        notes.push(
            "A real flame is close to it; the salt of a wick adds sodium's yellow line.".to_owned(),
        );
    }
    Some(item(
        group,
        name,
        "relative (100 at 560 nm)",
        notes,
        samples,
    ))
}
