//! Strips of colour below each other over one axis, with the names of lines.

use eframe::egui;
use egui::{Align2, Color32, FontId, Mesh, Painter, Rect, Sense, TextStyle, Ui, pos2, vec2};

use crate::{
    app::{dispersion::StripShown, ticks::short},
    ui::{
        kit::named,
        theme::{Theme, grey},
    },
};

/// Height of a strip, points.
const STRIP: f32 = 44.0;

/// Height of a row of names, points, and how many there are.
const NAME_ROW: f32 = 15.0;
const NAME_ROWS: usize = 2;

/// What is below the strips.
pub(super) struct Axis<'a> {
    /// Values at both ends.
    pub ends: [f64; 2],
    /// What it counts.
    pub label: &'a str,
}

/// Draws the strips.
pub(super) fn show(ui: &mut Ui, strips: &[StripShown], axis: &Axis<'_>, theme: Theme) {
    let scale = theme.scale;
    let font = TextStyle::Small.resolve(ui.style());
    let ink = ui.visuals().text_color();
    for strip in strips {
        ui.add_space(4.0);
        let names = if strip.marks.is_empty() {
            1.0
        } else {
            NAME_ROWS as f32
        };
        let above = names * NAME_ROW * scale;
        let size = vec2(ui.available_width(), above + STRIP * scale);
        let (area, response) = ui.allocate_exact_size(size, Sense::hover());
        named(
            &response,
            egui::Role::Image,
            &format!("Strip of {}", strip.name),
        );
        let field = area.with_min_y(area.top() + above);
        let painter = ui.painter();
        painter.rect_filled(field, 0.0, grey(super::bench::ROOM));
        columns(painter, field, &strip.colours.rgb);
        let taken = painter.text(
            area.left_top(),
            Align2::LEFT_TOP,
            &strip.name,
            font.clone(),
            ink,
        );
        marks(painter, field, strip, axis, (&font, theme.faint, taken));
        let pointed = response.hover_pos().filter(|at| field.contains(*at));
        if let Some(at) = pointed {
            let share = f64::from((at.x - field.left()) / field.width());
            let value = axis.ends[0] + share * (axis.ends[1] - axis.ends[0]);
            let words = format!("{value:.2} {}", axis.label);
            response.on_hover_text_at_pointer(words);
        }
    }
    if !strips.is_empty() {
        ticks(ui, axis, &font, theme);
    }
}

/// A box for each column.
fn columns(painter: &Painter, field: Rect, rgb: &[[u8; 3]]) {
    let mut mesh = Mesh::default();
    let width = field.width() / rgb.len().max(1) as f32;
    for (index, [r, g, b]) in rgb.iter().enumerate() {
        let left = field.left() + width * index as f32;
        let column = Rect::from_x_y_ranges(left..=left + width, field.y_range());
        mesh.add_colored_rect(column, Color32::from_rgb(*r, *g, *b));
    }
    painter.add(mesh);
}

/// Names of lines above the strip, each with a stroke to its place; those without room are left
/// out, for the table has them.
fn marks(
    painter: &Painter,
    field: Rect,
    strip: &StripShown,
    axis: &Axis<'_>,
    (font, ink, title): (&FontId, Color32, Rect),
) {
    let mut taken = vec![title];
    let [from, to] = axis.ends;
    for (value, name) in &strip.marks {
        let share = ((value - from) / (to - from)) as f32;
        let x = field.left() + share * field.width();
        if !(0.0..=1.0).contains(&share) {
            continue;
        }
        let galley = painter.layout_no_wrap(name.clone(), font.clone(), ink);
        let size = galley.size();
        let left =
            (x - 0.5 * size.x).clamp(field.left(), (field.right() - size.x).max(field.left()));
        let place = (0..NAME_ROWS).rev().map(|row| {
            let top = field.top() - (NAME_ROWS - row) as f32 * size.y - 1.0;
            Rect::from_min_size(pos2(left, top), size)
        });
        let free = |place: &Rect| {
            taken
                .iter()
                .all(|other| !other.intersects(place.expand2(vec2(4.0, -1.0))))
        };
        if let Some(place) = place.into_iter().find(free) {
            painter.vline(x, place.bottom() - 2.0..=field.top(), (1.0, ink));
            painter.galley(place.min, galley, ink);
            taken.push(place);
        }
    }
}

/// Numbers below the strips.
fn ticks(ui: &mut Ui, axis: &Axis<'_>, font: &FontId, theme: Theme) {
    let size = vec2(ui.available_width(), 18.0 * theme.scale);
    let (area, _) = ui.allocate_exact_size(size, Sense::hover());
    let painter = ui.painter();
    let [from, to] = axis.ends;
    let label = painter.layout_no_wrap(axis.label.to_owned(), font.clone(), theme.faint);
    let label_left = area.right() - label.size().x;
    let step = step_of((to - from) / 10.0);
    let mut value = (from / step).ceil() * step;
    while value <= to {
        let x = area.left() + ((value - from) / (to - from)) as f32 * area.width();
        painter.vline(x, area.top()..=area.top() + 4.0, (1.0, theme.faint));
        // Nothing is written over the label, and nothing is cut.
        if x > area.left() + 10.0 && x < label_left - 24.0 {
            let words = short((value / step).round() * step);
            let at = pos2(x, area.top() + 4.0);
            painter.text(at, Align2::CENTER_TOP, words, font.clone(), theme.faint);
        }
        value += step;
    }
    let at = pos2(label_left, area.top() + 4.0);
    painter.galley(at, label, theme.faint);
}

/// The round step at or above a size: 1, 2 or 5 of its decade.
fn step_of(size: f64) -> f64 {
    let decade = 10.0_f64.powf(size.max(1e-9).log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0].map(|step| step * decade);
    steps
        .into_iter()
        .find(|step| *step >= size)
        .unwrap_or(steps[3])
}
