//! Known lamps and lines of their own width beside the other representations.

use std::sync::Arc;

use eframe::egui;
use egui::Ui;

use super::{scaled, solid_bars, starred};
use crate::{
    app::{
        ByAddress, Memo,
        charts::race::{CELLS_AT, Ways, WaysRow, about, name},
        studies::RaceAsk,
    },
    study::Race,
    ui::{
        kit::{Column, Look, Row, Table},
        pages::PageContext,
    },
};

/// Width of the names and of a figure, points.
const NAMES: f32 = 190.0;
const CELL: f32 = 130.0;
/// Width of a column where there is little room.
const LEAST_CELL: f32 = 92.0;

/// The part of the page and what it keeps from frame to frame.
#[derive(Default)]
pub(super) struct WaysView {
    said: Memo<ByAddress<Race>, Option<Ways>>,
    rows: Memo<(ByAddress<Race>, Option<String>, usize), Vec<Row>>,
}

impl WaysView {
    /// The table of a count, by its place.
    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
        (ask, race): (&RaceAsk, &Arc<Race>),
        (class, budget): (Option<&str>, usize),
    ) {
        let said = |race: &ByAddress<Race>| Ways::of(ask, &race.0, &CELLS_AT);
        let Some(ways) = self.said.get(ByAddress(race.clone()), said) else {
            return;
        };
        ui.add(egui::Label::new(&ways.sentence).wrap());
        ui.horizontal_wrapped(|ui| {
            ui.checkbox(&mut context.pages.race.strict, said!("count strictly"))
                .on_hover_text(said!(
                    "Counts which lamp it is, and how wide a line is, as numbers of their own: a \
                     line takes three numbers, a known lamp two."
                ));
        });
        let at = race.budgets[budget];
        ui.weak(tr!(
            "At {n} number. ★ least error. {remark}"
                | "At {n} numbers. ★ least error. {remark}" % at,
            remark = ways.how
        ));
        ui.add_space(2.0);
        let key = (ByAddress(race.clone()), class.map(str::to_owned), budget);
        let rows = &*self.rows.get(key, |_| {
            let rows = ways.rows(race, class, budget);
            rows.iter().map(row).collect()
        });
        let theme = context.theme;
        ui.scope(|ui| {
            solid_bars(ui);
            egui::ScrollArea::horizontal()
                .id_salt("known lamps in the race")
                .show(ui, |ui| {
                    let [least, most] = [LEAST_CELL, CELL].map(|cell| NAMES + 5.0 * cell);
                    let room = ui.available_width();
                    ui.set_width(room.clamp(scaled(least, theme), scaled(most, theme)));
                    let columns = columns();
                    Table::dense(&columns, theme).show(ui, rows, &mut |_, _, _| {});
                });
        });
        ui.add_space(8.0);
    }
}

fn columns() -> [Column; 6] {
    let number = |title: &str, meaning: &str| Column::numbers(title, meaning, CELL);
    [
        Column::words("", "", NAMES),
        number(
            said!("surfaces, ΔE₀₀"),
            said!(
                "Mean of the 99 samples of TM-30, light and reflectances in as many numbers: \
                 median / 95th percentile where many lights race."
            ),
        ),
        number(
            said!("filters, ΔE₀₀"),
            said!("Mean behind filters 10 nm wide at 425, 435 ... 675 nm."),
        ),
        number(
            said!("spectrum, %"),
            said!("Root mean square behind a blur of 10 nm."),
        ),
        number(
            said!("lamps ahead in"),
            said!("In how many of the cells known lamps with wide lines have the smaller error."),
        ),
        number(
            said!("wide lines in"),
            said!("In how many of the cells wide lines alone have the smaller error."),
        ),
    ]
}

fn row(row: &WaysRow) -> Row {
    let title = name(row.racer);
    let (errors, looks) = starred(row.errors.iter());
    let tips = row.errors.iter().map(|cell| cell.tip.clone());
    Row {
        name: title.to_owned(),
        cells: std::iter::once(title.to_owned())
            .chain(errors)
            .chain(row.won.iter().cloned())
            .collect(),
        note: about(row.racer),
        tips: std::iter::once(String::new()).chain(tips).collect(),
        looks: std::iter::once(Look::Plain).chain(looks).collect(),
    }
}
