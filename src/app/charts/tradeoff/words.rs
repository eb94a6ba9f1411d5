//! How many numbers a spectrum needs to stay under an error, in sentences.

use super::{spikes_words, waves_words};
use crate::{
    app::studies::SweepAsk,
    io::many::numbers,
    languages::{said, with_colon, with_sign},
    study::{Measure, Sweep, SweepPoint},
};

/// The two errors that the sentences ask about, in the figure's unit.
pub fn limits(measure: Measure) -> [f64; 2] {
    if measure.is_colour() {
        [1.0, 0.1]
    } else {
        [10.0, 1.0]
    }
}

/// The cheapest model under an error, in the figure's unit.
fn enough<'a>(
    sweep: &'a Sweep,
    front: &[usize],
    measure: Measure,
    limit: f64,
) -> Option<&'a SweepPoint> {
    let figure = measure.figure();
    let mut points = front.iter().map(|index| &sweep.points[*index]);
    points.find(|point| {
        let error = point.verdict[measure];
        error.is_some_and(|error| figure.shown(error) < limit)
    })
}

/// How many numbers a spectrum needs to stay under two errors, the larger first: a sentence, and
/// the models that do.
pub fn needs(
    ask: &SweepAsk,
    sweep: &Sweep,
    front: &[usize],
    (measure, limits): (Measure, [f64; 2]),
) -> [String; 2] {
    let of = measure.figure().goal();
    let goal = |limit: f64| match measure.is_colour() {
        true => format!("ΔE₀₀ {}", with_sign(limit.to_string())),
        false => format!("{} %", with_sign(limit.to_string())),
    };
    let name = ask.about.subject.0.name();
    let [large, small] = limits.map(goal);
    let found = limits.map(|limit| enough(sweep, front, measure, limit));
    let sentence = match found {
        [None, _] => tr!(
            "No model shown here, up to {waves}, stays under {large} {of}.",
            waves = waves_words(sweep.map.highest_order),
            large,
            of
        ),
        [Some(first), None] => tr!(
            "{name} needs {numbers} to stay under {large} {of}; no model shown here stays under \
             {small}.",
            name,
            numbers = numbers(first.numbers),
            large,
            of,
            small
        ),
        [Some(first), Some(second)] if first.numbers == second.numbers => tr!(
            "{name} needs {numbers} to stay under {large} {of}, and stays under {small} with \
             them, too.",
            name,
            numbers = numbers(first.numbers),
            large,
            of,
            small
        ),
        [Some(first), Some(second)] => tr!(
            "{name} needs {numbers} to stay under {large} {of}, and {more} to stay under {small}.",
            name,
            numbers = numbers(first.numbers),
            large,
            of,
            more = second.numbers,
            small
        ),
    };
    let models = found.into_iter().flatten();
    let mut models: Vec<String> = models
        .map(|point| with_colon(numbers(point.numbers), way_words(point) + "."))
        .collect();
    models.dedup();
    [sentence, models.join(" ")]
}

/// A model within a sentence: "cosine, colour-exact, 4 waves, 3 lines".
fn way_words(point: &SweepPoint) -> String {
    let basis = said(point.way.basis.name());
    let (waves, lines) = (waves_words(point.order), spikes_words(point.spikes));
    match point.way.colour_exact {
        true => tr!(
            "{basis}, colour-exact, {waves}, {lines}",
            basis,
            waves,
            lines
        ),
        false => format!("{basis}, {waves}, {lines}"),
    }
}
