//! What stands around the panels: numbers and names along the horizontal axis, names of the axes,
//! the colour strip.

use std::sync::Arc;

use eframe::egui;
use egui::{Align2, Color32, Galley, Mesh, Rect, TextStyle, Ui, epaint::TextShape, pos2, vec2};

use super::{
    super::theme::{Theme, ink},
    STRIP,
    place::{Place, value},
};
use crate::app::{
    plot_svg::{Chart, Rgb, Scale},
    ticks,
};

/// Slant of names that do not fit side by side, radians.
const SLANT: f32 = 0.61;

/// Longest name of a place, points.
const LONGEST_NAME: f32 = 150.0;

/// Distance of a vertical axis's name to its panel, points: the highest number reaches half beyond.
pub(super) const LIFT: f32 = 5.0;

/// Free space between neighbouring names, points.
const APART: f32 = 8.0;

/// Width of a text in a style.
pub(super) fn width(ui: &Ui, text: &str, style: &TextStyle) -> f32 {
    galley(ui, text, style, f32::INFINITY).size().x
}

fn galley(ui: &Ui, text: &str, style: &TextStyle, longest: f32) -> Arc<Galley> {
    let font = style.resolve(ui.style());
    let mut job =
        egui::text::LayoutJob::simple_singleline(text.to_owned(), font, Color32::PLACEHOLDER);
    if longest.is_finite() {
        job.wrap = egui::text::TextWrapping::truncate_at_width(longest);
    }
    ui.painter().layout_job(job)
}

/// Height of a line of small text.
pub(super) fn line_height(ui: &Ui) -> f32 {
    ui.text_style_height(&TextStyle::Small) + 2.0
}

/// The labels under the horizontal axis: how they stand, and what room they take.
pub(super) struct Edge {
    slanted: bool,
    /// Height of labels and of the axis's name.
    pub height: f32,
    /// How far labels reach to the left of the panel.
    pub overhang: f32,
    labels: f32,
}

impl Edge {
    /// For a panel about `width` wide.
    pub fn new(ui: &Ui, chart: &Chart, width: f32) -> Self {
        let line = line_height(ui);
        let name = if chart.x_label.is_empty() {
            2.0
        } else {
            line + 1.0
        };
        let [low, high] = chart.x_limits();
        let along = |x: f64| {
            let part = match chart.x_scale {
                Scale::Linear => (x - low) / (high - low),
                Scale::Log10 => (x / low).ln() / (high / low).ln(),
            };
            part as f32 * width
        };
        let mut names: Vec<(f32, f32)> = chart
            .x_names
            .iter()
            .map(|(x, name)| (along(*x), galley(ui, name, &TextStyle::Small, LONGEST_NAME)))
            .map(|(at, galley)| (at, galley.size().x))
            .filter(|(at, _)| at.is_finite())
            .collect();
        names.sort_by(|a, b| a.0.total_cmp(&b.0));
        let slanted = names
            .windows(2)
            .any(|w| w[1].0 - w[0].0 < (w[0].1 + w[1].1) / 2.0 + APART);
        let longest = names.iter().map(|n| n.1).fold(0.0, f32::max);
        let (labels, overhang) = if slanted {
            let reach = names.iter().map(|(at, wide)| wide * SLANT.cos() - at);
            (
                longest * SLANT.sin() + line + 2.0,
                reach.fold(0.0, f32::max),
            )
        } else {
            (line + 3.0, 0.0)
        };
        Self {
            slanted,
            height: labels + name,
            overhang,
            labels,
        }
    }

    /// Writes labels and the axis's name under `foot`.
    pub fn draw(&self, ui: &Ui, chart: &Chart, place: &Place, foot: f32, theme: Theme) {
        let frame = place.frame();
        let mut last = f32::NEG_INFINITY;
        for (x, text) in self.texts(ui, chart, place) {
            let Some(at) = place.exact([x, 1.0]).map(|at| at[0] as f32) else {
                continue;
            };
            if !(frame.left() - 0.5..=frame.right() + 0.5).contains(&at) {
                continue;
            }
            let galley = galley(ui, &text, &TextStyle::Small, LONGEST_NAME);
            let size = galley.size();
            let needed = if self.slanted { size.y * 1.1 } else { 0.0 };
            if at - last < needed {
                continue;
            }
            last = at;
            let tick = [pos2(at, foot), pos2(at, foot + 3.0)];
            ui.painter()
                .line_segment(tick, (1.0, theme.faint.gamma_multiply(0.6)));
            if self.slanted {
                let end = pos2(at + 0.3 * size.y, foot + 3.0);
                let shape = TextShape::new(end - vec2(size.x, 0.0), galley, theme.faint)
                    .with_angle_and_anchor(-SLANT, Align2::RIGHT_TOP)
                    .with_override_text_color(theme.faint);
                ui.painter().add(shape);
            } else {
                let corner = pos2(at - size.x / 2.0, foot + 3.0);
                ui.painter()
                    .galley_with_override_text_color(corner, galley, theme.faint);
            }
        }
        let middle = pos2(frame.center().x, foot + self.labels + 1.0);
        ui.painter().text(
            middle,
            Align2::CENTER_TOP,
            &chart.x_label,
            TextStyle::Small.resolve(ui.style()),
            ui.visuals().text_color(),
        );
    }

    /// Places and what is written there.
    fn texts(&self, ui: &Ui, chart: &Chart, place: &Place) -> Vec<(f64, String)> {
        if !chart.x_names.is_empty() {
            let mut names = chart.x_names.clone();
            names.sort_by(|a, b| a.0.total_cmp(&b.0));
            return names;
        }
        let bounds = place.transform.bounds();
        let [low, high] = [bounds.min()[0], bounds.max()[0]].map(|at| value(at, chart.x_scale));
        let room = place.frame().width();
        let widest = width(ui, "00000", &TextStyle::Small) + 2.0 * APART;
        let target = (room / (1.4 * widest)).clamp(2.0, 14.0) as usize;
        match chart.x_scale {
            Scale::Linear => {
                let ticks = ticks::nice_ticks(low, high, target);
                let labels = ticks::tick_labels(&ticks);
                ticks.into_iter().zip(labels).collect()
            }
            Scale::Log10 => {
                let ticks = ticks::log_ticks(low, high, target);
                ticks.into_iter().map(|t| (t, ticks::short(t))).collect()
            }
        }
    }
}

/// What a vertical axis counts, over its upper end.
pub(super) fn y_label(ui: &Ui, label: &str, panel: Rect, theme: Theme) {
    let galley = galley(ui, label, &TextStyle::Small, 0.8 * panel.width());
    let corner = panel.left_top() + vec2(2.0 * theme.scale, -LIFT - galley.size().y);
    let colour = ui.visuals().text_color();
    ui.painter()
        .galley_with_override_text_color(corner, galley, colour);
}

/// Colours along the horizontal axis, right under the main panel.
pub(super) fn strip(ui: &Ui, colours: &[Rgb], limits: [f64; 2], place: &Place) {
    let frame = place.frame();
    let y = frame.bottom() + 2.0..=frame.bottom() + 2.0 + STRIP;
    let ends = limits.map(|x| place.exact([x, 1.0]).map(|at| at[0] as f32));
    let [Some(left), Some(right)] = ends else {
        return;
    };
    let steps = colours.len().saturating_sub(1).max(1) as f32;
    let border = |i: usize| left + (right - left) * ((i as f32 - 0.5) / steps).clamp(0.0, 1.0);
    let mut mesh = Mesh::default();
    for (i, colour) in colours.iter().enumerate() {
        let rect = Rect::from_x_y_ranges(border(i)..=border(i + 1), y.clone());
        mesh.add_colored_rect(rect, ink(*colour));
    }
    let clip = Rect::from_x_y_ranges(frame.x_range(), y);
    ui.painter().with_clip_rect(clip).add(mesh);
}
