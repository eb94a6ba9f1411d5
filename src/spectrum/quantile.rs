//! Percentiles: one rule for all that are told, linear between ranks.
//!
//! Of `count` sorted values the share `s` stands at rank `s (count - 1)`, counted from 0; between
//! two ranks the value goes straight from one to the other.

/// The rank below a share (0-1) of `count` sorted values (at least one), and how far beyond it the
/// share stands, as a part of the way to the next rank.
pub(crate) fn rank(count: usize, share: f64) -> (usize, f64) {
    let rank = share.clamp(0.0, 1.0) * (count.max(1) - 1) as f64;
    (rank as usize, rank.fract())
}

/// The value that a share (0-1) of all lies below; `None` of no value. The order of `values` is
/// lost.
pub(crate) fn quantile<T: Copy + Into<f64>>(values: &mut [T], share: f64) -> Option<f64> {
    if values.is_empty() {
        return None;
    }
    let by_size = |a: &T, b: &T| (*a).into().total_cmp(&(*b).into());
    let (below, beyond) = rank(values.len(), share);
    let (_, found, above) = values.select_nth_unstable_by(below, by_size);
    let found: f64 = (*found).into();
    let next = above.iter().copied().map(Into::into).min_by(f64::total_cmp);
    Some(match next {
        Some(next) if beyond > 0.0 && next > found => found + beyond * (next - found),
        _ => found,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quantile_stands_between_two_ranks_as_far_as_its_share() {
        // Twenty values: rank 18.05 is a twentieth of the way from the 19th to the 20th.
        let mut values: Vec<f64> = (1..=20).rev().map(|v| f64::from(v * v)).collect();
        let expected = 361.0 + 0.05 * (400.0 - 361.0);
        let found = quantile(&mut values, 0.95).expect("twenty values");
        assert!((found - expected).abs() < 1e-9, "{found}");
        assert_eq!(quantile(&mut values, 0.0), Some(1.0));
        assert_eq!(quantile(&mut values, 1.0), Some(400.0));
        assert_eq!(quantile(&mut [3.0_f32, 1.0], 0.5), Some(2.0));
        assert_eq!(quantile(&mut [7.0_f64], 0.95), Some(7.0));
        assert_eq!(quantile::<f64>(&mut [], 0.5), None);
    }
}
