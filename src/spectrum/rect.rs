//! A rectangle of an image's pixels.

use serde::{Deserialize, Serialize};

/// A rectangle of pixels: its upper left corner and its size.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Rect {
    /// First column, from 0.
    pub x: usize,
    /// First row, from 0.
    pub y: usize,
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
}

impl Rect {
    /// One pixel.
    pub fn pixel(x: usize, y: usize) -> Self {
        Self {
            x,
            y,
            width: 1,
            height: 1,
        }
    }

    /// The rectangle with two pixels in opposite corners.
    pub fn between([ax, ay]: [usize; 2], [bx, by]: [usize; 2]) -> Self {
        Self {
            x: ax.min(bx),
            y: ay.min(by),
            width: ax.abs_diff(bx).saturating_add(1),
            height: ay.abs_diff(by).saturating_add(1),
        }
    }

    /// Number of pixels.
    pub fn pixels(self) -> usize {
        self.width.saturating_mul(self.height)
    }

    /// True if it has pixels and all of them are in another rectangle.
    pub(crate) fn is_inside(self, other: Self) -> bool {
        let fits = |at: usize, size: usize, from: usize, room: usize| {
            let end = at.checked_add(size);
            size > 0 && at >= from && end.is_some_and(|end| end <= from.saturating_add(room))
        };
        fits(self.x, self.width, other.x, other.width)
            && fits(self.y, self.height, other.y, other.height)
    }
}
