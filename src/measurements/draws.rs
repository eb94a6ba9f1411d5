//! Normal numbers of a seed, for copies of a measurement with its noise drawn.

/// Standard normal numbers by Box and Muller from a linear congruence (Knuth's MMIX); the same seed
/// gives the same numbers.
pub(crate) fn normal(seed: u64) -> impl Iterator<Item = f64> {
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let mut even = move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        ((state >> 11) as f64 + 0.5) / (1_u64 << 53) as f64
    };
    std::iter::from_fn(move || {
        let (a, b) = (even(), even());
        Some((-2.0 * a.ln()).sqrt() * (2.0 * std::f64::consts::PI * b).cos())
    })
}
