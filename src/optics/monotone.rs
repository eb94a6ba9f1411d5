//! A smooth curve through a table that never overshoots it.
//!
//! Method: M. Steffen, "A simple method for monotonic interpolation in one dimension", Astron.
//! Astrophys. 239 (1990) 443-450. A cubic between neighbours, with slopes at the nodes from the
//! parabola through three of them, limited so that the curve is monotone where the table is.

/// A table with a slope at each node.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Monotone {
    x: Vec<f64>,
    y: Vec<f64>,
    slopes: Vec<f64>,
}

impl Monotone {
    /// Through points of rising `x`, at least two of them.
    pub(super) fn new(x: &[f64], y: &[f64]) -> Self {
        let secant = |i: usize| (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
        let last = x.len() - 1;
        let slope = |i: usize| {
            if i == 0 || i == last {
                // The end's parabola may run anywhere: the secant keeps the curve in the table.
                return secant(if i == 0 { 0 } else { last - 1 });
            }
            let (before, after) = (secant(i - 1), secant(i));
            let (left, right) = (x[i] - x[i - 1], x[i + 1] - x[i]);
            let parabola = (before * right + after * left) / (left + right);
            let most = before.abs().min(after.abs()).min(0.5 * parabola.abs());
            (before.signum() + after.signum()) * most
        };
        Self {
            slopes: (0..=last).map(slope).collect(),
            x: x.to_vec(),
            y: y.to_vec(),
        }
    }

    /// The curve at a place and its slope there; `None` outside the table.
    pub(super) fn value_and_slope(&self, x: f64) -> Option<[f64; 2]> {
        let [first, last] = [self.x[0], self.x[self.x.len() - 1]];
        if !(first..=last).contains(&x) {
            return None;
        }
        let right = self
            .x
            .partition_point(|node| *node <= x)
            .clamp(1, self.x.len() - 1);
        let left = right - 1;
        let step = self.x[right] - self.x[left];
        let t = (x - self.x[left]) / step;
        let (a, b) = (self.y[left], self.y[right]);
        let (p, q) = (self.slopes[left] * step, self.slopes[right] * step);
        let rise = b - a;
        // Hermite's cubic in powers of t.
        let (second, third) = (3.0 * rise - 2.0 * p - q, p + q - 2.0 * rise);
        let value = a + t * (p + t * (second + t * third));
        Some([value, (p + t * (2.0 * second + t * 3.0 * third)) / step])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_straight_table_stays_straight_and_a_step_does_not_ring() {
        let x = [0.0, 1.0, 3.0, 4.0];
        let line = Monotone::new(&x, &[1.0, 2.0, 4.0, 5.0]);
        for at in [0.0, 0.3, 1.0, 2.2, 3.9, 4.0] {
            assert!((line.value_and_slope(at).unwrap()[0] - (1.0 + at)).abs() < 1e-14);
        }
        let step = Monotone::new(&x, &[0.0, 0.0, 1.0, 1.0]);
        for at in 0..=400 {
            let [y, slope] = step.value_and_slope(f64::from(at) / 100.0).unwrap();
            assert!(slope >= 0.0);
            assert!((0.0..=1.0).contains(&y));
        }
        assert_eq!(step.value_and_slope(4.1), None);
        assert_eq!(step.value_and_slope(f64::NAN), None);
    }
}
