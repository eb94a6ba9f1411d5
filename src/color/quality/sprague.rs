//! Sprague's interpolation of an even table: a fifth-degree polynomial between two points through
//! the six around them (CIE 167:2005).

/// The two points before the first are these sums of the first six over 209; those beyond the last
/// are their mirror image.
const BEFORE: [[f64; 6]; 2] = [
    [884.0, -1960.0, 3033.0, -2648.0, 1080.0, -180.0],
    [508.0, -540.0, 488.0, -367.0, 144.0, -24.0],
];
const BEFORE_UNIT: f64 = 209.0;

/// Coefficients of the polynomial's powers 0 to 5 from the six points, times 24.
const POWERS: [[f64; 6]; 6] = [
    [0.0, 0.0, 24.0, 0.0, 0.0, 0.0],
    [2.0, -16.0, 0.0, 16.0, -2.0, 0.0],
    [-1.0, 16.0, -30.0, 16.0, -1.0, 0.0],
    [-9.0, 39.0, -70.0, 66.0, -33.0, 7.0],
    [13.0, -64.0, 126.0, -124.0, 61.0, -12.0],
    [-5.0, 25.0, -50.0, 50.0, -25.0, 5.0],
];
const POWERS_UNIT: f64 = 24.0;

/// Values with `parts - 1` new ones between each two; at least six values go in.
pub(super) fn sprague(values: &[f64], parts: usize) -> Vec<f64> {
    let dot = |a: &[f64], b: &[f64; 6]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
    let first = &values[..6];
    let mut last = values[values.len() - 6..].to_vec();
    last.reverse();
    let outside = |six: &[f64]| BEFORE.map(|row| dot(six, &row) / BEFORE_UNIT);
    let ([far, near], [far_behind, near_behind]) = (outside(first), outside(&last));
    let mut padded = vec![far, near];
    padded.extend(values);
    padded.extend([near_behind, far_behind]);
    let mut out = Vec::with_capacity((values.len() - 1) * parts + 1);
    for six in padded.windows(6) {
        let powers = POWERS.map(|row| dot(six, &row) / POWERS_UNIT);
        for part in 0..parts {
            let x = part as f64 / parts as f64;
            out.push(powers.iter().rev().fold(0.0, |sum, power| sum * x + power));
        }
    }
    out.push(values[values.len() - 1]);
    debug_assert_eq!(out.len(), (values.len() - 1) * parts + 1);
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_stays_and_inside_it_a_curve_of_the_third_degree_is_met() {
        let curve = |x: f64| 1.0 - 2.0 * x + 0.3 * x * x - 0.01 * x * x * x;
        let table: Vec<f64> = (0..12).map(|i| curve(f64::from(i))).collect();
        let fine = sprague(&table, 5);
        assert_eq!(fine.len(), 56);
        for (i, found) in fine.iter().enumerate() {
            // The points beyond the ends are made to be smooth, not to continue a polynomial.
            let is_inside = (10..=45).contains(&i);
            if is_inside || i % 5 == 0 {
                // Numbers up to 30 times coefficients of a few hundred.
                assert!((found - curve(i as f64 / 5.0)).abs() < 1e-11, "{i}");
            }
        }
    }

    #[test]
    fn a_straight_line_stays_straight_to_its_ends() {
        let table: Vec<f64> = (0..7).map(|i| 3.0 - 0.5 * f64::from(i)).collect();
        for (i, found) in sprague(&table, 5).iter().enumerate() {
            // Coefficients of some thousand times numbers near 3, over 209.
            assert!((found - (3.0 - 0.1 * i as f64)).abs() < 1e-12, "{i}");
        }
    }
}
