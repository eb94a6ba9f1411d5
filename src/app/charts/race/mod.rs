//! The race as it is shown: error against numbers as a chart, the table of one count, and who
//! wins.

mod halves;
mod table;
mod ways;
mod winners;

pub use halves::{Half, halves};
pub use table::{RaceCell, RaceColumn, RaceTable, about, group, name};
pub use ways::{CELLS_AT, Ways, WaysRow};
pub use winners::{Lamp, Winners, Won};

use crate::{
    app::{
        chart::{Chart, Dash, Ink, Scale, Series, Shape, stroke},
        figures::SMALLEST,
        numbers,
        race_report::{field_words, race_notes, row_numbers, wins},
        studies::RaceAsk,
        ticks::short,
    },
    languages::{said, with_colon},
    spectrum::Basis,
    study::{Measure, Race, race::Racer},
};

/// A racer's name in a few letters: `ex` is colour-exact, `+l` with lines.
pub fn short_name(racer: Racer) -> String {
    let name = match racer {
        Racer::Composite(way) => {
            let part = |is_there, part| if is_there { part } else { "" };
            let exact = part(way.colour_exact, " ex");
            let basis = match way.basis {
                Basis::Fourier => said!("Fourier"),
                Basis::Cosine => said!("Cosine"),
            };
            return format!("{basis}{exact}{}", part(way.spikes, " +l"));
        }
        Racer::WideLines => said!("Wide lines"),
        Racer::KnownLamps => said!("Known lamps"),
        Racer::Rival(family) => said(family.about().short),
        Racer::Chosen => said!("Chosen"),
    };
    name.to_owned()
}

/// How a racer is drawn: a hue a family, dashes for spikes, forms for the rest.
pub fn looks(racer: Racer) -> (Ink, Dash, Shape) {
    match racer {
        Racer::Composite(way) => (
            super::tradeoff::ink(way.basis),
            if way.spikes {
                Dash::Dashed
            } else {
                Dash::Solid
            },
            match (way.colour_exact, way.spikes) {
                (false, false) => Shape::Dot,
                (false, true) => Shape::Ring,
                (true, false) => Shape::Square,
                (true, true) => Shape::Diamond,
            },
        ),
        Racer::WideLines => (Ink::Product, Dash::Solid, Shape::Ring),
        Racer::KnownLamps => (Ink::Product, Dash::Solid, Shape::Dot),
        Racer::Rival(family) => {
            let by_place = [
                (Ink::Overlay(2), Shape::Cross),
                (Ink::Overlay(2), Shape::Square),
                (Ink::Overlay(0), Shape::Triangle),
                (Ink::Residual, Shape::Diamond),
                (Ink::Product, Shape::Triangle),
                (Ink::Overlay(3), Shape::Ring),
            ];
            // A family beyond these has the marks of an earlier one and lines of its own.
            let (round, place) = (
                family as usize / by_place.len(),
                family as usize % by_place.len(),
            );
            let dash = [Dash::Dotted, Dash::Dashed][round.min(1)];
            let (ink, shape) = by_place[place];
            (ink, dash, shape)
        }
        Racer::Chosen => (Ink::Measured, Dash::Solid, Shape::Cross),
    }
}

/// Where a racer stands among all of them.
fn place(race: &Race, racer: Racer) -> Option<usize> {
    race.racers.iter().position(|r| *r == racer)
}

/// An error in few letters with its unit.
fn error_words(measure: Measure, error: Option<f64>) -> String {
    let unit = measure.figure().unit;
    error.map_or_else(
        || "–".to_owned(),
        |error| format!("{}{}", numbers::error(error * unit.factor), unit.tail),
    )
}

/// Who races, with the class where there are several.
fn of_whom(ask: &RaceAsk, race: &Race, class: Option<&str>) -> String {
    let count = race.of_class(class).count();
    match class {
        Some(class) if count > 1 => tr!("{count} {class} lights", count, class),
        _ if count > 1 => format!("{} ({count})", field_words(&ask.field)),
        _ => race
            .of_class(class)
            .next()
            .map_or_else(String::new, |lamp| race.lamps[lamp].0.clone()),
    }
}

/// Error against numbers, one line a racer; medians where many lights race.
pub fn error_chart(ask: &RaceAsk, race: &Race, class: Option<&str>, measure: Measure) -> Chart {
    let of_measure = measure.figure();
    let many = race.of_class(class).count() > 1;
    let (mut lines, mut dots) = (Vec::new(), Vec::new());
    for (place, racer) in race.racers.iter().enumerate() {
        let mut points = Vec::new();
        let mut notes = Vec::new();
        for (budget, numbers) in race.budgets.iter().enumerate() {
            let Some(spread) = race.spread(class, budget, place, measure) else {
                continue;
            };
            points.push([*numbers as f64, of_measure.drawn(spread.median)]);
            notes.push(if many {
                let [p95, worst] =
                    [spread.p95, spread.worst].map(|e| numbers::error(of_measure.shown(e)));
                tr!("95 % below {p95}, worst {worst}", p95, worst)
            } else {
                String::new()
            });
        }
        if points.is_empty() {
            continue;
        }
        let (colour, dash, shape) = looks(*racer);
        let width = if *racer == Racer::Chosen { 2.4 } else { 1.5 };
        // The points have the name: their forms tell more apart than dashes do.
        lines.push(stroke("", colour, points.clone(), width, dash));
        let points = Series::points(short_name(*racer), colour, shape, points);
        dots.push(points.with_notes(notes));
    }
    let first = race.budgets.first().map_or(0.0, |n| *n as f64);
    let last = race.budgets.last().map_or(1.0, |n| *n as f64);
    let room = (0.03 * (last - first)).max(0.5);
    let mut notes = race_notes(ask);
    let smallest = short(SMALLEST);
    notes.push(match many {
        true => tr!(
            "Medians over the lights. Below {smallest} an error is drawn at it. ex: colour-exact, \
             +l: with lines.",
            smallest
        ),
        false => tr!(
            "Below {smallest} an error is drawn at it. ex: colour-exact, +l: with lines.",
            smallest
        ),
    });
    Chart {
        title: tr!(
            "Error against numbers: {lights}",
            lights = of_whom(ask, race, class)
        ),
        x_label: said!("Numbers").to_owned(),
        y_label: of_measure.with_unit(),
        x_range: [first - room, last + room],
        y_scale: Scale::Log10,
        series: lines.into_iter().chain(dots).collect(),
        notes,
        ..Chart::default()
    }
}

/// The errors at one count as a strip: a dot for each way, the least first, the composite's and its
/// kin's in colour.
pub fn strip_chart(
    ask: &RaceAsk,
    race: &Race,
    (class, budget): (Option<&str>, usize),
    measure: Measure,
) -> Chart {
    let of_measure = measure.figure();
    let errors = by_error(race, (class, budget), measure);
    let is_own = |racer: &Racer| !matches!(racer, Racer::Rival(_));
    let points = |own: bool| -> (Vec<[f64; 2]>, Vec<String>) {
        let placed = errors.iter().enumerate();
        let some = placed.filter(|(_, (racer, _))| is_own(racer) == own);
        some.map(|(place, (racer, error))| {
            let words = error_words(measure, Some(*error));
            let at = [place as f64, of_measure.drawn(*error)];
            (at, with_colon(said(racer.title()), words))
        })
        .unzip()
    };
    let dots = |name: &str, ink: Ink, shape: Shape, own: bool| {
        let (points, notes) = points(own);
        Series::points(name, ink, shape, points)
            .sized(6.0)
            .with_notes(notes)
    };
    let numbers = race.budgets.get(budget).copied().unwrap_or_default();
    let names = errors.iter().enumerate();
    Chart {
        title: tr!(
            "{lights}, {numbers} numbers each",
            lights = of_whom(ask, race, class),
            numbers
        ),
        y_label: of_measure.with_unit(),
        x_range: [-0.6, errors.len() as f64 - 0.4],
        x_names: names
            .map(|(place, (racer, _))| (place as f64, short_name(*racer).to_owned()))
            .collect(),
        y_scale: Scale::Log10,
        series: vec![
            dots(said!("other ways"), Ink::Measured, Shape::Ring, false),
            dots(
                said!("composites and known lamps"),
                Ink::Spikes,
                Shape::Dot,
                true,
            ),
        ],
        notes: race_notes(ask),
        ..Chart::default()
    }
}

/// The ways with their median errors at a count, the least first; those without one are left out.
fn by_error(
    race: &Race,
    (class, budget): (Option<&str>, usize),
    measure: Measure,
) -> Vec<(Racer, f64)> {
    let racers = race.racers.iter().enumerate();
    let mut errors: Vec<(Racer, f64)> = racers
        .filter(|(_, racer)| **racer != Racer::Chosen)
        .filter_map(|(place, racer)| {
            let spread = race.spread(class, budget, place, measure)?;
            Some((*racer, spread.median))
        })
        .collect();
    errors.sort_by(|a, b| a.1.total_cmp(&b.1));
    errors
}

/// Who is ahead at a count, a sentence.
pub fn ahead(
    ask: &RaceAsk,
    race: &Race,
    (class, budget): (Option<&str>, usize),
    measure: Measure,
) -> String {
    let errors = by_error(race, (class, budget), measure);
    let is_rival = |racer: &Racer| matches!(racer, Racer::Rival(_));
    let best = |rival: bool| errors.iter().find(|(racer, _)| is_rival(racer) == rival);
    let words = |(racer, error): &(Racer, f64)| {
        format!(
            "{} {}",
            said(racer.title()),
            error_words(measure, Some(*error))
        )
    };
    let numbers = race.budgets.get(budget).copied().unwrap_or_default();
    match (best(false), best(true)) {
        (Some(ours), Some(other)) => tr!(
            "{lights} in {numbers} numbers, {figure}: {ours}, best other {other}.",
            lights = of_whom(ask, race, class),
            numbers,
            figure = measure.figure().title(),
            ours = words(ours),
            other = words(other)
        ),
        _ => String::new(),
    }
}

/// The table of one count as a chart of columns: its CSV is the table.
pub fn table_chart(ask: &RaceAsk, race: &Race, class: Option<&str>, budget: usize) -> Chart {
    let wins = wins(race, class, budget, Measure::Patches);
    let places = 0..race.racers.len();
    let mut columns = row_numbers(
        places
            .clone()
            .map(|place| race.row(class, budget, place))
            .collect(),
    );
    let mut add = |key: &str, of: &dyn Fn(usize) -> Option<f64>| {
        columns.push((key.to_owned(), places.clone().map(of).collect()));
    };
    let yes = |yes: bool| Some(f64::from(u8::from(yes)));
    add("numbers", &|place| {
        let runs = race.of_class(class);
        let runs = runs.map(|lamp| race.run(lamp, budget, place).numbers);
        runs.max().map(|n| n as f64)
    });
    add(
        "needs_table",
        &|place| yes(race.racers[place].needs_table()),
    );
    add("is_prefix", &|place| yes(race.racers[place].is_prefix()));
    add("wins", &|place| wins[place].map(|n| n as f64));
    let points = |values: Vec<Option<f64>>| {
        let places = values.into_iter().enumerate();
        let point = |(i, value): (usize, Option<f64>)| [i as f64 + 1.0, value.unwrap_or(f64::NAN)];
        places.map(point).collect()
    };
    let names = race.racers.iter().enumerate();
    Chart {
        title: tr!(
            "Race at {budget} numbers: {lights}",
            budget = race.budgets[budget],
            lights = of_whom(ask, race, class)
        ),
        x_label: said!("place").to_owned(),
        x_names: names
            .map(|(i, racer)| (i as f64 + 1.0, said(racer.title()).to_owned()))
            .collect(),
        y_label: String::new(),
        x_range: [0.5, race.racers.len() as f64 + 0.5],
        series: columns
            .into_iter()
            .map(|(key, values)| Series::points(key, [128; 3], Shape::Dot, points(values)))
            .collect(),
        notes: race_notes(ask),
        ..Chart::default()
    }
}
