//! How a page's parts share its room.

use eframe::egui;
use egui::{Align, Grid, Layout, ScrollArea, Ui, Vec2, vec2};

/// Room of a scroll area's bar, which stands over the right edge, points.
const BAR: f32 = 8.0;

/// A length between two others. Where there is less room than the least, the room goes first.
pub fn bounded(length: f32, least: f32, room: f32) -> f32 {
    // `clamp` panics where the bounds cross.
    length.max(least).min(room)
}

/// What may be higher than its room, in a scroll area as wide and high as that.
pub fn scrolled<R>(ui: &mut Ui, id: &str, add: impl FnOnce(&mut Ui) -> R) -> R {
    ScrollArea::vertical()
        .id_salt(id)
        .auto_shrink(false)
        .show(ui, |ui| {
            ui.set_max_width(ui.available_width() - BAR);
            add(ui)
        })
        .inner
}

/// The same of all there is, its bar over what stands at the edge.
pub fn rolled(ui: &mut Ui, add: impl FnOnce(&mut Ui)) {
    ScrollArea::vertical().auto_shrink(false).show(ui, add);
}

/// A part that lays out downwards in the room of a size.
pub fn down<R>(ui: &mut Ui, size: Vec2, add: impl FnOnce(&mut Ui) -> R) -> R {
    let layout = Layout::top_down(Align::Min);
    ui.allocate_ui_with_layout(size, layout, add).inner
}

/// The same, taking all of it.
pub fn column<R>(ui: &mut Ui, size: Vec2, add: impl FnOnce(&mut Ui) -> R) -> R {
    down(ui, size, |ui| {
        ui.set_min_size(size);
        add(ui)
    })
}

/// A part of a row, as wide whatever stands in it.
pub fn cell(ui: &mut Ui, width: f32, add: impl FnOnce(&mut Ui)) {
    let size = vec2(width, ui.spacing().interact_size.y);
    ui.allocate_ui_with_layout(size, Layout::left_to_right(Align::Center), |ui| {
        ui.set_min_size(size);
        add(ui);
    });
}

/// A grid of four columns for figures and what they are, denser than rows of controls.
pub fn figure_grid(ui: &mut Ui, id: &str, add: impl FnOnce(&mut Ui)) {
    Grid::new(id)
        .num_columns(4)
        .min_row_height(16.0)
        .spacing([10.0, 2.0])
        .show(ui, add);
}

/// Two columns of the same width, their words ragged.
pub fn two_columns<C>(
    ui: &mut Ui,
    context: &mut C,
    left: impl FnOnce(&mut Ui, &mut C),
    right: impl FnOnce(&mut Ui, &mut C),
) {
    let down = Layout::top_down(Align::Min);
    ui.columns(2, |columns| {
        columns[0].with_layout(down, |ui| left(ui, context));
        columns[1].with_layout(down, |ui| right(ui, context));
    });
}

/// A row of one line, also when it is empty: what stands below must not jump.
pub fn line(ui: &mut Ui, add: impl FnOnce(&mut Ui)) {
    let size = vec2(ui.available_width(), ui.spacing().interact_size.y);
    ui.allocate_ui_with_layout(size, Layout::left_to_right(Align::Center), |ui| {
        ui.set_min_height(size.y);
        ui.set_max_width(size.x);
        add(ui);
    });
}
