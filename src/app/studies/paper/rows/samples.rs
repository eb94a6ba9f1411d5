//! The claim that 20 numbers are enough in place of 400 samples.

use super::super::{
    Claims,
    row::{Row, Verdict},
};
use crate::{
    app::{
        numbers::{delta_e, percent},
        ticks::short,
    },
    io::many::numbers,
    languages::said,
    study::{
        Measure,
        truth::{self, Match, SamplesAgainstNumbers},
    },
};

pub(in crate::app::studies::paper) fn samples_row(claims: &Claims) -> Row {
    let row = |measured: String, verdict, condition: String| Row {
        claim: said!("20 numbers instead of 400 samples"),
        place: said(truth::STATED_SAMPLES.place),
        paper: tr!(
            "From 380 to 780 nm at least {samples} samples to avoid missing any spikes, or about \
             {numbers} numbers: {background} for the background and {spikes} for the spikes.",
            samples = short(truth::STATED_SAMPLES.figure),
            numbers = short(truth::STATED_NUMBERS.figure),
            background = short(truth::STATED_BACKGROUND.figure),
            spikes = short(truth::STATED_SPIKE_NUMBERS.figure)
        ),
        measured,
        verdict,
        condition,
    };
    let Some(found) = &claims.samples else {
        let why = said!("the spectrum is zero over the whole range").to_owned();
        return row(String::new(), Verdict::Open, why);
    };
    let numbers = found.numbers();
    let needed = found.needed;
    let measured = format!("{} {}", what_they_leave(found), what_does_as_well(found));
    // A count that does as well where the samples happen to fall well is no proof.
    let judged = [Measure::Own, Measure::Rms, Measure::RmsBlurred]
        .map(|measure| Some(needed[measure]?.at_best.samples > numbers));
    let good = judged.map(|is_good| is_good == Some(true));
    let (verdict, condition) = if !judged.contains(&Some(false)) {
        (
            Verdict::Holds,
            tr!(
                "more than {numbers} samples are needed for the same",
                numbers
            ),
        )
    } else if !good.contains(&true) {
        (
            Verdict::Fails,
            tr!("{numbers} samples or fewer do as well here", numbers),
        )
    } else {
        (Verdict::OnlyIf, good_for(good).to_owned())
    };
    row(measured, verdict, condition)
}

/// What the model's numbers leave of the light, a sentence.
fn what_they_leave(found: &SamplesAgainstNumbers) -> String {
    let errors = found.composite;
    let (background, spikes, lines) = (found.background, 2 * found.spikes, found.spikes);
    let all = numbers(found.numbers());
    let (rms, blurred) = (
        percent(errors[Measure::Rms]),
        percent(errors[Measure::RmsBlurred]),
    );
    match errors[Measure::Own] {
        Some(own) => tr!(
            "{numbers} ({background} for the background, {spikes} for {n} line) leave an own \
             colour off by ΔE₀₀ {own}, rms {rms} % at 1 nm (where a line of some width counts as \
             missed by its spike) and {blurred} % behind 10 nm."
                | "{numbers} ({background} for the background, {spikes} for {n} lines) leave an \
                   own colour off by ΔE₀₀ {own}, rms {rms} % at 1 nm (where a line of some width \
                   counts as missed by its spike) and {blurred} % behind 10 nm."
                    % lines,
            numbers = all,
            background,
            spikes,
            own = delta_e(own),
            rms,
            blurred
        ),
        None => tr!(
            "{numbers} ({background} for the background, {spikes} for {n} line) leave rms {rms} % \
             at 1 nm (where a line of some width counts as missed by its spike) and {blurred} % \
             behind 10 nm."
                | "{numbers} ({background} for the background, {spikes} for {n} lines) leave rms \
                   {rms} % at 1 nm (where a line of some width counts as missed by its spike) and \
                   {blurred} % behind 10 nm."
                    % lines,
            numbers = all,
            background,
            spikes,
            rms,
            blurred
        ),
    }
}

/// How many samples do as well, a sentence.
fn what_does_as_well(found: &SamplesAgainstNumbers) -> String {
    let needed = found.needed;
    let both = |m: Match| {
        let (surely, best) = (m.surely.samples, m.at_best.samples);
        if surely == best {
            surely.to_string()
        } else {
            tr!(
                "{surely} ({best} where they happen to fall well)",
                surely,
                best
            )
        }
    };
    let samples = |measure| needed[measure].map_or_else(String::new, both);
    let (rms, blurred) = (samples(Measure::Rms), samples(Measure::RmsBlurred));
    match needed[Measure::Own] {
        Some(own) => tr!(
            "Even samples joined by straight lines, every count tried, that do as well: own \
             colour {own}, rms {rms}, behind 10 nm {blurred}.",
            own = both(own),
            rms,
            blurred
        ),
        None => tr!(
            "Even samples joined by straight lines, every count tried, that do as well: rms \
             {rms}, behind 10 nm {blurred}.",
            rms,
            blurred
        ),
    }
}

/// What fewer numbers are good for: the light's own colour, the spectrum at 1 nm and behind a slit.
fn good_for(good: [bool; 3]) -> &'static str {
    match good {
        [true, true, _] => said!("for own colour and the spectrum at 1 nm"),
        [true, false, true] => said!("for own colour and the spectrum behind 10 nm"),
        [true, false, false] => said!("for own colour"),
        [false, true, true] => said!("for the spectrum at 1 nm and the spectrum behind 10 nm"),
        [false, true, false] => said!("for the spectrum at 1 nm"),
        [false, false, _] => said!("for the spectrum behind 10 nm"),
    }
}
