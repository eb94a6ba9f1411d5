//! Many lights at once: which order is enough for how many of them, as a sentence, a chart and a
//! table.

use crate::{
    app::{
        App,
        cells::{Columns, Table, cell, column},
        chart::{Chart, Dash, Ink, Series, Shape},
        figures::Unit,
        pages::ManyMemory,
        settings::Settings,
        studies::ManyAsk,
        ticks::short,
    },
    languages::said,
    spectrum::numbers_of_order,
    study::{FitVariant, ManyLights, Measure, SweptLight},
};

/// What is asked of many lights: a way, a figure with its limit, and a share of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wanted {
    /// How models are fitted.
    pub way: FitVariant,
    /// The figure.
    pub measure: Measure,
    /// What it may be at most, as files have it.
    pub limit: f64,
    /// For how many of the lights, 0-1.
    pub share: f64,
}

impl Wanted {
    /// In the way of a document's model.
    pub fn of(settings: Settings, memory: &ManyMemory) -> Self {
        let measure = memory.measure;
        Self {
            way: FitVariant::new(settings.basis, settings.spikes, settings.colour_exact),
            measure,
            limit: memory.limit / measure.figure().unit.factor,
            share: f64::from(memory.share_percent) / 100.0,
        }
    }

    /// The same with or without lines as spikes.
    fn with_spikes(self, spikes: bool) -> Self {
        let way = FitVariant::new(self.way.basis, spikes, self.way.colour_exact);
        Self { way, ..self }
    }

    fn order(self, many: &ManyLights) -> Option<(usize, usize)> {
        many.order_for(self.way, self.measure, self.limit, self.share)
    }

    /// "mean of the surfaces at most ΔE₀₀ 1".
    fn limit_words(self) -> String {
        let figure = self.measure.figure();
        let limit = short(self.limit * figure.unit.factor);
        match figure.unit == Unit::DELTA_E {
            true => tr!(
                "{title} at most ΔE₀₀ {limit}",
                title = figure.title(),
                limit
            ),
            false => tr!(
                "{title} at most {limit}{tail}",
                title = figure.title(),
                limit,
                tail = figure.unit.tail
            ),
        }
    }
}

/// The answer in a sentence.
pub fn sentence(many: &ManyLights, wanted: Wanted) -> String {
    let lights = tr!("{n} light" | "{n} lights" % many.lights.len());
    let limit = wanted.limit_words();
    let highest = many.highest_order;
    let enough = |(order, count): (usize, usize)| {
        tr!(
            "{n} wave ({numbers} numbers and two for each line) is enough for {count} of \
             {lights}: {limit}."
                | "{n} waves ({numbers} numbers and two for each line) are enough for {count} of \
                   {lights}: {limit}."
                    % order,
            numbers = numbers_of_order(order),
            count,
            lights,
            limit
        )
    };
    let enough_without = |(order, count): (usize, usize)| {
        tr!(
            "Without lines {n} wave ({numbers} numbers) is enough for {count} of {lights}: \
             {limit}."
                | "Without lines {n} waves ({numbers} numbers) are enough for {count} of \
                   {lights}: {limit}."
                    % order,
            numbers = numbers_of_order(order),
            count,
            lights,
            limit
        )
    };
    let ways = [wanted.with_spikes(true), wanted.with_spikes(false)];
    let [first, second] = match ways.map(|way| way.order(many)) {
        [Some(with), Some((order, _))] if order == with.0 => [
            enough(with),
            said!("As many waves without lines do it too.").to_owned(),
        ],
        [Some(with), Some((order, _))] => [
            enough(with),
            tr!("Without lines it takes {n} wave." | "Without lines it takes {n} waves." % order),
        ],
        [Some(with), None] => [
            enough(with),
            tr!("Without lines {n} wave is not enough."
                | "Without lines {n} waves are not enough." % highest),
        ],
        [None, Some(without)] => [
            enough_without(without),
            tr!("With lines {n} wave is not enough."
                | "With lines {n} waves are not enough." % highest),
        ],
        [None, None] => {
            return tr!(
                "{n} wave is not enough for {share} % of {lights}: {limit}."
                    | "{n} waves are not enough for {share} % of {lights}: {limit}." % highest,
                share = short(100.0 * wanted.share),
                lights,
                limit
            );
        }
    };
    format!("{first} {second}")
}

/// At least twice so many waves are drawn.
const LEAST_ENOUGH: usize = 6;

/// For how many of the lights each order is enough, with and without lines.
pub fn chart(many: &ManyLights, wanted: Wanted) -> Chart {
    let total = many.lights.len() as f64;
    let last = many.highest_order as f64;
    // Nothing happens beyond twice what is enough.
    let ways = [true, false].map(|spikes| wanted.with_spikes(spikes).order(many));
    let enough = ways.iter().flatten().map(|(order, _)| *order).max();
    let shown = enough.map_or(last, |order| (2 * order.max(LEAST_ENOUGH)) as f64);
    let wish = 100.0 * wanted.share;
    let mut series = vec![
        Series::line(
            said!("target"),
            Ink::Measured,
            vec![[0.0, wish], [last, wish]],
        )
        .dashed(Dash::Dotted),
    ];
    for (spikes, name, ink, dash) in [
        (false, said!("without lines"), Ink::Smooth, Dash::Dashed),
        (true, said!("with lines"), Ink::Spikes, Dash::Solid),
    ] {
        let wanted = wanted.with_spikes(spikes);
        let counts = many.counts(wanted.way, wanted.measure, wanted.limit);
        let points = counts.iter().enumerate();
        let points = points.map(|(order, count)| [order as f64, 100.0 * *count as f64 / total]);
        series.push(Series::line(name, ink, points.collect()).dashed(dash));
        if let Some((order, count)) = wanted.order(many) {
            let at = [order as f64, 100.0 * count as f64 / total];
            series.push(Series::points("", ink, Shape::Dot, vec![at]));
        }
    }
    Chart {
        title: said!("Lights for which so many waves are enough").to_owned(),
        x_label: said!("Waves (N waves take 2N + 1 numbers)").to_owned(),
        y_label: said!("Of the lights, %").to_owned(),
        x_range: [0.0, shown.min(last)],
        y_range: Some([0.0, 100.0]),
        series,
        notes: vec![format!(
            "{}; {}",
            wanted.limit_words(),
            said(wanted.way.title())
        )],
        ..Chart::default()
    }
}

/// A light of the table, the one that needs most first.
pub struct ManyRow<'a> {
    pub light: &'a SweptLight,
    /// Order, lines and numbers that are enough; `None` where no order looked at is.
    pub enough: Option<[usize; 3]>,
    /// The figure at the model's present order.
    pub now: Option<f64>,
}

/// All lights, those that need most first.
pub fn rows<'a>(many: &'a ManyLights, wanted: Wanted, order: usize) -> Vec<ManyRow<'a>> {
    let row = |light: &'a SweptLight| {
        let enough = light.enough(wanted.way, wanted.measure, wanted.limit);
        let now = light.of_way(wanted.way).find(|point| point.order == order);
        ManyRow {
            light,
            enough: enough.map(|point| [point.order, point.spikes, point.numbers]),
            now: now.and_then(|point| point.verdict[wanted.measure]),
        }
    };
    let mut rows: Vec<ManyRow<'a>> = many.lights.iter().map(row).collect();
    let needs = |row: &ManyRow<'_>| row.enough.map_or(usize::MAX, |[order, ..]| order);
    rows.sort_by_key(|row| std::cmp::Reverse(needs(row)));
    rows
}

/// The lights as a table, with what was asked.
pub fn table(app: &App, ask: &ManyAsk, many: &ManyLights, wanted: Wanted) -> Table {
    let comments = format!(
        "# question: {}\n# way: {}\n# answer: {}\n# range: {}-{} nm\n",
        wanted.limit_words(),
        wanted.way.word(),
        sentence(many, wanted),
        ask.0.band.min_nm(),
        ask.0.band.max_nm(),
    );
    let order = app.document().settings.order;
    let measure = wanted.measure.figure();
    let enough = |key: &'static str, at: usize| {
        column(key, move |row: &ManyRow<'_>| {
            cell(row.enough.map(|enough| enough[at]))
        })
    };
    let columns = Columns::<ManyRow<'_>>::default()
        .with("light", |row| cell(row.light.name.as_str()))
        .titled(
            said!("light"),
            said!("Sorted by need: the light that needs most comes first."),
        )
        .with("class", |row| cell(row.light.class.as_str()))
        .and(enough("order", 0))
        .figures(
            said!("waves"),
            said!("From it on every count of waves is good enough."),
        )
        .and(enough("lines", 1))
        .figures(
            said!("lines"),
            said!("Lines that are kept, two numbers each."),
        )
        .and(enough("numbers", 2))
        .figures(said!("numbers"), said!("2N + 1, and two for each line."))
        .with(format!("{}_at_order_{order}", measure.key), |row| {
            cell(row.now).shown(measure.in_column(row.now))
        })
        .figures(tr!("with {order}", order), measure.meaning());
    Table::new(comments, columns, rows(many, wanted, order))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::studies::Question;
    use crate::{app::pages::FieldChoice, study::Progress};

    fn found(app: &App, field: FieldChoice) -> (ManyAsk, ManyLights) {
        let ask = ManyAsk::of(app.document(), field.field(app.document()));
        let many = ask.answer(&Progress::default()).expect("lights");
        (ask, many)
    }

    #[test]
    fn the_sentence_the_chart_and_the_table_tell_the_same_order() {
        let app = App::new();
        let (ask, many) = found(&app, FieldChoice::Smooth);
        let memory = ManyMemory::default();
        let wanted = Wanted::of(app.document().settings, &memory);
        assert_eq!((wanted.limit, wanted.share), (1.0, 0.95));
        let (order, count) = wanted.order(&many).expect("smooth lights need few");
        let told = sentence(&many, wanted);
        assert!(told.starts_with(&format!("{order} waves (")), "{told}");
        let rows = rows(&many, wanted, 7);
        let within = rows
            .iter()
            .filter(|row| row.enough.is_some_and(|[o, ..]| o <= order));
        assert_eq!(within.count(), count);
        let needs = |row: &ManyRow<'_>| row.enough.map_or(usize::MAX, |[o, ..]| o);
        assert!(rows.is_sorted_by_key(|row| std::cmp::Reverse(needs(row))));
        let chart = chart(&many, wanted);
        let line = chart
            .series
            .iter()
            .find(|s| s.name == "with lines")
            .expect("drawn");
        let share = line.marks.points()[order][1];
        assert!(share >= 95.0 && (share - 100.0 * count as f64 / rows.len() as f64).abs() < 1e-9);
        let csv = table(&app, &ask, &many, wanted).csv();
        assert_eq!(
            csv.lines().filter(|line| !line.starts_with('#')).count(),
            rows.len() + 1
        );
    }

    #[test]
    fn a_limit_that_nothing_meets_is_said_without_a_number() {
        let app = App::new();
        let (_, many) = found(&app, FieldChoice::ThisLight);
        let memory = ManyMemory {
            limit: 0.0,
            measure: Measure::Rms,
            ..ManyMemory::default()
        };
        let told = sentence(&many, Wanted::of(app.document().settings, &memory));
        assert!(told.contains("are not enough for"), "{told}");
    }
}
