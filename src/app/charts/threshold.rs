//! What order and threshold do to an error, as a heat map.

use super::tradeoff::{all_figures, origin, spikes_words, words_now};
use crate::{
    app::{
        App, Command, Settings,
        chart::{Cells, Chart, Scale, Series, Shape},
        settings::Detector,
        studies::SweepAsk,
    },
    io::many::numbers,
    languages::said,
    spectrum::SpikeEdits,
    study::{FitVariant, Measure, Sweep},
};

/// The threshold's effect as a heat map over order and threshold.
pub fn threshold_chart(ask: &SweepAsk, sweep: &Sweep, measure: Measure) -> Chart {
    let map = &sweep.map;
    let columns = map.highest_order + 1;
    let values = map
        .verdicts
        .iter()
        .map(|verdict| Some(measure.figure().drawn(verdict[measure]?)))
        .collect();
    let notes = (0..map.verdicts.len())
        .map(|i| {
            let (row, order) = (i / columns, i % columns);
            let spikes = map.spikes[row];
            tr!(
                "{lines} at this threshold: {numbers}\n{figures}\nClick to take this model.",
                lines = spikes_words(spikes),
                numbers = numbers(2 * order + 1 + 2 * spikes),
                figures = all_figures(&map.verdicts[i])
            )
        })
        .collect();
    let cells = Cells {
        x_edges: (0..=columns).map(|i| i as f64 - 0.5).collect(),
        y_edges: edges(&map.thresholds_percent),
        values,
        range: None,
        scale: Scale::Log10,
        label: measure.figure().unit.sign.to_owned(),
    };
    let way = FitVariant::new(ask.basis, false, ask.colour_exact);
    Chart {
        title: tr!(
            "{subject}: {figure} by waves and lines ({way})",
            subject = ask.about.subject.0.name(),
            figure = measure.figure().title(),
            way = said(way.title())
        ),
        x_label: said!("Waves").to_owned(),
        y_label: said!("Lines above, % of the power").to_owned(),
        x_range: [-0.5, columns as f64 - 0.5],
        y_range: Some([
            cells.y_edges.first().copied().unwrap_or(0.1),
            cells.y_edges.last().copied().unwrap_or(5.0),
        ]),
        y_scale: Scale::Log10,
        series: vec![Series::cells(measure.figure().title(), cells).with_notes(notes)],
        notes: origin(&ask.about),
        ..Chart::default()
    }
}

/// Borders between places that are even in their logarithm.
fn edges(places: &[f64]) -> Vec<f64> {
    let [Some(first), Some(second)] = [places.first(), places.get(1)] else {
        return Vec::new();
    };
    let half = (second / first).sqrt();
    std::iter::once(first / half)
        .chain(places.iter().map(|place| place * half))
        .collect()
}

/// Marks the present order and threshold in the heat map.
pub fn mark_threshold(chart: &mut Chart, app: &App) {
    chart.series.truncate(1);
    let (settings, derived) = (app.document().settings, app.derived());
    let edited = !app.document().subject_edits().is_empty();
    if !settings.spikes || settings.detector != Detector::Energy || edited {
        return;
    }
    let at = [
        derived.model.smooth().order() as f64,
        settings.threshold_percent,
    ];
    let inside = chart.heat_map().is_some_and(|cells| cells.at(at).is_some());
    if inside {
        // White or black would vanish at one end of the colours: a ring of each.
        let ring = |ink, radius| Series::points("", ink, Shape::Ring, vec![at]).sized(radius);
        let note = tr!("The model now: {model}", model = words_now(app));
        chart.series.push(ring([20; 3], 7.4));
        chart
            .series
            .push(ring([255; 3], 6.0).with_notes(vec![note]));
    }
}

/// What a click on a box of the heat map asks for: that order and threshold, without hand edits.
pub fn take_cell(settings: Settings, sweep: &Sweep, cell: usize) -> Option<Command> {
    let map = &sweep.map;
    let columns = map.highest_order + 1;
    let threshold = *map.thresholds_percent.get(cell / columns)?;
    Some(Command::TakeModel {
        settings: Settings {
            order: cell % columns,
            threshold_percent: threshold,
            spikes: true,
            detector: Detector::Energy,
            wide_lines: false,
            ..settings
        },
        edits: SpikeEdits::default(),
    })
}
