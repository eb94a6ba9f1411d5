//! Arithmetic on 3x3 matrices, usable in constants so that colour matrices are derived, not pasted.

/// Rows of a 3x3 matrix.
pub(super) type Matrix3 = [[f64; 3]; 3];

/// `matrix * vector`.
pub(super) const fn times_vector(matrix: &Matrix3, vector: [f64; 3]) -> [f64; 3] {
    let mut out = [0.0; 3];
    let mut row = 0;
    while row < 3 {
        out[row] =
            matrix[row][0] * vector[0] + matrix[row][1] * vector[1] + matrix[row][2] * vector[2];
        row += 1;
    }
    out
}

/// `a * b`.
pub(super) fn times_matrix(a: &Matrix3, b: &Matrix3) -> Matrix3 {
    std::array::from_fn(|row| {
        std::array::from_fn(|column| (0..3).map(|k| a[row][k] * b[k][column]).sum())
    })
}

/// The inverse by cofactors.
///
/// Meant for the fixed matrices of colour spaces, which are far from singular; a singular matrix
/// fails the build when used in a constant and panics otherwise.
///
/// # Panics
/// When the determinant is zero.
pub(super) const fn inverse(m: &Matrix3) -> Matrix3 {
    let mut cofactor = [[0.0; 3]; 3];
    let mut row = 0;
    while row < 3 {
        let mut col = 0;
        while col < 3 {
            // Taking the following rows and columns cyclically supplies the alternating sign.
            let (r1, r2) = ((row + 1) % 3, (row + 2) % 3);
            let (c1, c2) = ((col + 1) % 3, (col + 2) % 3);
            cofactor[row][col] = m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
            col += 1;
        }
        row += 1;
    }
    let determinant =
        m[0][0] * cofactor[0][0] + m[0][1] * cofactor[0][1] + m[0][2] * cofactor[0][2];
    assert!(determinant != 0.0, "a colour matrix must be invertible");
    let mut out = [[0.0; 3]; 3];
    let mut row = 0;
    while row < 3 {
        let mut col = 0;
        while col < 3 {
            out[row][col] = cofactor[col][row] / determinant;
            col += 1;
        }
        row += 1;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_matrix_times_its_inverse_gives_a_vector_back() {
        const M: Matrix3 = [[2.0, -1.0, 0.5], [0.25, 3.0, 1.0], [-0.5, 0.75, 4.0]];
        const BACK: Matrix3 = inverse(&M);
        let vector = [0.3, -1.7, 2.9];
        let again = times_vector(&BACK, times_vector(&M, vector));
        for (found, expected) in again.into_iter().zip(vector) {
            // A handful of roundings on numbers near 1.
            assert!((found - expected).abs() < 1e-14);
        }
    }

    #[test]
    fn a_product_of_matrices_does_what_one_does_after_the_other() {
        const A: Matrix3 = [[2.0, -1.0, 0.5], [0.25, 3.0, 1.0], [-0.5, 0.75, 4.0]];
        const B: Matrix3 = [[1.0, 4.0, -2.0], [0.5, -3.0, 2.0], [8.0, 0.25, 1.0]];
        let vector = [1.0, 2.0, -0.5];
        // Every product of these numbers is exact.
        let both = times_vector(&times_matrix(&A, &B), vector);
        assert_eq!(both, times_vector(&A, times_vector(&B, vector)));
    }
}
