//! How long the program takes to answer, each figure beside a plain way of doing the same.
//!
//! ```text
//! cargo bench -p benches --bench explorer
//! ```
//!
//! Everything runs on one thread. The target stands in the group's name. The plain way of a
//! slider move and of the error curve, written at the end of this file without prepared products,
//! prefixes or running sums, gives the same numbers (checked before anything is measured). Spike
//! detection stands beside the paper's detector and a frame beside a bare plot of its curves.
//!
//! ```text
//! a slider move          fit at N = 7, reconstruction, XYZ, 24 patches exact and model, CIEDE2000
//! the window derives     the same and errors, swatches, CCT, and the error curve to N = 40
//! spike detection        one lamp of 401 points
//! a product              2N + 2 samples against 401, with the ratio
//! a frame                the window's ui and tessellation, 20 overlays, 1280 x 800
//! ```

use std::{cell::Cell, hint::black_box, sync::Arc, time::Instant};

use criterion::{Bencher, Criterion, Throughput, criterion_group, criterion_main};
use eframe::egui;
use spectral_explorer::{
    app::{
        App, CURVE_ORDER, Command, FIRST_LIGHT, Settings, Tables, derive, derived::Derived,
        workspace::Preferences,
    },
    color::{
        Lab, Observer, Xyz, delta_e_2000, lab_from_xyz,
        patches::{difference, labs_into},
    },
    spectrum::{
        Band, Basis, Constraints, Line, SampleGrid, Series, SpikeSettings, detect,
        gradient::{self, DEFAULT_GRADIENT},
        numbers_of_order,
    },
    study::Measure,
    ui::{Window, files::Picked},
};

const BAND: Band = Band::VISIBLE;
const ORDER: usize = 7;

/// The lamps that spikes are looked for in: triphosphor, plain fluorescent and bare discharge.
const LAMPS: [&str; 3] = [
    FIRST_LIGHT,
    "cie_fluorescent_1nm/FL11",
    "lamps_nist_traditional/Mercury",
];

/// What a slider move starts from: the first light, taken apart already.
struct Start {
    app: App,
    measured: Vec<f64>,
    smooth: Vec<f64>,
    spikes: Vec<Line>,
}

impl Start {
    fn new() -> Self {
        let mut app = App::new();
        // The plain loops fit by plain least squares.
        app.apply(Command::Edit(Settings::plain()));
        let derived = app.derived();
        assert_eq!(derived.band, BAND);
        Self {
            measured: derived.measured.clone(),
            smooth: derived.parts.smooth.clone(),
            spikes: derived.model.lines().to_vec(),
            app,
        }
    }

    fn tables(&self) -> &Tables {
        self.app.tables()
    }
}

/// What one move of the order slider gives, without what hangs on it in the window.
#[derive(Debug)]
struct Moved {
    coefficients: Vec<f64>,
    reconstruction: Vec<f64>,
    exact: Xyz,
    model: Xyz,
    own: f64,
    mean: f64,
    max: f64,
}

/// A slider move as the program does it.
fn slider_move(start: &Start, tables: &Tables) -> Moved {
    let patches = tables.patches.as_ref().expect("a light has patches");
    let coefficients = tables.basis.project(&start.smooth, numbers_of_order(ORDER));
    let reconstruction = tables.basis.evaluate(&coefficients);
    let (mut exact_patches, mut model_patches) = (patches.set.buffer(), patches.set.buffer());
    patches.set.xyz_into(&start.measured, &mut exact_patches);
    patches.matrix.xyz_into(&coefficients, &mut model_patches);
    let exact = patches.set.white_xyz(&start.measured);
    let mut model = patches.matrix.white_xyz(&coefficients);
    for spike in &start.spikes {
        patches
            .set
            .add_line(spike.at_nm, spike.weight, &mut model_patches);
        model += patches.set.line_white_xyz(spike.at_nm, spike.weight);
    }
    let (mut exact_labs, mut model_labs) = (
        vec![Lab::default(); exact_patches.len()],
        vec![Lab::default(); exact_patches.len()],
    );
    labs_into(&exact_patches, exact, &mut exact_labs);
    labs_into(&model_patches, exact, &mut model_labs);
    let found = difference(&exact_labs, &model_labs);
    Moved {
        own: delta_e_2000(lab_from_xyz(exact, exact), lab_from_xyz(model, exact)),
        mean: found.mean,
        max: found.max,
        coefficients,
        reconstruction,
        exact,
        model,
    }
}

fn a_slider_move(criterion: &mut Criterion) {
    let start = Start::new();
    let plain = plain::Tables::new(start.tables());
    agree(
        &slider_move(&start, start.tables()),
        &plain.slider_move(&start, ORDER),
    );
    let mut group = criterion.benchmark_group("a slider move (target 30 us)");
    group.bench_function("this program", |b| {
        b.iter(|| slider_move(black_box(&start), start.tables()));
    });
    group.bench_function("plain loops over the grid", |b| {
        b.iter(|| plain.slider_move(black_box(&start), ORDER));
    });
    group.finish();
}

/// Both ways sum the same few hundred products in different orders.
fn agree(one: &Moved, other: &Moved) {
    let near = |a: f64, b: f64, scale: f64| {
        assert!((a - b).abs() <= 1e-9 * scale, "{a} and {b} differ");
    };
    let size = |values: &[f64]| values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let (numbers, curve) = (size(&one.coefficients), size(&one.reconstruction));
    for (a, b) in one.coefficients.iter().zip(&other.coefficients) {
        near(*a, *b, numbers);
    }
    for (a, b) in one.reconstruction.iter().zip(&other.reconstruction) {
        near(*a, *b, curve);
    }
    for (a, b) in [(one.exact, other.exact), (one.model, other.model)] {
        near(a.x, b.x, one.exact.y);
        near(a.y, b.y, one.exact.y);
        near(a.z, b.z, one.exact.y);
    }
    // The plain colour difference goes by angles and cube roots by powers.
    near(one.own, other.own, 1.0);
    near(one.mean, other.mean, 1.0);
    near(one.max, other.max, 1.0);
}

fn all_that_the_window_derives(criterion: &mut Criterion) {
    let start = Start::new();
    let plain = plain::Tables::new(start.tables());
    let derived: Derived = derive(start.app.document(), start.tables(), None);
    for (point, moved) in derived.curve.iter().zip(plain.curve(&start)) {
        let near = |measure: Measure, plain: f64| {
            let found = point.figures[measure].expect("a light");
            let off = (found - plain).abs();
            assert!(off <= 1e-9, "{measure:?}: {found} against {plain}");
        };
        near(Measure::Own, moved.own);
        near(Measure::Patches, moved.mean);
        near(Measure::Rms, moved.relative_rms);
        near(Measure::RmsBlurred, moved.relative_rms_10nm);
    }
    let mut group = criterion.benchmark_group("all that the window derives (target 2 ms)");
    group.bench_function("this program", |b| {
        b.iter(|| derive(black_box(start.app.document()), start.tables(), None));
    });
    let mut app = start.app.clone();
    let mut orders = orders();
    group.bench_function("this program, as a command", |b| {
        b.iter(|| {
            app.apply(next_edit(&mut orders));
            app.derived().numbers()
        });
    });
    let mut wide = start.app.clone();
    wide.apply(Command::Edit(Settings {
        wide_lines: true,
        ..wide.document().settings
    }));
    group.bench_function("this program, lines as wide as they are", |b| {
        b.iter(|| derive(black_box(wide.document()), wide.tables(), None));
    });
    group.bench_function("plain loops, every order from the start", |b| {
        b.iter(|| plain.curve(black_box(&start)));
    });
    group.finish();
}

fn spike_detection(criterion: &mut Criterion) {
    let app = App::new();
    let mut group = criterion.benchmark_group("spike detection, 401 points (target 20 us)");
    for key in LAMPS {
        let values = app.entry(key).expect("a shipped lamp").on_band(BAND);
        let settings = SpikeSettings::default();
        let name = key.rsplit('/').next().unwrap_or(key);
        group.bench_function(format!("{name}, this program"), |b| {
            b.iter(|| detect(BAND, black_box(&values), settings));
        });
        group.bench_function(format!("{name}, the paper's gradient"), |b| {
            b.iter(|| {
                let widest = settings.max_width_nm;
                let constraints = Constraints::default();
                gradient::detect(
                    BAND,
                    black_box(&values),
                    DEFAULT_GRADIENT,
                    widest,
                    constraints,
                )
            });
        });
    }
    group.finish();
}

/// One light times the patches, one after the other, on few points and on the grid.
fn a_product(criterion: &mut Criterion) {
    let start = Start::new();
    let patches = start
        .tables()
        .patches
        .as_ref()
        .expect("a light has patches");
    let numbers = numbers_of_order(ORDER);
    // Eq. 15 counts both ends of the period: 2N + 2 samples for 2N + 1 numbers.
    let grid = SampleGrid {
        band: BAND,
        basis: Basis::Fourier,
        points: numbers,
    };
    let samples = |coefficients: &[f64]| {
        let mut values = grid.sample(&Series {
            band: BAND,
            basis: Basis::Fourier,
            coefficients: coefficients[..numbers].to_vec(),
        });
        values.push(values[0]);
        values
    };
    let light = samples(&start.app.derived().model.smooth().coefficients);
    let factors: Vec<Vec<f64>> = patches.coefficients.iter().map(|c| samples(c)).collect();
    assert_eq!(light.len(), 2 * ORDER + 2);

    let (few, many) = (Fastest::default(), Fastest::default());
    let mut group = criterion.benchmark_group("a product of two spectra (as a ratio)");
    group.throughput(Throughput::Elements(factors.len() as u64));
    group.bench_function("2N + 2 = 16 samples", |b| {
        few.measure(b, products(&light, &factors));
    });
    group.bench_function("401 samples", |b| {
        many.measure(b, products(&start.measured, &patches.reflectances));
    });
    group.finish();
    if let (Some(few), Some(many)) = (few.seconds(), many.seconds()) {
        println!(
            "16 samples instead of 401: {:.1} times as many products per second\n",
            many / few
        );
    }
}

fn products<'a>(light: &'a [f64], factors: &'a [Vec<f64>]) -> impl FnMut() + 'a {
    let mut product = vec![0.0; light.len()];
    move || {
        let light = black_box(light);
        for factor in factors {
            for ((p, l), f) in product.iter_mut().zip(light).zip(factor) {
                *p = l * f;
            }
            black_box(&mut product);
        }
    }
}

/// The fastest time of one round that was seen while measuring.
#[derive(Default)]
struct Fastest(Cell<Option<f64>>);

impl Fastest {
    fn measure(&self, bencher: &mut Bencher<'_>, mut round: impl FnMut()) {
        bencher.iter_custom(|rounds| {
            let start = Instant::now();
            for _ in 0..rounds {
                round();
            }
            let took = start.elapsed();
            let each = took.as_secs_f64() / rounds as f64;
            // Few rounds at a time measure the clock more than the work.
            if rounds >= 100 && self.0.get().is_none_or(|fastest| each < fastest) {
                self.0.set(Some(each));
            }
            took
        });
    }

    fn seconds(&self) -> Option<f64> {
        self.0.get()
    }
}

/// Overlays of the measured frame.
const OVERLAYS: usize = 20;
const SIZE: egui::Vec2 = egui::vec2(1280.0, 800.0);
/// Frames before the measured ones, until layout and animations are settled.
const SETTLING_FRAMES: usize = 60;

fn a_frame(criterion: &mut Criterion) {
    let mut app = App::new();
    let lights: Vec<_> = app
        .bundled()
        .iter()
        .filter(|entry| entry.key.starts_with("cie_fluorescent_1nm/"))
        .take(OVERLAYS)
        .cloned()
        .collect();
    assert_eq!(lights.len(), OVERLAYS);
    for light in lights {
        app.apply(Command::ToggleOverlay(light));
    }
    app.end_gesture();
    let curves: Vec<Vec<[f64; 2]>> = std::iter::once(&app.document().light)
        .chain(&app.document().overlays)
        .map(|entry| {
            BAND.grid()
                .zip(entry.on_band(BAND))
                .map(<[f64; 2]>::from)
                .collect()
        })
        .collect();

    let mut group =
        criterion.benchmark_group("a frame, 20 overlays (targets 2 ms recomputed, 0.8 ms at rest)");
    group.sample_size(50);
    let mut orders = orders();
    for moves in [true, false] {
        let no_files = Arc::new(|_: &_| Picked::Cancelled);
        let mut window = Window::new(app.clone(), Preferences::default(), no_files, None);
        let mut screen = Screen::default();
        for _ in 0..SETTLING_FRAMES {
            screen.frame(|ui| window.show(ui));
        }
        let name = match moves {
            true => "the window, everything recomputed",
            false => "the window at rest",
        };
        group.bench_function(name, |b| {
            b.iter(|| {
                if moves {
                    window.app.apply(next_edit(&mut orders));
                }
                screen.frame(|ui| window.show(ui))
            });
        });
    }
    group.bench_function("a bare plot of the 21 curves", |b| {
        let mut screen = Screen::default();
        b.iter(|| {
            screen.frame(|ui| {
                egui::CentralPanel::default_margins().show(ui, |ui| {
                    egui_plot::Plot::new("curves").show(ui, |plot| {
                        for curve in &curves {
                            plot.line(egui_plot::Line::new("", curve.clone()));
                        }
                    });
                });
            })
        });
    });
    group.finish();
}

/// A display that nobody looks at.
#[derive(Default)]
struct Screen {
    context: egui::Context,
    frames: u32,
}

impl Screen {
    /// One frame down to its triangles; the number of meshes keeps it from being left out.
    fn frame(&mut self, show: impl FnMut(&mut egui::Ui)) -> usize {
        self.frames += 1;
        let input = egui::RawInput {
            screen_rect: Some(egui::Rect::from_min_size(egui::Pos2::ZERO, SIZE)),
            time: Some(f64::from(self.frames) / 60.0),
            ..Default::default()
        };
        let output = self.context.run_ui(input, show);
        self.context
            .tessellate(output.shapes, output.pixels_per_point)
            .len()
    }
}

/// Orders that a slider goes through, there and back.
fn orders() -> impl Iterator<Item = usize> {
    (5..15).chain((5..15).rev()).cycle()
}

fn next_edit(orders: &mut impl Iterator<Item = usize>) -> Command {
    Command::Edit(Settings {
        order: orders.next().unwrap_or(ORDER),
        ..Settings::default()
    })
}

/// The straightforward way: what one writes first, from the formulas.
mod plain {
    use super::*;

    /// Functions on the grid, one row each, and nothing multiplied ahead of time.
    pub(crate) struct Tables {
        basis: Vec<Vec<f64>>,
        norms: Vec<f64>,
        cmf: [Vec<f64>; 3],
        reflectances: Vec<Vec<f64>>,
    }

    /// One order of the curve.
    pub(crate) struct Point {
        pub own: f64,
        pub mean: f64,
        pub relative_rms: f64,
        pub relative_rms_10nm: f64,
    }

    impl Tables {
        pub(crate) fn new(tables: &super::Tables) -> Self {
            let basis = tables.basis.basis();
            let numbers = 0..tables.basis.numbers();
            let patches = tables.patches.as_ref().expect("a light has patches");
            Self {
                basis: numbers
                    .clone()
                    .map(|k| tables.basis.row(k).to_vec())
                    .collect(),
                norms: numbers.map(|k| basis.norm_squared(k, BAND)).collect(),
                cmf: (*Observer::CIE_1931.table().on_band(BAND)).clone(),
                reflectances: patches.reflectances.clone(),
            }
        }

        pub(crate) fn slider_move(&self, start: &Start, order: usize) -> Moved {
            let numbers = numbers_of_order(order);
            let coefficients: Vec<f64> = (0..numbers)
                .map(|k| integral(|i| start.smooth[i] * self.basis[k][i]) / self.norms[k])
                .collect();
            let reconstruction: Vec<f64> = (0..BAND.points())
                .map(|i| {
                    (0..numbers)
                        .map(|k| coefficients[k] * self.basis[k][i])
                        .sum()
                })
                .collect();
            // The model as a list of values, each spike on its two neighbouring nm.
            let mut model = reconstruction.clone();
            add_lines(&start.spikes, &mut model);
            let white = self.xyz(|i| start.measured[i]);
            let model_xyz = self.line_xyz(&reconstruction, &start.spikes, |_| 1.0);
            let differences: Vec<f64> = self
                .reflectances
                .iter()
                .map(|r| {
                    let exact = self.xyz(|i| start.measured[i] * r[i]);
                    let smooth: Vec<f64> =
                        reconstruction.iter().zip(r).map(|(s, r)| s * r).collect();
                    let model = self.line_xyz(&smooth, &start.spikes, |nm| BAND.interpolate(r, nm));
                    delta_e(lab(exact, white), lab(model, white))
                })
                .collect();
            Moved {
                own: delta_e(lab(white, white), lab(model_xyz, white)),
                mean: differences.iter().sum::<f64>() / differences.len() as f64,
                max: differences.iter().copied().fold(0.0, f64::max),
                coefficients,
                reconstruction,
                exact: white,
                model: model_xyz,
            }
        }

        /// Every order of the curve, each from the start.
        pub(crate) fn curve(&self, start: &Start) -> Vec<Point> {
            (0..=CURVE_ORDER)
                .map(|order| {
                    let moved = self.slider_move(start, order);
                    let mut model = moved.reconstruction.clone();
                    add_lines(&start.spikes, &mut model);
                    let share = |d: &[f64], m: &[f64]| {
                        (integral(|i| d[i] * d[i]) / integral(|i| m[i] * m[i])).sqrt()
                    };
                    let minus = |a: &[f64]| -> Vec<f64> {
                        a.iter().zip(&start.measured).map(|(a, m)| a - m).collect()
                    };
                    let mut blurred = blur(&minus(&moved.reconstruction));
                    for (i, b) in blurred.iter_mut().enumerate() {
                        for spike in &start.spikes {
                            *b += spike.weight * density(BAND.nm(i) - spike.at_nm);
                        }
                    }
                    Point {
                        own: moved.own,
                        mean: moved.mean,
                        relative_rms: share(&minus(&model), &start.measured),
                        relative_rms_10nm: share(&blurred, &blur(&start.measured)),
                    }
                })
                .collect()
        }

        fn xyz(&self, value: impl Fn(usize) -> f64) -> Xyz {
            Xyz::from_array(std::array::from_fn(|k| {
                integral(|i| value(i) * self.cmf[k][i])
            }))
        }

        /// XYZ of values on the grid and of spikes seen through a factor.
        fn line_xyz(&self, values: &[f64], spikes: &[Line], factor: impl Fn(f64) -> f64) -> Xyz {
            spikes.iter().fold(self.xyz(|i| values[i]), |sum, spike| {
                let seen = Observer::CIE_1931.table().at(spike.at_nm);
                sum + Xyz::from_array(seen) * (spike.weight * factor(spike.at_nm))
            })
        }
    }

    fn integral(value: impl Fn(usize) -> f64) -> f64 {
        (0..BAND.points()).map(|i| BAND.weight(i) * value(i)).sum()
    }

    fn add_lines(spikes: &[Line], values: &mut [f64]) {
        for spike in spikes {
            let x = spike.at_nm - BAND.min_nm();
            let (i, t) = (x as usize, x.fract());
            values[i] += spike.weight * (1.0 - t) / BAND.weight(i);
            values[i + 1] += spike.weight * t / BAND.weight(i + 1);
        }
    }

    /// Reach of the 10 nm blur, nm: beyond it next to nothing is left.
    const REACH: usize = 26;

    fn density(distance_nm: f64) -> f64 {
        let sigma = 10.0 / (8.0 * std::f64::consts::LN_2).sqrt();
        let t = distance_nm / sigma;
        (-0.5 * t * t).exp() / (sigma * (2.0 * std::f64::consts::PI).sqrt())
    }

    fn blur(values: &[f64]) -> Vec<f64> {
        let taps: Vec<f64> = (0..=REACH).map(|i| density(i as f64)).collect();
        (0..values.len())
            .map(|i| {
                let near = i.saturating_sub(REACH)..=(i + REACH).min(values.len() - 1);
                near.map(|j| BAND.weight(j) * values[j] * taps[i.abs_diff(j)])
                    .sum()
            })
            .collect()
    }

    fn lab(xyz: Xyz, white: Xyz) -> Lab {
        let f = |t: f64| {
            if t > 216.0 / 24389.0 {
                t.powf(1.0 / 3.0)
            } else {
                (24389.0 / 27.0 * t + 16.0) / 116.0
            }
        };
        let [x, y, z] = [xyz.x / white.x, xyz.y / white.y, xyz.z / white.z].map(f);
        Lab::new(116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z))
    }

    /// CIEDE2000 as it is printed, by angles in degrees.
    fn delta_e(first: Lab, second: Lab) -> f64 {
        let share = |c: f64| (c.powf(7.0) / (c.powf(7.0) + 25_f64.powf(7.0))).sqrt();
        let g = 0.5 * (1.0 - share(0.5 * (first.chroma() + second.chroma())));
        let prime = |lab: Lab| Lab::new(lab.l, lab.a * (1.0 + g), lab.b);
        let (p, q) = (prime(first), prime(second));
        let (c1, c2) = (p.chroma(), q.chroma());
        let hue = |lab: Lab| lab.hue_degrees().unwrap_or(0.0);
        let (h1, h2) = (hue(p), hue(q));
        let neutral = c1 * c2 == 0.0;
        let gap = h2 - h1;
        let dh = match () {
            () if neutral => 0.0,
            () if gap > 180.0 => gap - 360.0,
            () if gap < -180.0 => gap + 360.0,
            () => gap,
        };
        let mean = match () {
            () if neutral => h1 + h2,
            () if gap.abs() <= 180.0 => 0.5 * (h1 + h2),
            () if h1 + h2 < 360.0 => 0.5 * (h1 + h2 + 360.0),
            () => 0.5 * (h1 + h2 - 360.0),
        };
        let cos = |degrees: f64| degrees.to_radians().cos();
        let t =
            1.0 - 0.17 * cos(mean - 30.0) + 0.24 * cos(2.0 * mean) + 0.32 * cos(3.0 * mean + 6.0)
                - 0.20 * cos(4.0 * mean - 63.0);
        let (l, c) = (0.5 * (p.l + q.l), 0.5 * (c1 + c2));
        let s_l = 1.0 + 0.015 * (l - 50.0).powi(2) / (20.0 + (l - 50.0).powi(2)).sqrt();
        let turn = 30.0 * (-((mean - 275.0) / 25.0).powi(2)).exp();
        let rotation = -(2.0 * turn).to_radians().sin() * 2.0 * share(c);
        let dl = (q.l - p.l) / s_l;
        let dc = (c2 - c1) / (1.0 + 0.045 * c);
        let dh = 2.0 * (c1 * c2).sqrt() * (0.5 * dh).to_radians().sin() / (1.0 + 0.015 * c * t);
        (dl * dl + dc * dc + dh * dh + rotation * dc * dh)
            .max(0.0)
            .sqrt()
    }
}

criterion_group!(
    benches,
    a_slider_move,
    all_that_the_window_derives,
    spike_detection,
    a_product,
    a_frame
);
criterion_main!(benches);
