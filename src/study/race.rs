//! The race: the composite model against the other representations at an equal count of numbers.
//!
//! A spike costs two numbers, everything else one: `P = B + 2M`. Lights and reflectances are both
//! approximated, by the same representation with the same count; reflectances carry no spikes.
//! The `M <= (P - 3) / 2` heaviest lines are spikes that make the 10 nm-blurred error least. A
//! colour-exact reflectance has the exact X, Y, Z of the equal-energy light, since it is not
//! known under which light it will be seen.
//!
//! Beside the patches, a second set judges that took no part in any choice, and so do narrow
//! filters between those that choose.

use std::{hint::black_box, sync::Arc, time::Duration};

use web_time::Instant;

use super::{
    measure::Measure,
    parallel::{in_parallel, processors},
    progress::Progress,
    projected_spectrum::{FitBasis, ProjectedSpectrum},
    reference::{Measures, Reference, scaled_to_one},
    way::FitVariant,
};
use crate::{
    color::patches::PatchSet,
    rivals::{Bounds, Family, FitTables, Rival},
    spectrum::{
        Basis, Composite, Line, PerBasis, Series, detect_shapes,
        product::{chain, multiply},
    },
};

pub use super::{
    race_cells::Cell, race_cells::figures, race_result::Encoded, race_result::Race,
    race_result::RaceConfig, training::Lamp,
};
pub(crate) use super::{
    race_cells::Judged, race_result::Cost, race_result::Encode, race_result::Racer,
    race_result::Row, race_result::Run,
};

/// A light ready to race.
struct Entrant {
    reference: Reference,
    /// Reference for the measures that take no part in any choice.
    check: Reference,
    /// The light with 1 as its largest value.
    lamp: Lamp,
    projected: PerBasis<ProjectedSpectrum>,
}

/// State shared by all tasks.
struct RaceContext<'a> {
    course: &'a RaceConfig,
    bases: PerBasis<FitBasis>,
    fit_tables: FitTables,
    runners: Vec<Entrant>,
    names: Vec<String>,
}

/// A representation of a light: its smooth values on the grid, its spikes and its numbers.
struct Reconstruction {
    smooth: Vec<f64>,
    spikes: Vec<Line>,
    numbers: usize,
    /// Lines among the numbers, also those that stand in the values.
    lines: usize,
}

/// Fit of the reflectances that accompany lights of known lamps and wide lines.
const COLOUR_EXACT: FitVariant = FitVariant::new(Basis::Cosine, false, true);

/// Runs the race on all processors; `None` when it was cancelled or no light shines.
///
/// The time grows in proportion to the lights.
pub fn run(course: &RaceConfig, lamps: &[Lamp], progress: &Progress) -> Option<Race> {
    let races = |racer: &Racer| course.encoder.is_some() || !Racer::ENCODED.contains(racer);
    let racers: Vec<Racer> = Racer::all().filter(races).collect();
    let tasks: Vec<(usize, usize)> = (0..course.budgets.len())
        .flat_map(|budget| (0..racers.len()).map(move |racer| (budget, racer)))
        .collect();
    progress.expect(2 * tasks.len() + lamps.len());
    let (stable, shining) = RaceContext::new(course, lamps, progress)?;
    let by_task = in_parallel(&tasks, processors(), progress, |(budget, racer)| {
        stable.all_runs(racers[*racer], course.budgets[*budget], progress)
    })?;
    // By task, from each its lights; wanted by light, from each its tasks.
    let mut runs = Vec::with_capacity(shining.len() * tasks.len());
    for lamp in 0..shining.len() {
        for budget in 0..course.budgets.len() {
            let here = &by_task[budget * racers.len()..][..racers.len()];
            let of = |racer: usize| here[racer].get(lamp)?.as_ref();
            let choice = chosen(&racers, of);
            runs.extend((0..racers.len()).map(|racer| of(racer).or(choice).copied()));
        }
    }
    let mut costs = Vec::with_capacity(tasks.len());
    for (budget, racer) in &tasks {
        if progress.is_cancelled() {
            return None;
        }
        costs.push(stable.cost(racers[*racer], course.budgets[*budget]));
        progress.step();
    }
    Some(Race {
        lamps: shining,
        cost_of: stable.most_lines().lamp.name.clone(),
        budgets: course.budgets.clone(),
        racers,
        runs: runs.into_iter().collect::<Option<Vec<Run>>>()?,
        costs,
    })
}

/// The composite that is best on the patches.
fn chosen<'a>(racers: &[Racer], run: impl Fn(usize) -> Option<&'a Run>) -> Option<&'a Run> {
    let error = |run: &Run| run.verdict[Measure::Patches].unwrap_or(f64::INFINITY);
    (0..racers.len())
        .filter(|racer| matches!(racers[*racer], Racer::Composite(_)))
        .filter_map(run)
        .min_by(|a, b| error(a).total_cmp(&error(b)))
}

impl<'a> RaceContext<'a> {
    fn new(
        course: &'a RaceConfig,
        lamps: &[Lamp],
        progress: &Progress,
    ) -> Option<(Self, Vec<(String, String)>)> {
        let measures = &course.measures;
        let (band, observer) = (measures.band(), measures.patches.observer());
        let most = course.budgets.iter().copied().max()?.max(3);
        let bases = PerBasis::of(|basis| FitBasis::new(band, basis, most, &measures.seen));
        let names: Vec<String> = (0..course.check.len()).map(|i| i.to_string()).collect();
        let check = PatchSet::new(&course.check, names.clone(), band, observer);
        let check = Arc::new(Measures::judging(check));
        let mut runners: Vec<Entrant> = Vec::new();
        for lamp in lamps {
            if progress.is_cancelled() {
                return None;
            }
            progress.step();
            let Some(values) = scaled_to_one(&lamp.values).filter(|_| lamp.shines()) else {
                continue;
            };
            let reference = Reference::of_light(measures, &values);
            let lamp = Lamp {
                values,
                ..lamp.clone()
            };
            let values = &lamp.values;
            let (_, shapes) = detect_shapes(band, values, course.spikes);
            runners.push(Entrant {
                check: Reference::of_light(&check, values),
                projected: PerBasis::of(|basis| {
                    ProjectedSpectrum::new(&bases[basis], values, &shapes, &measures.seen)
                }),
                reference,
                lamp,
            });
        }
        if runners.is_empty() {
            return None;
        }
        let named = |runner: &Entrant| (runner.lamp.name.clone(), runner.lamp.class.clone());
        let shining = runners.iter().map(named).collect();
        let stable = Self {
            fit_tables: FitTables::new(band, most),
            course,
            bases,
            runners,
            names,
        };
        Some((stable, shining))
    }

    /// Every light's run, in their order. None for [`Racer::Chosen`] and where an encoder has
    /// nothing: what is left there is the choice among the composites, read off later.
    fn all_runs(&self, racer: Racer, numbers: usize, progress: &Progress) -> Vec<Option<Run>> {
        if racer == Racer::Chosen {
            return Vec::new();
        }
        let measures = &self.course.measures;
        let (band, observer) = (measures.band(), measures.patches.observer());
        let set = |reflectances: &[Vec<f64>], names: &[String]| {
            let likenesses: Vec<Vec<f64>> = reflectances
                .iter()
                .map(|r| self.reflectance_values(racer, r, numbers))
                .collect();
            PatchSet::new(&likenesses, names.to_vec(), band, observer)
        };
        let patches = set(&self.course.patches, measures.patches.names());
        let check = set(&self.course.check, &self.names);
        let wanted = self.runners.iter().take_while(|_| !progress.is_cancelled());
        wanted
            .map(|runner| {
                let likeness = self.light(runner, racer, numbers)?;
                Some(self.judged(runner, &likeness, &patches, &check))
            })
            .collect()
    }

    fn judged(
        &self,
        runner: &Entrant,
        likeness: &Reconstruction,
        patches: &PatchSet,
        check: &PatchSet,
    ) -> Run {
        let Reconstruction {
            smooth,
            spikes,
            numbers,
            lines,
        } = likeness;
        let on_check = runner.check.patches(smooth, spikes, check);
        Run {
            numbers: *numbers,
            spikes: *lines,
            check: on_check.map(|found| found.mean),
            check_filters: runner.check.figure(Measure::Filters, smooth, spikes),
            verdict: runner.reference.verdict_through(smooth, spikes, patches),
        }
    }

    /// The representation of a light; nothing for [`Racer::Chosen`] and where an encoder has none.
    fn light(&self, runner: &Entrant, racer: Racer, numbers: usize) -> Option<Reconstruction> {
        match racer {
            Racer::Composite(way) => {
                let projected = &runner.projected[way.basis];
                let model = composite(runner, way, numbers);
                Some(Reconstruction {
                    smooth: projected.smooth(&model),
                    numbers: model.numbers(),
                    lines: model.lines().len(),
                    spikes: model.into_parts().1,
                })
            }
            Racer::WideLines | Racer::KnownLamps => {
                let encoded = self.encoded(runner, racer, numbers)?;
                Some(Reconstruction {
                    smooth: encoded.on_band(),
                    spikes: Vec::new(),
                    numbers: encoded.numbers(),
                    lines: encoded.lines(),
                })
            }
            Racer::Rival(family) => {
                let rival = self.rival(family, runner, numbers);
                Some(Reconstruction {
                    smooth: rival.on_band(),
                    spikes: Vec::new(),
                    numbers: rival.numbers(),
                    lines: 0,
                })
            }
            Racer::Chosen => None,
        }
    }

    fn encoded(&self, runner: &Entrant, racer: Racer, numbers: usize) -> Option<Box<dyn Encoded>> {
        let encoder = self.course.encoder.as_ref()?;
        encoder.encoded(&runner.lamp, numbers, racer == Racer::KnownLamps)
    }

    fn rival(&self, family: Family, runner: &Entrant, numbers: usize) -> Rival {
        let values = runner.reference.measured();
        let lights = &self.course.lights;
        let basis = match family {
            Family::Principal => lights.basis_for(&runner.lamp.name, values, numbers),
            _ => &self.course.reflectances,
        };
        self.fit_tables
            .fit(family, values, numbers, Bounds::Light, basis)
    }

    fn rival_reflectance(&self, family: Family, values: &[f64], numbers: usize) -> Rival {
        let bounds = Bounds::Reflectance;
        self.fit_tables
            .fit(family, values, numbers, bounds, &self.course.reflectances)
    }

    /// A reflectance as a series; colour-exact under the equal-energy light.
    fn reflectance_series(&self, way: FitVariant, values: &[f64], numbers: usize) -> Series {
        let fit_basis = &self.bases[way.basis];
        let projected = ProjectedSpectrum::new(fit_basis, values, &[], &self.course.measures.seen);
        projected
            .model(numbers, &[], way.colour_exact)
            .0
            .into_parts()
            .0
    }

    fn reflectance_values(&self, racer: Racer, values: &[f64], numbers: usize) -> Vec<f64> {
        match racer {
            Racer::Composite(way) => {
                let series = self.reflectance_series(way, values, numbers);
                let table = &self.bases[way.basis].table;
                table.evaluate(&series.coefficients)
            }
            // The light's lines and lamps are no help with a reflectance.
            Racer::WideLines | Racer::KnownLamps => {
                self.reflectance_values(Racer::Composite(COLOUR_EXACT), values, numbers)
            }
            Racer::Rival(family) => self.rival_reflectance(family, values, numbers).on_band(),
            Racer::Chosen => values.to_vec(),
        }
    }

    /// The light with most lines.
    fn most_lines(&self) -> &Entrant {
        let lines = |runner: &&Entrant| runner.projected[COLOUR_EXACT.basis].lines();
        // The first of equals.
        self.runners
            .iter()
            .rev()
            .max_by_key(lines)
            .unwrap_or(&self.runners[0])
    }

    /// Times one product and one evaluation of that light and the first patch.
    fn cost(&self, racer: Racer, numbers: usize) -> Option<Cost> {
        let runner = self.most_lines();
        let flat = vec![0.5; runner.reference.measured().len()];
        let reflectance = self.course.patches.first().unwrap_or(&flat);
        match racer {
            Racer::Chosen => None,
            Racer::Composite(way) => {
                let model = composite(runner, way, numbers);
                let factor = [self.reflectance_series(way, reflectance, numbers)];
                let points = 2 * numbers;
                let product = || chain(black_box(&model), black_box(&factor), points);
                let value = || model.smooth().at(black_box(546.1));
                let sizes = [
                    model.numbers() * size_of::<f64>(),
                    points + model.lines().len(),
                ];
                Some(cost_of(sizes, product, value))
            }
            Racer::WideLines | Racer::KnownLamps => {
                let light = self.encoded(runner, racer, numbers)?;
                let factor = self.reflectance_series(COLOUR_EXACT, reflectance, numbers);
                let table = &self.bases[COLOUR_EXACT.basis].table;
                let product = || {
                    let (a, b) = (black_box(&light).on_band(), black_box(&factor));
                    multiply(&a, &table.evaluate(&b.coefficients))
                };
                let value = || light.at(black_box(546.1));
                Some(cost_of([light.bytes(), flat.len()], product, value))
            }
            Racer::Rival(family) => {
                let light = self.rival(family, runner, numbers);
                let factor = self.rival_reflectance(family, reflectance, numbers);
                let product = || {
                    let (a, b) = (black_box(&light).points(), black_box(&factor).points());
                    multiply(&a, &b)
                };
                let value = || light.at(black_box(546.1));
                let sizes = [light.bytes(), light.points().len()];
                Some(cost_of(sizes, product, value))
            }
        }
    }
}

/// The cost of so many bytes and points, timed.
fn cost_of<T>(
    [bytes, points]: [usize; 2],
    product: impl Fn() -> T,
    value: impl Fn() -> f64,
) -> Cost {
    Cost {
        bytes,
        points,
        ns_per_product: nanoseconds(product),
        ns_per_evaluation: nanoseconds(value),
    }
}

/// A light's composite of so many numbers.
fn composite(runner: &Entrant, way: FitVariant, numbers: usize) -> Composite {
    let projected = &runner.projected[way.basis];
    runner.reference.with_best_lines(projected, way, numbers)
}

/// Shortest of a few batches, ns a call: what disturbs a measurement only ever makes it longer.
fn nanoseconds<T>(call: impl Fn() -> T) -> f64 {
    const BATCHES: usize = 5;
    const BATCH: Duration = Duration::from_micros(30);
    let mut best = f64::INFINITY;
    for _ in 0..BATCHES {
        let (start, mut calls) = (Instant::now(), 0_u32);
        while start.elapsed() < BATCH {
            (0..8).for_each(|_| drop(black_box(call())));
            calls += 8;
        }
        best = best.min(start.elapsed().as_nanos() as f64 / f64::from(calls));
    }
    best
}
