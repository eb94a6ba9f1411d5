//! Questions about a file with their answers, one row each.

use eframe::egui;
use egui::{Label, Ui, WidgetText, text::LayoutJob, vec2};

use super::Wish;
use crate::{
    app::import::{Answer, Question},
    ui::theme::Theme,
};

/// Width of what is asked, before the answers, points.
const LABEL: f32 = 118.0;

/// Width that a reason needs beside the answers, points; else it stands below them.
const REASON: f32 = 150.0;

/// One row of answers a question; rows keep their height whatever is answered.
pub(super) fn answers(ui: &mut Ui, questions: &[Question], theme: Theme, wishes: &mut Vec<Wish>) {
    for question in questions {
        let beside = stands_beside(ui, question, theme);
        let size = vec2(ui.available_width(), row_height(ui));
        let layout = egui::Layout::left_to_right(egui::Align::Center);
        ui.allocate_ui_with_layout(size, layout, |ui| {
            ui.set_min_height(size.y);
            ui.spacing_mut().item_spacing.x = 4.0;
            label(ui, question.what, question.meaning, question.applies, theme);
            if beside {
                buttons(ui, question, wishes);
                reason(ui, question, theme);
            } else {
                ui.horizontal_wrapped(|ui| buttons(ui, question, wishes));
            }
        });
        if !beside {
            ui.horizontal(|ui| {
                ui.set_min_height(row_height(ui));
                ui.add_space(LABEL * theme.scale + 4.0);
                reason(ui, question, theme);
            });
        }
    }
}

/// What is asked, in the width that all rows give it.
pub(super) fn label(ui: &mut Ui, what: &str, meaning: &str, applies: bool, theme: Theme) {
    let size = vec2(LABEL * theme.scale, ui.spacing().interact_size.y);
    let left = egui::Layout::left_to_right(egui::Align::Center);
    ui.allocate_ui_with_layout(size, left, |ui| {
        ui.set_min_width(size.x);
        ui.add_enabled(applies, Label::new(what))
            .on_hover_text(meaning);
    });
}

/// About what the buttons of a row take.
fn buttons_width(ui: &Ui, question: &Question) -> f32 {
    let font = egui::TextStyle::Button.resolve(ui.style());
    let padding = 2.0 * ui.spacing().button_padding.x + 4.0;
    let width = |answer: &Answer| {
        let text = answer.words.clone();
        let galley = ui
            .painter()
            .layout_no_wrap(text, font.clone(), egui::Color32::WHITE);
        galley.size().x + padding
    };
    question.answers.iter().map(width).sum()
}

/// Whether the reason has room beside the answers.
pub(super) fn stands_beside(ui: &Ui, question: &Question, theme: Theme) -> bool {
    let needs = LABEL * theme.scale + buttons_width(ui, question);
    ui.available_width() - needs >= REASON * theme.scale
}

fn buttons(ui: &mut Ui, question: &Question, wishes: &mut Vec<Wish>) {
    for answer in &question.answers {
        let button = egui::Button::new(&answer.words).selected(answer.chosen);
        let button = ui
            .add_enabled(question.applies, button)
            .on_hover_text(question.meaning);
        let name = format!("{} {}", question.what, answer.words);
        button.widget_info(|| {
            let enabled = question.applies;
            egui::WidgetInfo::selected(egui::Role::Button, enabled, answer.chosen, &name)
        });
        if button.clicked() && !answer.chosen {
            wishes.push(Wish::Flip(answer.flip));
        }
    }
}

/// Why a question was answered as it is.
fn reason(ui: &mut Ui, question: &Question, theme: Theme) {
    let width = ui.available_width();
    if question.doubtful {
        let words = tr!("▲ doubtful: {reason}", reason = question.because);
        two_lines(ui, &words, theme.warning, width);
    } else {
        two_lines(ui, &question.because, theme.faint, width);
    }
}

/// Height of a row of answers with its reason: two small lines, or a button.
pub(super) fn row_height(ui: &Ui) -> f32 {
    let line = ui.text_style_height(&egui::TextStyle::Small);
    (2.0 * line + 1.0).max(ui.spacing().interact_size.y)
}

/// Small text in at most two lines; all of it in its tooltip where it is longer.
pub(super) fn two_lines(ui: &mut Ui, text: &str, colour: egui::Color32, width: f32) {
    let font = egui::TextStyle::Small.resolve(ui.style());
    let mut job = LayoutJob::simple(text.to_owned(), font, colour, width.max(40.0));
    job.wrap.max_rows = 2;
    let galley = ui.painter().layout_job(job);
    let is_cut = galley.elided;
    let label = ui.add(Label::new(WidgetText::Galley(galley)));
    if is_cut {
        label.on_hover_text(text);
    }
}
