//! From measured data to a grid: the one way, for models, colours and files.

use super::{
    band::Band,
    sampled::{Outside, Sampled},
};

/// A sample this near to a grid point (in steps of the grid) stands on it: rounded labels.
const ON_A_GRID_POINT: f64 = 1e-6;

impl Sampled {
    /// The spectrum on an even grid: `points` values (at least 2) at `first_nm`, `first_nm +
    /// step_nm`, ...
    ///
    /// Every way from data to a grid goes through here. Between two grid points in which the
    /// table is one straight line nothing is lost by reading it off; where it has samples in
    /// between, its area is shared out: each part of it goes to the two grid points beside it, the
    /// nearer the more. So the area is kept, a line finer than the grid keeps its power and its
    /// centroid, and the integral times any weight that is read off linearly is exact to rounding.
    ///
    /// A value is the mean over what the grid covers around its point. A table that is zero
    /// outside and begins between two grid points fills the mean in part; one that begins at a
    /// grid point counts there in full, as in the sums of the CIE.
    pub fn on_grid(
        &self,
        first_nm: f64,
        step_nm: f64,
        points: usize,
        outside: Outside,
    ) -> Vec<f64> {
        debug_assert!(points >= 2, "a grid has two points at least");
        let grid = |index: usize| first_nm + step_nm * index as f64;
        let near = ON_A_GRID_POINT * step_nm;
        let mut values = vec![0.0; points];
        // Samples are walked along with the grid: this is the first one beyond a cell's left end.
        let mut next = self.nm().partition_point(|nm| *nm <= first_nm + near);
        for cell in 0..points - 1 {
            let (left, right) = (grid(cell), grid(cell + 1));
            let past = next
                + self.nm()[next..]
                    .iter()
                    .take_while(|nm| **nm < right - near)
                    .count();
            let halves = if next < past {
                self.shared_out(left, right, next..past, outside)
            } else {
                [left, right].map(|nm| 0.5 * self.on_line(next, nm, outside))
            };
            values[cell] += halves[0];
            values[cell + 1] += halves[1];
            next = past
                + self.nm()[past..]
                    .iter()
                    .take_while(|nm| **nm <= right + near)
                    .count();
        }
        // The grid covers half as much around its ends, and so does a table that is zero outside
        // and ends at a grid point.
        let mut covered_half = vec![0, points - 1];
        if outside == Outside::Zero {
            for end in [self.first_nm(), self.last_nm()] {
                let index = ((end - first_nm) / step_nm).round();
                let is_inside = index > 0.0 && index < (points - 1) as f64;
                if is_inside && (first_nm + step_nm * index - end).abs() <= near {
                    covered_half.push(index as usize);
                }
            }
        }
        for index in covered_half {
            values[index] *= 2.0;
        }
        values
    }

    /// The spectrum on the 1 nm grid of a band, one value per grid point ([`Sampled::on_grid`]).
    pub fn on_band(&self, band: Band, outside: Outside) -> Vec<f64> {
        self.on_grid(band.min_nm(), 1.0, band.points(), outside)
    }

    /// The spectrum on whole nm `first_nm..=last_nm`, for sums of the CIE ([`Sampled::on_grid`]).
    pub fn on_whole_nm(&self, first_nm: u32, last_nm: u32, outside: Outside) -> Vec<f64> {
        let points = (last_nm - first_nm + 1) as usize;
        self.on_grid(f64::from(first_nm), 1.0, points, outside)
    }

    /// The value at a place on the straight line that ends at the sample `next`.
    fn on_line(&self, next: usize, nm: f64, outside: Outside) -> f64 {
        match outside {
            _ if (1..self.len()).contains(&next) => {
                // A rounded label may put a sample a trifle beyond the grid point.
                self.on_segment(next - 1, nm.clamp(self.nm()[next - 1], self.nm()[next]))
            }
            Outside::Zero => 0.0,
            Outside::Hold => self.values()[next.min(self.len() - 1)],
        }
    }

    /// The area between two grid points shared out to them, as shares of the step; `inside` are
    /// the samples between them, at least one.
    fn shared_out(
        &self,
        left: f64,
        right: f64,
        inside: std::ops::Range<usize>,
        outside: Outside,
    ) -> [f64; 2] {
        let step = right - left;
        let mut halves = [0.0; 2];
        // The integral of a straight line times one that falls from 1 to 0 over the step, and
        // times one that rises.
        let mut add = |[a, at_a]: [f64; 2], [b, at_b]: [f64; 2]| {
            let (s, t) = ((a - left) / step, (b - left) / step);
            let rising = (at_a * (2.0 * s + t) + at_b * (s + 2.0 * t)) / 6.0;
            halves[1] += (t - s) * rising;
            halves[0] += (t - s) * (0.5 * (at_a + at_b) - rising);
        };
        let sample = |index: usize| [self.nm()[index], self.values()[index]];
        let (head, tail) = (inside.start, inside.end - 1);
        let before = if head == 0 && outside == Outside::Zero {
            sample(head)
        } else {
            [left, self.on_line(head, left, outside)]
        };
        let after = if tail + 1 == self.len() && outside == Outside::Zero {
            sample(tail)
        } else {
            [right, self.on_line(inside.end, right, outside)]
        };
        add(before, sample(head));
        for index in inside.start..tail {
            add(sample(index), sample(index + 1));
        }
        add(sample(tail), after);
        halves
    }
}
