//! Draws egui's triangles on the CPU, so that a view becomes a picture without window or GPU.
//!
//! The maths is that of egui's own shaders with dithering off:
//!
//! ```text
//! source = vertex colour * texel                  premultiplied, both in sRGB (gamma) values
//! target = source + target * (1 - source alpha)
//! ```
//!
//! A pixel belongs to a triangle when its centre lies inside, and a centre on an edge shared by
//! two triangles belongs to just one of them (the usual top-left rule): feathered outlines would
//! show seams otherwise. Vertices are first put on a grid of 1/256 pixel, as GPUs do. On that grid
//! every edge function is a whole number that `f64` holds exactly, so a row of a triangle is one
//! division per edge instead of three tests per pixel, and the same picture comes out everywhere.
//!
//! Paint callbacks (raw OpenGL) are not drawn; nothing in this program uses them.

use std::collections::HashMap;

use eframe::egui;
use egui::epaint::{ClippedPrimitive, ImageData, Mesh, Primitive, Vertex};
use egui::{
    Color32, ColorImage, Rect, TextureFilter, TextureId, TextureOptions, TextureWrapMode,
    TexturesDelta, Vec2,
};

/// Steps of the vertex grid in one pixel.
const SUBPIXELS: f64 = 256.0;

/// Time between two passes of [`picture`], in seconds: longer than any of egui's animations.
const PASS_SECONDS: f32 = 1.0;

/// Largest texture that a view may load in [`picture`], in texels a side.
const TEXTURE_SIDE: usize = 8192;

/// The textures of one egui context, and the means to draw its triangles with them.
#[derive(Default)]
pub struct Painter {
    textures: HashMap<TextureId, Texture>,
    /// Textures that the frame now on show still uses, but no later one.
    outgoing: Vec<TextureId>,
}

impl Painter {
    /// Takes over a frame's texture changes; call it once for each frame, before [`Painter::paint`].
    ///
    /// What the frame frees is kept until the next call, because the frame itself may show it.
    pub fn apply(&mut self, mut delta: TexturesDelta) {
        for id in self.outgoing.drain(..) {
            self.textures.remove(&id);
        }
        for (id, changes) in delta.set.drain() {
            for change in changes {
                let ImageData::Color(image) = change.image;
                if let Some(corner) = change.pos {
                    if let Some(texture) = self.textures.get_mut(&id) {
                        texture.patch(corner, &image);
                    }
                } else {
                    let options = change.options;
                    let image = std::sync::Arc::unwrap_or_clone(image);
                    self.textures.insert(id, Texture { image, options });
                }
            }
        }
        self.outgoing.extend(delta.free.drain());
    }

    /// Draws tessellated shapes onto a fresh image.
    ///
    /// `size_px` is width and height in pixels, `pixels_per_point` the scale that the shapes were
    /// tessellated with, `clear` the colour of the empty image.
    pub fn paint(
        &self,
        primitives: &[ClippedPrimitive],
        size_px: [usize; 2],
        pixels_per_point: f32,
        clear: Color32,
    ) -> ColorImage {
        let mut image = ColorImage::filled(size_px, clear);
        for ClippedPrimitive {
            clip_rect,
            primitive,
        } in primitives
        {
            let Primitive::Mesh(mesh) = primitive else {
                continue;
            };
            let Some(texture) = self.textures.get(&mesh.texture_id) else {
                continue;
            };
            let window = Window::new(*clip_rect, pixels_per_point, size_px);
            let mut canvas = Canvas {
                pixels: &mut image.pixels,
                width: size_px[0],
                window,
            };
            canvas.mesh(mesh, texture, f64::from(pixels_per_point));
        }
        image
    }
}

/// Runs a view without a window and returns what it looks like.
///
/// The view gets `passes` frames, a second apart, so that layouts that need a second look at
/// themselves and animations are settled in the last one, which is drawn. Fonts and themes that
/// the view sets in its first frame take effect in the next. See [`picture_with`] for a view that
/// needs the context beforehand.
pub fn picture(
    size_points: Vec2,
    pixels_per_point: f32,
    passes: usize,
    ui: impl FnMut(&mut egui::Ui),
) -> ColorImage {
    let context = egui::Context::default();
    picture_with(&context, size_points, pixels_per_point, passes, ui)
}

/// [`picture`] for a context that was made, and perhaps given fonts and a theme, by the caller.
///
/// The context must not have been shown elsewhere: its textures are delivered only once.
pub fn picture_with(
    context: &egui::Context,
    size_points: Vec2,
    pixels_per_point: f32,
    passes: usize,
    mut ui: impl FnMut(&mut egui::Ui),
) -> ColorImage {
    let mut painter = Painter::default();
    let mut shapes = Vec::new();
    let mut scale = pixels_per_point;
    for pass in 0..passes.max(1) {
        let mut input = egui::RawInput {
            screen_rect: Some(Rect::from_min_size(egui::Pos2::ZERO, size_points)),
            max_texture_side: Some(TEXTURE_SIDE),
            time: Some(pass as f64 * f64::from(PASS_SECONDS)),
            // egui caps an animation's progress to this much a frame.
            predicted_dt: PASS_SECONDS,
            ..Default::default()
        };
        let viewport = input.viewports.entry(egui::ViewportId::ROOT).or_default();
        viewport.native_pixels_per_point = Some(pixels_per_point);
        let mut output = context.run_ui(input, &mut ui);
        painter.apply(std::mem::take(&mut output.textures_delta));
        shapes = std::mem::take(&mut output.shapes);
        scale = output.pixels_per_point;
    }
    let size_px = [size_points.x, size_points.y].map(|s| (s * scale).round().max(1.0) as usize);
    let backdrop = context.global_style().visuals.panel_fill;
    let primitives = context.tessellate(shapes, scale);
    painter.paint(&primitives, size_px, scale, backdrop)
}

/// The image as a PNG file that says it is sRGB; with an alpha channel only where one is needed.
///
/// # Panics
/// When the image has no pixels, which PNG cannot express.
pub fn encode_png(image: &ColorImage) -> Vec<u8> {
    let opaque = image.pixels.iter().all(|pixel| pixel.a() == 255);
    let (colour, bytes): (_, Vec<u8>) = if opaque {
        let rgb = |pixel: &Color32| [pixel.r(), pixel.g(), pixel.b()];
        (
            png::ColorType::Rgb,
            image.pixels.iter().flat_map(rgb).collect(),
        )
    } else {
        // PNG stores colours that are not multiplied by their alpha.
        let rgba = |pixel: &Color32| pixel.to_srgba_unmultiplied();
        (
            png::ColorType::Rgba,
            image.pixels.iter().flat_map(rgba).collect(),
        )
    };
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, image.width() as u32, image.height() as u32);
    encoder.set_color(colour);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    encoder
        .write_header()
        .and_then(|mut writer| writer.write_image_data(&bytes))
        .expect("an image with pixels can always be written to memory");
    file
}

/// An image that triangles are filled with.
struct Texture {
    image: ColorImage,
    options: TextureOptions,
}

impl Texture {
    /// Replaces the part of the texture that starts at `corner` (column, row).
    fn patch(&mut self, corner: [usize; 2], image: &ColorImage) {
        let stride = self.image.width();
        let rows = image.pixels.chunks_exact(image.width().max(1));
        for (row, texels) in rows.enumerate() {
            let at = (corner[1] + row) * stride + corner[0];
            self.image.pixels[at..at + texels.len()].copy_from_slice(texels);
        }
    }

    fn size(&self) -> [f64; 2] {
        [self.image.width() as f64, self.image.height() as f64]
    }

    /// The texel at a column and row that may lie outside, as four values of 0-255.
    fn texel(&self, column: i32, row: i32) -> [f32; 4] {
        let [width, height] = self.image.size;
        let x = wrapped(column, width, self.options.wrap_mode);
        let y = wrapped(row, height, self.options.wrap_mode);
        self.image.pixels[y * width + x].to_array().map(f32::from)
    }

    /// The texture's colour, each channel 0-255, at a place in texels (0 is the outer edge).
    fn sample(&self, at: [f32; 2], filter: TextureFilter) -> [f32; 4] {
        if filter == TextureFilter::Nearest {
            return self.texel(floor(at[0]), floor(at[1]));
        }
        let (u, v) = (at[0] - 0.5, at[1] - 0.5);
        let (column, row) = (floor(u), floor(v));
        let (right, below) = (u - column as f32, v - row as f32);
        let [a, b, c, d] = [(0, 0), (1, 0), (0, 1), (1, 1)]
            .map(|(x, y)| self.texel(column.saturating_add(x), row.saturating_add(y)));
        let mut colour = [0.0; 4];
        for channel in 0..4 {
            let top = a[channel] + (b[channel] - a[channel]) * right;
            let bottom = c[channel] + (d[channel] - c[channel]) * right;
            colour[channel] = top + (bottom - top) * below;
        }
        colour
    }
}

/// Where an index outside `0..length` is looked up.
fn wrapped(index: i32, length: usize, mode: TextureWrapMode) -> usize {
    let length = length as i32;
    let inside = match mode {
        TextureWrapMode::ClampToEdge => index.clamp(0, length - 1),
        TextureWrapMode::Repeat => index.rem_euclid(length),
        TextureWrapMode::MirroredRepeat => {
            let there_and_back = index.rem_euclid(2 * length);
            there_and_back.min(2 * length - 1 - there_and_back)
        }
    };
    inside as usize
}

/// `floor` by way of a cast, which needs no library call on older processors.
fn floor(x: f32) -> i32 {
    let whole = x as i32;
    whole - i32::from(whole as f32 > x)
}

/// The pixels that a mesh may touch: columns and rows, ends excluded.
#[derive(Clone, Copy)]
struct Window {
    columns: [i32; 2],
    rows: [i32; 2],
}

impl Window {
    fn new(clip: Rect, pixels_per_point: f32, size_px: [usize; 2]) -> Self {
        let pixel = |at: f32, most: usize| {
            let at = (at * pixels_per_point).round();
            at.clamp(0.0, most as f32) as i32
        };
        Self {
            columns: [clip.min.x, clip.max.x].map(|x| pixel(x, size_px[0])),
            rows: [clip.min.y, clip.max.y].map(|y| pixel(y, size_px[1])),
        }
    }
}

/// One edge of a triangle, as the sign test that tells on which side of it a pixel centre lies.
struct Edge {
    from: [f64; 2],
    along: [f64; 2],
    /// Whether a centre exactly on the edge belongs to the triangle: true for top and left edges.
    closed: bool,
}

impl Edge {
    /// The edge between two corners in grid steps, with the triangle on its right (rows go down).
    fn new(from: [f64; 2], to: [f64; 2]) -> Self {
        let along = [to[0] - from[0], to[1] - from[1]];
        let closed = along[1] < 0.0 || (along[1] == 0.0 && along[0] > 0.0);
        Self {
            from,
            along,
            closed,
        }
    }

    /// Narrows a run of columns (end excluded) to the pixels of a row that lie inside.
    fn narrow(&self, row: i32, run: &mut [i32; 2]) {
        // Inside: level - slope * column > 0, or = 0 where the edge is closed.
        let slope = self.along[1] * SUBPIXELS;
        let level = self.along[0] * (centre(row) - self.from[1])
            - self.along[1] * (SUBPIXELS / 2.0 - self.from[0]);
        if slope == 0.0 {
            if level < 0.0 || (level == 0.0 && !self.closed) {
                run[1] = run[0];
            }
            return;
        }
        // Both are whole numbers, so the quotient is exact where it is whole, and elsewhere too
        // far from a whole number to be rounded across it.
        let crossing = level / slope;
        let crossing = crossing
            .max(f64::from(run[0]) - 1.0)
            .min(f64::from(run[1]) + 1.0);
        let truncated = crossing as i32;
        let below = truncated - i32::from(f64::from(truncated) > crossing);
        let exact = f64::from(below) == crossing;
        if slope > 0.0 {
            let end = below + i32::from(!exact || self.closed);
            run[1] = run[1].min(end);
        } else {
            let start = below + i32::from(!exact || !self.closed);
            run[0] = run[0].max(start);
        }
    }
}

/// The middle of a pixel's column or row, in grid steps.
fn centre(pixel: i32) -> f64 {
    f64::from(pixel) * SUBPIXELS + SUBPIXELS / 2.0
}

/// A value that changes linearly over a triangle.
#[derive(Clone, Copy, Default)]
struct Plane {
    /// At the centre of the pixel in column 0, row 0.
    origin: f64,
    per_column: f64,
    per_row: f64,
}

impl Plane {
    fn at(&self, column: i32, row: i32) -> f32 {
        (self.origin + self.per_column * f64::from(column) + self.per_row * f64::from(row)) as f32
    }
}

/// A triangle on the grid: its three corners in turning order, and their edges.
struct Triangle {
    corners: [[f64; 2]; 3],
    /// Edge `i` is opposite corner `i`.
    edges: [Edge; 3],
    /// Twice the area, in squared grid steps; positive.
    area: f64,
}

impl Triangle {
    /// A triangle from corners in pixels, and whether two corners changed places; `None` if flat.
    fn new(corners: [[f64; 2]; 3]) -> Option<(Self, bool)> {
        let [a, mut b, mut c] = corners.map(|corner| corner.map(|x| (x * SUBPIXELS).round()));
        let mut area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        if area == 0.0 || !area.is_finite() {
            return None;
        }
        let turned = area < 0.0;
        if turned {
            std::mem::swap(&mut b, &mut c);
            area = -area;
        }
        let triangle = Self {
            corners: [a, b, c],
            edges: [Edge::new(b, c), Edge::new(c, a), Edge::new(a, b)],
            area,
        };
        Some((triangle, turned))
    }

    /// First and last row (excluded) that the triangle may touch within a window.
    fn rows(&self, window: Window) -> std::ops::Range<i32> {
        let [low, high] = self.extent(1);
        low.max(window.rows[0])..high.min(window.rows[1])
    }

    /// Pixels that the triangle spans along an axis (0 = columns, 1 = rows), end excluded.
    fn extent(&self, axis: usize) -> [i32; 2] {
        let [a, b, c] = self.corners.map(|corner| corner[axis] / SUBPIXELS);
        // One pixel too many on either side costs nothing: the edges decide.
        let (low, high) = (a.min(b).min(c) as i32, a.max(b).max(c) as i32);
        [low.saturating_sub(1), high.saturating_add(2)]
    }

    /// The plane through one value at each corner.
    fn plane(&self, values: [f32; 3]) -> Plane {
        let first = f64::from(values[0]);
        let mut plane = Plane::default();
        // Differences to the first corner, so that equal values give a plane that is exactly flat.
        for (value, edge) in values.into_iter().zip(&self.edges).skip(1) {
            let share = (f64::from(value) - first) * SUBPIXELS / self.area;
            plane.per_column -= share * edge.along[1];
            plane.per_row += share * edge.along[0];
        }
        let [x, y] = self.corners[0].map(|at| (at - SUBPIXELS / 2.0) / SUBPIXELS);
        plane.origin = first - plane.per_column * x - plane.per_row * y;
        plane
    }
}

/// The image under construction, and the part of it that may be drawn on.
struct Canvas<'a> {
    pixels: &'a mut [Color32],
    width: usize,
    window: Window,
}

impl Canvas<'_> {
    fn mesh(&mut self, mesh: &Mesh, texture: &Texture, pixels_per_point: f64) {
        if texture.image.pixels.is_empty() {
            return;
        }
        for indices in mesh.indices.chunks_exact(3) {
            let [a, b, c] = [indices[0], indices[1], indices[2]].map(|i| mesh.vertices[i as usize]);
            self.triangle([a, b, c], texture, pixels_per_point);
        }
    }

    fn triangle(&mut self, vertices: [Vertex; 3], texture: &Texture, pixels_per_point: f64) {
        let place = |at: f32| f64::from(at) * pixels_per_point;
        let corners = vertices.map(|vertex| [place(vertex.pos.x), place(vertex.pos.y)]);
        let Some((triangle, turned)) = Triangle::new(corners) else {
            return;
        };
        let [a, b, c] = vertices;
        let [a, b, c] = if turned { [a, c, b] } else { [a, b, c] };

        let one_colour = a.color == b.color && a.color == c.color;
        if a.uv == b.uv && a.uv == c.uv {
            let size = texture.size();
            let at = [
                (f64::from(a.uv.x) * size[0]) as f32,
                (f64::from(a.uv.y) * size[1]) as f32,
            ];
            let texel = texture.sample(at, texture.options.magnification);
            if one_colour {
                self.solid(&triangle, product(a.color.to_array().map(f32::from), texel));
            } else {
                self.shaded(&triangle, [a, b, c], texel);
            }
        } else {
            self.textured(&triangle, [a, b, c], texture);
        }
    }

    /// Visits the triangle's runs of pixels: first column, row, and the pixels themselves.
    fn runs(&mut self, triangle: &Triangle, mut run: impl FnMut(i32, i32, &mut [Color32])) {
        let extent = triangle.extent(0);
        let columns = [
            extent[0].max(self.window.columns[0]),
            extent[1].min(self.window.columns[1]),
        ];
        if columns[0] >= columns[1] {
            return;
        }
        for row in triangle.rows(self.window) {
            let mut inside = columns;
            for edge in &triangle.edges {
                edge.narrow(row, &mut inside);
                if inside[0] >= inside[1] {
                    break;
                }
            }
            let [first, end] = inside;
            if first < end {
                let start = row as usize * self.width;
                let pixels = &mut self.pixels[start + first as usize..start + end as usize];
                run(first, row, pixels);
            }
        }
    }

    /// One colour all over: most of the area of a window.
    fn solid(&mut self, triangle: &Triangle, colour: [f32; 4]) {
        let source = colour.map(|channel| (channel + 0.5) as u8);
        if source == [0; 4] {
            return;
        }
        let [r, g, b, a] = source;
        if a == 255 {
            let colour = Color32::from_rgba_premultiplied(r, g, b, a);
            self.runs(triangle, |_, _, pixels| pixels.fill(colour));
            return;
        }
        let keep = 255 - u32::from(a);
        // Rounded to the nearest; 255 is odd, so there are no halves to decide on.
        let mix = |source: u8, target: u8| {
            let kept = (u32::from(target) * keep + 127) / 255;
            (u32::from(source) + kept).min(255) as u8
        };
        self.runs(triangle, |_, _, pixels| {
            for pixel in pixels {
                let [tr, tg, tb, ta] = pixel.to_array();
                *pixel = Color32::from_rgba_premultiplied(
                    mix(r, tr),
                    mix(g, tg),
                    mix(b, tb),
                    mix(a, ta),
                );
            }
        });
    }

    /// Colours that blend from corner to corner: the soft edges of lines and boxes.
    fn shaded(&mut self, triangle: &Triangle, corners: [Vertex; 3], texel: [f32; 4]) {
        let colours = colour_planes(triangle, corners);
        let per_column = colours.map(|plane| plane.per_column as f32);
        self.runs(triangle, |column, row, pixels| {
            let start = colours.map(|plane| plane.at(column, row));
            for (i, pixel) in pixels.iter_mut().enumerate() {
                let colour = stepped(start, per_column, i as f32);
                *pixel = blended(product(colour, texel), *pixel);
            }
        });
    }

    /// Colours and a texture: text and images.
    fn textured(&mut self, triangle: &Triangle, corners: [Vertex; 3], texture: &Texture) {
        let [width, height] = texture.size();
        let u = triangle.plane(corners.map(|corner| (f64::from(corner.uv.x) * width) as f32));
        let v = triangle.plane(corners.map(|corner| (f64::from(corner.uv.y) * height) as f32));
        // More than a texel per pixel, both ways together, is a texture made smaller.
        let texels_per_pixel = (u.per_column * v.per_row - u.per_row * v.per_column).abs();
        let filter = if texels_per_pixel > 1.0 {
            texture.options.minification
        } else {
            texture.options.magnification
        };
        let colours = colour_planes(triangle, corners);
        let per_column = colours.map(|plane| plane.per_column as f32);
        let (u_step, v_step) = (u.per_column as f32, v.per_column as f32);
        self.runs(triangle, |column, row, pixels| {
            let start = colours.map(|plane| plane.at(column, row));
            let (u, v) = (u.at(column, row), v.at(column, row));
            for (i, pixel) in pixels.iter_mut().enumerate() {
                let i = i as f32;
                let texel = texture.sample([u + u_step * i, v + v_step * i], filter);
                if texel != [0.0; 4] {
                    let colour = stepped(start, per_column, i);
                    *pixel = blended(product(colour, texel), *pixel);
                }
            }
        });
    }
}

/// One plane for each of red, green, blue and alpha, 0-255.
fn colour_planes(triangle: &Triangle, corners: [Vertex; 3]) -> [Plane; 4] {
    let colours = corners.map(|corner| corner.color.to_array().map(f32::from));
    [0, 1, 2, 3].map(|channel| triangle.plane(colours.map(|colour| colour[channel])))
}

/// Four values some steps further on.
fn stepped(start: [f32; 4], step: [f32; 4], steps: f32) -> [f32; 4] {
    let mut values = start;
    for channel in 0..4 {
        values[channel] += step[channel] * steps;
    }
    values
}

/// The product of two colours whose channels are 0-255.
fn product(colour: [f32; 4], texel: [f32; 4]) -> [f32; 4] {
    let mut values = colour;
    for channel in 0..4 {
        values[channel] *= texel[channel] * (1.0 / 255.0);
    }
    values
}

/// A premultiplied source, each channel 0-255, over a pixel.
fn blended(source: [f32; 4], target: Color32) -> Color32 {
    let keep = (1.0 - source[3] * (1.0 / 255.0)).max(0.0);
    let target = target.to_array();
    let mut mixed = [0_u8; 4];
    for channel in 0..4 {
        // The cast ends at 0 and 255.
        mixed[channel] = (source[channel] + f32::from(target[channel]) * keep + 0.5) as u8;
    }
    Color32::from_rgba_premultiplied(mixed[0], mixed[1], mixed[2], mixed[3])
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::{Pos2, pos2, vec2};

    /// A painter that knows one white texel, as egui's font texture has at its corner.
    fn painter() -> Painter {
        textured_painter(ColorImage::filled([1, 1], Color32::WHITE))
    }

    fn textured_painter(image: ColorImage) -> Painter {
        let mut delta = TexturesDelta::default();
        let image = egui::epaint::ImageDelta::full(image, TextureOptions::NEAREST);
        delta.push(TextureId::default(), image);
        let mut painter = Painter::default();
        painter.apply(delta);
        painter
    }

    fn clipped(mesh: Mesh) -> [ClippedPrimitive; 1] {
        [ClippedPrimitive {
            clip_rect: Rect::EVERYTHING,
            primitive: Primitive::Mesh(mesh),
        }]
    }

    fn fan(points: &[Pos2], colour: Color32) -> Mesh {
        let mut mesh = Mesh::default();
        for &point in points {
            mesh.colored_vertex(point, colour);
        }
        for i in 2..points.len() as u32 {
            mesh.add_triangle(0, i - 1, i);
        }
        mesh
    }

    #[test]
    fn triangles_that_share_edges_cover_each_pixel_once() {
        // A fan around a corner that is no pixel centre, and one around a corner that is.
        for hub in [pos2(11.3, 9.7), pos2(11.5, 9.5)] {
            let rim = [
                pos2(0.0, 0.0),
                pos2(13.0, 0.0),
                pos2(24.0, 0.0),
                pos2(24.0, 20.0),
                pos2(7.5, 20.0),
                pos2(0.0, 20.0),
                pos2(0.0, 0.0),
            ];
            let mut points = vec![hub];
            points.extend(rim);
            let grey = Color32::from_rgba_premultiplied(100, 100, 100, 100);
            let mesh = clipped(fan(&points, grey));
            let image = painter().paint(&mesh, [24, 20], 1.0, Color32::TRANSPARENT);
            assert!(image.pixels.iter().all(|&pixel| pixel == grey));
        }
    }

    #[test]
    fn a_box_fills_exactly_the_centres_inside() {
        let rect = Rect::from_min_max(pos2(1.5, 2.0), pos2(4.5, 5.0));
        let mut mesh = Mesh::default();
        mesh.add_colored_rect(rect, Color32::RED);
        let image = painter().paint(&clipped(mesh), [8, 8], 1.0, Color32::BLACK);
        for y in 0..8 {
            for x in 0..8 {
                // Centre 1.5 lies on the left edge and belongs, 4.5 on the right and does not.
                let inside = (1..4).contains(&x) && (2..5).contains(&y);
                let found = image[(x, y)];
                assert_eq!(found == Color32::RED, inside, "pixel {x} {y}");
            }
        }
    }

    #[test]
    fn either_turning_direction_draws_the_same() {
        let points = [pos2(1.2, 0.7), pos2(9.1, 3.3), pos2(3.4, 8.8)];
        let [a, b, c] = points;
        let draw = |points: [Pos2; 3]| {
            let mesh = clipped(fan(&points, Color32::WHITE));
            painter().paint(&mesh, [10, 10], 1.0, Color32::BLACK)
        };
        assert_eq!(draw([a, b, c]), draw([a, c, b]));
        assert!(draw([a, b, c]).pixels.contains(&Color32::WHITE));
    }

    #[test]
    fn corners_far_outside_do_not_disturb_what_is_inside() {
        let mut mesh = fan(
            &[pos2(-3e9, 5.0), pos2(3e9, 5.0), pos2(5.0, 1e30)],
            Color32::WHITE,
        );
        mesh.colored_vertex(pos2(f32::NAN, 0.0), Color32::RED);
        mesh.add_triangle(0, 1, 3);
        let image = painter().paint(&clipped(mesh), [10, 10], 1.0, Color32::BLACK);
        for y in 0..10 {
            let expected = if y < 5 {
                Color32::BLACK
            } else {
                Color32::WHITE
            };
            assert_eq!(image[(5, y)], expected, "row {y}");
        }
    }

    #[test]
    fn half_transparent_white_over_black_is_half_grey() {
        let half = Color32::from_rgba_premultiplied(128, 128, 128, 128);
        let mut mesh = Mesh::default();
        mesh.add_colored_rect(Rect::from_min_size(Pos2::ZERO, vec2(2.0, 2.0)), half);
        let image = painter().paint(&clipped(mesh), [2, 2], 1.0, Color32::BLACK);
        assert_eq!(image[(0, 0)], Color32::from_gray(128));
    }

    #[test]
    fn solid_and_shaded_fills_agree() {
        // The same translucent colour through the whole-number and the fractional arithmetic.
        let colour = Color32::from_rgba_premultiplied(37, 91, 5, 140);
        let triangle = Triangle::new([[0.0, 0.0], [9.0, 0.0], [0.0, 9.0]])
            .unwrap()
            .0;
        let corner = Vertex {
            pos: Pos2::ZERO,
            uv: Pos2::ZERO,
            color: colour,
        };
        for level in 0..=255 {
            let mut pixels = [vec![Color32::from_gray(level); 81], Vec::new()];
            pixels[1] = pixels[0].clone();
            for (way, pixels) in pixels.iter_mut().enumerate() {
                let mut canvas = Canvas {
                    pixels,
                    width: 9,
                    window: Window {
                        columns: [0, 9],
                        rows: [0, 9],
                    },
                };
                if way == 0 {
                    canvas.solid(&triangle, colour.to_array().map(f32::from));
                } else {
                    canvas.shaded(&triangle, [corner; 3], [255.0; 4]);
                }
            }
            assert_eq!(pixels[0], pixels[1], "over grey {level}");
        }
    }

    #[test]
    fn an_image_shown_at_its_own_size_is_unchanged() {
        let colours = (0..20).map(|i| Color32::from_rgb(i * 12, 255 - i, i * 7));
        let texture = ColorImage::new([5, 4], colours.collect());
        for filter in [TextureOptions::NEAREST, TextureOptions::LINEAR] {
            let mut painter = textured_painter(texture.clone());
            for texture in painter.textures.values_mut() {
                texture.options = filter;
            }
            let mut mesh = Mesh::default();
            let whole = Rect::from_min_max(Pos2::ZERO, pos2(1.0, 1.0));
            let at = Rect::from_min_size(Pos2::ZERO, vec2(5.0, 4.0));
            mesh.add_rect_with_uv(at, whole, Color32::WHITE);
            let image = painter.paint(&clipped(mesh), [5, 4], 1.0, Color32::BLACK);
            assert_eq!(image.pixels, texture.pixels);
        }
    }

    #[test]
    fn a_freed_texture_lives_until_the_next_frame() {
        let mut painter = painter();
        let mut delta = TexturesDelta::default();
        delta.free(TextureId::default());
        painter.apply(delta);
        assert!(painter.textures.contains_key(&TextureId::default()));
        painter.apply(TexturesDelta::default());
        assert!(painter.textures.is_empty());
    }

    #[test]
    fn indices_outside_wrap_as_asked() {
        let row = |mode| -> Vec<usize> { (-3..6).map(|i| wrapped(i, 3, mode)).collect() };
        assert_eq!(
            row(TextureWrapMode::ClampToEdge),
            [0, 0, 0, 0, 1, 2, 2, 2, 2]
        );
        assert_eq!(row(TextureWrapMode::Repeat), [0, 1, 2, 0, 1, 2, 0, 1, 2]);
        assert_eq!(
            row(TextureWrapMode::MirroredRepeat),
            [2, 1, 0, 0, 1, 2, 2, 1, 0]
        );
    }

    #[test]
    fn a_view_becomes_the_same_picture_twice() {
        let view = |ui: &mut egui::Ui| {
            egui::CentralPanel::default().show(ui, |ui| {
                ui.heading("Spectrum");
                ui.collapsing("More", |ui| ui.label("hidden"));
            });
        };
        let draw = || picture(vec2(120.0, 60.0), 1.5, 3, view);
        let image = draw();
        assert_eq!(image.size, [180, 90]);
        let ink = image.pixels[0];
        assert!(image.pixels.iter().any(|&pixel| pixel != ink));
        assert_eq!(image, draw());
    }

    #[test]
    fn png_files_read_back_as_the_same_pixels() {
        let opaque = ColorImage::new([2, 1], vec![Color32::RED, Color32::from_rgb(1, 2, 3)]);
        let clear = ColorImage::new([1, 1], vec![Color32::TRANSPARENT]);
        for (image, colour, expected) in [
            (opaque, png::ColorType::Rgb, vec![255, 0, 0, 1, 2, 3]),
            (clear, png::ColorType::Rgba, vec![0; 4]),
        ] {
            let file = encode_png(&image);
            let mut reader = png::Decoder::new(std::io::Cursor::new(file))
                .read_info()
                .unwrap();
            assert_eq!(reader.info().color_type, colour);
            assert!(reader.info().srgb.is_some());
            let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
            reader.next_frame(&mut bytes).unwrap();
            assert_eq!(bytes, expected);
        }
    }
}
