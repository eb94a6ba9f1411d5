//! MacAdam's ellipses of colours that look alike.
//!
//! Source: D. L. MacAdam, J. Opt. Soc. Am. 32, 247 (1942), observer PGN, as tabled in Wyszecki and
//! Stiles, Color Science, table 2(5.4.1). One step is one standard deviation of colour matching;
//! diagrams draw them ten times enlarged as a rule.

/// One ellipse, a single step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ellipse {
    /// Centre, xy.
    pub centre: [f64; 2],
    /// Long and short semi-axis, xy units.
    pub semi_axes: [f64; 2],
    /// Angle of the long axis from the x axis, degrees.
    pub angle_deg: f64,
}

impl Ellipse {
    /// Points around the ellipse enlarged `steps` times, xy, not closed.
    pub(crate) fn outline(&self, steps: f64, points: usize) -> Vec<[f64; 2]> {
        let (sin, cos) = self.angle_deg.to_radians().sin_cos();
        let [long, short] = self.semi_axes.map(|axis| axis * steps);
        (0..points)
            .map(|i| {
                let turn = std::f64::consts::TAU * i as f64 / points as f64;
                let (across, along) = (short * turn.sin(), long * turn.cos());
                [
                    self.centre[0] + along * cos - across * sin,
                    self.centre[1] + along * sin + across * cos,
                ]
            })
            .collect()
    }

    /// Distance of a point from the centre, in steps of this ellipse.
    #[cfg(test)]
    pub(crate) fn steps_to(&self, xy: [f64; 2]) -> f64 {
        let (sin, cos) = self.angle_deg.to_radians().sin_cos();
        let [dx, dy] = [xy[0] - self.centre[0], xy[1] - self.centre[1]];
        let along = (dx * cos + dy * sin) / self.semi_axes[0];
        let across = (dy * cos - dx * sin) / self.semi_axes[1];
        along.hypot(across)
    }
}

const fn ellipse([x, y, long, short, angle_deg]: [f64; 5]) -> Ellipse {
    Ellipse {
        centre: [x, y],
        semi_axes: [long, short],
        angle_deg,
    }
}

/// The 25 ellipses.
pub(crate) const ELLIPSES: [Ellipse; 25] = [
    ellipse([0.160, 0.057, 0.00085, 0.00035, 62.5]),
    ellipse([0.187, 0.118, 0.00220, 0.00055, 77.0]),
    ellipse([0.253, 0.125, 0.00250, 0.00050, 55.5]),
    ellipse([0.150, 0.680, 0.00960, 0.00230, 105.0]),
    ellipse([0.131, 0.521, 0.00470, 0.00200, 112.5]),
    ellipse([0.212, 0.550, 0.00580, 0.00230, 100.0]),
    ellipse([0.258, 0.450, 0.00500, 0.00200, 92.0]),
    ellipse([0.152, 0.365, 0.00380, 0.00190, 110.0]),
    ellipse([0.280, 0.385, 0.00400, 0.00150, 75.5]),
    ellipse([0.380, 0.498, 0.00440, 0.00120, 70.0]),
    ellipse([0.160, 0.200, 0.00210, 0.00095, 104.0]),
    ellipse([0.228, 0.250, 0.00310, 0.00090, 72.0]),
    ellipse([0.305, 0.323, 0.00230, 0.00090, 58.0]),
    ellipse([0.385, 0.393, 0.00380, 0.00160, 65.5]),
    ellipse([0.472, 0.399, 0.00320, 0.00140, 51.0]),
    ellipse([0.527, 0.350, 0.00260, 0.00130, 20.0]),
    ellipse([0.475, 0.300, 0.00290, 0.00110, 28.5]),
    ellipse([0.510, 0.236, 0.00240, 0.00120, 29.5]),
    ellipse([0.596, 0.283, 0.00260, 0.00130, 13.0]),
    ellipse([0.344, 0.284, 0.00230, 0.00090, 60.0]),
    ellipse([0.390, 0.237, 0.00250, 0.00100, 47.0]),
    ellipse([0.441, 0.198, 0.00280, 0.00095, 34.5]),
    ellipse([0.278, 0.223, 0.00240, 0.00055, 57.5]),
    ellipse([0.300, 0.163, 0.00290, 0.00060, 54.0]),
    ellipse([0.365, 0.153, 0.00360, 0.00095, 40.0]),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_outline_is_as_many_steps_away_as_it_was_enlarged() {
        for ellipse in ELLIPSES {
            for point in ellipse.outline(7.0, 36) {
                // Differences of numbers near 0.5, 1e-3 in size: 13 digits are left.
                assert!((ellipse.steps_to(point) - 7.0).abs() < 1e-9);
            }
        }
    }
}
