//! The race on the shipped lamps: its promises, and the figures of a larger collection beside it.

use std::sync::{Arc, LazyLock};

use spectral_explorer::{
    app::{
        ByAddress, Document, Entry, Library,
        chart::{Marks, Theme},
        charts::race::{CELLS_AT, error_chart, table_chart},
        figures::SMALLEST,
        pages::RACE_BUDGETS,
        studies::{Field, Question, RaceAsk},
    },
    color::Observer,
    lamps::{Count, Encoder, LeaveOut, Racing},
    rivals::{Family, PrincipalBasis},
    spectrum::{Band, Kind, NamedSpectrum, Sampled, SpikeSettings},
    study::{
        Measure, Progress, Race, Training, TrainingSpectrum,
        race::{self, Judged, Lamp, RaceConfig, Racer},
        race_reference::{COLUMNS, TABLE},
    },
};

const BAND: Band = Band::VISIBLE;

/// The race of all shipped lights at all counts, run once.
static ALL: LazyLock<(RaceAsk, Race)> = LazyLock::new(|| {
    let ask = ask(Field::Shipped, &RACE_BUDGETS);
    let race = ask.answer(&Progress::default()).expect("lights that shine");
    (ask, race)
});

fn ask(field: Field, budgets: &[usize]) -> RaceAsk {
    RaceAsk::of(&Document::about(entry("FL11")), field, budgets.to_vec())
}

fn entry(name: &str) -> Arc<Entry> {
    let preset = Library::bundled().find(name).expect("it is shipped");
    Entry::of_preset(preset).expect("it is a table").into()
}

fn place(race: &Race, racer: Racer) -> usize {
    let found = race.racers.iter().position(|r| *r == racer);
    found.expect("everybody races")
}

fn budget(race: &Race, numbers: usize) -> usize {
    let found = race.budgets.iter().position(|n| *n == numbers);
    found.expect("it is one of the counts")
}

fn median(race: &Race, class: &str, numbers: usize, racer: Racer) -> f64 {
    let row = race.row(Some(class), budget(race, numbers), place(race, racer));
    row.spreads[Measure::Patches].expect("visible light").median
}

fn teachers(lamps: &[Lamp]) -> Vec<TrainingSpectrum> {
    let teacher = |lamp: &Lamp| TrainingSpectrum {
        name: lamp.name.clone(),
        class: lamp.class.clone(),
        values: lamp.values.clone(),
    };
    lamps.iter().map(teacher).collect()
}

/// Planck's law, equal to 1 at 560 nm.
fn blackbody(kelvin: f64, nm: f64) -> f64 {
    const C2_NM_KELVIN: f64 = 1.4388e7;
    let bottom = |nm: f64| (C2_NM_KELVIN / (nm * kelvin)).exp_m1();
    (560.0 / nm).powi(5) * bottom(560.0) / bottom(nm)
}

/// 20 temperatures from 2000 to 20000 K, in even ratios.
fn temperatures() -> impl Iterator<Item = f64> {
    (0..20).map(|i| 2000.0 * 10_f64.powf(f64::from(i) / 19.0))
}

#[test]
fn nobody_spends_more_than_the_count() {
    let (_, race) = &*ALL;
    for lamp in 0..race.lamps.len() {
        for (b, numbers) in race.budgets.iter().enumerate() {
            for (r, racer) in race.racers.iter().enumerate() {
                let run = race.run(lamp, b, r);
                assert!(run.numbers <= *numbers, "{}: {run:?}", racer.title());
                assert!(2 * run.spikes < run.numbers, "{}: {run:?}", racer.title());
                if matches!(racer, Racer::Rival(_)) {
                    assert_eq!(run.spikes, 0);
                }
            }
        }
    }
}

#[test]
fn the_choice_is_never_worse_on_the_patches_than_any_composite() {
    let (_, race) = &*ALL;
    let chosen = place(race, Racer::Chosen);
    for lamp in 0..race.lamps.len() {
        for b in 0..race.budgets.len() {
            let of = |r: usize| race.run(lamp, b, r).verdict[Measure::Patches].expect("visible");
            for (r, racer) in race.racers.iter().enumerate() {
                if matches!(racer, Racer::Composite(_)) {
                    assert!(
                        of(chosen) <= of(r),
                        "{}: {}",
                        race.lamps[lamp].0,
                        racer.word()
                    );
                }
            }
        }
    }
}

#[test]
fn a_row_is_the_spread_of_its_runs_by_hand() {
    let (_, race) = &*ALL;
    let (b, r) = (budget(race, 20), place(race, Racer::Rival(Family::Bins)));
    let row = race.row(Some("discharge"), b, r);
    let mut errors: Vec<f64> = race
        .of_class(Some("discharge"))
        .map(|lamp| race.run(lamp, b, r).verdict[Measure::Filters].expect("visible"))
        .collect();
    errors.sort_by(f64::total_cmp);
    assert_eq!((row.lamps, errors.len()), (18, 18));
    let filters = row.spreads[Measure::Filters].expect("visible");
    assert!((filters.median - 0.5 * (errors[8] + errors[9])).abs() < 1e-12);
    // 95 % of 17 steps is 16.15 steps.
    let p95 = errors[16] + 0.15 * (errors[17] - errors[16]);
    assert!((filters.p95 - p95).abs() < 1e-12);
    assert_eq!(filters.worst, errors[17]);
    let lobes = race
        .of_class(Some("discharge"))
        .filter(|lamp| race.run(*lamp, b, r).verdict[Measure::Lowest].expect("lit") < -1e-3)
        .count();
    assert_eq!(row.negative_lobes, lobes as f64 / 18.0);
}

#[test]
fn a_winner_has_the_least_error_and_the_choice_wins_nothing() {
    let (_, race) = &*ALL;
    let b = budget(race, 20);
    for lamp in 0..race.lamps.len() {
        let winner = race.winner_on(lamp, b, Measure::Filters).expect("visible");
        assert_ne!(winner, Racer::Chosen);
        let of = |r: usize| race.run(lamp, b, r).verdict[Measure::Filters].expect("visible");
        let least = (0..race.racers.len()).map(of).fold(f64::INFINITY, f64::min);
        assert_eq!(of(place(race, winner)), least);
    }
}

#[test]
fn every_light_runs_as_it_would_alone_so_the_time_is_linear_in_lights() {
    let (whole, all) = &*ALL;
    let lamps = whole.lamps();
    let course = RaceConfig {
        budgets: vec![11, 20],
        ..whole.course()
    };
    let few: Vec<Lamp> = lamps.iter().step_by(31).cloned().collect();
    let race = race::run(&course, &few, &Progress::default()).expect("lights that shine");
    for (i, lamp) in (0..lamps.len()).step_by(31).enumerate() {
        assert_eq!(race.lamps[i], all.lamps[lamp]);
        for (b, numbers) in race.budgets.iter().enumerate() {
            for (r, racer) in race.racers.iter().enumerate() {
                // Tables that hold more components catch the same with their first ones, but
                // choose among classes with fewer at hand.
                if *racer == Racer::Rival(Family::Principal) {
                    continue;
                }
                let (here, there) = (race.run(i, b, r), all.run(lamp, budget(all, *numbers), r));
                assert_eq!(here.numbers, there.numbers, "{}", racer.word());
                let [here, there] = [here, there].map(|run| run.verdict[Measure::Patches]);
                let off = (here.expect("visible") - there.expect("visible")).abs();
                assert!(off < 1e-6, "{} {}: {off}", race.lamps[i].0, racer.word());
            }
        }
    }
}

#[test]
fn principal_components_never_saw_the_light_they_are_fitted_to() {
    let lamps = ask(Field::Shipped, &[20]).lamps();
    let training = Training::new(BAND, &teachers(&lamps), 20);
    let caught = |basis: &PrincipalBasis, values: &[f64]| -> f64 {
        let whole = BAND.inner(values, values);
        let rows = basis.rows().iter().take(20);
        rows.map(|row| BAND.inner(row, values).powi(2)).sum::<f64>() / whole
    };
    // Trained on its own class with it, a table of as many components as there are lamps has all.
    for class in ["LED", "discharge", "smooth"] {
        let own: Vec<Vec<f64>> = lamps
            .iter()
            .filter(|lamp| lamp.class == class)
            .map(|lamp| lamp.values.clone())
            .collect();
        let with = PrincipalBasis::train(BAND, &own, own.len());
        let mut lost = 0;
        for lamp in lamps.iter().filter(|lamp| lamp.class == class) {
            let without = training.basis_for(&lamp.name, &lamp.values, 20);
            let all: f64 = {
                let rows = with.rows().iter();
                rows.map(|row| BAND.inner(row, &lamp.values).powi(2))
                    .sum::<f64>()
                    / BAND.inner(&lamp.values, &lamp.values)
            };
            assert!(all > 0.999, "{}: {all}", lamp.name);
            lost += usize::from(caught(without, &lamp.values) < all - 1e-6);
            // Neither another name nor another scale brings the light itself back.
            let twice: Vec<f64> = lamp.values.iter().map(|v| 2.0 * v).collect();
            assert!(Arc::ptr_eq(without, training.basis_for("?", &twice, 20)));
        }
        let count = own.len();
        assert!(
            3 * lost >= 2 * count,
            "{class}: {lost} of {count} lose something"
        );
    }
}

/// Where medians are further apart than [`NOTABLE`]: the shipped lights' over the larger
/// collection's. The reasons are tests of their own below.
const APART: [(&str, &str, usize, f64); 13] = [
    ("cosine", "smooth", 11, 1.58),
    ("cosine+spikes", "smooth", 11, 1.58),
    ("cosine-exact", "smooth", 20, 2.61),
    ("cosine-exact+spikes", "smooth", 20, 2.61),
    ("legendre", "fluorescent", 11, 0.608),
    ("legendre", "fluorescent", 31, 0.594),
    ("legendre", "smooth", 20, 1.64),
    ("moments", "fluorescent", 11, 0.64),
    ("principal", "LED", 20, 4.84),
    ("principal", "discharge", 20, 2.47),
    ("principal", "fluorescent", 20, 2.05),
    ("principal", "smooth", 11, 2.60),
    ("principal", "smooth", 20, 29.4),
];

#[test]
fn every_line_of_the_larger_collection_is_met_or_explained() {
    let (_, race) = &*ALL;
    for line in &TABLE {
        let cells = line.beside(race);
        let mut text = format!("{:34}", line.racer.title());
        for (cell, column) in cells.iter().zip(COLUMNS) {
            let beside = cell.expect("all classes and counts race");
            assert_eq!(beside.column, column);
            let known = APART.iter().find(|(word, class, numbers, _)| {
                (*word, *class, *numbers) == (line.racer.word(), column.class, column.numbers)
            });
            let place = format!("{} {column:?}", line.racer.title());
            assert_eq!(known.is_some(), beside.differs(), "{place}");
            if let Some((.., factor)) = known {
                // Three digits are written above.
                let off = beside.factor() / factor - 1.0;
                assert!(off.abs() < 0.01, "{place}: {}", beside.factor());
            }
            text += &format!(
                " {}{}: {:.3}/{:.2} ({:.3}/{:.2})",
                column.class,
                column.numbers,
                beside.ours.median,
                beside.ours.p95,
                beside.theirs.median,
                beside.theirs.p95
            );
        }
        let words = line.explained(&cells);
        println!("{text}\n    {words}");
        let apart = cells.iter().flatten().filter(|c| c.differs()).count();
        assert_eq!(apart > 0, words.starts_with("Apart"), "{words}");
        assert!(!words.contains("The lights are others"), "{words}");
    }
}

#[test]
fn blackbodies_alone_are_as_smooth_as_the_larger_collection() {
    let of = |kelvin: f64| {
        let values = (360..=830)
            .map(|nm| blackbody(kelvin, f64::from(nm)))
            .collect();
        let spectrum = NamedSpectrum {
            name: format!("{kelvin:.0} K"),
            kind: Kind::Light,
            samples: Sampled::even(360.0, 1.0, values).expect("a table"),
            ..entry("CIE A").spectrum.clone()
        };
        ByAddress(Arc::new(Entry::own(1, spectrum)))
    };
    let ask = ask(Field::These(temperatures().map(of).collect()), &[11, 20]);
    let race = ask.answer(&Progress::default()).expect("they shine");
    let find = |word: &str| {
        let found = race.racers.iter().copied().find(|r| r.word() == word);
        found.expect("everybody races")
    };
    let of = |numbers: usize, word: &str| median(&race, "own", numbers, find(word));
    let close = |found: f64, told: f64| assert!((found / told - 1.0).abs() < 0.05, "{found}");
    close(of(11, "cosine"), 0.24);
    close(of(20, "cosine-exact"), 0.0018);
    close(of(20, "legendre"), 0.0125);
    // What stands beside them in the words: one daylight.
    let (_, all) = &*ALL;
    let d65 = all
        .lamps
        .iter()
        .position(|l| l.0 == "CIE D65")
        .expect("shipped");
    let run = |numbers: usize, word: &str| {
        let run = all.run(d65, budget(all, numbers), place(all, find(word)));
        run.verdict[Measure::Patches].expect("visible")
    };
    close(run(11, "cosine"), 0.44);
    close(run(20, "cosine-exact"), 0.0069);
}

#[test]
fn principal_components_lack_teachers_here() {
    let (whole, all) = &*ALL;
    let lamps = whole.lamps();
    let usual = teachers(&lamps);
    let principal = Racer::Rival(Family::Principal);
    let course = RaceConfig {
        budgets: vec![11, 20],
        encoder: None,
        ..whole.course()
    };
    let taught_by = |teachers: &[TrainingSpectrum]| {
        let course = RaceConfig {
            lights: Arc::new(Training::new(BAND, teachers, 20)),
            ..course.clone()
        };
        race::run(&course, &lamps, &Progress::default()).expect("lights that shine")
    };
    let smooth = |race: &Race, numbers: usize| median(race, "smooth", numbers, principal);
    let more = temperatures().map(|kelvin| TrainingSpectrum {
        name: format!("{kelvin:.0} K"),
        class: "smooth".to_owned(),
        values: BAND.grid().map(|nm| blackbody(kelvin, nm)).collect(),
    });
    let more = taught_by(&usual.iter().cloned().chain(more).collect::<Vec<_>>());
    println!(
        "20 blackbodies more: {:.3} -> {:.3} at 11, {:.3} -> {:.4} at 20",
        smooth(all, 11),
        smooth(&more, 11),
        smooth(all, 20),
        smooth(&more, 20)
    );
    // The figures that the page tells, to their two digits.
    let told = |found: f64, told: f64| {
        assert!(
            (found / told - 1.0).abs() < 0.05,
            "{found} is told as {told}"
        );
    };
    told(smooth(all, 11), 0.57);
    told(smooth(&more, 11), 0.12);
    told(smooth(all, 20), 0.56);
    told(smooth(&more, 20), 0.011);
    for (class, lamps_told, all_told, half_told) in [
        ("LED", 25, 0.48, 2.1),
        ("fluorescent", 50, 0.31, 0.63),
        ("discharge", 18, 1.8, 3.6),
    ] {
        let mut names: Vec<&str> = Vec::new();
        for teacher in usual.iter().filter(|t| t.class == class) {
            if !names.contains(&teacher.name.as_str()) {
                names.push(&teacher.name);
            }
        }
        assert_eq!(names.len(), lamps_told, "{class}");
        let half: Vec<&str> = names.iter().copied().step_by(2).collect();
        let some: Vec<TrainingSpectrum> = usual
            .iter()
            .filter(|t| t.class != class || half.contains(&t.name.as_str()))
            .cloned()
            .collect();
        let fewer = taught_by(&some);
        let [before, after] = [all, &fewer].map(|race| median(race, class, 20, principal));
        println!("{class}, half of its teachers: {before:.2} -> {after:.2} at 20");
        told(before, all_told);
        told(after, half_told);
    }
}

#[test]
fn the_cie_lamps_are_easier_than_the_other_fluorescents() {
    let (whole, all) = &*ALL;
    let b = budget(all, 11);
    let medians = |family: Family| {
        let r = place(all, Racer::Rival(family));
        let of = |cie: bool| {
            let mut errors: Vec<f64> = all
                .of_class(Some("fluorescent"))
                .filter(|lamp| all.lamps[*lamp].0.starts_with("FL") == cie)
                .map(|lamp| all.run(lamp, b, r).verdict[Measure::Patches].expect("visible"))
                .collect();
            errors.sort_by(f64::total_cmp);
            (errors.len(), errors[errors.len() / 2])
        };
        [of(true), of(false)]
    };
    for (family, cie, others) in [(Family::Legendre, 1.0, 1.37), (Family::Moments, 0.43, 0.49)] {
        let found = medians(family);
        assert_eq!(found.map(|f| f.0), [54, 23]);
        assert!((found[0].1 / cie - 1.0).abs() < 0.03, "{found:?}");
        assert!((found[1].1 / others - 1.0).abs() < 0.03, "{found:?}");
    }
    assert_eq!(whole.lamps().len(), 146);
}

#[test]
fn both_halves_stand_in_the_figures() {
    let (_, race) = &*ALL;
    let b = budget(race, 20);
    let composite = |racer: Racer| matches!(racer, Racer::Composite(_));
    // Whoever wins but for known lamps and wide lines.
    let winner_of = |class: &str, measure: Measure| {
        let racers = race.racers.iter().enumerate();
        let others = racers.filter(|(_, r)| !Racer::ENCODED.contains(r) && **r != Racer::Chosen);
        let medians = others.map(|(i, racer)| {
            let spread = race.spread(Some(class), b, i, measure);
            (*racer, spread.expect("visible light").median)
        });
        let least = medians.min_by(|a, b| a.1.total_cmp(&b.1));
        least.expect("others").0
    };
    for class in race.classes() {
        let winner = winner_of(class, Measure::Patches);
        assert!(composite(winner), "{class}: {winner:?}");
    }
    for class in ["LED", "fluorescent", "discharge"] {
        for measure in [Measure::RmsBlurred, Measure::Filters] {
            let winner = winner_of(class, measure);
            assert_eq!(winner, Racer::Rival(Family::Principal), "{class}");
            let winner = race.winner_of(Some(class), b, measure);
            assert!(
                winner.is_some_and(|winner| Racer::ENCODED.contains(&winner)),
                "{class}: {winner:?}"
            );
        }
    }
}

/// Per cent of the cells that known lamps win against each peer, told with those that are lost.
fn per_cent_won(race: &Race, counts: &[usize]) -> Vec<(Racer, f64)> {
    let peers = race.racers.iter().filter(|r| matches!(r, Racer::Rival(_)));
    peers
        .map(|peer| {
            let wins = race.cells(Racer::KnownLamps, *peer, counts);
            println!("{}: {} of {}", peer.word(), wins.won(), wins.of);
            wins.behind.iter().for_each(|cell| println!("   {cell:?}"));
            (*peer, wins.per_cent().expect("cells"))
        })
        .collect()
}

#[test]
fn known_lamps_win_every_cell_of_the_race() {
    // Every table is trained on the lamps that race, each without the one at hand and its likes.
    let (_, race) = &*ALL;
    let won = per_cent_won(race, &CELLS_AT);
    assert_eq!(won.len(), 6);
    for (peer, per_cent) in won {
        assert_eq!(per_cent, 100.0, "{}", peer.word());
    }
}

#[test]
fn with_all_lamps_but_itself_known_lamps_win_too() {
    let (whole, _) = &*ALL;
    let encoder = Encoder::new(BAND, Observer::CIE_1931, SpikeSettings::default());
    let course = RaceConfig {
        encoder: Some(Arc::new(Racing {
            encoder: Arc::new(encoder.expect("the visible")),
            count: Count::Words,
            leave_out: LeaveOut::Itself,
        })),
        budgets: vec![11, 20],
        ..whole.course()
    };
    let some: Vec<Lamp> = whole.lamps().into_iter().step_by(5).collect();
    let race = race::run(&course, &some, &Progress::default()).expect("lights that shine");
    for (peer, per_cent) in per_cent_won(&race, &course.budgets) {
        assert!(per_cent >= 95.0, "{}: {per_cent}", peer.word());
    }
}

#[test]
fn numbers_too_few_for_a_label_are_those_of_the_best_composite() {
    let ask = ask(Field::One(ByAddress(entry("FL11"))), &[2, 3]);
    let race = ask.answer(&Progress::default()).expect("a light");
    let run = |budget: usize, racer: Racer| *race.run(0, budget, place(&race, racer));
    for racer in Racer::ENCODED {
        assert_eq!(run(0, racer), run(0, Racer::Chosen));
        assert_eq!(run(1, racer).numbers, 3);
    }
    let judged = race.judged(None, 1, Racer::WideLines, Judged::Filters);
    assert!(judged.is_some_and(|spread| spread.worst > 0.0));
}

#[test]
fn the_tables_file_has_a_line_for_everybody_with_the_figures_of_its_row() {
    let (ask, race) = &*ALL;
    let b = budget(race, 20);
    let csv: &str = table_chart(ask, race, Some("LED"), b).to_csv().leak();
    let mut lines = csv.lines().filter(|line| !line.starts_with('#'));
    let titles: Vec<&str> = lines.next().expect("titles").split(',').collect();
    let at = |title: &str| titles.iter().position(|t| *t == title).expect("a column");
    // Names with a comma stand in quotes; none of the numbers does.
    let cells = |line: &'static str| -> Vec<&'static str> {
        let quoted = line.strip_prefix('"').and_then(|rest| rest.split_once('"'));
        match quoted {
            Some((name, rest)) => std::iter::once(name)
                .chain(rest.split(',').skip(1))
                .collect(),
            None => line.split(',').collect(),
        }
    };
    let rows: Vec<Vec<&str>> = lines.map(cells).collect();
    assert_eq!(rows.len(), race.racers.len());
    for (r, (racer, cells)) in race.racers.iter().zip(&rows).enumerate() {
        assert_eq!(cells.len(), titles.len(), "{cells:?}");
        assert_eq!(cells[0], racer.title());
        let median = race.row(Some("LED"), b, r).spreads[Measure::Patches]
            .expect("visible")
            .median;
        let found: f64 = cells[at("delta_e_patches_median")]
            .parse()
            .expect("a number");
        assert_eq!(found, median);
    }
}

#[test]
fn every_racer_looks_different_in_the_chart() {
    let (ask, race) = &*ALL;
    for measure in Measure::COMPARED {
        let chart = error_chart(ask, race, None, measure, Theme::Dark);
        let mut looks = Vec::new();
        for series in &chart.series {
            if let Marks::Points { points, shape, .. } = &series.marks {
                assert_eq!(points.len(), RACE_BUDGETS.len());
                assert!(points.iter().all(|p| p[1] >= SMALLEST));
                let look = (series.colour, *shape);
                assert!(!looks.contains(&look), "{} {look:?}", series.name);
                looks.push(look);
            }
        }
        assert_eq!(looks.len(), race.racers.len());
    }
}

#[test]
fn low_pressure_sodium_is_the_worst_of_whatever_has_no_spikes_but_box_bins() {
    let (_, race) = &*ALL;
    let b = budget(race, 20);
    for (r, racer) in race.racers.iter().enumerate() {
        let plain = match racer {
            Racer::Composite(way) => !way.spikes,
            Racer::Rival(family) => *family != Family::Bins,
            Racer::WideLines | Racer::KnownLamps | Racer::Chosen => false,
        };
        let error =
            |lamp: &usize| race.run(*lamp, b, r).verdict[Measure::Patches].expect("visible");
        let worst = race
            .of_class(Some("discharge"))
            .max_by(|a, b| error(a).total_cmp(&error(b)))
            .expect("there are some");
        assert!(!plain || race.lamps[worst].0 == "LPS", "{}", racer.word());
    }
}
