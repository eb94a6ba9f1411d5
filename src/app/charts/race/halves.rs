//! Both halves of the result in words: what the composite wins and what it loses.

use super::error_words;
use crate::{
    app::studies::{Field, RaceAsk},
    io::many::capitalised,
    languages::said,
    study::{Measure, Race, Spread, race::Racer},
};

/// A measure's title, and a sentence for each class: who wins, and by how much.
pub type Half = (&'static str, Vec<String>);

/// What the composite wins and loses over a whole set; `None` where single lights race.
pub fn halves(ask: &RaceAsk, race: &Race, budget: usize) -> Option<Vec<Half>> {
    if matches!(ask.field, Field::One(_) | Field::These(_)) {
        return None;
    }
    let measures = [
        (Measure::Patches, said!("On the surfaces")),
        (Measure::Filters, said!("Behind narrow filters")),
        (
            Measure::RmsBlurred,
            said!("For the spectrum itself, behind a 10 nm blur"),
        ),
    ];
    let halves = measures.map(|(measure, title)| (title, sentences(race, budget, measure)));
    let said = halves.into_iter().filter(|(_, said)| !said.is_empty());
    Some(said.collect())
}

/// Who wins a measure on each class, and by how much.
fn sentences(race: &Race, budget: usize, measure: Measure) -> Vec<String> {
    let classes = race.classes();
    classes
        .into_iter()
        .filter_map(|class| sentence(race, class, budget, measure))
        .collect()
}

/// Of some racers the one with the least median.
fn best(
    race: &Race,
    (class, budget, measure): (&str, usize, Measure),
    wanted: impl Fn(&Racer) -> bool,
) -> Option<(Racer, Spread)> {
    let racers = race.racers.iter().copied().enumerate();
    racers
        .filter(|(_, racer)| wanted(racer))
        .filter_map(|(i, racer)| Some((racer, race.spread(Some(class), budget, i, measure)?)))
        .min_by(|a, b| a.1.median.total_cmp(&b.1.median))
}

fn is_composite(racer: &Racer) -> bool {
    matches!(racer, Racer::Composite(_))
}

fn sentence(race: &Race, class: &str, budget: usize, measure: Measure) -> Option<String> {
    let of = (class, budget, measure);
    let (composite, ours) = best(race, of, is_composite)?;
    let (rival, theirs) = best(race, of, |racer| matches!(racer, Racer::Rival(_)))?;
    let words = |spread: Spread| error_words(measure, Some(spread.median));
    let (ours_words, theirs_words) = (words(ours), words(theirs));
    let class = capitalised(class);
    let (composite, rival) = (said(composite.title()), rival_words(rival));
    Some(if ours.median < theirs.median {
        tr!(
            "{class}: the composite wins: {ours_words} ({composite}) against {theirs_words} of \
             {rival}.",
            class,
            ours_words,
            composite,
            theirs_words,
            rival
        )
    } else {
        tr!(
            "{class}: the composite loses: {rival} {theirs_words} against {ours_words} of the \
             best composite ({composite}).",
            class,
            rival,
            theirs_words,
            ours_words,
            composite
        )
    })
}

/// A rival in the middle of a sentence.
fn rival_words(racer: Racer) -> &'static str {
    match racer {
        Racer::Rival(family) => said(family.about().in_a_sentence),
        other => said(other.title()),
    }
}
