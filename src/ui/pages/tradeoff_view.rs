//! The page "Trade-off": error against numbers, and what the threshold changes.

use std::sync::Arc;

use eframe::egui;
use egui::{Ui, vec2};

use super::{PageContext, progress};
use crate::{
    app::{
        App, ByAddress, Command, Memo,
        chart::Chart,
        charts::{
            threshold::{mark_threshold, take_cell, threshold_chart},
            tradeoff::{
                self, Tradeoff, all_figures, lack, limits, measure_within, needs, take,
                waves_words, way_name,
            },
        },
        pages::WaysShown,
        studies::{About, Stage, SweepAsk},
    },
    io::many::numbers,
    languages::said,
    spectrum::Basis,
    study::{Measure, Reference, Sweep, SweepPoint, Verdict},
    ui::{
        chart_view::Hit,
        kit::{Column, Row, fold, headline, line, rolled, table},
    },
};

/// Names of controls.
mod names {
    pub(super) const EVERY_WAY: &str = later!("Every way");
    pub(super) const MAP: &str = later!("By waves and lines");
}

/// Height of a fold below the page, points.
const FOLDED: f32 = 34.0;

/// From this width on the table stands beside the chart, points.
const WIDE: f32 = 940.0;

/// From this width on the table has all figures, points.
const ALL_FIGURES: f32 = 720.0;

/// Charts and table of one sweep and figure.
struct Sheet {
    sweep: Arc<Sweep>,
    measure: Measure,
    tradeoff: Tradeoff,
    map: Chart,
    sentence: String,
    /// The models that the sentence is about.
    models: String,
    /// The table with all figures, and with the chosen one for where there is little room.
    tables: [(Vec<Column>, Vec<Row>); 2],
    /// The document's revision whose model is marked.
    marked: Option<u64>,
}

#[derive(Default)]
pub(super) struct TradeoffView {
    sheet: Memo<(ByAddress<Sweep>, Measure, Option<WaysShown>), Sheet>,
    reference: Memo<About, Option<Reference>>,
    now: Memo<u64, Option<Verdict>>,
}

impl TradeoffView {
    pub(super) fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let app = context.app;
        let ask = SweepAsk::of(app.document());
        context.put(&ask);
        let measure = measure_within(app, context.pages.tradeoff.measure);
        let job = context.studies.of::<SweepAsk>();
        let answer = job.answer().filter(|_| job.stage() != Stage::Impossible);
        let answer = answer.map(|(key, sweep)| (key.clone(), sweep.clone()));
        let Some((key, sweep)) = answer else {
            progress(ui, job, said!("Error against numbers"));
            return controls(ui, context, measure);
        };
        // A model of another spectrum is none for this one.
        let fresh = key == ask;
        let revision = app.revision();
        let reference = self.reference.get(ask.about.clone(), tradeoff::reference);
        let now = self.now.get(revision, |_| {
            let reference = reference.as_ref()?;
            tradeoff::verdict_now(app, reference)
        });
        let drawn = context.pages.tradeoff.drawn();
        let of = (ByAddress(sweep.clone()), measure, drawn);
        let sheet = self.sheet.get(of, |(_, measure, drawn)| {
            Sheet::of(&key, sweep, *measure, drawn.as_ref())
        });
        if fresh && sheet.marked != Some(revision) {
            sheet.tradeoff.mark(app, now.as_ref(), measure);
            mark_threshold(&mut sheet.map, app);
            sheet.marked = Some(revision);
        }
        headline(ui, context.theme, &sheet.sentence);
        // A row that is always there: the charts must not jump while a slider is dragged.
        line(ui, |ui| {
            let job = context.studies.of::<SweepAsk>();
            if job.stage() == Stage::Done {
                let words = tr!(
                    "{models} Click a point or a row to take its model.",
                    models = sheet.models
                );
                ui.add(egui::Label::new(egui::RichText::new(words).weak()).truncate());
            } else {
                progress(ui, job, said!("Error against numbers"));
            }
        });
        controls(ui, context, measure);
        ui.add_space(14.0);
        lay_out(ui, context, sheet, fresh);
    }
}

/// A button for a figure, which says what it counts or why there is none; whether it was clicked.
pub(in crate::ui) fn choose(
    ui: &mut Ui,
    app: &App,
    (measure, name): (Measure, &str),
    is_chosen: bool,
) -> bool {
    let lack = lack(app, measure);
    ui.add_enabled(lack.is_none(), egui::Button::selectable(is_chosen, name))
        .on_hover_text(measure.figure().meaning())
        .on_disabled_hover_text(lack.unwrap_or_default())
        .clicked()
}

/// Which figure, and which ways have a curve.
fn controls(ui: &mut Ui, context: &mut PageContext<'_>, measure: Measure) {
    ui.horizontal_wrapped(|ui| {
        ui.label(said!("Error"));
        for one in Measure::COMPARED {
            if choose(ui, context.app, (one, one.figure().title()), measure == one) {
                context.pages.tradeoff.measure = one;
            }
        }
        ui.separator();
        let meaning = said!(
            "A curve for every basis and fit, with lines and without; else the lowest error of all."
        );
        ui.checkbox(
            &mut context.pages.tradeoff.every_way,
            said(names::EVERY_WAY),
        )
        .on_hover_text(meaning);
    });
    let state = &mut context.pages.tradeoff;
    if state.every_way {
        ui.horizontal_wrapped(|ui| ways(ui, &mut state.ways));
    }
}

/// The choices of ways.
fn ways(ui: &mut Ui, ways: &mut WaysShown) {
    let show = |ui: &mut Ui, shown: &mut bool, name: &str, meaning: &str| {
        ui.checkbox(shown, name).on_hover_text(meaning);
    };
    for basis in Basis::ALL {
        let (name, meaning) = (said(basis.name()), said(basis.meaning()));
        show(ui, &mut ways.bases[basis], name, meaning);
    }
    ui.separator();
    let meaning = said!("Every line above the threshold, two numbers each: drawn through.");
    show(ui, &mut ways.with_spikes, said!("lines"), meaning);
    let meaning = said!("Waves only: drawn in dashes.");
    show(ui, &mut ways.without_spikes, said!("no lines"), meaning);
    ui.separator();
    show(
        ui,
        &mut ways.plain,
        said!("plain"),
        said!("Plain least squares."),
    );
    let meaning = said!("Least squares under the condition that X, Y and Z are exact.");
    show(ui, &mut ways.colour_exact, said!("colour-exact"), meaning);
}

impl Sheet {
    fn of(ask: &SweepAsk, sweep: Arc<Sweep>, measure: Measure, shown: Option<&WaysShown>) -> Self {
        let tradeoff = Tradeoff::of(ask, &sweep, measure, shown);
        let goals = (measure, limits(measure));
        let [sentence, models] = needs(ask, &sweep, &tradeoff.front, goals);
        let points = || tradeoff.front.iter().map(|index| &sweep.points[*index]);
        let tables = [&Measure::COMPARED[..], &[measure]].map(|figures| {
            let rows = points().map(|point| row(point, measure, figures));
            (columns(figures), rows.collect())
        });
        Self {
            map: threshold_chart(ask, &sweep, measure),
            tables,
            sentence,
            models,
            tradeoff,
            marked: None,
            sweep,
            measure,
        }
    }
}

fn columns(figures: &[Measure]) -> Vec<Column> {
    let mut columns = vec![
        Column::numbers(
            said!("numbers"),
            said!("2N + 1 for N waves, two for each line."),
            1.2,
        ),
        Column::words(
            said!("way"),
            said!("Basis, fit (exact: colour-exact), with or without lines."),
            3.0,
        ),
        Column::numbers(said!("waves"), said!("Waves of the smooth part."), 0.9),
        Column::numbers(
            said!("lines"),
            said!("Lines kept as a place and a weight."),
            1.0,
        ),
    ];
    columns.extend(figures.iter().map(|measure| {
        let figure = measure.figure();
        let share = if measure.is_colour() { 1.2 } else { 1.4 };
        Column::numbers(figure.short(), figure.meaning(), share)
    }));
    columns
}

fn row(point: &SweepPoint, measure: Measure, figures: &[Measure]) -> Row {
    let told = |measure: &Measure| measure.figure().in_column(point.verdict[*measure]);
    let figure = measure.figure();
    let mut cells = vec![
        point.numbers.to_string(),
        way_name(point.way),
        point.order.to_string(),
        point.spikes.to_string(),
    ];
    cells.extend(figures.iter().map(told));
    Row {
        cells,
        name: format!(
            "{}: {}, {}, {} {} {}",
            numbers(point.numbers),
            crate::languages::said(point.way.title()),
            waves_words(point.order),
            figure.title(),
            figure.unit.sign,
            told(&measure)
        ),
        note: tr!(
            "{figures}\nClick to take this model.",
            figures = all_figures(&point.verdict)
        ),
        ..Row::default()
    }
}

/// Charts and table in the room there is.
fn lay_out(ui: &mut Ui, context: &mut PageContext<'_>, sheet: &Sheet, fresh: bool) {
    let room = ui.available_size();
    let scale = context.theme.scale;
    rolled(ui, |ui| {
        let folded = FOLDED * scale;
        if room.x >= WIDE * scale {
            let height = (room.y - folded).max(300.0 * scale);
            ui.columns(2, |columns| {
                let size = vec2(columns[0].available_width(), height);
                against_numbers(&mut columns[0], context, sheet, size, fresh);
                front_table(&mut columns[1], context, sheet, fresh);
            });
        } else {
            let height = (0.6 * room.y).clamp(240.0 * scale, 460.0 * scale);
            let size = vec2(ui.available_width(), height);
            against_numbers(ui, context, sheet, size, fresh);
            ui.add_space(6.0);
            front_table(ui, context, sheet, fresh);
        }
        fold(ui, "trade-off map", said(names::MAP), |ui| {
            let height = (0.6 * room.y).clamp(210.0 * scale, 460.0 * scale);
            let size = vec2(ui.available_width(), height);
            against_threshold(ui, context, sheet, size, fresh);
        });
    });
}

fn against_numbers(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    sheet: &Sheet,
    size: egui::Vec2,
    fresh: bool,
) {
    let chart = &sheet.tradeoff.chart;
    let shown = context.chart(ui, chart, "tradeoff", size);
    let model = |hit: Hit| sheet.tradeoff.model(hit.series, hit.point);
    if fresh && let Some(model) = shown.clicked.and_then(model) {
        let settings = context.app.document().settings;
        let command = take(settings, &sheet.sweep.points[model]);
        context.commands.push(command);
    }
}

fn against_threshold(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    sheet: &Sheet,
    size: egui::Vec2,
    fresh: bool,
) {
    let shown = context.chart(ui, &sheet.map, "threshold map", size);
    let settings = context.app.document().settings;
    let cell = shown.clicked.filter(|hit| hit.series == 0);
    if fresh
        && let Some(cell) = cell
        && let Some(command) = take_cell(settings, &sheet.sweep, cell.point)
    {
        context.commands.push(command);
    }
}

/// The front as a table; its first row is the cheapest model.
fn front_table(ui: &mut Ui, context: &mut PageContext<'_>, sheet: &Sheet, fresh: bool) {
    let settings = context.app.document().settings;
    let points = || {
        let front = sheet.tradeoff.front.iter();
        front.map(|index| &sheet.sweep.points[*index])
    };
    let figure = sheet.measure.figure().title();
    ui.strong(tr!("Lowest error for that many numbers: {figure}", figure));
    let chosen = points().position(|point| is_now(context.app, take(settings, point)));
    let few = ui.available_width() < ALL_FIGURES * context.theme.scale;
    let (columns, rows) = &sheet.tables[usize::from(few)];
    let clicked = table(ui, columns, rows, chosen, fresh, context.theme);
    if let Some(point) = clicked.and_then(|row| points().nth(row)) {
        let command: Command = take(settings, point);
        context.commands.push(command);
    }
}

/// Whether taking a model would change nothing: it is the document's present one.
pub(super) fn is_now(app: &App, taking: Command) -> bool {
    let document = app.document();
    let Command::TakeModel { settings, edits } = taking else {
        return false;
    };
    settings == document.settings && edits == document.subject_edits()
}
