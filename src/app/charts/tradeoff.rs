//! Error against numbers as charts: all ways, their Pareto front, and what the threshold
//! changes.

mod words;

use super::spectrum::{by_program, source_of};
use crate::{
    app::{
        App, Command, Settings,
        chart::{Chart, Dash, Ink, Scale, Series, Shape, stroke},
        pages::WaysShown,
        settings::Detector,
        studies::{About, SweepAsk},
        ticks::short,
    },
    io::many::numbers,
    languages::said,
    spectrum::{Basis, SpikeEdits},
    study::{
        Examined, FitVariant, Measure, Reference, Sweep, SweepPoint, Verdict,
        error::{height, spikes_times, times},
        filter_centres,
    },
};

pub use words::{limits, needs};

/// Every error that models are compared by, in two lines for hover.
pub fn all_figures(verdict: &Verdict) -> String {
    let line = |of_colour: bool| -> String {
        let wanted = Measure::in_files().filter(|measure| measure.is_colour() == of_colour);
        let told = wanted.map(|measure| {
            let figure = measure.figure();
            format!("{} {}", figure.title(), figure.brief(verdict[measure]))
        });
        told.collect::<Vec<_>>().join(", ")
    };
    format!("ΔE₀₀: {}\n{}", line(true), line(false))
}

/// Why a figure does not exist for the document's subject; `None` when it does.
pub fn lack(app: &App, measure: Measure) -> Option<&'static str> {
    let (document, derived) = (app.document(), app.derived());
    let is_light = document.is_about_light();
    if !derived.has_errors() {
        return Some(derived.why_no_errors());
    }
    if !measure.is_colour() {
        return None;
    }
    if derived.colour.delta_e_2000.is_none() {
        return Some(said!(
            "There is no visible light in this range, so there is no colour."
        ));
    }
    match measure {
        Measure::Patches | Measure::PatchesWorst if !is_light => Some(said!(
            "A reflectance lights no surfaces: choose the light as the model's subject."
        )),
        Measure::Filters if !is_light => Some(said!(
            "Narrow filters are put before a light: choose the light as the model's subject."
        )),
        Measure::Patches | Measure::PatchesWorst
            if derived.patches.as_ref().is_none_or(|p| p.items.is_empty()) =>
        {
            Some(said!("There are no surfaces to see."))
        }
        Measure::Filters if !filter_centres().any(|nm| derived.band.contains(nm)) => Some(said!(
            "No filter's centre (420 to 670 nm) lies in this range."
        )),
        _ => None,
    }
}

/// The chosen figure where it exists, else the first that does.
pub fn measure_within(app: &App, chosen: Measure) -> Measure {
    std::iter::once(chosen)
        .chain(Measure::COMPARED)
        .find(|measure| lack(app, *measure).is_none())
        .unwrap_or(chosen)
}

/// The reference of a study's subject; `None` for an all-zero one.
pub fn reference(about: &About) -> Option<Reference> {
    Examined::of(&about.subject(), 1).map(|examined| examined.reference)
}

/// Every figure of the document's present model, hand edits and all.
pub fn verdict_now(app: &App, reference: &Reference) -> Option<Verdict> {
    let derived = app.derived();
    let unit = height(&derived.measured)?;
    // A range that was just changed has another grid than the reference.
    (reference.measured().len() == derived.smooth.len()).then(|| {
        reference.verdict(
            &times(&derived.outline(), unit),
            &spikes_times(&derived.ideal_spikes(), unit),
        )
    })
}

/// Where a study's numbers come from.
pub fn origin(about: &About) -> Vec<String> {
    let spectrum = &about.subject.0.spectrum;
    let mut notes = source_of(spectrum);
    notes.push(by_program(&tr!(
        "{from}-{to} nm, {observer}, surfaces {set}.",
        from = short(about.band.min_nm()),
        to = short(about.band.max_nm()),
        observer = about.observer.title(),
        set = about.patches.set
    )));
    notes
}

impl WaysShown {
    /// Whether the lines of a way are drawn.
    pub fn shows(&self, way: FitVariant) -> bool {
        let basis = self.bases[way.basis];
        let spikes = if way.spikes {
            self.with_spikes
        } else {
            self.without_spikes
        };
        let fit = if way.colour_exact {
            self.colour_exact
        } else {
            self.plain
        };
        basis && spikes && fit
    }
}

/// A way in few letters, for legends and tables.
pub fn way_name(way: FitVariant) -> String {
    let name = match (way.basis, way.colour_exact, way.spikes) {
        (Basis::Fourier, false, false) => said!("Fourier"),
        (Basis::Fourier, false, true) => said!("Fourier + lines"),
        (Basis::Fourier, true, false) => said!("Fourier, exact"),
        (Basis::Fourier, true, true) => said!("Fourier, exact + lines"),
        (Basis::Cosine, false, false) => said!("Cosine"),
        (Basis::Cosine, false, true) => said!("Cosine + lines"),
        (Basis::Cosine, true, false) => said!("Cosine, exact"),
        (Basis::Cosine, true, true) => said!("Cosine, exact + lines"),
    };
    name.to_owned()
}

/// Colours and points of each basis, in the order of [`Basis::ALL`]: plain and colour-exact.
const MARKS: [[(Ink, Shape); 2]; Basis::ALL.len()] = [
    [(Ink::Smooth, Shape::Dot), (Ink::Residual, Shape::Square)],
    [
        (Ink::Spikes, Shape::Triangle),
        (Ink::Product, Shape::Diamond),
    ],
];

/// Colour of a basis.
pub(super) fn ink(basis: Basis) -> Ink {
    MARKS[basis as usize][0].0
}

/// Colour and point of a way: hue and form tell basis and fit, the dash tells spikes.
pub fn looks(way: FitVariant) -> (Ink, Shape, Dash) {
    let (ink, shape) = MARKS[way.basis as usize][usize::from(way.colour_exact)];
    let dash = if way.spikes {
        Dash::Solid
    } else {
        Dash::Dashed
    };
    (ink, shape, dash)
}

/// The Pareto front of the ways shown, as indices of points.
pub fn front(sweep: &Sweep, measure: Measure, shown: &WaysShown) -> Vec<usize> {
    sweep.front(measure, |way| shown.shows(way))
}

/// Corners of a staircase: each height holds until the next point. Corner `i` belongs to point
/// `i / 2`.
pub fn stairs(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut corners = Vec::with_capacity(2 * points.len());
    for (i, point) in points.iter().enumerate() {
        corners.push(*point);
        if let Some(next) = points.get(i + 1) {
            corners.push([next[0], point[1]]);
        }
    }
    corners
}

/// Error against numbers with what a click needs to know.
#[derive(Clone, Debug)]
pub struct Tradeoff {
    /// The chart; its last series are the mark of the present model, when there is one.
    pub chart: Chart,
    /// The front's models by rising numbers, as indices of the sweep's points.
    pub front: Vec<usize>,
    /// For every series the indices of its points' models.
    models: Vec<Vec<usize>>,
}

impl Tradeoff {
    /// The chart of one figure: the lowest error of the ways shown, each of them a curve of its
    /// own; of all ways alone where none is.
    pub fn of(ask: &SweepAsk, sweep: &Sweep, measure: Measure, shown: Option<&WaysShown>) -> Self {
        let all = WaysShown::default();
        let front = front(sweep, measure, shown.unwrap_or(&all));
        let at = |index: &usize| place(&sweep.points[*index], measure);
        let (mut lines, mut marks) = (Vec::new(), Vec::new());
        // Where no line was found both kinds are the same models.
        let twice = |shown: &WaysShown, way: FitVariant| {
            way.spikes && sweep.spikes.is_empty() && shown.without_spikes
        };
        let is_drawn =
            |way: &FitVariant| shown.is_some_and(|shown| shown.shows(*way) && !twice(shown, *way));
        for way in FitVariant::ALL.into_iter().filter(is_drawn) {
            let (ink, shape, dash) = looks(way);
            let models: Vec<usize> = (0..sweep.points.len())
                .filter(|i| sweep.points[*i].way == way && at(i).is_some())
                .collect();
            let points: Vec<[f64; 2]> = models.iter().filter_map(at).collect();
            let notes = models.iter().map(|i| note(&sweep.points[*i])).collect();
            let line = stroke(way_name(way), ink, points.clone(), 1.3, dash);
            lines.push((line, models.clone()));
            let points = Series::points(way_name(way), ink, shape, points).sized(2.0);
            marks.push((points.with_notes(notes), models));
        }
        let (stairs, rings) = front_series(sweep, measure, &front);
        let corners = (0..stairs.marks.points().len())
            .map(|corner| front[corner / 2])
            .collect();
        let (series, models): (Vec<Series>, Vec<Vec<usize>>) = std::iter::once((stairs, corners))
            .chain(lines)
            .chain(marks)
            .chain([(rings, front.clone())])
            .unzip();
        let most = sweep.points.iter().map(|p| p.numbers).max().unwrap_or(1);
        let chart = Chart {
            title: tr!(
                "{subject}: {figure} against numbers",
                subject = ask.about.subject.0.name(),
                figure = measure.figure().title()
            ),
            x_label: said!("Numbers: 2N + 1 for N waves, two for each line").to_owned(),
            y_label: measure.figure().with_unit(),
            x_range: [1.0, (most as f64 * 1.05).max(2.0)],
            x_scale: Scale::Log10,
            y_scale: Scale::Log10,
            series,
            notes: origin(&ask.about),
            ..Chart::default()
        };
        Self {
            chart,
            front,
            models,
        }
    }

    /// The model at a point of a series.
    pub fn model(&self, series: usize, point: usize) -> Option<usize> {
        self.models.get(series)?.get(point).copied()
    }

    /// Marks the present model in place of the one that was marked.
    pub fn mark(&mut self, app: &App, verdict: Option<&Verdict>, measure: Measure) {
        self.chart.series.truncate(self.models.len());
        let Some((verdict, error)) = verdict.and_then(|v| Some((v, v[measure]?))) else {
            return;
        };
        let numbers = app.derived().numbers();
        let at = [numbers as f64, measure.figure().drawn(error)];
        let mark = mark_now(app, at, verdict);
        self.chart.series.push(mark);
    }
}

/// The mark of the present model, with its figures.
pub fn mark_now(app: &App, at: [f64; 2], verdict: &Verdict) -> Series {
    let note = format!("{}\n{}", words_now(app), all_figures(verdict));
    let ink = Ink::Overlay(1);
    let mark = Series::points(said!("the model now"), ink, Shape::Cross, vec![at]);
    mark.sized(8.0).with_notes(vec![note])
}

/// The present model in words: basis, fit, order, spikes, numbers.
pub fn words_now(app: &App) -> String {
    let (settings, derived) = (app.document().settings, app.derived());
    let spikes = derived.model.lines().len();
    let way = FitVariant::new(settings.basis, spikes > 0, settings.colour_exact);
    format!(
        "{}\n{}, {}: {}",
        said(way.title()),
        waves_words(derived.model.smooth().order()),
        spikes_words(spikes),
        numbers(derived.numbers())
    )
}

fn place(point: &SweepPoint, measure: Measure) -> Option<[f64; 2]> {
    let error = measure.figure().drawn(point.verdict[measure]?);
    Some([point.numbers as f64, error])
}

/// "1 wave", "4 waves".
pub fn waves_words(order: usize) -> String {
    tr!("{n} wave" | "{n} waves" % order)
}

/// "no lines", "1 line", "4 lines".
pub fn spikes_words(count: usize) -> String {
    match count {
        0 => said!("no lines").to_owned(),
        _ => tr!("{n} line" | "{n} lines" % count),
    }
}

fn note(point: &SweepPoint) -> String {
    tr!(
        "{waves}, {lines}: {numbers}\n{figures}\nClick to take this model.",
        waves = waves_words(point.order),
        lines = spikes_words(point.spikes),
        numbers = numbers(point.numbers),
        figures = all_figures(&point.verdict)
    )
}

/// The front: a bold staircase under everything, and rings over it.
fn front_series(sweep: &Sweep, measure: Measure, front: &[usize]) -> (Series, Series) {
    let name = said!("lowest error");
    let ink = Ink::Measured;
    let points: Vec<[f64; 2]> = front
        .iter()
        .filter_map(|i| place(&sweep.points[*i], measure))
        .collect();
    let notes = front.iter().map(|i| {
        let point = &sweep.points[*i];
        format!("{}\n{}", said(point.way.title()), note(point))
    });
    let rings = Series::points(name, ink, Shape::Ring, points.clone()).sized(4.0);
    (
        stroke(name, ink, stairs(&points), 3.4, Dash::Solid),
        rings.with_notes(notes.collect()),
    )
}

/// What a click on a point of the sweep asks for: that model, without hand edits.
pub fn take(settings: Settings, point: &SweepPoint) -> Command {
    let FitVariant {
        basis,
        spikes,
        colour_exact,
    } = point.way;
    Command::TakeModel {
        settings: Settings {
            basis,
            spikes,
            colour_exact,
            order: point.order,
            detector: Detector::Energy,
            wide_lines: false,
            ..settings
        },
        edits: SpikeEdits::default(),
    }
}
