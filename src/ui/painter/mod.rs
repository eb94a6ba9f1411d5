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

mod canvas;
mod texture;
mod triangle;

use std::collections::HashMap;

use eframe::egui;
use egui::epaint::{ClippedPrimitive, ImageData, Primitive};
use egui::{Color32, ColorImage, Rect, TextureId, TexturesDelta, Vec2};

use crate::io::png;

use self::{canvas::Canvas, texture::Texture, triangle::Window};

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
/// The size is in points before any zoom, which the view may set. The view gets `passes` frames, a second apart, so that layouts that need a second look at
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
            screen_rect: Some(Rect::from_min_size(
                egui::Pos2::ZERO,
                size_points / context.zoom_factor(),
            )),
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
    let size_px = [size_points.x, size_points.y]
        .map(|side| (side * pixels_per_point).round().max(1.0) as usize);
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
    // PNG stores colours that are not multiplied by their alpha.
    let colours = image.pixels.iter().map(Color32::to_srgba_unmultiplied);
    let bytes: Vec<u8> = match opaque {
        true => colours.flat_map(|[r, g, b, _]| [r, g, b]).collect(),
        false => colours.flatten().collect(),
    };
    png(image.size, &bytes).expect("an image with pixels can always be written to memory")
}

#[cfg(test)]
mod tests {
    use super::{texture::wrapped, triangle::Triangle, *};
    use egui::epaint::{Mesh, Vertex};
    use egui::{Pos2, TextureOptions, TextureWrapMode, pos2, vec2};

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
