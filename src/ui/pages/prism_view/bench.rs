//! The bench drawn: a dark room, a prism, the light on its way.

use eframe::egui;
use egui::{Color32, Mesh, Painter, Pos2, Rect, Sense, Shape, Stroke, Ui, Vec2, pos2, vec2};

use crate::{
    app::{
        chart::Rgb,
        dispersion::{BenchDrawing, DrawnRay, Grip},
        pages::Handle,
    },
    ui::{
        kit::{self, named},
        theme::{Theme, grey},
    },
};

/// Degrees that the prism turns by for each point that a hand moves.
const DEGREES_A_POINT: f32 = 0.08;

/// Free space around the drawing, points.
const MARGIN: f32 = 14.0;

/// Width of a handle, points.
const HANDLE: f32 = 10.0;

/// Least width of a beam whose edges are drawn, points.
const WIDE_BEAM: f32 = 3.0;

/// How dark the room is: colours of light are seen against it in both themes.
pub(super) const ROOM: u8 = 16;

/// From millimetres to the screen.
struct Mapping {
    corner: Pos2,
    low: [f64; 2],
    scale: f64,
}

impl Mapping {
    fn new(drawing: &BenchDrawing, area: Rect) -> Self {
        // Rays that graze the screen far out are cut.
        let mut places = drawing.prism.to_vec();
        places.extend(drawing.incoming);
        places.extend(drawing.screen);
        let range = |k: usize| {
            let values = places.iter().map(|place| place[k]);
            values.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], v| {
                [a.min(v), b.max(v)]
            })
        };
        let ranges = [range(0), range(1)];
        let size = ranges.map(|[a, b]| (b - a).max(1e-9));
        let room = area.size() - Vec2::splat(2.0 * MARGIN);
        let scale = (f64::from(room.x) / size[0]).min(f64::from(room.y) / size[1]);
        let drawn = vec2((size[0] * scale) as f32, (size[1] * scale) as f32);
        Self {
            corner: area.center() - 0.5 * drawn + vec2(0.0, drawn.y),
            low: [ranges[0][0], ranges[1][0]],
            scale,
        }
    }

    /// What lies so many points to the right of and below a place.
    fn moved(&self, [x, y]: [f64; 2], by: Vec2) -> [f64; 2] {
        let [right, down] = [by.x, by.y].map(|v| f64::from(v) / self.scale);
        [x + right, y - down]
    }

    fn at(&self, [x, y]: [f64; 2]) -> Pos2 {
        let [across, up] = [x - self.low[0], y - self.low[1]].map(|v| (v * self.scale) as f32);
        pos2(self.corner.x + across, self.corner.y - up)
    }
}

/// What a hand did to the bench in a frame.
pub(super) enum Moved {
    /// It turned the prism, degrees.
    Turned(f64),
    /// It moved a handle, to degrees or mm.
    Set(Handle, f64),
}

/// Draws the bench; what a hand did to it in this frame.
pub(super) fn show(
    ui: &mut Ui,
    drawing: Option<&BenchDrawing>,
    size: Vec2,
    theme: Theme,
) -> Option<Moved> {
    let name = "Drawing of the prism and the light";
    let (area, response) = kit::drawing(ui, size, Sense::drag(), name);
    let painter = ui.painter().with_clip_rect(area);
    painter.rect_filled(area, 3.0, grey(ROOM));
    let drawing = drawing?;
    let mapping = Mapping::new(drawing, area);
    light(&painter, drawing, &mapping, theme);
    let hint = "Angles are exact; the screen is drawn nearer than it is.";
    let turned = response.drag_delta().x * DEGREES_A_POINT;
    if response.hovered() {
        ui.set_cursor_icon(egui::CursorIcon::ResizeHorizontal);
    }
    response.on_hover_text_at_pointer("Drag to turn the prism.");
    let mut moved = (turned != 0.0).then_some(Moved::Turned(f64::from(turned)));
    let mut taken = Vec::new();
    for grip in &drawing.grips {
        let at = (grip, mapping.at(grip.at));
        if let Some(by) = handle(ui, &painter, at, (theme, &mut taken)) {
            let to = drawing.dragged(grip.handle, mapping.moved(grip.at, by));
            moved = Some(Moved::Set(grip.handle, to));
        }
    }
    let at = area.left_bottom() + vec2(8.0, -6.0);
    write(
        ui,
        &painter,
        (at, egui::Align2::LEFT_BOTTOM, hint, grey(140)),
        &mut taken,
    );
    moved
}

/// Writes words in small type where there is room for them: whole, and over no others.
pub(super) fn write(
    ui: &Ui,
    painter: &Painter,
    (at, align, words, ink): (Pos2, egui::Align2, &str, Color32),
    taken: &mut Vec<Rect>,
) {
    let font = egui::TextStyle::Small.resolve(ui.style());
    let galley = painter.layout_no_wrap(words.to_owned(), font, ink);
    let place = align.anchor_size(at, galley.size());
    let is_free = taken.iter().all(|other| !other.intersects(place));
    if is_free && painter.clip_rect().contains_rect(place) {
        painter.galley(place.min, galley, ink);
        taken.push(place);
    }
}

/// Draws a handle with what it is set to; how far a hand moved it.
fn handle(
    ui: &Ui,
    painter: &Painter,
    (grip, at): (&Grip, Pos2),
    (theme, taken): (Theme, &mut Vec<Rect>),
) -> Option<Vec2> {
    let title = grip.handle.title();
    let area = Rect::from_center_size(at, Vec2::splat(2.4 * HANDLE * theme.scale));
    let response = ui.interact(area, ui.scope_id().with(title), Sense::drag());
    named(&response, egui::Role::Slider, &format!("{title}, drawn"));
    let is_held = response.hovered() || response.dragged();
    knob(painter, at, is_held, theme);
    let beside = 0.7 * HANDLE * theme.scale;
    // Light comes from below the screen's handle.
    let (at, align) = match grip.handle {
        Handle::Screen => (at + vec2(beside, 0.0), egui::Align2::LEFT_CENTER),
        Handle::Apex | Handle::Slit => (at + vec2(0.0, beside), egui::Align2::CENTER_TOP),
    };
    write(ui, painter, (at, align, &grip.words, grey(190)), taken);
    let by = response.drag_delta();
    if is_held {
        ui.set_cursor_icon(egui::CursorIcon::Grab);
    }
    response.on_hover_text(format!("{title}: drag."));
    (by != Vec2::ZERO).then_some(by)
}

/// What a hand can take.
pub(super) fn knob(painter: &Painter, at: Pos2, is_held: bool, theme: Theme) {
    let fill = if is_held { grey(235) } else { grey(90) };
    let stroke = Stroke::new(1.5 * theme.scale, grey(220));
    painter.circle(at, 0.5 * HANDLE * theme.scale, fill, stroke);
}

fn light(painter: &Painter, drawing: &BenchDrawing, mapping: &Mapping, theme: Theme) {
    let corners = drawing.prism.map(|corner| mapping.at(corner)).to_vec();
    let glass = Color32::from_rgb(38, 42, 46);
    painter.add(Shape::convex_polygon(corners.clone(), glass, Stroke::NONE));
    let [from, to] = drawing.incoming.map(|place| mapping.at(place));
    let wide = (drawing.slit_mm * mapping.scale) as f32;
    let beam = wide.max(2.5 * theme.scale);
    let strength = if wide > WIDE_BEAM { 0.45 } else { 1.0 };
    let jaws = drawing.jaws.map(|jaw| jaw.map(|place| mapping.at(place)));
    let slit_at = jaws[0][0] + 0.5 * (jaws[1][0] - jaws[0][0]);
    // As wide as the lamp before the slit, as wide as the slit behind it.
    let lamp = Stroke::new(beam + 8.0 * theme.scale, colour(drawing.rgb, 0.25));
    painter.line_segment([from, slit_at], lamp);
    painter.line_segment([slit_at, to], (beam, colour(drawing.rgb, strength)));
    for jaw in jaws {
        painter.line_segment(jaw, (3.0 * theme.scale, grey(170)));
    }
    let mut mesh = Mesh::default();
    for pair in drawing.smooth.windows(2) {
        for part in 0..2 {
            band(&mut mesh, mapping, &pair[0], &pair[1], part);
        }
    }
    painter.add(mesh);
    for ray in &drawing.lines {
        let stroke = Stroke::new(1.6 * theme.scale, colour(ray.rgb, ray.strength));
        if let Some(edges) = ray.edges.filter(|_| wide > WIDE_BEAM) {
            edge_rays(painter, mapping, edges, colour(ray.rgb, 0.5 * ray.strength));
        }
        let points = ray.at.map(|place| mapping.at(place)).to_vec();
        painter.add(Shape::line(points, stroke));
    }
    let edge = Stroke::new(1.2 * theme.scale, grey(150));
    painter.add(Shape::closed_line(corners, edge));
    let screen = drawing.screen.map(|place| mapping.at(place));
    painter.line_segment(screen, (2.0 * theme.scale, grey(190)));
}

/// The rays through both edges of the slit, and what they enclose.
fn edge_rays(painter: &Painter, mapping: &Mapping, edges: [[[f64; 2]; 3]; 2], ink: Color32) {
    let [a, b] = edges.map(|way| way.map(|place| mapping.at(place)));
    for part in 0..2 {
        let between = vec![a[part], a[part + 1], b[part + 1], b[part]];
        let fill = ink.gamma_multiply(0.35);
        painter.add(Shape::convex_polygon(between, fill, Stroke::NONE));
    }
    for way in [a, b] {
        painter.add(Shape::line(way.to_vec(), Stroke::new(0.8, ink)));
    }
}

/// What lies between two neighbouring rays of the smooth part, in the glass (0) or behind it (1).
fn band(mesh: &mut Mesh, mapping: &Mapping, a: &DrawnRay, b: &DrawnRay, part: usize) {
    let first = mesh.vertices.len() as u32;
    for (ray, end) in [(a, part), (a, part + 1), (b, part + 1), (b, part)] {
        // A glow behind the lines, not beside them.
        mesh.colored_vertex(
            mapping.at(ray.at[end]),
            colour(ray.rgb, 0.55 * ray.strength),
        );
    }
    mesh.add_triangle(first, first + 1, first + 2);
    mesh.add_triangle(first, first + 2, first + 3);
}

fn colour([r, g, b]: Rgb, strength: f64) -> Color32 {
    Color32::from_rgb(r, g, b).gamma_multiply(strength as f32)
}
