//! The page "Coefficients" as charts: bars of a light and of what weighs it, and how X, Y, Z add
//! up.
//!
//! Coefficients are drawn as multiples of the mean (the term of order 0), so that lights of any
//! unit and height stand beside functions of any height.

mod partial;

use crate::{
    app::{
        chart::{Chart, Dash, Ink, Scale, Series, Shape, stroke},
        charts::{spectrum::of_subject, tradeoff::waves_words},
        numbers::figure,
        state::App,
        studies::paper::CHANNELS,
        ticks::extent,
    },
    spectrum::Basis,
    study::harmonics::{Harmonics, Order},
};

/// What of the harmonics is looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sight {
    /// X, Y or Z: 0, 1 or 2.
    pub channel: usize,
    /// Order of the partial sum.
    pub partial_order: usize,
    /// The order under the pointer.
    pub pointed: Option<usize>,
}

/// Every chart of the page; `None` where there is nothing to divide by: a spectrum without a
/// mean, or X, Y, Z that are not positive on the range.
#[derive(Clone, Debug, PartialEq)]
pub struct CoefficientCharts {
    /// The spectrum with the partial sum.
    pub partial: Chart,
    /// The light's coefficients.
    pub light: Option<Chart>,
    /// Those of the weight.
    pub weight: Option<Chart>,
    /// What each order adds to the channel.
    pub product: Option<Chart>,
    /// X, Y, Z up to each order.
    pub running: Option<Chart>,
    /// What is left out beyond each order, beside Eq. 12.
    pub neglected: Option<Chart>,
}

/// Orders that the bars show at least, where the range carries them.
const LEAST_SHOWN: usize = 20;

/// Mean of the bells over that of the real function, where the range holds them.
const WHOLE_BELLS: std::ops::RangeInclusive<f64> = 0.5..=2.0;

/// The 5 % of Eq. 12, in percent.
const LIMIT_PERCENT: f64 = 5.0;

/// Percentages that a chart of what is left out shows.
pub(super) const NEGLECTED_PERCENT: [f64; 2] = [1e-3, 300.0];

/// What weighs a spectrum for X, Y and Z.
pub(super) const FUNCTIONS: [&str; 3] = ["x-bar", "y-bar", "z-bar"];

/// How lines of X, Y and Z are drawn.
pub(super) const CHANNEL_DASHES: [Dash; 3] = [Dash::Dashed, Dash::Solid, Dash::Dotted];

/// And in which colours.
pub(super) fn channel_inks() -> [Ink; 3] {
    [Ink::Spikes, Ink::Residual, Ink::Smooth]
}

impl CoefficientCharts {
    /// Draws all of them.
    pub fn of(app: &App, harmonics: &Harmonics, sight: Sight) -> Self {
        let draw = Draw::new(app, harmonics, sight);
        Self {
            partial: draw.partial(),
            light: draw.light(),
            weight: draw.weight(),
            product: draw.product(),
            running: draw.running(),
            neglected: draw.neglected(),
        }
    }
}

struct Draw<'a> {
    app: &'a App,
    harmonics: &'a Harmonics,
    orders: &'a [Order],
    sight: Sight,
}

impl<'a> Draw<'a> {
    fn new(app: &'a App, harmonics: &'a Harmonics, sight: Sight) -> Self {
        let in_force = app.derived().model.smooth().order();
        let last = LEAST_SHOWN.max(in_force + 3).max(sight.partial_order);
        let shown = harmonics.orders.len().min(last + 1);
        Self {
            app,
            harmonics,
            orders: &harmonics.orders[..shown],
            sight,
        }
    }

    /// A chart over the orders.
    fn chart(&self, title: &str, y_label: &str, series: Vec<Series>) -> Chart {
        let last = self.orders.len().saturating_sub(1) as f64;
        Chart {
            title: title.to_owned(),
            x_label: said!("Wave n").to_owned(),
            y_label: y_label.to_owned(),
            x_range: [-0.6, last + 0.6],
            series,
            colours: self.strip(last),
            strip: true,
            notes: of_subject(self.app),
            ..Chart::default()
        }
    }

    /// The same with room over and under the marks, which are larger than their places.
    fn roomy(&self, chart: Chart) -> Chart {
        let heights = chart.series.iter().flat_map(|s| s.marks.points());
        let Some([low, high]) = extent(heights.map(|p| p[1]).chain([0.0])) else {
            return chart;
        };
        let room = 0.1 * (high - low);
        Chart {
            y_range: (room > 0.0).then_some([low - room, high + room]),
            ..chart
        }
    }

    /// Under the axis: the orders in the partial sum, and the one that is pointed at.
    fn strip(&self, last: f64) -> Vec<Ink> {
        // Twenty steps an order, the half order at both ends included.
        let steps = ((last + 1.2) * 20.0) as usize;
        let order_at = |i: usize| (-0.6 + i as f64 / 20.0).round().max(0.0) as usize;
        let colour = |i: usize| match order_at(i) {
            order if self.sight.pointed == Some(order) => Ink::Product,
            order if order <= self.sight.partial_order => Ink::Smooth,
            _ => Ink::Beyond,
        };
        (0..=steps).map(colour).collect()
    }

    /// Names of the two numbers that every order from 1 on has.
    fn names(&self) -> [String; 2] {
        let basis = self.harmonics.basis;
        match basis.lists()[..] {
            [first, second, ..] => [first.to_owned(), second.to_owned()],
            [only, ..] => [said!("odd"), said!("even")].map(|which| format!("{only}, {which}")),
            [] => [String::new(), String::new()],
        }
    }

    /// Bars of the first number of each order and stems of the second, as multiples of the mean.
    fn pair(&self, of: impl Fn(&Order) -> [f64; 2]) -> Option<Vec<Series>> {
        let first = self.orders.first().map(&of)?;
        let mean = Some(self.harmonics.basis.mean(first[0])).filter(|mean| *mean != 0.0)?;
        let value = |order: &Order, which: usize| match (order.order, which) {
            (0, 0) => 1.0,
            // Order 0 is one number.
            (0, _) => f64::NAN,
            _ => of(order)[which] / mean,
        };
        let points = |which: usize| -> Vec<[f64; 2]> {
            let point = |o: &Order| [o.order as f64, value(o, which)];
            self.orders.iter().map(point).collect()
        };
        let basis = self.harmonics.basis;
        let word = |order: &Order, which: usize| match order.order {
            0 => {
                let is_mean = basis.mean(1.0) == 1.0;
                let what = if is_mean {
                    said!("the mean")
                } else {
                    said!("twice the mean")
                };
                format!(
                    "{} = {}, {what}",
                    basis.number_name(0),
                    figure(of(order)[0])
                )
            }
            n => {
                let name = basis.number_name(2 * n - 1 + which);
                format!("{name} = {}", figure(of(order)[which]))
            }
        };
        let notes = |which: usize| self.orders.iter().map(|o| word(o, which)).collect();
        let [name, second] = self.names();
        Some(vec![
            Series::bars(name, Ink::Smooth, 0.72, points(0)).with_notes(notes(0)),
            Series::stems(second, Ink::Spikes, points(1), Vec::new()).with_notes(notes(1)),
        ])
    }

    /// The exact value of the channel, where shares of it mean something.
    fn exact(&self) -> Option<f64> {
        Some(self.harmonics.exact[self.sight.channel]).filter(|exact| *exact > 0.0)
    }

    fn light(&self) -> Option<Chart> {
        let title = if self.app.document().is_about_light() {
            said!("Coefficients of the light")
        } else {
            said!("Coefficients of the reflectance")
        };
        let series = self.pair(|order| order.light)?;
        Some(self.roomy(self.chart(title, self.unit_of_mean(), series)))
    }

    fn weight(&self) -> Option<Chart> {
        let k = self.sight.channel;
        let mut series = self.pair(|order| order.weights[k])?;
        if let Some(by_fit) = self.fitted(k) {
            series.extend(by_fit);
        }
        let title = tr!("Coefficients of {weight}", weight = self.weight_name());
        Some(self.roomy(self.chart(&title, self.unit_of_mean(), series)))
    }

    /// What the bars count, and what the two kinds of numbers are.
    fn unit_of_mean(&self) -> &'static str {
        if self.harmonics.basis == Basis::Fourier {
            said!("multiples of its mean (a cosine, b sine)")
        } else {
            said!("multiples of its mean")
        }
    }

    /// What weighs the spectrum, in words.
    fn weight_name(&self) -> String {
        let function = FUNCTIONS[self.sight.channel];
        let document = self.app.document();
        if document.is_about_light() {
            function.to_owned()
        } else {
            tr!(
                "{function} times {light}",
                function,
                light = document.light.name()
            )
        }
    }

    /// Eq. 10 as open forms over the exact bars, as multiples of the exact mean.
    fn fitted(&self, k: usize) -> Option<[Series; 2]> {
        let first = self.orders.first()?;
        let mean = self.harmonics.basis.mean(first.weights[k][0]);
        // Eq. 10 counts the whole bells: a range that cuts them is none of its business.
        let bells = self.harmonics.basis.mean(first.gaussian?[k][0]) / mean;
        if !WHOLE_BELLS.contains(&bells) {
            return None;
        }
        let points = |which: usize| -> Option<Vec<[f64; 2]>> {
            let point = |order: &Order| {
                let value = order.gaussian?[k][which];
                let value = match (order.order, which) {
                    (0, 0) => value / 2.0,
                    (0, _) => f64::NAN,
                    _ => value,
                };
                Some([order.order as f64, value / mean])
            };
            self.orders.iter().map(point).collect()
        };
        let ink = Ink::Measured;
        Some([
            Series::points(said!("a Eq. 10"), ink, Shape::Ring, points(0)?),
            Series::points(said!("b Eq. 10"), ink, Shape::Cross, points(1)?),
        ])
    }

    fn product(&self) -> Option<Chart> {
        let (k, exact) = (self.sight.channel, self.exact()?);
        let point = |order: &Order| {
            let share = order.contribution[k] / exact;
            [order.order as f64, 100.0 * share]
        };
        let points = self.orders.iter().map(point).collect();
        let name = CHANNELS[k];
        let bars = Series::bars(tr!("added to {name}", name), Ink::Residual, 0.72, points);
        let title = tr!(
            "Their product: the part of {name} that each wave adds",
            name
        );
        Some(self.chart(&title, &tr!("% of {name}", name), vec![bars]))
    }

    fn running(&self) -> Option<Chart> {
        self.exact()?;
        let inks = channel_inks();
        let mut series = vec![self.level(said!("exact, 100 %"), 100.0)];
        for k in 0..3 {
            let exact = self.harmonics.exact[k];
            if exact <= 0.0 {
                continue;
            }
            let point = |order: &Order| [order.order as f64, 100.0 * order.running[k] / exact];
            let points = self.orders.iter().map(point).collect();
            let width = if k == self.sight.channel { 3.0 } else { 1.6 };
            series.push(stroke(
                CHANNELS[k],
                inks[k],
                points,
                width,
                CHANNEL_DASHES[k],
            ));
        }
        let title = said!("Running sums towards X, Y and Z");
        Some(self.chart(title, said!("% of the exact total"), series))
    }

    /// A level line over all orders.
    fn level(&self, name: &str, at: f64) -> Series {
        let points = self.orders.iter().map(|o| [o.order as f64, at]).collect();
        stroke(name, Ink::Measured, points, 1.2, Dash::Dashed)
    }

    fn neglected(&self) -> Option<Chart> {
        self.exact()?;
        let k = self.sight.channel;
        let line = |name: &str, ink: Ink, of: &dyn Fn(&Order) -> Option<f64>| {
            let point = |order: &Order| {
                let value = of(order).map_or(f64::NAN, |share| 100.0 * share.abs());
                [order.order as f64, value]
            };
            Series::line(name, ink, self.orders.iter().map(point).collect())
        };
        let name = CHANNELS[k];
        let missed = |order: &Order| order.neglected[k];
        let mut series = vec![
            self.level("5 %", LIMIT_PERCENT),
            line(&tr!("missed of {name}", name), Ink::Residual, &missed),
            line(said!("term n / term 0"), Ink::Smooth, &|o| {
                o.share_of_first[k]
            })
            .dashed(Dash::Dashed),
        ];
        if self.orders.iter().any(|o| o.bound.is_some()) {
            let bound = |order: &Order| order.bound.map(|b| b.channels[k]);
            // The printed 4/n is twice the corrected 2/n for every lobe.
            let printed = |order: &Order| order.bound.map(|b| b.channels_as_printed[k]);
            series.push(line(said!("bound, 2/n"), Ink::Spikes, &bound));
            series
                .push(line(said!("as printed, 4/n"), Ink::Product, &printed).dashed(Dash::Dotted));
        }
        let in_force = self.app.derived().model.smooth().order();
        let mark = |order: &Order| {
            let here = missed(order).filter(|_| order.order == in_force);
            let value = here.map(|share| (100.0 * share.abs()).max(NEGLECTED_PERCENT[0]));
            [order.order as f64, value.unwrap_or(f64::NAN)]
        };
        let points = self.orders.iter().map(mark).collect();
        let now = tr!("{waves}, in force", waves = waves_words(in_force));
        series.push(Series::points(now, Ink::Measured, Shape::Ring, points).sized(6.0));
        Some(Chart {
            y_scale: Scale::Log10,
            y_range: Some(NEGLECTED_PERCENT),
            ..self.chart(&tr!("Left out of {name}, and Eq. 12", name), "%", series)
        })
    }
}
