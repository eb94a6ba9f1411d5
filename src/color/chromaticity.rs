//! Chromaticity coordinates (CIE 15:2018): colour without its amount.
//!
//! ```text
//! x  = X / (X + Y + Z)          y  = Y / (X + Y + Z)
//! u' = 4X / (X + 15Y + 3Z)      v' = 9Y / (X + 15Y + 3Z)     CIE 1976
//! u  = u'                       v  = 2/3 v'                  CIE 1960, for CCT and Duv only
//! ```
//!
//! Every function returns `None` when the denominator is not positive or not finite.

use super::xyz::Xyz;

/// CIE `[x, y]`.
pub fn xy_from_xyz(xyz: Xyz) -> Option<[f64; 2]> {
    shares([xyz.x, xyz.y], xyz.x + xyz.y + xyz.z)
}

/// CIE 1976 `[u', v']`.
pub(crate) fn uv_1976_from_xyz(xyz: Xyz) -> Option<[f64; 2]> {
    shares(
        [4.0 * xyz.x, 9.0 * xyz.y],
        xyz.x + 15.0 * xyz.y + 3.0 * xyz.z,
    )
}

/// CIE 1960 `[u, v]`, the plane in which CCT and Duv are defined.
pub(crate) fn uv_1960_from_xyz(xyz: Xyz) -> Option<[f64; 2]> {
    shares(
        [4.0 * xyz.x, 6.0 * xyz.y],
        xyz.x + 15.0 * xyz.y + 3.0 * xyz.z,
    )
}

/// XYZ of a chromaticity at luminance `y_total`; `None` when `y` is not positive.
pub(crate) fn xyz_from_xy([x, y]: [f64; 2], y_total: f64) -> Option<Xyz> {
    let xyz = Xyz::new(x / y * y_total, y_total, (1.0 - x - y) / y * y_total);
    (y > 0.0 && xyz.is_finite()).then_some(xyz)
}

fn shares(parts: [f64; 2], whole: f64) -> Option<[f64; 2]> {
    let found = parts.map(|part| part / whole);
    let is_light = whole > 0.0 && whole.is_finite();
    (is_light && found.iter().all(|v| v.is_finite())).then_some(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_amounts_lie_at_one_third() {
        let [x, y] = xy_from_xyz(Xyz::new(7.0, 7.0, 7.0)).unwrap();
        assert_eq!([x, y], [1.0 / 3.0, 1.0 / 3.0]);
        let [u, v] = uv_1976_from_xyz(Xyz::new(1.0, 1.0, 1.0)).unwrap();
        assert_eq!([u, v], [4.0 / 19.0, 9.0 / 19.0]);
    }

    #[test]
    fn the_planes_of_1960_and_1976_differ_by_two_thirds_in_v() {
        let xyz = Xyz::new(31.0, 20.0, 4.0);
        let (new, old) = (
            uv_1976_from_xyz(xyz).unwrap(),
            uv_1960_from_xyz(xyz).unwrap(),
        );
        assert_eq!(new[0], old[0]);
        // One rounding of a number near 0.5.
        assert!((new[1] * 2.0 / 3.0 - old[1]).abs() < 1e-15);
    }

    #[test]
    fn a_chromaticity_leads_back_to_its_xyz() {
        let xyz = Xyz::new(95.0, 100.0, 108.0);
        let back = xyz_from_xy(xy_from_xyz(xyz).unwrap(), 100.0).unwrap();
        // Two divisions and two products near 100.
        assert!((back.x - xyz.x).abs() < 1e-12 && (back.z - xyz.z).abs() < 1e-12);
        assert_eq!(xyz_from_xy([0.3, 0.0], 1.0), None);
    }

    #[test]
    fn without_light_there_is_no_chromaticity() {
        for xyz in [
            Xyz::ZERO,
            Xyz::new(-1.0, -1.0, -1.0),
            Xyz::new(f64::MAX, f64::MAX, 0.0),
        ] {
            assert_eq!(xy_from_xyz(xyz), None);
            assert_eq!(uv_1976_from_xyz(xyz), None);
            assert_eq!(uv_1960_from_xyz(xyz), None);
        }
    }
}
