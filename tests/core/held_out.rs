//! Known lamps and wide lines on lamps that are no known lamps and took no part in any choice: their
//! cosine with every known lamp is below .9999.

use std::sync::Arc;

use spectral_explorer::{
    app::{
        ByAddress, Document, Entry, Library,
        studies::{Field, Question, RaceAsk},
    },
    spectrum::{Band, NamedSpectrum, Sampled},
    study::{Progress, Race, race::Racer},
};

use super::lamps::{files_of_others, likeness_to_known, measured_lamps};

const COUNTS: [usize; 3] = [11, 20, 31];

fn race_of(lamps: Vec<(String, Vec<f64>)>) -> Race {
    let preset = Library::bundled().find("CIE A").expect("it is shipped");
    let shipped = Entry::of_preset(preset).expect("it is a table");
    let entry = |(number, (name, values)): (u64, (String, Vec<f64>))| {
        let samples = Sampled::even(Band::VISIBLE.min_nm(), 1.0, values).expect("a table");
        let spectrum = NamedSpectrum {
            name,
            samples,
            ..shipped.spectrum.clone()
        };
        ByAddress(Arc::new(Entry::own(number, spectrum)))
    };
    let field = Field::These((1..).zip(lamps).map(entry).collect());
    let document = Document::about(Arc::new(shipped.clone()));
    let ask = RaceAsk::of(&document, field, COUNTS.to_vec());
    ask.answer(&Progress::default()).expect("lights that shine")
}

/// Cells that a way wins from all other representations, and cells in all.
fn won(race: &Race, ours: Racer) -> [usize; 2] {
    let peers = race.racers.iter().filter(|r| matches!(r, Racer::Rival(_)));
    peers.fold([0, 0], |[won, of], peer| {
        let wins = race.cells(ours, *peer, &COUNTS);
        println!(
            "{} against {}: {} of {}",
            ours.word(),
            peer.word(),
            wins.won(),
            wins.of
        );
        wins.behind.iter().for_each(|cell| println!("   {cell:?}"));
        [won + wins.won(), of + wins.of]
    })
}

fn are_told_best_by_known_lamps_and_wide_lines(lamps: Vec<(String, Vec<f64>)>) {
    for (name, values) in &lamps {
        assert!(likeness_to_known(values) < 0.9999, "{name}");
    }
    let count = lamps.len();
    let race = race_of(lamps);
    let of = [Racer::KnownLamps, Racer::WideLines].map(|ours| won(&race, ours));
    println!(
        "{count} lamps: known lamps {:?}, wide lines {:?}",
        of[0], of[1]
    );
    for [won, of] in of {
        // Three errors, three figures of their spread, three counts and six representations.
        assert_eq!(of, 162);
        assert!(2 * won > of, "{won} of {of}");
    }
}

#[test]
fn measured_lamps_that_nothing_was_made_from_are_told_best_by_known_lamps_and_wide_lines() {
    are_told_best_by_known_lamps_and_wide_lines(measured_lamps());
}

#[test]
fn so_are_the_lamps_in_the_files_of_others() {
    let lamps = files_of_others();
    if lamps.is_empty() {
        println!("skipped: the folder of others' files is not at hand");
        return;
    }
    are_told_best_by_known_lamps_and_wide_lines(lamps);
}
