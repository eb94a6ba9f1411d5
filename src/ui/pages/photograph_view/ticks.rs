//! The ticks of a lamp's lines, and what a hand does to them.

use eframe::egui;
use egui::{Rect, Shape, Stroke, TextStyle, Ui, pos2};

use super::{Hand, PhotographView};
use crate::{
    app::{
        chart::Ink,
        photograph::{LampChoice, Photograph},
    },
    languages::fixed,
    photographs::{Lamp, axis::Pin},
    ui::{kit::hold_arrows, theme::Theme},
};

/// A hand takes the tick that is no farther off, points.
const REACH: f32 = 8.0;
/// Wavelengths over which a lamp's lines are spread before any is pinned, and most of its lines.
const ENDS_NM: (f64, f64) = (390.0, 710.0);
const MOST_TICKS: usize = 9;
/// Columns that an arrow key moves a tick by.
const STEP_PX: f64 = 0.1;

/// Columns over the width of a drawing.
#[derive(Clone, Copy)]
pub(super) struct Across {
    pub(super) rect: Rect,
    columns: f32,
}

impl Across {
    pub(super) fn of(rect: Rect, found: &Photograph) -> Self {
        let columns = found.found.profile.columns().max(2) as f32;
        Self { rect, columns }
    }

    pub(super) fn x(self, column: f64) -> f32 {
        self.rect.left() + (column as f32 + 0.5) / self.columns * self.rect.width()
    }

    pub(super) fn column(self, x: f32) -> f64 {
        f64::from((x - self.rect.left()) / self.rect.width() * self.columns - 0.5)
    }
}

/// A line of the axis as it is drawn: its number among the matches, column, wavelength.
pub(super) struct Tick {
    line: usize,
    px: f64,
    nm: f64,
    is_strong: bool,
    is_pinned: bool,
}

impl PhotographView {
    /// The lines of the axis, or the pins of one without lines.
    pub(super) fn ticks(&self, found: &Photograph) -> Vec<Tick> {
        let best = found
            .answer
            .as_ref()
            .and_then(|answer| answer.best.as_ref());
        let Some(best) = best.filter(|_| found.is_by_lines()) else {
            if let LampChoice::Is(lamp) = self.said.lamp
                && self.by_hand.lines_up
            {
                return self.lined_up(found, lamp);
            }
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
        let exact = |nm: f64| {
            let mut pins = self.said.pins.iter().filter(|pin| pin.is_exact);
            pins.find(|pin| (pin.nm - nm).abs() < 0.01)
                .map(|pin| pin.px)
        };
        (best.matches.iter().enumerate())
            .map(|(line, found)| Tick {
                line,
                px: exact(found.landmark.nm).unwrap_or(peaks[found.peak].px),
                nm: found.landmark.nm,
                is_strong: peaks[found.peak].height > 0.04 * strongest,
                is_pinned: (self.said.pins.iter()).any(|p| (p.nm - found.landmark.nm).abs() < 0.01),
            })
            .collect()
    }

    /// The strongest lines of a lamp, spread over the strip until two of them are pinned.
    fn lined_up(&self, found: &Photograph, lamp: Lamp) -> Vec<Tick> {
        let last = found.found.profile.columns() as f64 - 1.0;
        let falls = self.said.falls.or(found.found.blue_is_right) == Some(true);
        let (first_nm, last_nm) = if falls {
            (ENDS_NM.1, ENDS_NM.0)
        } else {
            ENDS_NM
        };
        let place = |nm: f64| (nm - first_nm) / (last_nm - first_nm) * last;
        // The table of a slit of 2 nm parts what most pictures part.
        let table = &lamp.tables()[2];
        let mut marks: Vec<_> = table.landmarks.iter().filter(|m| !m.is_clipped).collect();
        marks.sort_by(|a, b| (b.chance * b.strength).total_cmp(&(a.chance * a.strength)));
        marks.truncate(MOST_TICKS);
        let pin_of = |nm: f64| self.said.pins.iter().find(|pin| (pin.nm - nm).abs() < 0.01);
        let tick = |(line, mark): (usize, &&crate::photographs::landmarks::Landmark)| Tick {
            line,
            px: pin_of(mark.nm).map_or(place(mark.nm), |pin| pin.px),
            nm: mark.nm,
            is_strong: true,
            is_pinned: pin_of(mark.nm).is_some(),
        };
        let ticks = marks.iter().enumerate().map(tick);
        ticks
            .filter(|tick| (0.0..=last).contains(&tick.px))
            .collect()
    }

    /// Arrow keys move the tick that was chosen last by a tenth of a column.
    pub(super) fn keys(
        &mut self,
        ui: &Ui,
        response: &egui::Response,
        found: &Photograph,
        ticks: &[Tick],
    ) {
        let Some(nm) = self.by_hand.chosen_nm.filter(|_| response.has_focus()) else {
            return;
        };
        hold_arrows(ui, response.id, false);
        let pressed = |key| ui.input(|i| i.num_presses(key)) as f64;
        let steps = pressed(egui::Key::ArrowRight) - pressed(egui::Key::ArrowLeft);
        let tick = ticks.iter().find(|tick| (tick.nm - nm).abs() < 0.01);
        if let Some(tick) = tick.filter(|_| steps != 0.0) {
            let own = self.said.pins.iter().find(|pin| (pin.nm - nm).abs() < 0.01);
            let px = own.map_or(tick.px, |pin| pin.px) + STEP_PX * steps;
            self.pin(
                found,
                Pin {
                    px,
                    nm,
                    is_exact: true,
                },
            );
        }
    }

    /// Sets a pin, in place of another of its wavelength.
    fn pin(&mut self, found: &Photograph, pin: Pin) {
        let last = found.found.profile.columns() as f64 - 1.0;
        let mut said = self.said.clone();
        said.pins.retain(|old| (old.nm - pin.nm).abs() > 0.01);
        said.pins.push(Pin {
            px: pin.px.clamp(0.0, last),
            ..pin
        });
        if found.is_by_lines() {
            said.lamp = Self::lamp_of(found);
        }
        self.say(said);
    }

    /// The lamp whose lines a hand has put right.
    fn lamp_of(found: &Photograph) -> LampChoice {
        let best = found
            .answer
            .as_ref()
            .and_then(|answer| answer.best.as_ref());
        best.map_or(LampChoice::Auto, |best| LampChoice::Is(best.lamp))
    }

    /// A hand moves a tick to another column, takes its pin away, or asks for a pin at a peak.
    pub(super) fn drag(
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
        if response.clicked() {
            response.request_focus();
            self.by_hand.chosen_nm = nearest().map(|tick| tick.nm);
            let column = across.column(pointer.x);
            let is_free = nearest().is_none() && column >= 0.0;
            self.by_hand.column = is_free.then(|| near_peak(found, column));
            if let Some(curve) = found.curve().filter(|_| is_free) {
                self.by_hand.nm = (10.0 * curve.nm(column)).round() / 10.0;
            }
            return;
        }
        if response.drag_started()
            && let Some(tick) = nearest()
        {
            response.request_focus();
            self.by_hand.chosen_nm = Some(tick.nm);
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
            // Alt: exactly where it was let go, also beside a peak.
            let is_exact = response.ctx.input(|i| i.modifiers.alt);
            let nm = tick.nm;
            self.pin(found, Pin { px, nm, is_exact });
        }
    }
}

/// A column, or the peak that is so near that it is meant.
fn near_peak(found: &Photograph, column: f64) -> f64 {
    let reach = (0.012 * found.found.profile.columns() as f64).max(4.0);
    let away = |px: f64| (px - column).abs();
    let peaks = found.peaks().peaks.iter().map(|peak| peak.px);
    let near = peaks.filter(|px| away(*px) <= reach);
    near.min_by(|a, b| away(*a).total_cmp(&away(*b)))
        .unwrap_or(column)
}

/// The lines of the lamp; those that are only suggested are dashed, those set by hand have a head.
pub(super) fn draw_ticks(
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
        let words = fixed(tick.nm, 1);
        let galley = ui.painter().layout_no_wrap(words, font.clone(), ink);
        let half = 0.5 * galley.size().x;
        if (tick.is_strong || held.is_some()) && x - half > free_from {
            free_from = x + half + 4.0;
            let at = pos2(x - half, rect.top() - galley.size().y - 1.0);
            ui.painter().galley(at, galley, ink);
        }
    }
}
