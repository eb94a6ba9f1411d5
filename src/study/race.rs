//! The race: the composite model against the other representations at an equal count of numbers.
//!
//! A spike costs two numbers, everything else one: `P = B + 2M`. Lights and reflectances are both
//! approximated, by the same representation with the same count; reflectances carry no spikes.
//! The `M <= (P - 3) / 2` heaviest lines are spikes that make the 10 nm-blurred error least. A
//! colour-exact reflectance has the exact X, Y, Z of the equal-energy light, since it is not
//! known under which light it will be seen.
//!
//! Beside the patches, a second set judges that took no part in any choice.

use std::{
    hint::black_box,
    sync::{
        Arc, Mutex,
        atomic::{AtomicUsize, Ordering},
    },
    time::{Duration, Instant},
};

use super::{
    error::Spread,
    measure::{ByMeasure, Measure, Verdict},
    progress::Progress,
    projected_spectrum::{FitBasis, ProjectedSpectrum},
    reference::{Measures, Reference, scaled_to_one},
    training::Training,
    way::Way,
};
use crate::{
    color::{
        Lab,
        patches::{PatchSet, difference},
    },
    rivals::{Bounds, Family, FitTables, PrincipalBasis, Rival},
    spectrum::{Basis, Series, Spike, SpikeSettings, product::chain, spikes::detect_shapes},
};

/// Who races.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Racer {
    /// A composite, or its smooth part alone.
    Composite(Way),
    /// Another representation.
    Rival(Family),
    /// For each light the composite that is best on the patches: what the program would choose.
    Chosen,
}

impl Racer {
    /// Everybody, composites first.
    pub fn all() -> impl Iterator<Item = Self> + Clone {
        Way::ALL
            .into_iter()
            .map(Self::Composite)
            .chain(Family::ALL.into_iter().map(Self::Rival))
            .chain([Self::Chosen])
    }

    /// The word used in files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Composite(way) => way.word(),
            Self::Rival(family) => family.about().word,
            Self::Chosen => "chosen",
        }
    }

    /// In words for people.
    pub fn title(self) -> &'static str {
        match self {
            Self::Composite(way) => way.title(),
            Self::Rival(family) => family.about().title,
            Self::Chosen => "Best composite, chosen per light",
        }
    }

    /// Whether fewer numbers are a prefix of more: one fit, truncated at will. With spikes the
    /// smooth part's numbers depend on which lines were taken out.
    pub fn is_prefix(self) -> bool {
        match self {
            Self::Composite(way) => !way.spikes && !way.colour_exact,
            // Another count may be fitted with the table of another class.
            Self::Rival(Family::Principal) | Self::Chosen => false,
            Self::Rival(family) => family.is_prefix(),
        }
    }

    /// Whether its numbers mean nothing without a table that is not counted among them.
    pub fn needs_table(self) -> bool {
        matches!(self, Self::Rival(family) if family.needs_table())
    }
}

/// A light in the race.
#[derive(Clone, Debug, PartialEq)]
pub struct Lamp {
    /// Its name.
    pub name: String,
    /// The class it is counted in.
    pub class: String,
    /// Its values on the band's grid.
    pub values: Vec<f64>,
}

/// Everything that a race is run on, all on one band.
#[derive(Clone, Debug)]
pub struct Course {
    /// Measures with the patches that choose.
    pub measures: Arc<Measures>,
    /// The patches' reflectances.
    pub patches: Vec<Vec<f64>>,
    /// Reflectances that judge without having taken part in a choice.
    pub check: Vec<Vec<f64>>,
    /// Components for lights.
    pub lights: Arc<Training>,
    /// Components for reflectances, trained without patches and check.
    pub reflectances: Arc<PrincipalBasis>,
    /// How lines are looked for.
    pub spikes: SpikeSettings,
    /// Counts of numbers, rising.
    pub budgets: Vec<usize>,
}

/// How one racer did on one light at one count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Run {
    /// Numbers it took, at most the budget.
    pub numbers: usize,
    /// Spikes among them (two numbers each).
    pub spikes: usize,
    /// Its errors.
    pub verdict: Verdict,
    /// Mean CIEDE2000 of the check reflectances.
    pub check: Option<f64>,
}

/// What a racer costs at one count, measured in this run on [`Race::cost_of`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cost {
    /// Bytes of the stored numbers of one spectrum.
    pub bytes: usize,
    /// Values that a product multiplies.
    pub points: usize,
    /// From the stored numbers of a light and a reflectance to their product's values, ns.
    pub ns_per_product: f64,
    /// One value at one wavelength, ns.
    pub ns_per_evaluation: f64,
}

/// A whole race.
#[derive(Clone, Debug, PartialEq)]
pub struct Race {
    /// Names and classes of the lights that shine.
    pub lamps: Vec<(String, String)>,
    /// Counts of numbers, rising.
    pub budgets: Vec<usize>,
    /// Everybody who ran.
    pub racers: Vec<Racer>,
    /// The light that costs were measured on: that with most lines, so that spikes cost.
    pub cost_of: String,
    /// By light, then count, then racer.
    runs: Vec<Run>,
    /// By count, then racer.
    costs: Vec<Option<Cost>>,
}

/// One line of the result.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Who.
    pub racer: Racer,
    /// The budget.
    pub numbers: usize,
    /// Lights counted.
    pub lamps: usize,
    /// Every figure over the lights.
    pub spreads: ByMeasure<Option<Spread>>,
    /// Mean of the check reflectances.
    pub check: Option<Spread>,
    /// Share of the lights that dip below -0.1 % of their peak.
    pub negative_lobes: f64,
    /// What it costs; nothing of its own for [`Racer::Chosen`].
    pub cost: Option<Cost>,
}

/// A dip below zero that counts, as a share of the peak.
const A_LOBE: f64 = 1e-3;

impl Race {
    /// How a racer did on a light at a count, by their places.
    pub fn run(&self, lamp: usize, budget: usize, racer: usize) -> &Run {
        &self.runs[(lamp * self.budgets.len() + budget) * self.racers.len() + racer]
    }

    /// What a racer costs at a count, by their places.
    pub fn cost(&self, budget: usize, racer: usize) -> Option<Cost> {
        self.costs[budget * self.racers.len() + racer]
    }

    /// The classes in the order of their first light.
    pub fn classes(&self) -> Vec<&str> {
        let mut classes: Vec<&str> = Vec::new();
        for (_, class) in &self.lamps {
            if !classes.contains(&class.as_str()) {
                classes.push(class);
            }
        }
        classes
    }

    /// The lights of a class, by place; of all classes without one.
    pub fn of_class<'a>(&'a self, class: Option<&'a str>) -> impl Iterator<Item = usize> + 'a {
        let wanted = move |own: &str| class.is_none_or(|class| class == own);
        (0..self.lamps.len()).filter(move |i| wanted(&self.lamps[*i].1))
    }

    /// A figure over a class (or all) at a count; `None` where no light has it.
    pub fn spread(
        &self,
        class: Option<&str>,
        budget: usize,
        racer: usize,
        measure: Measure,
    ) -> Option<Spread> {
        let error = |lamp: usize| self.run(lamp, budget, racer).verdict[measure];
        Spread::of(&self.of_class(class).filter_map(error).collect::<Vec<_>>())
    }

    /// A racer's line over a class (or all) at a count.
    pub fn row(&self, class: Option<&str>, budget: usize, racer: usize) -> Row {
        let run = |lamp: usize| self.run(lamp, budget, racer);
        let runs: Vec<&Run> = self.of_class(class).map(run).collect();
        let checks: Vec<f64> = runs.iter().filter_map(|run| run.check).collect();
        let dips = |run: &&&Run| run.verdict[Measure::Lowest].is_some_and(|low| low < -A_LOBE);
        Row {
            racer: self.racers[racer],
            numbers: self.budgets[budget],
            lamps: runs.len(),
            spreads: ByMeasure::from_fn(|measure| self.spread(class, budget, racer, measure)),
            check: Spread::of(&checks),
            negative_lobes: runs.iter().filter(dips).count() as f64 / runs.len().max(1) as f64,
            cost: self.cost(budget, racer),
        }
    }

    /// The racer with the least error on one light; [`Racer::Chosen`] is one of the others again
    /// and does not count.
    pub fn winner_on(&self, lamp: usize, budget: usize, measure: Measure) -> Option<Racer> {
        self.best(|racer| self.run(lamp, budget, racer).verdict[measure])
    }

    /// The racer with the least median over a class (or all).
    pub fn winner_of(&self, class: Option<&str>, budget: usize, measure: Measure) -> Option<Racer> {
        self.best(|racer| {
            let spread = self.spread(class, budget, racer, measure);
            spread.map(|spread| spread.median)
        })
    }

    fn best(&self, error: impl Fn(usize) -> Option<f64>) -> Option<Racer> {
        (0..self.racers.len())
            .filter(|racer| self.racers[*racer] != Racer::Chosen)
            .filter_map(|racer| Some((racer, error(racer)?)))
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .map(|(racer, _)| self.racers[racer])
    }
}

/// A light ready to race.
struct Runner {
    reference: Reference,
    check: Vec<Lab>,
    name: String,
    /// In the order of [`Basis::ALL`].
    projected: [ProjectedSpectrum; 2],
}

/// What all tasks share.
struct Stable<'a> {
    course: &'a Course,
    bases: [FitBasis; 2],
    fit_tables: FitTables,
    check: PatchSet,
    runners: Vec<Runner>,
    names: Vec<String>,
}

/// A representation of a light: its smooth values on the grid, its spikes and its numbers.
struct Likeness {
    smooth: Vec<f64>,
    spikes: Vec<Spike>,
    numbers: usize,
}

/// Runs the race on both processors; `None` when it was cancelled or no light shines.
///
/// The time grows in proportion to the lights.
pub fn run(course: &Course, lamps: &[Lamp], progress: &Progress) -> Option<Race> {
    let racers: Vec<Racer> = Racer::all().collect();
    let tasks: Vec<(usize, usize)> = (0..course.budgets.len())
        .flat_map(|budget| (0..racers.len()).map(move |racer| (budget, racer)))
        .collect();
    progress.expect(2 * tasks.len() + lamps.len());
    let (stable, shining) = Stable::new(course, lamps, progress)?;
    let next = AtomicUsize::new(0);
    let found: Mutex<Vec<(usize, Vec<Run>)>> = Mutex::new(Vec::new());
    let work = || {
        while let Some((budget, racer)) = tasks.get(next.fetch_add(1, Ordering::Relaxed)) {
            if progress.is_cancelled() {
                return;
            }
            let runs = stable.all_runs(racers[*racer], course.budgets[*budget]);
            let place = budget * racers.len() + racer;
            // A thread that panicked holds no half-written result: each push is whole.
            let mut found = found.lock().unwrap_or_else(|e| e.into_inner());
            found.push((place, runs));
            drop(found);
            progress.step();
        }
    };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 1..threads {
            scope.spawn(work);
        }
        work();
    });
    let found = found.into_inner().unwrap_or_else(|e| e.into_inner());
    if progress.is_cancelled() || found.len() < tasks.len() {
        return None;
    }
    // By task, from each its lights; wanted by light, from each its tasks.
    let mut by_task: Vec<Vec<Run>> = vec![Vec::new(); tasks.len()];
    for (place, runs) in found {
        by_task[place] = runs;
    }
    let mut runs = Vec::with_capacity(shining.len() * tasks.len());
    for lamp in 0..shining.len() {
        for budget in 0..course.budgets.len() {
            let here = &by_task[budget * racers.len()..][..racers.len()];
            let choice = chosen(&racers, |racer| here[racer].get(lamp));
            runs.extend(here.iter().map(|runs| runs.get(lamp).or(choice).copied()));
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
        cost_of: stable.most_lines().name.clone(),
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

impl<'a> Stable<'a> {
    fn new(
        course: &'a Course,
        lamps: &[Lamp],
        progress: &Progress,
    ) -> Option<(Self, Vec<(String, String)>)> {
        let measures = &course.measures;
        let (band, observer) = (measures.band(), measures.patches.observer());
        let most = course.budgets.iter().copied().max()?.max(3);
        let bases = Basis::ALL.map(|basis| FitBasis::new(band, basis, most, &measures.seen));
        let names: Vec<String> = (0..course.check.len()).map(|i| i.to_string()).collect();
        let check = PatchSet::new(&course.check, names.clone(), band, observer);
        let (mut runners, mut shining) = (Vec::new(), Vec::new());
        for lamp in lamps {
            if progress.is_cancelled() {
                return None;
            }
            progress.step();
            let Some(values) = scaled_to_one(&lamp.values) else {
                continue;
            };
            let reference = Reference::of_light(measures, &values);
            let (_, shapes) = detect_shapes(band, &values, course.spikes);
            runners.push(Runner {
                check: reference.labs_of(&check, &values, &[]),
                name: lamp.name.clone(),
                projected: std::array::from_fn(|i| {
                    ProjectedSpectrum::new(&bases[i], &values, &shapes, &measures.seen)
                }),
                reference,
            });
            shining.push((lamp.name.clone(), lamp.class.clone()));
        }
        if runners.is_empty() {
            return None;
        }
        let stable = Self {
            fit_tables: FitTables::new(band, most),
            course,
            bases,
            check,
            runners,
            names,
        };
        Some((stable, shining))
    }

    /// Every light's run, in their order; none for [`Racer::Chosen`], which is read off later.
    fn all_runs(&self, racer: Racer, numbers: usize) -> Vec<Run> {
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
        self.runners
            .iter()
            .map(|runner| {
                let Likeness {
                    smooth,
                    spikes,
                    numbers,
                } = self.light(runner, racer, numbers);
                let labs = runner.reference.labs_of(&check, &smooth, &spikes);
                let verdict = runner.reference.verdict_through(&smooth, &spikes, &patches);
                Run {
                    numbers,
                    spikes: spikes.len(),
                    check: verdict[Measure::Own]
                        .filter(|_| !self.check.is_empty())
                        .map(|_| difference(&runner.check, &labs).mean),
                    verdict,
                }
            })
            .collect()
    }

    fn light(&self, runner: &Runner, racer: Racer, numbers: usize) -> Likeness {
        match racer {
            Racer::Composite(way) => {
                let projected = &runner.projected[place(way.basis)];
                let lines = if way.spikes {
                    best_count(runner, projected, numbers, way.colour_exact)
                } else {
                    0
                };
                let lines: Vec<usize> = (0..lines).collect();
                let smooth_numbers = numbers - 2 * lines.len();
                let (model, _) = projected.model(smooth_numbers, &lines, way.colour_exact);
                Likeness {
                    smooth: projected.smooth(&model),
                    numbers: model.numbers(),
                    spikes: model.spikes,
                }
            }
            Racer::Rival(family) => {
                let rival = self.rival(family, runner, numbers);
                Likeness {
                    smooth: rival.on_band(),
                    spikes: Vec::new(),
                    numbers: rival.numbers(),
                }
            }
            Racer::Chosen => Likeness {
                smooth: runner.reference.measured().to_vec(),
                spikes: Vec::new(),
                numbers: 0,
            },
        }
    }

    fn rival(&self, family: Family, runner: &Runner, numbers: usize) -> Rival {
        let values = runner.reference.measured();
        let lights = &self.course.lights;
        let basis = match family {
            Family::Principal => lights.basis_for(&runner.name, values, numbers),
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
    fn reflectance_series(&self, way: Way, values: &[f64], numbers: usize) -> Series {
        let fit_basis = &self.bases[place(way.basis)];
        let projected = ProjectedSpectrum::new(fit_basis, values, &[], &self.course.measures.seen);
        projected.model(numbers, &[], way.colour_exact).0.smooth
    }

    fn reflectance_values(&self, racer: Racer, values: &[f64], numbers: usize) -> Vec<f64> {
        match racer {
            Racer::Composite(way) => {
                let series = self.reflectance_series(way, values, numbers);
                let table = &self.bases[place(way.basis)].table;
                table.evaluate(&series.coefficients)
            }
            Racer::Rival(family) => self.rival_reflectance(family, values, numbers).on_band(),
            Racer::Chosen => values.to_vec(),
        }
    }

    /// The light with most lines.
    fn most_lines(&self) -> &Runner {
        let lines = |runner: &&Runner| runner.projected[0].lines();
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
                let projected = &runner.projected[place(way.basis)];
                let lines: Vec<usize> = if way.spikes {
                    (0..best_count(runner, projected, numbers, way.colour_exact)).collect()
                } else {
                    Vec::new()
                };
                let smooth_numbers = numbers - 2 * lines.len();
                let (model, _) = projected.model(smooth_numbers, &lines, way.colour_exact);
                let factor = [self.reflectance_series(way, reflectance, numbers)];
                let points = 2 * numbers;
                let product = || {
                    black_box(chain(black_box(&model), black_box(&factor), points));
                };
                Some(Cost {
                    bytes: model.numbers() * size_of::<f64>(),
                    points: points + model.spikes.len(),
                    ns_per_product: nanoseconds(product),
                    ns_per_evaluation: nanoseconds(|| {
                        black_box(model.smooth.at(black_box(546.1)));
                    }),
                })
            }
            Racer::Rival(family) => {
                let light = self.rival(family, runner, numbers);
                let factor = self.rival_reflectance(family, reflectance, numbers);
                let product = || {
                    let (a, b) = (black_box(&light).points(), black_box(&factor).points());
                    let both: Vec<f64> = a.iter().zip(&b).map(|(a, b)| a * b).collect();
                    black_box(both);
                };
                Some(Cost {
                    bytes: light.bytes(),
                    points: light.points().len(),
                    ns_per_product: nanoseconds(product),
                    ns_per_evaluation: nanoseconds(|| {
                        black_box(light.at(black_box(546.1)));
                    }),
                })
            }
        }
    }
}

fn place(basis: Basis) -> usize {
    Basis::ALL.iter().position(|b| *b == basis).unwrap_or(0)
}

/// How many of the heaviest lines are spikes: the count with the least 10 nm-blurred error.
fn best_count(
    runner: &Runner,
    projected: &ProjectedSpectrum,
    numbers: usize,
    colour_exact: bool,
) -> usize {
    let most = projected.lines().min(numbers.saturating_sub(3) / 2);
    let error = |count: usize| {
        let lines: Vec<usize> = (0..count).collect();
        let (model, _) = projected.model(numbers - 2 * count, &lines, colour_exact);
        let smooth = projected.smooth(&model);
        let error = runner
            .reference
            .figure(Measure::RmsBlurred, &smooth, &model.spikes);
        error.unwrap_or(f64::INFINITY)
    };
    (0..=most)
        .map(|count| (count, error(count)))
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map_or(0, |(count, _)| count)
}

/// Shortest of a few batches, ns a call: what disturbs a measurement only ever makes it longer.
fn nanoseconds(call: impl Fn()) -> f64 {
    const BATCHES: usize = 5;
    const BATCH: Duration = Duration::from_micros(30);
    let mut best = f64::INFINITY;
    for _ in 0..BATCHES {
        let (start, mut calls) = (Instant::now(), 0_u32);
        while start.elapsed() < BATCH {
            (0..8).for_each(|_| call());
            calls += 8;
        }
        best = best.min(start.elapsed().as_nanos() as f64 / f64::from(calls));
    }
    best
}
