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
                self, Tradeoff, all_figures, lack, limits, measure_within, needs, take, way_name,
            },
        },
        pages::WaysShown,
        studies::{About, Stage, SweepAsk},
    },
    io::many::numbers,
    spectrum::Basis,
    study::{Measure, Reference, Sweep, SweepPoint, Verdict},
    ui::{
        chart_view::Hit,
        kit::{Column, Row, headline, line, rolled, table},
    },
};

/// From this width on the two charts stand side by side, points.
const WIDE: f32 = 940.0;

/// From this width on the table has all figures, points.
const ALL_FIGURES: f32 = 600.0;

/// Charts and table of one sweep and figure.
struct Sheet {
    sweep: Arc<Sweep>,
    measure: Measure,
    tradeoff: Tradeoff,
    map: Chart,
    sentences: [String; 2],
    /// The table with all figures, and with the chosen one for where there is little room.
    tables: [(Vec<Column>, Vec<Row>); 2],
    /// The document's revision whose model is marked.
    marked: Option<u64>,
}

#[derive(Default)]
pub(super) struct TradeoffView {
    sheet: Memo<(ByAddress<Sweep>, Measure, WaysShown), Sheet>,
    reference: Memo<About, Option<Reference>>,
    now: Memo<u64, Option<Verdict>>,
}

impl TradeoffView {
    pub(super) fn show(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let app = context.app;
        let ask = SweepAsk::of(app.document());
        context.put(&ask);
        let measure = measure_within(app, context.pages.tradeoff.measure);
        controls(ui, context, measure);
        // A row that is always there: the charts must not jump while a slider is dragged.
        line(ui, |ui| {
            let job = context.studies.of::<SweepAsk>();
            if job.stage() == Stage::Done {
                let words =
                    "Click a point, a box or a row to take that model; Undo brings yours back.";
                ui.add(egui::Label::new(egui::RichText::new(words).weak()).truncate());
            } else {
                progress(ui, job, "Error against numbers");
            }
        });
        let job = context.studies.of::<SweepAsk>();
        if job.stage() == Stage::Impossible {
            return;
        }
        let Some((key, sweep)) = job.answer() else {
            return;
        };
        let (key, sweep) = (key.clone(), sweep.clone());
        // A model of another spectrum is none for this one.
        let fresh = key == ask;
        let revision = app.revision();
        let reference = self.reference.get(ask.about.clone(), tradeoff::reference);
        let now = self.now.get(revision, |_| {
            let reference = reference.as_ref()?;
            tradeoff::verdict_now(app, reference)
        });
        let of = (
            ByAddress(sweep.clone()),
            measure,
            context.pages.tradeoff.ways,
        );
        let sheet = self.sheet.get(of, |(_, measure, ways)| {
            Sheet::of(&key, sweep, *measure, ways)
        });
        if fresh && sheet.marked != Some(revision) {
            sheet.tradeoff.mark(app, now.as_ref(), measure);
            mark_threshold(&mut sheet.map, app);
            sheet.marked = Some(revision);
        }
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
        .on_hover_text(measure.figure().meaning)
        .on_disabled_hover_text(lack.unwrap_or_default())
        .clicked()
}

/// Which figure, and which lines.
fn controls(ui: &mut Ui, context: &mut PageContext<'_>, measure: Measure) {
    ui.horizontal_wrapped(|ui| {
        ui.label("Error");
        for one in Measure::COMPARED {
            if choose(ui, context.app, (one, one.figure().title), measure == one) {
                context.pages.tradeoff.measure = one;
            }
        }
    });
    ui.horizontal_wrapped(|ui| {
        ui.label("Show");
        let ways = &mut context.pages.tradeoff.ways;
        let show = |ui: &mut Ui, shown: &mut bool, name: &str, meaning: &str| {
            ui.checkbox(shown, name).on_hover_text(meaning);
        };
        for basis in Basis::ALL {
            show(ui, &mut ways.bases[basis], basis.name(), basis.meaning());
        }
        ui.separator();
        let meaning = "Every line above the threshold as a spike, two numbers each: drawn through.";
        show(ui, &mut ways.with_spikes, "spikes", meaning);
        let meaning = "Orders only: drawn in dashes.";
        show(ui, &mut ways.without_spikes, "no spikes", meaning);
        ui.separator();
        show(ui, &mut ways.plain, "plain", "Plain least squares.");
        let meaning = "Least squares under the condition that X, Y and Z are exact.";
        show(ui, &mut ways.colour_exact, "colour-exact", meaning);
    });
}

impl Sheet {
    fn of(ask: &SweepAsk, sweep: Arc<Sweep>, measure: Measure, shown: &WaysShown) -> Self {
        let tradeoff = Tradeoff::of(ask, &sweep, measure, shown);
        let sentences =
            limits(measure).map(|limit| needs(ask, &sweep, &tradeoff.front, measure, limit));
        let points = || tradeoff.front.iter().map(|index| &sweep.points[*index]);
        let tables = [&Measure::COMPARED[..], &[measure]].map(|figures| {
            let rows = points().map(|point| row(point, measure, figures));
            (columns(figures), rows.collect())
        });
        Self {
            map: threshold_chart(ask, &sweep, measure),
            tables,
            sentences,
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
            "numbers",
            "2N + 1 for the smooth part and two for each spike.",
            1.2,
        ),
        Column::words(
            "way",
            "Basis, fit (exact: colour-exact), with or without spikes.",
            3.0,
        ),
        Column::numbers("N", "Order of the smooth part.", 0.55),
        Column::numbers("spikes", "Lines kept as a place and a weight.", 1.0),
    ];
    columns.extend(figures.iter().map(|measure| {
        let figure = measure.figure();
        let share = if measure.is_colour() { 1.2 } else { 1.4 };
        Column::numbers(figure.short, figure.meaning, share)
    }));
    columns
}

fn row(point: &SweepPoint, measure: Measure, figures: &[Measure]) -> Row {
    let brief = |measure: &Measure| measure.figure().brief(point.verdict[*measure]);
    let figure = measure.figure();
    let mut cells = vec![
        point.numbers.to_string(),
        way_name(point.way),
        point.order.to_string(),
        point.spikes.to_string(),
    ];
    cells.extend(figures.iter().map(brief));
    Row {
        cells,
        name: format!(
            "{}: {}, order {}, {} {} {}",
            numbers(point.numbers),
            point.way.title(),
            point.order,
            figure.title,
            figure.unit.sign,
            brief(&measure)
        ),
        note: format!("{}\nClick to take this model.", all_figures(&point.verdict)),
        ..Row::default()
    }
}

/// Charts and table in the room there is.
fn lay_out(ui: &mut Ui, context: &mut PageContext<'_>, sheet: &Sheet, fresh: bool) {
    let [first, second] = &sheet.sentences;
    let sentence = headline(ui, context.theme, format!("{first} {second}"));
    sentence.on_hover_text("Of the models drawn: all orders of the ways that are switched on.");
    let room = ui.available_size();
    let scale = context.theme.scale;
    rolled(ui, |ui| {
        if room.x >= WIDE * scale {
            let height = (0.60 * room.y).max(300.0 * scale);
            ui.columns(2, |columns| {
                let size = vec2(columns[0].available_width(), height);
                against_numbers(&mut columns[0], context, sheet, size, fresh);
                against_threshold(&mut columns[1], context, sheet, size, fresh);
            });
        } else {
            let width = ui.available_width();
            let height = (0.52 * room.y).clamp(270.0 * scale, 460.0 * scale);
            against_numbers(ui, context, sheet, vec2(width, height), fresh);
            ui.add_space(4.0);
            let height = (0.41 * room.y).clamp(210.0 * scale, 380.0 * scale);
            against_threshold(ui, context, sheet, vec2(width, height), fresh);
        }
        ui.add_space(6.0);
        front_table(ui, context, sheet, fresh);
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
    let figure = sheet.measure.figure().title;
    ui.strong(format!("Lowest error for that many numbers: {figure}"));
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
