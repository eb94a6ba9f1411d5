//! Wavelength against columns: a cubic with weak priors, and its doubt.

use nalgebra::{Matrix4, Vector4};

/// A point that the curve goes through, with its doubt.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Point {
    pub px: f64,
    pub nm: f64,
    pub sigma_nm: f64,
}

/// Degree of a curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Degree {
    Straight,
    Quadratic,
    Cubic,
}

/// Deviation of a curve from a point that it was fitted without.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeftOut {
    /// Wavelength of the curve less that of the point.
    pub error_nm: f64,
    /// Its standard deviation: of the curve there, and of the point.
    pub sigma_nm: f64,
}

/// `nm = c0 + c1 x + c2 x^2 + c3 x^3`, `x = (px - centre) / scale`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curve {
    /// The column of x = 0.
    pub centre_px: f64,
    /// Columns for one of x: all of the strip's.
    pub scale_px: f64,
    /// Coefficients, nm.
    pub c: [f64; 4],
    /// Their covariance, nm^2.
    pub covariance: [[f64; 4]; 4],
}

/// Standard deviations of the curvature `2 c2 / c1` and of `c3 / c1` among spectrographs.
const CURVATURE: f64 = 0.35;
const THIRD: f64 = 0.15;
/// A coefficient that a curve has not.
const NONE: f64 = 1e-7;
/// Least error of any axis, nm.
const FLOOR_NM: f64 = 0.1;
/// A curve whose slope falls below this share of its mean anywhere may turn round.
const LEAST_SLOPE: f64 = 0.25;

impl Curve {
    /// The curve of coefficients over some columns, without doubt.
    pub fn new(columns: usize, c: [f64; 4]) -> Self {
        Self {
            centre_px: 0.5 * columns as f64,
            scale_px: columns as f64,
            c,
            covariance: [[0.0; 4]; 4],
        }
    }

    fn x(&self, px: f64) -> f64 {
        (px - self.centre_px) / self.scale_px
    }

    /// The wavelength at a column.
    pub fn nm(&self, px: f64) -> f64 {
        let x = self.x(px);
        let [c0, c1, c2, c3] = self.c;
        c0 + x * (c1 + x * (c2 + x * c3))
    }

    /// nm a column, negative where wavelengths fall.
    pub fn slope(&self, px: f64) -> f64 {
        let x = self.x(px);
        let [_, c1, c2, c3] = self.c;
        (c1 + x * (2.0 * c2 + x * 3.0 * c3)) / self.scale_px
    }

    /// Standard deviation of the wavelength at a column.
    pub fn sigma(&self, px: f64) -> f64 {
        let x = self.x(px);
        let powers = Vector4::new(1.0, x, x * x, x * x * x);
        let covariance = Matrix4::from_fn(|i, j| self.covariance[i][j]);
        (powers.dot(&(covariance * powers))).max(0.0).sqrt() + FLOOR_NM
    }

    /// The column of a wavelength within a range of columns, where the curve rises or falls all
    /// along.
    pub fn px(&self, nm: f64, from: f64, to: f64) -> Option<f64> {
        let sign = (self.nm(to) - self.nm(from)).signum();
        let beyond = |px: f64| (self.nm(px) - nm) * sign;
        if beyond(from) > 0.0 || beyond(to) < 0.0 {
            return None;
        }
        let (mut low, mut high) = (from, to);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if beyond(middle) < 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        Some(0.5 * (low + high))
    }

    /// Curvature: `2 c2 / c1`.
    pub(super) fn curvature(&self) -> f64 {
        2.0 * self.c[2] / self.c[1]
    }

    /// True if it rises or falls throughout, nowhere much slower than in the mean.
    pub fn is_monotone(&self) -> bool {
        self.turns_at().is_none()
    }

    /// Wavelength at which it would turn round, or comes near to it, nm.
    pub fn turns_at(&self) -> Option<f64> {
        let first = self.centre_px - 0.5 * self.scale_px;
        let mean = (self.nm(first + self.scale_px) - self.nm(first)) / self.scale_px;
        let places = (0..=64).map(|i| first + self.scale_px * f64::from(i) / 64.0);
        let mut slow =
            places.filter(|px| self.slope(*px) * mean.signum() < LEAST_SLOPE * mean.abs());
        slow.next().map(|px| self.nm(px))
    }

    /// The same curve with all columns moved to the right by some.
    #[must_use]
    pub fn moved(mut self, by_px: f64) -> Self {
        self.centre_px += by_px;
        self
    }

    /// The weighted fit through points, and how far one without each point is off it.
    ///
    /// `slope` is about how many nm all columns span: priors are shares of it. `None` where the
    /// points fix no curve.
    pub(super) fn fit(
        points: &[Point],
        columns: usize,
        slope: f64,
        degree: Degree,
    ) -> Option<(Self, Vec<LeftOut>)> {
        let mut curve = Self::new(columns, [0.0; 4]);
        if points.len() < 2 {
            return None;
        }
        let second = if degree == Degree::Straight {
            NONE
        } else {
            0.5 * CURVATURE
        };
        let third = if degree == Degree::Cubic { THIRD } else { NONE };
        let mut normal = Matrix4::zeros();
        normal[(2, 2)] = (second * slope).powi(-2);
        normal[(3, 3)] = (third * slope).powi(-2);
        let mut right = Vector4::zeros();
        let powers = |px: f64| {
            let x = curve.x(px);
            Vector4::new(1.0, x, x * x, x * x * x)
        };
        for point in points {
            let weight = point.sigma_nm.powi(-2);
            let powers = powers(point.px);
            normal += weight * powers * powers.transpose();
            right += weight * point.nm * powers;
        }
        let inverse = normal.cholesky()?.inverse();
        let c = inverse * right;
        if !c.iter().all(|c| c.is_finite()) {
            return None;
        }
        let left_out = |point: &Point| {
            let powers = powers(point.px);
            let own = powers.dot(&(inverse * powers)) * point.sigma_nm.powi(-2);
            let others = (1.0 - own).max(1e-9);
            LeftOut {
                error_nm: (powers.dot(&c) - point.nm) / others,
                sigma_nm: point.sigma_nm / others.sqrt(),
            }
        };
        let left_out: Vec<LeftOut> = points.iter().map(left_out).collect();
        let off = |p: &Point| ((p.nm - powers(p.px).dot(&c)) / p.sigma_nm).powi(2);
        let chi2: f64 = points.iter().map(off).sum();
        let scatter = (chi2 / (points.len() as f64 - 2.0).max(1.0)).max(1.0);
        curve.c = [c[0], c[1], c[2], c[3]];
        for i in 0..4 {
            for j in 0..4 {
                curve.covariance[i][j] = inverse[(i, j)] * scatter;
            }
        }
        Some((curve, left_out))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRUE: [f64; 4] = [550.0, -320.0, 18.0, 9.0];

    fn points(of: &Curve, places: &[f64]) -> Vec<Point> {
        let point = |px: &f64| Point {
            px: *px,
            nm: of.nm(*px),
            sigma_nm: 0.1,
        };
        places.iter().map(point).collect()
    }

    #[test]
    fn a_fit_finds_the_curve_that_points_were_made_of() {
        let truth = Curve::new(600, TRUE);
        let points = points(&truth, &[40.0, 130.0, 222.0, 310.0, 390.0, 470.0, 560.0]);
        let (found, left_out) = Curve::fit(&points, 600, 320.0, Degree::Cubic).expect("a curve");
        for px in [0.0, 300.0, 599.0] {
            assert!((found.nm(px) - truth.nm(px)).abs() < 0.1, "{px}");
            assert!(found.sigma(px) > 0.1 && found.sigma(px) < 3.0);
        }
        assert!(
            left_out.iter().all(|off| off.error_nm.abs() < 0.3),
            "{left_out:?}"
        );
        let px = found.px(500.0, 0.0, 599.0).expect("inside");
        assert!((found.nm(px) - 500.0).abs() < 1e-6);
        assert_eq!(found.px(900.0, 0.0, 599.0), None);
    }

    #[test]
    fn what_a_point_is_off_by_when_left_out_is_that_of_a_fit_without_it() {
        let truth = Curve::new(600, TRUE);
        let mut points = points(&truth, &[40.0, 130.0, 310.0, 390.0, 560.0]);
        points[4].nm += 3.0;
        let (_, left_out) = Curve::fit(&points, 600, 320.0, Degree::Quadratic).expect("a curve");
        let (without, _) =
            Curve::fit(&points[..4], 600, 320.0, Degree::Quadratic).expect("a curve");
        assert!((without.nm(560.0) - points[4].nm - left_out[4].error_nm).abs() < 1e-6);
    }

    #[test]
    fn a_curve_that_turns_is_seen() {
        assert!(Curve::new(600, TRUE).is_monotone());
        let turning = Curve::new(600, [550.0, 300.0, -290.0, 0.0]);
        assert!(!turning.is_monotone());
        assert!(Curve::fit(&[], 600, 300.0, Degree::Straight).is_none());
    }
}
