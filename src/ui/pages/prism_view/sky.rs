//! The sky with both bows as arches over the point opposite the sun.

use eframe::egui;
use egui::{Color32, ColorImage, Rect, Sense, TextureHandle, TextureOptions, Ui, Vec2, pos2};

use crate::{
    app::chart::Rgb,
    ui::{kit::drawing, theme::grey},
};

/// What is seen of the arches to either side, degrees of the sky.
const HALF_WIDTH_DEG: f32 = 62.0;

/// Least height above the horizon that is seen, degrees: the middle of the arches is below.
const FROM_DEG: f32 = 20.0;

/// Most columns of the picture.
const MOST: f32 = 1400.0;

/// The picture on the graphics card and what it was made of.
#[derive(Default)]
pub(super) struct Painted {
    of: Option<(Vec<Rgb>, [usize; 2])>,
    texture: Option<TextureHandle>,
}

impl Painted {
    /// Draws the sky: a colour for each angle between two ends.
    pub(super) fn show(&mut self, ui: &mut Ui, (rgb, ends): (&[Rgb], [f64; 2]), size: Vec2) {
        let (area, _) = drawing(ui, size, Sense::hover(), "The sky with both rainbows");
        let shrink = (size.x / MOST).max(1.0);
        let pixels = [size.x, size.y].map(|side| ((side / shrink) as usize).max(1));
        let is_fresh = |of: &(Vec<Rgb>, [usize; 2])| of.0 == rgb && of.1 == pixels;
        if !self.of.as_ref().is_some_and(is_fresh) {
            let image = sky(rgb, ends, pixels);
            let options = TextureOptions::LINEAR;
            self.texture = Some(ui.ctx().load_texture("rainbow", image, options));
            self.of = Some((rgb.to_vec(), pixels));
        }
        let painter = ui.painter().with_clip_rect(area);
        if let Some(texture) = &self.texture {
            let uv = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
            painter.image(texture.id(), area, uv, Color32::WHITE);
        }
    }
}

/// Each pixel has the colour of its angle; distances from the middle below are angles.
fn sky(rgb: &[Rgb], [from, to]: [f64; 2], [width, height]: [usize; 2]) -> ColorImage {
    let to_deg = to as f32 + 2.0;
    // The same scale both ways: what is too wide is cut at the sides.
    let scale =
        ((to_deg - FROM_DEG) / height as f32).max(2.0 * HALF_WIDTH_DEG / width as f32 / 2.2);
    let colour = |x: usize, y: usize| {
        let across = (x as f32 + 0.5 - 0.5 * width as f32) * scale;
        let up = to_deg - (y as f32 + 0.5) * scale;
        let angle = f64::from(across.hypot(up));
        let share = (angle - from) / (to - from);
        let column = (share * rgb.len() as f64).floor();
        let inside = up > 0.0 && (0.0..rgb.len() as f64).contains(&column);
        match rgb.get(column.max(0.0) as usize).filter(|_| inside) {
            Some([r, g, b]) => Color32::from_rgb(*r, *g, *b),
            None => grey(super::bench::ROOM),
        }
    };
    let pixels = (0..width * height).map(|i| colour(i % width, i / width));
    ColorImage::new([width, height], pixels.collect())
}
