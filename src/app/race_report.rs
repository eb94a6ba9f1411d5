//! The race as JSON and CSV: what the command line prints and the window saves.
//!
//! The JSON's keys are stable. A number that does not exist is `null` in JSON and an empty cell in
//! CSV, never NaN. Colour differences are CIEDE2000, relative errors shares of the spectrum (not
//! percent).

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::{
    cells::{line, number, words},
    product_report::spread_json,
    studies::{CHECK_SET, Field, RaceAsk},
    study_report::{errors, lines_json, lines_words, program},
};
use crate::{
    io::{many::many, one_line},
    study::{
        Measure, Race, Spread,
        race::{Judged, Racer, Row},
    },
};

/// The lights of a race in words.
pub fn field_words(field: &Field) -> String {
    match field {
        Field::One(entry) => entry.0.name().to_owned(),
        Field::Shipped => "all shipped lights".to_owned(),
        Field::Class(class) => format!("shipped lights: {}", class.word()),
        Field::Group(group) => format!("group {group}"),
        Field::These(entries) => many(entries.len(), "own light", "own lights"),
    }
}

/// The sets that a race is counted over: each class and all together, or the only class there is.
pub fn sets(race: &Race) -> Vec<(String, Option<String>)> {
    let classes = race.classes();
    let of = |class: &&str| ((*class).to_owned(), Some((*class).to_owned()));
    let mut sets: Vec<_> = classes.iter().map(of).collect();
    if classes.len() > 1 {
        sets.push(("all".to_owned(), None));
    }
    sets
}

/// On how many lights of a set each racer has the least error; `None` for the choice among others.
pub fn wins(
    race: &Race,
    class: Option<&str>,
    budget: usize,
    measure: Measure,
) -> Vec<Option<usize>> {
    let winners: Vec<Option<Racer>> = race
        .of_class(class)
        .map(|lamp| race.winner_on(lamp, budget, measure))
        .collect();
    let count = |racer: &Racer| winners.iter().filter(|w| **w == Some(*racer)).count();
    race.racers
        .iter()
        .map(|racer| (*racer != Racer::Chosen).then(|| count(racer)))
        .collect()
}

/// The spreads of a row with the keys that files use: first what decides wins, and what took no
/// part in a choice.
fn spreads(row: &Row) -> Vec<(&'static str, Option<Spread>)> {
    let patches = ("delta_e_patches", row.spreads[Measure::Patches]);
    let others = errors()
        .filter(|(_, measure)| !matches!(measure, Measure::Patches | Measure::PatchesWorst))
        .map(|(key, measure)| (key, row.spreads[measure]));
    let mut all = vec![patches, ("delta_e_check", row.check)];
    all.extend(others);
    all
}

/// All numbers of a row with the names of their columns.
pub fn row_numbers(row: &Row) -> Vec<(String, Option<f64>)> {
    let mut all = Vec::new();
    for (key, spread) in spreads(row) {
        for (part, value) in [
            ("median", spread.map(|s| s.median)),
            ("p95", spread.map(|s| s.p95)),
            ("worst", spread.map(|s| s.worst)),
        ] {
            all.push((format!("{key}_{part}"), value));
        }
    }
    let cost = row.cost;
    all.extend([
        ("negative_lobes".to_owned(), Some(row.negative_lobes)),
        ("bytes".to_owned(), cost.map(|c| c.bytes as f64)),
        ("ns_per_product".to_owned(), cost.map(|c| c.ns_per_product)),
        (
            "ns_per_evaluation".to_owned(),
            cost.map(|c| c.ns_per_evaluation),
        ),
    ]);
    all
}

fn row_json(row: &Row, set: &str, wins: Option<usize>) -> Value {
    let (racer, cost) = (row.racer, row.cost);
    let mut entry = json!({
        "representation": racer.word(),
        "title": racer.title(),
        "numbers": row.numbers,
        "set": set,
        "lamps": row.lamps,
        "negative_lobes": row.negative_lobes,
        "bytes": cost.map(|c| c.bytes),
        "ns_per_product": cost.map(|c| c.ns_per_product),
        "ns_per_evaluation": cost.map(|c| c.ns_per_evaluation),
        "needs_table": racer.needs_table(),
        "is_prefix": racer.is_prefix(),
        "wins": wins,
    });
    for (key, spread) in spreads(row) {
        entry[key] = spread_json(spread);
    }
    entry
}

/// Every row of a race: count by count, set by set, racer by racer, with its wins on the patches.
fn rows(race: &Race) -> Vec<(Row, String, Option<usize>)> {
    let sets = sets(race);
    let mut rows = Vec::new();
    for budget in 0..race.budgets.len() {
        for (name, class) in &sets {
            let wins = wins(race, class.as_deref(), budget, Measure::Patches);
            for (racer, wins) in wins.into_iter().enumerate() {
                let row = race.row(class.as_deref(), budget, racer);
                rows.push((row, name.clone(), wins));
            }
        }
    }
    rows
}

/// A race as JSON. `wins` counts the lights on which a representation has the least error on the
/// patches.
pub fn race_json(ask: &RaceAsk, race: &Race) -> Value {
    let all: Vec<Value> = rows(race)
        .iter()
        .map(|(row, set, wins)| row_json(row, set, *wins))
        .collect();
    let mut winners = Vec::new();
    for (lamp, (name, set)) in race.lamps.iter().enumerate() {
        for (budget, numbers) in race.budgets.iter().enumerate() {
            let winner = race.winner_on(lamp, budget, Measure::Patches);
            winners.push(json!({
                "lamp": name,
                "set": set,
                "numbers": numbers,
                "representation": winner.map(Racer::word),
            }));
        }
    }
    json!({
        "program": program(),
        "field": field_words(&ask.field),
        "settings": {
            "range_nm": [ask.band.min_nm(), ask.band.max_nm()],
            "observer": ask.observer.word(),
            "patches": ask.patches.words(),
            "check": CHECK_SET,
            "lines": lines_json(ask.spikes),
        },
        "cost_of": race.cost_of,
        "rows": all,
        "winners": winners,
        "judged": judged_json(ask, race),
    })
}

/// Everybody who is in the cells: known lamps and wide lines, then whom they are compared with.
pub fn in_cells(race: &Race) -> Vec<Racer> {
    let ours = [Racer::KnownLamps, Racer::WideLines, Racer::Chosen];
    let rivals = |racer: &Racer| matches!(racer, Racer::Rival(_));
    let rivals = race.racers.iter().copied().filter(rivals);
    ours.into_iter().chain(rivals).collect()
}

/// Errors on what took no part in any choice, and the cells that known lamps and wide lines win;
/// nothing where they do not race.
fn judged_json(ask: &RaceAsk, race: &Race) -> Option<Value> {
    let counts = ask.judged_counts();
    if counts.is_empty() || !race.racers.contains(&Racer::KnownLamps) {
        return None;
    }
    let racers = in_cells(race);
    let mut rows = Vec::new();
    for class in race.classes() {
        for (budget, numbers) in race.budgets.iter().enumerate() {
            for racer in racers.iter().filter(|_| counts.contains(numbers)) {
                let mut row = json!({
                    "set": class,
                    "numbers": numbers,
                    "representation": racer.word(),
                    "needs_table": racer.needs_table(),
                });
                for error in Judged::ALL {
                    row[error.word()] =
                        spread_json(race.judged(Some(class), budget, *racer, error));
                }
                rows.push(row);
            }
        }
    }
    let mut cells = Vec::new();
    for ours in [Racer::KnownLamps, Racer::WideLines] {
        for peer in racers.iter().filter(|r| !Racer::ENCODED.contains(r)) {
            let wins = race.cells(ours, *peer, &counts);
            let behind = wins.behind.iter().map(|cell| {
                json!({
                    "set": cell.class, "numbers": cell.numbers, "error": cell.error.word(),
                    "figure": cell.figure, "ours": cell.values[0], "theirs": cell.values[1],
                })
            });
            cells.push(json!({
                "representation": ours.word(), "against": peer.word(), "won": wins.won(),
                "of": wins.of, "per_cent": wins.per_cent(), "behind": behind.collect::<Vec<_>>(),
            }));
        }
    }
    Some(json!({
        "count": if ask.strict { "strict" } else { "words" },
        "left_out": "the light, its namesakes and its likes",
        "rows": rows,
        "cells": cells,
    }))
}

/// Where the figures of a race come from, line by line.
pub fn race_notes(ask: &RaceAsk) -> Vec<String> {
    vec![
        format!("field: {}", one_line(&field_words(&ask.field))),
        format!(
            "settings: {}-{} nm, {}, patches {}, check {}, {}; wins are by delta_e_patches",
            ask.band.min_nm(),
            ask.band.max_nm(),
            ask.observer.title(),
            ask.patches.words(),
            CHECK_SET,
            lines_words(ask.spikes),
        ),
        format!(
            "written by: Spectral Explorer {}",
            env!("CARGO_PKG_VERSION")
        ),
    ]
}

/// A race as a table, one representation, count and set a line; `more` are comments above it.
pub fn race_csv(ask: &RaceAsk, race: &Race, more: &[String]) -> String {
    let mut out = "# title: representations at equal counts of numbers\n".to_owned();
    for note in race_notes(ask).iter().chain(more) {
        let _ = writeln!(out, "# {note}");
    }
    let _ = writeln!(
        out,
        "# costs: measured in this run on {}, the light with most lines",
        one_line(&race.cost_of)
    );
    for (i, (row, set, wins)) in rows(race).iter().enumerate() {
        let numbers = row_numbers(row);
        if i == 0 {
            out.push_str("representation,title,numbers,set,lamps");
            for (key, _) in &numbers {
                let _ = write!(out, ",{key}");
            }
            out.push_str(",needs_table,is_prefix,wins\n");
        }
        let mut cells = vec![
            row.racer.word().to_owned(),
            words(row.racer.title()),
            row.numbers.to_string(),
            words(set),
            row.lamps.to_string(),
        ];
        cells.extend(numbers.into_iter().map(|(_, value)| number(value)));
        cells.extend([
            row.racer.needs_table().to_string(),
            row.racer.is_prefix().to_string(),
            wins.map(|w| w.to_string()).unwrap_or_default(),
        ]);
        out.push_str(&line(cells));
    }
    out
}
