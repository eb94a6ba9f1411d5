//! Accuracy against numbers: the sweep, the auction and their promises on the shipped lamps.

mod common;

use std::sync::Arc;

use common::{on_band, values};
use proptest::prelude::*;
use spectral_explorer::{
    app::library::Library,
    color::{Observer, patches::PatchSet},
    spectrum::{Band, Basis, Kind, NamedSpectrum, SpikeSettings},
    study::{
        Goal, Judge, Measure, Progress, Sweep, Way, Yardsticks,
        auction::{Auction, Ended, Purchase, Terms, hold},
        sweep::Subject,
    },
};

const BAND: Band = Band::VISIBLE;

/// The yardsticks with the 24 patches of the ColorChecker.
fn yardsticks(band: Band) -> Arc<Yardsticks> {
    let group = Library::bundled()
        .group("colorchecker_ohta")
        .expect("the ColorChecker is shipped");
    let (names, reflectances): (Vec<String>, Vec<Vec<f64>>) = group
        .items
        .iter()
        .filter_map(|p| p.spectrum())
        .map(|s| (s.name.clone(), values(s, band)))
        .unzip();
    let set = PatchSet::new(&reflectances, names, band, Observer::Cie1931);
    Arc::new(Yardsticks::new(set))
}

fn subject(values: Vec<f64>) -> Subject {
    Subject {
        yardsticks: yardsticks(BAND),
        values,
        under: None,
        spikes: SpikeSettings::default(),
    }
}

/// The lamps of the shipped collection, one table of each.
fn lamps() -> Vec<&'static NamedSpectrum> {
    Library::bundled()
        .spectra()
        .filter(|s| s.kind == Kind::Light)
        .collect()
}

fn auction(name: &str, basis: Basis, colour_exact: bool, goal: Goal, numbers: usize) -> Auction {
    let terms = Terms {
        basis,
        colour_exact,
        goal,
        numbers,
    };
    hold(&subject(on_band(name, BAND)), terms, &Progress::default()).expect("a light that shines")
}

fn bought_lines(auction: &Auction) -> Vec<f64> {
    let bought = auction.steps.iter().flat_map(|s| &s.bought);
    bought
        .filter_map(|p| match p {
            Purchase::Spike(spike) => Some(spike.at_nm),
            Purchase::Order(_) => None,
        })
        .collect()
}

#[test]
fn prints() {
    for basis in Basis::ALL {
        for exact in [false, true] {
            for (word, goal) in Goal::PLAIN {
                for lamp in ["FL2", "CIE D65"] {
                    let a = auction(lamp, basis, exact, goal, 41);
                    println!(
                        "== {lamp} {} exact {exact} {word}: {:?}",
                        basis.word(),
                        a.ended
                    );
                    for s in &a.steps {
                        let w = |p: &Vec<Purchase>| {
                            p.iter()
                                .map(|p| match p {
                                    Purchase::Order(n) => format!("N{n}"),
                                    Purchase::Spike(s) => format!("{:.1}", s.at_nm),
                                })
                                .collect::<Vec<_>>()
                                .join("+")
                        };
                        println!(
                            "  P {:2} {:.5}  +[{}] -[{}]",
                            s.numbers,
                            s.error,
                            w(&s.bought),
                            w(&s.gave_back)
                        );
                    }
                }
            }
        }
    }
}
