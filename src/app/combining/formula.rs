//! Formulas over measurements, and two ranges spliced.

use super::{
    parts::{Part, doubt_from, has_lines, measurements, with_noise},
    result::{Found, LineRow},
    said,
    words::with_half,
};
use crate::measurements::OF_95;
use crate::{
    app::readings::names_of_lines,
    languages::with_sign,
    measurements::{
        Formula, Measurement, Normalise, Options, Quantity, Summand, combine, letter, normalised,
        splice, sum_of_composites,
    },
    spectrum::{Composite, Sampled},
};

/// Most that a quotient over a reference with lines may be off by.
const MOST_DOUBT: f64 = 0.03;

/// A formula over the inputs; `text` as it was written.
///
/// # Errors
/// A sentence for what means nothing.
pub(super) fn of_formula(
    formula: &Formula,
    text: &str,
    parts: &[Part],
    keep_all: bool,
) -> Result<Found, String> {
    let from = doubt_from(&measurements(parts));
    let inputs = with_noise(measurements(parts));
    let divisors = formula.divisors();
    let has_lines = divisors
        .iter()
        .filter_map(|index| inputs.get(*index))
        .any(has_lines);
    // Between lines a quotient is as good as the axes are known; of the noise alone the mask tells.
    let has_axis = inputs.iter().any(|input| input.axis_nm > 0.0);
    let settings = Options {
        keep_all,
        most_doubt: (has_lines && has_axis).then_some(MOST_DOUBT),
        tells_lines: has_lines,
    };
    let mut found = combine(formula, &inputs, settings).map_err(said)?;
    if has_lines && found.kept < 0.25 {
        found.notes.push(tr!(
            "The reference is almost dark between its lines: T is told at {count} lines only.",
            count = found.points.len()
        ));
    }
    let used = formula.letters();
    let unused = (0..inputs.len()).filter(|index| !used.contains(index));
    let unused: Vec<&str> = unused.map(|index| inputs[index].name.as_str()).collect();
    if !unused.is_empty() {
        let unused = unused.join(", ");
        found.notes.push(tr!(
            "Not used: {unused}. The formula has no letter for it.",
            unused
        ));
    }
    let names: Vec<String> = inputs
        .iter()
        .enumerate()
        .filter(|(index, _)| used.contains(index))
        .map(|(index, part)| format!("{} = {}", letter(index), part.name))
        .collect();
    let made_by = format!("{text}; {}", names.join("; "));
    let mut made = Found {
        notes: found.notes,
        step_nm: found.step_nm,
        first_nm: inputs
            .iter()
            .map(|part| part.samples.nm().to_vec())
            .collect(),
        lines: found.points.into_iter().map(LineRow::of_quotient).collect(),
        intervals: found.intervals,
        ..Found::of(found.result, made_by, from)
    };
    if let Some(sum) = sum_of(formula, parts) {
        made = of_composite(made, sum)?;
    }
    made.tell_lines();
    Ok(made)
}

/// Lights brought to one scale; all else as it is.
///
/// # Errors
/// A sentence for a light that has nothing to divide by.
pub(super) fn at_equal(parts: &[Part], by: Option<Normalise>) -> Result<Vec<Part>, String> {
    let brought = |part: &Part| match by.filter(|_| part.of.quantity == Quantity::Light) {
        Some(by) => Ok(Part {
            of: normalised(&part.of, by).map_err(said)?,
            composite: None,
            ..part.clone()
        }),
        None => Ok(part.clone()),
    };
    parts.iter().map(brought).collect()
}

/// Words of a reference or a sample that a quotient is of a surface for.
const OF_SURFACES: [&str; 6] = [
    "reflect",
    "white standard",
    "white reference",
    "white tile",
    "spectralon",
    "ptfe",
];

/// A quotient of two lights is a transmittance unless it is of a surface, which a person or the
/// inputs' own names say.
pub(super) fn name_quotient(
    found: &mut Found,
    formula: &Formula,
    parts: &[Part],
    of_surface: bool,
) {
    let says_so = |part: &Part| {
        let name = part.of.name.to_lowercase();
        OF_SURFACES.iter().any(|word| name.contains(word))
    };
    let is_light = |part: &Part| matches!(part.of.quantity, Quantity::Light | Quantity::Counts);
    let mut used = formula.letters().into_iter().filter_map(|i| parts.get(i));
    let is_surface = used.all(is_light) && (of_surface || parts.iter().any(says_so));
    let result = found.result_mut();
    if result.quantity == Quantity::Transmittance && is_surface {
        result.quantity = Quantity::Reflectance;
    }
}

/// The sum of composites on their own numbers, where the formula is one and all inputs are.
fn sum_of(formula: &Formula, parts: &[Part]) -> Option<(Composite, bool)> {
    let factors = formula.factors()?;
    let used = factors.iter().copied().zip(parts);
    of_summands(used.filter(|(by, _)| *by != 0.0))
}

/// A weighted sum of parts that are composites, their lines by name and place; `None` where one is
/// none, or the ranges differ.
pub(super) fn of_summands<'a>(
    parts: impl Iterator<Item = (f64, &'a Part)>,
) -> Option<(Composite, bool)> {
    let summand = |(by, part): (f64, &'a Part)| {
        let of = part.composite.as_deref()?;
        let places: Vec<f64> = of.lines().iter().map(|line| line.at_nm).collect();
        Some(Summand {
            by,
            of,
            names: names_of_lines(&part.of.samples, &places),
            u_at_nm: part.of.axis_nm,
        })
    };
    sum_of_composites(&parts.map(summand).collect::<Option<Vec<_>>>()?)
}

/// A result that is a composite, and whether a series was brought to another basis: its table and its
/// lines are that one's.
pub(super) fn of_composite(
    mut made: Found,
    (composite, is_brought): (Composite, bool),
) -> Result<Found, String> {
    if is_brought {
        let why = said!("Cosine and Fourier series are added through the 1 nm grid.");
        made.notes.push(why.to_owned());
    }
    let band = composite.band();
    let samples = Sampled::new(band.grid().collect(), composite.on_band());
    let mut result = made.result().clone();
    result.samples = samples.map_err(said)?;
    (result.sigma, result.mask) = (None, Vec::new());
    made.lines = composite
        .lines()
        .iter()
        .map(|line| LineRow::of_composite(line, composite.power()))
        .collect();
    made.step_nm = 1.0;
    made.result = Some(result);
    made.composite = Some(composite);
    Ok(made)
}

/// Two ranges of one light as one; `is_sound` where their axes are known to be right.
///
/// # Errors
/// A sentence where they share too little.
pub(super) fn of_ranges(parts: &[Measurement], is_sound: bool) -> Result<Found, String> {
    let [first, second] = parts else {
        return Err(said!("expected 2 ranges of one light").to_owned());
    };
    let spliced = splice(first, second, is_sound).map_err(said)?;
    let made_by = format!("splice of {} and {}", first.name, second.name);
    let half = OF_95 * spliced.u * spliced.factor;
    let [from, to] = spliced.overlap_nm.map(|nm| with_sign(nm.to_string()));
    let note = tr!(
        "From {from} to {to} nm both are there: the second is multiplied by {factor}.",
        from,
        to,
        factor = with_half(spliced.factor, Some(half))
    );
    let mut found = Found::of(spliced.result.clone(), made_by, doubt_from(parts));
    found.first_nm = parts
        .iter()
        .map(|part| part.samples.nm().to_vec())
        .collect();
    found.notes.push(note);
    found.splice = Some(spliced);
    found.tell_lines();
    Ok(found)
}
