//! What the composite wins, and what it does not.

use eframe::egui;
use egui::{RichText, Ui};

use super::WIDE;
use crate::{app::charts::race::Half, ui::theme::section};

pub(super) fn show(ui: &mut Ui, halves: &[Half]) {
    section(ui, said!("Wins and losses of waves and lines"));
    if ui.available_width() >= WIDE && !halves.is_empty() {
        ui.columns(halves.len(), |columns| {
            for (ui, half) in columns.iter_mut().zip(halves) {
                // Columns would stretch the words to their width.
                ui.vertical(|ui| {
                    ui.set_max_width(ui.available_width() - 10.0);
                    told(ui, half);
                });
            }
        });
    } else {
        for half in halves {
            told(ui, half);
        }
    }
}

/// One measure's sentences under their title.
fn told(ui: &mut Ui, (title, sentences): &Half) {
    ui.label(RichText::new(*title).strong());
    for sentence in sentences {
        ui.label(sentence);
    }
    ui.add_space(2.0);
}
