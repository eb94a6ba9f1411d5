//! Words with a task: names for screen readers, titles with a button, warnings.

use crate::languages::{Language, in_language};
use eframe::egui;
use egui::{
    Align, Button, CollapsingHeader, DragValue, Frame, Label, Layout, Margin, Rect, Response,
    RichText, Sense, TextEdit, Ui, Vec2, WidgetText,
};

use crate::ui::theme::{Theme, main_colours};

/// Size of the sentence that a page begins with, points.
pub const HEADLINE: f32 = 20.0;

/// The sentence that a page begins with: its result.
pub fn headline(ui: &mut Ui, theme: Theme, words: impl Into<String>) -> Response {
    let words = words.into();
    if !ui.is_visible() {
        ui.data_mut(|data| data.insert_temp(hidden(), words.clone()));
    }
    let text = RichText::new(words).size(HEADLINE * theme.scale);
    ui.add(Label::new(text).wrap())
}

/// Where the sentence of a page that is drawn unseen is kept.
fn hidden() -> egui::Id {
    egui::Id::unique("sentence of a page that is presented")
}

/// The sentence of the page that was drawn unseen just now.
pub fn hidden_headline(ui: &Ui) -> String {
    ui.data_mut(|data| data.remove_temp(hidden()))
        .unwrap_or_default()
}

/// Gives a widget the name that screen readers and tests call it.
pub fn named(response: &Response, role: egui::Role, name: &str) {
    response.widget_info(|| egui::WidgetInfo::labeled(role, true, name));
}

/// The same for what is chosen or not: a row, a switch, one of several.
pub fn named_choice(response: &Response, role: egui::Role, is_chosen: bool, name: &str) {
    response.widget_info(|| egui::WidgetInfo::selected(role, true, is_chosen, name));
}

/// Adds a field of a number under its name.
pub fn number(ui: &mut Ui, field: DragValue<'_>, name: &str) -> Response {
    let response = ui.add(field);
    named(&response, egui::Role::SpinButton, name);
    response
}

/// A field of one line to type into, under its name.
pub fn text_field(ui: &mut Ui, text: &mut String, [name, hint]: [&str; 2], width: f32) -> Response {
    let field = TextEdit::singleline(text)
        .hint_text(hint)
        .desired_width(width);
    let response = ui.add(field);
    named(&response, egui::Role::TextInput, name);
    response
}

/// Words in one line, cut where they are wider than a width, to be painted.
pub fn cut_words(
    ui: &Ui,
    words: &str,
    font: egui::FontId,
    ink: egui::Color32,
    width: f32,
) -> std::sync::Arc<egui::Galley> {
    let mut job = egui::text::LayoutJob::simple_singleline(words.to_owned(), font, ink);
    job.wrap = egui::text::TextWrapping::truncate_at_width(width.max(8.0));
    ui.painter().layout_job(job)
}

/// Room for what is painted, under its name.
pub fn drawing(ui: &mut Ui, size: Vec2, sense: Sense, name: &str) -> (Rect, Response) {
    let (rect, response) = ui.allocate_exact_size(size, sense);
    named(&response, egui::Role::Image, name);
    (rect, response)
}

/// A button with what it does; whether it was clicked.
pub fn pressed(ui: &mut Ui, words: &str, meaning: &str) -> bool {
    pressed_if(ui, true, Button::new(words), meaning)
}

/// The same in small.
pub fn pressed_small(ui: &mut Ui, words: &str, meaning: &str) -> bool {
    pressed_if(ui, true, Button::new(words).small(), meaning)
}

/// The one button of a card that does its work: it looks like nothing that is switched on.
pub fn main_button(ui: &Ui, words: &str) -> Button<'static> {
    let (fill, ink) = main_colours(ui.visuals().dark_mode);
    Button::new(RichText::new(words.to_owned()).color(ink)).fill(fill)
}

/// A button that can be clicked under a condition, with what it does.
pub fn pressed_if(ui: &mut Ui, can: bool, button: Button<'_>, meaning: &str) -> bool {
    ui.add_enabled(can, button).on_hover_text(meaning).clicked()
}

/// A small button with a sign or a word, called by more; whether it was clicked.
pub fn sign_button(ui: &mut Ui, sign: &str, name: &str, meaning: &str) -> bool {
    let button = ui.small_button(sign);
    named(&button, egui::Role::Button, name);
    button.on_hover_text(meaning).clicked()
}

/// A button as large as a card, on which the words are to be painted.
pub fn tile_button(ui: &mut Ui, size: Vec2, name: &str) -> (Rect, Response) {
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    named(&response, egui::Role::Button, name);
    let fill = ui.style().interact(&response).bg_fill;
    ui.painter().rect_filled(rect, 4.0, fill);
    if response.has_focus() {
        let stroke = ui.visuals().widgets.active.bg_stroke;
        ui.painter()
            .rect_stroke(rect, 4.0, stroke, egui::StrokeKind::Inside);
    }
    (rect, response)
}

/// A button that copies a table; nothing where there is none. `meaning` may be empty.
pub fn copy_button(ui: &mut Ui, name: &str, meaning: &str, csv: impl FnOnce() -> String) {
    let mut button = ui.small_button(said!("Copy as CSV"));
    named(&button, egui::Role::Button, name);
    if !meaning.is_empty() {
        button = button.on_hover_text(meaning);
    }
    // Programs read English.
    let text = button
        .clicked()
        .then(|| in_language(Language::English, csv));
    if let Some(text) = text.filter(|text| !text.is_empty()) {
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

/// What is seen on demand, below its title; `id` tells it apart from others of the page.
pub fn fold(ui: &mut Ui, id: &str, title: &str, add: impl FnOnce(&mut Ui)) {
    CollapsingHeader::new(title).id_salt(id).show(ui, add);
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

/// What must be said about a model, in small type.
pub fn small_warnings(ui: &mut Ui, theme: Theme, warnings: &[String]) {
    for warning in warnings {
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            ui.colored_label(theme.warning, "▲");
            ui.small(warning);
        });
    }
}

/// Something that needs attention, told by a sign and words.
pub fn warning(ui: &mut Ui, theme: Theme, words: impl Into<WidgetText>) {
    ui.horizontal_top(|ui| {
        ui.colored_label(theme.warning, "▲");
        ui.add(Label::new(words).wrap());
    });
}
