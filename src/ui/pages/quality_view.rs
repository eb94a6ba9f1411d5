//! The place "Quality": whether it is a good light, measured beside model.

use eframe::egui;
use egui::{Ui, vec2};

use super::{PageContext, progress};
use crate::{
    app::{
        App, ByOrder, Memo, QualityShown,
        chart::Chart,
        charts::quality::{
            DiagramShows, OfBins, against_order, bin_bars, diagram, fidelity_bars, sample_bars,
            vector_graphic,
        },
        quality_report::Row,
        settled_words,
    },
    study::{Progress, quality::Chosen},
    ui::kit::{Column, Row as TableRow, down, headline, scrolled, table},
};

/// From this width on three charts stand side by side, points.
const WIDE: f32 = 780.0;
/// Lowest chart of several, points.
const LEAST_CHART: f32 = 190.0;
/// Room of a scroll bar, points.
const BAR: f32 = 14.0;

/// What the pages keep from frame to frame.
#[derive(Default)]
pub(super) struct QualityView {
    shown: Memo<u64, QualityShown>,
    charts: Memo<u64, Vec<Chart>>,
    diagram: Memo<(u64, DiagramShows), Chart>,
}

impl QualityView {
    fn shown(&mut self, app: &App) -> &QualityShown {
        &*self.shown.get(app.revision(), |_| QualityShown::of(app))
    }

    /// Every figure with its reading, measured and by the model.
    pub(super) fn figures(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let shown = self.shown(context.app);
        headline(ui, context.theme, &shown.sentence);
        ui.add_space(6.0);
        let mut columns = vec![
            Column::words(
                "figure",
                "Point at a row for the standard that it follows.",
                2.2,
            ),
            Column::numbers("measured", "Of the whole table as it was measured.", 1.2),
            Column::numbers("model", "Of the smooth part and the lines together.", 1.2),
        ];
        let beside = "A light compared with this one (+ Compare), as it was measured.";
        let others = shown.others.iter();
        columns.extend(others.map(|name| Column::numbers(name, beside, 1.2)));
        let reading = 4.0 - 0.6 * shown.others.len() as f32;
        columns.push(Column::words(
            "what it says",
            "Of the light as measured.",
            reading,
        ));
        let rows: Vec<TableRow> = shown.rows.iter().map(|row| figure_row(row)).collect();
        scrolled(ui, "figures of quality", |ui| {
            table(ui, &columns, &rows, None, false, context.theme);
            ui.add_space(6.0);
            for note in &shown.sheet.measured.notes {
                ui.small(note);
            }
        });
    }

    /// Where the light is among colours.
    pub(super) fn diagram(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let revision = context.app.revision();
        let shown = self.shown(context.app);
        headline(ui, context.theme, &shown.place);
        let [measured, model] = shown.places();
        let shows = &mut context.memory.diagram;
        ui.horizontal_wrapped(|ui| {
            let mut switch = |on: &mut bool, title: &str, meaning: &str| {
                ui.toggle_value(on, title).on_hover_text(meaning);
            };
            switch(
                &mut shows.uniform,
                "u′v′",
                "CIE 1976 u′v′, in which equal steps look more alike; else CIE 1931 x, y.",
            );
            switch(
                &mut shows.whites,
                "Whites sold",
                "The quadrangles of ANSI C78.377 that lamps are sold by.",
            );
            switch(
                &mut shows.gamuts,
                "Screens",
                "What screens of sRGB, P3 and Rec. 2020 can show.",
            );
            switch(
                &mut shows.ellipses,
                "Ellipses",
                "MacAdam's ellipses: how one observer's matches of a colour scattered, ten times \
                 enlarged.",
            );
            switch(
                &mut shows.near,
                "Near the light",
                "The neighbourhood of the light: the step from measured to model.",
            );
        });
        let shows = *shows;
        let make = |_: &_| diagram(measured, model, shows);
        let chart = &*self.diagram.get((revision, shows), make);
        let room = ui.available_size();
        let side = room.x.min(1.1 * room.y);
        context.chart(ui, chart, "chromaticity", vec2(side, room.y));
    }

    /// What it does to colours: TM-30 and CRI.
    pub(super) fn rendition(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let revision = context.app.revision();
        let shown = self.shown(context.app);
        headline(ui, context.theme, &shown.rendition);
        let of = shown.sheet.measured.clone();
        let charts = &*self.charts.get(revision, |_| {
            let mut charts = Vec::new();
            if let Ok(fidelity) = &of.fidelity {
                charts.push(vector_graphic(fidelity));
                charts.push(bin_bars(fidelity, OfBins::Fidelity));
            }
            if let Ok(rendering) = &of.rendering {
                charts.push(sample_bars(rendering));
            }
            if let Ok(fidelity) = &of.fidelity {
                charts.push(bin_bars(fidelity, OfBins::Chroma));
                charts.push(bin_bars(fidelity, OfBins::Hue));
                charts.push(fidelity_bars(fidelity));
            }
            charts
        });
        grid(ui, context, charts, "rendition");
    }

    /// What a few numbers do to the figures.
    pub(super) fn order(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let app = context.app;
        let job = context.studies.job();
        job.ask(&app.revision(), context.wake, || {
            let ask = ByOrder::of(app);
            move |progress: &Progress| ask.answer(progress)
        });
        progress(ui, job, "Quality against order");
        let Some(found) = job.result().cloned() else {
            return;
        };
        headline(ui, context.theme, settled_words(&found));
        let charts = Chosen::ALL.map(|chosen| against_order(&found, chosen));
        grid(ui, context, &charts, "quality against order");
    }
}

/// Charts side by side, two in a row or three where there is room.
fn grid(ui: &mut Ui, context: &mut PageContext<'_>, charts: &[Chart], id: &str) {
    let scale = context.theme.scale;
    let room = ui.available_size();
    let gap = ui.spacing().item_spacing;
    let columns = match charts.len() > 4 && room.x >= WIDE * scale {
        true => 3,
        false => 2,
    };
    let rows = charts.len().div_ceil(columns) as f32;
    let shared = vec2(
        (room.x - BAR) / columns as f32 - gap.x,
        room.y / rows - gap.y,
    );
    let field = vec2(shared.x, shared.y.max(LEAST_CHART * scale));
    scrolled(ui, id, |ui| {
        for (row, some) in charts.chunks(columns).enumerate() {
            ui.horizontal_top(|ui| {
                for (column, chart) in some.iter().enumerate() {
                    down(ui, field, |ui| {
                        ui.set_min_width(field.x);
                        context.chart(ui, chart, (id, row, column), field);
                    });
                }
            });
        }
    });
}

/// A row of the table of figures: of the light as measured, by its model, of other lights.
fn figure_row(of: &[Row]) -> TableRow {
    let first = &of[0];
    let why = |row: &Row| row.value.clone().err().unwrap_or_default();
    let reading = match &first.value {
        Ok(_) => first.reading.clone(),
        Err(why) => why.clone(),
    };
    let title = std::iter::once(first.figure.title.to_owned());
    TableRow {
        name: format!("{}: {}", first.figure.title, first.shown()),
        cells: title
            .chain(of.iter().map(Row::shown))
            .chain([reading.clone()])
            .collect(),
        note: first.figure.meaning.to_owned(),
        tips: std::iter::once(String::new())
            .chain(of.iter().map(why))
            .chain([reading])
            .collect(),
        ..TableRow::default()
    }
}
