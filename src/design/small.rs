//! Systems of a few linear equations, and numbers in words.

/// Solves `matrix x = right` by elimination with row exchanges; `None` where the matrix has no
/// inverse to rounding.
pub(super) fn solved<const M: usize>(
    mut matrix: [[f64; M]; M],
    mut right: [f64; M],
) -> Option<[f64; M]> {
    let largest = matrix
        .as_flattened()
        .iter()
        .fold(0.0, |a, v| v.abs().max(a));
    for column in 0..M {
        let pivot = (column..M).max_by(|a, b| {
            let size = |row: &usize| matrix[*row][column].abs();
            size(a).total_cmp(&size(b))
        })?;
        matrix.swap(column, pivot);
        right.swap(column, pivot);
        let top = matrix[column];
        let pivot = top[column].abs();
        if pivot.is_nan() || pivot <= largest * f64::EPSILON {
            return None;
        }
        for row in column + 1..M {
            let factor = matrix[row][column] / top[column];
            for k in column + 1..M {
                matrix[row][k] -= factor * top[k];
            }
            right[row] -= factor * right[column];
        }
    }
    for row in (0..M).rev() {
        let rest: f64 = (row + 1..M).map(|k| matrix[row][k] * right[k]).sum();
        right[row] = (right[row] - rest) / matrix[row][row];
    }
    right.iter().all(|v| v.is_finite()).then_some(right)
}

/// The inverse; `None` as [`solved`].
pub(super) fn inverse<const M: usize>(matrix: &[[f64; M]; M]) -> Option<[[f64; M]; M]> {
    let mut out = [[0.0; M]; M];
    for column in 0..M {
        let unit = std::array::from_fn(|row| if row == column { 1.0 } else { 0.0 });
        let found = solved(*matrix, unit)?;
        let rows = out.iter_mut().zip(found);
        rows.for_each(|(row, value)| row[column] = value);
    }
    Some(out)
}

/// A number in words: as it is, or by its power of ten where that would be a row of noughts.
pub(super) fn digits(value: f64) -> String {
    match value.abs() {
        size if size >= 1e9 || (size > 0.0 && size < 1e-9) => format!("{value:e}"),
        _ => value.to_string(),
    }
}

/// Sum of products.
pub(super) fn dot<const M: usize>(a: &[f64; M], b: &[f64; M]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// Negative pivots of a symmetric matrix: as many as it has negative eigenvalues (Sylvester).
/// `None` where a pivot is zero to rounding, whose sign is unknown.
pub(super) fn negative_pivots<const M: usize>(mut matrix: [[f64; M]; M]) -> Option<usize> {
    let largest = matrix
        .as_flattened()
        .iter()
        .fold(0.0, |a, v| v.abs().max(a));
    let mut negative = 0;
    for column in 0..M {
        let top = matrix[column];
        let pivot = top[column].abs();
        if pivot.is_nan() || pivot <= largest * f64::EPSILON {
            return None;
        }
        negative += usize::from(top[column] < 0.0);
        for row in &mut matrix[column + 1..] {
            let factor = row[column] / top[column];
            add(row, &top, -factor);
        }
    }
    Some(negative)
}

/// Adds `factor * from` to `to`.
pub(super) fn add<const M: usize>(to: &mut [f64; M], from: &[f64; M], factor: f64) {
    for (t, f) in to.iter_mut().zip(from) {
        *t += factor * f;
    }
}

/// Sum of columns, each times its weight.
pub(super) fn combined<'a, const M: usize>(
    columns: impl IntoIterator<Item = &'a [f64; M]>,
    weights: impl IntoIterator<Item = &'a f64>,
) -> [f64; M] {
    let mut sum = [0.0; M];
    for (column, weight) in columns.into_iter().zip(weights) {
        add(&mut sum, column, *weight);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_matrix_times_its_inverse_is_one_also_where_rows_must_change_places() {
        let matrix = [[0.0, 2.0, 1.0], [1.0, 0.0, 3.0], [4.0, 5.0, 0.0]];
        let inverse = inverse(&matrix).unwrap();
        for (row, line) in matrix.iter().enumerate() {
            for (column, value) in combined(&inverse, line).into_iter().enumerate() {
                // A handful of operations on numbers of size one.
                assert!((value - f64::from(u8::from(row == column))).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn pivots_count_negative_eigenvalues_or_say_that_they_cannot() {
        assert_eq!(negative_pivots([[2.0, 0.0], [0.0, 3.0]]), Some(0));
        assert_eq!(negative_pivots([[1.0, 2.0], [2.0, 1.0]]), Some(1));
        assert_eq!(negative_pivots([[-1.0, 0.5], [0.5, -1.0]]), Some(2));
        assert_eq!(negative_pivots([[0.0, 0.0], [0.0, -1.0]]), None);
        assert_eq!(negative_pivots([[0.0, 1.0], [1.0, 0.0]]), None);
        assert_eq!(negative_pivots([[f64::NAN, 1.0], [1.0, 0.0]]), None);
    }

    #[test]
    fn great_and_small_numbers_are_told_by_their_power_of_ten() {
        for (value, words) in [
            (1e308, "1e308"),
            (82.5, "82.5"),
            (0.0, "0"),
            (-1e-12, "-1e-12"),
        ] {
            assert_eq!(digits(value), words);
        }
    }

    #[test]
    fn a_matrix_without_an_inverse_is_told() {
        assert!(solved([[1.0, 2.0], [2.0, 4.0]], [1.0, 0.0]).is_none());
        assert!(solved([[0.0; 2]; 2], [0.0; 2]).is_none());
        assert!(solved([[f64::NAN; 2]; 2], [0.0; 2]).is_none());
    }
}
