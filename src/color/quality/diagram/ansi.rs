//! Quadrangles of ANSI C78.377: which white a lamp may be sold as.
//!
//! Basic nominal CCTs of the editions of 2015 and 2017. Neighbours share an edge; the corners are
//! at CCT = target -/+ tolerance and Duv = D(that CCT) +/- 0.006, with
//! `D(T) = 57700 / T^2 - 44.6 / T + 0.00854` from 2870 K on, else 0. The extended set of 2017 below
//! the locus is not here.

use std::sync::LazyLock;

use super::{locus::uv_1960_of_cct, plane::xy_from_uv_1960};

/// Nominal, target and tolerance, K.
const BASIC: [[f64; 3]; 10] = [
    [2200.0, 2238.0, 102.0],
    [2500.0, 2460.0, 120.0],
    [2700.0, 2725.0, 145.0],
    [3000.0, 3045.0, 175.0],
    [3500.0, 3465.0, 245.0],
    [4000.0, 3985.0, 275.0],
    [4500.0, 4503.0, 243.0],
    [5000.0, 5029.0, 283.0],
    [5700.0, 5667.0, 355.0],
    [6500.0, 6532.0, 510.0],
];

/// Half-width of a quadrangle to either side of its middle line, Duv.
pub(crate) const WHITE_HALF_WIDTH_DUV: f64 = 0.006;

/// Below this the middle line is the Planckian locus itself, K.
const OFFSET_FROM_K: f64 = 2870.0;

/// A nominal white.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Quadrangle {
    /// Nominal CCT, K.
    pub nominal_k: f64,
    /// Target CCT, K.
    pub target_k: f64,
    /// Tolerance of the CCT, K.
    pub tolerance_k: f64,
    /// Centre, xy.
    pub centre: [f64; 2],
    /// Corners, xy: warm upper, cool upper, cool lower, warm lower.
    pub corners: [[f64; 2]; 4],
}

/// The ten basic quadrangles, from warm to cool.
pub(crate) static QUADRANGLES: LazyLock<Vec<Quadrangle>> = LazyLock::new(|| {
    let xy = |kelvin: f64, duv: f64| uv_1960_of_cct(kelvin, duv).map_or([0.0; 2], xy_from_uv_1960);
    let of = |[nominal_k, target_k, tolerance_k]: [f64; 3]| {
        let (warm, cool) = (target_k - tolerance_k, target_k + tolerance_k);
        let corner = |kelvin: f64, sign: f64| {
            xy(
                kelvin,
                white_middle_duv(kelvin) + sign * WHITE_HALF_WIDTH_DUV,
            )
        };
        Quadrangle {
            nominal_k,
            target_k,
            tolerance_k,
            centre: xy(target_k, white_middle_duv(target_k)),
            corners: [
                corner(warm, 1.0),
                corner(cool, 1.0),
                corner(cool, -1.0),
                corner(warm, -1.0),
            ],
        }
    };
    BASIC.map(of).to_vec()
});

/// Duv of the middle line of the quadrangles; beyond them where their formula leads.
pub(crate) fn white_middle_duv(kelvin: f64) -> f64 {
    if kelvin < OFFSET_FROM_K {
        0.0
    } else {
        57_700.0 / (kelvin * kelvin) - 44.6 / kelvin + 0.00854
    }
}

/// The quadrangle that a colour lies in; `None` outside all of them.
pub(crate) fn quadrangle_of(xy: [f64; 2]) -> Option<&'static Quadrangle> {
    QUADRANGLES.iter().find(|quadrangle| {
        let corners = quadrangle.corners;
        let next = corners.iter().cycle().skip(1);
        // The corners go round one way: the point must be on the same side of all edges.
        let sides = corners
            .iter()
            .zip(next)
            .map(|(a, b)| (b[0] - a[0]) * (xy[1] - a[1]) - (b[1] - a[1]) * (xy[0] - a[0]));
        let sides: Vec<f64> = sides.collect();
        sides.iter().all(|s| *s >= 0.0) || sides.iter().all(|s| *s <= 0.0)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_centre_lies_in_its_own_quadrangle_and_neighbours_share_an_edge() {
        for quadrangle in QUADRANGLES.iter() {
            let found = quadrangle_of(quadrangle.centre).map(|q| q.nominal_k);
            assert_eq!(found, Some(quadrangle.nominal_k));
        }
        for pair in QUADRANGLES.windows(2) {
            assert_eq!(pair[0].corners[1], pair[1].corners[0]);
            assert_eq!(pair[0].corners[2], pair[1].corners[3]);
        }
        assert_eq!(quadrangle_of([0.2, 0.2]), None);
        assert_eq!(quadrangle_of([f64::NAN, 0.3]), None);
    }
}
