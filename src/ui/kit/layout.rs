//! How a page's parts share its room.

use eframe::egui;
use egui::{Align, Grid, Layout, ScrollArea, Ui, Vec2, vec2};

use super::form::GROUP;

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

/// Width of a panel of controls, points, and from which width of the page on it stands beside the
/// picture.
const PANEL: f32 = 300.0;
const BESIDE: f32 = 760.0;

/// A picture that gets the room there is, with its controls at the right; in a narrow page below
/// it. Each scrolls where it is higher than its room.
pub fn with_panel<C>(
    ui: &mut Ui,
    context: &mut C,
    (id, scale): (&str, f32),
    picture: impl FnOnce(&mut Ui, &mut C, Vec2),
    panel: impl FnOnce(&mut Ui, &mut C),
) {
    let room = ui.available_size();
    if room.x < BESIDE * scale {
        scrolled(ui, id, |ui| {
            let size = vec2(ui.available_width(), 0.8 * room.y);
            picture(ui, context, size);
            ui.add_space(GROUP);
            panel(ui, context);
        });
        return;
    }
    let width = PANEL * scale;
    ui.horizontal_top(|ui| {
        ui.spacing_mut().item_spacing.x = GROUP;
        let left = vec2(room.x - width - GROUP, room.y);
        column(ui, left, |ui| {
            ui.spacing_mut().item_spacing.x = 6.0;
            scrolled(ui, id, |ui| {
                let size = vec2(ui.available_width(), room.y);
                picture(ui, context, size);
            });
        });
        column(ui, vec2(width, room.y), |ui| {
            ui.spacing_mut().item_spacing.x = 6.0;
            ui.spacing_mut().slider_width = 100.0 * scale;
            scrolled(ui, &format!("controls of {id}"), |ui| panel(ui, context));
        });
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
