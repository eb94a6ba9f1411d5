//! Who wins: per class and count, and per light.

use eframe::egui;
use egui::Ui;

use super::{super::PageContext, scaled, sideways, solid_bars, winner_bar, with_bar};
use crate::{
    app::{
        Command,
        charts::race::{Lamp, Winners, Won, about, short_name},
    },
    ui::{
        kit::{Column, Look, Row, Table},
        theme::{Theme, section},
    },
};

/// Width of the classes' names, points.
const CLASSES: f32 = 74.0;

/// Width of a winner's short name, points.
const WINNER: f32 = 77.0;

/// Width of the list of lights, points.
const LAMPS: f32 = 560.0;

pub(super) struct WinnerRows {
    winners: Winners,
    sets: Vec<Row>,
    lamps: Vec<Row>,
}

impl WinnerRows {
    /// The rows of all winners.
    pub(super) fn of(winners: Winners) -> Self {
        let sets = winners.sets.iter().map(|(set, count, won)| Row {
            name: set.clone(),
            cells: std::iter::once(set.clone())
                .chain(won.iter().map(short))
                .collect(),
            tips: std::iter::once(lights(*count))
                .chain(won.iter().map(tip))
                .collect(),
            looks: std::iter::once(Look::Plain)
                .chain(won.iter().map(|_| Look::Small))
                .collect(),
            ..Row::default()
        });
        let show_class = winners.sets.len() > 1;
        let class = |lamp: &Lamp| match show_class {
            true => lamp.class.clone(),
            false => String::new(),
        };
        let lamps = winners.lamps.iter().enumerate().map(|(i, lamp)| Row {
            name: tr!("Show {lamp} ({number})", lamp = lamp.name, number = i + 1),
            note: tr!("{lamp}: click to make it the light.", lamp = lamp.name),
            cells: vec![
                lamp.name.clone(),
                class(lamp),
                short(&lamp.won),
                lamp.won.error.clone(),
            ],
            tips: vec![String::new(), String::new(), tip(&lamp.won)],
            looks: vec![Look::Plain, Look::SmallWeak, Look::Small],
        });
        Self {
            sets: sets.collect(),
            lamps: lamps.collect(),
            winners,
        }
    }

    /// Draws them within a height.
    pub(super) fn show(&self, ui: &mut Ui, context: &mut PageContext<'_>, height: f32) {
        let theme = context.theme;
        let top = ui.cursor().top();
        self.classes(ui, theme);
        if self.lamps.len() < 2 {
            return;
        }
        ui.add_space(4.0);
        section(
            ui,
            &tr!("Winner per light, {n} number"
                | "Winner per light, {n} numbers" % self.winners.numbers),
        );
        let left = (height - (ui.cursor().top() - top)).max(140.0 * theme.scale);
        let has_classes = self.winners.sets.len() > 1;
        let columns = [
            Column::words("", "", 300.0),
            Column::words("", "", if has_classes { 80.0 } else { 0.0 }),
            with_bar("", "", 92.0),
            Column::numbers("", "", 64.0),
        ];
        let lamps = &self.winners.lamps;
        let light = context.app.document().light.name();
        let table = Table {
            chosen: lamps.iter().position(|lamp| lamp.name == light),
            titles: false,
            dense: true,
            ..Table::new(&columns, theme)
        };
        let clicked = ui
            .scope(|ui| {
                solid_bars(ui);
                ui.set_width(ui.available_width().min(scaled(LAMPS, theme)));
                table.scrolled(
                    ui,
                    "race lamps",
                    left,
                    &self.lamps,
                    &mut |ui, [row, column], cell| {
                        if column == 2
                            && let Some(racer) = lamps[row].won.racer
                        {
                            winner_bar(ui, cell, racer, theme);
                        }
                    },
                )
            })
            .inner;
        if let Some(entry) = clicked.and_then(|row| lamps[row].entry.clone()) {
            context.commands.push(Command::Show(entry));
        }
    }

    fn classes(&self, ui: &mut Ui, theme: Theme) {
        let winners = &self.winners;
        section(
            ui,
            &tr!(
                "Least {figure}, by numbers",
                figure = winners.measure.figure().title()
            ),
        );
        let budgets = winners.budgets.iter().map(|numbers| {
            with_bar(
                &numbers.to_string(),
                said!("Numbers that each may spend."),
                WINNER,
            )
        });
        let columns: Vec<Column> = std::iter::once(Column::words("", "", CLASSES))
            .chain(budgets)
            .collect();
        ui.scope(|ui| {
            solid_bars(ui);
            sideways(ui, ("race classes", false), &columns, theme, |ui, table| {
                table.show(ui, &self.sets, &mut |ui, [row, column], cell| {
                    let won = column.checked_sub(1).map(|i| &winners.sets[row].2[i]);
                    if let Some(racer) = won.and_then(|won| won.racer) {
                        winner_bar(ui, cell, racer, theme);
                    }
                });
            });
        });
    }
}

fn lights(count: usize) -> String {
    match count {
        1 => said!("One light.").to_owned(),
        n => tr!("{n} light; the least median wins." | "{n} lights; the least median wins." % n),
    }
}

fn short(won: &Won) -> String {
    won.racer.map_or_else(|| "–".to_owned(), short_name)
}

fn tip(won: &Won) -> String {
    match won.racer {
        Some(racer) => tr!(
            "{meaning}\nError {error}.",
            meaning = about(racer),
            error = won.error
        ),
        None => said!("This figure does not exist here: there is no visible light.").to_owned(),
    }
}
