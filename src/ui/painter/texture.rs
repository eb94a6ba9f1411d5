//! The images that triangles are filled with.

use eframe::egui::{ColorImage, TextureFilter, TextureOptions, TextureWrapMode};

/// An image that triangles are filled with.
pub(super) struct Texture {
    pub(super) image: ColorImage,
    pub(super) options: TextureOptions,
}

impl Texture {
    /// Replaces the part of the texture that starts at `corner` (column, row).
    pub(super) fn patch(&mut self, corner: [usize; 2], image: &ColorImage) {
        let stride = self.image.width();
        let rows = image.pixels.chunks_exact(image.width().max(1));
        for (row, texels) in rows.enumerate() {
            let at = (corner[1] + row) * stride + corner[0];
            self.image.pixels[at..at + texels.len()].copy_from_slice(texels);
        }
    }

    pub(super) fn size(&self) -> [f64; 2] {
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
    pub(super) fn sample(&self, at: [f32; 2], filter: TextureFilter) -> [f32; 4] {
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
pub(super) fn wrapped(index: i32, length: usize, mode: TextureWrapMode) -> usize {
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
