//! The race's table: names that stay, figures that scroll where there is no room for all.

use eframe::egui;
use egui::{RichText, Ui};

use super::{scaled, solid_bars, winner_bar, with_bar};
use crate::{
    app::charts::race::{RaceColumn, RaceTable, about, group, name},
    study::race::Racer,
    ui::{
        kit::{Column, Look, Row, Table},
        theme::Theme,
    },
};

/// Width of the names, points.
const NAMES: f32 = 186.0;

/// Space between two columns, points.
const GAP: f32 = 8.0;

/// The table as rows.
pub struct TableRows {
    /// Who stands in a line; none in a group's title.
    racers: Vec<Option<Racer>>,
    names: Vec<Row>,
    columns: Vec<Column>,
    figures: Vec<Row>,
    many: bool,
}

impl TableRows {
    /// The rows of a table.
    pub fn of(table: &RaceTable) -> Self {
        let column = |column: &RaceColumn| Column {
            decides: column.decides,
            ..Column::numbers(&column.title, &column.tip, column.width + GAP)
        };
        let mut rows = Self {
            racers: Vec::new(),
            names: Vec::new(),
            columns: table.columns.iter().map(column).collect(),
            figures: Vec::new(),
            many: table.many,
        };
        let mut before = None;
        for (place, racer) in table.racers.iter().enumerate() {
            let title = group(*racer);
            if before != Some(title) {
                before = Some(title);
                rows.racers.push(None);
                let row = |cells| Row {
                    name: title.to_owned(),
                    cells,
                    looks: vec![Look::SmallWeak],
                    ..Row::default()
                };
                rows.names.push(row(vec![title.to_owned()]));
                rows.figures.push(row(Vec::new()));
            }
            rows.racers.push(Some(*racer));
            rows.names.push(Row {
                name: name(*racer).to_owned(),
                cells: vec![name(*racer).to_owned()],
                note: about(*racer),
                ..Row::default()
            });
            rows.figures.push(figures(table, place));
        }
        rows
    }

    /// Draws it.
    pub fn show(&self, ui: &mut Ui, theme: Theme) {
        let names = [with_bar("", "", 1.0)];
        let table = |columns| Table {
            enabled: false,
            dense: true,
            ..Table::new(columns, theme)
        };
        let bar = &mut |ui: &Ui, [row, _]: [usize; 2], cell| {
            if let Some(racer) = self.racers[row] {
                winner_bar(ui, cell, racer, theme);
            }
        };
        ui.horizontal_top(|ui| {
            solid_bars(ui);
            ui.spacing_mut().item_spacing.x = 0.0;
            ui.vertical(|ui| {
                ui.set_width(scaled(NAMES, theme));
                table(&names).show(ui, &self.names, bar);
            });
            egui::ScrollArea::horizontal()
                .id_salt("race columns")
                .auto_shrink([true, true])
                .show(ui, |ui| {
                    ui.vertical(|ui| {
                        let width: f32 = self.columns.iter().map(|column| column.share).sum();
                        ui.set_width(scaled(width, theme));
                        table(&self.columns).show(ui, &self.figures, &mut |_, _, _| {});
                    });
                });
        });
        if self.many {
            ui.weak(
                RichText::new(
                    "Each: median over the lights and, after the stroke, the 95th percentile; \
                     the worst light on hover.",
                )
                .small(),
            );
        }
    }
}

/// The figures of one racer, those that win marked by a sign.
fn figures(table: &RaceTable, place: usize) -> Row {
    let cells = || table.columns.iter().map(|column| &column.cells[place]);
    let told: Vec<String> = table
        .columns
        .iter()
        .zip(cells())
        .map(|(column, cell)| format!("{} {}", column.title, cell.text))
        .collect();
    Row {
        name: format!("{}: {}", name(table.racers[place]), told.join(", ")),
        cells: cells()
            .map(|cell| match cell.wins {
                true => format!("★ {}", cell.text),
                false => cell.text.clone(),
            })
            .collect(),
        tips: cells().map(|cell| cell.tip.clone()).collect(),
        looks: cells()
            .map(|cell| match cell.wins {
                true => Look::Strong,
                false => Look::Plain,
            })
            .collect(),
        ..Row::default()
    }
}
