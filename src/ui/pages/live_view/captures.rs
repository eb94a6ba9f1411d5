//! What was captured, in small: a click shows it.

use std::sync::Arc;

use eframe::egui;
use egui::{Color32, Rect, ScrollArea, Stroke, Ui, pos2, vec2};

use crate::{
    app::{Command, Entry, following::is_capture, readings::is_counts},
    color::srgb_of_fill,
    spectrum::Outside,
    ui::{
        kit::{cut_words, tile_button},
        pages::PageContext,
        swatch,
    },
};

/// The newest that are drawn.
const MOST: usize = 50;

/// Size of each, points, and columns of its curve.
const SIZE: [f32; 2] = [112.0, 62.0];
const COLUMNS: usize = 52;

/// Room around them, points.
const AROUND: f32 = 14.0;

/// The height that they take; none where there are none.
pub(super) fn height(context: &PageContext<'_>) -> f32 {
    let has_some = newest(context).next().is_some();
    if has_some {
        SIZE[1] * context.theme.scale + AROUND
    } else {
        0.0
    }
}

fn newest<'a>(context: &PageContext<'a>) -> impl Iterator<Item = &'a Arc<Entry>> {
    let own = context.app.document().own.iter();
    own.filter(|entry| is_capture(entry)).rev().take(MOST)
}

pub(super) fn show(ui: &mut Ui, context: &mut PageContext<'_>) {
    let captures: Vec<_> = newest(context).collect();
    if captures.is_empty() {
        return;
    }
    ui.add_space(6.0);
    let size = vec2(SIZE[0], SIZE[1]) * context.theme.scale;
    ScrollArea::horizontal().id_salt("captures").show(ui, |ui| {
        ui.horizontal(|ui| {
            for entry in captures {
                let name = tr!("Captured: {name}", name = entry.name());
                let (rect, tile) = tile_button(ui, size, &name);
                draw(ui, rect, entry);
                let meaning = tr!(
                    "{name}. Click to show it on every page.",
                    name = entry.name()
                );
                if tile.on_hover_text(meaning).clicked() {
                    context.commands.push(Command::Show(entry.clone()));
                }
            }
        });
    });
}

/// The curve in the colours of its wavelengths, and its time below it.
fn draw(ui: &Ui, rect: Rect, entry: &Entry) {
    let samples = &entry.spectrum.samples;
    let (first, last) = (samples.first_nm().max(360.0), samples.last_nm().min(800.0));
    let font = egui::TextStyle::Small.resolve(ui.style());
    let time = entry.name().rsplit(" at ").next().unwrap_or_default();
    let ink = ui.visuals().text_color();
    let words = cut_words(ui, time, font, ink, rect.width() - 12.0);
    let curve = Rect::from_min_max(
        rect.min + vec2(6.0, 5.0),
        rect.max - vec2(6.0, 5.0 + words.size().y),
    );
    let painter = ui.painter();
    let wide = curve.width() / COLUMNS as f32;
    let nm = |column: usize| first + (last - first) * (column as f64 + 0.5) / COLUMNS as f64;
    let values: Vec<f64> = (0..COLUMNS)
        .map(|c| samples.at(nm(c), Outside::Zero))
        .collect();
    let top = values.iter().copied().fold(0.0, f64::max);
    for (column, value) in values.iter().enumerate().filter(|_| top > 0.0) {
        let x = curve.left() + wide * (column as f32 + 0.5);
        let high = curve.height() * (value / top).clamp(0.0, 1.0) as f32;
        let colour = match is_counts(entry) {
            // Counts have no colour.
            true => ink,
            false => swatch::colour(srgb_of_fill(nm(column))),
        };
        let ends = [pos2(x, curve.bottom()), pos2(x, curve.bottom() - high)];
        painter.line_segment(ends, Stroke::new(wide + 0.5, colour));
    }
    painter.galley(pos2(curve.left(), curve.bottom()), words, Color32::WHITE);
}
