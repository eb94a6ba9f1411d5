//! What values stand for: kind, unit and per cent, from titles, headers, names and the values.
//!
//! Titles of columns count most, then lines that state what is on the y axis, then the rest of
//! the header, then the file's name, last the values. Whatever is not stated is a guess, and the
//! reading says so.

use crate::spectrum::Kind;

/// A kind and what told it.
#[derive(Clone, Debug, PartialEq)]
pub struct KindFound {
    /// The kind.
    pub kind: Kind,
    /// What told it, for the person who may flip it.
    pub because: String,
    /// Whether the file states it, or it is only likely.
    pub stated: bool,
}

/// Words in a title or a header line, lower case, and the kind they tell, strongest first.
const WORDS: [(Kind, &[&str]); 6] = [
    (
        Kind::Weighting,
        &[
            "xbar", "ybar", "zbar", "x_bar", "y_bar", "z_bar", "x-bar", "y-bar", "z-bar",
            "colour-matching", "color-matching", "colour matching", "color matching", "cmf",
            "luminous efficiency", "v(l", "v(λ", "action spectr", "cone fundamental", "opic",
            "spectral sensitivity", "responsivity", "kind: weighting",
        ],
    ),
    (
        Kind::Absorbance,
        &["absorbance", "optical density", "kind: absorbance"],
    ),
    (
        Kind::Other,
        &["refractive", "optical constants", "extinction coeff", "tabulated n", "kind: other"],
    ),
    (
        Kind::Reflectance,
        &["reflect", "%r", "albedo", "kind: reflectance"],
    ),
    (
        Kind::Transmittance,
        &["transmit", "transmis", "%t", "kind: transmittance"],
    ),
    (
        Kind::Light,
        &[
            "irradian", "radiance", "radiant", "w/m", "w m-2", "wm-2", "w/nm", "w/cm", "/nm",
            "emission", "spectral power", "power distribution", "photon", "intensity", "counts",
            "kind: light",
        ],
    ),
];

/// Words in a file's name only: too weak for a line of text.
const NAME_WORDS: [(Kind, &[&str]); 7] = [
    (Kind::Other, &[".eta.", ".k.", ".n.", "_eta.", "_k.", "_n.", "-eta.", "-k.", "-n."]),
    (
        Kind::Weighting,
        &["cmf", "xyz_", "ciexyz", "linss", "sbrgb", "vlambda", "vl_", "opic", "action", "sensitiv"],
    ),
    (Kind::Reflectance, &["reflect", "macbeth", "colorchecker", "colourchecker", "munsell", "_refl"]),
    (Kind::Transmittance, &["transm", "filter"]),
    (Kind::Absorbance, &["absorb"]),
    (
        Kind::Light,
        &["irrad", "radian", "spd", "lamp", "led", "illum", "light", "emission", "daylight", "halogen"],
    ),
    (Kind::Lines, &[]),
];

/// The kind that a title tells by its words or its one letter (`R`, `T`, `%R`, `n`, `k`).
pub fn kind_of_title(title: &str) -> Option<Kind> {
    let title = title.trim().to_lowercase();
    let stem = title.split(['(', '[', ' ', '_', '.']).next().unwrap_or("");
    kind_of_words(&title).or(match stem {
        "r" | "refl" | "rho" => Some(Kind::Reflectance),
        "t" | "trans" | "tau" => Some(Kind::Transmittance),
        "abs" | "od" | "a" => Some(Kind::Absorbance),
        "n" | "k" | "eta" => Some(Kind::Other),
        "spd" | "power" | "energy" | "irr" => Some(Kind::Light),
        _ => None,
    })
}

/// The kind that a line of text tells.
pub fn kind_of_words(line: &str) -> Option<Kind> {
    let line = line.to_lowercase();
    WORDS
        .iter()
        .find(|(_, words)| words.iter().any(|w| line.contains(w)))
        .map(|(kind, _)| *kind)
}

/// The kind that a file's name suggests.
pub fn kind_of_name(name: &str) -> Option<Kind> {
    let name = name.to_lowercase();
    NAME_WORDS
        .iter()
        .find(|(_, words)| words.iter().any(|w| name.contains(w)))
        .map(|(kind, _)| *kind)
}

/// Whether a header line states what is on the y axis ("Y Units: Reflectance (percent)").
fn states_values(line: &str) -> bool {
    let line = line.trim().to_lowercase();
    ["kind:", "y unit", "yunit", "y-unit", "unit", "measurement", "quantity"]
        .iter()
        .any(|start| line.starts_with(start))
}

/// The kind of one column.
pub fn kind(title: &str, header: &[(usize, &str)], file: &str, values: &[f64]) -> KindFound {
    let stated = |kind, because: String| KindFound {
        kind,
        because,
        stated: true,
    };
    if let Some(kind) = kind_of_title(title) {
        return stated(kind, format!("the column's title \"{}\"", short(title)));
    }
    let lines = || header.iter().rev().map(|(_, line)| *line);
    let telling = lines()
        .filter(|line| states_values(line))
        .chain(lines())
        .find_map(|line| kind_of_words(line).map(|kind| (kind, line)));
    if let Some((kind, line)) = telling {
        return stated(kind, format!("the header line \"{}\"", short(line)));
    }
    let guess = |kind, because: &str| KindFound {
        kind,
        because: because.to_owned(),
        stated: false,
    };
    if let Some(kind) = kind_of_name(file) {
        return guess(kind, "the file's name");
    }
    if values.iter().all(|v| (-0.05..=1.2).contains(v)) {
        guess(Kind::Light, "nothing states it; all values lie in 0..1, so it may be a reflectance or a transmittance")
    } else {
        guess(Kind::Light, "nothing states it")
    }
}

/// Whether values of a factor (reflectance, transmittance) are per cent.
#[derive(Clone, Debug, PartialEq)]
pub struct PercentFound {
    /// Per cent rather than a fraction.
    pub percent: bool,
    /// What told it.
    pub because: String,
    /// Whether the file states it.
    pub stated: bool,
}

/// Per cent or fraction for the values of a factor.
///
/// Unstated, it is per cent when more than 1 % of the values exceed 1.5 and they are not just
/// noise over fractions: the middle value exceeds 1.5 too, or lies far under the largest (a
/// narrow filter is near 0 nearly everywhere).
pub fn percent(title: &str, header: &[(usize, &str)], signs: bool, values: &[f64]) -> PercentFound {
    let stated = |percent, because: &str| PercentFound {
        percent,
        because: because.to_owned(),
        stated: true,
    };
    let title = title.to_lowercase();
    if signs || title.contains('%') || title.contains("percent") {
        return stated(true, "the column's title");
    }
    if title.contains("[1.0]") || title.contains("fraction") {
        return stated(false, "the column's title");
    }
    for (_, line) in header.iter().rev().filter(|(_, line)| states_values(line)) {
        let line = line.to_lowercase();
        if line.contains('%') || line.contains("percent") {
            return stated(true, "the header");
        }
        if line.contains("fraction") {
            return stated(false, "the header");
        }
    }
    let mut sorted: Vec<f64> = values.iter().map(|v| v.abs()).collect();
    sorted.sort_by(f64::total_cmp);
    let at = |share: f64| sorted.get((share * sorted.len() as f64) as usize).copied();
    let (middle, high) = (at(0.5).unwrap_or(0.0), at(0.99).unwrap_or(0.0));
    let percent = high > 1.5 && (middle > 1.5 || middle < 0.05 * high);
    PercentFound {
        percent,
        because: format!("the values' size (up to about {high:.3})"),
        stated: false,
    }
}

/// The unit that a title or a header gives for values: text in brackets, or after "unit:".
pub fn unit(title: &str, header: &[(usize, &str)]) -> String {
    if let Some(unit) = bracketed(title) {
        return unit.to_owned();
    }
    for (_, line) in header.iter().rev() {
        let lower = line.trim().to_lowercase();
        let states = lower.starts_with("unit") || lower.starts_with("y unit");
        if states && let Some(after) = line.split([':', '=', '\t', ',']).nth(1) {
            let after = after.trim().trim_matches(['(', ')', '[', ']', '"']);
            if !after.is_empty() && after.len() <= 40 {
                return after.to_owned();
            }
        }
        if let Some(unit) = bracketed(line).filter(|u| u.contains('/') && kind_of_words(u).is_some())
        {
            return unit.to_owned();
        }
        if lower.contains("w/m^2/nm") || lower.contains("(w m-2 nm-1)") {
            return "W m-2 nm-1".to_owned();
        }
    }
    String::new()
}

fn bracketed(text: &str) -> Option<&str> {
    let open = text.find(['[', '('])?;
    let close = text[open..].find([']', ')'])? + open;
    let inside = text[open + 1..close].trim();
    let is_unit = !inside.is_empty() && inside.len() <= 40 && !inside.contains("nm]")
        && (inside.contains(['/', '%', '-', '²', '^']) || ["counts", "1.0", "fraction", "a.u."].contains(&inside));
    is_unit.then_some(inside)
}

fn short(text: &str) -> String {
    let text = text.trim();
    match text.char_indices().nth(40) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn titles_tell_the_kind() {
        for (title, kind) in [
            ("R(adaxial)", Some(Kind::Reflectance)),
            ("T(abaxial)", Some(Kind::Transmittance)),
            ("Transmittance(%)", Some(Kind::Transmittance)),
            ("Reflect. [1.0]", Some(Kind::Reflectance)),
            ("irradiance [W m-2 nm-1]", Some(Kind::Light)),
            ("x_bar", Some(Kind::Weighting)),
            ("n", Some(Kind::Other)),
            ("TL01", None),
            ("red", None),
        ] {
            assert_eq!(kind_of_title(title), kind, "{title}");
        }
    }

    #[test]
    fn the_y_axis_line_outweighs_the_rest_of_the_header() {
        let header = [(1, "Y Units: Reflectance (percent)"), (2, "irradiance of the sample")];
        assert_eq!(kind("", &header, "a.txt", &[50.0]).kind, Kind::Reflectance);
        assert!(percent("", &header, false, &[0.5]).percent);
    }

    #[test]
    fn a_kind_that_nothing_states_is_a_guess() {
        let found = kind("", &[], "x.csv", &[0.1, 0.5]);
        assert_eq!((found.kind, found.stated), (Kind::Light, false));
        assert!(found.because.contains("may be a reflectance"));
        assert_eq!(kind("", &[], "Au.eta.spd", &[1.0]).kind, Kind::Other);
    }

    #[test]
    fn per_cent_is_told_from_noisy_fractions() {
        let mut noisy = vec![0.9; 200];
        noisy[5..15].fill(20.0);
        assert!(!percent("", &[], false, &noisy).percent);
        let mut filter = vec![0.01; 200];
        filter[90..100].fill(80.0);
        assert!(percent("", &[], false, &filter).percent);
        assert!(percent("", &[], false, &[40.0, 50.0, 60.0]).percent);
    }

    #[test]
    fn units_stand_in_brackets_or_behind_the_word() {
        assert_eq!(unit("Irradiance [µW/cm2/nm]", &[]), "µW/cm2/nm");
        assert_eq!(unit("", &[(1, "unit: W m-2 nm-1")]), "W m-2 nm-1");
        assert_eq!(unit("", &[(3, "Units\t(W/m^2nm)")]), "W/m^2nm");
        assert_eq!(unit("TL01", &[]), "");
    }
}
