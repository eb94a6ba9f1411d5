//! Student's t and Holm's procedure.

/// Half the width of the interval that holds a normal number 95 times of 100, in standard
/// deviations.
pub const OF_95: f64 = 1.96;
/// Probability of a false difference among all that are compared together.
pub(super) const LEVEL_OF_TEST: f64 = 0.05;

/// Logarithm of the gamma function for arguments above 0 (Lanczos, g = 7, nine terms; 1e-15).
fn ln_gamma(x: f64) -> f64 {
    const TERMS: [f64; 9] = [
        0.999_999_999_999_809_9,
        676.520_368_121_885_1,
        -1_259.139_216_722_402_8,
        771.323_428_777_653_1,
        -176.615_029_162_140_6,
        12.507_343_278_686_905,
        -0.138_571_095_265_720_12,
        9.984_369_578_019_572e-6,
        1.505_632_735_149_311_6e-7,
    ];
    if x < 0.5 {
        // Reflected.
        let pi = std::f64::consts::PI;
        return (pi / (pi * x).sin()).ln() - ln_gamma(1.0 - x);
    }
    let x = x - 1.0;
    let t = x + 7.5;
    let sum = (1..9).fold(TERMS[0], |sum, i| sum + TERMS[i] / (x + i as f64));
    0.5 * (2.0 * std::f64::consts::PI).ln() + (x + 0.5) * t.ln() - t + sum.ln()
}

/// The regularised incomplete beta function (continued fraction of Lentz).
fn beta(a: f64, b: f64, x: f64) -> f64 {
    if x <= 0.0 {
        return 0.0;
    }
    if x >= 1.0 {
        return 1.0;
    }
    if x > (a + 1.0) / (a + b + 2.0) {
        return 1.0 - beta(b, a, 1.0 - x);
    }
    const TINY: f64 = 1e-300;
    let front =
        (ln_gamma(a + b) - ln_gamma(a) - ln_gamma(b) + a * x.ln() + b * (1.0 - x).ln()).exp();
    let (mut c, mut d) = (1.0, 1.0 - (a + b) * x / (a + 1.0));
    d = 1.0 / if d.abs() < TINY { TINY } else { d };
    let mut fraction = d;
    for m in 1..500 {
        let m = f64::from(m);
        let even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
        let odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
        let mut step = 1.0;
        for term in [even, odd] {
            d = 1.0 + term * d;
            d = 1.0 / if d.abs() < TINY { TINY } else { d };
            c = 1.0 + term / c;
            c = if c.abs() < TINY { TINY } else { c };
            step = c * d;
            fraction *= step;
        }
        if (step - 1.0).abs() < 1e-15 {
            break;
        }
    }
    front * fraction / a
}

/// Probability that Student's t is at least as far from 0 as this.
pub fn two_sided_p(t: f64, dof: f64) -> f64 {
    if !t.is_finite() {
        return 0.0;
    }
    beta(0.5 * dof, 0.5, dof / (dof + t * t))
}

/// The t that 95 % of Student's distribution lie within.
pub fn student_95(dof: f64) -> f64 {
    quantile_of_p(0.05, dof)
}

/// The t that is exceeded either way with probability `p`.
pub(super) fn quantile_of_p(p: f64, dof: f64) -> f64 {
    let (mut low, mut high) = (0.0, 2.0);
    while two_sided_p(high, dof) > p && high < 1e9 {
        low = high;
        high *= 2.0;
    }
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if two_sided_p(middle, dof) > p {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// Marks the probabilities that are significant by Holm's procedure, all together at `level`.
pub fn holm(p: &[f64], level: f64) -> Vec<bool> {
    let mut order: Vec<usize> = (0..p.len()).collect();
    order.sort_by(|a, b| p[*a].total_cmp(&p[*b]));
    let mut found = vec![false; p.len()];
    for (rank, index) in order.into_iter().enumerate() {
        if p[index] > level / (p.len() - rank) as f64 {
            break;
        }
        found[index] = true;
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn student_is_that_of_the_tables() {
        // Tables of the t distribution, 95 % two-sided.
        for (dof, t) in [
            (1.0, 12.7062),
            (2.0, 4.30265),
            (4.0, 2.77645),
            (10.0, 2.22814),
            (160.0, 1.97490),
        ] {
            assert!(
                (student_95(dof) / t - 1.0).abs() < 1e-5,
                "{dof}: {}",
                student_95(dof)
            );
        }
        assert!((student_95(1e9) - 1.959_964).abs() < 1e-5);
        assert!((two_sided_p(2.77645, 4.0) - 0.05).abs() < 1e-6);
        assert_eq!(two_sided_p(0.0, 4.0), 1.0);
        assert_eq!(two_sided_p(f64::INFINITY, 4.0), 0.0);
    }

    #[test]
    fn holm_tests_the_smallest_at_a_share_of_the_level_and_stops_at_the_first_that_fails() {
        assert_eq!(holm(&[0.04, 0.01, 0.3], 0.05), [false, true, false]);
        assert_eq!(holm(&[0.02, 0.01, 0.04], 0.05), [true, true, true]);
        assert_eq!(holm(&[0.03, 0.01, 0.04], 0.05), [false, true, false]);
        assert!(holm(&[], 0.05).is_empty());
    }
}
