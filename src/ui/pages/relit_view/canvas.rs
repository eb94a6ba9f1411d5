//! The picture as two halves with a line to drag between them, or as a map with its scale.

use eframe::egui;
use egui::{
    Align2, Color32, FontId, Key, Painter, Pos2, Rect, Sense, Stroke, StrokeKind, TextStyle,
    TextureId, Ui, Vec2, pos2, vec2,
};

use crate::{
    app::{
        chart::ramp_colour,
        relit::{NAMED, place_of},
        ticks::short,
    },
    ui::{
        kit::{hold_arrows, named},
        theme::{Theme, ink},
    },
};

pub(super) struct Drawn<'a> {
    /// Its name for screen readers.
    pub name: &'a str,
    /// Columns and rows.
    pub pixels: [usize; 2],
    /// Every band and few numbers, or the map alone.
    pub textures: &'a [TextureId],
    /// What stands over each half.
    pub labels: [&'a str; 2],
    /// The pixel that is marked.
    pub marked: Option<[usize; 2]>,
}

/// What a hand did.
#[derive(Default)]
pub(super) struct Touched {
    /// The pixel under the pointer.
    pub pointed: Option<[usize; 2]>,
    /// The pixel that was clicked.
    pub clicked: Option<[usize; 2]>,
}

/// How far an arrow key moves the line.
const KEY_STEP: f32 = 0.02;

/// Draws the picture as large as the room allows; `split` is where its halves meet, 0-1.
pub(super) fn show(
    ui: &mut Ui,
    room: Vec2,
    drawn: &Drawn<'_>,
    split: &mut f32,
    theme: Theme,
) -> Touched {
    let [width, height] = drawn.pixels.map(|side| side.max(1) as f32);
    let scale = (room.x / width).min(room.y / height).max(0.0);
    let size = vec2(width, height) * scale;
    let (field, _) = ui.allocate_exact_size(room, Sense::hover());
    let area = Rect::from_min_size(field.min, size);
    let id = ui.scope_id().with("picture in few numbers");
    let response = ui.interact(area, id, Sense::click_and_drag());
    named(&response, egui::Role::Image, drawn.name);
    let pixel = |at: Pos2| {
        let place = (at - area.min) / scale;
        let whole = |v: f32, count: usize| (v.max(0.0) as usize).min(count - 1);
        [
            whole(place.x, drawn.pixels[0]),
            whole(place.y, drawn.pixels[1]),
        ]
    };
    let is_split = drawn.textures.len() > 1;
    let mut touched = Touched::default();
    let inside = response.hover_pos().filter(|at| area.contains(*at));
    touched.pointed = inside.map(pixel);
    if response.clicked() {
        response.request_focus();
        touched.clicked = response.interact_pointer_pos().map(pixel);
    }
    if is_split {
        if let Some(at) = response
            .interact_pointer_pos()
            .filter(|_| response.dragged())
        {
            *split = ((at.x - area.left()) / area.width()).clamp(0.0, 1.0);
        }
        move_by_keys(ui, &response, split);
    }
    let painter = ui.painter().with_clip_rect(area);
    paint(&painter, area, drawn.textures, *split);
    if let Some([x, y]) = drawn.marked {
        let at = area.min + vec2(x as f32 + 0.5, y as f32 + 0.5) * scale;
        for (width, colour) in [(3.0, Color32::BLACK), (1.2, Color32::WHITE)] {
            painter.circle_stroke(at, 6.0 * theme.scale, Stroke::new(width, colour));
        }
    }
    if is_split {
        let x = area.left() + *split * area.width();
        handle(&painter, pos2(x, area.center().y), area, theme);
        let font = TextStyle::Body.resolve(ui.style());
        label(&painter, area, drawn.labels, x, &font);
    }
    if response.has_focus() {
        let stroke = ui.visuals().widgets.active.bg_stroke;
        painter.rect_stroke(area, 2.0, stroke, StrokeKind::Inside);
    }
    touched
}

/// The arrow keys move the line.
fn move_by_keys(ui: &Ui, response: &egui::Response, split: &mut f32) {
    if !response.has_focus() {
        return;
    }
    hold_arrows(ui, response.id, false);
    let pressed = |key| ui.input(|i| i.num_presses(key)) as f32;
    let steps = pressed(Key::ArrowRight) - pressed(Key::ArrowLeft);
    *split = (*split + KEY_STEP * steps).clamp(0.0, 1.0);
}

fn paint(painter: &Painter, area: Rect, textures: &[TextureId], split: f32) {
    let part = |texture: &TextureId, from: f32, to: f32| {
        let x = |share: f32| area.left() + share * area.width();
        let place = Rect::from_min_max(pos2(x(from), area.top()), pos2(x(to), area.bottom()));
        let uv = Rect::from_min_max(pos2(from, 0.0), pos2(to, 1.0));
        painter.image(*texture, place, uv, Color32::WHITE);
    };
    match textures {
        [left, right, ..] => {
            part(left, 0.0, split);
            part(right, split, 1.0);
        }
        [one] => part(one, 0.0, 1.0),
        [] => {}
    }
}

/// The line between both halves with a grip.
fn handle(painter: &Painter, at: Pos2, area: Rect, theme: Theme) {
    for (width, colour) in [(3.5, Color32::BLACK), (1.5, Color32::WHITE)] {
        painter.vline(at.x, area.y_range(), Stroke::new(width, colour));
    }
    let radius = 11.0 * theme.scale;
    painter.circle(at, radius, Color32::WHITE, Stroke::new(1.5, Color32::BLACK));
    for side in [-1.0, 1.0] {
        let tip = at + vec2(side * 0.62 * radius, 0.0);
        let back = side * 0.36 * radius;
        let points = [[0.0, 0.0], [-back, -0.36 * radius], [-back, 0.36 * radius]];
        let points = points.map(|[x, y]| tip + vec2(x, y)).to_vec();
        painter.add(egui::Shape::convex_polygon(
            points,
            Color32::BLACK,
            Stroke::NONE,
        ));
    }
}

/// Words over both halves, as far as there is room.
fn label(painter: &Painter, area: Rect, labels: [&str; 2], x: f32, font: &FontId) {
    let inset = vec2(8.0, 4.0);
    for (words, left) in labels.into_iter().zip([true, false]) {
        let galley = painter.layout_no_wrap(words.to_owned(), font.clone(), Color32::WHITE);
        let size = galley.size() + 2.0 * inset;
        let room = if left {
            x - area.left()
        } else {
            area.right() - x
        };
        if room < size.x + 16.0 {
            continue;
        }
        let corner = if left {
            area.left_top() + vec2(8.0, 8.0)
        } else {
            pos2(area.right() - 8.0 - size.x, area.top() + 8.0)
        };
        painter.rect_filled(
            Rect::from_min_size(corner, size),
            3.0,
            Color32::from_black_alpha(170),
        );
        painter.galley(corner + inset, galley, Color32::WHITE);
    }
}

/// Height of the scale, points.
pub(super) const SCALE_HEIGHT: f32 = 34.0;

/// The colours of differences with the numbers that they stand for.
pub(super) fn scale(ui: &mut Ui, width: f32, theme: Theme) {
    let size = vec2(width, SCALE_HEIGHT * theme.scale);
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    let bar = rect
        .with_max_y(rect.top() + 12.0 * theme.scale)
        .shrink2(vec2(18.0, 0.0));
    let steps = 96;
    for step in 0..steps {
        let x = |i: usize| bar.left() + bar.width() * i as f32 / steps as f32;
        let colour = ink(ramp_colour((step as f64 + 0.5) / f64::from(steps as u32)));
        let part = Rect::from_x_y_ranges(x(step)..=x(step + 1), bar.y_range());
        ui.painter().rect_filled(part, 0.0, colour);
    }
    let font = TextStyle::Small.resolve(ui.style());
    let last = NAMED.len() - 1;
    for (i, off) in NAMED.into_iter().enumerate() {
        let x = bar.left() + bar.width() * place_of(off) as f32;
        let words = match i {
            0 => "ΔE₀₀ 0".to_owned(),
            _ if i == last => tr!("{difference} and more", difference = short(off)),
            _ => short(off),
        };
        let align = match i {
            0 => Align2::LEFT_TOP,
            _ if i == last => Align2::RIGHT_TOP,
            _ => Align2::CENTER_TOP,
        };
        let at = pos2(x, bar.bottom() + 3.0);
        ui.painter()
            .text(at, align, words, font.clone(), theme.faint);
    }
    response.on_hover_text(said!(
        "A difference below 1 is hard to see, from 1 to 2 it is seen side by side, from 2 on if \
         you look for it."
    ));
}
