//! Encoding and decoding one lamp at 20 numbers, beside today's plain cosine and its table.

use criterion::{Criterion, criterion_group, criterion_main};
use spectral_explorer::{
    color::Observer,
    lamps::{Ask, Encoder},
    preset,
    spectrum::{Band, Basis, BasisTable, Composite, Line, Outside, SpikeSettings, detect_shapes},
};
use std::hint::black_box;

const BAND: Band = Band::VISIBLE;

fn lamp(group: &str, name: &str) -> Vec<f64> {
    preset::table(group, name)
        .expect("a shipped lamp")
        .on_band(BAND, Outside::Zero)
}

fn encoding(c: &mut Criterion) {
    let encoder =
        Encoder::new(BAND, Observer::CIE_1931, SpikeSettings::default()).expect("the visible");
    let mut group = c.benchmark_group("encode at 20");
    for (from, name) in [
        ("cie_fluorescent_1nm", "FL2"),
        ("cie_led_1nm", "LED-B3"),
        ("lamps_nist_traditional", "HPS"),
        ("cie_illuminants", "CIE D65"),
    ] {
        let values = lamp(from, name);
        let ask = Ask::numbers(20).in_comparison();
        group.bench_function(format!("known lamps, {name}"), |b| {
            b.iter(|| encoder.encode(black_box(&values), ask))
        });
        group.bench_function(format!("wide lines, {name}"), |b| {
            b.iter(|| encoder.encode(black_box(&values), ask.portable()))
        });
    }
    let values = lamp("cie_fluorescent_1nm", "FL2");
    let basis = BasisTable::new(BAND, Basis::Cosine, 20);
    group.bench_function("plain: detector and cosine projection, FL2", |b| {
        b.iter(|| {
            (
                detect_shapes(BAND, black_box(&values), SpikeSettings::default()),
                basis.project(&values, 20),
            )
        });
    });
    group.finish();
}

fn decoding(c: &mut Criterion) {
    let encoder =
        Encoder::new(BAND, Observer::CIE_1931, SpikeSettings::default()).expect("the visible");
    let values = lamp("cie_fluorescent_1nm", "FL2");
    let encoding = encoder
        .encode(&values, Ask::numbers(20).in_comparison())
        .expect("a light")
        .encoding;
    let decoder = encoder.decoder();
    let mut out = vec![0.0; BAND.points()];
    let mut group = c.benchmark_group("decode at 20");
    group.bench_function("known lamps and lines", |b| {
        b.iter(|| decoder.decode_into(black_box(&encoding), &mut out))
    });
    let basis = BasisTable::new(BAND, Basis::Cosine, 20);
    let coefficients = basis.project(&values, 20);
    group.bench_function("plain: cosine table", |b| {
        b.iter(|| {
            out.fill(0.0);
            basis.add_series(black_box(&coefficients), &mut out);
        });
    });
    let line = Line {
        at_nm: 546.07,
        weight: 2.0,
        fwhm_nm: 8.0,
    };
    let composite = Composite::of_lines_inside(encoding.smooth.clone(), vec![line; 4]);
    group.bench_function("values of a composite with 4 wide lines", |b| {
        b.iter(|| black_box(&composite).on_band())
    });
    group.bench_function("a wide line through a series, closed form", |b| {
        b.iter(|| line.integrate_series(black_box(composite.smooth())))
    });
    group.finish();
}

criterion_group! {
    name = lamps;
    config = Criterion::default().sample_size(20);
    targets = encoding, decoding
}
criterion_main!(lamps);
