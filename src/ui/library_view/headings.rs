//! What stands over and beside the library's spectra: favourites, shelves, files, hover texts.

use eframe::egui;
use egui::{Align2, Sense, Ui, Vec2, pos2, vec2};

use super::taken;
use crate::{
    app::{App, Command, Entry, search::favourites},
    languages::{said, translated, with_sign},
    ui::{entry_row::elided, kit::named_choice, theme::Theme},
};

/// The lights on top of the library, three in a row.
pub(super) fn favourites_row(
    ui: &mut Ui,
    app: &App,
    theme: Theme,
    compares: bool,
    commands: &mut Vec<Command>,
) {
    let all = favourites(app.bundled());
    ui.add_space(4.0);
    ui.label(
        egui::RichText::new(said!("Favourites"))
            .small()
            .color(theme.faint),
    );
    for row in all.chunks(3) {
        ui.columns(3, |columns| {
            for (ui, favourite) in columns.iter_mut().zip(row) {
                let size = vec2(ui.available_width(), 26.0 * theme.scale);
                let label = translated(favourite.label).to_owned();
                let button = egui::Button::new(label).truncate();
                let response = ui.add_sized(size, button);
                if response.clicked() {
                    commands.push(taken(app, &favourite.entry, compares));
                }
                response.on_hover_text(favourite.entry.name());
            }
        });
    }
    ui.add_space(4.0);
}

/// The name of a shelf; whether it was clicked.
pub(super) fn heading(ui: &mut Ui, size: Vec2, title: &str, count: usize, folded: bool) -> bool {
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    named_choice(&response, egui::Role::Button, !folded, title);
    let colour = ui.style().interact(&response).fg_stroke.color;
    let body = egui::TextStyle::Body.resolve(ui.style());
    let small = egui::TextStyle::Small.resolve(ui.style());
    let (painter, middle) = (ui.painter(), rect.center().y);
    let mark = if folded { "▸" } else { "▾" };
    let left = pos2(rect.left() + 3.0, middle);
    painter.text(left, Align2::LEFT_CENTER, mark, body.clone(), colour);
    let left = pos2(rect.left() + 17.0, middle);
    let strong = ui.visuals().strong_text_color();
    painter.text(left, Align2::LEFT_CENTER, title, body, strong);
    let right = pos2(rect.right() - 4.0, middle);
    let weak = ui.visuals().weak_text_color();
    painter.text(right, Align2::RIGHT_CENTER, count, small, weak);
    response.clicked()
}

/// The name of a file of the user's own; whether it was clicked.
pub(super) fn file_heading(
    ui: &mut Ui,
    size: Vec2,
    name: &str,
    count: usize,
    folded: bool,
) -> bool {
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    let words = tr!("{name}, {n} spectrum" | "{name}, {n} spectra" % count, name);
    named_choice(&response, egui::Role::Button, !folded, &words);
    let colour = ui.style().interact(&response).fg_stroke.color;
    let small = egui::TextStyle::Small.resolve(ui.style());
    let (painter, middle) = (ui.painter(), rect.center().y);
    let mark = if folded { "▸" } else { "▾" };
    let left = pos2(rect.left() + 4.0, middle);
    painter.text(left, Align2::LEFT_CENTER, mark, small.clone(), colour);
    let right = pos2(rect.right() - 4.0, middle);
    let weak = ui.visuals().weak_text_color();
    let count = count.to_string();
    let counted = painter.text(right, Align2::RIGHT_CENTER, count, small.clone(), weak);
    let room = counted.left() - 6.0 - (rect.left() + 17.0);
    let name = elided(ui, name, [0; 2], &small, room);
    let left = pos2(rect.left() + 17.0, middle);
    painter.text(left, Align2::LEFT_CENTER, name, small, colour);
    response.on_hover_text(words).clicked()
}

/// What is known of a spectrum, told under the pointer.
pub(super) fn describe(ui: &mut Ui, entry: &Entry) {
    let spectrum = &entry.spectrum;
    ui.set_max_width(380.0);
    ui.strong(entry.name());
    let samples = &spectrum.samples;
    let [first_nm, last_nm] =
        [samples.first_nm(), samples.last_nm()].map(|nm| with_sign(nm.to_string()));
    let mut words = tr!(
        "{kind}, {n} points, {first_nm} to {last_nm} nm"
            | "{kind}, {n} points, {first_nm} to {last_nm} nm" % samples.len(),
        kind = said(spectrum.kind.word()),
        first_nm,
        last_nm
    );
    if !spectrum.unit.is_empty() {
        words += &format!(", {}", spectrum.unit);
    }
    ui.label(words);
    if !spectrum.source.is_empty() {
        ui.weak(&spectrum.source);
    }
    if !entry.licence.is_empty() {
        ui.weak(tr!("Licence: {licence}", licence = entry.licence));
    }
    ui.weak(said!(
        "Click to show it. Ctrl or Shift and click to compare."
    ));
}
