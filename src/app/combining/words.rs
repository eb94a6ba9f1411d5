//! The result of a combination in words.

use crate::measurements::OF_95;
use std::fmt::Write as _;

use super::result::{Found, LineRow, ScanRow};
use crate::{
    app::ticks::short,
    io::many::capitalised,
    languages::{fixed, signed, with_sign},
    measurements::{Changed, Doubt, Doubted, Feature, Figure, Measurement, Part, Verdict, rounded},
};

/// Most lines that are told in words.
const MOST_LINES: usize = 12;

/// What a doubt is of where nothing but the readings' own noise is known.
const NOISE_ONLY: &str = "\u{b1} is of the noise alone: what level and wavelengths are known to was \
                          not stated (--level, --axis).";

/// All that was found, in words.
pub fn text(found: &Found) -> String {
    let mut text = String::new();
    if let Some(result) = &found.result {
        words_of(found, result, &mut text);
        text += &doubt_words(found, result);
    }
    for scan in &found.scans {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "Scan      {}: {}", scan.name, scan_words(scan));
    }
    let (mut own, rest) = found.notes();
    if found.changed.is_some() {
        // What was asked for is no note.
        text += &(own.remove(0) + "\n");
    }
    for note in own.iter().chain(&rest) {
        let _ = writeln!(text, "Note      {note}");
    }
    text
}

fn words_of(found: &Found, result: &Measurement, text: &mut String) {
    let samples = &result.samples;
    let quantity = result.quantity.to_string();
    let unit = match result.unit.as_str() {
        unit if unit.is_empty() || unit.eq_ignore_ascii_case(&quantity) => String::new(),
        unit => format!(", {unit}"),
    };
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "{}\n{quantity}{unit}, {} points, {}-{} nm",
        found.made_by,
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
}

/// Figures and lines with their doubt.
pub fn doubt_words(found: &Found, result: &Measurement) -> String {
    let mut text = String::new();
    if let Some((all, _)) = found.figures() {
        for doubted in &all {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{}", in_words(doubted));
        }
        let has_doubt = |d: &Doubted| d.doubt.is_some_and(|doubt| doubt.half_width_95 > 0.0);
        if all.iter().any(has_doubt) && result.level == 0.0 && result.axis_nm == 0.0 {
            let _ = writeln!(text, "Note      {NOISE_ONLY}");
        }
    }
    for line in found.lines.iter().take(MOST_LINES) {
        let _ = writeln!(text, "Line      {}", line_words(line));
    }
    text
}

/// `level +0.31 %, moved -0.012 nm`.
pub fn scan_words(scan: &ScanRow) -> String {
    let (level, shift) = (100.0 * scan.level, scan.shift_nm);
    tr!(
        "level {level} %, moved {shift} nm",
        level = signed(level, 2),
        shift = signed(shift, 3)
    )
}

/// `12.4 ± 0.3`; the value alone where its half width is not known.
pub fn with_half(value: f64, half: Option<f64>) -> String {
    match half {
        Some(half) if half > 0.0 => {
            let (value, half) = rounded(value, half);
            with_sign(format!("{value} \u{b1} {half}"))
        }
        _ => short(value),
    }
}

/// `546.07 ± 0.02 nm, 12.4 ± 0.3, 9.8 % of the power`.
pub fn line_words(line: &LineRow) -> String {
    let with = |value: f64, u: Option<f64>| with_half(value, u.map(|u| OF_95 * u));
    let weight = line.weight.map_or_else(
        || said!("its top is cut").to_owned(),
        |w| with(w, line.u[1]),
    );
    let mut words = vec![format!("{} nm", with(line.at_nm, line.u[0])), weight];
    words.extend(
        line.share
            .map(|share| tr!("{share} % of the power", share = fixed(100.0 * share, 1))),
    );
    words.extend((!line.is_certain).then(|| said!("uncertain").to_owned()));
    words.join(", ")
}

/// `CCT       4224 ± 11 K`.
fn in_words(doubted: &Doubted) -> String {
    format!("{:<9} {}", doubted.figure.words(), figure_words(doubted))
}

/// A figure as it is shown: an index is cut at its top.
pub fn shown_value(figure: Figure, doubt: &Doubt) -> f64 {
    match figure {
        Figure::Ra | Figure::R9 | Figure::Rf => doubt.value.min(100.0),
        _ => doubt.value,
    }
}

/// `4224 ± 11 K`, the last digit worth writing; a dash for a figure that the light does not have.
pub fn figure_words(doubted: &Doubted) -> String {
    let Some(doubt) = doubted.doubt else {
        return "-".to_owned();
    };
    let unit = if doubted.figure == Figure::Cct {
        " K"
    } else {
        ""
    };
    let value = shown_value(doubted.figure, &doubt);
    format!("{}{unit}", with_half(value, Some(doubt.half_width_95)))
}

/// What was found, in a sentence.
pub fn headline(found: &Found) -> String {
    let Some(result) = &found.result else {
        return found.notes.first().cloned().unwrap_or_default();
    };
    let kept = result.kept_values().iter().flatten().count();
    let share = 100 * kept / result.samples.len().max(1);
    let quantity = result.quantity.to_string();
    let quantity = capitalised(&quantity);
    let what = match (found.scans.len(), kept == result.samples.len()) {
        (0, true) => quantity,
        (0, false) => tr!(
            "{quantity}, told over {share} % of its samples",
            quantity,
            share
        ),
        (all, _) => {
            let used = found.scans.iter().filter(|scan| scan.is_kept).count();
            match used == all {
                true => tr!("The mean of {all} scans", all),
                false => tr!("The mean of {used} of {all} scans", used, all),
            }
        }
    };
    let figures = found.figures().map(|(all, _)| all).unwrap_or_default();
    let told = figures.iter().filter(|d| d.doubt.is_some());
    let told = told.filter(|d| matches!(d.figure, Figure::Cct | Figure::Ra));
    let told: Vec<String> = told
        .map(|d| format!("{} {}", d.figure.words(), figure_words(d)))
        .collect();
    match told.is_empty() {
        true => format!("{what}."),
        false => format!("{what}: {}.", told.join(", ")),
    }
}

/// One part that differs, without its amount: `Hg 546`, `glow`, `CCT`.
pub fn part_name(part: &Part, name: Option<&str>) -> String {
    match (part.feature, name) {
        (Feature::Line(_), Some(name)) => name.to_owned(),
        (Feature::Line(at), None) => tr!("line {at}", at = fixed(at, 1)),
        (feature, _) => feature.to_string(),
    }
}

/// By how much a part differs: `+12 ± 2 %`, `-80 ± 15 K`.
pub fn change_words(part: &Part) -> String {
    let (by, unit) = match part.feature {
        Feature::Cct => (1.0, " K"),
        _ => (100.0, " %"),
    };
    let (change, u) = rounded(by * part.change, OF_95 * by * part.u);
    let sign = if part.change > 0.0 { "+" } else { "" };
    with_sign(format!("{sign}{change} \u{b1} {u}{unit}"))
}

/// What differs, in a sentence.
pub(super) fn sentence(changed: &Changed, names: &[String]) -> String {
    let amount = |(part, name): (&Part, &String)| format!("{name} {}", change_words(part));
    let parts: Vec<String> = changed.parts.iter().zip(names).map(amount).collect();
    match changed.verdict {
        Verdict::Different => tr!("Different: {changes}.", changes = parts.join(", ")),
        Verdict::Same => {
            let least = fixed(changed.least_seen_percent, 1);
            match parts.first() {
                Some(level) => tr!(
                    "Same ({level}): no difference beyond the noise (a line would have to change \
                     by {least} %).",
                    level,
                    least
                ),
                None => tr!(
                    "Same: no difference beyond the noise (a line would have to change by {least} \
                     %).",
                    least
                ),
            }
        }
        Verdict::CannotSay => said!("Cannot say.").to_owned(),
    }
}
