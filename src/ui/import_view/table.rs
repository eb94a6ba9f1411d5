//! The first rows of a file.

use eframe::egui;
use egui::{RichText, ScrollArea, Ui};

use crate::{app::import::Head, ui::theme::Theme};

/// How many of the shown columns the width has room for, two at least.
fn columns_that_fit(ui: &Ui, head: &Head) -> usize {
    let letter = 0.5 * ui.text_style_height(&egui::TextStyle::Small);
    let mut left = ui.available_width() - 8.0;
    (0..head.width())
        .take_while(|column| {
            let cells = head.rows.iter().chain([&head.titles]);
            let cells = cells.filter_map(|row| row.get(*column));
            let longest = cells.map(|cell| cell.chars().count()).max().unwrap_or(0);
            left -= letter * longest.max(9) as f32 + 14.0;
            *column < 2 || left >= 0.0
        })
        .count()
}

/// The first rows with what each column was taken for.
pub(super) fn table(ui: &mut Ui, head: &Head, theme: Theme, turn: u64, height: f32) {
    let top = ui.cursor().top();
    if head.rows.is_empty() {
        return;
    }
    for line in &head.above {
        ui.add(egui::Label::new(RichText::new(line).small().color(theme.faint)).truncate());
    }
    if head.along_rows {
        ui.small(said!(
            "The wavelengths stand in a row, one spectrum in each row below."
        ));
    }
    let columns = columns_that_fit(ui, head);
    let more = head.width() + head.more_columns - columns;
    if more > 0 && !head.along_rows {
        ui.small(tr!(
            "The first {columns} columns, + {more} more columns",
            columns,
            more
        ));
    }
    let area = egui::Frame::new()
        .fill(ui.visuals().extreme_bg_color)
        .inner_margin(4)
        .corner_radius(3);
    area.show(ui, |ui| {
        ScrollArea::both()
            .id_salt(("rows", turn))
            .auto_shrink([false, true])
            .max_height((height - (ui.cursor().top() - top)).max(60.0))
            .show(ui, |ui| {
                egui::Grid::new(("first rows", turn))
                    .striped(true)
                    .min_row_height(12.0)
                    .spacing([14.0, 1.0])
                    .show(ui, |ui| {
                        if !head.along_rows {
                            for role in head.roles.iter().take(columns) {
                                ui.small(RichText::new(role.words()).strong());
                            }
                            ui.end_row();
                        }
                        if !head.titles.is_empty() {
                            for title in head.titles.iter().take(columns) {
                                ui.small(RichText::new(title).color(theme.faint));
                            }
                            ui.end_row();
                        }
                        for row in &head.rows {
                            for cell in row.iter().take(columns) {
                                ui.small(RichText::new(cell).monospace());
                            }
                            ui.end_row();
                        }
                    });
            });
    });
}
