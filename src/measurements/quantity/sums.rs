//! Meaning of sums and differences.

use super::{Meaning, Outcome, Quantity, meaningless, outcome, scaled_words};
use crate::{
    languages::with_sign,
    measurements::{
        error::MeasurementError,
        units::{conversion, is_relative},
    },
};

/// Meaning of the sum of two parts, or of their difference.
///
/// # Errors
/// A sentence for a combination that means nothing.
pub(super) fn sum(a: &Meaning, b: &Meaning, sign: char) -> Result<Outcome, MeasurementError> {
    use Quantity::{Absorbance, Counts, Light, Number};
    let text = format!("({} {sign} {})", a.text, b.text);
    let is_sum = sign == '+';
    match (a.quantity, b.quantity) {
        (Light, Light) => lights(a, b, text),
        (Counts, Counts) => counts(a, b, sign, text),
        (Number, Number) => Ok(outcome(text, Number, "", a)),
        (Absorbance, Absorbance) => Ok(outcome(text, Absorbance, "", a)),
        (x, y) if (x.is_factor() || x == Number) && (y.is_factor() || y == Number) => {
            let mut found = outcome(text, Quantity::Factor, "factor", a);
            let note = match is_sum {
                true => said!("A plain sum of factors, no filter any more."),
                false => said!("A plain difference of factors, no filter any more."),
            };
            found.note = Some(note.to_owned());
            Ok(found)
        }
        _ => meaningless(no_sum(a, b, is_sum)),
    }
}

/// Why a sum, or a difference, means nothing.
fn no_sum(a: &Meaning, b: &Meaning, is_sum: bool) -> String {
    use Quantity::{Counts, Light};
    match (a.quantity, b.quantity) {
        (Counts, Light) => match is_sum {
            true => tr!(
                "{a} holds counts and {b} {held}: they cannot be added. Divide {a} by a reading \
                 of {b}'s lamp first (Instruments).",
                a = a.text,
                b = b.text,
                held = held(b)
            ),
            false => tr!(
                "{a} holds counts and {b} {held}: they cannot be subtracted. Divide {a} by a \
                 reading of {b}'s lamp first (Instruments).",
                a = a.text,
                b = b.text,
                held = held(b)
            ),
        },
        (Light, Counts) => match is_sum {
            true => tr!(
                "{a} holds {held} and {b} counts: they cannot be added. Divide {b} by a reading \
                 of {a}'s lamp first (Instruments).",
                a = a.text,
                held = held(a),
                b = b.text
            ),
            false => tr!(
                "{a} holds {held} and {b} counts: they cannot be subtracted. Divide {b} by a \
                 reading of {a}'s lamp first (Instruments).",
                a = a.text,
                held = held(a),
                b = b.text
            ),
        },
        (Light, y) if y.is_factor() => match is_sum {
            true => tr!(
                "{a} is a light and {b} {factor}: a sum of the two means nothing. Multiply, or \
                 choose {a} over another light.",
                a = a.text,
                b = b.text,
                factor = y
            ),
            false => tr!(
                "{a} is a light and {b} {factor}: a difference of the two means nothing. \
                 Multiply, or choose {a} over another light.",
                a = a.text,
                b = b.text,
                factor = y
            ),
        },
        (x, y) => match is_sum {
            true => tr!(
                "{a} is {x} and {b} {y}: a sum of the two means nothing.",
                a = a.text,
                x,
                b = b.text,
                y
            ),
            false => tr!(
                "{a} is {x} and {b} {y}: a difference of the two means nothing.",
                a = a.text,
                x,
                b = b.text,
                y
            ),
        },
    }
}

/// Description of a part's values for a sentence: its unit where it has one.
fn held(part: &Meaning) -> String {
    match (part.quantity, part.unit.as_str()) {
        (Quantity::Light, "") => said!("a light without a unit").to_owned(),
        (Quantity::Light, unit) => unit.to_owned(),
        (quantity, _) => quantity.to_string(),
    }
}

fn lights(a: &Meaning, b: &Meaning, text: String) -> Result<Outcome, MeasurementError> {
    let mut found = outcome(text, Quantity::Light, &a.unit, a);
    match (is_relative(&a.unit), is_relative(&b.unit)) {
        (true, true) => {
            found.note = Some(tr!(
                "{a} and {b} state no unit: taken as on one scale. Where they are not, bring both \
                 to equal Y or area first.",
                a = a.text,
                b = b.text
            ));
            Ok(found)
        }
        (false, false) => match conversion(&b.unit, &a.unit) {
            Some(factor) => {
                found.second_by = factor;
                if factor != 1.0 {
                    found.note = Some(tr!(
                        "{name} is in {unit}, converted to {wanted}.",
                        name = b.text,
                        unit = b.unit,
                        wanted = a.unit
                    ));
                }
                Ok(found)
            }
            None => meaningless(tr!(
                "{a} is in {unit} and {b} in {other}: different quantities cannot be added or \
                 subtracted.",
                a = a.text,
                unit = a.unit,
                b = b.text,
                other = b.unit
            )),
        },
        (is_first, _) => {
            let (relative, absolute) = if is_first { (a, b) } else { (b, a) };
            meaningless(tr!(
                "{relative} is relative and {absolute} in {unit}: they share no scale. Bring both \
                 to equal Y or area first.",
                relative = relative.text,
                absolute = absolute.text,
                unit = absolute.unit
            ))
        }
    }
}

fn counts(a: &Meaning, b: &Meaning, sign: char, text: String) -> Result<Outcome, MeasurementError> {
    let per_ms = |m: &Meaning| m.unit.to_lowercase().contains("/ms") || m.unit.contains("per ms");
    let found = outcome(text, Quantity::Counts, &a.unit, a);
    if let (Some(x), Some(y)) = (a.exposure_ms, b.exposure_ms)
        && x != y
        && !(per_ms(a) && per_ms(b))
    {
        if sign == '-' {
            return meaningless(tr!(
                "{a} was read with {ms} ms and the dark {b} with {other} ms: a dark of another \
                 exposure is not subtracted.",
                a = a.text,
                ms = with_sign(x.to_string()),
                b = b.text,
                other = with_sign(y.to_string())
            ));
        }
        let mut scaled = found;
        scaled.second_by = x / y;
        scaled.note = Some(scaled_words(a, b, [x, y]));
        return Ok(scaled);
    }
    Ok(found)
}
