//! The verdict in little room, beside the patches or over them.

use eframe::egui;
use egui::{Label, RichText, Ui, vec2};

use super::{
    kit::down,
    theme::Theme,
    verdict_view::{SWATCH, counts, figure, no_colour, split},
};
use crate::app::{
    App,
    answers::{Seen, Worst},
};

/// Below this height swatch, word and numbers stand in one line, points.
const LINE: f32 = 56.0;

/// Least width of a swatch with words below it, points.
const CAPTIONS: f32 = 96.0;

/// Swatch, word and numbers in little room.
pub(super) fn brief(ui: &mut Ui, app: &App, theme: Theme) {
    let outline = ui.visuals().widgets.noninteractive.bg_stroke;
    let is_line = ui.available_height() < LINE * theme.scale;
    egui::Frame::new()
        .stroke(outline)
        .corner_radius(4)
        .inner_margin(if is_line { 4 } else { 8 })
        .show(ui, |ui| {
            ui.set_min_size(ui.available_size());
            let height = ui.available_height();
            if is_line {
                return ui
                    .horizontal_centered(|ui| brief_line(ui, app, theme, height))
                    .inner;
            }
            ui.horizontal_top(|ui| {
                let width = (0.4 * ui.available_width()).min(120.0 * theme.scale);
                down(ui, vec2(width, height), |ui| {
                    ui.set_width(width);
                    let says = width >= CAPTIONS * theme.scale;
                    let row = ui.spacing().interact_size.y + ui.spacing().item_spacing.y;
                    let captions = if says { row } else { 0.0 };
                    let swatch = (height - captions).min(SWATCH * theme.scale);
                    split(ui, app, theme, swatch - 16.0, says);
                });
                let rest = ui.available_width().max(0.0);
                down(ui, vec2(rest, height), |ui| {
                    let Some(worst) = Worst::of(app) else {
                        return no_colour(ui);
                    };
                    let seen = Seen::of(worst.delta_e_2000);
                    let size = if theme.scale > 1.0 { 14.0 } else { 18.0 };
                    let words = RichText::new(seen.verdict()).size(size * theme.scale);
                    ui.add(Label::new(words.color(ui.visuals().strong_text_color())).wrap());
                    ui.label(format!("ΔE₀₀ {} at worst", figure(worst.delta_e_2000)));
                    let (numbers, instead) = counts(app);
                    let words = format!("{numbers} numbers, not {instead}");
                    ui.add(Label::new(words).wrap());
                });
            });
        });
}

/// The same in one line.
fn brief_line(ui: &mut Ui, app: &App, theme: Theme, height: f32) {
    let Some(worst) = Worst::of(app) else {
        return no_colour(ui);
    };
    let width = 64.0 * theme.scale;
    ui.allocate_ui(vec2(width, height), |ui| {
        ui.set_width(width);
        split(ui, app, theme, height - 16.0, false);
    });
    let seen = Seen::of(worst.delta_e_2000);
    ui.label(RichText::new(seen.verdict()).color(ui.visuals().strong_text_color()));
    let (numbers, instead) = counts(app);
    let worst = figure(worst.delta_e_2000);
    let words = format!("ΔE₀₀ {worst} at worst, {numbers} numbers, not {instead}");
    ui.add(Label::new(words).truncate());
}
