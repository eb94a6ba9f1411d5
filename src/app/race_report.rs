//! The race as JSON and CSV: what the command line prints and the window saves.
//!
//! The JSON's keys are stable. A number that does not exist is `null` in JSON and an empty cell in
//! CSV, never NaN. Colour differences are CIEDE2000, relative errors shares of the spectrum (not
//! percent).

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::{
    cells::{Columns, Table, cell},
    product_report::spread_json,
    studies::{CHECK_SET, Field, RaceAsk},
    study_report::{errors, lines_json, lines_words, program},
    ticks::short,
};
use crate::{
    io::one_line,
    study::{
        Measure, Race, Spread,
        race::{Judged, Racer, Row},
    },
};

/// The lights of a race in words.
pub fn field_words(field: &Field) -> String {
    match field {
        Field::One(entry) => entry.0.name().to_owned(),
        Field::Shipped => said!("all shipped lights").to_owned(),
        Field::Class(class) => tr!("shipped lights: {class}", class = class.word()),
        Field::Group(group) => tr!("group {group}", group),
        Field::These(entries) => tr!("{n} own light" | "{n} own lights" % entries.len()),
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

/// What rows have spreads of, with the keys that files use: first what decides wins, and what took
/// no part in a choice, which is no measure.
fn spreads() -> impl Iterator<Item = (&'static str, Option<Measure>)> {
    let others = errors()
        .filter(|(_, measure)| !matches!(measure, Measure::Patches | Measure::PatchesWorst))
        .map(|(key, measure)| (key, Some(measure)));
    let first = [
        ("delta_e_patches", Some(Measure::Patches)),
        ("delta_e_check", None),
    ];
    first.into_iter().chain(others)
}

/// A racer's row of a set, with its wins on the patches.
type SetRow = (Row, String, Option<usize>);

/// The columns of a race that are numbers of a row.
fn with_numbers(mut columns: Columns<'_, SetRow>) -> Columns<'_, SetRow> {
    type Part = (&'static str, fn(&Spread) -> f64);
    let parts: [Part; 3] = [
        ("median", |s| s.median),
        ("p95", |s| s.p95),
        ("worst", |s| s.worst),
    ];
    for (key, measure) in spreads() {
        for (part, of) in parts {
            columns.push(format!("{key}.{part}"), move |(row, ..)| {
                let spread = measure.map_or(row.check, |measure| row.spreads[measure]);
                cell(spread.as_ref().map(of))
            });
        }
    }
    columns
        .with("negative_lobes", |(row, ..)| cell(row.negative_lobes))
        .with("bytes", |(row, ..)| cell(row.cost.map(|c| c.bytes)))
        .with("ns_per_product", |(row, ..)| {
            cell(row.cost.map(|c| c.ns_per_product))
        })
        .with("ns_per_evaluation", |(row, ..)| {
            cell(row.cost.map(|c| c.ns_per_evaluation))
        })
}

/// The numbers of rows with the names of their columns.
pub fn row_numbers(rows: Vec<Row>) -> Vec<(String, Vec<Option<f64>>)> {
    let rows = rows.into_iter().map(|row| (row, String::new(), None));
    Table::new("", with_numbers(Columns::default()), rows).numbers()
}

/// Every row of a race: count by count, set by set, racer by racer, with its wins on the patches.
fn rows(race: &Race) -> Vec<SetRow> {
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
        "rows": race_table(ask, race, &[]).json(),
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
        tr!("field: {field}", field = one_line(&field_words(&ask.field))),
        tr!(
            "settings: {min}-{max} nm, {observer}, surfaces {surfaces}, check {check}, {lines}; \
             wins are by delta_e_patches",
            min = short(ask.band.min_nm()),
            max = short(ask.band.max_nm()),
            observer = ask.observer.title(),
            surfaces = ask.patches.words(),
            check = CHECK_SET,
            lines = lines_words(ask.spikes)
        ),
        tr!(
            "written by: Spectral Explorer {version}",
            version = env!("CARGO_PKG_VERSION")
        ),
    ]
}

/// A race as a table, one representation, count and set a row; `more` are comments above it.
pub fn race_table(ask: &RaceAsk, race: &Race, more: &[String]) -> Table {
    let mut out = "# title: representations at equal counts of numbers\n".to_owned();
    for note in race_notes(ask).iter().chain(more) {
        let _ = writeln!(out, "# {note}");
    }
    let _ = writeln!(
        out,
        "# costs: measured in this run on {}, the light with most lines",
        one_line(&race.cost_of)
    );
    let columns = Columns::<SetRow>::default()
        .with("representation", |(row, ..)| cell(row.racer.word()))
        .with("title", |(row, ..)| cell(row.racer.title()))
        .with("numbers", |(row, ..)| cell(row.numbers))
        .with("set", |(_, set, _)| cell(set.as_str()))
        .with("lamps", |(row, ..)| cell(row.lamps));
    let columns = with_numbers(columns)
        .with("needs_table", |(row, ..)| cell(row.racer.needs_table()))
        .with("is_prefix", |(row, ..)| cell(row.racer.is_prefix()))
        .with("wins", |(.., wins)| cell(*wins));
    Table::new(out, columns, rows(race))
}
