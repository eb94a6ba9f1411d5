//! What values are called on an axis: their unit in a reader's form, not as a file has it.

use crate::{app::state::App, spectrum::Kind};

/// What values in a unit are called on an axis.
pub(super) fn value_label(unit: &str) -> String {
    match unit {
        // What else a file says of it belongs to its source.
        unit if unit.starts_with("relative") => said!("Relative power per nm").to_owned(),
        unit => unit_or_value(&as_fraction(unit)),
    }
}

/// A unit of powers as a fraction: "W m-2 nm-1" as "W/(m² nm)"; others as they are.
fn as_fraction(unit: &str) -> String {
    let power = |part: &str| {
        let at = part.find(|c: char| c == '-' || c.is_ascii_digit())?;
        let (name, exponent) = part.split_at(at);
        let exponent: i32 = exponent.parse().ok()?;
        let sign = match exponent.abs() {
            1 => "",
            2 => "²",
            3 => "³",
            _ => return None,
        };
        Some((format!("{name}{sign}"), exponent < 0))
    };
    let (mut over, mut under) = (Vec::new(), Vec::new());
    for part in unit.split(' ') {
        match power(part) {
            Some((name, true)) if name.starts_with(char::is_alphabetic) => under.push(name),
            _ => over.push(part.to_owned()),
        }
    }
    match under.len() {
        0 => unit.to_owned(),
        1 => format!("{}/{}", over.join(" "), under[0]),
        _ => format!("{}/({})", over.join(" "), under.join(" ")),
    }
}

/// What the values of the subject are called on an axis.
pub(super) fn subject_label(app: &App) -> String {
    kind_label(app.document().subject_entry().kind(), app.unit())
}

/// What values of a kind in a unit are called on an axis.
pub(super) fn kind_label(kind: Kind, unit: &str) -> String {
    match kind {
        Kind::Reflectance => said!("Reflectance").to_owned(),
        Kind::Transmittance => said!("Transmittance").to_owned(),
        _ => value_label(unit),
    }
}

/// A unit, or what stands for one where there is none.
fn unit_or_value(unit: &str) -> String {
    if unit.is_empty() {
        said!("Value, no unit stated")
    } else {
        unit
    }
    .to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_fractions_and_what_a_file_says_beside_them_is_left_out() {
        for (unit, label) in [
            ("W m-2 nm-1", "W/(m² nm)"),
            ("W nm-1", "W/nm"),
            ("mW/nm", "mW/nm"),
            (
                "relative (weights in % of the power)",
                "Relative power per nm",
            ),
            ("", "Value, no unit stated"),
            ("counts", "counts"),
        ] {
            assert_eq!(value_label(unit), label, "{unit}");
        }
    }
}
