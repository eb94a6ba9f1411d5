//! The light along a strip: three curves, the ticks of a lamp's lines, and where nothing is sure.

use eframe::egui;
use egui::{Align2, Color32, Pos2, Rect, Sense, Shape, Stroke, TextStyle, Ui, Vec2, pos2, vec2};

use super::{
    Hand, PhotographView,
    ticks::{Across, draw_ticks},
};
use crate::{
    app::{chart::Ink, photograph::Photograph},
    photographs::axis::{Curve, with_line_at},
    ui::{kit::drawing, theme::Theme},
};

/// Room under the curves for numbers, and over them for the names of lines, points.
const FOOT: f32 = 20.0;
const HEAD: f32 = 18.0;
/// Distance of the lines of a hatch, points.
const HATCH: f32 = 5.0;
/// Inks of red, green and blue on a dark and on a light ground.
const INKS: [[[u8; 3]; 2]; 3] = [
    [[240, 110, 110], [190, 30, 30]],
    [[110, 210, 120], [20, 120, 40]],
    [[120, 160, 255], [30, 70, 200]],
];

/// Slanted lines over a part of a drawing.
fn hatch(ui: &Ui, rect: Rect, ink: Color32) {
    let painter = ui.painter().with_clip_rect(rect);
    let mut x = rect.left() - rect.height();
    while x < rect.right() {
        let from = pos2(x, rect.bottom());
        painter.line_segment(
            [from, from + vec2(rect.height(), -rect.height())],
            Stroke::new(1.0, ink),
        );
        x += HATCH;
    }
}

/// Hatches what is over-exposed, and where the axis is in doubt.
pub(super) fn marks(ui: &Ui, theme: Theme, found: &Photograph, rect: Rect) {
    let across = Across::of(rect, found);
    let profile = &found.found.profile;
    let over = |from: f64, to: f64, ink: Color32| {
        let part = Rect::from_x_y_ranges(across.x(from - 0.5)..=across.x(to + 0.5), rect.y_range());
        hatch(ui, part.intersect(rect), ink);
    };
    let red = Color32::from_rgb(230, 60, 60);
    let mut start = None;
    for column in 0..=profile.columns() {
        let is_clipped = profile.clipped.get(column).is_some_and(|c| *c);
        match (start, is_clipped) {
            (None, true) => start = Some(column),
            (Some(from), false) => {
                over(from as f64, column as f64 - 1.0, red);
                start = None;
            }
            _ => {}
        }
    }
    let last = profile.columns() as f64 - 1.0;
    let (Some(curve), Some((low, high))) = (found.curve(), found.valid_nm()) else {
        return;
    };
    let ends = [low, high].map(|nm| curve.px(nm, 0.0, last));
    if let [Some(a), Some(b)] = ends {
        let (a, b) = (a.min(b), a.max(b));
        for (from, to) in [(0.0, a), (b, last)] {
            if to - from > 1.0 {
                over(from, to, theme.ink(Ink::Beyond));
            }
        }
    }
}

impl PhotographView {
    /// The curves with the ticks of the lamp's lines, which a hand may move.
    pub(super) fn profile(&mut self, ui: &mut Ui, theme: Theme, found: &Photograph, size: Vec2) {
        // Lessons point at it by this name.
        let name = "Profile of the strip, red, green and blue";
        let (rect, response) = drawing(ui, size, Sense::click_and_drag(), name);
        ui.painter().rect_filled(rect, 0.0, theme.ground);
        let plot = Rect::from_min_max(
            rect.min + vec2(0.0, HEAD * theme.scale),
            rect.max - vec2(0.0, FOOT * theme.scale),
        );
        marks(ui, theme, found, plot);
        curves(ui, theme, found, plot);
        let ticks = self.ticks(found);
        self.drag(&response, found, &ticks, Across::of(plot, found));
        self.keys(ui, &response, found, &ticks);
        let moved = match self.hand {
            Some(Hand::Line(line, px)) => Some((line, px)),
            _ => None,
        };
        let answer = found.answer.as_ref().filter(|_| found.is_by_lines());
        let best = answer.and_then(|answer| answer.best.as_ref());
        let by_hand = moved
            .zip(best)
            .and_then(|((line, px), best)| with_line_at(best, found.peaks(), line, px));
        let curve = by_hand.or_else(|| found.curve());
        scale(ui, theme, found, curve, plot);
        draw_ticks(
            ui,
            theme,
            &ticks,
            moved,
            Across::of(plot, found),
            found.is_open(),
        );
    }
}

/// The three channels, each with its letter where it is highest.
fn curves(ui: &Ui, theme: Theme, found: &Photograph, plot: Rect) {
    let profile = &found.found.profile;
    let top = profile
        .channels
        .iter()
        .flatten()
        .copied()
        .fold(1e-9, f64::max);
    let across = Across::of(plot, found);
    let font = TextStyle::Small.resolve(ui.style());
    let painter = ui.painter().with_clip_rect(plot.expand2(vec2(0.0, HEAD)));
    for ((channel, inks), letter) in profile.channels.iter().zip(INKS).zip(["R", "G", "B"]) {
        let ink = crate::ui::theme::ink(inks[usize::from(!theme.dark)]);
        let place = |(column, value): (usize, &f64)| -> Pos2 {
            let share = (value / top).clamp(0.0, 1.0) as f32;
            pos2(
                across.x(column as f64),
                plot.bottom() - share * (plot.height() - 4.0),
            )
        };
        let points: Vec<Pos2> = channel.iter().enumerate().map(place).collect();
        let highest = points.iter().copied().min_by(|a, b| a.y.total_cmp(&b.y));
        painter.add(Shape::line(points, Stroke::new(theme.line, ink)));
        if profile.is_grey {
            break;
        }
        if let Some(at) = highest {
            painter.text(
                at + vec2(7.0, 6.0),
                Align2::LEFT_CENTER,
                letter,
                font.clone(),
                ink,
            );
        }
    }
}

/// Numbers under the curves: nm where there is an axis, else columns.
fn scale(ui: &Ui, theme: Theme, found: &Photograph, curve: Option<Curve>, plot: Rect) {
    let across = Across::of(plot, found);
    let font = TextStyle::Small.resolve(ui.style());
    let last = found.found.profile.columns() as f64 - 1.0;
    let mark = |column: f64, words: String| {
        let at = pos2(across.x(column), plot.bottom());
        let tick = [at, at + vec2(0.0, 4.0)];
        ui.painter()
            .line_segment(tick, Stroke::new(1.0, theme.faint));
        let below = at + vec2(0.0, 5.0);
        ui.painter()
            .text(below, Align2::CENTER_TOP, words, font.clone(), theme.faint);
    };
    match curve {
        Some(curve) => {
            for nm in (350..=800).step_by(50).map(f64::from) {
                if let Some(column) = curve.px(nm, 0.0, last) {
                    mark(column, format!("{nm:.0} nm"));
                }
            }
        }
        None => {
            let step = if last > 1200.0 { 400.0 } else { 100.0 };
            let mut column = step;
            while column < last {
                mark(column, format!("{column:.0} px"));
                column += step;
            }
        }
    }
}
