//! Beside a larger collection: its figures and this race's, the differences in words, and both
//! halves of the result: what the composite wins and what it loses.

use super::{error_words, figure, place};
use crate::{
    app::{
        FIRST_PATCH_SET,
        studies::{Field, RaceAsk},
    },
    color::Observer,
    io::many::capitalised,
    rivals::Family,
    spectrum::{Band, SpikeSettings},
    study::{
        Measure, Race, Spread,
        race::{Racer, figures},
        race_reference::{Beside, CHECKED, CHECKED_NUMBERS, OTHER_HALF, TABLE},
    },
};

/// The figures of both, in words.
pub struct Larger {
    /// What a sentence says for each class and measure: who wins, and by how much.
    pub halves: Vec<(&'static str, Vec<String>)>,
    /// Both tables; none where the settings are not those of the larger collection.
    pub tables: Option<Tables>,
}

/// This race beside the larger collection.
pub struct Tables {
    /// A representation, its figures in each column, and what they say.
    pub lines: Vec<(Racer, [Option<Beside>; 7], String)>,
    /// Title and cells `[ours, theirs]` a line.
    pub checked: Vec<(String, Vec<[String; 2]>)>,
    /// What the composite does not win, in sentences.
    pub others: Vec<String>,
}

impl Larger {
    /// The comparison of a race over a whole set; `None` where single lights race.
    pub fn new(ask: &RaceAsk, race: &Race, budget: usize) -> Option<Self> {
        let whole = match ask.field {
            Field::Shipped | Field::Class(_) | Field::Group(_) => true,
            Field::One(_) | Field::These(_) => false,
        };
        if !whole {
            return None;
        }
        let halves = [
            (Measure::Patches, "On the patches"),
            (Measure::Filters, "Behind narrow filters"),
            (
                Measure::RmsBlurred,
                "For the spectrum itself, behind a 10 nm blur",
            ),
        ]
        .into_iter()
        .map(|(measure, title)| (title, sentences(race, budget, measure)))
        .filter(|(_, sentences)| !sentences.is_empty())
        .collect();
        Some(Self {
            halves,
            tables: comparable(ask).then(|| Tables::of(race)),
        })
    }
}

impl Tables {
    fn of(race: &Race) -> Self {
        let lines = TABLE
            .iter()
            .map(|line| {
                let cells = line.beside(race);
                let words = line.explained(&cells);
                (line.racer, cells, words)
            })
            .collect();
        Self {
            lines,
            checked: checked(race),
            others: others(race),
        }
    }
}

/// Whether the race was run as the larger collection was.
fn comparable(ask: &RaceAsk) -> bool {
    ask.band == Band::VISIBLE
        && ask.observer == Observer::CIE_1931
        && ask.patches.set == FIRST_PATCH_SET
        && ask.patches.own.is_empty()
        && ask.spikes == SpikeSettings::default()
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
    let (composite, rival) = (composite.title(), rival_words(rival));
    Some(if ours.median < theirs.median {
        format!(
            "{class}: the composite wins: {ours_words} ({composite}) against {theirs_words} of \
             {rival}."
        )
    } else {
        format!(
            "{class}: the composite loses: {rival} {theirs_words} against {ours_words} of the best \
             composite ({composite})."
        )
    })
}

/// A rival in the middle of a sentence.
fn rival_words(racer: Racer) -> &'static str {
    match racer {
        Racer::Rival(family) => family.about().in_a_sentence,
        other => other.title(),
    }
}

fn pair(spread: [f64; 3]) -> String {
    spread.map(figure).join("/")
}

fn checked(race: &Race) -> Vec<(String, Vec<[String; 2]>)> {
    let Some(budget) = race.budgets.iter().position(|n| *n == CHECKED_NUMBERS) else {
        return Vec::new();
    };
    CHECKED
        .iter()
        .filter(|line| race.classes().contains(&line.class))
        .map(|line| {
            let cells = [
                (Racer::Chosen, line.chosen),
                (Racer::Rival(Family::Moments), line.moments),
                (Racer::Rival(Family::Principal), line.principal),
            ]
            .into_iter()
            .map(|(racer, theirs)| {
                let row = place(race, racer).map(|p| race.row(Some(line.class), budget, p));
                let ours = row.and_then(|row| row.check);
                let ours = ours.map_or_else(|| "–".to_owned(), |s| pair(figures(s)));
                [ours, pair(theirs)]
            })
            .collect();
            (line.class.to_owned(), cells)
        })
        .collect()
}

/// The half that the composite does not win, on fluorescent lights.
fn others(race: &Race) -> Vec<String> {
    let class = "fluorescent";
    let Some(budget) = race.budgets.iter().position(|n| *n == CHECKED_NUMBERS) else {
        return Vec::new();
    };
    if !race.classes().contains(&class) {
        return Vec::new();
    }
    let mut words = vec![format!(
        "On fluorescent lights at {CHECKED_NUMBERS} numbers, behind narrow filters (median/95th \
         percentile/worst) and rms behind 10 nm (median/95th percentile):"
    )];
    for other in OTHER_HALF {
        let Some(place) = place(race, other.racer) else {
            continue;
        };
        let spread = |measure| race.spread(Some(class), budget, place, measure);
        let both = spread(Measure::Filters).zip(spread(Measure::RmsBlurred));
        let Some((filters, rms)) = both else {
            continue;
        };
        words.push(format!(
            "{}: {} and {}/{} here, {} and {}/{} in the larger collection.",
            other.racer.title(),
            pair(figures(filters)),
            figure(rms.median),
            figure(rms.p95),
            pair(other.filters),
            figure(other.rms_blurred[0]),
            figure(other.rms_blurred[1]),
        ));
    }
    let (mut without, mut all) = (0, 0);
    if let Some(place) = place(race, Racer::Chosen) {
        for lamp in race.of_class(Some(class)) {
            all += 1;
            without += usize::from(race.run(lamp, budget, place).spikes == 0);
        }
        let with = best(race, (class, budget, Measure::Filters), is_composite);
        let best = with.map_or_else(String::new, |(racer, spread)| {
            format!(
                " Behind narrow filters the best composite is {}, median {}.",
                racer.title(),
                figure(spread.median)
            )
        });
        words.push(format!(
            "The choice is by the patches alone: on {without} of {all} lights it takes no spike.{best}"
        ));
    }
    words
}
