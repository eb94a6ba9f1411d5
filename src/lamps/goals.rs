//! The three goals near one light: small differences of a spectrum to small errors.
//!
//! Of each colour, `|M d|^2` is the squared CIEDE2000 that a small difference `d` of its X, Y, Z
//! makes: `M = H^(1/2) J`, with `J` the derivative of L\*a\*b\* and `H` the quadratic form of
//! CIEDE2000 at the exact colour. `M` is divided by the root of the count of colours, so that the
//! norm of all rows is the RMS error; the blurred rows give the relative RMS.

use nalgebra::{Matrix3, SymmetricEigen};

use super::operators::Operators;
use crate::{
    color::{LAB_EPSILON, LAB_KAPPA, Lab, Xyz, delta_e_2000, lab_from_xyz},
    spectrum::dot,
    study::brightened,
};

/// Step in each axis of L\*a\*b\* for the quadratic form. Differences to both sides leave an error of
/// its square, and rounding one of about 1e-16 over it.
const STEP: f64 = 1e-3;

/// Least eigenvalue of a quadratic form.
const LEAST_EIGENVALUE: f64 = 1e-9;

/// Share of the white's Y below which its X or Z counts as absent, as `lab_from_xyz` has it.
const ABSENT: f64 = 1e-9;

/// The goals: patches, filters, spectrum.
pub(super) const GOALS: usize = 3;

/// A light's goals.
#[derive(Clone, Debug)]
pub(super) struct Goals {
    /// One matrix a colour, by rows, upper triangular or full.
    forms: Vec<[[f64; 3]; 3]>,
    /// Factor of a blurred row.
    blur: f64,
    /// First row of filters, of the blurred spectrum, and of nothing.
    ends: [usize; GOALS],
}

impl Goals {
    /// The goals near a light given by its rows and its X, Y, Z; `blurred_norm` is the root of the
    /// sum of squares of the blurred light on the grid.
    pub(super) fn near(
        operators: &Operators,
        rows: &[f64],
        white: [f64; 3],
        blurred_norm: f64,
    ) -> Self {
        let [patches, filters] = operators.colours();
        let white = Xyz::from_array(white);
        let triples = rows[..3 * (patches + filters)].chunks_exact(3);
        let forms = triples
            .enumerate()
            .map(|(i, xyz)| {
                let xyz = Xyz::new(xyz[0], xyz[1], xyz[2]);
                let (gain, count) = if i < patches {
                    (1.0, patches)
                } else {
                    (brightened(xyz.y, white.y), filters)
                };
                form(xyz * gain, white, gain / (count as f64).sqrt())
            })
            .collect();
        Self {
            forms,
            // Every fourth nm stands for four.
            blur: 2.0 / blurred_norm,
            ends: [3 * patches, 3 * (patches + filters), operators.rows()],
        }
    }

    /// Rows of a difference turned into errors.
    pub(super) fn errors_of(&self, rows: &[f64]) -> Vec<f64> {
        let mut out = rows.to_vec();
        let (colours, blur) = out.split_at_mut(self.ends[1]);
        for (triple, form) in colours.chunks_exact_mut(3).zip(&self.forms) {
            let [x, y, z] = [triple[0], triple[1], triple[2]];
            for (row, m) in triple.iter_mut().zip(form) {
                *row = m[0] * x + m[1] * y + m[2] * z;
            }
        }
        blur.iter_mut().for_each(|v| *v *= self.blur);
        out
    }

    /// The transpose of [`Goals::errors_of`].
    pub(super) fn transposed(&self, errors: &[f64]) -> Vec<f64> {
        let mut out = errors.to_vec();
        let (colours, blur) = out.split_at_mut(self.ends[1]);
        for (triple, form) in colours.chunks_exact_mut(3).zip(&self.forms) {
            let [a, b, c] = [triple[0], triple[1], triple[2]];
            for (k, row) in triple.iter_mut().enumerate() {
                *row = form[0][k] * a + form[1][k] * b + form[2][k] * c;
            }
        }
        blur.iter_mut().for_each(|v| *v *= self.blur);
        out
    }

    /// The squared form of each colour, as its six numbers `xx yy zz xy xz yz`, times the square of
    /// its goal's weight; the last is that of a blurred row.
    pub(super) fn squares(&self, weights: [f64; GOALS]) -> (Vec<[f64; 6]>, f64) {
        let patches = self.ends[0] / 3;
        let squares = self.forms.iter().enumerate().map(|(i, form)| {
            let t = weights[usize::from(i >= patches)];
            let product = |j: usize, k: usize| {
                t * t
                    * (form[0][j] * form[0][k] + form[1][j] * form[1][k] + form[2][j] * form[2][k])
            };
            [
                product(0, 0),
                product(1, 1),
                product(2, 2),
                2.0 * product(0, 1),
                2.0 * product(0, 2),
                2.0 * product(1, 2),
            ]
        });
        (squares.collect(), (weights[2] * self.blur).powi(2))
    }

    /// Each goal's rows times its weight.
    pub(super) fn weighed(&self, weights: [f64; GOALS], errors: &[f64]) -> Vec<f64> {
        let mut weighed = errors.to_vec();
        for (range, t) in self.ranges().into_iter().zip(weights) {
            weighed[range].iter_mut().for_each(|v| *v *= t);
        }
        weighed
    }

    /// The rows of each goal.
    pub(super) fn ranges(&self) -> [std::ops::Range<usize>; GOALS] {
        [
            0..self.ends[0],
            self.ends[0]..self.ends[1],
            self.ends[1]..self.ends[2],
        ]
    }

    /// Norm of each goal's rows.
    pub(super) fn norms(&self, errors: &[f64]) -> [f64; GOALS] {
        self.ranges()
            .map(|range| dot(&errors[range.clone()], &errors[range]).sqrt())
    }
}

/// The quadratic form of CIEDE2000 at a colour: `d^T H d` is the squared difference of a small step
/// `d` in L\*a\*b\*. Steps to both sides are averaged, since CIEDE2000 weighs by both colours and a
/// step to one side alone is off in the first order.
fn quadratic_form(lab: Lab) -> Matrix3<f64> {
    let difference = |steps: [f64; 3]| {
        let square = |sign: f64| {
            let [l, a, b] = steps.map(|step| sign * STEP * step);
            delta_e_2000(lab, Lab::new(lab.l + l, lab.a + a, lab.b + b)).powi(2)
        };
        (square(1.0) + square(-1.0)) / (2.0 * STEP * STEP)
    };
    let axis = |i: usize| std::array::from_fn::<f64, 3, _>(|k| f64::from(u8::from(k == i)));
    let mut h = Matrix3::from_diagonal(&nalgebra::Vector3::from_fn(|i, _| difference(axis(i))));
    for i in 0..3 {
        for j in 0..i {
            let along =
                |sign: f64| difference(std::array::from_fn(|k| axis(i)[k] + sign * axis(j)[k]));
            h[(i, j)] = 0.25 * (along(1.0) - along(-1.0));
            h[(j, i)] = h[(i, j)];
        }
    }
    h
}

/// `H^(1/2) J` at a colour, times a scale.
fn form(xyz: Xyz, white: Xyz, scale: f64) -> [[f64; 3]; 3] {
    let h = quadratic_form(lab_from_xyz(xyz, white));
    let j = jacobian(xyz, white) * scale;
    // Any root will do; the triangular one is cheapest.
    let root = match h.cholesky() {
        Some(root) if (0..3).all(|i| root.l_dirty()[(i, i)].powi(2) > LEAST_EIGENVALUE) => {
            root.l().transpose()
        }
        _ => root_of(h),
    };
    let m = root * j;
    std::array::from_fn(|i| std::array::from_fn(|k| m[(i, k)]))
}

/// A root of a form whose eigenvalues are first brought to the least.
fn root_of(h: Matrix3<f64>) -> Matrix3<f64> {
    let SymmetricEigen {
        eigenvectors,
        eigenvalues,
    } = SymmetricEigen::new(h);
    let roots = eigenvalues.map(|v| v.max(LEAST_EIGENVALUE).sqrt());
    Matrix3::from_diagonal(&roots) * eigenvectors.transpose()
}

/// Derivative of L\*a\*b\* by X, Y, Z.
fn jacobian(xyz: Xyz, white: Xyz) -> Matrix3<f64> {
    let slope = |value: f64, of_white: f64| {
        if of_white.abs() <= ABSENT * white.y {
            return 0.0;
        }
        let t = value / of_white;
        let slope = if t > LAB_EPSILON {
            let root = t.cbrt();
            1.0 / (3.0 * root * root)
        } else {
            LAB_KAPPA / 116.0
        };
        slope / of_white
    };
    let y = slope(xyz.y, white.y);
    let (x, z) = (slope(xyz.x, white.x), slope(xyz.z, white.z));
    // Where the white has no X or Z, the ratio of Y stands in for it and the axis is empty.
    let (ya, yb) = (
        if x == 0.0 { 0.0 } else { y },
        if z == 0.0 { 0.0 } else { y },
    );
    Matrix3::new(
        0.0,
        116.0 * y,
        0.0,
        500.0 * x,
        -500.0 * ya,
        0.0,
        0.0,
        200.0 * yb,
        -200.0 * z,
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{color::Observer, lamps::EvaluationSet, spectrum::Band};

    fn light() -> Vec<f64> {
        Band::VISIBLE
            .grid()
            .map(|nm| 1.0 + 0.6 * (nm / 45.0).sin())
            .collect()
    }

    #[test]
    fn a_small_difference_makes_the_error_that_the_goals_say() {
        let panel = EvaluationSet::choosing(Band::VISIBLE, Observer::CIE_1931);
        let operators = Operators::new(&panel);
        let light = light();
        let rows = operators.rows_of(0, &light);
        let blurred = panel.measures().blur.values(&light);
        let goals = Goals::near(
            &operators,
            &rows,
            operators.xyz(0, &light),
            dot(&blurred, &blurred).sqrt(),
        );
        let difference: Vec<f64> = Band::VISIBLE
            .grid()
            .map(|nm| 1e-4 * (nm / 17.0).cos())
            .collect();
        let said = goals.norms(&goals.errors_of(&operators.rows_of(0, &difference)));
        let other: Vec<f64> = light.iter().zip(&difference).map(|(a, b)| a + b).collect();
        let white = Xyz::from_array(operators.xyz(0, &light));
        // RMS of CIEDE2000 over the same colours.
        let (a, b) = (rows, operators.rows_of(0, &other));
        let [patches, filters] = operators.colours();
        let rms = |range: std::ops::Range<usize>, is_filter: bool| {
            let count = range.len() as f64;
            let squares = range.map(|i| {
                let xyz = |rows: &[f64]| Xyz::new(rows[3 * i], rows[3 * i + 1], rows[3 * i + 2]);
                let gain = if is_filter {
                    brightened(a[3 * i + 1], white.y)
                } else {
                    1.0
                };
                delta_e_2000(
                    lab_from_xyz(xyz(&a) * gain, white),
                    lab_from_xyz(xyz(&b) * gain, white),
                )
                .powi(2)
            });
            (squares.sum::<f64>() / count).sqrt()
        };
        let found = [
            rms(0..patches, false),
            rms(patches..patches + filters, true),
        ];
        for (said, found) in said.iter().zip(found) {
            // The form is exact for small differences; these reach some hundredths of CIEDE2000.
            assert!((said - found).abs() < 0.003 * found, "{said} {found}");
        }
    }

    /// L, a, b and the second derivatives of CIEDE2000 squared by L, a, b, then by a and b together, halved: formed in
    /// 60 digits from Sharma, Wu and Dalal's formulas by differences of 1e-15 to both sides. Blues
    /// where hue turns, all other quadrants, and a colour next to grey.
    #[rustfmt::skip]
    const CURVED: [[f64; 7]; 6] = [
        [50.0, 4.0, -45.0, 1.0, 0.483758637701, 0.148096888784, 0.238221465848],
        [40.0, 10.0, -60.0, 0.773627784654, 0.426945802178, 0.134416341731, 0.21806759139],
        [60.0, -30.0, 25.0, 0.773627784654, 0.205148828074, 0.23397349812, 0.0862443568568],
        [52.0, 48.0, 30.0, 0.975947864973, 0.15842249229, 0.281351454747, -0.126214216842],
        [80.0, 2.0, 70.0, 0.478867237977, 0.372569106996, 0.0582843640326, -0.00898628749386],
        [50.0, 0.5, -0.3, 1.0, 2.10601377217, 0.961873225689, 0.0184756232986],
    ];

    #[test]
    fn the_form_is_the_curvature_of_ciede2000_and_leans_to_no_side() {
        for [l, a, b, ll, aa, bb, ab] in CURVED {
            let h = quadratic_form(Lab::new(l, a, b));
            let expected = [
                ((0, 0), ll),
                ((1, 1), aa),
                ((2, 2), bb),
                ((1, 2), ab),
                ((0, 1), 0.0),
                ((0, 2), 0.0),
            ];
            for (place, expected) in expected {
                // The square of a step of .001, next to grey over that of a chroma of .6.
                let off = (h[place] - expected).abs();
                assert!(off < 1e-5, "{l} {a} {b} {place:?}: {off}");
            }
        }
    }

    #[test]
    fn the_transpose_weighs_rows_as_the_errors_are_weighed() {
        let panel = EvaluationSet::choosing(Band::VISIBLE, Observer::CIE_1931);
        let operators = Operators::new(&panel);
        let rows = operators.rows_of(0, &light());
        let goals = Goals::near(&operators, &rows, operators.xyz(0, &light()), 3.0);
        let weights: Vec<f64> = (0..rows.len()).map(|i| (i as f64).sin()).collect();
        let (a, b) = (
            dot(&weights, &goals.errors_of(&rows)),
            dot(&goals.transposed(&weights), &rows),
        );
        assert!((a - b).abs() < 1e-10 * a.abs().max(1.0));
        // The squares are the squared norm of the errors.
        let t = [2.0, 3.0, 0.5];
        let errors = goals.weighed(t, &goals.errors_of(&rows));
        let (squares, blur) = goals.squares(t);
        let colours: f64 = squares
            .iter()
            .zip(rows.chunks_exact(3))
            .map(|(h, r)| {
                h[0] * r[0] * r[0]
                    + h[1] * r[1] * r[1]
                    + h[2] * r[2] * r[2]
                    + h[3] * r[0] * r[1]
                    + h[4] * r[0] * r[2]
                    + h[5] * r[1] * r[2]
            })
            .sum();
        let rest = &rows[3 * squares.len()..];
        let whole = colours + blur * dot(rest, rest);
        assert!((whole - dot(&errors, &errors)).abs() < 1e-9 * whole);
    }
}
