//! Triangles on the grid: which pixels lie inside, and values that change over them.

use eframe::egui::Rect;

/// Steps of the vertex grid in one pixel.
const SUBPIXELS: f64 = 256.0;

/// The pixels that a mesh may touch: columns and rows, ends excluded.
#[derive(Clone, Copy)]
pub(super) struct Window {
    pub(super) columns: [i32; 2],
    pub(super) rows: [i32; 2],
}

impl Window {
    pub(super) fn new(clip: Rect, pixels_per_point: f32, size_px: [usize; 2]) -> Self {
        let pixel = |at: f32, most: usize| {
            let at = (at * pixels_per_point).round();
            at.clamp(0.0, most as f32) as i32
        };
        Self {
            columns: [clip.min.x, clip.max.x].map(|x| pixel(x, size_px[0])),
            rows: [clip.min.y, clip.max.y].map(|y| pixel(y, size_px[1])),
        }
    }
}

/// One edge of a triangle, as the sign test that tells on which side of it a pixel centre lies.
pub(super) struct Edge {
    from: [f64; 2],
    along: [f64; 2],
    /// Whether a centre exactly on the edge belongs to the triangle: true for top and left edges.
    closed: bool,
}

impl Edge {
    /// The edge between two corners in grid steps, with the triangle on its right (rows go down).
    fn new(from: [f64; 2], to: [f64; 2]) -> Self {
        let along = [to[0] - from[0], to[1] - from[1]];
        let closed = along[1] < 0.0 || (along[1] == 0.0 && along[0] > 0.0);
        Self {
            from,
            along,
            closed,
        }
    }

    /// Narrows a run of columns (end excluded) to the pixels of a row that lie inside.
    pub(super) fn narrow(&self, row: i32, run: &mut [i32; 2]) {
        // Inside: level - slope * column > 0, or = 0 where the edge is closed.
        let slope = self.along[1] * SUBPIXELS;
        let level = self.along[0] * (centre(row) - self.from[1])
            - self.along[1] * (SUBPIXELS / 2.0 - self.from[0]);
        if slope == 0.0 {
            if level < 0.0 || (level == 0.0 && !self.closed) {
                run[1] = run[0];
            }
            return;
        }
        // Both are whole numbers, so the quotient is exact where it is whole, and elsewhere too
        // far from a whole number to be rounded across it.
        let crossing = level / slope;
        let crossing = crossing
            .max(f64::from(run[0]) - 1.0)
            .min(f64::from(run[1]) + 1.0);
        let truncated = crossing as i32;
        let below = truncated - i32::from(f64::from(truncated) > crossing);
        let exact = f64::from(below) == crossing;
        if slope > 0.0 {
            let end = below + i32::from(!exact || self.closed);
            run[1] = run[1].min(end);
        } else {
            let start = below + i32::from(!exact || !self.closed);
            run[0] = run[0].max(start);
        }
    }
}

/// The middle of a pixel's column or row, in grid steps.
fn centre(pixel: i32) -> f64 {
    f64::from(pixel) * SUBPIXELS + SUBPIXELS / 2.0
}

/// A value that changes linearly over a triangle.
#[derive(Clone, Copy, Default)]
pub(super) struct Plane {
    /// At the centre of the pixel in column 0, row 0.
    origin: f64,
    pub(super) per_column: f64,
    pub(super) per_row: f64,
}

impl Plane {
    pub(super) fn at(&self, column: i32, row: i32) -> f32 {
        (self.origin + self.per_column * f64::from(column) + self.per_row * f64::from(row)) as f32
    }
}

/// A triangle on the grid: its three corners in turning order, and their edges.
pub(super) struct Triangle {
    corners: [[f64; 2]; 3],
    /// Edge `i` is opposite corner `i`.
    pub(super) edges: [Edge; 3],
    /// Twice the area, in squared grid steps; positive.
    area: f64,
}

impl Triangle {
    /// A triangle from corners in pixels, and whether two corners changed places; `None` if flat.
    pub(super) fn new(corners: [[f64; 2]; 3]) -> Option<(Self, bool)> {
        let [a, mut b, mut c] = corners.map(|corner| corner.map(|x| (x * SUBPIXELS).round()));
        let mut area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        if area == 0.0 || !area.is_finite() {
            return None;
        }
        let turned = area < 0.0;
        if turned {
            std::mem::swap(&mut b, &mut c);
            area = -area;
        }
        let triangle = Self {
            corners: [a, b, c],
            edges: [Edge::new(b, c), Edge::new(c, a), Edge::new(a, b)],
            area,
        };
        Some((triangle, turned))
    }

    /// First and last row (excluded) that the triangle may touch within a window.
    pub(super) fn rows(&self, window: Window) -> std::ops::Range<i32> {
        let [low, high] = self.extent(1);
        low.max(window.rows[0])..high.min(window.rows[1])
    }

    /// Pixels that the triangle spans along an axis (0 = columns, 1 = rows), end excluded.
    pub(super) fn extent(&self, axis: usize) -> [i32; 2] {
        let [a, b, c] = self.corners.map(|corner| corner[axis] / SUBPIXELS);
        // One pixel too many on either side costs nothing: the edges decide.
        let (low, high) = (a.min(b).min(c) as i32, a.max(b).max(c) as i32);
        [low.saturating_sub(1), high.saturating_add(2)]
    }

    /// The plane through one value at each corner.
    pub(super) fn plane(&self, values: [f32; 3]) -> Plane {
        let first = f64::from(values[0]);
        let mut plane = Plane::default();
        // Differences to the first corner, so that equal values give a plane that is exactly flat.
        for (value, edge) in values.into_iter().zip(&self.edges).skip(1) {
            let share = (f64::from(value) - first) * SUBPIXELS / self.area;
            plane.per_column -= share * edge.along[1];
            plane.per_row += share * edge.along[0];
        }
        let [x, y] = self.corners[0].map(|at| (at - SUBPIXELS / 2.0) / SUBPIXELS);
        plane.origin = first - plane.per_column * x - plane.per_row * y;
        plane
    }
}
