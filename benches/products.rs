//! How fast spectra are multiplied: a few points against 401 samples, and a chain of factors.
//!
//! ```text
//! cargo bench -p benches --bench products
//! ```
//!
//! ```text
//! a product    10^6 of them cycling through 1 MiB of factors, N = 7, f64: 2N + 2 points and twice
//!              the numbers against 401 samples (targets 12 and 6 times as many a second)
//! with spikes  the same with four spikes: the factors read where the lamp's lines stand once and
//!              for all (four more multiplications), or their series read anew in each product
//! a chain      eight factors with 24 patches behind them, exact and model, CIEDE2000; the plain
//!              way multiplies and weighs on the 1 nm grid only (target 1 ms)
//! ```

use std::{
    hint::black_box,
    time::{Duration, Instant},
};

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use spectral_explorer::{
    app::{App, Command, Settings},
    color::{
        Lab,
        patches::{difference, labs_into},
    },
    spectrum::{
        Band, Basis, Factor, Line, SampleGrid, Sampling, Series, numbers_of_order,
        product::multiply_points,
    },
    study::products::Product,
};

const BAND: Band = Band::VISIBLE;
const ORDER: usize = 7;
/// Memory that the factors of one run take.
const WORKING_SET: usize = 1 << 20;
/// Products of one run.
const PRODUCTS: usize = 1_000_000;
/// Rounds of which the fastest counts: another process may have the processor in between.
const ROUNDS: usize = 9;
const LINES: usize = 4;

/// Eq. 15 counts both ends of the period.
const PAPER: usize = 2 * ORDER + 2;
const DOUBLE: usize = 2 * (2 * ORDER + 1);
const FULL: usize = 401;
/// The same with the factor's values where the lines stand behind those of the points.
const PAPER_LINES: usize = PAPER + LINES;
const DOUBLE_LINES: usize = DOUBLE + LINES;

/// Spectra of `POINTS` values that fill the working set.
fn factors<const POINTS: usize>() -> Vec<[f64; POINTS]> {
    let count = WORKING_SET / (POINTS * size_of::<f64>());
    let value = |i: usize, j: usize| 0.5 + 0.4 * ((i * 7 + j) as f64 * 0.37).sin();
    (0..count)
        .map(|i| std::array::from_fn(|j| value(i, j)))
        .collect()
}

/// Runs [`PRODUCTS`] products and gives the time of one in ns.
fn time<const POINTS: usize>(
    factors: &[[f64; POINTS]],
    mut multiply: impl FnMut(&[f64; POINTS]),
) -> f64 {
    let start = Instant::now();
    let mut left = PRODUCTS;
    while left > 0 {
        let count = left.min(factors.len());
        factors[..count].iter().for_each(&mut multiply);
        left -= count;
    }
    start.elapsed().as_secs_f64() * 1e9 / PRODUCTS as f64
}

/// Products of values alone.
fn plain<const POINTS: usize>(factors: &[[f64; POINTS]]) -> f64 {
    let light = black_box(factors[0]);
    let mut product = [0.0; POINTS];
    time(factors, |factor| {
        multiply_points(&light, factor, &mut product);
        black_box(&mut product);
    })
}

/// Products of values and [`LINES`] spikes: `rows` read the factor's series where they stand.
fn with_spikes<const POINTS: usize>(
    factors: &[[f64; POINTS]],
    rows: &[[f64; POINTS]; LINES],
) -> f64 {
    let light = black_box(factors[0]);
    let weights = black_box([3.0, 2.0, 1.0, 0.5]);
    let mut product = [0.0; POINTS];
    let mut behind = [0.0; LINES];
    time(factors, |factor| {
        multiply_points(&light, factor, &mut product);
        for ((out, weight), row) in behind.iter_mut().zip(weights).zip(rows) {
            let share: f64 = row.iter().zip(factor).map(|(r, f)| r * f).sum();
            *out = weight * share;
        }
        black_box((&mut product, &mut behind));
    })
}

/// What reads the series off a factor's values at mercury's lines; the paper's last point repeats
/// the first and is not needed.
fn rows<const POINTS: usize>(basis: Basis, points: usize) -> [[f64; POINTS]; LINES] {
    let grid = SampleGrid {
        band: BAND,
        basis,
        points,
    };
    [404.7, 435.8, 546.1, 578.0].map(|nm| {
        let row = grid.row_at(nm);
        std::array::from_fn(|i| row.get(i).copied().unwrap_or(0.0))
    })
}

fn fastest(mut run: impl FnMut() -> f64) -> f64 {
    (0..ROUNDS).map(|_| run()).fold(f64::INFINITY, f64::min)
}

/// Everything in the same run, one after the other in each round, so that what else the machine
/// does falls on all alike.
fn a_product(_: &mut Criterion) {
    let (paper, double, full) = (factors::<PAPER>(), factors::<DOUBLE>(), factors::<FULL>());
    let paper_rows = rows::<PAPER>(Basis::Fourier, 2 * ORDER + 1);
    let double_rows = rows::<DOUBLE>(Basis::Cosine, DOUBLE);
    let full_ns = fastest(|| plain(&full));
    println!("a product of two spectra, 10^6 products through 1 MiB, N = {ORDER}, f64");
    println!("401 samples                  {full_ns:7.2} ns");
    let tell = |what: &str, ns: f64, target: &str| {
        println!(
            "{what:<28} {ns:7.2} ns, {:.1} times as many a second{target}",
            full_ns / ns
        );
    };
    tell(
        "2N + 2 = 16 points",
        fastest(|| plain(&paper)),
        " (target 12)",
    );
    tell(
        "twice the numbers, 30 points",
        fastest(|| plain(&double)),
        " (target 6)",
    );
    let (paper_lines, double_lines) = (factors::<PAPER_LINES>(), factors::<DOUBLE_LINES>());
    tell(
        "16 points and 4 spikes",
        fastest(|| plain(&paper_lines)),
        "",
    );
    tell(
        "30 points and 4 spikes",
        fastest(|| plain(&double_lines)),
        "",
    );
    tell(
        "16, and 4 read in a series",
        fastest(|| with_spikes(&paper, &paper_rows)),
        "",
    );
    tell(
        "30, and 4 read in a series",
        fastest(|| with_spikes(&double, &double_rows)),
        "",
    );
    println!(
        "401 samples again            {:7.2} ns\n",
        fastest(|| plain(&full))
    );
}

/// Eight surfaces of the ColorChecker's brighter half.
fn eight(app: &App) -> Vec<Factor> {
    let patches = app.tables().patches.as_ref().expect("a light has patches");
    let bright = patches.reflectances.iter().rev().take(20);
    bright
        .step_by(2)
        .take(8)
        .cloned()
        .map(Factor::new)
        .collect()
}

/// Mean CIEDE2000 of the patches under what comes out of the chain.
fn patches_behind(app: &App, factors: &[Factor], sampling: Sampling) -> f64 {
    let (derived, tables) = (app.derived(), app.tables());
    let passage = Product {
        measured: &derived.measured,
        model: &derived.model,
        sampling,
        seen: &tables.viewing.weights,
        width_nm: 10.0,
    }
    .through(factors);
    let step = passage.steps.last().expect("eight factors");
    let set = &tables.patches.as_ref().expect("a light has patches").set;
    let (mut exact, mut model) = (set.buffer(), set.buffer());
    set.xyz_into(&step.exact, &mut exact);
    set.xyz_into(&step.smooth, &mut model);
    for spike in &step.spikes {
        set.add_line(spike.at_nm, spike.weight, &mut model);
    }
    let mut labs = [
        vec![Lab::default(); exact.len()],
        vec![Lab::default(); exact.len()],
    ];
    labs_into(&exact, passage.white, &mut labs[0]);
    labs_into(&model, passage.white, &mut labs[1]);
    difference(&labs[0], &labs[1]).mean
}

fn a_chain(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("a chain of 8 with 24 patches (target 1 ms)");
    group.throughput(Throughput::Elements(8));
    for (basis, order) in [
        (Basis::Fourier, ORDER),
        (Basis::Cosine, ORDER),
        (Basis::Cosine, 20),
    ] {
        let mut app = App::new();
        app.apply(Command::Edit(Settings {
            basis,
            order,
            ..Settings::default()
        }));
        let factors = eight(&app);
        for sampling in Sampling::ALL {
            let name = format!("{} N = {order}, {}", basis.word(), sampling.word());
            group.bench_function(name, |b| {
                b.iter(|| black_box(patches_behind(&app, black_box(&factors), sampling)));
            });
        }
    }
    group.finish();
    // What has no table: light, spikes and factor read where they stand, one cosine at a time.
    let app = App::new();
    let light: Series = app.derived().model.smooth().clone();
    let spikes: Vec<Line> = app.derived().model.lines().to_vec();
    let factors: Vec<Series> = eight(&app)
        .iter()
        .map(|factor| Series {
            coefficients: app
                .tables()
                .basis
                .project(factor.values(), numbers_of_order(ORDER)),
            ..light.clone()
        })
        .collect();
    criterion.bench_function(
        "the chain alone on 1 nm, every series evaluated anew",
        |b| {
            b.iter(|| {
                let mut values = light.on_band();
                let mut weights: Vec<f64> = spikes.iter().map(|s| s.weight).collect();
                for factor in &factors {
                    for (v, f) in values.iter_mut().zip(factor.on_band()) {
                        *v *= f;
                    }
                    for (w, s) in weights.iter_mut().zip(&spikes) {
                        *w *= factor.at(s.at_nm);
                    }
                }
                black_box((values, weights))
            });
        },
    );
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(1));
    targets = a_product, a_chain
}
criterion_main!(benches);
