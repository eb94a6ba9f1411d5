//! The wavelengths at which a dispersion formula is sampled.

use crate::languages::with_sign;

/// Below this no formula is sampled, nm: soft X-rays.
const FIRST_NM: f64 = 1.0;

/// Beyond this no formula is sampled, nm: microwaves.
const LAST_NM: f64 = 1e6;

/// Parts of the axis: from, to, and the step between, nm. Whole nanometres up to the middle
/// infrared; about as many points a decade beyond.
const PARTS: [(f64, f64, f64); 5] = [
    (FIRST_NM, 100.0, 0.1),
    (100.0, 5_000.0, 1.0),
    (5_000.0, 50_000.0, 10.0),
    (50_000.0, 500_000.0, 100.0),
    (500_000.0, LAST_NM, 1_000.0),
];

/// Wavelengths from one to another, nm: the multiples of the step between them, and the choice in
/// words.
pub(crate) fn of(from: f64, to: f64) -> (Vec<f64>, String) {
    let (from, to) = (tidied(from), tidied(to));
    let (first, last) = (from.max(FIRST_NM), to.min(LAST_NM));
    let mut nm = Vec::new();
    let mut how = said!("at whole nm").to_owned();
    for (low, high, step) in PARTS {
        let (start, end) = (first.max(low), last.min(high));
        if start >= end {
            continue;
        }
        let (start, end) = (tidied(start / step).ceil(), tidied(end / step).floor());
        let steps = (end - start).max(-1.0) as i64;
        let part = (0..=steps).map(|i| tidied((start + i as f64) * step));
        // But the one that the part before ended with.
        nm.extend(part.filter(|x| *x > low || low <= first));
        if step < 1.0 {
            how += &tr!(
                ", in steps of {step} nm below {limit} nm",
                step = with_sign(step.to_string()),
                limit = with_sign(high.to_string())
            );
        } else if step > 1.0 {
            how += &tr!(
                ", in steps of {step} nm beyond {limit} nm",
                step = with_sign(step.to_string()),
                limit = with_sign(low.to_string())
            );
        }
    }
    // A narrow range may hold one multiple of the step or none.
    if nm.len() < 2 && first < last {
        nm = vec![first, last];
        said!("at the ends of its range").clone_into(&mut how);
    }
    if from < FIRST_NM {
        how += &tr!(
            "; not sampled below {limit} nm",
            limit = with_sign(FIRST_NM.to_string())
        );
    }
    if to > LAST_NM {
        how += &tr!(
            "; not sampled beyond {limit} nm",
            limit = with_sign(LAST_NM.to_string())
        );
    }
    (nm, how)
}

/// A number without the rounding error of the conversion from um to nm.
fn tidied(x: f64) -> f64 {
    let rounded = (x * 1e6).round() / 1e6;
    if rounded.is_finite() { rounded } else { x }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wavelengths_rise_from_end_to_end_in_steps_that_widen() {
        let (nm, how) = of(0.0004 * 1000.0, 2e6);
        assert!(nm.is_sorted_by(|a, b| a < b));
        assert_eq!((nm.first(), nm.last()), (Some(&1.0), Some(&1e6)));
        assert!(nm.len() < 16_000, "{}", nm.len());
        assert!(
            how.ends_with("not sampled below 1 nm; not sampled beyond 1000000 nm"),
            "{how}"
        );
        for part in [100.0, 5_000.0, 50_000.0] {
            assert_eq!(nm.iter().filter(|x| **x == part).count(), 1, "{part}");
        }
    }

    #[test]
    fn what_lies_between_is_whole_nanometres() {
        assert_eq!(of(400.5, 403.2).0, [401.0, 402.0, 403.0]);
        assert_eq!(
            of(4.0999 * 1000.0, 4.1 * 1000.0 + 2.0).0,
            [4100.0, 4101.0, 4102.0]
        );
        assert_eq!(of(400.2, 400.8).0, [400.2, 400.8]);
        assert_eq!(of(500.0, 400.0).0, [0.0; 0]);
        assert_eq!(of(1e-297, 1e303).0.len(), of(1.0, 1e6).0.len());
    }
}
