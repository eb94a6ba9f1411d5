//! How long the studies take, each beside a plain way of doing the same.
//!
//! ```text
//! cargo bench -p benches --bench studies
//! ```
//!
//! ```text
//! a sweep      eight ways x 41 orders and the threshold map; the plain way derives everything
//!              that the window shows for each of the 328 models
//! an auction   to 41 numbers, FL11 on patches; the plain way tries every number of the heaviest
//!              lines at every order, without any look ahead
//! a race       15 representations at 7 counts over 34, 68 and 137 lamps, on all processors: the
//!              time for one lamp must not grow with their number
//! ```

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use spectral_explorer::{
    app::{
        App, CURVE_ORDER, Command, Settings, derive,
        pages::RACE_BUDGETS,
        studies::{AuctionAsk, Field, Question, RaceAsk, SweepAsk},
    },
    spectrum::numbers_of_order,
    study::{
        Examined, FitVariant, Goal, Measure, Progress,
        race::{self, Lamp, RaceConfig},
    },
};

fn go() -> Progress {
    Progress::default()
}

fn a_sweep(criterion: &mut Criterion) {
    let app = App::new();
    let ask = SweepAsk::of(app.document());
    let mut group = criterion.benchmark_group("a sweep of 328 models");
    group.sample_size(10);
    group.bench_function("this program, with the threshold map", |b| {
        b.iter(|| black_box(ask.answer(&go())));
    });
    let apps: Vec<App> = FitVariant::ALL
        .map(|way| {
            let mut app = App::new();
            app.apply(Command::Edit(Settings {
                basis: way.basis,
                spikes: way.spikes,
                colour_exact: way.colour_exact,
                ..Settings::default()
            }));
            app
        })
        .into();
    group.bench_function("everything derived for every model, no map", |b| {
        b.iter(|| {
            for app in &apps {
                let mut document = app.document().clone();
                for order in 0..=CURVE_ORDER {
                    document.settings.order = order;
                    black_box(derive(&document, app.tables(), None));
                }
            }
        });
    });
    group.finish();
}

fn an_auction(criterion: &mut Criterion) {
    let app = App::new();
    let ask = AuctionAsk::of(app.document(), Goal::PATCHES, 41);
    let mut group = criterion.benchmark_group("an auction to 41 numbers");
    group.sample_size(20);
    group.bench_function("this program", |b| {
        b.iter(|| black_box(ask.answer(&go())));
    });
    group.bench_function("the heaviest lines only, every order", |b| {
        b.iter(|| {
            let examined = Examined::of(&ask.about.subject(), 41).expect("the first light shines");
            let projected = examined.projected(ask.terms.basis, &examined.shapes);
            let mut best = f64::INFINITY;
            for count in 0..=20 {
                for lines in 0..=projected.lines().min(count) {
                    let lines: Vec<usize> = (0..lines).collect();
                    let numbers = numbers_of_order(count - lines.len());
                    let (model, _) = projected.model(numbers, &lines, false);
                    let smooth = projected.smooth(&model);
                    let reference = &examined.reference;
                    let found = reference.figure(Measure::Patches, &smooth, model.lines());
                    best = best.min(found.unwrap_or(f64::INFINITY));
                }
            }
            black_box(best)
        });
    });
    group.finish();
}

fn a_race(criterion: &mut Criterion) {
    let app = App::new();
    let ask = RaceAsk::of(app.document(), Field::Shipped, RACE_BUDGETS.to_vec());
    let (course, all) = (ask.course(), ask.lamps());
    // Every fourth, every second and all: the same mixture of lamps each time.
    let every = |step: usize| -> Vec<Lamp> {
        let lamps = all.iter().take(137).step_by(step);
        lamps.cloned().collect()
    };
    let mut group = criterion.benchmark_group("a race at 7 counts (target 10 s for 137 lamps)");
    group.sample_size(10);
    for step in [4, 2, 1] {
        let lamps = every(step);
        group.throughput(Throughput::Elements(lamps.len() as u64));
        group.bench_function(format!("{} lamps", lamps.len()), |b| {
            b.iter(|| black_box(race::run(&course, &lamps, &go())));
        });
    }
    let others = RaceConfig {
        encoder: None,
        ..course
    };
    let lamps = every(1);
    group.bench_function("137 lamps without known lamps and wide lines", |b| {
        b.iter(|| black_box(race::run(&others, &lamps, &go())));
    });
    group.finish();
    let mut group = criterion.benchmark_group("what a race is run on");
    group.sample_size(10);
    group.bench_function("tables, training of the components, measures", |b| {
        b.iter(|| black_box(ask.course()));
    });
    group.finish();
}

criterion_group!(benches, a_sweep, an_auction, a_race);
criterion_main!(benches);
