//! The bench drawn: a dark room, a prism, the light on its way to the strip below.

use eframe::egui;
use egui::{Color32, Mesh, Painter, Pos2, Rect, Sense, Shape, Stroke, Ui, Vec2, pos2, vec2};

use crate::{
    app::{
        chart::Rgb,
        dispersion::{BenchDrawing, DrawnRay, Grip, Leaves},
        pages::Handle,
    },
    languages::fixed,
    ui::{
        kit::{self, named},
        theme::{Theme, grey},
    },
};

/// Degrees that the prism turns by for each point that a hand moves.
const DEGREES_A_POINT: f32 = 0.08;

/// Free space around prism and slit, points.
const MARGIN: f32 = 26.0;

/// Where in the room the ray leaves that is bent most, as shares of its width and height.
const LEAVES_AT: Vec2 = vec2(0.45, 0.56);

/// Width of a handle, points.
const HANDLE: f32 = 12.0;

/// Least width of a beam whose edges are drawn, points.
const WIDE_BEAM: f32 = 3.0;

/// How dark the room is: colours of light are seen against it in both themes.
pub(super) const ROOM: u8 = 16;

/// From millimetres to the window. The ray that is bent most is drawn as it leaves; the angles of
/// the others to it are larger than they are, so that each ends at its place of the strip below.
struct Mapping<'a> {
    area: Rect,
    /// Where that ray leaves the glass, in the window and in the drawing, mm.
    middle: Pos2,
    origin: [f64; 2],
    scale: f64,
    /// Sine and cosine of how far the drawing is turned, with the clock.
    turn: [f64; 2],
    /// How far from the left end of the strip a place on the screen is, 0-1.
    share: &'a dyn Fn(f64) -> f32,
}

impl<'a> Mapping<'a> {
    fn new(drawing: &BenchDrawing, area: Rect, share: &'a dyn Fn(f64) -> f32) -> Self {
        let mut mapping = Self {
            area,
            middle: area.center(),
            origin: drawing.prism[0],
            scale: 1.0,
            turn: [0.0, 1.0],
            share,
        };
        if let Some(ray) = drawing.most_bent {
            mapping.middle = area.lerp_inside(LEAVES_AT);
            mapping.origin = ray.exit;
            let way = (mapping.on_screen(ray.x_mm) - mapping.middle).normalized();
            mapping.turn = [f64::from(-way.x), f64::from(way.y)];
        }
        // As large as there is room for on each side of where it stands.
        let places = drawing.prism.iter().chain(drawing.jaws.iter().flatten());
        let room = area.shrink(MARGIN);
        let middle = mapping.middle;
        let fits = places.flat_map(|place| {
            let off = mapping.at(*place) - middle;
            let side = |off: f32, low: f32, high: f32| {
                let room = if off < 0.0 { low } else { high };
                f64::from(room.max(1.0) / off.abs().max(0.1))
            };
            [
                side(off.x, middle.x - room.left(), room.right() - middle.x),
                side(off.y, middle.y - room.top(), room.bottom() - middle.y),
            ]
        });
        let most = f64::from(0.42 * area.height()) / drawing.side_mm();
        mapping.scale = fits.fold(most, f64::min);
        mapping
    }

    fn at(&self, [x, y]: [f64; 2]) -> Pos2 {
        let [across, down] = [x - self.origin[0], self.origin[1] - y].map(|v| v * self.scale);
        self.middle + self.turned([across, down])
    }

    /// A vector of the drawing, downwards, in the window.
    fn turned(&self, [x, y]: [f64; 2]) -> Vec2 {
        let [sin, cos] = self.turn;
        vec2((x * cos - y * sin) as f32, (x * sin + y * cos) as f32)
    }

    /// What lies so many points to the right of and below a place.
    fn moved(&self, [x, y]: [f64; 2], by: Vec2) -> [f64; 2] {
        let [sin, cos] = self.turn;
        let [right, down] = [by.x, by.y].map(|v| f64::from(v) / self.scale);
        [x + right * cos + down * sin, y + right * sin - down * cos]
    }

    fn on_screen(&self, x_mm: f64) -> Pos2 {
        let x = self.area.left() + (self.share)(x_mm) * self.area.width();
        pos2(x, self.area.bottom())
    }

    /// Where a ray ends that goes on from its last place.
    fn end(&self, from: [f64; 2], leaves: Leaves) -> Pos2 {
        match leaves {
            Leaves::To(x_mm) => self.on_screen(x_mm),
            Leaves::Away([x, y]) => {
                let far = self.area.width() + self.area.height();
                self.at(from) + far * self.turned([x, -y])
            }
        }
    }

    /// The ray over its places in the window.
    fn ray(&self, way: &[[f64; 2]], leaves: Leaves) -> Vec<Pos2> {
        let mut places: Vec<Pos2> = way.iter().map(|place| self.at(*place)).collect();
        places.extend(way.last().map(|last| self.end(*last, leaves)));
        places
    }

    /// How many times the spread behind the prism is drawn; `None` without light there.
    fn stretch(&self, drawing: &BenchDrawing) -> Option<f64> {
        let ray = drawing.most_bent?;
        let angle = |to: Pos2| f64::from((to - self.middle).angle());
        let drawn = angle(self.on_screen(ray.x_mm)) - angle(self.area.right_bottom());
        let stretch = drawn.to_degrees() / ray.spread_deg;
        stretch.is_finite().then_some(stretch)
    }
}

/// What a hand did to the bench in a frame.
pub(super) enum Moved {
    /// It turned the prism, degrees.
    Turned(f64),
    /// It moved a handle, to degrees or mm.
    Set(Handle, f64),
}

/// Draws the bench above its strip, on which `share` tells how far from the left end a place is;
/// what a hand did to it in this frame.
pub(super) fn show(
    ui: &mut Ui,
    drawing: Option<&BenchDrawing>,
    size: Vec2,
    (share, theme): (&dyn Fn(f64) -> f32, Theme),
) -> Option<Moved> {
    let name = said!("Drawing of the prism and the light");
    let (area, response) = kit::drawing(ui, size, Sense::drag(), name);
    let painter = ui.painter().with_clip_rect(area.intersect(ui.clip_rect()));
    painter.rect_filled(area, 0.0, grey(ROOM));
    let drawing = drawing?;
    let mapping = Mapping::new(drawing, area, share);
    light(&painter, drawing, &mapping, theme);
    let turned = response.drag_delta().x * DEGREES_A_POINT;
    if response.hovered() {
        ui.set_cursor_icon(egui::CursorIcon::ResizeHorizontal);
    }
    response.on_hover_text_at_pointer(said!("Drag to turn the prism."));
    let mut moved = (turned != 0.0).then_some(Moved::Turned(f64::from(turned)));
    let mut taken = Vec::new();
    for grip in &drawing.grips {
        let at = (grip, mapping.at(grip.at));
        if let Some(by) = handle(ui, &painter, at, (theme, &mut taken)) {
            let to = drawing.dragged(grip.handle, mapping.moved(grip.at, by));
            moved = Some(Moved::Set(grip.handle, to));
        }
    }
    if let Some(stretch) = mapping.stretch(drawing) {
        let hint = tr!(
            "The spread is drawn {stretch} times as wide.",
            stretch = fixed(stretch, 0)
        );
        let at = area.right_top() + vec2(-8.0, 6.0);
        write(
            ui,
            &painter,
            (at, egui::Align2::RIGHT_TOP, &hint, grey(140)),
            &mut taken,
        );
    }
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
    named(
        &response,
        egui::Role::Slider,
        &tr!("{handle}, drawn", handle = title),
    );
    let is_held = response.hovered() || response.dragged();
    knob(painter, at, is_held, theme);
    let away = 0.7 * HANDLE * theme.scale;
    let (beside, align) = match grip.handle {
        // Below it the light passes.
        Handle::Slit => (at - vec2(away, 0.0), egui::Align2::RIGHT_CENTER),
        Handle::Apex => (at + vec2(0.0, away), egui::Align2::CENTER_TOP),
    };
    let words = (beside, align, &*grip.words, grey(190));
    write(ui, painter, words, taken);
    let by = response.drag_delta();
    if is_held {
        ui.set_cursor_icon(egui::CursorIcon::Grab);
    }
    response.on_hover_text(tr!("{handle}: drag.", handle = title));
    (by != Vec2::ZERO).then_some(by)
}

/// What a hand can take.
pub(super) fn knob(painter: &Painter, at: Pos2, is_held: bool, theme: Theme) {
    let fill = if is_held { grey(235) } else { grey(90) };
    let stroke = Stroke::new(1.5 * theme.scale, grey(220));
    painter.circle(at, 0.5 * HANDLE * theme.scale, fill, stroke);
}

fn light(painter: &Painter, drawing: &BenchDrawing, mapping: &Mapping<'_>, theme: Theme) {
    let corners = drawing.prism.map(|corner| mapping.at(corner)).to_vec();
    let glass = Color32::from_rgb(38, 42, 46);
    painter.add(Shape::convex_polygon(corners.clone(), glass, Stroke::NONE));
    incoming(painter, drawing, mapping, theme);
    let mut mesh = Mesh::default();
    for pair in drawing.smooth.windows(2) {
        for part in 0..2 {
            band(&mut mesh, mapping, &pair[0], &pair[1], part);
        }
    }
    painter.add(mesh);
    let reflected = |ray: &&DrawnRay| matches!(ray.leaves, Leaves::Away(_));
    for ray in drawing.smooth.iter().filter(reflected) {
        let stroke = Stroke::new(theme.scale, colour(ray.rgb, 0.25 * ray.strength));
        painter.add(Shape::line(mapping.ray(&ray.way, ray.leaves), stroke));
    }
    let wide = (drawing.slit_mm * mapping.scale) as f32;
    for ray in &drawing.lines {
        let stroke = Stroke::new(1.6 * theme.scale, colour(ray.rgb, ray.strength));
        if let Some(edges) = ray.edges.filter(|_| wide > WIDE_BEAM) {
            edge_rays(painter, mapping, edges, colour(ray.rgb, 0.5 * ray.strength));
        }
        painter.add(Shape::line(mapping.ray(&ray.way, ray.leaves), stroke));
    }
    let edge = Stroke::new(1.2 * theme.scale, grey(150));
    painter.add(Shape::closed_line(corners, edge));
}

/// The light before the prism: as wide as the lamp before the slit, as wide as the slit behind it.
fn incoming(painter: &Painter, drawing: &BenchDrawing, mapping: &Mapping<'_>, theme: Theme) {
    let [enters, along] = drawing.enters;
    let to = mapping.at(enters);
    let far = mapping.area.width() + mapping.area.height();
    let from = to - far * mapping.turned([along[0], -along[1]]);
    let wide = (drawing.slit_mm * mapping.scale) as f32;
    let beam = wide.max(2.5 * theme.scale);
    let strength = if wide > WIDE_BEAM { 0.45 } else { 1.0 };
    let jaws = drawing.jaws.map(|jaw| jaw.map(|place| mapping.at(place)));
    let slit_at = jaws[0][0] + 0.5 * (jaws[1][0] - jaws[0][0]);
    let lamp = Stroke::new(beam + 8.0 * theme.scale, colour(drawing.rgb, 0.25));
    painter.line_segment([from, slit_at], lamp);
    painter.line_segment([slit_at, to], (beam, colour(drawing.rgb, strength)));
    for jaw in jaws {
        painter.line_segment(jaw, (3.0 * theme.scale, grey(170)));
    }
}

/// The rays through both edges of the slit, and what they enclose.
fn edge_rays(
    painter: &Painter,
    mapping: &Mapping<'_>,
    edges: [([[f64; 2]; 2], f64); 2],
    ink: Color32,
) {
    let [a, b] = edges.map(|(way, x_mm)| mapping.ray(&way, Leaves::To(x_mm)));
    for part in 0..2 {
        let between = vec![a[part], a[part + 1], b[part + 1], b[part]];
        let fill = ink.gamma_multiply(0.35);
        painter.add(Shape::convex_polygon(between, fill, Stroke::NONE));
    }
    for way in [a, b] {
        painter.add(Shape::line(way, Stroke::new(0.8, ink)));
    }
}

/// What lies between two neighbouring rays of the smooth part, in the glass (0) or behind it (1).
fn band(mesh: &mut Mesh, mapping: &Mapping<'_>, a: &DrawnRay, b: &DrawnRay, part: usize) {
    let [one, other] = [a, b].map(|ray| match ray.leaves {
        Leaves::To(_) => mapping.ray(&ray.way, ray.leaves),
        Leaves::Away(_) => Vec::new(),
    });
    let corners = [
        (a, one.get(part)),
        (a, one.get(part + 1)),
        (b, other.get(part + 1)),
        (b, other.get(part)),
    ];
    if corners.iter().any(|(_, place)| place.is_none()) {
        return;
    }
    let first = mesh.vertices.len() as u32;
    for (ray, place) in corners {
        // A glow behind the lines, not beside them.
        let ink = colour(ray.rgb, 0.55 * ray.strength);
        mesh.colored_vertex(place.copied().unwrap_or_default(), ink);
    }
    mesh.add_triangle(first, first + 1, first + 2);
    mesh.add_triangle(first, first + 2, first + 3);
}

fn colour([r, g, b]: Rgb, strength: f64) -> Color32 {
    Color32::from_rgb(r, g, b).gamma_multiply(strength as f32)
}
