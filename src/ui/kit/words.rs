//! Words with a task: names for screen readers, titles with a button, warnings.

use eframe::egui;
use egui::{Align, Frame, Label, Layout, Margin, Response, RichText, Ui, WidgetText};

use crate::ui::theme::Theme;

/// Size of the sentence that a page begins with, points.
pub const HEADLINE: f32 = 16.0;

/// The sentence that a page begins with: its result.
pub fn headline(ui: &mut Ui, theme: Theme, words: impl Into<String>) -> Response {
    let text = RichText::new(words).size(HEADLINE * theme.scale);
    ui.add(Label::new(text).wrap())
}

/// Gives a widget the name that screen readers and tests call it.
pub fn named(response: &Response, role: egui::Role, name: &str) {
    response.widget_info(|| egui::WidgetInfo::labeled(role, true, name));
}

/// A button that copies a table; nothing where there is none. `meaning` may be empty.
pub fn copy_button(ui: &mut Ui, name: &str, meaning: &str, csv: impl FnOnce() -> String) {
    let mut button = ui.small_button("Copy as CSV");
    named(&button, egui::Role::Button, name);
    if !meaning.is_empty() {
        button = button.on_hover_text(meaning);
    }
    let text = if button.clicked() {
        csv()
    } else {
        String::new()
    };
    if !text.is_empty() {
        ui.ctx().copy_text(text);
    }
}

/// A strong title, and at the right edge the button that copies what is below.
pub fn titled(ui: &mut Ui, title: &str, copy: &str, meaning: &str, csv: impl FnOnce() -> String) {
    ui.horizontal(|ui| {
        ui.label(RichText::new(title).strong());
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            copy_button(ui, copy, meaning, csv);
        });
    });
}

/// A card: what belongs together, on a ground of its own.
pub fn framed<R>(ui: &mut Ui, add: impl FnOnce(&mut Ui) -> R) -> R {
    Frame::new()
        .fill(ui.visuals().faint_bg_color)
        .stroke(ui.visuals().widgets.noninteractive.bg_stroke)
        .corner_radius(4)
        .inner_margin(Margin::symmetric(10, 8))
        .show(ui, |ui| {
            ui.set_width(ui.available_width());
            add(ui)
        })
        .inner
}

/// Something that needs attention, told by a sign and words.
pub fn warning(ui: &mut Ui, theme: Theme, words: impl Into<WidgetText>) {
    ui.horizontal_top(|ui| {
        ui.colored_label(theme.warning, "▲");
        ui.add(Label::new(words).wrap());
    });
}
