//! The sky with both bows as a person sees it who has the sun at the back: a horizon, the ground,
//! and the shadow of the own head, about which the bows stand.

use eframe::egui;
use egui::{
    Align2, Color32, ColorImage, Painter, Pos2, Rect, Sense, Shape, Stroke, TextureHandle,
    TextureOptions, Ui, Vec2, pos2, vec2,
};

use super::bench::write;
use crate::{
    app::chart::Rgb,
    ui::{
        kit::drawing,
        theme::{Theme, grey},
    },
};

/// How high the sun stands, degrees: the point opposite it is as far below the horizon.
const SUN_HIGH_DEG: f32 = 12.0;

/// What is seen above that point and below it, degrees.
const ABOVE_DEG: f32 = 57.0;
const BELOW_DEG: f32 = 9.0;

/// Greys of the sky at the top and at the horizon, of the ground there and at the viewer's feet.
const SKY: [f32; 2] = [34.0, 66.0];
const GROUND: [f32; 2] = [46.0, 26.0];

/// Share of the bows' light in front of the ground.
const BEFORE_GROUND: f32 = 0.35;

/// Power by which the bows' light is shown: they stand out from the paler glow inside.
const STEEP: f32 = 2.0;

/// How fast the light beyond both ends of what is computed fades, degrees.
const FADES_DEG: f32 = 12.0;

/// Most columns of the picture.
const MOST: f32 = 1400.0;

/// The picture on the graphics card and what it was made of.
#[derive(Default)]
pub(super) struct Painted {
    of: Option<(Vec<Rgb>, [usize; 2])>,
    texture: Option<TextureHandle>,
}

impl Painted {
    /// Draws the sky: a colour for each angle between two ends; a line to the bow at an angle.
    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        (rgb, ends): (&[Rgb], [f64; 2]),
        (size, bow_deg): (Vec2, Option<f64>),
        theme: Theme,
    ) {
        let name = said!("The sky with both rainbows");
        let (area, _) = drawing(ui, size, Sense::hover(), name);
        let shrink = (size.x / MOST).max(1.0);
        let pixels = [size.x, size.y].map(|side| ((side / shrink) as usize).max(1));
        let is_fresh = |of: &(Vec<Rgb>, [usize; 2])| of.0 == rgb && of.1 == pixels;
        if !self.of.as_ref().is_some_and(is_fresh) {
            let image = sky(rgb, ends, pixels);
            let options = TextureOptions::LINEAR;
            self.texture = Some(ui.ctx().load_texture("rainbow", image, options));
            self.of = Some((rgb.to_vec(), pixels));
        }
        let painter = ui.painter().with_clip_rect(area.intersect(ui.clip_rect()));
        if let Some(texture) = &self.texture {
            let uv = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
            painter.image(texture.id(), area, uv, Color32::WHITE);
        }
        let a_degree = area.height() / (ABOVE_DEG + BELOW_DEG);
        let head = pos2(area.center().x, area.top() + ABOVE_DEG * a_degree);
        shadow(&painter, head, a_degree, area.bottom());
        let mut taken = Vec::new();
        let beside = vec2(2.6 * a_degree, 0.0);
        let words = said!("your head's shadow, opposite the sun");
        let at = (head + beside, Align2::LEFT_CENTER, words, grey(200));
        write(ui, &painter, at, &mut taken);
        if let Some(bow_deg) = bow_deg {
            let top = head - vec2(0.0, bow_deg as f32 * a_degree);
            let from = head - vec2(0.0, 1.8 * a_degree);
            let stroke = Stroke::new(theme.scale, grey(150));
            painter.add(Shape::dashed_line(&[from, top], stroke, 4.0, 4.0));
            let words = format!("{bow_deg:.0}\u{b0}");
            let at = from + 0.4 * (top - from) + vec2(6.0, 0.0);
            write(
                ui,
                &painter,
                (at, Align2::LEFT_CENTER, &words, grey(220)),
                &mut taken,
            );
        }
    }
}

/// A person's shadow on the ground: the head where one looks away from the sun.
fn shadow(painter: &Painter, head: Pos2, a_degree: f32, bottom: f32) {
    let ink = grey(8);
    let at = |x: f32, y: f32| head + a_degree * vec2(x, y);
    let down = (bottom - head.y) / a_degree + 1.0;
    painter.circle_filled(head, 1.25 * a_degree, ink);
    let body = vec![
        at(-0.5, 1.0),
        at(0.5, 1.0),
        at(0.8, 1.8),
        at(2.3, 2.6),
        at(3.2, down),
        at(-3.2, down),
        at(-2.3, 2.6),
        at(-0.8, 1.8),
    ];
    painter.add(Shape::convex_polygon(body, ink, Stroke::NONE));
}

/// Each pixel has the colour of its angle over the grey of sky or ground; distances from the middle
/// below are angles.
fn sky(rgb: &[Rgb], [from, to]: [f64; 2], [width, height]: [usize; 2]) -> ColorImage {
    let scale = (ABOVE_DEG + BELOW_DEG) / height as f32;
    let [from, to] = [from, to].map(|deg| deg as f32);
    let last = rgb.len().saturating_sub(1);
    let colour = |x: usize, y: usize| {
        let across = (x as f32 + 0.5 - 0.5 * width as f32) * scale;
        let up = ABOVE_DEG - (y as f32 + 0.5) * scale;
        let angle = across.hypot(up);
        let share = ((angle - from) / (to - from)).clamp(0.0, 1.0);
        let beyond = (from - angle).max(angle - to).max(0.0);
        let high = up - SUN_HIGH_DEG;
        let mix = |[a, b]: [f32; 2], part: f32| a + (b - a) * part.clamp(0.0, 1.0);
        let (ground, part) = match high > 0.0 {
            true => (mix(SKY, 1.0 - high / (ABOVE_DEG - SUN_HIGH_DEG)), 1.0),
            false => (
                mix(GROUND, -high / (SUN_HIGH_DEG + BELOW_DEG)),
                BEFORE_GROUND,
            ),
        };
        let light = part * (-beyond / FADES_DEG).exp();
        let column = (share * last as f32).round() as usize;
        let [r, g, b] = rgb.get(column).copied().unwrap_or([0; 3]).map(|v| {
            // What shines adds to what lies behind it.
            let shines = 255.0 * (f32::from(v) / 255.0).powf(STEEP);
            (ground + light * shines * (1.0 - ground / 255.0)).min(255.0) as u8
        });
        Color32::from_rgb(r, g, b)
    };
    let pixels = (0..width * height).map(|i| colour(i % width, i / width));
    ColorImage::new([width, height], pixels.collect())
}
