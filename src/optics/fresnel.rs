//! Reflection at the boundary of two clear media (Fresnel).

/// Shares of the power that are reflected, polarised across (s) and in (p) the plane of incidence.
///
/// `n1`, `cos1` are index and cosine on the side where the light comes from, `n2`, `cos2` on the
/// other.
pub(crate) fn reflectances(n1: f64, cos1: f64, n2: f64, cos2: f64) -> [f64; 2] {
    let share = |a: f64, b: f64| {
        let r = (a - b) / (a + b);
        r * r
    };
    [share(n1 * cos1, n2 * cos2), share(n2 * cos1, n1 * cos2)]
}
