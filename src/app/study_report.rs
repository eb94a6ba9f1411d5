//! Sweep and auction as JSON and CSV: what the command line prints and the window saves.
//!
//! The JSON's keys are stable. A number that does not exist is `null` in JSON and an empty cell in
//! CSV, never NaN. Wavelengths are nm, colour differences CIEDE2000, relative errors shares of the
//! spectrum (not percent).

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::{
    cells::{Columns, Table, cell, comments},
    export,
    state::App,
    studies::{About, AuctionAsk, SweepAsk},
    ticks::short,
};
use crate::{
    io::{Provenance, many::numbers, one_line},
    languages::with_sign,
    spectrum::{Kind, SpikeSettings},
    study::{
        Auction, Measure, Sweep, SweepPoint,
        auction::{Bid, Ended, Purchase, Step},
    },
};

/// The errors that models are compared by, with the keys that files use.
pub fn errors() -> impl Iterator<Item = (&'static str, Measure)> {
    Measure::in_files().map(|measure| (measure.figure().key, measure))
}

/// The figure that decides which models of a sweep are on the front: the patches' mean, or the own
/// colour of a spectrum that has no patches, or the spectrum itself where nothing is seen of it.
pub fn front_measure(sweep: &Sweep) -> Measure {
    let has = |measure: &Measure| {
        let points = &sweep.points;
        points.iter().any(|point| point.verdict[*measure].is_some())
    };
    [Measure::Patches, Measure::Own, Measure::RmsBlurred]
        .into_iter()
        .find(has)
        .unwrap_or_default()
}

/// The program that writes.
pub fn program() -> Value {
    json!({ "name": env!("CARGO_PKG_NAME"), "version": env!("CARGO_PKG_VERSION") })
}

fn input_json(app: &App) -> Value {
    let spectrum = &app.document().subject_entry().spectrum;
    json!({
        "name": spectrum.name,
        "kind": spectrum.kind.word(),
        "unit": spectrum.unit,
        "source": spectrum.source,
        "points": spectrum.samples.len(),
        "notes": spectrum.notes,
        "light": (spectrum.kind != Kind::Light).then(|| app.document().light.name()),
    })
}

/// How lines are looked for.
pub fn lines_json(spikes: SpikeSettings) -> Value {
    json!({
        "threshold_percent": 100.0 * spikes.threshold,
        "max_width_nm": spikes.max_width_nm,
        "dips": spikes.dips,
    })
}

fn about_json(about: &About) -> Value {
    json!({
        "range_nm": [about.band.min_nm(), about.band.max_nm()],
        "observer": about.observer.word(),
        "patches": about.patches.set,
        "lines": lines_json(about.spikes),
    })
}

/// The same in words.
pub fn lines_words(spikes: SpikeSettings) -> String {
    let share = short(100.0 * spikes.threshold);
    let width = with_sign(spikes.max_width_nm.to_string());
    match spikes.dips {
        true => tr!(
            "lines from {share} % of the power and up to {width} nm wide, dips too",
            share,
            width
        ),
        false => tr!(
            "lines from {share} % of the power and up to {width} nm wide",
            share,
            width
        ),
    }
}

/// Comment lines about the spectrum that a study is of.
fn head(app: &App, about: &About, title: &str, more: &str) -> String {
    let provenance = Provenance {
        scale_words: String::new(),
        settings: format!(
            "{}-{} nm, {}, surfaces {}, {}{more}",
            about.band.min_nm(),
            about.band.max_nm(),
            about.observer.title(),
            about.patches.set,
            lines_words(about.spikes),
        ),
        ..export::provenance(app)
    };
    let spectrum = &app.document().subject_entry().spectrum;
    let mut out = format!("# title: {title}\n{}", comments(&provenance, spectrum));
    for note in &spectrum.notes {
        // Writing to a String cannot fail.
        let _ = writeln!(out, "# note: {}", one_line(note));
    }
    out
}

pub fn sweep_json(app: &App, ask: &SweepAsk, sweep: &Sweep) -> Value {
    let measure = front_measure(sweep);
    let map = &sweep.map;
    let rows = |measure: Measure| -> Vec<Vec<Option<f64>>> {
        let rows = map.verdicts.chunks(map.highest_order + 1);
        rows.map(|row| row.iter().map(|verdict| verdict[measure]).collect())
            .collect()
    };
    let mut threshold_map = json!({
        "basis": ask.basis.word(),
        "colour_exact": ask.colour_exact,
        "thresholds_percent": map.thresholds_percent,
        "spikes": map.spikes,
        "orders": (0..=map.highest_order).collect::<Vec<_>>(),
    });
    for (key, measure) in errors() {
        threshold_map[key] = json!(rows(measure));
    }
    json!({
        "program": program(),
        "input": input_json(app),
        "settings": about_json(&ask.about),
        "front_of": measure.figure().key,
        "points": sweep_table(app, ask, sweep).json(),
        "threshold_map": threshold_map,
    })
}

/// A sweep as a table, one model a row.
pub fn sweep_table(app: &App, ask: &SweepAsk, sweep: &Sweep) -> Table {
    let measure = front_measure(sweep);
    let front = sweep.front(measure, |_| true);
    let more = format!("; on_front is by {}", measure.figure().key);
    let mut columns = Columns::<(usize, &SweepPoint)>::default()
        .with("way", |(_, point)| cell(point.way.word()))
        .with("basis", |(_, point)| cell(point.way.basis.word()))
        .with("spikes", |(_, point)| cell(point.way.spikes))
        .with("spike_count", |(_, point)| cell(point.spikes))
        .with("colour_exact", |(_, point)| cell(point.way.colour_exact))
        .with("order", |(_, point)| cell(point.order))
        .with("numbers", |(_, point)| cell(point.numbers));
    for (key, measure) in errors() {
        let error = move |(_, point): &(usize, &SweepPoint)| cell(point.verdict[measure]);
        columns.push(key, error);
    }
    columns.push("on_front", |(index, _)| cell(front.contains(index)));
    let comments = head(app, &ask.about, "error against numbers", &more);
    Table::new(comments, columns, sweep.points.iter().enumerate())
}

/// One purchase in files: every step has as many as it bought, the first one order 0.
struct Bought<'a> {
    /// The step's place on the path, from 0: what was bought together has the same.
    place: usize,
    step: &'a Step,
    purchase: Purchase,
    /// The first purchase of its step, which carries what was given back.
    first: bool,
}

fn purchases(auction: &Auction) -> Vec<Bought<'_>> {
    let mut all = Vec::new();
    for (place, step) in auction.steps.iter().enumerate() {
        let bought = if step.bought.is_empty() {
            vec![Purchase::Order(step.order)]
        } else {
            step.bought.clone()
        };
        for (i, purchase) in bought.into_iter().enumerate() {
            all.push(Bought {
                place,
                step,
                purchase,
                first: i == 0,
            });
        }
    }
    all
}

/// Largest value of the subject, by which weights are multiplied to be in the file's unit.
fn unit_of(about: &About) -> f64 {
    let values = about.subject.0.on_band(about.band);
    values.iter().fold(0.0, |most: f64, v| most.max(v.abs()))
}

/// A purchase; `what` is the key of what was bought or given back.
fn purchase_json(what: &str, purchase: Purchase, unit: f64) -> Value {
    match purchase {
        Purchase::Widths => json!({ what: "width" }),
        Purchase::Order(order) => json!({ what: "order", "order": order }),
        Purchase::Line(spike) => {
            json!({ what: "spike", "at_nm": spike.at_nm, "weight": spike.weight * unit })
        }
    }
}

pub fn auction_json(app: &App, ask: &AuctionAsk, auction: &Auction) -> Value {
    let unit = unit_of(&ask.about);
    let places =
        |step: &Step| -> Vec<f64> { step.lines.iter().map(|i| auction.lines[*i].at_nm).collect() };
    let steps: Vec<Value> = purchases(auction)
        .into_iter()
        .map(|bought| {
            let Bought {
                place,
                step,
                purchase,
                first,
            } = bought;
            let gave_back = step.gave_back.iter().filter(|_| first);
            let gave_back = gave_back.map(|back| purchase_json("what", *back, unit));
            let mut entry = purchase_json("bought", purchase, unit);
            entry["step"] = json!(place);
            entry["numbers"] = json!(step.numbers);
            entry["error"] = json!(step.error);
            entry["order_now"] = json!(step.order);
            entry["spikes_nm_now"] = json!(places(step));
            entry["wide_lines_now"] = json!(step.wide);
            entry["gave_back"] = gave_back.collect();
            for (key, measure) in errors() {
                entry[key] = json!(step.verdict[measure]);
            }
            entry
        })
        .collect();
    let bids = |bids: &[Bid]| -> Vec<Value> {
        bids.iter()
            .map(|Bid { numbers, error }| json!({ "numbers": numbers, "error": error }))
            .collect()
    };
    let terms = ask.terms;
    let [own, patches, spectrum, filters] = terms.goal.weights();
    let ended = match auction.ended {
        Ended::Spent => "spent",
        Ended::NothingHelps => "nothing_helps",
    };
    json!({
        "program": program(),
        "input": input_json(app),
        "settings": about_json(&ask.about),
        "goal": terms.goal.words(),
        "goal_weights": {
            "own": own, "patches": patches, "spectrum": spectrum, "filters": filters,
        },
        "basis": terms.basis.word(),
        "colour_exact": terms.colour_exact,
        "numbers": terms.numbers,
        "ended": ended,
        "steps": steps,
        "with": bids(&auction.with),
        "without": bids(&auction.without),
    })
}

/// An auction as a table, one purchase a row.
pub fn auction_table(app: &App, ask: &AuctionAsk, auction: &Auction) -> Table {
    let terms = ask.terms;
    let unit = unit_of(&ask.about);
    let more = format!(
        "; goal {}, {}{}, at most {}, ended: {}",
        terms.goal.words(),
        terms.basis.word(),
        if terms.colour_exact {
            ", colour-exact"
        } else {
            ""
        },
        numbers(terms.numbers),
        match auction.ended {
            Ended::Spent => "all was spent",
            Ended::NothingHelps => "nothing helps any more",
        },
    );
    let line = |bought: &Bought<'_>| match bought.purchase {
        Purchase::Line(spike) => Some(spike),
        _ => None,
    };
    let mut columns = Columns::<Bought<'_>>::default()
        .with("step", |bought| cell(bought.place))
        .with("bought", |bought| {
            cell(match bought.purchase {
                Purchase::Widths => "width",
                Purchase::Order(_) => "order",
                Purchase::Line(_) => "spike",
            })
        })
        .with("at_nm", |bought| {
            cell(line(bought).map(|spike| spike.at_nm))
        })
        .with("weight", |bought| {
            cell(line(bought).map(|spike| spike.weight * unit))
        })
        .with("order", |bought| match bought.purchase {
            Purchase::Order(order) => cell(order),
            _ => cell(None::<usize>),
        })
        .with("numbers", |bought| cell(bought.step.numbers))
        .with("error", |bought| cell(bought.step.error))
        .with("order_now", |bought| cell(bought.step.order))
        .with("spikes_now", |bought| cell(bought.step.lines.len()))
        .with("gave_back", |bought| {
            let back = bought.step.gave_back.iter().filter(|_| bought.first);
            let back = back.map(|purchase| match purchase {
                Purchase::Widths => "width".to_owned(),
                Purchase::Order(order) => format!("order {order}"),
                Purchase::Line(spike) => format!("{:.1} nm", spike.at_nm),
            });
            cell(back.collect::<Vec<_>>().join(" and "))
        });
    for (key, measure) in errors() {
        let error = move |bought: &Bought<'_>| cell(bought.step.verdict[measure]);
        columns.push(key, error);
    }
    columns.push("wide_lines_now", |bought| cell(bought.step.wide));
    let comments = head(app, &ask.about, "auction", &more);
    Table::new(comments, columns, purchases(auction))
}
