//! The planes that diagrams are drawn in.

/// A chromaticity diagram.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub(crate) enum Plane {
    /// CIE 1931 x, y.
    #[default]
    Xy,
    /// CIE 1976 u', v'.
    Uv1976,
}

impl Plane {
    /// A point of x, y in this plane.
    pub(crate) fn of_xy(self, xy: [f64; 2]) -> [f64; 2] {
        match self {
            Self::Xy => xy,
            Self::Uv1976 => uv_1976_from_xy(xy),
        }
    }

    /// x, y of a point in this plane.
    pub(crate) fn to_xy(self, at: [f64; 2]) -> [f64; 2] {
        match self {
            Self::Xy => at,
            Self::Uv1976 => xy_from_uv_1976(at),
        }
    }
}

/// CIE 1976 `[u', v']` of `[x, y]`; the white E where the formula has no value.
pub(crate) fn uv_1976_from_xy([x, y]: [f64; 2]) -> [f64; 2] {
    let below = -2.0 * x + 12.0 * y + 3.0;
    finite([4.0 * x / below, 9.0 * y / below], [4.0 / 19.0, 9.0 / 19.0])
}

/// `[x, y]` of CIE 1976 `[u', v']`; the white E where the formula has no value.
pub(crate) fn xy_from_uv_1976([u, v]: [f64; 2]) -> [f64; 2] {
    let below = 6.0 * u - 16.0 * v + 12.0;
    finite([9.0 * u / below, 4.0 * v / below], [1.0 / 3.0; 2])
}

/// `[x, y]` of CIE 1960 `[u, v]`; the white E where the formula has no value.
pub(crate) fn xy_from_uv_1960([u, v]: [f64; 2]) -> [f64; 2] {
    xy_from_uv_1976([u, 1.5 * v])
}

fn finite(found: [f64; 2], otherwise: [f64; 2]) -> [f64; 2] {
    if found.iter().all(|v| v.is_finite()) {
        found
    } else {
        otherwise
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn every_plane_leads_back(x in 0.0..0.75_f64, y in 0.005..0.85_f64) {
            for plane in [Plane::Xy, Plane::Uv1976] {
                let back = plane.to_xy(plane.of_xy([x, y]));
                // Two quotients; the lowest y divides by little more than 1.5.
                prop_assert!((back[0] - x).abs() < 1e-12 && (back[1] - y).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn nothing_is_drawn_at_infinity() {
        for at in [[1.5, 0.0], [f64::NAN, 0.0], [f64::MAX, f64::MAX]] {
            assert!(uv_1976_from_xy(at).iter().all(|v| v.is_finite()));
            assert!(xy_from_uv_1976(at).iter().all(|v| v.is_finite()));
        }
    }
}
