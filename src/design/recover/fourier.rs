//! The paper's way from colours to a spectrum: as many Fourier coefficients as there are numbers.
//!
//! Eq. 18 prints `a0 A0 / 4 + a1 A1 + b1 B1 = X`, with the misprint of Eq. 7; here the functions
//! themselves are weighed (`1/2`, cosine, sine), so that the equations are the colour. Nothing
//! keeps the series in 0-1, and often it does not stay there.

use super::viewing::{FOURIER, Viewing};
use crate::{
    design::small::solved,
    spectrum::{WORST_CONDITION, condition_number},
};

/// Coefficients of a series (prefix order) and the condition number of their equations, or that
/// number alone where there is no solution.
pub(super) type Solved = Result<(Vec<f64>, f64), f64>;

/// Three coefficients from the colour (white = 1) under one light.
pub(super) fn three(viewing: &Viewing, target: [f64; 3]) -> Solved {
    solution::<3>(&[viewing], target)
}

/// Six coefficients from the colours under two lights.
pub(super) fn six(viewings: [&Viewing; 2], target: [f64; FOURIER]) -> Solved {
    solution::<FOURIER>(&viewings, target)
}

fn solution<const M: usize>(viewings: &[&Viewing], target: [f64; M]) -> Solved {
    let matrix: [[f64; M]; M] =
        std::array::from_fn(|row| std::array::from_fn(|n| viewings[row / 3].fourier[n][row % 3]));
    // The unknowns are the mean and the amplitudes: a0 itself is twice the mean.
    let of_mean = matrix.map(|mut row| {
        row[0] *= 2.0;
        row
    });
    let rows: Vec<&[f64]> = of_mean.iter().map(|row| &row[..]).collect();
    let condition = condition_number(&rows);
    match solved(matrix, target) {
        Some(found) if condition < WORST_CONDITION => Ok((found.to_vec(), condition)),
        _ => Err(condition),
    }
}
