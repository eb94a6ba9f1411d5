//! The colours of a triangle's pixels.

use eframe::egui::{
    Color32,
    epaint::{Mesh, Vertex},
};

use super::{
    texture::Texture,
    triangle::{Plane, Triangle, Window},
};

/// The image under construction, and the part of it that may be drawn on.
pub(super) struct Canvas<'a> {
    pub(super) pixels: &'a mut [Color32],
    pub(super) width: usize,
    pub(super) window: Window,
}

impl Canvas<'_> {
    pub(super) fn mesh(&mut self, mesh: &Mesh, texture: &Texture, pixels_per_point: f64) {
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
    pub(super) fn solid(&mut self, triangle: &Triangle, colour: [f32; 4]) {
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
    pub(super) fn shaded(&mut self, triangle: &Triangle, corners: [Vertex; 3], texel: [f32; 4]) {
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
