//! Quantities of measured values, and the meaning of their combinations.

mod sums;

use std::fmt;

use super::{
    error::MeasurementError,
    units::{conversion, is_relative},
};
use crate::{languages::with_sign, spectrum::Kind};

/// Quantity of the values of a measurement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// A light: radiant power, irradiance, radiance per nm, absolute or relative.
    Light,
    /// Raw counts of an instrument, with the response still in them.
    Counts,
    /// Share of light let through.
    Transmittance,
    /// Share of light sent back.
    Reflectance,
    /// Decadic absorbance.
    Absorbance,
    /// Any other factor over wavelengths: a correction, a difference of two factors.
    Factor,
    /// A plain number, the same at every wavelength.
    Number,
}

impl Quantity {
    /// The word of files, JSON and the command line.
    pub fn word(self) -> &'static str {
        match self {
            // A light is what JSON and files call radiant.
            Self::Light => "radiant",
            Self::Counts => "counts",
            Self::Transmittance => "transmittance",
            Self::Reflectance => "reflectance",
            Self::Absorbance => "absorbance",
            Self::Factor => "factor",
            Self::Number => "number",
        }
    }

    /// True if it multiplies a light.
    pub fn is_factor(self) -> bool {
        matches!(self, Self::Transmittance | Self::Reflectance | Self::Factor)
    }

    /// The kind of a spectrum with such values.
    pub fn kind(self) -> Kind {
        match self {
            Self::Light => Kind::Light,
            Self::Transmittance => Kind::Transmittance,
            Self::Reflectance => Kind::Reflectance,
            Self::Absorbance => Kind::Absorbance,
            Self::Counts | Self::Factor | Self::Number => Kind::Other,
        }
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Light => said!("a light"),
            Self::Counts => said!("counts"),
            Self::Transmittance => said!("a transmittance"),
            Self::Reflectance => said!("a reflectance"),
            Self::Absorbance => said!("an absorbance"),
            Self::Factor => said!("a factor"),
            Self::Number => said!("a number"),
        })
    }
}

/// Words of a unit that say that an instrument counted.
const COUNT_WORDS: [&str; 6] = ["count", "adu", "dn", "digital", "scope", "raw"];

/// True if a unit or title says that an instrument counted.
pub(super) fn says_counts(text: &str) -> bool {
    let text = text.to_lowercase();
    let mut words = text.split(|c: char| !c.is_alphanumeric());
    words.any(|word| {
        COUNT_WORDS
            .iter()
            .any(|known| word == *known || *known == "count" && word.starts_with("count"))
    })
}

/// Quantity of the values of a spectrum of this kind and unit.
///
/// # Errors
/// A sentence for what is no measurement: weightings, n and k, lists of lines.
pub fn quantity_of(name: &str, kind: Kind, unit: &str) -> Result<Quantity, MeasurementError> {
    match kind {
        Kind::Light | Kind::Other if says_counts(unit) => Ok(Quantity::Counts),
        Kind::Light => Ok(Quantity::Light),
        Kind::Transmittance => Ok(Quantity::Transmittance),
        Kind::Reflectance => Ok(Quantity::Reflectance),
        Kind::Absorbance => Ok(Quantity::Absorbance),
        Kind::Other if unit.trim().eq_ignore_ascii_case("factor") => Ok(Quantity::Factor),
        Kind::Weighting => meaningless(tr!("{name} is a weighting, not a measurement.", name)),
        Kind::Lines => meaningless(tr!("{name} is a list of lines, not a measurement.", name)),
        Kind::Other => meaningless(tr!(
            "{name} is a curve of another kind (n, k), not a measurement.",
            name
        )),
    }
}

/// Meaning of a part of a formula.
#[derive(Clone, Debug, PartialEq)]
pub struct Meaning {
    /// Text of the part in the formula: `A`, `(A - C)`.
    pub text: String,
    /// Quantity of its values.
    pub quantity: Quantity,
    /// Unit; empty where none is known.
    pub unit: String,
    /// Exposure, ms, where the file says it.
    pub exposure_ms: Option<f64>,
}

/// An operation of two parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Operation {
    Add,
    Subtract,
    Multiply,
    Divide,
}

/// Meaning of two parts combined, and the factor that converts the second to the first one's unit.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Outcome {
    pub meaning: Meaning,
    pub second_by: f64,
    pub note: Option<String>,
}

fn meaningless<T>(why: String) -> Result<T, MeasurementError> {
    Err(MeasurementError::Meaningless(why))
}

impl Operation {
    /// Meaning of the operation for two parts.
    ///
    /// # Errors
    /// A sentence for a combination that means nothing.
    pub(super) fn of(self, a: &Meaning, b: &Meaning) -> Result<Outcome, MeasurementError> {
        match self {
            Self::Add => sums::sum(a, b, '+'),
            Self::Subtract => sums::sum(a, b, '-'),
            Self::Multiply => product(a, b),
            Self::Divide => quotient(a, b),
        }
    }
}

fn outcome(text: String, quantity: Quantity, unit: &str, of: &Meaning) -> Outcome {
    Outcome {
        meaning: Meaning {
            text,
            quantity,
            unit: unit.to_owned(),
            exposure_ms: of.exposure_ms,
        },
        second_by: 1.0,
        note: None,
    }
}

/// That the second part is scaled to the exposure of the first, of these ms.
fn scaled_words(a: &Meaning, b: &Meaning, exposures_ms: [f64; 2]) -> String {
    let [wanted, read] = exposures_ms.map(|ms| with_sign(ms.to_string()));
    tr!(
        "{b} was read with {read} ms and is scaled to the {wanted} ms of {a}.",
        b = b.text,
        read,
        wanted,
        a = a.text
    )
}

fn product(a: &Meaning, b: &Meaning) -> Result<Outcome, MeasurementError> {
    use Quantity::{Absorbance, Counts, Factor, Light, Number};
    let text = format!("{} * {}", a.text, b.text);
    let same = |of: &Meaning| Ok(outcome(text.clone(), of.quantity, &of.unit, of));
    match (a.quantity, b.quantity) {
        (Number, _) => same(b),
        (_, Number) => same(a),
        (Absorbance, _) | (_, Absorbance) => meaningless(tr!(
            "{a} is {x} and {b} {y}: absorbances are added, not multiplied.",
            a = a.text,
            x = a.quantity,
            b = b.text,
            y = b.quantity
        )),
        // An instrument's factor makes a light of counts.
        (Counts, Factor) | (Factor, Counts) => {
            let unit = if a.quantity == Factor {
                &a.unit
            } else {
                &b.unit
            };
            let unit = unit.trim_start_matches("factor").trim();
            Ok(outcome(text, Light, unit, a))
        }
        (Light | Counts, y) if y.is_factor() => same(a),
        (x, Light | Counts) if x.is_factor() => same(b),
        (x, y) if x.is_factor() && y.is_factor() => {
            let quantity = if x == y { x } else { Factor };
            Ok(outcome(
                text,
                quantity,
                if quantity == Factor { "factor" } else { "" },
                a,
            ))
        }
        (x, y) => meaningless(tr!(
            "{a} is {x} and {b} {y}: a product of the two means nothing.",
            a = a.text,
            x,
            b = b.text,
            y
        )),
    }
}

fn quotient(a: &Meaning, b: &Meaning) -> Result<Outcome, MeasurementError> {
    use Quantity::{Absorbance, Counts, Factor, Light, Number, Transmittance};
    let text = format!("{} / {}", a.text, b.text);
    match (a.quantity, b.quantity) {
        (_, Number) => Ok(outcome(text, a.quantity, &a.unit, a)),
        (Absorbance, _) | (_, Absorbance) => meaningless(tr!(
            "{a} is {x} and {b} {y}: absorbances are subtracted, not divided.",
            a = a.text,
            x = a.quantity,
            b = b.text,
            y = b.quantity
        )),
        (Light, Light) => {
            let factor = match (is_relative(&a.unit), is_relative(&b.unit)) {
                (false, false) => conversion(&b.unit, &a.unit),
                _ => Some(1.0),
            };
            let Some(factor) = factor else {
                return meaningless(tr!(
                    "{a} is in {unit} and {b} in {other}: a quotient of different quantities is \
                     no transmittance.",
                    a = a.text,
                    unit = a.unit,
                    b = b.text,
                    other = b.unit
                ));
            };
            let mut found = outcome(text, Transmittance, "fraction", a);
            found.second_by = factor;
            Ok(found)
        }
        (Counts, Counts) => {
            let mut found = outcome(text, Transmittance, "fraction", a);
            if let (Some(x), Some(y)) = (a.exposure_ms, b.exposure_ms)
                && x != y
            {
                found.second_by = x / y;
                found.note = Some(scaled_words(a, b, [x, y]));
            }
            Ok(found)
        }
        (Counts, Light) | (Light, Counts) => {
            let mut found = outcome(text, Factor, "factor", a);
            found.note =
                Some(said!("Counts and a light: the response of an instrument.").to_owned());
            Ok(found)
        }
        (Light | Counts, y) if y.is_factor() => Ok(outcome(text, a.quantity, &a.unit, a)),
        (x, y) if x.is_factor() && y.is_factor() => {
            let quantity = if x == y { x } else { Factor };
            Ok(outcome(text, quantity, "fraction", a))
        }
        (Number, y) if y.is_factor() => Ok(outcome(text, Factor, "factor", a)),
        (x, y) => meaningless(tr!(
            "{a} is {x} and {b} {y}: a quotient of the two means nothing.",
            a = a.text,
            x,
            b = b.text,
            y
        )),
    }
}

/// Meaning of `-log10` of a part.
///
/// # Errors
/// A sentence for anything but a factor.
pub(super) fn absorbance_of(a: &Meaning) -> Result<Meaning, MeasurementError> {
    let found = |quantity| Meaning {
        text: format!("-log10({})", a.text),
        quantity,
        unit: String::new(),
        exposure_ms: None,
    };
    match a.quantity {
        Quantity::Number => Ok(found(Quantity::Number)),
        quantity if quantity.is_factor() => Ok(found(Quantity::Absorbance)),
        Quantity::Light => meaningless(
            said!("A light has no absorbance. Divide it by a reference first.").to_owned(),
        ),
        Quantity::Counts => meaningless(
            said!("Counts has no absorbance. Divide it by a reference first.").to_owned(),
        ),
        _ => meaningless(
            said!("An absorbance has no absorbance. Divide it by a reference first.").to_owned(),
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn part(text: &str, quantity: Quantity, unit: &str) -> Meaning {
        Meaning {
            text: text.to_owned(),
            quantity,
            unit: unit.to_owned(),
            exposure_ms: None,
        }
    }

    #[test]
    fn what_means_nothing_is_refused_in_words() {
        use Operation::{Add, Divide, Multiply, Subtract};
        let light = part("B", Quantity::Light, "W m-2 nm-1");
        let counts = part("A", Quantity::Counts, "counts");
        let glass = part("B", Quantity::Transmittance, "");
        let lamp = part("A", Quantity::Light, "");
        let why = |op: Operation, a, b| op.of(a, b).expect_err("refused").to_string();
        assert_eq!(
            why(Add, &counts, &light),
            "A holds counts and B W m-2 nm-1: they cannot be added. Divide A by a reading of B's \
             lamp first (Instruments)."
        );
        assert_eq!(
            why(Subtract, &lamp, &glass),
            "A is a light and B a transmittance: a difference of the two means nothing. Multiply, \
             or choose A over another light."
        );
        assert_eq!(
            absorbance_of(&lamp).expect_err("refused").to_string(),
            "A light has no absorbance. Divide it by a reference first."
        );
        assert!(why(Multiply, &lamp, &light).contains("a product of the two means nothing"));
        assert!(why(Divide, &glass, &lamp).contains("a quotient of the two means nothing"));
        assert!(why(Add, &lamp, &light).contains("they share no scale"));
        let mut dark = part("C", Quantity::Counts, "counts");
        dark.exposure_ms = Some(100.0);
        let mut lit = counts.clone();
        lit.exposure_ms = Some(30.0);
        assert_eq!(
            why(Subtract, &lit, &dark),
            "A was read with 30 ms and the dark C with 100 ms: a dark of another exposure is not \
             subtracted."
        );
        let why = quantity_of("V(λ)", Kind::Weighting, "").expect_err("refused");
        assert_eq!(why.to_string(), "V(λ) is a weighting, not a measurement.");
    }

    #[test]
    fn what_means_something_says_what() {
        use Operation::{Divide, Multiply, Subtract};
        let of = |op: Operation, a: Quantity, b: Quantity| {
            let found = op.of(&part("A", a, ""), &part("B", b, ""));
            found.expect("it means something").meaning.quantity
        };
        use Quantity::{Counts, Factor, Light, Reflectance, Transmittance};
        assert_eq!(of(Subtract, Counts, Counts), Counts);
        assert_eq!(of(Divide, Light, Light), Transmittance);
        assert_eq!(of(Divide, Counts, Light), Factor);
        assert_eq!(of(Divide, Light, Transmittance), Light);
        assert_eq!(of(Multiply, Transmittance, Transmittance), Transmittance);
        assert_eq!(of(Multiply, Reflectance, Light), Light);
        assert_eq!(of(Subtract, Transmittance, Transmittance), Factor);
        assert_eq!(of(Multiply, Counts, Factor), Light);
        let counts = quantity_of("x", Kind::Light, "Intensity (counts)");
        assert_eq!(counts, Ok(Counts));
        assert_eq!(quantity_of("x", Kind::Light, "W m-2 nm-1"), Ok(Light));
    }
}
