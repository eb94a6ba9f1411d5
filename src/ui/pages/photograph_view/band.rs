//! The band over the picture: drawn, and moved by its edges and its end.

use eframe::egui;
use egui::{Color32, CursorIcon, Pos2, Rect, Stroke, Ui, pos2};

use super::{Hand, PhotographView};
use crate::{
    app::photograph::SeenPhotograph,
    photographs::strip::{ByHand, Strip},
    ui::{swatch, theme::Theme},
};

/// A hand takes an edge that is no farther off, points.
const REACH: f32 = 6.0;
/// Size of the handle that turns the band, points.
const HANDLE: f32 = 5.0;

/// Part of the band that a hand moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Edge {
    First,
    Last,
    Upper,
    Lower,
    /// The middle of its last end, which turns it.
    End,
}

/// Corners of a strip in pixels of the picture, in turn.
fn corners(strip: &Strip) -> [(f64, f64); 4] {
    let (last, half) = (strip.columns as f64 - 1.0, strip.half);
    let corners = [(0.0, -half), (last, -half), (last, half), (0.0, half)];
    corners.map(|(column, v)| strip.pixel_of(column, v))
}

/// The outline of a strip, and the handle at its end.
pub(super) fn draw(ui: &Ui, theme: Theme, strip: &Strip, to_screen: impl Fn(f64, f64) -> Pos2) {
    let ink = Stroke::new(theme.line, theme.accent);
    let corners = corners(strip).map(|(x, y)| to_screen(x, y));
    for i in 0..4 {
        ui.painter()
            .line_segment([corners[i], corners[(i + 1) % 4]], ink);
    }
    let end = corners[1] + 0.5 * (corners[2] - corners[1]);
    ui.painter().circle(
        end,
        HANDLE,
        theme.ground,
        Stroke::new(theme.line, theme.accent),
    );
}

/// The edge of a strip that is within reach of a place, in pixels of the picture.
fn edge_at(strip: &Strip, (x, y): (f64, f64), reach: f64) -> Option<Edge> {
    let (column, v) = strip.column_of(x, y);
    let last = strip.columns as f64 - 1.0;
    let is_along = (-reach..=last + reach).contains(&column);
    let is_across = v.abs() <= strip.half + reach;
    if !is_along || !is_across {
        return None;
    }
    let distances = [
        (Edge::End, (column - last).hypot(v)),
        (Edge::First, column.abs()),
        (Edge::Last, (column - last).abs()),
        (Edge::Upper, (v + strip.half).abs()),
        (Edge::Lower, (v - strip.half).abs()),
    ];
    let mut near = distances.into_iter().filter(|(_, away)| *away <= reach);
    near.next().map(|(edge, _)| edge)
}

/// The strip as a person has set it, with an edge at another place.
fn with_edge_at(strip: &Strip, edge: Edge, (x, y): (f64, f64), kept: &ByHand) -> ByHand {
    let (column, v) = strip.column_of(x, y);
    let (mut x0, mut last) = (strip.x0, strip.x0 + strip.columns as f64 - 1.0);
    let (mut upper, mut lower) = (-strip.half, strip.half);
    let mut turn_deg = strip.turn_deg;
    match edge {
        Edge::First => x0 = (strip.x0 + column).min(last - 24.0),
        Edge::Last => last = (strip.x0 + column).max(x0 + 24.0),
        Edge::Upper => upper = v.min(lower - 3.0),
        Edge::Lower => lower = v.max(upper + 3.0),
        Edge::End => {
            let (start, along) = (strip.pixel_of(0.0, 0.0), (x, y));
            let (dx, dy) = (along.0 - start.0, along.1 - start.1);
            let (dx, dy) = if strip.is_vertical {
                (dy, dx)
            } else {
                (dx, dy)
            };
            turn_deg = dy.atan2(dx).to_degrees().clamp(-45.0, 45.0);
        }
    }
    // The area is told where it was before it is turned about the picture's middle.
    let slope = strip.turn_deg.to_radians().tan();
    let middle = strip.centre_y + (0.5 * (x0 + last) - strip.xm) * slope;
    let (y0, y1) = (middle + upper, middle + lower);
    let area = if strip.is_vertical {
        [y0, x0, y1, last]
    } else {
        [x0, y0, last, y1]
    };
    ByHand {
        is_vertical: Some(strip.is_vertical),
        area: Some(area),
        turn_deg: Some(turn_deg),
        ..kept.clone()
    }
}

impl PhotographView {
    /// A hand draws another band over the picture, or moves an edge of the one that is there.
    pub(super) fn band(
        &mut self,
        ui: &Ui,
        theme: Theme,
        response: &egui::Response,
        (rect, scale): (Rect, f32),
        seen: &SeenPhotograph,
    ) {
        let touched = response.interact_pointer_pos();
        let Some(pointer) = touched.or_else(|| response.hover_pos()) else {
            return;
        };
        let place = |at: Pos2| {
            let [w, h] = seen.size.map(|side| side as f32 - 1.0);
            let at = (at - rect.min) / scale;
            pos2((at.x - 0.5).clamp(0.0, w), (at.y - 0.5).clamp(0.0, h))
        };
        let at = place(pointer);
        let at = (f64::from(at.x), f64::from(at.y));
        let strip = seen.found.as_ref().ok().map(|found| found.found.strip);
        let edge = strip.and_then(|strip| edge_at(&strip, at, f64::from(REACH / scale)));
        if let Some(edge) = edge {
            let is_upright =
                strip.is_some_and(|s| s.is_vertical) == matches!(edge, Edge::Upper | Edge::Lower);
            ui.ctx().set_cursor_icon(match (edge, is_upright) {
                (Edge::End, _) => CursorIcon::Grab,
                (_, true) => CursorIcon::ResizeHorizontal,
                (_, false) => CursorIcon::ResizeVertical,
            });
        }
        if response.drag_started() {
            let from = response
                .ctx
                .input(|i| i.pointer.press_origin())
                .unwrap_or(pointer);
            let start = place(from);
            let start_at = (f64::from(start.x), f64::from(start.y));
            let edge = strip.and_then(|s| edge_at(&s, start_at, f64::from(REACH / scale)));
            self.hand = Some(edge.map_or(Hand::Band(start), Hand::Edge));
        }
        match (self.hand, strip) {
            (Some(Hand::Band(from)), _) => {
                let to = place(pointer);
                let back = |at: Pos2| rect.min + at.to_vec2() * scale;
                let drawn = Rect::from_two_pos(back(from), back(to));
                swatch::outline(ui, drawn, Stroke::new(theme.line, Color32::WHITE));
                let (x, y) = (
                    (from.x.min(to.x), from.x.max(to.x)),
                    (from.y.min(to.y), from.y.max(to.y)),
                );
                if response.drag_stopped() {
                    self.hand = None;
                    if x.1 - x.0 >= 3.0 && y.1 - y.0 >= 3.0 {
                        let area = [x.0, y.0, x.1, y.1].map(f64::from);
                        self.set_strip(ByHand {
                            area: Some(area),
                            strip: None,
                            ..self.said.strip.clone()
                        });
                    }
                }
            }
            (Some(Hand::Edge(edge)), Some(strip)) if response.drag_stopped() => {
                self.hand = None;
                let moved = with_edge_at(&strip, edge, at, &self.said.strip);
                self.set_strip(ByHand {
                    strip: None,
                    ..moved
                });
            }
            (Some(Hand::Edge(_)), Some(_)) => {
                let ink = Stroke::new(theme.line, Color32::WHITE);
                ui.painter().circle_stroke(pointer, HANDLE, ink);
            }
            _ => {}
        }
    }

    /// The strip as a person has set it; what an instrument says of it counts no more.
    pub(super) fn set_strip(&mut self, strip: ByHand) {
        let mut said = self.said.clone();
        if said.strip != strip {
            said.instrument = None;
        }
        said.strip = strip;
        self.say(said);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn strip(is_vertical: bool) -> Strip {
        Strip {
            is_vertical,
            turn_deg: 3.0,
            shear: 0.0,
            smile: 0.0,
            xm: 319.5,
            centre_y: 180.0,
            half: 30.0,
            x0: 100.0,
            columns: 401,
        }
    }

    #[test]
    fn an_edge_is_taken_where_it_is_and_moves_alone() {
        for is_vertical in [false, true] {
            let strip = strip(is_vertical);
            let lower = strip.pixel_of(200.0, 30.0);
            assert_eq!(edge_at(&strip, lower, 4.0), Some(Edge::Lower));
            assert_eq!(
                edge_at(&strip, strip.pixel_of(0.0, 5.0), 4.0),
                Some(Edge::First)
            );
            assert_eq!(
                edge_at(&strip, strip.pixel_of(400.0, 0.0), 4.0),
                Some(Edge::End)
            );
            assert_eq!(edge_at(&strip, strip.pixel_of(200.0, 0.0), 4.0), None);
            let to = strip.pixel_of(200.0, 40.0);
            let moved = with_edge_at(&strip, Edge::Lower, to, &ByHand::default());
            let [x0, y0, x1, y1] = moved.area.expect("an area");
            let (along, across) = if is_vertical {
                (y1 - y0, x1 - x0)
            } else {
                (x1 - x0, y1 - y0)
            };
            assert!((along - 400.0).abs() < 1e-9 && (across - 70.0).abs() < 1e-9);
            assert_eq!(moved.turn_deg, Some(3.0));
        }
    }

    #[test]
    fn the_end_turns_the_band() {
        let strip = strip(false);
        let start = strip.pixel_of(0.0, 0.0);
        let to = (
            start.0 + 300.0,
            start.1 - 300.0 * 5.0_f64.to_radians().tan(),
        );
        let moved = with_edge_at(&strip, Edge::End, to, &ByHand::default());
        assert!((moved.turn_deg.expect("a turn") + 5.0).abs() < 1e-9);
    }
}
