//! The colour bar of a heat map.

use eframe::egui;
use egui::{Align2, Mesh, Rect, StrokeKind, TextStyle, Ui, pos2, vec2};

use super::{
    super::theme::{Theme, ink},
    edge,
};
use crate::app::plot_svg::{Cells, ramp_colour};

/// Distance to the panel, and width, points.
const GAP: f32 = 14.0;
const WIDTH: f32 = 14.0;

fn target(height: f32) -> usize {
    (height / 40.0).clamp(2.0, 9.0) as usize
}

/// The room that a bar takes beside a panel.
pub(super) fn room(ui: &Ui, cells: &Cells, height: f32) -> f32 {
    let ticks = cells.bar_ticks(target(height));
    let widths = ticks
        .iter()
        .map(|(_, t)| edge::width(ui, t, &TextStyle::Small));
    GAP + WIDTH + 6.0 + widths.fold(12.0, f32::max) + 4.0
}

/// Draws the bar at the right of a panel, its name over it.
pub(super) fn draw(ui: &Ui, cells: &Cells, frame: Rect, theme: Theme) {
    const STEPS: usize = 96;
    let bar = Rect::from_min_size(
        pos2(frame.right() + GAP, frame.top()),
        vec2(WIDTH, frame.height()),
    );
    let y = |part: f32| bar.bottom() - part * bar.height();
    let mut mesh = Mesh::default();
    for step in 0..STEPS {
        let [low, high] = [step, step + 1].map(|s| s as f32 / STEPS as f32);
        let rect = Rect::from_x_y_ranges(bar.x_range(), y(high)..=y(low));
        mesh.add_colored_rect(rect, ink(ramp_colour(f64::from((low + high) / 2.0))));
    }
    let painter = ui.painter();
    painter.add(mesh);
    let faint = theme.faint.gamma_multiply(0.6);
    painter.rect_stroke(bar, 0.0, (1.0, faint), StrokeKind::Outside);
    let font = TextStyle::Small.resolve(ui.style());
    let limits = cells.limits();
    for (tick, words) in cells.bar_ticks(target(frame.height())) {
        let at = pos2(bar.right(), y(cells.place(tick, limits) as f32));
        painter.line_segment([at, at + vec2(3.0, 0.0)], (1.0, faint));
        let corner = at + vec2(6.0, 0.0);
        painter.text(
            corner,
            Align2::LEFT_CENTER,
            words,
            font.clone(),
            theme.faint,
        );
    }
    let end = pos2(ui.max_rect().right(), frame.top() - edge::LIFT);
    let colour = ui.visuals().text_color();
    painter.text(end, Align2::RIGHT_BOTTOM, &cells.label, font, colour);
}
