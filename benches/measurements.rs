//! Sigma points, the mean of a hundred scans and a combination of two tables, each beside a plain
//! loop over the same numbers.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use spectral_explorer::{
    app::{
        Entry,
        combining::{Act, Part},
        measured::spectrum,
    },
    measurements::{Formula, Measurement, Options, Quantity, Repeats, combine, doubts},
    preset,
    spectrum::Sampled,
};

/// Scans of 2048 points of a lamp, with a ripple in place of noise.
fn scans(count: usize, points: usize) -> Vec<Measurement> {
    let lamp = preset::table("cie_led_1nm", "LED-B3").expect("a shipped lamp");
    let scan = |k: usize| {
        let nm: Vec<f64> = (0..points)
            .map(|i| 380.0 + 400.0 * i as f64 / points as f64)
            .collect();
        let values = nm.iter().enumerate().map(|(i, nm)| {
            let ripple = ((i * 7919 + k * 104_729) % 1000) as f64 / 1000.0 - 0.5;
            lamp.at(*nm, spectral_explorer::spectrum::Outside::Hold) + 0.1 * ripple
        });
        let samples = Sampled::new(nm.clone(), values.collect()).expect("rising");
        Measurement::new("scan", Quantity::Light, "", samples)
    };
    (0..count).map(scan).collect()
}

fn measurements(c: &mut Criterion) {
    let five = scans(5, 401);
    let mean = Repeats::of(&five).expect("five").mean;
    c.bench_function("sigma points of eight figures", |b| {
        b.iter(|| doubts(black_box(&mean)));
    });
    c.bench_function("the eight figures alone, a plain loop over 345 sums", |b| {
        let values = vec![1.0; 471];
        b.iter(|| spectral_explorer::measurements::figures_of(black_box(&values)));
    });
    let hundred = scans(100, 2048);
    c.bench_function("mean of 100 scans of 2048 points", |b| {
        b.iter(|| Repeats::of(black_box(&hundred)).expect("a hundred"));
    });
    c.bench_function("a plain mean of the same numbers", |b| {
        b.iter(|| {
            let mut mean = vec![0.0; 2048];
            for scan in black_box(&hundred) {
                for (sum, v) in mean.iter_mut().zip(scan.samples.values()) {
                    *sum += v / 100.0;
                }
            }
            mean
        });
    });
    let two = scans(2, 2048);
    let formula = Formula::parse("A / B").expect("a formula");
    c.bench_function("a quotient of two tables of 2048 points", |b| {
        b.iter(|| combine(black_box(&formula), black_box(&two), Options::default()));
    });
    let parts: Vec<Part> = two
        .iter()
        .map(|scan| {
            let mut light = spectrum(scan, "");
            "W m-2 nm-1".clone_into(&mut light.unit);
            Part::of_entry(&Entry::own(0, light), false).expect("a light")
        })
        .collect();
    let act = Act::Formula {
        text: "A - 0.1 * B".to_owned(),
        keep_all: false,
        equal: None,
        of_surface: false,
    };
    c.bench_function("all that combine tells of a difference of the two", |b| {
        b.iter(|| {
            let found = act.of(black_box(&parts)).expect("a light");
            (found.figures(), found.notes())
        });
    });
    c.bench_function("a plain quotient of the same numbers", |b| {
        b.iter(|| {
            let pairs = two[0].samples.values().iter().zip(two[1].samples.values());
            pairs.map(|(a, b)| black_box(a / b)).collect::<Vec<f64>>()
        });
    });
}

criterion_group!(benches, measurements);
criterion_main!(benches);
