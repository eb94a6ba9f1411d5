//! Spectral pictures against plain baselines in the same run.

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use nalgebra::DMatrix;
use spectral_explorer::pictures::*;
use spectral_explorer::study::Progress;

fn nm(first: f64, last: f64, count: usize) -> Vec<f64> {
    (0..count)
        .map(|j| first + (last - first) * j as f64 / (count - 1) as f64)
        .collect()
}

/// 81 -> 20 and 31 -> 20, one thread, against nalgebra's product of the same matrices.
fn encode(c: &mut Criterion) {
    for (bands, first, last) in [(81, 380.0, 780.0), (31, 400.0, 700.0)] {
        let pixels =
            InMemory::of(&Scene::reflectance(256, 256, nm(first, last, bands)).unwrap()).unwrap();
        let operator = Operator::new(pixels.bands(), &Plan::new(pixels.bands(), 20)).unwrap();
        let count = 256 * 256;
        let mut group = c.benchmark_group(format!("encode {bands} to 20, one thread"));
        group
            .throughput(Throughput::Elements(count as u64))
            .sample_size(10);
        let kernel = operator.encoder();
        let mut out = vec![0.0; 20 * count];
        group.bench_function("kernel", |b| {
            b.iter(|| kernel.apply(black_box(pixels.values()), count, &mut out))
        });
        let by_pixel = DMatrix::from_row_slice(bands, count, pixels.values()).transpose();
        let matrix = DMatrix::from_fn(bands, 20, |j, n| operator.encode(n, j) as f32);
        group.bench_function("nalgebra", |b| b.iter(|| black_box(&by_pixel) * &matrix));
    }
}

fn relight(c: &mut Criterion) {
    let count = 1 << 20;
    let planes = vec![0.5_f32; 20 * count];
    let relit = Relit {
        light: String::new(),
        rows: std::array::from_fn(|k| vec![0.1 * (k + 1) as f64; 20]),
        white: spectral_explorer::color::Xyz::new(0.95, 1.0, 1.09),
    };
    let mut out = vec![0.0; 3 * count];
    let mut group = c.benchmark_group("relight 1 Mpixel, 20 numbers");
    group.sample_size(10);
    group.bench_function("planes to XYZ", |b| {
        b.iter(|| relit_into(black_box(&planes), count, &relit, &mut out))
    });
    group.bench_function("plane by plane", |b| {
        b.iter(|| {
            out.fill(0.0);
            for (n, plane) in planes.chunks_exact(count).enumerate() {
                for (k, row) in out.chunks_exact_mut(count).enumerate() {
                    let w = relit.rows[k][n] as f32;
                    row.iter_mut().zip(plane).for_each(|(o, z)| *o += w * z);
                }
            }
        });
    });
}

fn files(c: &mut Criterion) {
    let quiet = Progress::default();
    let pixels =
        InMemory::of(&Scene::reflectance(512, 512, nm(380.0, 780.0, 81)).unwrap()).unwrap();
    let survey = Survey::of(&pixels, &quiet).unwrap();
    let operator = Operator::new(pixels.bands(), &Plan::new(pixels.bands(), 11)).unwrap();
    let sample: Vec<Vec<f64>> = survey
        .sample
        .iter()
        .map(|p| operator.numbers_of(p))
        .collect();
    let quantiser = Quantiser::new(&operator, &sample, 0.5, None).unwrap();
    let error = measure(&pixels, &operator, &quantiser, 1.0, &quiet).unwrap();
    println!(
        "compact t .5, P 11, 512: own {:?}, rms {}",
        error.own, error.relative_rms
    );
    let plan = CompactPlan {
        quantiser,
        error: error.clone(),
    };
    let about = About::default();
    // The study's scene: c_ref = 1, the own colour of its table.
    let whole = Quantiser::new(&operator, &sample, 0.5, Some(1.0)).unwrap();
    let of_whole = measure(&pixels, &operator, &whole, 1.0, &quiet).unwrap();
    println!(
        "with c_ref 1: own {:?}, rms {}",
        of_whole.own, of_whole.relative_rms
    );
    let of_whole = CompactPlan {
        quantiser: whole,
        error: of_whole,
    };
    let compact = |coder| {
        let mut bytes = Vec::new();
        write_compact(&mut bytes, &pixels, &operator, &plan, &about, coder, &quiet).unwrap();
        bytes
    };
    // Tiles only: what is measured in PICTURES.md is without the preview.
    let tiles = |bytes: &[u8]| {
        let (mut at, mut sum) = (8, 0);
        while at + 8 <= bytes.len() {
            let length = u32::from_be_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
            sum += if &bytes[at + 4..at + 8] == b"csPT" {
                length
            } else {
                0
            };
            at += length + 12;
        }
        sum as f64 / (512.0 * 512.0)
    };
    for coder in [Coder::Simple, Coder::Fitted] {
        println!("bytes a pixel, {coder:?}: {:.3}", tiles(&compact(coder)));
    }
    for coder in [Coder::Simple, Coder::Fitted] {
        let mut bytes = Vec::new();
        write_compact(
            &mut bytes, &pixels, &operator, &of_whole, &about, coder, &quiet,
        )
        .unwrap();
        println!(
            "bytes a pixel with c_ref 1, {coder:?}: {:.3}",
            tiles(&bytes)
        );
    }
    if let Ok(path) = std::env::var("PICTURES_PNG") {
        std::fs::write(path, compact(Coder::Fitted)).unwrap();
    }
    let mut group = c.benchmark_group("files 512 x 512 x 81, 11 numbers");
    group.sample_size(10);
    group.bench_function("compact saved", |b| b.iter(|| compact(Coder::Fitted)));
    let written = compact(Coder::Fitted);
    group.bench_function("compact opened", |b| {
        b.iter(|| {
            CompactFile::open(written.clone())
                .unwrap()
                .picture(&quiet)
                .unwrap()
        })
    });
    let half = Half::of(&sample);
    let full = || {
        let mut bytes = std::io::Cursor::new(Vec::new());
        let kept = (Precision::Half, half);
        write_full(
            &mut bytes,
            &pixels,
            &operator,
            kept,
            (&about, error.clone()),
            &quiet,
        )
        .unwrap();
        bytes.into_inner()
    };
    group.bench_function("full saved, half", |b| b.iter(full));
    let written = full();
    println!(
        "full form, bytes a pixel: {:.2}",
        written.len() as f64 / (512.0 * 512.0)
    );
    group.bench_function("full opened", |b| b.iter(|| read_full(&written).unwrap()));
    group.bench_function("spectral OpenEXR of every band, half", |b| {
        b.iter(|| exact_bytes(&pixels, Precision::Half, &quiet).unwrap())
    });
    let base = Plan::new(pixels.bands(), 8);
    group.bench_function("choose, 81 bands", |b| {
        b.iter(|| {
            let asked = Asked::Bound {
                p95: BOUND_P95,
                rms: BOUND_RMS,
            };
            choose(
                pixels.bands(),
                &survey,
                None,
                (&base, &Wish::default()),
                asked,
                &quiet,
            )
            .unwrap()
        })
    });
}

fn tables(c: &mut Criterion) {
    let light = Light::named("FL11").unwrap();
    let pixels =
        InMemory::of(&Scene::lit(256, 256, nm(380.0, 780.0, 81), &[light]).unwrap()).unwrap();
    let names: Vec<String> = (0..65536).map(|i| i.to_string()).collect();
    let mut group = c.benchmark_group("fit a table of 65536 spectra");
    group
        .throughput(Throughput::Elements(65536))
        .sample_size(10);
    for lines in [false, true] {
        let ask = FitAsk {
            numbers: 20,
            reference: ReferenceKind::Mean,
            lines,
        };
        group.bench_function(if lines { "with lines" } else { "without" }, |b| {
            b.iter(|| {
                let values = pixels.values().to_vec();
                fit_values(
                    names.clone(),
                    pixels.bands().clone(),
                    values,
                    ask,
                    &Progress::default(),
                )
                .unwrap()
            })
        });
    }
}

criterion_group!(benches, encode, relight, files, tables);
criterion_main!(benches);
