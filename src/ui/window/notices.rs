//! A refusal told where the file was dropped, in its own words.

use eframe::egui;
use egui::{Align2, Area, Context, Frame, Label, Order, Pos2};

use super::{super::theme::Theme, Window};
use crate::{
    app::open::{Came, Finished, Loaded},
    ui::kit::{sign_button, warning},
};

/// How long it stands, s, and how wide it is at most, points.
const STANDS: f64 = 15.0;
const WIDTH: f32 = 420.0;

/// Refusals of files that were dropped.
pub(super) struct Refusal {
    at: Pos2,
    words: String,
    until: f64,
}

impl Window {
    /// Where files are being dropped now.
    pub(super) fn note_drop(&mut self, context: &Context) {
        let dropped = context.input(|i| !i.raw.dropped_files.is_empty());
        if dropped {
            let pointer = context.input(|i| i.pointer.latest_pos());
            let middle = context.content_rect().center();
            self.dropped_at = Some(pointer.unwrap_or(middle));
        }
    }

    /// Tells what was refused where its file was dropped; nothing where it was opened otherwise.
    pub(super) fn tell_refusals(&mut self, finished: &Finished, context: &Context) {
        let Some(at) = self.dropped_at.take() else {
            return;
        };
        let refused = finished.files.iter().filter_map(|file| match &file.came {
            Came::Loaded(Loaded::Refused(why)) => Some(why.as_str()),
            _ => None,
        });
        let refused: Vec<&str> = refused.collect();
        let words = match &refused[..] {
            [] => return,
            [one] => (*one).to_owned(),
            [first, rest @ ..] => tr!(
                "{first} (and {n} more files)" | "{first} (and {n} more files)" % rest.len(),
                first
            ),
        };
        let until = context.input(|i| i.time) + STANDS;
        self.refusal = Some(Refusal { at, words, until });
    }

    /// Draws a refusal until its time is over or it is closed.
    pub(super) fn show_refusal(&mut self, context: &Context, theme: Theme) {
        let Some(refusal) = &self.refusal else { return };
        let left = refusal.until - context.input(|i| i.time);
        let mut closes = left <= 0.0;
        let room = context.content_rect();
        let width = WIDTH.min(room.width() - 32.0);
        let area = Area::new(egui::Id::unique("refusal"))
            .order(Order::Foreground)
            .pivot(Align2::CENTER_CENTER)
            .fixed_pos(refusal.at)
            .constrain(true);
        area.show(context, |ui| {
            Frame::popup(ui.style()).show(ui, |ui| {
                ui.set_width(width);
                ui.horizontal_top(|ui| {
                    let meaning = said!("Closes this note; the line at the bottom keeps it.");
                    closes |= sign_button(ui, "✕", said!("Close the note"), meaning);
                    ui.vertical(|ui| {
                        warning(ui, theme, said!("Not opened"));
                        ui.add(Label::new(&refusal.words).wrap());
                    });
                });
            });
        });
        if closes {
            self.refusal = None;
        } else {
            context.request_repaint_after(std::time::Duration::from_secs_f64(left));
        }
    }
}
