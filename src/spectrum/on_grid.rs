//! From measured data to a grid: the one way, for models, colours and files.

use super::{
    band::Band,
    sampled::{Outside, Sampled},
};

/// The end of a table stands on a grid point, the more the nearer, within this share of a step: of
/// a wavelength in nm that is rounded in its third decimal 2 % are lost.
const ON_A_GRID_POINT: f64 = 0.04;

impl Sampled {
    /// The spectrum on an even grid: `points` values (at least 2) at `first_nm`, `first_nm +
    /// step_nm`, ...
    ///
    /// Every way from data to a grid goes through here. The table is cut at its samples and at the
    /// grid points, and the area of each straight piece goes to the two grid points beside it, the
    /// nearer the more: so the area is kept, a line finer than the grid keeps its power and its
    /// centroid, and the integral of data in pieces of up to half a step, times any weight that is
    /// read off linearly, is that of the data. A piece as long as a step is shared out by its two
    /// ends alone, as by the trapezoid rule, so that a table on the grid's own points comes back as
    /// it is; between half a step and a whole one the first way goes over into the second. Nothing
    /// jumps when samples are moved a little.
    ///
    /// A value is the mean over what the grid covers around its point. A table that is zero
    /// outside and begins between two grid points fills the mean in part. Where it begins at a
    /// grid point, its first value stands for half its own step outside too (half a step of the
    /// grid at most): a table of the grid's steps counts there in full, as in the sums of the CIE.
    ///
    /// # Panics
    /// For fewer than two points.
    pub(crate) fn on_grid(
        &self,
        first_nm: f64,
        step_nm: f64,
        points: usize,
        outside: Outside,
    ) -> Vec<f64> {
        assert!(points >= 2, "a grid has two points at least");
        let grid = |index: usize| first_nm + step_nm * index as f64;
        let last_nm = grid(points - 1);
        let mut values = vec![0.0; points];
        // Samples are walked along with the grid: this is the first one beyond a cell's left end.
        let mut next = self.nm().partition_point(|nm| *nm <= first_nm);
        for cell in 0..points - 1 {
            let (left, right) = (grid(cell), grid(cell + 1));
            let inside = self.nm()[next..].iter().take_while(|nm| **nm < right);
            let past = next + inside.count();
            let halves = self.shared_out(left, right, next..past, outside);
            values[cell] += halves[0];
            values[cell + 1] += halves[1];
            next = past + usize::from(self.nm().get(past) == Some(&right));
        }
        if outside == Outside::Zero {
            let last = self.len() - 1;
            let ends = [
                (0, 1.min(last), self.first_nm() - first_nm),
                (last, last.saturating_sub(1), last_nm - self.last_nm()),
            ];
            for (sample, beside, room) in ends {
                let nm = self.nm()[sample];
                if !(first_nm..=last_nm).contains(&nm) {
                    continue;
                }
                let x = (nm - first_nm) / step_nm;
                let cell = (x as usize).min(points - 2);
                let on_it = (1.0 - (x - x.round()).abs() / ON_A_GRID_POINT).max(0.0);
                let own_step = (self.nm()[beside] - nm).abs().min(step_nm) / step_nm;
                let beyond = self.values()[sample] * (room / step_nm).min(0.5 * own_step * on_it);
                let t = x - cell as f64;
                values[cell] += beyond * (1.0 - t);
                values[cell + 1] += beyond * t;
            }
        }
        // The grid covers half as much around its ends.
        values[0] *= 2.0;
        values[points - 1] *= 2.0;
        values
    }

    /// The spectrum on the 1 nm grid of a band, one value per grid point (`Sampled::on_grid`).
    pub fn on_band(&self, band: Band, outside: Outside) -> Vec<f64> {
        self.on_grid(band.min_nm(), 1.0, band.points(), outside)
    }

    /// The spectrum on whole nm `first_nm..=last_nm`, for sums of the CIE ([`Sampled::on_grid`]).
    pub(crate) fn on_whole_nm(&self, first_nm: u32, last_nm: u32, outside: Outside) -> Vec<f64> {
        let points = (last_nm - first_nm + 1) as usize;
        self.on_grid(f64::from(first_nm), 1.0, points, outside)
    }

    /// The value at a place on the straight line that ends at the sample `next`.
    fn on_line(&self, next: usize, nm: f64, outside: Outside) -> f64 {
        match outside {
            _ if (1..self.len()).contains(&next) => self.on_segment(next - 1, nm),
            Outside::Zero => 0.0,
            Outside::Hold => self.values()[next.min(self.len() - 1)],
        }
    }

    /// The area between two grid points shared out to them, as shares of the step; `inside` are
    /// the samples between them.
    fn shared_out(
        &self,
        left: f64,
        right: f64,
        inside: std::ops::Range<usize>,
        outside: Outside,
    ) -> [f64; 2] {
        let step = right - left;
        let mut halves = [0.0; 2];
        let mut add = |[a, at_a]: [f64; 2], [b, at_b]: [f64; 2]| {
            let (s, t) = ((a - left) / step, (b - left) / step);
            // The integral of the straight line times one that rises from 0 to 1 over the step and
            // times one that falls; and the same by the piece's two ends.
            let exact = [
                (at_a * (3.0 - 2.0 * s - t) + at_b * (3.0 - s - 2.0 * t)) / 6.0,
                (at_a * (2.0 * s + t) + at_b * (s + 2.0 * t)) / 6.0,
            ];
            let by_ends = [
                0.5 * (at_a * (1.0 - s) + at_b * (1.0 - t)),
                0.5 * (at_a * s + at_b * t),
            ];
            let share = (2.0 * (t - s) - 1.0).clamp(0.0, 1.0);
            for ((half, exact), by_ends) in halves.iter_mut().zip(exact).zip(by_ends) {
                *half += (t - s) * (exact * (1.0 - share) + by_ends * share);
            }
        };
        let sample = |index: usize| [self.nm()[index], self.values()[index]];
        let is_dark = outside == Outside::Zero;
        let mut before = (!(is_dark && inside.start == 0))
            .then(|| [left, self.on_line(inside.start, left, outside)]);
        for here in inside.clone().map(sample) {
            if let Some(before) = before {
                add(before, here);
            }
            before = Some(here);
        }
        let is_beyond = is_dark && inside.end == self.len();
        if let Some(before) = before.filter(|_| !is_beyond) {
            add(before, [right, self.on_line(inside.end, right, outside)]);
        }
        halves
    }
}
