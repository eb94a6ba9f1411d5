//! The light along a strip: three curves, the ticks of a lamp's lines, and where nothing is sure.

use eframe::egui;
use egui::{Align2, Color32, Pos2, Rect, Sense, Shape, Stroke, TextStyle, Ui, Vec2, pos2, vec2};

use super::{Hand, PhotographView};
use crate::{
    app::{chart::Ink, photograph::Photograph},
    photographs::axis::{Curve, Pin, with_line_at},
    ui::{kit::drawing, theme::Theme},
};

/// Room under the curves for numbers, and over them for the names of lines, points.
const FOOT: f32 = 20.0;
const HEAD: f32 = 18.0;
/// A hand takes the tick that is no farther off, points.
const REACH: f32 = 8.0;
/// Distance of the lines of a hatch, points.
const HATCH: f32 = 5.0;
/// Inks of red, green and blue on a dark and on a light ground.
const INKS: [[[u8; 3]; 2]; 3] = [
    [[240, 110, 110], [190, 30, 30]],
    [[110, 210, 120], [20, 120, 40]],
    [[120, 160, 255], [30, 70, 200]],
];

/// Columns over the width of a drawing.
#[derive(Clone, Copy)]
struct Across {
    rect: Rect,
    columns: f32,
}

impl Across {
    fn of(rect: Rect, found: &Photograph) -> Self {
        let columns = found.found.profile.columns().max(2) as f32;
        Self { rect, columns }
    }

    fn x(self, column: f64) -> f32 {
        self.rect.left() + (column as f32 + 0.5) / self.columns * self.rect.width()
    }

    fn column(self, x: f32) -> f64 {
        f64::from((x - self.rect.left()) / self.rect.width() * self.columns - 0.5)
    }
}

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

/// A line of the axis as it is drawn: its number among the matches, column, wavelength.
struct Tick {
    line: usize,
    px: f64,
    nm: f64,
    is_strong: bool,
    is_pinned: bool,
}

impl PhotographView {
    /// The curves with the ticks of the lamp's lines, which a hand may move.
    pub(super) fn profile(&mut self, ui: &mut Ui, theme: Theme, found: &Photograph, size: Vec2) {
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
        let moved = match self.hand {
            Some(Hand::Line(line, px)) => Some((line, px)),
            _ => None,
        };
        let best = found
            .answer
            .as_ref()
            .and_then(|answer| answer.best.as_ref());
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

    fn ticks(&self, found: &Photograph) -> Vec<Tick> {
        let best = found
            .answer
            .as_ref()
            .and_then(|answer| answer.best.as_ref());
        let Some(best) = best.filter(|_| found.is_by_lines()) else {
            let pins = self.said.pins.iter().enumerate();
            let of_pin = |(line, pin): (usize, &Pin)| Tick {
                line,
                px: pin.px,
                nm: pin.nm,
                is_strong: true,
                is_pinned: true,
            };
            return pins.map(of_pin).collect();
        };
        let peaks = &found.peaks().peaks;
        let strongest = best
            .matches
            .iter()
            .map(|m| peaks[m.peak].height)
            .fold(0.0, f64::max);
        (best.matches.iter().enumerate())
            .map(|(line, found)| Tick {
                line,
                px: peaks[found.peak].px,
                nm: found.landmark.nm,
                is_strong: peaks[found.peak].height > 0.04 * strongest,
                is_pinned: (self.said.pins.iter()).any(|p| (p.nm - found.landmark.nm).abs() < 0.01),
            })
            .collect()
    }

    /// A hand moves a tick to another column, or takes its pin away.
    fn drag(
        &mut self,
        response: &egui::Response,
        found: &Photograph,
        ticks: &[Tick],
        across: Across,
    ) {
        let touched = response.interact_pointer_pos();
        let Some(pointer) = touched.or_else(|| response.hover_pos()) else {
            return;
        };
        let nearest = || {
            let away = |tick: &&Tick| (across.x(tick.px) - pointer.x).abs();
            let near = ticks.iter().filter(|tick| away(tick) <= REACH);
            near.min_by(|a, b| away(a).total_cmp(&away(b)))
        };
        if response.double_clicked()
            && let Some(tick) = nearest()
        {
            let mut said = self.said.clone();
            said.pins.retain(|pin| (pin.nm - tick.nm).abs() > 0.01);
            self.say(said);
            return;
        }
        if response.drag_started()
            && let Some(tick) = nearest()
        {
            self.hand = Some(Hand::Line(tick.line, tick.px));
        }
        let Some(Hand::Line(line, _)) = self.hand else {
            return;
        };
        let last = found.found.profile.columns() as f64 - 1.0;
        let px = across.column(pointer.x).clamp(0.0, last);
        self.hand = Some(Hand::Line(line, px));
        if response.drag_stopped() {
            self.hand = None;
            let Some(tick) = ticks.iter().find(|tick| tick.line == line) else {
                return;
            };
            let mut said = self.said.clone();
            said.pins.retain(|pin| (pin.nm - tick.nm).abs() > 0.01);
            said.pins.push(Pin { px, nm: tick.nm });
            if found.is_by_lines() {
                said.lamp = Self::lamp_of(found);
            }
            self.say(said);
        }
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

/// The lines of the lamp; those that are only suggested are dashed, those set by hand have a head.
fn draw_ticks(
    ui: &Ui,
    theme: Theme,
    ticks: &[Tick],
    moved: Option<(usize, f64)>,
    across: Across,
    is_open: bool,
) {
    let font = TextStyle::Small.resolve(ui.style());
    let ink = theme.ink(Ink::Text);
    let rect = across.rect;
    let mut free_from = f32::MIN;
    let mut sorted: Vec<&Tick> = ticks.iter().collect();
    sorted.sort_by(|a, b| a.px.total_cmp(&b.px));
    for tick in sorted {
        let held = moved.filter(|(line, _)| *line == tick.line);
        let x = across.x(held.map_or(tick.px, |(_, px)| px));
        let line = [pos2(x, rect.top()), pos2(x, rect.bottom())];
        let stroke = Stroke::new(
            1.0,
            ink.gamma_multiply(if held.is_some() { 1.0 } else { 0.55 }),
        );
        if is_open {
            ui.painter()
                .extend(Shape::dashed_line(&line, stroke, 4.0, 3.0));
        } else {
            ui.painter().line_segment(line, stroke);
        }
        if tick.is_pinned || held.is_some() {
            ui.painter().circle_filled(line[0], 4.0, theme.accent);
        }
        let words = format!("{:.1}", tick.nm);
        let galley = ui.painter().layout_no_wrap(words, font.clone(), ink);
        let half = 0.5 * galley.size().x;
        if (tick.is_strong || held.is_some()) && x - half > free_from {
            free_from = x + half + 4.0;
            let at = pos2(x - half, rect.top() - galley.size().y - 1.0);
            ui.painter().galley(at, galley, ink);
        }
    }
}
