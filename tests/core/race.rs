//! The race on the shipped lamps: its promises and its figures.

use std::sync::{Arc, LazyLock};

use spectral_explorer::{
    app::{
        ByAddress, Document, Entry, Library,
        chart::Marks,
        charts::race::{CELLS_AT, error_chart, table_chart},
        figures::SMALLEST,
        pages::RACE_BUDGETS,
        studies::{Field, Question, RaceAsk},
    },
    color::Observer,
    lamps::{Count, Encoder, LeaveOut, Racing},
    rivals::{Family, PrincipalBasis},
    spectrum::{Band, SpikeSettings},
    study::{
        Measure, Progress, Race, Training,
        race::{self, Judged, Lamp, RaceConfig, Racer},
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
    let training = Training::new(BAND, &lamps, 20);
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
        let chart = error_chart(ask, race, None, measure);
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
