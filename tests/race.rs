//! The race on the shipped lamps, beside the figures of a larger collection.

use std::time::Instant;

use spectral_explorer::{
    app::{
        Document, Entry,
        library::Library,
        studies::{Field, RaceAsk},
    },
    study::{Progress, Race, race},
};

fn document() -> Document {
    let first = Library::bundled().find("FL11").expect("FL11 is shipped");
    Document::about(Entry::of_preset(first).expect("it is a table").into())
}

fn race_of(field: Field, budgets: &[usize]) -> Race {
    let ask = RaceAsk::of(&document(), field, budgets.to_vec());
    let t = Instant::now();
    let (course, lamps) = (ask.course(), ask.lamps());
    println!("course of {} lamps in {:?}", lamps.len(), t.elapsed());
    let t = Instant::now();
    let r = race::run(&course, &lamps, &Progress::default()).expect("lights that shine");
    println!("race in {:?}", t.elapsed());
    r
}

#[test]
fn prints() {
    let race = race_of(Field::Shipped, &[8, 11, 15, 20, 25, 31, 41]);
    for (b, numbers) in race.budgets.iter().enumerate() {
        if ![11, 20, 31].contains(numbers) {
            continue;
        }
        println!("== P = {numbers}");
        for class in race.classes() {
            println!("-- {class} ({})", race.of_class(Some(class)).count());
            for r in 0..race.racers.len() {
                let row = race.row(Some(class), b, r);
                let s = |s: Option<spectral_explorer::study::Spread>| {
                    s.map_or("-".into(), |s| {
                        format!("{:8.4}/{:7.3}/{:6.2}", s.median, s.p95, s.worst)
                    })
                };
                println!(
                    "{:32} patches {} ces {} own {} filt {} rms10 {} neg {:.2} ns {:6.0} {:5.1} B {}",
                    row.racer.title(),
                    s(row.patches),
                    s(row.check),
                    s(row.own),
                    s(row.filters),
                    s(row.relative_rms_10nm),
                    row.negative_lobes,
                    row.cost.map_or(0.0, |c| c.ns_per_product),
                    row.cost.map_or(0.0, |c| c.ns_per_evaluation),
                    row.cost.map_or(0, |c| c.bytes)
                );
            }
        }
    }
}
