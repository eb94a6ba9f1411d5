//! Reflection at the boundary of two clear media (Fresnel).

/// Shares of the power that are reflected, polarised across (s) and in (p) the plane of incidence.
///
/// `n1`, `cos1` are index and cosine on the side where the light comes from, `n2`, `cos2` on the
/// other.
pub fn reflectances(n1: f64, cos1: f64, n2: f64, cos2: f64) -> [f64; 2] {
    let share = |a: f64, b: f64| {
        let r = (a - b) / (a + b);
        r * r
    };
    [share(n1 * cos1, n2 * cos2), share(n2 * cos1, n1 * cos2)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::optics::BuiltinMaterial;

    #[test]
    fn a_sixth_of_the_light_comes_back_from_diamond() {
        let n = BuiltinMaterial::Diamond.material().index(589.294).unwrap();
        let [s, p] = reflectances(1.0, 1.0, n, 1.0);
        // The definition's six digits.
        assert!((s - 0.172_006).abs() < 5e-7, "{s}");
        assert_eq!(s, p);
    }

    #[test]
    fn at_the_brewster_angle_no_p_light_comes_back() {
        let n: f64 = 1.5;
        let incidence = n.atan();
        let refraction = (incidence.sin() / n).asin();
        let [s, p] = reflectances(1.0, incidence.cos(), n, refraction.cos());
        assert!(p < 1e-30 && s > 0.1);
    }

    #[test]
    fn both_ways_through_a_face_reflect_alike() {
        let (cos1, cos2) = (0.3_f64.cos(), (0.3_f64.sin() / 1.7).asin().cos());
        let there = reflectances(1.0, cos1, 1.7, cos2);
        let back = reflectances(1.7, cos2, 1.0, cos1);
        assert!((0..2).all(|k| (there[k] - back[k]).abs() < 1e-15));
    }
}
