//! Spectral pictures against plain baselines in the same run, and against numpy and `cjxl` where
//! they are installed (`PYTHON` names another python).

use std::hint::black_box;
use std::time::Instant;

#[path = "pictures/large.rs"]
mod large;
#[path = "pictures/peers.rs"]
mod theirs;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use nalgebra::DMatrix;
use spectral_explorer::app::picture::{Raster, exposed};
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
        drop(group);
        match theirs::numpy(bands, 20, count) {
            Some(rate) => {
                let mut best = f64::INFINITY;
                for _ in 0..9 {
                    let started = Instant::now();
                    kernel.apply(black_box(pixels.values()), count, &mut out);
                    best = best.min(started.elapsed().as_secs_f64());
                }
                let ours = 1e-6 * count as f64 / best;
                println!(
                    "{bands} to 20, one thread, best of 9: {ours:.1} Mpixel/s, numpy {rate:.1}"
                );
            }
            None => println!("numpy is not installed: not run"),
        }
    }
}

/// From the bytes of an ENVI file, masks included, on as many threads as there are.
fn from_file(c: &mut Criterion) {
    let wall = InMemory::of(&Scene::reflectance(512, 512, nm(400.0, 700.0, 31)).unwrap()).unwrap();
    let count = 512 * 512;
    let folder = tempfile::tempdir().unwrap();
    let list: Vec<String> = wall.bands().nm().iter().map(f64::to_string).collect();
    let mut group = c.benchmark_group("encode 31 to 20 from a file, 512 x 512");
    group
        .throughput(Throughput::Elements(count as u64))
        .sample_size(10);
    for interleave in ["bsq", "bil", "bip"] {
        let at = |x: usize, y: usize, j: usize| wall.values()[j * count + y * 512 + x];
        let mut bytes = Vec::with_capacity(2 * 31 * count);
        let mut put = |x, y, j| {
            let whole = (at(x, y, j) * 10_000.0).round().clamp(1.0, 65535.0) as u16;
            bytes.extend(whole.to_le_bytes());
        };
        match interleave {
            "bsq" => (0..31).for_each(|j| (0..count).for_each(|i| put(i % 512, i / 512, j))),
            "bil" => (0..512).for_each(|y| (0..31 * 512).for_each(|i| put(i % 512, y, i / 512))),
            _ => (0..count).for_each(|i| (0..31).for_each(|j| put(i % 512, i / 512, j))),
        }
        std::fs::write(folder.path().join(format!("{interleave}.img")), bytes).unwrap();
        let header = format!(
            "ENVI\nsamples = 512\nlines = 512\nbands = 31\nheader offset = 0\ndata type = 12\n\
             interleave = {interleave}\nbyte order = 0\nwavelength units = Nanometers\n\
             reflectance scale factor = 10000\ndata ignore value = 0\nwavelength = {{{}}}\n",
            list.join(", ")
        );
        let path = folder.path().join(format!("{interleave}.hdr"));
        std::fs::write(&path, header).unwrap();
        let file = EnviFile::open(&path, false, None).unwrap();
        let operator = Operator::new(file.bands(), &Plan::new(file.bands(), 20)).unwrap();
        let kernel = operator.encoder();
        group.bench_function(interleave, |b| {
            b.iter(|| {
                over_strips(&file, STRIP_ROWS, &Progress::default(), |strip| {
                    let mut numbers = vec![0.0; 20 * strip.pixels];
                    kernel.apply(strip.values, strip.pixels, &mut numbers);
                    Ok(numbers)
                })
                .unwrap()
            })
        });
    }
    let operator = Operator::new(wall.bands(), &Plan::new(wall.bands(), 20)).unwrap();
    let kernel = operator.encoder();
    group.bench_function("from memory", |b| {
        b.iter(|| {
            over_strips(&wall, STRIP_ROWS, &Progress::default(), |strip| {
                let mut numbers = vec![0.0; 20 * strip.pixels];
                kernel.apply(strip.values, strip.pixels, &mut numbers);
                Ok(numbers)
            })
            .unwrap()
        })
    });
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
    group.bench_function("and exposed to sRGB bytes", |b| {
        b.iter(|| {
            relit_into(black_box(&planes), count, &relit, &mut out);
            let values = (0..count).map(|i| [out[i], out[count + i], out[2 * count + i]]);
            let raster = Raster {
                width: 1024,
                height: 1024,
                step: 1,
                values: values.collect(),
                is_xyz: true,
                full: [1.0; 3],
            };
            exposed(&raster, 0.0)
        })
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

fn compact(pixels: &InMemory, operator: &Operator, plan: &CompactPlan, coder: Coder) -> Vec<u8> {
    let (mut bytes, about, quiet) = (Vec::new(), About::default(), Progress::default());
    write_compact(&mut bytes, pixels, operator, plan, &about, coder, &quiet).unwrap();
    bytes
}

/// How many bytes a pixel takes in the compact form, and in that of another program.
fn tell_sizes(pixels: &InMemory, operator: &Operator, [plan, of_whole]: [&CompactPlan; 2]) {
    let compact = |plan, coder| compact(pixels, operator, plan, coder);
    // Tiles only, without preview and header.
    let per_pixel = |bytes: &[u8]| theirs::bytes_of(bytes, &[b"csPT"]) as f64 / (512.0 * 512.0);
    for coder in [Coder::Simple, Coder::Fitted] {
        println!(
            "bytes a pixel, {coder:?}: {:.3}",
            per_pixel(&compact(plan, coder))
        );
        println!(
            "the same with c_ref 1: {:.3}",
            per_pixel(&compact(of_whole, coder))
        );
    }
    let steps: Vec<Vec<i32>> = (0..512 * 512)
        .map(|i| {
            let numbers = operator.numbers_of(&pixels.pixel(i % 512, i / 512));
            plan.quantiser.steps(&numbers).unwrap()
        })
        .collect();
    let planes = (0..11).map(|n| {
        let plane: Vec<i32> = steps.iter().map(|steps| steps[n]).collect();
        theirs::lossless(512, 512, &plane)
    });
    match planes.sum::<Option<u64>>() {
        Some(bytes) => println!(
            "the planes by cjxl -d 0 -e 7: {:.3} bytes a pixel",
            bytes as f64 / (512.0 * 512.0)
        ),
        None => println!("cjxl is not installed: not run"),
    }
}

fn files(c: &mut Criterion) {
    let quiet = Progress::default();
    let pixels =
        InMemory::of(&Scene::reflectance(512, 512, nm(380.0, 780.0, 81)).unwrap()).unwrap();
    let survey = Survey::of(&pixels, &quiet).unwrap();
    let operator = Operator::new(pixels.bands(), &Plan::new(pixels.bands(), 11)).unwrap();
    let numbers = |p: &Vec<f64>| operator.numbers_of(p);
    let sample: Vec<Vec<f64>> = survey.sample.iter().map(numbers).collect();
    let planned = |c_ref| {
        let quantiser = Quantiser::new(&operator, &sample, 0.5, c_ref).unwrap();
        let error = measure(&pixels, &operator, &quantiser, 1.0, &quiet).unwrap();
        CompactPlan { quantiser, error }
    };
    let plan = planned(None);
    // The study's scene: c_ref = 1, the own colour of its table.
    let of_whole = planned(Some(1.0));
    for (what, plan) in [
        ("compact t .5, P 11, 512", &plan),
        ("with c_ref 1", &of_whole),
    ] {
        let error = &plan.error;
        println!("{what}: own {:?}, rms {}", error.own, error.relative_rms);
    }
    let about = About::default();
    let compact = |coder| compact(&pixels, &operator, &plan, coder);
    tell_sizes(&pixels, &operator, [&plan, &of_whole]);
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
            (&about, plan.error.clone()),
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
                (&base, &FixedSettings::default()),
                asked,
                &quiet,
            )
            .unwrap()
        })
    });
}

/// The compact form beside a stand-in for the method of Spectral JPEG XL, at the same 95th
/// percentile of own colour. It is not their authors' program.
fn beside_the_stand_in(_: &mut Criterion) {
    let bands = nm(380.0, 780.0, 81);
    let light = Illuminant::named("FL11").unwrap();
    let wall = InMemory::of(&Scene::reflectance(128, 128, bands.clone()).unwrap()).unwrap();
    let lit = Scene::lit(128, 128, bands, std::slice::from_ref(&light)).unwrap();
    let lit = InMemory::of(&lit).unwrap();
    let plans = [
        (
            "reflectance, 20 numbers",
            &wall,
            Plan::new(wall.bands(), 20),
        ),
        (
            "FL11 known, 11 numbers",
            &lit,
            Plan::lit(lit.bands(), 11, &light, 0.004).unwrap(),
        ),
    ];
    for (name, pixels, plan) in plans {
        let operator = Operator::new(pixels.bands(), &plan).unwrap();
        for distance in [0.1, 0.3, 1.0] {
            let Some(theirs) = theirs::stand_in(pixels, &operator, distance) else {
                println!("cjxl and djxl are not installed: not run");
                return;
            };
            let (bytes, error) = theirs::composite_at(pixels, &operator, theirs.own.p95);
            let a_pixel = |bytes: u64| bytes as f64 / (128.0 * 128.0);
            println!(
                "{name}: stand-in {:.2} bytes a pixel, own p95 {:.2}, rms {:.4}; composite {:.2}, \
                 {:.2}, {:.4}; {:.2} of the bytes",
                a_pixel(theirs.bytes),
                theirs.own.p95,
                theirs.relative_rms,
                a_pixel(bytes),
                error.own.p95,
                error.relative_rms,
                bytes as f64 / theirs.bytes as f64
            );
        }
    }
}

fn tables(c: &mut Criterion) {
    let light = Illuminant::named("FL11").unwrap();
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
    let by_spectrum = DMatrix::from_row_slice(81, 65536, pixels.values()).transpose();
    let matrix = DMatrix::from_element(81, 20, 0.5_f32);
    group.bench_function("the product alone, nalgebra, one thread", |b| {
        b.iter(|| black_box(&by_spectrum) * &matrix)
    });
    group.bench_function("lines of JSON", |b| {
        let ask = FitAsk {
            numbers: 20,
            reference: ReferenceKind::One,
            lines: true,
        };
        let nm = pixels.bands().nm();
        let line = |i: usize| {
            let values = pixels.pixel(i % 256, i / 256);
            serde_json::json!({ "nm": nm, "values": values }).to_string()
        };
        let lines: Vec<String> = (0..64).map(line).collect();
        // Times 1024, to be told as a rate of as many.
        b.iter_custom(|rounds| {
            let started = Instant::now();
            for _ in 0..rounds {
                lines.iter().for_each(|line| {
                    fit_line(line, ask).unwrap();
                });
            }
            started.elapsed() * 1024
        });
    });
}

criterion_group!(
    benches,
    encode,
    from_file,
    relight,
    files,
    large::large,
    beside_the_stand_in,
    tables
);
criterion_main!(benches);
