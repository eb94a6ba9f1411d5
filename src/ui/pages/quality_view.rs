//! The place "Quality": whether it is a good light, measured beside model.

use std::sync::Arc;

use eframe::egui;
use egui::{RichText, Ui, vec2};

use super::{PageContext, progress};
use crate::{
    app::{
        App,
        chart::{self, Chart},
        charts::quality::{OfBins, against_order, bin_bars, diagram, sample_bars, vector_graphic},
        memo::Memo,
        quality::{OrderAsk, QualitySheet},
        quality_report::Row,
    },
    study::quality::{Chosen, OrderFigures},
    ui::kit::{Column, Row as TableRow, Table, scrolled, table},
};

/// What the pages keep from frame to frame.
#[derive(Default)]
pub struct QualityView {
    sheet: Memo<u64, QualitySheet>,
    charts: Memo<(u64, chart::Theme), Vec<Chart>>,
    diagram: Memo<(u64, chart::Theme, [bool; 5]), Chart>,
}

impl QualityView {
    fn sheet(&mut self, app: &App) -> &QualitySheet {
        &*self.sheet.get(app.revision(), |_| QualitySheet::of(app))
    }

    /// Every figure with its reading, measured and by the model.
    pub fn figures(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let sheet = self.sheet(context.app);
        ui.label(RichText::new(&sheet.sentence).size(16.0 * context.theme.scale));
        ui.add_space(6.0);
        scrolled(ui, "figures of quality", |ui| {
            egui::Grid::new("quality")
                .num_columns(4)
                .striped(true)
                .show(ui, |ui| {
                    ui.weak("figure");
                    ui.weak("measured");
                    ui.weak("model");
                    ui.weak("what it says");
                    ui.end_row();
                    for (measured, model) in &sheet.rows {
                        one(ui, measured, model);
                    }
                });
            for note in &sheet.notes {
                ui.small(note);
            }
        });
    }

    /// Where the light is among colours.
    pub fn diagram(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let theme = context.chart_theme();
        let shows = &mut context.memory.diagram;
        ui.horizontal_wrapped(|ui| {
            ui.checkbox(&mut shows.uniform, "u′v′")
                .on_hover_text("CIE 1976 u′v′, in which equal steps look more alike; else x, y.");
            ui.checkbox(&mut shows.whites, "Nominal whites")
                .on_hover_text("The quadrangles of ANSI C78.377 that lamps are sold by.");
            ui.checkbox(&mut shows.gamuts, "Screens")
                .on_hover_text("What screens of sRGB, P3 and Rec. 2020 can show.");
            ui.checkbox(&mut shows.ellipses, "Ellipses").on_hover_text(
                "MacAdam's ellipses of colours that look alike, ten times enlarged.",
            );
            ui.checkbox(&mut shows.near, "Near the light")
                .on_hover_text("The neighbourhood of the light, where model and measured part.");
        });
        let shows = *shows;
        let key = [
            shows.uniform,
            shows.gamuts,
            shows.whites,
            shows.ellipses,
            shows.near,
        ];
        let revision = context.app.revision();
        let sheet = self.sheet(context.app);
        ui.label(&sheet.place);
        let [measured, model] = [sheet.measured_xy, sheet.model_xy];
        let make = |_: &_| diagram(measured, model, shows, theme);
        let chart = &*self.diagram.get((revision, theme, key), make);
        let room = ui.available_size();
        let side = room.x.min(1.06 * room.y);
        context.chart(ui, chart, "chromaticity", vec2(side, room.y));
    }

    /// What it does to colours: TM-30 and CRI.
    pub fn rendition(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let theme = context.chart_theme();
        let revision = context.app.revision();
        let sheet = self.sheet(context.app);
        let sentence = sheet.rendition.clone();
        let of = sheet.figures.clone();
        let charts = &*self.charts.get((revision, theme), |_| {
            let mut charts = Vec::new();
            if let Ok(fidelity) = &of.fidelity {
                charts.push(vector_graphic(fidelity, theme));
                charts.push(bin_bars(fidelity, OfBins::Fidelity, theme));
                charts.push(bin_bars(fidelity, OfBins::Chroma, theme));
            }
            if let Ok(rendering) = &of.rendering {
                charts.push(sample_bars(rendering, theme));
            }
            charts
        });
        ui.label(RichText::new(sentence).size(16.0 * context.theme.scale));
        if charts.is_empty() {
            return;
        }
        let room = ui.available_size();
        let half = vec2(0.5 * room.x - 4.0, 0.5 * room.y - 8.0);
        for pair in 0..charts.len().div_ceil(2) {
            ui.horizontal_top(|ui| {
                for (i, chart) in charts.iter().enumerate().skip(2 * pair).take(2) {
                    ui.allocate_ui(half, |ui| {
                        context.chart(ui, chart, ("rendition", i), half);
                    });
                }
            });
        }
    }

    /// What a few numbers do to the figures.
    pub fn order(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let ask = OrderAsk::of(context.app);
        let job = &mut context.studies.quality;
        job.ask_by(&ask, context.wake, OrderAsk::answer);
        let found: Option<Arc<OrderFigures>> = job.result().cloned();
        progress(ui, job, "Quality against order");
        let Some(found) = found else { return };
        let theme = context.chart_theme();
        ui.label(RichText::new(ask.sentence(&found)).size(16.0 * context.theme.scale));
        let room = ui.available_size();
        let half = vec2(0.5 * room.x - 4.0, 0.5 * room.y - 8.0);
        for pair in Chosen::ALL.chunks(2) {
            ui.horizontal_top(|ui| {
                for chosen in pair {
                    let chart = against_order(&found, *chosen, theme);
                    ui.allocate_ui(half, |ui| {
                        context.chart(ui, &chart, ("quality", chosen.title()), half);
                    });
                }
            });
        }
    }
}

/// A row of the table of figures.
fn one(ui: &mut Ui, measured: &Row, model: &Row) {
    ui.label(measured.title).on_hover_text(measured.method);
    for row in [measured, model] {
        let cell = ui.monospace(row.shown());
        if let Err(why) = &row.value {
            cell.on_hover_text(why);
        }
    }
    ui.add(egui::Label::new(&measured.reading).truncate());
    ui.end_row();
}
