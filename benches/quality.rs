//! How long the figures of lights take.
//!
//! ```text
//! cargo bench -p benches --bench quality
//! ```
//!
//! ```text
//! one light     every figure of FL2 as measured, of a model with lines, and the few figures that are
//!               drawn against order; the plain way forms each sample's XYZ by itself
//! many lights   1000 lights on two threads and on one
//! orders        figures against order, 0 to 30
//! slider move   model, every figure of light and model, and the chart of the page, anew
//! ```

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use spectral_explorer::{
    app::{App, Command, QualityShown, Settings, charts::quality::diagram, pages::DiagramShows},
    color::{
        Cct, Observer,
        quality::{FewFigures, Figures, Light, Measured, fidelity, fidelity_reference, rendering},
        xyz::xyz_from_reflectance,
    },
    preset,
    spectrum::{
        Band, Basis, BasisTable, Composite, Outside, Sampled, Series, SpikeSettings, detect,
        numbers_of_order,
    },
    study::{
        Progress,
        quality::{figures_against_order, figures_of_many},
    },
};

fn tables(group: &str) -> Vec<(String, Sampled)> {
    let group = preset::group(group).expect("a shipped group");
    let tables = group.items.iter().filter_map(|item| {
        let table = item.spectrum()?.samples.clone();
        Some((item.name.clone(), table))
    });
    tables.collect()
}

fn fl2() -> Sampled {
    let tables = tables("cie_fluorescent_5nm");
    let found = tables.into_iter().find(|(name, _)| name == "FL2");
    found.expect("FL2 is shipped").1
}

/// Models of a light by order: lines found once, coefficients cut from one fit.
fn models(table: &Sampled, highest: usize) -> impl Fn(usize) -> Composite {
    let band = Band::VISIBLE;
    let parts = detect(
        band,
        &table.on_band(band, Outside::Zero),
        SpikeSettings::default(),
    );
    let numbers = numbers_of_order(highest);
    let basis = BasisTable::new(band, Basis::Cosine, numbers);
    let whole = Series {
        band,
        basis: Basis::Cosine,
        coefficients: basis.project(&parts.smooth, numbers),
    };
    let spikes: Vec<_> = parts.spikes.iter().map(|found| found.spike).collect();
    move |order| {
        Composite::of_lines_inside(whole.truncated(numbers_of_order(order)), spikes.clone())
    }
}

/// The 99 samples under light and reference, one integral after the other from their tables.
fn plainly(samples: &[(String, Sampled)], light: &Sampled, reference: &Sampled) -> f64 {
    let xyz = |light: &Sampled| -> f64 {
        samples
            .iter()
            .filter_map(|(_, sample)| xyz_from_reflectance(sample, light, Observer::CIE_1964))
            .map(|xyz| xyz.x + xyz.y + xyz.z)
            .sum()
    };
    xyz(light) - xyz(reference)
}

fn one_light(criterion: &mut Criterion) {
    let table = fl2();
    let light = Light::of_sampled(&table);
    let model = Light::of_composite(&models(&table, 7)(7));
    let cct = Cct {
        kelvin: 4225.0,
        duv: 0.002,
    };
    let mut group = criterion.benchmark_group("one light");
    group.bench_function("every figure, measured", |b| {
        b.iter(|| Figures::of(black_box(&light), None));
    });
    group.bench_function("every figure, from the table of the file", |b| {
        b.iter(|| Figures::of(&Light::of_sampled(black_box(&table)), None));
    });
    group.bench_function("every figure, a model with four lines", |b| {
        b.iter(|| Figures::of(black_box(&model), None));
    });
    group.bench_function("the few figures against order", |b| {
        b.iter(|| FewFigures::of(black_box(&light)));
    });
    group.bench_function("TM-30 alone", |b| {
        b.iter(|| fidelity(black_box(&light), cct))
    });
    group.bench_function("CRI alone", |b| {
        b.iter(|| rendering(black_box(&light), cct))
    });
    let samples = tables("tm30_ces99_5nm");
    let reference = Sampled::even(360.0, 1.0, fidelity_reference(4225.0).on_nm());
    let reference = reference.expect("finite values");
    group.sample_size(20);
    group.bench_function("the plain way: only the samples' XYZ of TM-30", |b| {
        b.iter(|| plainly(&samples, black_box(&table), &reference));
    });
}

fn many_lights(criterion: &mut Criterion) {
    let lamps = tables("cie_fluorescent_5nm");
    let lights: Vec<(Light, Option<Measured>)> = (0..1000)
        .map(|i| (Light::of_sampled(&lamps[i % lamps.len()].1), None))
        .collect();
    let mut group = criterion.benchmark_group("1000 lights");
    group.sample_size(10);
    for threads in [1, 2] {
        group.bench_function(format!("{threads} threads"), |b| {
            b.iter(|| figures_of_many(&lights, threads, &Progress::default()));
        });
    }
}

fn orders(criterion: &mut Criterion) {
    let table = fl2();
    let light = Light::of_sampled(&table).within(Band::VISIBLE);
    let model = models(&table, 30);
    criterion.bench_function("figures against order, 31 orders", |b| {
        b.iter(|| figures_against_order(&light, 30, &model, &Progress::default()));
    });
}

/// A move of the order with the place Quality shown: the model anew, every figure of light and model,
/// and the chart of the page.
fn slider_move(c: &mut Criterion) {
    let mut group = c.benchmark_group("a slider move with Quality shown");
    let mut app = App::new();
    let mut order = 7;
    let mut step = move || {
        order = 15 - order;
        let settings = Settings {
            order,
            ..app.document().settings
        };
        app.apply(Command::Edit(settings));
        QualityShown::of(&app)
    };
    group.bench_function("figures", |b| b.iter(&mut step));
    group.bench_function("chromaticity", |b| {
        b.iter(|| diagram(&step().placed(), DiagramShows::default()));
    });
    group.finish();
}

criterion_group!(benches, one_light, many_lights, orders, slider_move);
criterion_main!(benches);
