//! Units of lights, and the factor from one to another of the same quantity.

/// Words of units that state nothing absolute.
pub(super) fn is_relative(unit: &str) -> bool {
    let unit = unit.to_lowercase();
    // What it is relative to stands behind it in brackets.
    let word = unit.split('(').next().unwrap_or_default().trim();
    [
        "",
        "relative",
        "arbitrary",
        "a.u.",
        "au",
        "arb. units",
        "normalised",
        "normalized",
    ]
    .contains(&word)
}

/// Factor from one unit of a light to another of the same quantity; `None` where they differ.
pub(super) fn conversion(from: &str, to: &str) -> Option<f64> {
    let ((from_scale, from_rest), (to_scale, to_rest)) = (parsed(from), parsed(to));
    (from_rest == to_rest).then(|| {
        let factor = from_scale / to_scale;
        // W to mW is a power of ten, whatever the quotient's last bit is.
        let power = factor.log10().round();
        let exact = 10f64.powi(power as i32);
        if (factor / exact - 1.0).abs() < 1e-9 {
            exact
        } else {
            factor
        }
    })
}

/// A unit as its size in W, m and nm, and the exponents of its words.
fn parsed(unit: &str) -> (f64, Vec<(String, i32)>) {
    let unit = unit
        .replace('²', "2")
        .replace('⁻', "-")
        .replace(['µ', 'μ'], "u");
    let mut scale = 1.0;
    let mut words: Vec<(String, i32)> = Vec::new();
    let mut sign = 1;
    let mut rest = String::new();
    let mut flush = |text: &mut String, sign: i32| {
        let word = text.trim().trim_matches(['(', ')', '^']);
        if !word.is_empty() {
            let digits = word.find(|c: char| c.is_ascii_digit() || c == '-' || c == '^');
            let (name, power) = word.split_at(digits.unwrap_or(word.len()));
            let power = power.trim_start_matches('^').parse::<i32>().unwrap_or(1) * sign;
            let (name, size) = match name {
                "mW" => ("W", 1e-3),
                "uW" => ("W", 1e-6),
                "nW" => ("W", 1e-9),
                "kW" => ("W", 1e3),
                "cm" => ("m", 1e-2),
                "mm" => ("m", 1e-3),
                // Per nm and per um are lengths along the axis.
                "um" => ("nm", 1e3),
                name => (name, 1.0),
            };
            scale *= f64::powi(size, power);
            words.push((name.to_owned(), power));
        }
        text.clear();
    };
    for letter in unit.chars() {
        match letter {
            '/' => {
                flush(&mut rest, sign);
                sign = -1;
            }
            ' ' | '·' | '*' | '.' | '(' | ')' => flush(&mut rest, sign),
            letter => rest.push(letter),
        }
    }
    flush(&mut rest, sign);
    words.sort();
    (scale, words)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_of_one_quantity_are_converted_and_others_are_not() {
        assert_eq!(conversion("uW cm-2 nm-1", "W m-2 nm-1"), Some(0.01));
        assert_eq!(conversion("mW/m2/nm", "W m-2 nm-1"), Some(1e-3));
        assert_eq!(conversion("W m-2 nm-1", "µW/cm²/nm"), Some(100.0));
        assert_eq!(conversion("W m-2 sr-1 nm-1", "W m-2 nm-1"), None);
        assert_eq!(conversion("W nm-1", "W m-2 nm-1"), None);
    }
}
