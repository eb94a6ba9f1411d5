//! How fast light goes through things, each goal beside a plain way of doing the same.
//!
//! ```text
//! cargo bench -p benches --bench optics
//! ```
//!
//! ```text
//! tracer     view A in diamond at 589.294 nm on one core: rays and segments a second; the plain
//!            way is one ray after another in double precision
//! growth     with rays, pixels and cores: the time for a ray must not grow
//! FL11       256 x 256 with its eight spikes; the plain way traces every whole 5 nm alike
//! relight    another light on a finished 480 x 480 film; the plain way traces it anew
//! turning    96 x 96 pixels with 12 rays
//! prism      1000 columns and 20 spikes, figures included; the plain way samples 0.001 nm points
//! rainbow    the sky strip of 1000 columns under a light of 20 spikes; the plain way traces every
//!            whole nm again
//! ```

use std::{
    hint::black_box,
    num::NonZero,
    time::{Duration, Instant},
};

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use spectral_explorer::{
    app::Library,
    color::Observer,
    optics::{
        Absorption, Bench, BenchSettings, Brilliant, BuiltinMaterial, Ending, Film, FilmSettings,
        Light, Scene, Sky, Studio,
    },
    spectrum::{Band, Line, SpikeSettings, detect},
    study::Progress,
};

fn studio_in(scene: Scene) -> Studio {
    let solid = Brilliant::default().solid().expect("the default cut");
    let diamond = BuiltinMaterial::Diamond.material();
    Studio::new(solid, diamond, Absorption::None, scene).expect("a scene in order")
}

fn studio() -> Studio {
    studio_in(Scene::default())
}

fn film_in(scene: Scene, size: usize) -> Film {
    let settings = FilmSettings {
        size,
        ..FilmSettings::default()
    };
    Film::new(studio_in(scene), settings).expect("a size in range")
}

fn film(size: usize) -> Film {
    film_in(Scene::default(), size)
}

fn preset(name: &str) -> Light {
    let preset = Library::bundled().find(name).expect("a shipped light");
    let spectrum = preset.spectrum().expect("a table");
    let band = Band::VISIBLE;
    let values = spectrum.samples.on_band(band, spectrum.kind.outside());
    let parts = detect(band, &values, SpikeSettings::default());
    let spikes = parts.spikes.iter().map(|s| s.spike).collect();
    Light::new(name, band, parts.smooth, spikes).expect("a light that shines")
}

fn cores(count: usize) -> Option<NonZero<usize>> {
    NonZero::new(count)
}

fn go() -> Progress {
    Progress::default()
}

fn tracer(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("view A, diamond, 589.294 nm, one core");
    group
        .sample_size(10)
        .measurement_time(Duration::from_secs(4));
    let mut counted = film(128);
    counted
        .trace_lines(&[589.294], 8, cores(1), &go())
        .expect("rays");
    let traced = counted.traced();
    let segments = traced.segments as f64 / traced.rays as f64;
    println!(
        "{segments:.2} segments a ray, {:.2} a ray on the gem",
        traced.segments_per_ray()
    );
    for (what, unit) in [("rays", traced.rays), ("segments", traced.segments)] {
        group.throughput(Throughput::Elements(unit));
        group.bench_function(format!("side by side, {what}"), |b| {
            b.iter(|| {
                let mut film = film(128);
                film.trace_lines(&[589.294], 8, cores(1), &go())
                    .expect("rays");
                black_box(film.traced());
            });
        });
    }
    let studio = studio();
    group.throughput(Throughput::Elements(32 * 32));
    group.bench_function("one after another, double, rays", |b| {
        b.iter(|| {
            for i in 0..1024_u32 {
                let place = |i: u32| (f64::from(i) + 0.5) / 16.0 - 1.0;
                let film = [place(i % 32), place(i / 32)];
                black_box(
                    studio
                        .look(film, 589.294, Ending::default())
                        .expect("an index"),
                );
            }
        });
    });
    group.finish();
}

fn growth(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("growth, 589.294 nm, time a ray");
    group
        .sample_size(10)
        .measurement_time(Duration::from_secs(2));
    for (what, size, rays, threads) in [
        ("8 rays", 96, 8, 1),
        ("32 rays", 96, 32, 1),
        ("4 times the pixels", 192, 8, 1),
        ("2 cores", 192, 8, 2),
    ] {
        group.throughput(Throughput::Elements((size * size) as u64 * u64::from(rays)));
        group.bench_function(BenchmarkId::from_parameter(what), |b| {
            b.iter(|| {
                let mut film = film(size);
                film.trace_lines(&[589.294], rays, cores(threads), &go())
                    .expect("rays");
                black_box(film.traced());
            });
        });
    }
    group.finish();
}

fn pictures(criterion: &mut Criterion) {
    let fl11 = preset("FL11");
    let mut group = criterion.benchmark_group("pictures under FL11");
    group
        .sample_size(10)
        .measurement_time(Duration::from_secs(5));
    for rays in [16, 64] {
        let mut told = film(256);
        told.trace(&fl11, rays, None, &go()).expect("rays");
        let own = told.noise(&fl11, Observer::CIE_1931);
        println!("256 x 256, {rays} rays: {own:?}");
        group.bench_function(format!("256 x 256, {rays} rays, one core"), |b| {
            b.iter(|| {
                let mut film = film(256);
                film.trace(&fl11, rays, cores(1), &go()).expect("rays");
                black_box(film.picture(&fl11, Observer::CIE_1931));
            });
        });
    }
    let grid: Vec<f64> = (0..81).map(|i| 380.0 + 5.0 * f64::from(i)).collect();
    group.bench_function("256 x 256, 81 wavelengths of a 5 nm grid, one core", |b| {
        b.iter(|| {
            let mut film = film(256);
            film.trace_lines(&grid, 1, cores(1), &go()).expect("rays");
            black_box(film.traced());
        });
    });
    group.bench_function("first whole picture, 120 x 120, 12 rays, two cores", |b| {
        b.iter(|| {
            let mut film = film(120);
            film.trace(&fl11, 12, cores(2), &go()).expect("rays");
            black_box(film.picture(&fl11, Observer::CIE_1931).shown(0.0));
        });
    });
    for (lamps, scene) in [
        ("", Scene::default()),
        (" under the window's lamps", Scene::jeweller()),
    ] {
        let name = format!("turning, 96 x 96, 12 rays, two cores{lamps}");
        group.bench_function(name, |b| {
            b.iter(|| {
                let mut film = film_in(scene.clone(), 96);
                film.trace(&fl11, 12, cores(2), &go()).expect("rays");
                black_box(film.picture(&fl11, Observer::CIE_1931).shown(0.0));
            });
        });
    }
    group.finish();
}

fn relit(criterion: &mut Criterion) {
    let (fl11, fl2) = (preset("FL11"), preset("FL2"));
    let mut group = criterion.benchmark_group("a finished film");
    group
        .sample_size(10)
        .measurement_time(Duration::from_secs(5));
    let mut large = film(480);
    // Once: ten times would take minutes.
    let start = Instant::now();
    large.trace(&fl11, 64, cores(2), &go()).expect("rays");
    println!(
        "480 x 480, 64 rays, {} planes, {} MB: {:.2} s on two cores, the plain way to another light",
        large.planes().len(),
        large.bytes() >> 20,
        start.elapsed().as_secs_f64()
    );
    let start = Instant::now();
    film(480)
        .trace_lines(&eight_new(), 16, cores(2), &go())
        .expect("rays");
    println!(
        "eight new spikes on 480 x 480, 16 rays each: {:.2} s on two cores",
        start.elapsed().as_secs_f64()
    );
    group.bench_function("another light on 480 x 480", |b| {
        b.iter(|| black_box(large.picture(&fl2, Observer::CIE_1931)));
    });
    group.bench_function(
        "eight new spikes on 480 x 480, 1 ray each, two cores",
        |b| {
            b.iter(|| {
                let mut film = film(480);
                film.trace_lines(&eight_new(), 1, cores(2), &go())
                    .expect("rays");
                black_box(film.traced());
            });
        },
    );
    group.finish();
}

/// Places of spikes that no film has.
fn eight_new() -> Vec<f64> {
    (0..8).map(|i| 400.5 + 40.0 * f64::from(i)).collect()
}

fn twenty_spikes() -> Light {
    let band = Band::VISIBLE;
    let smooth = band
        .grid()
        .map(|nm| 1.0 + 0.5 * (nm / 37.0).sin())
        .collect();
    let spike = |i: i32| Line::ideal(400.3 + 17.7 * f64::from(i), 10.0);
    Light::new("twenty", band, smooth, (0..20).map(spike).collect()).expect("a light")
}

fn bench_and_sky(criterion: &mut Criterion) {
    let light = twenty_spikes();
    let mut group = criterion.benchmark_group("1000 columns, 20 spikes");
    group.bench_function("prism, set up, all figures and the screen", |b| {
        b.iter(|| {
            let bench = Bench::new(BenchSettings::default(), BuiltinMaterial::NSf11.material());
            let bench = bench.expect("the default bench");
            let screen = bench
                .whole_screen(&light, 1000)
                .expect("light on the screen");
            for spike in light.spikes() {
                black_box(bench.landing(spike.at_nm).expect("an index"));
            }
            black_box(bench.strip(&light, screen, Observer::CIE_1931));
        });
    });
    group.sample_size(10);
    group.bench_function("prism, plain points of 0.001 nm", |b| {
        let bench = Bench::new(BenchSettings::default(), BuiltinMaterial::NSf11.material());
        let bench = bench.expect("the default bench");
        b.iter(|| {
            let mut columns = vec![0.0; 1000];
            for i in 0..400_000 {
                let nm = 380.0 + f64::from(i) / 1000.0;
                let n = bench.material().index(nm).expect("an index");
                let passage = bench.prism().passage(n).expect("light that leaves");
                let column = (passage.deviation_deg * 20.0) as usize % 1000;
                columns[column] += light.smooth_at(nm) * passage.transmittance();
            }
            black_box(columns);
        });
    });
    group.sample_size(30);
    let sky = Sky::new(BuiltinMaterial::Water.material(), 1000);
    group.bench_function("rainbow, another light", |b| {
        b.iter(|| black_box(sky.strip(&light, Observer::CIE_1931, true)));
    });
    group.sample_size(10);
    group.bench_function("rainbow, all wavelengths anew", |b| {
        b.iter(|| {
            let sky = Sky::new(BuiltinMaterial::Water.material(), 1000);
            black_box(sky.strip(&light, Observer::CIE_1931, true))
        });
    });
    group.finish();
}

criterion_group!(all, bench_and_sky, tracer, growth, pictures, relit);
criterion_main!(all);
