//! Speed of reading files, each figure beside a plain baseline of the same run.
//!
//! `cargo bench -p benches --bench files`

use std::{
    fmt::Write as _,
    fs,
    hint::black_box,
    path::{Path, PathBuf},
    sync::Arc,
    time::Duration,
};

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use spectral_explorer::{
    app::{
        ByAddress, Library,
        picture::{BandWeights, Exposed, MOST_SIDE, RasterAsk, Source, exposed},
        studies::Question,
    },
    color::Observer,
    io::read_path,
    study::Progress,
};

/// Files of a folder that is opened at once.
const FILES: usize = 100;
/// Columns of values in the long table; one of wavelengths stands before them.
const COLUMNS: usize = 20;
/// Size of the long table.
const LONG_BYTES: usize = 100_000_000;

/// A smooth curve with something of its own in every column, as an instrument writes it.
fn value(row: usize, column: usize) -> f64 {
    let x = row as f64 * 1e-3 + column as f64;
    1.5 + x.sin() + 1e-4 * ((row * 7919 + column * 104_729) % 9973) as f64
}

fn hundred_files(folder: &Path) -> Vec<PathBuf> {
    let one = |file: usize| {
        let mut text = String::from("wavelength (nm),spectral irradiance (W m-2 nm-1)\n");
        for row in 0..401 {
            let _ = writeln!(text, "{},{:.6}", 380 + row, value(row, file));
        }
        let path = folder.join(format!("lamp {file:03}.csv"));
        fs::write(&path, text).expect("a file in a temporary folder");
        path
    };
    (0..FILES).map(one).collect()
}

fn long_table(folder: &Path) -> (PathBuf, usize) {
    let mut text = String::from("nm");
    for column in 1..COLUMNS {
        let _ = write!(text, ",lamp {column}");
    }
    text.push('\n');
    let mut row = 0;
    while text.len() < LONG_BYTES {
        let _ = write!(text, "{:.4}", 300.0 + row as f64 * 1e-3);
        for column in 1..COLUMNS {
            let _ = write!(text, ",{:.6}", value(row, column));
        }
        text.push('\n');
        row += 1;
    }
    let path = folder.join("long.csv");
    fs::write(&path, &text).expect("a file in a temporary folder");
    (path, text.len())
}

/// Columns and rows of the cube.
const SIDE: usize = 512;
/// Bands of the cube.
const BANDS: usize = 31;

/// An ENVI cube as a camera with tunable filters writes it: 16 bits a number.
fn cube(folder: &Path) -> (PathBuf, PathBuf) {
    let nm: Vec<String> = (0..BANDS).map(|b| (400 + 10 * b).to_string()).collect();
    let header = format!(
        "ENVI\nsamples = {SIDE}\nlines = {SIDE}\nbands = {BANDS}\nheader offset = 0\ndata type = 12\n\
         interleave = bsq\nbyte order = 0\nreflectance scale factor = 10000\n\
         wavelength units = Nanometers\nwavelength = {{{}}}\n",
        nm.join(", ")
    );
    let number = |i: usize| (i.wrapping_mul(7919) % 9973) as u16;
    let bytes: Vec<u8> = (0..SIDE * SIDE * BANDS)
        .flat_map(|i| number(i).to_le_bytes())
        .collect();
    let paths = (folder.join("scene.hdr"), folder.join("scene.img"));
    fs::write(&paths.0, header).expect("a file in a temporary folder");
    fs::write(&paths.1, bytes).expect("a file in a temporary folder");
    paths
}

/// What any program has to do at least: read the file and make every number one it can add.
fn plain_cube(path: &PathBuf) -> Vec<f32> {
    let bytes = fs::read(path).expect("the file that was written");
    let numbers = bytes.chunks_exact(2);
    numbers
        .map(|b| f32::from(u16::from_le_bytes([b[0], b[1]])))
        .collect()
}

/// The picture that the window shows of a file's first image.
fn true_colour(path: &Path) -> Exposed {
    let mut reading = read_path(path).expect("a cube");
    let image = Arc::new(reading.images.remove(0));
    let light = Library::bundled().find("CIE D65").expect("shipped");
    let light = light.spectrum().expect("a spectrum");
    let weights = BandWeights::of(&image, Observer::CIE_1931, Some(light), false).expect("light");
    let ask = RasterAsk {
        image: ByAddress(image),
        source: Source::TrueColour(Box::new(weights)),
        most_side: MOST_SIDE,
    };
    let raster = ask.answer(&Progress::default()).expect("not cancelled");
    exposed(&raster, 0.0)
}

/// What any program has to do at least: split lines at commas and parse every cell.
fn plain_loop(path: &PathBuf) -> f64 {
    let text = fs::read_to_string(path).expect("the file that was written");
    let rows = text.lines().skip(1);
    let cells = rows.flat_map(|line| line.split(','));
    cells.map(|cell| cell.parse::<f64>().unwrap_or(0.0)).sum()
}

fn files(criterion: &mut Criterion) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let hundred = hundred_files(folder.path());
    let mut group = criterion.benchmark_group("100 CSV files of 401 points");
    group.measurement_time(Duration::from_secs(3));
    group.bench_function("baseline: split and parse", |b| {
        b.iter(|| hundred.iter().map(plain_loop).sum::<f64>());
    });
    group.bench_function("read", |b| {
        b.iter(|| {
            for path in &hundred {
                black_box(read_path(path).expect("a table"));
            }
        });
    });
    group.finish();

    let (path, bytes) = long_table(folder.path());
    let mut group = criterion.benchmark_group("100 MB of text in 20 columns");
    group
        .sample_size(10)
        .throughput(Throughput::Bytes(bytes as u64));
    group.bench_function("baseline: split and parse", |b| {
        b.iter(|| plain_loop(black_box(&path)));
    });
    group.bench_function("read", |b| {
        b.iter(|| black_box(read_path(&path).expect("a table")));
    });
    group.finish();
}

fn cubes(criterion: &mut Criterion) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (header, data) = cube(folder.path());
    let mut group = criterion.benchmark_group("512 x 512 x 31 ENVI cube opens");
    group
        .sample_size(20)
        .measurement_time(Duration::from_secs(3))
        .throughput(Throughput::Bytes((2 * SIDE * SIDE * BANDS) as u64));
    group.bench_function("baseline: read and convert every number", |b| {
        b.iter(|| plain_cube(black_box(&data)));
    });
    group.bench_function("read", |b| {
        b.iter(|| black_box(read_path(&header).expect("a cube")));
    });
    group.bench_function("read and drawn in true colour", |b| {
        b.iter(|| black_box(true_colour(&header)));
    });
    group.finish();
}

criterion_group!(benches, files, cubes);
criterion_main!(benches);
