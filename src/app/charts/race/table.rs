//! The paper's Table 1 with numbers: one line a representation, the least of each column marked.

use crate::{
    app::numbers::{error, nanoseconds, or_dash},
    languages::said,
    study::{
        Measure, Race, Spread,
        race::{Racer, Row, figures},
    },
};

/// A column of the race's table.
pub struct RaceColumn {
    /// Stands over the column.
    pub title: String,
    /// What it counts, with its unit.
    pub tip: String,
    /// Width that its figures need, points.
    pub width: f32,
    /// Decides the chart and the winners.
    pub decides: bool,
    /// What the numbers cost and promise, where the others are errors.
    pub costs: bool,
    /// A cell for each racer.
    pub cells: Vec<RaceCell>,
}

/// A cell of the race's table.
#[derive(Clone, Default)]
pub struct RaceCell {
    /// The figure.
    pub text: String,
    /// More about it; may be empty.
    pub tip: String,
    /// The least of its column.
    pub wins: bool,
}

impl RaceCell {
    /// A figure and nothing more.
    pub(super) fn of(text: String) -> Self {
        Self {
            text,
            ..Self::default()
        }
    }

    /// Median and 95th percentile, with the worst beside them.
    pub(super) fn of_spread(spread: Spread, factor: f64) -> Self {
        let [median, p95, worst] = figures(spread).map(|value| error(factor * value));
        Self {
            text: format!("{median} / {p95}"),
            tip: tr!(
                "median {median}, 95 % below {p95}, worst {worst}",
                median,
                p95,
                worst
            ),
            wins: false,
        }
    }
}

/// The table as text.
pub struct RaceTable {
    /// One a line.
    pub racers: Vec<Racer>,
    /// Figures of all of them.
    pub columns: Vec<RaceColumn>,
    /// Whether more than one light races, so that figures are spreads.
    pub many: bool,
}

/// What stands between the patches that choose and those that check.
const BEFORE_CHECK: [Measure; 3] = [Measure::Filters, Measure::RmsBlurred, Measure::Own];

/// What is compared in a column; less is better.
type Value<'a> = &'a dyn Fn(&Row) -> Option<f64>;

impl RaceTable {
    /// The table of a class (or all) at a count.
    pub fn new(race: &Race, class: Option<&str>, budget: usize, decides: Measure) -> Self {
        let rows: Vec<Row> = (0..race.racers.len())
            .map(|racer| race.row(class, budget, racer))
            .collect();
        let many = rows.first().is_some_and(|row| row.lamps > 1);
        let mut columns = Vec::new();
        patches(&mut columns, &rows, many, decides);
        let of = |measure: Measure| {
            let mut column = measured(measure, measure.figure().meaning(), &rows, many);
            column.decides = measure == decides;
            if many && measure == Measure::Own {
                // Two figures too small to be written, and the sign of those who win.
                column.width = 114.0;
            }
            column
        };
        columns.extend(BEFORE_CHECK.map(of));
        let check = said!(
            "Mean CIEDE2000 of the 99 test samples of TM-30, which took no part in any choice."
        );
        columns.push(spread_column(
            said!("check, ΔE₀₀"),
            check,
            &rows,
            many,
            1.0,
            &|row| row.check,
        ));
        let is_new = |measure: &Measure| {
            let patches = matches!(measure, Measure::Patches | Measure::PatchesWorst);
            !patches && !BEFORE_CHECK.contains(measure)
        };
        columns.extend(Measure::COMPARED.into_iter().filter(is_new).map(of));
        let errors = columns.len();
        columns.push(spent(race, class, budget, rows.len()));
        costs(&mut columns, &rows, many, &race.cost_of);
        columns[errors..]
            .iter_mut()
            .for_each(|column| column.costs = true);
        Self {
            racers: race.racers.clone(),
            columns,
            many,
        }
    }
}

/// What a racer is listed under.
pub fn group(racer: Racer) -> &'static str {
    match racer {
        Racer::Composite(_) => said!("Composites"),
        Racer::WideLines | Racer::KnownLamps => said!("Lines of their own width"),
        Racer::Rival(_) => said!("Other representations"),
        Racer::Chosen => said!("Chosen per light, by the surfaces"),
    }
}

/// A racer's name in the table.
pub fn name(racer: Racer) -> &'static str {
    match racer {
        Racer::Chosen => said!("Best composite per light"),
        other => said(other.title()),
    }
}

/// What a racer is, a sentence.
pub fn about(racer: Racer) -> String {
    let words = match racer {
        Racer::Composite(way) => {
            let spikes = if way.spikes {
                said!(
                    "The heaviest lines are kept, as many as make the error behind a 10 nm blur \
                     least."
                )
            } else {
                said!("No lines.")
            };
            match way.colour_exact {
                true => {
                    let exact = said!("The light's own X, Y, Z are made exact.");
                    format!("{spikes} {exact}")
                }
                false => spikes.to_owned(),
            }
        }
        Racer::WideLines => said!(
            "A short cosine series and lines of their own width, chosen together; decoding needs \
             the formula alone."
        )
        .to_owned(),
        Racer::KnownLamps => said!(
            "Up to two of the program's lamps, a short cosine series and lines of their own \
             width, chosen together; needs the program's list of lamps. Neither the light at hand \
             nor its likes are among them."
        )
        .to_owned(),
        Racer::Rival(family) => said(family.about().meaning).to_owned(),
        Racer::Chosen => said!(
            "For each light the composite that is best on the surfaces: one of the eight above \
             again, so it wins nothing of its own."
        )
        .to_owned(),
    };
    format!("{}. {words}", said(racer.title()))
}

/// Errors closer than this are equal: a colour-exact fit is off by rounding only.
const EQUAL: f64 = 1e-6;

/// Marks the least value of a column; whoever is as good as the best wins too.
fn mark(rows: &[Row], cells: &mut [RaceCell], value: Value<'_>) {
    let racing = |row: &Row| row.racer != Racer::Chosen;
    let best = rows
        .iter()
        .filter(|row| racing(row))
        .filter_map(value)
        .fold(f64::INFINITY, f64::min);
    for (row, cell) in rows.iter().zip(cells) {
        let near = |v: f64| v <= best * (1.0 + 1e-9) || v.max(best) < EQUAL;
        cell.wins = racing(row) && value(row).is_some_and(near);
    }
}

fn patches(columns: &mut Vec<RaceColumn>, rows: &[Row], many: bool, decides: Measure) {
    let tip = format!(
        "{} {}",
        Measure::Patches.figure().meaning(),
        said!("Light and reflectances are both approximated, with the same count of numbers.")
    );
    if !many {
        let mut column = measured(Measure::Patches, &tip, rows, false);
        column.width = 92.0;
        column.decides = decides == Measure::Patches;
        columns.push(column);
        return;
    }
    type Part = fn(Spread) -> f64;
    let first = over(Measure::Patches);
    let parts: [(&str, Part, &str); 3] = [
        (&first, |s| s.median, said!("Half of the lights are below.")),
        ("95 %", |s| s.p95, said!("95 % of the lights are below.")),
        (said!("worst"), |s| s.worst, said!("The worst light.")),
    ];
    for (i, (title, part, more)) in parts.into_iter().enumerate() {
        let value = |row: &Row| row.spreads[Measure::Patches].map(part);
        let mut cells: Vec<RaceCell> = rows.iter().map(|row| plain(value(row))).collect();
        mark(rows, &mut cells, &value);
        let width = if i == 0 { 92.0 } else { 56.0 };
        columns.push(RaceColumn {
            decides: i == 0 && decides == Measure::Patches,
            ..column(title, &format!("{tip} {more}"), width, cells)
        });
    }
}

fn plain(value: Option<f64>) -> RaceCell {
    RaceCell::of(or_dash(value, error))
}

fn column(title: &str, tip: &str, width: f32, cells: Vec<RaceCell>) -> RaceColumn {
    RaceColumn {
        title: title.to_owned(),
        tip: tip.to_owned(),
        width,
        decides: false,
        costs: false,
        cells,
    }
}

/// What stands over a figure.
fn over(measure: Measure) -> String {
    let figure = measure.figure();
    format!("{}, {}", figure.short(), figure.unit.sign)
}

/// A figure's column.
fn measured(measure: Measure, tip: &str, rows: &[Row], many: bool) -> RaceColumn {
    let (unit, of) = (measure.figure().unit, |row: &Row| row.spreads[measure]);
    spread_column(&over(measure), tip, rows, many, unit.factor, &of)
}

fn spread_column(
    title: &str,
    tip: &str,
    rows: &[Row],
    many: bool,
    factor: f64,
    of: &dyn Fn(&Row) -> Option<Spread>,
) -> RaceColumn {
    let mut cells: Vec<RaceCell> = rows
        .iter()
        .map(|row| match of(row) {
            None => plain(None),
            Some(s) if !many => plain(Some(factor * s.median)),
            Some(s) => RaceCell::of_spread(s, factor),
        })
        .collect();
    mark(rows, &mut cells, &|row| of(row).map(|s| s.median));
    column(title, tip, if many { 104.0 } else { 84.0 }, cells)
}

/// Numbers really spent, and lines among them.
fn spent(race: &Race, class: Option<&str>, budget: usize, racers: usize) -> RaceColumn {
    let cells = (0..racers)
        .map(|racer| {
            let runs = || {
                race.of_class(class)
                    .map(move |l| race.run(l, budget, racer))
            };
            let least = runs().map(|r| r.numbers).min().unwrap_or(0);
            let most = runs().map(|r| r.numbers).max().unwrap_or(0);
            let spikes = runs().map(|r| r.spikes).max().unwrap_or(0);
            RaceCell {
                text: if least == most {
                    most.to_string()
                } else {
                    format!("{least}-{most}")
                },
                tip: match spikes {
                    0 => String::new(),
                    1 => said!("One line at most, two numbers.").to_owned(),
                    n => tr!("Up to {n} lines, two numbers each.", n),
                },
                wins: false,
            }
        })
        .collect();
    let tip = said!(
        "Numbers really spent: a table may have fewer components than asked for, and a wavelet \
         coefficient takes two."
    );
    column(said!("numbers"), tip, 58.0, cells)
}

fn costs(columns: &mut Vec<RaceColumn>, rows: &[Row], many: bool, cost_of: &str) {
    let first = tr!(
        "Measured in this run on {light}, the light with most lines.",
        light = cost_of
    );
    let mut add =
        |title: &str, tip: String, width: f32, value: Value<'_>, text: &dyn Fn(f64) -> String| {
            let mut cells: Vec<RaceCell> = rows
                .iter()
                .map(|row| RaceCell::of(value(row).map_or_else(|| "–".to_owned(), text)))
                .collect();
            mark(rows, &mut cells, value);
            columns.push(column(title, &tip, width, cells));
        };
    let lobes = if many {
        said!("Share of the lights whose smooth part goes below -0.1 % of the peak, percent.")
    } else {
        said!("The smooth part goes below -0.1 % of the peak, or not.")
    };
    add(
        if many {
            said!("below 0 %")
        } else {
            said!("below 0")
        },
        lobes.to_owned(),
        54.0,
        &|row| Some(row.negative_lobes),
        &|share| match (many, share > 0.0) {
            (true, _) => format!("{:.0}", 100.0 * share),
            (false, true) => said!("yes").to_owned(),
            (false, false) => said!("no").to_owned(),
        },
    );
    add(
        said!("ns/product"),
        format!(
            "{} {first}",
            said!(
                "Time from the stored numbers of a light and a reflectance to the values of their \
                 product, nanoseconds. Samples and boxes multiply their own few values; the \
                 others are read at points first."
            )
        ),
        82.0,
        &|row| row.cost.map(|c| c.ns_per_product),
        &nanoseconds,
    );
    add(
        said!("ns/value"),
        format!(
            "{} {first}",
            said!("Time for one value at one wavelength, nanoseconds.")
        ),
        76.0,
        &|row| row.cost.map(|c| c.ns_per_evaluation),
        &nanoseconds,
    );
    add(
        said!("bytes"),
        said!(
            "Bytes of the stored numbers of one spectrum, 8 each; a wavelet coefficient's place \
             takes 2, and wide lines and known lamps have words of 4."
        )
        .to_owned(),
        62.0,
        &|row| row.cost.map(|c| c.bytes as f64),
        &|bytes| format!("{bytes:.0}"),
    );
    promises(columns, rows);
}

/// What the numbers of a representation can do beside being few.
fn promises(columns: &mut Vec<RaceColumn>, rows: &[Row]) {
    for (title, tip, yes) in [
        (
            said!("portable"),
            said!(
                "Numbers that mean something by themselves; principal components need their \
                 table, known lamps the list of lamps."
            ),
            (|racer: Racer| !racer.needs_table()) as fn(Racer) -> bool,
        ),
        (
            said!("flexible"),
            said!(
                "One fit that can be cut anywhere: fewer numbers are the first of more. With \
                 lines or colour-exact every count is a fit of its own."
            ),
            Racer::is_prefix,
        ),
    ] {
        columns.push(column(
            title,
            tip,
            58.0,
            rows.iter()
                .map(|row| {
                    RaceCell::of(
                        match yes(row.racer) {
                            true => said!("yes"),
                            false => said!("no"),
                        }
                        .to_owned(),
                    )
                })
                .collect(),
        ));
    }
}
