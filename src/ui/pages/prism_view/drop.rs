//! A drop of water in section, with rays of the light.

use eframe::egui;
use egui::{Color32, Sense, Shape, Stroke, Ui, Vec2, pos2, vec2};

use crate::{
    app::dispersion::{DropDrawing, DropRay},
    ui::{
        kit,
        theme::{Theme, grey},
    },
};

/// What is seen to each side of the drop's middle, radii.
const SEEN: f32 = 1.5;

/// Draws the drop; where a hand moved the rays to, radii off its middle.
pub(super) fn show(ui: &mut Ui, drawing: &DropDrawing, size: Vec2, theme: Theme) -> Option<f64> {
    let name = said!("A drop with rays of the light");
    let (area, response) = kit::drawing(ui, size, Sense::drag(), name);
    let painter = ui.painter().with_clip_rect(area);
    painter.rect_filled(area, 0.0, grey(super::bench::ROOM));
    let scale = 0.5 * size.min_elem() / SEEN;
    let middle = area.center();
    painter.circle_filled(middle, scale, Color32::from_rgb(34, 40, 46));
    // Rays of the smooth part lie on one another: their colours add up to the light's.
    let draw = |ray: &DropRay, wide: f32, adds: bool| {
        let at = |[x, y]: [f64; 2]| middle + scale * vec2(x as f32, -y as f32);
        let way: Vec<_> = ray.way.iter().map(|place| at(*place)).collect();
        let [r, g, b] = ray.rgb;
        let ink = Color32::from_rgb(r, g, b).gamma_multiply(ray.strength as f32);
        let ink = if adds { ink.additive() } else { ink };
        painter.add(Shape::line(way, Stroke::new(wide * theme.scale, ink)));
    };
    drawing.fan.iter().for_each(|ray| draw(ray, 0.8, false));
    drawing.smooth.iter().for_each(|ray| draw(ray, 1.0, true));
    drawing.lines.iter().for_each(|ray| draw(ray, 1.6, false));
    painter.circle_stroke(middle, scale, (1.2 * theme.scale, grey(150)));
    let hand = middle + scale * vec2(-SEEN + 0.12, -drawing.impact as f32);
    let is_held = response.hovered() || response.dragged();
    super::bench::knob(&painter, hand, is_held, theme);
    let corner = pos2(area.left() + 8.0, area.top() + 6.0);
    let said = said!("light from the left; thin: all of 555 nm");
    let words = (corner, egui::Align2::LEFT_TOP, said, grey(140));
    super::bench::write(ui, &painter, words, &mut Vec::new());
    if response.hovered() {
        ui.set_cursor_icon(egui::CursorIcon::ResizeVertical);
    }
    let moved = f64::from(-response.drag_delta().y / scale);
    response.on_hover_text_at_pointer(said!("Drag up and down: where the light meets the drop."));
    (moved != 0.0).then_some(drawing.impact + moved)
}
