//! Smoothing and robust figures of plain lists of numbers.

/// A list behind a Gaussian of `sigma` places, its ends mirrored; unchanged for a sigma of 0.
pub(super) fn gaussian(values: &[f64], sigma: f64) -> Vec<f64> {
    let reach = (4.0 * sigma + 0.5) as usize;
    if reach == 0 || values.is_empty() {
        return values.to_vec();
    }
    let kernel: Vec<f64> = (0..=2 * reach)
        .map(|i| (i as f64 - reach as f64) / sigma)
        .map(|z| (-0.5 * z * z).exp())
        .collect();
    let total: f64 = kernel.iter().sum();
    let count = values.len();
    (0..count)
        .map(|at| {
            let sum: f64 = kernel
                .iter()
                .enumerate()
                .map(|(i, weight)| weight * values[mirrored(at + i, reach, count)])
                .sum();
            sum / total
        })
        .collect()
}

/// The place `at - back` of a list that goes on mirrored at its ends.
fn mirrored(at: usize, back: usize, count: usize) -> usize {
    let inside = if at < back { back - at - 1 } else { at - back };
    if inside >= count {
        (2 * count).saturating_sub(inside + 1).min(count - 1)
    } else {
        inside
    }
}

/// The value below which a share of a list lies, linear between neighbours; 0 of an empty list.
pub(super) fn percentile(values: &[f64], share: f64) -> f64 {
    let mut known: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
    if known.is_empty() {
        return 0.0;
    }
    let place = share.clamp(0.0, 1.0) * (known.len() - 1) as f64;
    let (_, low, above) = known.select_nth_unstable_by(place as usize, f64::total_cmp);
    let high = above.iter().copied().fold(f64::INFINITY, f64::min);
    let part = place.fract();
    if part > 0.0 {
        *low + (high - *low) * part
    } else {
        *low
    }
}

/// The middle of a list; 0 of an empty one.
pub(super) fn median(values: &[f64]) -> f64 {
    percentile(values, 0.5)
}

/// The standard deviation of a normal distribution with the same median distance from the median.
pub(super) fn robust_sigma(values: &[f64]) -> f64 {
    let middle = median(values);
    let distances: Vec<f64> = values.iter().map(|v| (v - middle).abs()).collect();
    1.4826 * median(&distances)
}

/// The largest of a list; 0 of an empty one.
pub(super) fn largest(values: &[f64]) -> f64 {
    values.iter().copied().fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_gaussian_keeps_the_sum_and_widens_a_point_by_its_sigma() {
        let mut values = vec![0.0; 101];
        values[50] = 1.0;
        let wide = gaussian(&values, 3.0);
        assert!((wide.iter().sum::<f64>() - 1.0).abs() < 1e-12);
        let second: f64 = (wide.iter().enumerate())
            .map(|(i, v)| v * (i as f64 - 50.0).powi(2))
            .sum();
        assert!((second.sqrt() - 3.0).abs() < 0.01, "{second}");
        assert_eq!(gaussian(&[2.0; 5], 40.0), vec![2.0; 5]);
    }

    #[test]
    fn percentiles_lie_between_neighbours() {
        let values = [4.0, 1.0, 3.0, 2.0];
        assert_eq!(percentile(&values, 0.5), 2.5);
        assert_eq!(percentile(&values, 1.0), 4.0);
        assert_eq!(percentile(&[], 0.5), 0.0);
        assert!((robust_sigma(&values) - 1.4826).abs() < 1e-12);
    }
}
