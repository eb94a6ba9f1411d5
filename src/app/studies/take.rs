//! From a step of an auction to the document: the order and the lines bought, and no others.

use super::AuctionAsk;
use crate::{
    app::{
        command::Command,
        settings::{Detector, Settings},
    },
    spectrum::{Decomposition, HandSpike, Line, SpikeEdits, decompose, detect_shapes},
    study::{Auction, auction::Step},
};

/// Rounds in which lines that turn up beside those left in are left in too.
const ROUNDS: usize = 4;

/// A line found nearer than this to its place is that line, nm.
const SAME_PLACE_NM: f64 = 0.5;

/// The model of a step, as one change of the document.
///
/// The lines not bought are left in the smooth part. Where that keeps a bought one from being
/// found (it stands beside a stronger line that was not bought), the bought lines are locked
/// instead. Where no line was bought, spikes are switched off; where widths were bought, the lines
/// are as wide as they are.
pub fn take(settings: Settings, ask: &AuctionAsk, auction: &Auction, step: &Step) -> Command {
    let none = step.lines.is_empty() && !auction.lines.is_empty();
    Command::TakeModel {
        settings: Settings {
            basis: ask.terms.basis,
            colour_exact: ask.terms.colour_exact,
            order: step.order,
            spikes: !none,
            wide_lines: step.wide,
            detector: Detector::Energy,
            ..settings
        },
        edits: if none {
            SpikeEdits::default()
        } else {
            edits(ask, auction, step)
        },
    }
}

/// Hand edits under which the detector finds the lines of a step.
fn edits(ask: &AuctionAsk, auction: &Auction, step: &Step) -> SpikeEdits {
    let about = &ask.about;
    let values = about.subject.0.on_band(about.band);
    let (parts, shapes) = detect_shapes(about.band, &values, about.spikes);
    // By place: the auction saw the spectrum at another scale, and rounding may change an order.
    let is_bought = |found: &Line| {
        let mut places = step.lines.iter().map(|line| auction.lines[*line].at_nm);
        places.any(|at_nm| (found.at_nm - at_nm).abs() < SAME_PLACE_NM)
    };
    let (bought, others): (Vec<Line>, Vec<Line>) =
        shapes.iter().map(|shape| shape.spike).partition(is_bought);
    let left = SpikeEdits {
        hand: Vec::new(),
        deleted_nm: others.iter().map(|spike| spike.at_nm).collect(),
    };
    // What is left in changes what is found beside it: a few rounds settle that.
    let settled = |mut edits: SpikeEdits| {
        for _ in 0..ROUNDS {
            let found = decompose(about.band, &values, about.spikes, &edits).plain_spikes();
            let others = found.iter().filter(|spike| !is_bought(spike));
            let others: Vec<f64> = others.map(|spike| spike.at_nm).collect();
            if others.is_empty() {
                return (found.len() == bought.len()).then_some(edits);
            }
            edits.deleted_nm.extend(others);
        }
        None
    };
    let locked = || SpikeEdits {
        hand: bought.iter().map(|spike| locked(*spike, &parts)).collect(),
        deleted_nm: left.deleted_nm.clone(),
    };
    settled(left.clone())
        .or_else(|| settled(locked()))
        .unwrap_or_else(|| left.clone())
}

/// A found line as a locked spike.
fn locked(spike: Line, parts: &Decomposition) -> HandSpike {
    let found = parts.spikes.iter().find(|found| found.spike == spike);
    HandSpike {
        at_nm: spike.at_nm,
        weight: spike.weight,
        line_nm: Some(spike.at_nm),
        window_nm: found.map(|found| found.window_nm),
        is_dip: spike.weight < 0.0,
    }
}
