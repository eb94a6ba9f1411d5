//! The race's table: names that stay, figures that scroll where there is no room for all.

use eframe::egui;
use egui::{RichText, Ui};

use super::{scaled, sideways, solid_bars, starred, winner_bar, with_bar};
use crate::{
    app::charts::race::{RaceColumn, RaceTable, about, group, name},
    languages::{said, with_colon},
    study::race::Racer,
    ui::{
        kit::{Column, Look, Row, Table},
        theme::Theme,
    },
};

/// Names of controls, shared with the tests that move them.
pub(super) mod names {
    pub(crate) const ERRORS: &str = later!("Errors");
    pub(crate) const COSTS: &str = later!("Numbers, time and bytes");
}

/// Width of the names, points.
const NAMES: f32 = 204.0;

/// Space between two columns, points.
const GAP: f32 = 8.0;

pub(super) struct TableRows {
    /// Who stands in a line; none in a group's title.
    racers: Vec<Option<Racer>>,
    names: Vec<Row>,
    /// All columns; errors alone; costs beside the error that decides.
    parts: [Part; 3],
    many: bool,
}

/// Columns that are seen together.
struct Part {
    columns: Vec<Column>,
    figures: Vec<Row>,
}

impl Part {
    fn of(table: &RaceTable, shown: impl Fn(&RaceColumn) -> bool) -> Self {
        let columns: Vec<&RaceColumn> = table.columns.iter().filter(|c| shown(c)).collect();
        let head = |column: &&RaceColumn| Column {
            decides: column.decides,
            ..Column::numbers(&column.title, &column.tip, column.width + GAP)
        };
        let figures = lines(table).map(|line| match line {
            Line::Group(group) => Row {
                name: group.to_owned(),
                ..Row::default()
            },
            Line::Racer(place, racer) => figures(racer, &columns, place),
        });
        Self {
            columns: columns.iter().map(head).collect(),
            figures: figures.collect(),
        }
    }

    /// Width that its figures need, points.
    fn width(&self) -> f32 {
        self.columns.iter().map(|column| column.share).sum()
    }
}

impl TableRows {
    /// The rows of a table.
    pub(super) fn of(table: &RaceTable) -> Self {
        let names = lines(table).map(|line| match line {
            Line::Group(group) => Row {
                looks: vec![Look::SmallWeak],
                ..Row::of(vec![group.to_owned()])
            },
            Line::Racer(_, racer) => Row {
                name: name(racer).to_owned(),
                cells: vec![match racer.needs_table() {
                    true => tr!("{model} + table", model = name(racer)),
                    false => name(racer).to_owned(),
                }],
                note: about(racer),
                ..Row::default()
            },
        });
        let racers = lines(table).map(|line| match line {
            Line::Group(_) => None,
            Line::Racer(_, racer) => Some(racer),
        });
        Self {
            racers: racers.collect(),
            names: names.collect(),
            parts: [
                Part::of(table, |_| true),
                Part::of(table, |column| !column.costs),
                Part::of(table, |column| column.costs || column.decides),
            ],
            many: table.many,
        }
    }

    /// Draws it; where there is no room for all columns, errors or `costs`.
    pub(super) fn show(&self, ui: &mut Ui, theme: Theme, costs: &mut bool) {
        let room = ui.available_width() - scaled(NAMES, theme);
        let [all, errors, rest] = &self.parts;
        let fits = scaled(all.width(), theme) <= room;
        if !fits {
            ui.horizontal(|ui| {
                ui.selectable_value(costs, false, said(names::ERRORS));
                ui.selectable_value(costs, true, said(names::COSTS));
            });
        }
        let part = match (fits, *costs) {
            (true, _) => all,
            (false, false) => errors,
            (false, true) => rest,
        };
        let names = [with_bar("", "", 1.0)];
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
                Table::dense(&names, theme).show(ui, &self.names, bar);
            });
            sideways(
                ui,
                ("race columns", true),
                &part.columns,
                theme,
                |ui, table| {
                    table.show(ui, &part.figures, &mut |_, _, _| {});
                },
            );
        });
        if self.many {
            ui.weak(
                RichText::new(said!(
                    "Each: median over the lights and, after the stroke, the 95th percentile; the \
                     worst light on hover."
                ))
                .small(),
            );
        }
    }
}

/// A line of the table.
enum Line {
    /// A group's title.
    Group(&'static str),
    /// A racer by its place.
    Racer(usize, Racer),
}

/// The racers, each group under its title.
fn lines(table: &RaceTable) -> impl Iterator<Item = Line> {
    let mut before = None;
    table
        .racers
        .iter()
        .enumerate()
        .flat_map(move |(place, racer)| {
            let title = group(*racer);
            let is_new = before.replace(title) != Some(title);
            let title = is_new.then_some(Line::Group(title));
            title.into_iter().chain([Line::Racer(place, *racer)])
        })
}

/// The figures of one racer, those that win marked by a sign.
fn figures(racer: Racer, columns: &[&RaceColumn], place: usize) -> Row {
    let cells = || columns.iter().map(|column| &column.cells[place]);
    let told: Vec<String> = columns
        .iter()
        .zip(cells())
        .map(|(column, cell)| format!("{} {}", column.title, cell.text))
        .collect();
    let (starred, looks) = starred(cells());
    Row {
        name: with_colon(name(racer), told.join(", ")),
        cells: starred,
        tips: cells().map(|cell| cell.tip.clone()).collect(),
        looks,
        ..Row::default()
    }
}
