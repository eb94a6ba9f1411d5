//! The status line: what was said last, and what is going on.

use eframe::egui;
use egui::Ui;

use super::{
    super::{
        batch_view,
        kit::{named, pressed_small},
        theme::Theme,
    },
    WATCH_EVERY, Window,
};
use crate::app::{Tone, lessons::Lesson};

/// Messages that the status line's tooltip tells.
const MESSAGES_SHOWN: usize = 12;
/// Width from which the button to a lesson has room for its title, points.
const ROOM_FOR_TITLE: f32 = 900.0;

impl Window {
    /// `otherwise`: what is to be noticed and a question, where nothing was said just now;
    /// `lesson` answers it.
    pub(super) fn status(
        &mut self,
        ui: &mut Ui,
        theme: Theme,
        otherwise: (String, String),
        lesson: Option<&Lesson>,
    ) {
        let mut wants_summary = false;
        ui.horizontal_centered(|ui| {
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                if let Some(lesson) = lesson {
                    self.offer_lesson(ui, lesson);
                }
                if let Some(progress) = self.loader.progress() {
                    // What was read is fetched in the next frame; until then it goes on.
                    ui.ctx().request_repaint_after(WATCH_EVERY);
                    if batch_view::progress(ui, &progress) {
                        self.loader.cancel();
                        ui.ctx().request_repaint();
                    }
                }
                if self.lesson_checks.is_busy() {
                    ui.label(said!("checking a lesson"));
                }
                let images = self.images.waiting().len();
                if images > 0 {
                    // Nothing that moves: a file may be long in coming, and each frame costs.
                    ui.label(tr!(
                        "reading {n} image again" | "reading {n} images again" % images
                    ));
                }
                self.offer_to_forget(ui);
                if self.waiting.is_some() {
                    let meaning = said!("Stops waiting for the file dialog.");
                    if pressed_small(ui, said!("stop waiting"), meaning) {
                        self.waiting = None;
                    }
                    ui.label(said!("file dialog open"));
                }
                ui.with_layout(egui::Layout::left_to_right(egui::Align::Center), |ui| {
                    let Some(message) = self.app.current_message() else {
                        let (notice, question) = otherwise;
                        let notice = egui::RichText::new(notice).weak();
                        let whole = egui::Label::new(notice).truncate();
                        ui.add(whole);
                        if ui.available_width() > 24.0 {
                            ui.add(egui::Label::new(question).truncate());
                        }
                        return;
                    };
                    if message.tone == Tone::Problem {
                        ui.colored_label(theme.warning, "▲");
                    }
                    if self.batch.is_told_by(&message.text) {
                        let meaning = said!("How each file was read, or why it was refused.");
                        wants_summary = pressed_small(ui, said!("Each file…"), meaning);
                    }
                    ui.add(egui::Label::new(&message.text).truncate())
                        .on_hover_ui(|ui| {
                            let messages = self.app.messages();
                            let last = messages.len().saturating_sub(MESSAGES_SHOWN);
                            for message in &messages[last..] {
                                ui.label(&message.text);
                            }
                        });
                });
            });
        });
        if wants_summary {
            self.batch.show();
        }
    }

    /// A button to the lesson that answers the page's question.
    fn offer_lesson(&mut self, ui: &mut Ui, lesson: &Lesson) {
        let words = match ui.available_width() >= ROOM_FOR_TITLE {
            true => tr!("Lesson: {title}", title = lesson.title),
            false => said!("Lesson").to_owned(),
        };
        let button = ui.small_button(words);
        named(&button, egui::Role::Button, said!("Lesson about this page"));
        let hover = tr!(
            "{about} ({n} minutes)" | "{about} ({n} minutes)" % lesson.minutes,
            about = format!("{} {}", lesson.title, lesson.sentence)
        );
        if button.on_hover_text(hover).clicked() {
            self.begin_lesson(lesson.name.clone(), ui.ctx());
        }
    }

    /// A button that gives up the images of the last time that were not found.
    fn offer_to_forget(&mut self, ui: &mut Ui) {
        let lost = self.images.lost();
        if lost.is_empty() {
            return;
        }
        let words = tr!("forget {n} missing image" | "forget {n} missing images" % lost.len());
        let names: Vec<String> = lost.iter().map(|l| l.path.display().to_string()).collect();
        let forgets = ui.small_button(words).on_hover_text(tr!(
            "Not found: {files}. The program looks for them at every start until you forget them.",
            files = names.join(", ")
        ));
        if forgets.clicked() {
            self.images.give_up();
            self.keep_now();
        }
    }
}
