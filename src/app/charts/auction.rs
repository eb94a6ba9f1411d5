//! The auction as a chart, as a table and as a model for the document.

use super::tradeoff::{all_figures, lack, mark_now, origin, spikes_words, stairs, waves_words};
use crate::{
    app::{
        App,
        chart::{Chart, Dash, Ink, Scale, Series, Shape, stroke},
        figures::{SMALLEST, Unit, in_column},
        line_names::{ElementLine, LineName},
        spike_names::identified,
        studies::AuctionAsk,
    },
    io::many::numbers,
    languages::{fixed, said, with_colon},
    study::{
        Auction, FitVariant, Goal, Verdict,
        auction::{Bid, Ended, Purchase, Step},
    },
};

/// Names of the plain goals for people, in the order of `Goal::PLAIN`.
pub const NAMES: [&str; 4] = [
    later!("own colour"),
    later!("surfaces"),
    later!("spectrum"),
    later!("narrow filters"),
];

/// The goal without what does not exist for the document's subject; when nothing is left, the
/// first figure that does exist.
pub fn goal_within(app: &App, goal: Goal) -> Goal {
    let lacks = Goal::MEASURES.map(|measure| lack(app, measure).is_some());
    let kept = |weight: f64, i: usize| if lacks[i] { 0.0 } else { weight };
    let left = Goal {
        own: kept(goal.own, 0),
        patches: kept(goal.patches, 1),
        spectrum: kept(goal.spectrum, 2),
        filters: kept(goal.filters, 3),
    };
    if left.weights().iter().any(|w| *w > 0.0) {
        return left;
    }
    let first = Goal::PLAIN.iter().zip(lacks).find(|(_, lacks)| !lacks);
    first.map_or(goal, |((_, plain), _)| *plain)
}

/// The goal in words: "ΔE₀₀ on the patches (mean)", "mix of errors (own 1, filters 2)".
pub fn goal_words(goal: Goal) -> String {
    match goal.plain_measure() {
        Some(measure) if measure.is_colour() => format!("ΔE₀₀ {}", measure.figure().goal()),
        Some(measure) => measure.figure().goal().to_owned(),
        None => tr!("mix of errors ({words})", words = goal.words()),
    }
}

/// What a goal's error is shown in.
fn goal_unit(goal: Goal) -> Unit {
    let plain = goal.plain_measure();
    plain.map_or(Unit::PERCENT, |measure| measure.figure().unit)
}

/// A goal's error in words.
pub fn error_words(goal: Goal, error: f64) -> String {
    let unit = goal_unit(goal);
    in_column(Some(error * unit.factor), unit)
}

/// Names of the lines on offer, in their order.
pub fn names(ask: &AuctionAsk, auction: &Auction, lines: &[ElementLine]) -> Vec<LineName> {
    let light = identified(&ask.about.subject.0, lines);
    let places: Vec<f64> = auction.lines.iter().map(|line| line.at_nm).collect();
    light.names_at(&places)
}

/// A purchase in words: "wave 3", "line 435.8 nm (Hg)".
fn purchase_words(purchase: &Purchase, auction: &Auction, names: &[LineName]) -> String {
    match purchase {
        Purchase::Widths => said!("the lines' own widths").to_owned(),
        Purchase::Order(order) => tr!("wave {order}", order),
        Purchase::Line(spike) => {
            let index = auction.lines.iter().position(|line| line == spike);
            let name = index.and_then(|i| names.get(i)?.safe.as_deref());
            match name.and_then(|name| name.split_once(' ')) {
                Some((element, _)) => tr!(
                    "line {at_nm} nm ({element})",
                    at_nm = fixed(spike.at_nm, 1),
                    element
                ),
                None => tr!("line {at_nm} nm", at_nm = fixed(spike.at_nm, 1)),
            }
        }
    }
}

/// Purchases in words, runs of waves drawn together: "waves 3-5, line 435.8 nm (Hg)".
pub fn purchases_words(purchases: &[Purchase], auction: &Auction, names: &[LineName]) -> String {
    let orders: Vec<usize> = purchases
        .iter()
        .filter_map(|p| match p {
            Purchase::Order(order) => Some(*order),
            Purchase::Line(_) | Purchase::Widths => None,
        })
        .collect();
    let lines = purchases
        .iter()
        .filter(|p| !matches!(p, Purchase::Order(_)))
        .map(|p| purchase_words(p, auction, names));
    let orders = match orders[..] {
        [] => None,
        [order] => Some(tr!("wave {order}", order)),
        _ => {
            let first = orders.iter().min().copied().unwrap_or(0);
            let last = orders.iter().max().copied().unwrap_or(0);
            Some(tr!("waves {first}-{last}", first, last))
        }
    };
    let words: Vec<String> = orders.into_iter().chain(lines).collect();
    words.join(", ")
}

/// The model of a step in words: "6 waves and the lines 404.9, 435.8 nm".
pub fn model_words(auction: &Auction, step: &Step) -> String {
    let mut places: Vec<f64> = step
        .lines
        .iter()
        .filter_map(|i| auction.lines.get(*i))
        .map(|line| line.at_nm)
        .collect();
    places.sort_by(f64::total_cmp);
    let words: Vec<String> = places.iter().map(|nm| fixed(nm, 1)).collect();
    let (waves, places) = (waves_words(step.order), words.join(", "));
    match (words.len(), step.wide) {
        (0, _) => tr!("{waves} and no lines", waves),
        (1, false) => tr!("{waves} and the line {place} nm", waves, place = places),
        (1, true) => tr!(
            "{waves} and the line {place} nm, as wide as they are",
            waves,
            place = places
        ),
        (_, false) => tr!("{waves} and the lines {places} nm", waves, places),
        (_, true) => tr!(
            "{waves} and the lines {places} nm, as wide as they are",
            waves,
            places
        ),
    }
}

/// Why an auction ended, a sentence.
pub fn ended_words(ask: &AuctionAsk, auction: &Auction) -> String {
    let (last, most) = (auction.last(), numbers(ask.terms.numbers));
    let model = model_words(auction, last);
    match auction.ended {
        Ended::Spent => tr!(
            "{spent} of {most} buy {model}.",
            spent = last.numbers,
            most,
            model
        ),
        Ended::NothingHelps => tr!(
            "{spent} of {most} buy {model}. The rest would lower nothing.",
            spent = last.numbers,
            most,
            model
        ),
    }
}

/// The path with what a click needs to know.
#[derive(Clone, Debug)]
pub struct AuctionChart {
    /// The chart; its last series is the mark of the present model, when there is one.
    pub chart: Chart,
    /// How many series there are without that mark.
    series: usize,
}

/// Places of the series in the chart.
const STAIRS: usize = 2;
const STEPS: usize = 3;

impl AuctionChart {
    /// The chart of an auction.
    pub fn of(ask: &AuctionAsk, auction: &Auction, names: &[LineName]) -> Self {
        let terms = ask.terms;
        let unit = goal_unit(terms.goal);
        let at = |numbers: usize, error: f64| [numbers as f64, (error * unit.factor).max(SMALLEST)];
        let bids = |bids: &[Bid]| bids.iter().map(|b| at(b.numbers, b.error)).collect();
        let points: Vec<[f64; 2]> = auction
            .steps
            .iter()
            .map(|step| at(step.numbers, step.error))
            .collect();
        let mut corners = stairs(&points);
        corners.extend(points.last().map(|p| [terms.numbers as f64, p[1]]));
        let notes = auction
            .steps
            .iter()
            .map(|step| step_note(auction, step, names))
            .collect();
        // Without lines the two plain ways are one.
        let all_lines = if auction.lines.is_empty() {
            &[]
        } else {
            &auction.with[..]
        };
        let with = match auction.lines.len() {
            0 => String::new(),
            1 => said!("the line first, then waves").to_owned(),
            lines => tr!("all {lines} lines first, then waves", lines),
        };
        let series = vec![
            stroke(with, Ink::Spikes, bids(all_lines), 1.6, Dash::Dashed),
            Series::line(
                said!("waves only, no lines"),
                Ink::Smooth,
                bids(&auction.without),
            )
            .dashed(Dash::Dotted),
            stroke(
                said!("the auction"),
                Ink::Measured,
                corners,
                2.2,
                Dash::Solid,
            ),
            Series::points(said!("bought"), Ink::Residual, Shape::Dot, points).with_notes(notes),
        ];
        let way = FitVariant::new(terms.basis, false, terms.colour_exact);
        let y_label = terms.goal.plain_measure().map_or_else(
            || said!("Mix of errors, each in % of its value without waves").to_owned(),
            |measure| measure.figure().with_unit(),
        );
        let chart = Chart {
            title: tr!(
                "{subject}: the auction for {goal} ({way})",
                subject = ask.about.subject.0.name(),
                goal = goal_words(terms.goal),
                way = said(way.title())
            ),
            x_label: said!("Numbers").to_owned(),
            y_label,
            x_range: [0.0, terms.numbers as f64 + 1.0],
            y_scale: Scale::Log10,
            series,
            notes: origin(&ask.about),
            ..Chart::default()
        };
        Self {
            series: chart.series.len(),
            chart,
        }
    }

    /// The step at a point of a series.
    pub fn step(&self, series: usize, point: usize) -> Option<usize> {
        match series {
            STAIRS => Some(point / 2),
            STEPS => Some(point),
            _ => None,
        }
    }

    /// Marks the present model in place of the one that was marked.
    pub fn mark(&mut self, app: &App, ask: &AuctionAsk, auction: &Auction, now: Option<&Verdict>) {
        self.chart.series.truncate(self.series);
        let goal = ask.terms.goal;
        let Some((now, start)) = now.zip(auction.steps.first().map(|s| &s.verdict)) else {
            return;
        };
        let numbers = app.derived().numbers() as f64;
        if let Some(error) = goal.error(now, start)
            && numbers <= self.chart.x_range[1]
        {
            let at = [numbers, (error * goal_unit(goal).factor).max(SMALLEST)];
            let mark = mark_now(app, at, now);
            self.chart.series.push(mark);
        }
    }
}

fn step_note(auction: &Auction, step: &Step, names: &[LineName]) -> String {
    let mut note = Vec::new();
    if step.bought.is_empty() {
        note.push(said!("the mean, where the auction begins").to_owned());
    } else {
        let bought = purchases_words(&step.bought, auction, names);
        note.push(tr!("bought {bought}", bought));
    }
    if !step.gave_back.is_empty() {
        let gave = purchases_words(&step.gave_back, auction, names);
        note.push(tr!("gave back {gave}", gave));
    }
    let (waves, lines) = (waves_words(step.order), spikes_words(step.lines.len()));
    let numbers = numbers(step.numbers);
    note.push(match step.wide {
        true => tr!(
            "{waves}, {lines} as wide as they are: {numbers}",
            waves,
            lines,
            numbers
        ),
        false => with_colon(format!("{waves}, {lines}"), numbers),
    });
    note.push(all_figures(&step.verdict));
    note.push(said!("Click to take this model.").to_owned());
    note.join("\n")
}

/// How much lower an error is than the one before, percent.
pub fn gain_words(before: f64, now: f64) -> String {
    let gain = 100.0 * (1.0 - now / before);
    if !gain.is_finite() {
        return "–".to_owned();
    }
    if gain >= 99.95 {
        format!("> {} %", fixed(99.9, 1))
    } else if gain < 0.05 {
        format!("< {} %", fixed(0.1, 1))
    } else {
        format!("{} %", fixed(gain, 1))
    }
}
