//! From values to points on screen and back.

use eframe::egui;
use egui::{Pos2, Rect, pos2};
use egui_plot::{PlotPoint, PlotTransform};

use crate::app::plot_svg::Scale;

/// Where a value stands on an axis; not finite where it has no place.
pub(super) fn coordinate(value: f64, scale: Scale) -> f64 {
    match scale {
        Scale::Linear => value,
        Scale::Log10 if value > 0.0 => value.log10(),
        Scale::Log10 => f64::NAN,
    }
}

/// The value at a place of an axis.
pub(super) fn value(at: f64, scale: Scale) -> f64 {
    match scale {
        Scale::Linear => at,
        Scale::Log10 => 10_f64.powf(at),
    }
}

/// Farthest from the origin that anything is painted, points: beyond, `f32` has no fractions.
const FARTHEST: f64 = 1e5;

/// The two axes of a panel on screen.
pub(super) struct Place {
    pub transform: PlotTransform,
    pub x_scale: Scale,
    pub y_scale: Scale,
}

impl Place {
    pub fn new(transform: PlotTransform, x_scale: Scale, y_scale: Scale) -> Self {
        Self {
            transform,
            x_scale,
            y_scale,
        }
    }

    pub fn frame(&self) -> Rect {
        *self.transform.frame()
    }

    /// Where a point stands on screen, points, exact even far outside; `None` where it has no
    /// place.
    pub fn exact(&self, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
        let bounds = self.transform.bounds();
        let part = |value: f64, scale, axis: usize| {
            let [low, high] = [bounds.min()[axis], bounds.max()[axis]];
            (coordinate(value, scale) - low) / (high - low)
        };
        let frame = self.frame();
        let at = [
            f64::from(frame.left()) + part(x, self.x_scale, 0) * f64::from(frame.width()),
            f64::from(frame.bottom()) - part(y, self.y_scale, 1) * f64::from(frame.height()),
        ];
        at.iter().all(|c| c.is_finite()).then_some(at)
    }

    /// Where a point stands on screen; `None` where it has no place.
    pub fn pos(&self, point: [f64; 2]) -> Option<Pos2> {
        let [x, y] = self.exact(point)?.map(|c| c.clamp(-FARTHEST, FARTHEST));
        Some(pos2(x as f32, y as f32))
    }

    /// Where marks that stand on a value start: 0 is under a logarithmic axis.
    pub fn foot(&self, x: f64, base: f64) -> Option<Pos2> {
        if self.y_scale == Scale::Log10 && base <= 0.0 {
            let low = value(self.transform.bounds().min()[1], self.y_scale);
            // A little lower, so that no rounding shows the end.
            return self.pos([x, low]).map(|at| at + egui::vec2(0.0, 2.0));
        }
        self.pos([x, base])
    }

    /// The values at a place on screen.
    pub fn values(&self, at: Pos2) -> [f64; 2] {
        let PlotPoint { x, y } = self.transform.value_from_position(at);
        [value(x, self.x_scale), value(y, self.y_scale)]
    }
}
