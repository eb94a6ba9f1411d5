//! What is said of the better light, a function for each purpose.

use super::{Predicate, Win};
use crate::app::numbers::fixed;

/// How much more one gives.
enum More {
    /// Per cent more.
    Share(String),
    /// So many times as much.
    Times(String),
    Far,
}

impl Win {
    fn more(self) -> More {
        match self.ratio {
            r if r < 2.0 => More::Share(fixed(100.0 * (r - 1.0), 0)),
            r if r < 100.0 => More::Times(fixed(r, 1)),
            _ => More::Far,
        }
    }
}

pub(super) fn colours(win: Win) -> Predicate {
    let words = match win.is_much {
        true => [
            said!("shows colours much better"),
            said!("colours much better"),
        ],
        false => [said!("shows colours better"), said!("colours better")],
    };
    Predicate::new("shows", words)
}

pub(super) fn skin(win: Win) -> Predicate {
    let words = match win.is_much {
        true => [
            said!("shows light skin much better"),
            said!("light skin much better"),
        ],
        false => [said!("shows light skin better"), said!("light skin better")],
    };
    Predicate::new("shows", words)
}

pub(super) fn reds(win: Win) -> Predicate {
    let words = match win.is_much {
        true => [
            said!("shows strong reds much better"),
            said!("strong reds much better"),
        ],
        false => [
            said!("shows strong reds better"),
            said!("strong reds better"),
        ],
    };
    Predicate::new("shows", words)
}

pub(super) fn evening(win: Win) -> Predicate {
    let words = match win.is_much {
        true => [
            said!("suits the evening much better at the same lux"),
            said!("the evening much better at the same lux"),
        ],
        false => [
            said!("suits the evening better at the same lux"),
            said!("the evening better at the same lux"),
        ],
    };
    Predicate::new("suits", words)
}

pub(super) fn day(win: Win) -> Predicate {
    let words = match win.is_much {
        true => [
            said!("suits the day much better at the same lux"),
            said!("the day much better at the same lux"),
        ],
        false => [
            said!("suits the day better at the same lux"),
            said!("the day better at the same lux"),
        ],
    };
    Predicate::new("suits", words)
}

pub(super) fn cameras(win: Win) -> Predicate {
    let words = match win.is_much {
        true => [
            said!("serves cameras much better"),
            said!("cameras much better"),
        ],
        false => [said!("serves cameras better"), said!("cameras better")],
    };
    Predicate::new("serves", words)
}

pub(super) fn night(win: Win) -> Predicate {
    let words = match win.more() {
        More::Share(share) => [
            tr!(
                "gives eyes that are used to the dark {share} % more light at the same lux",
                share
            ),
            tr!(
                "eyes that are used to the dark {share} % more light at the same lux",
                share
            ),
        ],
        More::Times(times) => [
            tr!(
                "gives eyes that are used to the dark {times} times the light at the same lux",
                times
            ),
            tr!(
                "eyes that are used to the dark {times} times the light at the same lux",
                times
            ),
        ],
        More::Far => [
            said!("gives eyes that are used to the dark far more light at the same lux").to_owned(),
            said!("eyes that are used to the dark far more light at the same lux").to_owned(),
        ],
    };
    Predicate::new("gives", words)
}

pub(super) fn energy(win: Win) -> Predicate {
    let words = match win.more() {
        More::Share(share) => [
            tr!("gives {share} % more light per watt of radiation", share),
            tr!("{share} % more light per watt of radiation", share),
        ],
        More::Times(times) => [
            tr!("gives {times} times the light per watt of radiation", times),
            tr!("{times} times the light per watt of radiation", times),
        ],
        More::Far => [
            said!("gives far more light per watt of radiation").to_owned(),
            said!("far more light per watt of radiation").to_owned(),
        ],
    };
    Predicate::new("gives", words)
}

pub(super) fn plants(win: Win) -> Predicate {
    let words = match win.more() {
        More::Share(share) => [
            tr!(
                "gives plants {share} % more photons per watt of radiation",
                share
            ),
            tr!("plants {share} % more photons per watt of radiation", share),
        ],
        More::Times(times) => [
            tr!(
                "gives plants {times} times the photons per watt of radiation",
                times
            ),
            tr!(
                "plants {times} times the photons per watt of radiation",
                times
            ),
        ],
        More::Far => [
            said!("gives plants far more photons per watt of radiation").to_owned(),
            said!("plants far more photons per watt of radiation").to_owned(),
        ],
    };
    Predicate::new("gives", words)
}

pub(super) fn reading(_: Win) -> Predicate {
    let words = said!("reaches the Ra of 80 that EN 12464-1 asks for at desks");
    Predicate::new("reaches", [words, words])
}
