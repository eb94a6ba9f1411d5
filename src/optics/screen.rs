//! Energy on the columns of a screen, exactly.

/// An even row of columns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Columns {
    /// Left end of the first column.
    pub(super) from: f64,
    /// Width of a column.
    pub(super) width: f64,
    /// Number of columns.
    pub(super) count: usize,
}

/// Energy that falls on columns: a number and its X, Y, Z.
#[derive(Clone, Debug)]
pub(super) struct Deposit {
    columns: Columns,
    /// Energy put into single columns.
    parts: Vec<[f64; 4]>,
    /// By how much whole stretches of columns rise at their start and fall at their end.
    steps: Vec<[f64; 4]>,
}

/// A box of the width of a cell's extent on the screen, blurred by a box of the slit's image.
#[derive(Clone, Copy, Debug)]
struct Trapezoid {
    centre: f64,
    /// Half its foot.
    outer: f64,
    /// Half its flat top.
    inner: f64,
    /// Height for an area of 1.
    height: f64,
}

impl Trapezoid {
    /// Part of it to the left of a place, 0-1.
    fn below(&self, x: f64) -> f64 {
        let from_centre = x - self.centre;
        let off = from_centre.abs();
        if off <= self.inner {
            return 0.5 + from_centre * self.height;
        }
        let missing = (self.outer - off).max(0.0);
        let ramp = self.outer - self.inner;
        let beyond = if ramp > 0.0 {
            0.5 * self.height * missing * missing / ramp
        } else {
            0.0
        };
        if from_centre < 0.0 {
            beyond
        } else {
            1.0 - beyond
        }
    }
}

impl Deposit {
    pub(super) fn new(columns: Columns) -> Self {
        Self {
            columns,
            parts: vec![[0.0; 4]; columns.count],
            steps: vec![[0.0; 4]; columns.count + 1],
        }
    }

    /// Spreads an energy over the image of what extends from `a` to `b`, blurred by a box of width
    /// `blur`. Nothing falls outside the columns; what would is left out.
    pub(super) fn spread(&mut self, [a, b]: [f64; 2], blur: f64, energy: [f64; 4]) {
        let scale = 1.0 / self.columns.width;
        let place = |x: f64| (x - self.columns.from) * scale;
        let (extent, blur) = ((b - a).abs() * scale, blur * scale);
        let centre = 0.5 * (place(a) + place(b));
        let (wide, narrow) = (extent.max(blur), extent.min(blur));
        if !(centre.is_finite() && wide.is_finite()) {
            return;
        }
        let last = self.columns.count as f64;
        if wide <= 0.0 {
            // All at one place.
            if (0.0..last).contains(&centre) {
                add(&mut self.parts[centre as usize], energy, 1.0);
            }
            return;
        }
        let shape = Trapezoid {
            centre,
            outer: 0.5 * (wide + narrow),
            inner: 0.5 * (wide - narrow),
            height: 1.0 / wide,
        };
        let first = (centre - shape.outer).floor().clamp(0.0, last) as usize;
        let end = (centre + shape.outer).ceil().clamp(0.0, last) as usize;
        let flat_first = ((centre - shape.inner).ceil().clamp(0.0, last) as usize).max(first);
        let flat_end = ((centre + shape.inner).floor().clamp(0.0, last) as usize).min(end);
        if flat_end > flat_first + 2 {
            self.sloped(&shape, first, flat_first, energy);
            add(&mut self.steps[flat_first], energy, shape.height);
            add(&mut self.steps[flat_end], energy, -shape.height);
            self.sloped(&shape, flat_end, end, energy);
        } else {
            self.sloped(&shape, first, end, energy);
        }
    }

    fn sloped(&mut self, shape: &Trapezoid, first: usize, end: usize, energy: [f64; 4]) {
        let mut below = shape.below(first as f64);
        for column in first..end {
            let next = shape.below((column + 1) as f64);
            add(&mut self.parts[column], energy, next - below);
            below = next;
        }
    }

    /// Energy of each column.
    pub(super) fn columns(mut self) -> Vec<[f64; 4]> {
        let mut level = [0.0; 4];
        for (part, step) in self.parts.iter_mut().zip(&self.steps) {
            add(&mut level, *step, 1.0);
            add(part, level, 1.0);
        }
        self.parts
    }
}

fn add(to: &mut [f64; 4], energy: [f64; 4], share: f64) {
    for (to, energy) in to.iter_mut().zip(energy) {
        *to += share * energy;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row() -> Columns {
        Columns {
            from: 0.0,
            width: 1.0,
            count: 20,
        }
    }

    fn spread(ends: [f64; 2], blur: f64) -> Vec<f64> {
        let mut deposit = Deposit::new(row());
        deposit.spread(ends, blur, [1.0; 4]);
        deposit.columns().iter().map(|c| c[0]).collect()
    }

    #[test]
    fn a_box_covers_its_end_columns_in_part() {
        let found = spread([3.25, 3.25], 2.5);
        // From 2.0 to 4.5.
        let expected = [0.0, 0.0, 0.4, 0.4, 0.2];
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-15, "{found} {expected}");
        }
    }

    #[test]
    fn extent_and_blur_change_places_and_nothing_is_lost() {
        for (ends, blur) in [([4.1, 9.3], 2.2), ([5.6, 7.8], 5.2), ([6.7, 6.7], 0.0)] {
            let found = spread(ends, blur);
            // Sums of 20 parts of 1.
            assert!((found.iter().sum::<f64>() - 1.0).abs() < 1e-14);
        }
        let (wide, narrow) = (spread([4.1, 9.3], 2.2), spread([5.6, 7.8], 5.2));
        assert!(wide.iter().zip(&narrow).all(|(a, b)| (a - b).abs() < 1e-14));
    }

    #[test]
    fn what_falls_beside_is_left_out() {
        let found = spread([-2.0, 2.0], 0.0);
        assert!((found.iter().sum::<f64>() - 0.5).abs() < 1e-15);
        assert_eq!(spread([50.0, 60.0], 3.0), [0.0; 20]);
        assert_eq!(spread([f64::NAN, 1.0], 3.0), [0.0; 20]);
    }
}
