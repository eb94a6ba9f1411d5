//! A panel of a drawing on screen.

use eframe::egui;
use egui::{Pos2, Rect, Vec2};

use super::paint;
use crate::app::chart::{Cells, Plot};

/// A panel of a drawing on screen.
#[derive(Clone, Copy, Debug)]
pub struct Screen {
    pub(super) plot: Plot,
    /// Where the drawing begins.
    pub(super) origin: Vec2,
}

impl Screen {
    /// The panel without what stands around it.
    pub fn frame(&self) -> Rect {
        paint::rect(self.origin, self.plot.field)
    }

    /// Where a point of the axes stands, in or beside the panel; `None` where it has no place.
    pub fn pos(&self, point: [f64; 2]) -> Option<Pos2> {
        let at = paint::pos(self.origin, self.plot.place(point)?);
        (at.x.is_finite() && at.y.is_finite()).then_some(at)
    }

    /// The values of the axes at a place.
    pub fn values(&self, at: Pos2) -> [f64; 2] {
        let at = at - self.origin;
        self.plot.values([f64::from(at.x), f64::from(at.y)])
    }

    pub(super) fn bar(&self, point: [f64; 2], width: f64) -> Option<Rect> {
        let field = self.plot.bar(point, width)?;
        Some(paint::rect(self.origin, field))
    }

    pub(super) fn cell(&self, cells: &Cells, index: usize) -> Option<Rect> {
        let field = self.plot.cell(cells, index)?;
        Some(paint::rect(self.origin, field))
    }
}
