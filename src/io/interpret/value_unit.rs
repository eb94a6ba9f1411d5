//! The unit of values, as titles and header lines give it.

use super::kinds::{kind_of_words, titles_several};
use crate::io::text::NumberedLines;
use crate::io::text::words::holds_one;

/// Photons in the unit that plant scientists use.
pub(crate) const PHOTONS: &str = "µmol m-2 s-1 nm-1";

/// Photons of which only a title tells.
pub(crate) const PHOTONS_ALONE: &str = "photons";

/// True if a unit counts photons: moles of them, or einsteins (`µE/m2/s/nm`).
pub(crate) fn counts_photons(unit: &str) -> bool {
    const WORDS: &str = "mol;photon;quanta;^ue;^µe;^μe;^einstein;^ph/";
    holds_one(&unit.to_lowercase(), WORDS)
}

/// True if a title states that photons were counted: by their name, or by plant scientists' terms
/// for their flux. Photon energy is an axis, and a quantum efficiency is not a light.
pub(crate) fn title_counts_photons(title: &str) -> bool {
    const WORDS: &str =
        "|photon|;|photons|;|quanta|;|quantum flux;|quantum irrad;|ppfd|;|pfd|;|umol;|µmol";
    let title = title.to_lowercase().replace('μ', "µ").replace('_', " ");
    holds_one(&title, WORDS) && !title.contains("photon energy") && !title.contains("w/")
}

/// What an instrument counted.
pub(crate) const COUNTS: &str = "counts";

/// True if a title states that an instrument counted. The name of a spectrum need not say it: an
/// only column is called after its file.
pub(crate) fn title_tells_counts(title: &str) -> bool {
    const WORDS: &str = "|count|;|counts|;|adu|;|dn|;|digital|;|scope|;|raw|";
    holds_one(&title.to_lowercase(), WORDS)
}

/// The unit of values that a title gives: text in brackets, a unit at its end, or what a
/// spectrometer counted above its own dark reading.
pub(crate) fn unit_of_title(title: &str) -> Option<&str> {
    let is_counted = title
        .trim_start()
        .to_lowercase()
        .starts_with("dark subtracted");
    let counts = is_counted.then_some(COUNTS);
    bracketed(title).or_else(|| bare(title)).or(counts)
}

/// The unit of values that header lines give: in brackets, or behind "unit:". A line that titles
/// columns of several kinds says nothing of those without one.
pub(crate) fn unit_of_header(header: &NumberedLines) -> String {
    let lines = header.iter().rev();
    for (_, line) in lines.filter(|(_, line)| !titles_several(line)) {
        // What this program's own files say, whatever it is.
        if let Some(own) = line.strip_prefix("unit: ") {
            return own.trim().to_owned();
        }
        let lower = line.trim().to_lowercase();
        let states = lower.starts_with("unit") || lower.starts_with("y unit");
        if states && let Some(after) = line.split([':', '=', '\t', ',']).nth(1) {
            let after = without_brackets(after.trim().trim_matches('"'));
            if looks_like_unit(after) {
                return after.to_owned();
            }
        }
        let is_of_values = |unit: &&str| unit.contains('/') && kind_of_words(unit).is_some();
        if let Some(unit) = bracketed(line).filter(is_of_values) {
            return unit.to_owned();
        }
        if lower.contains("w/m^2/nm") || lower.contains("(w m-2 nm-1)") {
            return "W m-2 nm-1".to_owned();
        }
    }
    String::new()
}

fn without_brackets(unit: &str) -> &str {
    let unit = unit.trim();
    [('(', ')'), ('[', ']')]
        .into_iter()
        .find_map(|(open, close)| unit.strip_prefix(open)?.strip_suffix(close))
        .unwrap_or(unit)
        .trim()
}

/// The first unit in brackets; brackets inside it and a divisor in brackets belong to it, as in
/// "E(lambda) [W/(m²·nm)]".
fn bracketed(text: &str) -> Option<&str> {
    text.match_indices(['[', '('])
        .filter(|(open, _)| !text[..*open].ends_with('/'))
        .find_map(|(open, mark)| {
            let (open_mark, close_mark) = if mark == "[" { ('[', ']') } else { ('(', ')') };
            let mut depth = 0;
            let close = text[open..].find(|c| {
                depth += i32::from(c == open_mark) - i32::from(c == close_mark);
                depth == 0 && c == close_mark
            });
            // Titles close brackets of one form with the other now and then.
            let close = close.or_else(|| text[open..].find([']', ')']))? + open;
            let inside = text[open + 1..close].trim();
            looks_like_unit(inside).then_some(inside)
        })
}

/// A unit of light without brackets at the end of a title: "Global W*m-2*nm-1", "W/m2".
fn bare(title: &str) -> Option<&str> {
    let starts = [
        "mW", "uW", "µW", "μW", "nW", "kW", "MW", "W", "µmol", "μmol", "umol", "nmol", "mmol",
        "mol", "photons", "quanta", "µE", "μE", "uE",
    ];
    let words = std::iter::once(0).chain(title.match_indices(' ').map(|(at, _)| at + 1));
    words.map(|at| title[at..].trim()).find(|rest| {
        let quantity = starts.iter().find_map(|start| rest.strip_prefix(start));
        quantity.is_some_and(|divisor| {
            divisor
                .trim_start()
                .starts_with(['/', '*', '·', 'm', 'c', 's', 'p'])
                && looks_like_unit(rest)
                && !rest.contains(['%', '='])
        })
    })
}

/// True if a text is a unit of values and nothing else.
pub(crate) fn looks_like_unit(text: &str) -> bool {
    const WORDS: [&str; 6] = ["counts", "1.0", "fraction", "a.u.", "relative", "W"];
    !text.is_empty()
        && text.len() <= 40
        && (text.contains(['/', '%', '²', '^', '⁻'])
            || text.contains("-1")
            || WORDS.contains(&text))
}
